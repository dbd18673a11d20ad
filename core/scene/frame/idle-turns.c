/* What has an end on a support is not idle: that has an angle. Constraints between angles are looked at for two ends on
 * one body only, as a scene in which one of them has an end on a point is refused. */
#include "scene/frame/idle-turns.h"

#include <glib/gi18n-lib.h>

#include <tinker/physics.h>

static gboolean gives_torques_alone(const TinkerPhysics *physics)
{
    return physics->force_element != NULL && physics->force_element->angles && physics->force_element->torsion != NULL;
}

/* Rows that hold places, too, are those of a joint. */
static gboolean ties_angles_alone(const TinkerPhysics *physics)
{
    return physics->constraint != NULL && physics->constraint->turning != NULL && physics->constraint->joint == 0;
}

static gboolean is_point(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return block_class != NULL && block_class->physics != NULL && block_class->physics->body != NULL &&
           block_class->physics->body->degrees_of_freedom == 2;
}

/* How many of the ends before this one are on the same block. */
static int32_t count_before(TinkerScene *scene, TinkerBlockId block, int32_t end)
{
    int32_t count = 0;
    for (int32_t k = 0; k < end; k++)
        count += tinker_scene_end(scene, block, k).block == tinker_scene_end(scene, block, end).block;
    return count;
}

static void add_idle_turns(GArray *idle_turns, TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class == NULL || block_class->physics == NULL) return;
    const gboolean is_force = gives_torques_alone(block_class->physics);
    if (!is_force && !ties_angles_alone(block_class->physics)) return;
    for (int32_t k = 0; k < tinker_scene_end_count(scene, block); k++) {
        const TinkerBlockId on = tinker_scene_end(scene, block, k).block;
        if (on == TINKER_NO_BLOCK) continue;
        const int32_t before = count_before(scene, block, k);
        const gboolean is_idle = is_point(scene, on) ? is_force && before == 0 : before == 1;
        if (is_idle) g_array_append_val(idle_turns, ((TinkerIdleTurn){block, on, before == 1}));
    }
}

GArray *tinker_idle_turns_of(TinkerScene *scene)
{
    GArray *idle_turns = g_array_new(FALSE, FALSE, sizeof(TinkerIdleTurn));
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++)
        add_idle_turns(idle_turns, scene, tinker_scene_block_at(scene, i));
    return idle_turns;
}

char *tinker_idle_turn_text(TinkerScene *scene, const TinkerIdleTurn *idle)
{
    const char *by = tinker_scene_block_name(scene, idle->by), *body = tinker_scene_block_name(scene, idle->body);
    return g_strdup_printf(idle->is_twice ? _("%s: two of its ends are on %s, which does not turn against itself "
                                              "(attach one of them to another block)")
                                          : _("%s: it acts on angles alone, and %s is a point, which has none: it does "
                                              "nothing there (attach it to a disc, a bar, a box or a support)"),
                           by, body);
}
