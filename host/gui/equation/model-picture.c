#include "gui/equation/model-picture.h"

#include <glib/gi18n.h>

#include "common/diagram/books-picture.h"
#include "common/diagram/diagram-picture.h"
#include "gui/widget/desktop-theme.h"

#define DIAGRAM_HEIGHT 380
#define BOOKS_HEIGHT   840

#define REACH 5.0 /* widget units: how near to an arrow is at it */

/* What a picture is made from, and what was drawn. */
typedef struct {
    TinkerDocument *document;
    TinkerModelTask *task;
    GArray *spots;        /* of TinkerSpot, drawn last */
    TinkerPointed chosen; /* by keys */
} Source;

static void source_free(gpointer data)
{
    Source *source = data;
    g_object_unref(source->document);
    g_object_unref(source->task);
    g_array_unref(source->spots);
    g_free(source);
}

static void draw_diagram(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    Source *source = data;
    const TinkerModelResult *result = tinker_model_task_result(source->task);
    g_array_set_size(source->spots, 0);
    if (result == NULL || result->state == NULL || result->bodies[0] == TINKER_NO_BLOCK) return;
    g_autoptr(TinkerFrame) frame = tinker_diagram_frame(result->scene, result->state, NULL);
    g_autoptr(TinkerDiagram) diagram = tinker_diagram_new(result->scene, result->state, result->bodies, NULL);
    if (frame == NULL || diagram == NULL) return;
    TinkerDiagramPicture picture = {.frame = frame,
                                    .diagram = diagram,
                                    .blocks = result->bodies,
                                    .theme = tinker_desktop_theme(),
                                    .lit = tinker_document_pointed(source->document),
                                    .spots = source->spots};
    tinker_diagram_draw(cairo, width, height, &picture);
}

static void draw_books(GtkDrawingArea *area, cairo_t *cairo, int width, int height, gpointer data)
{
    Source *source = data;
    const TinkerModelResult *result = tinker_model_task_result(source->task);
    g_array_set_size(source->spots, 0);
    if (result == NULL || result->books == NULL) return;
    TinkerBooksPicture picture = {.scene = result->scene,
                                  .books = result->books,
                                  .bodies = result->bodies,
                                  .theme = tinker_desktop_theme(),
                                  .lit = tinker_document_pointed(source->document),
                                  .spots = source->spots};
    tinker_books_draw(cairo, width, height, &picture);
}

static void on_pointed(GtkWidget *area)
{
    if (gtk_widget_get_mapped(area)) gtk_widget_queue_draw(area);
}

/* Pointing --------------------------------------------------------------------------------------------------------- */

static Source *source_of(GtkWidget *area)
{
    return g_object_get_data(G_OBJECT(area), "source");
}

static void on_motion(GtkEventControllerMotion *motion, double x, double y, GtkWidget *area)
{
    Source *source = source_of(area);
    const TinkerSpot *spot = tinker_spots_at(source->spots, x, y, REACH);
    tinker_document_point(source->document, spot != NULL ? spot->what : tinker_pointed_block(TINKER_NO_BLOCK));
}

static void on_leave(GtkEventControllerMotion *motion, GtkWidget *area)
{
    tinker_document_point(source_of(area)->document, tinker_pointed_block(TINKER_NO_BLOCK));
}

static gboolean on_tooltip(GtkWidget *area, int x, int y, gboolean by_key, GtkTooltip *tooltip)
{
    const TinkerSpot *spot = by_key ? NULL : tinker_spots_at(source_of(area)->spots, x, y, REACH);
    gtk_tooltip_set_text(tooltip, spot != NULL ? spot->text : NULL);
    return spot != NULL;
}

/* Chooses the one that is so many behind the last one, the first where there was none, and tells it. */
static void choose(GtkWidget *area, int step)
{
    Source *source = source_of(area);
    const TinkerSpot *spot = tinker_spots_next(source->spots, &source->chosen, step);
    if (spot == NULL) return;
    source->chosen = spot->what;
    gtk_accessible_update_property(GTK_ACCESSIBLE(area), GTK_ACCESSIBLE_PROPERTY_DESCRIPTION, spot->text, -1);
    tinker_document_point(source->document, spot->what);
}

static gboolean on_key(GtkEventControllerKey *keys, guint key, guint code, GdkModifierType modifiers, GtkWidget *area)
{
    Source *source = source_of(area);
    const gboolean is_block = tinker_scene_has_block(tinker_document_scene(source->document), source->chosen.block);
    if (modifiers & (GDK_CONTROL_MASK | GDK_ALT_MASK)) return GDK_EVENT_PROPAGATE;
    if (key == GDK_KEY_Down || key == GDK_KEY_Up)
        choose(area, key == GDK_KEY_Down ? 1 : -1);
    else if (is_block && (key == GDK_KEY_Return || key == GDK_KEY_KP_Enter))
        tinker_document_select(source->document, source->chosen.block);
    else
        return GDK_EVENT_PROPAGATE;
    return GDK_EVENT_STOP;
}

static void on_focus(GtkEventControllerFocus *focus, GtkWidget *area)
{
    choose(area, 0);
}

static void on_focus_leave(GtkEventControllerFocus *focus, GtkWidget *area)
{
    Source *source = source_of(area);
    tinker_document_point_away(source->document, source->chosen);
}

static void on_click(GtkGestureClick *gesture, int presses, double x, double y, GtkWidget *area)
{
    Source *source = source_of(area);
    const TinkerSpot *spot = tinker_spots_at(source->spots, x, y, REACH);
    if (spot != NULL) source->chosen = spot->what;
    gtk_widget_grab_focus(area);
    if (spot != NULL) choose(area, 0);
}

static void add_input(GtkWidget *area)
{
    GtkEventController *motion = gtk_event_controller_motion_new(), *focus = gtk_event_controller_focus_new();
    GtkEventController *keys = gtk_event_controller_key_new();
    GtkGesture *click = gtk_gesture_click_new();
    g_signal_connect(motion, "enter", G_CALLBACK(on_motion), area);
    g_signal_connect(motion, "motion", G_CALLBACK(on_motion), area);
    g_signal_connect(motion, "leave", G_CALLBACK(on_leave), area);
    g_signal_connect(focus, "enter", G_CALLBACK(on_focus), area);
    g_signal_connect(focus, "leave", G_CALLBACK(on_focus_leave), area);
    g_signal_connect(keys, "key-pressed", G_CALLBACK(on_key), area);
    g_signal_connect(click, "pressed", G_CALLBACK(on_click), area);
    g_signal_connect(area, "query-tooltip", G_CALLBACK(on_tooltip), NULL);
    GtkEventController *all[] = {motion, focus, keys, GTK_EVENT_CONTROLLER(click)};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++)
        gtk_widget_add_controller(area, all[i]);
    gtk_widget_set_focusable(area, TRUE);
    gtk_widget_set_has_tooltip(area, TRUE);
}

static GtkWidget *new_picture(TinkerDocument *document, TinkerModelTask *task, GtkDrawingAreaDrawFunc draw, int height,
                              const char *label)
{
    GtkWidget *area = g_object_new(GTK_TYPE_DRAWING_AREA, "accessible-role", GTK_ACCESSIBLE_ROLE_IMG, NULL);
    Source *source = g_new(Source, 1);
    *source =
        (Source){g_object_ref(document), g_object_ref(task), tinker_spots_new(), tinker_pointed_block(TINKER_NO_BLOCK)};
    g_object_set_data(G_OBJECT(area), "source", source);
    gtk_drawing_area_set_content_height(GTK_DRAWING_AREA(area), height);
    gtk_drawing_area_set_draw_func(GTK_DRAWING_AREA(area), draw, source, source_free);
    gtk_accessible_update_property(GTK_ACCESSIBLE(area), GTK_ACCESSIBLE_PROPERTY_LABEL, label, -1);
    tinker_desktop_theme_redraws(area);
    gtk_widget_set_visible(area, FALSE);
    add_input(area);
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
