/* A small reader for the program's own CSV: the names in it hold no commas. */
#include "table.h"

#include <math.h>
#include <string.h>

static void read_header(TestTable *table, const char *line)
{
    table->names = g_strsplit(line, ",", -1);
    table->columns = g_strv_length(table->names);
    for (char **name = table->names; *name != NULL; name++) {
        char *unit = strrchr(*name, '[');
        if (unit != NULL && unit > *name) unit[-1] = '\0';
    }
    g_assert_cmpstr(table->names[0], ==, "time");
}

static void read_row(const char *line, gsize columns, double *values)
{
    const char *place = line;
    for (gsize c = 0; c < columns; c++) {
        char *end = NULL;
        values[c] = g_ascii_strtod(place, &end);
        if (end == place || !isfinite(values[c]) || *end != (c + 1 < columns ? ',' : '\0'))
            g_error("the record has a line that is no row of %" G_GSIZE_FORMAT " numbers: %s", columns, line);
        place = end + 1;
    }
}

static gssize find_column(const TestTable *table, const char *column)
{
    for (gsize c = 0; c < table->columns; c++)
        if (strcmp(table->names[c], column) == 0) return (gssize)c;
    return -1;
}

TestTable *test_table_new(const char *text)
{
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    TestTable *table = g_new0(TestTable, 1);
    g_assert_nonnull(lines[0]);
    read_header(table, lines[0]);
    table->values = g_new(double, g_strv_length(lines) * table->columns);
    for (char **line = lines + 1; *line != NULL && **line != '\0'; line++)
        read_row(*line, table->columns, table->values + table->rows++ * table->columns);
    return table;
}

void test_table_free(TestTable *table)
{
    g_strfreev(table->names);
    g_free(table->values);
    g_free(table);
}

gboolean test_table_has(const TestTable *table, const char *column)
{
    return find_column(table, column) >= 0;
}

double test_table_value(const TestTable *table, gsize row, const char *column)
{
    const gssize c = find_column(table, column);
    if (c < 0) g_error("the record has no column \"%s\"", column);
    g_assert_cmpuint(row, <, table->rows);
    return table->values[row * table->columns + (gsize)c];
}

gsize test_table_row(const TestTable *table, double time)
{
    for (gsize row = 0; row < table->rows; row++)
        if (fabs(table->values[row * table->columns] - time) <= 1e-12 * fmax(1.0, fabs(time))) return row;
    g_error("the record has no sample at t = %.17g", time);
}
