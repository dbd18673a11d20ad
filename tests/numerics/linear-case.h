/* Linear systems for tests, and their motion by an independent way: Taylor series in quadruple precision. */
#ifndef TINKER_TEST_LINEAR_CASE_H
#define TINKER_TEST_LINEAR_CASE_H

#include <glib.h>

#include <tinker/integrator.h>

#define CASE_MOST  64
#define CASE_BOOKS 8

typedef struct LinearCase {
    TinkerSystem system;
    TinkerLinearSystem linear;
    TinkerSignal signals[CASE_MOST];
    TinkerLinearEdge edges[CASE_MOST];
    TinkerSignalUse forces[CASE_MOST], motions[CASE_MOST];
    TinkerConstantLoad loads[CASE_MOST];
    double mass[CASE_MOST], drag[CASE_MOST], anchors[CASE_MOST];
    double q[CASE_MOST], v[CASE_MOST], books[CASE_BOOKS];
    double t;
} LinearCase;

/* `size` unit masses at rest at 0, one anchor at 0, no books. */
void case_init(LinearCase *c, int32_t size);
void case_keep_books(LinearCase *c); /* 0: dampers, 1: drag, 2: supports, others free */
TinkerLinearEdge *case_edge(LinearCase *c, int32_t a, int32_t b, double stiffness, double damping);
int32_t case_anchor(LinearCase *c, double place); /* answers the edge's end */
int32_t case_polynomial(LinearCase *c, double c0, double c1, double c2, double c3);
int32_t case_harmonic(LinearCase *c, double amplitude, double rate, double phase);
void case_force(LinearCase *c, int32_t target, int32_t signal, int32_t book, double factor);
void case_motion(LinearCase *c, int32_t end, int32_t signal, double factor);
void case_load(LinearCase *c, int32_t target, int32_t book, double force);

/* Goes to `to` in equal steps of the exact method; steps may land earlier, which is counted in the answer. */
int case_run(LinearCase *c, double to, int steps);

/* Goes to `to` by Taylor series in `steps` equal steps; on edges of one sign only. */
void case_run_by_series(LinearCase *c, double to, int steps);

/* Kinetic energy and that of the edges and of the loads without a book. */
double case_energy(const LinearCase *c);

/* Stops the test where they differ by more, or where either is no number. */
void assert_near(double value, double truth, double tolerance);

#endif
