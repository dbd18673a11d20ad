/* Writing and reading the net's table; see the header. */
#include "net-table.h"

#include <string.h>

const char *const net_column_names[] = {"scene",   "method", "status",      "samples", "record", "estimate",
                                        "summary", "steps",  "evaluations", "message", NULL};

G_STATIC_ASSERT(G_N_ELEMENTS(net_column_names) == NET_COLUMNS + 1);

GPtrArray *net_table_new(void)
{
    return g_ptr_array_new_with_free_func((GDestroyNotify)g_strfreev);
}

void net_table_add(GPtrArray *table, const char *const *fields)
{
    char **line = g_strdupv((char **)fields);
    g_strdelimit(line[NET_MESSAGE], "\t\r\n", ' ');
    g_ptr_array_add(table, line);
}

int net_line_compare(char *const *left, char *const *right)
{
    const int scenes = strcmp(left[NET_SCENE], right[NET_SCENE]);
    return scenes != 0 ? scenes : strcmp(left[NET_METHOD], right[NET_METHOD]);
}

static int compare_entries(gconstpointer left, gconstpointer right)
{
    return net_line_compare(*(char **const *)left, *(char **const *)right);
}

void net_table_sort(GPtrArray *table)
{
    g_ptr_array_sort(table, compare_entries);
}

char *net_table_to_text(const GPtrArray *table)
{
    GString *text = g_string_new(NULL);
    for (guint i = 0; i < table->len; i++) {
        g_autofree char *line = g_strjoinv("\t", g_ptr_array_index(table, i));
        g_string_append_printf(text, "%s\n", line);
    }
    return g_string_free(text, FALSE);
}

gboolean net_table_add_text(GPtrArray *table, const char *text, GError **error)
{
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    for (char **line = lines; *line != NULL; line++) {
        if (**line == '\0') continue;
        g_auto(GStrv) fields = g_strsplit(*line, "\t", -1);
        if (g_strv_length(fields) != NET_COLUMNS) {
            g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%u columns in \"%s\" (there must be %d)",
                        g_strv_length(fields), *line, NET_COLUMNS);
            return FALSE;
        }
        net_table_add(table, (const char *const *)fields);
    }
    return TRUE;
}

gboolean net_table_write(const GPtrArray *table, const char *path, GError **error)
{
    g_autofree char *lines = net_table_to_text(table), *names = g_strjoinv("\t", (char **)net_column_names);
    g_autofree char *whole = g_strdup_printf("%s\n%s", names, lines);
    return g_file_set_contents(path, whole, -1, error);
}

GPtrArray *net_table_read(const char *path, GError **error)
{
    g_autoptr(GPtrArray) table = net_table_new();
    g_autofree char *text = NULL;
    if (!g_file_get_contents(path, &text, NULL, error)) return NULL;
    const char *behind_heading = strchr(text, '\n');
    if (behind_heading == NULL || !net_table_add_text(table, behind_heading + 1, error)) {
        g_prefix_error(error, "%s is no table of the net: ", path);
        if (error != NULL && *error == NULL)
            g_set_error(error, G_FILE_ERROR, G_FILE_ERROR_INVAL, "%s is no table of the net: it has no heading", path);
        return NULL;
    }
    net_table_sort(table);
    return g_steal_pointer(&table);
}
