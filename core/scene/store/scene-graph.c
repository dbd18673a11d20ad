/* Graphs: their curves, which blocks they are of, and how they follow a name. */
#include <string.h>

#include "scene/store/quantities.h"
#include "scene/store/scene-data.h"
#include "scene/store/scene-expression.h"

/* What a curve is made of: exactly one of the three. */
static gboolean is_quantity(const TinkerSceneCurve *curve)
{
    return curve->expression == NULL && curve->table == NULL;
}

void scene_curve_free(TinkerSceneCurve *curve)
{
    char *texts[] = {curve->block, curve->quantity, curve->expression, curve->table,
                     curve->title, curve->unit,     curve->extras};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_free(curve);
}

static TinkerSceneCurve *curve_copy(const TinkerSceneCurve *curve)
{
    TinkerSceneCurve *copy = g_new(TinkerSceneCurve, 1);
    *copy = *curve;
    char **texts[] = {&copy->block, &copy->quantity, &copy->expression, &copy->table,
                      &copy->title, &copy->unit,     &copy->extras};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        *texts[i] = g_strdup(*texts[i]);
    return copy;
}

TinkerSceneGraph *tinker_scene_graph_new(void)
{
    TinkerSceneGraph *graph = g_new0(TinkerSceneGraph, 1);
    graph->against = g_strdup("time");
    graph->curves = g_ptr_array_new_with_free_func((GDestroyNotify)scene_curve_free);
    return graph;
}

TinkerSceneCurve *tinker_scene_graph_add(TinkerSceneGraph *graph, const char *block, const char *quantity)
{
    TinkerSceneCurve *curve = g_new0(TinkerSceneCurve, 1);
    curve->block = g_strdup(block);
    curve->quantity = g_strdup(quantity);
    curve->axis = 1;
    g_ptr_array_add(graph->curves, curve);
    return curve;
}

const TinkerSceneCurve *tinker_scene_graph_curve(const TinkerSceneGraph *graph)
{
    for (guint i = 0; i < graph->curves->len; i++)
        if (is_quantity(g_ptr_array_index(graph->curves, i))) return g_ptr_array_index(graph->curves, i);
    return NULL;
}

TinkerSceneGraph *tinker_scene_graph_copy(const TinkerSceneGraph *graph)
{
    TinkerSceneGraph *copy = g_new(TinkerSceneGraph, 1);
    *copy = *graph;
    copy->against = g_strdup(graph->against);
    copy->title = g_strdup(graph->title);
    copy->extras = g_strdup(graph->extras);
    copy->curves = g_ptr_array_new_with_free_func((GDestroyNotify)scene_curve_free);
    for (guint i = 0; i < graph->curves->len; i++)
        g_ptr_array_add(copy->curves, curve_copy(g_ptr_array_index(graph->curves, i)));
    return copy;
}

void tinker_scene_graph_free(TinkerSceneGraph *graph)
{
    g_ptr_array_unref(graph->curves);
    g_free(graph->against);
    g_free(graph->title);
    g_free(graph->extras);
    g_free(graph);
}

const char *scene_graph_name(const TinkerSceneGraph *graph)
{
    const TinkerSceneCurve *first = graph->curves->len > 0 ? g_ptr_array_index(graph->curves, 0) : NULL;
    if (first == NULL) return "nothing";
    return first->block != NULL ? first->block : first->expression != NULL ? first->expression : first->table;
}

/* Blocks ----------------------------------------------------------------------------------------------------------- */

static void add_block(GArray *blocks, TinkerBlockId block)
{
    if (block != TINKER_NO_BLOCK) g_array_append_val(blocks, block);
}

static void add_quantity(const TinkerScene *scene, TinkerBlockId block, const char *quantity, GArray *blocks)
{
    const char *other = tinker_quantity_other_name(quantity);
    add_block(blocks, block);
    if (other != NULL) add_block(blocks, tinker_scene_find_block(scene, other));
}

/* Adds the blocks that a curve is of; some perhaps more than once. */
static void add_curve_blocks(const TinkerScene *scene, const TinkerSceneCurve *curve, GArray *blocks)
{
    if (is_quantity(curve)) add_quantity(scene, tinker_scene_find_block(scene, curve->block), curve->quantity, blocks);
    if (curve->expression == NULL) return;
    g_autoptr(TinkerSceneExpression) read = tinker_scene_expression_new(scene, curve->expression, NULL);
    for (guint i = 0; read != NULL && i < read->references->len; i++) {
        const TinkerReference *reference = &g_array_index(read->references, TinkerReference, i);
        add_block(blocks, reference->block);
        add_block(blocks, tinker_quantity_other(reference->quantity));
    }
}

GArray *scene_graph_blocks(const TinkerScene *scene, const TinkerSceneGraph *graph)
{
    GArray *blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (guint i = 0; i < graph->curves->len; i++)
        add_curve_blocks(scene, g_ptr_array_index(graph->curves, i), blocks);
    add_quantity(scene, TINKER_NO_BLOCK, graph->against, blocks);
    return blocks;
}

/* Whether a curve, or what it is drawn against, is of one of the blocks. */
static gboolean is_of(const TinkerScene *scene, const TinkerSceneGraph *graph, const TinkerSceneCurve *curve,
                      GHashTable *blocks)
{
    g_autoptr(GArray) own = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    add_curve_blocks(scene, curve, own);
    if (is_quantity(curve)) add_quantity(scene, TINKER_NO_BLOCK, graph->against, own);
    for (guint i = 0; i < own->len; i++)
        if (g_hash_table_contains(blocks, GINT_TO_POINTER(g_array_index(own, TinkerBlockId, i)))) return TRUE;
    return FALSE;
}

GArray *scene_graphs_of(const TinkerScene *scene, GHashTable *blocks)
{
    GArray *places = g_array_new(FALSE, FALSE, sizeof(guint));
    for (guint i = scene->graphs->len; i-- > 0;) {
        const TinkerSceneGraph *graph = g_ptr_array_index(scene->graphs, i);
        gboolean any = FALSE;
        for (guint k = 0; k < graph->curves->len && !any; k++)
            any = is_of(scene, graph, g_ptr_array_index(graph->curves, k), blocks);
        if (any) g_array_append_val(places, i);
    }
    return places;
}

TinkerSceneGraph *scene_graph_without(const TinkerScene *scene, const TinkerSceneGraph *graph, GHashTable *blocks)
{
    TinkerSceneGraph *left = tinker_scene_graph_copy(graph);
    for (guint i = left->curves->len; i-- > 0;)
        if (is_of(scene, left, g_ptr_array_index(left->curves, i), blocks)) g_ptr_array_remove_index(left->curves, i);
    return left;
}

gboolean scene_graph_is_of_samples(const TinkerSceneGraph *graph)
{
    return g_str_equal(graph->against, "time") || g_str_equal(graph->against, "frequency");
}

/* Names ------------------------------------------------------------------------------------------------------------ */

static void take(char **text, char *renamed)
{
    if (renamed == NULL) return;
    g_free(*text);
    *text = renamed;
}

void scene_graph_rename(TinkerSceneGraph *graph, const char *from, const char *to)
{
    take(&graph->against, tinker_quantity_renamed(graph->against, from, to));
    for (guint i = 0; i < graph->curves->len; i++) {
        TinkerSceneCurve *curve = g_ptr_array_index(graph->curves, i);
        if (curve->expression != NULL)
            take(&curve->expression, tinker_scene_expression_renamed(curve->expression, from, to));
        if (!is_quantity(curve)) continue;
        take(&curve->quantity, tinker_quantity_renamed(curve->quantity, from, to));
        if (strcmp(curve->block, from) == 0) take(&curve->block, g_strdup(to));
    }
}
