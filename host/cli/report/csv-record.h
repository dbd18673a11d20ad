/* The record of a run, written as CSV while it runs.
 *
 * Rows are gathered and go to the file some at a time: when 64 KiB have come together, or 0.2 s after those before.
 * What is in the file always ends with a whole row. What is not yet there when a plugin crashes is written by the
 * handler (plugin/crash.h), so that no row is lost then; a process that is killed from outside loses the last 0.2 s. */
#ifndef TINKER_CLI_CSV_RECORD_H
#define TINKER_CLI_CSV_RECORD_H

#include "cli/command/output.h"
#include "common/program/csv-writer.h"
#include "physics/record/record.h"
#include "physics/run/simulation.h"
#include "plugin/call/crash.h"

typedef struct {
    TinkerOutput output;
    TinkerCsvWriter writer; /* gathers rows in memory */
    guint columns;
    double last_time;   /* of the rows written */
    TinkerRecord *held; /* rows of a run that may begin again; NULL: they go to the file as they come */
    gint64 flushed;     /* µs, monotonic: when rows last went to the file */
    TinkerCrashRecord rescue;
} TinkerCsvRecord;

/* Opens the file and writes the header: "time [s]", then "NAME.QUANTITY [UNIT]" of every column. */
gboolean tinker_csv_record_open(TinkerCsvRecord *record, const char *path, const GArray *columns, GError **error);

/* From here on rows are held back until the record is closed, as the run may begin again: nothing of a try that is
 * thrown away is ever in the file. They are lost where a plugin crashes. */
void tinker_csv_record_hold(TinkerCsvRecord *record);

/* Forgets all rows that are held back. */
void tinker_csv_record_begin_again(TinkerCsvRecord *record);

/* Writes one row, or holds it back; stops the run where the file takes no more. */
gboolean tinker_csv_record_add(TinkerCsvRecord *record, double time, const double *values, GError **error);

/* Closes the file. Rows later than `valid_until` have been written already, so a last line says that they are not to be
 * believed. */
gboolean tinker_csv_record_close(TinkerCsvRecord *record, double valid_until, GError **error);

void tinker_csv_record_clear(TinkerCsvRecord *record);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerCsvRecord, tinker_csv_record_clear)

#endif
