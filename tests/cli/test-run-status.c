/* tinker run: its exit status, what stays of a run that fails or is interrupted, and where scenes come from. */
#include <string.h>

#include "fixture.h"

/* A step of 0.285 s is a little beyond rk4's limit of 2.83 / (10 rad/s): it goes wrong by and by. */
static void test_failed_run_keeps(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program =
        cli_run_badly(fixture, "run @a.json --step 0.285 --duration 400 --csv @r.csv --json @s.json", 1);
    cli_assert_holds(program->error, "Spring 0");
    g_autofree char *csv = cli_read(fixture, "r.csv");
    g_assert_true(g_str_has_prefix(csv, "time [s],"));
    g_assert_nonnull(strstr(csv, "\n# invalid from t = "));
    g_autofree char *path = cli_path(fixture, "s.json");
    cJSON *root = test_read_json(path);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "warnings")), >, 0);
    cJSON_Delete(root);
}

typedef struct {
    const char *words;
    int status;
    const char *message; /* part of what must be told */
} Failure;

static void test_statuses(CliFixture *fixture, gconstpointer data)
{
    static const Failure failures[] = {
        {"run", 2, "an operand is missing"},
        {"run @fall.json again", 2, "one operand too many"},
        {"run @fall.json --durtion 3", 2, "did you mean --duration"},
        {"run @fall.json --csv", 2, "--csv"},
        {"run @fall.json -z", 2, "-z"},
        {"rum @fall.json", 2, "did you mean \"run\""},
        {"run @fall.json --step 0", 2, "--step \"0\": must be greater than 0"},
        {"run @fall.json --step -1", 2, "must be greater than 0"},
        {"run @fall.json --duration 0", 2, "must be greater than 0"},
        {"run @fall.json --interval '2 kg'", 2, "a time (s) was expected"},
        {"run @fall.json --tolerance nan", 2, "--tolerance"},
        {"run @fall.json --duration inf", 2, "--duration"},
        {"run @fall.json --at -1", 2, "--at"},
        {"run @fall.json --at 1,,2", 2, "entry 2 of --at is empty"},
        {"run @fall.json --at nonsense", 2, "--at \"nonsense\": a time is expected here, as in 12 or 12 ms"},
        {"run @fall.json --step abc", 2, "as in 12 or 12 ms"},
        {"run @fall.json --at ''", 2, "--at"},
        {"run @fall.json --method rk5", 2, "did you mean \"rk4\""},
        {"run @fall.json --columns 'Mass 1.y'", 2, "did you mean \"Mass 0\""},
        {"run @fall.json --columns 'Pendulum.y'", 2, "(it has Gravity 0, Mass 0)"},
        {"run @fall.json --columns Pendulum", 2, "put quotes round a name with a space"},
        {"run @fall.json --columns 'Mass 0.z'", 2, "kinetic energy"},
        {"run @fall.json --csv - --json -", 2, "standard output"},
        {"run @fall.json --csv @fall.json", 2, "the scene itself"},
        {"run @none.json", 5, "No such file"},
        {"run @fall.json --csv @none/r.csv", 5, "/none does not exist"},
        {"run @fall.json --json @none/s.json", 5, "cannot be written"},
        {"run @fall.json --csv /dev/full", 5, "No space"},
        {"run @text.json", 3, "text.json:1:1: "},
        {"run @negative.json", 3, "negative.json:1:51: "},
        {"run @loose.json", 3, "Spring 0"},
        {"run @pulley.json", 4, "pulley"},
    };
    g_autofree char *fall = cli_write(fixture, "fall.json", FREE_FALL);
    g_autofree char *text = cli_write(fixture, "text.json", "a mass and a spring");
    g_autofree char *negative =
        cli_write(fixture, "negative.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"mass\": -1}]}");
    g_autofree char *loose = cli_write(
        fixture, "loose.json",
        "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\"}, {\"type\": \"spring\", \"ends\": [\"Mass 0\", [1, 2]]}]}");
    g_autofree char *pulley =
        cli_write(fixture, "pulley.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"pulley\"}]}");
    for (gsize i = 0; i < G_N_ELEMENTS(failures); i++) {
        g_autoptr(TestProgram) program = cli_run_badly(fixture, failures[i].words, failures[i].status);
        g_assert_true(g_str_has_prefix(program->error, "tinker: ") || strstr(program->error, "\ntinker: ") != NULL);
        cli_assert_holds(program->error, failures[i].message);
    }
    /* nothing was written over the scene */
    g_autofree char *kept = cli_read(fixture, "fall.json");
    g_assert_cmpstr(kept, ==, FREE_FALL);
}

/* A file that cannot be written is told before the run: this one would take hours. */
static void test_unwritable_before_run(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program =
        cli_run_badly(fixture, "run @a.json --duration 1e9 --interval 1e6 --csv @none/r.csv", 5);
    g_assert_cmpstr(program->output, ==, "");
}

static void test_standard_input(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autofree char *command = g_strdup_printf("\"$TINKER_PROGRAM\" run - --at 1 --csv - < '%s' 2>/dev/null", scene);
    const char *words[] = {"sh", "-c", command, NULL};
    g_autofree char *output = NULL;
    g_autoptr(GError) error = NULL;
    g_spawn_sync(NULL, (char **)words, NULL, G_SPAWN_SEARCH_PATH, NULL, NULL, &output, NULL, NULL, &error);
    g_assert_no_error(error);
    g_autoptr(TestTable) table = test_table_new(output);
    g_assert_cmpfloat_with_epsilon(test_table_value(table, 0, "Mass 0.y"), -4.905, 1e-14);
}

static void wait_for_rows(const char *path)
{
    for (;;) {
        g_autofree char *text = NULL;
        if (g_file_get_contents(path, &text, NULL, NULL) && strchr(text, '\n') != NULL) return;
        g_usleep(1000);
    }
}

static void test_interrupt(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autofree char *csv = cli_path(fixture, "r.csv");
    const GPid process = cli_start(fixture, "run @a.json --duration 1e9 --csv @r.csv");
    wait_for_rows(csv);
    g_assert_cmpint(cli_interrupt(process), ==, 1);
    /* whole rows, all of them readable */
    g_autofree char *text = test_read_file(csv);
    g_assert_true(g_str_has_suffix(text, "\n"));
    g_autoptr(TestTable) table = test_table_new(text);
    g_assert_cmpuint(table->rows, >, 0);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/run/failed-run-keeps", test_failed_run_keeps);
    cli_test_add("/run/statuses", test_statuses);
    cli_test_add("/run/unwritable-before-run", test_unwritable_before_run);
    cli_test_add("/run/standard-input", test_standard_input);
    cli_test_add("/run/interrupt", test_interrupt);
    return g_test_run();
}
