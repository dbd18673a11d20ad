/* What a search is spared by: no trigger comes near its level in the step, or the first event comes soon after the
 * step's start; as the values at a few places of the step tell. */
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-search-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

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
    TinkerStatus status = tinker_contact_search_look(self, t, &v);
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

TinkerStatus tinker_contact_search_far_off(TinkerContactRun *self, double from, double to, gboolean *clear)
{
    guint count = self->triggers->len;
    double *first = self->values, *last = first + count, *middle = last + count, *kept = self->end_values;
    gboolean follows = self->end_time == from && self->end_changes == self->changes;
    *clear = FALSE;
    if (!varies_slowly(self)) return TINKER_OK;
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

/* Whether steps are held to a tolerance and nothing acts that swings by itself, so that what a few places of a step
 * tell holds between them. A body may turn many times within a step that its own motion does not limit: its corners are
 * as far off at three places that are half a turn apart, whatever they do in between. */
static gboolean acts_evenly(const TinkerContactRun *self, double step)
{
    const TinkerModel *model = self->model;
    return tinker_method_is_adaptive(self->run->choice.method) && !self->exact && model->waveform_batches->len == 0 &&
           model->asked_forces->len == 0 && model->moving_supports == 0 && model->constraints.unilateral == NULL &&
           tinker_contact_run_fastest_turn(self) * step <= TINKER_LONGEST_ARC;
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
        if (tinker_trigger_is_of_place(trigger))
            self->values[number * count + (guint)node] = tinker_trigger_value(self, trigger);
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
        if (!tinker_trigger_is_of_place(&g_array_index(self->triggers, TinkerTrigger, i))) continue;
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
        const double t = tinker_contact_search_first_fall(
            self, trigger, self->values + number * (guint)(self->degree + 1), from, to, *time);
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
        TinkerStatus status = tinker_contact_search_ask(self, from + 0.5 * k * (to - from), &v);
        if (status != TINKER_OK) return status;
        for (guint i = 0; i < count; i++) {
            const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
            if (!tinker_trigger_is_of_place(trigger)) self->values[k * count + i] = tinker_trigger_value(self, trigger);
        }
    }
    for (guint i = 0; i < count && *far; i++) {
        if (tinker_trigger_is_of_place(&g_array_index(self->triggers, TinkerTrigger, i))) continue;
        const double a = self->values[i], b = self->values[count + i], c = self->values[2 * count + i];
        const double least = fmin(a, fmin(b, c)), most = fmax(a, fmax(b, c));
        *far = least > TINKER_SURELY * (most - least);
    }
    return TINKER_OK;
}

TinkerStatus tinker_contact_search_soon(TinkerContactRun *self, double from, double to, TinkerTrigger *found,
                                        double *time, gboolean *done)
{
    TinkerTrigger first;
    double t;
    *done = FALSE;
    if (self->contacts->closed->len == 0 || !acts_evenly(self, to - from)) return TINKER_OK;
    TinkerStatus status = first_place_to_fall(self, from, to, &first, &t);
    if (status != TINKER_OK || isnan(t) || !(fmin(t, to) <= from + TINKER_SOON * self->usual)) return status;
    status = t > from ? forces_are_far_off(self, from, fmin(t, to), done) : TINKER_OK;
    *done |= t == from;
    if (!*done || isinf(t)) return status;
    *found = first;
    *time = t;
    return status;
}
