/* What the functions of a model as a system share. */
#ifndef TINKER_CORE_SYSTEM_PRIVATE_H
#define TINKER_CORE_SYSTEM_PRIVATE_H

#include "physics/model/model-data.h"
#include "physics/system/system.h"

static inline gboolean system_is_reduced(const TinkerModelSystem *self)
{
    return self->form != NULL && tinker_linear_form_is_reduced(self->form);
}

/* Whether the coordinates are held by constraints; those of shafts meet them as they are. */
static inline gboolean system_is_held(const TinkerModelSystem *self)
{
    return self->model->constraints.rows > 0 && !system_is_reduced(self);
}

/* What TinkerSystem asks of a model in the plane; `context` is the TinkerModelSystem. */

/* system-evaluate.c */
TinkerStatus system_acceleration(void *context, double t, const double *q, const double *v, double *a, double *power);
TinkerStatus system_applied(void *context, double t, const double *q, const double *v, double *a, double *power);

/* system-project.c */
TinkerStatus system_project(void *context, double t, double *q, double *v, int32_t *moved);
TinkerStatus system_constrain_step(void *context, double t_from, const double *q_from, double t, double h, double *q,
                                   double *v);
TinkerStatus system_project_velocity(void *context, double t, const double *q, double *v, int32_t homogeneous);

/* system-scales.c: of a state and of what was kept, and of the supports. */
void system_scales(void *context, const double *q, const double *v, double *extent, double *speed);

#endif
