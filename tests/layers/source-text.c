/* A tokenizer for as much of C as these questions need: comments, character constants, string literals, include lines.
 */
#include "source-text.h"

#include <string.h>

static gint compare_paths(gconstpointer a, gconstpointer b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

static void collect(const char *root, const char *inside, GPtrArray *files)
{
    g_autofree char *folder = g_build_filename(root, inside, NULL);
    g_autoptr(GDir) dir = g_dir_open(folder, 0, NULL);
    if (dir == NULL) return;
    for (const char *name = g_dir_read_name(dir); name != NULL; name = g_dir_read_name(dir)) {
        g_autofree char *relative = inside[0] != '\0' ? g_build_filename(inside, name, NULL) : g_strdup(name);
        g_autofree char *path = g_build_filename(root, relative, NULL);
        if (g_file_test(path, G_FILE_TEST_IS_DIR))
            collect(root, relative, files);
        else if (g_str_has_suffix(name, ".c") || g_str_has_suffix(name, ".h"))
            g_ptr_array_add(files, g_steal_pointer(&relative));
    }
}

/* Where the literal that begins at `place` ends: behind its closing quote. */
static const char *literal_end(const char *place)
{
    const char quote = *place++;
    while (*place != '\0' && *place != quote)
        place += place[0] == '\\' && place[1] != '\0' ? 2 : 1;
    return *place == quote ? place + 1 : place;
}

/* Where the comment at `place` ends; `place` itself where there is none. */
static const char *comment_end(const char *place)
{
    if (g_str_has_prefix(place, "//")) return place + strcspn(place, "\n");
    if (!g_str_has_prefix(place, "/*")) return place;
    const char *end = strstr(place + 2, "*/");
    return end != NULL ? end + 2 : place + strlen(place);
}

GPtrArray *source_files(const char *folder)
{
    GPtrArray *files = g_ptr_array_new_with_free_func(g_free);
    collect(folder, "", files);
    g_ptr_array_sort(files, compare_paths);
    return files;
}

char *source_without_comments(const char *path)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *text = NULL;
    g_file_get_contents(path, &text, NULL, &error);
    g_assert_no_error(error);
    GString *result = g_string_new(NULL);
    for (const char *place = text; *place != '\0';) {
        const char *end = comment_end(place);
        if (end > place) {
            for (; place < end; place++)
                if (*place == '\n') g_string_append_c(result, '\n');
            g_string_append_c(result, ' ');
            continue;
        }
        end = *place == '"' || *place == '\'' ? literal_end(place) : place + 1;
        g_string_append_len(result, place, end - place);
        place = end;
    }
    return g_string_free(result, FALSE);
}

GPtrArray *source_includes(const char *text)
{
    GPtrArray *includes = g_ptr_array_new_with_free_func(g_free);
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    for (char **line = lines; *line != NULL; line++) {
        g_strstrip(*line);
        if (!g_str_has_prefix(*line, "#")) continue;
        const char *word = *line + 1;
        word += strspn(word, " \t");
        if (!g_str_has_prefix(word, "include")) continue;
        g_ptr_array_add(includes, g_strstrip(g_strdup(word + strlen("include"))));
    }
    return includes;
}

GPtrArray *source_literals(const char *text)
{
    GPtrArray *literals = g_ptr_array_new_with_free_func(g_free);
    gboolean directive = FALSE;
    for (const char *place = text; *place != '\0';) {
        if (*place == '\n') directive = FALSE;
        if (g_str_has_prefix(place, "#include")) directive = TRUE;
        const char *end = *place == '"' || *place == '\'' ? literal_end(place) : place + 1;
        if (*place == '"' && !directive) g_ptr_array_add(literals, g_strndup(place + 1, (gsize)(end - place) - 2));
        place = end;
    }
    return literals;
}

gboolean source_begins_with_one_of(const char *text, const char *const *beginnings)
{
    for (; *beginnings != NULL; beginnings++)
        if (g_str_has_prefix(text, *beginnings)) return TRUE;
    return FALSE;
}

char *source_output_of(const char *const *arguments)
{
    g_autoptr(GError) error = NULL;
    char *output = NULL;
    int wait_status = 0;
    g_spawn_sync(NULL, (char **)arguments, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, &output, NULL, &wait_status, &error);
    g_assert_no_error(error);
    g_assert_true(g_spawn_check_wait_status(wait_status, NULL));
    return output;
}
