/* What the built-in integrators share: their tables, and the few lines that every step begins or ends with. */
#ifndef TINKER_NUMERICS_STEPPING_H
#define TINKER_NUMERICS_STEPPING_H

#include <math.h>
#include <stddef.h>
#include <string.h>

#include <tinker/integrator.h>

extern const TinkerIntegrator tinker_integrator_semi_implicit_euler;
extern const TinkerIntegrator tinker_integrator_verlet;
extern const TinkerIntegrator tinker_integrator_rk4;
extern const TinkerIntegrator tinker_integrator_dopri5;
extern const TinkerIntegrator tinker_integrator_dop853;
extern const TinkerIntegrator tinker_integrator_exact;
extern const TinkerIntegrator tinker_integrator_verlet6;
extern const TinkerIntegrator tinker_integrator_newmark;
extern const TinkerIntegrator tinker_integrator_generalized_alpha;

/* Cuts `count` doubles off the memory at *next. */
static inline double *tinker_take(double **next, size_t count)
{
    double *taken = *next;
    *next += count;
    return taken;
}

static inline void tinker_copy(int32_t count, const double *from, double *to)
{
    if (count > 0) memcpy(to, from, (size_t)count * sizeof *to);
}

static inline int tinker_is_constrained(const TinkerSystem *system)
{
    return (system->flags & TINKER_SYSTEM_CONSTRAINED) != 0;
}

/* Why the system's last function failed: its own words, or `otherwise`. */
const char *tinker_failure_of(const TinkerSystem *system, const char *otherwise);

/* Begins the report of a fixed step from `t` to `limit`. A step of no length, or of none that is a number, is refused;
 * one backwards in time is not. */
TinkerStatus tinker_fixed_step_begin(double t, double limit, TinkerStepReport *report);

/* Ends a step that a fixed-step method cannot do: TINKER_FAILED with the system's reason in the report. */
TinkerStatus tinker_fixed_step_fail(const TinkerSystem *system, TinkerStepReport *report);

#endif
