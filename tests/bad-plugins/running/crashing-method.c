/* A method whose step is a null pointer's. */
#include <stdlib.h>
#include <tinker/sdk.h>

static int32_t *volatile nowhere;
static char stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return &stepper;
}

static void destroy(void *own) {}

static void restart(void *own) {}

__attribute__((no_sanitize("undefined"))) static TinkerStatus step(void *own, TinkerState *state, double limit,
                                                                   TinkerStepReport *report)
{
    return *nowhere;
}

static TinkerStatus interpolate(void *own, double t, double *q, double *v, double *books)
{
    return TINKER_FAILED;
}

static const TinkerIntegrator integrators[] = {{
    .struct_size = sizeof(TinkerIntegrator),
    .id = "crashing-method",
    .title = "Crashes",
    .order = 1,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
}};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.example.crashing-method", "Exhibit", "1.0.0", "MIT", integrators)
