/* Rows of two ends that hang together in chains, one after the other: rods end to end, the most common mechanism there
 * is. Every body of a chain carries one row or two, so S = J M^-1 J^T is tridiagonal along it, and its assembly, its
 * factorisation and the first half of the solve are one pass over the rows; the second half and the impulses on the
 * bodies are another.
 *
 * A chain is eliminated from both ends at once towards its middle: two runs of divisions that do not wait for each
 * other. */
#ifndef TINKER_CORE_ROW_CHAINS_H
#define TINKER_CORE_ROW_CHAINS_H

#include "physics/model/model-data.h"

/* The chains of a model's rows; NULL where some rows do not hang together so. (transfer full) */
TinkerRowChains *tinker_row_chains_new(const TinkerModel *model);
void tinker_row_chains_free(TinkerRowChains *chains);

/* What a solve is for: S x = sign * (J u + extra), with u two entries a point, `stride` apart. `extra` has one entry a
 * row; NULL: none. `u` NULL: S x = sign * extra. */
typedef struct {
    const double *u;
    int32_t stride;
    const double *extra;
    double sign;
} TinkerRowDemand;

/* Factors S of this Jacobian and solves for a demand, up to the last pass. FALSE where some pivot falls to `threshold`
 * of its diagonal entry: the factor is then of no use. */
gboolean tinker_row_chains_factor(TinkerRowChains *chains, const double *jacobian, double threshold,
                                  const TinkerRowDemand *demand);
/* Solves for a demand with the factor at hand. */
void tinker_row_chains_substitute(TinkerRowChains *chains, const double *jacobian, const TinkerRowDemand *demand);
/* The last pass: x, of one entry a row, and target += M^-1 J^T x, or where `fresh` the bodies of the chains get that
 * alone; `target` NULL: x alone. */
void tinker_row_chains_finish(TinkerRowChains *chains, const double *jacobian, double *x, double *target,
                              gboolean fresh);

#endif
