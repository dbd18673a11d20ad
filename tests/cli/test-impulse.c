/* --contacts: what a run, a plan and a benchmark say of contact as impulses. */
#include <math.h>
#include <string.h>

#include "fixture.h"

#define DROP                                                                                                           \
    "{\"tinker\": 1, \"run\": {\"duration\": 1, \"interval\": 0.5, \"step\": 0.001},\n"                                \
    " \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\"}, {\"type\": \"mass\", \"position\": [0, 2]}]}\n"

static void test_run(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "drop.json", DROP);
    g_autoptr(TestProgram) events = cli_run_well(fixture, "run @drop.json --json -");
    cli_assert_holds(events->output, "\"rest\"");
    g_autoptr(TestProgram) impulses = cli_run_well(fixture, "run @drop.json --contacts impulse --step 0.002 --json -");
    cli_assert_holds(impulses->output, "\"impulse\"");
    cli_assert_holds(impulses->output, "\"steps\":\t500");
    g_assert_null(strstr(impulses->output, "no effect"));
    g_autoptr(TestProgram) idle =
        cli_run_well(fixture, "run @drop.json --contacts impulse --method rk4 --tolerance 1e-6");
    cli_assert_holds(idle->output, "--method has no effect");
    cli_assert_holds(idle->output, "--tolerance has no effect");
}

static void test_scene(CliFixture *fixture, gconstpointer data)
{
    const char *place = strstr(DROP, "\"step\"");
    g_autofree char *text =
        g_strdup_printf("%.*s\"contacts\": \"impulse\", %s", (int)(strlen(DROP) - strlen(place)), DROP, place);
    g_autofree char *scene = cli_write(fixture, "asked.json", text);
    g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @asked.json");
    cli_assert_holds(plan->output, "impulse, step 0.001 s");
    cli_assert_holds(plan->output, "contacts are asked for as impulses: one velocity solve a step, order 1");
    g_autoptr(TestProgram) other = cli_run_well(fixture, "plan @asked.json --contacts events");
    g_assert_null(strstr(other->output, "as impulses"));
    g_autoptr(TestProgram) bench = cli_run_well(fixture, "bench @asked.json --seconds 0.05");
    cli_assert_holds(bench->output, "impulse");
}

static void test_mistake(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "drop.json", DROP);
    g_autoptr(TestProgram) program = cli_run_badly(fixture, "run @drop.json --contacts impulses", 2);
    cli_assert_holds(program->error, "--contacts is \"impulses\" (it must be events or impulse)");
}

static void assert_turning(CliFixture *fixture, const char *scene, double expected)
{
    g_autofree char *file = cli_write(fixture, "disc.json", scene);
    g_autoptr(TestProgram) run =
        cli_run_well(fixture, "run @disc.json --contacts impulse --step 0.01 --no-estimate --at 0.2 --columns "
                              "\"Disc.angular acceleration\" --csv -");
    const double value = g_ascii_strtod(strchr(strchr(run->output, '\n'), ',') + 1, NULL);
    if (!(fabs(value - expected) <= 1e-9)) g_error("%.15g rad/s^2 where %.15g was expected", value, expected);
}

/* A disc of 1 kg that rolls evenly has no angular acceleration, one of 0.3 m that slides, m g R mu / I = 2 g mu / R. */
static void test_angular_acceleration(CliFixture *fixture, gconstpointer data)
{
    static const char form[] =
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\", \"position\": [0, -0.2], "
        "\"width\": 40}, {\"type\": \"disc\", \"name\": \"Disc\", \"radius\": 0.3, \"position\": [0, 0.3], "
        "\"velocity\": [%g, 0], \"angular_velocity\": %g}]}";
    g_autofree char *rolls = g_strdup_printf(form, 0.3, -1.0), *slides = g_strdup_printf(form, 20.0, 0.0);
    assert_turning(fixture, rolls, 0);
    assert_turning(fixture, slides, -2 * 9.81 * 0.5 / 0.3);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/impulse/run", test_run);
    cli_test_add("/cli/impulse/scene", test_scene);
    cli_test_add("/cli/impulse/mistake", test_mistake);
    cli_test_add("/cli/impulse/angular-acceleration", test_angular_acceleration);
    return g_test_run();
}
