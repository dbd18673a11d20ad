/* The first event in a step: what must not fall below zero is worked out at a few nodes of the step, from dense output;
 * the polynomials through these values have all their roots found. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

#define MOST_PARTS 256
#define MOST_FALLS 8
/* What rises and falls within a small share of a step is looked at as closely as this many times. */
#define DEEPEST 12
/* Of a part of a step: between two nodes of either number. */
#define PLACE_BETWEEN 0.317
/* A step is cut into no more than 2 to the power of this many parts for that. */
#define MOST_HALVINGS 6

/* Whether the trigger's value follows from where the bodies are and how they move, without the forces on them. */
static gboolean is_of_place(const TinkerTrigger *trigger)
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

/* Brings the model to a time within the last step; *v gets the velocities of the bodies then. Where the forces of
 * contacts that were worked out last are those of that time they stand: every contact that has just begun to slip asks
 * for the step's start. */
static TinkerStatus look_at_time(TinkerContactRun *self, double t, double **v)
{
    double *q;
    if (tinker_contact_run_has_looked(self, t)) return tinker_contact_run_place_at(self, t, v);
    TinkerStatus status = tinker_contact_run_state_at(self, t, &q, v);
    return status == TINKER_OK ? tinker_contact_run_look_at(self, t, q, *v, NULL) : status;
}

/* As look_at_time, for what triggers alone ask for: that may be kept of the step's start. */
static TinkerStatus ask_at_time(TinkerContactRun *self, double t, double **v)
{
    return tinker_contact_run_recall_start(self, t) ? tinker_contact_run_place_at(self, t, v)
                                                    : look_at_time(self, t, v);
}

static TinkerStatus value_at(TinkerContactRun *self, double t, const TinkerTrigger *trigger, double *value)
{
    double *v;
    TinkerStatus status = is_of_place(trigger) ? tinker_contact_run_place_at(self, t, &v) : ask_at_time(self, t, &v);
    if (status == TINKER_OK) *value = tinker_trigger_value(self, trigger);
    return status;
}

static TinkerStatus fill_values(TinkerContactRun *self, double from, double to)
{
    const double *nodes = self->nodes;
    double speed = self->run->system.speed;
    int32_t count = self->degree + 1;
    for (int32_t k = 0; k < count; k++) {
        double t = k == 0 ? from : k == count - 1 ? to : from + nodes[k] * (to - from), *v;
        TinkerStatus status = look_at_time(self, t, &v);
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
    if (ask_at_time(self, from, &v) != TINKER_OK) return rate;
    tinker_contacts_relative_acceleration(
        self->contacts, tinker_contacts_closed(self->contacts, (guint)trigger->closed), self->force, along);
    return sign * along[1];
}

/* Whether it rises first, by less than the polynomial resolves. Of what has a rate of its own that says it: a
 * difference of values may be rounding. */
static gboolean rises_first(TinkerContactRun *self, const TinkerTrigger *trigger, double from, double to)
{
    double at_first, soon;
    if (value_at(self, from, trigger, &at_first) != TINKER_OK) return FALSE;
    if (trigger->kind == TINKER_TRIGGER_GAP && trigger->row >= 0)
        return tinker_constraints_own_rate(self->model, trigger->row) < 0;
    if (trigger->kind == TINKER_TRIGGER_END || trigger->kind == TINKER_TRIGGER_BEGINNING)
        return rate_from_end(self, trigger, from) > 0;
    if (trigger->kind == TINKER_TRIGGER_GAP)
        return tinker_contact_place(self->contacts, trigger->body, trigger->plate).normal_speed > 0;
    if (trigger->kind == TINKER_TRIGGER_SPEED) {
        double *v;
        const TinkerTrigger starting = {TINKER_TRIGGER_STARTING, trigger->body, trigger->plate, trigger->closed, -1, 0};
        return ask_at_time(self, from, &v) == TINKER_OK && tinker_trigger_value(self, &starting) > 0;
    }
    return value_at(self, from + TINKER_FALLS_AT_ONCE * (to - from), trigger, &soon) == TINKER_OK && soon > at_first;
}

/* Whether a place or a speed comes up from clearly below its level, as that of a contact that was taken for one that
 * stops behind a blow and then slides the other way: what a closer look would find is the same rise. One that turns
 * back below the level, or starts at 0 but for rounding, has to be looked at. A force below its level is an event. */
static gboolean comes_up(const TinkerContactRun *self, const TinkerTrigger *trigger, const double *values)
{
    const double most = tinker_largest(self->degree + 1, values);
    if (!is_of_place(trigger) || !(values[0] < fmin(trigger->level, -TINKER_NOTHING * most))) return FALSE;
    for (int32_t k = 1; k <= self->degree && values[k - 1] <= trigger->level; k++)
        if (!(values[k] >= values[k - 1])) return FALSE;
    return TRUE;
}

/* The first fall of one trigger between two times and before one that is known; INFINITY for none, NAN where it has to
 * be looked at more closely. */
static double first_fall(TinkerContactRun *self, const TinkerTrigger *trigger, const double *values, double from,
                         double to, double known)
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
    TinkerStatus status = look_at_time(self, from + PLACE_BETWEEN * (to - from), &v);
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
    return !is_of_place(trigger) && place > 0 && place < self->nodes[1] && values[1] > trigger->level &&
           fabs(values[0]) <= TINKER_NOTHING * most;
}

static TinkerStatus search_part(TinkerContactRun *self, double from, double to, int depth, TinkerTrigger *found,
                                double *time);

/* The first half, and where nothing is found there, the second. */
static TinkerStatus search_halves(TinkerContactRun *self, double from, double to, int depth, TinkerTrigger *found,
                                  double *time)
{
    double middle = 0.5 * (from + to);
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
    if (!resolved) return search_halves(self, from, to, depth, found, time);
    TinkerTrigger unclear = {.kind = TINKER_TRIGGER_NONE};
    for (guint i = 0; i < self->triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        const double *values = self->values + i * (guint)(self->degree + 1);
        double t = first_fall(self, trigger, values, from, to, *time);
        if (depth > 0 && dips_at_first(self, trigger, values, (t - from) / (to - from))) t = NAN;
        if (isnan(t)) unclear = *trigger;
        if (!(t < *time)) continue;
        *time = t;
        *found = *trigger;
    }
    if (unclear.kind == TINKER_TRIGGER_NONE || *time == from) return TINKER_OK;
    if (depth == 0 && is_of_place(&unclear)) return TINKER_OK;
    *time = from;
    *found = unclear;
    if (depth == 0) return TINKER_OK;
    found->kind = TINKER_TRIGGER_NONE;
    *time = INFINITY;
    const double middle = from + self->nodes[1] * (to - from);
    status = search_part(self, from, middle, depth - 1, found, time);
    if (status != TINKER_OK || found->kind != TINKER_TRIGGER_NONE) return status;
    return search_part(self, middle, to, depth - 1, found, time);
}

double tinker_contact_run_swing(TinkerContactRun *self, int32_t point, const TinkerPlate *top, double from, double to)
{
    const TinkerPlace *turned = top != NULL ? top->turned : NULL;
    const double reach = turned != NULL ? hypot(top->half_width, top->half_height) : 0;
    double *speed = &self->plate_speed[point - self->model->first_support], change = 0;
    for (int k = 0; k <= 8; k++) {
        if (tinker_model_set_time(self->model, from + k * (to - from) / 8) != TINKER_OK) return 0;
        const double *a = self->model->point_acceleration + 2 * point;
        const double rate = turned != NULL ? fabs(turned->rate) : 0,
                     alpha = turned != NULL ? fabs(turned->angular_acceleration) : 0;
        *speed = fmax(*speed, hypot(self->model->point[point].vx, self->model->point[point].vy) + rate * reach);
        change = fmax(change, hypot(a[0], a[1]) + (alpha + rate * rate) * reach);
    }
    self->contacts->plate_speed = fmax(self->contacts->plate_speed, *speed);
    return *speed > 0 ? change / *speed : 0;
}

/* How fast (rad/s) bodies turn whose corners may touch: at the ends of the step. */
static double highest_rate(const TinkerContactRun *self)
{
    const TinkerModel *model = self->model;
    double highest = 0;
    for (int32_t k = 0; self->contacts->gap_count > 0 && k < model->turning; k++) {
        const int32_t at = 2 * model->bodies + k;
        const double speed = fmax(fabs(self->from.v[at]), fabs(self->run->state.v[at]));
        if (self->contacts->reach[model->turns[k].body] > 0) highest = fmax(highest, speed / model->turns[k].gyration);
    }
    return highest;
}

/* The fastest swing of moving plates, and of what turns. */
static double highest_frequency(TinkerContactRun *self, double from, double to)
{
    const TinkerContacts *contacts = self->contacts;
    double highest = highest_rate(self);
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
        TinkerStatus status = value_at(self, at[k], trigger, &value[k]);
        if (status != TINKER_OK) return status;
    }
    *slope = (value[1] - value[0]) / (at[1] - at[0]);
    return TINKER_OK;
}

/* Whether all that acts varies as slowly as the steps resolve, so that a few values tell of what is between them: what
 * waveforms and supports do might repeat itself from end to end, and adaptive steps may be as long as a swing. */
static gboolean varies_slowly(const TinkerContactRun *self)
{
    const TinkerModel *model = self->model;
    gboolean fixed = tinker_method_is_fixed(self->run->choice.method);
    return fixed && model->waveform_batches->len == 0 && model->asked_forces->len == 0 && model->moving_supports == 0 &&
           model->constraints.unilateral == NULL && self->near->len == 0;
}

static TinkerStatus fill_place(TinkerContactRun *self, double t, double *values)
{
    double *v;
    TinkerStatus status = look_at_time(self, t, &v);
    for (guint i = 0; status == TINKER_OK && i < self->triggers->len; i++)
        values[i] = tinker_trigger_value(self, &g_array_index(self->triggers, TinkerTrigger, i));
    return status;
}

/* Whether the least of some values is `times` as large as what they change by, in this step and in the one before: one
 * step may happen to end as it began, two do not. */
static gboolean is_far_off(const TinkerContactRun *self, guint places, double times)
{
    guint count = self->triggers->len;
    for (guint i = 0; i < count; i++) {
        double least = self->values[i], most = least;
        for (guint k = 1; k < places; k++) {
            least = fmin(least, self->values[k * count + i]);
            most = fmax(most, self->values[k * count + i]);
        }
        if (!(least > times * fmax(most - least, self->end_values[count + i]))) return FALSE;
    }
    return TRUE;
}

/* Whether no trigger comes near its level, by far: from the values at the ends of the step, and where these change from
 * the one in its middle as well. What is at the end serves the next step as what is at its start. */
static TinkerStatus look_at_places(TinkerContactRun *self, double from, double to, gboolean *clear)
{
    guint count = self->triggers->len;
    double *first = self->values, *last = first + count, *middle = last + count, *kept = self->end_values;
    gboolean follows = self->end_time == from && self->end_changes == self->changes;
    *clear = FALSE;
    if (follows) memcpy(first, kept, count * sizeof(double));
    TinkerStatus status = follows ? TINKER_OK : fill_place(self, from, first);
    if (status == TINKER_OK) status = fill_place(self, to, last);
    if (status != TINKER_OK) return status;
    *clear = follows && is_far_off(self, 2, TINKER_MOST_SURELY);
    if (follows && !*clear) {
        status = fill_place(self, 0.5 * (from + to), middle);
        *clear = status == TINKER_OK && is_far_off(self, 3, TINKER_SURELY);
    }
    self->end_time = to;
    self->end_changes = self->changes;
    for (guint i = 0; i < count; i++) {
        kept[i] = last[i];
        kept[count + i] = fabs(last[i] - first[i]);
    }
    return status;
}

/* Soon ------------------------------------------------------------------------------------------------------------- */

/* Whether steps are held to a tolerance and nothing acts that swings by itself, so that what a few places of a step
 * tell holds between them. A body may turn many times within a step that its own motion does not limit: its corners are
 * as far off at three places that are half a turn apart, whatever they do in between. */
static gboolean acts_evenly(const TinkerContactRun *self, double step)
{
    const TinkerModel *model = self->model;
    return tinker_method_is_adaptive(self->run->choice.method) && !self->exact && model->waveform_batches->len == 0 &&
           model->asked_forces->len == 0 && model->moving_supports == 0 && model->constraints.unilateral == NULL &&
           highest_rate(self) * step <= TINKER_LONGEST_ARC;
}

/* The values of triggers of places at a node of the step: of all (`which` is NULL), or of some. */
static TinkerStatus fill_node(TinkerContactRun *self, double from, double to, int32_t node, const GArray *which,
                              double *speed)
{
    const guint count = (guint)self->degree + 1, some = which != NULL ? which->len : self->triggers->len;
    const double t = node == 0 ? from : node == self->degree ? to : from + self->nodes[node] * (to - from);
    double *v;
    TinkerStatus status = tinker_contact_run_place_at(self, t, &v);
    if (status != TINKER_OK) return status;
    for (guint i = 0; i < some; i++) {
        const guint number = which != NULL ? g_array_index(which, guint, i) : i;
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, number);
        if (is_of_place(trigger)) self->values[number * count + (guint)node] = tinker_trigger_value(self, trigger);
    }
    *speed = fmax(*speed, tinker_largest(self->model->coordinates, v));
    return TINKER_OK;
}

/* The triggers of places that do not stay far from 0 in the step, as their values at its ends and in its middle have it
 * where these hardly differ. */
static void list_falling(TinkerContactRun *self)
{
    const int32_t last = self->degree;
    g_array_set_size(self->falling, 0);
    for (guint i = 0; i < self->triggers->len; i++) {
        if (!is_of_place(&g_array_index(self->triggers, TinkerTrigger, i))) continue;
        const double *values = self->values + i * ((guint)last + 1);
        const double a = values[0], b = values[last / 2], c = values[last];
        const double least = MIN(a, MIN(b, c)), most = MAX(a, MAX(b, c));
        if (!(least > TINKER_SURELY * (most - least))) g_array_append_val(self->falling, i);
    }
}

/* The triggers of places that may fall to 0 in the step, their values at all its nodes and their levels. */
static TinkerStatus fill_places(TinkerContactRun *self, double from, double to)
{
    const int32_t last = self->degree, middle = last / 2;
    double speed = self->run->system.speed;
    for (int32_t node = 0; node <= last; node += middle) {
        TinkerStatus status = fill_node(self, from, to, node, NULL, &speed);
        if (status != TINKER_OK) return status;
    }
    list_falling(self);
    for (int32_t node = 1; self->falling->len > 0 && node < last; node++) {
        TinkerStatus status = node == middle ? TINKER_OK : fill_node(self, from, to, node, self->falling, &speed);
        if (status != TINKER_OK) return status;
    }
    double *v; /* levels are those of the step's end */
    TinkerStatus status = self->falling->len > 0 ? tinker_contact_run_place_at(self, to, &v) : TINKER_OK;
    for (guint i = 0; i < self->falling->len; i++) {
        TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, g_array_index(self->falling, guint, i));
        trigger->level = tinker_trigger_level(self, trigger, speed);
    }
    return status;
}

/* The first fall of a place in the step; *time is INFINITY where there is none, NAN where that has to be looked at more
 * closely. */
static TinkerStatus first_place_to_fall(TinkerContactRun *self, double from, double to, TinkerTrigger *found,
                                        double *time)
{
    *time = INFINITY;
    TinkerStatus status = fill_places(self, from, to);
    for (guint i = 0; status == TINKER_OK && i < self->falling->len; i++) {
        const guint number = g_array_index(self->falling, guint, i);
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, number);
        const double t = first_fall(self, trigger, self->values + number * (guint)(self->degree + 1), from, to, *time);
        if (!(t < *time) && !isnan(t)) continue;
        *time = t;
        *found = *trigger;
        if (isnan(t)) break;
    }
    return status;
}

/* Whether all forces stay far from where they change anything, from the first of two near times to the other: by their
 * values there and halfway, which hardly differ. */
static TinkerStatus forces_are_far_off(TinkerContactRun *self, double from, double to, gboolean *far)
{
    const guint count = self->triggers->len;
    double *v;
    *far = TRUE;
    for (guint k = 0; k < 3; k++) {
        TinkerStatus status = ask_at_time(self, from + 0.5 * k * (to - from), &v);
        if (status != TINKER_OK) return status;
        for (guint i = 0; i < count; i++) {
            const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
            if (!is_of_place(trigger)) self->values[k * count + i] = tinker_trigger_value(self, trigger);
        }
    }
    for (guint i = 0; i < count && *far; i++) {
        if (is_of_place(&g_array_index(self->triggers, TinkerTrigger, i))) continue;
        const double a = self->values[i], b = self->values[count + i], c = self->values[2 * count + i];
        const double least = fmin(a, fmin(b, c)), most = fmax(a, fmax(b, c));
        *far = least > TINKER_SURELY * (most - least);
    }
    return TINKER_OK;
}

/* Where contacts follow upon one another, the first event is that of a place soon after the step's start. Then nothing
 * has to be known of forces behind it. FALSE where that is not so, or not sure. */
static TinkerStatus search_soon(TinkerContactRun *self, double from, double to, TinkerTrigger *found, double *time,
                                gboolean *done)
{
    TinkerTrigger first;
    double t;
    *done = FALSE;
    TinkerStatus status = first_place_to_fall(self, from, to, &first, &t);
    if (status != TINKER_OK || isnan(t) || !(fmin(t, to) <= from + TINKER_SOON * self->usual)) return status;
    status = t > from ? forces_are_far_off(self, from, fmin(t, to), done) : TINKER_OK;
    *done |= t == from;
    if (!*done || isinf(t)) return status;
    *found = first;
    *time = t;
    return status;
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
    if (varies_slowly(self)) status = look_at_places(self, from, to, &clear);
    if (clear || status != TINKER_OK) return status;
    gboolean done = FALSE;
    if (self->contacts->closed->len > 0 && acts_evenly(self, to - from))
        status = search_soon(self, from, to, found, time, &done);
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
