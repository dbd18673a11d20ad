/* Which of the contacts that touch are closed from here on, and which of those stick: steps 3 and 4 of a change
 * (contact-change.c). */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/model/model-data.h"

#define MOST_JAMS 8
/* Of the forces of pins. */
#define MOST_PASSES 100

/* Whether it has no speed, as nearly as the method tells. */
static gboolean is_slow(const TinkerContactChange *change, double speed)
{
    const double noise = fmax(TINKER_STOPPED, TINKER_STOPPED_NOISES * tinker_contact_run_speed_noise(change->run));
    return fabs(speed) <= noise * change->speed;
}

/* Whether the event is that this speed along the top has come to 0: the method makes no less of it. What slides as one
 * stops as one, such as both corners of a box that lies: of the others it is told by what slowed them down. */
static gboolean has_stopped(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerTriggerKind kind = change->trigger.kind;
    if (kind != TINKER_TRIGGER_SPEED && kind != TINKER_TRIGGER_STARTING) return FALSE;
    if (at->row >= 0 || at->struck || !is_slow(change, at->place.tangential_speed)) return FALSE;
    return at->slows || tinker_change_is_trigger(change, at);
}

/* Of a touch that reaches the limit of sticking at the same instant as the one that the event is of. */
static const TinkerTrigger *reaches_with(const TinkerContactChange *change, const TinkerTouch *at)
{
    if (at->row >= 0) return NULL;
    return tinker_trigger_of_contact(change->run->alike, at->contact.body, at->contact.plate);
}

/* The way it would slip that has reached the limit of sticking: with the event, or before it while others held. 0: it
 * has not. */
static int8_t limit_of(const TinkerContactChange *change, const TinkerTouch *at)
{
    const TinkerTriggerKind kind = change->trigger.kind;
    if (kind != TINKER_TRIGGER_FORWARD && kind != TINKER_TRIGGER_BACKWARD) return 0;
    if (!change->forced || at->struck) return 0;
    if (tinker_change_is_trigger(change, at)) return kind == TINKER_TRIGGER_FORWARD ? -1 : 1;
    const TinkerTrigger *with = reaches_with(change, at);
    if (with != NULL) return with->kind == TINKER_TRIGGER_FORWARD ? -1 : 1;
    return is_slow(change, at->place.tangential_speed) ? at->limit : 0;
}

static gboolean anything_struck(const TinkerContactChange *change)
{
    gboolean struck = FALSE;
    for (guint i = 0; i < change->touches->len; i++)
        struck |= tinker_touch(change, i)->struck;
    return struck;
}

/* Which way it slides; 0 where it is slow enough to stick. An event says that it stops, or that it begins; `struck`: a
 * blow on any of the group does. */
static int8_t sliding_of(const TinkerContactChange *change, guint number, double acceleration, gboolean struck)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const TinkerPlate *plate = tinker_touch_plate(change, number);
    double speed = at->place.tangential_speed;
    if (plate == NULL) return 1; /* without friction either way is the same */
    if (limit_of(change, at) != 0) return limit_of(change, at);
    if (has_stopped(change, at)) return 0;
    if (tinker_touch_surface(change, number).static_friction == 0) return 1;
    if (tinker_change_hardly_slides(change, at)) return 0;
    /* what falls over the length of the plate is a scale for what is the only thing that moves */
    double length = plate->gap != NULL ? change->contacts->thickness : plate->half_width + plate->half_height;
    double scale = change->speed + sqrt(acceleration * length);
    if (fabs(speed) > change->slow * scale) return speed > 0 ? 1 : -1;
    /* one that has just begun to slip goes on, until an event of its own says that it stops, or a blow on any that it
     * is tied to has changed its speed; what slipped clearly stops now */
    gboolean begins = at->contact.starts || !change->run->starts_low;
    gboolean stops = tinker_change_is_trigger(change, at) || struck || !begins;
    if (stops || at->was == TINKER_CONTACT_OPEN || at->was == TINKER_CONTACT_STICK) return 0;
    return at->was == TINKER_CONTACT_SLIP_FORWARD ? 1 : -1;
}

/* Bodies that lean on one another stop all at once, where the event is of one of them only: whatever slides but has no
 * speed is asked which way it goes. Answers whether that is anything. */
static gboolean ask_slow(const TinkerContactChange *change, const TinkerContactLaws *laws)
{
    gboolean any = FALSE;
    for (guint i = 0; i < laws->count; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (laws->sliding[i] == 0 || tinker_touch_surface(change, i).static_friction == 0) continue;
        if (limit_of(change, at) != 0) continue;
        if (!is_slow(change, at->place.tangential_speed)) continue;
        laws->sliding[i] = 0;
        any = TRUE;
    }
    return any;
}

/* What has no speed along its top goes over the end where that is the event, unless a blow has stopped it there. */
static gboolean goes_over_end(const TinkerContactChange *change, const TinkerTouch *at)
{
    double outwards = at->place.along > 0 ? at->place.along_speed : -at->place.along_speed;
    if (!at->at_end || outwards > TINKER_STILL * change->speed) return at->at_end;
    return !anything_struck(change) && outwards >= -TINKER_STILL * change->speed;
}

/* What parts, or goes over an end of its top, is not asked. */
static void drop_parting(TinkerContactChange *change)
{
    for (guint i = change->touches->len; i-- > 0;) {
        TinkerTouch *at = tinker_touch(change, i);
        gboolean over = goes_over_end(change, at);
        at->dropped = over || at->place.normal_speed > TINKER_STILL * tinker_change_speed_scale(change, at);
        if (tinker_touch_leans(change, i)) continue; /* it goes with what it leans on */
        if (!at->dropped) continue;
        if (over)
            tinker_change_add_event(change, "end", at);
        else if (at->was != TINKER_CONTACT_OPEN)
            tinker_change_add_event(change, at->row < 0 ? "take-off" : "slack", at);
        else if (at->struck)
            tinker_change_add_event(change, at->row < 0 ? "impact" : "jerk", at);
    }
    for (guint i = 0; i < change->touches->len; i++)
        tinker_touch(change, i)->dropped = tinker_touch(change, tinker_touch_bearer(change, i))->dropped;
    tinker_change_drop(change);
}

/* What pins hold with is a share of their forces, which what they hold with changes: until that settles. */
static TinkerContactResult solve_modes(const TinkerContactChange *change, const TinkerClosedContacts *closed,
                                       TinkerContactLaws *laws)
{
    tinker_change_size_pins(change, laws, laws->answers);
    for (int pass = 0;; pass++) {
        for (guint i = 0; laws->pin_size != NULL && i < laws->count; i++)
            if (tinker_touch_is_pin(change, i))
                laws->first[i] = laws->second[i] = tinker_touch_surface(change, i).static_friction * laws->pin_size[i];
        const TinkerContactResult result = tinker_contact_modes(closed, laws->modes, laws->answers);
        if (result != TINKER_CONTACT_SOLVED || laws->pin_size == NULL || pass >= MOST_PASSES) return result;
        if (tinker_change_size_pins(change, laws, laws->answers) <= TINKER_PINS_SETTLED) return result;
    }
}

/* Those at the limit of sticking, but for pins, whose limit moves with their force, and those that were let go of. */
static gboolean is_at_limit(const TinkerContactChange *change, const TinkerContactLaws *laws, guint number)
{
    return laws->sliding[number] != 0 && limit_of(change, tinker_touch(change, number)) != 0 &&
           !tinker_touch_is_pin(change, number);
}

/* Whether anything moves there by what a solve gave. */
static gboolean moves_at_limit(const TinkerContactChange *change, const TinkerClosedContacts *closed,
                               const TinkerContactLaws *laws, TinkerContactResult result)
{
    gboolean moves = result != TINKER_CONTACT_SOLVED;
    for (guint i = 0; i < laws->count; i++)
        moves |= is_at_limit(change, laws, i) && closed->relative[2 * i + 1] != 0;
    return moves;
}

/* Whether it would move the way that its friction pushes. */
static gboolean goes_back(const TinkerClosedContacts *closed, const TinkerContactLaws *laws, guint number)
{
    return laws->sliding[number] * closed->relative[2 * number + 1] < 0;
}

/* Friction that would move what it holds is more than is needed: another is at its limit in the place of that. It holds
 * by less from here on; so do all others where it is that of the event itself, which has reached its limit now. */
static gboolean let_go_of_limits(const TinkerContactChange *change, const TinkerClosedContacts *closed,
                                 const TinkerContactLaws *laws)
{
    gboolean any = FALSE, all = FALSE;
    for (guint i = 0; i < laws->count; i++)
        all |= tinker_change_is_trigger(change, tinker_touch(change, i)) && goes_back(closed, laws, i);
    for (guint i = 0; i < laws->count; i++) {
        if (!is_at_limit(change, laws, i) || tinker_change_is_trigger(change, tinker_touch(change, i))) continue;
        if (!all && !goes_back(closed, laws, i)) continue;
        laws->sliding[i] = 0;
        laws->second[i] = tinker_touch_surface(change, i).dynamic_friction;
        any = TRUE;
    }
    return any;
}

/* What has reached the limit of sticking rubs with its dynamic coefficient as soon as it moves, and with the static one
 * as long as others hold what it rubs on: that moves by nothing then, with a little less friction, too. */
static TinkerContactResult solve_limits(const TinkerContactChange *change, TinkerClosedContacts *closed,
                                        TinkerContactLaws *laws)
{
    gboolean any = FALSE, moves = FALSE;
    for (guint i = 0; i < laws->count; i++) {
        if (!is_at_limit(change, laws, i)) continue;
        laws->second[i] = (1 - TINKER_SHORT_OF_LIMIT) * laws->first[i];
        any = TRUE;
    }
    if (!any) return solve_modes(change, closed, laws);
    g_autofree double *relative = g_try_new0(double, 2 * laws->count);
    if (relative == NULL) return TINKER_CONTACT_NO_MEMORY;
    closed->relative = relative;
    do
        moves = moves_at_limit(change, closed, laws, solve_modes(change, closed, laws));
    while (moves && let_go_of_limits(change, closed, laws));
    closed->relative = NULL;
    for (guint i = 0; i < laws->count; i++) {
        if (!is_at_limit(change, laws, i)) continue;
        tinker_touch(change, i)->contact.at_limit = !moves;
        laws->second[i] = moves ? tinker_touch_surface(change, i).dynamic_friction : laws->first[i];
    }
    return solve_modes(change, closed, laws);
}

/* What has reached the limit of sticking slips, but where no motion has it do so: then it is asked like any other that
 * has no speed. Answers whether that is anything. */
static gboolean free_limits(const TinkerContactChange *change, const TinkerContactLaws *laws)
{
    gboolean any = FALSE;
    for (guint i = 0; i < laws->count; i++) {
        if (laws->sliding[i] == 0 || limit_of(change, tinker_touch(change, i)) == 0) continue;
        laws->sliding[i] = 0;
        laws->first[i] = tinker_touch_surface(change, i).static_friction;
        laws->second[i] = tinker_touch_surface(change, i).dynamic_friction;
        tinker_touch(change, i)->contact.at_limit = FALSE;
        any = TRUE;
    }
    return any;
}

/* Whether shares of the load are no choice: what rows pull with is not kept as a share, and pins hold by their own. */
static gboolean has_no_shares(const TinkerContactChange *change)
{
    gboolean any = FALSE;
    for (guint i = 0; i < change->touches->len; i++)
        any |= tinker_touch(change, i)->row >= 0 || tinker_touch_is_pin(change, i);
    return any;
}

static TinkerContactResult ask_modes(TinkerContactChange *change, TinkerContactLaws *laws, double scale)
{
    const gboolean struck = anything_struck(change);
    for (guint i = 0; i < laws->count; i++) {
        tinker_touch(change, i)->contact.at_limit = FALSE;
        laws->sliding[i] = sliding_of(change, i, scale, struck);
        const TinkerSurface surface = tinker_touch_surface(change, i);
        laws->first[i] = surface.static_friction;
        laws->second[i] = surface.dynamic_friction;
    }
    TinkerClosedContacts closed = {
        (int32_t)laws->count,       laws->delassus, laws->pairs, laws->sliding, laws->first, laws->second,
        TINKER_FORCE_NOISE * scale, laws->motion,   laws->bearer};
    closed.any = has_no_shares(change);
    if (change->turns) ask_slow(change, laws);
    TinkerContactResult result = TINKER_CONTACT_NO_ACCELERATION;
    if (!change->jams) result = solve_limits(change, &closed, laws);
    if (!change->jams && result == TINKER_CONTACT_NO_ACCELERATION && ask_slow(change, laws))
        result = solve_modes(change, &closed, laws);
    if (!change->jams && result == TINKER_CONTACT_NO_ACCELERATION && free_limits(change, laws))
        result = solve_modes(change, &closed, laws);
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

/* A contact whose force has just come to 0 opens, unless something presses it again; so does one that presses by
 * nothing and is to slip, where that would only be the turn of another, and where opening was not tried just now. A
 * pin, which has no normal force of its own, never opens. */
static gboolean lets_go(const TinkerContactChange *change, guint number, double force, double noise)
{
    const TinkerTouch *at = tinker_touch(change, number);
    const TinkerTriggerKind kind = change->trigger.kind;
    const gboolean limit = kind == TINKER_TRIGGER_FORWARD || kind == TINKER_TRIGGER_BACKWARD;
    if (tinker_touch_is_pin(change, number)) return FALSE;
    if (!tinker_change_is_trigger(change, at) || force > TINKER_LET_GO * noise) return FALSE;
    return kind == TINKER_TRIGGER_NORMAL ||
           (limit && change->turns && !tinker_contact_run_came_back(change->run, &change->trigger));
}

/* What acts on the bodies of a row besides it (N), added up: where that cancels along the row, what is left is rounding
 * of this. */
static double acts_along(const TinkerModel *model, int32_t row)
{
    const TinkerConstraints *all = &model->constraints;
    double sum = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const int32_t body = all->points[e];
        for (int32_t k = 2 * body; body < model->bodies && k < 2 * body + 2; k++)
            sum += fabs(model->force[k]) + model->mass[body] * fabs(model->constant_acceleration[k]);
    }
    return sum;
}

static void note_modes(TinkerContactChange *change, const TinkerContactLaws *laws, double scale)
{
    for (guint i = 0; i < laws->count; i++) {
        TinkerTouch *at = tinker_touch(change, i);
        double mass = change->model->mass[at->contact.body];
        const guint bearer = tinker_touch_bearer(change, i);
        at->contact.mode = laws->modes[i];
        at->begins = laws->sliding[i] == 0;
        at->contact.at_limit &= laws->modes[i] != TINKER_CONTACT_OPEN && laws->modes[i] != TINKER_CONTACT_STICK;
        if (bearer != i) {
            const gboolean open = tinker_touch(change, bearer)->contact.mode == TINKER_CONTACT_OPEN;
            if (open) at->contact.mode = TINKER_CONTACT_OPEN;
            at->contact.normal = laws->answers[2 * bearer];
            at->contact.base_friction = laws->answers[2 * i + 1];
            continue;
        }
        if (!at->struck) at->contact.normal = laws->answers[2 * i];
        at->contact.base_normal = laws->answers[2 * i];
        at->contact.base_friction = laws->answers[2 * i + 1];
        const double acts = mass * scale + (at->row >= 0 ? acts_along(change->model, at->row) : 0);
        if (lets_go(change, i, laws->answers[2 * i], acts)) at->contact.mode = TINKER_CONTACT_OPEN;
    }
}

gboolean tinker_change_decide(TinkerContactChange *change, GError **error)
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
        tinker_change_note_pins(change, &laws);
        result = ask_modes(change, &laws, scale);
        if (result == TINKER_CONTACT_SOLVED) {
            note_modes(change, &laws, scale);
            tinker_change_choose_sides(change);
            return TRUE;
        }
        if (result != TINKER_CONTACT_NO_ACCELERATION) break;
        change->jams = FALSE;
        tinker_change_add_event(change, "jam", tinker_touch(change, 0));
        if (!tinker_change_push_all(change, laws.answers))
            return tinker_change_refuse(change, change->model->failure, error);
    }
    return tinker_change_refuse_laws(
        change, result, _("no motion satisfies the laws of friction for all bodies that touch there"), error);
}
