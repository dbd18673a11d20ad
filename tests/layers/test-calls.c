/* Who calls whom, as the compiler left it in the objects of core and of the hosts: files that call each other in a
 * circle can only be understood together, so there are none but for those of the table. A symbol that one object
 * defines and another leaves open is a call. */
#include <glib.h>
#include <string.h>

#include "source-text.h"

/* Calls that may close a circle, and why; ended by NULL. */
typedef struct {
    const char *from, *to, *reason;
} Exception;

static const Exception exceptions[] = {
    {NULL, NULL, NULL},
};

/* Of one file: the files that it calls, with a symbol each. */
typedef struct {
    GHashTable *calls; /* name of a file -> a symbol */
    int visit;         /* 0: not yet, 1: on the way, 2: done */
} File;

static void file_free(gpointer data)
{
    File *file = data;
    g_hash_table_unref(file->calls);
    g_free(file);
}

/* "…/libtinker_physics.a:run_watch.c.o:0000 T name" is in the file "physics/run_watch". (transfer full) */
static char *file_of(const char *line)
{
    const char *archive = strstr(line, "libtinker_"), *object;
    const char *suffix = archive != NULL ? strstr(archive, ".c.o:") : NULL;
    if (suffix == NULL) return NULL;
    for (object = suffix; object[-1] != ':' && object[-1] != '/'; object--)
        continue;
    const char *name = archive + strlen("libtinker_");
    g_autofree char *folder = g_strndup(name, strcspn(name, ".")), *file = g_strndup(object, (gsize)(suffix - object));
    return g_strconcat(folder, "/", file, NULL);
}

/* The kind of a symbol, as nm writes it, and its name; FALSE where the line holds none. */
static gboolean read_symbol(const char *line, char *kind, const char **name)
{
    *name = strrchr(line, ' ');
    if (*name == NULL || *name - line < 2) return FALSE;
    *kind = (*name)[-1];
    ++*name;
    return TRUE;
}

static void collect_definitions(char **lines, GHashTable *defined)
{
    for (; *lines != NULL; lines++) {
        const char *name;
        char kind, *file = file_of(*lines);
        if (file != NULL && read_symbol(*lines, &kind, &name) && strchr("TDRBV", kind) != NULL)
            g_hash_table_insert(defined, g_strdup(name), file);
        else
            g_free(file);
    }
}

static File *find_file(GHashTable *files, const char *name)
{
    File *file = g_hash_table_lookup(files, name);
    if (file != NULL) return file;
    file = g_new0(File, 1);
    file->calls = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    g_hash_table_insert(files, g_strdup(name), file);
    return file;
}

static void collect_calls(char **lines, GHashTable *defined, GHashTable *files)
{
    for (; *lines != NULL; lines++) {
        const char *symbol, *to;
        char kind;
        g_autofree char *from = file_of(*lines);
        if (from == NULL || !read_symbol(*lines, &kind, &symbol) || kind != 'U') continue;
        to = g_hash_table_lookup(defined, symbol);
        if (to != NULL && strcmp(from, to) != 0)
            g_hash_table_insert(find_file(files, from)->calls, g_strdup(to), g_strdup(symbol));
    }
}

/* All files that call another. (transfer full) */
static GHashTable *read_calls(void)
{
    GHashTable *files = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, file_free);
    g_autoptr(GHashTable) defined = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, g_free);
    g_auto(GStrv) archives = g_strsplit(g_getenv("TINKER_TEST_ARCHIVES"), ":", -1);
    g_autoptr(GString) all = g_string_new(NULL);
    for (char **archive = archives; *archive != NULL; archive++) {
        g_autofree char *symbols = source_output_of((const char *[]){"nm", "--print-file-name", *archive, NULL});
        g_string_append(all, symbols);
    }
    g_auto(GStrv) lines = g_strsplit(all->str, "\n", -1);
    collect_definitions(lines, defined);
    collect_calls(lines, defined, files);
    return files;
}

/* Follows all calls from a file; where one leads back to a file on the way, tells the way round. */
static void follow(GHashTable *files, const char *name, GPtrArray *way)
{
    File *file = find_file(files, name);
    if (file->visit == 1) {
        g_autoptr(GString) circle = g_string_new(name);
        guint first = 0;
        while (!g_str_equal(way->pdata[first], name))
            first++;
        for (guint i = first; i < way->len; i++) {
            const char *next = i + 1 < way->len ? way->pdata[i + 1] : name;
            const File *caller = g_hash_table_lookup(files, way->pdata[i]);
            g_string_append_printf(circle, " -[%s]-> %s", (char *)g_hash_table_lookup(caller->calls, next), next);
        }
        g_test_message("files call each other in a circle: %s", circle->str);
        g_test_fail();
    }
    if (file->visit != 0) return;
    file->visit = 1;
    g_ptr_array_add(way, (gpointer)name);
    g_autoptr(GList) called = g_list_sort(g_hash_table_get_keys(file->calls), (GCompareFunc)strcmp);
    for (GList *each = called; each != NULL; each = each->next)
        follow(files, each->data, way);
    g_ptr_array_set_size(way, (int)way->len - 1);
    file->visit = 2;
}

static void test_no_circles(void)
{
    g_autoptr(GHashTable) files = read_calls();
    g_autoptr(GPtrArray) way = g_ptr_array_new();
    g_assert_cmpuint(g_hash_table_size(files), >, 200);
    for (gsize i = 0; exceptions[i].from != NULL; i++) {
        File *file = find_file(files, exceptions[i].from);
        if (!g_hash_table_remove(file->calls, exceptions[i].to)) {
            g_test_message("%s does not call %s any more: take it out of the table", exceptions[i].from,
                           exceptions[i].to);
            g_test_fail();
        }
    }
    g_autoptr(GList) names = g_list_sort(g_hash_table_get_keys(files), (GCompareFunc)strcmp);
    for (GList *each = names; each != NULL; each = each->next)
        follow(files, each->data, way);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/calls/no-circles", test_no_circles);
    return g_test_run();
}
