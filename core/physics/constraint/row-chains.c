/* Chains of rows; see the header.
 *
 * A chain of m rows runs over m + 1 nodes, row i from node i to node i + 1. With w the inverse mass of a node (0 for a
 * support), and u_i, d_i the two entries of row i's Jacobian, on the node before and the one behind it:
 *
 *   S_ii = w_i |u_i|^2 + w_(i+1) |d_i|^2,   S_i,i+1 = w_(i+1) d_i . u_(i+1).
 *
 * Tested through rods in tests/physics, against the general factorisation and dense elimination. */
#include "physics/constraint/row-chains.h"
#include "physics/model/model-data.h"

#include <string.h>

/* One row of a chain: where it stands in the model's arrays, and the inverse masses of its nodes. */
typedef struct {
    int32_t row;
    int32_t u, d;           /* where its entries begin in the Jacobian */
    int32_t before, behind; /* the points of its nodes */
    double mobility[2];     /* of its nodes */
} Place;

/* What the first pass leaves: 1 / pivot, the entry towards the middle / pivot, the right-hand side substituted. */
typedef struct {
    double inverse, factor, known;
} Solved;

typedef struct {
    int32_t first, count; /* places */
} Chain;

struct _TinkerRowChains {
    int32_t count, bodies;
    Chain *chains;
    Place *places; /* rows in the order along their chain */
    Solved *solved;
};

/* Finding them ----------------------------------------------------------------------------------------------------- */

static int32_t entries_on(const TinkerModel *model, int32_t point)
{
    const int32_t *starts = model->constraints.body_starts;
    return point < model->bodies ? starts[point + 1] - starts[point] : 0;
}

/* The entry on the same body of the other row there; -1 where there is none. */
static int32_t neighbour(const TinkerModel *model, int32_t entry)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t point = all->points[entry];
    if (entries_on(model, point) != 2) return -1;
    const int32_t *on = all->body_entries + all->body_starts[point];
    return on[0] == entry ? on[1] : on[0];
}

/* Whether every row has two entries, of different bodies, and no body has more than two rows. */
static gboolean is_thin(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->rows == 0 || !all->two_entries || all->turn_count > 0 || all->repeats != NULL) return FALSE;
    for (int32_t i = 0; i < model->bodies; i++)
        if (entries_on(model, i) > 2) return FALSE;
    for (int32_t row = 0; row < all->rows; row++)
        if (all->points[2 * row] == all->points[2 * row + 1]) return FALSE;
    return TRUE;
}

static double mobility(const TinkerModel *model, int32_t point)
{
    return point < model->bodies ? model->inverse_mass[point] : 0.0;
}

/* Follows a chain from an entry that no other row shares the body of. */
static void follow(TinkerRowChains *self, const TinkerModel *model, int32_t entry, gboolean *seen)
{
    const int32_t *points = model->constraints.points;
    Chain *chain = &self->chains[self->count];
    if (self->count > 0) chain->first = chain[-1].first + chain[-1].count;
    self->count++;
    for (; entry >= 0; entry = neighbour(model, entry ^ 1)) {
        int32_t before = points[entry], behind = points[entry ^ 1];
        self->places[chain->first + chain->count++] = (Place){
            entry / 2, 2 * entry, 2 * (entry ^ 1), before, behind, {mobility(model, before), mobility(model, behind)}};
        seen[entry / 2] = TRUE;
    }
}

TinkerRowChains *tinker_row_chains_new(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (!is_thin(model)) return NULL;
    gsize rows = (gsize)all->rows;
    TinkerRowChains *self = g_new0(TinkerRowChains, 1);
    self->bodies = model->bodies;
    self->chains = g_new0(Chain, rows);
    self->places = g_new0(Place, rows);
    self->solved = g_new0(Solved, rows);
    g_autofree gboolean *seen = g_new0(gboolean, rows);
    for (int32_t entry = 0; entry < 2 * all->rows; entry++)
        if (!seen[entry / 2] && neighbour(model, entry) < 0) follow(self, model, entry, seen);
    gboolean ring = FALSE; /* has no end to follow it from */
    for (int32_t row = 0; row < all->rows; row++)
        ring |= !seen[row];
    if (ring) g_clear_pointer(&self, tinker_row_chains_free);
    return self;
}

void tinker_row_chains_free(TinkerRowChains *self)
{
    if (self == NULL) return;
    g_free(self->chains);
    g_free(self->places);
    g_free(self->solved);
    g_free(self);
}

/* Solving ---------------------------------------------------------------------------------------------------------- */

#define INLINE __attribute__((always_inline)) static inline

INLINE double demand_at(const Place *at, const double *j, const TinkerRowDemand *demand)
{
    double sum = 0;
    if (demand->u != NULL) {
        const double *before = demand->u + demand->stride * at->before;
        const double *behind = demand->u + demand->stride * at->behind;
        sum = (j[at->u] * before[0] + j[at->u + 1] * before[1]) + (j[at->d] * behind[0] + j[at->d + 1] * behind[1]);
    }
    if (demand->extra != NULL) sum += demand->extra[at->row];
    return demand->sign * sum;
}

INLINE double diagonal_at(const Place *at, const double *j)
{
    return at->mobility[0] * (j[at->u] * j[at->u] + j[at->u + 1] * j[at->u + 1]) +
           at->mobility[1] * (j[at->d] * j[at->d] + j[at->d + 1] * j[at->d + 1]);
}

/* S between a row and the next. */
INLINE double beside(const Place *at, const double *j)
{
    return at->mobility[1] * (j[at->d] * j[at[1].u] + j[at->d + 1] * j[at[1].u + 1]);
}

/* What the rows that were eliminated before take off the next one: its pivot and its right-hand side. */
typedef struct {
    double pivot, known;
    gboolean vanished;
} Carry;

/* Eliminates a row whose entry towards the middle is `entry`. The division of the carry does not wait for the one of
 * the reciprocal. */
INLINE void eliminate(const Place *at, Solved *solved, const double *j, double threshold, const TinkerRowDemand *demand,
                      double entry, Carry *carry)
{
    double diagonal = diagonal_at(at, j), pivot = diagonal - carry->pivot;
    double known = demand_at(at, j, demand) - carry->known;
    double inverse = 1.0 / pivot, factor = entry * inverse;
    carry->vanished |= !(pivot > threshold * diagonal);
    carry->pivot = entry * entry / pivot;
    carry->known = factor * known;
    *solved = (Solved){inverse, factor, known};
}

INLINE gboolean factor_chain(const Place *place, Solved *solved, int32_t count, const double *j, double threshold,
                             const TinkerRowDemand *demand)
{
    Carry left = {0, 0, FALSE}, right = {0, 0, FALSE};
    const Place *a = place, *b = place + count - 1;
    for (; a + 1 < b; a++, b--) {
        eliminate(a, solved + (a - place), j, threshold, demand, beside(a, j), &left);
        eliminate(b, solved + (b - place), j, threshold, demand, beside(b - 1, j), &right);
    }
    if (a < b) {
        eliminate(a, solved + (a - place), j, threshold, demand, beside(a, j), &left);
        a++;
    }
    left.pivot += right.pivot;
    left.known += right.known;
    eliminate(a, solved + (a - place), j, threshold, demand, 0.0, &left);
    return !(left.vanished | right.vanished);
}

INLINE double pass_on(const Place *at, Solved *solved, const double *j, const TinkerRowDemand *demand, double carry)
{
    solved->known = demand_at(at, j, demand) - carry;
    return solved->factor * solved->known;
}

INLINE void substitute_chain(const Place *place, Solved *solved, int32_t count, const double *j,
                             const TinkerRowDemand *demand)
{
    double left = 0, right = 0;
    const Place *a = place, *b = place + count - 1;
    for (; a + 1 < b; a++, b--) {
        left = pass_on(a, solved + (a - place), j, demand, left);
        right = pass_on(b, solved + (b - place), j, demand, right);
    }
    if (a < b) {
        left = pass_on(a, solved + (a - place), j, demand, left);
        a++;
    }
    pass_on(a, solved + (a - place), j, demand, left + right);
}

/* The passes for each kind of demand, so that no loop asks for it. */
#define FOR_DEMANDS(call, demand)                                                                                      \
    do {                                                                                                               \
        if ((demand)->u == NULL)                                                                                       \
            call(&((TinkerRowDemand){NULL, 0, (demand)->extra, (demand)->sign}));                                      \
        else                                                                                                           \
            call(demand);                                                                                              \
    } while (0)

TINKER_VARIANTS gboolean tinker_row_chains_factor(TinkerRowChains *self, const double *jacobian, double threshold,
                                                  const TinkerRowDemand *demand)
{
    gboolean fine = TRUE;
    for (int32_t k = 0; k < self->count; k++) {
        const Chain *chain = &self->chains[k];
#define FACTOR(wanted)                                                                                                 \
    fine &= factor_chain(self->places + chain->first, self->solved + chain->first, chain->count, jacobian, threshold,  \
                         wanted)
        FOR_DEMANDS(FACTOR, demand);
#undef FACTOR
    }
    return fine;
}

TINKER_VARIANTS void tinker_row_chains_substitute(TinkerRowChains *self, const double *jacobian,
                                                  const TinkerRowDemand *demand)
{
    for (int32_t k = 0; k < self->count; k++) {
        const Chain *chain = &self->chains[k];
#define SUBSTITUTE(wanted)                                                                                             \
    substitute_chain(self->places + chain->first, self->solved + chain->first, chain->count, jacobian, wanted)
        FOR_DEMANDS(SUBSTITUTE, demand);
#undef SUBSTITUTE
    }
}

/* Both coordinates of a point at once: written by halves, they could only be read as a whole after some cycles more. */
typedef double Pair __attribute__((vector_size(16)));

INLINE Pair pair_at(const double *from)
{
    Pair pair;
    memcpy(&pair, from, sizeof(pair));
    return pair;
}

/* `fresh`: in place of what stands there. */
INLINE void put_pair(Pair pair, double *to, gboolean fresh)
{
    if (!fresh) pair += pair_at(to);
    memcpy(to, &pair, sizeof(pair));
}

/* On the node between a row, with the multiplier `x`, and the next, with `next`. */
INLINE void push(const Place *at, const double *j, double x, double next, double *target, gboolean fresh)
{
    put_pair(at->mobility[1] * (x * pair_at(j + at->d) + next * pair_at(j + at[1].u)), target + 2 * at->behind, fresh);
}

/* On the first or the last node of a chain, which may lie on a support. */
INLINE void push_end(int32_t point, int32_t bodies, double mobility, const double *j, double x, double *target,
                     gboolean fresh)
{
    if (point < bodies) put_pair(mobility * (x * pair_at(j)), target + 2 * point, fresh);
}

INLINE double backwards(const Solved *at, double next)
{
    return at->known * at->inverse - at->factor * next;
}

INLINE void finish_chain(const Place *place, const Solved *solved, int32_t count, int32_t bodies,
                         const double *restrict j, double *restrict x, double *restrict target, gboolean fresh)
{
    int32_t middle = count / 2, a = middle - 1, b = middle + 1;
    double left = solved[middle].known * solved[middle].inverse, right = left;
    x[place[middle].row] = left;
    for (; a >= 0; a--, b++) {
        double next = backwards(&solved[a], left);
        x[place[a].row] = next;
        if (target != NULL) push(&place[a], j, next, left, target, fresh);
        left = next;
        if (b >= count) continue;
        next = backwards(&solved[b], right);
        x[place[b].row] = next;
        if (target != NULL) push(&place[b - 1], j, right, next, target, fresh);
        right = next;
    }
    if (target == NULL) return;
    const Place *end = &place[count - 1];
    push_end(place->before, bodies, place->mobility[0], j + place->u, left, target, fresh);
    push_end(end->behind, bodies, end->mobility[1], j + end->d, right, target, fresh);
}

TINKER_VARIANTS void tinker_row_chains_finish(TinkerRowChains *self, const double *jacobian, double *x, double *target,
                                              gboolean fresh)
{
    for (int32_t k = 0; k < self->count; k++) {
        const Chain *chain = &self->chains[k];
        const Place *place = self->places + chain->first;
        const Solved *solved = self->solved + chain->first;
        if (target == NULL)
            finish_chain(place, solved, chain->count, self->bodies, jacobian, x, NULL, FALSE);
        else if (fresh)
            finish_chain(place, solved, chain->count, self->bodies, jacobian, x, target, TRUE);
        else
            finish_chain(place, solved, chain->count, self->bodies, jacobian, x, target, FALSE);
    }
}
