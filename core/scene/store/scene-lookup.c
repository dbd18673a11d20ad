/* What is in a scene: blocks by place, id and name. */
#include "scene/store/scene-data.h"

GQuark tinker_scene_error_quark(void)
{
    return g_quark_from_static_string("tinker-scene-error-quark");
}

TinkerCatalogue *tinker_scene_catalogue(const TinkerScene *scene)
{
    return scene->catalogue;
}

TinkerSceneHead *tinker_scene_head(TinkerScene *scene)
{
    return &scene->head;
}

GPtrArray *tinker_scene_graphs(TinkerScene *scene)
{
    return scene->graphs;
}

int32_t tinker_scene_block_count(const TinkerScene *scene)
{
    return (int32_t)scene->order->len;
}

TinkerBlockId tinker_scene_block_at(const TinkerScene *scene, int32_t place)
{
    g_assert(place >= 0 && place < (int32_t)scene->order->len);
    return g_array_index(scene->order, TinkerBlockId, place);
}

int32_t tinker_scene_id_limit(const TinkerScene *scene)
{
    return (int32_t)scene->slots->len;
}

gboolean tinker_scene_has_block(const TinkerScene *scene, TinkerBlockId block)
{
    return block >= 0 && block < (TinkerBlockId)scene->slots->len && scene_slot(scene, block)->table != SCENE_REMOVED;
}

TinkerBlockId tinker_scene_find_block(const TinkerScene *scene, const char *name)
{
    return GPOINTER_TO_INT(g_hash_table_lookup(scene->by_name, name)) - 1;
}

const char *tinker_scene_block_name(const TinkerScene *scene, TinkerBlockId block)
{
    g_assert(tinker_scene_has_block(scene, block));
    return scene_slot(scene, block)->name;
}

const TinkerBlockClass *tinker_scene_block_class(const TinkerScene *scene, TinkerBlockId block)
{
    g_assert(tinker_scene_has_block(scene, block));
    const SceneTable *table = scene_table_of(scene, block);
    return table == NULL ? NULL : table->block_class;
}

const char *tinker_scene_block_type(const TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (block_class != NULL) return block_class->type->id;
    const ScenePlaceholder *placeholder = g_hash_table_lookup(scene->placeholders, GINT_TO_POINTER(block));
    return placeholder->type;
}

const char *tinker_scene_get_text(const TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    g_assert(tinker_scene_has_block(scene, block));
    const SceneTable *table = scene_table_of(scene, block);
    g_assert(table != NULL && property >= 0 && property < table->block_class->property_count &&
             table->texts[property] != NULL);
    const char *text = table->texts[property][scene_slot(scene, block)->row];
    if (text == NULL) text = table->block_class->properties[property].default_text;
    return text == NULL ? "" : text;
}

const char *tinker_scene_text_of(int32_t property, void *texts)
{
    const TinkerSceneTexts *of = texts;
    return tinker_scene_get_text(of->scene, of->block, property);
}

int32_t scene_order_of(const TinkerScene *scene, TinkerBlockId block)
{
    guint place = 0;
    while (g_array_index(scene->order, TinkerBlockId, place) != block)
        place++;
    return (int32_t)place;
}

TinkerWaveform *tinker_scene_get_waveform(const TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    g_assert(tinker_scene_has_block(scene, block));
    const SceneTable *table = scene_table_of(scene, block);
    g_assert(table != NULL && property >= 0 && property < table->block_class->property_count);
    g_assert(table->waveforms[property] != NULL);
    TinkerWaveform *waveform = table->waveforms[property][scene_slot(scene, block)->row];
    return waveform != NULL ? waveform : table->default_waveforms[property];
}
