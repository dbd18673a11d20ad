/* --contacts: what a run, a plan and a benchmark say of contact as impulses. */
#include "fixture.h"

#include <string.h>

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

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/impulse/run", test_run);
    cli_test_add("/cli/impulse/scene", test_scene);
    cli_test_add("/cli/impulse/mistake", test_mistake);
    return g_test_run();
}
