/* --accuracy, and the accuracy of a scene: what is held, what is told, what excludes what. */
#include <math.h>
#include <string.h>

#include "fixture.h"

/* A pendulum of 1 m let go one degree from its top: no plan sees how fast it leaves. `run` stands in its settings. */
#define PENDULUM(run)                                                                                                  \
    "{\"tinker\": 1, \"run\": {\"duration\": 10, \"interval\": 0.5" run "},\n \"blocks\": [{\"type\": \"gravity\"}, "  \
    "{\"type\": \"support\", \"solid\": false},\n {\"type\": \"mass\", \"position\": [0.017452406437283512, "          \
    "0.99984769515639127]},\n {\"type\": \"rod\", \"ends\": [\"Support 0\", \"Mass 0\"]}],\n"                          \
    " \"graphs\": [{\"block\": \"Mass 0\", \"quantity\": \"y\"}]}\n"

static cJSON *read_json(const CliFixture *fixture, const char *name)
{
    g_autofree char *text = cli_read(fixture, name);
    cJSON *json = cJSON_Parse(text);
    g_assert_nonnull(json);
    return json;
}

static double number(const cJSON *object, const char *key)
{
    const cJSON *item = cJSON_GetObjectItemCaseSensitive(object, key);
    g_assert_true(cJSON_IsNumber(item));
    return item->valuedouble;
}

/* Energy is what gravity takes: the height of the record says the speed. */
static void assert_energy(const char *csv, double bound)
{
    g_autoptr(TestTable) table = test_table_new(csv);
    g_assert_cmpuint(table->rows, ==, 21);
    for (gsize row = 0; row < table->rows; row++) {
        double y = test_table_value(table, row, "Mass 0.y"), vx = test_table_value(table, row, "Mass 0.vx"),
               vy = test_table_value(table, row, "Mass 0.vy");
        g_assert_cmpfloat(test_table_value(table, row, "time"), ==, 0.5 * (double)row);
        g_assert_cmpfloat_with_epsilon((vx * vx + vy * vy) / 2 + 9.81 * (y - 0.99984769515639127), 0, bound * 4 * 9.81);
    }
}

static void test_held(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", PENDULUM(", \"method\": \"rk4\", \"step\": 1"));
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @a.json --accuracy 1e-6 --csv - --json @run.json");
    assert_energy(program->output, 1e-6);
    cli_assert_holds(program->error, "try 2");
    cli_assert_holds(program->error, "1e-06 was asked for: met");
    cJSON *json = read_json(fixture, "run.json");
    const cJSON *tries = cJSON_GetObjectItemCaseSensitive(json, "tries");
    int count = cJSON_GetArraySize(tries);
    g_assert_cmpfloat(number(json, "accuracy"), ==, 1e-6);
    g_assert_cmpint(count, >=, 2);
    g_assert_cmpint(count, <=, 3);
    for (int i = 0; i < count; i++) {
        const cJSON *each = cJSON_GetArrayItem(tries, i);
        g_assert_true((number(each, "error_estimate") <= 1e-6) == (i == count - 1));
        g_assert_cmpfloat(number(each, "evaluations"), >, 0);
        g_assert_cmpfloat(number(each, "wall_s"), >, 0);
        if (i > 0) g_assert_cmpfloat(number(each, "step"), <, number(cJSON_GetArrayItem(tries, i - 1), "step"));
    }
    g_assert_cmpfloat(number(json, "error_estimate"), <=, 1e-6);
    cJSON_Delete(json);
}

/* The record is written, whole, and once. */
static void test_not_met(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", PENDULUM(""));
    g_autoptr(TestProgram) program =
        cli_run_badly(fixture, "run @a.json --accuracy 1e-15 --csv @run.csv --json @run.json", 1);
    cli_assert_holds(program->error, "the accuracy of 1e-15 is not met");
    g_autofree char *csv = cli_read(fixture, "run.csv");
    assert_energy(csv, 1e-9);
    cJSON *json = read_json(fixture, "run.json");
    const cJSON *warning = cJSON_GetArrayItem(cJSON_GetObjectItemCaseSensitive(json, "warnings"), 0);
    cli_assert_holds(cJSON_GetStringValue(warning), "the accuracy of 1e-15 is not met");
    cJSON_Delete(json);

    g_autoptr(TestProgram) graph = cli_run_badly(fixture, "graph @a.json --accuracy 1e-15 -o @y.csv", 1);
    g_autofree char *curve = cli_read(fixture, "y.csv");
    g_auto(GStrv) rows = g_strsplit(curve, "\n", -1);
    g_assert_cmpuint(g_strv_length(rows), ==, 23); /* a heading, 0 to 10 s, and what is behind the last line feed */
    g_autoptr(TestProgram) picture = cli_run_badly(fixture, "render @a.json --accuracy 1e-15 --time 2 -o @a.svg", 1);
    g_autofree char *svg = cli_read(fixture, "a.svg");
    cli_assert_holds(svg, "<svg");
}

static void test_excluded(CliFixture *fixture, gconstpointer data)
{
    static const char *const others[] = {"--tolerance 1e-9", "--step 0.01", "--no-estimate"};
    g_autofree char *scene = cli_write(fixture, "a.json", PENDULUM(""));
    for (gsize i = 0; i < G_N_ELEMENTS(others); i++) {
        g_autofree char *words = g_strdup_printf("run @a.json --accuracy 1e-6 %s", others[i]);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words, 2);
        cli_assert_holds(program->error, "--accuracy and ");
        cli_assert_holds(program->error, "exclude each other");
    }
    static const char *const wrong[] = {"0", "-1", "1", "nan", "small", "'1 mm'"};
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autofree char *words = g_strdup_printf("run @a.json --accuracy=%s", wrong[i]);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, words, 2);
        cli_assert_holds(program->error, "--accuracy");
    }
}

static void test_of_scene(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", PENDULUM(", \"method\": \"rk4\", \"accuracy\": 1e-4"));
    g_autoptr(TestProgram) held = cli_run_well(fixture, "run @a.json --json @held.json");
    cJSON *json = read_json(fixture, "held.json");
    g_assert_cmpfloat(number(json, "accuracy"), ==, 1e-4);
    g_assert_cmpfloat(number(json, "error_estimate"), <=, 1e-4);
    cJSON_Delete(json);
    /* the command line goes first */
    g_autoptr(TestProgram) stepped = cli_run_well(fixture, "run @a.json --step 0.05 --json @stepped.json");
    json = read_json(fixture, "stepped.json");
    g_assert_true(cJSON_IsNull(cJSON_GetObjectItemCaseSensitive(json, "accuracy")));
    g_assert_cmpfloat(number(json, "step"), ==, 0.05);
    cJSON_Delete(json);
    g_autoptr(TestProgram) converted = cli_run_well(fixture, "convert @a.json -o @b.json");
    json = read_json(fixture, "b.json");
    g_assert_cmpfloat(number(cJSON_GetObjectItemCaseSensitive(json, "run"), "accuracy"), ==, 1e-4);
    cJSON_Delete(json);
    g_autoptr(TestProgram) planned = cli_run_well(fixture, "plan @a.json --json @plan.json");
    cli_assert_holds(planned->output, "an accuracy of 0.0001");
    json = read_json(fixture, "plan.json");
    g_assert_cmpfloat(number(json, "accuracy"), ==, 1e-4);
    cJSON_Delete(json);
}

/* What is not asked for is not written, and what cannot be is told by check. */
static void test_checked(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *none = cli_write(fixture, "none.json", PENDULUM(""));
    g_autoptr(TestProgram) converted = cli_run_well(fixture, "convert @none.json -o @b.json");
    g_autofree char *text = cli_read(fixture, "b.json");
    g_assert_null(strstr(text, "accuracy"));
    static const char *const wrong[] = {"0", "1", "-1e-6", "\"1 m\""};
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autofree char *all = g_strdup(PENDULUM(", \"accuracy\": @"));
        g_auto(GStrv) parts = g_strsplit(all, "@", 2);
        g_autofree char *with = g_strjoin(wrong[i], parts[0], parts[1], NULL);
        g_autofree char *scene = cli_write(fixture, "wrong.json", with);
        g_autoptr(TestProgram) program = cli_run_badly(fixture, "check @wrong.json", 3);
        cli_assert_holds(program->error, "accuracy");
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/cli/accuracy/held", test_held);
    cli_test_add("/cli/accuracy/not-met", test_not_met);
    cli_test_add("/cli/accuracy/excluded", test_excluded);
    cli_test_add("/cli/accuracy/of-scene", test_of_scene);
    cli_test_add("/cli/accuracy/checked", test_checked);
    return g_test_run();
}
