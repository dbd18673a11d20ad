/* What a system without constraints answers when a method asks it about them: for those who try a method on a system of
 * their own, such as the test of an integrator. The functions fit the members of TinkerSystem that have their names. */
#ifndef TINKER_UNCONSTRAINED_H
#define TINKER_UNCONSTRAINED_H

#include <stddef.h>

#include "integrator.h"

#ifdef __cplusplus
extern "C" {
#endif

static inline TinkerStatus tinker_unconstrained_project(void *context, double t, double *q, double *v, int32_t *moved)
{
    (void)context, (void)t, (void)q, (void)v;
    *moved = 0;
    return TINKER_OK;
}

static inline TinkerStatus tinker_unconstrained_constrain_step(void *context, double t_from, const double *q_from,
                                                               double t, double h, double *q, double *v)
{
    (void)context, (void)t_from, (void)q_from, (void)t, (void)h, (void)q, (void)v;
    return TINKER_OK;
}

static inline TinkerStatus tinker_unconstrained_project_velocity(void *context, double t, const double *q, double *v,
                                                                 int32_t homogeneous)
{
    (void)context, (void)t, (void)q, (void)v, (void)homogeneous;
    return TINKER_OK;
}

/* Nothing has failed. */
static inline const char *tinker_unconstrained_failure(void *context)
{
    (void)context;
    return NULL;
}

#ifdef __cplusplus
}
#endif

#endif
