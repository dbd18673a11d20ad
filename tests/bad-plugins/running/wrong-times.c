/* Methods that move nothing, and do not keep to the times of a step, or do not say why there is none. */
#include <tinker/sdk.h>

static char stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return &stepper;
}

static void destroy(void *own) {}

static void restart(void *own) {}

static TinkerStatus end_at(TinkerState *state, double t, double reported, TinkerStepReport *report)
{
    report->t_from = state->t;
    report->step = reported;
    state->t = t;
    return TINKER_OK;
}

static TinkerStatus step_past(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    const double h = 2 * (limit - state->t);
    return end_at(state, state->t + h, h, report);
}

static TinkerStatus step_short(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    const double h = 0.5 * (limit - state->t);
    return end_at(state, state->t + h, h, report);
}

static TinkerStatus step_unlike(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    return end_at(state, limit, 0.5 * (limit - state->t), report);
}

static TinkerStatus step_nowhere(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    return end_at(state, state->t, limit - state->t, report);
}

static TinkerStatus step_never(void *own, TinkerState *state, double limit, TinkerStepReport *report)
{
    report->failure = NULL;
    return TINKER_FAILED;
}

static TinkerStatus interpolate(void *own, double t, double *q, double *v, double *books)
{
    return TINKER_OK;
}

#define METHOD(name, title_, flags_, step_)                                                                            \
    {                                                                                                                  \
        .struct_size = sizeof(TinkerIntegrator), .id = name, .title = title_, .order = 1, .flags = flags_,             \
        .create = create, .destroy = destroy, .restart = restart, .step = step_, .interpolate = interpolate            \
    }

static const TinkerIntegrator integrators[] = {
    METHOD("past-limit", "Steps past its limit", TINKER_INTEGRATOR_ADAPTIVE, step_past),
    METHOD("short-of-limit", "Takes a fixed step of another length", 0, step_short),
    METHOD("other-step", "Reports another step than it made", 0, step_unlike),
    METHOD("no-step", "Stays where it is", 0, step_nowhere),
    METHOD("no-reason", "Fails, and does not say why", 0, step_never),
};

TINKER_DEFINE_INTEGRATOR_PLUGIN("org.example.wrong-times", "Exhibit", "1.0.0", "MIT", integrators)
