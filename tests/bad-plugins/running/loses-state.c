/* A method whose step loses the arrays of the state. */
#include <stdlib.h>
#include <tinker/sdk.h>

static char stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return &stepper;
}

static void destroy(void *own) {}

static void restart(void *own) {}

static TinkerStatus step(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    state->t = limit;
    state->q = NULL;
    return TINKER_OK;
}

static TinkerStatus interpolate(void *own, double t, double *q, double *v, double *books)
{
    return TINKER_FAILED;
}

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .id = "loses-state",
    .title = "Loses its state",
    .order = 1,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.example.loses-state", "Exhibit", "1.0.0", "MIT", integrators)
