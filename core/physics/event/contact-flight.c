/* Flights of an island that is solved exactly while nothing is closed. Two things would let rounding grow from blow to
 * blow:
 *
 * 1. The instant of a blow is a number, and the blow falls up to half of its last digit beside it: at 1e5 s that is
 * 7e-12 s, in which a body goes much farther than places are rounded. So the state is taken on to the blow itself,
 * where what touches changes its speed, and back to the instant by the motion after it; within so short a time
 * acceleration is constant.
 * 2. A speed that is rounded at every blow walks at random, and with it the length of all later flights: the error of n
 * flights is that of n^(3/2) roundings. But of one body that nothing drives or brakes the energy along the plate's
 * normal is a first integral of the flight, so that it comes back to the plate with the speed along it that it left
 * with. */
#include <float.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

/* Whether what one plate does cannot change the energy along the normal of another. */
static gboolean leaves_energy_along(const TinkerContacts *contacts, const TinkerTrigger *trigger, int32_t plate)
{
    const TinkerSurface struck = tinker_contact_surface(contacts, trigger->body, trigger->plate);
    const double *n = contacts->plates[trigger->plate].normal, *m = contacts->plates[plate].normal;
    if (fabs(n[0] * m[0] + n[1] * m[1]) <= TINKER_NO_ANGLE) return struck.dynamic_friction == 0;
    return fabs(n[0] * m[1] - n[1] * m[0]) <= TINKER_NO_ANGLE && struck.restitution == 1;
}

static gboolean keeps_energy(const TinkerModel *model)
{
    return model->bodies == 1 && !model->lines.any_damping && model->field_drag == 0 && model->driven->len == 0 &&
           model->moving_supports == 0;
}

void tinker_contact_flight_init(TinkerContactFlight *flight, const TinkerContactRun *self, gboolean exact)
{
    const TinkerContacts *contacts = self->contacts;
    *flight = (TinkerContactFlight){.exact = exact};
    if (!exact || !keeps_energy(self->model) || contacts->plate_count == 0) return;
    flight->rebound = g_new(double, contacts->plate_count);
    for (int32_t i = 0; i < contacts->plate_count; i++)
        flight->rebound[i] = NAN;
}

void tinker_contact_flight_clear(TinkerContactFlight *flight)
{
    g_clear_pointer(&flight->rebound, g_free);
}

gboolean tinker_contact_flight_is_free(TinkerContactRun *self)
{
    TinkerIslandRun *run = self->run;
    double extent, speed;
    if (!self->flight.exact || self->contacts->closed->len > 0 || self->leaving->len > 0) return FALSE;
    run->system.system.scales(&run->system, run->q, run->v, &extent, &speed);
    self->flight.exact = tinker_linear_form_holds(run->island->linear, run->q, run->v, extent, speed);
    return self->flight.exact;
}

/* Moves the bodies with their present acceleration for `time` (s), which may be negative. */
static TinkerStatus fall_for(TinkerContactRun *self, double time)
{
    TinkerIslandRun *run = self->run;
    TinkerSystem *system = &run->system.system;
    TinkerState *state = &run->state;
    TinkerStatus status = system->acceleration(system->context, state->t, state->q, state->v, self->force, NULL);
    for (int32_t i = 0; status == TINKER_OK && i < system->size; i++) {
        state->q[i] += time * (state->v[i] + 0.5 * time * self->force[i]);
        state->v[i] += time * self->force[i];
    }
    return status;
}

static TinkerStatus measure(const TinkerContactRun *self, const TinkerTrigger *trigger, TinkerContactPlace *place)
{
    const TinkerState *state = &self->run->state;
    TinkerStatus status = tinker_model_set_time(self->model, state->t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(self->model, state->q, state->v);
    *place = tinker_contact_place(self->contacts, trigger->body, trigger->plate);
    return TINKER_OK;
}

TinkerStatus tinker_contact_flight_meet(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    TinkerContactFlight *flight = &self->flight;
    TinkerContactPlace place;
    flight->ahead = 0;
    flight->approach = NAN;
    if (!flight->exact || self->contacts->closed->len > 0 || trigger->kind != TINKER_TRIGGER_GAP || trigger->row >= 0 ||
        self->contacts->plates[trigger->plate].moving || trigger->plate >= self->contacts->plate_count)
        return TINKER_OK;
    TinkerStatus status = measure(self, trigger, &place);
    double ahead = -place.gap / place.normal_speed;
    if (status != TINKER_OK || !(place.normal_speed < 0) || fabs(ahead) > TINKER_BLOW_INSTANT * self->run->state.t)
        return status;
    status = fall_for(self, ahead);
    if (status == TINKER_OK) status = measure(self, trigger, &place);
    if (status != TINKER_OK) return status;
    flight->ahead = ahead;
    flight->approach = -place.normal_speed;
    if (flight->rebound == NULL) return TINKER_OK;
    double left = flight->rebound[trigger->plate];
    if (fabs(left - flight->approach) <= TINKER_SAME_SPEED * left) flight->approach = left;
    return TINKER_OK;
}

/* After the blow the speed along the normal is what restitution makes of the approach, to the last digit; the other
 * plates' blows are forgotten where this one changed what they left. */
static void note_rebound(TinkerContactRun *self, const TinkerTrigger *trigger, const TinkerContactPlace *place)
{
    TinkerContactFlight *flight = &self->flight;
    const TinkerPlate *plate = &self->contacts->plates[trigger->plate];
    const double e = tinker_contact_surface(self->contacts, trigger->body, trigger->plate).restitution;
    double rebound = e * flight->approach, *v = self->run->state.v + 2 * trigger->body;
    gboolean same = fabs(rebound - place->normal_speed) <= TINKER_SAME_SPEED * rebound;
    if (same)
        for (int k = 0; k < 2; k++)
            v[k] += (rebound - place->normal_speed) * plate->normal[k];
    if (flight->rebound == NULL) return;
    flight->rebound[trigger->plate] = same ? rebound : NAN;
    for (int32_t i = 0; i < self->contacts->plate_count; i++)
        if (i != trigger->plate && !leaves_energy_along(self->contacts, trigger, i)) flight->rebound[i] = NAN;
}

TinkerStatus tinker_contact_flight_part(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    TinkerContactFlight *flight = &self->flight;
    TinkerContactPlace place;
    if (isnan(flight->approach) || self->contacts->closed->len > 0 || self->leaving->len > 0) return TINKER_OK;
    TinkerStatus status = measure(self, trigger, &place);
    if (status != TINKER_OK) return status;
    note_rebound(self, trigger, &place);
    return fall_for(self, -flight->ahead);
}
