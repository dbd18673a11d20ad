/* Pictures that leave the program are for white paper: the light theme, with the title, not in the window's compact
 * form. */
#include "gui/graph/graph-export.h"

#include <adwaita.h>
#include <glib/gi18n.h>
#include <string.h>

#include "gui/text/message.h"
#include "gui/widget/image-texture.h"
#include "gui/widget/save-dialog.h"

#define FINENESS       2   /* device pixels a unit of what is copied */
#define SAVED_WIDTH    800 /* least size of a saved picture */
#define SAVED_HEIGHT   500
#define SHOWN_DECIMALS 5

/* A question for a file that is open. */
typedef struct {
    GtkWidget *view; /* owned */
    TinkerGraphData *data;
    int width, height;
} Question;

static TinkerPlot plot_for_paper(TinkerGraphData *data)
{
    TinkerPlot plot = {.theme = tinker_theme_find("light"), .title = tinker_graph_data_title(data)};
    tinker_graph_data_catch_up(data);
    tinker_graph_data_fill_plot(data, &plot);
    /* "Now" is the window's. */
    plot.cursor = NULL;
    plot.curve_count = MIN(plot.curve_count, (int)MAX(tinker_graph_data_curves(data), 1));
    return plot;
}

void tinker_graph_draw_for_paper(TinkerGraphData *data, cairo_t *cairo, double width, double height)
{
    TinkerPlot plot = plot_for_paper(data);
    tinker_plot_draw(cairo, &plot, width, height);
}

void tinker_graph_copy(GtkWidget *widget, TinkerGraphData *data, int width, int height)
{
    cairo_surface_t *image = tinker_image_new(width, height, FINENESS);
    cairo_t *cairo = cairo_create(image);
    tinker_graph_draw_for_paper(data, cairo, width, height);
    cairo_destroy(cairo);
    g_autoptr(GdkTexture) texture = tinker_image_to_texture(image);
    gdk_clipboard_set_texture(gtk_widget_get_clipboard(widget), texture);
}

/* Asking ----------------------------------------------------------------------------------------------------------- */

static void question_free(Question *question)
{
    g_object_unref(question->view);
    g_free(question);
}

static GtkWindow *window_of(GtkWidget *widget)
{
    GtkRoot *root = gtk_widget_get_root(widget);
    return GTK_IS_WINDOW(root) ? GTK_WINDOW(root) : NULL;
}

static void tell(GtkWidget *view, const char *heading, const char *body)
{
    tinker_message(window_of(view), heading, body);
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

static void on_image_file(GtkNativeDialog *dialog, int response, Question *question)
{
    g_autofree char *full = response == GTK_RESPONSE_ACCEPT ? tinker_picture_dialog_path(dialog) : NULL;
    if (full != NULL) {
        g_autoptr(GError) error = NULL;
        TinkerPlot plot = plot_for_paper(question->data);
        if (!tinker_graph_data_check_output(question->data, full, &error) ||
            !tinker_plot_to_file(&plot, question->width, question->height, full, &error))
            tell(question->view, _("The Image Was Not Saved"), error->message);
    }
    question_free(question);
    g_object_unref(dialog);
}

void tinker_graph_save_image(GtkWidget *view, TinkerGraphData *data, int width, int height)
{
    Question *question = g_new(Question, 1);
    *question = (Question){g_object_ref(view), data, MAX(width, SAVED_WIDTH), MAX(height, SAVED_HEIGHT)};
    GtkFileChooserNative *dialog =
        tinker_picture_dialog_new(window_of(view), _("Save Image As"), tinker_graph_data_title(data));
    g_signal_connect(dialog, "response", G_CALLBACK(on_image_file), question);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

/* Values ----------------------------------------------------------------------------------------------------------- */

static void on_values_file(GtkNativeDialog *dialog, int response, Question *question)
{
    g_autofree char *path = response == GTK_RESPONSE_ACCEPT ? tinker_save_dialog_path(dialog) : NULL;
    if (path != NULL) {
        g_autoptr(GError) error = NULL;
        const char *digits = gtk_file_chooser_get_choice(GTK_FILE_CHOOSER(dialog), "digits");
        g_autofree char *full = tinker_has_ending(path, ".csv") ? g_strdup(path) : g_strconcat(path, ".csv", NULL);
        tinker_graph_data_catch_up(question->data);
        if (!tinker_graph_data_write_csv(question->data, full, g_strcmp0(digits, "five") == 0 ? SHOWN_DECIMALS : -1,
                                         &error))
            tell(question->view, _("The Values Were Not Exported"), error->message);
    }
    question_free(question);
    g_object_unref(dialog);
}

void tinker_graph_export_values(GtkWidget *view, TinkerGraphData *data)
{
    tinker_graph_data_update(data);
    if (tinker_graph_data_count(data) == 0) {
        tell(view, _("Nothing to Export Yet"), _("Press Play first: the values come from the run."));
        return;
    }
    Question *question = g_new(Question, 1);
    *question = (Question){g_object_ref(view), data, 0, 0};
    GtkFileChooserNative *dialog =
        tinker_save_dialog_new(window_of(view), _("Export Values To File"), tinker_graph_data_title(data), ".csv");
    const char *ids[] = {"nine", "five", NULL};
    const char *labels[] = {_("9 significant digits"), _("5 decimals"), NULL};
    tinker_save_dialog_add_filter(dialog, _("CSV table"), ".csv");
    gtk_file_chooser_add_choice(GTK_FILE_CHOOSER(dialog), "digits", _("Numbers"), ids, labels);
    gtk_file_chooser_set_choice(GTK_FILE_CHOOSER(dialog), "digits", "nine");
    g_signal_connect(dialog, "response", G_CALLBACK(on_values_file), question);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}
