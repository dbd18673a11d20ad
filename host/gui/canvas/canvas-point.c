/* Pointing at blocks and arrows, with the pointer and by keys: what is pointed at here lights up in all views. */
#include "gui/canvas/canvas-private.h"

#define ARROW_REACH 4.0 /* widget units: how near to an arrow is at it */

/* Arrows and their labels lie over the blocks. */
static const TinkerSpot *arrow_at(TinkerCanvas *canvas, double x, double y)
{
    const double larger = canvas_magnification(canvas);
    return tinker_spots_at(canvas_forces_spots(canvas->forces), x / larger, y / larger, ARROW_REACH / larger);
}

/* `arrow`: it is one or its label, which is to show up among others here as well. */
static void point(TinkerCanvas *canvas, TinkerPointed what, gboolean arrow)
{
    if (canvas->points_at_arrow != arrow) gtk_widget_queue_draw(GTK_WIDGET(canvas));
    canvas->points = TRUE;
    canvas->points_at_arrow = arrow;
    tinker_document_point(canvas->document, what);
}

void canvas_point_at(TinkerCanvas *canvas, double x, double y, TinkerBlockId under)
{
    const TinkerSpot *arrow = arrow_at(canvas, x, y);
    point(canvas, arrow != NULL ? arrow->what : tinker_pointed_block(under), arrow != NULL);
}

void canvas_point_away(TinkerCanvas *canvas)
{
    if (canvas->document != NULL) tinker_document_point(canvas->document, tinker_pointed_block(TINKER_NO_BLOCK));
    canvas->points = canvas->points_at_arrow = FALSE;
}

static void forget_reached(TinkerCanvas *canvas)
{
    if (canvas->reached_text == NULL) return;
    g_clear_pointer(&canvas->reached_text, g_free);
    canvas_describe_view(canvas);
}

void canvas_reach_block(TinkerCanvas *canvas, TinkerBlockId block)
{
    forget_reached(canvas);
    canvas->reached = tinker_pointed_block(block);
    point(canvas, canvas->reached, FALSE);
}

gboolean canvas_reach_arrow(TinkerCanvas *canvas, int step)
{
    const TinkerPointed *from = canvas->reached_text != NULL ? &canvas->reached : NULL;
    const TinkerSpot *spot = tinker_spots_next(canvas_forces_spots(canvas->forces), from, step);
    if (spot == NULL) return GDK_EVENT_PROPAGATE;
    g_free(canvas->reached_text);
    canvas->reached_text = g_strdup(spot->text);
    canvas->reached = spot->what;
    canvas_describe_view(canvas);
    point(canvas, canvas->reached, TRUE);
    return GDK_EVENT_STOP;
}

void canvas_reach_away(TinkerCanvas *canvas)
{
    forget_reached(canvas);
    canvas->points = canvas->points_at_arrow = FALSE;
    gtk_widget_queue_draw(GTK_WIDGET(canvas));
    if (canvas->document != NULL) tinker_document_point_away(canvas->document, canvas->reached);
    canvas->reached = tinker_pointed_block(TINKER_NO_BLOCK);
}
