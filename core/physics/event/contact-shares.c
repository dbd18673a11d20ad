/* How closed contacts share a load that nothing divides among them: bodies that are held more than once. */
#include <math.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/island/island-run.h"

/* What presses least is to press by so much of what presses most, and where that leads nowhere by so many times less.
 */
#define LARGEST_LEAST 0.1
#define LESS          0.1
#define PASSES_EACH   40
#define MOST_PASSES   120
/* Of the limit of sticking. */
#define SHORT_OF_SLIPPING 0.99
/* So many times the way is gone on along it, at most. */
#define FARTHEST 100

/* Whether it had no speed along before the laws were asked. */
static gboolean begins_now(const TinkerContactChange *change, const TinkerContact *contact)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (at->row < 0 && at->contact.body == contact->body && at->contact.plate == contact->plate) return at->begins;
    }
    return FALSE;
}

/* Whether what begins to slip goes the way that its friction is against, by the accelerations worked out last: where
 * another share of the load moves it the other way, that is none of this motion. */
static gboolean slips_as_said(const TinkerContactChange *change, const TinkerContact *contact)
{
    const double pushes =
        (fabs(contact->normal) + fabs(contact->friction)) * change->model->inverse_mass[contact->body];
    double along[2];
    if (contact->friction == 0 || !begins_now(change, contact)) return TRUE;
    tinker_contacts_relative_acceleration(change->contacts, contact, change->run->force, along);
    const double forward = contact->mode == TINKER_CONTACT_SLIP_FORWARD ? along[1] : -along[1];
    return forward >= -TINKER_FORCE_NOISE * pushes;
}

static gboolean keeps_laws(const TinkerContactChange *change, const TinkerContact *contact)
{
    const TinkerContacts *contacts = change->contacts;
    const double most =
        tinker_contact_surface(contacts, contact->body, contact->plate).static_friction * contact->normal;
    if (!(contact->normal >= 0)) return FALSE;
    if (contact->mode == TINKER_CONTACT_STICK) return fabs(contact->friction) <= most;
    return contact->at_limit || slips_as_said(change, contact);
}

/* Whether all that opens parts, by the accelerations worked out last: what slides rubs by what presses on it, so that
 * another share of a load is another motion. */
static gboolean parts_as_said(const TinkerContactChange *change)
{
    const TinkerModel *model = change->model;
    const double *a = change->run->force, *constant = model->constant_acceleration;
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        if (at->row >= 0 || at->contact.mode != TINKER_CONTACT_OPEN || tinker_touch_leans(change, i)) continue;
        const int32_t k = 2 * at->contact.body, plate_point = tinker_touch_plate(change, i)->point;
        const double *base = (plate_point < model->bodies ? a : model->point_acceleration) + 2 * plate_point;
        const double scale =
            fabs(a[k]) + fabs(a[k + 1]) + fabs(base[0]) + fabs(base[1]) + fabs(constant[k]) + fabs(constant[k + 1]);
        double along[2];
        tinker_contacts_relative_acceleration(change->contacts, &at->contact, a, along);
        if (along[0] < -TINKER_FORCE_NOISE * scale) return FALSE;
    }
    return TRUE;
}

/* Whether the load of this closed contact is shared anew. */
static gboolean is_asked(const TinkerContactChange *change, const TinkerContact *contact)
{
    const TinkerContacts *contacts = change->contacts;
    if (change->run->together[contact->body] != change->group) return FALSE;
    return !change->apart || contacts->touching[contact->body] == contacts->touching[change->trigger.body];
}

/* The share of least norm. */
static void share_evenly(TinkerContactChange *change, const TinkerContact *kept)
{
    TinkerContacts *contacts = change->contacts;
    for (guint i = 0; i < contacts->closed->len; i++) {
        if (!is_asked(change, &kept[i])) continue;
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        contact->base_normal = contact->base_friction = 0;
    }
}

/* Corners of one pair that stick on one line hold together, each by what presses on it: only the sum of their friction
 * is determined, and all of them reach their limit at once. Closed contacts are in the order of their bodies. */
static void share_by_load(TinkerContactChange *change, const TinkerContact *kept)
{
    TinkerContacts *contacts = change->contacts;
    guint first = 0; /* of the body */
    for (guint i = 0; i < contacts->closed->len; i++) {
        double normal = 0, friction = 0;
        if (kept[i].body != kept[first].body) first = i;
        for (guint k = first; k < contacts->closed->len && kept[k].body == kept[i].body; k++) {
            if (!tinker_contacts_stick_together(contacts, &kept[i], &kept[k])) continue;
            normal += kept[k].base_normal;
            friction += kept[k].base_friction;
        }
        if (normal > 0) tinker_contacts_closed(contacts, i)->base_friction = friction * kept[i].base_normal / normal;
    }
}

/* Whether any two corners hold together, so that shares by load differ from others. */
static gboolean is_any_together(const TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    guint first = 0; /* of the body */
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->body != tinker_contacts_closed(contacts, first)->body) first = i;
        for (guint k = first; k < i; k++)
            if (tinker_contacts_stick_together(contacts, contact, tinker_contacts_closed(contacts, k))) return TRUE;
    }
    return FALSE;
}

/* The share of least norm between bodies; corners that hold together by what presses on each, as friction that all bear
 * alike may be beyond the limit of the one that is pressed less. */
static void share_evenly_by_load(TinkerContactChange *change, const TinkerContact *kept)
{
    TinkerContacts *contacts = change->contacts;
    const TinkerState *state = &change->run->run->state;
    share_evenly(change, kept);
    tinker_contacts_take_shares(contacts);
    if (tinker_contact_run_look_at(change->run, state->t, state->q, state->v, NULL) != TINKER_OK) return;
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (!is_asked(change, contact)) continue;
        if (!tinker_contacts_resists(contacts, contact)) contact->base_normal = contact->normal;
        contact->base_friction = contact->friction;
    }
    g_autofree TinkerContact *even = g_memdup2(contacts->closed->data, contacts->closed->len * sizeof(TinkerContact));
    share_by_load(change, even);
}

/* Takes a share if it keeps the laws, else the one that there was. */
static gboolean try_share(TinkerContactChange *change, void (*share)(TinkerContactChange *, const TinkerContact *))
{
    TinkerContacts *contacts = change->contacts;
    const TinkerState *state = &change->run->run->state;
    g_autofree TinkerContact *kept = g_memdup2(contacts->closed->data, contacts->closed->len * sizeof(TinkerContact));
    share(change, kept);
    tinker_contacts_take_shares(contacts);
    gboolean keeps = tinker_contact_run_look_at(change->run, state->t, state->q, state->v, NULL) == TINKER_OK;
    for (guint i = 0; keeps && i < contacts->closed->len; i++)
        if (is_asked(change, &kept[i])) keeps = keeps_laws(change, tinker_contacts_closed(contacts, i));
    if (keeps && parts_as_said(change)) return TRUE;
    memcpy(contacts->closed->data, kept, contacts->closed->len * sizeof(TinkerContact));
    tinker_contacts_take_shares(contacts);
    change->run->looked_time = NAN; /* those forces are of another share */
    return FALSE;
}

/* A share that lies within the limits ------------------------------------------------------------------------------ */

/* Whether the share of this closed contact is moved. */
static gboolean is_moved(const TinkerContactChange *change, const TinkerContact *contact)
{
    return is_asked(change, contact) && !tinker_contacts_is_pin(change->contacts, contact);
}

/* What presses, and how it rubs, by the share that the laws gave. */
static void take_given_share(TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (!is_moved(change, contact)) continue;
        contact->friction = contact->base_friction;
        if (!tinker_contacts_resists(contacts, contact)) contact->normal = contact->base_normal;
    }
}

/* The closed contact that leans on this one by resisting its rolling; NULL: none. */
static TinkerContact *resisting(const TinkerContacts *contacts, guint number)
{
    for (guint i = 0; contacts->resistance_count > 0 && i < contacts->closed->len; i++)
        if (tinker_contacts_closed(contacts, i)->bearer == (int32_t)number) return tinker_contacts_closed(contacts, i);
    return NULL;
}

/* What the friction of one that sticks may be at most, over the normal force: a little short of slipping. Else 0. */
static double friction_ratio(const TinkerContacts *contacts, const TinkerContact *contact)
{
    if (contact == NULL || contact->mode != TINKER_CONTACT_STICK) return 0;
    return SHORT_OF_SLIPPING * tinker_contact_surface(contacts, contact->body, contact->plate).static_friction;
}

/* Moves the share of one contact, with what resists its rolling, to the nearest at which it presses by no less than
 * `least` (N) and is a little short of slipping: with friction f_i of at most s_i N each, the distance from what there
 * is has no slope in N where N - n = sum s_i (|f_i| - s_i N), over those that are beyond s_i N. */
static void take_nearest_share(const TinkerContacts *contacts, guint number, double least)
{
    TinkerContact *contact = tinker_contacts_closed(contacts, number), *rolls = resisting(contacts, number);
    const double slope[2] = {friction_ratio(contacts, contact), friction_ratio(contacts, rolls)};
    const double rubs[2] = {contact->friction, rolls != NULL ? rolls->friction : 0};
    double normal = contact->normal;
    for (int beyond = 1; beyond < 4; beyond++) { /* which of the two are */
        double sum = contact->normal, weights = 1;
        for (int k = 0; k < 2; k++) {
            if (!(beyond & (1 << k))) continue;
            sum += slope[k] * fabs(rubs[k]);
            weights += slope[k] * slope[k];
        }
        normal = fmax(normal, sum / weights); /* the slope is the least of these lines, which all rise */
    }
    contact->base_normal = fmax(normal, least);
    if (contact->mode == TINKER_CONTACT_STICK)
        contact->base_friction = CLAMP(rubs[0], -slope[0] * contact->base_normal, slope[0] * contact->base_normal);
    if (rolls != NULL && rolls->mode == TINKER_CONTACT_STICK)
        rolls->base_friction = CLAMP(rubs[1], -slope[1] * contact->base_normal, slope[1] * contact->base_normal);
}

/* Works the forces out, nearest to the shares; whether they keep the laws, and everything presses by half of `least`.
 */
static gboolean presses_all(TinkerContactChange *change, double least)
{
    TinkerContacts *contacts = change->contacts;
    const TinkerState *state = &change->run->run->state;
    tinker_contacts_take_shares(contacts);
    gboolean all = tinker_contact_run_look_at(change->run, state->t, state->q, state->v, NULL) == TINKER_OK;
    for (guint i = 0; all && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (is_moved(change, contact)) all = keeps_laws(change, contact) && contact->normal >= 0.5 * least;
    }
    return all && parts_as_said(change);
}

/* The square of how far two sets of forces are apart, as the least norm has it. */
static double distance_squared(const TinkerContactChange *change, const TinkerContact *contact, double normal,
                               double friction)
{
    const double own = tinker_contacts_resists(change->contacts, contact) ? 0 : normal * normal;
    const double along = contact->mode == TINKER_CONTACT_STICK ? friction * friction : 0;
    return (own + along) * change->model->inverse_mass[contact->body];
}

/* Goes on along the way from `before`, which does what the motion asks for, by the shares to the forces worked out,
 * which do so, too: as far as the shares let it, (distance to them / way)^2 times. */
static void extrapolate(TinkerContactChange *change, const TinkerContact *before)
{
    const TinkerContacts *contacts = change->contacts;
    double asked = 0, way = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *now = tinker_contacts_closed(contacts, i), *from = &before[i];
        if (!is_moved(change, now)) continue;
        asked += distance_squared(change, now, now->base_normal - from->normal, now->base_friction - from->friction);
        way += distance_squared(change, now, now->normal - from->normal, now->friction - from->friction);
    }
    const double times = way > 0 ? CLAMP(asked / way, 1, FARTHEST) : 1;
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *now = tinker_contacts_closed(contacts, i);
        if (!is_moved(change, now)) continue;
        now->normal = before[i].normal + times * (now->normal - before[i].normal);
        now->friction = before[i].friction + times * (now->friction - before[i].friction);
    }
}

/* A share in which everything presses. The laws gave one at an edge of those there are, where something presses no more
 * or is about to slip; if forces change so that it falls over that edge at once, another edge follows, and on without
 * end. Between the edges: by turns to what presses, and to what the motion asks for, as near to it as can be, and on
 * along that way. Sources: the method of alternating projections, H. H. Bauschke, J. M. Borwein, SIAM Review 38 (1996)
 * 367-426; how far on, H. H. Bauschke, P. L. Combettes, S. G. Kruk, "Extrapolation algorithm for affine-convex
 * feasibility problems", Numerical Algorithms 41 (2006) 239-274. */
static gboolean share_within(TinkerContactChange *change)
{
    TinkerContacts *contacts = change->contacts;
    const gsize bytes = contacts->closed->len * sizeof(TinkerContact);
    g_autofree TinkerContact *kept = g_memdup2(contacts->closed->data, bytes), *before = g_malloc(bytes);
    double least = 0;
    for (guint i = 0; i < contacts->closed->len; i++)
        if (is_asked(change, &kept[i])) least = fmax(least, kept[i].base_normal);
    take_given_share(change);
    for (int pass = 0; least > 0 && pass < MOST_PASSES; pass++) {
        if (pass % PASSES_EACH == 0) least *= pass == 0 ? LARGEST_LEAST : LESS;
        memcpy(before, contacts->closed->data, bytes);
        for (guint i = 0; i < contacts->closed->len; i++) {
            const TinkerContact *contact = tinker_contacts_closed(contacts, i);
            if (is_moved(change, contact) && !tinker_contacts_resists(contacts, contact))
                take_nearest_share(contacts, i, least);
        }
        if (presses_all(change, least)) return TRUE;
        extrapolate(change, before);
    }
    memcpy(contacts->closed->data, kept, bytes);
    tinker_contacts_take_shares(contacts);
    return FALSE;
}

gboolean tinker_change_shares_load(const TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->run->contacts;
    for (guint i = 0; i < contacts->blocks->len; i++) {
        const TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        int32_t contact = g_array_index(contacts->rows, TinkerContactRow, (guint)block->first).contact;
        if (change->run->together[tinker_contacts_closed(contacts, (guint)contact)->body] == change->group &&
            !tinker_contact_block_is_full(block))
            return TRUE;
    }
    return FALSE;
}

/* As tinker_change_share_load, of what leans on the contact that the event is of: others may stand at an edge for good.
 */
static gboolean share_where_it_turns(TinkerContactChange *change)
{
    change->apart = TRUE;
    const gboolean shared = try_share(change, share_evenly) || share_within(change);
    change->apart = FALSE;
    return shared;
}

gboolean tinker_change_share_load(TinkerContactChange *change)
{
    const gboolean by_load = is_any_together(change);
    if (try_share(change, share_evenly) || (by_load && try_share(change, share_evenly_by_load))) return TRUE;
    if ((change->turns || tinker_change_repeats(change)) && share_within(change)) return TRUE;
    if (change->turns && change->trigger.row < 0 && share_where_it_turns(change)) return TRUE;
    if (by_load) try_share(change, share_by_load);
    return FALSE;
}
