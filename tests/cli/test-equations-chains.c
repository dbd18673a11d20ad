/* tinker equations: matrices of chains of masses, as patterns and as numbers. */
#include <cjson/cJSON.h>
#include <math.h>

#include "written.h"

/* A chain of masses on a line, each on a spring behind the one before, with these numbers of "stiffness", and where
 * `damped` on a damper of 0.1 N s/m. */
static char *write_chain(CliFixture *fixture, int count, int (*stiffness)(int number), gboolean damped)
{
    g_autoptr(GString) scene =
        g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"position\": [0, 0], "
                     "\"solid\": false, \"name\": \"Wall\"}");
    for (int i = 1; i <= count; i++) {
        g_string_append_printf(scene,
                               ",{\"type\": \"mass\", \"name\": \"M%d\", \"position\": [%d, 0], \"solid\": false},"
                               "{\"type\": \"spring\", \"ends\": [\"%s%.0d\", \"M%d\"], \"stiffness\": %d}",
                               i, i, i == 1 ? "Wall" : "M", i - 1, i, stiffness(i));
        if (damped)
            g_string_append_printf(scene, ",{\"type\": \"damper\", \"ends\": [\"%s%.0d\", \"M%d\"], \"damping\": 0.1}",
                                   i == 1 ? "Wall" : "M", i - 1, i);
    }
    g_string_append(scene, "]}");
    return cli_write(fixture, "scene.json", scene->str);
}

static int two_each(G_GNUC_UNUSED int number)
{
    return 2;
}

static int two_but_in_the_middle(int number)
{
    return number == 100 ? 3 : number == 101 ? 4 : 2;
}

/* A chain of ten on a line: its stiffness is a band of three, its mass a diagonal. */
static void test_pattern(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = write_chain(fixture, 10, two_each, FALSE);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
    cli_assert_holds(page->output, "10 coordinates");
    cli_assert_holds(page->output, "M is diagonal, 10 × 10, with 10 entries");
    cli_assert_holds(page->output, "C is 0");
    cli_assert_holds(page->output, "K is tridiagonal, 10 × 10, with 28 entries");
    cli_assert_holds(page->output, "= 2 k   on the diagonal, 9 of 10, ");
    cli_assert_holds(page->output, "= −k    beside it, −");
}

/* A chain as above of two hundred masses, with k of two springs in its middle 3 N/m and 4 N/m in the place of 2 N/m: of
 * the sums on the diagonal all but one look alike, from 2 + 2 N/m to 3 + 4 N/m. */
static void test_large_pattern(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = write_chain(fixture, 200, two_but_in_the_middle, FALSE);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
    cli_assert_holds(page->output, "K is tridiagonal, 200 × 200, with 598 entries");
    cli_assert_holds(page->output, "= 2 k   on the diagonal, 199 of 200, 4 N/m to 7 N/m");
    cli_assert_holds(page->output, "= k     on the diagonal, 1 of 200, 2 N/m");
    cli_assert_holds(page->output, "= −k    beside it, −4 N/m to −2 N/m");
}

static double number_at(const cJSON *list, int number)
{
    return cJSON_GetArrayItem(list, number)->valuedouble;
}

/* Of a uniform chain that is free at its end (k = 2 N/m, c = 0.1 N s/m or 0, 1 kg) the JSON has all: the frequencies
 * are 2 sqrt(k/m) sin((2 j - 1) pi / (2 (2 n + 1))), the damping ratios c omega / (2 k), and rest is where each stands.
 * P. M. Morse, Vibration and Sound, 1948, section 8. */
static void check_large_numbers(CliFixture *fixture, int n, gboolean damped)
{
    g_autofree char *path = write_chain(fixture, n, two_each, damped);
    cJSON *root = written_json(fixture, "equations @scene.json --form matrix --as json");
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    g_assert_nonnull(island);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "why")), ==, 0);
    static const char *const matrices[] = {"M", "C", "K"};
    for (gsize i = 0; i < G_N_ELEMENTS(matrices); i++) {
        const cJSON *rows = cJSON_GetObjectItem(island, matrices[i]), *row;
        g_assert_cmpint(cJSON_GetArraySize(rows), ==, n);
        cJSON_ArrayForEach(row, rows) g_assert_cmpint(cJSON_GetArraySize(row), ==, n);
    }
    for (int j = 0; j < n; j++) {
        const double omega = 2 * sqrt(2) * sin((2 * j + 1) * G_PI / (2 * (2 * n + 1)));
        written_assert_near(number_at(cJSON_GetObjectItem(island, "omega"), j), omega, 1e-10);
        written_assert_near(number_at(cJSON_GetObjectItem(island, "zeta"), j), damped ? 0.1 * omega / 4 : 0, 1e-10);
    }
    const cJSON *about = cJSON_GetObjectItem(island, "about");
    written_assert_near(number_at(about, n - 1), n, 1e-9);
    cJSON_Delete(root);
}

static void test_large_numbers(CliFixture *fixture, gconstpointer data)
{
    check_large_numbers(fixture, 70, TRUE);
    check_large_numbers(fixture, 300, FALSE);
    g_autofree char *path = write_chain(fixture, 300, two_each, TRUE);
    cJSON *root = written_json(fixture, "equations @scene.json --form matrix --as json");
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "islands")), ==, 0);
    const cJSON *why = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "why"), 0);
    cli_assert_holds(cJSON_GetObjectItem(why, "why")->valuestring, "256");
    cJSON_Delete(root);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-chains/pattern", test_pattern);
    cli_test_add("/cli/equations-chains/large-pattern", test_large_pattern);
    cli_test_add("/cli/equations-chains/large-numbers", test_large_numbers);
    return g_test_run();
}
