/* The engine of the implicit methods of structural dynamics: a method is four weights.
 *
 * With x the acceleration that a step finds, h its length and a that of the step before,
 *
 *     q1 = q + h v + h^2 ((1/2 - beta) a + beta x),   v1 = v + h ((1 - gamma) a + gamma x)
 *     (1 - mean_acceleration) x + mean_acceleration a = (1 - mean_force) A(t1, q1, v1) + mean_force A(t, q, v)
 *
 * where A is the acceleration by all forces, those of the constraints included: their multipliers come from the level
 * of accelerations, and (q1, v1) is brought onto the constraints, as RATTLE does, before A sees it. Forces meet the
 * ends of steps, where constraints hold, rather than a mean of two ends, at which a stiff spring that turns would be
 * too short: M. Arnold, O. Bruls, Multibody System Dynamics 18 (2007) 185-202. x is found by Newton's method. Its
 * matrix,
 *
 *     (1 - mean_acceleration) M + (1 - mean_force) (h gamma C + h^2 beta K)
 *
 * with C, K the forces' own derivatives, is kept while it serves; residuals are exact, so that what it leaves out (how
 * multipliers change, the part of K that is not symmetric) costs iterations but no accuracy. With constraints a large
 * multiple of the masses along their rows is added, which leaves solutions that move along no row.
 *
 * The acceleration that is carried over belongs to a time (mean_force - mean_acceleration) h before the end of its
 * step. Where there is none, at the start and where h changes, the step is one of average acceleration (beta = 1/4,
 * gamma = 1/2, both means 0), after which it is interpolated; without that such a step would err by h^2. On starts and
 * changing steps: L. O. Jay, D. Negrut, Electronic Transactions on Numerical Analysis 26 (2007) 190-208.
 *
 * Books follow by the trapezoidal rule.
 */
#ifndef TINKER_NUMERICS_NEWMARK_FAMILY_H
#define TINKER_NUMERICS_NEWMARK_FAMILY_H

#include <tinker/integrator.h>

typedef struct TinkerNewmarkWeights {
    double mean_acceleration, mean_force, beta, gamma;
} TinkerNewmarkWeights;

/* The functions of the vtable; `create` takes the weights besides, and static text that says why steps of this system
 * are refused, or NULL. */
void *tinker_newmark_create(const TinkerNewmarkWeights *weights, const char *refusal, const TinkerSystem *system);
void tinker_newmark_destroy(void *stepper);
void tinker_newmark_restart(void *stepper);
TinkerStatus tinker_newmark_step(void *stepper, TinkerState *state, double limit, TinkerStepReport *report);
TinkerStatus tinker_newmark_interpolate(void *stepper, double t, double *q, double *v, double *books);

#endif
