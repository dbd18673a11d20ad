/* Contacts that follow upon one another, as of a chain that strikes the ground link by link: a step is made for the
 * next one where that is to come soon, and its state is carried the little way that is left to the event, so that
 * hardly any step is made twice. And masses that lie in a row and reach the limit of sticking together: no step is made
 * from one to the other. */
#include <float.h>
#include <math.h>

#include "numerics/solve/largest.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

#define MOST_CARRIES 3

/* How far in time (s) the state may be carried on by its velocities and accelerations, those that were worked out last:
 * these change within a step of usual length by no more than so many times as much, which is to be nothing beside the
 * error of the method. Where that is not held to a tolerance, states follow from steps alone. */
static double longest_carry(const TinkerContactRun *self)
{
    const TinkerIslandRun *run = self->run;
    const int32_t n = run->system.system.size;
    if (!self->in_plane || !tinker_method_is_adaptive(run->choice.method)) return 0;
    const double strongest = tinker_largest(n, self->force), speed = tinker_largest(n, run->state.v);
    const double share = fmax(TINKER_CARRIED_SHARE * run->choice.tolerance, DBL_EPSILON);
    if (!(strongest > 0)) return 0;
    return fmin(TINKER_FARTHEST_CARRY * self->usual,
                sqrt(share * speed * self->usual / (TINKER_CARRIED_CHANGE * strongest)));
}

gboolean tinker_contact_run_ends_near(const TinkerContactRun *self, double time)
{
    return fabs(time - self->run->state.t) < longest_carry(self);
}

/* Takes the state on by a short time (s), with the accelerations and powers that were worked out there. */
static void carry(TinkerContactRun *self, double by, const double *power)
{
    TinkerState *state = &self->run->state;
    const TinkerSystem *system = &self->run->system.system;
    for (int32_t i = 0; i < system->size; i++) {
        state->q[i] += by * (state->v[i] + 0.5 * by * self->force[i]);
        state->v[i] += by * self->force[i];
    }
    for (int32_t i = 0; i < system->books; i++)
        state->books[i] += by * power[i];
}

/* Carries the state of a time on until a gap is 0 to rounding; *closed is FALSE where it does not get there, as one
 * that closes too slowly. */
static TinkerStatus close_gap(TinkerContactRun *self, const TinkerTrigger *trigger, const double *power, double *time,
                              gboolean *closed)
{
    const TinkerState *state = &self->run->state;
    *closed = FALSE;
    for (int k = 0; k < MOST_CARRIES; k++) {
        TinkerStatus status = tinker_model_set_time(self->model, *time);
        if (status != TINKER_OK) return status;
        tinker_model_set_state(self->model, state->q, state->v);
        const TinkerContactPlace place = tinker_contact_place(self->contacts, trigger->body, trigger->plate);
        const double by = -place.gap / place.normal_speed;
        *closed = fabs(by) <= 2 * DBL_EPSILON * fabs(*time);
        if (*closed || !(fabs(by) <= longest_carry(self))) break;
        carry(self, by, power);
        *time += by;
    }
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_carry_to(TinkerContactRun *self, const TinkerTrigger *trigger, double time,
                                         TinkerStepReport *report, gboolean *there)
{
    TinkerState *state = &self->run->state;
    TinkerSystem *system = &self->run->system.system;
    const double before = state->t;
    const double *power = self->power;
    *there = FALSE;
    if (!(fabs(time - before) < TINKER_FARTHEST_CARRY * self->usual) || !(longest_carry(self) > 0)) return TINKER_OK;
    if (fabs(time - before) > before - self->from.t) return TINKER_OK; /* dense output would be anything there */
    TinkerStatus status = TINKER_OK;
    if (!tinker_contact_run_has_looked(self, before))
        status = system->acceleration(system->context, before, state->q, state->v, self->force, self->power);
    if (status != TINKER_OK || !(fabs(time - before) <= longest_carry(self))) return status;
    carry(self, time - before, power);
    *there = TRUE;
    if (trigger->kind == TINKER_TRIGGER_GAP && trigger->row < 0) status = close_gap(self, trigger, power, &time, there);
    if (status != TINKER_OK || !*there) return status;
    state->t = fmax(time, self->from.t + 4 * DBL_EPSILON * fabs(self->from.t));
    report->step += state->t - before;
    self->carried = TRUE;
    return TINKER_OK;
}

/* When the gap of an open pair falls to 0, by the accelerations worked out last; INFINITY where it does not. It is
 * open beyond a gap of `closed`. */
static double arrival(const TinkerContactRun *self, const TinkerContactPair *pair, double closed)
{
    const TinkerPlate *plate = &self->contacts->plates[pair->plate];
    const TinkerContactPlace place = tinker_contact_place(self->contacts, pair->body, pair->plate);
    const double *a = self->force + 2 * pair->body;
    const double bend = plate->normal[0] * a[0] + plate->normal[1] * a[1], speed = place.normal_speed;
    const double root = speed * speed - 2 * bend * place.gap;
    if (!(place.gap > closed) || !(root >= 0) || fabs(place.along) > plate->half_width) return INFINITY;
    const double time = 2 * place.gap / (-speed + sqrt(root)); /* the nearer root, whatever its signs */
    return time > 0 && !tinker_contact_run_leaves(self, pair) ? time : INFINITY;
}

/* Apart, as it is asked behind events alone. */
static G_NO_INLINE void expect_arrival(TinkerContactRun *self)
{
    const TinkerIslandRun *run = self->run;
    double soonest = TINKER_SOON * self->usual;
    if (isnan(self->start.at.t) && tinker_contact_run_evaluate_start(self) != TINKER_OK) return;
    tinker_contact_run_hand_start_on(self);
    if (self->near->len == 0 || self->contacts->moving_plates > 0) return;
    const double closed = tinker_contact_run_closed_gap(self);
    for (int32_t i = 0; i < self->model->bodies; i++) {
        const GArray *plates = self->neighbours.lists[i];
        for (guint k = 0; k < plates->len; k++) {
            const TinkerContactPair pair = {i, g_array_index(plates, int32_t, k), -1};
            const double time = arrival(self, &pair, closed);
            if (!(time < soonest)) continue;
            self->hint_trigger = (TinkerTrigger){TINKER_TRIGGER_GAP, pair.body, pair.plate, -1, -1, 0};
            self->hint_trigger.level = -tinker_trigger_place_rounding(self, &self->hint_trigger);
            soonest = time;
            self->expects = TRUE;
        }
    }
    if (self->expects) self->hint = run->state.t + soonest + 0.1 * longest_carry(self);
}

void tinker_contact_run_expect(TinkerContactRun *self)
{
    self->expects = FALSE;
    if (self->passed && self->in_plane && !self->remembers && !isfinite(self->hint) &&
        tinker_method_is_adaptive(self->run->choice.method))
        expect_arrival(self);
}

void tinker_contact_run_take_expected(TinkerContactRun *self, TinkerTrigger *found, double *time, double *slope)
{
    const TinkerIslandRun *run = self->run;
    tinker_model_set_state(self->model, run->q, run->v);
    const TinkerContactPlace place =
        tinker_contact_place(self->contacts, self->hint_trigger.body, self->hint_trigger.plate);
    const double left = -place.gap / place.normal_speed;
    if (!(place.normal_speed < 0) || !tinker_contact_run_ends_near(self, run->state.t + left)) return;
    *found = self->hint_trigger;
    *time = run->state.t + left;
    *slope = place.normal_speed;
}

/* At once ---------------------------------------------------------------------------------------------------------- */

/* Whether the trigger is of a mass on a top that reaches the limit of sticking. Where shapes that turn lie on one
 * another what presses is a share of a load, too, and which of them slip is no more than how it is shared: steps tell.
 */
static gboolean is_of_sticking(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const gboolean limit = trigger->kind == TINKER_TRIGGER_FORWARD || trigger->kind == TINKER_TRIGGER_BACKWARD;
    return limit && trigger->plate < self->contacts->plate_count;
}

/* The values of the triggers of sticking (is_of_sticking) by the forces worked out last, `stride` apart. */
static void fill_left(TinkerContactRun *self, double *values, guint stride)
{
    tinker_contact_run_note_force_scales(self);
    for (guint i = 0; i < self->triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        if (is_of_sticking(self, trigger)) values[stride * i] = tinker_trigger_value(self, trigger);
    }
}

/* The forces a part of a usual step later, where the present accelerations lead. */
static TinkerStatus look_ahead(TinkerContactRun *self, double by)
{
    const TinkerState *state = &self->run->state;
    for (int32_t i = 0; i < self->run->system.system.size; i++) {
        self->node_x[i] = state->q[i] + by * (state->v[i] + 0.5 * by * self->start.force[i]);
        self->node_u[i] = state->v[i] + by * self->start.force[i];
    }
    return tinker_contact_run_look_at(self, state->t + by, self->node_x, self->node_u, NULL);
}

/* Whether any of the triggers of sticking is no more than rounding where the step begins. */
static gboolean is_any_at_its_end(TinkerContactRun *self)
{
    fill_left(self, self->values, 3);
    for (guint i = 0; i < self->triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        if (is_of_sticking(self, trigger) && self->values[3 * i] <= -tinker_trigger_level(self, trigger, 0))
            return TRUE;
    }
    return FALSE;
}

/* Whether it is nothing, and less from the start on; *sure is FALSE where a step has to tell. */
static gboolean falls_now(TinkerContactRun *self, guint number, gboolean *sure)
{
    const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, number);
    const double *values = self->values + 3 * number;
    if (!is_of_sticking(self, trigger)) return FALSE;
    const double level = tinker_trigger_level(self, trigger, 0); /* what is nearer to 0 is 0 but for rounding */
    if (!(values[0] <= -level) || !(values[2] < level)) return FALSE;
    *sure = values[1] <= values[0];
    return TRUE;
}

/* The first that does so, unless it or another was asked at this instant already: then it stands at an edge, that a
 * step has to pass (tinker_contact_run_stays_at_edge). Those that reach the limit of sticking with it are noted. */
static gboolean find_falling(TinkerContactRun *self, TinkerTrigger *first)
{
    gboolean found = FALSE, sure;
    for (guint i = 0; i < self->triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        if (!falls_now(self, i, &sure)) continue;
        if (!found && !sure) return FALSE;
        if (tinker_trigger_of_contact(self->asked, trigger->body, trigger->plate) != NULL) return FALSE;
        if (!found) *first = *trigger;
        if (found && sure && self->together[trigger->body] == self->together[first->body])
            g_array_append_val(self->alike, *trigger);
        found = TRUE;
    }
    return found;
}

gboolean tinker_contact_run_next_at_once(TinkerContactRun *self, TinkerTrigger *next)
{
    const TinkerIslandRun *run = self->run;
    gboolean found = FALSE;
    const double by = fmin(self->usual, run->piece_end - run->state.t);
    g_array_append_val(self->asked, *next);
    g_array_append_vals(self->asked, self->alike->data, self->alike->len);
    g_array_set_size(self->alike, 0);
    if (!tinker_method_is_adaptive(run->choice.method) || self->remembers || !(by > 0)) return FALSE;
    if (self->contacts->closed->len == 0 || self->model->constraints.unilateral != NULL) return FALSE;
    tinker_contact_run_keep_start(self);
    if (tinker_contact_run_evaluate_start(self) != TINKER_OK) return FALSE;
    if (tinker_contact_run_list_triggers(self) != TINKER_OK || !is_any_at_its_end(self)) return FALSE;
    if (look_ahead(self, TINKER_FALLS_AT_ONCE * by) == TINKER_OK) {
        fill_left(self, self->values + 1, 3);
        if (look_ahead(self, self->nodes[1] * by) == TINKER_OK) {
            fill_left(self, self->values + 2, 3);
            found = find_falling(self, next);
        }
    }
    if (!found) g_array_set_size(self->alike, 0);
    tinker_contact_run_recall_start(self, self->start.at.t);
    tinker_contact_run_forget_start(self);
    return found;
}
