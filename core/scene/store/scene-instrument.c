/* Instruments of a scene, controls and meters: which blocks they are of, and how they follow a name. */
#include <string.h>

#include "scene/store/quantities.h"
#include "scene/store/scene-data.h"

const char *const scene_instrument_kinds[] = {"slider", "knob", "switch", "number", "dial", "bar", NULL};

TinkerSceneInstrument *tinker_scene_instrument_new(TinkerInstrumentKind kind, const char *block, const char *of)
{
    TinkerSceneInstrument *instrument = g_new0(TinkerSceneInstrument, 1);
    instrument->kind = kind;
    instrument->block = g_strdup(block);
    instrument->of = g_strdup(of);
    instrument->to = 1;
    return instrument;
}

TinkerSceneInstrument *tinker_scene_instrument_copy(const TinkerSceneInstrument *instrument)
{
    TinkerSceneInstrument *copy = g_new(TinkerSceneInstrument, 1);
    *copy = *instrument;
    copy->block = g_strdup(instrument->block);
    copy->of = g_strdup(instrument->of);
    copy->extras = g_strdup(instrument->extras);
    return copy;
}

void tinker_scene_instrument_free(TinkerSceneInstrument *instrument)
{
    g_free(instrument->block);
    g_free(instrument->of);
    g_free(instrument->extras);
    g_free(instrument);
}

GPtrArray *tinker_scene_instruments(TinkerScene *scene)
{
    return scene->instruments;
}

GPtrArray *scene_instruments_copy(const GPtrArray *instruments)
{
    GPtrArray *copy = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_scene_instrument_free);
    for (guint i = 0; i < instruments->len; i++)
        g_ptr_array_add(copy, tinker_scene_instrument_copy(g_ptr_array_index(instruments, i)));
    return copy;
}

static gboolean names_one_of(const TinkerScene *scene, GHashTable *blocks, const char *name)
{
    const TinkerBlockId block = name != NULL ? tinker_scene_find_block(scene, name) : TINKER_NO_BLOCK;
    return block != TINKER_NO_BLOCK && g_hash_table_contains(blocks, GINT_TO_POINTER(block));
}

gboolean scene_instrument_is_of(const TinkerScene *scene, const TinkerSceneInstrument *instrument, GHashTable *blocks)
{
    return names_one_of(scene, blocks, instrument->block) ||
           names_one_of(scene, blocks, tinker_quantity_other_name(instrument->of));
}

void scene_instrument_rename(TinkerSceneInstrument *instrument, const char *from, const char *to)
{
    char *of = tinker_quantity_renamed(instrument->of, from, to);
    if (of != NULL) {
        g_free(instrument->of);
        instrument->of = of;
    }
    if (strcmp(instrument->block, from) != 0) return;
    g_free(instrument->block);
    instrument->block = g_strdup(to);
}

gboolean tinker_scene_find_number(const TinkerScene *scene, TinkerBlockId block, const char *name, TinkerNumber *number)
{
    const TinkerBlockClass *block_class = block == TINKER_NO_BLOCK ? NULL : tinker_scene_block_class(scene, block);
    for (int32_t p = 0; block_class != NULL && p < block_class->property_count; p++) {
        const TinkerPropertyType *property = &block_class->properties[p];
        const gboolean vector = property->kind == TINKER_KIND_VECTOR;
        if (property->kind != TINKER_KIND_REAL && property->kind != TINKER_KIND_INTEGER &&
            property->kind != TINKER_KIND_SWITCH && !vector)
            continue;
        if (!g_str_has_prefix(name, property->id)) continue;
        const char *rest = name + strlen(property->id);
        if (vector ? strcmp(rest, ".x") != 0 && strcmp(rest, ".y") != 0 : rest[0] != '\0') continue;
        const int component = vector && rest[1] == 'y';
        *number = (TinkerNumber){p, component, block_class->first_columns[p] + component, property};
        return TRUE;
    }
    return FALSE;
}
