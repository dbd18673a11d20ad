/* Whether, and when, the value of one trigger falls below 0 in a part of a step. */
#include <float.h>
#include <math.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-search-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

#define MOST_FALLS 8

gboolean tinker_trigger_is_of_place(const TinkerTrigger *trigger)
{
    switch (trigger->kind) {
    case TINKER_TRIGGER_GAP:
    case TINKER_TRIGGER_SPEED:
    case TINKER_TRIGGER_END:
    case TINKER_TRIGGER_BEGINNING:
        return trigger->row < 0;
    default:
        return FALSE;
    }
}

TinkerStatus tinker_contact_search_look(TinkerContactRun *self, double t, double **v)
{
    double *q;
    if (tinker_contact_run_has_looked(self, t)) return tinker_contact_run_place_at(self, t, v);
    TinkerStatus status = tinker_contact_run_state_at(self, t, &q, v);
    return status == TINKER_OK ? tinker_contact_run_look_at(self, t, q, *v, NULL) : status;
}

TinkerStatus tinker_contact_search_ask(TinkerContactRun *self, double t, double **v)
{
    return tinker_contact_run_recall_start(self, t) ? tinker_contact_run_place_at(self, t, v)
                                                    : tinker_contact_search_look(self, t, v);
}

TinkerStatus tinker_contact_search_value(TinkerContactRun *self, double t, const TinkerTrigger *trigger, double *value)
{
    double *v;
    TinkerStatus status = tinker_trigger_is_of_place(trigger) ? tinker_contact_run_place_at(self, t, &v)
                                                              : tinker_contact_search_ask(self, t, &v);
    if (status == TINKER_OK) *value = tinker_trigger_value(self, trigger);
    return status;
}

/* Whether a body whose gap falls through 0 at t meets the top there, and not the space beside it. */
static gboolean meets(TinkerContactRun *self, const TinkerTrigger *trigger, double t)
{
    double *q, *v;
    if (trigger->kind != TINKER_TRIGGER_GAP || trigger->row >= 0) return TRUE;
    if (tinker_contact_run_state_at(self, t, &q, &v) != TINKER_OK || tinker_model_set_time(self->model, t) != TINKER_OK)
        return FALSE;
    tinker_model_set_state(self->model, q, v);
    TinkerContactPlace place = tinker_contact_place(self->contacts, trigger->body, trigger->plate);
    return tinker_contact_is_over(self->contacts, trigger->plate, &place, tinker_trigger_place_rounding(self, trigger));
}

/* Whether it has fallen by the first node, from a value that is nothing beside what follows. */
static gboolean falls_soon(TinkerContactRun *self, const TinkerTrigger *trigger, const double *values)
{
    const double most = tinker_largest(self->degree + 1, values);
    if (!(values[1] < trigger->level) || values[0] > TINKER_NOTHING * most) return FALSE;
    if (trigger->kind != TINKER_TRIGGER_GAP) return TRUE;
    if (isnan(self->closed_gap)) self->closed_gap = tinker_contact_run_closed_gap(self);
    return tinker_contact_run_is_before(self, trigger, values[0], self->closed_gap);
}

/* How fast what is left of a top grows, towards the end that the trigger is of; where that is nothing, whether it is to
 * grow. What rolls moves along without slipping, too. */
static double rate_from_end(TinkerContactRun *self, const TinkerTrigger *trigger, double from)
{
    const TinkerContactPlace place = tinker_contact_place(self->contacts, trigger->body, trigger->plate);
    const double sign = trigger->kind == TINKER_TRIGGER_END ? -1 : 1, rate = sign * place.along_speed;
    const TinkerPlate *plate = &self->contacts->plates[trigger->plate];
    double along[2], *v;
    if (fabs(rate) > TINKER_STILL * self->run->system.speed || plate->gap == NULL || plate->gap->rolls) return rate;
    if (tinker_contact_search_ask(self, from, &v) != TINKER_OK) return rate;
    tinker_contacts_relative_acceleration(
        self->contacts, tinker_contacts_closed(self->contacts, (guint)trigger->closed), self->force, along);
    return sign * along[1];
}

/* Whether it rises first, by less than the polynomial resolves. Of what has a rate of its own that says it: a
 * difference of values may be rounding. */
static gboolean rises_first(TinkerContactRun *self, const TinkerTrigger *trigger, double from, double to)
{
    double at_first, soon;
    if (tinker_contact_search_value(self, from, trigger, &at_first) != TINKER_OK) return FALSE;
    if (trigger->kind == TINKER_TRIGGER_GAP && trigger->row >= 0)
        return tinker_constraints_own_rate(self->model, trigger->row) < 0;
    if (trigger->kind == TINKER_TRIGGER_END || trigger->kind == TINKER_TRIGGER_BEGINNING)
        return rate_from_end(self, trigger, from) > 0;
    if (trigger->kind == TINKER_TRIGGER_GAP)
        return tinker_contact_place(self->contacts, trigger->body, trigger->plate).normal_speed > 0;
    if (trigger->kind == TINKER_TRIGGER_SPEED) {
        double *v;
        const TinkerTrigger starting = {TINKER_TRIGGER_STARTING, trigger->body, trigger->plate, trigger->closed, -1, 0};
        return tinker_contact_search_ask(self, from, &v) == TINKER_OK && tinker_trigger_value(self, &starting) > 0;
    }
    return tinker_contact_search_value(self, from + TINKER_FALLS_AT_ONCE * (to - from), trigger, &soon) == TINKER_OK &&
           soon > at_first;
}

/* Whether a place or a speed comes up from clearly below its level, as that of a contact that was taken for one that
 * stops behind a blow and then slides the other way: what a closer look would find is the same rise. One that turns
 * back below the level, or starts at 0 but for rounding, has to be looked at. A force below its level is an event. */
static gboolean comes_up(const TinkerContactRun *self, const TinkerTrigger *trigger, const double *values)
{
    const double most = tinker_largest(self->degree + 1, values);
    if (!tinker_trigger_is_of_place(trigger) || !(values[0] < fmin(trigger->level, -TINKER_NOTHING * most)))
        return FALSE;
    for (int32_t k = 1; k <= self->degree && values[k - 1] <= trigger->level; k++)
        if (!(values[k] >= values[k - 1])) return FALSE;
    return TRUE;
}

double tinker_contact_search_first_fall(TinkerContactRun *self, const TinkerTrigger *trigger, const double *values,
                                        double from, double to, double known)
{
    double places[MOST_FALLS];
    if (tinker_step_least(self->degree, values) > trigger->level) return INFINITY;
    if (falls_soon(self, trigger, values) && meets(self, trigger, from)) {
        if (!rises_first(self, trigger, from, to)) return from;
        if (!comes_up(self, trigger, values)) return NAN;
    }
    if (known < to) { /* most that fall do so later than what was found first: that is sooner seen than when */
        const double rounding = 4 * DBL_EPSILON * (fabs(from) + fabs(to)),
                     place = (known - from + rounding) / (to - from);
        if (tinker_step_least_before(self->degree, values, fmin(place, 1)) > trigger->level) return INFINITY;
    }
    int32_t falls = tinker_step_falls(self->degree, values, trigger->level, places, MOST_FALLS);
    for (int32_t k = 0; k < falls; k++) {
        double t = from + places[k] * (to - from);
        if (!(t < known)) break;
        if (meets(self, trigger, t)) return t;
    }
    return INFINITY;
}
