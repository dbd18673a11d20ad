/* Snapshots: one block with its values, ends and name, for undo. */
#include <string.h>

#include "scene/store/scene-data.h"

struct _SceneSnapshot {
    TinkerBlockId id;
    char *name;
    int32_t table; /* number, or SCENE_PLACEHOLDER: the values that follow are then empty */
    int32_t column_count, property_count, end_count;
    double *columns;
    guint8 *given;
    char **texts;
    TinkerWaveform **waveforms;
    TinkerSceneEnd *ends;
    gboolean lies;
    ScenePlaceOn on;   /* where it lies */
    char *placeholder; /* the text of one; else NULL */
};

static void take_row(SceneSnapshot *snapshot, const SceneTable *table, int32_t row)
{
    snapshot->column_count = table->block_class->column_count;
    snapshot->property_count = table->block_class->property_count;
    snapshot->end_count = scene_table_end_count(table, row);
    snapshot->columns = g_new(double, (gsize)snapshot->column_count + 1);
    snapshot->given = g_new(guint8, (gsize)snapshot->property_count + 1);
    snapshot->texts = g_new0(char *, (gsize)snapshot->property_count + 1);
    snapshot->waveforms = g_new0(TinkerWaveform *, (gsize)snapshot->property_count + 1);
    snapshot->ends = g_new(TinkerSceneEnd, (gsize)snapshot->end_count + 1);
    for (int32_t c = 0; c < snapshot->column_count; c++)
        snapshot->columns[c] = table->columns[c][row];
    for (int32_t p = 0; p < snapshot->property_count; p++) {
        snapshot->given[p] = table->given[p][row];
        if (table->texts[p] != NULL) snapshot->texts[p] = g_strdup(table->texts[p][row]);
        if (table->waveforms[p] != NULL && table->waveforms[p][row] != NULL)
            snapshot->waveforms[p] = tinker_waveform_ref(table->waveforms[p][row]);
    }
    for (int32_t end = 0; end < snapshot->end_count; end++)
        snapshot->ends[end] = scene_table_ends(table, row)[end];
}

static void restore_row(const SceneSnapshot *snapshot, SceneTable *table, int32_t row)
{
    for (int32_t c = 0; c < snapshot->column_count; c++)
        table->columns[c][row] = snapshot->columns[c];
    for (int32_t p = 0; p < snapshot->property_count; p++) {
        if (table->texts[p] != NULL) scene_store_text(table, row, p, snapshot->texts[p]);
        if (table->waveforms[p] != NULL) scene_store_waveform(table, row, p, snapshot->waveforms[p]);
        table->given[p][row] = snapshot->given[p];
    }
    for (int32_t end = 0; end < snapshot->end_count; end++)
        scene_table_ends(table, row)[end] = snapshot->ends[end];
}

SceneSnapshot *scene_snapshot_take(const TinkerScene *scene, TinkerBlockId block)
{
    SceneSnapshot *snapshot = g_new0(SceneSnapshot, 1);
    const SceneSlot *slot = scene_slot(scene, block);
    snapshot->id = block;
    snapshot->name = g_strdup(slot->name);
    snapshot->table = slot->table;
    const SceneTable *table = scene_table_of(scene, block);
    if (table != NULL) take_row(snapshot, table, slot->row);
    const ScenePlaceholder *placeholder = g_hash_table_lookup(scene->placeholders, GINT_TO_POINTER(block));
    if (placeholder != NULL) snapshot->placeholder = g_strdup(placeholder->text);
    const ScenePlaceOn *on = scene_place_on(scene, block);
    snapshot->lies = on != NULL;
    if (on != NULL) snapshot->on = *on;
    return snapshot;
}

void scene_snapshot_free(SceneSnapshot *snapshot)
{
    if (snapshot == NULL) return;
    for (int32_t p = 0; p < snapshot->property_count; p++) {
        g_free(snapshot->texts[p]);
        g_clear_pointer(&snapshot->waveforms[p], tinker_waveform_unref);
    }
    g_free(snapshot->name);
    g_free(snapshot->placeholder);
    g_free(snapshot->columns);
    g_free(snapshot->given);
    g_free(snapshot->texts);
    g_free(snapshot->waveforms);
    g_free(snapshot->ends);
    g_free(snapshot);
}

TinkerBlockId scene_snapshot_block(const SceneSnapshot *snapshot)
{
    return snapshot->id;
}

int32_t scene_snapshot_table(const SceneSnapshot *snapshot)
{
    return snapshot->table;
}

int32_t scene_snapshot_end_count(const SceneSnapshot *snapshot)
{
    return snapshot->end_count;
}

gboolean scene_snapshot_renames(const SceneSnapshot *before, const SceneSnapshot *after)
{
    return g_strcmp0(before->name, after->name) != 0;
}

void scene_snapshot_restore(TinkerScene *scene, const SceneSnapshot *snapshot)
{
    if (g_strcmp0(scene_slot(scene, snapshot->id)->name, snapshot->name) != 0)
        scene_assign_name(scene, snapshot->id, snapshot->name);
    SceneTable *table = scene_table_of(scene, snapshot->id);
    if (table != NULL) restore_row(snapshot, table, scene_slot(scene, snapshot->id)->row);
    ScenePlaceholder *placeholder = g_hash_table_lookup(scene->placeholders, GINT_TO_POINTER(snapshot->id));
    if (placeholder != NULL) {
        g_free(placeholder->text);
        placeholder->text = g_strdup(snapshot->placeholder);
    }
    scene_set_place_on(scene, snapshot->id, snapshot->lies ? &snapshot->on : NULL);
}

void scene_copy_row(const TinkerScene *from, TinkerBlockId block, TinkerScene *to, TinkerBlockId copy)
{
    SceneSnapshot *snapshot = scene_snapshot_take(from, block);
    restore_row(snapshot, scene_table_of(to, copy), scene_slot(to, copy)->row);
    scene_snapshot_free(snapshot);
}
