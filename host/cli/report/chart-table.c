/* The columns that the curves need are looked for in the file's first line. */
#include "cli/report/chart-table.h"

#include <stdio.h>
#include <string.h>

#include "cli/report/chart-private.h"
#include "common/program/exit-status.h"
#include "units/waveform/table-columns.h"

/* The fields of a line of CSV. (transfer full) */
static GPtrArray *split(const char *line)
{
    GPtrArray *fields = g_ptr_array_new_with_free_func(g_free);
    GString *field = g_string_new(NULL);
    gboolean quoted = FALSE;
    for (const char *at = line; *at != '\0' && *at != '\n' && *at != '\r'; at++) {
        if (*at == '"' && quoted && at[1] == '"')
            g_string_append_c(field, *at++);
        else if (*at == '"')
            quoted = !quoted;
        else if (*at == ',' && !quoted) {
            g_ptr_array_add(fields, g_string_free(field, FALSE));
            field = g_string_new(NULL);
        } else
            g_string_append_c(field, *at);
    }
    g_ptr_array_add(fields, g_string_free(field, FALSE));
    return fields;
}

static GPtrArray *read_headings(const char *path, GError **error)
{
    g_autofree char *line = NULL;
    size_t room = 0;
    FILE *file = fopen(path, "re");
    gboolean read = file != NULL && getline(&line, &room, file) > 0;
    if (file != NULL) fclose(file);
    if (read) return split(line);
    g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE, "--with: %s cannot be read, or is empty", path);
    return NULL;
}

/* The number of the column "NAME [UNIT]". */
static int find_heading(const GPtrArray *headings, const char *name)
{
    const gsize length = strlen(name);
    for (guint i = 1; i < headings->len; i++) {
        const char *heading = g_ptr_array_index(headings, i);
        if (strncmp(heading, name, length) == 0 &&
            (heading[length] == '\0' || g_str_has_prefix(heading + length, " [")))
            return (int)i;
    }
    return -1;
}

static gboolean read_columns(TinkerChart *chart, const char *path, const GPtrArray *headings, GPtrArray *columns,
                             GError **error)
{
    for (guint c = 0; c < chart->columns->len; c++) {
        const char *name = g_array_index(chart->columns, TinkerColumn, c).name;
        const int number = find_heading(headings, name);
        GArray *rows = g_array_new(FALSE, FALSE, sizeof(double));
        g_ptr_array_add(columns, rows);
        if (number < 0) {
            g_set_error(error, TINKER_CLI_ERROR, TINKER_CLI_ERROR_USAGE,
                        "--with: %s has no column \"%s\" (record it with tinker run --columns \"%s\" --csv %s)", path,
                        name, name, path);
            return FALSE;
        }
        if (!tinker_table_read_column(path, 0, number, rows, error)) return FALSE;
    }
    return TRUE;
}

TinkerChart *tinker_chart_of_table(const TinkerChart *like, char **names, const char *against, const char *path,
                                   GError **error)
{
    g_autoptr(TinkerChart) chart = tinker_chart_new(like->scene);
    g_autoptr(GPtrArray) columns = g_ptr_array_new_with_free_func((GDestroyNotify)g_array_unref);
    for (char **name = names; *name != NULL; name++)
        if (!tinker_chart_add(chart, *name, against, error)) return NULL;
    g_autoptr(GPtrArray) headings = read_headings(path, error);
    if (headings == NULL || !read_columns(chart, path, headings, columns, error)) return NULL;
    g_autofree double *values = g_new0(double, columns->len + 1);
    const GArray *first = g_ptr_array_index(columns, 0);
    for (guint row = 0; row + 1 < first->len; row += 2) {
        for (guint c = 0; c < columns->len; c++)
            values[c] = g_array_index((const GArray *)g_ptr_array_index(columns, c), double, row + 1);
        if (!tinker_chart_sample(chart, g_array_index(first, double, row), values, NULL, error)) return NULL;
    }
    return g_steal_pointer(&chart);
}
