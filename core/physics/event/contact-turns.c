/* Contacts that change by turns at one instant: closed, a force falls below 0, open, an acceleration does, and so on
 * without end, as corners at corners do, where nothing divides a load; or two that stop by turns, each while the other
 * slides on. Others are asked with them then (contact-modes.c, contact-shares.c). */
#include <math.h>

#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"

/* So many turns are not taken for an endless sequence. */
#define FEW_TURNS 8

typedef struct {
    TinkerContactPair pair;
    int turns;
    double time; /* s: of the last */
} Turns;

static gboolean is_of_force(TinkerTriggerKind kind)
{
    return kind >= TINKER_TRIGGER_LEAVING && kind <= TINKER_TRIGGER_STARTING;
}

static Turns *find(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    for (guint i = 0; i < self->turns->len; i++) {
        Turns *turns = &g_array_index(self->turns, Turns, i);
        const TinkerContactPair *pair = &turns->pair;
        if (pair->body == trigger->body && pair->plate == trigger->plate && pair->row == trigger->row) return turns;
    }
    return NULL;
}

GArray *tinker_contact_turns_new(void)
{
    return g_array_new(FALSE, FALSE, sizeof(Turns));
}

/* Steps resolve the motion: what changes again within so little of one does not by the motion. The time since the start
 * says nothing of that, but for its rounding. */
void tinker_contact_run_note_turn(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const double t = self->run->state.t, soon = fmax(TINKER_BY_TURNS * self->usual, TINKER_SAME_INSTANT * fabs(t));
    if (!is_of_force(trigger->kind)) return;
    for (guint i = self->turns->len; i-- > 0;)
        if (t - g_array_index(self->turns, Turns, i).time > soon) g_array_remove_index_fast(self->turns, i);
    const Turns first = {{trigger->body, trigger->plate, trigger->row}, 1, t};
    Turns *turns = find(self, trigger);
    if (turns == NULL) {
        g_array_append_val(self->turns, first);
        return;
    }
    turns->turns++;
    turns->time = t;
}

gboolean tinker_contact_run_goes_by_turns(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const Turns *turns = is_of_force(trigger->kind) ? find(self, trigger) : NULL;
    return turns != NULL && turns->turns > FEW_TURNS;
}
