/* Batches under a clock, and children under wait4; see the header. */
#include "measure.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define BATCHES       9
#define BATCH_SECONDS 0.012

static double clock_seconds(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double benchmark_now(void)
{
    return clock_seconds(CLOCK_MONOTONIC);
}

double benchmark_processor_time(void)
{
    return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

static int by_value(const void *a, const void *b)
{
    double first = *(const double *)a, second = *(const double *)b;
    return (first > second) - (first < second);
}

BenchmarkTiming benchmark_summarize(double *values, gsize count)
{
    qsort(values, count, sizeof(double), by_value);
    return (BenchmarkTiming){values[count / 2], values[0]};
}

/* By doubling, which warms the caches as well. */
static gint64 batch_units(const BenchmarkTask *task)
{
    gint64 units = 1;
    while (task->work(units, task->data) < BATCH_SECONDS)
        units *= 2;
    return units;
}

void benchmark_time_pair(BenchmarkTask *first, BenchmarkTask *second)
{
    BenchmarkTask *tasks[] = {first, second};
    gint64 units[] = {batch_units(first), batch_units(second)};
    double values[2][BATCHES];
    for (int i = 0; i < BATCHES; i++)
        for (int k = 0; k < 2; k++)
            values[k][i] = tasks[k]->work(units[k], tasks[k]->data) / (double)units[k];
    for (int k = 0; k < 2; k++)
        tasks[k]->timing = benchmark_summarize(values[k], BATCHES);
}

static double seconds(const struct timeval *time)
{
    return (double)time->tv_sec + 1e-6 * (double)time->tv_usec;
}

static BenchmarkChild wait_for(pid_t child, double started)
{
    int status = 0;
    struct rusage used = {0};
    if (child < 0 || wait4(child, &status, 0, &used) != child) g_error("a child process could not be started");
    return (BenchmarkChild){WIFEXITED(status) && WEXITSTATUS(status) == 0, benchmark_now() - started,
                            seconds(&used.ru_utime) + seconds(&used.ru_stime), 1024.0 * (double)used.ru_maxrss};
}

static gboolean read_whole(int from, void *to, gsize size)
{
    char *next = to;
    while (size > 0) {
        ssize_t got = read(from, next, size);
        if (got <= 0) return FALSE;
        next += got;
        size -= (gsize)got;
    }
    return TRUE;
}

BenchmarkChild benchmark_in_child(void (*work)(void *data, double *values), void *data, double *values, gsize count)
{
    int ends[2];
    if (pipe(ends) != 0) g_error("no pipe");
    double started = benchmark_now();
    pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        work(data, values);
        ssize_t size = (ssize_t)(count * sizeof(double));
        _exit(write(ends[1], values, (gsize)size) == size ? 0 : 1);
    }
    close(ends[1]);
    gboolean heard = read_whole(ends[0], values, count * sizeof(double));
    close(ends[0]);
    BenchmarkChild used = wait_for(child, started);
    used.fine = used.fine && heard;
    return used;
}

char *benchmark_program(void)
{
    g_autofree char *own = g_file_read_link("/proc/self/exe", NULL);
    g_autofree char *folder = g_path_get_dirname(own);
    const char *given = g_getenv("TINKER_PROGRAM");
    return given != NULL ? g_strdup(given) : g_build_filename(folder, "..", "..", "host", "cli", "tinker", NULL);
}

BenchmarkChild benchmark_run(const char *const *arguments)
{
    double started = benchmark_now();
    pid_t child = fork();
    if (child == 0) {
        int nowhere = open("/dev/null", O_WRONLY);
        if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
        execv(arguments[0], (char *const *)arguments);
        _exit(127);
    }
    return wait_for(child, started);
}

double benchmark_peak_rss(void)
{
    struct rusage used = {0};
    getrusage(RUSAGE_SELF, &used);
    return 1024.0 * (double)used.ru_maxrss;
}
