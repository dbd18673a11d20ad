#include "physics-fixture.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/simulation.h"

#include <math.h>
#include <string.h>

static void (*tests_of_program)(void);

/* A failure ends no program: the tests behind it still run. */
static void add_nonfatal_tests(void)
{
    g_test_set_nonfatal_assertions();
    tests_of_program();
}

int physics_main(int argc, char **argv, void (*add_tests)(void))
{
    tests_of_program = add_tests;
    return scene_fixture_main_with(argc, argv, "physics/plugins", add_nonfatal_tests);
}

TinkerScene *physics_scene(const char *path, const char *blocks)
{
    g_autofree char *text = g_strdup_printf("{\"tinker\": 1, \"blocks\": [\n%s]}", blocks);
    g_strdelimit(text, "'", '"');
    g_autoptr(GError) error = NULL;
    TinkerScene *scene = tinker_scene_read_text(scene_fixture_catalogue(), text, strlen(text), path, NULL, &error);
    if (scene == NULL) g_error("%s", error->message);
    return scene;
}

static gboolean keep(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    PhysicsRun *run = data;
    g_array_append_val(run->samples, time);
    g_assert_true(isfinite(time));
    for (guint i = 0; i < run->columns->len; i++)
        g_assert_true(isfinite(values[i]));
    g_array_append_vals(run->samples, values, run->columns->len);
    return TRUE;
}

static void begin_again(void *data)
{
    g_array_set_size(((PhysicsRun *)data)->samples, 0);
}

static PhysicsRun *prepare(const PhysicsOptions *options, const char *blocks)
{
    PhysicsRun *run = g_new0(PhysicsRun, 1);
    double duration = options->duration > 0 ? options->duration : 1.0;
    run->scene = physics_scene(options->path, blocks);
    if (options->impact_law != NULL) {
        TinkerRunSettings *settings = &tinker_scene_head(run->scene)->run;
        g_free(settings->impact_law);
        settings->impact_law = g_strdup(options->impact_law);
    }
    run->columns = tinker_columns_new();
    run->samples = g_array_new(FALSE, FALSE, sizeof(double));
    if (options->columns != NULL) {
        tinker_columns_add_list(run->columns, run->scene, options->columns, &run->error);
        if (run->error != NULL) g_error("%s", run->error->message);
    }
    run->model = tinker_model_new(run->scene, &run->error);
    if (run->model == NULL) return run;
    TinkerRunOptions how = {
        .duration = duration,
        .interval = options->interval > 0 ? options->interval : 0.1 * duration,
        .at = options->at,
        .at_count = options->at_count,
        .method = options->method != NULL ? options->method : "dop853",
        .step = options->step > 0 ? options->step : 0.01,
        .tolerance = options->tolerance > 0 ? options->tolerance : 1e-12,
        .accuracy = options->accuracy,
        .spectral_radius = 0.8,
        .estimate = options->estimate,
        .bands = options->bands,
        .impulses = options->impulses,
        .found = options->found,
        .data = options->found_data,
    };
    run->simulation = tinker_simulation_new(run->model, &how, &run->error);
    if (run->simulation != NULL) run->summary = tinker_simulation_summary(run->simulation);
    return run;
}

static PhysicsRun *prepare_and_run(const PhysicsOptions *options, const char *blocks)
{
    PhysicsRun *run = prepare(options, blocks);
    if (run->simulation == NULL) return run;
    const TinkerSampleTaker taker = {.sample = keep, .begin_again = begin_again, .data = run};
    gboolean done = tinker_accurate_run(&run->simulation, run->columns, &taker, &run->error);
    run->summary = tinker_simulation_summary(run->simulation);
    g_assert_true(done == (run->error == NULL));
    return run;
}

static PhysicsRun *must_succeed(PhysicsRun *run)
{
    if (run->error == NULL) return run;
    g_test_fail_printf("%s", run->error->message);
    if (run->simulation == NULL) g_error("%s", run->error->message);
    return run;
}

PhysicsRun *physics_prepare(const PhysicsOptions *options, const char *blocks, ...)
{
    va_list arguments;
    va_start(arguments, blocks);
    g_autofree char *text = g_strdup_vprintf(blocks, arguments);
    va_end(arguments);
    return must_succeed(prepare(options, text));
}

PhysicsRun *physics_try(const PhysicsOptions *options, const char *blocks, ...)
{
    va_list arguments;
    va_start(arguments, blocks);
    g_autofree char *text = g_strdup_vprintf(blocks, arguments);
    va_end(arguments);
    return prepare_and_run(options, text);
}

PhysicsRun *physics_run(const PhysicsOptions *options, const char *blocks, ...)
{
    va_list arguments;
    va_start(arguments, blocks);
    g_autofree char *text = g_strdup_vprintf(blocks, arguments);
    va_end(arguments);
    return must_succeed(prepare_and_run(options, text));
}

void physics_run_free(PhysicsRun *run)
{
    if (run == NULL) return;
    tinker_simulation_free(run->simulation);
    tinker_model_free(run->model);
    tinker_scene_free(run->scene);
    g_array_unref(run->columns);
    g_array_unref(run->samples);
    g_clear_error(&run->error);
    g_free(run);
}

gsize physics_samples(const PhysicsRun *run)
{
    return run->samples->len / (run->columns->len + 1);
}

double physics_time(const PhysicsRun *run, gsize sample)
{
    g_assert(sample < physics_samples(run));
    return g_array_index(run->samples, double, sample *(run->columns->len + 1));
}

double physics_value(const PhysicsRun *run, gsize sample, gsize column)
{
    g_assert(sample < physics_samples(run));
    g_assert(column < run->columns->len);
    return g_array_index(run->samples, double, sample *(run->columns->len + 1) + column + 1);
}

double physics_last(const PhysicsRun *run, gsize column)
{
    return physics_value(run, physics_samples(run) - 1, column);
}

void physics_state(const PhysicsRun *run, const char *block, double state[4])
{
    TinkerBlockId id = tinker_scene_find_block(run->scene, block);
    g_assert(id != TINKER_NO_BLOCK);
    g_assert_true(tinker_simulation_state(run->simulation, id, state, state + 2));
}

void physics_assert_same_bits(const PhysicsRun *left, const PhysicsRun *right)
{
    int compared = 0;
    for (int32_t place = 0; place < tinker_scene_block_count(left->scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(left->scene, place);
        double l[4], r[4];
        if (!tinker_simulation_state(left->simulation, block, l, l + 2)) continue;
        g_assert_true(tinker_simulation_state(right->simulation, block, r, r + 2));
        g_assert_cmpmem(l, sizeof(l), r, sizeof(r));
        compared++;
    }
    g_assert_cmpint(compared, >, 0);
}

void physics_assert_near(const char *what, double value, double truth, double bound)
{
    if (!(fabs(value - truth) <= bound) && !g_test_failed())
        g_test_fail_printf("%s is %.17g, not %.17g: off by %.3g, more than %.3g", what, value, truth,
                           fabs(value - truth), bound);
}

void physics_assert_follows(const PhysicsRun *run, gsize column, double (*truth)(double, const void *),
                            const void *data, double bound)
{
    for (gsize i = 0; i < physics_samples(run); i++) {
        double t = physics_time(run, i);
        g_autofree char *what =
            g_strdup_printf("%s at t = %g s", g_array_index(run->columns, TinkerColumn, column).name, t);
        physics_assert_near(what, physics_value(run, i, column), truth(t, data), bound);
    }
}

void physics_assert_refused(const PhysicsRun *run, TinkerModelError code, ...)
{
    g_assert_error(run->error, TINKER_MODEL_ERROR, (int)code);
    g_test_message("%s", run->error->message);
    va_list parts;
    va_start(parts, code);
    for (const char *part = va_arg(parts, const char *); part != NULL; part = va_arg(parts, const char *))
        if (strstr(run->error->message, part) == NULL)
            g_test_fail_printf("the message \"%s\" lacks \"%s\"", run->error->message, part);
    va_end(parts);
}

void physics_rk4(int n, double *y, double from, double to, int steps,
                 void (*f)(double, const double *, double *, const void *), const void *data)
{
    double k[4][8], stage[8], h = (to - from) / steps;
    static const double at[4] = {0, 0.5, 0.5, 1};
    g_assert_cmpint(n, <=, 8);
    for (int i = 0; i < steps; i++) {
        for (int s = 0; s < 4; s++) {
            for (int j = 0; j < n; j++)
                stage[j] = y[j] + (s > 0 ? at[s] * h * k[s - 1][j] : 0.0);
            f(from + (i + at[s]) * h, stage, k[s], data);
        }
        for (int j = 0; j < n; j++)
            y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
    }
}

const char physics_rods_and_springs[] =
    "{'type': 'gravity'}, {'type': 'wind', 'drag': 0.05, 'drag_quadratic': 0.02}, {'type': 'support', 'solid': false},"
    "{'type': 'support', 'solid': false, 'position': [4, 1]}, {'type': 'mass', 'position': [1, 0.3]},"
    "{'type': 'mass', 'mass': 2, 'position': [2.1, -0.4]}, {'type': 'mass', 'mass': 0.5, 'position': [3, 0]},"
    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rod', 'ends': ['Mass 0', 'Mass 1']},"
    "{'type': 'spring', 'ends': ['Mass 1', 'Mass 2'], 'rest_length': 1}, {'type': 'rod', 'ends': ['Mass 2', 'Support "
    "1']},"
    "{'type': 'damper', 'ends': ['Mass 0', 'Mass 2']},"
    "{'type': 'support-motion', 'ends': ['Support 1'], 'amplitude': 0.2, 'frequency': 5},"
    "{'type': 'motor', 'ends': ['Mass 1'], 'waveform': {'expression': '5*square(3*t) + sin(t)'}}";
