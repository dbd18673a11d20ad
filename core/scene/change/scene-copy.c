/* Copies of whole scenes. A copy has memory of its own; shared are only the catalogue, which guards itself, block
 * classes, which stay as they are as long as the process lives, and waveforms, which never change. So a copy may be
 * used in one thread while the original is edited in another. */
#include <string.h>

#include "scene/store/scene-data.h"

/* As many entries as the table grows by from nothing. */
#define LEAST_ROOM 8

/* A copy of the first `count` of `room` entries. */
static gpointer copy_array(gconstpointer from, gsize count, gsize room, gsize size)
{
    gpointer copy = g_malloc0_n(room, size);
    if (count > 0) memcpy(copy, from, count * size);
    return copy;
}

#define COPY_ARRAY(from, count, room) copy_array((from), (gsize)(count), (gsize)(room), sizeof *(from))

static void copy_property(const SceneTable *from, SceneTable *copy, int32_t property)
{
    copy->given[property] = COPY_ARRAY(from->given[property], from->count, copy->room);
    if (from->default_waveforms[property] != NULL) tinker_waveform_ref(copy->default_waveforms[property]);
    if (from->texts[property] != NULL) {
        copy->texts[property] = g_new0(char *, (gsize)copy->room);
        for (int32_t row = 0; row < from->count; row++)
            copy->texts[property][row] = g_strdup(from->texts[property][row]);
    }
    if (from->waveforms[property] != NULL) {
        copy->waveforms[property] = COPY_ARRAY(from->waveforms[property], from->count, copy->room);
        for (int32_t row = 0; row < from->count; row++)
            if (copy->waveforms[property][row] != NULL) tinker_waveform_ref(copy->waveforms[property][row]);
    }
}

static SceneTable *copy_table(const SceneTable *from)
{
    const TinkerBlockClass *block_class = from->block_class;
    int32_t ends = from->end_offsets[from->count];
    SceneTable *copy = g_new(SceneTable, 1);
    *copy = *from;
    copy->room = MAX(from->count, LEAST_ROOM);
    copy->end_room = ends;
    copy->ids = COPY_ARRAY(from->ids, from->count, copy->room);
    copy->end_offsets = COPY_ARRAY(from->end_offsets, from->count + 1, copy->room + 1);
    copy->ends = ends == 0 ? NULL : COPY_ARRAY(from->ends, ends, ends);
    copy->columns = g_new0(double *, (gsize)block_class->column_count + 1);
    for (int32_t c = 0; c < block_class->column_count; c++)
        copy->columns[c] = COPY_ARRAY(from->columns[c], from->count, copy->room);

    gsize properties = (gsize)block_class->property_count + 1;
    copy->given = g_new0(guint8 *, properties);
    copy->texts = g_new0(char **, properties);
    copy->waveforms = g_new0(TinkerWaveform **, properties);
    copy->default_waveforms = COPY_ARRAY(from->default_waveforms, properties, properties);
    for (int32_t p = 0; p < block_class->property_count; p++)
        copy_property(from, copy, p);
    return copy;
}

static void copy_tables(const TinkerScene *from, TinkerScene *copy)
{
    for (guint i = 0; i < from->tables->len; i++) {
        SceneTable *table = copy_table(g_ptr_array_index(from->tables, i));
        g_ptr_array_add(copy->tables, table);
        g_hash_table_insert(copy->table_of, (gpointer)table->block_class, table);
    }
}

static void copy_names(const TinkerScene *from, TinkerScene *copy)
{
    for (guint id = 0; id < from->slots->len; id++) {
        SceneSlot slot = *scene_slot(from, (TinkerBlockId)id);
        if (slot.name != NULL) {
            slot.name = g_string_chunk_insert(copy->names, slot.name);
            if (tinker_scene_find_block(from, slot.name) == (TinkerBlockId)id)
                g_hash_table_insert(copy->by_name, (gpointer)slot.name, GINT_TO_POINTER((int)id + 1));
        }
        g_array_append_val(copy->slots, slot);
    }
    GHashTableIter iter;
    gpointer title, number;
    g_hash_table_iter_init(&iter, from->next_number);
    while (g_hash_table_iter_next(&iter, &title, &number))
        g_hash_table_insert(copy->next_number, g_strdup(title), number);
}

static void copy_side_tables(const TinkerScene *from, TinkerScene *copy)
{
    GHashTableIter iter;
    gpointer key, value;
    g_hash_table_iter_init(&iter, from->placeholders);
    while (g_hash_table_iter_next(&iter, &key, &value))
        g_hash_table_insert(copy->placeholders, key, scene_placeholder_copy(value));
    g_hash_table_iter_init(&iter, from->extras);
    while (g_hash_table_iter_next(&iter, &key, &value))
        g_hash_table_insert(copy->extras, key, g_strdup(value));
    g_hash_table_iter_init(&iter, from->places_on);
    while (g_hash_table_iter_next(&iter, &key, &value))
        scene_set_place_on(copy, GPOINTER_TO_INT(key), value);
    g_hash_table_iter_init(&iter, from->end_extras);
    while (g_hash_table_iter_next(&iter, &key, &value))
        g_hash_table_insert(copy->end_extras, g_memdup2(key, sizeof(gint64)), g_strdup(value));
    g_hash_table_iter_init(&iter, from->sources);
    while (g_hash_table_iter_next(&iter, &key, &value))
        g_hash_table_insert(copy->sources, tinker_waveform_ref(key), g_strdup(value));
}

TinkerScene *tinker_scene_copy(const TinkerScene *scene)
{
    TinkerScene *copy = tinker_scene_new(scene->catalogue);
    TinkerSceneHead *head = scene_head_copy(&scene->head);
    scene_head_clear(&copy->head);
    copy->head = *head;
    g_free(head); /* its texts are the copy's now */
    for (guint i = 0; i < scene->graphs->len; i++)
        g_ptr_array_add(copy->graphs, tinker_scene_graph_copy(g_ptr_array_index(scene->graphs, i)));
    g_ptr_array_unref(copy->instruments);
    copy->instruments = scene_instruments_copy(scene->instruments);
    if (scene->order->len > 0) g_array_append_vals(copy->order, scene->order->data, scene->order->len);
    copy_tables(scene, copy);
    copy_names(scene, copy);
    copy_side_tables(scene, copy);
    copy->head_extras = g_strdup(scene->head_extras);
    copy->canvas_extras = g_strdup(scene->canvas_extras);
    copy->run_extras = g_strdup(scene->run_extras);
    return copy;
}
