/* The matrix form of shafts: against the inertia and stiffness that gears carry over by the square of their ratio, and
 * the characteristic polynomial of two discs. */
#include <cjson/cJSON.h>
#include <complex.h>
#include <math.h>

#include "fixture.h"

/* Two discs of 2 and 5 kg m^2 on axes of their own. */
#define DISCS(more)                                                                                                    \
    "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"O\", \"position\": [0, 0], \"solid\": false},"   \
    "{\"type\": \"support\", \"name\": \"P\", \"position\": [2, 0], \"solid\": false},"                                \
    "{\"type\": \"disc\", \"name\": \"A\", \"position\": [0, 0], \"inertia\": 2, \"solid\": false},"                   \
    "{\"type\": \"disc\", \"name\": \"B\", \"position\": [2, 0], \"inertia\": 5, \"solid\": false, "                   \
    "\"orientation\": 0.25}, {\"type\": \"pin\", \"ends\": [\"O\", \"A\"]}, {\"type\": \"pin\", \"ends\": [\"P\", "    \
    "\"B\"]}," more "]}"

/* B turns by -3 where A turns by 1; its spring of 40 N m/rad is at rest where it is turned by 0.55. */
#define GEARED                                                                                                         \
    DISCS("{\"type\": \"gear\", \"ends\": [\"A\", \"B\"], \"ratio\": 3},"                                              \
          "{\"type\": \"torsional-spring\", \"ends\": [\"P\", \"B\"], \"stiffness\": 40, \"rest_angle\": 0.55}")

#define DAMPED                                                                                                         \
    DISCS("{\"type\": \"torsional-spring\", \"ends\": [\"O\", \"A\"], \"stiffness\": 50},"                             \
          "{\"type\": \"torsional-spring\", \"ends\": [\"A\", \"B\"], \"stiffness\": 30},"                             \
          "{\"type\": \"torsional-damper\", \"ends\": [\"A\", \"B\"], \"damping\": 4}")

static double number(const cJSON *object, const char *key, int place)
{
    return cJSON_GetArrayItem(cJSON_GetObjectItem(object, key), place)->valuedouble;
}

static cJSON *form_of(CliFixture *fixture, const char *blocks)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", blocks);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "equations @scene.json --form matrix --as json");
    return cJSON_Parse(program->output);
}

static void test_geared(CliFixture *fixture, gconstpointer data)
{
    cJSON *root = form_of(fixture, GEARED);
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    const cJSON *coordinate = cJSON_GetArrayItem(cJSON_GetObjectItem(island, "coordinates"), 0);
    g_assert_cmpstr(cJSON_GetObjectItem(coordinate, "unit")->valuestring, ==, "rad");
    g_assert_cmpstr(cJSON_GetObjectItem(coordinate, "is")->valuestring, ==, "A.angle");
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(island, "coordinates")), ==, 1);
    g_assert_cmpfloat_with_epsilon(number(island, "omega", 0), sqrt(9 * 40 / (2 + 9 * 5.0)), 1e-12);
    g_assert_cmpfloat_with_epsilon(cJSON_GetObjectItem(cJSON_GetObjectItem(island, "about"), "q_1")->valuedouble,
                                   -(0.55 - 0.25) / 3, 1e-12);
    cJSON_Delete(root);
    g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
    cli_assert_holds(page->output, "(I₁ + i² I₂) q");
    cli_assert_holds(page->output, "rad   counted from rest\n");
}

static void test_two_discs(CliFixture *fixture, gconstpointer data)
{
    cJSON *root = form_of(fixture, DAMPED);
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    for (int i = 0; i < 2; i++) {
        const double omega = number(island, "omega", i), zeta = number(island, "zeta", i);
        const double complex s = omega * (-zeta + I * sqrt(1 - zeta * zeta)), link = 30 + 4 * s;
        const double complex a = 2 * s * s + 50 + link, b = 5 * s * s + link;
        g_assert_cmpfloat(cabs(a * b - link * link), <, 1e-11 * cabs(a * b));
    }
    g_assert_cmpfloat(number(island, "omega", 0) * 1.5, <, number(island, "omega", 1));
    cJSON_Delete(root);
}

/* What turns freely on the whole has roots of 0, and none of rounding; where it is braked, one is not 0. */
static void test_free(CliFixture *fixture, gconstpointer data)
{
    cJSON *root =
        form_of(fixture, DISCS("{\"type\": \"torsional-spring\", \"ends\": [\"A\", \"B\"], \"stiffness\": 30}"));
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    g_assert_cmpfloat(number(island, "omega", 0), ==, 0);
    g_assert_cmpfloat_with_epsilon(number(island, "omega", 1), sqrt(30 / 2.0 + 30 / 5.0), 1e-12);
    cJSON_Delete(root);
    root = form_of(fixture, DISCS("{\"type\": \"torsional-damper\", \"ends\": [\"O\", \"A\"], \"damping\": 3},"
                                  "{\"type\": \"torsional-damper\", \"ends\": [\"A\", \"B\"], \"damping\": 4}"));
    island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    /* s of [2 s + 7, -4; -4, 5 s + 4]: 10 s^2 + 43 s + 12 = 0 */
    const double far = (43 + sqrt(43 * 43 - 4 * 10 * 12)) / 20;
    for (int i = 0; i < 2; i++)
        g_assert_cmpfloat(number(island, "omega", i), ==, 0);
    g_assert_cmpfloat_with_epsilon(number(island, "decay", 0), 1.2 / far, 1e-12);
    g_assert_cmpfloat_with_epsilon(number(island, "decay", 1), far, 1e-12);
    cJSON_Delete(root);
}

/* Gears that gainsay one another leave nothing that turns, nor does a weld to what stands. */
static void test_without_form(CliFixture *fixture, gconstpointer data)
{
    static const char *const scenes[] = {
        DISCS("{\"type\": \"gear\", \"ends\": [\"A\", \"B\"]}, {\"type\": \"gear\", \"ends\": [\"A\", \"B\"], "
              "\"ratio\": 2}"),
        DISCS("{\"type\": \"gear\", \"ends\": [\"A\", \"B\"]}, {\"type\": \"weld\", \"ends\": [\"P\", \"B\"]}"),
    };
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        cJSON *root = form_of(fixture, scenes[i]);
        g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "islands")), ==, 0);
        cJSON_Delete(root);
        g_autoptr(TestProgram) page = cli_run_well(fixture, "equations @scene.json --form matrix");
        cli_assert_holds(page->output, "has no such equations");
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/equations-shafts/free", test_free);
    cli_test_add("/cli/equations-shafts/geared", test_geared);
    cli_test_add("/cli/equations-shafts/two-discs", test_two_discs);
    cli_test_add("/cli/equations-shafts/without-form", test_without_form);
    return g_test_run();
}
