/* tinker modes: tables, JSON, pictures and responses. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"

/* 1 kg on 100 N/m and 2 N s/m: 10 rad/s, damping ratio 0.1; driven by a motor. */
#define DAMPED                                                                                                         \
    "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"position\": [0, 0]},"                                      \
    " {\"type\": \"mass\", \"position\": [2, 0]},"                                                                     \
    " {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100},"                              \
    " {\"type\": \"damper\", \"ends\": [\"Support 0\", \"Mass 0\"], \"damping\": 2},"                                  \
    " {\"type\": \"motor\", \"ends\": [\"Mass 0\"], \"waveform\": \"sine\"}]}\n"

static gboolean exists(const CliFixture *fixture, const char *name)
{
    g_autofree char *path = cli_path(fixture, name);
    return g_file_test(path, G_FILE_TEST_EXISTS);
}

static void test_table(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", DAMPED);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @scene.json");
    cli_assert_holds(program->output, "degrees of freedom:  2");
    cli_assert_holds(program->output, "stable:              yes");
    cli_assert_holds(program->output, "1.59155");
    cli_assert_holds(program->output, "oscillation");
    cli_assert_holds(program->output, "rigid");
    g_autoptr(TestProgram) one = cli_run_well(fixture, "modes @scene.json --count 1");
    cli_assert_holds(one->output, "and 1 more");
    g_assert_null(strstr(one->output, "oscillation"));
}

/* Places are those of bodies, with the angle of one that turns: a bar of 1 m hangs from its end. */
static void test_places(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *path =
        cli_write(fixture, "bar.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\", \"solid\": false}, "
                  "{\"type\": \"bar\", \"position\": [0.5, 0]}, {\"type\": \"pin\", \"ends\": [\"Support 0\", "
                  "{\"block\": \"Bar 0\", \"at\": [-0.5, 0]}]}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @bar.json --json -");
    cJSON *root = cJSON_Parse(program->output);
    const cJSON *places = cJSON_GetObjectItem(root, "places"), *place = cJSON_GetArrayItem(places, 0);
    g_assert_cmpint(cJSON_GetArraySize(places), ==, 1);
    g_assert_cmpstr(cJSON_GetObjectItem(place, "block")->valuestring, ==, "Bar 0");
    g_assert_cmpfloat(fabs(cJSON_GetObjectItem(place, "y")->valuedouble + 0.5), <, 1e-12);
    g_assert_cmpfloat(fabs(cJSON_GetObjectItem(place, "angle")->valuedouble + G_PI / 2), <, 1e-9);
    cJSON_Delete(root);
}

static void test_json(CliFixture *fixture, gconstpointer data)
{
    static const char *const keys[] = {"state",
                                       "stable",
                                       "growth_rate",
                                       "unbalanced_force",
                                       "places",
                                       "modes",
                                       "mode",
                                       "kind",
                                       "frequency_hz",
                                       "damping_ratio",
                                       "angular_frequency",
                                       "damped_frequency_hz",
                                       "period",
                                       "decay_rate",
                                       "shape",
                                       "undamped_frequencies_hz",
                                       "warnings"};
    g_autofree char *scene = cli_write(fixture, "scene.json", DAMPED);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @scene.json --json -");
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++) {
        g_autofree char *key = g_strdup_printf("\"%s\":", keys[i]);
        cli_assert_holds(program->output, key);
    }
    cli_assert_holds(program->output, "\"rest\"");
    cli_assert_holds(program->error, "1.59155"); /* the table, for people */
    g_autoptr(TestProgram) response =
        cli_run_well(fixture, "modes @scene.json --response 'Motor 0' 'Mass 0.x' --json -");
    static const char *const more[] = {"\"response\":", "\"input\":", "\"peaks\":", "\"amplitude\":", "\"m/N\""};
    for (gsize i = 0; i < G_N_ELEMENTS(more); i++)
        cli_assert_holds(response->output, more[i]);
}

/* The hanging mass of 1 kg on 100 N/m is at rest at y = -2 - g / k; what a motor does to it as time goes on is no load,
 * whatever it begins with. What is constant is one: 4 N more weight are 0.04 m. */
static void test_forcing_is_no_load(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *motor;
        double rest;
    } cases[] = {{"\"angle\": 0, \"waveform\": \"cosine\", \"amplitude\": 50, \"frequency\": 3", -2.0981},
                 {"\"angle\": 0, \"waveform\": \"sine\", \"amplitude\": 50, \"phase\": 1", -2.0981},
                 {"\"angle\": \"-90 deg\", \"waveform\": {\"expression\": \"4 + 7*cos(2*t) + 3*t\"}", -2.1381}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *text = g_strdup_printf(
            "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\", \"position\": [0, 0], "
            "\"solid\": false}, {\"type\": \"mass\", \"position\": [0, -2]}, {\"type\": \"spring\", \"ends\": "
            "[\"Support 0\", \"Mass 0\"], \"stiffness\": 100, \"rest_length\": 2}, {\"type\": \"motor\", \"ends\": "
            "[\"Mass 0\"], %s}]}",
            cases[i].motor);
        g_autofree char *scene = cli_write(fixture, "forced.json", text);
        g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @forced.json --json -");
        cJSON *root = cJSON_Parse(program->output);
        g_assert_nonnull(root);
        const cJSON *place = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "places"), 0);
        g_assert_cmpfloat(fabs(cJSON_GetObjectItem(place, "x")->valuedouble), <, 1e-9);
        g_assert_cmpfloat(fabs(cJSON_GetObjectItem(place, "y")->valuedouble - cases[i].rest), <, 1e-9);
        cJSON_Delete(root);
    }
}

/* A block of 1 kg that slides on a rough floor by a spring of 100 N/m: what was assumed is told. */
static void test_assumed(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "floor.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
                  " {\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -0.3], \"height\": 0.2, "
                  "\"width\": 9, \"static_friction\": 0.3, \"dynamic_friction\": 0.2},"
                  " {\"type\": \"support\", \"position\": [-2, 0], \"solid\": false},"
                  " {\"type\": \"mass\", \"height\": 0.4, \"position\": [1, 0]},"
                  " {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100, "
                  "\"rest_length\": 2}]}\n");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @floor.json --json @floor-modes.json");
    cli_assert_holds(program->output, "degrees of freedom:  1");
    cli_assert_holds(program->output,
                     "assumed:             Mass 0 stays on Floor and slides along it; friction is left out");
    g_autofree char *json = cli_read(fixture, "floor-modes.json");
    static const char *const parts[] = {"\"assumed\":", "\"on\":\t\"Floor\"", "\"contact\":\t\"slides\"",
                                        "\"friction_left_out\":\ttrue"};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        cli_assert_holds(json, parts[i]);
}

static void test_pictures(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", DAMPED);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @scene.json -o @shape.png --size 300x200");
    g_assert_true(exists(fixture, "shape-1.png") && exists(fixture, "shape-2.png"));
    g_assert_false(exists(fixture, "shape-3.png") || exists(fixture, "shape.png"));
    g_autoptr(TestProgram) drawing = cli_run_well(fixture, "modes @scene.json -o @shape.svg --count 2");
    g_autofree char *svg = cli_read(fixture, "shape-2.svg");
    cli_assert_holds(svg, "<svg");
    g_autoptr(TestProgram) plot =
        cli_run_well(fixture, "modes --response 'Motor 0' 'Mass 0.x' @scene.json -o @response.svg --linear");
    g_assert_true(exists(fixture, "response.svg"));
}

/* A cord that is longer than its way hangs in a picture of a mode, too: a line of many pieces in the colour of what is
 * slack, of which the marks of its ends are as well. */
static void test_picture_of_slack_cord(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "scene.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
                  "{\"type\": \"support\", \"name\": \"Axle\", \"position\": [0, 3], \"solid\": false},"
                  "{\"type\": \"support\", \"name\": \"Hook\", \"position\": [0, 1], \"solid\": false},"
                  "{\"type\": \"disc\", \"name\": \"D\", \"position\": [0, 2.9], \"radius\": 0.2, \"solid\": false},"
                  "{\"type\": \"pin\", \"ends\": [\"Axle\", {\"block\": \"D\", \"at\": [0, 0.1]}]},"
                  "{\"type\": \"cord\", \"ends\": [\"D\", \"Hook\"], \"length\": 3}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @scene.json -o @shape.svg --theme print");
    g_autofree char *svg = cli_read(fixture, "shape-1.svg");
    g_auto(GStrv) lines = g_strsplit(svg, "\n", -1);
    guint hanging = 0;
    for (char **line = lines; *line != NULL; line++) {
        g_auto(GStrv) pieces = g_strsplit(*line, " L ", -1);
        if (strstr(*line, "stroke:rgb(75.294118%,0%,6.27451%)") != NULL && g_strv_length(pieces) > 10) hanging++;
    }
    g_assert_cmpuint(hanging, ==, 1);
}

/* Every row of the CSV against 1 / (100 - omega^2 + 2 i omega). */
static void test_response_csv(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", DAMPED);
    g_autoptr(TestProgram) program = cli_run_well(
        fixture, "modes @scene.json --response 'Motor 0' 'Mass 0.x' --from 0.5 --to '20 rad/s' --points 20 -o -");
    g_auto(GStrv) lines = g_strsplit(program->output, "\n", -1);
    g_assert_cmpstr(lines[0], ==, "frequency [Hz],amplitude [m/N],phase [deg]");
    guint rows = 0;
    for (char **line = lines + 1; **line != '\0'; line++, rows++) {
        g_auto(GStrv) fields = g_strsplit(*line, ",", -1);
        double omega = 2 * G_PI * g_ascii_strtod(fields[0], NULL), real = 100 - omega * omega;
        g_assert_cmpfloat_with_epsilon(g_ascii_strtod(fields[1], NULL) * hypot(real, 2 * omega), 1, 1e-10);
        g_assert_cmpfloat_with_epsilon(g_ascii_strtod(fields[2], NULL), -atan2(2 * omega, real) * 180 / G_PI, 1e-8);
    }
    g_assert_cmpuint(rows, >=, 20);
    g_assert_true(g_str_has_prefix(lines[1], "0.5,"));
}

static void test_no_rest(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "fall.json", FREE_FALL);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @fall.json");
    cli_assert_holds(program->error, "no rest state was found");
    cli_assert_holds(program->output, "balanced:            no");
    g_autoptr(TestProgram) start = cli_run_well(fixture, "modes @fall.json --state start");
    g_assert_cmpstr(start->error, ==, "");
}

/* A mass on a spring without length, at its place: 10 rad/s in all directions, and a damper that has none. */
static void test_one_place(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "middle.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"solid\": false}, {\"type\": \"mass\"},"
        " {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100, \"rest_length\": 0},"
        " {\"type\": \"damper\", \"ends\": [\"Support 0\", \"Mass 0\"], \"damping\": 2}]}\n");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @middle.json --json -");
    cli_assert_holds(program->error, "the resistance has no direction there");
    cli_assert_holds(program->output, "the resistance has no direction there");
    cli_assert_holds(program->error, "1.59155");
    g_autofree char *longer = cli_write(
        fixture, "longer.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\", \"solid\": false}, {\"type\": \"mass\"},"
        " {\"type\": \"spring\", \"ends\": [\"Support 0\", \"Mass 0\"], \"stiffness\": 100, \"rest_length\": 1}]}\n");
    g_autoptr(TestProgram) rest = cli_run_well(fixture, "modes @longer.json");
    cli_assert_holds(rest->error, "Spring 0: its ends are at one place");
    cli_assert_holds(rest->error, "no rest state was found");
    g_autoptr(TestProgram) start = cli_run_well(fixture, "modes @longer.json --state start");
    cli_assert_holds(start->error, "it has no direction there");
}

static void test_refusals(CliFixture *fixture, gconstpointer data)
{
    static const struct {
        const char *words, *says;
    } rows[] = {
        {"modes @scene.json --response 'Motor 0'", "the quantity that answers is missing"},
        {"modes @scene.json 'Mass 0.x'", "no --response"},
        {"modes @scene.json --response 'Spring 0' 'Mass 0.x'", "\"Motor 0\""},
        {"modes @scene.json --response 'Motor 0' 'Mass 0.z'", "it has x, y"},
        {"modes @scene.json --response 'Motor 0' 'Mass 0.x' --from 3 --to 2", "below its end"},
        {"modes @scene.json --from 3", "belong to a --response"},
        {"modes @scene.json --state moving", "--state"},
        {"modes @scene.json -o shapes.gif", ".png"},
        {"modes @scene.json --count 0", "--count"},
    };
    g_autofree char *scene = cli_write(fixture, "scene.json", DAMPED);
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, rows[i].words, 2);
        cli_assert_holds(program->error, rows[i].says);
    }
}

/* A block is named, and not which of its quantities answers. */
static void test_response_without_quantity(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "a.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [3, 0]}, "
                  "{\"type\": \"spring\", "
                  "\"ends\": [\"Support 0\", \"Mass 0\"]}, {\"type\": \"motor\", \"ends\": [\"Mass 0\"]}]}");
    g_autoptr(TestProgram) program = cli_run_badly(fixture, "modes @a.json --response 'Motor 0' 'Mass 0'", 2);
    cli_assert_holds(program->error,
                     "--response: column \"Mass 0\": the quantity is missing, as in \"Mass 0.x\" (it has x, y, ");
}

/* A pendulum on a cart that gains 3 m/s each second: it stands still in the modes, and that is told. */
static void test_held(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "cart.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"},"
        " {\"type\": \"support\", \"name\": \"Cart\", \"solid\": false},"
        " {\"type\": \"mass\", \"position\": [0, -1]},"
        " {\"type\": \"rod\", \"ends\": [\"Cart\", \"Mass 0\"]},"
        " {\"type\": \"support-motion\", \"ends\": [\"Cart\"], \"waveform\": {\"expression\": \"2*t + 1.5*t^2\"}}]}\n");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "modes @cart.json --json @cart-modes.json");
    cli_assert_holds(program->output, "assumed:             Cart is held still where it is at t = 0; its motion there, "
                                      "2 m/s, 3 m/s^2, is left out\n");
    g_autofree char *text = cli_read(fixture, "cart-modes.json");
    cJSON *root = cJSON_Parse(text), *held = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "held"), 0);
    g_assert_cmpstr(cJSON_GetObjectItem(held, "block")->valuestring, ==, "Cart");
    g_assert_cmpfloat(cJSON_GetArrayItem(cJSON_GetObjectItem(held, "acceleration"), 0)->valuedouble, ==, 3);
    cJSON_Delete(root);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/modes/response-without-quantity", test_response_without_quantity);
    cli_test_add("/cli/modes/table", test_table);
    cli_test_add("/cli/modes/json", test_json);
    cli_test_add("/cli/modes/places", test_places);
    cli_test_add("/cli/modes/assumed", test_assumed);
    cli_test_add("/cli/modes/pictures", test_pictures);
    cli_test_add("/cli/modes/picture-of-slack-cord", test_picture_of_slack_cord);
    cli_test_add("/cli/modes/response-csv", test_response_csv);
    cli_test_add("/cli/modes/no-rest", test_no_rest);
    cli_test_add("/cli/modes/one-place", test_one_place);
    cli_test_add("/cli/modes/refusals", test_refusals);
    cli_test_add("/cli/modes/forcing-is-no-load", test_forcing_is_no_load);
    cli_test_add("/cli/modes/held", test_held);
    return g_test_run();
}
