/* A worked example of sdk/examples, as its author has it: the folder alone, against an installed SDK. It builds with
 * warnings as errors, its own test passes, and it keeps the rules of the contract. The example is named on the command
 * line. */
#include "author.h"
#include "folders.h"

#include "program.h"

/* A copy, so that nothing of the tree is within reach, and nothing is written into it. */
static void copy_example(const char *name, const char *to)
{
    g_autofree char *from = g_build_filename(g_getenv("TINKER_SOURCES"), "sdk", "examples", name, NULL);
    const char *copy[] = {"cp", "-R", from, to, NULL};
    test_author_run(to, NULL, copy);
}

static void test_builds_and_holds(gconstpointer name)
{
    g_autofree char *folder = test_author_folder();
    copy_example(name, folder);
    g_autofree char *sources = g_build_filename(folder, name, NULL), *build = g_build_filename(folder, "build", NULL);
    const char *setup[] = {"meson", "setup", "-Dwerror=true", build, sources, NULL},
               *compile[] = {"meson", "compile", "-C", build, NULL},
               *test[] = {"meson", "test", "-C", build, "--no-rebuild", "--print-errorlogs", "-t", "5", NULL};
    test_author_run(folder, NULL, setup);
    test_author_run(folder, NULL, compile);
    test_author_run(folder, NULL, test);
    g_autofree char *file = g_strdup_printf("%s/tinker-%s.so", build, (const char *)name);
    test_author_states_laws(file);
    test_remove_all(folder);
}

/* A README is read at one look. */
static void test_readme(gconstpointer name)
{
    g_autofree char *path = g_build_filename(g_getenv("TINKER_SOURCES"), "sdk", "examples", name, "README.md", NULL);
    g_autofree char *text = test_read_file(path);
    g_auto(GStrv) lines = g_strsplit(text, "\n", -1);
    g_assert_cmpuint(g_strv_length(lines) - 1, <=, 30);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_assert_cmpint(argc, ==, 2);
    g_test_add_data_func("/sdk/examples/builds-and-holds", argv[1], test_builds_and_holds);
    g_test_add_data_func("/sdk/examples/readme", argv[1], test_readme);
    return g_test_run();
}
