/* What piles cost: ten stacks of ten boxes as they come to rest and at rest (S7), with how far they have sunk; and
 * walls of 100 to 5 000 boxes that a disc runs into, by the point of contact. */
#include <math.h>

#include "numerics/sharing/sharing.h"
#include "physics/contact/contacts.h"
#include "report.h"
#include "scene-text.h"
#include "subject.h"

#define STEP    (1.0 / 60)
#define SETTLE  120 /* steps until stacks rest */
#define BATCHES 9
#define BATCH   600

static double step_for(BenchmarkSubject *subject, int steps)
{
    const double started = benchmark_processor_time();
    for (int i = 0; i < steps; i++)
        benchmark_subject_step(subject);
    return (benchmark_processor_time() - started) / steps;
}

/* The best of some batches, of a step. */
static double best_of(BenchmarkSubject *subject)
{
    double best = INFINITY;
    for (int batch = 0; batch < BATCHES; batch++)
        best = fmin(best, step_for(subject, BATCH));
    return best;
}

static void measure_stacks(BenchmarkReport *report)
{
    static const char scene[] = "S7 ten stacks of ten boxes";
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = benchmark_stacks();
    BenchmarkSubject subject = benchmark_subject(text, "rk4", STEP);
    const double falling = step_for(&subject, SETTLE), rest = best_of(&subject);
    double top[2];
    benchmark_subject_place(&subject, "Box 9", top);
    benchmark_report_figure(report, scene, "2 s from the start, a step", 1e6 * falling, "us", NAN);
    benchmark_report_figure(report, scene, "at rest, a step", 1e6 * rest, "us", 21);
    benchmark_report_figure(report, scene, "the highest has sunk by", 1e9 * (4.75 - top[1]), "nm", 1000);
    benchmark_subject_clear(&subject);
}

/* Rows of ten, beside one another; a disc of 100 kg runs into the first. */
static void measure_wall(BenchmarkReport *report, int boxes)
{
    g_autofree char *scene = g_strdup_printf("wall of %d boxes, hit by a disc", boxes);
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = benchmark_wall(boxes);
    BenchmarkSubject subject = benchmark_subject(text, "rk4", STEP);
    const double step = step_for(&subject, 60);
    const guint points = subject.model->contacts == NULL ? 0 : subject.model->contacts->pressings->len;
    benchmark_report_figure(report, scene, "1 s from the start, a step", 1e6 * step, "us", 16667);
    benchmark_report_figure(report, scene, "points that press at its end", points, "", NAN);
    benchmark_report_figure(report, scene, "a step and point", 1e9 * step / MAX(points, 1), "ns", NAN);
    benchmark_subject_clear(&subject);
}

int main(int argc, char **argv)
{
    static const int boxes[] = {100, 200, 500, 1000, 2000, 5000};
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    tinker_share_set_threads(1);
    measure_stacks(report);
    for (gsize i = 0; i < G_N_ELEMENTS(boxes); i++)
        measure_wall(report, boxes[i]);
    return benchmark_report_end(report);
}
