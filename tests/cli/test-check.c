/* tinker check and plan on bodies that start in something solid. */
#include <math.h>
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

/* Whatever is done with the scene, its start is the same; a box that is 0.3 µm too low is not seen in any picture. */
static void test_overlap_by_verb(CliFixture *fixture, gconstpointer data)
{
    static const char *const words[] = {
        "run @a.json",
        "run @a.json --json @out.json",
        "graph @a.json Box.y -o @graph.csv",
        "render @a.json -o @picture.png",
        "render @a.json --time 0.5 -o @picture.png",
        "animate @a.json --fps 2 -o @film.png",
        "plan @a.json",
        "check @a.json",
        "trade @a.json --seconds 0.2",
        "modes @a.json",
        "bench @a.json --seconds 0.05",
        "convert @a.json -o @b.json",
    };
    g_autofree char *scene = cli_write(fixture, "a.json", SCENE(", \"position\": [0.5, 0.5999997]", ""));
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autoptr(TestProgram) program = cli_run_well(fixture, words[i]);
        g_autofree char *told = g_strconcat(program->output, program->error, NULL);
        const char *first = strstr(told, "warning: Box starts 3e-07 m below the top of Floor ");
        if (first == NULL) g_error("%s says nothing: %s", words[i], told);
        g_assert_null(strstr(first + strlen("warning: Box"), "Box starts"));
    }
    g_autofree char *json = cli_read(fixture, "out.json");
    cli_assert_holds(json, "Box starts 3e-07 m below the top of Floor ");
}

/* A box that lies on an incline slides down it from rest: s = g (sin a - mu cos a) t^2 / 2 along it. */
static void test_slides_from_top(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "a.json",
        SCENE(", \"on\": \"Floor\", \"along\": 3",
              ", \"position\": [1, -2], \"orientation\": \"30 deg\", \"width\": 12, \"static_friction\": 0.2, "
              "\"dynamic_friction\": 0.2"));
    g_autoptr(TestProgram) run = cli_run_well(fixture, "run @a.json --at 0.5,1 --columns Box.x,Box.y --csv @out.csv");
    g_assert_null(strstr(run->output, "warning"));
    g_assert_null(strstr(run->output, "impact"));
    g_autofree char *csv = cli_read(fixture, "out.csv");
    g_auto(GStrv) lines = g_strsplit(csv, "\n", -1);
    const double angle = G_PI / 6, acceleration = 9.81 * (sin(angle) - 0.2 * cos(angle));
    for (int i = 1; i <= 2; i++) {
        g_auto(GStrv) cells = g_strsplit(lines[i], ",", -1);
        const double t = 0.5 * i, along = 3 - 0.5 * acceleration * t * t, up = 0.2 + 0.4;
        g_assert_cmpfloat_with_epsilon(g_ascii_strtod(cells[1], NULL), 1 + along * cos(angle) - up * sin(angle), 1e-9);
        g_assert_cmpfloat_with_epsilon(g_ascii_strtod(cells[2], NULL), -2 + along * sin(angle) + up * cos(angle), 1e-9);
    }
}

/* Two carts whose sides are 3.2 m apart and come nearer by 4 m/s meet at 0.8 s: told before the run, as long as it
 * lasts until then, and by the run at the first sample behind it. */
static void test_carts(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "a.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 4, \"interval\": 0.25}, \"blocks\": [{\"type\": \"mass\", \"name\": "
        "\"A\", "
        "\"position\": [-3, 0.2], \"velocity\": [3, 0]}, {\"type\": \"mass\", \"name\": \"B\", \"position\": [1, 0.2], "
        "\"velocity\": [-1, 0]}]}");
    static const char *const meet = "warning: A and B meet at 0.8 s, moved on with their start velocities: they pass "
                                    "through each other, as not both of them have \"collides\" on\n";
    g_autoptr(TestProgram) check = cli_run_well(fixture, "check @a.json");
    cli_assert_holds(check->error, meet);
    g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @a.json");
    cli_assert_holds(plan->output, meet);
    cli_assert_holds(plan->output, "  contact between bodies: they pass through each other\n");
    g_autoptr(TestProgram) brief = cli_run_well(fixture, "plan @a.json --duration 0.75");
    g_assert_null(strstr(brief->output, "meet at"));
    g_autoptr(TestProgram) run = cli_run_well(fixture, "run @a.json");
    cli_assert_holds(run->output, "  warning: A and B overlap at 1 s: they pass through each other, as not both of "
                                  "them have \"collides\" on\n");
}

/* A rope with an end between on a disc's centre: check, plan and run say that it does not run round the disc. */
static void test_small_wheel(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "a.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"support\", \"name\": \"Axle\", "
        "\"solid\": false}, {\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Wheel\"}, {\"type\": \"pin\", "
        "\"ends\": [\"Axle\", "
        "\"Wheel\"]}, {\"type\": \"mass\", \"name\": \"A\", \"position\": [-1, -2]}, {\"type\": \"mass\", \"name\": "
        "\"B\", \"position\": [1, -2]}, {\"type\": \"rope\", \"name\": \"Line\", \"ends\": [\"A\", \"Wheel\", "
        "\"B\"]}]}");
    static const char *const warning =
        "warning: Line: it goes over a small wheel at the centre of Wheel: it neither runs "
        "round its rim nor turns it (for that, wind a cord on it on either side)\n";
    g_autoptr(TestProgram) check = cli_run_well(fixture, "check @a.json");
    cli_assert_holds(check->error, warning);
    g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @a.json");
    cli_assert_holds(plan->output, warning);
    cli_assert_holds(plan->output,
                     "  turning of wheels by ropes: Line slides over Wheel (cords wound on it turn it)\n");
    g_autoptr(TestProgram) run = cli_run_well(fixture, "run @a.json");
    cli_assert_holds(run->output, warning);
}

/* A method that nobody knows has its place, and stands beside the other mistakes; a run that asks for it says the same,
 * one that asks for another goes on. */
static void test_method(CliFixture *fixture, gconstpointer data)
{
    static const char *const method =
        "a.json:2:20: run: there is no method \"rk5\"; did you mean \"rk4\"? (there are auto, ";
    g_autofree char *both =
        cli_write(fixture, "a.json",
                  "{\"tinker\": 1,\n \"run\": {\"method\": \"rk5\", \"duration\": -1},\n \"blocks\": "
                  "[{\"type\": \"mass\"}]}\n");
    g_autoptr(TestProgram) check = cli_run_badly(fixture, "check @a.json", 3);
    cli_assert_holds(check->error, method);
    cli_assert_holds(check->error, "a.json:2:39: run: duration must be greater than 0 s (it is -1 s)\n");
    g_assert_null(strstr(check->error, "warning"));
    g_autofree char *only = cli_write(fixture, "a.json",
                                      "{\"tinker\": 1,\n \"run\": {\"method\": \"rk5\"},\n \"blocks\": [{\"type\": "
                                      "\"mass\"}]}\n");
    g_autoptr(TestProgram) alone = cli_run_badly(fixture, "check @a.json", 3);
    cli_assert_holds(alone->error, method);
    g_assert_cmpstr(strstr(alone->error, "rk5"), ==, g_strrstr(alone->error, "rk5"));
    g_autoptr(TestProgram) run = cli_run_badly(fixture, "run @a.json", 3);
    cli_assert_holds(run->error, method);
    g_assert_cmpstr(strstr(run->error, "rk5"), ==, g_strrstr(run->error, "rk5"));
    g_autoptr(TestProgram) other = cli_run_well(fixture, "run @a.json --method rk4");
    cli_assert_holds(other->output, "method       rk4, step 0.01 s\n");
}

/* Of many blocks of a type that nobody provides it is told once, by the check as by the run. */
static void test_missing_type_once(CliFixture *fixture, gconstpointer data)
{
    static const char *const verbs[] = {"check", "run", "plan"};
    g_autofree char *scene =
        cli_write(fixture, "a.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"sprng\"}, {\"type\": \"mass\"}, {\"type\": "
                  "\"sprng\"}]}");
    for (gsize i = 0; i < G_N_ELEMENTS(verbs); i++) {
        g_autofree char *words = g_strdup_printf("%s @a.json", verbs[i]);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words, 4);
        const char *reason = "no plugin provides the block type \"sprng\" (did you mean \"spring\"?)";
        cli_assert_holds(program->error, reason);
        g_assert_cmpstr(strstr(program->error, reason), ==, g_strrstr(program->error, reason));
    }
}

/* A pendulum that hangs still moves by what rounding makes of its forces, if at all: none of that is told as a number.
 * Free fall is stepped to rounding, and told so. */
static void test_rounding(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "a.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 5}, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\", "
        "\"solid\": false, \"position\": [0.1, 0.3]}, {\"type\": \"mass\", \"position\": [0.1, -0.7], \"velocity\": "
        "[1e-12, 0]}, {\"type\": \"rod\", \"ends\": [\"Support 0\", \"Mass 0\"]}]}");
    g_autoptr(TestProgram) still = cli_run_well(fixture, "run @a.json --method rk4 --no-estimate");
    g_assert_true(g_regex_match_simple("\n  kinetic +0 +0\n", still->output, 0, 0));
    for (int exponent = 14; exponent < 40; exponent++) {
        g_autofree char *noise = g_strdup_printf("e-%d", exponent);
        if (strstr(still->output, noise) != NULL) g_error("noise is told: %s", still->output);
    }
    g_autofree char *fall = cli_write(fixture, "b.json", FREE_FALL);
    g_autoptr(TestProgram) exact = cli_run_well(fixture, "run @b.json --method exact");
    cli_assert_holds(exact->output, "error        right to rounding, estimated\n");
    g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @b.json --method exact");
    cli_assert_holds(plan->output, "right to rounding\n");
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
    g_assert_cmpstr(check->output, ==, "no mistakes found (4 warnings)\n");
    cli_assert_holds(check->error, "Box starts 0.25 m below the top of Floor ");
    cli_assert_holds(check->error, "Ball starts 0.6 m below the top of Floor ");
    cli_assert_holds(check->error, "Box starts 0.3 m below the top of Wall ");
    cli_assert_holds(check->error, "Box and Ball overlap at the start: they pass through each other");
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

/* What switches without end is a mistake of the scene, before any run; a run of it stops. */
static void test_endless_switching(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path = cli_write(fixture, "a.json",
                                      "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"},\n"
                                      "{\"type\": \"motor\", \"name\": \"Drive\", \"ends\": [\"Mass 0\"], "
                                      "\"waveform\": {\"expression\": \"mod(t, 1e-12)\"}}]}\n");
    static const char *const words[] = {"check @a.json", "plan @a.json", "run @a.json"};
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words[i], i < 2 ? 3 : 1);
        cli_assert_holds(program->error, "Drive: from t = ");
        cli_assert_holds(program->error, "it switches every 1e-12 s");
    }
}

/* What prescribes a freedom that is prescribed already, otherwise, is refused before a run: two drives on one disc, two
 * that a gear of any ratio ties, a drive on what cannot turn, a rod between supports of which one moves away, a mass
 * off the line of a slot, off the end of a weld or a pin. Where both ask for the same nothing is wrong. */
static void test_contradictions(CliFixture *fixture, gconstpointer data)
{
    static const char *const words[] = {"check @a.json", "plan @a.json"};
    static const char *const cases[][2] = {
        {"{\"type\": \"drive\", \"name\": \"A\", \"ends\": [\"S\", \"D\"], \"speed\": 1},\n"
         "{\"type\": \"drive\", \"name\": \"B\", \"ends\": [\"S\", \"D\"], \"speed\": 2}",
         ":4:1: A, B: no velocity satisfies"},
        {"{\"type\": \"drive\", \"name\": \"A\", \"ends\": [\"S\", \"D\"]},\n"
         "{\"type\": \"gear\", \"name\": \"G\", \"ends\": [\"D\", \"E\"]},"
         "{\"type\": \"drive\", \"name\": \"B\", \"ends\": [\"S\", \"E\"], \"speed\": 0.5}",
         "A, B, G: no velocity satisfies these"},
        {"{\"type\": \"drive\", \"name\": \"A\", \"ends\": [\"S\", \"D\"]},\n"
         "{\"type\": \"gear\", \"name\": \"G\", \"ends\": [\"D\", \"E\"], \"ratio\": 20},"
         "{\"type\": \"drive\", \"name\": \"B\", \"ends\": [\"S\", \"E\"], \"speed\": 0.5}",
         "A, B, G: no velocity satisfies these"},
        {"{\"type\": \"drive\", \"name\": \"A\", \"ends\": [\"S\", \"D\"]},\n"
         "{\"type\": \"gear\", \"name\": \"G\", \"ends\": [\"D\", \"E\"], \"ratio\": 0.001},"
         "{\"type\": \"drive\", \"name\": \"B\", \"ends\": [\"S\", \"E\"], \"speed\": 0.5}",
         "A, B, G: no velocity satisfies these"},
        {"{\"type\": \"drive\", \"name\": \"A\", \"ends\": [\"S\", \"M\"]}",
         "A: no velocity satisfies this constraint"},
        {"{\"type\": \"support-motion\", \"ends\": [\"S\"], \"waveform\": {\"expression\": \"t\"}},"
         "{\"type\": \"rod\", \"name\": \"R\", \"ends\": [\"S\", \"T\"]}",
         "R: no velocity satisfies this constraint"},
        {"{\"type\": \"slot\", \"name\": \"L\", \"ends\": [\"S\", \"M\"]}",
         "(move one onto the line through the other"},
        {"{\"type\": \"weld\", \"name\": \"L\", \"ends\": [\"S\", \"M\"]}", "(move one to the other"},
        {"{\"type\": \"pin\", \"name\": \"L\", \"ends\": [\"S\", \"M\"]}", "(move one to the other"},
        {"{\"type\": \"gear\", \"name\": \"G\", \"ends\": [\"D\", \"M\"]}", "has no angle"},
        {"{\"type\": \"rack\", \"name\": \"G\", \"ends\": [\"M\", \"D\"], \"radius\": 1}", "has no angle"},
        {"{\"type\": \"drive\", \"name\": \"A\", \"ends\": [\"S\", \"D\"], \"speed\": 1},"
         "{\"type\": \"drive\", \"name\": \"B\", \"ends\": [\"S\", \"D\"], \"speed\": 1}",
         NULL},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases) * G_N_ELEMENTS(words); i++) {
        g_autofree char *text = g_strconcat(
            "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"name\": \"S\", \"solid\": false},"
            "{\"type\": \"support\", \"name\": \"T\", \"position\": [1, 0], \"solid\": false},\n"
            "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"D\"}, {\"type\": \"disc\", \"name\": \"E\", "
            "\"position\": [1, 0]},"
            "{\"type\": \"mass\", \"name\": \"M\", \"position\": [0, 1]},\n"
            "{\"type\": \"pin\", \"ends\": [\"S\", \"D\"]}, {\"type\": \"pin\", \"ends\": [\"T\", \"E\"]},\n",
            cases[i / 2][0], "]}\n", NULL);
        g_autofree char *path = cli_write(fixture, "a.json", text);
        const char *what = cases[i / 2][1];
        if (what == NULL) {
            g_autoptr(TestProgram) good = cli_run_well(fixture, words[i % 2]);
            continue;
        }
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words[i % 2], 3);
        g_autofree char *placed = what[0] == ':' ? g_strconcat(path, what, NULL) : g_strdup(what);
        cli_assert_holds(program->error, placed);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/check/method", test_method);
    cli_test_add("/check/missing-type-once", test_missing_type_once);
    cli_test_add("/check/rounding", test_rounding);
    cli_test_add("/check/carts", test_carts);
    cli_test_add("/check/small-wheel", test_small_wheel);
    cli_test_add("/check/overlap-by-verb", test_overlap_by_verb);
    cli_test_add("/check/slides-from-top", test_slides_from_top);
    cli_test_add("/check/overlap", test_overlap);
    cli_test_add("/check/each-overlap-once", test_each_overlap_once);
    cli_test_add("/check/no-overlap", test_no_overlap);
    cli_test_add("/check/first-system", test_first_system);
    cli_test_add("/check/places", test_places);
    cli_test_add("/check/endless-switching", test_endless_switching);
    cli_test_add("/check/contradictions", test_contradictions);
    return g_test_run();
}
