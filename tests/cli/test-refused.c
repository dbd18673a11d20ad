/* A library that was refused: the message about what it lacks says so, wherever it is missed. */
#include <string.h>

#include "fixture.h"

#define NO_LIBRARY "it is no shared object: it begins with 23 21 2f 62, 7f 45 4c 46 was expected"

/* Two rings of a type whose library is a script. */
static void write_rings(const CliFixture *fixture)
{
    g_autofree char *library = cli_write(fixture, "tinker-guide.so", "#!/bin/sh\n");
    g_autofree char *scene = cli_write(fixture, "ring.json",
                                       "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"},\n"
                                       " {\"type\": \"ring\", \"name\": \"Big Ring\"},\n"
                                       " {\"name\": \"Ring\", \"type\": \"ring\"}]}\n");
}

/* What is said of the missing type. (transfer full) */
static char *reason_of(const CliFixture *fixture)
{
    g_autofree char *library = cli_path(fixture, "tinker-guide.so");
    return g_strdup_printf("no plugin provides the block type \"ring\"; it may be in a refused "
                           "one: the library \"%s\" was refused: " NO_LIBRARY,
                           library);
}

/* The error has the reason and the place; nothing of it is told twice. */
static void test_run(CliFixture *fixture, gconstpointer data)
{
    write_rings(fixture);
    g_autofree char *reason = reason_of(fixture), *scene = cli_path(fixture, "ring.json");
    g_autoptr(TestProgram) run = cli_run_badly(fixture, "run @ring.json --plugins @", 4);
    g_autofree char *expected =
        g_strdup_printf("tinker: %s:2:11: Big Ring: %s; 1 more block is of it\n", scene, reason);
    g_assert_cmpstr(run->error, ==, expected);
}

static void test_check(CliFixture *fixture, gconstpointer data)
{
    write_rings(fixture);
    g_autofree char *reason = reason_of(fixture), *scene = cli_path(fixture, "ring.json");
    g_autoptr(TestProgram) check = cli_run_badly(fixture, "check @ring.json --plugins @", 4);
    g_autofree char *expected =
        g_strdup_printf("tinker: %s:2:11: Big Ring: %s; 1 more block is of it\n", scene, reason);
    g_assert_cmpstr(check->error, ==, expected);
}

/* A column of a placeholder: its type is what is missing, not the quantity. */
static void test_columns(CliFixture *fixture, gconstpointer data)
{
    write_rings(fixture);
    g_autofree char *reason = reason_of(fixture), *scene = cli_path(fixture, "ring.json");
    g_autofree char *expected =
        g_strdup_printf("tinker: %s: column \"Ring.force\": the block's type is missing: %s\n", scene, reason);
    static const char *const words[] = {
        "run @ring.json --plugins @ --csv @r.csv --columns Ring.force",
        "graph @ring.json --plugins @ 'Ring.force' -o @r.png",
    };
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words[i], 4);
        g_assert_true(g_str_has_prefix(program->error, expected));
        g_autofree char *record = cli_path(fixture, "r.csv");
        g_assert_false(g_file_test(record, G_FILE_TEST_EXISTS));
    }
}

static void test_method(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *library = cli_write(fixture, "tinker-heun.so", "#!/bin/sh\n");
    g_autofree char *scene = cli_write(fixture, "fall.json", FREE_FALL);
    g_autofree char *reason = g_strdup_printf("): the library \"%s\" was refused: " NO_LIBRARY "\n", library);
    g_autoptr(TestProgram) run = cli_run_badly(fixture, "run @fall.json --plugins @ --method heun", 2);
    cli_assert_holds(run->error, "there is no method \"heun\"");
    cli_assert_holds(run->error, reason);
}

/* What --plugins names: a file, nothing, a project whose library is in its build folder, a folder of bundles. */
static void test_folders(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "fall.json", FREE_FALL), *project = cli_path(fixture, "project"),
                    *build = cli_path(fixture, "project/build"), *bundle = cli_path(fixture, "course"),
                    *file = cli_path(fixture, "project/build/tinker-a.so"), *none = cli_path(fixture, "none");
    const struct {
        const char *words;
        char *error;
    } cases[] = {
        {"run @fall.json --plugins @none",
         g_strdup_printf("tinker: warning: --plugins \"%s\": no such folder\n", none)},
        {"run @fall.json --plugins @project/build/tinker-a.so",
         g_strdup_printf("tinker: warning: --plugins \"%s\": this is a file; give the folder it lies in, \"%s\"\n",
                         file, build)},
        {"run @fall.json --plugins @project",
         g_strdup_printf(
             "tinker: warning: --plugins \"%s\": no plugin library (*.so) lies in this folder (a project's is "
             "in its build folder: did you mean \"%s\"?)\n",
             project, build)},
        {"run @fall.json --plugins @course",
         g_strdup_printf(
             "tinker: warning: --plugins \"%s\": no plugin library (*.so) lies in this folder (a project's is "
             "in its build folder)\n",
             bundle)},
        {"run @fall.json --plugins @project/build", g_strdup("")},
        {"run @fall.json --plugins @", g_strdup("")},
    };
    g_assert_cmpint(g_mkdir_with_parents(build, 0755), ==, 0);
    g_assert_cmpint(g_mkdir_with_parents(bundle, 0755), ==, 0);
    g_autofree char *library = cli_write(fixture, "project/build/tinker-a.so", "#!/bin/sh\n");
    g_autofree char *marker = NULL, *of_bundle = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        if (i == 5) { /* now a bundle lies in the folder, and its library counts */
            marker = cli_write(fixture, "course/bundle.json", "{\"bundle\": 1, \"title\": \"Course\"}");
            of_bundle = cli_write(fixture, "course/tinker-b.so", "#!/bin/sh\n");
        }
        g_autoptr(TestProgram) program = cli_run_well(fixture, cases[i].words);
        g_assert_cmpstr(program->error, ==, cases[i].error);
        g_free(cases[i].error);
    }
}

/* A folder where a library is expected. */
static void test_check_of_folder(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *first = cli_write(fixture, "tinker-a.so", ""), *second = cli_write(fixture, "tinker-b.so", "");
    g_autofree char *empty = cli_path(fixture, "empty");
    g_assert_cmpint(g_mkdir_with_parents(empty, 0755), ==, 0);
    g_autofree char *expected = g_strdup_printf("tinker: %s: this is a folder; check one of its libraries: %s, %s\n",
                                                fixture->folder, first, second);
    g_autofree char *words = g_strdup_printf("plugins check '%s'", fixture->folder);
    g_autoptr(TestProgram) check = cli_run_badly(fixture, words, 5);
    g_assert_cmpstr(check->error, ==, expected);
    g_autofree char *nothing =
        g_strdup_printf("tinker: %s: this is a folder; no plugin library (*.so) lies in it\n", empty);
    g_autoptr(TestProgram) other = cli_run_badly(fixture, "plugins check @empty", 5);
    g_assert_cmpstr(other->error, ==, nothing);
}

/* The list is of the folders that are searched, and says so. */
static void test_list(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *library = cli_write(fixture, "tinker-a.so", "#!/bin/sh\n");
    g_autofree char *line = g_strdup_printf("%s: " NO_LIBRARY "\n", library);
    g_autoptr(TestProgram) named = cli_run_well(fixture, "plugins refused --plugins @");
    g_assert_cmpstr(named->output, ==, line);
    g_autoptr(TestProgram) unnamed = cli_run_well(fixture, "plugins refused");
    g_assert_cmpstr(unnamed->output, ==, "no library was refused in the folders that are searched\n");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/refused/run", test_run);
    cli_test_add("/refused/check", test_check);
    cli_test_add("/refused/columns", test_columns);
    cli_test_add("/refused/method", test_method);
    cli_test_add("/refused/folders", test_folders);
    cli_test_add("/refused/check-of-folder", test_check_of_folder);
    cli_test_add("/refused/list", test_list);
    return g_test_run();
}
