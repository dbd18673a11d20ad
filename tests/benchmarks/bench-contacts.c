/* What contact costs: 100 masses on ten supports, as impulses, and by events between events beside the same scene
 * without contact. */
#include <math.h>

#include "numerics/sharing/sharing.h"
#include "report.h"
#include "subject.h"

#define MASSES   100
#define SUPPORTS 10
#define STEP     1e-3
/* s: on the steeper slopes masses slide, and do not reach the end by then. */
#define LAP 2.0

/* What the masses do. */
typedef enum {
    REST,   /* all stick, on slopes that friction holds */
    SLIDE,  /* all slide */
    MIXED,  /* every other slope */
    BOUNCE, /* they fall from different heights, and bounce until they rest or slide */
} Motion;

static double slope_of(Motion motion, int support)
{
    gboolean slides = motion == SLIDE || (motion != REST && support % 2 == 1);
    return (support % 4 < 2 ? 1 : -1) * (slides ? 0.6 : 0.1);
}

/* Supports of 100 m, 200 m from each other, with ten masses on each. */
static char *scene_of(Motion motion, const char *contacts, gboolean solid)
{
    GString *text = g_string_new(NULL);
    g_string_append_printf(
        text, "{\"tinker\": 1, \"run\": {\"contacts\": \"%s\"}, \"blocks\": [{\"type\": \"gravity\"}", contacts);
    for (int k = 0; k < SUPPORTS; k++)
        g_string_append_printf(text,
                               ", {\"type\": \"support\", \"position\": [%d, 0], \"width\": 100, \"height\": 0.4, "
                               "\"orientation\": %.17g, \"static_friction\": 0.5, \"dynamic_friction\": 0.4, "
                               "\"restitution\": 0.5, \"solid\": %s}",
                               200 * k, slope_of(motion, k), solid ? "true" : "false");
    for (int i = 0; i < MASSES; i++) {
        double angle = slope_of(motion, i / 10), along = 3 * (i % 10) - 15;
        double off = 0.3 + (motion == BOUNCE ? 0.5 + 0.07 * (i % 10) : 0.0);
        g_string_append_printf(
            text, ", {\"type\": \"mass\", \"mass\": %g, \"width\": 0.2, \"height\": 0.2, \"position\": [%.17g, %.17g]}",
            1 + 0.1 * (i % 7), 200 * (i / 10) + along * cos(angle) - off * sin(angle),
            along * sin(angle) + off * cos(angle));
    }
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

static BenchmarkSubject subject_of(Motion motion, const char *contacts, gboolean solid)
{
    g_autofree char *text = scene_of(motion, contacts, solid);
    return benchmark_subject(text, "rk4", STEP);
}

/* As BenchmarkWork: a unit is a run of all masses through a lap. Preparing it is outside the clock. */
static double time_runs(gint64 runs, void *data)
{
    BenchmarkSubject *subject = data;
    double seconds = 0;
    for (; runs > 0; runs--) {
        g_autoptr(GError) error = NULL;
        benchmark_subject_restart(subject);
        double started = benchmark_processor_time();
        if (!tinker_simulation_run(subject->simulation, NULL, NULL, NULL, &error)) g_error("%s", error->message);
        seconds += benchmark_processor_time() - started;
    }
    return seconds;
}

static BenchmarkTask task_of(BenchmarkSubject *subject)
{
    subject->options.duration = subject->options.interval = LAP;
    subject->options.estimate = FALSE;
    return (BenchmarkTask){.work = time_runs, .data = subject};
}

static void measure(BenchmarkReport *report, Motion motion, const char *what)
{
    g_autofree char *scene = g_strdup_printf("100 masses, %s", what);
    if (!benchmark_report_wants(report, scene)) return;
    BenchmarkSubject impulses = subject_of(motion, "impulse", TRUE), events = subject_of(motion, "events", TRUE);
    BenchmarkSubject without = subject_of(motion, "events", FALSE);
    BenchmarkTask impulse_task = task_of(&impulses), event_task = task_of(&events), plain_task = task_of(&without);
    benchmark_time_pair(&impulse_task, &event_task);
    benchmark_time_pair(&plain_task, &event_task);
    const double a_step = 1e9 * STEP / LAP, ns = a_step * impulse_task.timing.minimum;
    const double by_events = a_step * event_task.timing.minimum, plain = a_step * plain_task.timing.minimum;
    benchmark_report_figure(report, scene, "as impulses, a step", ns, "ns", 15000);
    benchmark_report_figure(report, scene, "as impulses, a step and mass", ns / MASSES, "ns", NAN);
    benchmark_report_figure(report, scene, "by events (rk4), a step", by_events, "ns", NAN);
    benchmark_report_figure(report, scene, "without contact (rk4), a step", plain, "ns", NAN);
    /* between events: those of bounces are no part of the goal */
    benchmark_report_figure(report, scene, "by events over without contact", by_events / plain, "",
                            motion == BOUNCE ? NAN : 5);
    benchmark_subject_clear(&impulses);
    benchmark_subject_clear(&events);
    benchmark_subject_clear(&without);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    tinker_share_set_threads(1);
    measure(report, REST, "at rest");
    measure(report, SLIDE, "sliding");
    measure(report, MIXED, "rest and slide");
    measure(report, BOUNCE, "bouncing");
    return benchmark_report_end(report);
}
