/* The least of several answers. Contacts that hold a body more than once leave open how they share its load, and a
 * search ends at an edge of what they may do, at whichever rounding leads it to: where nothing presses at one corner of
 * two, say. Softened a little, the laws have one answer, in which all press; proximal points take it from there to the
 * nearest one that keeps the laws themselves. Source: Rockafellar, "Monotone operators and the proximal point
 * algorithm", SIAM J. Control Optim. 14 (1976) 877-898. */
#include <math.h>
#include <string.h>

#include "numerics/contact/contact-private.h"
#include "numerics/contact/tolerances.h"

/* The path of pivots through the softened laws of more takes longer than all else at an event. */
#define MOST_CONTACTS 24
#define MOST_PASSES   6
/* Away from the edges if it can be, as what stands there changes what it does soon: of the friction that what sticks
 * may have, and of the largest normal impulse what each has at least. */
static const struct {
    double friction, normal;
} within[] = {{0.9, 0.05}, {0.99, 0.005}};

/* Whether entry i of v is rounding, of what meets in it or of the largest velocity. */
static gboolean is_still(const TinkerContactWork *work, int32_t i, double tolerance)
{
    return fabs(work->v[i]) <= tolerance * (work->size[i] + 1);
}

/* Whether some of the impulses may be otherwise, as a contact that is open does not part, or one that slips holds. */
static gboolean leaves_open(const TinkerContactWork *work, double tolerance)
{
    gboolean open = work->singular;
    for (int32_t k = 0; k < work->problem.count; k++) {
        const TinkerContactState state = work->state[k];
        const gboolean slips = state == TINKER_STATE_FORWARD || state == TINKER_STATE_BACKWARD;
        open |= (slips && is_still(work, 2 * k + 1, tolerance)) ||
                (state == TINKER_STATE_OPEN && !tinker_contact_leans(&work->problem, k) &&
                 is_still(work, 2 * k, tolerance));
    }
    return open;
}

/* Whether the impulses keep the laws; what may hold and does counts as holding. Where all that meets is rounding beside
 * the largest velocity nothing closes: the path of pivots has no impulses so small. */
static gboolean keeps_laws(TinkerContactWork *work, double tolerance)
{
    tinker_contact_velocities(&work->problem, work->p, work->v, work->size);
    for (int32_t k = 0; k < work->problem.count; k++)
        if (work->state[k] != TINKER_STATE_OPEN && tinker_contact_grips(&work->problem, k) &&
            is_still(work, 2 * k + 1, tolerance))
            work->state[k] = TINKER_STATE_STICK;
    for (int32_t k = 0; k < work->problem.count; k++)
        if (work->size[2 * k] <= tolerance) work->v[2 * k] = 0;
    return tinker_contact_judge(work, tolerance, NULL);
}

/* What holds by all of its friction, but for what a path of pivots misses by, is at that bound: free to hold by a
 * little more while the rounding is taken out, it would stay beyond it; and so would what slips. */
static void put_on_bounds(TinkerContactWork *work)
{
    const TinkerContactProblem *problem = &work->problem;
    for (int32_t k = 0; k < problem->count; k++) {
        const double normal = tinker_contact_normal(problem, work->p, k), bound = problem->friction[k] * normal;
        double *along = &work->p[2 * k + 1];
        if (!tinker_contact_grips(problem, k) || !(bound > 0) || fabs(*along) < (1 - TINKER_AT_BOUND) * bound) continue;
        work->state[k] = *along < 0 ? TINKER_STATE_FORWARD : TINKER_STATE_BACKWARD;
        *along = tinker_contact_slope(problem, k, work->state[k]) * normal;
    }
}

/* The least with these coefficients of friction and least normal impulses, which may be less and more than the true
 * ones: it keeps the true laws and misses them by no more than `miss`. */
static gboolean find_least(TinkerContactWork *work, double tolerance, double miss)
{
    const gsize bytes = 2 * (gsize)work->problem.count * sizeof *work->p;
    const TinkerContactProblem problem = work->problem;
    memset(work->centre, 0, bytes);
    for (int32_t pass = 0; pass < MOST_PASSES; pass++) {
        work->problem.friction = work->grip;
        work->problem.least = work->least;
        const gboolean solved = tinker_contact_by_complementarity(work, TINKER_SOFT, work->centre);
        work->problem = problem;
        if (!solved) return FALSE;
        memcpy(work->centre, work->p, bytes);
        if (pass == 0) continue;
        put_on_bounds(work);
        tinker_contact_velocities(&work->problem, work->p, work->v, work->size);
        tinker_contact_correct(work); /* of the rounding in a path of pivots */
        if (keeps_laws(work, tolerance) && tinker_contact_miss(work) <= miss) return TRUE;
    }
    return FALSE;
}

static void keep(TinkerContactWork *work, TinkerContactState *states)
{
    memcpy(work->kept, work->p, 2 * (gsize)work->problem.count * sizeof *work->p);
    memcpy(states, work->state, (gsize)work->problem.count * sizeof *states);
}

static void take_kept(TinkerContactWork *work, const TinkerContactState *states)
{
    memcpy(work->p, work->kept, 2 * (gsize)work->problem.count * sizeof *work->p);
    memcpy(work->state, states, (gsize)work->problem.count * sizeof *states);
}

/* Asks for more than the least that was found: of what holds, and of what does not part. */
static void ask_within(TinkerContactWork *work, double friction, double normal, double tolerance)
{
    const TinkerContactProblem *problem = &work->problem;
    double largest = 0;
    for (int32_t k = 0; k < problem->count; k++)
        largest = fmax(largest, work->p[2 * k]);
    for (int32_t k = 0; k < problem->count; k++) {
        const gboolean presses = !tinker_contact_leans(problem, k) && is_still(work, 2 * k, tolerance);
        work->grip[k] = (work->state[k] == TINKER_STATE_STICK ? friction : 1) * problem->friction[k];
        work->least[k] = presses ? normal * largest : 0;
    }
}

void tinker_contact_take_least(TinkerContactWork *work, double tolerance, TinkerContactState *states)
{
    if (work->problem.count > MOST_CONTACTS || !leaves_open(work, tolerance)) return;
    const double miss = fmax(2 * tinker_contact_miss(work), tolerance);
    keep(work, states);
    ask_within(work, 1, 0, tolerance);
    gboolean found = find_least(work, tolerance, miss);
    if (!found) take_kept(work, states);
    for (gsize i = 0; found && i < G_N_ELEMENTS(within); i++) {
        keep(work, states);
        ask_within(work, within[i].friction, within[i].normal, tolerance);
        if (find_least(work, tolerance, miss)) return;
        take_kept(work, states);
        tinker_contact_check(work, tolerance, NULL);
    }
}
