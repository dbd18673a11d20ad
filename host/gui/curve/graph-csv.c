/* The values of a graph as a table: rows of the time and the curves over it, and beside them what has times of its own.
 */
#include <glib/gi18n.h>
#include <stdio.h>
#include <stdlib.h>

#include "files/replace-file.h"
#include "gui/curve/graph-data.h"

/* One column of the table. */
typedef struct {
    const TinkerGraphSeries *series;
    gboolean is_x;
    const char *run; /* NULL: the present one */
    gsize next;      /* point that is written next: samples alone are */
} Column;

/* (transfer full) */
static GArray *columns_of(const TinkerGraphData *data)
{
    GArray *columns = g_array_new(FALSE, FALSE, sizeof(Column));
    for (guint i = 0; i < tinker_graph_data_curves(data); i++) {
        const TinkerGraphSeries *series = tinker_graph_data_curve(data, i);
        const Column x = {series, TRUE, NULL, 0}, y = {series, FALSE, tinker_graph_data_run(data, i), 0};
        const gboolean own_times = tinker_graph_series_is_table(series) || !tinker_graph_data_is_over_time(data) ||
                                   tinker_graph_data_begins_run(data, i);
        if (i == 0 || own_times) g_array_append_val(columns, x);
        g_array_append_val(columns, y);
    }
    return columns;
}

/* As the command line writes them: of another run "Mass 0.y (Run 1)". */
static void write_heading(TinkerCsvWriter *writer, const TinkerGraphData *data, const Column *column, gboolean several)
{
    const TinkerScene *scene = tinker_document_scene(tinker_graph_data_document(data));
    const TinkerGraphSeries *series = column->series;
    const char *block = tinker_graph_series_block(series), *symbol = tinker_graph_series_symbol(series);
    if (column->run == NULL) {
        tinker_csv_axis(writer, scene,
                        column->is_x ? tinker_graph_series_x_axis(series) : tinker_graph_series_y_axis(series),
                        several);
        return;
    }
    g_autofree char *name = block[0] != '\0' ? g_strdup_printf("%s.%s (%s)", block, symbol, column->run)
                                             : g_strdup_printf("%s (%s)", symbol, column->run);
    tinker_csv_text(writer, name);
}

static gboolean any_left(const GArray *columns)
{
    for (guint k = 0; k < columns->len; k++) {
        const Column *column = &g_array_index(columns, Column, k);
        if (tinker_graph_series_sample_from(column->series, column->next) < tinker_graph_series_count(column->series))
            return TRUE;
    }
    return FALSE;
}

static void write_cell(TinkerCsvWriter *writer, Column *column)
{
    const gsize point = tinker_graph_series_sample_from(column->series, column->next);
    if (point >= tinker_graph_series_count(column->series))
        tinker_csv_text(writer, "");
    else
        tinker_csv_number(writer, column->is_x ? tinker_graph_series_x(column->series)[point]
                                               : tinker_graph_series_y(column->series)[point]);
    column->next = point + 1;
}

static void write_rows(const TinkerGraphData *data, TinkerCsvWriter *writer)
{
    const gboolean several = tinker_graph_data_own_curves(data) > 1;
    g_autoptr(GArray) columns = columns_of(data);
    for (guint k = 0; k < columns->len; k++)
        write_heading(writer, data, &g_array_index(columns, Column, k), several);
    tinker_csv_end_row(writer);
    while (any_left(columns)) {
        for (guint k = 0; k < columns->len; k++)
            write_cell(writer, &g_array_index(columns, Column, k));
        tinker_csv_end_row(writer);
    }
}

gboolean tinker_graph_data_check_output(const TinkerGraphData *data, const char *path, GError **error)
{
    g_autoptr(TinkerFileSet) files = tinker_document_files(tinker_graph_data_document(data));
    return tinker_file_set_add_output(files, NULL, path, error);
}

gboolean tinker_graph_data_write_csv(TinkerGraphData *data, const char *path, int decimals, GError **error)
{
    if (!tinker_graph_data_check_output(data, path, error)) return FALSE;
    char *text = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&text, &length);
    gboolean done = FALSE;
    if (stream != NULL) {
        g_auto(TinkerCsvWriter) writer = tinker_csv_writer_graph(stream, decimals);
        write_rows(data, &writer);
        done = fclose(stream) == 0 && !writer.failed;
    }
    if (done && !tinker_replace_file(path, text, length, 0666, error)) {
        done = FALSE;
        g_prefix_error(error, "%s: ", path);
    } else if (!done) {
        g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_NOMEM, _("there is no memory to write %zu rows"),
                    tinker_graph_data_count(data));
    }
    free(text);
    return done;
}
