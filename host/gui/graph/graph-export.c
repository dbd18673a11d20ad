/* Pictures that leave the program are for white paper: the light theme, with the title, not in the window's compact
 * form. */
#include "gui/graph/graph-export.h"

#include <adwaita.h>
#include <glib/gi18n.h>
#include <string.h>

#include "gui/text/message.h"
#include "gui/widget/image-texture.h"

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

static const struct {
    const char *name, *ending;
} formats[] = {{N_("PNG image"), ".png"}, {N_("SVG drawing"), ".svg"}, {N_("PDF document"), ".pdf"}};

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

void tinker_graph_copy(GtkWidget *widget, TinkerGraphData *data, int width, int height)
{
    TinkerPlot plot = plot_for_paper(data);
    cairo_surface_t *image = tinker_image_new(width, height, FINENESS);
    cairo_t *cairo = cairo_create(image);
    tinker_plot_draw(cairo, &plot, width, height);
    cairo_destroy(cairo);
    g_autoptr(GdkTexture) texture = tinker_image_to_texture(image);
    gdk_clipboard_set_texture(gtk_widget_get_clipboard(widget), texture);
}

/* Asking --------------------------------------------------------------------------------------------------------------
 */

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

static void add_filter(GtkFileChooser *chooser, const char *name, const char *ending)
{
    g_autoptr(GtkFileFilter) filter = gtk_file_filter_new();
    g_autofree char *pattern = g_strconcat("*", ending, NULL);
    gtk_file_filter_set_name(filter, name);
    gtk_file_filter_add_pattern(filter, pattern);
    gtk_file_chooser_add_filter(chooser, filter);
}

/* A dialog that suggests the graph's title as the file's name. (transfer full) */
static GtkFileChooserNative *ask(GtkWidget *view, const char *title, const char *suggestion, const char *ending)
{
    GtkFileChooserNative *dialog =
        gtk_file_chooser_native_new(title, window_of(view), GTK_FILE_CHOOSER_ACTION_SAVE, _("_Save"), _("_Cancel"));
    g_autofree char *bare = g_strdup(suggestion);
    g_strdelimit(bare, "/\\", '-');
    g_strdelimit(bare, ":", ',');
    g_autofree char *name = g_strconcat(bare, ending, NULL);
    gtk_native_dialog_set_modal(GTK_NATIVE_DIALOG(dialog), TRUE);
    gtk_file_chooser_set_current_name(GTK_FILE_CHOOSER(dialog), name);
    return dialog;
}

static char *chosen_path(GtkNativeDialog *dialog)
{
    g_autoptr(GFile) file = gtk_file_chooser_get_file(GTK_FILE_CHOOSER(dialog));
    return file != NULL ? g_file_get_path(file) : NULL;
}

/* Pictures ------------------------------------------------------------------------------------------------------------
 */

static gboolean has_ending(const char *path, const char *ending)
{
    gsize length = strlen(path), tail = strlen(ending);
    return length > tail && g_ascii_strcasecmp(path + length - tail, ending) == 0;
}

/* The path with the ending that the chosen filter stands for, where it has none of a picture. (transfer full) */
static char *with_picture_ending(const char *path, GtkFileFilter *filter)
{
    gsize chosen = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(formats); i++) {
        if (has_ending(path, formats[i].ending)) return g_strdup(path);
        if (filter != NULL && g_strcmp0(gtk_file_filter_get_name(filter), _(formats[i].name)) == 0) chosen = i;
    }
    return g_strconcat(path, formats[chosen].ending, NULL);
}

static void on_image_file(GtkNativeDialog *dialog, int response, Question *question)
{
    g_autofree char *path = response == GTK_RESPONSE_ACCEPT ? chosen_path(dialog) : NULL;
    if (path != NULL) {
        g_autoptr(GError) error = NULL;
        g_autofree char *full = with_picture_ending(path, gtk_file_chooser_get_filter(GTK_FILE_CHOOSER(dialog)));
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
    GtkFileChooserNative *dialog = ask(view, _("Save Image As"), tinker_graph_data_title(data), formats[0].ending);
    for (gsize i = 0; i < G_N_ELEMENTS(formats); i++)
        add_filter(GTK_FILE_CHOOSER(dialog), _(formats[i].name), formats[i].ending);
    g_signal_connect(dialog, "response", G_CALLBACK(on_image_file), question);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

/* Values --------------------------------------------------------------------------------------------------------------
 */

static void on_values_file(GtkNativeDialog *dialog, int response, Question *question)
{
    g_autofree char *path = response == GTK_RESPONSE_ACCEPT ? chosen_path(dialog) : NULL;
    if (path != NULL) {
        g_autoptr(GError) error = NULL;
        const char *digits = gtk_file_chooser_get_choice(GTK_FILE_CHOOSER(dialog), "digits");
        g_autofree char *full = has_ending(path, ".csv") ? g_strdup(path) : g_strconcat(path, ".csv", NULL);
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
    GtkFileChooserNative *dialog = ask(view, _("Export Values To File"), tinker_graph_data_title(data), ".csv");
    const char *ids[] = {"nine", "five", NULL};
    const char *labels[] = {_("9 significant digits"), _("5 decimals"), NULL};
    add_filter(GTK_FILE_CHOOSER(dialog), _("CSV table"), ".csv");
    gtk_file_chooser_add_choice(GTK_FILE_CHOOSER(dialog), "digits", _("Numbers"), ids, labels);
    gtk_file_chooser_set_choice(GTK_FILE_CHOOSER(dialog), "digits", "nine");
    g_signal_connect(dialog, "response", G_CALLBACK(on_values_file), question);
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}
