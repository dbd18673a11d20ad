/* Charts: which curves, and their values as CSV. */
#include "cli/report/chart-private.h"

#include <string.h>

#include "units/waveform/table-columns.h"

#include "cli/command/output.h"
#include "common/program/exit-status.h"

#define ROWS_AT_ONCE ((gsize)1024)

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

/* CSV -------------------------------------------------------------------------------------------------------------- */

/* One column of the file. */
typedef struct {
    const TinkerChart *chart;      /* of this run */
    const TinkerChartCurve *curve; /* NULL: the time; */
    guint place;                   /* else where this is not 0 what it is drawn against */
    gboolean times;                /* of the curve's own table */
} CsvColumn;

static gsize rows_of(const CsvColumn *column)
{
    if (column->curve != NULL && column->curve->table != NULL) return column->curve->table->len / 2;
    return column->chart->record == NULL ? 0 : tinker_record_rows(column->chart->record);
}

static void add_csv_columns(const TinkerChart *chart, GArray *columns)
{
    for (guint i = 0; i < chart->curves->len; i++) {
        const TinkerChartCurve *curve = &g_array_index(chart->curves, TinkerChartCurve, i);
        CsvColumn x = {chart, curve->table != NULL ? curve : NULL, curve->x, curve->table != NULL},
                  y = {chart, curve, 0, FALSE};
        if (curve->x > 0 || x.times || i == 0) g_array_append_val(columns, x);
        g_array_append_val(columns, y);
    }
}

/* The columns that are written, in order: the time once for each run, if any curve is over it. (transfer full) */
static GArray *csv_columns(const TinkerChart *chart)
{
    GArray *columns = g_array_new(FALSE, FALSE, sizeof(CsvColumn));
    add_csv_columns(chart, columns);
    for (guint i = 0; i < chart->others->len; i++)
        add_csv_columns(g_ptr_array_index(chart->others, i), columns);
    return columns;
}

static TinkerGraphAxis csv_axis(const CsvColumn *column)
{
    if (column->times) return tinker_graph_axis_time();
    return column->curve != NULL ? column->curve->axis : tinker_chart_axis(column->chart, column->place);
}

/* Cells of the rows from `first` on; nothing where a run has no such row. */
static gboolean read_cells(const CsvColumn *column, gsize first, gsize count, double *rows, double *cells,
                           GError **error)
{
    const TinkerChartCurve *curve = column->curve;
    const double per_si = csv_axis(column).per_si;
    const gsize have = rows_of(column), some = first < have ? MIN(count, have - first) : 0;
    const guint width = tinker_chart_width(column->chart);
    const gboolean table = curve != NULL && curve->table != NULL;
    if (!table && some > 0 && !tinker_record_read(column->chart->record, first, some, rows, error)) return FALSE;
    for (gsize i = 0; i < some; i++) {
        if (table)
            cells[i] = per_si * g_array_index(curve->table, double, 2 * (first + i) + !column->times);
        else
            cells[i] = per_si *
                       (curve != NULL ? tinker_chart_value(curve, rows + i * width) : rows[i * width + column->place]);
    }
    return TRUE;
}

static gboolean write_rows(TinkerCsvWriter *writer, const GArray *columns, GError **error)
{
    gsize count = 0;
    guint width = 0;
    for (guint c = 0; c < columns->len; c++) {
        const CsvColumn *column = &g_array_index(columns, CsvColumn, c);
        count = MAX(count, rows_of(column));
        width = MAX(width, tinker_chart_width(column->chart));
    }
    g_autofree double *rows = g_new(double, (gsize)ROWS_AT_ONCE *width);
    g_autofree double *cells = g_new(double, (gsize)ROWS_AT_ONCE * columns->len);
    for (gsize first = 0; first < count; first += ROWS_AT_ONCE) {
        for (guint c = 0; c < columns->len; c++)
            if (!read_cells(&g_array_index(columns, CsvColumn, c), first, ROWS_AT_ONCE, rows, cells + c * ROWS_AT_ONCE,
                            error))
                return FALSE;
        for (gsize row = 0; row < MIN(ROWS_AT_ONCE, count - first); row++) {
            for (guint c = 0; c < columns->len; c++)
                if (first + row < rows_of(&g_array_index(columns, CsvColumn, c)))
                    tinker_csv_number(writer, cells[c * ROWS_AT_ONCE + row]);
                else
                    tinker_csv_text(writer, "");
            tinker_csv_end_row(writer);
        }
    }
    return TRUE;
}

static void write_heading(TinkerCsvWriter *writer, const TinkerChart *chart, const CsvColumn *column)
{
    TinkerGraphAxis axis = csv_axis(column);
    if (column->chart->run == NULL || column->curve == NULL) {
        tinker_csv_axis(writer, chart->scene, &axis, chart->curves->len > 1);
        return;
    }
    g_autofree char *heading = g_strdup_printf("%s (%s)", column->curve->name, column->chart->run);
    tinker_csv_text(writer, heading);
}

gboolean tinker_chart_write_csv(TinkerChart *chart, int decimals, const char *path, GError **error)
{
    g_auto(TinkerOutput) output = {0};
    if (!tinker_output_open(&output, path, error)) return FALSE;
    g_auto(TinkerCsvWriter) writer = tinker_csv_writer_graph(output.file, decimals);
    g_autoptr(GArray) columns = csv_columns(chart);
    for (guint c = 0; c < columns->len; c++)
        write_heading(&writer, chart, &g_array_index(columns, CsvColumn, c));
    tinker_csv_end_row(&writer);
    if (!write_rows(&writer, columns, error)) return FALSE;
    return tinker_output_close(&output, error);
}
