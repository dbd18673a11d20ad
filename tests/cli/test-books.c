/* tinker books and the numbers of tinker diagram: against closed forms of a throw, a bounce and a pendulum. */
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

#define DISC_DROPPED                                                                                                   \
    SCENE("{\"type\": \"support\", \"name\": \"Floor\", \"height\": 0, \"width\": 9, \"restitution\": 0.5},"           \
          "{\"type\": \"disc\", \"name\": \"Disc\", \"mass\": 3, \"radius\": 0.1, \"position\": [0, 0.9]}")

/* Level, at rest: the rod does not pull, and the bob falls. */
#define PENDULUM                                                                                                       \
    SCENE("{\"type\": \"support\", \"name\": \"Pivot\", \"solid\": false},"                                            \
          "{\"type\": \"mass\", \"name\": \"Bob\", \"mass\": 0.5, \"position\": [2, 0]},"                              \
          "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Pivot\", \"Bob\"]}")

/* 1 kg and, behind it, 3 kg on a rod, struck along it at 0.25 s. */
#define STRUCK                                                                                                         \
    SCENE("{\"type\": \"mass\", \"name\": \"A\"},"                                                                     \
          "{\"type\": \"mass\", \"name\": \"B\", \"mass\": 3, \"position\": [2, 0]},"                                  \
          "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"A\", \"B\"]},"                                          \
          "{\"type\": \"impulse\", \"name\": \"Blow\", \"ends\": [\"A\"], \"impulse\": 4, \"time\": 0.25}")

/* A blow on the very bearing of a box that is carried along at 0.3 m/s: what the pin gives it, its motion does not
 * show.
 */
#define CARRIED                                                                                                        \
    SCENE("{\"type\": \"support\", \"name\": \"S\", \"solid\": false},"                                                \
          "{\"type\": \"support-motion\", \"ends\": [\"S\"], \"waveform\": {\"expression\": \"0.3*t\"}},"              \
          "{\"type\": \"box\", \"name\": \"Box\", \"position\": [0, -1], \"height\": 2},"                              \
          "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [\"S\", {\"block\": \"Box\", \"at\": [0, 1]}]},"           \
          "{\"type\": \"impulse\", \"name\": \"Blow\", \"ends\": [{\"block\": \"Box\", \"at\": [0, 1]}], "             \
          "\"impulse\": 4, \"time\": 0.25}")

/* Dropped by 0.8 m with a rod askew between them: A lands at 0.4 s with 4 m/s and leaves with 2 m/s. */
#define DUMBBELL                                                                                                       \
    SCENE("{\"type\": \"support\", \"name\": \"Floor\", \"height\": 0, \"width\": 9, \"restitution\": 0.5,"            \
          "\"static_friction\": 0, \"dynamic_friction\": 0},"                                                          \
          "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0.8], \"width\": 0, \"height\": 0},"                \
          "{\"type\": \"mass\", \"name\": \"B\", \"position\": [1, 1.8], \"width\": 0, \"height\": 0},"                \
          "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"A\", \"B\"]}")

/* Three that land at one time, but for rounding. */
#define DROPPED_TOGETHER                                                                                               \
    SCENE("{\"type\": \"support\", \"name\": \"Floor\", \"height\": 0.1, \"width\": 9, \"restitution\": 0.5},"         \
          "{\"type\": \"mass\", \"name\": \"A\", \"position\": [-1.3, 0.95], \"height\": 0.2},"                        \
          "{\"type\": \"mass\", \"name\": \"B\", \"position\": [0.1, 1.0], \"height\": 0.3},"                          \
          "{\"type\": \"disc\", \"name\": \"C\", \"position\": [1.3, 1.18], \"radius\": 0.33}")

/* 1 kg runs at 2 m/s into a bumper of 400 N/m and 4 N s/m, after 1 s: its damper pushes at once. */
#define BUMPED                                                                                                         \
    "{\"tinker\": 1, \"run\": {\"duration\": 2, \"tolerance\": 1e-12}, \"blocks\": ["                                  \
    "{\"type\": \"support\", \"name\": \"Wall\", \"position\": [3, 0], \"solid\": false},"                             \
    "{\"type\": \"mass\", \"name\": \"Ball\", \"velocity\": [2, 0]},"                                                  \
    "{\"type\": \"bumper\", \"name\": \"Bumper\", \"ends\": [\"Wall\", \"Ball\"], \"stiffness\": 400, \"damping\": "   \
    "4, "                                                                                                              \
    "\"length\": 1}]}"

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

/* That the numbers of a whole answer are these. */
static void assert_answer(CliFixture *fixture, const char *scene, const char *words, const Expected *expected,
                          gsize count)
{
    cJSON *root = json_of(fixture, scene, words);
    assert_numbers(root, expected, count);
    cJSON_Delete(root);
}

/* The force begins with a jump and lets go with a kink, both between any two times that are looked at. Shortened by
 * x = v/w e^(-2 t) sin w t, w^2 = 400 - 2^2, it pushes with 400 x + 4 dx/dt until tan w t = -4 w/(400 - 8). */
static void test_bumper(CliFixture *fixture, gconstpointer data)
{
    const double w = sqrt(396), over = (acos(-1) - atan(4 * w / 392)) / w;
    const double leaves = -2 * exp(-2 * over) * (cos(w * over) - 2 / w * sin(w * over));
    const double at = 0.05, deep = 2 * exp(-2 * at) * (cos(w * at) - 2 / w * sin(w * at));
    const struct {
        const char *words;
        double speed;
    } cases[] = {{"books @scene.json --to 1.05 --as json", deep},
                 {"books @scene.json --to 1.3 --as json", -leaves},
                 {"books @scene.json --as json", -leaves}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const double v = cases[i].speed;
        const Expected expected[] = {{"energy/work/Bumper", 0.5 * (v * v - 4)},
                                     {"momentum/impulses/Bumper/0", v - 2},
                                     {"energy/residual", 0},
                                     {"momentum/residual", 0},
                                     {"angular/residual", 0}};
        cJSON *root = json_of(fixture, BUMPED, cases[i].words);
        assert_numbers(root, expected, G_N_ELEMENTS(expected));
        cJSON_Delete(root);
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
    assert_answer(fixture, THROWN, "books @scene.json --to 1 --about 2,1 --as json", expected, G_N_ELEMENTS(expected));
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

/* What happens at an instant is of the interval that ends there, as is the state behind it. */
static void test_ends_at_impact(CliFixture *fixture, gconstpointer data)
{
    static const Expected lands[] = {
        {"impacts/0/time", 0.4},
        {"impacts/0/impulse/1", 18},
        {"impacts/0/work", -18},
        {"energy/kinetic/1", 6},
        {"momentum/impulses/Gravity/1", -12},
        {"momentum/impulses/Floor/1", 18},
        {"energy/work/Floor", -18},
        {"momentum/residual", 0},
        {"energy/residual", 0},
    };
    assert_answer(fixture, DROPPED, "books @scene.json --to 0.4 --as json", lands, G_N_ELEMENTS(lands));
    static const Expected leaves[] = {
        {"energy/kinetic/0", 6}, {"momentum/momentum/0/1", 6}, {"momentum/momentum/1/1", 3}, {"momentum/residual", 0}};
    assert_answer(fixture, DROPPED, "books @scene.json --from 0.4 --to 0.5 --as json", leaves, G_N_ELEMENTS(leaves));
    static const Expected struck[] = {{"momentum/impulses/Blow/0", 4},
                                      {"energy/work/Blow", 2},
                                      {"momentum/momentum/1/0", 4},
                                      {"momentum/residual", 0}};
    assert_answer(fixture, STRUCK, "books @scene.json --to 0.25 --as json", struck, G_N_ELEMENTS(struck));
}

/* What a joint answers to a blow is the joint's. */
static void test_struck(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {
        {"momentum/impulses/Blow/0", 4}, {"energy/work/Blow", 2}, {"energy/work/Rod", 0},
        {"momentum/residual", 0},        {"energy/residual", 0},  {"angular/residual", 0},
        {"momentum/momentum/1/0", 4},
    };
    assert_answer(fixture, STRUCK, "books @scene.json --to 0.5 --as json", expected, G_N_ELEMENTS(expected));
    static const Expected behind[] = {
        {"momentum/impulses/Rod/0", 3}, {"energy/work/Rod", 1.5}, {"momentum/residual", 0}, {"energy/residual", 0}};
    assert_answer(fixture, STRUCK, "books @scene.json --block B --to 0.5 --as json", behind, G_N_ELEMENTS(behind));
}

/* A blow at time 0, or a landing, comes behind the start: 4 N s on 4 kg, and a ball that is thrown off the floor with
 * half its speed. */
static void test_blow_at_start(CliFixture *fixture, gconstpointer data)
{
    static const char thrown[] =
        SCENE("{\"type\": \"support\", \"name\": \"Floor\", \"height\": 0, \"restitution\": 0.5},"
              "{\"type\": \"mass\", \"name\": \"A\", \"mass\": 2, \"width\": 0, \"height\": 0, \"velocity\": [0, -3]}");
    static const Expected struck[] = {
        {"momentum/momentum/0/0", 0}, {"momentum/impulses/Blow/0", 4}, {"energy/work/Blow", 2},
        {"energy/kinetic/0", 0},      {"momentum/residual", 0},        {"energy/residual", 0},
        {"angular/residual", 0},      {"momentum/momentum/1/0", 4},    {"impacts/0/impulse/0", 4},
    };
    static const Expected bounced[] = {
        {"energy/kinetic/0", 9},       {"impacts/0/impulse/1", 9}, {"energy/work/Floor", -6.75},
        {"momentum/momentum/0/1", -6}, {"momentum/residual", 0},   {"energy/residual", 0},
    };
    g_autoptr(GString) at_start = g_string_new(STRUCK);
    g_string_replace(at_start, "\"time\": 0.25", "\"time\": 0", 0);
    assert_answer(fixture, at_start->str, "books @scene.json --to 0.5 --as json", struck, G_N_ELEMENTS(struck));
    assert_answer(fixture, thrown, "books @scene.json --to 0.1 --as json", bounced, G_N_ELEMENTS(bounced));
}

/* A blow at time 0 of a run that takes two tries: the first is off by all, the second to 1e-7. 0.4 N s on an arm of 1 m
 * are 0.4 N m s, which a central force keeps. */
static void test_blow_of_second_try(CliFixture *fixture, gconstpointer data)
{
    static const char orbit[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 4, \"method\": \"rk4\", \"accuracy\": 1e-7}, \"blocks\": ["
        "{\"type\": \"mass\", \"name\": \"A\", \"position\": [1, 0]},"
        "{\"type\": \"impulse\", \"name\": \"Blow\", \"ends\": [\"A\"], \"impulse\": 0.4, \"angle\": \"90 deg\"},"
        "{\"type\": \"law-force\", \"ends\": [\"A\"], \"potential\": \"-1/sqrt(x^2+y^2)\"}]}";
    static const Expected expected[] = {
        {"momentum/momentum/0/1", 0},   {"momentum/impulses/Blow/1", 0.4}, {"energy/work/Blow", 0.08},
        {"angular/impulses/Blow", 0.4}, {"impacts/0/impulse/1", 0.4},
    };
    assert_answer(fixture, orbit, "books @scene.json --as json", expected, G_N_ELEMENTS(expected));
}

static void test_blow_that_is_held(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {{"impacts/0/work", 1.2},   {"impacts/0/impulse/0", 4},
                                        {"impacts/1/work", -1.2},  {"impacts/1/impulse/0", -4},
                                        {"energy/work/Blow", 1.2}, {"momentum/impulses/Blow/0", 4},
                                        {"momentum/residual", 0},  {"energy/residual", 0}};
    assert_answer(fixture, CARRIED, "books @scene.json --to 0.3 --as json", expected, G_N_ELEMENTS(expected));
}

/* With p from the floor and r (1, 1) from the rod: A changes by (-r, p - r), B by (r, r), and along the rod by the
 * same: r = p / 4, and 3 p / 4 = 6. */
static void test_dumbbell(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {
        {"momentum/impulses/Floor/0", 0}, {"momentum/impulses/Floor/1", 8}, {"energy/work/Floor", -8},
        {"momentum/residual", 0},         {"energy/residual", 0},           {"angular/residual", 0},
    };
    assert_answer(fixture, DUMBBELL, "books @scene.json --to 0.45 --as json", expected, G_N_ELEMENTS(expected));
    cJSON *root = json_of(fixture, DUMBBELL, "books @scene.json --block B --from 0.39 --to 0.4000001 --as json");
    g_assert_cmpfloat(fabs(number_at(root, "momentum/impulses/Rod/0") - 2), <, 1e-5);
    g_assert_cmpfloat(fabs(number_at(root, "momentum/impulses/Rod/1") - 2), <, 1e-5);
    g_assert_cmpfloat(number_at(root, "energy/residual"), <, 1e-8);
    cJSON_Delete(root);
}

/* A ball that bounces down to rest pulls by a rod at a plate on the floor, less and less: what stops the plate where it
 * slides too slowly to be seen is the floor's, as all else that does. */
#define PULLED_LESS                                                                                                    \
    "{\"tinker\": 1, \"run\": {\"duration\": 2.2, \"tolerance\": 1e-12}, \"blocks\": [{\"type\": \"gravity\"},"        \
    "{\"type\": \"support\", \"name\": \"Floor\", \"width\": 40, \"height\": 0.4, \"restitution\": 0.3,"               \
    " \"static_friction\": 0.287, \"dynamic_friction\": 0.243},"                                                       \
    "{\"type\": \"plate\", \"name\": \"Plate\", \"mass\": 2.732, \"position\": [-4.471, 0.5], \"velocity\": [-0.124, " \
    "0],"                                                                                                              \
    " \"corners\": [[0.4, 0.3], [-0.4, 0.3], [-0.5, -0.3], [0.5, -0.3]]},"                                             \
    "{\"type\": \"mass\", \"name\": \"Ball\", \"mass\": 0.866, \"width\": 0.6, \"height\": 0.8, "                      \
    "\"position\": [1.639, 1.042], \"velocity\": [1.93, 0]},"                                                          \
    "{\"type\": \"rod\", \"name\": \"Rod\", \"ends\": [\"Ball\", {\"block\": \"Plate\", \"at\": [-0.191, 0.094]}]}]}"

static void test_pulled_less(CliFixture *fixture, gconstpointer data)
{
    cJSON *root = json_of(fixture, PULLED_LESS, "books @scene.json --block Plate --from 0.33 --to 1.1 --as json");
    static const char *const accounts[] = {"energy", "momentum", "angular"};
    for (gsize i = 0; i < G_N_ELEMENTS(accounts); i++) {
        g_autofree char *residual = g_strconcat(accounts[i], "/residual", NULL),
                        *scale = g_strconcat(accounts[i], "/scale", NULL);
        g_assert_cmpfloat(fabs(number_at(root, residual)), <, 1e-10 * number_at(root, scale));
    }
    cJSON_Delete(root);
}

/* 1 kg each, from -4 to 2 m/s. */
static void test_dropped_together(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {
        {"momentum/impulses/Floor/1", 18}, {"energy/work/Floor", -18}, {"momentum/residual", 0}, {"energy/residual", 0},
        {"angular/residual", 0},
    };
    assert_answer(fixture, DROPPED_TOGETHER, "books @scene.json --to 0.5 --as json", expected, G_N_ELEMENTS(expected));
}

/* As impulses a blow is a force over the step that it falls into, wherever books begin and end. */
static void test_bounce_as_impulse(CliFixture *fixture, gconstpointer data)
{
    static const Expected expected[] = {{"momentum/residual", 0}, {"energy/residual", 0}};
    cJSON *root = json_of(fixture, DISC_DROPPED,
                          "books @scene.json --from 0.12345 --to 0.5 --contacts impulse --step 0.01 --as json");
    assert_numbers(root, expected, G_N_ELEMENTS(expected));
    const double gained = number_at(root, "momentum/momentum/1/1") - number_at(root, "momentum/momentum/0/1");
    const double floor = number_at(root, "momentum/impulses/Floor/1");
    g_assert_cmpfloat(floor, >, 10);
    g_assert_cmpfloat(fabs(floor - gained - 30 * (0.5 - 0.12345)), <, 1e-9);
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

/* A mass at rest, pulled by a damper of c = 0.1 N s/m whose support swings with 20 m/s and w = 2000/s: v' = c (u' - v).
 * In 100 s that is more often than can be told. */
static void test_unsettled(CliFixture *fixture, gconstpointer data)
{
    static const char scene[] =
        "{\"tinker\": 1, \"run\": {\"duration\": 100}, \"blocks\": [{\"type\": \"mass\"},"
        "{\"type\": \"support\", \"name\": \"Shaken\", \"position\": [2, 0], \"solid\": false},"
        "{\"type\": \"support-motion\", \"ends\": [\"Shaken\"], \"amplitude\": 0.01, \"frequency\": 2000},"
        "{\"type\": \"damper\", \"name\": \"D\", \"ends\": [\"Mass 0\", \"Shaken\"], \"damping\": 0.1}]}";
    const double c = 0.1, w = 2000, size = c * 20 / (c * c + w * w), times[] = {0.05, 100};
    for (int i = 0; i < 2; i++) {
        const double t = times[i], v = size * (c * cos(w * t) + w * sin(w * t) - c * exp(-c * t));
        g_autofree char *words = g_strdup_printf("books @scene.json --as json --to %g", t);
        cJSON *root = json_of(fixture, scene, words);
        const double unsettled = number_at(root, "unsettled");
        const double impulse = fabs(number_at(root, "momentum/impulses/D/0") - v) / number_at(root, "momentum/scale");
        const double work = fabs(number_at(root, "energy/work/D") - v * v / 2) / number_at(root, "energy/scale");
        g_assert_cmpfloat(fmax(work, impulse), <=, 2 * unsettled + 1e-9);
        g_assert_true(i == 0 ? unsettled == 0 : unsettled > 1e-7);
        cJSON_Delete(root);
    }
    g_autoptr(TestProgram) text = cli_run_well(fixture, "books @scene.json");
    cli_assert_holds(text->output, "The sums are right to about ");
}

/* What holds a block of 1 kg on an incline of 20 degrees: across, the normal force m g cos a gives -m g cos a sin a,
 * and friction, m g sin a, the opposite; upwards m g cos^2 a and m g sin^2 a. In one row they would be 0 N. */
static void test_normal_force_and_friction_apart(CliFixture *fixture, gconstpointer data)
{
    const double weight = 9.81, angle = 20 * G_PI / 180;
    g_autofree char *words =
        g_strdup_printf("books '%s/friction-incline.tinker.json' --block 'Block 1' --to 2", g_getenv("TINKER_SCENES"));
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    const double truth[2][2] = {{-weight * cos(angle) * sin(angle), weight * cos(angle) * cos(angle)},
                                {weight * sin(angle) * cos(angle), weight * sin(angle) * sin(angle)}};
    static const char *const names[] = {"20 degrees (Normal force)", "20 degrees (Friction)"};
    for (int part = 0; part < 2; part++) {
        const char *row = strstr(program->output, names[part]);
        g_assert_nonnull(row);
        char *end;
        const double x = g_ascii_strtod(row + strlen(names[part]), &end), y = g_ascii_strtod(end, NULL);
        g_assert_cmpfloat_with_epsilon(x, truth[part][0], 1e-5);
        g_assert_cmpfloat_with_epsilon(y, truth[part][1], 1e-5);
    }
}

static void test_pages(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = cli_write(fixture, "scene.json", THROWN);
    g_autoptr(TestProgram) text = cli_run_well(fixture, "books @scene.json --to 1");
    cli_assert_holds(text->output, "Work and energy (J)\n  kinetic energy before   25\n  Gravity                 40\n"
                                   "  = kinetic energy after  65\n");
    g_autoptr(TestProgram) csv = cli_run_well(fixture, "books @scene.json --to 1 --as csv");
    g_assert_true(g_str_has_prefix(csv->output, "block,force_x [N],force_y [N],work [J],"));
    g_autoptr(TestProgram) twice = cli_run_well(fixture, "books @scene.json --block Ball --block Ball --to 1");
    cli_assert_holds(twice->output, "  kinetic energy before   25\n");
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
    g_autoptr(TestProgram) page = cli_run_well(fixture, "diagram @scene.json --block Bob");
    cli_assert_holds(page->output, "  force                x [N]  y [N]  size [N]\n");
    g_autoptr(TestProgram) nobody = cli_run_badly(fixture, "diagram @scene.json", 2);
    cli_assert_holds(nobody->error, "a body is needed");
    g_autoptr(TestProgram) held = cli_run_badly(fixture, "diagram @scene.json --block Bob --block Pivot", 2);
    cli_assert_holds(held->error, "\"Pivot\": it cannot move, and has a diagram of its own alone");
    g_autoptr(TestProgram) other = cli_run_badly(fixture, "diagram @scene.json --block Bob -o @d.jpg", 2);
    cli_assert_holds(other->error, "no picture is made with this ending");
    g_autoptr(TestProgram) equations = cli_run_badly(fixture, "equations @scene.json -o @d.jpg", 2);
    cli_assert_holds(equations->error, "equations are written as text, not drawn");
    g_autoptr(TestProgram) field = cli_run_well(fixture, "diagram @scene.json --block Gravity");
    cli_assert_holds(field->output, "nothing acts on it");
}

/* 2 kg that lie on 10 kg, taken as one: the floor carries 120 N, and what they press on each other with is left out. */
static void test_touching(CliFixture *fixture, gconstpointer data)
{
    g_free(cli_write(
        fixture, "a.json",
        SCENE("{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -0.2], \"width\": 6},"
              "{\"type\": \"box\", \"name\": \"A\", \"mass\": 10, \"width\": 1, \"height\": 1, \"position\": [0, 0.5]},"
              "{\"type\": \"box\", \"name\": \"B\", \"mass\": 2, \"width\": 0.4, \"height\": 0.4, \"position\": [0, "
              "1.2]}")));
    g_autoptr(TestProgram) diagram = cli_run_well(fixture, "diagram @a.json --block A --block B --as json");
    cJSON *root = cJSON_Parse(diagram->output);
    const cJSON *force;
    double lift = 0;
    cJSON_ArrayForEach(force, cJSON_GetObjectItem(root, "forces"))
    {
        const char *by = cJSON_GetObjectItem(force, "from")->valuestring;
        g_assert_true(strcmp(by, "Floor") == 0 || strcmp(by, "Gravity") == 0);
        if (strcmp(by, "Floor") == 0) lift += cJSON_GetArrayItem(cJSON_GetObjectItem(force, "force"), 1)->valuedouble;
    }
    g_assert_cmpfloat_with_epsilon(lift, 120, 1e-9);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "cancelled")), ==, 2);
    cJSON_Delete(root);
    g_autoptr(TestProgram) books = cli_run_well(fixture, "books @a.json");
    cli_assert_holds(books->output, "Between the bodies: forces cancel, and only work counts\n  A\n  B\n");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/books/throw", test_throw);
    cli_test_add("/cli/books/touching", test_touching);
    cli_test_add("/cli/books/bounce", test_bounce);
    cli_test_add("/cli/books/ends-at-impact", test_ends_at_impact);
    cli_test_add("/cli/books/struck", test_struck);
    cli_test_add("/cli/books/blow-that-is-held", test_blow_that_is_held);
    cli_test_add("/cli/books/blow-at-start", test_blow_at_start);
    cli_test_add("/cli/books/blow-of-second-try", test_blow_of_second_try);
    cli_test_add("/cli/books/bumper", test_bumper);
    cli_test_add("/cli/books/dumbbell", test_dumbbell);
    cli_test_add("/cli/books/pulled-less", test_pulled_less);
    cli_test_add("/cli/books/dropped-together", test_dropped_together);
    cli_test_add("/cli/books/bounce-as-impulse", test_bounce_as_impulse);
    cli_test_add("/cli/books/pendulum", test_pendulum);
    cli_test_add("/cli/books/normal-force-and-friction-apart", test_normal_force_and_friction_apart);
    cli_test_add("/cli/books/pages", test_pages);
    cli_test_add("/cli/books/unsettled", test_unsettled);
    cli_test_add("/cli/books/diagram", test_diagram);
    return g_test_run();
}
