/* Charts: which curves, and their values as CSV. */
#include "cli/report/chart-private.h"

#include <string.h>

#include "cli/command/output.h"
#include "exit-status.h"

#define ROWS_AT_ONCE 1024

TinkerChart *tinker_chart_new(TinkerScene *scene)
{
    TinkerChart *chart = g_new0(TinkerChart, 1);
    chart->scene = scene;
    chart->columns = tinker_columns_new();
    chart->curves = g_array_new(FALSE, FALSE, sizeof(TinkerChartCurve));
    chart->title = g_strdup(tinker_scene_head(scene)->title);
    return chart;
}

void tinker_chart_free(TinkerChart *chart)
{
    if (chart == NULL) return;
    g_array_unref(chart->columns);
    g_array_unref(chart->curves);
    g_clear_pointer(&chart->record, tinker_record_free);
    g_free(chart->title);
    g_free(chart);
}

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

gboolean tinker_chart_add(TinkerChart *chart, const char *name, const char *against, GError **error)
{
    TinkerChartCurve curve = {0, 0};
    if (!column_place(chart, name, &curve.y, error)) return FALSE;
    if (against != NULL && strcmp(against, "time") != 0) {
        g_autofree char *other = full_name(name, against);
        if (!column_place(chart, other, &curve.x, error)) return FALSE;
    }
    g_array_append_val(chart->curves, curve);
    return TRUE;
}

static gboolean same_axes(const TinkerChart *chart, const TinkerSceneGraph *first, const TinkerSceneGraph *graph)
{
    if (first == graph) return TRUE;
    if (strcmp(first->against, graph->against) != 0) return FALSE;
    TinkerBlockId a = tinker_scene_find_block(chart->scene, first->block);
    TinkerBlockId b = tinker_scene_find_block(chart->scene, graph->block);
    const TinkerBlockClass *class_a = tinker_scene_block_class(chart->scene, a);
    const TinkerBlockClass *class_b = tinker_scene_block_class(chart->scene, b);
    if (class_a == NULL || class_b == NULL) return FALSE;
    int32_t quantity_a = tinker_block_class_quantity(class_a, first->quantity);
    int32_t quantity_b = tinker_block_class_quantity(class_b, graph->quantity);
    return quantity_a >= 0 && quantity_b >= 0 &&
           tinker_dimension_equal(class_a->quantities[quantity_a].dimension, class_b->quantities[quantity_b].dimension);
}

gboolean tinker_chart_add_graphs_of_scene(TinkerChart *chart, GPtrArray *left_out, GError **error)
{
    GPtrArray *graphs = tinker_scene_graphs(chart->scene);
    for (guint i = 0; i < graphs->len; i++) {
        TinkerSceneGraph *first = g_ptr_array_index(graphs, 0), *graph = g_ptr_array_index(graphs, i);
        if (!same_axes(chart, first, graph)) {
            g_ptr_array_add(left_out, graph);
            continue;
        }
        g_autofree char *name = g_strdup_printf("%s.%s", graph->block, graph->quantity);
        if (!tinker_chart_add(chart, name, graph->against, error)) return FALSE;
    }
    const TinkerSceneGraph *only = graphs->len == 1 ? g_ptr_array_index(graphs, 0) : NULL;
    if (only != NULL && only->title != NULL) {
        g_free(chart->title);
        chart->title = g_strdup(only->title);
    }
    return TRUE;
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

/* The places of a row that are written, in order: the time once, if any curve is over it. */
static GArray *csv_places(const TinkerChart *chart)
{
    GArray *places = g_array_new(FALSE, FALSE, sizeof(guint));
    for (guint i = 0; i < chart->curves->len; i++) {
        TinkerChartCurve curve = g_array_index(chart->curves, TinkerChartCurve, i);
        if (curve.x > 0 || i == 0) g_array_append_val(places, curve.x);
        g_array_append_val(places, curve.y);
    }
    return places;
}

static gboolean write_rows(TinkerCsvWriter *writer, const TinkerChart *chart, const GArray *places, GError **error)
{
    guint width = tinker_chart_width(chart);
    g_autofree double *rows = g_new(double, (gsize)ROWS_AT_ONCE *width);
    g_autofree double *factors = g_new(double, places->len);
    for (guint i = 0; i < places->len; i++)
        factors[i] = tinker_chart_axis(chart, g_array_index(places, guint, i)).per_si;
    gsize count = chart->record == NULL ? 0 : tinker_record_rows(chart->record);
    for (gsize first = 0; first < count; first += ROWS_AT_ONCE) {
        gsize some = MIN(ROWS_AT_ONCE, count - first);
        if (!tinker_record_read(chart->record, first, some, rows, error)) return FALSE;
        for (gsize row = 0; row < some; row++) {
            for (guint i = 0; i < places->len; i++)
                tinker_csv_number(writer, factors[i] * rows[row * width + g_array_index(places, guint, i)]);
            tinker_csv_end_row(writer);
        }
    }
    return TRUE;
}

gboolean tinker_chart_write_csv(TinkerChart *chart, int decimals, const char *path, GError **error)
{
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, path, error)) return FALSE;
    g_auto(TinkerCsvWriter) writer = tinker_csv_writer_graph(output.file, decimals);
    g_autoptr(GArray) places = csv_places(chart);
    for (guint i = 0; i < places->len; i++) {
        TinkerGraphAxis axis = tinker_chart_axis(chart, g_array_index(places, guint, i));
        tinker_csv_axis(&writer, chart->scene, &axis, chart->curves->len > 1, FALSE);
    }
    tinker_csv_end_row(&writer);
    if (!write_rows(&writer, chart, places, error)) return FALSE;
    return tinker_output_close(&output, error);
}
