/* Any place on the block but its centre is passed over: an eye on its rim is meant as such. */
#include "scene/frame/small-wheels.h"

#include <glib/gi18n-lib.h>
#include <math.h>

#include <tinker/physics.h>

#define CENTRE 1e-9 /* m: an attachment this near to the centre is at it */

static gboolean goes_over(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return block_class != NULL && block_class->physics != NULL && block_class->physics->constraint != NULL &&
           block_class->physics->constraint->unilateral != 0;
}

static void add_wheels(GArray *wheels, TinkerScene *scene, TinkerBlockId block)
{
    const int32_t last = goes_over(scene, block) ? tinker_scene_end_count(scene, block) - 1 : 0;
    for (int32_t k = 1; k < last; k++) {
        const TinkerSceneEnd end = tinker_scene_end(scene, block, k);
        const TinkerBlockClass *on = end.block != TINKER_NO_BLOCK ? tinker_scene_block_class(scene, end.block) : NULL;
        if (!tinker_block_class_turns(on) || !(hypot(end.x, end.y) <= CENTRE)) continue;
        const TinkerSmallWheel wheel = {block, end.block, on->meanings[TINKER_MEANING_RADIUS] >= 0};
        g_array_append_val(wheels, wheel);
    }
}

GArray *tinker_small_wheels_of(TinkerScene *scene)
{
    GArray *wheels = g_array_new(FALSE, FALSE, sizeof(TinkerSmallWheel));
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++)
        add_wheels(wheels, scene, tinker_scene_block_at(scene, i));
    return wheels;
}

char *tinker_small_wheel_text(TinkerScene *scene, const TinkerSmallWheel *wheel)
{
    return g_strdup_printf(_("%s: it goes over a small wheel at the centre of %s: it neither runs round its rim nor "
                             "turns it (for that, wind a cord on it on either side)"),
                           tinker_scene_block_name(scene, wheel->over), tinker_scene_block_name(scene, wheel->body));
}
