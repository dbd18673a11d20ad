/* tinker books and tinker diagram: against closed forms of a throw, a bounce and a pendulum. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"

#define SCENE(blocks)                                                                                                  \
    "{\"tinker\": 1, \"run\": {\"duration\": 4, \"tolerance\": 1e-12}, \"blocks\": ["                                  \
    "{\"type\": \"gravity\", \"name\": \"Gravity\", \"acceleration\": 10}," blocks "]}"

/* 2 kg from (1, 0) with (4, 3) m/s. */
#define THROWN                                                                                                         \
    SCENE("{\"type\": \"mass\", \"name\": \"Ball\", \"mass\": 2, \"position\": [1, 0], \"velocity\": [4, 3]}")

/* Dropped by 0.8 m: it lands at 0.4 s with 4 m/s and leaves with 2. */
#define DROPPED                                                                                                        \
    SCENE("{\"type\": \"support\", \"name\": \"Floor\", \"height\": 0, \"width\": 9, \"restitution\": 0.5},"           \
          "{\"type\": \"mass\", \"name\": \"Ball\", \"mass\": 3, \"position\": [0, 0.8], \"width\": 0, \"height\": "   \
          "0}")

/* Level, at rest: the rod does not pull, and the bob falls. */
#define PENDULUM                                                                                                       \
    SCENE("{\"type\": \"support\", \"name\": \"Pivot\", \"solid\": false},"                                            \
          "{\"type\": \"mass\", \"name\": \"Bob\", \"mass\": 0.5, \"position\": [2, 0]},"                              \
          "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Pivot\", \"Bob\"]}")

static cJSON *json_of(CliFixture *fixture, const char *scene, const char *words)
{
    g_autofree char *path = cli_write(fixture, "scene.json", scene);
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    return root;
}

/* The number at a path such as "energy/work/Gravity" or "momentum/momentum/1/0". */
static double number_at(const cJSON *root, const char *path)
{
    g_auto(GStrv) keys = g_strsplit(path, "/", -1);
    for (char **key = keys; *key != NULL && root != NULL; key++)
        root = cJSON_IsArray(root) ? cJSON_GetArrayItem(root, atoi(*key)) : cJSON_GetObjectItem(root, *key);
    if (!cJSON_IsNumber(root)) g_error("there is no number at %s", path);
    return root->valuedouble;
}

typedef struct {
    const char *path;
    double value;
} Expected;

static void assert_numbers(const cJSON *root, const Expected *expected, gsize count)
{
    for (gsize i = 0; i < count; i++) {
        const double found = number_at(root, expected[i].path);
        if (fabs(found - expected[i].value) > 1e-9)
            g_error("%s is %.12g, %.12g was expected", expected[i].path, found, expected[i].value);
    }
}

/* After 1 s it is at (5, -2) with (4, -7) m/s. */
static void test_throw(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {
        {"energy/kinetic/0", 25},
        {"energy/kinetic/1", 65},
        {"energy/work/Gravity", 40},
        {"momentum/momentum/0/1", 6},
        {"momentum/momentum/1/1", -14},
        {"momentum/impulses/Gravity/1", -20},
        {"newton/forces/Gravity/1", -20},
        {"newton/rate_of_momentum/1", -20},
        {"angular/angular_momentum/0", 2 * ((1 - 2) * 3 - (0 - 1) * 4)},
        {"angular/angular_momentum/1", 2 * ((5 - 2) * -7 - (-2 - 1) * 4)},
        {"angular/impulses/Gravity", -20 * (3 - 2)}, /* its mean place is x = 3 */
        {"energy/residual", 0},
        {"momentum/residual", 0},
        {"angular/residual", 0},
    };
    cJSON *root = json_of(fixture, THROWN, "books @scene.json --to 1 --about 2,1 --as json");
    assert_numbers(root, expected, G_N_ELEMENTS(expected));
    cJSON_Delete(root);
}

static void test_bounce(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {
        {"impacts/0/time", 0.4},
        {"impacts/0/impulse/1", 3 * 6},
        {"impacts/0/work", 0.5 * 3 * (4 - 16)},
        {"energy/work/Floor", -18},
        {"energy/work/Gravity", 30 * 0.65},
        {"energy/kinetic/1", 1.5},
        {"momentum/residual", 0},
        {"energy/residual", 0},
        {"momentum/impulses/Floor/1", 18},
    };
    cJSON *root = json_of(fixture, DROPPED, "books @scene.json --to 0.5 --as json");
    g_assert_cmpstr(cJSON_GetObjectItem(cJSON_GetArrayItem(cJSON_GetObjectItem(root, "impacts"), 0), "by")->valuestring,
                    ==, "Floor");
    assert_numbers(root, expected, G_N_ELEMENTS(expected));
    cJSON_Delete(root);
}

/* A rod does no work; half a swing gives the momentum back. */
static void test_pendulum(CliFixture *fixture, gconstpointer data)
{
    cJSON *root = json_of(fixture, PENDULUM, "books @scene.json --to 0.7 --as json");
    const double rod = number_at(root, "energy/work/Rod"), gravity = number_at(root, "energy/work/Gravity");
    g_assert_cmpfloat(fabs(rod), <, 1e-9);
    g_assert_cmpfloat(fabs(gravity - number_at(root, "energy/kinetic/1")), <, 1e-9);
    g_assert_cmpfloat(fabs(number_at(root, "angular/impulses/Rod")), <, 1e-9);
    cJSON_Delete(root);
}

static void test_pages(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = cli_write(fixture, "scene.json", THROWN);
    g_autoptr(TestProgram) text = cli_run_well(fixture, "books @scene.json --to 1");
    cli_assert_holds(text->output, "Work and energy (J)\n  kinetic energy before   25\n  Gravity                 40\n"
                                   "  = kinetic energy after  65\n");
    g_autoptr(TestProgram) csv = cli_run_well(fixture, "books @scene.json --to 1 --as csv");
    g_assert_true(g_str_has_prefix(csv->output, "block,force_x [N],force_y [N],work [J],"));
    g_autoptr(TestProgram) order = cli_run_badly(fixture, "books @scene.json --from 2 --to 1", 2);
    cli_assert_holds(order->error, "--to must be later than --from");
    g_autoptr(TestProgram) late = cli_run_badly(fixture, "books @scene.json --to 5", 2);
    g_autoptr(TestProgram) field = cli_run_badly(fixture, "books @scene.json --block Gravity", 2);
    cli_assert_holds(field->error, "it is no body that can move");
}

/* At the start the bob falls freely: a = g, and the rod gives 0. */
static void test_diagram(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {{"mass", 0.5},          {"centre/0", 2},          {"kinetic/force/1", -5},
                                        {"kinetic/force/0", 0}, {"forces/0/force/1", -5}, {"forces/1/force/0", 0}};
    cJSON *root = json_of(fixture, PENDULUM, "diagram @scene.json --block Bob --as json");
    assert_numbers(root, expected, G_N_ELEMENTS(expected));
    const cJSON *rod = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "forces"), 1);
    g_assert_cmpstr(cJSON_GetObjectItem(rod, "partner")->valuestring, ==, "Pivot");
    g_assert_cmpstr(cJSON_GetObjectItem(rod, "kind")->valuestring, ==, "constraint");
    cJSON_Delete(root);
    g_autoptr(TestProgram) nobody = cli_run_badly(fixture, "diagram @scene.json", 2);
    cli_assert_holds(nobody->error, "a body is needed");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/books/throw", test_throw);
    cli_test_add("/cli/books/bounce", test_bounce);
    cli_test_add("/cli/books/pendulum", test_pendulum);
    cli_test_add("/cli/books/pages", test_pages);
    cli_test_add("/cli/books/diagram", test_diagram);
    return g_test_run();
}
