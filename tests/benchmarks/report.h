/* What a benchmark program prints: a table while it goes on, and the same as JSON where a file was asked for. */
#ifndef BENCHMARK_REPORT_H
#define BENCHMARK_REPORT_H

#include <cjson/cJSON.h>
#include <glib.h>

#include "measure.h"

typedef struct _BenchmarkReport BenchmarkReport;

/* Reads `--json FILE`, and `--only TEXT`: only scenes whose name contains it are run. Ends the program with a message
 * where there is any other option. (transfer full) */
BenchmarkReport *benchmark_report_new(int argc, char **argv);

/* Writes the JSON. Answers the program's exit status. */
int benchmark_report_end(BenchmarkReport *report);

gboolean benchmark_report_wants(const BenchmarkReport *report, const char *scene);

/* The cost of a step, beside that of a program written for the one scene. */
typedef struct {
    const char *scene, *method;
    BenchmarkTiming step, floor; /* s */
    double elements;             /* that a step's cost is divided by: springs, links; 1 for small scenes */
    double goal;                 /* ns per step and element; NAN for none */
    const char *error_kind;      /* what `error` and `floor_error` are; NULL: no error was looked at */
    double error, floor_error;   /* `floor_error` NAN where `error` is against the floor */
} BenchmarkStep;
void benchmark_report_step(BenchmarkReport *report, const BenchmarkStep *step);

/* Any other figure, with the bound it is to stay below; NAN for none. */
void benchmark_report_figure(BenchmarkReport *report, const char *scene, const char *what, double value,
                             const char *unit, double goal);

/* Adds to a list of the JSON, which prints nothing. (transfer full) */
void benchmark_report_add(BenchmarkReport *report, const char *list, cJSON *item);

#endif
