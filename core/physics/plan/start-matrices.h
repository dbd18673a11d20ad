/* Mass-normalised stiffness and damping of an island at its start, as products with vectors:
 *
 *     P M^-1/2 K M^-1/2 P x   and   P M^-1/2 C M^-1/2 P x,
 *
 * P the projection on the tangent space of the constraints. K holds what the constraints' tensions add,
 * -sum of lambda d2g/dq2. Coordinates are those of the linear form, where the island has one, else of its model. */
#ifndef TINKER_CORE_START_MATRICES_H
#define TINKER_CORE_START_MATRICES_H

#include "physics/plan/islands.h"

typedef struct _TinkerStartMatrices TinkerStartMatrices;

/* NULL where forces cannot be worked out at the start. The island is borrowed, and its model must not be used in
 * between products. (transfer full) */
TinkerStartMatrices *tinker_start_matrices_new(const TinkerIsland *island);
void tinker_start_matrices_free(TinkerStartMatrices *matrices);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerStartMatrices, tinker_start_matrices_free)

int32_t tinker_start_matrices_size(const TinkerStartMatrices *matrices);
gboolean tinker_start_matrices_damped(const TinkerStartMatrices *matrices);

/* Whether forces act across velocities (Coriolis's, a magnet's): C has an antisymmetric part. */
gboolean tinker_start_matrices_turned(const TinkerStartMatrices *matrices);

/* TinkerOperator each, with the matrices as data; `turning`: of C's antisymmetric part, 0 of islands of thousands of
 * bodies. */
void tinker_start_matrices_stiffness(void *matrices, const double *x, double *y);
void tinker_start_matrices_damping(void *matrices, const double *x, double *y);
void tinker_start_matrices_turning(void *matrices, const double *x, double *y);

/* The products without P, and a basis of the tangent space instead (size * size doubles, column by column; its number
 * of vectors, or -1): for dense matrices. */
void tinker_start_matrices_free_stiffness(void *matrices, const double *x, double *y);
void tinker_start_matrices_free_damping(void *matrices, const double *x, double *y);
/* The first, less what the motion at the start takes off (start-geometry.h): what grows beside that motion does so by
 * it. `moves`: they differ. */
void tinker_start_matrices_moving_stiffness(void *matrices, const double *x, double *y);
gboolean tinker_start_matrices_moves(const TinkerStartMatrices *matrices);
int32_t tinker_start_matrices_tangents(TinkerStartMatrices *matrices, double *basis);

/* M^1/2 a and M^1/2 v of the start. Borrowed. */
const double *tinker_start_matrices_acceleration(const TinkerStartMatrices *matrices);
const double *tinker_start_matrices_velocity(const TinkerStartMatrices *matrices);

/* Twice the energy (J) that the start's forces hold against the stiffness: f . u with K u = f. NAN where K has no
 * inverse that is positive, or constraints hold the island, or it is large. *omega (rad/s) is the frequency of u by
 * Rayleigh's quotient. */
double tinker_start_matrices_held_energy(TinkerStartMatrices *matrices, double *omega);

/* Displacements, 2 a body of the model, of a mass-normalised vector. */
void tinker_start_matrices_shape(const TinkerStartMatrices *matrices, const double *x, double *shape);

#endif
