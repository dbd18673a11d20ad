/* Snapping: to a square grid through the world's origin, and of bodies onto tops. */
#include <math.h>

#include "edit/drag.h"
#include "scene/frame/tops.h"

static double snapped(double grid, double value)
{
    /* Where the grid is finer than the digits of the value, the value is as good as on it. */
    double steps = round(value / grid);
    return fabs(steps) < 4503599627370496.0 ? steps * grid : value;
}

void tinker_snap(double grid, double *x, double *y)
{
    if (!(grid > 0) || !isfinite(grid)) return;
    *x = snapped(grid, *x);
    *y = snapped(grid, *y);
}

/* Whether the body is dropped on the top: from its front, over its width. */
static gboolean is_dropped_on(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body, double reach)
{
    double along, gap;
    if (top->plate == TINKER_NO_BLOCK) return FALSE;
    tinker_top_foot(frame, top, body, &along, &gap);
    const double half = 0.5 * tinker_frame_meaning(frame, body, TINKER_MEANING_HEIGHT, 0, 0);
    return fabs(along) <= top->half_width && gap < reach && gap > -fmax(half, reach);
}

gboolean tinker_snap_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, double reach)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, body);
    if (!tinker_class_can_lie(block_class)) return FALSE;
    TinkerFrame *frame = tinker_frame_new(scene, NULL);
    double along, gap;
    if (frame == NULL) return FALSE;
    const TinkerTop top = tinker_top_nearest(frame, body);
    const gboolean dropped = is_dropped_on(frame, &top, body, reach);
    if (dropped) tinker_top_foot(frame, &top, body, &along, &gap);
    tinker_frame_free(frame);
    if (!dropped) return FALSE;
    return tinker_history_lay_on(history, body, top.plate, tinker_top_round(&top, along), NULL);
}
