#include "crash-fixture.h"

void crash_write_scene(const CliFixture *fixture, const char *type)
{
    g_autofree char *text =
        g_strdup_printf("{\"tinker\": 1, \"run\": {\"duration\": 3, \"interval\": 0.125, \"method\": \"rk4\", "
                        "\"step\": 0.125}, \"blocks\": [{\"type\": \"mass\", \"velocity\": [1, 0]},\n"
                        "{\"type\": \"mass\", \"position\": [0, 1], \"velocity\": [2, 0]},\n"
                        "{\"type\": \"%s\", \"name\": \"First\", \"ends\": [\"Mass 0\"]},\n"
                        "{\"type\": \"%s\", \"name\": \"Second\", \"ends\": [\"Mass 1\"]}]}\n",
                        type, type);
    g_autofree char *path = cli_write(fixture, "a.json", text);
}

TestProgram *crash_run_exhibit(const CliFixture *fixture, const char *type, const char *interval, const char *columns)
{
    crash_write_scene(fixture, type);
    g_autofree char *words = g_strdup_printf("run @a.json --plugins '%s' --csv @r.csv --interval %s --columns '%s'",
                                             g_getenv("TINKER_EXHIBITS"), interval, columns);
    return cli_run(fixture, words);
}

void crash_assert_record(const CliFixture *fixture)
{
    g_autofree char *text = cli_read(fixture, "r.csv");
    g_assert_true(g_str_has_suffix(text, "\n"));
    g_autoptr(TestTable) table = test_table_new(text);
    g_assert_cmpuint(table->rows, ==, 9);
    g_assert_cmpuint(table->columns, ==, 3);
    for (gsize row = 0; row < table->rows; row++) {
        double t = (double)row / 8;
        g_assert_cmpfloat(test_table_value(table, row, "time"), ==, t);
        g_assert_cmpfloat(test_table_value(table, row, "Mass 0.x"), ==, t);
        g_assert_cmpfloat(test_table_value(table, row, "Mass 1.x"), ==, 2 * t);
    }
}

char *crash_copy_exhibit(const CliFixture *fixture, const char *exhibit, const char *name)
{
    g_autofree char *file = g_strconcat(exhibit, "-exhibit.so", NULL), *contents = NULL;
    g_autofree char *library = g_build_filename(g_getenv("TINKER_EXHIBITS"), file, NULL);
    char *copy = cli_path(fixture, name);
    gsize size = 0;
    g_autoptr(GError) error = NULL;
    g_assert_true(g_file_get_contents(library, &contents, &size, &error));
    g_assert_true(g_file_set_contents(copy, contents, (gssize)size, &error));
    return copy;
}
