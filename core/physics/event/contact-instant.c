/* Ends a step at an event: by its dense output where the method remembers its steps, else by steps that are made again
 * until one ends there. */
#include <float.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

#define MOST_TRIALS 12

static void go_back(TinkerContactRun *self)
{
    tinker_island_run_go_back(self->run, &self->from, self->projection_work, self->position_error);
    tinker_contact_run_hand_start_on(self);
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
 * the method makes several steps of it, the last of them goes on from here. */
static TinkerStatus step_to_event(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                  TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    double from = self->from.t, end = self->limit;
    double first = MIN(from + fmax(TINKER_AT_ONCE * (run->state.t - from), 4 * DBL_EPSILON * fabs(from)), end);
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
        double next = CLAMP(next_trial(&trial, &before, &slope), first, end);
        if (has_settled(&trial, &before, next, trigger->level)) break;
        gboolean there;
        status = tinker_contact_run_carry_to(self, trigger, next, report, &there);
        if (status != TINKER_OK) return status;
        if (there) break;
        before = trial;
        trial.time = next;
    }
    stand_on_event(self, trigger);
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_end_at(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                       TinkerStepReport *report)
{
    return self->remembers ? cut_to_event(self, trigger, time, slope, report)
                           : step_to_event(self, trigger, time, slope, report);
}
