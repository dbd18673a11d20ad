/* Chains of pinned bodies; see the header.
 *
 * A chain of m blocks runs over m + 1 nodes, block i from node i to node i + 1. Of ends that coincide a block's
 * Jacobian has on the node before it (u I, U_i) and on the one behind it (d I, D_i), with u and d 1 or -1 and the
 * columns of the turns U_i and D_i. With w the inverse mass of a node (0 for a support):
 *
 *   S_ii = w_i (I + U_i U_i^T) + w_(i+1) (I + D_i D_i^T),   S_i,i+1 = w_(i+1) (d_i u_(i+1) I + D_i U_(i+1)^T).
 *
 * Tested through bars in tests/physics/test-mechanisms.c, against the general factorisation. */
#include "physics/constraint/pin-chains.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/repeated-rows.h"
#include "physics/model/points.h"

#include <string.h>

#define ROWS 2 /* of a block */

/* One side of a block: where it stands in the model's arrays. */
typedef struct {
    int32_t turn[ROWS]; /* where the entries of its turn stand in the Jacobian; -1: none */
    int32_t point;
    int32_t coordinate; /* of its turn; -1: it has none */
    double sign;        /* of its entries */
    double mobility;    /* 1/kg: of the node; 0: a support */
} Side;

typedef struct {
    int32_t row;
    Side side[2]; /* before, behind */
} Place;

/* What the first pass leaves: the columns of the turns before and behind, the inverse of the pivot (11, 12, 22), S
 * beside it, and the right-hand side substituted. */
typedef struct {
    double column[2][ROWS];
    double inverse[3], beside[ROWS][ROWS], known[ROWS];
} Solved;

typedef struct {
    int32_t first, count; /* places */
} Chain;

struct _TinkerPinChains {
    int32_t count;
    Chain *chains;
    Place *places; /* blocks in the order along their chain */
    Solved *solved;
    gboolean of_factor; /* the columns are those of the Jacobian that was factored */
};

/* Finding them ----------------------------------------------------------------------------------------------------- */

/* A block and one of its ends, as 2 * block + end. */
typedef struct {
    int32_t count;
    int32_t *points;         /* two a block: of its ends, that of the body where they are on one */
    int32_t *first, *second; /* of each body: the ends on it, or -1 */
} Ends;

static gboolean note(int32_t *first, int32_t *second, int32_t end)
{
    int32_t *free_place = *first < 0 ? first : *second < 0 ? second : NULL;
    if (free_place != NULL) *free_place = end;
    return free_place != NULL;
}

/* Whether every block has its ends on different bodies, and no body more than two blocks. */
static gboolean list_ends(const TinkerModel *model, Ends *ends)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t i = 0; i < model->bodies; i++)
        ends->first[i] = ends->second[i] = -1;
    for (int32_t row = 0; row < all->rows; row += ROWS, ends->count++)
        for (int32_t k = 0; k < 2; k++) {
            const int32_t *own = all->points + all->row_starts[row];
            const int32_t point = ends->points[row + k] = own[k];
            if (own[0] == own[1]) return FALSE;
            if (tinker_row_repeats(all, row)) continue;
            if (point < model->bodies && !note(&ends->first[point], &ends->second[point], row + k)) return FALSE;
        }
    return TRUE;
}

/* The other end on the body of an end; -1: none. */
static int32_t neighbour(const TinkerModel *model, const Ends *ends, int32_t end)
{
    const int32_t point = ends->points[end];
    if (point >= model->bodies) return -1;
    return ends->first[point] == end ? ends->second[point] : ends->first[point];
}

static Side side_of(const TinkerModel *model, const Ends *ends, int32_t end)
{
    const TinkerConstraints *all = &model->constraints;
    const int32_t row = end & ~1, point = ends->points[end];
    Side side = {.point = point, .coordinate = -1, .sign = (end & 1) == 0 ? -1 : 1};
    if (point < model->bodies) {
        side.coordinate = tinker_model_turn_of(model, point);
        side.mobility = model->inverse_mass[point];
    }
    for (int32_t r = 0; r < ROWS; r++) {
        const int32_t entry = all->row_starts[row + r] + (end & 1);
        side.turn[r] = -1;
        for (int32_t k = tinker_row_turns(all, row + r); k < tinker_row_turns(all, row + r + 1); k++)
            if (all->turns[k].entry == entry) side.turn[r] = 2 * all->entries + k;
    }
    return side;
}

/* Follows a chain from an end that no other block shares the body of. */
static void follow(TinkerPinChains *self, const TinkerModel *model, const Ends *ends, int32_t end, gboolean *seen)
{
    Chain *chain = &self->chains[self->count];
    if (self->count > 0) chain->first = chain[-1].first + chain[-1].count;
    self->count++;
    for (; end >= 0; end = neighbour(model, ends, end ^ 1)) {
        self->places[chain->first + chain->count++] =
            (Place){end & ~1, {side_of(model, ends, end), side_of(model, ends, end ^ 1)}};
        seen[end / 2] = TRUE;
    }
}

static TinkerPinChains *chains_of(const TinkerModel *model, const Ends *ends)
{
    const gsize blocks = (gsize)ends->count;
    TinkerPinChains *self = g_new0(TinkerPinChains, 1);
    self->chains = g_new0(Chain, blocks);
    self->places = g_new0(Place, blocks);
    self->solved = g_new0(Solved, blocks);
    g_autofree gboolean *seen = g_new0(gboolean, blocks);
    for (int32_t i = 0; i < model->constraints.repeated_count; i++)
        seen[model->constraints.repeated[i].row / ROWS] = TRUE;
    for (int32_t end = 0; end < 2 * ends->count; end++)
        if (!seen[end / 2] && neighbour(model, ends, end) < 0) follow(self, model, ends, end, seen);
    gboolean ring = FALSE; /* has no end to follow it from */
    for (gsize block = 0; block < blocks; block++)
        ring |= !seen[block];
    if (ring) g_clear_pointer(&self, tinker_pin_chains_free);
    return self;
}

TinkerPinChains *tinker_pin_chains_new(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    if (all->rows == 0 || all->turn_count == 0 || !tinker_constraints_are_gaps(model)) return NULL;
    Ends ends = {0, g_new(int32_t, all->rows), g_new(int32_t, MAX(model->bodies, 1)),
                 g_new(int32_t, MAX(model->bodies, 1))};
    TinkerPinChains *self = list_ends(model, &ends) ? chains_of(model, &ends) : NULL;
    g_free(ends.points);
    g_free(ends.first);
    g_free(ends.second);
    return self;
}

void tinker_pin_chains_free(TinkerPinChains *self)
{
    if (self == NULL) return;
    g_free(self->chains);
    g_free(self->places);
    g_free(self->solved);
    g_free(self);
}

/* Solving ---------------------------------------------------------------------------------------------------------- */

static inline void take_columns(const Place *at, const double *j, Solved *solved)
{
    for (int k = 0; k < 2; k++)
        for (int r = 0; r < ROWS; r++)
            solved->column[k][r] = at->side[k].turn[r] >= 0 ? j[at->side[k].turn[r]] : 0;
}

static inline void add_demand(const Side *side, const double column[ROWS], const TinkerRowDemand *demand,
                              double known[ROWS])
{
    const double *at = demand->u + demand->stride * side->point;
    const double turned = side->coordinate >= 0 ? demand->u[side->coordinate] : 0;
    for (int r = 0; r < ROWS; r++)
        known[r] += side->sign * at[r] + column[r] * turned;
}

static inline void demand_of(const Place *at, const Solved *solved, const TinkerRowDemand *demand, double known[ROWS])
{
    known[0] = known[1] = 0;
    for (int k = 0; k < 2 && demand->u != NULL; k++)
        add_demand(&at->side[k], solved->column[k], demand, known);
    for (int r = 0; r < ROWS; r++)
        known[r] = demand->sign * (known[r] + (demand->extra != NULL ? demand->extra[at->row + r] : 0));
}

/* What the block before takes off the known side: (S beside)^T times its solution alone. */
static inline void pass_on(const Solved *before, double known[ROWS])
{
    const double *p = before->inverse, *y = before->known;
    const double x[ROWS] = {p[0] * y[0] + p[1] * y[1], p[1] * y[0] + p[2] * y[1]};
    for (int r = 0; r < ROWS; r++)
        known[r] -= before->beside[0][r] * x[0] + before->beside[1][r] * x[1];
}

/* S of a block: 11, 12, 22. */
static inline void diagonal_of(const Place *at, const Solved *solved, double out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (int k = 0; k < 2; k++) {
        const double w = at->side[k].mobility, *n = solved->column[k];
        out[0] += w * (1 + n[0] * n[0]);
        out[1] += w * (n[0] * n[1]);
        out[2] += w * (1 + n[1] * n[1]);
    }
}

/* S of a block and the one behind it. */
static inline void find_beside(const Place *at, Solved *solved)
{
    const double w = at[1].side[0].mobility, same = at->side[1].sign * at[1].side[0].sign;
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < ROWS; c++)
            solved->beside[r][c] = w * ((r == c ? same : 0) + solved->column[1][r] * solved[1].column[0][c]);
}

/* Takes (S beside)^T P^-1 (S beside) of the block before off a diagonal. */
static inline void take_off(const Solved *before, double pivot[3])
{
    const double *p = before->inverse, (*s)[ROWS] = before->beside;
    double half[ROWS][ROWS];
    for (int c = 0; c < ROWS; c++) {
        half[0][c] = p[0] * s[0][c] + p[1] * s[1][c];
        half[1][c] = p[1] * s[0][c] + p[2] * s[1][c];
    }
    pivot[0] -= s[0][0] * half[0][0] + s[1][0] * half[1][0];
    pivot[1] -= s[0][0] * half[0][1] + s[1][0] * half[1][1];
    pivot[2] -= s[0][1] * half[0][1] + s[1][1] * half[1][1];
}

/* FALSE where a pivot vanishes beside the diagonal. */
static inline gboolean invert(const double pivot[3], const double diagonal[3], double threshold, double inverse[3])
{
    const double determinant = pivot[0] * pivot[2] - pivot[1] * pivot[1], scale = 1 / determinant;
    inverse[0] = pivot[2] * scale;
    inverse[1] = -pivot[1] * scale;
    inverse[2] = pivot[0] * scale;
    return pivot[0] > threshold * diagonal[0] && determinant > threshold * diagonal[2] * pivot[0];
}

static gboolean factor_chain(const Place *place, Solved *solved, int32_t count, const double *j, double threshold,
                             const TinkerRowDemand *demand)
{
    gboolean fine = TRUE;
    for (int32_t i = 0; i < count; i++) {
        double diagonal[3], pivot[3];
        take_columns(&place[i], j, &solved[i]);
        diagonal_of(&place[i], &solved[i], diagonal);
        demand_of(&place[i], &solved[i], demand, solved[i].known);
        memcpy(pivot, diagonal, sizeof(pivot));
        if (i > 0) {
            find_beside(&place[i - 1], &solved[i - 1]);
            take_off(&solved[i - 1], pivot);
            pass_on(&solved[i - 1], solved[i].known);
        }
        fine &= invert(pivot, diagonal, threshold, solved[i].inverse);
    }
    return fine;
}

gboolean tinker_pin_chains_factor(TinkerPinChains *self, const double *jacobian, double threshold,
                                  const TinkerRowDemand *demand)
{
    gboolean fine = TRUE;
    self->of_factor = TRUE;
    for (int32_t k = 0; k < self->count; k++) {
        const Chain *chain = &self->chains[k];
        fine &= factor_chain(self->places + chain->first, self->solved + chain->first, chain->count, jacobian,
                             threshold, demand);
    }
    return fine;
}

/* What a demand is of are the rows evaluated last, which may not be those of the factor. */
static void take_all_columns(TinkerPinChains *self, const double *jacobian)
{
    for (int32_t k = 0; k < self->count; k++)
        for (int32_t i = self->chains[k].first; i < self->chains[k].first + self->chains[k].count; i++)
            take_columns(&self->places[i], jacobian, &self->solved[i]);
}

void tinker_pin_chains_substitute(TinkerPinChains *self, const double *jacobian, gboolean of_factor,
                                  const TinkerRowDemand *demand)
{
    if (!of_factor || !self->of_factor) take_all_columns(self, jacobian);
    self->of_factor = of_factor;
    for (int32_t k = 0; k < self->count; k++) {
        const Chain *chain = &self->chains[k];
        for (int32_t i = chain->first; i < chain->first + chain->count; i++) {
            Solved *solved = &self->solved[i];
            demand_of(&self->places[i], solved, demand, solved->known);
            if (i > chain->first) pass_on(solved - 1, solved->known);
        }
    }
}

/* The sum of what the blocks before and behind give to a node; `fresh`: in place of what stands there. */
static inline void push(const Side *node, const double sum[3], double *target, gboolean fresh)
{
    if (!(node->mobility > 0)) return;
    double *at = target + 2 * node->point, *turned = node->coordinate >= 0 ? target + node->coordinate : NULL;
    at[0] = (fresh ? 0 : at[0]) + node->mobility * sum[0];
    at[1] = (fresh ? 0 : at[1]) + node->mobility * sum[1];
    if (turned != NULL) *turned = (fresh ? 0 : *turned) + node->mobility * sum[2];
}

/* What a block gives to the node at one of its sides. */
static inline void add_block(const Side *side, const double column[ROWS], const double x[ROWS], double sum[3])
{
    sum[0] += side->sign * x[0];
    sum[1] += side->sign * x[1];
    sum[2] += x[0] * column[0] + x[1] * column[1];
}

static void finish_chain(const Place *place, const Solved *solved, int32_t count, double *x, double *target,
                         gboolean fresh)
{
    double next[ROWS] = {0, 0}, behind[3] = {0, 0, 0}; /* of the block behind: its multipliers, and its impulse */
    for (int32_t i = count - 1; i >= 0; i--) {
        const double *p = solved[i].inverse, (*s)[ROWS] = solved[i].beside;
        const double known[ROWS] = {solved[i].known[0] - (s[0][0] * next[0] + s[0][1] * next[1]),
                                    solved[i].known[1] - (s[1][0] * next[0] + s[1][1] * next[1])};
        next[0] = x[place[i].row] = p[0] * known[0] + p[1] * known[1];
        next[1] = x[place[i].row + 1] = p[1] * known[0] + p[2] * known[1];
        if (target == NULL) continue;
        add_block(&place[i].side[1], solved[i].column[1], next, behind);
        push(&place[i].side[1], behind, target, fresh);
        memset(behind, 0, sizeof(behind));
        add_block(&place[i].side[0], solved[i].column[0], next, behind);
    }
    if (target != NULL) push(&place[0].side[0], behind, target, fresh);
}

void tinker_pin_chains_finish(TinkerPinChains *self, double *x, double *target, gboolean fresh)
{
    for (int32_t k = 0; k < self->count; k++) {
        const Chain *chain = &self->chains[k];
        finish_chain(self->places + chain->first, self->solved + chain->first, chain->count, x, target, fresh);
    }
}
