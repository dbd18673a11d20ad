/* How rough surfaces are, and how they rebound: of one block, and between two that touch. */
#ifndef TINKER_CORE_SURFACES_H
#define TINKER_CORE_SURFACES_H

#include "scene/frame/batch.h"

/* Coefficients, and the arm (m) of the moment that resists rolling; of a block NAN: it has none of its own. */
typedef struct {
    double static_friction, dynamic_friction, restitution;
    double rolling;
} TinkerSurface;

/* Of the block in a row, `otherwise` where its class has no such property. */
TinkerSurface tinker_surface_of(const TinkerBlockBatch *batch, int32_t row, double otherwise);

/* Whether it has any value of its own. */
gboolean tinker_surface_is_given(const TinkerSurface *surface);

/* Between two: of friction the geometric mean, of rebounds and of rolling resistance the larger; the other's where one
 * has none; where neither has, 0.5, 0.5, 0 and 0. Dynamic friction is at most the static one. */
TinkerSurface tinker_surface_between(const TinkerSurface *a, const TinkerSurface *b);

#endif
