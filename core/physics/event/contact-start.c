/* What was evaluated where a step begins is kept for whoever asks for it: what looks ahead, the method, and the search.
 */
#include <math.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/system/system.h"

void tinker_contact_run_keep_start(TinkerContactRun *self)
{
    const TinkerState *state = &self->run->state;
    const gsize bytes = (gsize)self->run->system.system.size * sizeof(double);
    const gboolean stands = self->start.at.t == state->t && self->start.changes == self->changes &&
                            memcmp(self->from.q, state->q, bytes) == 0 && memcmp(self->from.v, state->v, bytes) == 0;
    memcpy(self->from.books, state->books, (gsize)self->run->system.system.books * sizeof(double));
    if (stands) return;
    tinker_contact_run_forget_start(self);
    self->from.t = state->t;
    memcpy(self->from.q, state->q, bytes);
    memcpy(self->from.v, state->v, bytes);
}

void tinker_contact_run_forget_start(TinkerContactRun *self)
{
    self->start.at.t = NAN;
}

TinkerStatus tinker_contact_run_evaluate_start(TinkerContactRun *self)
{
    TinkerStepStart *start = &self->start;
    const TinkerState *from = &self->from;
    const TinkerSystem *system = &self->run->system.system;
    tinker_contact_run_forget_start(self);
    self->run->system.known = NULL;
    TinkerStatus status = system->acceleration(system->context, from->t, from->q, from->v, self->force, start->power);
    if (status != TINKER_OK) return status;
    memcpy(start->force, self->force, (gsize)system->size * sizeof(double));
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        start->loads[2 * i] = contact->normal;
        start->loads[2 * i + 1] = contact->friction;
    }
    start->changes = self->changes;
    start->at = (TinkerEvaluated){from->t, from->q, from->v, start->force, start->power};
    return TINKER_OK;
}

void tinker_contact_run_hand_start_on(TinkerContactRun *self)
{
    self->run->system.known = self->start.at.t == self->from.t ? &self->start.at : NULL;
}

/* Multipliers of rows that hold in one direction only are not kept. */
gboolean tinker_contact_run_recall_start(TinkerContactRun *self, double t)
{
    const TinkerStepStart *start = &self->start;
    if (t != start->at.t || self->model->constraints.unilateral != NULL) return FALSE;
    self->looked_time = NAN;
    memcpy(self->force, start->force, (gsize)self->run->system.system.size * sizeof(double));
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        contact->normal = start->loads[2 * i];
        contact->friction = start->loads[2 * i + 1];
    }
    return TRUE;
}
