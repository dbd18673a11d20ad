/* The record of a run, written as CSV while it runs. */
#include "csv-record.h"

#include "units/units.h"

gboolean tinker_csv_record_open(TinkerCsvRecord *record, const char *path, const char *scene_path,
                                const GArray *columns, GError **error)
{
    if (!tinker_output_open(&record->output, path, scene_path, error)) return FALSE;
    record->writer = tinker_csv_writer_record(record->output.file);
    record->columns = columns->len;
    record->last_time = 0;
    tinker_csv_text(&record->writer, "time [s]");
    for (guint i = 0; i < columns->len; i++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, i);
        g_autofree char *heading =
            g_strdup_printf("%s [%s]", column->name, column->unit[0] != '\0' ? column->unit : "1");
        tinker_csv_text(&record->writer, heading);
    }
    tinker_csv_end_row(&record->writer);
    return TRUE;
}

gboolean tinker_csv_record_add(TinkerCsvRecord *record, double time, const double *values, GError **error)
{
    tinker_csv_number(&record->writer, time);
    for (guint i = 0; i < record->columns; i++)
        tinker_csv_number(&record->writer, values[i]);
    tinker_csv_end_row(&record->writer);
    record->last_time = time;
    return tinker_output_check(&record->output, error);
}

gboolean tinker_csv_record_close(TinkerCsvRecord *record, double valid_until, GError **error)
{
    if (record->output.file != NULL && valid_until < record->last_time) {
        char text[32];
        tinker_number_to_text(valid_until, text, sizeof text);
        fprintf(record->output.file, "# invalid from t = %s\n", text);
    }
    return tinker_output_close(&record->output, error);
}

void tinker_csv_record_clear(TinkerCsvRecord *record)
{
    tinker_output_clear(&record->output);
}
