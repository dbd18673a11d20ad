/* What a second thread brings on lattices of springs: time that goes by, in turns with one thread, once with a
 * processor to spare and once with another program on it. */
#include <math.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "numerics/sharing/sharing.h"
#include "report.h"
#include "scene-text.h"
#include "subject.h"

#define ROUNDS 15
/* Longer than a scheduler gives a program a processor at a time. */
#define ROUND_SECONDS 0.15

static double time_steps(BenchmarkSubject *subject, int threads, int steps)
{
    tinker_share_set_threads(threads);
    benchmark_subject_step(subject);
    double started = benchmark_now();
    for (int i = 0; i < steps; i++)
        benchmark_subject_step(subject);
    return (benchmark_now() - started) / steps;
}

/* A program that wants a processor all the time. */
static pid_t start_busy_program(void)
{
    pid_t child = fork();
    if (child != 0) return child;
    for (volatile double x = 1;;)
        x = x * 1.000001;
}

static void stop(pid_t child)
{
    if (child < 0) g_error("a child process could not be started");
    kill(child, SIGKILL);
    waitpid(child, NULL, 0);
}

static void compare(BenchmarkReport *report, const char *scene, BenchmarkSubject *subject, const char *when,
                    double goal)
{
    double one[ROUNDS], two[ROUNDS], ratio[ROUNDS];
    int steps = (int)ceil(ROUND_SECONDS / time_steps(subject, 1, 4));
    for (int i = 0; i < ROUNDS; i++) {
        one[i] = time_steps(subject, 1, steps);
        two[i] = time_steps(subject, 2, steps);
        ratio[i] = two[i] / one[i];
    }
    g_autofree char *first = g_strdup_printf("a step with one thread, %s, median", when);
    g_autofree char *second = g_strdup_printf("a step with two threads, %s, median", when);
    g_autofree char *third = g_strdup_printf("two threads' time of one's, %s, median", when);
    benchmark_report_figure(report, scene, first, 1e3 * benchmark_summarize(one, ROUNDS).median, "ms", NAN);
    benchmark_report_figure(report, scene, second, 1e3 * benchmark_summarize(two, ROUNDS).median, "ms", NAN);
    benchmark_report_figure(report, scene, third, benchmark_summarize(ratio, ROUNDS).median, "", goal);
}

static void measure(BenchmarkReport *report, int n, double goal)
{
    g_autofree char *scene = g_strdup_printf("S4 lattice %d x %d, threads", n, n);
    if (!benchmark_report_wants(report, scene)) return;
    g_autofree char *text = benchmark_lattice(n);
    BenchmarkSubject subject = benchmark_subject(text, "rk4", 1e-3);
    compare(report, scene, &subject, "a core free", goal);
    pid_t busy = start_busy_program();
    compare(report, scene, &subject, "one core busy", 1.1);
    stop(busy);
    benchmark_subject_clear(&subject);
}

int main(int argc, char **argv)
{
    BenchmarkReport *report = benchmark_report_new(argc, argv);
    measure(report, 100, NAN);
    measure(report, 316, 1 / 1.6);
    return benchmark_report_end(report);
}
