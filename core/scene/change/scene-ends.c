/* Ends: what they are attached to, and what they may be attached to. */
#include <math.h>

#include "scene/store/scene-data.h"

gint64 *scene_end_key(TinkerBlockId block, int32_t end)
{
    gint64 *key = g_new(gint64, 1);
    *key = ((gint64)block << 32) | end;
    return key;
}

/* What an end of this type may not be on, in words, or NULL. */
static char *target_fault(const TinkerScene *scene, const TinkerBlockType *type, int32_t end, TinkerSceneEnd to)
{
    const TinkerBlockClass *target = tinker_scene_block_class(scene, to.block);
    const char *name = tinker_scene_block_name(scene, to.block);
    if (target == NULL) return NULL; /* nobody knows what a placeholder is */
    if (target->physics == NULL || target->physics->body == NULL)
        return g_strdup_printf("end %d is on \"%s\", a %s, which nothing can be attached to", end + 1, name,
                               target->type->id);

    int32_t freedom = target->physics->body->degrees_of_freedom;
    if (freedom == 0 && !(type->end_accepts & TINKER_ACCEPTS_SUPPORT))
        return g_strdup_printf("end %d must be on a block that can move, \"%s\" is a %s, which cannot", end + 1, name,
                               target->type->id);
    if (freedom != 0 && !(type->end_accepts & TINKER_ACCEPTS_BODY))
        return g_strdup_printf("end %d must be on a support, \"%s\" is a %s, which can move", end + 1, name,
                               target->type->id);
    if (freedom == 2 && (to.x != 0 || to.y != 0)) {
        char x[64], y[64];
        tinker_number_to_text(to.x, x, sizeof x);
        tinker_number_to_text(to.y, y, sizeof y);
        return g_strdup_printf("end %d is at [%s, %s] of \"%s\", which is a point: only [0, 0] is possible", end + 1, x,
                               y, name);
    }
    return NULL;
}

/* What acts between two ends does nothing where both are one point. */
static char *same_place_fault(const TinkerScene *scene, TinkerBlockId block, int32_t end, TinkerSceneEnd to)
{
    const TinkerBlockType *type = tinker_scene_block_class(scene, block)->type;
    if (type->least_ends != 2 || type->most_ends != 2) return NULL;
    const TinkerSceneEnd other = tinker_scene_end(scene, block, 1 - end);
    if (other.block != to.block || other.x != to.x || other.y != to.y) return NULL;
    return g_strdup_printf("ends 1 and 2 are both on \"%s\": a %s acts between two places (attach one of them to "
                           "another block)",
                           tinker_scene_block_name(scene, to.block), type->id);
}

char *scene_end_fault(const TinkerScene *scene, TinkerBlockId block, int32_t end, TinkerSceneEnd to)
{
    if (!isfinite(to.x) || !isfinite(to.y)) return g_strdup_printf("end %d must be at a finite place", end + 1);
    if (to.block == TINKER_NO_BLOCK) return NULL;
    if (!tinker_scene_has_block(scene, to.block)) return g_strdup_printf("end %d is on a block that is gone", end + 1);
    if (to.block == block) return g_strdup_printf("end %d is on the block itself", end + 1);
    char *same = same_place_fault(scene, block, end, to);
    if (same != NULL) return same;
    return target_fault(scene, tinker_scene_block_class(scene, block)->type, end, to);
}

static gboolean is_on(const SceneTable *table, int32_t row, GHashTable *blocks)
{
    const TinkerSceneEnd *ends = scene_table_ends(table, row);
    for (int32_t end = 0; end < scene_table_end_count(table, row); end++)
        if (g_hash_table_contains(blocks, GINT_TO_POINTER(ends[end].block))) return TRUE;
    return FALSE;
}

GArray *scene_attached_to(const TinkerScene *scene, GHashTable *blocks)
{
    GArray *attached = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (guint t = 0; t < scene->tables->len; t++) {
        const SceneTable *table = g_ptr_array_index(scene->tables, t);
        for (int32_t row = 0; row < table->count; row++)
            if (is_on(table, row, blocks) && !g_hash_table_contains(blocks, GINT_TO_POINTER(table->ids[row])))
                g_array_append_val(attached, table->ids[row]);
    }
    return attached;
}

void scene_detach(TinkerScene *scene, GHashTable *blocks)
{
    g_autoptr(GArray) attached = scene_attached_to(scene, blocks);
    for (guint i = 0; i < attached->len; i++) {
        const TinkerBlockId other = g_array_index(attached, TinkerBlockId, i);
        const SceneTable *table = scene_table_of(scene, other);
        const int32_t row = scene_slot(scene, other)->row;
        TinkerSceneEnd *ends = scene_table_ends(table, row);
        for (int32_t end = 0; end < scene_table_end_count(table, row); end++) {
            if (!g_hash_table_contains(blocks, GINT_TO_POINTER(ends[end].block))) continue;
            double place[2];
            scene_end_place(scene, ends[end], place);
            ends[end] = (TinkerSceneEnd){TINKER_NO_BLOCK, place[0], place[1]};
        }
    }
    g_autoptr(GArray) lying = scene_placed_on(scene, blocks);
    for (guint i = 0; i < lying->len; i++)
        scene_fix_place(scene, g_array_index(lying, TinkerBlockId, i));
    scene_placeholders_detach(scene, blocks);
}

gboolean tinker_scene_set_end(TinkerScene *scene, TinkerBlockId block, int32_t end, TinkerSceneEnd to, GError **error)
{
    g_assert(end >= 0 && end < tinker_scene_end_count(scene, block));
    g_autofree char *fault = scene_end_fault(scene, block, end, to);
    if (fault != NULL) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_END, "%s: %s", tinker_scene_block_name(scene, block),
                    fault);
        return FALSE;
    }
    scene_table_ends(scene_table_of(scene, block), scene_slot(scene, block)->row)[end] = to;
    scene_settle_after(scene, block);
    return TRUE;
}
