/* How near and how slow is nothing: what rounding and the method make of 0, for contacts. */
#include <float.h>
#include <math.h>

#include "numerics/solve/largest.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"

double tinker_contact_run_speed_noise(const TinkerContactRun *self)
{
    const TinkerIslandRun *run = self->run;
    gboolean adaptive = tinker_method_is_adaptive(run->choice.method);
    return adaptive ? fmax(TINKER_SPEED_ROUNDING, 0.1 * run->choice.tolerance) : TINKER_SPEED_ROUNDING_OF_STEPS;
}

double tinker_contact_run_unclear_speed(const TinkerContactRun *self)
{
    double extent, speed;
    const TinkerIslandRun *run = self->run;
    run->system.system.scales(run->system.system.context, run->state.q, run->state.v, &extent, &speed);
    return fmax(TINKER_UNCLEAR_SPEED, TINKER_UNCLEAR_NOISES * tinker_contact_run_speed_noise(self)) *
           fmax(speed, self->contacts->plate_speed);
}

double tinker_contact_run_place_noise(const TinkerContactRun *self)
{
    double extent, speed;
    const TinkerIslandRun *run = self->run;
    if (!self->remembers) return 0;
    run->system.system.scales(run->system.system.context, run->state.q, run->state.v, &extent, &speed);
    return run->choice.tolerance * extent;
}

/* Rounding of places, and of the instant of an event at the speed of what moves. */
double tinker_contact_run_closed_gap(const TinkerContactRun *self)
{
    double extent, speed;
    TinkerIslandRun *run = self->run;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    double size = extent + tinker_largest(run->system.system.size, run->state.q) + self->contacts->thickness;
    return TINKER_CLOSED_GAP * size + TINKER_INSTANT * fabs(run->state.t) * fmax(speed, self->contacts->plate_speed);
}

double tinker_contact_run_touching(const TinkerContactRun *self)
{
    return fmax(TINKER_TOUCHING, tinker_contact_run_closed_gap(self));
}

gboolean tinker_contact_run_is_before(const TinkerContactRun *self, const TinkerTrigger *gap, double value,
                                      double closed)
{
    const gboolean shapes = gap->row < 0 && self->contacts->plates[gap->plate].gap != NULL;
    return value >= -(shapes ? fmax(TINKER_TOUCHING, closed) : closed);
}

gboolean tinker_contact_run_is_across(const TinkerContactRun *self, int32_t body, int32_t plate)
{
    const TinkerContacts *contacts = self->contacts;
    const TinkerGapFunction *gap = contacts->plates[plate].gap;
    if (gap == NULL || gap->reverse == 0) return FALSE;
    const TinkerContactPair facing = {body, plate + gap->reverse, -1};
    for (guint i = 0; i < self->struck->len; i++)
        if (g_array_index(self->struck, int32_t, i) == facing.plate) return TRUE;
    for (guint i = 0; i < contacts->closed->len; i++)
        if (tinker_contacts_closed(contacts, i)->plate == facing.plate) return TRUE;
    return tinker_contact_run_leaves(self, &facing);
}

gboolean tinker_contact_run_leaves(const TinkerContactRun *self, const TinkerContactPair *sought)
{
    for (guint i = 0; i < self->leaving->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->leaving, TinkerContactPair, i);
        if (pair->body == sought->body && pair->plate == sought->plate && pair->row == sought->row) return TRUE;
    }
    return FALSE;
}
