#include "cli/report/scene-json.h"

void tinker_json_add_name(cJSON *list, TinkerScene *scene, TinkerBlockId block)
{
    cJSON_AddItemToArray(list, cJSON_CreateString(tinker_scene_block_name(scene, block)));
}

void tinker_json_add_names(cJSON *object, TinkerScene *scene, const GArray *blocks)
{
    cJSON *list = cJSON_AddArrayToObject(object, "blocks");
    for (guint i = 0; i < blocks->len; i++)
        tinker_json_add_name(list, scene, g_array_index(blocks, TinkerBlockId, i));
}

void tinker_json_add_cancelled(cJSON *list, TinkerScene *scene, TinkerBlockId block)
{
    cJSON *object = cJSON_CreateObject();
    cJSON_AddStringToObject(object, "block", tinker_scene_block_name(scene, block));
    cJSON *on = cJSON_AddArrayToObject(object, "on");
    for (int32_t k = 0; k < tinker_scene_end_count(scene, block); k++)
        tinker_json_add_name(on, scene, tinker_scene_end(scene, block, k).block);
    cJSON_AddItemToArray(list, object);
}

void tinker_json_add_pair(cJSON *object, const char *key, const double pair[2])
{
    cJSON_AddItemToObject(object, key, cJSON_CreateDoubleArray(pair, 2));
}
