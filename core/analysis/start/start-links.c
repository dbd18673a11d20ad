/* What hangs together: links of one block, and sets of bodies that ties make. */
#include "analysis/start/start-private.h"

#include "numerics/solve/disjoint-sets.h"

gboolean start_can_move(const TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return tinker_block_class_moves(block_class) && block_class->meanings[TINKER_MEANING_POSITION] >= 0 &&
           block_class->meanings[TINKER_MEANING_VELOCITY] >= 0;
}

static gboolean has_length(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->physics != NULL && block_class->type->least_ends == 2 &&
           block_class->type->most_ends == 2 && block_class->meanings[TINKER_MEANING_LENGTH] >= 0;
}

gboolean start_has_rest_length(const TinkerBlockClass *block_class)
{
    return has_length(block_class) && block_class->physics->line_law != NULL;
}

gboolean start_keeps_length(const TinkerBlockClass *block_class)
{
    return has_length(block_class) && block_class->physics->constraint != NULL &&
           !tinker_block_class_is_wound(block_class);
}

gboolean start_is_rigid(const TinkerBlockClass *block_class)
{
    return block_class != NULL && block_class->physics != NULL && block_class->physics->constraint != NULL &&
           !block_class->physics->constraint->unilateral;
}

gboolean start_is_joint(const TinkerBlockClass *block_class)
{
    return start_is_rigid(block_class) && block_class->physics->constraint->joint != 0 &&
           block_class->type->least_ends == 2 && block_class->type->most_ends == 2;
}

gboolean start_set_meaning(TinkerHistory *history, TinkerScene *scene, TinkerBlockId block, int32_t meaning,
                           const double *values, GError **error)
{
    int32_t property = tinker_scene_block_class(scene, block)->meanings[meaning];
    return property < 0 || tinker_history_set(history, block, property, values, error);
}

GArray *start_links_new(const TinkerScene *scene, TinkerBlockId block)
{
    GArray *links = g_array_new(FALSE, FALSE, sizeof(StartLink));
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId connector = tinker_scene_block_at(scene, i);
        if (tinker_scene_block_class(scene, connector) == NULL || tinker_scene_end_count(scene, connector) != 2)
            continue;
        TinkerSceneEnd first = tinker_scene_end(scene, connector, 0), second = tinker_scene_end(scene, connector, 1);
        if (first.block == TINKER_NO_BLOCK || second.block == TINKER_NO_BLOCK || first.block == second.block) continue;
        StartLink link = {connector, first, second};
        if (second.block == block) link = (StartLink){connector, second, first};
        if (link.own.block == block) g_array_append_val(links, link);
    }
    return links;
}

/* Sets ------------------------------------------------------------------------------------------------------------- */

static gboolean ties_bodies(const TinkerBlockClass *block_class, StartTies ties)
{
    const TinkerPhysics *physics = block_class->physics;
    if (physics == NULL || physics->motion != NULL) return FALSE;
    if (ties == START_TIED_RIGIDLY) return start_is_rigid(block_class);
    return ties == START_TIED_BY_ANYTHING || physics->constraint != NULL;
}

static void join_ends(const TinkerScene *scene, const TinkerSceneTable *table, int32_t row, int32_t *parent)
{
    TinkerBlockId first = TINKER_NO_BLOCK;
    for (int32_t e = table->end_offsets[row]; e < table->end_offsets[row + 1]; e++) {
        TinkerBlockId block = table->ends[e].block;
        if (block == TINKER_NO_BLOCK || !start_can_move(scene, block)) continue;
        if (first != TINKER_NO_BLOCK) tinker_sets_join(parent, first, block);
        first = block;
    }
}

static void join_all(const TinkerScene *scene, int32_t *parent)
{
    TinkerBlockId first = TINKER_NO_BLOCK;
    for (int32_t i = 0; i < tinker_scene_block_count(scene); i++) {
        TinkerBlockId block = tinker_scene_block_at(scene, i);
        if (!start_can_move(scene, block)) continue;
        if (first != TINKER_NO_BLOCK) tinker_sets_join(parent, first, block);
        first = block;
    }
}

int32_t *start_sets_new(TinkerScene *scene, StartTies ties, TinkerBlockId without)
{
    int32_t limit = MAX(tinker_scene_id_limit(scene), 1);
    int32_t *parent = g_new(int32_t, limit);
    tinker_sets_begin(parent, limit);
    for (int32_t t = 0; t < tinker_scene_table_count(scene); t++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, t, &table);
        const TinkerPhysics *physics = table.block_class->physics;
        if (table.count == 0 || !ties_bodies(table.block_class, ties)) continue;
        if (physics->field != NULL && physics->field->couples_bodies) join_all(scene, parent);
        for (int32_t row = 0; row < table.count; row++)
            if (table.ids[row] != without) join_ends(scene, &table, row, parent);
    }
    for (int32_t id = 0; id < limit; id++)
        parent[id] = tinker_sets_first(parent, id);
    return parent;
}

/* Whether an end of what ties a group is on something that cannot move. */
static gboolean is_anchored(TinkerScene *scene, const gboolean *group, StartTies ties, TinkerBlockId without)
{
    for (int32_t t = 0; t < tinker_scene_table_count(scene); t++) {
        TinkerSceneTable table;
        tinker_scene_table(scene, t, &table);
        if (!ties_bodies(table.block_class, ties)) continue;
        for (int32_t row = 0; row < table.count; row++) {
            gboolean inside = FALSE, outside = FALSE;
            for (int32_t e = table.end_offsets[row]; e < table.end_offsets[row + 1]; e++) {
                TinkerBlockId block = table.ends[e].block;
                if (block == TINKER_NO_BLOCK) continue;
                inside |= group[block];
                outside |= !group[block];
            }
            if (inside && outside && table.ids[row] != without) return TRUE;
        }
    }
    return FALSE;
}

gboolean *start_group_new(TinkerScene *scene, TinkerBlockId body, StartTies ties, TinkerBlockId without,
                          gboolean *anchored)
{
    int32_t limit = MAX(tinker_scene_id_limit(scene), 1);
    gboolean *group = g_new0(gboolean, limit);
    g_autofree int32_t *sets = start_sets_new(scene, ties, without);
    for (TinkerBlockId id = 0; id < limit; id++)
        group[id] = tinker_scene_has_block(scene, id) && sets[id] == sets[body] && start_can_move(scene, id);
    if (anchored != NULL) *anchored = is_anchored(scene, group, ties, without);
    return group;
}
