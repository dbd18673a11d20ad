/* Taking times and memory of a piece of work: the clock around batches of it, or a child process around the whole. */
#ifndef BENCHMARK_MEASURE_H
#define BENCHMARK_MEASURE_H

#include <glib.h>

/* Seconds of one unit of work: the middle and the least of several batches. Neighbours on the machine make a batch
 * slower, never faster, so the least is what the program costs and the median what it cost today. */
typedef struct {
    double median, minimum;
} BenchmarkTiming;

/* Does `units` of work and answers the seconds it took by its own clock, so that preparing may stay outside. */
typedef double (*BenchmarkWork)(gint64 units, void *data);

/* Time that went by, s; and time that this process had a processor, s, to which the others on a shared machine add
 * nothing. */
double benchmark_now(void);
double benchmark_processor_time(void);

/* A piece of work, and what came out. */
typedef struct {
    BenchmarkWork work;
    void *data;
    BenchmarkTiming timing;
} BenchmarkTask;

/* Warms up, finds how many units of each task take 12 ms or more, and times batches of that many, of the two in turns:
 * what slows the machine down meets both. */
void benchmark_time_pair(BenchmarkTask *first, BenchmarkTask *second);

/* The middle and the least of values; sorts them. */
BenchmarkTiming benchmark_summarize(double *values, gsize count);

/* What a finished child used. */
typedef struct {
    gboolean fine;    /* it exited with status 0 */
    double wall;      /* s, from before its start until after its end */
    double processor; /* s, that it had a processor, the system's part included */
    double peak_rss;  /* bytes; includes what this process had when it started the child */
} BenchmarkChild;

/* Does work in a child process, which fills in `count` values; what it allocates never becomes ours. */
BenchmarkChild benchmark_in_child(void (*work)(void *data, double *values), void *data, double *values, gsize count);

/* The program under test. (transfer full) */
char *benchmark_program(void);

/* Runs a program (arguments ended by NULL, the program first) with its standard output thrown away. */
BenchmarkChild benchmark_run(const char *const *arguments);

/* The largest amount of memory this process has had, bytes. */
double benchmark_peak_rss(void);

#endif
