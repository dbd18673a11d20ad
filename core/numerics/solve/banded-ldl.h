/* L D L^T of symmetric matrices with a narrow band, without any indirection.
 *
 * Pivots are not exchanged: meant for matrices that are positive definite or nearly so. A negative pivot is let pass,
 * as the caller checks residuals. A tridiagonal matrix is eliminated from both ends to the middle, two runs that do not
 * wait for each other. */
#ifndef TINKER_NUMERICS_BANDED_LDL_H
#define TINKER_NUMERICS_BANDED_LDL_H

#include <glib.h>
#include <stdint.h>

typedef struct {
    int32_t size, width; /* width: entries left of the diagonal */
    double *pivots;      /* of each row; before factoring the diagonal, afterwards reciprocals */
    double *rows;        /* `width` a row: entry k is column row - width + k; those left of column 0 are 0 */
    double *upper;       /* tridiagonal: factors of the run from the far end */
} TinkerBandedLdl;

void tinker_banded_ldl_init(TinkerBandedLdl *ldl, int32_t size, int32_t width);
void tinker_banded_ldl_clear(TinkerBandedLdl *ldl);

/* All entries 0, to assemble anew. */
void tinker_banded_ldl_reset(TinkerBandedLdl *ldl);

/* Factors what was assembled, in place. FALSE where a pivot is 0 or not finite. */
gboolean tinker_banded_ldl_factor(TinkerBandedLdl *ldl);

/* Solves in place. */
void tinker_banded_ldl_solve(const TinkerBandedLdl *ldl, double *b);

#endif
