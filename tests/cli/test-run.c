/* tinker run: what it records and sums up, and options that go before the scene. */
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

/* A torque and an energy have one dimension: each is recorded in the unit of its kind. */
static void test_torque_header(CliFixture *fixture, gconstpointer data)
{
    g_autofree char *scene = cli_write(
        fixture, "a.json",
        "{\"tinker\": 1, \"run\": {\"duration\": 0.1}, \"blocks\": [{\"type\": \"support\", \"solid\": false},"
        "{\"type\": \"disc\", \"position\": [0, 0]}, {\"type\": \"pin\", \"ends\": [\"Support 0\", \"Disc 0\"]},"
        "{\"type\": \"torsional-spring\", \"ends\": [\"Support 0\", \"Disc 0\"]}]}");
    g_autoptr(TestProgram) program = cli_run_well(
        fixture,
        "run @a.json --at 0 --csv - --columns 'Torsional Spring 0.torque,Torsional Spring 0.energy,Pin 0.torque'");
    g_assert_true(g_str_has_prefix(program->output, "time [s],Torsional Spring 0.torque [N m],"
                                                    "Torsional Spring 0.energy [J],Pin 0.torque [N m]\n"));
    g_autoptr(TestProgram) shown = cli_run_well(fixture, "plugins show pin");
    cli_assert_holds(shown->output, "N·m, lbf·ft");
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
    /* one axis has the units of the first */
    g_auto(GStrv) head = g_strsplit(OSCILLATOR, "\"tinker\": 1,", 2);
    g_autofree char *in_feet = g_strjoinv("\"tinker\": 1, \"units\": \"English\",", head),
                    *feet = cli_write(fixture, "feet.json", in_feet);
    g_autoptr(TestProgram) units = cli_run_well(fixture, "graph @a.json 'Mass 0.x' --with @feet.json -o -");
    g_auto(GStrv) alike = g_strsplit(units->output, "\n", -1), both = g_strsplit(alike[2], ",", -1);
    g_assert_cmpuint(g_strv_length(both), ==, 4);
    g_assert_cmpstr(both[3], ==, cells[1]);
    /* what is wrong is told of the file that it is wrong in */
    g_autofree char *none =
        cli_write(fixture, "other.json", "{\"tinker\": 1, \"blocks\": [{\"type\": \"mass\", \"name\": \"Ball\"}]}");
    static const struct {
        const char *arguments, *told;
        int status;
    } wrong[] = {{"graph @a.json 'Mass 0.x' --with @other.json -o -",
                  "other.json: column \"Mass 0.x\": the scene has no block \"Mass 0\"", 2},
                 {"graph @a.json 'Mass 0.x' --with @none.csv -o -", "none.csv cannot be read, or is empty", 2},
                 {"graph @a.json 'Mass 0.x' --statistics --with @b.json", "--with", 2},
                 {"graph @a.json 'Mass 0.x*2' --with @b.json -o -",
                  "in an expression quantities stand in braces, as in {Mass 0.x}*2", 2}};
    for (gsize i = 0; i < G_N_ELEMENTS(wrong); i++) {
        g_autoptr(TestProgram) refused = cli_run_badly(fixture, wrong[i].arguments, wrong[i].status);
        cli_assert_holds(refused->error, wrong[i].told);
        g_assert_cmpint(strstr(refused->error, "--with: ") == NULL, ==, i >= 2);
    }
    g_autoptr(TestProgram) lacks = cli_run_badly(fixture, "graph @a.json 'Mass 0.ax' --with @a.csv -o -", 2);
    cli_assert_holds(lacks->error, "has no column \"Mass 0.ax\"");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    cli_test_add("/run/default-record", test_default_record);
    cli_test_add("/run/torque-header", test_torque_header);
    cli_test_add("/run/values", test_values);
    cli_test_add("/run/times", test_times);
    cli_test_add("/run/recording-changes-nothing", test_recording_changes_nothing);
    cli_test_add("/run/quoting", test_quoting);
    cli_test_add("/run/summary-json", test_summary_json);
    cli_test_add("/run/overrides", test_overrides);
    cli_test_add("/run/options-without-record", test_options_without_record);
    cli_test_add("/run/start-event", test_start_event);
    cli_test_add("/run/with", test_with);
    return g_test_run();
}
