/* CSV by RFC 4180. */
#include "common/program/csv-writer.h"

#include <math.h>
#include <string.h>

TinkerCsvWriter tinker_csv_writer_record(FILE *file)
{
    return (TinkerCsvWriter){.file = file, .text = g_string_new(NULL), .digits = 17, .signed_zero = TRUE};
}

TinkerCsvWriter tinker_csv_writer_graph(FILE *file, int decimals)
{
    return (TinkerCsvWriter){
        .file = file, .text = g_string_new(NULL), .digits = decimals < 0 ? 9 : 0, .decimals = decimals};
}

void tinker_csv_writer_clear(TinkerCsvWriter *writer)
{
    if (writer->text != NULL) g_string_free(writer->text, TRUE);
    writer->text = NULL;
}

static void begin_field(TinkerCsvWriter *writer)
{
    if (writer->row_begun) g_string_append_c(writer->text, ',');
    writer->row_begun = TRUE;
}

void tinker_csv_text(TinkerCsvWriter *writer, const char *text)
{
    begin_field(writer);
    if (strpbrk(text, ",\"\r\n") == NULL) {
        g_string_append(writer->text, text);
        return;
    }
    g_string_append_c(writer->text, '"');
    for (const char *character = text; *character != '\0'; character++) {
        if (*character == '"') g_string_append_c(writer->text, '"');
        g_string_append_c(writer->text, *character);
    }
    g_string_append_c(writer->text, '"');
}

static void drop_trailing_zeros(char *text)
{
    if (strchr(text, '.') == NULL) return;
    char *end = text + strlen(text);
    while (end[-1] == '0')
        end--;
    if (end[-1] == '.') end--;
    *end = '\0';
}

void tinker_csv_number(TinkerCsvWriter *writer, double value)
{
    begin_field(writer);
    if (!isfinite(value)) {
        g_string_append(writer->text, isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
        return;
    }
    /* room for the longest double with the most decimals that an option allows */
    char format[8], text[400];
    if (writer->digits > 0) {
        g_snprintf(format, sizeof format, "%%.%dg", writer->digits);
        g_ascii_formatd(text, sizeof text, format, value);
    } else {
        g_snprintf(format, sizeof format, "%%.%df", writer->decimals);
        g_ascii_formatd(text, sizeof text, format, value);
        drop_trailing_zeros(text);
    }
    const char *shown = !writer->signed_zero && strcmp(text, "-0") == 0 ? "0" : text;
    g_string_append(writer->text, shown);
}

void tinker_csv_end_row(TinkerCsvWriter *writer)
{
    g_string_append_c(writer->text, '\n');
    writer->row_begun = FALSE;
    if (writer->file == NULL) return;
    if (fwrite(writer->text->str, 1, writer->text->len, writer->file) != writer->text->len) writer->failed = TRUE;
    g_string_truncate(writer->text, 0);
}
