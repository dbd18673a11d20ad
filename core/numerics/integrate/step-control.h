/* Step size control of the adaptive methods.
 *
 * Errors are measured in the largest norm against the extent and the largest speed of the system, never against |q| and
 * never against an absolute number: a problem scaled in length, time or mass takes the same steps.
 */
#ifndef TINKER_NUMERICS_STEP_CONTROL_H
#define TINKER_NUMERICS_STEP_CONTROL_H

#include <tinker/integrator.h>

/* How a method's error turns into the next step: h times safety * error^-exponent * last_error^memory, within the
 * factors. */
typedef struct TinkerStepLaw {
    double exponent;
    double memory;
    double least_factor;
    double greatest_factor;
} TinkerStepLaw;

typedef struct TinkerStepControl {
    const TinkerStepLaw *law;
    double tolerance;
    double h;            /* the step to try next, s; 0: not known yet */
    double last_error;   /* of the last accepted step */
    double usual;        /* s: how long steps were lately, however short they are now; 0: not known */
    double usual_before; /* s: how long steps were lately, kept by tinker_step_control_forget; of what is at rest,
                            before the first, how long they may be */
} TinkerStepControl;

/* What an error in q and one in v are divided by. */
typedef struct TinkerErrorScale {
    double q, v;
} TinkerErrorScale;

/* Tolerances below what doubles can meet are raised to that. */
void tinker_step_control_init(TinkerStepControl *control, const TinkerStepLaw *law, double tolerance);

/* Forgets the step size and the last error. */
void tinker_step_control_forget(TinkerStepControl *control);

/* The length of the next trial: the known step, or less (or 1 % more) so as to end on `limit`, or half of what remains
 * where one step would leave a crumb. *lands becomes 1 where it ends on `limit`. */
double tinker_step_control_trial(const TinkerStepControl *control, double t, double limit, int *lands);

/* After an accepted step of length h: sets the next one. A step that was cut short to land does not lower it, one that
 * followed a rejection does not raise it. */
void tinker_step_control_accept(TinkerStepControl *control, double h, double error, int rejected);

/* After a rejected trial of length h. An error that is not finite counts as very large. Returns 0 where the step would
 * become too small for t to change. */
int tinker_step_control_reject(TinkerStepControl *control, double t, double h, double error);

/* The scales for a step of length h between two states with the accelerations `a` at its start. A scale that the system
 * does not have is replaced by what the step can bring about: h max|a| for the speed, h times the speed for the extent.
 * To the velocity's scale is added what moves the system by two roundings of its extent within a step of the usual
 * length, so that the rounding of large, balanced forces does not drive the step down. Of a shorter step it is less, as
 * what such forces do within it is: a force that jumps is no rounding, however short the steps are that find the jump.
 */
TinkerErrorScale tinker_error_scale(const TinkerSystem *system, const TinkerStepControl *control, double h,
                                    const double *q0, const double *v0, const double *q1, const double *v1,
                                    const double *a);

/* value / scale, and 0 for 0 / 0. */
double tinker_relative(double value, double scale);

/* A first step for a method of this order, from the state and the acceleration `a` there: (tolerance)^(1/(order+1)) of
 * the shortest time in which v, a and the change of a over a probing Euler step would cross the system. After Hairer,
 * Norsett, Wanner, Solving Ordinary Differential Equations I, II.4, rewritten so that no units mix. The arrays q1, v1,
 * a1 are for work. */
TinkerStatus tinker_starting_step(const TinkerSystem *system, int order, double tolerance, const TinkerState *state,
                                  double limit, const double *a, double *q1, double *v1, double *a1, double *h);

#endif
