/* Which curves a chart has: named ones, and those of the graphs that a scene holds. */
#include <string.h>

#include "cli/report/chart-private.h"
#include "units/waveform/table-columns.h"

/* The row's place of a column, which is added unless it is recorded already. */
static gboolean column_place(TinkerChart *chart, const char *name, guint *place, GError **error)
{
    for (guint i = 0; i < chart->columns->len; i++) {
        if (strcmp(g_array_index(chart->columns, TinkerColumn, i).name, name) != 0) continue;
        *place = i + 1;
        return TRUE;
    }
    if (!tinker_columns_add(chart->columns, chart->scene, name, error)) return FALSE;
    *place = chart->columns->len;
    return TRUE;
}

/* "vx" beside "Mass 0.y" means "Mass 0.vx"; a name with a dot that is no column of its own block stands for itself. */
static char *full_name(const char *beside, const char *name)
{
    const char *dot = strrchr(beside, '.');
    if (strchr(name, '.') != NULL || dot == NULL) return g_strdup(name);
    return g_strdup_printf("%.*s.%s", (int)(dot - beside), beside, name);
}

static gboolean add_formula(TinkerChart *chart, const char *text, const TinkerSceneCurve *as, GError **error)
{
    TinkerChartCurve curve = {.right = as != NULL && as->axis == 2};
    TinkerDimension dimension;
    curve.formula = tinker_formula_new(chart->scene, text, chart->columns, error);
    if (curve.formula == NULL) {
        g_prefix_error(error, "\"%s\": ", text);
        return FALSE;
    }
    gboolean known = tinker_formula_dimension(curve.formula, &dimension, NULL);
    curve.name = g_strdup(as != NULL && as->title != NULL ? as->title : text);
    const char *unit = as != NULL && as->unit != NULL
                           ? as->unit
                           : tinker_formula_unit(curve.formula, tinker_scene_head(chart->scene)->units);
    curve.axis = tinker_graph_axis_of_value(chart->scene, curve.name, known ? &dimension : NULL, unit);
    g_array_append_val(chart->curves, curve);
    return TRUE;
}

/* Spectra are of curves over time. */
static gboolean is_over_time(const char *against)
{
    return against == NULL || strcmp(against, "time") == 0 || strcmp(against, "frequency") == 0;
}

gboolean tinker_chart_add(TinkerChart *chart, const char *name, const char *against, GError **error)
{
    TinkerChartCurve curve = {0};
    if (strchr(name, '{') != NULL && is_over_time(against)) return add_formula(chart, name, NULL, error);
    if (!column_place(chart, name, &curve.y, error)) return FALSE;
    if (!is_over_time(against)) {
        g_autofree char *other = full_name(name, against);
        if (!column_place(chart, other, &curve.x, error)) return FALSE;
    }
    curve.name = g_strdup(g_array_index(chart->columns, TinkerColumn, curve.y - 1).name);
    curve.axis = tinker_chart_axis(chart, curve.y);
    g_array_append_val(chart->curves, curve);
    return TRUE;
}

void tinker_chart_part_axes(TinkerChart *chart)
{
    const char *units[2] = {NULL, NULL};
    for (guint i = 0; i < chart->curves->len; i++) {
        const TinkerChartCurve *curve = &g_array_index(chart->curves, TinkerChartCurve, i);
        int k = 0;
        while (k < 2 && units[k] != NULL && strcmp(units[k], curve->axis.unit) != 0)
            k++;
        if (k == 2 || curve->x != 0) return;
        units[k] = curve->axis.unit;
    }
    for (guint i = 0; units[1] != NULL && i < chart->curves->len; i++) {
        TinkerChartCurve *curve = &g_array_index(chart->curves, TinkerChartCurve, i);
        curve->right = strcmp(curve->axis.unit, units[1]) == 0;
    }
}

/* Graphs of the scene ---------------------------------------------------------------------------------------------- */

/* The only curve of a graph, where it is a quantity. */
static const TinkerSceneCurve *only_quantity(const TinkerSceneGraph *graph)
{
    return graph->curves->len == 1 ? tinker_scene_graph_curve(graph) : NULL;
}

static gboolean find_dimension(const TinkerChart *chart, const TinkerSceneCurve *curve, TinkerDimension *dimension)
{
    TinkerBlockId block;
    if (curve == NULL || !tinker_scene_find_owner(chart->scene, curve->block, &block)) return FALSE;
    int32_t quantity = tinker_scene_find_quantity(chart->scene, block, curve->quantity);
    if (quantity >= 0) *dimension = tinker_scene_quantity_type(chart->scene, block, quantity).dimension;
    return quantity >= 0;
}

static gboolean same_axes(const TinkerChart *chart, const TinkerSceneGraph *first, const TinkerSceneGraph *graph)
{
    TinkerDimension a, b;
    if (first == graph) return TRUE;
    return strcmp(first->against, graph->against) == 0 && find_dimension(chart, only_quantity(first), &a) &&
           find_dimension(chart, only_quantity(graph), &b) && tinker_dimension_equal(a, b);
}

static gboolean add_table(TinkerChart *chart, const TinkerSceneCurve *from, const char *path, GError **error)
{
    TinkerChartCurve curve = {.right = from->axis == 2, .table = g_array_new(FALSE, FALSE, sizeof(double))};
    g_autofree char *folder = g_path_get_dirname(path), *file = g_build_filename(folder, from->table, NULL);
    curve.name = from->title != NULL ? g_strdup(from->title) : g_strdup_printf("%s, %d", from->table, from->column);
    curve.axis = tinker_graph_axis_of_value(chart->scene, curve.name, NULL, from->unit);
    g_array_append_val(chart->curves, curve);
    return tinker_table_read_column(file, from->time_column, from->column, curve.table, error);
}

static gboolean add_curve(TinkerChart *chart, const TinkerSceneGraph *graph, const TinkerSceneCurve *curve,
                          const char *path, GError **error)
{
    if (curve->table != NULL) return add_table(chart, curve, path, error);
    if (curve->expression != NULL) return add_formula(chart, curve->expression, curve, error);
    g_autofree char *name = g_strdup_printf("%s.%s", curve->block, curve->quantity);
    if (!tinker_chart_add(chart, name, graph->against, error)) return FALSE;
    TinkerChartCurve *added = &g_array_index(chart->curves, TinkerChartCurve, chart->curves->len - 1);
    added->right = curve->axis == 2;
    if (curve->title == NULL) return TRUE;
    g_free(added->name);
    added->name = g_strdup(curve->title);
    added->axis.title = g_intern_string(curve->title);
    return TRUE;
}

gboolean tinker_chart_add_graphs_of_scene(TinkerChart *chart, const char *path, GPtrArray *left_out, GError **error)
{
    GPtrArray *graphs = tinker_scene_graphs(chart->scene);
    for (guint i = 0; i < graphs->len; i++) {
        TinkerSceneGraph *first = g_ptr_array_index(graphs, 0), *graph = g_ptr_array_index(graphs, i);
        if (!same_axes(chart, first, graph)) {
            g_ptr_array_add(left_out, graph);
            continue;
        }
        for (guint k = 0; k < graph->curves->len; k++)
            if (!add_curve(chart, graph, g_ptr_array_index(graph->curves, k), path, error)) return FALSE;
    }
    const TinkerSceneGraph *only = graphs->len == 1 ? g_ptr_array_index(graphs, 0) : NULL;
    if (graphs->len > 0) chart->axes = g_ptr_array_index(graphs, 0);
    chart->is_spectrum = chart->axes != NULL && strcmp(chart->axes->against, "frequency") == 0;
    if (only != NULL && only->title != NULL) {
        g_free(chart->title);
        chart->title = g_strdup(only->title);
    }
    return TRUE;
}
