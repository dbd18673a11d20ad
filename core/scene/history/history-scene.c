/* The recorded setters of what is not a block: the head, graphs, and the drawing order. */
#include "scene/history/history-private.h"

/* Head --------------------------------------------------------------------------------------------------------- */

static void make_head(TinkerScene *scene, int32_t id, gconstpointer from, gconstpointer to)
{
    (void)id, (void)from;
    TinkerSceneHead *copy = scene_head_copy(to);
    scene_head_clear(&scene->head);
    scene->head = *copy;
    g_free(copy); /* its texts are the scene's now */
}

static void free_head(gpointer state)
{
    scene_head_free(state);
}

/* Of the head: id 0; TinkerSceneHead. */
static const HistoryKind history_head = {HISTORY_HEAD, make_head, free_head};

gboolean tinker_history_set_head(TinkerHistory *history, const TinkerSceneHead *head, GError **error)
{
    TinkerScene *scene = history_scene(history);
    g_autofree char *fault = scene_head_fault(head);
    if (fault != NULL) {
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, fault);
        return FALSE;
    }
    TinkerSceneHead *before = scene_head_copy(&scene->head), *after = scene_head_copy(head);
    make_head(scene, 0, before, after);
    gboolean own = history_open_own(history, "Change", "Scene");
    history_add(history, &history_head, 0, before, after);
    if (own) tinker_history_end(history);
    return TRUE;
}

/* Graphs ------------------------------------------------------------------------------------------------------- */

static void make_graph(TinkerScene *scene, int32_t index, gconstpointer from, gconstpointer to)
{
    if (from != NULL) g_ptr_array_remove_index(scene->graphs, (guint)index);
    if (to != NULL) g_ptr_array_insert(scene->graphs, index, tinker_scene_graph_copy(to));
}

static void free_graph(gpointer state)
{
    tinker_scene_graph_free(state);
}

/* Of a graph: by place in the list; TinkerSceneGraph. */
static const HistoryKind history_graph = {HISTORY_OTHER, make_graph, free_graph};

/* Makes and records the change of a graph of `block`; takes both states, of which one may be NULL. */
static void change_graph(TinkerHistory *history, const char *verb, const char *block, int32_t index,
                         TinkerSceneGraph *before, TinkerSceneGraph *after)
{
    g_autofree char *name = g_strdup_printf("Graph of %s", block);
    gboolean own = history_open_own(history, verb, name);
    make_graph(history_scene(history), index, before, after);
    history_add(history, &history_graph, index, before, after);
    if (own) tinker_history_end(history);
}

static gboolean check_graph(TinkerHistory *history, const TinkerSceneGraph *graph, GError **error)
{
    g_autofree char *fault = scene_graph_fault(history_scene(history), graph);
    if (fault == NULL) return TRUE;
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, "graph: %s", fault);
    return FALSE;
}

/* The graph as it is. (transfer full) */
static TinkerSceneGraph *copy_of(TinkerHistory *history, int32_t index)
{
    const GPtrArray *graphs = history_scene(history)->graphs;
    g_assert(index >= 0 && index < (int32_t)graphs->len);
    return tinker_scene_graph_copy(g_ptr_array_index(graphs, index));
}

int32_t tinker_history_add_graph(TinkerHistory *history, const TinkerSceneGraph *graph, GError **error)
{
    if (!check_graph(history, graph, error)) return -1;
    int32_t index = (int32_t)history_scene(history)->graphs->len;
    change_graph(history, "Add", scene_graph_name(graph), index, NULL, tinker_scene_graph_copy(graph));
    return index;
}

void tinker_history_remove_graph(TinkerHistory *history, int32_t index)
{
    TinkerSceneGraph *before = copy_of(history, index);
    change_graph(history, "Remove", scene_graph_name(before), index, before, NULL);
}

gboolean tinker_history_change_graph(TinkerHistory *history, int32_t index, const TinkerSceneGraph *graph,
                                     GError **error)
{
    if (!check_graph(history, graph, error)) return FALSE;
    change_graph(history, "Change", scene_graph_name(graph), index, copy_of(history, index),
                 tinker_scene_graph_copy(graph));
    return TRUE;
}

/* Instruments -------------------------------------------------------------------------------------------------- */

static void make_instruments(TinkerScene *scene, int32_t id, gconstpointer from, gconstpointer to)
{
    (void)id, (void)from;
    GPtrArray *before = scene->instruments;
    scene->instruments = scene_instruments_copy(to);
    g_ptr_array_unref(before);
}

static void free_instruments(gpointer state)
{
    g_ptr_array_unref(state);
}

/* Of all instruments: id 0; GPtrArray of TinkerSceneInstrument *. */
static const HistoryKind history_instruments = {HISTORY_OTHER, make_instruments, free_instruments};

gboolean tinker_history_set_instrument(TinkerHistory *history, int32_t index, const TinkerSceneInstrument *instrument,
                                       GError **error)
{
    TinkerScene *scene = history_scene(history);
    g_assert(index >= 0 && index <= (int32_t)scene->instruments->len);
    g_autofree char *fault = instrument != NULL ? scene_instrument_fault(scene, instrument) : NULL;
    if (fault != NULL) {
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, fault);
        return FALSE;
    }
    GPtrArray *before = scene_instruments_copy(scene->instruments), *after = scene_instruments_copy(before);
    if (index < (int32_t)after->len) g_ptr_array_remove_index(after, (guint)index);
    if (instrument != NULL) g_ptr_array_insert(after, index, tinker_scene_instrument_copy(instrument));
    gboolean own = history_open_own(history, "Change", "Instruments");
    make_instruments(scene, 0, before, after);
    history_add(history, &history_instruments, 0, before, after);
    if (own) tinker_history_end(history);
    return TRUE;
}

/* Drawing order ------------------------------------------------------------------------------------------------ */

static void make_order(TinkerScene *scene, int32_t block, gconstpointer from, gconstpointer to)
{
    (void)from;
    scene_move_in_order(scene, block, GPOINTER_TO_INT(to) - 1);
}

/* Of the drawing order: by block id; its place, see history_place(). */
static const HistoryKind history_order = {HISTORY_OTHER, make_order, NULL};

static void move_to(TinkerHistory *history, TinkerBlockId block, int32_t place)
{
    TinkerScene *scene = history_scene(history);
    int32_t before = scene_order_of(scene, block);
    if (before == place) return;
    scene_move_in_order(scene, block, place);
    history_add(history, &history_order, block, history_place(before), history_place(place));
}

static int by_place(const void *a, const void *b, void *data)
{
    const TinkerScene *scene = data;
    return scene_order_of(scene, *(const TinkerBlockId *)a) - scene_order_of(scene, *(const TinkerBlockId *)b);
}

void tinker_history_order_blocks(TinkerHistory *history, const TinkerBlockId *blocks, guint count, gboolean in_front)
{
    TinkerScene *scene = history_scene(history);
    const int32_t last = tinker_scene_block_count(scene) - 1;
    g_autofree TinkerBlockId *ordered = g_memdup2(blocks, count * sizeof *blocks);
    g_qsort_with_data(ordered, (int)count, sizeof *ordered, by_place, scene);
    const gboolean own = history_open_several(history, in_front ? "Raise" : "Lower", blocks, count);
    for (guint i = 0; i < count; i++)
        move_to(history, in_front ? ordered[i] : ordered[count - 1 - i], in_front ? last : 0);
    if (own) tinker_history_end(history);
}
