/* A scene as the program runs it: text read, plugins opened from the build, model compiled, and a run that is stepped.
 */
#ifndef BENCHMARK_SUBJECT_H
#define BENCHMARK_SUBJECT_H

#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/run/simulation.h"

typedef struct {
    TinkerCatalogue *catalogue;
    TinkerScene *scene;
    TinkerModel *model;
    TinkerRunOptions options;
    TinkerSimulation *simulation;
    double lap; /* s of motion after which a lap starts over; INFINITY: never */
} BenchmarkSubject;

/* Any failure ends the program with its message: a benchmark of something broken has no figures. */
BenchmarkSubject benchmark_subject(const char *text, const char *method, double step);
void benchmark_subject_clear(BenchmarkSubject *subject);

/* Back to t = 0. */
void benchmark_subject_restart(BenchmarkSubject *subject);

void benchmark_subject_step(BenchmarkSubject *subject);

/* As BenchmarkWork: a unit is a step. Starting a lap over is outside the clock. */
double benchmark_subject_work(gint64 steps, void *subject);

/* Where a block is now, in the world. */
void benchmark_subject_place(BenchmarkSubject *subject, const char *block, double place[2]);

#endif
