/* An integrator, simple: v += h a, x += h v, with straight lines between. */
#include <stdlib.h>

#include "planted.h"

typedef struct {
    const TinkerSystem *system;
    double from, h, q[8], v[8], q1[8], v1[8], a[8], power[8];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    Stepper *stepper = system->size <= 8 && system->books <= 8 ? calloc(1, sizeof *stepper) : NULL;
    if (stepper != NULL) stepper->system = system;
    return stepper;
}

static void restart(void *stepper) {}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *s = data;
    s->from = state->t;
    s->h = limit - state->t;
#if defined(PLANT_timeless)
    const double when = 0;
#else
    const double when = state->t;
#endif
    const TinkerStatus status = s->system->acceleration(s->system->context, when, state->q, state->v, s->a, s->power);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < s->system->size; i++) {
        s->q[i] = state->q[i];
        s->v[i] = state->v[i];
        state->v[i] += s->h * s->a[i];
        state->q[i] += s->h * state->v[i];
    }
#if !defined(PLANT_unprojected)
    int32_t moved = 0;
    if (s->system->flags & TINKER_SYSTEM_CONSTRAINED &&
        s->system->project(s->system->context, limit, state->q, state->v, &moved) != TINKER_OK)
        return TINKER_FAILED;
#endif
    for (int32_t i = 0; i < s->system->size; i++) {
        s->q1[i] = state->q[i];
        s->v1[i] = state->v[i];
    }
    for (int32_t i = 0; i < s->system->books; i++)
        state->books[i] += s->h * s->power[i];
    state->t = limit;
#if defined(PLANT_overshoots)
    state->t += 1e-12 * s->h;
#endif
    report->t_from = s->from;
#if defined(PLANT_misreports)
    report->step = s->h / 2;
#else
    report->step = s->h;
#endif
    return TINKER_OK;
}

static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    const Stepper *s = data;
    const double part = (t - s->from) / s->h;
    for (int32_t i = 0; i < s->system->size; i++) {
        q[i] = (1 - part) * s->q[i] + part * s->q1[i];
        v[i] = (1 - part) * s->v[i] + part * s->v1[i];
#if defined(PLANT_dense)
        q[i] = s->q[i];
#endif
    }
    return TINKER_OK;
}

#if defined(PLANT_order)
#define ORDER 2
#else
#define ORDER 1
#endif
#if defined(PLANT_bold)
#define IMAGINARY_LIMIT 3
#define REAL_LIMIT      2
#elif defined(PLANT_endless)
#define IMAGINARY_LIMIT 2
#define REAL_LIMIT      (-1)
#elif defined(PLANT_timid)
#define IMAGINARY_LIMIT 2
#define REAL_LIMIT      0.5
#else
#define IMAGINARY_LIMIT 2
#define REAL_LIMIT      2
#endif
const TinkerIntegrator planted_integrators[] = {{.struct_size = sizeof(TinkerIntegrator),
                                                 .flags = TINKER_INTEGRATOR_EXPLICIT,
                                                 .id = "planted-simple",
                                                 .title = "Simple",
                                                 .summary = "The simplest",
                                                 .source = "L. Euler",
                                                 .order = ORDER,
                                                 .dense_order = 1,
                                                 .evaluations_per_step = 1,
                                                 .imaginary_limit = IMAGINARY_LIMIT,
                                                 .real_limit = REAL_LIMIT,
                                                 .create = create,
                                                 .destroy = free,
                                                 .restart = restart,
                                                 .step = step,
                                                 .interpolate = interpolate}};
