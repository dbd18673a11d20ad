#include "gui/equation/model-picture.h"

#include <glib/gi18n.h>

#include "common/diagram/books-picture.h"
#include "common/diagram/diagram-picture.h"
#include "gui/widget/desktop-theme.h"

#define DIAGRAM_HEIGHT 340
#define BOOKS_HEIGHT   840

/* What a picture is made from. */
typedef struct {
    TinkerDocument *document;
    TinkerModelTask *task;
} Source;

static void source_free(gpointer data)
{
    Source *source = data;
    g_object_unref(source->document);
    g_object_unref(source->task);
    g_free(source);
}

/* What is pointed at, where the result's scene has it. */
static TinkerBlockId lit_block(const Source *source, const TinkerModelResult *result)
{
    const TinkerBlockId pointed = tinker_document_pointed(source->document);
    return tinker_scene_has_block(result->scene, pointed) ? pointed : TINKER_NO_BLOCK;
}

static void draw_diagram(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const Source *source = data;
    const TinkerModelResult *result = tinker_model_task_result(source->task);
    if (result == NULL || result->state == NULL || result->bodies[0] == TINKER_NO_BLOCK) return;
    g_autoptr(TinkerFrame) frame = tinker_diagram_frame(result->scene, result->state, NULL);
    g_autoptr(TinkerDiagram) diagram = tinker_diagram_new(result->scene, result->state, result->bodies, NULL);
    if (frame == NULL || diagram == NULL) return;
    TinkerDiagramPicture picture = {.frame = frame,
                                    .diagram = diagram,
                                    .blocks = result->bodies,
                                    .theme = tinker_desktop_theme(),
                                    .lit = lit_block(source, result)};
    tinker_diagram_draw(cairo, width, height, &picture);
}

static void draw_books(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    const Source *source = data;
    const TinkerModelResult *result = tinker_model_task_result(source->task);
    if (result == NULL || result->books == NULL) return;
    TinkerBooksPicture picture = {result->scene, result->books, result->bodies, tinker_desktop_theme(),
                                  lit_block(source, result)};
    tinker_books_draw(cairo, width, height, &picture);
}

static void on_pointed(GtkWidget *area)
{
    if (gtk_widget_get_mapped(area)) gtk_widget_queue_draw(area);
}

static GtkWidget *new_picture(TinkerDocument *document, TinkerModelTask *task, GtkDrawingAreaDrawFunc draw, int height,
                              const char *label)
{
    GtkWidget *area = g_object_new(GTK_TYPE_DRAWING_AREA, "accessible-role", GTK_ACCESSIBLE_ROLE_IMG, NULL);
    Source *source = g_new(Source, 1);
    *source = (Source){g_object_ref(document), g_object_ref(task)};
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(area), height);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw, source, source_free);
    gtk_accessible_update_property(GTK_ACCESSIBLE(area), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    tinker_desktop_theme_redraws(area);
    gtk_widget_set_visible(area, FALSE);
    g_signal_connect_object(document, "pointed-changed", G_CALLBACK(on_pointed), area, G_CONNECT_SWAPPED);
    return area;
}

GtkWidget *tinker_model_diagram_new(TinkerDocument *document, TinkerModelTask *task)
{
    return new_picture(document, task, draw_diagram, DIAGRAM_HEIGHT, _("Free-body diagram"));
}

GtkWidget *tinker_model_books_new(TinkerDocument *document, TinkerModelTask *task)
{
    return new_picture(document, task, draw_books, BOOKS_HEIGHT, _("Work and energy, impulse and momentum"));
}
