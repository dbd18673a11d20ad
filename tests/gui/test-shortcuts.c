/* The window of shortcuts leaves none out: every key in the table of commands is in it. */
#include <glib.h>
#include <string.h>

/* Not inlined: the compiler would take the text for a part of it. */
G_GNUC_NO_INLINE static char *read_source(const char *name)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), "host", "gui", name, NULL);
    char *text = NULL;
    g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
    return text;
}

/* The accelerators that it shows, split at blanks. */
static GHashTable *shown_keys(void)
{
    g_autofree char *text = read_source("resources/help-overlay.ui");
    GHashTable *keys = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    g_autoptr(GRegex) property = g_regex_new("name=\"accelerator\">([^<]*)</property>", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    for (g_regex_match(property, text, 0, &match); g_match_info_matches(match); g_match_info_next(match, NULL)) {
        g_autofree char *escaped = g_match_info_fetch(match, 1);
        g_autoptr(GString) plain = g_string_new(escaped);
        g_string_replace(plain, "&lt;", "<", 0);
        g_string_replace(plain, "&gt;", ">", 0);
        g_auto(GStrv) words = g_strsplit(plain->str, " ", -1);
        for (char **word = words; *word != NULL; word++)
            g_hash_table_add(keys, g_strdup(*word));
    }
    return keys;
}

/* Every key in the rows of the table of commands. */
static guint check_keys(const char *table, GHashTable *shown)
{
    g_autoptr(GRegex) entry = g_regex_new("\\{(\"[^{}]*\")\\}", 0, 0, NULL),
                      key = g_regex_new("\"([^\"]+)\"", 0, 0, NULL);
    g_autoptr(GMatchInfo) match = NULL;
    guint count = 0;
    for (g_regex_match(entry, table, 0, &match); g_match_info_matches(match); g_match_info_next(match, NULL)) {
        g_autofree char *keys = g_match_info_fetch(match, 1);
        g_autoptr(GMatchInfo) one = NULL;
        for (g_regex_match(key, keys, 0, &one); g_match_info_matches(one); g_match_info_next(one, NULL), count++) {
            g_autofree char *accelerator = g_match_info_fetch(one, 1);
            if (g_hash_table_contains(shown, accelerator)) continue;
            g_test_message("help-overlay.ui does not show %s", accelerator);
            g_test_fail();
        }
    }
    return count;
}

static void test_complete(void)
{
    g_autoptr(GHashTable) shown = shown_keys();
    char *text = read_source("window/window-actions.c");
    char *table = strstr(text, "} commands[] = {"), *end = table != NULL ? strstr(table, "\n};") : NULL;
    if (end != NULL) *end = '\0';
    g_assert_cmpuint(table != NULL ? check_keys(table, shown) : 0, >, 20);
    g_free(text);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/gui/shortcuts/complete", test_complete);
    return g_test_run();
}
