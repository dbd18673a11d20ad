/* Implicit steps of a linear system whose matrices have a narrow band: one product, one solve, nothing looked up. */
#ifndef TINKER_NUMERICS_LINEAR_BAND_H
#define TINKER_NUMERICS_LINEAR_BAND_H

#include <glib.h>

#include "numerics/integrate/newmark-family.h"

typedef struct _TinkerLinearBand TinkerLinearBand;

/* NULL where the system is not linear or its band is not narrow. The system is borrowed. (transfer full) */
TinkerLinearBand *tinker_linear_band_new(const TinkerSystem *system);
void tinker_linear_band_free(TinkerLinearBand *band);

/* Takes over the signals of the piece, and on which side of each other the ends of edges are. */
TinkerStatus tinker_linear_band_enter(TinkerLinearBand *band, double t, const double *q);

/* Factors the matrix of steps of this length: see newmark-family.h. FALSE where a pivot vanishes. */
gboolean tinker_linear_band_factor(TinkerLinearBand *band, const TinkerNewmarkWeights *weights, double h);

/* A step's start: state, the method's own acceleration and that by the forces. */
typedef struct {
    const double *q, *v, *a, *behind;
} TinkerBandStart;

/* Finds the acceleration x and the end (q, v) at time t of a step that the matrix was factored for. Where the ends of
 * an edge pass through one another the step is worked out anew with the force turned round. */
void tinker_linear_band_step(TinkerLinearBand *band, const TinkerNewmarkWeights *weights, double h, double t,
                             const TinkerBandStart *start, double *x, double *q, double *v);

#endif
