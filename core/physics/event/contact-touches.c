/* What touches at an event, and where it is. */
#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

TinkerStatus tinker_change_set_state(const TinkerContactChange *change)
{
    TinkerIslandRun *run = change->run->run;
    TinkerStatus status = tinker_model_set_time(change->model, run->state.t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(change->model, run->state.q, run->state.v);
    return change->model->constraints.rows > 0 ? tinker_constraints_evaluate(change->model) : TINKER_OK;
}

gboolean tinker_change_hardly_slides(const TinkerContactChange *change, const TinkerTouch *at)
{
    if (tinker_change_repeats(change)) return FALSE;
    if (!tinker_contacts_is_gap(change->contacts, &at->contact)) return FALSE;
    const double least = fmax(TINKER_SLOW_SLIDE * change->speed, change->least_rise);
    if (fabs(at->place.tangential_speed) > least) return FALSE;
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->struck) return TRUE;
    return FALSE;
}

gboolean tinker_change_is_trigger(const TinkerContactChange *change, const TinkerTouch *of)
{
    const TinkerTrigger *trigger = &change->trigger;
    if (trigger->kind <= TINKER_TRIGGER_BLOW || trigger->row != of->row) return FALSE;
    return of->row >= 0 || (trigger->body == of->contact.body && trigger->plate == of->contact.plate);
}

static TinkerContactPlace place_of(const TinkerContactChange *change, const TinkerTouch *at)
{
    if (at->row < 0) return tinker_contact_place(change->contacts, at->contact.body, at->contact.plate);
    const TinkerModel *model = change->model;
    return (TinkerContactPlace){.gap = -model->constraints.own_g[at->row],
                                .normal_speed = at->held ? 0 : -tinker_constraints_own_rate(model, at->row)};
}

void tinker_change_measure(TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++)
        tinker_touch(change, i)->place = place_of(change, tinker_touch(change, i));
}

double tinker_change_speed_scale(const TinkerContactChange *change, const TinkerTouch *at)
{
    const double *g = change->model->constant_acceleration + 2 * at->contact.body;
    return fmax(change->speed, sqrt(hypot(g[0], g[1]) * change->contacts->thickness));
}

gboolean tinker_change_approaches(const TinkerContactChange *change, const TinkerContactPair *pair)
{
    const TinkerTouch of = {.contact = {.body = pair->body, .plate = pair->plate}, .row = pair->row};
    return place_of(change, &of).normal_speed < -TINKER_STILL * change->speed;
}

static gboolean ends_now(const TinkerContactChange *change, const TinkerTouch *of)
{
    return tinker_change_is_trigger(change, of) &&
           (change->trigger.kind == TINKER_TRIGGER_END || change->trigger.kind == TINKER_TRIGGER_BEGINNING);
}

/* What was not decided yet counts as open before; what was at the limit of sticking stuck. */
static void take_closed(TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerTouch taken = {.contact = *tinker_contacts_closed(contacts, i), .row = -1};
        if (change->run->together[taken.contact.body] != change->group) continue;
        taken.was = taken.contact.mode == TINKER_CONTACT_SMOOTH ? TINKER_CONTACT_OPEN : taken.contact.mode;
        if (taken.contact.at_limit) {
            taken.limit = taken.was == TINKER_CONTACT_SLIP_FORWARD ? 1 : -1;
            taken.was = TINKER_CONTACT_STICK;
            taken.contact.at_limit = FALSE;
        }
        taken.place = place_of(change, &taken);
        taken.at_end = ends_now(change, &taken);
        g_array_append_val(change->touches, taken);
    }
}

/* Whether the event is that this one closes. What parts no more by its acceleration is closed only where it has not
 * come clear of its plate by then: else its gap tells when it is back. */
static gboolean meets_now(const TinkerContactChange *change, const TinkerTouch *of)
{
    if (!tinker_change_is_trigger(change, of)) return FALSE;
    if (change->trigger.kind == TINKER_TRIGGER_LEAVING)
        return of->row >= 0 || fabs(of->place.gap) <= tinker_contact_run_touching(change->run);
    return change->trigger.kind == TINKER_TRIGGER_GAP;
}

/* One that has just opened is watched by its acceleration, so that it is not taken for closed on the way; a blow on
 * another body may throw it back all the same. */
static gboolean is_closed(const TinkerContactChange *change, const TinkerTouch *of, double tolerance)
{
    const TinkerContactPair pair = {of->contact.body, of->contact.plate, of->row};
    double noise = TINKER_STILL * change->speed;
    if (fabs(of->place.gap) > tolerance || of->place.normal_speed > noise) return FALSE;
    return of->place.normal_speed < -noise || !tinker_contact_run_leaves(change->run, &pair);
}

/* One that was not closed, and what resists its rolling. */
static void add_touch(TinkerContactChange *change, const TinkerTouch *touch)
{
    const int32_t resistance = change->contacts->plates[touch->contact.plate].resistance;
    g_array_append_val(change->touches, *touch);
    if (resistance == 0) return;
    TinkerTouch resisting = {
        .contact = {.body = touch->contact.body, .plate = resistance}, .row = -1, .leaves = touch->leaves};
    resisting.place = place_of(change, &resisting);
    g_array_append_val(change->touches, resisting);
}

static void take_open(TinkerContactChange *change, double tolerance)
{
    const TinkerContactRun *self = change->run;
    for (guint i = 0; i < self->near->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->near, TinkerContactPair, i);
        if (self->together[pair->body] != change->group) continue;
        TinkerTouch taken = {.contact = {.body = pair->body, .plate = pair->plate}, .row = -1};
        if (tinker_contact_run_is_across(self, pair->body, pair->plate)) continue;
        taken.place = place_of(change, &taken);
        gboolean guided = tinker_contacts_is_guided(self->contacts, pair->body, pair->plate);
        double near = guided ? fmax(tolerance, 2 * TINKER_TOUCHING) : tolerance;
        const gboolean at = fabs(taken.place.gap) <= near &&
                            tinker_contact_is_over(self->contacts, pair->plate, &taken.place, tolerance);
        const gboolean meets = (at && is_closed(change, &taken, near)) || meets_now(change, &taken);
        /* what it was thrown away from within no time; take_leaving() takes what is watched as leaving */
        taken.leaves = change->rattles && at && !meets && fabs(taken.place.gap) <= tolerance &&
                       !tinker_contact_run_leaves(self, pair);
        if (meets || taken.leaves) add_touch(change, &taken);
    }
}

/* Rows that hold in one direction only are left out of the constraints while they are decided upon. One that is as long
 * as it may be and loosens, as at a start, a blow may tauten at the same instant. */
static void take_rows(TinkerContactChange *change, double tolerance)
{
    const TinkerContactRun *self = change->run;
    const TinkerConstraints *all = &change->model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++) {
        TinkerTouch taken = {.contact = {.body = tinker_contacts_row_body(self->contacts, row)}, .row = row};
        if (!all->unilateral[row] || taken.contact.body < 0 || self->together[taken.contact.body] != change->group)
            continue;
        taken.was = all->slack[row] ? TINKER_CONTACT_OPEN : TINKER_CONTACT_SLIP_FORWARD;
        tinker_constraints_set_slack(change->model, row, TRUE);
        taken.place = place_of(change, &taken);
        const gboolean closed =
            taken.was != TINKER_CONTACT_OPEN || is_closed(change, &taken, tolerance) || meets_now(change, &taken);
        taken.leaves = !closed && fabs(taken.place.gap) <= tolerance;
        if (closed || taken.leaves) g_array_append_val(change->touches, taken);
    }
}

/* Whether joints tie one of the two to others. */
static gboolean is_tied(const TinkerContactChange *change, const TinkerContactPair *pair)
{
    const gboolean *held = change->contacts->held;
    const TinkerTouchingPair *shapes = change->contacts->plates[pair->plate].pair;
    for (int k = 0; shapes != NULL && k < 2; k++)
        if (shapes->point[k] < change->model->bodies && held[shapes->point[k]]) return TRUE;
    return held[pair->body];
}

/* Within this (m) of a plate that it has just left a body is there for a blow: rounding, and, of what joints tie
 * together, no more than what a method that holds a tolerance makes of a place. There a blow on one throws back many at
 * once; of loose bodies one is struck after the other, and what they do then depends on the order. */
static double left_gap(const TinkerContactChange *change, double tolerance)
{
    const TinkerIslandRun *run = change->run->run;
    double extent, speed;
    if (!tinker_method_is_adaptive(run->choice.method)) return tolerance;
    run->system.system.scales(run->system.system.context, run->state.q, run->state.v, &extent, &speed);
    return fmax(tolerance, TINKER_LEFT * run->choice.tolerance * extent);
}

/* What has just opened, neither closes nor is clear of its plate. If a blow on another body that throws it back were
 * followed by one of its own, that might throw back the other, and so on without end. */
static void take_leaving(TinkerContactChange *change, double tolerance)
{
    const TinkerContactRun *self = change->run;
    const double tied = self->leaving->len > 0 ? left_gap(change, tolerance) : 0;
    for (guint i = 0; i < self->leaving->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->leaving, TinkerContactPair, i);
        if (pair->row >= 0 || self->together[pair->body] != change->group) continue;
        TinkerTouch taken = {.contact = {.body = pair->body, .plate = pair->plate}, .row = -1, .leaves = TRUE};
        taken.place = place_of(change, &taken);
        const gboolean closes = is_closed(change, &taken, tolerance) || meets_now(change, &taken);
        const double near = is_tied(change, pair) ? tied : tolerance;
        if (!closes && fabs(taken.place.gap) <= near &&
            tinker_contact_is_over(self->contacts, pair->plate, &taken.place, tolerance))
            add_touch(change, &taken);
    }
}

void tinker_change_drop(TinkerContactChange *change)
{
    guint kept = 0;
    for (guint i = 0; i < change->touches->len; i++)
        if (!tinker_touch(change, i)->dropped) *tinker_touch(change, kept++) = *tinker_touch(change, i);
    g_array_set_size(change->touches, kept);
}

void tinker_change_take(TinkerContactChange *change, double tolerance)
{
    take_closed(change);
    take_open(change, tolerance);
    take_leaving(change, tolerance);
    take_rows(change, tolerance);
}

/* Whether any constraint holds in both directions. */
static gboolean is_any_rigid(const TinkerConstraints *all)
{
    for (int32_t row = 0; row < all->rows; row++)
        if (all->unilateral == NULL || !all->unilateral[row]) return TRUE;
    return FALSE;
}

/* Whether a constraint attaches to a support that moves. */
static gboolean is_any_carried(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t e = 0; model->moving_supports > 0 && e < all->entries; e++)
        if (all->points[e] >= model->first_support && tinker_model_attachment(model, all->points[e])->moving)
            return TRUE;
    return FALSE;
}

void tinker_change_note_held(TinkerContactChange *change)
{
    const TinkerModel *model = change->model;
    if (model->constraints.prescribed || is_any_carried(model) || !is_any_rigid(&model->constraints)) return;
    for (guint i = 0; i < change->touches->len; i++) {
        TinkerTouch *at = tinker_touch(change, i);
        if (at->row < 0) continue;
        at->held = tinker_contacts_row_is_held(change->contacts, at->row);
        at->place = place_of(change, at);
    }
}
