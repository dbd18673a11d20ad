/* Undamped modes of masses joined by springs, every frequency accurate to rounding of its own size, however far the
 * stiffnesses and masses lie apart. */
#ifndef TINKER_NUMERICS_LINEAR_MODES_H
#define TINKER_NUMERICS_LINEAR_MODES_H

#include <glib.h>

/* How many doubles of work memory n coordinates need. */
gsize tinker_linear_modes_work(int32_t n);

/* Modes of M x'' + K x = 0 where K is given by what it is made of, all of it >= 0: `weights` (n x n, symmetric,
 * diagonal ignored) holds the stiffness between two coordinates, `ground` (n) that to anchors. Both are destroyed.
 *
 * omega[j] in rad/s, not sorted; exactly 0 for rigid motion of parts that no spring holds. shape[i * n + j] is
 * coordinate i of mode j, normalised so that shape^T M shape = I (1/sqrt(kg)). FALSE where the rotations do not
 * converge.
 *
 * Source: J. Demmel, P. Koev, "Accurate SVDs of weakly diagonally dominant M-matrices", Numer. Math. 98 (2004)
 * 99-104, for the factor; K. Veselic, V. Hari, "A note on a one-sided Jacobi algorithm", Numer. Math. 56 (1989)
 * 627-633. */
gboolean tinker_linear_modes(int32_t n, const double *mass, double *weights, double *ground, double *omega,
                             double *shape, double *work);

#endif
