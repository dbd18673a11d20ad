/* Contacts that change by turns at one instant: closed, a force falls below 0, open, an acceleration does, and so on
 * without end, as corners at corners do, where nothing divides a load; or two that stop by turns, each while the other
 * slides on. Others are asked with them then (contact-modes.c, contact-shares.c). Where a corner stands beside another
 * that bears the body already, as two do at the foot of one wall, what presses it is rounding, and so is what parts it:
 * then its gap is watched and not what accelerates it (contact-change.c).
 *
 * And bodies that strike by turns what closes on them from both sides: each blow throws them at the other side, ever
 * sooner, until the gaps are rounding. What infinitely many such blows do within no time is one without any rebound
 * (contact-blows.c). */
#include <math.h>

#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"

/* So many turns are not taken for an endless sequence. */
#define FEW_TURNS 8

typedef struct {
    TinkerContactPair pair;
    gboolean blows;
    int turns;
    double time;                 /* s: of the last */
    TinkerTriggerKind kind, was; /* of the last, and of the one before */
    int alike;                   /* how many of the last were of one kind */
} Turns;

static gboolean is_of_force(TinkerTriggerKind kind)
{
    return kind >= TINKER_TRIGGER_LEAVING && kind <= TINKER_TRIGGER_STARTING;
}

static Turns *find(const TinkerContactRun *self, const TinkerTrigger *trigger, gboolean blows)
{
    for (guint i = 0; i < self->turns->len; i++) {
        Turns *turns = &g_array_index(self->turns, Turns, i);
        const TinkerContactPair *pair = &turns->pair;
        if (turns->blows == blows && pair->body == trigger->body && pair->plate == trigger->plate &&
            pair->row == trigger->row)
            return turns;
    }
    return NULL;
}

GArray *tinker_contact_turns_new(void)
{
    return g_array_new(FALSE, FALSE, sizeof(Turns));
}

/* Whether the gap has been no more than rounding since the blow before. */
static gboolean stayed_closed(const TinkerContactRun *self, const TinkerTrigger *trigger, double passed)
{
    const TinkerContactPlace place = tinker_contact_place(self->contacts, trigger->body, trigger->plate);
    return passed <= TINKER_ONE_INSTANT * fabs(self->run->state.t) ||
           passed * fabs(place.normal_speed) <= tinker_contact_run_closed_gap(self);
}

static void append_first(TinkerContactRun *self, const TinkerTrigger *trigger, gboolean blows)
{
    const Turns first = {.pair = {trigger->body, trigger->plate, trigger->row},
                         .blows = blows,
                         .turns = 1,
                         .time = self->run->state.t,
                         .kind = trigger->kind,
                         .was = TINKER_TRIGGER_NONE,
                         .alike = 1};
    g_array_append_val(self->turns, first);
}

static void note_blow(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const double t = self->run->state.t;
    Turns *turns = find(self, trigger, TRUE);
    if (turns == NULL) {
        append_first(self, trigger, TRUE);
        return;
    }
    turns->turns = stayed_closed(self, trigger, t - turns->time) ? turns->turns + 1 : 1;
    turns->time = t;
}

/* Steps resolve the motion: what changes again within so little of one does not by the motion. The time since the start
 * says nothing of that, but for its rounding. */
void tinker_contact_run_note_turn(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const double t = self->run->state.t, soon = fmax(TINKER_BY_TURNS * self->usual, TINKER_ONE_INSTANT * fabs(t));
    if (trigger->kind == TINKER_TRIGGER_GAP && trigger->row < 0) note_blow(self, trigger);
    if (!is_of_force(trigger->kind)) return;
    for (guint i = self->turns->len; i-- > 0;)
        if (!g_array_index(self->turns, Turns, i).blows && t - g_array_index(self->turns, Turns, i).time > soon)
            g_array_remove_index_fast(self->turns, i);
    Turns *turns = find(self, trigger, FALSE);
    if (turns == NULL) {
        append_first(self, trigger, FALSE);
        return;
    }
    turns->turns++;
    turns->time = t;
    turns->alike = turns->kind == trigger->kind ? turns->alike + 1 : 1;
    turns->was = turns->kind;
    turns->kind = trigger->kind;
}

gboolean tinker_contact_run_goes_by_turns(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const Turns *turns = is_of_force(trigger->kind) ? find(self, trigger, FALSE) : NULL;
    return turns != NULL && turns->turns > FEW_TURNS;
}

gboolean tinker_contact_run_came_back(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const Turns *turns = find(self, trigger, FALSE);
    return turns != NULL && turns->was == TINKER_TRIGGER_LEAVING;
}

int tinker_contact_run_stays_at_edge(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const Turns *turns = is_of_force(trigger->kind) ? find(self, trigger, FALSE) : NULL;
    return turns != NULL ? MAX(turns->alike - FEW_TURNS, 0) : 0;
}

gboolean tinker_contact_run_strikes_by_turns(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const Turns *turns = trigger->kind == TINKER_TRIGGER_GAP && trigger->row < 0 ? find(self, trigger, TRUE) : NULL;
    return turns != NULL && turns->turns > FEW_TURNS;
}
