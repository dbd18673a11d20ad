/* The exact integrator: a linear system stepped to rounding, whatever the length of the step, and what that costs. */
#ifndef TINKER_NUMERICS_EXACT_H
#define TINKER_NUMERICS_EXACT_H

#include <glib.h>
#include <tinker/integrator.h>

/* Whether the method takes the system: stiffness not negative, masses above 0, and no part with more coordinates
 * than it has room for (1500; 400 where dampers couple the modes). */
gboolean tinker_exact_suits(const TinkerLinearSystem *system);

/* Whether every part is damped proportionally (Rayleigh: c = beta k on its edges, drag = alpha m on its masses),
 * so that its modes stay apart. Other damping may leave them apart too; that shows only when the modes are known. */
gboolean tinker_exact_is_proportional(const TinkerLinearSystem *system);

/* Floating-point operations of `steps` equal steps without books; *setup, unless it is NULL, gets what comes once
 * before them. Counts, not times: the same system has the same. The length of the steps enters by a logarithm
 * only, and is taken as a typical one. INFINITY where the system does not suit. */
double tinker_exact_operations(const TinkerLinearSystem *system, gint64 steps, double *setup);

/* rad/s: a bound of the frequencies, by Gershgorin's circles about the rows of M^-1 K. */
double tinker_exact_fastest(const TinkerLinearSystem *system);

/* The interval (s) at which a run of `duration` is stepped: a share of it, so that the run is watched, and where
 * signals (the fastest of `drive`, rad/s) or dampers act on the modes together so short that states on the way cost
 * little. It depends on nothing else: who looks at the run when is not asked. */
double tinker_exact_interval(const TinkerLinearSystem *system, double drive, double duration);

/* The error to expect after the time T, relative to the system's scales: rounding times omega T, with omega a
 * bound on the system's rates, for what moves at that rate; at least a few roundings. */
double tinker_exact_claimed_error(const TinkerLinearSystem *system, double T);

#endif
