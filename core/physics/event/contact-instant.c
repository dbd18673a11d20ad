/* Ends a step at an event: by its dense output where the method remembers its steps, or where the step was far shorter
 * than its error asks for; else by steps that are made again until one ends there. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

#define MOST_TRIALS 24
/* Of a step that was searched: an event may be so much later than its end, as dense output has it. */
#define BEYOND_STEP 0.01
/* Events that a step may turn out to have passed on the way to one. */
#define MOST_EARLIER 8

static void go_back(TinkerContactRun *self)
{
    tinker_island_run_go_back(self->run, &self->from, self->projection_work, self->position_error);
    tinker_contact_run_hand_start_on(self);
    self->carried = FALSE;
}

/* A trial of the time of an event: what the trigger's value was there. */
typedef struct {
    double time, value;
} Trial;

/* Where the secant through two trials falls through 0; the first knows its slope from dense output. */
static double next_trial(const Trial *trial, const Trial *before, double *slope)
{
    if (trial->time != before->time) *slope = (trial->value - before->value) / (trial->time - before->time);
    return *slope < 0 ? trial->time - trial->value / *slope : trial->time;
}

/* Where a trial leads, between times that are known to be before and behind the fall; halfway, where a slope that is
 * little more than rounding leads past them. */
static double next_within(const Trial *trial, double next, double level, double *first, double *end)
{
    if (trial->value > fabs(level)) *first = fmax(*first, trial->time);
    if (trial->value < -fabs(level)) *end = fmin(*end, trial->time);
    const gboolean leads_past = (next > *end && trial->time >= *end) || (next < *first && trial->time <= *first);
    return leads_past ? 0.5 * (*first + *end) : CLAMP(next, *first, *end);
}

/* Whether the trial is the event, as well as it can be told: the next is where it is, or the value is rounding and the
 * secant through two such leads away. */
static gboolean has_settled(const Trial *trial, const Trial *before, double next, double level)
{
    const double way = fabs(next - trial->time);
    if (way <= 2 * DBL_EPSILON * fabs(next)) return TRUE;
    return fabs(trial->value) <= fabs(level) && before->time != trial->time && way > fabs(trial->time - before->time);
}

static void stand_on_event(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    self->hint = INFINITY;
    self->pending = TRUE;
    self->pending_trigger = *trigger;
    if (trigger->kind == TINKER_TRIGGER_GAP) self->last_impact = self->run->state.t;
}

/* The trigger's value at a time within the step that was made, for the state that the run would go on from there. */
static TinkerStatus value_from(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double *value)
{
    TinkerModelSystem *system = &self->run->system;
    double *q, *v, work = system->projection_work, off = system->position_error;
    int32_t moved;
    TinkerStatus status = tinker_contact_run_state_at(self, time, &q, &v);
    if (status == TINKER_OK) status = system->system.project(system, time, q, v, &moved);
    system->projection_work = work;
    system->position_error = off;
    return status == TINKER_OK ? tinker_contact_run_value(self, time, q, v, trigger, value, NULL) : status;
}

/* When the trigger falls through 0 in the step that was made, to rounding. */
static TinkerStatus refine_event(TinkerContactRun *self, const TinkerTrigger *trigger, double slope, double *time)
{
    const double from = self->from.t, end = self->run->state.t;
    Trial trial = {CLAMP(*time, from, end), 0}, before = trial;
    for (int k = 0; k < MOST_TRIALS; k++) {
        TinkerStatus status = value_from(self, trigger, trial.time, &trial.value);
        if (status != TINKER_OK) return status;
        const double next = CLAMP(next_trial(&trial, &before, &slope), from, end);
        if (has_settled(&trial, &before, next, trigger->level)) break;
        before = trial;
        trial.time = next;
    }
    *time = fmin(fmax(trial.time, from + 4 * DBL_EPSILON * fabs(from)), end);
    return TINKER_OK;
}

/* The step ends at the event, by its dense output. */
static TinkerStatus cut_to_event(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                 TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    TinkerState *state = &run->state;
    TinkerSystem *system = &run->system.system;
    int32_t moved;
    TinkerStatus status = refine_event(self, trigger, slope, &time);
    if (status == TINKER_OK && time < state->t) {
        state->t = time;
        status = tinker_method_interpolate(run->choice.method, run->stepper, time, state->q, state->v, state->books);
        if (status == TINKER_OK) status = system->project(system->context, time, state->q, state->v, &moved);
        report->step = time - self->from.t;
    }
    if (status == TINKER_OK) stand_on_event(self, trigger);
    return status;
}

/* The step is made again, to the event: dense output says when it is, the step itself how far it is off there. Where
 * the method makes several steps of it, the last of them goes on from here. What falls at once stays there: a slope
 * that is next to nothing would lead past everything else. What has not fallen as far as this looks, as where dense
 * output is of a much longer step than this, is no event of it: nothing is pending, and no time is expected. */
static TinkerStatus step_to_event(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                  TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    const double from = self->from.t, length = run->state.t - from;
    double first = MIN(from + fmax(TINKER_AT_ONCE * length, 4 * DBL_EPSILON * fabs(from)), self->limit);
    double end = time > from ? CLAMP(run->state.t + BEYOND_STEP * length, first, self->limit) : first;
    const double farthest = end;
    Trial trial = {CLAMP(time, first, end), 0}, before = trial;
    if (tinker_contact_run_ends_near(self, trial.time)) before.time = trial.time = run->state.t;
    for (int k = 0; k < MOST_TRIALS; k++) {
        TinkerStatus status = TINKER_OK;
        self->hint = trial.time;
        if (run->state.t != trial.time) {
            go_back(self);
            status = tinker_island_run_make_step(run, trial.time, report);
        }
        if (status != TINKER_OK || run->state.t < trial.time) {
            self->hint_trigger = *trigger;
            self->hint_slope = slope;
            return status;
        }
        tinker_island_run_place(run);
        status = tinker_contact_run_value(self, run->state.t, run->q, run->v, trigger, &trial.value, self->power);
        if (status != TINKER_OK) return status;
        const double next = next_within(&trial, next_trial(&trial, &before, &slope), trigger->level, &first, &end);
        if (has_settled(&trial, &before, next, trigger->level)) break;
        gboolean there;
        status = tinker_contact_run_carry_to(self, trigger, next, report, &there);
        if (status != TINKER_OK) return status;
        if (there) break;
        before = trial;
        trial.time = next;
    }
    const gboolean fell = time <= from || trial.time < farthest || trial.value <= fabs(trigger->level);
    if (fell)
        stand_on_event(self, trigger);
    else
        self->hint = INFINITY;
    return TINKER_OK;
}

/* Whether dense output of the step that was made is as good as a step that ends within it: its error is of the order of
 * the estimate for the whole step, or a lower one. Where one event follows upon another most steps are like that. */
static gboolean is_smooth_within(const TinkerContactRun *self, double time, const TinkerStepReport *report)
{
    const gboolean inside = time > self->from.t && time < self->run->state.t && !self->carried;
    return inside && self->in_plane && tinker_method_is_adaptive(self->run->choice.method) &&
           report->error <= TINKER_CUT_ERROR;
}

static TinkerStatus end_at_fall(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                TinkerStepReport *report)
{
    return self->remembers || is_smooth_within(self, time, report) ? cut_to_event(self, trigger, time, slope, report)
                                                                   : step_to_event(self, trigger, time, slope, report);
}

static gboolean is_same(const TinkerTrigger *a, const TinkerTrigger *b)
{
    return a->kind == b->kind && a->body == b->body && a->plate == b->plate && a->row == b->row;
}

/* Whether a body is behind a top or in another body by more than rounding; beside a top it is not. */
static gboolean is_behind(const TinkerContactRun *self, const TinkerTrigger *gap, double closed)
{
    if (!(tinker_trigger_value(self, gap) < -closed)) return FALSE;
    const TinkerContactPlace place = tinker_contact_place(self->contacts, gap->body, gap->plate);
    return tinker_contact_is_over(self->contacts, gap->plate, &place, tinker_trigger_place_rounding(self, gap));
}

/* Lists the gaps, but for that of the event, that are behind where the step ends. */
static void list_behind(TinkerContactRun *self, const TinkerTrigger *trigger, double closed, GArray *behind)
{
    g_array_set_size(behind, 0);
    for (guint i = 0; i < self->triggers->len; i++) {
        const TinkerTrigger *other = &g_array_index(self->triggers, TinkerTrigger, i);
        if (other->kind != TINKER_TRIGGER_GAP || other->row >= 0 || is_same(other, trigger)) continue;
        if (is_behind(self, other, closed)) g_array_append_val(behind, i);
    }
}

/* Whether another gap than the event's, which was not closed where the step began, has closed before it: dense output
 * of a long step may put events in another order than the step that ends at one of them. */
static TinkerStatus has_passed_another(TinkerContactRun *self, const TinkerTrigger *trigger, gboolean *passed)
{
    const double closed = tinker_contact_run_closed_gap(self);
    double *v;
    *passed = FALSE;
    TinkerStatus status = tinker_contact_run_place_at(self, self->run->state.t, &v);
    if (status != TINKER_OK) return status;
    GArray *behind = self->falling; /* for work: no search is on */
    list_behind(self, trigger, closed, behind);
    if (behind->len == 0) return TINKER_OK;
    status = tinker_contact_run_place_at(self, self->from.t, &v);
    if (status != TINKER_OK) return status;
    for (guint i = 0; i < behind->len && !*passed; i++) {
        const TinkerTrigger *gap = &g_array_index(self->triggers, TinkerTrigger, g_array_index(behind, guint, i));
        *passed = tinker_contact_run_is_before(self, gap, tinker_trigger_value(self, gap), closed);
    }
    return tinker_contact_run_place_at(self, self->run->state.t, &v);
}

/* What falls before the event that the step ends at. Where its state was carried on to that, the step is made again for
 * this, as dense output is of what the method made; the state stays as it was where nothing else is found. */
static TinkerStatus search_before(TinkerContactRun *self, const TinkerTrigger *event, TinkerTrigger *earlier,
                                  double *time, double *slope, TinkerStepReport *report)
{
    TinkerState *state = &self->run->state;
    const TinkerSystem *system = &self->run->system.system;
    const double end = state->t;
    const gsize bytes = (gsize)system->size * sizeof(double), books = (gsize)system->books * sizeof(double);
    if (!self->carried) return tinker_contact_run_search(self, self->from.t, end, earlier, time, slope);
    g_autofree double *q = g_memdup2(state->q, bytes), *v = g_memdup2(state->v, bytes);
    g_autofree double *kept = g_memdup2(state->books, books);
    go_back(self);
    TinkerStatus status = tinker_island_run_make_step(self->run, end, report);
    if (status == TINKER_OK) status = tinker_contact_run_search(self, self->from.t, state->t, earlier, time, slope);
    if (status != TINKER_OK || state->t < end) return status;
    if (earlier->kind != TINKER_TRIGGER_NONE && !is_same(earlier, event)) return TINKER_OK;
    memcpy(state->q, q, bytes);
    memcpy(state->v, v, bytes);
    if (books > 0) memcpy(state->books, kept, books);
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_end_at(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                       TinkerStepReport *report)
{
    TinkerTrigger first = *trigger;
    for (int times = 0;;) {
        TinkerTrigger earlier;
        gboolean passed = FALSE;
        TinkerStatus status = end_at_fall(self, &first, time, slope, report);
        const gboolean missed = !self->pending && !isfinite(self->hint);
        if (status == TINKER_OK && self->pending) status = has_passed_another(self, &first, &passed);
        if (status != TINKER_OK || !(passed || missed)) return status;
        const double end = self->run->state.t;
        status = search_before(self, &first, &earlier, &time, &slope, report);
        const gboolean ends_earlier = self->run->state.t < end; /* and not at the event */
        if (ends_earlier) self->pending = FALSE;
        if (status != TINKER_OK || earlier.kind == TINKER_TRIGGER_NONE) return status;
        if (is_same(&earlier, &first) && !ends_earlier && !missed) return TINKER_OK;
        first = earlier;
        self->pending = FALSE;
        if (++times == MOST_EARLIER) return end_at_fall(self, &first, time, slope, report);
    }
}
