/* The record of a run, written as CSV while it runs. */
#include "cli/report/csv-record.h"

#include <string.h>

#include "units/quantity/units.h"

#define MOST_GATHERED 65536
#define LONGEST_WAIT  (G_USEC_PER_SEC / 5)

/* From here on the handler of crashes may write what is gathered. */
static void keep_rows(TinkerCsvRecord *record)
{
    record->rescue.text = record->writer.text->str;
    record->rescue.size = record->writer.text->len;
    tinker_crash_keep(&record->rescue);
}

static void end_row(TinkerCsvRecord *record)
{
    tinker_csv_end_row(&record->writer);
    keep_rows(record);
}

/* Hands what was gathered to the file. */
static void flush_rows(TinkerCsvRecord *record)
{
    GString *rows = record->writer.text;
    tinker_crash_change();
    tinker_output_lines(&record->output, rows->str, rows->len);
    g_string_truncate(rows, 0);
    keep_rows(record);
    record->flushed = g_get_monotonic_time();
}

static void open_rows(TinkerCsvRecord *record)
{
    record->writer = tinker_csv_writer_record(NULL);
    // Room for all that is gathered and a long row: while text moves to a larger place, the handler cannot write it.
    g_string_set_size(record->writer.text, 2 * MOST_GATHERED);
    g_string_truncate(record->writer.text, 0);
    record->rescue.name = record->output.name;
    record->rescue.file = record->output.descriptor;
    record->flushed = g_get_monotonic_time();
}

static void close_rows(TinkerCsvRecord *record)
{
    if (record->writer.text == NULL) return;
    flush_rows(record);
    tinker_crash_keep(NULL);
    tinker_csv_writer_clear(&record->writer);
}

gboolean tinker_csv_record_open(TinkerCsvRecord *record, const char *path, const GArray *columns, GError **error)
{
    if (!tinker_output_open(&record->output, path, error)) return FALSE;
    open_rows(record);
    record->columns = columns->len;
    record->last_time = 0;
    tinker_csv_text(&record->writer, "time [s]");
    for (guint i = 0; i < columns->len; i++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, i);
        g_autofree char *heading =
            g_strdup_printf("%s [%s]", column->name, column->unit[0] != '\0' ? column->unit : "1");
        tinker_csv_text(&record->writer, heading);
    }
    end_row(record);
    return TRUE;
}

static gboolean write_row(TinkerCsvRecord *record, double time, const double *values, GError **error)
{
    tinker_crash_change();
    tinker_csv_number(&record->writer, time);
    for (guint i = 0; i < record->columns; i++)
        tinker_csv_number(&record->writer, values[i]);
    end_row(record);
    record->last_time = time;
    const gboolean many = record->writer.text->len >= MOST_GATHERED;
    if (many || g_get_monotonic_time() - record->flushed >= LONGEST_WAIT) flush_rows(record);
    return tinker_output_check(&record->output, error);
}

static gboolean hold_row(TinkerCsvRecord *record, double time, const double *values, GError **error)
{
    g_autofree double *row = g_new(double, record->columns + 1);
    row[0] = time;
    if (record->columns > 0) memcpy(row + 1, values, record->columns * sizeof(double));
    return tinker_record_append(record->held, row, error);
}

static gboolean write_held_rows(TinkerCsvRecord *record, GError **error)
{
    gsize rows = record->held != NULL ? tinker_record_rows(record->held) : 0;
    g_autofree double *row = g_new(double, record->columns + 1);
    for (gsize i = 0; i < rows; i++)
        if (!tinker_record_read(record->held, i, 1, row, error) || !write_row(record, row[0], row + 1, error))
            return FALSE;
    return TRUE;
}

void tinker_csv_record_hold(TinkerCsvRecord *record)
{
    record->held = tinker_record_new(record->columns + 1, 0);
}

void tinker_csv_record_begin_again(TinkerCsvRecord *record)
{
    if (record->held != NULL) tinker_record_cut(record->held, 0);
}

gboolean tinker_csv_record_add(TinkerCsvRecord *record, double time, const double *values, GError **error)
{
    return record->held != NULL ? hold_row(record, time, values, error) : write_row(record, time, values, error);
}

gboolean tinker_csv_record_close(TinkerCsvRecord *record, double valid_until, GError **error)
{
    if (!write_held_rows(record, error)) {
        tinker_csv_record_clear(record);
        return FALSE;
    }
    close_rows(record);
    if (record->output.file != NULL && valid_until < record->last_time) {
        char number[32];
        tinker_number_to_text(valid_until, number, sizeof number);
        g_autofree char *text = g_strdup_printf("# invalid from t = %s\n", number);
        tinker_output_lines(&record->output, text, strlen(text));
    }
    return tinker_output_close(&record->output, error);
}

void tinker_csv_record_clear(TinkerCsvRecord *record)
{
    close_rows(record);
    g_clear_pointer(&record->held, tinker_record_free);
    tinker_output_clear(&record->output);
}
