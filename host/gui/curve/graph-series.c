/* Each quantity that a curve is made of has a cursor of its own in the record, and the run may go on between two
 * readings: only rows that all of them have make points. What is read and has made its point is forgotten, but for the
 * values of the curve itself. */
#include "gui/curve/graph-series-private.h"

#include <math.h>
#include <string.h>

#include "measure/spectrum.h"
#include "physics/record/columns.h"
#include "units/waveform/table-columns.h"
#include "units/waveform/times.h"

#define GROWTH 1.2 /* by so much has a record to have grown before its spectrum is worked out anew */

static void clear_source(gpointer data)
{
    GraphSource *source = data;
    g_array_unref(source->times);
    g_array_unref(source->values);
}

static const double *numbers(const GArray *array)
{
    return (const double *)(gconstpointer)array->data;
}

/* What the curve is ------------------------------------------------------------------------------------------------ */

static void add_source(TinkerGraphSeries *series, TinkerBlockId block, int32_t quantity)
{
    const GraphSource source = {.of = {block, quantity},
                                .cursor = {.at_events = !series->is_spectrum},
                                .times = g_array_new(FALSE, FALSE, sizeof(double)),
                                .values = g_array_new(FALSE, FALSE, sizeof(double))};
    g_array_append_val(series->sources, source);
}

/* Nobody knows the quantities of a placeholder: it has their ids for titles. */
static TinkerGraphAxis find_axis(TinkerGraphSeries *series, TinkerScene *scene, const char *block_name, const char *id)
{
    TinkerBlockId block = TINKER_NO_BLOCK;
    const int32_t quantity =
        tinker_scene_find_owner(scene, block_name, &block) ? tinker_scene_find_quantity(scene, block, id) : -1;
    if (quantity < 0) {
        series->fault = g_strdup_printf("%s.%s", block_name, id);
        return (TinkerGraphAxis){.title = g_intern_string(id), .unit = "", .per_si = 1, .block = block};
    }
    TinkerGraphAxis axis = tinker_graph_axis(scene, block, quantity);
    axis.unit = g_intern_string(axis.unit);
    add_source(series, block, quantity);
    return axis;
}

static void find_quantity(TinkerGraphSeries *series, TinkerScene *scene, const TinkerSceneGraph *graph,
                          const TinkerSceneCurve *curve)
{
    series->block = g_strdup(curve->block);
    series->symbol = g_strdup(curve->quantity);
    series->y_axis = find_axis(series, scene, curve->block, curve->quantity);
    series->over_time = series->is_spectrum || g_str_equal(graph->against, "time");
    if (!series->over_time) series->x_axis = find_axis(series, scene, curve->block, graph->against);
    if (curve->title != NULL) series->y_axis.title = g_intern_string(curve->title);
}

static void find_formula(TinkerGraphSeries *series, TinkerScene *scene, const TinkerSceneCurve *curve)
{
    g_autoptr(GArray) columns = tinker_columns_new();
    g_autoptr(GError) error = NULL;
    TinkerDimension dimension;
    const char *title = curve->title != NULL ? curve->title : curve->expression;
    series->symbol = g_strdup(title);
    series->formula = tinker_formula_new(scene, curve->expression, columns, &error);
    const gboolean known = series->formula != NULL && tinker_formula_dimension(series->formula, &dimension, NULL);
    const char *unit = curve->unit == NULL && known
                           ? tinker_formula_unit(series->formula, tinker_scene_head(scene)->units)
                           : curve->unit;
    series->y_axis = tinker_graph_axis_of_value(scene, title, known ? &dimension : NULL, unit);
    if (series->formula == NULL) series->fault = g_strdup(error->message);
    for (guint i = 0; series->formula != NULL && i < columns->len; i++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, i);
        add_source(series, column->block, column->quantity);
    }
    /* what depends on the time alone has its points where the record has */
    if (series->formula != NULL && columns->len == 0) add_source(series, TINKER_NO_BLOCK, TINKER_SCENE_KINETIC);
}

static void read_table(TinkerGraphSeries *series, TinkerScene *scene, const char *base, const TinkerSceneCurve *curve)
{
    g_autofree char *folder = base != NULL ? g_path_get_dirname(base) : g_strdup(".");
    g_autofree char *file = g_build_filename(folder, curve->table, NULL);
    g_autoptr(GArray) rows = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GError) error = NULL;
    series->is_table = TRUE;
    series->symbol =
        curve->title != NULL ? g_strdup(curve->title) : g_strdup_printf("%s, %d", curve->table, curve->column);
    series->y_axis = tinker_graph_axis_of_value(scene, series->symbol, NULL, curve->unit);
    if (!tinker_table_read_column(file, curve->time_column, curve->column, rows, &error)) {
        series->fault = g_strdup(error->message);
        return;
    }
    for (guint i = 0; i + 1 < rows->len; i += 2) {
        g_array_append_val(series->times, g_array_index(rows, double, i));
        g_array_append_val(series->y, g_array_index(rows, double, i + 1));
    }
    if (!series->is_spectrum)
        tinker_curve_index_add(series->index, numbers(series->times), numbers(series->y), series->y->len);
}

static void transform(TinkerGraphSeries *series)
{
    series->transformed = series->y->len;
    tinker_spectrum_of_curve(numbers(series->times), numbers(series->y), series->y->len, -INFINITY, INFINITY,
                             TINKER_WINDOW_HANN, series->frequencies, series->amplitudes);
    tinker_curve_index_clear(series->index);
    tinker_curve_index_add(series->index, numbers(series->frequencies), numbers(series->amplitudes),
                           series->amplitudes->len);
}

TinkerGraphSeries *tinker_graph_series_new(TinkerScene *scene, const char *base, const TinkerSceneGraph *graph,
                                           const TinkerSceneCurve *curve)
{
    TinkerGraphSeries *series = g_new0(TinkerGraphSeries, 1);
    GArray **arrays[] = {&series->times, &series->x, &series->y, &series->frequencies, &series->amplitudes};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_array_new(FALSE, FALSE, sizeof(double));
    series->sources = g_array_new(FALSE, FALSE, sizeof(GraphSource));
    g_array_set_clear_func(series->sources, clear_source);
    series->index = tinker_curve_index_new();
    series->right = curve->axis == 2;
    series->over_time = TRUE;
    series->is_spectrum = g_str_equal(graph->against, "frequency");
    series->x_axis = series->is_spectrum ? tinker_graph_axis_frequency() : tinker_graph_axis_time();
    if (curve->table != NULL)
        read_table(series, scene, base, curve);
    else if (curve->expression != NULL)
        find_formula(series, scene, curve);
    else
        find_quantity(series, scene, graph, curve);
    if (series->is_spectrum && series->is_table) transform(series);
    if (series->block == NULL) series->block = g_strdup("");
    series->key = g_strdup_printf("%s\n%s\n%s\n%.17g\n%.17g", series->block, series->symbol, graph->against,
                                  series->x_axis.per_si, series->y_axis.per_si);
    return series;
}

void tinker_graph_series_free(TinkerGraphSeries *series)
{
    char *texts[] = {series->block, series->symbol, series->fault, series->key};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++)
        g_free(texts[i]);
    g_clear_pointer(&series->formula, tinker_formula_free);
    GArray *arrays[] = {series->sources, series->times, series->x, series->y, series->frequencies, series->amplitudes};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_array_unref(arrays[i]);
    tinker_curve_index_free(series->index);
    g_free(series);
}

/* A formula may have other values for its properties. */
gboolean tinker_graph_series_take_over(TinkerGraphSeries *series, TinkerGraphSeries *old)
{
    if (series->formula != NULL || series->is_table || old->formula != NULL || old->is_table ||
        !g_str_equal(series->key, old->key) || series->sources->len != old->sources->len)
        return FALSE;
    for (guint i = 0; i < series->sources->len; i++) {
        const TinkerQuantity *a = &g_array_index(series->sources, GraphSource, i).of,
                             *b = &g_array_index(old->sources, GraphSource, i).of;
        if (a->block != b->block || a->quantity != b->quantity) return FALSE;
    }
    GArray **mine[] = {&series->sources, &series->times,       &series->x,
                       &series->y,       &series->frequencies, &series->amplitudes};
    GArray **its[] = {&old->sources, &old->times, &old->x, &old->y, &old->frequencies, &old->amplitudes};
    for (gsize i = 0; i < G_N_ELEMENTS(mine); i++) {
        GArray *swapped = *mine[i];
        *mine[i] = *its[i];
        *its[i] = swapped;
    }
    TinkerCurveIndex *index = series->index;
    series->index = old->index;
    old->index = index;
    series->transformed = old->transformed;
    return TRUE;
}

const char *tinker_graph_series_block(const TinkerGraphSeries *series)
{
    return series->block;
}

const char *tinker_graph_series_symbol(const TinkerGraphSeries *series)
{
    return series->symbol;
}

const TinkerGraphAxis *tinker_graph_series_x_axis(const TinkerGraphSeries *series)
{
    return &series->x_axis;
}

const TinkerGraphAxis *tinker_graph_series_y_axis(const TinkerGraphSeries *series)
{
    return &series->y_axis;
}

gboolean tinker_graph_series_is_right(const TinkerGraphSeries *series)
{
    return series->right;
}

gboolean tinker_graph_series_is_table(const TinkerGraphSeries *series)
{
    return series->is_table;
}

/* The record ------------------------------------------------------------------------------------------------------- */

void tinker_graph_series_forget(TinkerGraphSeries *series)
{
    if (series->is_table) return;
    GArray *arrays[] = {series->times, series->x, series->y, series->frequencies, series->amplitudes};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_array_set_size(arrays[i], 0);
    for (guint i = 0; i < series->sources->len; i++) {
        GraphSource *source = &g_array_index(series->sources, GraphSource, i);
        g_array_set_size(source->times, 0);
        g_array_set_size(source->values, 0);
        source->cursor = (TinkerSeriesCursor){.at_events = source->cursor.at_events};
    }
    tinker_curve_index_clear(series->index);
    series->transformed = 0;
    series->behind = FALSE;
}

/* Makes points of the first rows that are read. */
static void make_points(TinkerGraphSeries *series, guint rows)
{
    const guint sources = series->sources->len;
    g_autofree double *row = g_new(double, sources);
    for (guint i = 0; i < rows; i++) {
        const double time = g_array_index(graph_source(series, 0)->times, double, i);
        for (guint k = 0; k < sources; k++)
            row[k] = g_array_index(graph_source(series, k)->values, double, i);
        const double y = series->formula != NULL ? tinker_formula_value(series->formula, time, row) : row[0];
        const double shown = y * series->y_axis.per_si, x = row[sources - 1] * series->x_axis.per_si;
        g_array_append_val(series->times, time);
        g_array_append_val(series->y, shown);
        if (!series->over_time) g_array_append_val(series->x, x);
    }
    for (guint k = 0; k < sources; k++) {
        g_array_remove_range(graph_source(series, k)->times, 0, rows);
        g_array_remove_range(graph_source(series, k)->values, 0, rows);
    }
    if (series->over_time && !series->is_spectrum)
        tinker_curve_index_add(series->index, numbers(series->times), numbers(series->y), series->y->len);
}

/* While the record grows it is worked out now and then, and once it stands still. */
static gboolean update_spectrum(TinkerGraphSeries *series, gboolean grew)
{
    const gsize count = series->y->len;
    if (count == series->transformed) return FALSE;
    if (grew && (double)count < GROWTH * (double)series->transformed) {
        series->behind = TRUE;
        return FALSE;
    }
    transform(series);
    return TRUE;
}

gboolean tinker_graph_series_update(TinkerGraphSeries *series, TinkerSeriesReader read, gpointer source)
{
    guint rows = G_MAXUINT;
    series->behind = FALSE;
    if (series->fault != NULL || series->sources->len == 0) return FALSE;
    for (guint i = 0; i < series->sources->len; i++) {
        GraphSource *next = graph_source(series, i);
        next->cursor.behind = FALSE;
        read(source, next->of, &next->cursor, next->times, next->values);
        series->behind |= next->cursor.behind;
        rows = MIN(rows, next->values->len);
    }
    if (rows > 0) make_points(series, rows);
    return series->is_spectrum ? update_spectrum(series, rows > 0) : rows > 0;
}

gboolean tinker_graph_series_is_behind(const TinkerGraphSeries *series)
{
    return series->behind;
}

gsize tinker_graph_series_count(const TinkerGraphSeries *series)
{
    return series->is_spectrum ? series->amplitudes->len : series->y->len;
}

const double *tinker_graph_series_times(const TinkerGraphSeries *series)
{
    return numbers(series->times);
}

const double *tinker_graph_series_x(const TinkerGraphSeries *series)
{
    if (series->is_spectrum) return numbers(series->frequencies);
    return numbers(series->over_time ? series->times : series->x);
}

const double *tinker_graph_series_y(const TinkerGraphSeries *series)
{
    return numbers(series->is_spectrum ? series->amplitudes : series->y);
}

const TinkerCurveIndex *tinker_graph_series_index(const TinkerGraphSeries *series)
{
    return series->over_time ? series->index : NULL;
}

/* Events have two points at one time, and a sample at that time comes behind them. */
gsize tinker_graph_series_sample_from(const TinkerGraphSeries *series, gsize point)
{
    const double *times = numbers(series->times);
    if (series->is_table || series->is_spectrum) return point;
    while (point + 1 < series->times->len && times[point] == times[point + 1])
        point += 2;
    return point;
}

gboolean tinker_graph_series_find(const TinkerGraphSeries *series, double time, gsize *point)
{
    const gsize count = tinker_times_until(numbers(series->times), series->y->len, time);
    *point = count - 1;
    return count > 0 && !series->is_spectrum;
}
