/* Bodies that turn and are not solid: they pass through tops that they look as if they could lie on. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/advice-private.h"
#include "analysis/start/start-private.h"
#include "physics/run/acting-forces.h"
#include "scene/frame/tops.h"

/* So steeply, as a sine, a fall meets a top that it is told of. */
#define STEEP 0.5

/* All forces at the start, worked out for the first body that asks: none where the scene cannot run. Borrowed. */
static const GArray *forces_at_start(TinkerScene *scene, GArray **forces)
{
    if (*forces != NULL) return *forces;
    *forces = tinker_acting_forces_array();
    if (!tinker_acting_forces_at_start(scene, *forces, NULL)) g_array_set_size(*forces, 0);
    return *forces;
}

/* The direction in which fields pull a body at the start; FALSE where none does. */
static gboolean find_pull(const GArray *forces, TinkerBlockId body, double pull[2])
{
    pull[0] = pull[1] = 0;
    for (guint i = 0; i < forces->len; i++) {
        const TinkerActingForce *force = &g_array_index(forces, TinkerActingForce, i);
        if (force->kind != TINKER_ACTING_FIELD || force->on != body) continue;
        pull[0] += force->fx;
        pull[1] += force->fy;
    }
    const double size = hypot(pull[0], pull[1]);
    if (!(size > 0)) return FALSE;
    pull[0] /= size;
    pull[1] /= size;
    return TRUE;
}

/* What a joint holds, or hangs on anything, may be drawn in front of supports and be meant to pass. */
static gboolean is_held(TinkerScene *scene, TinkerBlockId body, gboolean by_joint)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (by_joint && !start_is_joint(tinker_scene_block_class(scene, block))) continue;
        for (int32_t e = 0; e < tinker_scene_end_count(scene, block); e++)
            if (tinker_scene_end(scene, block, e).block == body) return TRUE;
    }
    return FALSE;
}

/* How far (m) a place is from a top along the pull; INFINITY where it does not fall onto it. */
static double way_to(const TinkerTop *top, const double place[2], const double pull[2])
{
    const double height = tinker_top_height(top, place), steep = -(pull[0] * top->normal[0] + pull[1] * top->normal[1]);
    if (!(steep > STEEP) || !(height > 0)) return INFINITY;
    const double way = height / steep,
                 at[2] = {place[0] + way * pull[0] - top->middle[0], place[1] + way * pull[1] - top->middle[1]};
    return fabs(at[0] * top->along[0] + at[1] * top->along[1]) <= top->half_width ? way : INFINITY;
}

/* The solid top that a body lies at, or the first of those that it falls onto. */
static TinkerBlockId passed_top(const TinkerFrame *frame, TinkerBlockId body, GArray **forces)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const TinkerTop nearest = tinker_top_nearest(frame, body);
    if (is_held(scene, body, TRUE)) return TINKER_NO_BLOCK;
    if (nearest.plate != TINKER_NO_BLOCK && tinker_top_touches(frame, &nearest, body)) return nearest.plate;
    TinkerBlockId found = TINKER_NO_BLOCK;
    double centre[2], angle, pull[2], least = INFINITY;
    if (is_held(scene, body, FALSE) || !find_pull(forces_at_start(scene, forces), body, pull)) return TINKER_NO_BLOCK;
    tinker_frame_centre(frame, body, &centre[0], &centre[1], &angle);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId plate = tinker_scene_block_at(scene, i);
        if (!tinker_class_has_top(tinker_scene_block_class(scene, plate)) ||
            tinker_frame_meaning(frame, plate, TINKER_MEANING_SOLID, 0, 1) == 0)
            continue;
        const TinkerTop top = tinker_top_of(frame, plate);
        const double way = way_to(&top, centre, pull);
        if (!(way < least)) continue;
        least = way;
        found = plate;
    }
    return found;
}

void advice_on_passing(GPtrArray *all, const TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    g_autoptr(GArray) forces = NULL;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId body = tinker_scene_block_at(scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, body);
        if (block_class == NULL || !tinker_block_class_turns(block_class) ||
            tinker_frame_meaning(frame, body, TINKER_MEANING_SOLID, 0, 1) != 0)
            continue;
        const TinkerBlockId plate = passed_top(frame, body, &forces);
        if (plate == TINKER_NO_BLOCK) continue;
        TinkerAdvice *advice =
            advice_add(all, TINKER_ADVICE_PASSING, FALSE,
                       g_strdup_printf(_("%s is not solid, and passes through %s."),
                                       tinker_scene_block_name(scene, body), tinker_scene_block_name(scene, plate)));
        advice_add_block(advice, body);
        advice_add_block(advice, plate);
        advice->repair = g_strdup(_("Make It Solid"));
    }
}
