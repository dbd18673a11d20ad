/* Where an end is. */
#include "scene/store/scene-data.h"

/* The value of the column with this meaning (and the one behind it), or 0. */
static double meaning_value(const SceneTable *table, int32_t row, int32_t meaning, int32_t offset)
{
    int32_t column = tinker_block_class_meaning_column(table->block_class, meaning);
    return column < 0 ? 0 : table->columns[column + offset][row];
}

void scene_end_place(const TinkerScene *scene, TinkerSceneEnd end, double place[2])
{
    place[0] = end.x;
    place[1] = end.y;
    const SceneTable *table = end.block == TINKER_NO_BLOCK ? NULL : scene_table_of(scene, end.block);
    if (table == NULL) return;
    int32_t row = scene_slot(scene, end.block)->row;
    double angle = meaning_value(table, row, TINKER_MEANING_ORIENTATION, 0);
    place[0] = meaning_value(table, row, TINKER_MEANING_POSITION, 0) + cos(angle) * end.x - sin(angle) * end.y;
    place[1] = meaning_value(table, row, TINKER_MEANING_POSITION, 1) + sin(angle) * end.x + cos(angle) * end.y;
}

int32_t tinker_scene_end_count(const TinkerScene *scene, TinkerBlockId block)
{
    g_assert(tinker_scene_has_block(scene, block));
    const SceneTable *table = scene_table_of(scene, block);
    return table == NULL ? 0 : scene_table_end_count(table, scene_slot(scene, block)->row);
}

TinkerSceneEnd tinker_scene_end(const TinkerScene *scene, TinkerBlockId block, int32_t end)
{
    g_assert(end >= 0 && end < tinker_scene_end_count(scene, block));
    return scene_table_ends(scene_table_of(scene, block), scene_slot(scene, block)->row)[end];
}
