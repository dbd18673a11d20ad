/* What might follow as well: where several contacts close at once and the laws of impact differ, how the bodies would
 * go on by each of them; and where nothing determines how contacts share a load, whether another share would move them
 * otherwise. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/model/points.h"
#include "physics/system/summary.h"

/* Contacts of more are not compared: that costs more than the impact. */
#define MOST_COMPARED 12

static gboolean is_one_pair(const TinkerContactChange *change, const TinkerTouch *a, const TinkerTouch *b)
{
    if (a->row >= 0 || b->row >= 0) return a->row == b->row;
    const TinkerPlate *plates = change->contacts->plates;
    const TinkerTouchingPair *pair = plates[a->contact.plate].pair;
    if (pair != NULL) return pair == plates[b->contact.plate].pair;
    return a->contact.body == b->contact.body && a->contact.plate == b->contact.plate;
}

int32_t tinker_change_number_pairs(const TinkerContactChange *change, int32_t *pair)
{
    int32_t count = 0;
    for (guint i = 0; i < change->touches->len; i++) {
        guint first = 0;
        while (!is_one_pair(change, tinker_touch(change, first), tinker_touch(change, i)))
            first++;
        pair[i] = first == i ? count++ : pair[first];
    }
    return count;
}

static void add_body(TinkerContactChange *change, const char *law, int32_t body, const double *v)
{
    const TinkerModel *model = change->model;
    const int32_t turn = tinker_model_turn_of(model, body);
    TinkerAlternative each = {law, model->body_blocks[body], v[2 * body], v[2 * body + 1], NAN};
    if (turn >= 0) each.rate = tinker_model_angle(model, body, v);
    g_array_append_val(change->alternatives, each);
}

/* All bodies of this law that something touches, each once. */
static void add_bodies(TinkerContactChange *change, const char *law, const double *v)
{
    const TinkerModel *model = change->model;
    g_autofree gboolean *listed = g_new0(gboolean, MAX(model->bodies, 1));
    for (guint i = 0; i < change->touches->len; i++) {
        const TinkerTouch *at = tinker_touch(change, i);
        const TinkerTouchingPair *pair = at->row < 0 ? change->contacts->plates[at->contact.plate].pair : NULL;
        const int32_t bodies[] = {at->contact.body, pair != NULL ? pair->point[1] : at->contact.body};
        for (int k = 0; k < 2; k++) {
            if (bodies[k] >= model->bodies || listed[bodies[k]]) continue;
            listed[bodies[k]] = TRUE;
            add_body(change, law, bodies[k], v);
        }
    }
}

static void warn_once(const TinkerContactChange *change)
{
    if (change->run->warned) return;
    change->run->warned = TRUE;
    tinker_summary_warn_of_laws(&change->run->run->summary, change->run->run->state.t);
}

void tinker_change_note_alternatives(TinkerContactChange *change, const TinkerImpact *impact, const int32_t *pair,
                                     const double *impulses)
{
    const TinkerModel *model = change->model;
    const gsize width = 2 * (gsize)impact->count, coordinates = (gsize)MAX(model->coordinates, 1);
    if (impact->delassus == NULL || impact->count > MOST_COMPARED) return;
    g_autofree double *answers = g_new0(double, width), *after = g_new0(double, TINKER_IMPACT_LAWS *coordinates);
    double differ = 0;
    for (int law = 0; law < TINKER_IMPACT_LAWS; law++) {
        double *v = after + (gsize)law * coordinates;
        const gboolean own = law == (int)change->contacts->impact_law;
        if (!own && tinker_impact_by_law((TinkerImpactLaw)law, impact, pair, answers) != TINKER_CONTACT_SOLVED) return;
        memcpy(v, change->run->run->state.v, (gsize)model->coordinates * sizeof(double));
        tinker_change_push(change, own ? impulses : answers, v);
        for (int32_t i = 0; i < model->coordinates; i++)
            differ = fmax(differ, fabs(v[i] - after[i]));
    }
    if (differ <= TINKER_SAME_OUTCOME * change->speed) return;
    g_clear_pointer(&change->alternatives, g_array_unref);
    change->alternatives = g_array_new(FALSE, FALSE, sizeof(TinkerAlternative));
    for (int law = 0; law < TINKER_IMPACT_LAWS; law++)
        add_bodies(change, tinker_scene_impact_laws[law], after + (gsize)law * coordinates);
    warn_once(change);
}

/* Other shares ----------------------------------------------------------------------------------------------------- */

static gboolean is_of_group(const TinkerContactChange *change, const TinkerContact *contact)
{
    return change->run->together[contact->body] == change->group;
}

/* Whether anything of the group rubs as it slides: by what presses on it. */
static gboolean group_rubs(const TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    gboolean any = FALSE;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const gboolean slips =
            contact->mode == TINKER_CONTACT_SLIP_FORWARD || contact->mode == TINKER_CONTACT_SLIP_BACKWARD;
        any |= slips && is_of_group(change, contact) &&
               tinker_contact_surface(contacts, contact->body, contact->plate).dynamic_friction > 0;
    }
    return any;
}

/* A share to which the forces that do what the motion asks for are not the nearest, by which load and which friction
 * any of them bears. Answers by how much that would accelerate a body by itself (m/s^2), at most. */
static double disturb_share(const TinkerContactChange *change)
{
    const TinkerContacts *contacts = change->contacts;
    double largest = 0, most = 0, part = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (is_of_group(change, contact)) largest = fmax(largest, fabs(contact->normal));
    }
    for (guint i = 0; i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (!is_of_group(change, contact) || tinker_contacts_is_pin(contacts, contact) ||
            tinker_contacts_resists(contacts, contact))
            continue;
        part = fmod(part + 0.618, 1); /* no two are alike */
        contact->base_normal += part * largest;
        if (contact->mode == TINKER_CONTACT_STICK) contact->base_friction += (1 - part) * largest;
        most = fmax(most, largest * change->model->inverse_mass[contact->body]);
    }
    return most;
}

void tinker_change_note_share(TinkerContactChange *change)
{
    TinkerContactRun *self = change->run;
    TinkerContacts *contacts = change->contacts;
    const TinkerState *state = &self->run->state;
    const int32_t size = self->run->system.system.size;
    if (self->warned_share || !group_rubs(change)) return;
    if (tinker_contact_run_look_at(self, state->t, state->q, state->v, NULL) != TINKER_OK) return;
    const gsize bytes = contacts->closed->len * sizeof(TinkerContact);
    g_autofree TinkerContact *kept = g_memdup2(contacts->closed->data, bytes);
    g_autofree double *given = g_memdup2(self->force, (gsize)size * sizeof(double));
    const double disturbed = disturb_share(change);
    tinker_contacts_take_shares(contacts);
    double differ = 0;
    if (tinker_contact_run_look_at(self, state->t, state->q, state->v, NULL) == TINKER_OK)
        for (int32_t i = 0; i < size; i++)
            differ = fmax(differ, fabs(self->force[i] - given[i]));
    memcpy(contacts->closed->data, kept, bytes);
    tinker_contacts_take_shares(contacts);
    if (!(differ > TINKER_SHARE_MATTERS * disturbed)) return;
    self->warned_share = TRUE;
    tinker_summary_warn_of_scene(
        &self->run->summary,
        g_strdup_printf(_("the motion from %.6g s on is one of several: the laws leave open how contacts share a load, "
                          "and what slides rubs by what presses on it (give what is guided or wedged some play, or "
                          "make it smooth)"),
                        state->t));
}
