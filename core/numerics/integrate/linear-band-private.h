/* What a linear band consists of. The matrices are kept by diagonals, in the order of the band; with a margin of zeros
 * at both ends, products need no bounds. */
#ifndef TINKER_NUMERICS_LINEAR_BAND_PRIVATE_H
#define TINKER_NUMERICS_LINEAR_BAND_PRIVATE_H

#include "numerics/integrate/linear-band.h"
#include "numerics/integrate/signal.h"
#include "numerics/solve/banded-ldl.h"

/* An edge with a force that depends on which side its ends are, places in the order of the band; -1 - k for anchor k.
 */
typedef struct {
    int32_t a, b;
    double push; /* tension - stiffness * length */
    double sign; /* of d; 0: not known yet */
} TinkerTurningEdge;

struct _TinkerLinearBand {
    const TinkerSystem *system;
    const TinkerLinearSystem *linear;
    int32_t n, width;
    int32_t *place,
        *order; /* of each coordinate, and the coordinate at each place; order is NULL where they are the same */
    double *memory;
    double *mass;
    double *stiffness, *damping; /* width + 1 diagonals, `stride` apart; entry p of diagonal k: (p, p + k) */
    gsize stride;
    double *steady, *load;  /* constant forces, all forces of the time in hand */
    double *q, *v, *x, *at; /* predicted, with margins; found; the end in the order of the band */
    gboolean damped;
    TinkerBandedLdl ldl;
    TinkerTurningEdge *turning;
    int32_t turning_count;
    TinkerSignal *signals;
    double *anchor, *anchor_rate, *anchor_move; /* places now and their rates, what signals add */
};

#endif
