/* tinker plan: its JSON has the keys of the contract, its text says the same for people, and options override the
 * scene. */
#include <cjson/cJSON.h>
#include <math.h>
#include <string.h>

#include "fixture.h"

static cJSON *plan_json(CliFixture *fixture, const char *options)
{
    g_autofree char *words = g_strdup_printf("plan @scene.json %s --json -", options);
    g_autoptr(TestProgram) program = cli_run_well(fixture, words);
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    return root;
}

static double number(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    if (!cJSON_IsNumber(item)) g_error("\"%s\" is no number", key);
    return item->valuedouble;
}

static void assert_keys(const cJSON *object, const char *const *keys)
{
    int count = 0;
    for (; keys[count] != NULL; count++)
        if (!cJSON_HasObjectItem(object, keys[count])) g_error("\"%s\" is missing", keys[count]);
    g_assert_cmpint(cJSON_GetArraySize(object), ==, count);
}

/* omega = 10 rad/s: stable up to 2 / omega for Verlet, 2 sqrt 2 / omega for rk4. */
static void test_keys(CliFixture *fixture, gconstpointer data)
{
    static const char *const keys[] = {"bodies",      "degrees_of_freedom",
                                       "constraints", "redundant_constraints",
                                       "accuracy",    "islands",
                                       "modelled",    "left_out",
                                       "libraries",   "warnings",
                                       NULL};
    static const char *const fixed[] = {"blocks",     "method",         "step",        "reason",
                                        "omega_max",  "damping_max",    "stable_step", "expected_evaluations",
                                        "expected_s", "expected_error", NULL};
    static const char *const adaptive[] = {"blocks",     "method",         "tolerance",   "reason",
                                           "omega_max",  "damping_max",    "stable_step", "expected_evaluations",
                                           "expected_s", "expected_error", NULL};
    g_autofree char *scene = cli_write(fixture, "scene.json", OSCILLATOR);
    cJSON *root = plan_json(fixture, "");
    assert_keys(root, keys);
    g_assert_cmpfloat(number(root, "bodies"), ==, 1);
    g_assert_cmpfloat(number(root, "degrees_of_freedom"), ==, 2);
    g_assert_cmpfloat(number(root, "constraints"), ==, 0);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "redundant_constraints")), ==, 0);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "libraries")), ==, 3);
    const cJSON *island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    assert_keys(island, fixed);
    g_assert_cmpfloat(fabs(number(island, "omega_max") - 10), <, 1e-9);
    g_assert_cmpfloat(number(island, "step"), ==, 0.001);
    const cJSON *stable = cJSON_GetObjectItem(island, "stable_step");
    g_assert_cmpfloat(fabs(number(stable, "verlet") - 0.2), <, 1e-6);
    g_assert_cmpfloat(fabs(number(stable, "rk4") - 0.28284271), <, 1e-6);
    g_assert_cmpfloat(fabs(number(stable, "semi-implicit-euler") - 0.2), <, 1e-6);
    g_assert_false(cJSON_HasObjectItem(stable, "dop853"));
    cJSON_Delete(root);

    root = plan_json(fixture, "--method dop853 --tolerance 1e-7");
    island = cJSON_GetArrayItem(cJSON_GetObjectItem(root, "islands"), 0);
    assert_keys(island, adaptive);
    g_assert_cmpfloat(number(island, "tolerance"), ==, 1e-7);
    cJSON_Delete(root);
}

static void test_text(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", OSCILLATOR);
    g_autoptr(TestProgram) plan = cli_run_well(fixture, "plan @scene.json --step 0.3");
    static const char *const parts[] = {"Island 1: Mass 0, Spring 0",
                                        "rk4, step 0.3 s",
                                        "rk4 0.283 s",
                                        "10 rad/s",
                                        "Left out",
                                        "warning: ",
                                        "it will diverge",
                                        "rotation: ",
                                        "Modelled"};
    for (gsize i = 0; i < G_N_ELEMENTS(parts); i++)
        cli_assert_holds(plan->output, parts[i]);
    g_autoptr(TestProgram) fine = cli_run_well(fixture, "plan @scene.json --step 0.01");
    g_assert_null(strstr(fine->output, "warning"));
}

static void test_refusals(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "scene.json", OSCILLATOR);
    g_autoptr(TestProgram) method = cli_run_badly(fixture, "plan @scene.json --method rk5", 2);
    cli_assert_holds(method->error, "did you mean \"rk4\"");
    g_autoptr(TestProgram) step = cli_run_badly(fixture, "plan @scene.json --step -1", 2);
    g_autoptr(TestProgram) missing = cli_run_badly(fixture, "plan @nothing.json", 5);
    g_autofree char *loose =
        cli_write(fixture, "loose.json",
                  "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"rod\", \"name\": \"Loose\"}]}");
    g_autoptr(TestProgram) end = cli_run_badly(fixture, "plan @loose.json", 3);
    cli_assert_holds(end->error, "Loose");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/plan/keys", test_keys);
    cli_test_add("/cli/plan/text", test_text);
    cli_test_add("/cli/plan/refusals", test_refusals);
    return g_test_run();
}
