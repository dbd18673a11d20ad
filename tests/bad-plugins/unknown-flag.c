/* A method with a flag that no version of the contract has. */
#include "exhibit.h"

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return NULL;
}

static void destroy(void *stepper) {}

static void restart(void *stepper) {}

static TinkerStatus step(void *stepper, TinkerState *state, double limit, TinkerStepReport *report)
{
    return TINKER_FAILED;
}

static TinkerStatus interpolate(void *stepper, double t, double *q, double *v, double *books)
{
    return TINKER_FAILED;
}

static const TinkerIntegrator methods[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT | 1u << 31,
    .id = "exhibit",
    .title = "Exhibit",
    .summary = "Stands in a museum.",
    .source = "Nobody",
    .order = 1,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

static const TinkerPlugin plugin = {
    TINKER_PLUGIN_HEAD,
    EXHIBIT_TEXTS,
    .integrators = TINKER_SPAN(methods),
};

EXHIBIT_ENTRY(plugin)
