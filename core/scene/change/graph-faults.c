/* What is wrong with a graph, in words. */
#include <math.h>

#include "scene/store/quantities.h"
#include "scene/store/scene-expression.h"
#include "scene/value/reader.h"

char *scene_quantity_fault(const TinkerScene *scene, TinkerBlockId block, const char *quantity)
{
    if (block != TINKER_NO_BLOCK && tinker_scene_block_class(scene, block) == NULL) return NULL; /* nobody knows */
    if (tinker_scene_find_quantity(scene, block, quantity) >= 0) return NULL;
    g_auto(GStrv) names = tinker_scene_quantity_names(scene, block);
    g_autofree char *list = g_strjoinv("\", \"", names);
    g_autofree char *otherwise =
        names[0] == NULL ? g_strdup(" (it has none)") : g_strdup_printf(" (it has \"%s\")", list);
    g_autofree char *suggestion = reader_suggestion(quantity, (const char *const *)names, otherwise);
    if (block == TINKER_NO_BLOCK) return g_strdup_printf("the scene has no quantity \"%s\"%s", quantity, suggestion);
    return g_strdup_printf("a %s has no quantity \"%s\"%s", tinker_scene_block_type(scene, block), quantity,
                           suggestion);
}

char *scene_graph_size_fault(const double size[2])
{
    if (isfinite(size[0]) && isfinite(size[1]) && size[0] > 0 && size[1] > 0) return NULL;
    return g_strdup("size: both numbers must be greater than 0");
}

char *scene_graph_range_fault(const TinkerSceneGraph *graph, int axis)
{
    const double *range = graph->range[axis];
    if (!graph->has_range[axis]) return NULL;
    if (!(isfinite(range[0]) && isfinite(range[1]) && range[0] < range[1]))
        return g_strdup("range: the second number must be greater than the first");
    if (graph->logarithmic[axis] && range[0] <= 0)
        return g_strdup("range: both numbers must be greater than 0 where the scale is \"log\"");
    return NULL;
}

char *scene_curve_fault(const TinkerScene *scene, const TinkerSceneGraph *graph, const TinkerSceneCurve *curve)
{
    if (curve->axis != 1 && curve->axis != 2) return g_strdup("axis: it is 1 (left) or 2 (right)");
    const gboolean of_samples = scene_graph_is_of_samples(graph);
    if (curve->unit != NULL && curve->block != NULL)
        return g_strdup("unit: a quantity has its own; it is for expressions and tables");
    if (curve->block == NULL && !of_samples)
        return g_strdup("against: only quantities are drawn against a quantity of their block");
    if (curve->expression != NULL) {
        g_autoptr(GError) error = NULL;
        g_autoptr(TinkerSceneExpression) read = tinker_scene_expression_new(scene, curve->expression, &error);
        return read != NULL ? NULL : g_strdup_printf("expression: %s", error->message);
    }
    if (curve->table != NULL) return NULL;
    TinkerBlockId block;
    if (!tinker_scene_find_owner(scene, curve->block, &block))
        return g_strdup_printf("there is no block \"%s\"", curve->block);
    char *fault = scene_quantity_fault(scene, block, curve->quantity);
    return fault != NULL || of_samples ? fault : scene_quantity_fault(scene, block, graph->against);
}

char *scene_graph_fault(const TinkerScene *scene, const TinkerSceneGraph *graph)
{
    g_assert(graph->curves != NULL && graph->against != NULL);
    if (graph->curves->len == 0) return g_strdup("a graph needs a curve");
    if (graph->title != NULL && !g_utf8_validate(graph->title, -1, NULL)) return g_strdup("title must be UTF-8 text");
    if (graph->has_place && !(isfinite(graph->place[0]) && isfinite(graph->place[1])))
        return g_strdup("place must be finite");
    char *fault = graph->has_size ? scene_graph_size_fault(graph->size) : NULL;
    for (int axis = 0; axis < 2 && fault == NULL; axis++)
        fault = scene_graph_range_fault(graph, axis);
    for (guint i = 0; i < graph->curves->len && fault == NULL; i++)
        fault = scene_curve_fault(scene, graph, g_ptr_array_index(graph->curves, i));
    return fault;
}
