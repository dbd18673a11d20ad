/* The calls of a method, which may be a plugin's: a crash within is told with its name (plugin/call.h). */
#ifndef TINKER_CORE_METHOD_CALL_H
#define TINKER_CORE_METHOD_CALL_H

#include "plugin/call/call.h"

/* As the functions of TinkerIntegrator say. */
static inline void *tinker_method_create(const TinkerIntegrator *method, const TinkerSystem *system,
                                         const TinkerIntegratorOptions *options)
{
    void *stepper;
    TINKER_CALL_VOID(stepper = method->create(system, options), .phase = "create", .method = method);
    return stepper;
}

static inline void tinker_method_destroy(const TinkerIntegrator *method, void *stepper)
{
    TINKER_CALL_VOID(method->destroy(stepper), .phase = "destroy", .method = method);
}

static inline void tinker_method_restart(const TinkerIntegrator *method, void *stepper)
{
    TINKER_CALL_VOID(method->restart(stepper), .phase = "restart", .method = method);
}

/* Why a step failed that changed where the arrays of the state are. */
extern const char *const tinker_method_swapped_state;

/* Whether a method remembers its steps: an implicit one of variable step. From a start without memory it makes many
 * small steps of low order, and what it projects while it solves for a step is part of its formula. */
static inline gboolean tinker_method_remembers(const TinkerIntegrator *method)
{
    const uint32_t multistep = TINKER_INTEGRATOR_ADAPTIVE | TINKER_INTEGRATOR_IMPLICIT;
    return (method->flags & multistep) == multistep;
}

/* Exact, of a linear island; of steps of its own length; of a fixed step. One of the three. */
static inline gboolean tinker_method_is_exact(const TinkerIntegrator *method)
{
    return (method->flags & TINKER_INTEGRATOR_LINEAR) != 0;
}

static inline gboolean tinker_method_is_adaptive(const TinkerIntegrator *method)
{
    return (method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
}

static inline gboolean tinker_method_is_fixed(const TinkerIntegrator *method)
{
    return !tinker_method_is_exact(method) && !tinker_method_is_adaptive(method);
}

/* The flag of a method whose steps solve contact themselves, as impulses. It needs the model, which methods of plugins
 * do not see, so that theirs have no such flag. */
#define TINKER_METHOD_SOLVES_CONTACT (1u << 31)

static inline gboolean tinker_method_solves_contact(const TinkerIntegrator *method)
{
    return (method->flags & TINKER_METHOD_SOLVES_CONTACT) != 0;
}

/* Whether stability limits its steps at all: it is explicit and takes a step. */
static inline gboolean tinker_method_is_fixed_explicit(const TinkerIntegrator *method)
{
    return (method->flags & TINKER_INTEGRATOR_EXPLICIT) != 0 && !tinker_method_is_adaptive(method);
}

static inline TinkerStatus tinker_method_step(const TinkerIntegrator *method, void *stepper, TinkerState *state,
                                              double limit, TinkerStepReport *report)
{
    const TinkerState given = *state;
    const TinkerStatus status =
        TINKER_CALL(method->step(stepper, state, limit, report), .phase = "step", .method = method);
    if (state->q == given.q && state->v == given.v && state->books == given.books) return status;
    state->q = given.q;
    state->v = given.v;
    state->books = given.books;
    report->failure = tinker_method_swapped_state;
    return TINKER_FAILED;
}

static inline TinkerStatus tinker_method_interpolate(const TinkerIntegrator *method, void *stepper, double t, double *q,
                                                     double *v, double *books)
{
    return TINKER_CALL(method->interpolate(stepper, t, q, v, books), .phase = "interpolate", .method = method);
}

#endif
