/* CSV by RFC 4180, row by row: fields are separated by commas, lines end with LF, '.' is the decimal point whatever the
 * locale. */
#ifndef TINKER_COMMON_CSV_WRITER_H
#define TINKER_COMMON_CSV_WRITER_H

#include <stdio.h>

#include <glib.h>

typedef struct {
    FILE *file;      /* borrowed; takes each row when it ends; NULL: rows stay in `text` */
    GString *text;   /* the row that has begun, or all */
    gboolean failed; /* whether the file has not taken all of a row; streams into memory do not tell later */
    gboolean row_begun;
    int digits;           /* significant ones of numbers; 0: see decimals */
    int decimals;         /* behind the point, trailing zeros dropped */
    gboolean signed_zero; /* whether "-0" is written, so that numbers read back to the same bits */
} TinkerCsvWriter;

/* A record: 17 significant digits, which read back to the same bits. Without a file (NULL) all rows stay in `text`. To
 * be cleared, as the other. */
TinkerCsvWriter tinker_csv_writer_record(FILE *file);

/* A graph's values: `decimals` digits behind the point, trailing zeros dropped; 9 significant digits where it is
 * negative. */
TinkerCsvWriter tinker_csv_writer_graph(FILE *file, int decimals);

/* Frees the text; a row that has begun is dropped. */
void tinker_csv_writer_clear(TinkerCsvWriter *writer);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(TinkerCsvWriter, tinker_csv_writer_clear)

/* A field. Text is quoted where it needs to be. NaN and infinities are written as nan, inf and -inf. */
void tinker_csv_text(TinkerCsvWriter *writer, const char *text);
void tinker_csv_number(TinkerCsvWriter *writer, double value);

void tinker_csv_end_row(TinkerCsvWriter *writer);

#endif
