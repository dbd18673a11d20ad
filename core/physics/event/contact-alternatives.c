/* Where several contacts close at once and the laws of impact differ, how the bodies would go on by each of them. */
#include <math.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-change-private.h"
#include "physics/event/tolerances.h"
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
        add_bodies(change, tinker_impact_law_names[law], after + (gsize)law * coordinates);
    warn_once(change);
}
