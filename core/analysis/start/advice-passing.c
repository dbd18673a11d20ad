/* Bodies that turn and are not solid: they pass through tops that they look as if they could lie on. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "analysis/start/advice-private.h"
#include "analysis/start/start-private.h"
#include "scene/frame/tops.h"

/* Whether something pulls all bodies: a block that is a field. */
static gboolean has_field(TinkerScene *scene)
{
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, tinker_scene_block_at(scene, i));
        if (block_class != NULL && block_class->physics != NULL && block_class->physics->field != NULL) return TRUE;
    }
    return FALSE;
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

/* Whether the vertical through a place meets the top below it. */
static gboolean is_below(const TinkerTop *top, const double place[2])
{
    const double height = tinker_top_height(top, place);
    if (!(top->normal[1] > 0.5) || !(height > 0)) return FALSE;
    const double at[2] = {place[0] - top->middle[0], place[1] - height / top->normal[1] - top->middle[1]};
    return fabs(at[0] * top->along[0] + at[1] * top->along[1]) <= top->half_width;
}

/* The solid top that a body lies at, or of those below it the nearest. */
static TinkerBlockId passed_top(const TinkerFrame *frame, TinkerBlockId body)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    const TinkerTop nearest = tinker_top_nearest(frame, body);
    if (is_held(scene, body, TRUE)) return TINKER_NO_BLOCK;
    if (nearest.plate != TINKER_NO_BLOCK && tinker_top_touches(frame, &nearest, body)) return nearest.plate;
    if (is_held(scene, body, FALSE) || !has_field(scene)) return TINKER_NO_BLOCK;
    TinkerBlockId found = TINKER_NO_BLOCK;
    double centre[2], angle, least = INFINITY;
    tinker_frame_centre(frame, body, &centre[0], &centre[1], &angle);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId plate = tinker_scene_block_at(scene, i);
        if (!tinker_class_has_top(tinker_scene_block_class(scene, plate)) ||
            tinker_frame_meaning(frame, plate, TINKER_MEANING_SOLID, 0, 1) == 0)
            continue;
        const TinkerTop top = tinker_top_of(frame, plate);
        const double height = tinker_top_height(&top, centre);
        if (!is_below(&top, centre) || !(height < least)) continue;
        least = height;
        found = plate;
    }
    return found;
}

void advice_on_passing(GPtrArray *all, const TinkerFrame *frame)
{
    TinkerScene *scene = tinker_frame_scene(frame);
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        const TinkerBlockId body = tinker_scene_block_at(scene, i);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, body);
        if (block_class == NULL || !tinker_block_class_turns(block_class) ||
            tinker_frame_meaning(frame, body, TINKER_MEANING_SOLID, 0, 1) != 0)
            continue;
        const TinkerBlockId plate = passed_top(frame, body);
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
