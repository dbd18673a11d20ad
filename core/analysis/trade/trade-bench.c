/* The test bench: one scene compiled once, run again and again with other methods, sampled or timed. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>
#include <time.h>

#include "analysis/trade/trade-private.h"
#include "physics/compile/compile.h"
#include "physics/impulse/impulse.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

#define SAMPLES          500 /* equally spaced, where no times are given: enough to see how far and how fast the motion goes */
#define LEAST_SAMPLES    8
#define MOST_NUMBERS     4000000 /* of one trajectory: larger scenes are sampled less often */
#define LEAST_REPEATS    3
#define MOST_REPEATS     31
#define WORTHWHILE_TIMED 0.03 /* s: short runs are repeated until they fill this */

/* Setting up ------------------------------------------------------------------------------------------------------- */

static gboolean is_body(TinkerScene *scene, TinkerBlockId block)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    return block_class != NULL && block_class->physics != NULL && block_class->physics->body != NULL;
}

static gboolean is_rate(const TinkerColumn *column)
{
    static const TinkerDimension rate = TINKER_DIMENSION_ANGULAR_FREQUENCY;
    return tinker_dimension_equal(column->dimension, rate);
}

static gboolean is_speed(const TinkerColumn *column)
{
    static const TinkerDimension velocity = TINKER_DIMENSION_VELOCITY;
    return tinker_dimension_equal(column->dimension, velocity) || is_rate(column);
}

static gboolean is_angle(const TinkerColumn *column)
{
    static const TinkerDimension angle = TINKER_DIMENSION_ANGLE;
    return tinker_dimension_equal(column->dimension, angle);
}

/* The states of the bodies, out of what a record holds. */
static GArray *state_columns(TinkerScene *scene)
{
    static const TinkerDimension length = TINKER_DIMENSION_LENGTH;
    GArray *columns = tinker_columns_default(scene);
    for (guint i = columns->len; i-- > 0;) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, i);
        const gboolean is_state =
            tinker_dimension_equal(column->dimension, length) || is_angle(column) || is_speed(column);
        if (!is_body(scene, column->block) || !is_state) g_array_remove_index(columns, i);
    }
    return columns;
}

/* A body that turns has all its columns in m and m/s. */
static double *arms_of(const TinkerTradeBench *bench)
{
    double *arms = g_new(double, MAX(bench->columns->len, 1));
    for (guint i = 0; i < bench->columns->len; i++) {
        const TinkerColumn *column = &g_array_index(bench->columns, TinkerColumn, i);
        const double mass = tinker_frame_meaning(bench->frame, column->block, TINKER_MEANING_MASS, 0, 1);
        const double inertia = tinker_frame_meaning(bench->frame, column->block, TINKER_MEANING_INERTIA, 0, 0);
        arms[i] = is_angle(column) || is_rate(column) ? sqrt(inertia / mass) : 1;
    }
    return arms;
}

static int by_value(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

static void choose_times(TinkerTradeBench *bench)
{
    const TinkerRunOptions *run = &bench->options->run;
    if (run->at != NULL) {
        bench->time_count = run->at_count;
        bench->times = g_memdup2(run->at, run->at_count * sizeof(double));
        qsort(bench->times, bench->time_count, sizeof(double), by_value);
        bench->duration = bench->times[bench->time_count - 1];
        return;
    }
    bench->duration = run->duration;
    bench->time_count = CLAMP(MOST_NUMBERS / MAX(bench->columns->len, 1), LEAST_SAMPLES, SAMPLES);
    bench->times = g_new(double, bench->time_count);
    for (gsize i = 0; i < bench->time_count; i++)
        bench->times[i] = bench->duration * (double)(i + 1) / (double)bench->time_count;
}

gboolean tinker_trade_bench_init(TinkerTradeBench *bench, TinkerScene *scene, const TinkerTradeOptions *options,
                                 GError **error)
{
    *bench = (TinkerTradeBench){.options = options, .begun = g_get_monotonic_time()};
    bench->columns = state_columns(scene);
    bench->model = tinker_model_new(scene, error);
    if (bench->model == NULL) return FALSE;
    bench->frame = tinker_frame_new(scene, error);
    if (bench->frame == NULL) return FALSE;
    bench->arms = arms_of(bench);
    choose_times(bench);
    if (bench->duration > 0 && isfinite(bench->duration)) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                _("the duration is %g (it must be greater than 0 s: a motion is needed to measure errors of)"),
                bench->duration);
    return FALSE;
}

void tinker_trade_bench_clear(TinkerTradeBench *bench)
{
    g_clear_pointer(&bench->frame, tinker_frame_free);
    g_clear_pointer(&bench->model, tinker_model_free);
    g_clear_pointer(&bench->columns, g_array_unref);
    g_clear_pointer(&bench->times, g_free);
    g_clear_pointer(&bench->arms, g_free);
}

double tinker_trade_bench_elapsed(const TinkerTradeBench *bench)
{
    return 1e-6 * (double)(g_get_monotonic_time() - bench->begun);
}

void tinker_trade_bench_enter(TinkerTradeBench *bench, double from, double to, double seconds)
{
    bench->phase.from = from;
    bench->phase.to = to;
    bench->phase.begun = tinker_trade_bench_elapsed(bench);
    bench->phase.seconds = seconds;
    tinker_trade_bench_look(bench);
}

gboolean tinker_trade_bench_look(TinkerTradeBench *bench)
{
    const TinkerTradeOptions *options = bench->options;
    double gone = (tinker_trade_bench_elapsed(bench) - bench->phase.begun) / bench->phase.seconds;
    if (options->progress != NULL)
        options->progress(bench->phase.from + (bench->phase.to - bench->phase.from) * CLAMP(gone, 0, 1), options->data);
    if (options->cancelled != NULL && options->cancelled(options->data)) bench->cancelled = TRUE;
    return bench->cancelled;
}

/* Running ---------------------------------------------------------------------------------------------------------- */

/* TinkerRunOptions.cancelled */
static gboolean must_stop(void *data)
{
    TinkerTradeBench *bench = data;
    return tinker_trade_bench_look(bench) || g_get_monotonic_time() >= bench->run_end;
}

/* A simulation of this setting that has not begun; sampled at the bench's times or at the end alone. */
static TinkerSimulation *prepare(TinkerTradeBench *bench, TinkerTradeSetting setting, gboolean sampled, double most,
                                 GError **error)
{
    TinkerRunOptions run = bench->options->run;
    run.method = setting.method;
    run.impulses = g_str_equal(setting.method, tinker_integrator_impulse.id);
    run.accuracy = 0;
    if (setting.value > 0) *(setting.adaptive ? &run.tolerance : &run.step) = setting.value;
    run.at = sampled ? bench->times : &bench->duration;
    run.at_count = sampled ? bench->time_count : 1;
    run.cancelled = must_stop;
    run.progress = NULL;
    run.estimate = FALSE;
    run.data = bench;
    bench->run_end = g_get_monotonic_time() + (gint64)(1e6 * fmin(most, 1e9));
    return tinker_simulation_new(bench->model, &run, error);
}

typedef struct {
    TinkerTradeBench *bench;
    TinkerTrajectory *trajectory;
    double box[4]; /* least and greatest x, y of all bodies */
} Sampling;

static void widen_box(Sampling *sampling)
{
    TinkerScene *scene = tinker_frame_scene(sampling->bench->frame);
    double *box = sampling->box;
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        double x, y, orientation;
        if (!is_body(scene, block)) continue;
        tinker_frame_centre(sampling->bench->frame, block, &x, &y, &orientation);
        box[0] = fmin(box[0], x);
        box[1] = fmax(box[1], x);
        box[2] = fmin(box[2], y);
        box[3] = fmax(box[3], y);
    }
}

/* The largest speed of any body in one sample; the columns of a body stand side by side. */
static double largest_speed(const TinkerTradeBench *bench, const double *state)
{
    double largest = 0, sum = 0;
    TinkerBlockId last = TINKER_NO_BLOCK;
    for (guint i = 0; i < bench->columns->len; i++) {
        const TinkerColumn *column = &g_array_index(bench->columns, TinkerColumn, i);
        if (column->block != last) sum = 0;
        last = column->block;
        if (is_speed(column)) sum += state[i] * state[i];
        largest = fmax(largest, sum);
    }
    return sqrt(largest);
}

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    Sampling *sampling = data;
    TinkerTrajectory *trajectory = sampling->trajectory;
    if (trajectory->count >= sampling->bench->time_count) return TRUE;
    double *state = trajectory->states + trajectory->count++ * trajectory->width;
    for (gsize i = 0; i < trajectory->width; i++)
        state[i] = values[i] * sampling->bench->arms[i];
    if (!tinker_simulation_place(simulation, sampling->bench->frame, error)) return FALSE;
    widen_box(sampling);
    trajectory->speed = fmax(trajectory->speed, largest_speed(sampling->bench, state));
    return TRUE;
}

/* How far a body is turned to and fro, by the radius of gyration; all around is twice that. */
static double widest_turn(const TinkerTradeBench *bench, const TinkerTrajectory *trajectory)
{
    double widest = 0;
    for (guint i = 0; i < bench->columns->len; i++) {
        if (!is_angle(&g_array_index(bench->columns, TinkerColumn, i))) continue;
        double least = INFINITY, greatest = -INFINITY;
        for (gsize row = 0; row < trajectory->count; row++) {
            least = fmin(least, trajectory->states[row * trajectory->width + i]);
            greatest = fmax(greatest, trajectory->states[row * trajectory->width + i]);
        }
        widest = fmax(widest, fmin(greatest - least, 2 * bench->arms[i]));
    }
    return widest;
}

static void close_trajectory(const TinkerTradeBench *bench, TinkerTrajectory *trajectory, const TinkerSummary *summary,
                             const double box[4])
{
    trajectory->extent = box[0] <= box[1] ? hypot(box[1] - box[0], box[3] - box[2]) : 0;
    trajectory->extent = fmax(trajectory->extent, widest_turn(bench, trajectory));
    trajectory->steps = summary->steps;
    trajectory->evaluations = summary->evaluations;
    trajectory->touches = summary->contact_changes > 0;
    trajectory->energy_error = summary->energy_balance_error;
    trajectory->constraint_error = fmax(summary->constraint_position_error, summary->constraint_velocity_error);
    trajectory->wall_s = summary->wall_s;
}

gboolean tinker_trade_bench_sample(TinkerTradeBench *bench, TinkerTradeSetting setting, double most,
                                   TinkerTrajectory *trajectory, GError **error)
{
    g_autoptr(TinkerSimulation) simulation = prepare(bench, setting, TRUE, most, error);
    if (simulation == NULL) return FALSE;
    Sampling sampling = {bench, trajectory, {INFINITY, -INFINITY, INFINITY, -INFINITY}};
    *trajectory = (TinkerTrajectory){.width = bench->columns->len};
    trajectory->states = g_new0(double, MAX(trajectory->width * bench->time_count, 1));
    gboolean done = tinker_frame_set_time(bench->frame, 0.0, error);
    if (done) {
        widen_box(&sampling);
        done = tinker_simulation_run(simulation, bench->columns, take_sample, &sampling, error);
    }
    if (done)
        close_trajectory(bench, trajectory, tinker_simulation_summary(simulation), sampling.box);
    else
        tinker_trajectory_clear(trajectory);
    return done;
}

void tinker_trajectory_clear(TinkerTrajectory *trajectory)
{
    g_clear_pointer(&trajectory->states, g_free);
    trajectory->count = 0;
}

/* Timing ----------------------------------------------------------------------------------------------------------- */

static gboolean ignore_sample(TinkerSimulation *simulation, double time, const double *values, void *data,
                              GError **error)
{
    return TRUE;
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static double time_once(TinkerTradeBench *bench, TinkerTradeSetting setting, double most)
{
    g_autoptr(TinkerSimulation) simulation = prepare(bench, setting, FALSE, most, NULL);
    if (simulation == NULL) return NAN;
    double begun = now();
    gboolean done = tinker_simulation_run(simulation, NULL, ignore_sample, NULL, NULL);
    double wall = now() - begun;
    return done ? wall : NAN;
}

double tinker_trade_bench_time(TinkerTradeBench *bench, TinkerTradeSetting setting, double expected, int *repeats)
{
    double walls[MOST_REPEATS], sum = 0;
    double begun = now();
    *repeats = 0;
    /* What is needed around a run, in front of the clock, counts for when to stop. */
    while (*repeats < LEAST_REPEATS ||
           (*repeats < MOST_REPEATS && sum < WORTHWHILE_TIMED && now() - begun < 4 * WORTHWHILE_TIMED)) {
        double wall = time_once(bench, setting, 10 * expected + 1);
        if (isnan(wall)) return NAN;
        walls[(*repeats)++] = wall;
        sum += wall;
    }
    qsort(walls, (size_t)*repeats, sizeof walls[0], by_value);
    int middle = *repeats / 2;
    return *repeats % 2 == 1 ? walls[middle] : (walls[middle - 1] + walls[middle]) / 2;
}

/* Comparing -------------------------------------------------------------------------------------------------------- */

double tinker_trade_bench_distance(const TinkerTradeBench *bench, const TinkerTrajectory *left,
                                   const TinkerTrajectory *right, gsize samples, double extent, double speed)
{
    double largest = 0, duration = bench->duration;
    if (left->count < samples || right->count < samples) return INFINITY;
    /* What stands still, or has no extent, is measured by what it has. */
    if (!(speed > 0)) speed = extent > 0 ? extent / duration : 1;
    if (!(extent > 0)) extent = speed * duration;
    for (gsize row = 0; row < samples; row++) {
        const double *a = left->states + row * left->width, *b = right->states + row * right->width;
        double sum = 0;
        for (guint i = 0; i < bench->columns->len; i++) {
            const TinkerColumn *column = &g_array_index(bench->columns, TinkerColumn, i);
            double scale = is_speed(column) ? speed : extent;
            double part = (a[i] - b[i]) / scale;
            sum += part * part;
        }
        largest = fmax(largest, sqrt(sum));
    }
    return largest;
}
