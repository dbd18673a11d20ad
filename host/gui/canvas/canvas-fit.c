/* What the view is set to: all there is to see, the width of the scene, and the same again when the canvas gets another
 * size or is covered. */
#include <math.h>
#include <string.h>

#include "gui/canvas/canvas-private.h"

#define FIT_MARGIN   48.0
#define NOTICE       48.0 /* widget units: a notice over the top, of which the margin leaves no room for as much */
#define CANVAS_SHAPE 0.6  /* height of a canvas over its width, where only that is known */

void tinker_canvas_zoom(TinkerCanvas *canvas, double factor)
{
    tinker_view_zoom(&canvas->view, factor, canvas->view.width / 2, canvas->view.height / 2);
    canvas_view_changed(canvas);
}

/* `above` widget units at the top stay free. */
static void show_box(TinkerCanvas *canvas, const double box[4], double margin, double above)
{
    double width = canvas->view.width, height = canvas->view.height;
    if (!(width > 0) || !(height > above)) return;
    canvas->view = tinker_view_fit(box, width, height - above, margin);
    tinker_view_pan(&canvas->view, 0, above);
    canvas->view.height = height;
    canvas->view_is_set = TRUE;
    canvas_view_changed(canvas);
}

/* As show_box; when the canvas gets another size it shows the same, as long as nobody looks elsewhere meanwhile. */
static void fit_box(TinkerCanvas *canvas, const double box[4], double margin, double above)
{
    show_box(canvas, box, margin, above);
    memmove(canvas->fitted, box, sizeof canvas->fitted);
    canvas->fitted_margin = margin;
    canvas->fitted_above = above;
    canvas->view_is_fitted = TRUE;
}

/* What stays free at the top: the place of a notice of one line, or of the one that is there. */
static double room_above(const TinkerCanvas *canvas)
{
    return fmax(NOTICE, canvas_seen_from(canvas));
}

/* Graphs that float are part of what there is to see. */
static void include_graphs(TinkerScene *scene, double box[4])
{
    GPtrArray *graphs = tinker_scene_graphs(scene);
    for (guint i = 0; i < graphs->len; i++) {
        const TinkerSceneGraph *graph = g_ptr_array_index(graphs, i);
        double width = graph->has_size ? graph->size[0] : 0, height = graph->has_size ? graph->size[1] : 0;
        if (!graph->has_place) continue;
        box[0] = fmin(box[0], graph->place[0]);
        box[1] = fmin(box[1], graph->place[1] - height);
        box[2] = fmax(box[2], graph->place[0] + width);
        box[3] = fmax(box[3], graph->place[1]);
    }
}

/* The box of everything there is to see; FALSE where there is none. */
static gboolean box_of_all(TinkerCanvas *canvas, double box[4])
{
    TinkerFrame *frame = tinker_player_frame(canvas->player);
    if (frame == NULL) return FALSE;
    tinker_painter_bounds(frame, box);
    include_graphs(tinker_frame_scene(frame), box);
    return TRUE;
}

void tinker_canvas_fit(TinkerCanvas *canvas)
{
    double box[4];
    if (box_of_all(canvas, box)) fit_box(canvas, box, FIT_MARGIN, room_above(canvas));
}

double tinker_canvas_covered(TinkerCanvas *canvas)
{
    return canvas_seen_from(canvas);
}

/* Shows the same below what lies over it, where that covers something of the scene. */
static gboolean keep_below_cover(gpointer data)
{
    TinkerCanvas *canvas = data;
    double box[4], x, top;
    canvas->keeping_below = 0;
    if (canvas->covered_told != canvas_seen_from(canvas)) {
        canvas->covered_told = canvas_seen_from(canvas);
        g_signal_emit_by_name(canvas, "view-changed");
    }
    if (room_above(canvas) <= canvas->fitted_above) return G_SOURCE_REMOVE;
    if (!canvas->view_is_fitted || canvas->gesture != CANVAS_IDLE || !box_of_all(canvas, box)) return G_SOURCE_REMOVE;
    tinker_view_to_canvas(&canvas->view, 0, box[3], &x, &top);
    if (top < canvas_seen_from(canvas)) fit_box(canvas, canvas->fitted, canvas->fitted_margin, room_above(canvas));
    return G_SOURCE_REMOVE;
}

void tinker_canvas_cover_placed(TinkerCanvas *canvas)
{
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
    /* not while widgets get their places */
    if (canvas->keeping_below == 0)
        canvas->keeping_below = g_idle_add_full(G_PRIORITY_DEFAULT, keep_below_cover, canvas, NULL);
}

void tinker_canvas_show_width(TinkerCanvas *canvas)
{
    double half = tinker_scene_head(tinker_document_scene(canvas->document))->canvas_width / 2;
    show_box(canvas, (double[]){-half, 0, half, 0}, 0, 0);
}

/* Widens a range about its middle. */
static void widen(double *low, double *high, double length)
{
    double room = (length - (*high - *low)) / 2;
    if (room <= 0) return;
    *low -= room;
    *high += room;
}

void canvas_renew_memory(TinkerCanvas *canvas)
{
    tinker_paint_memory_free(canvas->memory);
    canvas->memory = tinker_paint_memory_new();
}

/* A scene is first shown as wide as it says, because it will move, and wholly; an empty one as wide as it says. */
void tinker_canvas_show_first(TinkerCanvas *canvas)
{
    double box[4], canvas_width = tinker_scene_head(tinker_document_scene(canvas->document))->canvas_width;
    canvas_renew_memory(canvas);
    if (tinker_document_is_empty(canvas->document) || !box_of_all(canvas, box)) {
        tinker_canvas_show_width(canvas);
        return;
    }
    widen(&box[0], &box[2], canvas_width);
    widen(&box[1], &box[3], CANVAS_SHAPE * canvas_width);
    fit_box(canvas, box, 0, room_above(canvas));
}

/* With graphs that float by now. */
static void show_fitted_again(TinkerCanvas *canvas)
{
    const double above = fmin(canvas->fitted_above, room_above(canvas));
    double box[4];
    memcpy(box, canvas->fitted, sizeof box);
    if (canvas->document != NULL) include_graphs(tinker_document_scene(canvas->document), box);
    show_box(canvas, box, canvas->fitted_margin, above);
    canvas->fitted_above = above;
    canvas->view_is_fitted = TRUE;
}

gboolean tinker_canvas_is_fitted(TinkerCanvas *canvas)
{
    return canvas->view_is_fitted;
}

void canvas_set_size(TinkerCanvas *canvas, int width, int height)
{
    if (width == (int)canvas->view.width && height == (int)canvas->view.height) return;
    tinker_view_pan(&canvas->view, (width - canvas->view.width) / 2, (height - canvas->view.height) / 2);
    canvas->view.width = width;
    canvas->view.height = height;
    if (!canvas->view_is_set && canvas->document != NULL)
        tinker_canvas_show_first(canvas);
    else if (canvas->view_is_fitted)
        show_fitted_again(canvas);
    else
        canvas_view_changed(canvas);
}
