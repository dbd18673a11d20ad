/* The implicit half kick of Verlet where forces depend on velocities.
 *
 * With the place q and time t held fixed, a(v) the applied acceleration and P the mass-weighted projection onto the
 * tangent space J v = 0, it solves
 *
 *     v1 = v0 + h P a(v1)
 *
 * by Newton's method. The linear systems (1 - h P D) x = r, D = da/dv, are symmetric in the mass inner product wherever
 * forces come from line laws, and positive definite wherever they dissipate, so conjugate gradients need no matrix.
 * Forces across the velocity (Coriolis's, a magnet's) make them unsymmetric, and conjugate residuals as little.
 */
#ifndef TINKER_NUMERICS_DAMPING_H
#define TINKER_NUMERICS_DAMPING_H

#include <tinker/integrator.h>

#define TINKER_KEPT_DIRECTIONS 8

typedef struct TinkerDampingSolver {
    const TinkerSystem *system;
    double *start, *trial, *acceleration, *residual, *correction, *left, *direction, *product;
    double *directions, *images; /* TINKER_KEPT_DIRECTIONS each, of operators without symmetry */
} TinkerDampingSolver;

/* How many doubles of memory a solver for n coordinates needs. */
size_t tinker_damping_doubles(int32_t n);

/* Cuts the arrays off the memory at *next. */
void tinker_damping_init(TinkerDampingSolver *solver, const TinkerSystem *system, double **next);

/* Replaces v by v1. power, unless it is NULL, becomes the power at (t, q, v1). TINKER_RETRY_SMALLER where the iteration
 * does not converge; v is then undefined. */
TinkerStatus tinker_damping_half_step(TinkerDampingSolver *solver, double t, double h, const double *q, double *v,
                                      double *power);

#endif
