/* Snapshots: one block with its values, ends, name, place in the drawing order and graphs, for undo. */
#include <string.h>

#include "scene/scene-private.h"

typedef struct {
    guint place; /* in the scene's list */
    TinkerSceneGraph *graph;
} SnapshotGraph;

struct _SceneSnapshot {
    TinkerBlockId id;
    char *name;
    int32_t order; /* place in the drawing order */
    int32_t table; /* number, or SCENE_PLACEHOLDER: the values that follow are then empty */
    int32_t column_count, property_count, end_count;
    double *columns;
    guint8 *given;
    char **texts;
    TinkerWaveform **waveforms;
    TinkerSceneEnd *ends;
    char *placeholder; /* the text of one; else NULL */
    GArray *graphs;    /* of SnapshotGraph, last first */
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

/* The first row whose id is not below this one. */
static int32_t row_for(const SceneTable *table, TinkerBlockId id)
{
    int32_t low = 0, high = table->count;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (table->ids[middle] < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* A removed block takes up its slot, its row and its place again. */
static void bring_back(TinkerScene *scene, const SceneSnapshot *snapshot)
{
    guint place = MIN((guint)snapshot->order, scene->order->len);
    g_array_insert_val(scene->order, place, snapshot->id);
    if (snapshot->table == SCENE_PLACEHOLDER) {
        scene_slot(scene, snapshot->id)->table = SCENE_PLACEHOLDER;
    } else {
        SceneTable *table = g_ptr_array_index(scene->tables, snapshot->table);
        scene_table_insert(scene, table, row_for(table, snapshot->id), snapshot->id, snapshot->end_count);
    }
    for (guint i = snapshot->graphs->len; i-- > 0;) {
        const SnapshotGraph *graph = &g_array_index(snapshot->graphs, SnapshotGraph, i);
        g_ptr_array_insert(scene->graphs, (int)MIN(graph->place, scene->graphs->len), scene_graph_copy(graph->graph));
    }
}

SceneSnapshot *scene_snapshot_take(const TinkerScene *scene, TinkerBlockId block)
{
    SceneSnapshot *snapshot = g_new0(SceneSnapshot, 1);
    const SceneSlot *slot = scene_slot(scene, block);
    snapshot->id = block;
    snapshot->name = g_strdup(slot->name);
    snapshot->order = scene_order_of(scene, block);
    snapshot->table = slot->table;
    const SceneTable *table = scene_table_of(scene, block);
    if (table != NULL) take_row(snapshot, table, slot->row);
    const ScenePlaceholder *placeholder = g_hash_table_lookup(scene->placeholders, GINT_TO_POINTER(block));
    if (placeholder != NULL) snapshot->placeholder = g_strdup(placeholder->text);

    snapshot->graphs = g_array_new(FALSE, FALSE, sizeof(SnapshotGraph));
    g_autoptr(GArray) places = scene_graphs_of(scene, block);
    for (guint i = 0; i < places->len; i++) {
        guint place = g_array_index(places, guint, i);
        SnapshotGraph graph = {place, scene_graph_copy(g_ptr_array_index(scene->graphs, place))};
        g_array_append_val(snapshot->graphs, graph);
    }
    return snapshot;
}

void scene_snapshot_free(SceneSnapshot *snapshot)
{
    if (snapshot == NULL) return;
    for (int32_t p = 0; p < snapshot->property_count; p++) {
        g_free(snapshot->texts[p]);
        g_clear_pointer(&snapshot->waveforms[p], tinker_waveform_unref);
    }
    for (guint i = 0; i < snapshot->graphs->len; i++)
        scene_graph_free(g_array_index(snapshot->graphs, SnapshotGraph, i).graph);
    g_array_unref(snapshot->graphs);
    g_free(snapshot->name);
    g_free(snapshot->placeholder);
    g_free(snapshot->columns);
    g_free(snapshot->given);
    g_free(snapshot->texts);
    g_free(snapshot->waveforms);
    g_free(snapshot->ends);
    g_free(snapshot);
}

gboolean scene_snapshot_renames(const SceneSnapshot *before, const SceneSnapshot *after)
{
    return g_strcmp0(before->name, after->name) != 0;
}

void scene_snapshot_restore(TinkerScene *scene, const SceneSnapshot *snapshot)
{
    if (!tinker_scene_has_block(scene, snapshot->id)) bring_back(scene, snapshot);
    if (g_strcmp0(scene_slot(scene, snapshot->id)->name, snapshot->name) != 0)
        scene_assign_name(scene, snapshot->id, snapshot->name);
    SceneTable *table = scene_table_of(scene, snapshot->id);
    if (table != NULL) restore_row(snapshot, table, scene_slot(scene, snapshot->id)->row);
    ScenePlaceholder *placeholder = g_hash_table_lookup(scene->placeholders, GINT_TO_POINTER(snapshot->id));
    if (placeholder != NULL) {
        g_free(placeholder->text);
        placeholder->text = g_strdup(snapshot->placeholder);
    }
}

void scene_copy_row(const TinkerScene *from, TinkerBlockId block, TinkerScene *to, TinkerBlockId copy)
{
    SceneSnapshot *snapshot = scene_snapshot_take(from, block);
    restore_row(snapshot, scene_table_of(to, copy), scene_slot(to, copy)->row);
    scene_snapshot_free(snapshot);
}
