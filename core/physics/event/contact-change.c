/* What happens at an event: impacts where bodies approach what they touch, then which contacts are closed and which
 * stick.
 *
 * 1. All contacts that are closed, or whose gap is closed and not opening, are taken together; for 2. also those that
 *    have just opened.
 * 2. Where one of them approaches, an impact changes velocities (numerics/contact/contact-laws.h).
 * 3. Of those that do not part by then, the laws at the level of accelerations tell the modes from here on.
 * 4. Where no acceleration satisfies them (Painleve), an impulse ends the sliding that jams, and 3. is asked again. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/contact/tolerances.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

/* Impacts that are made to follow on one another at one instant; what strikes by turns without end is found out by
 * time. */
#define MOST_FOLLOWING 32
/* Of many bodies, so many changes follow at one instant of groups by themselves; then all are asked, as they may do the
 * same. */
#define FEW_AT_ONCE 4

static const char *name_of_row_change(TinkerContactMode was, TinkerContactMode is, gboolean landed)
{
    if (was == TINKER_CONTACT_OPEN) return !landed ? NULL : is != TINKER_CONTACT_OPEN ? "taut" : "jerk";
    return is == TINKER_CONTACT_OPEN ? "slack" : NULL;
}

/* `landed`: it has come down to the plate just now, with a blow or without. */
static const char *name_of_change(TinkerContactMode was, TinkerContactMode is, gboolean landed)
{
    if (was == TINKER_CONTACT_OPEN) return !landed ? NULL : is != TINKER_CONTACT_OPEN ? "rest" : "impact";
    if (is == TINKER_CONTACT_OPEN) return "take-off";
    if (is == was) return NULL;
    if (is == TINKER_CONTACT_STICK) return "stick";
    return was == TINKER_CONTACT_STICK ? "slip" : "reversal";
}

/* Every body lies along what pushes it hardest. */
static void turn_bodies(TinkerContactChange *change)
{
    double *hardest = change->acceleration; /* for work, by body */
    for (guint i = 0; i < change->touches->len; i++)
        hardest[tinker_touch(change, i)->contact.body] = -INFINITY;
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (at->row < 0) hardest[at->contact.body] = fmax(hardest[at->contact.body], at->contact.normal);
    }
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (at->row >= 0 || tinker_contacts_has_outline(change->contacts, at->contact.body) ||
            tinker_change_changes_side(change, at))
            continue;
        const gboolean pushed = at->struck || at->contact.mode != TINKER_CONTACT_OPEN;
        if (pushed && at->contact.normal >= hardest[at->contact.body])
            change->run->orientation[at->contact.body] = tinker_plate_angle(tinker_touch_plate(change, i));
    }
}

/* Whether a blow on another body threw it back: it is closed, or has opened once more. */
static gboolean was_thrown_back(const TinkerContactChange *change, const TinkerContactPair *pair)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (at->leaves && at->contact.body == pair->body && at->contact.plate == pair->plate) return TRUE;
    }
    return FALSE;
}

/* What opens by its acceleration alone is watched by that; what an event was about is done with, and what a blow on
 * another body throws back is watched by its gap again. So is what approaches: that others stick, which slid too slowly
 * to be seen, may leave it with a speed. */
static void note_leaving(TinkerContactChange *change)
{
    GArray *leaving = change->run->leaving;
    if (leaving->len + change->touches->len > 0 && tinker_change_set_state(change) != TINKER_OK) return;
    for (guint i = leaving->len; i-- > 0;) {
        const TinkerContactPair *pair = &g_array_index(leaving, TinkerContactPair, i);
        const TinkerTouch of = {.contact = {.body = pair->body, .plate = pair->plate}, .row = pair->row};
        if (tinker_change_is_trigger(change, &of) || tinker_change_approaches(change, pair) ||
            was_thrown_back(change, pair))
            g_array_remove_index_fast(leaving, i);
    }
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (tinker_touch_leans(change, i)) continue;
        TinkerContactPair pair = {at->contact.body, at->contact.plate, at->row};
        gboolean left = change->trigger.kind == TINKER_TRIGGER_LEAVING && tinker_change_is_trigger(change, at);
        gboolean parts = at->contact.mode == TINKER_CONTACT_OPEN && !left && !tinker_change_changes_side(change, at);
        /* by turns it is pressed and leaves by rounding: where it is back its gap tells */
        const gboolean by_gap = change->turns && at->row < 0 && tinker_change_is_trigger(change, at);
        gboolean held = tinker_change_other_side(change, at) != NULL && (at->was == TINKER_CONTACT_OPEN || at->struck);
        if (parts && !by_gap && !held && !tinker_contact_run_leaves(change->run, &pair) &&
            !tinker_change_approaches(change, &pair))
            g_array_append_val(leaving, pair);
    }
}

static void name_change(TinkerContactChange *change, guint number)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const TinkerPlate *plate = tinker_touch_plate(change, number);
    gboolean landed =
        at->struck || (tinker_change_is_trigger(change, at) && change->trigger.kind == TINKER_TRIGGER_GAP);
    if (tinker_change_changes_side(change, at)) return;
    const TinkerContactMode is = at->contact.at_limit ? TINKER_CONTACT_STICK : at->contact.mode;
    const char *name =
        plate != NULL ? name_of_change(at->was, is, landed) : name_of_row_change(at->was, at->contact.mode, landed);
    if (tinker_touch_leans(change, number) &&
        (at->was == TINKER_CONTACT_OPEN || at->contact.mode == TINKER_CONTACT_OPEN))
        return;
    const gboolean smooth = plate != NULL && tinker_touch_surface(change, number).static_friction == 0;
    if (name == NULL || (smooth && g_str_equal(name, "reversal"))) return;
    tinker_change_add_event(change, name, at);
}

/* What strikes comes before what the blow brings about at the same instant. */
static void name_changes(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->was == TINKER_CONTACT_OPEN) name_change(change, i);
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->was != TINKER_CONTACT_OPEN) name_change(change, i);
}

/* Whether it slips so slowly that a method whose first steps are of order 1 does not tell which way: its speed grows
 * with the second power of time. What was watched by its acceleration up to now is not any more. */
static gboolean has_unclear_speed(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerContactRun *self = change->run;
    gboolean slips =
        at->contact.mode == TINKER_CONTACT_SLIP_FORWARD || at->contact.mode == TINKER_CONTACT_SLIP_BACKWARD;
    gboolean watched = tinker_change_is_trigger(change, at) && change->trigger.kind == TINKER_TRIGGER_STARTING;
    return self->starts_low && slips && !watched &&
           fabs(at->place.tangential_speed) <= tinker_contact_run_unclear_speed(self);
}

static void close_one(TinkerContactChange *change, guint number)
{
    TinkerTouch *at = tinker_touch(change, number);
    if (at->contact.mode == TINKER_CONTACT_OPEN) return;
    if (at->row >= 0) {
        tinker_constraints_set_slack(change->model, at->row, FALSE);
        return;
    }
    if (at->was != TINKER_CONTACT_STICK) at->contact.anchor = at->place.rolled;
    at->contact.starts = has_unclear_speed(change, at);
    g_array_append_val(change->run->contacts->closed, at->contact);
}

static gboolean close_contacts(TinkerContactChange *change, GError **error)
{
    TinkerContactRun *self = change->run;
    TinkerContacts *contacts = self->contacts;
    for (guint i = contacts->closed->len; i-- > 0;)
        if (self->together[tinker_contacts_closed(contacts, i)->body] == change->group)
            g_array_remove_index(contacts->closed, i);
    for (guint i = 0; i < change->touches->len; i++)
        close_one(change, i);
    if (tinker_contacts_list_rows(contacts) != TINKER_OK || tinker_contact_run_make_room(self) != TINKER_OK)
        return tinker_change_refuse(change, change->model->failure, error);
    self->changes++;
    int32_t moved;
    TinkerSystem *system = &self->run->system.system;
    TinkerState *state = &self->run->state;
    gboolean acts = contacts->closed->len > 0 || change->model->constraints.unilateral != NULL;
    if (acts && system->project(system->context, state->t, state->q, state->v, &moved) != TINKER_OK)
        return tinker_change_refuse(change, change->model->failure, error);
    return TRUE;
}

/* Whether nothing determines how the load is shared, or did not until some reached the limit of sticking. */
static gboolean may_share(const TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->limit != 0) return TRUE;
    return tinker_change_shares_load(change);
}

/* Steps 3 and 4, and what is closed from here on. A contact that reaches the limit of sticking only by its share does
 * not slip where another share holds it. */
static gboolean find_contacts(TinkerContactChange *change, GError **error)
{
    gboolean limit = change->trigger.kind == TINKER_TRIGGER_FORWARD || change->trigger.kind == TINKER_TRIGGER_BACKWARD;
    change->forced = !(limit && may_share(change));
    if (!tinker_change_decide(change, error) || !close_contacts(change, error)) return FALSE;
    gboolean shared = !tinker_change_shares_load(change) || tinker_change_share_load(change);
    if (change->forced || shared) return TRUE;
    change->forced = TRUE;
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->row >= 0)
            tinker_constraints_set_slack(change->model, tinker_touch(change, i)->row, TRUE);
    if (tinker_change_set_state(change) != TINKER_OK)
        return tinker_change_refuse(change, change->model->failure, error);
    if (!tinker_change_decide(change, error) || !close_contacts(change, error)) return FALSE;
    if (tinker_change_shares_load(change)) tinker_change_share_load(change);
    return TRUE;
}

static gboolean settle_contacts(TinkerContactChange *change, GError **error)
{
    if (!find_contacts(change, error)) return FALSE;
    if (tinker_change_shares_load(change)) tinker_change_note_share(change);
    return TRUE;
}

/* What is at rest may be struck by what moves: that is a scale, too. */
static void include_relative_speeds(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerContactPlace *place = &tinker_touch(change, i)->place;
        change->speed = fmax(change->speed, hypot(place->normal_speed, place->tangential_speed));
    }
}

/* To the blow that was told of since there were so many events. */
static void give_alternatives(TinkerContactChange *change, guint before)
{
    static const char *const blows[] = {"impact", "rest", "jerk", "taut", NULL};
    GPtrArray *events = change->run->run->summary.events;
    for (guint i = before; change->alternatives != NULL && i < events->len; i++) {
        TinkerEvent *event = g_ptr_array_index(events, i);
        if (g_strv_contains(blows, event->kind)) event->alternatives = g_steal_pointer(&change->alternatives);
    }
    g_clear_pointer(&change->alternatives, g_array_unref);
}

/* Whether the event is that a speed has come to 0, and others of the group slide as well. */
static gboolean may_stop_together(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerContacts *contacts = self->contacts;
    for (guint i = 0; trigger->kind == TINKER_TRIGGER_SPEED && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const gboolean slides =
            contact->mode == TINKER_CONTACT_SLIP_FORWARD || contact->mode == TINKER_CONTACT_SLIP_BACKWARD;
        const gboolean other = contact->body != trigger->body || contact->plate != trigger->plate;
        if (slides && other && self->together[contact->body] == self->together[trigger->body]) return TRUE;
    }
    return FALSE;
}

/* Of what slides, by the accelerations up to the event. */
static void note_slowing(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        TinkerTouch *at = tinker_touch(change, i);
        double along[2] = {0, 0};
        if (at->row >= 0) continue;
        tinker_contacts_relative_acceleration(change->contacts, &at->contact, change->acceleration, along);
        at->slows = (at->was == TINKER_CONTACT_SLIP_FORWARD && along[1] < 0) ||
                    (at->was == TINKER_CONTACT_SLIP_BACKWARD && along[1] > 0);
    }
}

/* Takes what touches of one group through all four steps. */
static gboolean change_group(TinkerContactRun *self, const TinkerTrigger *trigger, int32_t group, double tolerance,
                             double slow, GError **error)
{
    TinkerIslandRun *run = self->run;
    /* what the trigger's contact did before is nothing to groups that are asked along with its own */
    const gboolean own = trigger->kind <= TINKER_TRIGGER_BLOW || self->together[trigger->body] == group;
    double extent;
    TinkerContactChange change = {
        .run = self,
        .model = self->model,
        .contacts = self->contacts,
        .acceleration = self->force,
        .trigger = *trigger,
        .jams = self->jams,
        .rattles = own && tinker_contact_run_strikes_by_turns(self, trigger),
        .turns = own && tinker_contact_run_goes_by_turns(self, trigger),
        .group = group,
        .touches = g_array_new(FALSE, TRUE, sizeof(TinkerTouch)),
        .told = g_array_new(FALSE, FALSE, sizeof(TinkerToldEvent)),
        .tolerance = fmin(tolerance, tinker_contact_run_closed_gap(self)),
        .slow =
            fmax(slow, self->remembers ? TINKER_STOPPED_NOISES * tinker_contact_run_speed_noise(self) : TINKER_STILL),
    };
    const guint events = run->summary.events->len;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &change.speed);
    change.speed = fmax(change.speed, TINKER_SLOWEST);
    const TinkerState *state = &run->state;
    const gboolean together = may_stop_together(self, trigger);
    gboolean done = (!together || tinker_contact_run_look_at(self, state->t, state->q, state->v, NULL) == TINKER_OK) &&
                    tinker_change_set_state(&change) == TINKER_OK;
    if (!done) tinker_change_refuse(&change, self->model->failure, error);
    if (done) {
        tinker_change_take(&change, tolerance);
        if (together) note_slowing(&change);
        done =
            tinker_change_set_state(&change) == TINKER_OK || tinker_change_refuse(&change, self->model->failure, error);
        if (done) tinker_change_note_held(&change);
        include_relative_speeds(&change);
        done = done && tinker_change_strike(&change, error);
    }
    if (done) turn_bodies(&change);
    done = done && settle_contacts(&change, error);
    if (done) name_changes(&change);
    tinker_change_note_staying(&change);
    give_alternatives(&change, events);
    if (done) turn_bodies(&change);
    if (done) note_leaving(&change);
    g_array_unref(change.touches);
    g_array_unref(change.told);
    return done;
}

/* The groups that something of touches: at a start and at a break all of them are asked. (transfer full) */
static gboolean *groups_near(const TinkerContactRun *self)
{
    const TinkerContacts *contacts = self->contacts;
    gboolean *asked = g_new0(gboolean, MAX(self->model->bodies, 1));
    for (guint i = 0; i < self->near->len; i++)
        asked[self->together[g_array_index(self->near, TinkerContactPair, i).body]] = TRUE;
    for (guint i = 0; i < contacts->closed->len; i++)
        asked[self->together[tinker_contacts_closed(contacts, i)->body]] = TRUE;
    const TinkerConstraints *all = &self->model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++) {
        int32_t body = all->unilateral[row] ? tinker_contacts_row_body(contacts, row) : -1;
        if (body >= 0) asked[self->together[body]] = TRUE;
    }
    return asked;
}

/* Counts the changes that follow on one another at one instant, each later than the one before by a shortest step. */
static void note_instant(TinkerContactRun *self)
{
    const double t = self->run->state.t;
    self->at_once = fabs(t - self->changed) <= TINKER_ONE_INSTANT * fabs(t) ? self->at_once + 1 : 0;
    self->changed = t;
}

/* Moves everything on by rounding of its place, and more each time, up to what a step may miss it by. */
static void pass_edge(TinkerContactRun *self, int times)
{
    TinkerIslandRun *run = self->run;
    double extent, speed;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    const double way = fmin(ldexp(TINKER_PAST_EDGE, 2 * MIN(times, 100)), self->run->choice.tolerance) * extent;
    const double moment = speed > 0 ? way / speed : 0;
    for (int32_t i = 0; i < run->system.system.size; i++)
        run->state.q[i] += moment * run->state.v[i];
}

gboolean tinker_contact_run_change(TinkerContactRun *self, const TinkerTrigger *trigger, double tolerance, double slow,
                                   GError **error)
{
    double reach = fmax(tolerance, 2 * TINKER_TOUCHING); /* of the other side of a guide */
    note_instant(self);
    if (tinker_model_set_time(self->model, self->run->state.t) != TINKER_OK)
        return tinker_island_run_fail(self->run, self->model->failure, error);
    tinker_model_set_state(self->model, self->run->state.q, self->run->state.v);
    tinker_contact_run_note_turn(self, trigger);
    const int times = tinker_contact_run_stays_at_edge(self, trigger);
    if (times > 0) {
        pass_edge(self, times);
        tinker_model_set_state(self->model, self->run->state.q, self->run->state.v);
    }
    if (trigger->kind == TINKER_TRIGGER_GAP && trigger->row < 0)
        reach += 2 * fabs(tinker_contact_place(self->contacts, trigger->body, trigger->plate).gap);
    tinker_contact_run_find_near(self, self->run->state.q, self->run->state.q, reach);
    tinker_contact_run_find_together(self);
    const gboolean of_one = trigger->kind > TINKER_TRIGGER_BLOW;
    /* what lands side by side does so at one instant */
    if (of_one && !(self->many && self->at_once >= FEW_AT_ONCE))
        return change_group(self, trigger, self->together[trigger->body], tolerance, slow, error);
    g_autofree gboolean *asked = groups_near(self);
    if (of_one) asked[self->together[trigger->body]] = TRUE;
    for (int32_t group = 0; group < self->model->bodies; group++)
        if (asked[group] && !change_group(self, trigger, group, tolerance, slow, error)) return FALSE;
    return TRUE;
}

/* Whether anything slides with friction. */
static gboolean rubs(const TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->mode != TINKER_CONTACT_STICK && contact->friction != 0) return TRUE;
    }
    return FALSE;
}

gboolean tinker_contact_run_jam(TinkerContactRun *self)
{
    const TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    const double t = self->run->state.t, before = self->last_impact;
    g_autoptr(GError) error = NULL;
    if (self->jammed == t || !tinker_method_is_adaptive(self->run->choice.method) || !rubs(self->contacts))
        return FALSE;
    self->jammed = t;
    self->jams = TRUE;
    const gboolean done = tinker_contact_run_change(self, &none, tinker_contact_run_closed_gap(self), 0, &error);
    self->jams = FALSE;
    tinker_method_restart(self->run->choice.method, self->run->stepper);
    return done && (self->last_impact == t && before != t);
}

/* Whether an impact at this instant threw something at what it touches, so that it approaches that only now. */
static gboolean approaches_after_impact(TinkerContactRun *self, double tolerance)
{
    TinkerIslandRun *run = self->run;
    double extent, speed;
    if (self->last_impact != run->state.t || tinker_model_set_time(self->model, run->state.t) != TINKER_OK)
        return FALSE;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    tinker_model_set_state(self->model, run->state.q, run->state.v);
    for (guint i = 0; i < self->near->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->near, TinkerContactPair, i);
        const TinkerContactPlace place = tinker_contact_place(self->contacts, pair->body, pair->plate);
        if (place.normal_speed < -TINKER_START_SLOW * speed && fabs(place.gap) <= tolerance &&
            tinker_contact_is_over(self->contacts, pair->plate, &place, tolerance))
            return TRUE;
    }
    return FALSE;
}

gboolean tinker_contact_run_change_until_parting(TinkerContactRun *self, const TinkerTrigger *trigger, double tolerance,
                                                 double slow, GError **error)
{
    const TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    if (!tinker_contact_run_change(self, trigger, tolerance, slow, error)) return FALSE;
    for (int blows = 0; blows < MOST_FOLLOWING && approaches_after_impact(self, tolerance); blows++)
        if (!tinker_contact_run_change(self, &none, tolerance, slow, error)) return FALSE;
    return TRUE;
}
