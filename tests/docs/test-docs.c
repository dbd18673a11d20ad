/* The documentation holds: its listings are the files they name and its outputs what the program prints, its links lead
 * somewhere, and every method and every bundled scene has its place in it. */
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

#include "markdown.h"
#include "program.h"

static void add_piece(GHashTable *pieces, const char *path, const char *text)
{
    GString *whole = g_hash_table_lookup(pieces, path);
    if (whole == NULL) {
        g_hash_table_insert(pieces, g_strdup(path), g_string_new(text));
        return;
    }
    g_string_append_printf(whole, "\n%s", text);
}

static void free_piece(gpointer data)
{
    g_string_free(data, TRUE);
}

/* A file may be shown in pieces, in order; together they must be all of it. */
static guint check_listings(const char *document)
{
    g_autofree char *text = test_read_file(document), *folder = g_path_get_dirname(document);
    g_autoptr(GPtrArray) listings = markdown_listings(text);
    g_autoptr(GHashTable) pieces = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, free_piece);
    for (guint i = 0; i < listings->len; i++) {
        const MarkdownListing *listing = listings->pdata[i];
        if (strcmp(listing->kind, "listing") != 0) continue;
        g_autofree char *path = g_build_filename(folder, listing->argument, NULL);
        add_piece(pieces, path, listing->text);
    }
    GHashTableIter each;
    gpointer path, whole;
    g_hash_table_iter_init(&each, pieces);
    while (g_hash_table_iter_next(&each, &path, &whole)) {
        g_autofree char *file = test_read_file(path);
        if (strcmp(file, ((GString *)whole)->str) != 0) g_test_message("%s does not show %s", document, (char *)path);
        g_assert_cmpstr(file, ==, ((GString *)whole)->str);
    }
    return g_hash_table_size(pieces);
}

static void test_listings(void)
{
    g_autoptr(GPtrArray) documents = markdown_files(g_getenv("TINKER_SOURCES"));
    guint shown = 0;
    for (guint i = 0; i < documents->len; i++)
        shown += check_listings(documents->pdata[i]);
    g_assert_cmpuint(shown, >=, 5);
}

/* Runs the program in the folder that the mark names, as the reader would. */
static void check_output(const char *document, const MarkdownListing *listing)
{
    g_autofree char *beside = g_path_get_dirname(document);
    g_autofree char *folder = g_build_filename(beside, listing->folder, NULL);
    g_assert_cmpint(g_chdir(folder), ==, 0);
    g_autoptr(GError) error = NULL;
    g_auto(GStrv) arguments = NULL;
    g_shell_parse_argv(listing->argument, NULL, &arguments, &error);
    g_assert_no_error(error);
    g_assert_cmpstr(arguments[0], ==, "tinker");
    g_autoptr(TestProgram) program = test_program_run((const char *const *)arguments + 1);
    g_autofree char *printed = g_strconcat(program->output, program->error, NULL);
    g_assert_cmpstr(printed, ==, listing->text);
}

static void test_outputs(void)
{
    g_autoptr(GPtrArray) documents = markdown_files(g_getenv("TINKER_SOURCES"));
    guint seen = 0;
    for (guint i = 0; i < documents->len; i++) {
        g_autofree char *text = test_read_file(documents->pdata[i]);
        g_autoptr(GPtrArray) listings = markdown_listings(text);
        for (guint k = 0; k < listings->len; k++) {
            const MarkdownListing *listing = listings->pdata[k];
            if (strcmp(listing->kind, "output") != 0) continue;
            check_output(documents->pdata[i], listing);
            seen++;
        }
    }
    g_assert_cmpuint(seen, >, 0);
}

static void test_links(void)
{
    g_autoptr(GPtrArray) documents = markdown_files(g_getenv("TINKER_SOURCES"));
    for (guint i = 0; i < documents->len; i++) {
        g_autofree char *text = test_read_file(documents->pdata[i]);
        g_autofree char *folder = g_path_get_dirname(documents->pdata[i]);
        g_autoptr(GPtrArray) links = markdown_links(text);
        for (guint k = 0; k < links->len; k++) {
            g_autofree char *target = g_build_filename(folder, links->pdata[k], NULL);
            if (g_file_test(target, G_FILE_TEST_EXISTS)) continue;
            g_test_message("%s: no file %s", (char *)documents->pdata[i], (char *)links->pdata[k]);
            g_test_fail();
        }
    }
}

/* What a page of a method must tell; that of auto, which is no method of its own, needs no equation, and that of
 * impulse, which is asked for by `contacts`, no picture. */
static void check_method_page(const char *name, const char *page, const char *overview)
{
    static const char *const parts[] = {"\n## Order", "\n## Cost\n", "\n## When to take it", "\n## Source\n"};
    const gboolean chosen = strcmp(name, "auto") == 0 || strcmp(name, "impulse") == 0;
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++) {
        if (strstr(page, parts[i]) == NULL) g_test_message("%s: no part%s", name, parts[i]);
        g_assert_nonnull(strstr(page, parts[i]));
    }
    g_autofree char *picture = g_strconcat("(../images/stability-", name, ".png)", NULL);
    g_assert_true(chosen || (strstr(page, picture) != NULL && strstr(page, "\n## Equation\n") != NULL));
    g_autofree char *link = g_strconcat("(../methods/", name, ".md)", NULL);
    g_assert_nonnull(strstr(overview, link));
}

/* The methods that are linked in: the program tells them where it does not know one. (transfer full) */
static GStrv builtin_methods(void)
{
    g_autofree char *scene = markdown_source_path("host/scenes/pendulum.tinker.json");
    const char *arguments[] = {"run", scene, "--method", "unheard-of", NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    const char *first = strstr(program->error, "(there are "), *end = strstr(program->error, ", and of plugins");
    g_assert_true(first != NULL && end != NULL);
    first += strlen("(there are ");
    g_autofree char *names = g_strndup(first, (gsize)(end - first));
    return g_strsplit(names, ", ", -1);
}

/* Each method that is linked in has a page, and each page tells of one of them or of a plugin. */
static void test_methods(void)
{
    g_auto(GStrv) names = builtin_methods();
    g_autofree char *overview_path = markdown_source_path("docs/reference/methods.md"),
                    *folder = markdown_source_path("docs/methods");
    g_autofree char *overview = test_read_file(overview_path);
    for (char **name = names; *name != NULL; name++) {
        g_autofree char *file = g_strconcat(*name, ".md", NULL), *path = g_build_filename(folder, file, NULL);
        if (!g_file_test(path, G_FILE_TEST_EXISTS)) g_test_message("no page %s", path);
        g_assert_true(g_file_test(path, G_FILE_TEST_EXISTS));
    }
    g_autoptr(GError) error = NULL;
    g_autoptr(GDir) pages = g_dir_open(folder, 0, &error);
    g_assert_no_error(error);
    for (const char *file = g_dir_read_name(pages); file != NULL; file = g_dir_read_name(pages)) {
        g_assert_true(g_str_has_suffix(file, ".md"));
        g_autofree char *name = g_strndup(file, strlen(file) - 3), *path = g_build_filename(folder, file, NULL);
        g_autofree char *page = test_read_file(path);
        g_autofree char *plugin = g_strconcat("plugins/", name, NULL), *plugin_folder = markdown_source_path(plugin);
        g_assert_true(g_strv_contains((const char *const *)names, name) || g_str_equal(name, "impulse") ||
                      g_file_test(plugin_folder, G_FILE_TEST_IS_DIR));
        check_method_page(name, page, overview);
    }
}

/* Every bundled scene serves a concept. */
static void test_concepts(void)
{
    static const char suffix[] = ".tinker.json";
    g_autofree char *page_path = markdown_source_path("docs/concepts.md"),
                    *folder = markdown_source_path("host/scenes");
    g_autofree char *page = test_read_file(page_path);
    g_autoptr(GDir) scenes = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(scenes);
    for (const char *file = g_dir_read_name(scenes); file != NULL; file = g_dir_read_name(scenes)) {
        if (!g_str_has_suffix(file, suffix)) continue;
        g_autofree char *named = g_strdup_printf("`%.*s`", (int)(strlen(file) - strlen(suffix)), file);
        if (strstr(page, named) == NULL) g_test_message("%s is not in docs/concepts.md", named);
        g_assert_nonnull(strstr(page, named));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/docs/listings", test_listings);
    g_test_add_func("/docs/outputs", test_outputs);
    g_test_add_func("/docs/links", test_links);
    g_test_add_func("/docs/methods", test_methods);
    g_test_add_func("/docs/concepts", test_concepts);
    return g_test_run();
}
