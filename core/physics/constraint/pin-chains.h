/* Blocks whose two ends coincide and that hang together in chains, one after the other: bars pinned end to end. Every
 * body of a chain carries one such block or two, so S = J M^-1 J^T is tridiagonal along it in blocks of 2 x 2; as with
 * rods (row-chains.h) its assembly, its factorisation and the first half of the solve are one pass over the blocks, the
 * second half and the impulses on the bodies another. */
#ifndef TINKER_CORE_PIN_CHAINS_H
#define TINKER_CORE_PIN_CHAINS_H

#include "physics/constraint/row-chains.h"
#include "physics/model/model-data.h"

/* The chains of a model's rows; NULL where some rows do not hang together so. (transfer full) */
TinkerPinChains *tinker_pin_chains_new(const TinkerModel *model);
void tinker_pin_chains_free(TinkerPinChains *chains);

/* As their namesakes of row-chains.h have it. A demand's `u` are accelerations or velocities by coordinate, 2 apart for
 * points. `of_factor`: the Jacobian is to the bit the one that was factored. */
gboolean tinker_pin_chains_factor(TinkerPinChains *chains, const double *jacobian, double threshold,
                                  const TinkerRowDemand *demand);
void tinker_pin_chains_substitute(TinkerPinChains *chains, const double *jacobian, gboolean of_factor,
                                  const TinkerRowDemand *demand);
void tinker_pin_chains_finish(TinkerPinChains *chains, double *x, double *target, gboolean fresh);

#endif
