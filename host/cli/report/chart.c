/* Charts: what a run records of their curves. */
#include "cli/report/chart-private.h"

#include <string.h>

static void clear_curve(gpointer data)
{
    TinkerChartCurve *curve = data;
    g_clear_pointer(&curve->formula, tinker_formula_free);
    g_clear_pointer(&curve->table, g_array_unref);
    g_free(curve->name);
    g_free(curve->title);
}

TinkerChart *tinker_chart_new(TinkerScene *scene)
{
    TinkerChart *chart = g_new0(TinkerChart, 1);
    chart->scene = scene;
    chart->columns = tinker_columns_new();
    chart->curves = g_array_new(FALSE, FALSE, sizeof(TinkerChartCurve));
    g_array_set_clear_func(chart->curves, clear_curve);
    chart->others = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_chart_free);
    chart->title = g_strdup(tinker_scene_head(scene)->title);
    return chart;
}

void tinker_chart_free(TinkerChart *chart)
{
    if (chart == NULL) return;
    g_array_unref(chart->columns);
    g_array_unref(chart->curves);
    g_clear_pointer(&chart->record, tinker_record_free);
    g_ptr_array_unref(chart->others);
    g_free(chart->title);
    g_free(chart->run);
    g_free(chart);
}

double tinker_chart_value(const TinkerChartCurve *curve, const double *row)
{
    return curve->formula != NULL ? tinker_formula_value(curve->formula, row[0], row + 1) : row[curve->y];
}

double tinker_chart_band(const TinkerChart *chart, const TinkerChartCurve *curve, const double *row)
{
    const double *bands = row + 1 + chart->columns->len;
    if (curve->formula != NULL) return tinker_formula_band(curve->formula, row[0], row + 1, bands);
    return bands[curve->y - 1];
}

guint tinker_chart_width(const TinkerChart *chart)
{
    return 1 + (chart->has_bands ? 2 : 1) * chart->columns->len;
}

gboolean tinker_chart_sample(TinkerChart *chart, double time, const double *values, const double *bands, GError **error)
{
    guint columns = chart->columns->len;
    if (chart->record == NULL) {
        chart->has_bands = bands != NULL;
        chart->record = tinker_record_new(tinker_chart_width(chart), 0);
    }
    double few[16];
    g_autofree double *many = 2 * columns >= G_N_ELEMENTS(few) ? g_new(double, 2 * columns + 1) : NULL;
    double *row = many != NULL ? many : few;
    row[0] = time;
    memcpy(row + 1, values, columns * sizeof(double));
    if (chart->has_bands) memcpy(row + 1 + columns, bands, columns * sizeof(double));
    return tinker_record_append(chart->record, row, error);
}

gboolean tinker_chart_at_event(TinkerChart *chart, double time, const double *before, const double *behind,
                               GError **error)
{
    const guint columns = chart->columns->len;
    g_autofree double *last = g_new0(double, tinker_chart_width(chart));
    const gsize rows = tinker_record_rows(chart->record);
    if (!tinker_record_read(chart->record, rows - 1, 1, last, error)) return FALSE;
    const double *bands = chart->has_bands ? last + 1 + columns : NULL;
    return tinker_chart_sample(chart, time, before, bands, error) &&
           tinker_chart_sample(chart, time, behind, bands, error);
}

void tinker_chart_cut(TinkerChart *chart, double time)
{
    if (chart->record == NULL) return;
    g_autofree double *row = g_new(double, tinker_chart_width(chart));
    gsize rows = tinker_record_rows(chart->record);
    while (rows > 0 && tinker_record_read(chart->record, rows - 1, 1, row, NULL) && row[0] > time)
        rows--;
    tinker_record_cut(chart->record, rows);
}

TinkerGraphAxis tinker_chart_axis(const TinkerChart *chart, guint place)
{
    if (place == 0) return tinker_graph_axis_time();
    const TinkerColumn *column = &g_array_index(chart->columns, TinkerColumn, place - 1);
    return tinker_graph_axis(chart->scene, column->block, column->quantity);
}
