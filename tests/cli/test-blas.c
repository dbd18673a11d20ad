/* Which BLAS is installed makes no difference: another one, found before all others, is not loaded. */
#include "fixture.h"

static void test_other_blas(CliFixture *fixture, gconstpointer data)
{
    g_free(cli_write(fixture, "scene.json", OSCILLATOR));
    g_autoptr(TestProgram) before = cli_run_well(fixture, "modes @scene.json --json -");
    g_autofree char *paths = g_strconcat(g_getenv("TEST_OTHER_BLAS"), ":", g_getenv("LD_LIBRARY_PATH"), NULL);
    g_autofree char *library = g_build_filename(g_getenv("TEST_OTHER_BLAS"), "libblas.so.3", NULL);
    g_assert_true(g_file_test(library, G_FILE_TEST_EXISTS));
    g_setenv("LD_LIBRARY_PATH", paths, TRUE);
    g_autoptr(TestProgram) after = cli_run_well(fixture, "modes @scene.json --json -");
    g_assert_cmpstr(after->output, ==, before->output);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/other-blas", test_other_blas);
    return g_test_run();
}
