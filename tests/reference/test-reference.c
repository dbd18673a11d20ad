/* Holds the program against the reference problems of expected.json. The error of a state is the distance from the
 * reference position over max(1 m, its distance from the origin), or that of the velocity over the largest reference
 * speed of the mass, at least 1 m/s; the worst one must stay below the problem's limit. */
#include <complex.h>
#include <glib.h>
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "program.h"

#define TOLERANCE "1e-11"

/* Accelerations and constraint forces at t = 0 come from one direct solve: rounding, over the largest of them. */
#define INITIAL_LIMIT 1e-10

enum { PERIOD_SAMPLES = 16 };

static const cJSON *member(const cJSON *object, const char *key)
{
    return cJSON_GetObjectItemCaseSensitive(object, key);
}

static double number(const cJSON *object, const char *key)
{
    const cJSON *item = member(object, key);
    if (!cJSON_IsNumber(item)) g_error("expected.json: no number \"%s\"", key);
    return item->valuedouble;
}

static const char *text(const cJSON *object, const char *key)
{
    const cJSON *item = member(object, key);
    if (!cJSON_IsString(item)) g_error("expected.json: no text \"%s\"", key);
    return item->valuestring;
}

static char *scene_path(const cJSON *problem)
{
    g_autofree char *file = g_strconcat(text(problem, "id"), ".tinker.json", NULL);
    return g_build_filename(g_getenv("TINKER_REFERENCE"), file, NULL);
}

/* The value of BLOCK.QUANTITY in a row. */
static double value_of(const TestTable *record, gsize row, const char *block, const char *quantity)
{
    g_autofree char *column = g_strconcat(block, ".", quantity, NULL);
    return test_table_value(record, row, column);
}

static double component(const cJSON *array, int i)
{
    return cJSON_GetArrayItem(array, i)->valuedouble;
}

/* The largest reference speed of a mass, at least 1 m/s. */
static double speed_scale(const cJSON *states, const char *mass)
{
    double scale = 1.0;
    const cJSON *state;
    cJSON_ArrayForEach(state, states)
    {
        const cJSON *expected = member(state, mass);
        if (cJSON_GetArraySize(expected) >= 4)
            scale = fmax(scale, hypot(component(expected, 2), component(expected, 3)));
    }
    return scale;
}

static double state_error(const cJSON *states, const cJSON *expected, const TestTable *record, gsize row,
                          double position_limit)
{
    const char *mass = expected->string;
    const double x = component(expected, 0), y = component(expected, 1);
    const double off = hypot(value_of(record, row, mass, "x") - x, value_of(record, row, mass, "y") - y);
    g_assert_cmpfloat(off, <=, position_limit);
    const double position_error = off / fmax(1.0, hypot(x, y));
    if (cJSON_GetArraySize(expected) < 4) return position_error;
    double turn_error = 0;
    if (cJSON_GetArraySize(expected) == 6) {
        const double angle = component(expected, 4), rate = component(expected, 5);
        turn_error = fmax(fabs(value_of(record, row, mass, "angle") - angle) / fmax(1.0, fabs(angle)),
                          fabs(value_of(record, row, mass, "angular velocity") - rate) / fmax(1.0, fabs(rate)));
    }
    const double velocity_error = hypot(value_of(record, row, mass, "vx") - component(expected, 2),
                                        value_of(record, row, mass, "vy") - component(expected, 3));
    return fmax(fmax(position_error, turn_error), velocity_error / speed_scale(states, mass));
}

static void check_states(const cJSON *problem, const char *path)
{
    const cJSON *states = member(problem, "states"), *listed = member(problem, "times");
    const double position_limit =
        member(problem, "position_limit") != NULL ? number(problem, "position_limit") : INFINITY;
    g_autoptr(GArray) times = g_array_new(FALSE, FALSE, sizeof(double));
    const cJSON *time;
    cJSON_ArrayForEach(time, listed) g_array_append_val(times, time->valuedouble);
    g_assert_cmpuint(times->len, >, 0);
    g_assert_cmpint((int)times->len, ==, cJSON_GetArraySize(states));
    g_autoptr(TestSceneRun) run = test_scene_run_at(path, (const double *)(gpointer)times->data, times->len, TOLERANCE);
    double worst = 0.0;
    for (guint i = 0; i < times->len; i++) {
        const gsize row = test_table_row(run->record, g_array_index(times, double, i));
        const cJSON *expected;
        cJSON_ArrayForEach(expected, cJSON_GetArrayItem(states, (int)i)) worst =
            fmax(worst, state_error(states, expected, run->record, row, position_limit));
    }
    g_test_message("error %.2e, limit %.0e", worst, number(problem, "limit"));
    g_assert_cmpfloat(worst, <=, number(problem, "limit"));
}

/* Runs with the columns of one kind at one time. (transfer full) */
static TestSceneRun *run_columns(const char *path, const char *times, const GString *columns)
{
    const char *options[] = {"--at",    times,       "--method",   "auto", "--tolerance",
                             TOLERANCE, "--columns", columns->str, NULL};
    return test_scene_run(path, options);
}

static void add_column(GString *columns, const char *column)
{
    g_string_append_printf(columns, "%s%s", columns->len > 0 ? "," : "", column);
}

static void check_initial_accelerations(const cJSON *problem, const char *path)
{
    g_autoptr(GString) columns = g_string_new(NULL);
    const cJSON *expected;
    double scale = 1.0;
    cJSON_ArrayForEach(expected, member(problem, "initial_accelerations"))
    {
        g_autofree char *both = g_strdup_printf("%s.ax,%s.ay", expected->string, expected->string);
        add_column(columns, both);
        scale = fmax(scale, hypot(component(expected, 0), component(expected, 1)));
    }
    g_autoptr(TestSceneRun) run = run_columns(path, "0", columns);
    cJSON_ArrayForEach(expected, member(problem, "initial_accelerations"))
    {
        const double ax = value_of(run->record, 0, expected->string, "ax");
        const double ay = value_of(run->record, 0, expected->string, "ay");
        g_assert_cmpfloat_with_epsilon(ax, component(expected, 0), INITIAL_LIMIT * scale);
        g_assert_cmpfloat_with_epsilon(ay, component(expected, 1), INITIAL_LIMIT * scale);
    }
}

static void check_initial_rod_tensions(const cJSON *problem, const char *path)
{
    g_autoptr(GString) columns = g_string_new(NULL);
    const cJSON *tensions = member(problem, "initial_rod_tensions");
    const int count = cJSON_GetArraySize(tensions);
    double scale = 1.0;
    for (int i = 0; i < count; i++) {
        g_autofree char *column = g_strdup_printf("rod%d.tension", i);
        add_column(columns, column);
        scale = fmax(scale, fabs(component(tensions, i)));
    }
    g_autoptr(TestSceneRun) run = run_columns(path, "0", columns);
    for (int i = 0; i < count; i++) {
        g_autofree char *column = g_strdup_printf("rod%d.tension", i);
        g_assert_cmpfloat_with_epsilon(test_table_value(run->record, 0, column), component(tensions, i),
                                       INITIAL_LIMIT * scale);
    }
}

/* Single values: a column at a time. */
static void check_values(const cJSON *problem, const char *path)
{
    g_autoptr(GString) columns = g_string_new(NULL), times = g_string_new(NULL);
    const cJSON *value;
    cJSON_ArrayForEach(value, member(problem, "values"))
    {
        g_autofree char *time = g_strdup_printf("%.17g", number(value, "time"));
        add_column(times, time);
        if (strstr(columns->str, text(value, "column")) == NULL) add_column(columns, text(value, "column"));
    }
    g_autoptr(TestSceneRun) run = run_columns(path, times->str, columns);
    cJSON_ArrayForEach(value, member(problem, "values"))
    {
        const gsize row = test_table_row(run->record, number(value, "time"));
        g_assert_cmpfloat_with_epsilon(test_table_value(run->record, row, text(value, "column")),
                                       number(value, "value"), number(value, "limit"));
    }
}

/* Amplitude of a steady motion: the first Fourier coefficient over its last period. */
static void check_steady(const cJSON *problem, const char *path)
{
    const cJSON *steady;
    cJSON_ArrayForEach(steady, member(problem, "steady"))
    {
        const double w = number(steady, "frequency");
        double times[PERIOD_SAMPLES];
        for (int i = 0; i < PERIOD_SAMPLES; i++)
            times[i] = number(steady, "until") - 2.0 * G_PI / w * (PERIOD_SAMPLES - 1 - i) / PERIOD_SAMPLES;
        g_autoptr(TestSceneRun) run = test_scene_run_at(path, times, PERIOD_SAMPLES, TOLERANCE);
        double complex sum = 0.0;
        for (gsize row = 0; row < PERIOD_SAMPLES; row++)
            sum += test_table_value(run->record, row, text(steady, "column")) * cexp(-I * w * times[row]);
        g_assert_cmpfloat_with_epsilon(2.0 / PERIOD_SAMPLES * cabs(sum), number(steady, "amplitude"), 1e-8);
    }
}

/* The sample of the largest magnitude in a record at an interval. */
static void check_peaks(const cJSON *problem, const char *path)
{
    const cJSON *peak;
    cJSON_ArrayForEach(peak, member(problem, "peaks"))
    {
        g_autofree char *interval = g_strdup_printf("%.17g", number(peak, "interval"));
        g_autofree char *duration = g_strdup_printf("%.17g", number(peak, "duration"));
        const char *column = text(peak, "column");
        const char *options[] = {"--interval", interval,    "--duration", duration, "--tolerance",
                                 TOLERANCE,    "--columns", column,       NULL};
        g_autoptr(TestSceneRun) run = test_scene_run(path, options);
        double largest = 0.0;
        for (gsize row = 0; row < run->record->rows; row++) {
            const double value = test_table_value(run->record, row, column);
            if (fabs(value) > fabs(largest)) largest = value;
        }
        g_assert_cmpfloat_with_epsilon(largest, number(peak, "value"), number(peak, "limit"));
    }
}

/* Whether one of the run's events is of this kind and at this time. */
static gboolean happened(const cJSON *events, const cJSON *expected)
{
    const cJSON *event;
    cJSON_ArrayForEach(event, events)
    {
        if (g_str_equal(text(event, "kind"), text(expected, "kind")) &&
            fabs(number(event, "time") - number(expected, "time")) <= number(expected, "limit"))
            return TRUE;
    }
    return FALSE;
}

/* What the run tells of itself: when contacts changed, and that its energy books close. */
static void check_summary(const cJSON *problem, const char *path)
{
    const char *options[] = {"--tolerance", TOLERANCE, NULL};
    g_autoptr(TestSceneRun) run = test_scene_run(path, options);
    const cJSON *expected, *events = member(run->summary, "events");
    cJSON_ArrayForEach(expected, member(problem, "events"))
    {
        if (!happened(events, expected)) {
            g_autofree char *all = cJSON_PrintUnformatted(events);
            g_test_message("events: %s", all);
            g_test_fail_printf("no %s at %.17g s", text(expected, "kind"), number(expected, "time"));
        }
    }
    if (member(problem, "balance") != NULL)
        g_assert_cmpfloat(test_summary_number(run, "energy_balance_error"), <=, number(problem, "balance"));
}

/* A scene whose tables lie elsewhere, put beside them in a folder of its own. (transfer full) */
static char *assemble(const cJSON *problem, const char *path)
{
    g_autoptr(GError) error = NULL;
    char *folder = g_dir_make_tmp("tinker-reference-XXXXXX", &error);
    g_assert_no_error(error);
    g_autofree char *name = g_path_get_basename(path), *scene = g_build_filename(folder, name, NULL);
    g_autofree char *contents = test_read_file(path);
    g_file_set_contents(scene, contents, -1, &error);
    g_assert_no_error(error);
    const cJSON *file;
    cJSON_ArrayForEach(file, member(problem, "beside"))
    {
        g_autofree char *from = g_build_filename(g_getenv("TINKER_SCENES"), file->valuestring, NULL);
        g_autofree char *to = g_build_filename(folder, file->valuestring, NULL), *table = test_read_file(from);
        g_file_set_contents(to, table, -1, &error);
        g_assert_no_error(error);
    }
    return folder;
}

static void remove_assembled(const cJSON *problem, const char *folder, const char *scene)
{
    const cJSON *file;
    cJSON_ArrayForEach(file, member(problem, "beside"))
    {
        g_autofree char *path = g_build_filename(folder, file->valuestring, NULL);
        g_remove(path);
    }
    g_remove(scene);
    g_rmdir(folder);
}

static void check_all(const cJSON *problem, const char *path)
{
    if (member(problem, "states") != NULL) check_states(problem, path);
    if (member(problem, "initial_accelerations") != NULL) check_initial_accelerations(problem, path);
    if (member(problem, "initial_rod_tensions") != NULL) check_initial_rod_tensions(problem, path);
    if (member(problem, "values") != NULL) check_values(problem, path);
    if (member(problem, "steady") != NULL) check_steady(problem, path);
    if (member(problem, "peaks") != NULL) check_peaks(problem, path);
    if (member(problem, "events") != NULL || member(problem, "balance") != NULL) check_summary(problem, path);
}

static void test_problem(gconstpointer data)
{
    const cJSON *problem = data;
    g_autofree char *path = scene_path(problem);
    if (member(problem, "beside") != NULL) {
        g_autofree char *folder = assemble(problem, path), *name = g_path_get_basename(path);
        g_autofree char *copy = g_build_filename(folder, name, NULL);
        check_all(problem, copy);
        remove_assembled(problem, folder, copy);
        return;
    }
    if (cJSON_IsTrue(member(problem, "may_be_refused"))) {
        const char *trial[] = {"run", path, "--csv", "-", NULL};
        g_autoptr(TestProgram) program = test_program_run(trial);
        if (program->status != 0) {
            /* a diagnosis is an answer, too, where it names what is singular */
            g_assert_true(program->status == 1 || program->status == 3);
            g_assert_nonnull(strstr(program->error, "rod0"));
            return;
        }
    }
    check_all(problem, path);
}

/* A scene that cannot be run is refused with the status of a wrong scene and a message that names what is wrong. */
static void test_refused(gconstpointer data)
{
    const cJSON *problem = data;
    g_autofree char *path = scene_path(problem);
    const char *arguments[] = {"run", path, "--csv", "-", NULL};
    g_autoptr(TestProgram) program = test_program_run(arguments);
    g_test_message("%s", program->error);
    g_assert_cmpint(program->status, ==, 3);
    g_assert_nonnull(strstr(program->error, text(problem, "names")));
    g_assert_null(strstr(program->output, "nan"));
}

static void add_cases(const cJSON *list, const char *group, GTestDataFunc function)
{
    const cJSON *problem;
    cJSON_ArrayForEach(problem, list)
    {
        g_autofree char *path = g_strdup_printf("/%s/%s", group, text(problem, "id"));
        g_test_add_data_func(path, problem, function);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_autofree char *path = g_build_filename(g_getenv("TINKER_REFERENCE"), "expected.json", NULL);
    cJSON *expected = test_read_json(path);
    add_cases(member(expected, "problems"), "reference", test_problem);
    add_cases(member(expected, "refused"), "refused", test_refused);
    const int status = g_test_run();
    cJSON_Delete(expected);
    return status;
}
