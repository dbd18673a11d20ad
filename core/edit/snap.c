/* Snapping: to a square grid through the world's origin, and of bodies onto tops. */
#include <math.h>

#include "edit/edit-private.h"
#include "scene/frame/overlaps.h"
#include "scene/frame/tops.h"

#define LEAN_ROUNDS 100 /* each brings the ends nearer to their tops by at least the ratio of length to width */

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

/* Both or neither: what is not finite would be refused. */
static gboolean set_place(TinkerHistory *history, const TinkerBlockClass *block_class, TinkerBlockId body,
                          const double centre[2], double angle)
{
    return isfinite(centre[0]) && isfinite(centre[1]) && isfinite(angle) &&
           tinker_history_set(history, body, block_class->meanings[TINKER_MEANING_POSITION], centre, NULL) &&
           tinker_history_set(history, body, block_class->meanings[TINKER_MEANING_ORIENTATION], &angle, NULL);
}

gboolean tinker_snap_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, double reach)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    if (frame == NULL) return FALSE;
    const gboolean lies = tinker_class_can_lie(tinker_scene_block_class(scene, body));
    if (!lies && (!tinker_body_can_stand(frame, body) || edit_is_attached(scene, body))) return FALSE;
    double along;
    const TinkerTop top = tinker_top_nearest(frame, body);
    if (!is_dropped_on(frame, &top, body, reach, &along)) return FALSE;
    along = tinker_top_round(&top, along);
    const double flat = lies ? 0 : tinker_top_flat(frame, &top, body);
    double centre[2];
    if (!lies) tinker_top_centre(&top, along, tinker_top_reach(frame, &top, body, flat), centre);
    g_clear_pointer(&frame, tinker_frame_free); /* it must not outlive the scene as it is */
    return lies ? tinker_history_lay_on(history, body, top.plate, along, NULL)
                : set_place(history, tinker_scene_block_class(scene, body), body, centre, flat);
}

/* Leaning --------------------------------------------------------------------------------------------------------- */

/* The ends of a bar's axis, and the tops that they are put on. */
typedef struct {
    double end[2][2]; /* m: that at -x of its own axes, and that at +x */
    TinkerTop top[2]; /* `plate` is TINKER_NO_BLOCK: the end stays where it is */
    double half_height;
} Leaning;

/* Moves each end to where a corner of it is on its top. How high that is above the axis depends on how the bar is
 * turned, and so on the other end: each in turn, until both are there. */
static void lean_on(Leaning *leaning)
{
    for (int round = 0; round < LEAN_ROUNDS; round++)
        for (int e = 0; e < 2; e++) {
            const TinkerTop *top = &leaning->top[e];
            double *a = leaning->end[0], *b = leaning->end[1], *end = leaning->end[e];
            const double dx = b[0] - a[0], dy = b[1] - a[1];
            if (top->plate == TINKER_NO_BLOCK || hypot(dx, dy) == 0) continue;
            const double along = fabs(dx * top->along[0] + dy * top->along[1]) / hypot(dx, dy);
            const double rise = leaning->half_height * along - tinker_top_height(top, end);
            end[0] += rise * top->normal[0];
            end[1] += rise * top->normal[1];
        }
}

/* What the ends lie at: that which was dragged within `reach` of it; the other one, whose corners go up and down as the
 * bar is turned, where its axis is no further off than half the height, as it is on a top at any angle. */
static gboolean find_tops(const TinkerFrame *frame, Leaning *leaning, TinkerBlockId body, int dragged, double reach)
{
    const double half = 0.5 * tinker_frame_meaning(frame, body, TINKER_MEANING_WIDTH, 0, 0);
    leaning->half_height = 0.5 * tinker_frame_meaning(frame, body, TINKER_MEANING_HEIGHT, 0, 0);
    for (int e = 0; e < 2; e++) {
        const double own[2] = {e == 0 ? -half : half, 0};
        tinker_frame_to_world(frame, body, own, leaning->end[e]);
        const double within = leaning->half_height + (e == dragged ? reach : TINKER_TOUCHING);
        leaning->top[e] = tinker_top_at(frame, leaning->end[e], within);
    }
    return leaning->top[dragged].plate != TINKER_NO_BLOCK;
}

gboolean tinker_snap_end_onto_top(TinkerHistory *history, TinkerScene *scene, TinkerBlockId body, const double place[2],
                                  double reach)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    double own[2];
    Leaning leaning;
    if (frame == NULL || !edit_has_ends(frame, body) || edit_is_attached(scene, body)) return FALSE;
    tinker_frame_to_own(frame, body, place, own);
    if (!find_tops(frame, &leaning, body, own[0] > 0, reach)) return FALSE;
    lean_on(&leaning);
    g_clear_pointer(&frame, tinker_frame_free); /* it must not outlive the scene as it is */
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, body);
    const double *a = leaning.end[0], *b = leaning.end[1], length = hypot(b[0] - a[0], b[1] - a[1]);
    const double centre[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}, angle = atan2(b[1] - a[1], b[0] - a[0]);
    /* the length first: it alone can be refused where all are finite */
    return isfinite(length) && isfinite(centre[0]) && isfinite(centre[1]) && length > 0 &&
           tinker_history_set(history, body, block_class->meanings[TINKER_MEANING_WIDTH], &length, NULL) &&
           set_place(history, block_class, body, centre, angle);
}
