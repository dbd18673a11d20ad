/* With E = v M v / 2 + V(q) and a the acceleration by the applied forces on the tangent space, grad V = -M a there. A
 * step of
 *
 *   v <- v + mu v,   q <- q - mu a / w^2,   w = speed / extent
 *
 * changes E by mu (v M v + a M a / w^2) in first order. The energy that a step of the method loses is so small that
 * what is left after one such step is rounding. */
#include "physics/system/hold-energy.h"

#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/system.h"
#include "physics/system/tolerances.h"

gboolean tinker_model_keeps_energy(const TinkerModel *model)
{
    for (int book = 0; book < TINKER_BOOK_COUNT; book++)
        if (model->has_book[book]) return FALSE;
    gboolean touches = model->contacts != NULL && model->contacts->plate_count + model->contacts->gap_count > 0;
    return !touches && model->constraints.unilateral == NULL && model->waveform_batches->len == 0;
}

void tinker_model_system_start_holding(TinkerModelSystem *self, const TinkerEnergy *energy)
{
    self->holds_energy = TRUE;
    self->energy = energy->kinetic + energy->potential;
    self->system.flags |= TINKER_SYSTEM_CONSTRAINED; /* or nobody would project */
}

/* Leaves the direction of places in self->constrained; answers v M v + a M a / w^2. */
static double squared_direction(TinkerModelSystem *self, const double *v, double slowness)
{
    const double *a = self->constrained, *mass = self->model->coordinate_mass;
    double sum = 0;
    for (int32_t i = 0; i < self->model->coordinates; i++)
        sum += mass[i] * (v[i] * v[i] + slowness * a[i] * a[i]);
    return sum;
}

static TinkerStatus find_tangent_acceleration(TinkerModelSystem *self, double t, const double *q)
{
    gboolean turned;
    TinkerModel *model = self->model;
    gint64 evaluations = model->evaluations;
    TinkerStatus status = tinker_model_applied(model, self->constrained, FALSE);
    if (status == TINKER_OK && model->constraints.rows > 0)
        status = tinker_constraints_project_velocities(model, t, q, self->constrained, TRUE, &turned);
    model->evaluations = evaluations;
    return status;
}

static TinkerStatus return_to_constraints(TinkerModel *model, double t, double *q, double *v)
{
    gboolean moved;
    if (model->constraints.rows == 0) return TINKER_OK;
    TinkerStatus status = tinker_constraints_project_positions(model, t, q, v, &moved);
    if (status == TINKER_OK) tinker_constraints_correct_velocities(model, v, FALSE, &moved);
    return status;
}

TinkerStatus tinker_model_system_hold_energy(TinkerModelSystem *self, double t, double *q, double *v, gboolean *moved)
{
    TinkerModel *model = self->model;
    TinkerEnergy now;
    double extent, speed;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, v);
    status = tinker_model_energy(model, &now);
    if (status == TINKER_OK) status = find_tangent_acceleration(self, t, q);
    if (status != TINKER_OK) return status;
    self->system.scales(self, q, v, &extent, &speed);
    double slowness = speed > 0 ? extent / speed * (extent / speed) : 0; /* 1 / w^2 */
    double missing = self->energy - now.kinetic - now.potential,
           change = missing / squared_direction(self, v, slowness);
    if (missing == 0 || !(fabs(change) < TINKER_MOST_HELD_CHANGE)) return TINKER_OK;
    for (int32_t i = 0; i < model->coordinates; i++) {
        v[i] += change * v[i];
        q[i] -= change * slowness * self->constrained[i];
    }
    self->projection_work += missing;
    *moved = TRUE;
    return return_to_constraints(model, t, q, v);
}
