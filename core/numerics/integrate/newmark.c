/* Newmark's method of average acceleration, beta = 1/4, gamma = 1/2: the trapezoidal rule for second-order systems. */
#include <glib.h>

#include "numerics/integrate/newmark-family.h"
#include "numerics/integrate/stepping.h"

static const TinkerNewmarkWeights weights = {.beta = 0.25, .gamma = 0.5};

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return tinker_newmark_create(&weights, NULL, system);
}

const TinkerIntegrator tinker_integrator_newmark = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_IMPLICIT,
    .id = "newmark",
    .title = "Newmark, average acceleration, order 2",
    .summary = "Stiff scenes at any step, without numerical damping: what moves faster than the step rings on.",
    .source = "N. M. Newmark, Journal of the Engineering Mechanics Division ASCE 85 (1959) 67-94",
    .order = 2,
    .dense_order = 2,
    .evaluations_per_step = 2,
    .imaginary_limit = -1.0,
    .real_limit = -1.0,
    .create = create,
    .destroy = tinker_newmark_destroy,
    .restart = tinker_newmark_restart,
    .step = tinker_newmark_step,
    .interpolate = tinker_newmark_interpolate,
};
