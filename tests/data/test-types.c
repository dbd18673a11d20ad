/* Does a desktop know a scene when it sees one? Asked of GIO, which file managers ask, by name and by content. */
#include <glib.h>
#include <glib/gstdio.h>
#include <string.h>

#include "installed.h"

#define SCENE "application/vnd.tinker.scene+json"

/* The type of a file, as `gio info` tells it. (transfer full) */
static char *type_of(const char *path)
{
    const char *arguments[] = {"gio", "info", "-a", "standard::content-type", path, NULL};
    g_autofree char *output = test_tool_output(arguments);
    const char *mark = "standard::content-type: ", *found = strstr(output, mark);
    g_assert_nonnull(found);
    return g_strndup(found + strlen(mark), strcspn(found + strlen(mark), "\n"));
}

/* The type of a file of this name that holds this text. (transfer full) */
static char *type_of_text(const char *name, const char *text)
{
    g_autofree char *path = test_installed_path(name);
    g_autoptr(GError) error = NULL;
    g_file_set_contents(path, text, -1, &error);
    g_assert_no_error(error);
    char *type = type_of(path);
    g_remove(path);
    return type;
}

static void test_by_name(void)
{
    static const struct {
        const char *name, *type;
    } files[] = {
        {"foo.tinker.json", SCENE},       {"two.dots.tinker.json", SCENE},     {"FOO.TINKER.JSON", SCENE},
        {"foo.json", "application/json"}, {"tinker.json", "application/json"}, {"foo.tinker.csv", "text/csv"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(files); i++) {
        g_autofree char *type = type_of_text(files[i].name, "{\"name\": 1}\n");
        g_test_message("%s", files[i].name);
        g_assert_cmpstr(type, ==, files[i].type);
    }
}

/* A scene without its name, as after a download; and text that looks a little like one. */
static void test_by_content(void)
{
    static const struct {
        const char *text;
        gboolean scene;
    } files[] = {
        {"{\n  \"tinker\": 1,\n  \"title\": \"A\"\n}\n", TRUE}, {"{\"tinker\":1,\"blocks\":[]}", TRUE},
        {"{\"tinkerbell\": 1, \"peter\": 2}", FALSE},           {"{\"name\": \"tinker\", \"version\": 1}", FALSE},
        {"\"tinker\": 1, is how a scene begins", FALSE},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(files); i++) {
        g_autofree char *type = type_of_text("nameless", files[i].text);
        g_test_message("%s: %s", files[i].text, type);
        g_assert_cmpint(g_str_equal(type, SCENE), ==, files[i].scene);
    }
}

/* Every bundled scene is known with its name and without. */
static void test_bundled_scenes(void)
{
    const char *folder = g_getenv("TINKER_SCENES");
    g_autoptr(GDir) scenes = g_dir_open(folder, 0, NULL);
    g_assert_nonnull(scenes);
    guint count = 0;
    for (const char *name; (name = g_dir_read_name(scenes)) != NULL;) {
        if (!g_str_has_suffix(name, ".tinker.json")) continue;
        g_autofree char *path = g_build_filename(folder, name, NULL), *text = NULL, *named = type_of(path);
        g_assert_true(g_file_get_contents(path, &text, NULL, NULL));
        g_autofree char *nameless = type_of_text("nameless", text);
        g_test_message("%s", name);
        g_assert_cmpstr(named, ==, SCENE);
        g_assert_cmpstr(nameless, ==, SCENE);
        count++;
    }
    g_assert_cmpuint(count, >, 0);
}

/* What the desktop's tools made of the description: weight, parent, and that only this one type was added. */
static void test_database(void)
{
    g_autofree char *globs = test_installed_text("mime/globs2"), *parents = test_installed_text("mime/subclasses");
    g_auto(GStrv) lines = g_strsplit(globs, "\n", -1);
    guint added = 0;
    for (guint i = 0; lines[i] != NULL; i++)
        if (*lines[i] != '#' && *lines[i] != '\0') added++;
    g_assert_cmpuint(added, ==, 1);
    g_assert_nonnull(strstr(globs, "60:" SCENE ":*.tinker.json\n"));
    g_assert_cmpstr(parents, ==, SCENE " application/json\n");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/data/types/database", test_database);
    g_test_add_func("/data/types/by-name", test_by_name);
    g_test_add_func("/data/types/by-content", test_by_content);
    g_test_add_func("/data/types/bundled-scenes", test_bundled_scenes);
    test_installed_set_up();
    const int status = g_test_run();
    test_installed_tear_down();
    return status;
}
