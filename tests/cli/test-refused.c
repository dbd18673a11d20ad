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
    g_autofree char *expected = g_strdup_printf("tinker: %s:2:11: Big Ring: %s\ntinker: warning: %s:3:27: Ring: %s\n",
                                                scene, reason, scene, reason);
    g_assert_cmpstr(run->error, ==, expected);
}

static void test_check(CliFixture *fixture, gconstpointer data)
{
    write_rings(fixture);
    g_autofree char *reason = reason_of(fixture), *scene = cli_path(fixture, "ring.json");
    g_autoptr(TestProgram) check = cli_run_badly(fixture, "check @ring.json --plugins @", 4);
    g_autofree char *expected =
        g_strdup_printf("tinker: %s:2:11: Big Ring: %s\ntinker: %s:3:27: Ring: %s\n", scene, reason, scene, reason);
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
    g_autofree char *reason =
        g_strdup_printf("and those of installed plugins): the library \"%s\" was refused: " NO_LIBRARY "\n", library);
    g_autoptr(TestProgram) run = cli_run_badly(fixture, "run @fall.json --plugins @ --method heun", 2);
    cli_assert_holds(run->error, "there is no method \"heun\"");
    cli_assert_holds(run->error, reason);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/refused/run", test_run);
    cli_test_add("/refused/check", test_check);
    cli_test_add("/refused/columns", test_columns);
    cli_test_add("/refused/method", test_method);
    return g_test_run();
}
