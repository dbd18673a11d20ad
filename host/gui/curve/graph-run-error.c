/* How far the run may have a curve off: as much as the quantities that it is made of make of it, to first order. */
#include <math.h>

#include "gui/curve/graph-series-private.h"
#include "measure/statistics.h"

/* All of one quantity, from the start. */
static void read_all(TinkerSeriesReader read, gpointer source, TinkerQuantity of, GArray *times, GArray *values)
{
    TinkerSeriesCursor cursor = {0};
    do
        read(source, of, &cursor, times, values);
    while (cursor.behind);
}

/* Of a formula it is another in each sample, and between them it may be more. */
static double formula_error(const TinkerGraphSeries *series, TinkerSeriesReader read, gpointer source,
                            const double *bands, const double *range)
{
    const guint sources = series->sources->len;
    guint rows = G_MAXUINT;
    g_autoptr(GPtrArray) values = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    g_autofree double *row = g_new(double, sources);
    for (guint k = 0; k < sources; k++) {
        GArray *column = g_array_new(FALSE, FALSE, sizeof(double));
        g_ptr_array_add(values, column);
        g_array_set_size(times, 0);
        read_all(read, source, graph_source(series, k)->of, times, column);
        rows = MIN(rows, column->len);
    }
    g_autofree double *errors = g_new(double, rows);
    for (guint i = 0; i < rows; i++) {
        const double time = g_array_index(times, double, i);
        for (guint k = 0; k < sources; k++)
            row[k] = g_array_index((GArray *)g_ptr_array_index(values, k), double, i);
        errors[i] = tinker_formula_band(series->formula, time, row, bands);
    }
    return tinker_greatest_about((const double *)(gconstpointer)times->data, errors, rows, range[0], range[1]);
}

gboolean tinker_graph_series_run_error(const TinkerGraphSeries *series, TinkerSeriesReader read, TinkerBandReader band,
                                       gpointer source, double from, double to, double *error)
{
    const double range[2] = {from, to};
    *error = 0;
    if (series->is_table) return TRUE;
    if (series->fault != NULL || series->sources->len == 0) return FALSE;
    g_autofree double *bands = g_new0(double, series->sources->len);
    for (guint k = 0; k < series->sources->len; k++)
        if (!band(source, graph_source(series, k)->of, to, &bands[k])) return FALSE;
    *error = fabs(series->y_axis.per_si) *
             (series->formula != NULL ? formula_error(series, read, source, bands, range) : bands[0]);
    return isfinite(*error);
}
