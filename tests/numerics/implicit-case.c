#include "implicit-case.h"

#include <glib.h>

const TinkerIntegrator *implicit_newmark(void)
{
    return tinker_integrator_builtin("newmark");
}

const TinkerIntegrator *implicit_alpha(void)
{
    return tinker_integrator_builtin("generalized-alpha");
}

void *implicit_create(const TinkerIntegrator *method, const TinkerSystem *system, double radius)
{
    TinkerIntegratorOptions options = {.struct_size = sizeof options, .spectral_radius = radius};
    return method->create(system, &options);
}

void implicit_step_equally(const TinkerIntegrator *method, void *stepper, TinkerState *state, double h, int steps)
{
    TinkerStepReport report = {.struct_size = sizeof report};
    for (int i = 0; i < steps; i++)
        g_assert_cmpint(method->step(stepper, state, state->t + h, &report), ==, TINKER_OK);
}
