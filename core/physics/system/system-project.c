/* Bringing states of a model in the plane onto its constraints and contacts. */
#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/model/state.h"
#include "physics/system/hold-energy.h"
#include "physics/system/system-private.h"

static TinkerStatus project_with_contacts(TinkerModelSystem *self, double t, double *q, double *v, int32_t *moved)
{
    TinkerModel *model = self->model;
    gboolean placed, turned = FALSE;
    double work;
    TinkerStatus status = tinker_contacts_project_positions(model->contacts, t, q, v, &placed, &work);
    if (status != TINKER_OK) return status;
    self->projection_work += work + tinker_contacts_correct_velocities(model->contacts, v, FALSE, &turned);
    if (model->constraints.rows > 0)
        self->position_error = fmax(self->position_error, tinker_constraints_worst_miss(model));
    *moved = placed || turned;
    return TINKER_OK;
}

TinkerStatus system_project(void *context, double t, double *q, double *v, int32_t *moved)
{
    TinkerModelSystem *self = context;
    TinkerModel *model = self->model;
    gboolean placed = FALSE, turned = FALSE;
    *moved = 0;
    if (tinker_contacts_act(model->contacts)) return project_with_contacts(self, t, q, v, moved);
    TinkerStatus status = TINKER_OK;
    if (system_is_held(self)) {
        status = tinker_constraints_project_positions(model, t, q, v, &placed);
        if (status != TINKER_OK) return status;
        self->projection_work +=
            model->constraints.work + tinker_constraints_correct_velocities(model, v, FALSE, &turned);
        self->position_error = fmax(self->position_error, tinker_constraints_worst_miss(model));
    }
    gboolean shifted = FALSE;
    if (self->holds_energy) status = tinker_model_system_hold_energy(self, t, q, v, &shifted);
    *moved = placed || turned || shifted;
    return status;
}

TinkerStatus system_constrain_step(void *context, double t_from, const double *q_from, double t, double h, double *q,
                                   double *v)
{
    TinkerModelSystem *self = context;
    if (tinker_contacts_act(self->model->contacts))
        return tinker_contacts_rattle(self->model->contacts, t_from, q_from, t, h, q, v);
    if (!system_is_held(self)) return TINKER_OK;
    return tinker_constraints_rattle(self->model, t_from, q_from, t, h, q, v);
}

static TinkerStatus project_velocity_with_contacts(TinkerModel *model, double t, const double *q, double *v,
                                                   gboolean homogeneous)
{
    gboolean moved;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, v);
    if (model->constraints.rows > 0) status = tinker_constraints_evaluate(model);
    if (status == TINKER_OK) tinker_contacts_correct_velocities(model->contacts, v, homogeneous, &moved);
    return status;
}

TinkerStatus system_project_velocity(void *context, double t, const double *q, double *v, int32_t homogeneous)
{
    TinkerModelSystem *self = context;
    gboolean moved;
    if (tinker_contacts_act(self->model->contacts))
        return project_velocity_with_contacts(self->model, t, q, v, homogeneous != 0);
    if (!system_is_held(self)) return TINKER_OK;
    return tinker_constraints_project_velocities(self->model, t, q, v, homogeneous != 0, &moved);
}
