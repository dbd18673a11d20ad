/* The record of a run, written as CSV while it runs. */
#include "csv-record.h"

#include <errno.h>
#include <stdlib.h>

#include "exit-status.h"
#include "units/units.h"

#define MOST_GATHERED 65536
#define LONGEST_WAIT  (G_USEC_PER_SEC / 5)

/* From here on the handler of crashes may write what is gathered. */
static void keep_rows(TinkerCsvRecord *record)
{
    fflush(record->rows);
    record->rescue.text = record->text;
    record->rescue.size = record->size;
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
    tinker_crash_change();
    fflush(record->rows);
    tinker_output_flush(&record->output, record->text, record->size);
    rewind(record->rows);
    keep_rows(record);
    record->flushed = g_get_monotonic_time();
}

static gboolean open_rows(TinkerCsvRecord *record, GError **error)
{
    record->rows = open_memstream(&record->text, &record->size);
    if (record->rows == NULL) {
        g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_FILE, "%s: no memory to gather rows in: %s",
                    record->output.name, g_strerror(errno));
        return FALSE;
    }
    record->rescue.name = record->output.name;
    record->rescue.file = fileno(record->output.file);
    record->flushed = g_get_monotonic_time();
    return TRUE;
}

static void close_rows(TinkerCsvRecord *record)
{
    if (record->rows == NULL) return;
    flush_rows(record);
    tinker_crash_keep(NULL);
    fclose(record->rows);
    free(record->text);
    record->rows = NULL;
    record->text = NULL;
}

gboolean tinker_csv_record_open(TinkerCsvRecord *record, const char *path, const char *scene_path,
                                const GArray *columns, GError **error)
{
    if (!tinker_output_open(&record->output, path, scene_path, error)) return FALSE;
    if (!open_rows(record, error)) return FALSE;
    record->writer = tinker_csv_writer_record(record->rows);
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
    if (record->size >= MOST_GATHERED || g_get_monotonic_time() - record->flushed >= LONGEST_WAIT) flush_rows(record);
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
