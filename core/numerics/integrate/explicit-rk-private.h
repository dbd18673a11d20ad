/* The stepper of the adaptive explicit Runge-Kutta methods, and the parts of its step. */
#ifndef TINKER_NUMERICS_EXPLICIT_RK_PRIVATE_H
#define TINKER_NUMERICS_EXPLICIT_RK_PRIVATE_H

#include "numerics/integrate/explicit-rk.h"

/* Two numbers side by side. */
typedef double RkPair __attribute__((vector_size(16)));

/* A weighted sum of accelerations, one for q and one for v, without the terms that are 0. */
typedef struct RkRow {
    int count;
    int stage[TINKER_RK_STAGES_CAP];
    RkPair weight[TINKER_RK_STAGES_CAP]; /* for q, times h^2; for v, times h */
} RkRow;

/* A tableau with its rows as they are summed. */
typedef struct RkScheme {
    const TinkerTableau *tableau;
    RkRow rows[TINKER_RK_STAGES_CAP];
    RkRow error, second_error, dense_error;
} RkScheme;

typedef struct RkStepper {
    const TinkerSystem *system;
    RkScheme whole, brief;  /* the method's own, and that of its brief steps: without a tableau where it has none */
    const RkScheme *scheme; /* of the last step, or of the one in progress */
    TinkerStepControl control;
    double first_step;
    double reach;             /* s: how long the next step was to be behind the last whole one; 0: not known */
    double brief_h;           /* s: steps up to here are tried briefly */
    double *q0, *v0, *books0; /* the start of the last step */
    double *q, *v;            /* a stage, the trial's end */
    double *error_q, *error_v;
    double *a[TINKER_RK_STAGES_CAP];
    double *power[TINKER_RK_STAGES_CAP];
    double t0, t1;
    int done;        /* there is a last step */
    int end_known;   /* a[stages] holds the acceleration at its end ... */
    int end_is_next; /* ... which the step found, and where the state is: the next step begins with it */
    int extra_known; /* so do those behind it */
    double memory[];
} RkStepper;

/* Where sums go: alone, or onto a state that drifts for a time. */
typedef struct RkOnto {
    const double *q, *v; /* NULL: alone */
    double drift;
    double *q_out, *v_out;
} RkOnto;

/* explicit-rk-sums.c */

RkRow rk_make_row(const TinkerTableau *tableau, const double *weights);
/* With h^2 sum_j wq_j a_j and h sum_j wv_j a_j: q_out = q + (drift v + sum), v_out = v + sum. */
void rk_combine(const RkStepper *stepper, const RkRow *row, double h, const RkOnto *onto);
/* books = from + h sum_j w_j power_j, over the first `stages`. */
void rk_sum_powers(const RkStepper *stepper, int stages, const double *weights, double h, const double *from,
                   double *books);

/* explicit-rk-error.c: the error of the trial whose end lies in (q, v), relative to the tolerance. */
double rk_find_error(RkStepper *stepper, double h);

#endif
