/* Charts as CSV. */
#include "cli/command/output.h"
#include "cli/report/chart-private.h"

#define ROWS_AT_ONCE ((gsize)1024)

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
