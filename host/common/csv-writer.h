/* CSV by RFC 4180, streamed: fields are separated by commas, lines end with LF, '.' is the decimal point whatever the
 * locale. */
#ifndef TINKER_COMMON_CSV_WRITER_H
#define TINKER_COMMON_CSV_WRITER_H

#include <stdio.h>

#include <glib.h>

typedef struct {
    FILE *file; /* borrowed; buffered by the C library */
    gboolean row_begun;
    int digits;           /* significant ones of numbers; 0: see decimals */
    int decimals;         /* behind the point, trailing zeros dropped */
    gboolean signed_zero; /* whether "-0" is written, so that numbers read back to the same bits */
} TinkerCsvWriter;

/* A record: 17 significant digits, which read back to the same bits. */
TinkerCsvWriter tinker_csv_writer_record(FILE *file);

/* A graph's values: `decimals` digits behind the point, trailing zeros dropped; 9 significant digits where it is
 * negative. */
TinkerCsvWriter tinker_csv_writer_graph(FILE *file, int decimals);

/* A field. Text is quoted where it needs to be. NaN and infinities are written as nan, inf and -inf. */
void tinker_csv_text(TinkerCsvWriter *writer, const char *text);
void tinker_csv_number(TinkerCsvWriter *writer, double value);

void tinker_csv_end_row(TinkerCsvWriter *writer);

#endif
