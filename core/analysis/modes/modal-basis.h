/* The undamped modes of a linearised model: the coordinates in which it is analysed.
 *
 * Motions that the constraints allow are spanned by the modes' shapes, v_i^T M v_j = 1 where i = j, else 0, and
 * v_i^T K v_j = square_i. Where K is a sum of positive parts of rank one, the modes are the singular vectors of its
 * factor, and every frequency has the relative accuracy of rounding, however far apart stiffnesses and masses are.
 * Source: Drmac, Veselic, "New fast and accurate Jacobi SVD algorithm", SIAM J. Matrix Anal. Appl. 29 (2008). */
#ifndef TINKER_CORE_MODAL_BASIS_H
#define TINKER_CORE_MODAL_BASIS_H

#include "physics/linearise/linearise.h"

/* More coordinates than this are refused: all is dense. */
#define TINKER_MOST_MODAL_COORDINATES 1200

typedef struct {
    int32_t size;    /* coordinates, 2 a body */
    int32_t count;   /* modes: coordinates less independent constraints */
    double *shapes;  /* size by count, column by column */
    double *squares; /* count: omega^2 (1/s^2), ascending; negative where the state is unstable, 0 for a rigid motion */
    double *damping; /* count by count: V^T C V (1/s); NULL: none */
    double *following; /* count by count: what of V^T K V is not symmetric (1/s^2); NULL: nothing */
} TinkerModalBasis;

/* Whether a model of so many coordinates is small enough; with an error like the one below where not. */
gboolean tinker_modal_basis_fits(int32_t coordinates, GError **error);

/* Errors: TINKER_MODEL_ERROR_RUN where it is too large, or numbers leave their range. (transfer full) */
TinkerModalBasis *tinker_modal_basis_new(const TinkerLinearisation *linear, GError **error);
void tinker_modal_basis_free(TinkerModalBasis *basis);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerModalBasis, tinker_modal_basis_free)

/* out (count) = V^T x, for x of `size` entries: a force into the modes' own. */
void tinker_modal_basis_reduce(const TinkerModalBasis *basis, const double *x, double *out);
/* out (size) = V y. */
void tinker_modal_basis_expand(const TinkerModalBasis *basis, const double *y, double *out);

/* Solves J x = b in the sense of least M-norm of x (size). `b` has one entry a row. FALSE where numbers leave their
 * range. */
gboolean tinker_linearisation_follow(const TinkerLinearisation *linear, const double *b, double *x);

#endif
