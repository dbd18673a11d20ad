/* All islands have to be known at the instant at which one of them jumps, and each is known within its last step alone.
 * So the island that is farthest behind makes the next step: none has begun a step later than the instant that comes
 * first. A heap knows which one it is. */
#include "physics/run/event-values.h"

#include <math.h>
#include <string.h>

#include "physics/event/contact-run.h"
#include "physics/island/island-run.h"
#include "physics/run/tolerances.h"

/* Instants that are told beyond one for each sample: what bounces to rest has them all at once. */
#define RESERVE 256.0

struct _TinkerEventValues {
    TinkerIslandRuns *runs;
    TinkerEventValuesTaker take;
    void *taker;
    guint *heap; /* islands that may jump, that which comes first at the top */
    guint count;
    double left; /* instants that may be told until the next sample */
    double told; /* s: the last instant. A break that joints cannot follow is not passed: it stays the next */
    double *before, *scales; /* of each column: just before the instant; the largest so far */
};

TinkerEventValues *tinker_event_values_new(TinkerIslandRuns *runs, TinkerEventValuesTaker take, void *taker)
{
    TinkerEventValues *self = g_new0(TinkerEventValues, 1);
    *self = (TinkerEventValues){.runs = runs, .take = take, .taker = taker, .left = RESERVE, .told = 0};
    self->heap = g_new0(guint, runs->runs->len + 1);
    self->before = g_new0(double, runs->columns + 1);
    self->scales = g_new0(double, runs->columns + 1);
    return self;
}

void tinker_event_values_free(TinkerEventValues *self)
{
    if (self == NULL) return;
    g_free(self->heap);
    g_free(self->before);
    g_free(self->scales);
    g_free(self);
}

/* The heap --------------------------------------------------------------------------------------------------------- */

static TinkerIslandRun *run_of(const TinkerEventValues *self, guint island)
{
    return g_ptr_array_index(self->runs->runs, island);
}

static gboolean stands_on_event(const TinkerIslandRun *run)
{
    return run->contacts != NULL && tinker_contact_run_has_pending_event(run->contacts);
}

static gboolean stands_on_break(const TinkerIslandRun *run)
{
    return run->ends_on_break && run->state.t >= run->piece_end;
}

/* At one time what stands on an instant comes first. */
static gboolean comes_before(const TinkerEventValues *self, guint a, guint b)
{
    const TinkerIslandRun *first = run_of(self, a), *second = run_of(self, b);
    if (first->state.t != second->state.t) return first->state.t < second->state.t;
    return (stands_on_event(first) || stands_on_break(first)) && !(stands_on_event(second) || stands_on_break(second));
}

static void sift_down(TinkerEventValues *self, guint place)
{
    for (;;) {
        guint first = place;
        for (guint child = 2 * place + 1; child <= 2 * place + 2 && child < self->count; child++)
            if (comes_before(self, self->heap[child], self->heap[first])) first = child;
        if (first == place) return;
        const guint island = self->heap[place];
        self->heap[place] = self->heap[first];
        self->heap[first] = island;
        place = first;
    }
}

static void order_islands(TinkerEventValues *self)
{
    self->count = 0;
    for (guint i = 0; i < self->runs->runs->len; i++)
        if (run_of(self, i)->contacts != NULL || run_of(self, i)->ends_on_break) self->heap[self->count++] = i;
    for (guint place = self->count / 2; place-- > 0;)
        sift_down(self, place);
}

/* Instants --------------------------------------------------------------------------------------------------------- */

/* Whether any island stands on an event at this time: others may stand on breaks at the same. */
static gboolean is_event_at(const TinkerEventValues *self, double t)
{
    for (guint i = 0; i < self->runs->runs->len; i++)
        if (run_of(self, i)->state.t == t && stands_on_event(run_of(self, i))) return TRUE;
    return FALSE;
}

static void note_scales(TinkerEventValues *self, const double *values)
{
    for (guint i = 0; i < self->runs->columns; i++)
        if (isfinite(values[i])) self->scales[i] = fmax(self->scales[i], fabs(values[i]));
}

/* By more than rounding makes of the way to the instant: of the largest that a column has been, as one that passes
 * through 0 there is all rounding. */
static gboolean differ(const TinkerEventValues *self, const double *before, const double *behind)
{
    for (guint i = 0; i < self->runs->columns; i++)
        if (fabs(before[i] - behind[i]) > TINKER_SMOOTH * self->scales[i]) return TRUE;
    return FALSE;
}

/* Where the columns have no value on one side, such as a force at length 0, the instant is not told. A break that only
 * bends what moves by it shows in no column. */
static gboolean tell(TinkerEventValues *self, double t, double sample, GError **error)
{
    TinkerIslandRuns *runs = self->runs;
    const gboolean is_event = is_event_at(self, t);
    self->told = t;
    if (!tinker_island_runs_place(runs, t, sample, FALSE, error)) return FALSE;
    const gboolean known = tinker_island_runs_sample_before(runs, t) == TINKER_OK;
    memcpy(self->before, runs->values, runs->columns * sizeof(double));
    if (!tinker_island_runs_place(runs, t, sample, TRUE, error)) return FALSE;
    if (!known || tinker_island_runs_sample(runs, t) != TINKER_OK) return TRUE;
    note_scales(self, self->before);
    note_scales(self, runs->values);
    if (!is_event && !differ(self, self->before, runs->values)) return TRUE;
    self->left -= 1;
    return self->take(self->taker, t, self->before, runs->values, error);
}

gboolean tinker_event_values_advance(TinkerEventValues *self, double t, GError **error)
{
    note_scales(self, self->runs->values);
    order_islands(self);
    while (self->count > 0 && self->left >= 1) {
        const guint first = self->heap[0];
        const TinkerIslandRun *run = run_of(self, first);
        if (run->state.t <= t && run->state.t > self->told && (stands_on_event(run) || stands_on_break(run))) {
            if (!tell(self, run->state.t, t, error)) return FALSE;
            order_islands(self);
        } else if (run->state.t < t) {
            if (!tinker_island_runs_step_towards(self->runs, first, t, error)) return FALSE;
            sift_down(self, 0);
        } else {
            break;
        }
    }
    self->left = fmin(self->left + 1, RESERVE);
    return tinker_island_runs_advance(self->runs, t, error);
}
