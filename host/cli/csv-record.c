/* The record of a run, written as CSV while it runs. */
#include "csv-record.h"

#include "units/units.h"

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

/* Hands what was gathered to the file, and the file's own buffer to the system. */
static void flush_rows(TinkerCsvRecord *record)
{
    GString *rows = record->writer.text;
    tinker_crash_change();
    tinker_output_flush(&record->output, rows->str, rows->len);
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
    record->rescue.file = fileno(record->output.file);
    record->flushed = g_get_monotonic_time();
}

static void close_rows(TinkerCsvRecord *record)
{
    if (record->writer.text == NULL) return;
    flush_rows(record);
    tinker_crash_keep(NULL);
    tinker_csv_writer_clear(&record->writer);
}

gboolean tinker_csv_record_open(TinkerCsvRecord *record, const char *path, const char *scene_path,
                                const GArray *columns, GError **error)
{
    if (!tinker_output_open(&record->output, path, scene_path, error)) return FALSE;
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

gboolean tinker_csv_record_add(TinkerCsvRecord *record, double time, const double *values, GError **error)
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

gboolean tinker_csv_record_close(TinkerCsvRecord *record, double valid_until, GError **error)
{
    close_rows(record);
    if (record->output.file != NULL && valid_until < record->last_time) {
        char text[32];
        tinker_number_to_text(valid_until, text, sizeof text);
        fprintf(record->output.file, "# invalid from t = %s\n", text);
    }
    return tinker_output_close(&record->output, error);
}

void tinker_csv_record_clear(TinkerCsvRecord *record)
{
    close_rows(record);
    tinker_output_clear(&record->output);
}
