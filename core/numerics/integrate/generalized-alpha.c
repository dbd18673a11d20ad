/* The generalized-alpha method: of all methods of its family with order 2 and no limit of stability, those that damp
 * the slow motion least for a spectral radius r at infinite frequency,
 *
 *     mean_acceleration = (2 r - 1) / (r + 1),  mean_force = r / (r + 1),
 *     gamma = 1/2 - mean_acceleration + mean_force,  beta = (1 - mean_acceleration + mean_force)^2 / 4.
 */
#include <glib.h>

#include "numerics/integrate/newmark-family.h"
#include "numerics/integrate/stepping.h"

#define DEFAULT_RADIUS 0.8

static const char *const refused_radius = "generalized-alpha takes a spectral_radius from 0 to 1: 0.8 is usual";
static const char *const refused_with_rods = "generalized-alpha with spectral_radius 1 damps no error of the rods' "
                                             "forces, which then grows: choose at most 0.95";

static const char *refusal(const TinkerSystem *system, double radius)
{
    if (!(radius >= 0.0 && radius <= 1.0)) return refused_radius;
    return radius == 1.0 && tinker_is_constrained(system) ? refused_with_rods : NULL;
}

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    double radius = options->spectral_radius != 0.0 ? options->spectral_radius : DEFAULT_RADIUS;
    double mean_acceleration = (2.0 * radius - 1.0) / (radius + 1.0), mean_force = radius / (radius + 1.0);
    double shift = mean_force - mean_acceleration;
    TinkerNewmarkWeights weights = {mean_acceleration, mean_force, 0.25 * (1.0 + shift) * (1.0 + shift), 0.5 + shift};
    return tinker_newmark_create(&weights, refusal(system, radius), system);
}

const TinkerIntegrator tinker_integrator_generalized_alpha = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_IMPLICIT | TINKER_INTEGRATOR_DISSIPATES,
    .id = "generalized-alpha",
    .title = "Generalized-alpha, order 2",
    .summary = "Stiff scenes at any step: damps what moves faster than the step, by spectral_radius a step.",
    .source = "J. Chung, G. M. Hulbert, Journal of Applied Mechanics 60 (1993) 371-375",
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
