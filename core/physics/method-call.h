/* The calls of a method, which may be a plugin's: a crash within is told with its name (plugin/call.h). */
#ifndef TINKER_CORE_METHOD_CALL_H
#define TINKER_CORE_METHOD_CALL_H

#include "plugin/call.h"

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

static inline TinkerStatus tinker_method_step(const TinkerIntegrator *method, void *stepper, TinkerState *state,
                                              double limit, TinkerStepReport *report)
{
    return TINKER_CALL(method->step(stepper, state, limit, report), .phase = "step", .method = method);
}

static inline TinkerStatus tinker_method_interpolate(const TinkerIntegrator *method, void *stepper, double t, double *q,
                                                     double *v, double *books)
{
    return TINKER_CALL(method->interpolate(stepper, t, q, v, books), .phase = "interpolate", .method = method);
}

#endif
