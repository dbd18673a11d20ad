/* tinker run: the record, the summary, and what happens when it goes wrong. */
#include <math.h>
#include <string.h>

#include "fixture.h"

static void test_default_record(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @a.json --csv -");
    g_auto(GStrv) lines = g_strsplit(program->output, "\n", -1);
    g_assert_cmpstr(lines[0], ==,
                    "time [s],Mass 0.x [m],Mass 0.y [m],Mass 0.vx [m/s],Mass 0.vy [m/s],Spring 0.tension [N]");
    /* stretched by 1 m at the start: 100 N */
    g_assert_cmpstr(lines[1], ==, "0,3,0,0,0,100");
    g_assert_cmpuint(g_strv_length(lines), ==, 7); /* header, 0 to 2 s, and nothing behind the last line feed */
    g_assert_cmpstr(lines[6], ==, "");
    g_assert_null(strchr(program->output, '\r'));
    /* the summary makes way */
    cli_assert_holds(program->error, "evaluations");
}

static void test_values(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @a.json --csv - --columns 'Mass 0.y,Mass 0.vy'");
    g_autoptr(TestTable) table = test_table_new(program->output);
    g_assert_cmpuint(table->rows, ==, 101);
    g_assert_cmpuint(table->columns, ==, 3);
    for (gsize row = 0; row < table->rows; row++) {
        double t = (double)row / 100;
        g_assert_cmpfloat(test_table_value(table, row, "time"), ==, t);
        g_assert_cmpfloat_with_epsilon(test_table_value(table, row, "Mass 0.y"), -9.81 * t * t / 2, 1e-14);
        g_assert_cmpfloat_with_epsilon(test_table_value(table, row, "Mass 0.vy"), -9.81 * t, 1e-13);
    }
    /* seventeen digits */
    cli_assert_holds(program->output, "\n0.10000000000000001,");
}

static void test_times(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) at = cli_run_well(fixture, "run @a.json --at '0.5, 250 ms,0,0.5,2 s' --csv -");
    g_autoptr(TestTable) table = test_table_new(at->output);
    const double expected[] = {0, 0.25, 0.5, 2};
    g_assert_cmpuint(table->rows, ==, G_N_ELEMENTS(expected));
    for (gsize row = 0; row < table->rows; row++)
        g_assert_cmpfloat(test_table_value(table, row, "time"), ==, expected[row]);

    /* the last sample is at the duration, whatever the interval */
    g_autoptr(TestProgram) every = cli_run_well(fixture, "run @a.json --duration 1 --interval '300 ms' --csv -");
    g_autoptr(TestTable) rows = test_table_new(every->output);
    g_assert_cmpuint(rows->rows, ==, 5);
    g_assert_cmpfloat(test_table_value(rows, 4, "time"), ==, 1);
}

static void test_recording_changes_nothing(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) few = cli_run_well(fixture, "run @a.json --at 2 --csv -");
    g_autoptr(TestProgram) many = cli_run_well(fixture, "run @a.json --interval 0.0007 --csv -");
    const char *last = strrchr(g_strchomp(few->output), '\n');
    g_assert_true(g_str_has_suffix(g_strchomp(many->output), last));
}

static void test_quoting(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "a.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"big, \\\"old\\\" one\"}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @a.json --at 0 --columns 'big, \"old\" one.y' --csv -");
    g_assert_cmpstr(program->output, ==, "time [s],\"big, \"\"old\"\" one.y [m]\"\n0,0\n");
}

static void test_summary_json(CliFixture *fixture, gconstpointer data)
{
    static const char *const keys[] = {
        "method",
        "step",
        "tolerance",
        "steps",
        "rejected_steps",
        "evaluations",
        "simulated_s",
        "wall_s",
        "real_time_factor",
        "constraint_position_error",
        "constraint_velocity_error",
        "energy",
        "energy_balance_error",
        "error_estimate",
        "accuracy",
        "tries",
        "valid_until",
        "events",
        "islands",
        "libraries",
        "warnings",
    };
    static const char *const energies[] = {"kinetic", "potential", "dampers",        "friction",  "contacts",
                                           "motors",  "fields",    "support_motion", "projection"};
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @a.json --json -");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++)
        if (!cJSON_HasObjectItem(root, keys[i])) g_error("no key %s", keys[i]);
    g_assert_cmpint(cJSON_GetArraySize(root), ==, G_N_ELEMENTS(keys));
    const cJSON *energy = cJSON_GetObjectItem(root, "energy");
    for (gsize i = 0; i < G_N_ELEMENTS(energies); i++)
        if (!cJSON_HasObjectItem(energy, energies[i])) g_error("no energy %s", energies[i]);

    g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(root, "method")), ==, "rk4");
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "step")), ==, 0.01);
    g_assert_true(cJSON_IsNull(cJSON_GetObjectItem(root, "tolerance")));
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "steps")), ==, 100);
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "simulated_s")), ==, 1);
    /* it fell 9.81 / 2 m in 1 s: kinetic energy (9.81 m/s)^2 / 2 */
    const cJSON *kinetic = cJSON_GetObjectItem(energy, "kinetic");
    g_assert_cmpfloat_with_epsilon(cJSON_GetNumberValue(cJSON_GetObjectItem(kinetic, "end")), 9.81 * 9.81 / 2, 1e-11);
    g_assert_cmpint(cJSON_GetArraySize(cJSON_GetObjectItem(root, "libraries")), ==, 2);
    cJSON_Delete(root);
}

static void test_overrides(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) program =
        cli_run_well(fixture, "run @a.json --method dop853 --tolerance 1e-10 --duration '0.1 min' --json -");
    cJSON *root = cJSON_Parse(program->output);
    g_assert_nonnull(root);
    g_assert_cmpstr(cJSON_GetStringValue(cJSON_GetObjectItem(root, "method")), ==, "dop853");
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "tolerance")), ==, 1e-10);
    g_assert_true(cJSON_IsNull(cJSON_GetObjectItem(root, "step")));
    g_assert_cmpfloat(cJSON_GetNumberValue(cJSON_GetObjectItem(root, "simulated_s")), ==, 6);
    cJSON_Delete(root);
}

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

/* What concerns the record alone is not silently ignored where none is written. */
static void test_options_without_record(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *fall = cli_write(fixture, "fall.json", FREE_FALL);
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @fall.json --columns 'Mass 0.y' --at 1");
    cli_assert_holds(program->error, "--columns has no effect without --csv");
    cli_assert_holds(program->error, "--at has no effect without --csv");
}

/* A mass that cannot leave its rod's circle as it was told to. */
static void test_start_event(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene =
        cli_write(fixture, "rod.json",
                  "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"support\"},"
                  "{\"type\": \"mass\", \"position\": [1, 0], \"velocity\": [1, 1]},"
                  "{\"type\": \"rod\", \"ends\": [\"Support 0\", \"Mass 0\"]}]}");
    g_autoptr(TestProgram) program = cli_run_well(fixture, "run @rod.json");
    cli_assert_holds(program->output,
                     "event at 0 s: The start velocities are changed to what connectors and supports allow\n");
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

/* Waits until the run has written something, so that it is surely under way. */
/* x = 2 + cos 10t over two periods. */
static void test_statistics(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) run = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --statistics --to "
                                                       "1.2566370614359172 --json -");
    const struct {
        const char *key;
        double truth, bound;
    } all[] = {{"mean", 2, 1e-9}, {"rms", sqrt(4.5), 1e-9}, {"max", 3, 1e-9}, {"period", G_PI / 5, 1e-7}};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++) {
        g_autofree char *key = g_strdup_printf("\"%s\":", all[i].key);
        const char *at = strstr(run->output, key);
        g_assert_nonnull(at);
        const double value = g_ascii_strtod(strstr(at, "\"value\":") + strlen("\"value\":"), NULL);
        g_assert_cmpfloat(fabs(value - all[i].truth), <, all[i].bound);
    }
    g_autoptr(TestProgram) text = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --statistics");
    cli_assert_holds(text->output, "amplitude");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "graph @a.json 'Mass 0.x' --statistics --from 3", 2);
    cli_assert_holds(wrong->error, "--from and --to leave nothing");
}

/* Curves of a scene, of one that is four times as stiff, and of the first one's record. */
static void test_with(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_auto(GStrv) parts = g_strsplit(OSCILLATOR, "\"stiffness\": 100", 2);
    g_autofree char *stiffer = g_strjoinv("\"stiffness\": 400", parts), *other = cli_write(fixture, "b.json", stiffer);
    g_autoptr(TestProgram) record = cli_run_well(fixture, "run @a.json --csv @a.csv");
    g_autoptr(TestProgram) run = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --with @b.json --with @a.csv -o -");
    g_auto(GStrv) lines = g_strsplit(run->output, "\n", -1);
    g_assert_cmpstr(lines[0], ==, "Time,Mass 0.x (a),Time,Mass 0.x (Spring 0: K 100 → 400 N/m),Time,Mass 0.x (a)");
    g_auto(GStrv) cells = g_strsplit(lines[2], ",", -1);
    g_assert_cmpuint(g_strv_length(cells), ==, 6);
    g_assert_cmpfloat(fabs(g_ascii_strtod(cells[1], NULL) - 2 - cos(5)), <, 1e-6);
    g_assert_cmpfloat(fabs(g_ascii_strtod(cells[3], NULL) - 2 - cos(10)), <, 1e-5);
    g_assert_cmpstr(cells[5], ==, cells[1]);
    g_autoptr(TestProgram) lacks = cli_run_badly(fixture, "graph @a.json 'Mass 0.ax' --with @a.csv -o -", 2);
    cli_assert_holds(lacks->error, "has no column \"Mass 0.ax\"");
}

/* It is drawn; what cannot be is refused. The numbers are those of tests/measure. */
static void test_spectrum(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", OSCILLATOR);
    g_autoptr(TestProgram) run =
        cli_run_well(fixture, "graph @a.json 'Mass 0.x' --interval 0.01 --spectrum hann -o @s.svg");
    g_autofree char *svg = cli_read(fixture, "s.svg");
    cli_assert_holds(svg, "<svg");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "graph @a.json 'Mass 0.x' --spectrum box -o @s.svg", 2);
    cli_assert_holds(wrong->error, "it must be hann or none");
}

static void wait_for_rows(const char *path)
{
    for (;;) {
        g_autofree char *text = NULL;
        if (g_file_get_contents(path, &text, NULL, NULL) && strchr(text, '\n') != NULL) return;
        g_usleep(1000);
    }
}

/* y = -9.81 t^2 / 2: at -1.2 m after sqrt(2.4 / 9.81) s, where the record and the run end. */
static void test_until(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(fixture, "a.json", FREE_FALL);
    const double end = sqrt(2.4 / 9.81);
    g_autoptr(TestProgram) run =
        cli_run_well(fixture, "run @a.json --until '{Mass 0.vy} < -9' --until '{Mass 0.y} = -1.2' "
                              "--csv @r.csv --json @s.json");
    g_autofree char *csv = cli_read(fixture, "r.csv"), *json = cli_read(fixture, "s.json");
    g_autoptr(TestTable) table = test_table_new(csv);
    g_assert_cmpuint(table->rows, ==, 51);
    g_assert_cmpfloat(fabs(test_table_value(table, 50, "time") - end), <, 1e-9);
    g_assert_cmpfloat(fabs(test_table_value(table, 50, "Mass 0.y") + 1.2), <, 1e-8);
    g_assert_cmpfloat(test_table_value(table, 29, "time"), ==, 0.29);
    cli_assert_holds(json, "\"stopped_by\":\t\"{Mass 0.y} = -1.2\"");
    cli_assert_holds(json, "\"simulated_s\":\t0.494");
    g_autoptr(TestProgram) never = cli_run_well(fixture, "run @a.json --until 'event(impact)' --json -");
    cli_assert_holds(never->output, "\"stopped_by\":\tnull");
    cli_assert_holds(never->error, "no condition of --until came true in");
    cli_assert_holds(run->output, "  ended at 0.494");
    cli_assert_holds(run->output, " s, where {Mass 0.y} = -1.2\n");
    g_autoptr(TestProgram) wrong = cli_run_badly(fixture, "run @a.json --until '{Mass 0.y}'", 2);
    cli_assert_holds(wrong->error, "--until");
    cli_assert_holds(wrong->error, "it is no condition");
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
    cli_test_add("/run/default-record", test_default_record);
    cli_test_add("/run/values", test_values);
    cli_test_add("/run/times", test_times);
    cli_test_add("/run/recording-changes-nothing", test_recording_changes_nothing);
    cli_test_add("/run/quoting", test_quoting);
    cli_test_add("/run/summary-json", test_summary_json);
    cli_test_add("/run/overrides", test_overrides);
    cli_test_add("/run/failed-run-keeps", test_failed_run_keeps);
    cli_test_add("/run/statuses", test_statuses);
    cli_test_add("/run/unwritable-before-run", test_unwritable_before_run);
    cli_test_add("/run/standard-input", test_standard_input);
    cli_test_add("/run/options-without-record", test_options_without_record);
    cli_test_add("/run/start-event", test_start_event);
    cli_test_add("/run/until", test_until);
    cli_test_add("/run/statistics", test_statistics);
    cli_test_add("/run/with", test_with);
    cli_test_add("/run/spectrum", test_spectrum);
    cli_test_add("/run/interrupt", test_interrupt);
    return g_test_run();
}
