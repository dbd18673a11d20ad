/* One step of velocity Verlet, for the methods that are made of such steps.
 *
 * With a(t, q, v) the applied acceleration and P the projection onto the tangent space J v = 0 a step is
 *
 *     v <- v + h/2 P a(t0, q0, v)       implicit in v: damping.h; explicit where a does not depend on v
 *     q <- q + h v                      with rods both corrected along J(q0)^T so that g(q, t1) = 0
 *     v projected onto J v + dg/dt = 0 at the new place
 *     v <- v + h/2 P a(t1, q1, v)       explicit
 *
 * The explicit half is the adjoint of the implicit one, so the whole is symmetric and of order 2. Which comes first
 * matters for stiff dampers: this way round the drift sees the damped velocity. Between two steps the explicit and the
 * implicit half join to the trapezoidal rule, whose factor (1 - z) / (1 + z), z = hc/2m, never exceeds 1 in size; for
 * x'' = -omega^2 x - c/m x' the step has determinant (1 - z) / (1 + z) and is stable for h omega <= 2 whatever c is. A
 * velocity that forces and dampers hold in balance is met exactly. What is not so held, a first velocity against a
 * damper with z >> 1, dies in slow alternation, as with the trapezoidal rule.
 *
 * Books follow by the trapezoidal rule. Damped, the powers are those after the implicit and before the explicit half:
 * either is off by order h, and the two cancel. Undamped, there are two ways:
 *
 *   - the velocity at the end is extrapolated from the start over the middle, so that one evaluation gives force and
 *     power; this is of order 2 but not symmetric;
 *   - the power is worked out at the end itself, one evaluation more, and the step is symmetric in its books too, which
 *     compositions of a higher order need.
 */
#ifndef TINKER_NUMERICS_VERLET_STEP_H
#define TINKER_NUMERICS_VERLET_STEP_H

#include <tinker/integrator.h>

#include "numerics/integrate/damping.h"

typedef struct TinkerVerlet {
    const TinkerSystem *system;
    TinkerDampingSolver damping;
    int damped;
    int symmetric_books; /* the second way */
    int carried;         /* `a` and `power_from` of an undamped system belong to the present state */
    double *a;
    double *ahead; /* the extrapolated velocity */
    double *power_from, *power_to;
} TinkerVerlet;

/* How many doubles of memory a step of this system needs. */
size_t tinker_verlet_doubles(const TinkerSystem *system);

/* Cuts the arrays off the memory at *next; nothing is carried over yet. */
void tinker_verlet_init(TinkerVerlet *verlet, const TinkerSystem *system, int symmetric_books, double **next);

/* Advances the state, books included, by h to the time `limit`. q_from and v_from are copies of its q and v; v_from is
 * read where books are extrapolated, q_from with rods. h may be negative. On failure the state is undefined and nothing
 * is carried over. */
TinkerStatus tinker_verlet_advance(TinkerVerlet *verlet, TinkerState *state, double h, double limit,
                                   const double *q_from, const double *v_from);

#endif
