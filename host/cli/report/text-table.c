/* Tables for people. Widths count characters, not bytes. */
#include "cli/report/text-table.h"
#include "common/program/print.h"
#include "units/quantity/plain-text.h"

#include <stdarg.h>
#include <string.h>

struct _TinkerTextTable {
    char *alignments;
    guint columns;
    int indent;
    GPtrArray *cells; /* of char *, row by row */
};

TinkerTextTable *tinker_text_table_new(const char *alignments, int indent)
{
    TinkerTextTable *table = g_new0(TinkerTextTable, 1);
    table->alignments = g_strdup(alignments);
    table->columns = (guint)strlen(alignments);
    table->indent = indent;
    table->cells = g_ptr_array_new_with_free_func(g_free);
    return table;
}

void tinker_text_table_free(TinkerTextTable *table)
{
    if (table == NULL) return;
    g_free(table->alignments);
    g_ptr_array_unref(table->cells);
    g_free(table);
}

void tinker_text_table_add(TinkerTextTable *table, const char *text)
{
    g_ptr_array_add(table->cells,
                    tinker_text_escaped(text == NULL ? "" : text, FALSE)); /* what is printed is measured */
}

void tinker_text_table_add_format(TinkerTextTable *table, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_autofree char *text = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    tinker_text_table_add(table, text);
}

void tinker_text_table_end_row(TinkerTextTable *table)
{
    while (table->cells->len % table->columns != 0)
        tinker_text_table_add(table, "");
}

static int cell_width(const TinkerTextTable *table, guint cell)
{
    return (int)g_utf8_strlen(g_ptr_array_index(table->cells, cell), -1);
}

static void append_row(const TinkerTextTable *table, guint first, const int *widths, GString *line)
{
    g_string_append_printf(line, "%*s", table->indent, "");
    for (guint c = 0; c < table->columns; c++) {
        int padding = widths[c] - cell_width(table, first + c);
        gboolean right = table->alignments[c] == 'r';
        if (c > 0) g_string_append(line, "  ");
        g_string_append_printf(line, "%*s%s%*s", right ? padding : 0, "",
                               (const char *)g_ptr_array_index(table->cells, first + c), right ? 0 : padding, "");
    }
}

void tinker_text_table_write(const TinkerTextTable *table, FILE *file)
{
    g_autofree int *widths = g_new0(int, table->columns);
    for (guint cell = 0; cell < table->cells->len; cell++)
        widths[cell % table->columns] = MAX(widths[cell % table->columns], cell_width(table, cell));
    for (guint first = 0; first + table->columns <= table->cells->len; first += table->columns) {
        g_autoptr(GString) line = g_string_new(NULL);
        append_row(table, first, widths, line);
        tinker_print_line(file, "%s", g_strchomp(line->str));
    }
}
