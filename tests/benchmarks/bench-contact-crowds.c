/* What many bodies cost that could meet, by events: boxes in a row that fall onto a floor, each at its time, and masses
 * that fly about in a box of walls. */
#include <math.h>

#include "numerics/sharing/sharing.h"
#include "report.h"
#include "subject.h"

/* `rebound`: over and over, until they lie. */
static char *row_of(int boxes, double rebound)
{
    GString *text = g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"gravity\"}");
    g_string_append_printf(text,
                           ", {\"type\": \"support\", \"position\": [0, -0.1], \"width\": %g, \"height\": 0.2, "
                           "\"restitution\": %g}",
                           1.5 * boxes + 4, rebound);
    for (int i = 0; i < boxes; i++)
        g_string_append_printf(text,
                               ", {\"type\": \"box\", \"mass\": 1, \"width\": 1, \"height\": 0.4, \"restitution\": %g, "
                               "\"position\": [%.17g, %.17g]}",
                               rebound, 1.5 * (i - 0.5 * boxes), 0.5 + 0.4 * (i * 7919 % boxes) / boxes);
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

/* Half a metre apart, with speeds of up to 1 m/s along both directions. */
static char *crowd_of(int masses)
{
    GString *text = g_string_new("{\"tinker\": 1, \"blocks\": [{\"type\": \"note\"}");
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    const int row = (int)ceil(sqrt(masses));
    const double middle = 0.25 * row, off[] = {-0.1, 0.5 * row + 0.1};
    for (int i = 0; i < 4; i++)
        g_string_append_printf(
            text,
            ", {\"type\": \"support\", \"position\": [%.17g, %.17g], \"width\": %g, \"height\": 0.2, "
            "\"orientation\": \"%d deg\", \"restitution\": 1}",
            i < 2 ? middle : off[i - 2], i < 2 ? off[i] : middle, 0.5 * row + 1, (const int[]){0, 180, -90, 90}[i]);
    for (int i = 0; i < masses; i++)
        g_string_append_printf(text,
                               ", {\"type\": \"mass\", \"width\": 0.15, \"height\": 0.15, \"collides\": true, "
                               "\"restitution\": 1, \"position\": [%g, %g], \"velocity\": [%.17g, %.17g]}",
                               0.25 + 0.5 * (i % row), 0.25 + 0.5 * (i / row), g_rand_double_range(random, -1, 1),
                               g_rand_double_range(random, -1, 1));
    g_string_append(text, "]}");
    return g_string_free(text, FALSE);
}

/* Takes the text. */
static void measure(BenchmarkReport *report, const char *scene, char *text, double duration, double goal)
{
    if (benchmark_report_wants(report, scene)) {
        BenchmarkSubject subject = benchmark_subject(text, "auto", 0);
        g_autoptr(GError) error = NULL;
        subject.options.duration = subject.options.interval = duration;
        subject.options.estimate = FALSE;
        benchmark_subject_restart(&subject);
        const double started = benchmark_processor_time();
        if (!tinker_simulation_run(subject.simulation, NULL, NULL, NULL, &error)) g_error("%s", error->message);
        benchmark_report_figure(report, scene, "the run", benchmark_processor_time() - started, "s", goal);
        benchmark_subject_clear(&subject);
    }
    g_free(text);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    tinker_share_set_threads(1);
    measure(report, "64 boxes in a row, 2 s", row_of(64, 0), 2, NAN);
    measure(report, "100 boxes in a row, 2 s", row_of(100, 0), 2, 5);
    measure(report, "256 boxes in a row, 2 s", row_of(256, 0), 2, NAN);
    measure(report, "100 boxes that rebound, 2 s", row_of(100, 0.5), 2, NAN);
    measure(report, "200 masses in a box, 1 s", crowd_of(200), 1, 5);
    return benchmark_report_end(report);
}
