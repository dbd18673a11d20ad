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
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"

#define MOST_JAMS 8

/* Steps 3 and 4 ---------------------------------------------------------------------------------------------------- */

/* Whether the event is that this speed along the top has come to 0: the method makes no less of it. */
static gboolean has_stopped(const TinkerContactChange *change, double speed)
{
    const TinkerTriggerKind kind = change->trigger.kind;
    double noise = fmax(TINKER_STOPPED, TINKER_STOPPED_NOISES * tinker_contact_run_speed_noise(change->run));
    return (kind == TINKER_TRIGGER_SPEED || kind == TINKER_TRIGGER_STARTING) && fabs(speed) <= noise * change->speed;
}

/* Whether a corner slides, behind a blow, by too little to be seen. Blocks that rock down to rest strike with their
 * corners by turns and slide a little in between, infinitely often in finite time. */
static gboolean hardly_slides(const TinkerContactChange *change, const TinkerTouch *at)
{
    if (!tinker_contacts_is_gap(change->contacts, &at->contact)) return FALSE;
    if (fabs(at->place.tangential_speed) > TINKER_SLOW_SLIDE * change->speed) return FALSE;
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->struck) return TRUE;
    return FALSE;
}

/* Which way it slides; 0 where it is slow enough to stick. An event says that it stops, or that it begins. */
static int8_t sliding_of(const TinkerContactChange *change, guint number, double acceleration)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const TinkerPlate *plate = tinker_touch_plate(change, number);
    double speed = at->place.tangential_speed;
    if (plate == NULL) return 1; /* without friction either way is the same */
    if (tinker_change_is_trigger(change, at) && !at->struck) {
        if (change->forced && change->trigger.kind == TINKER_TRIGGER_FORWARD) return -1;
        if (change->forced && change->trigger.kind == TINKER_TRIGGER_BACKWARD) return 1;
        if (has_stopped(change, speed)) return 0;
    }
    if (plate->static_friction == 0) return 1;
    if (hardly_slides(change, at)) return 0;
    /* what falls over the length of the plate is a scale for what is the only thing that moves */
    double length = plate->gap != NULL ? change->contacts->thickness : plate->half_width + plate->half_height;
    double scale = change->speed + sqrt(acceleration * length);
    if (fabs(speed) > change->slow * scale) return speed > 0 ? 1 : -1;
    /* one that has just begun to slip goes on, until an event of its own says that it stops; what slipped clearly stops
     * now */
    gboolean begins = at->contact.starts || !change->run->starts_low;
    gboolean stops = tinker_change_is_trigger(change, at) || at->struck || !begins;
    if (stops || at->was == TINKER_CONTACT_OPEN || at->was == TINKER_CONTACT_STICK) return 0;
    return at->was == TINKER_CONTACT_SLIP_FORWARD ? 1 : -1;
}

static gboolean goes_over_end(const TinkerContactChange *change, const TinkerTouch *at)
{
    double outwards = at->place.along > 0 ? at->place.along_speed : -at->place.along_speed;
    return at->at_end && outwards > TINKER_STILL * change->speed;
}

/* What parts, or goes over an end of its top, is not asked. */
static void drop_parting(TinkerContactChange *change)
{
    for (guint i = change->touches->len; i-- > 0;) {
        TinkerTouch *at = tinker_touch(change, i);
        gboolean over = goes_over_end(change, at);
        at->dropped = over || at->place.normal_speed > TINKER_STILL * change->speed;
        if (!at->dropped) continue;
        if (over)
            tinker_change_add_event(change, "end", at);
        else if (at->was != TINKER_CONTACT_OPEN)
            tinker_change_add_event(change, at->row < 0 ? "take-off" : "slack", at);
        else if (at->struck)
            tinker_change_add_event(change, at->row < 0 ? "impact" : "jerk", at);
    }
    tinker_change_drop(change);
}

static TinkerContactResult ask_modes(TinkerContactChange *change, TinkerContactLaws *laws, double scale)
{
    for (guint i = 0; i < laws->count; i++) {
        laws->sliding[i] = sliding_of(change, i, scale);
        const TinkerPlate *plate = tinker_touch_plate(change, i);
        laws->first[i] = plate != NULL ? plate->static_friction : 0;
        laws->second[i] = plate != NULL ? plate->dynamic_friction : 0;
    }
    TinkerClosedContacts closed = {
        (int32_t)laws->count,       laws->delassus, laws->pairs, laws->sliding, laws->first, laws->second,
        TINKER_FORCE_NOISE * scale, laws->motion};
    TinkerContactResult result = tinker_contact_modes(&closed, laws->modes, laws->answers);
    if (result != TINKER_CONTACT_NO_ACCELERATION) return result;
    g_autofree double *velocity = g_try_new(double, 2 * laws->count);
    if (velocity == NULL) return TINKER_CONTACT_NO_MEMORY;
    for (guint i = 0; i < laws->count; i++) {
        velocity[2 * i] = tinker_touch(change, i)->place.normal_speed;
        velocity[2 * i + 1] = tinker_touch(change, i)->place.tangential_speed;
    }
    const TinkerContactResult jam = tinker_contact_jam(&closed, velocity, laws->answers);
    if (jam == TINKER_CONTACT_NO_MEMORY) return jam;
    return jam == TINKER_CONTACT_SOLVED ? result : TINKER_CONTACT_GAVE_UP;
}

/* A contact whose force has just come to 0 opens, unless something presses it again. */
static gboolean lets_go(const TinkerContactChange *change, const TinkerTouch *at, double force, double noise)
{
    return tinker_change_is_trigger(change, at) && change->trigger.kind == TINKER_TRIGGER_NORMAL &&
           force <= TINKER_LET_GO * noise;
}

static void note_modes(TinkerContactChange *change, const TinkerContactLaws *laws, double scale)
{
    for (guint i = 0; i < laws->count; i++) {
        TinkerTouch *at = tinker_touch(change, i);
        double mass = change->model->mass[at->contact.body];
        at->contact.mode = laws->modes[i];
        if (!at->struck) at->contact.normal = laws->answers[2 * i];
        at->contact.base_normal = laws->answers[2 * i];
        at->contact.base_friction = laws->answers[2 * i + 1];
        if (lets_go(change, at, laws->answers[2 * i], mass * scale)) at->contact.mode = TINKER_CONTACT_OPEN;
    }
}

/* Guides ----------------------------------------------------------------------------------------------------------- */

/* What guides the body together with a touch; NULL for nothing. */
static TinkerTouch *other_side(const TinkerContactChange *change, const TinkerTouch *at)
{
    const gboolean top = at->row < 0 && !tinker_contacts_is_gap(change->contacts, &at->contact);
    const gboolean guides = top && change->contacts->plate_count > 1;
    for (guint i = 0; guides && i < change->touches->len; i++) {
        TinkerTouch *other = tinker_touch(change, i);
        if (other != at && other->row < 0 && other->contact.body == at->contact.body &&
            other->contact.plate < change->contacts->plate_count &&
            tinker_contacts_are_guide(change->contacts, at->contact.body, at->contact.plate, other->contact.plate))
            return other;
    }
    return NULL;
}

/* A motion along one top as the other sees it. */
static TinkerContactMode mirrored(TinkerContactMode mode)
{
    if (mode == TINKER_CONTACT_SLIP_FORWARD) return TINKER_CONTACT_SLIP_BACKWARD;
    return mode == TINKER_CONTACT_SLIP_BACKWARD ? TINKER_CONTACT_SLIP_FORWARD : mode;
}

static gboolean has_let_go(const TinkerContactChange *change, const TinkerTouch *at)
{
    return tinker_change_is_trigger(change, at) && change->trigger.kind == TINKER_TRIGGER_NORMAL && !at->struck;
}

/* Which of two sides of a guide presses: not the one whose force has just come to 0, else the one that is pressed
 * harder, else the one that was. */
static gboolean presses(const TinkerContactChange *change, const TinkerTouch *at, const TinkerTouch *other)
{
    if (has_let_go(change, at) != has_let_go(change, other)) return has_let_go(change, other);
    if (at->contact.base_normal != other->contact.base_normal)
        return at->contact.base_normal > other->contact.base_normal;
    if ((at->was != TINKER_CONTACT_OPEN) != (other->was != TINKER_CONTACT_OPEN)) return at->was != TINKER_CONTACT_OPEN;
    return at < other;
}

/* One side of each guide stays closed, whatever the laws say of each by itself; what slides goes on as it did. */
static void choose_sides(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        TinkerTouch *at = tinker_touch(change, i), *other = other_side(change, at);
        if (other == NULL || !presses(change, at, other)) continue;
        TinkerContactMode along = has_let_go(change, other) && other->was != TINKER_CONTACT_STICK
                                      ? mirrored(other->was)
                                      : mirrored(other->contact.mode);
        if (at->contact.mode == TINKER_CONTACT_OPEN || has_let_go(change, other)) at->contact.mode = along;
        other->contact.mode = TINKER_CONTACT_OPEN;
    }
}

/* Whether it passes from one side of a guide to the other, which is no event. */
static gboolean changes_side(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerTouch *other = other_side(change, at);
    gboolean was = at->was != TINKER_CONTACT_OPEN, is = at->contact.mode != TINKER_CONTACT_OPEN;
    return other != NULL && was != is && (other->was != TINKER_CONTACT_OPEN) == is &&
           (other->contact.mode != TINKER_CONTACT_OPEN) == was;
}

static gboolean decide(TinkerContactChange *change, GError **error)
{
    TinkerContactResult result = TINKER_CONTACT_NO_ACCELERATION;
    for (int jams = 0; jams <= MOST_JAMS; jams++) {
        double scale;
        g_auto(TinkerContactLaws) laws = {0};
        drop_parting(change);
        if (change->touches->len == 0) return TRUE;
        if (tinker_contact_laws_init(&laws, change) != TINKER_OK ||
            !tinker_change_accelerations(change, laws.pairs, &scale))
            return tinker_change_refuse(change, change->model->failure, error);
        result = ask_modes(change, &laws, scale);
        if (result == TINKER_CONTACT_SOLVED) {
            note_modes(change, &laws, scale);
            choose_sides(change);
            return TRUE;
        }
        if (result != TINKER_CONTACT_NO_ACCELERATION) break;
        tinker_change_add_event(change, "jam", tinker_touch(change, 0));
        if (!tinker_change_push_all(change, laws.answers))
            return tinker_change_refuse(change, change->model->failure, error);
    }
    return tinker_change_refuse_laws(
        change, result, _("no motion satisfies the laws of friction for all bodies that touch there"), error);
}

/* After it --------------------------------------------------------------------------------------------------------- */

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
        if (at->row >= 0 || tinker_contacts_is_gap(change->contacts, &at->contact) || changes_side(change, at))
            continue;
        const gboolean pushed = at->struck || at->contact.mode != TINKER_CONTACT_OPEN;
        if (pushed && at->contact.normal >= hardest[at->contact.body])
            change->run->orientation[at->contact.body] = tinker_touch_plate(change, i)->orientation;
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
 * another body throws back is watched by its gap again. */
static void note_leaving(TinkerContactChange *change)
{
    GArray *leaving = change->run->leaving;
    if (leaving->len > 0 && tinker_change_set_state(change) != TINKER_OK) return;
    for (guint i = leaving->len; i-- > 0;) {
        const TinkerContactPair *pair = &g_array_index(leaving, TinkerContactPair, i);
        const TinkerTouch of = {.contact = {.body = pair->body, .plate = pair->plate}, .row = pair->row};
        if (tinker_change_is_trigger(change, &of) || tinker_change_approaches(change, pair) ||
            was_thrown_back(change, pair))
            g_array_remove_index_fast(leaving, i);
    }
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        TinkerContactPair pair = {at->contact.body, at->contact.plate, at->row};
        gboolean left = change->trigger.kind == TINKER_TRIGGER_LEAVING && tinker_change_is_trigger(change, at);
        gboolean parts = at->contact.mode == TINKER_CONTACT_OPEN && !left && !changes_side(change, at);
        gboolean held = other_side(change, at) != NULL && (at->was == TINKER_CONTACT_OPEN || at->struck);
        if (parts && !held && !tinker_contact_run_leaves(change->run, &pair)) g_array_append_val(leaving, pair);
    }
}

static void name_change(TinkerContactChange *change, guint number)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const TinkerPlate *plate = tinker_touch_plate(change, number);
    gboolean landed =
        at->struck || (tinker_change_is_trigger(change, at) && change->trigger.kind == TINKER_TRIGGER_GAP);
    if (changes_side(change, at)) return;
    const char *name = plate != NULL ? name_of_change(at->was, at->contact.mode, landed)
                                     : name_of_row_change(at->was, at->contact.mode, landed);
    if (name == NULL || (plate != NULL && plate->static_friction == 0 && g_str_equal(name, "reversal"))) return;
    tinker_change_add_event(change, name, at);
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
        if (contacts->group[tinker_contacts_closed(contacts, i)->body] == change->group)
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

/* Shares of a load --------------------------------------------------------------------------------------------------
 */

static gboolean keeps_laws(const TinkerContacts *contacts, const TinkerContact *contact)
{
    double most = contacts->plates[contact->plate].static_friction * contact->normal;
    return contact->normal >= 0 && (contact->mode != TINKER_CONTACT_STICK || fabs(contact->friction) <= most);
}

/* Where contacts hold bodies more than once: whether the even share, that of least norm, keeps the laws. It is taken
 * where it does; else the share that the laws gave, which may stand at a limit. */
static gboolean share_evenly(TinkerContactChange *change)
{
    TinkerContactRun *self = change->run;
    TinkerContacts *contacts = self->contacts;
    const TinkerState *state = &self->run->state;
    gboolean even = TRUE;
    g_autofree TinkerContact *kept = g_memdup2(contacts->closed->data, contacts->closed->len * sizeof(TinkerContact));
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contacts->group[contact->body] == change->group) contact->base_normal = contact->base_friction = 0;
    }
    tinker_contacts_take_shares(contacts);
    if (tinker_contact_run_look_at(self, state->t, state->q, state->v) != TINKER_OK) even = FALSE;
    for (guint i = 0; even && i < contacts->closed->len; i++)
        if (contacts->group[kept[i].body] == change->group)
            even = keeps_laws(contacts, tinker_contacts_closed(contacts, i));
    if (even) return TRUE;
    memcpy(contacts->closed->data, kept, contacts->closed->len * sizeof(TinkerContact));
    tinker_contacts_take_shares(contacts);
    return FALSE;
}

/* Whether nothing determines how the closed contacts share their load. */
static gboolean shares_load(const TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->run->contacts;
    for (guint i = 0; i < contacts->blocks->len; i++) {
        const TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        int32_t contact = g_array_index(contacts->rows, TinkerContactRow, (guint)block->first).contact;
        if (contacts->group[tinker_contacts_closed(contacts, (guint)contact)->body] == change->group)
            return !tinker_contact_block_is_full(block);
    }
    return FALSE;
}

/* Steps 3 and 4, and what is closed from here on. A contact that reaches the limit of sticking only by its share does
 * not slip where another share holds it. */
static gboolean settle_contacts(TinkerContactChange *change, GError **error)
{
    gboolean limit = change->trigger.kind == TINKER_TRIGGER_FORWARD || change->trigger.kind == TINKER_TRIGGER_BACKWARD;
    change->forced = !(limit && shares_load(change));
    if (!decide(change, error) || !close_contacts(change, error)) return FALSE;
    gboolean even = !shares_load(change) || share_evenly(change);
    if (change->forced || even) return TRUE;
    change->forced = TRUE;
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->row >= 0)
            tinker_constraints_set_slack(change->model, tinker_touch(change, i)->row, TRUE);
    if (tinker_change_set_state(change) != TINKER_OK)
        return tinker_change_refuse(change, change->model->failure, error);
    if (!decide(change, error) || !close_contacts(change, error)) return FALSE;
    if (shares_load(change)) share_evenly(change);
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

/* Takes what touches of one group through all four steps. */
static gboolean change_group(TinkerContactRun *self, const TinkerTrigger *trigger, int32_t group, double tolerance,
                             double slow, GError **error)
{
    TinkerIslandRun *run = self->run;
    double extent;
    TinkerContactChange change = {
        .run = self,
        .model = self->model,
        .contacts = self->contacts,
        .acceleration = self->force,
        .trigger = *trigger,
        .group = group,
        .touches = g_array_new(FALSE, TRUE, sizeof(TinkerTouch)),
        .told = g_array_new(FALSE, FALSE, sizeof(TinkerToldEvent)),
        .tolerance = fmin(tolerance, tinker_contact_run_closed_gap(self)),
        .slow =
            fmax(slow, self->remembers ? TINKER_STOPPED_NOISES * tinker_contact_run_speed_noise(self) : TINKER_STILL),
    };
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &change.speed);
    gboolean done =
        tinker_change_set_state(&change) == TINKER_OK || tinker_change_refuse(&change, self->model->failure, error);
    if (done) {
        tinker_change_take(&change, tolerance);
        include_relative_speeds(&change);
        done = tinker_change_set_state(&change) == TINKER_OK && tinker_change_strike(&change, error);
    }
    if (done) turn_bodies(&change);
    done = done && settle_contacts(&change, error);
    for (guint i = 0; done && i < change.touches->len; i++)
        name_change(&change, i);
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
        asked[contacts->group[g_array_index(self->near, TinkerContactPair, i).body]] = TRUE;
    for (guint i = 0; i < contacts->closed->len; i++)
        asked[contacts->group[tinker_contacts_closed(contacts, i)->body]] = TRUE;
    const TinkerConstraints *all = &self->model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++) {
        int32_t body = all->unilateral[row] ? tinker_contacts_row_body(contacts, row) : -1;
        if (body >= 0) asked[contacts->group[body]] = TRUE;
    }
    return asked;
}

gboolean tinker_contact_run_change(TinkerContactRun *self, const TinkerTrigger *trigger, double tolerance, double slow,
                                   GError **error)
{
    double reach = fmax(tolerance, 2 * TINKER_TOUCHING); /* of the other side of a guide */
    if (tinker_model_set_time(self->model, self->run->state.t) != TINKER_OK)
        return tinker_island_run_fail(self->run, self->model->failure, error);
    tinker_model_set_state(self->model, self->run->state.q, self->run->state.v);
    if (trigger->kind == TINKER_TRIGGER_GAP && trigger->row < 0)
        reach += 2 * fabs(tinker_contact_place(self->contacts, trigger->body, trigger->plate).gap);
    tinker_contact_run_find_near(self, self->run->state.q, self->run->state.q, reach);
    if (trigger->kind != TINKER_TRIGGER_NONE)
        return change_group(self, trigger, self->contacts->group[trigger->body], tolerance, slow, error);
    g_autofree gboolean *asked = groups_near(self);
    for (int32_t group = 0; group < self->model->bodies; group++)
        if (asked[group] && !change_group(self, trigger, group, tolerance, slow, error)) return FALSE;
    return TRUE;
}
