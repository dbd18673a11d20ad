/* What touches at an event, where it is, and how it answers to pushes. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/force/forces.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* The largest m whose 2m x 2m entries an int32_t counts. */
#define MOST_TOUCHES 23170

/* Whether an event of this kind was told of the pair already; notes that it is now. */
static gboolean was_told(TinkerContactChange *change, const char *kind, const TinkerTouchingPair *pair)
{
    for (guint i = 0; pair != NULL && i < change->told->len; i++) {
        const TinkerToldEvent *told = &g_array_index(change->told, TinkerToldEvent, i);
        if (told->pair == pair && g_str_equal(told->kind, kind)) return TRUE;
    }
    const TinkerToldEvent now = {kind, pair, NULL};
    if (pair != NULL) g_array_append_val(change->told, now);
    return FALSE;
}

/* "A, B" of a body and what it touches (transfer full). What leaves an end is what has the tip, whichever body was
 * placed first; off a support goes the body. */
static char *names_of(const TinkerContactChange *change, const char *kind, const TinkerTouch *of)
{
    const TinkerModel *model = change->model;
    const TinkerPlate *plate = &change->contacts->plates[of->contact.plate];
    const char *body = tinker_scene_block_name(model->scene, model->body_blocks[of->contact.body]),
               *other = tinker_scene_block_name(model->scene, plate->block);
    if (tinker_contacts_is_pin(change->contacts, &of->contact)) return g_strdup(other);
    const gboolean turned_round = g_str_equal(kind, "end") && plate->gap != NULL && plate->gap->tip_of == 1 &&
                                  plate->pair->point[1] < model->bodies;
    return turned_round ? g_strdup_printf("%s, %s", other, body) : g_strdup_printf("%s, %s", body, other);
}

void tinker_change_add_event(TinkerContactChange *change, const char *kind, const TinkerTouch *of)
{
    TinkerScene *scene = change->model->scene;
    if (of->row >= 0) {
        tinker_island_run_add_event(change->run->run, kind,
                                    tinker_scene_block_name(scene, change->model->constraints.blocks[of->row]));
        return;
    }
    if (was_told(change, kind, change->contacts->plates[of->contact.plate].pair)) return;
    g_autofree char *names = names_of(change, kind, of);
    tinker_island_run_add_event(change->run->run, kind, names);
    const GPtrArray *events = change->run->run->summary.events;
    TinkerEvent *event = g_ptr_array_index(events, events->len - 1);
    event->turns = tinker_contacts_resists(change->contacts, &of->contact);
    const TinkerTouchingPair *pair = change->contacts->plates[of->contact.plate].pair;
    if (pair == NULL) return;
    g_array_index(change->told, TinkerToldEvent, change->told->len - 1).event = event;
}

void tinker_change_note_staying(TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    for (guint i = 0; i < change->told->len; i++) {
        const TinkerToldEvent *told = &g_array_index(change->told, TinkerToldEvent, i);
        for (guint k = 0; told->event != NULL && k < contacts->closed->len; k++)
            told->event->stays |= contacts->plates[tinker_contacts_closed(contacts, k)->plate].pair == told->pair;
    }
}

gboolean tinker_change_refuse(TinkerContactChange *change, const char *why, GError **error)
{
    return tinker_island_run_fail_step(change->run->run, why, error);
}

/* Whether what is touched goes towards the body by a prescribed motion, or is about to. */
static gboolean closes_as_prescribed(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerContacts *contacts = change->contacts;
    double along[2];
    if (at->row >= 0 || !contacts->plates[at->contact.plate].moving) return FALSE;
    tinker_contacts_along(contacts, &at->contact, change->run->run->state.v, along);
    const double own = at->place.normal_speed - along[0];
    if (fabs(own) > TINKER_STILL * change->speed) return own < 0;
    g_autofree double *at_rest = g_new0(double, change->model->coordinates);
    tinker_contacts_relative_acceleration(contacts, &at->contact, at_rest, along);
    return along[0] < 0;
}

static gboolean rubs(const TinkerContactChange *change, int32_t body)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->contact.body == body && tinker_touch_surface(change, i).static_friction > 0)
            return TRUE;
    return FALSE;
}

/* The first that something closes on by a prescribed motion, and that rubs; -1: there is none. */
static int32_t wedged_body(const TinkerContactChange *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (closes_as_prescribed(change, at) && rubs(change, at->contact.body)) return at->contact.body;
    }
    return -1;
}

gboolean tinker_change_refuse_laws(TinkerContactChange *change, TinkerContactResult result, const char *why,
                                   GError **error)
{
    const TinkerModel *model = change->model;
    const int32_t body = wedged_body(change);
    if (result != TINKER_CONTACT_NO_MEMORY && body < 0) return tinker_change_refuse(change, why, error);
    if (result != TINKER_CONTACT_NO_MEMORY) {
        g_autofree char *wedged = g_strdup_printf(
            _("%s is wedged: the motion of what closes on it is prescribed, and friction lets it go nowhere "
              "(make it smoother, or give the motion a way that leaves it room)"),
            tinker_scene_block_name(model->scene, model->body_blocks[body]));
        return tinker_change_refuse(change, wedged, error);
    }
    tinker_contacts_lack_memory(change->contacts, change->touches->len);
    return tinker_change_refuse(change, change->model->failure, error);
}

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

/* Places ----------------------------------------------------------------------------------------------------------- */

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

/* Pushes ----------------------------------------------------------------------------------------------------------- */

/* v += what an impulse (pn, pt) at a contact does. */
static void push(const TinkerContactChange *change, guint number, double pn, double pt, double *v)
{
    const TinkerTouch *at = tinker_touch(change, number);
    if (at->row >= 0) {
        tinker_contacts_pull(change->contacts, at->row, -pn, v);
        return;
    }
    tinker_contacts_begin_pushes(change->contacts);
    tinker_contacts_push_along(change->contacts, &at->contact, pn, pt, v);
    tinker_contacts_end_pushes(change->contacts, v);
}

void tinker_change_push(const TinkerContactChange *change, const double *impulses, double *v)
{
    TinkerContacts *contacts = change->contacts;
    tinker_contacts_begin_pushes(contacts);
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        const double pn = impulses[2 * i], pt = impulses[2 * i + 1];
        if (at->row >= 0 || (pn == 0 && pt == 0)) continue;
        tinker_contacts_push_along(contacts, &at->contact, pn, pt, v);
    }
    tinker_contacts_end_pushes(contacts, v);
    for (guint i = 0; i < change->touches->len; i++)
        if (tinker_touch(change, i)->row >= 0 && impulses[2 * i] != 0) push(change, i, impulses[2 * i], 0, v);
}

/* What a change of velocities (or accelerations) of all bodies is along a contact: normal and tangential. */
static void along_contact(const TinkerContactChange *change, guint number, const double *by_body, double *normal,
                          double *tangential)
{
    const TinkerTouch *at = tinker_touch(change, number);
    *tangential = 0;
    if (at->row >= 0) {
        *normal = at->held ? 0 : -tinker_constraints_own_row_times(change->model, at->row, by_body);
        return;
    }
    double along[2];
    tinker_contacts_along(change->contacts, &at->contact, by_body, along);
    *normal = along[0];
    *tangential = along[1];
}

void tinker_contact_laws_clear(TinkerContactLaws *laws)
{
    gpointer arrays[] = {laws->delassus, laws->pairs,  laws->answers,  laws->first,    laws->second,     laws->modes,
                         laws->sliding,  laws->bearer, laws->pin_size, laws->pin_free, laws->pin_answers};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    tinker_contact_reach_clear(&laws->reach);
}

/* `resists`: some may lean on others. */
static gboolean allot_laws(TinkerContactLaws *laws, gboolean resists)
{
    const gsize m = laws->count;
    laws->pairs = g_try_new0(double, 2 * m);
    laws->answers = g_try_new0(double, 2 * m);
    laws->first = g_try_new0(double, m);
    laws->second = g_try_new0(double, m);
    laws->sliding = g_try_new0(int8_t, m);
    laws->modes = g_try_new0(TinkerContactMode, m);
    if (resists) laws->bearer = g_try_new0(int32_t, m);
    if (resists && laws->bearer == NULL) return FALSE;
    return laws->pairs != NULL && laws->answers != NULL && laws->first != NULL && laws->second != NULL &&
           laws->sliding != NULL && laws->modes != NULL;
}

/* FALSE: no memory. */
static gboolean allot_pins(TinkerContactLaws *laws, const TinkerContactChange *change)
{
    const gsize m = laws->count;
    if (change->contacts->pin_count == 0) return TRUE;
    laws->pin_size = g_try_new0(double, m);
    laws->pin_free = g_try_new0(double, 2 * m);
    laws->pin_answers = m <= MOST_TOUCHES ? g_try_new0(double, 4 * m * m) : NULL;
    return laws->pin_size != NULL && laws->pin_free != NULL && laws->pin_answers != NULL;
}

/* The multipliers solved last, of all pins with friction: two numbers a touch, `stride` apart. */
static void keep_pins(const TinkerContactChange *change, double *into, gsize stride)
{
    for (guint i = 0; i < change->touches->len; i++) {
        if (!tinker_touch_is_pin(change, i)) continue;
        const double *force = change->model->constraints.lambda + tinker_touch_plate(change, i)->joint_row;
        into[2 * i * stride] = force[0];
        into[(2 * i + 1) * stride] = force[1];
    }
}

void tinker_change_note_pins(const TinkerContactChange *change, TinkerContactLaws *laws)
{
    if (laws->pin_free != NULL) keep_pins(change, laws->pin_free, 1);
}

double tinker_change_size_pins(const TinkerContactChange *change, TinkerContactLaws *laws, const double *forces)
{
    const gsize width = 2 * laws->count;
    double off = 0;
    for (guint i = 0; laws->pin_size != NULL && i < laws->count; i++) {
        if (!tinker_touch_is_pin(change, i)) continue;
        double force[2] = {laws->pin_free[2 * i], laws->pin_free[2 * i + 1]};
        for (gsize c = 0; c < 2; c++)
            for (gsize k = 0; k < width; k++)
                force[c] += laws->pin_answers[(2 * i + c) * width + k] * forces[k];
        const double size = hypot(force[0], force[1]);
        off = fmax(off, fabs(size - laws->pin_size[i]) / fmax(size, laws->pin_size[i]));
        laws->pin_size[i] = size;
    }
    return off;
}

/* Many contacts of plates alone. FALSE: no memory. */
static gboolean reach_contacts(TinkerContactLaws *laws, const TinkerContactChange *change)
{
    const gsize m = laws->count;
    if (m <= TINKER_FEW_CONTACTS || !change->contacts->held[tinker_touch(change, 0)->contact.body]) return TRUE;
    g_autofree TinkerContact *touching = g_try_new(TinkerContact, m);
    if (touching == NULL) return FALSE;
    for (guint i = 0; i < m; i++) {
        if (tinker_touch(change, i)->row >= 0 || tinker_touch_plate(change, i)->gap != NULL) return TRUE;
        touching[i] = tinker_touch(change, i)->contact;
    }
    if (!tinker_contact_reach_take(&laws->reach, change->contacts, touching, (int32_t)m)) return FALSE;
    if (laws->reach.motion.context != NULL) laws->motion = &laws->reach.motion;
    return TRUE;
}

TinkerStatus tinker_contact_laws_init(TinkerContactLaws *laws, const TinkerContactChange *change)
{
    const gsize m = change->touches->len;
    double *answer = change->contacts->column;
    *laws = (TinkerContactLaws){.count = m};
    if (!allot_laws(laws, change->contacts->resistance_count + change->contacts->pin_count > 0) ||
        !reach_contacts(laws, change))
        return tinker_contacts_lack_memory(change->contacts, m);
    for (guint i = 0; laws->bearer != NULL && i < m; i++)
        laws->bearer[i] = tinker_touch_is_pin(change, i) ? -1 : (int32_t)tinker_touch_bearer(change, i);
    if (!allot_pins(laws, change)) return tinker_contacts_lack_memory(change->contacts, m);
    if (laws->motion != NULL) return TINKER_OK;
    laws->delassus = m <= MOST_TOUCHES ? g_try_new0(double, 4 * m * m) : NULL;
    if (laws->delassus == NULL) return tinker_contacts_lack_memory(change->contacts, m);
    for (guint column = 0; column < 2 * m; column++) {
        const TinkerTouch *at = tinker_touch(change, column / 2);
        if (at->held || (column % 2 == 1 && at->row >= 0)) continue;
        memset(answer, 0, (gsize)change->model->coordinates * sizeof(double));
        push(change, column / 2, column % 2 == 0, column % 2 == 1, answer);
        for (guint i = 0; i < m; i++)
            along_contact(change, i, answer, &laws->delassus[2 * i * 2 * m + column],
                          &laws->delassus[(2 * i + 1) * 2 * m + column]);
        if (laws->pin_answers != NULL) keep_pins(change, laws->pin_answers + column, 2 * m);
    }
    return TINKER_OK;
}

gboolean tinker_change_accelerations(TinkerContactChange *change, double *pairs, double *scale)
{
    TinkerModel *model = change->model;
    double *a = change->acceleration;
    if (tinker_model_applied(model, a, FALSE) != TINKER_OK) return FALSE;
    if (model->constraints.rows > 0) tinker_constraints_accelerate(model, a);
    *scale = 0;
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        const TinkerPlate *plate = tinker_touch_plate(change, i);
        int32_t body = at->contact.body;
        along_contact(change, i, a, &pairs[2 * i], &pairs[2 * i + 1]);
        if (plate != NULL && plate->gap != NULL) {
            tinker_contacts_relative_acceleration(change->contacts, &at->contact, a, &pairs[2 * i]);
        } else if (plate != NULL) {
            const double *base = model->point_acceleration + 2 * plate->point, *n = plate->normal;
            pairs[2 * i] -= n[0] * base[0] + n[1] * base[1];
            pairs[2 * i + 1] -= n[1] * base[0] - n[0] * base[1];
        } else if (!at->held) {
            pairs[2 * i] -= tinker_constraints_own_drift(model, at->row);
        }
        *scale = fmax(*scale, hypot(pairs[2 * i], pairs[2 * i + 1]) +
                                  (fabs(model->force[2 * body]) + fabs(model->force[2 * body + 1])) *
                                      model->inverse_mass[body]);
    }
    return TRUE;
}
