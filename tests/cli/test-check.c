/* tinker check and plan on bodies that start in something solid. */
#include <string.h>

#include "fixture.h"

#define SCENE(mass, support)                                                                                           \
    "{\"tinker\": 1, \"run\": {\"duration\": 1}, \"blocks\": [{\"type\": \"gravity\"},\n"                              \
    " {\"type\": \"support\", \"name\": \"Floor\"" support "},\n {\"type\": \"mass\", \"name\": \"Box\"" mass "}]}\n"

/* The floor's top is at 0.2, so a box of height 0.8 stands on it at 0.6. */
static void test_overlap(CliFixture *fixture, gconstpointer data)
{
    static const char *const warning =
        "warning: Box starts 0.25 m below the top of Floor and overlaps it, so it passes as from behind (to start on "
        "the "
        "top, move it by [0, 0.25] m; to let it pass, set \"solid\" of Floor to false)\n";
    g_autofree char *scene = cli_write(fixture, "a.json", SCENE(", \"position\": [0.5, 0.35]", ""));
    g_autoptr(TestProgram) check = cli_run_well(fixture, "check @a.json");
    g_assert_cmpstr(check->output, ==, "no mistakes found (1 warning)\n");
    cli_assert_holds(check->error, "a.json: ");
    cli_assert_holds(check->error, warning);
    g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @a.json");
    cli_assert_holds(plan->output, warning);
}

/* Two boxes in one floor, and one of them in a wall as well: each pair once. */
static void test_each_overlap_once(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "a.json",
                  SCENE(", \"position\": [0.5, 0.35]}, {\"type\": \"mass\", \"name\": \"Ball\"",
                        "}, {\"type\": \"support\", \"name\": \"Wall\", \"position\": [0.8, 1], \"orientation\": "
                        "\"90 deg\""));
    g_autoptr(TestProgram) check = cli_run_well(fixture, "check @a.json");
    g_assert_cmpstr(check->output, ==, "no mistakes found (3 warnings)\n");
    cli_assert_holds(check->error, "Box starts 0.25 m below the top of Floor ");
    cli_assert_holds(check->error, "Ball starts 0.6 m below the top of Floor ");
    cli_assert_holds(check->error, "Box starts 0.3 m below the top of Wall ");
}

/* What stands on the top, hangs below, is beside it, or is meant to pass. */
static void test_no_overlap(CliFixture *fixture, gconstpointer data)
{
    static const char *const scenes[] = {
        SCENE(", \"position\": [0, 0.6]", ""),
        SCENE(", \"position\": [0, -2]", ""),
        SCENE(", \"position\": [0, 2]", ", \"position\": [0, 4], \"orientation\": \"180 deg\""),
        SCENE(", \"position\": [0, 2]", ", \"position\": [0, 4]"),
        SCENE(", \"position\": [2.1, 0]", ""),
        SCENE("", ", \"solid\": false"),
    };
    for (gsize i = 0; i < G_N_ELEMENTS(scenes); i++) {
        g_autofree char *scene = cli_write(fixture, "a.json", scenes[i]);
        g_autoptr(TestProgram) check = cli_run_well(fixture, "check @a.json");
        g_assert_cmpstr(check->output, ==, "no mistakes found\n");
        g_assert_cmpstr(check->error, ==, "");
        g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @a.json");
        g_assert_null(strstr(plan->output, "overlaps"));
    }
}

/* The spring-mass system as everybody first builds it. */
static void test_first_system(CliFixture *fixture, gconstpointer data)
{
    static const char *const bundled[] = {"spring-mass", "pendulum", "double-pendulum", "base-excitation"};
    for (gsize i = 0; i < G_N_ELEMENTS(bundled); i++) {
        g_autofree char *words = g_strdup_printf("check '%s/%s.tinker.json'", g_getenv("TINKER_SCENES"), bundled[i]);
        g_autoptr(TestProgram) check = cli_run_well(fixture, words);
        g_assert_cmpstr(check->output, ==, "no mistakes found\n");
    }
}

/* Names with colons and letters of two bytes; the spring's second end is on `end`. */
#define PLACES(end)                                                                                                    \
    "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\"}, {\"type\": \"mass\", \"name\": \"Größe\", \"position\": " \
    "[1, 0]},\n  {\"type\": \"mass\", \"position\": [0, 3]}, {\"type\": \"rod\", \"name\": \"R\", \"ends\": "          \
    "[\"Größe\", \"Mass 0\"]},\n"                                                                                    \
    "  {\"type\": \"rod\", \"name\": \"R: S\", \"ends\": [\"Größe\", \"Support 0\"], \"length\": 2},\n"              \
    "\t{\"type\": \"spring\", \"ends\": [\"Mass 0\", " end "]}]}\n"

/* What only compiling a scene tells is told with the place of the block that it is about. */
static void test_places(CliFixture *fixture, gconstpointer data)
{
    static const char *const words[] = {"check @a.json", "run @a.json"};
    static const struct {
        const char *scene, *start;
    } cases[] = {
        {PLACES("[1, 2]"), "4:2: Spring 0: "},
        {PLACES("\"Support 0\""), "3:3: R: S: its length is 2 m, but its ends are 1 m apart "},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases) * G_N_ELEMENTS(words); i++) {
        g_autofree char *path = cli_write(fixture, "a.json", cases[i / 2].scene);
        g_autofree char *start = g_strdup_printf("tinker: %s:%s", path, cases[i / 2].start);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words[i % 2], 3);
        cli_assert_holds(program->error, start);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/check/overlap", test_overlap);
    cli_test_add("/check/each-overlap-once", test_each_overlap_once);
    cli_test_add("/check/no-overlap", test_no_overlap);
    cli_test_add("/check/first-system", test_first_system);
    cli_test_add("/check/places", test_places);
    return g_test_run();
}
