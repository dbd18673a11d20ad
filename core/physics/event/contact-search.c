/* The first event in a step: what must not fall below zero is worked out at a few nodes of the step, from dense output;
 * the polynomials through these values have all their roots found. */
#include <math.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-search-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

#define MOST_PARTS 256
/* What rises and falls within a small share of a step is looked at as closely as this many times. */
#define DEEPEST 12
/* Of a part of a step: between two nodes of either number. */
#define PLACE_BETWEEN 0.317
/* A step is cut into no more than 2 to the power of this many parts for that. */
#define MOST_HALVINGS 6

static TinkerStatus fill_values(TinkerContactRun *self, double from, double to)
{
    const double *nodes = self->nodes;
    double speed = self->run->system.speed;
    int32_t count = self->degree + 1;
    for (int32_t k = 0; k < count; k++) {
        double t = k == 0 ? from : k == count - 1 ? to : from + nodes[k] * (to - from), *v;
        TinkerStatus status = tinker_contact_search_look(self, t, &v);
        if (status != TINKER_OK) return status;
        tinker_contact_run_note_force_scales(self);
        for (guint i = 0; i < self->triggers->len; i++)
            self->values[i * (guint)count + (guint)k] =
                tinker_trigger_value(self, &g_array_index(self->triggers, TinkerTrigger, i));
        speed = fmax(speed, tinker_largest(self->model->coordinates, v));
    }
    for (guint i = 0; i < self->triggers->len; i++) {
        TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        trigger->level = tinker_trigger_level(self, trigger, speed);
    }
    return TINKER_OK;
}

/* The polynomial through the values at the nodes. Source: Berrut, Trefethen, "Barycentric Lagrange interpolation", SIAM
 * Review 46 (2004) 501-517, (5.4). */
static double interpolated(const TinkerContactRun *self, const double *values, double place)
{
    double sum = 0, weights = 0;
    for (int32_t k = 0; k <= self->degree; k++) {
        double weight =
            (k % 2 == 0 ? 1.0 : -1.0) * (k == 0 || k == self->degree ? 0.5 : 1.0) / (place - self->nodes[k]);
        sum += weight * values[k];
        weights += weight;
    }
    return sum / weights;
}

/* Whether the polynomials tell what is between the nodes: at a place that is none of them. What drives bodies that rest
 * may swing many times within a step that they themselves do not limit. */
static TinkerStatus check_between(TinkerContactRun *self, double from, double to, gboolean *resolved)
{
    double *v;
    *resolved = TRUE;
    TinkerStatus status = tinker_contact_search_look(self, from + PLACE_BETWEEN * (to - from), &v);
    for (guint i = 0; status == TINKER_OK && i < self->triggers->len; i++) {
        const double *values = self->values + i * (guint)(self->degree + 1);
        double least = values[0], most = values[0];
        for (int32_t k = 1; k <= self->degree; k++) {
            least = fmin(least, values[k]);
            most = fmax(most, values[k]);
        }
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        double value = tinker_trigger_value(self, trigger), noise = TINKER_MISSED_NOISE * fabs(trigger->level);
        double miss = fabs(value - interpolated(self, values, PLACE_BETWEEN));
        *resolved &= miss <= TINKER_RESOLVED * (most - least) + TINKER_NOTICED * fmax(fabs(least), fabs(most)) + noise;
    }
    return status;
}

/* Whether a force that is nothing at first and has risen by the first node falls before that: as of one that grows with
 * the second power of time, the polynomial may do so by its own error. */
static gboolean dips_at_first(const TinkerContactRun *self, const TinkerTrigger *trigger, const double *values,
                              double place)
{
    const double most = tinker_largest(self->degree + 1, values);
    return !tinker_trigger_is_of_place(trigger) && place > 0 && place < self->nodes[1] && values[1] > trigger->level &&
           fabs(values[0]) <= TINKER_NOTHING * most;
}

static TinkerStatus search_part(TinkerContactRun *self, double from, double to, int depth, TinkerTrigger *found,
                                double *time);

/* More closely: up to the middle, and where nothing is found there, behind it. */
static TinkerStatus search_in_two(TinkerContactRun *self, double from, double middle, double to, int depth,
                                  TinkerTrigger *found, double *time)
{
    TinkerStatus status = search_part(self, from, middle, depth - 1, found, time);
    if (status != TINKER_OK || found->kind != TINKER_TRIGGER_NONE) return status;
    return search_part(self, middle, to, depth - 1, found, time);
}

/* `depth`: how often it may look more closely at a part. A place that is below its level by rounding and comes back
 * from there, by so little that no closer look tells it from 0, is no event. */
static TinkerStatus search_part(TinkerContactRun *self, double from, double to, int depth, TinkerTrigger *found,
                                double *time)
{
    gboolean resolved = TRUE;
    TinkerStatus status = fill_values(self, from, to);
    if (status == TINKER_OK && depth > DEEPEST - MOST_HALVINGS) status = check_between(self, from, to, &resolved);
    if (status != TINKER_OK) return status;
    if (!resolved) return search_in_two(self, from, 0.5 * (from + to), to, depth, found, time);
    TinkerTrigger unclear = {.kind = TINKER_TRIGGER_NONE};
    for (guint i = 0; i < self->triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        const double *values = self->values + i * (guint)(self->degree + 1);
        double t = tinker_contact_search_first_fall(self, trigger, values, from, to, *time);
        if (depth > 0 && dips_at_first(self, trigger, values, (t - from) / (to - from))) t = NAN;
        if (isnan(t)) unclear = *trigger;
        if (!(t < *time)) continue;
        *time = t;
        *found = *trigger;
    }
    if (unclear.kind == TINKER_TRIGGER_NONE || *time == from) return TINKER_OK;
    if (depth == 0 && tinker_trigger_is_of_place(&unclear)) return TINKER_OK;
    *time = from;
    *found = unclear;
    if (depth == 0) return TINKER_OK;
    found->kind = TINKER_TRIGGER_NONE;
    *time = INFINITY;
    return search_in_two(self, from, from + self->nodes[1] * (to - from), to, depth, found, time);
}

/* The fastest swing of moving plates, and of what turns. */
static double highest_frequency(TinkerContactRun *self, double from, double to)
{
    const TinkerContacts *contacts = self->contacts;
    double highest = tinker_contact_run_fastest_turn(self);
    for (int32_t i = 0; contacts->moving_plates > 0 && i < contacts->plate_count; i++)
        if (contacts->plates[i].moving)
            highest = fmax(highest,
                           tinker_contact_run_swing(self, contacts->plates[i].point, &contacts->plates[i], from, to));
    return highest;
}

/* How fast the trigger falls there. */
static TinkerStatus find_slope(TinkerContactRun *self, const TinkerTrigger *trigger, double from, double to, double t,
                               double *slope)
{
    double near = 1e-4 * (to - from), at[2] = {fmax(t - near, from), fmin(t + near, to)}, value[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        TinkerStatus status = tinker_contact_search_value(self, at[k], trigger, &value[k]);
        if (status != TINKER_OK) return status;
    }
    *slope = (value[1] - value[0]) / (at[1] - at[0]);
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_search(TinkerContactRun *self, double from, double to, TinkerTrigger *found,
                                       double *time, double *slope)
{
    gboolean clear = FALSE;
    found->kind = TINKER_TRIGGER_NONE;
    *time = INFINITY;
    self->looked_time = NAN;
    self->closed_gap = NAN;
    TinkerStatus status = tinker_contact_run_list_triggers(self);
    if (status != TINKER_OK || self->triggers->len == 0) return status;
    status = tinker_contact_search_far_off(self, from, to, &clear);
    if (clear || status != TINKER_OK) return status;
    gboolean done = FALSE;
    status = tinker_contact_search_soon(self, from, to, found, time, &done);
    if (status != TINKER_OK) return status;
    if (done && found->kind == TINKER_TRIGGER_NONE) return TINKER_OK;
    if (done) return find_slope(self, found, from, to, *time, slope);
    double arc = highest_frequency(self, from, to) * (to - from);
    int parts = (int)CLAMP(ceil(arc / TINKER_LONGEST_ARC), 1, MOST_PARTS);
    for (int k = 0; k < parts && status == TINKER_OK && found->kind == TINKER_TRIGGER_NONE; k++) {
        double begin = from + k * (to - from) / parts, end = k == parts - 1 ? to : from + (k + 1) * (to - from) / parts;
        status = search_part(self, begin, end, DEEPEST, found, time);
    }
    if (status != TINKER_OK || found->kind == TINKER_TRIGGER_NONE) return status;
    return find_slope(self, found, from, to, *time, slope);
}
