/* Surfaces, and what two of them make of each other. */
#include "physics/contact/surfaces.h"

#include <math.h>

/* Between two that do not say. */
#define USUAL_FRICTION    0.5
#define USUAL_RESTITUTION 0

TinkerSurface tinker_surface_of(const TinkerBlockBatch *batch, int32_t row, double otherwise)
{
    return (TinkerSurface){
        .static_friction = tinker_block_batch_meaning(batch, row, TINKER_MEANING_STATIC_FRICTION, 0, otherwise),
        .dynamic_friction = tinker_block_batch_meaning(batch, row, TINKER_MEANING_DYNAMIC_FRICTION, 0, otherwise),
        .restitution = tinker_block_batch_meaning(batch, row, TINKER_MEANING_RESTITUTION, 0, otherwise),
        .rolling = tinker_block_batch_meaning(batch, row, TINKER_MEANING_ROLLING_RESISTANCE, 0, otherwise),
    };
}

gboolean tinker_surface_is_given(const TinkerSurface *surface)
{
    return !isnan(surface->static_friction) || !isnan(surface->dynamic_friction) || !isnan(surface->restitution);
}

/* Equal ones to the last digit. */
static double mean_of(double a, double b)
{
    if (isnan(a) || a == b) return b;
    return isnan(b) ? a : sqrt(a) * sqrt(b);
}

static double either(double value, double otherwise)
{
    return isnan(value) ? otherwise : value;
}

TinkerSurface tinker_surface_between(const TinkerSurface *a, const TinkerSurface *b)
{
    const double fixed = mean_of(a->static_friction, b->static_friction),
                 sliding = mean_of(a->dynamic_friction, b->dynamic_friction);
    TinkerSurface both = {.restitution = either(fmax(a->restitution, b->restitution), USUAL_RESTITUTION),
                          .rolling = either(fmax(a->rolling, b->rolling), 0)};
    both.static_friction = either(fixed, isnan(sliding) ? USUAL_FRICTION : fmax(USUAL_FRICTION, sliding));
    both.dynamic_friction = fmin(either(sliding, USUAL_FRICTION), both.static_friction);
    return both;
}
