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
static gboolean is_dropped_on(const TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body, double reach,
                              double *along)
{
    double x, y, orientation, gap;
    if (top->plate == TINKER_NO_BLOCK) return FALSE;
    tinker_top_foot(frame, top, body, along, &gap);
    tinker_frame_centre(frame, body, &x, &y, &orientation);
    const double half = tinker_top_reach(frame, top, body, orientation);
    return fabs(*along) <= top->half_width && gap < reach && gap > -fmax(half, reach);
}

/* Whether anything is attached to the body: a place of its own is not to be taken from what holds it. */
static gboolean is_attached(const TinkerScene *scene, TinkerBlockId body)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        for (int32_t e = 0; e < tinker_scene_end_count(scene, block); e++)
            if (tinker_scene_end(scene, block, e).block == body) return TRUE;
    }
    return FALSE;
}

/* Puts a body that turns onto the top, with a side on it. */
static gboolean stand_on(TinkerHistory *history, TinkerFrame *frame, const TinkerTop *top, TinkerBlockId body,
                         double along)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(tinker_frame_scene(frame), body);
    const double flat = tinker_top_flat(frame, top, body);
    double centre[2];
    tinker_top_centre(top, along, tinker_top_reach(frame, top, body, flat), centre);
    return tinker_history_set(history, body, block_class->meanings[TINKER_MEANING_POSITION], centre, NULL) &&
           tinker_history_set(history, body, block_class->meanings[TINKER_MEANING_ORIENTATION], &flat, NULL);
}

gboolean tinker_snap_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, double reach)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return FALSE;
    const gboolean lies = tinker_class_can_lie(tinker_scene_block_class(scene, body));
    if (!lies && (!tinker_body_can_stand(frame, body) || is_attached(scene, body))) return FALSE;
    double along;
    const TinkerTop top = tinker_top_nearest(frame, body);
    if (!is_dropped_on(frame, &top, body, reach, &along)) return FALSE;
    along = tinker_top_round(&top, along);
    if (!lies) return stand_on(history, frame, &top, body, along);
    g_clear_pointer(&frame, tinker_frame_free); /* it must not outlive the scene as it is */
    return tinker_history_lay_on(history, body, top.plate, along, NULL);
}
