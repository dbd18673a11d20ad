/* The canvas on paper: as a picture in a file, and printed, there with all graphs behind it. What is drawn is what is
 * seen, in the light theme; graphs and instruments that stand on the canvas are in it. */
#include <glib/gi18n.h>

#include "gui/graph/graph-export.h"
#include "gui/widget/save-dialog.h"
#include "gui/window/window-parts.h"
#include "render/draw/surface.h"

#define GRAPHS_ON_A_PAGE 2
#define GRAPH_WIDTH      640.0 /* units that the width of the paper has for a graph: its texts are then readable */
#define GAP              0.05  /* of the height of a page, between two graphs */

static void draw_canvas(cairo_t *cairo, double width, double height, gpointer data)
{
    TinkerWindow *window = data;
    const TinkerView *view = tinker_canvas_view(window->canvas);
    const double factor = MIN(width / view->width, height / view->height);
    cairo_save(cairo);
    cairo_scale(cairo, factor, factor);
    cairo_rectangle(cairo, 0, 0, view->width, view->height);
    cairo_clip(cairo);
    tinker_canvas_draw_for_paper(window->canvas, cairo);
    tinker_graph_layer_draw_for_paper(window->graph_layer, cairo);
    tinker_instrument_layer_draw(window->instruments, cairo);
    cairo_restore(cairo);
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

static gboolean write_picture(TinkerWindow *window, const char *path, GError **error)
{
    const TinkerView *view = tinker_canvas_view(window->canvas);
    g_autoptr(TinkerFileSet) files = tinker_document_files(window->document);
    if (!tinker_file_set_add_output(files, NULL, path, error)) return FALSE;
    return tinker_surface_to_file(draw_canvas, window, (int)view->width, (int)view->height, path, error);
}

static void on_file(GtkNativeDialog *dialog, int response, TinkerWindow *window)
{
    g_autofree char *path = response == GTK_RESPONSE_ACCEPT ? tinker_picture_dialog_path(dialog) : NULL;
    g_autoptr(GError) error = NULL;
    if (path != NULL && write_picture(window, path, &error)) {
        g_autofree char *name = g_path_get_basename(path), *saved = g_strdup_printf(_("Saved as %s"), name);
        window_toast(window, saved);
    } else if (path != NULL) {
        window_message(window, _("The Image Was Not Saved"), error->message);
    }
    g_object_unref(dialog);
    g_object_unref(window);
}

void window_save_picture(TinkerWindow *window)
{
    g_autofree char *name = tinker_document_name(window->document);
    GtkFileChooserNative *dialog = tinker_picture_dialog_new(GTK_WINDOW(window), _("Save Picture"), name);
    g_signal_connect(dialog, "response", G_CALLBACK(on_file), g_object_ref(window));
    gtk_native_dialog_show(GTK_NATIVE_DIALOG(dialog));
}

/* Printing --------------------------------------------------------------------------------------------------------- */

static int graph_count(TinkerWindow *window)
{
    return (int)tinker_scene_graphs(tinker_document_scene(window->document))->len;
}

static void draw_graph(TinkerWindow *window, int number, cairo_t *cairo, double width, double height)
{
    GPtrArray *graphs = tinker_scene_graphs(tinker_document_scene(window->document));
    g_autoptr(TinkerGraphData) data = tinker_graph_data_new(window->document, window->player);
    const double factor = width / GRAPH_WIDTH;
    tinker_graph_data_set_graph(data, g_ptr_array_index(graphs, (guint)number));
    cairo_save(cairo);
    cairo_scale(cairo, factor, factor);
    tinker_graph_draw_for_paper(data, cairo, GRAPH_WIDTH, height / factor);
    cairo_restore(cairo);
}

static void on_begin(GtkPrintOperation *operation, GtkPrintContext *context, TinkerWindow *window)
{
    gtk_print_operation_set_n_pages(operation, 1 + (graph_count(window) + GRAPHS_ON_A_PAGE - 1) / GRAPHS_ON_A_PAGE);
}

static void on_draw_page(GtkPrintOperation *operation, GtkPrintContext *context, int page, TinkerWindow *window)
{
    cairo_t *cairo = gtk_print_context_get_cairo_context(context);
    const double width = gtk_print_context_get_width(context), height = gtk_print_context_get_height(context);
    if (page == 0) {
        draw_canvas(cairo, width, height, window);
        return;
    }
    const double each = height / GRAPHS_ON_A_PAGE;
    for (int i = 0; i < GRAPHS_ON_A_PAGE; i++) {
        const int number = (page - 1) * GRAPHS_ON_A_PAGE + i;
        if (number >= graph_count(window)) return;
        draw_graph(window, number, cairo, width, each - GAP * height);
        cairo_translate(cairo, 0, each);
    }
}

static void on_done(GtkPrintOperation *operation, GtkPrintOperationResult result, TinkerWindow *window)
{
    g_autoptr(GError) error = NULL;
    if (result != GTK_PRINT_OPERATION_RESULT_ERROR) return;
    gtk_print_operation_get_error(operation, &error);
    window_message(window, _("It Was Not Printed"), error->message);
}

void window_print(TinkerWindow *window)
{
    g_autoptr(GtkPrintOperation) operation = gtk_print_operation_new();
    g_autoptr(GtkPageSetup) page = gtk_page_setup_new();
    g_autofree char *name = tinker_document_name(window->document);
    const TinkerView *view = tinker_canvas_view(window->canvas);
    if (view->width > view->height) gtk_page_setup_set_orientation(page, GTK_PAGE_ORIENTATION_LANDSCAPE);
    gtk_print_operation_set_default_page_setup(operation, page);
    gtk_print_operation_set_job_name(operation, name);
    gtk_print_operation_set_allow_async(operation, TRUE);
    g_signal_connect_object(operation, "begin-print", G_CALLBACK(on_begin), window, 0);
    g_signal_connect_object(operation, "draw-page", G_CALLBACK(on_draw_page), window, 0);
    g_signal_connect_object(operation, "done", G_CALLBACK(on_done), window, 0);
    gtk_print_operation_run(operation, GTK_PRINT_OPERATION_ACTION_PRINT_DIALOG, GTK_WINDOW(window), NULL);
}
