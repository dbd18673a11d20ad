/* What the error estimate costs: runs with a companion, beside those without, in turns; in time that goes by, where
 * two processors are free, and in time that processors worked. Two runs without one, at once, tell how free they are:
 * where that takes longer than one, the companion's thread is slowed down as much. */
#include <math.h>

#include "numerics/sharing/sharing.h"
#include "physics/run/simulation.h"
#include "report.h"
#include "scene-text.h"
#include "subject.h"

#define ROUNDS 7

typedef struct {
    double wall, work; /* s */
} Cost;

static gboolean take(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    *(double *)data += time;
    return TRUE;
}

static Cost run(const BenchmarkSubject *subject, gboolean estimate, int threads)
{
    g_autoptr(GError) error = NULL;
    double sum = 0;
    TinkerRunOptions options = subject->options;
    options.estimate = estimate;
    tinker_share_set_threads(threads);
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(subject->model, &options, &error);
    if (simulation == NULL) g_error("%s", error->message);
    const double started = benchmark_now(), worked = benchmark_processor_time();
    if (!tinker_simulation_run(simulation, NULL, take, &sum, &error)) g_error("%s", error->message);
    return (Cost){benchmark_now() - started, benchmark_processor_time() - worked};
}

static gpointer run_alone(gpointer subject)
{
    (void)run(subject, FALSE, 1);
    return NULL;
}

/* Two runs without estimate, each on a thread of its own. */
static double run_two(BenchmarkSubject *subject, BenchmarkSubject *other)
{
    const double started = benchmark_now();
    GThread *beside = g_thread_new("other", run_alone, other);
    (void)run_alone(subject);
    g_thread_join(beside);
    return benchmark_now() - started;
}

static void figure(BenchmarkReport *report, const char *scene, const char *what, double value, const char *unit,
                   double goal)
{
    g_autofree char *name = g_strdup_printf("%s, least of %d", what, ROUNDS);
    benchmark_report_figure(report, scene, name, value, unit, goal);
}

static void measure(BenchmarkReport *report, const char *scene, char *text, const char *method, double step,
                    double duration, double interval)
{
    g_autofree char *owned = text;
    if (!benchmark_report_wants(report, scene)) return;
    BenchmarkSubject subjects[] = {benchmark_subject(text, method, step), benchmark_subject(text, method, step)};
    BenchmarkSubject *subject = &subjects[0];
    for (gsize i = 0; i < G_N_ELEMENTS(subjects); i++) {
        subjects[i].options.duration = duration;
        subjects[i].options.interval = interval;
    }
    double walls[3][ROUNDS], work[3][ROUNDS], two[ROUNDS];
    for (int i = 0; i < ROUNDS; i++) {
        two[i] = run_two(subject, &subjects[1]);
        for (int k = 0; k < 3; k++) {
            const Cost cost = run(subject, k > 0, k < 2 ? 1 : 2);
            walls[k][i] = cost.wall;
            work[k][i] = cost.work;
        }
    }
    double wall[3], worked[3];
    for (int k = 0; k < 3; k++) {
        wall[k] = benchmark_summarize(walls[k], ROUNDS).minimum;
        worked[k] = benchmark_summarize(work[k], ROUNDS).minimum;
    }
    figure(report, scene, "a run without estimate", 1e3 * wall[0], "ms", NAN);
    figure(report, scene, "two of them at once", benchmark_summarize(two, ROUNDS).minimum / wall[0], "times as long",
           NAN);
    figure(report, scene, "with it on one thread", wall[1] / wall[0], "times as long", NAN);
    figure(report, scene, "with it on two", wall[2] / wall[0], "times as long", 2.1);
    figure(report, scene, "work with it on two", worked[2] / worked[0], "times as much", NAN);
    for (gsize i = 0; i < G_N_ELEMENTS(subjects); i++)
        benchmark_subject_clear(&subjects[i]);
}

/* Masses of 1 kg in a row on springs of 1000 N/m, let go level. */
static char *chain_on_springs(int masses)
{
    GString *text = g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}, {\"type\": \"support\", "
                                 "\"name\": \"M0\", \"solid\": false}");
    for (int i = 1; i <= masses; i++)
        g_string_append_printf(text,
                               ", {\"type\": \"mass\", \"name\": \"M%d\", \"position\": [%d, 0]}, {\"type\": "
                               "\"spring\", \"ends\": [\"M%d\", \"M%d\"], \"stiffness\": 1000}",
                               i, i, i - 1, i);
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

static char *double_pendulum(void)
{
    g_autofree double *angles = benchmark_level_angles(2);
    return benchmark_chain(2, angles, 1);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    measure(report, "200 masses on springs, dop853", chain_on_springs(200), "dop853", 0, 60, 0.01);
    measure(report, "200 masses on springs, rk4", chain_on_springs(200), "rk4", 2e-3, 80, 0.1);
    measure(report, "20 masses on springs, dop853", chain_on_springs(20), "dop853", 0, 150, 0.01);
    measure(report, "double pendulum, dop853", double_pendulum(), "dop853", 0, 1e3, 0.01);
    measure(report, "double pendulum, dop853, few samples", double_pendulum(), "dop853", 0, 1e3, 1);
    measure(report, "double pendulum, rk4", double_pendulum(), "rk4", 1e-3, 1e3, 0.01);
    measure(report, "S1 oscillator hanging, rk4", benchmark_oscillator(TRUE), "rk4", 1e-3, 1e3, 0.1);
    return benchmark_report_end(report);
}
