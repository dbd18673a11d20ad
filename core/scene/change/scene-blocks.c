/* Several blocks that are taken out of a scene, or brought back, together. */
#include <string.h>

#include "scene/store/scene-data.h"

typedef struct {
    int32_t place; /* in the drawing order */
    TinkerBlockId id;
} Place;

typedef struct {
    guint place; /* in the scene's list */
    TinkerSceneGraph *graph;
    gboolean stays; /* with other curves */
} Graph;

struct _SceneBlocks {
    GPtrArray *snapshots;   /* of SceneSnapshot, by id */
    GArray *places;         /* of Place, the first to be drawn last */
    GArray *graphs;         /* of Graph, last first */
    GPtrArray *instruments; /* all of the scene, where some are of these blocks; else NULL */
};

GHashTable *scene_block_set(const TinkerBlockId *blocks, gsize count)
{
    GHashTable *set = g_hash_table_new(NULL, NULL);
    for (gsize i = 0; i < count; i++)
        g_hash_table_add(set, GINT_TO_POINTER(blocks[i]));
    return set;
}

/* Keeping ---------------------------------------------------------------------------------------------------------- */

static int by_id(const void *left, const void *right)
{
    const SceneSnapshot *const *l = left, *const *r = right;
    return scene_snapshot_block(*l) - scene_snapshot_block(*r);
}

/* From the end, where new blocks are. */
static void keep_places(SceneBlocks *kept, const TinkerScene *scene, GHashTable *set)
{
    const guint count = g_hash_table_size(set);
    for (guint place = scene->order->len; place-- > 0 && kept->places->len < count;) {
        Place at = {(int32_t)place, g_array_index(scene->order, TinkerBlockId, place)};
        if (g_hash_table_contains(set, GINT_TO_POINTER(at.id))) g_array_append_val(kept->places, at);
    }
}

static void keep_graphs(SceneBlocks *kept, const TinkerScene *scene, GHashTable *set)
{
    g_autoptr(GArray) places = scene_graphs_of(scene, set);
    for (guint i = 0; i < places->len; i++) {
        const guint place = g_array_index(places, guint, i);
        const TinkerSceneGraph *graph = g_ptr_array_index(scene->graphs, place);
        g_autoptr(TinkerSceneGraph) left = scene_graph_without(scene, graph, set);
        Graph entry = {place, tinker_scene_graph_copy(graph), left->curves->len > 0};
        g_array_append_val(kept->graphs, entry);
    }
}

static gboolean has_instruments(const TinkerScene *scene, GHashTable *set)
{
    for (guint i = 0; i < scene->instruments->len; i++)
        if (scene_instrument_is_of(scene, g_ptr_array_index(scene->instruments, i), set)) return TRUE;
    return FALSE;
}

SceneBlocks *scene_blocks_keep(const TinkerScene *scene, const TinkerBlockId *blocks, gsize count)
{
    SceneBlocks *kept = g_new0(SceneBlocks, 1);
    g_autoptr(GHashTable) set = scene_block_set(blocks, count);
    kept->snapshots = g_ptr_array_new_with_free_func((GDestroyNotify)scene_snapshot_free);
    kept->places = g_array_new(FALSE, FALSE, sizeof(Place));
    kept->graphs = g_array_new(FALSE, FALSE, sizeof(Graph));
    for (gsize i = 0; i < count; i++)
        g_ptr_array_add(kept->snapshots, scene_snapshot_take(scene, blocks[i]));
    g_ptr_array_sort(kept->snapshots, by_id);
    keep_places(kept, scene, set);
    keep_graphs(kept, scene, set);
    if (has_instruments(scene, set)) kept->instruments = scene_instruments_copy(scene->instruments);
    return kept;
}

void scene_blocks_free(SceneBlocks *blocks)
{
    for (guint i = 0; i < blocks->graphs->len; i++)
        tinker_scene_graph_free(g_array_index(blocks->graphs, Graph, i).graph);
    g_ptr_array_unref(blocks->snapshots);
    g_array_unref(blocks->places);
    g_array_unref(blocks->graphs);
    g_clear_pointer(&blocks->instruments, g_ptr_array_unref);
    g_free(blocks);
}

/* Taking out ------------------------------------------------------------------------------------------------------- */

static void leave_order(TinkerScene *scene, GHashTable *set)
{
    guint count = 0;
    for (guint place = 0; place < scene->order->len; place++) {
        const TinkerBlockId id = g_array_index(scene->order, TinkerBlockId, place);
        if (!g_hash_table_contains(set, GINT_TO_POINTER(id))) g_array_index(scene->order, TinkerBlockId, count++) = id;
    }
    g_array_set_size(scene->order, count);
}

static void take_out_curves(TinkerScene *scene, GHashTable *set)
{
    g_autoptr(GArray) places = scene_graphs_of(scene, set);
    for (guint i = 0; i < places->len; i++) {
        const guint place = g_array_index(places, guint, i);
        TinkerSceneGraph *graph = g_ptr_array_index(scene->graphs, place);
        TinkerSceneGraph *left = scene_graph_without(scene, graph, set);
        if (left->curves->len > 0) {
            scene->graphs->pdata[place] = left;
            tinker_scene_graph_free(graph);
        } else {
            tinker_scene_graph_free(left);
            g_ptr_array_remove_index(scene->graphs, place);
        }
    }
}

void scene_take_out(TinkerScene *scene, GHashTable *set)
{
    take_out_curves(scene, set);
    for (guint i = scene->instruments->len; i-- > 0;)
        if (scene_instrument_is_of(scene, g_ptr_array_index(scene->instruments, i), set))
            g_ptr_array_remove_index(scene->instruments, i);
    g_autoptr(GHashTable) tables = g_hash_table_new(NULL, NULL);
    leave_order(scene, set);
    GHashTableIter iter;
    gpointer id, table;
    g_hash_table_iter_init(&iter, set);
    while (g_hash_table_iter_next(&iter, &id, NULL)) {
        const TinkerBlockId block = GPOINTER_TO_INT(id);
        scene_forget_name(scene, block);
        if (scene_table_of(scene, block) != NULL) g_hash_table_add(tables, scene_table_of(scene, block));
        scene_slot(scene, block)->table = SCENE_REMOVED;
    }
    g_hash_table_iter_init(&iter, tables);
    while (g_hash_table_iter_next(&iter, &table, NULL))
        scene_table_remove(scene, table, set);
    scene_settle(scene);
}

void scene_blocks_take_out(TinkerScene *scene, const SceneBlocks *blocks)
{
    g_autoptr(GHashTable) set = g_hash_table_new(NULL, NULL);
    for (guint i = 0; i < blocks->snapshots->len; i++)
        g_hash_table_add(set, GINT_TO_POINTER(scene_snapshot_block(g_ptr_array_index(blocks->snapshots, i))));
    scene_take_out(scene, set);
}

/* Bringing back ---------------------------------------------------------------------------------------------------- */

static void enter_order(TinkerScene *scene, const GArray *places)
{
    GArray *others = scene->order;
    const guint total = others->len + places->len;
    guint next = 0;
    scene->order = g_array_sized_new(FALSE, FALSE, sizeof(TinkerBlockId), total);
    for (guint left = places->len; scene->order->len < total;) {
        const Place *at = left > 0 ? &g_array_index(places, Place, left - 1) : NULL;
        const gboolean now = at != NULL && (next == others->len || at->place <= (int32_t)scene->order->len);
        const TinkerBlockId id = now ? at->id : g_array_index(others, TinkerBlockId, next);
        if (now)
            left--;
        else
            next++;
        g_array_append_val(scene->order, id);
    }
    g_array_unref(others);
}

/* Rows are given by table, in the order of their ids, which is that of the snapshots. */
static void enter_tables(TinkerScene *scene, const GPtrArray *snapshots)
{
    g_autofree GArray **rows = g_new0(GArray *, scene->tables->len + 1);
    for (guint i = 0; i < snapshots->len; i++) {
        const SceneSnapshot *snapshot = g_ptr_array_index(snapshots, i);
        const int32_t table = scene_snapshot_table(snapshot);
        SceneNewRow row = {scene_snapshot_block(snapshot), scene_snapshot_end_count(snapshot)};
        scene_slot(scene, row.id)->table = table;
        if (table == SCENE_PLACEHOLDER) continue;
        if (rows[table] == NULL) rows[table] = g_array_new(FALSE, FALSE, sizeof(SceneNewRow));
        g_array_append_val(rows[table], row);
    }
    for (guint table = 0; table < scene->tables->len; table++) {
        if (rows[table] == NULL) continue;
        scene_table_insert(scene, g_ptr_array_index(scene->tables, table),
                           (const SceneNewRow *)(const void *)rows[table]->data, (int32_t)rows[table]->len);
        g_array_unref(rows[table]);
    }
}

void scene_blocks_bring_back(TinkerScene *scene, const SceneBlocks *blocks)
{
    enter_order(scene, blocks->places);
    enter_tables(scene, blocks->snapshots);
    for (guint i = 0; i < blocks->snapshots->len; i++)
        scene_snapshot_restore(scene, g_ptr_array_index(blocks->snapshots, i));
    for (guint i = blocks->graphs->len; i-- > 0;) {
        const Graph *graph = &g_array_index(blocks->graphs, Graph, i);
        const guint place = MIN(graph->place, scene->graphs->len);
        if (graph->stays) g_ptr_array_remove_index(scene->graphs, place);
        g_ptr_array_insert(scene->graphs, (int)place, tinker_scene_graph_copy(graph->graph));
    }
    if (blocks->instruments == NULL) return;
    g_ptr_array_unref(scene->instruments);
    scene->instruments = scene_instruments_copy(blocks->instruments);
}
