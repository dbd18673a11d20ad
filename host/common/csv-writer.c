/* CSV by RFC 4180. Write errors stay with the stream, whose owner asks for them. */
#include "csv-writer.h"

#include <math.h>
#include <string.h>

TinkerCsvWriter tinker_csv_writer_record(FILE *file)
{
    return (TinkerCsvWriter){.file = file, .digits = 17, .signed_zero = TRUE};
}

TinkerCsvWriter tinker_csv_writer_graph(FILE *file, int decimals)
{
    return (TinkerCsvWriter){.file = file, .digits = decimals < 0 ? 9 : 0, .decimals = decimals};
}

static void begin_field(TinkerCsvWriter *writer)
{
    if (writer->row_begun) fputc(',', writer->file);
    writer->row_begun = TRUE;
}

void tinker_csv_text(TinkerCsvWriter *writer, const char *text)
{
    begin_field(writer);
    if (strpbrk(text, ",\"\r\n") == NULL) {
        fputs(text, writer->file);
        return;
    }
    fputc('"', writer->file);
    for (const char *character = text; *character != '\0'; character++) {
        if (*character == '"') fputc('"', writer->file);
        fputc(*character, writer->file);
    }
    fputc('"', writer->file);
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
        fputs(isnan(value) ? "nan" : value > 0 ? "inf" : "-inf", writer->file);
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
    fputs(shown, writer->file);
}

void tinker_csv_end_row(TinkerCsvWriter *writer)
{
    fputc('\n', writer->file);
    writer->row_begun = FALSE;
}
