/* The solve of constraint rows, S lambda = b, S = J M^-1 J^T.
 *
 * Where the rows are independent, one factorisation solves it. Where a pivot vanishes (redundant rods, singular places)
 * the solve goes on as a proximal iteration with the shifted matrix S + eps I, which needs no rank:
 *
 *   lambda <- lambda + (S + eps I)^-1 (b - S lambda),  from lambda = 0,  eps = 1e-5 * mean diagonal.
 *
 * It converges to the solution of least norm, since it never leaves the range of S. Source: Parikh, Boyd, "Proximal
 * Algorithms" (2014), section 4.1; tested by rank-deficient frames in tests/physics. A residual that stalls at a state
 * on the constraints means that the rows contradict each other. Where masses differ widely, eps is a share of each
 * row's own diagonal entry: dependent rods between masses in a ratio of 1e9 are solved. A long truss has combinations
 * of rows that are independent by less than this eps; for it one is taken that is as small as it needs (start.c). */
#include "physics/constraint/constraints.h"
#include "numerics/solve/largest.h"
#include "numerics/solve/rank.h"
#include "physics/constraint/pin-chains.h"
#include "physics/constraint/row-chains.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/model-data.h"

#include <math.h>
#include <string.h>

#define MOST_PROXIMAL_ITERATIONS 60

double tinker_constraints_reach(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    double reach = 0;
    for (guint p = 0; p < all->batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, p);
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++)
            if (part->constraint->scale != NULL && all->row_starts[row + 1] - all->row_starts[row] == 1)
                reach = fmax(reach, all->scales[row]);
    }
    return reach;
}

/* The matrix ------------------------------------------------------------------------------------------------------- */

static void assemble(TinkerConstraints *all)
{
    tinker_sparse_ldl_clear(all->ldl);
    double *restrict values = tinker_sparse_ldl_values(all->ldl);
    const double *restrict j = all->jacobian;
    const TinkerProduct *restrict p = all->products;
    const TinkerProduct *end = p + all->product_count;
    while (p < end) {
        int32_t slot = p->slot;
        double sum = 0;
        do {
            const double *first = j + 2 * p->first_entry, *second = j + 2 * p->second_entry;
            sum += p->inverse_mass * (first[0] * second[0] + first[1] * second[1]);
        } while (++p < end && p->slot == slot);
        values[slot] = sum;
    }
    for (gsize i = 0; i < all->turn_product_count; i++) {
        const TinkerProduct *turn = &all->turn_products[i];
        values[turn->slot] += turn->inverse_mass * j[turn->first_entry] * j[turn->second_entry];
    }
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->slack[row]) values[all->diagonal[row]] = 1.0;
    for (int32_t i = 0; i < all->idle_count; i++)
        if (values[all->idle[i].slot] == 0) values[all->idle[i].slot] = 1.0;
}

static double mean_diagonal(const TinkerConstraints *all)
{
    double sum = 0;
    const double *j = all->jacobian;
    const TinkerProduct *products = all->products;
    for (gsize i = 0; i < all->product_count; i++) {
        const TinkerProduct *p = &products[i];
        const double *at = j + 2 * p->first_entry;
        if (p->first_entry == p->second_entry) sum += p->inverse_mass * (at[0] * at[0] + at[1] * at[1]);
    }
    for (gsize i = 0; i < all->turn_product_count; i++) {
        const TinkerProduct *p = &all->turn_products[i];
        if (p->first_entry == p->second_entry) sum += p->inverse_mass * j[p->first_entry] * j[p->first_entry];
    }
    return sum / all->rows;
}

/* The matrix depends on the Jacobian alone, so the factor is kept as long as that stays the same to the bit: after a
 * projection the next step's first stage needs no other. */
static gboolean is_factored(const TinkerConstraints *all)
{
    if (!all->factored || all->keeps_factored) return all->factored;
    if (all->jacobian[0] != all->factored_jacobian[0]) return FALSE;
    return memcmp(all->jacobian, all->factored_jacobian, all->jacobian_size * sizeof(double)) == 0;
}

/* Masses may differ so much that one shift for all rows drowns those of the heavy ones. Then every row is shifted by a
 * share of its own diagonal: the solution is the same motion, of least norm with the multipliers weighed by that.
 * Answers what is left to be added to all of them, which is no more than the least row's share. */
static double shift_rows(TinkerConstraints *all)
{
    double *values = tinker_sparse_ldl_values(all->ldl), least = INFINITY, greatest = 0;
    const TinkerProduct *products = all->products;
    for (gsize i = 0; i < all->product_count; i++) {
        if (products[i].first_entry != products[i].second_entry) continue;
        least = MIN(least, values[products[i].slot]);
        greatest = MAX(greatest, values[products[i].slot]);
    }
    if (!(greatest > TINKER_EVEN_ROWS * least)) return all->shift * mean_diagonal(all);
    int32_t last = -1;
    for (gsize i = 0; i < all->product_count; i++) {
        if (products[i].first_entry != products[i].second_entry || products[i].slot == last) continue;
        last = products[i].slot;
        values[last] *= 1 + all->shift;
    }
    return all->shift * least;
}

static void factor_shifted(TinkerConstraints *all)
{
    assemble(all);
    double shift = shift_rows(all);
    all->shifted = TRUE;
    /* Rows between supports alone have no diagonal at all: the shift stands for all of it. */
    tinker_sparse_ldl_factor(all->ldl, shift > 0 ? shift : 1.0, 0.0);
}

/* Factors S of the rows evaluated last and solves with it, in place of b; FALSE, with b as it was, where the factor had
 * to be shifted. */
static gboolean factor_and_solve(TinkerConstraints *all, double *b)
{
    gsize bytes = (gsize)all->rows * sizeof(double);
    all->factored = TRUE;
    all->shifted = FALSE;
    all->keeps_factored = TRUE;
    if (all->redundant == 0) {
        memcpy(all->residual, b, bytes);
        assemble(all);
        if (tinker_sparse_ldl_factor_and_solve(all->ldl, TINKER_DEPENDENT, b)) return TRUE;
        memcpy(b, all->residual, bytes);
    }
    factor_shifted(all);
    return FALSE;
}

int32_t tinker_constraints_count_dependent(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    assemble(all);
    all->factored = all->keeps_factored = FALSE;
    return tinker_sparse_ldl_count_dependent(all->ldl, TINKER_DEPENDENT, NULL);
}

/* Loops over rows are written once, for a number of entries that the compiler knows (2, nearly all rows there are) or
 * not: LOOP(first entry, their number). Between two ends it would not find that they are two apart. */
#define FOR_ROWS(all, LOOP)                                                                                            \
    do {                                                                                                               \
        if ((all)->two_entries)                                                                                        \
            LOOP(2 * row, 2)                                                                                           \
        else                                                                                                           \
            LOOP((all)->row_starts[row], (all)->row_starts[row + 1] - first)                                           \
    } while (0)

static void add_impulse(TinkerModel *model, const double *restrict x, double *restrict target)
{
    const TinkerConstraints *all = &model->constraints;
    const double *restrict j = all->jacobian, *restrict inverse_mass = model->inverse_mass;
    const int32_t *restrict starts = all->body_starts, *restrict entries = all->body_entries;
    const int32_t *restrict row = all->row_of;
    int32_t bodies = model->bodies;
    for (int32_t i = 0; i < bodies; i++) {
        double px = 0, py = 0;
        for (int32_t p = starts[i]; p < starts[i + 1]; p++) {
            int32_t e = entries[p];
            double force = x[row[e]];
            px += force * j[2 * e];
            py += force * j[2 * e + 1];
        }
        target[2 * i] += px * inverse_mass[i];
        target[2 * i + 1] += py * inverse_mass[i];
    }
    for (int32_t k = 0; k < all->turn_count; k++) {
        const TinkerTurnEntry *of = &all->turns[k];
        target[of->coordinate] += x[of->row] * j[2 * all->entries + k] * inverse_mass[all->points[of->entry]];
    }
}

void tinker_constraints_rows_times(const TinkerConstraints *all, const double *by_point, double *out)
{
    const double *restrict j = all->jacobian;
    const int32_t *restrict point = all->points;
#define ROW_TIMES(begin, count)                                                                                        \
    for (int32_t row = 0; row < all->rows; row++) {                                                                    \
        const int32_t first = (begin);                                                                                 \
        double sum = 0;                                                                                                \
        for (int32_t k = 0, e = first; k < (count); k++, e++)                                                          \
            sum += j[2 * e] * by_point[2 * point[e]] + j[2 * e + 1] * by_point[2 * point[e] + 1];                      \
        out[row] = sum;                                                                                                \
    }
    FOR_ROWS(all, ROW_TIMES);
#undef ROW_TIMES
    for (int32_t k = 0; k < all->turn_count; k++)
        out[all->turns[k].row] += j[2 * all->entries + k] * by_point[all->turns[k].coordinate];
}

static void rates_of_entries(const TinkerModel *model, double *out)
{
    const TinkerConstraints *all = &model->constraints;
    const double *restrict j = all->jacobian;
    const int32_t *restrict point = all->points;
#define ROW_RATE(begin, count)                                                                                         \
    for (int32_t row = 0; row < all->rows; row++) {                                                                    \
        const int32_t first = (begin);                                                                                 \
        double sum = 0;                                                                                                \
        for (int32_t k = 0, e = first; k < (count); k++, e++)                                                          \
            sum += j[2 * e] * model->point[point[e]].vx + j[2 * e + 1] * model->point[point[e]].vy;                    \
        out[row] = sum;                                                                                                \
    }
    FOR_ROWS(all, ROW_RATE);
#undef ROW_RATE
    for (int32_t k = 0; k < all->turn_count; k++)
        out[all->turns[k].row] += j[2 * all->entries + k] * model->turns[all->turns[k].turn].speed;
}

/* What J v comes to in the entries -1 and 1 of two points, and in the columns of their bodies' turns. */
static void rates_of_gaps(const TinkerModel *model, double *out)
{
    const TinkerConstraints *all = &model->constraints;
    for (guint p = 0; p < all->batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, p);
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row += 2) {
            const int32_t *points = all->points + all->row_starts[row], first = tinker_row_turns(all, row);
            const TinkerPoint *a = &model->point[points[0]], *b = &model->point[points[1]];
            const int32_t turns = tinker_row_turns(all, row + 1) - first;
            const double *column = all->jacobian + 2 * all->entries + first;
            double rate[2] = {b->vx - a->vx, b->vy - a->vy};
            for (int32_t k = 0; k < turns; k++) {
                const double speed = model->turns[all->turns[first + k].turn].speed;
                rate[0] += column[k] * speed;
                rate[1] += column[turns + k] * speed;
            }
            memcpy(out + row, rate, sizeof(rate));
        }
    }
}

void tinker_constraints_rates(const TinkerModel *model, double *out)
{
    const TinkerConstraints *all = &model->constraints;
    if (tinker_constraints_are_gaps(model))
        rates_of_gaps(model, out);
    else
        rates_of_entries(model, out);
    for (int32_t row = 0; all->prescribed && row < all->rows; row++)
        out[row] += all->rate[row];
}

/* Sets the rows between supports alone to 0, since no multiplier changes them; answers the largest that they asked for.
 */
static double drop_rows_without_bodies(const TinkerModel *model, double *b)
{
    const TinkerConstraints *all = &model->constraints;
    double most = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        gboolean felt = FALSE;
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            felt |= all->points[e] < model->bodies;
        if (felt) continue;
        most = MAX(most, fabs(b[row]));
        b[row] = 0;
    }
    return most;
}

/* Answers the residual that is left. Stages of a step stand off the constraints by the step's error, where rows that
 * depend on each other ask for slightly different things: what no multiplier can meet is left over, and does not reach
 * the accelerations, since J^T annuls it. It ends when the residual is rounding or no longer halves: close to a
 * singular place that leaves out what would have to be divided by nearly nothing. */
static double solve_proximally(TinkerModel *model, double *b)
{
    TinkerConstraints *all = &model->constraints;
    double *x = all->residual, *r = all->correction;
    double dropped = drop_rows_without_bodies(model, b);
    double scale = tinker_largest(all->rows, b), before = INFINITY, left = scale;
    memset(x, 0, (gsize)all->rows * sizeof(double));
    memcpy(r, b, (gsize)all->rows * sizeof(double));
    for (int iteration = 0; iteration < MOST_PROXIMAL_ITERATIONS; iteration++) {
        if (!(left > 1e-15 * scale) || !(left < 0.5 * before)) break;
        before = left;
        tinker_sparse_ldl_solve(all->ldl, r);
        for (int32_t row = 0; row < all->rows; row++)
            x[row] += r[row];
        memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
        add_impulse(model, x, all->by_point);
        tinker_constraints_rows_times(all, all->by_point, r);
        for (int32_t row = 0; row < all->rows; row++)
            r[row] = b[row] - r[row];
        left = tinker_largest(all->rows, r);
    }
    memcpy(b, x, (gsize)all->rows * sizeof(double));
    return MAX(left, dropped);
}

static gboolean factor_chains(TinkerConstraints *all, const TinkerRowDemand *demand)
{
    if (all->chains != NULL) return tinker_row_chains_factor(all->chains, all->jacobian, TINKER_DEPENDENT, demand);
    return tinker_pin_chains_factor(all->pin_chains, all->jacobian, TINKER_DEPENDENT, demand);
}

static void substitute_chains(TinkerConstraints *all, const TinkerRowDemand *demand, gboolean of_factor)
{
    if (all->chains != NULL)
        tinker_row_chains_substitute(all->chains, all->jacobian, demand);
    else
        tinker_pin_chains_substitute(all->pin_chains, all->jacobian, of_factor, demand);
}

static void finish_chains(TinkerConstraints *all, double *x, double *target, gboolean fresh)
{
    if (all->chains != NULL)
        tinker_row_chains_finish(all->chains, all->jacobian, x, target, fresh);
    else
        tinker_pin_chains_finish(all->pin_chains, x, target, fresh);
}

/* Where the rows are chains without dependent ones, solves for a demand up to the last pass, with the factor of the
 * rows evaluated last, or `roughly` with any. FALSE: the general way is left, with a shifted factor where the rows
 * turned out to depend on each other here. */
static gboolean solve_chains(TinkerConstraints *all, const TinkerRowDemand *demand, gboolean roughly)
{
    if ((all->chains == NULL && all->pin_chains == NULL) || all->redundant > 0) return FALSE;
    const gboolean any = roughly && all->factored && !all->shifted, of_factor = !any && is_factored(all);
    if (any || of_factor) {
        if (!all->shifted) substitute_chains(all, demand, of_factor);
        return !all->shifted;
    }
    all->factored = all->keeps_factored = TRUE;
    all->shifted = FALSE;
    if (factor_chains(all, demand)) return TRUE;
    factor_shifted(all);
    return FALSE;
}

void tinker_constraints_begin_look(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    if (all->rows == 0) return;
    if (!all->looked) {
        gsize bytes = all->jacobian_size * sizeof(double);
        memcpy(all->kept_jacobian, all->jacobian, bytes);
        memcpy(all->kept_factored_jacobian, all->factored_jacobian, bytes);
        all->kept = (TinkerFactorState){all->factored, all->keeps_factored, all->shifted};
        all->looked = TRUE;
    }
    all->factored = all->keeps_factored = FALSE;
}

/* What was evaluated before the look is put back; its factor, which is not kept, comes out to the bit as it was, from a
 * matrix that is. */
void tinker_constraints_end_look(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    if (!all->looked) return;
    gsize bytes = all->jacobian_size * sizeof(double);
    all->looked = FALSE;
    if (all->kept.factored) {
        memcpy(all->jacobian, all->kept.keeps_factored ? all->kept_jacobian : all->kept_factored_jacobian, bytes);
        memset(all->correction, 0, (gsize)all->rows * sizeof(double));
        all->factored = FALSE;
        if (all->kept.shifted)
            factor_shifted(all);
        else if (!solve_chains(all, &(TinkerRowDemand){.extra = all->correction, .sign = 1}, FALSE))
            factor_and_solve(all, all->correction);
    }
    memcpy(all->jacobian, all->kept_jacobian, bytes);
    memcpy(all->factored_jacobian, all->kept_factored_jacobian, bytes);
    all->factored = all->kept.factored;
    all->keeps_factored = all->kept.keeps_factored;
    all->shifted = all->kept.shifted;
    model->turned = TRUE;
}

double tinker_constraints_solve(TinkerModel *model, double *b)
{
    TinkerConstraints *all = &model->constraints;
    if (solve_chains(all, &(TinkerRowDemand){.extra = b, .sign = 1}, FALSE)) {
        finish_chains(all, b, NULL, FALSE);
        return 0;
    }
    if (!is_factored(all) && factor_and_solve(all, b)) return 0;
    if (all->shifted) return solve_proximally(model, b);
    tinker_sparse_ldl_solve(all->ldl, b);
    return 0;
}

void tinker_constraints_newton_step(TinkerModel *model, gboolean roughly)
{
    TinkerConstraints *all = &model->constraints;
    double *displacement = all->displacement; /* 0 on bodies without rows */
    if (solve_chains(all, &(TinkerRowDemand){.extra = all->g, .sign = -1}, roughly)) {
        finish_chains(all, all->lambda, displacement, TRUE);
        return;
    }
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] = -all->g[row];
    if (!roughly || !all->factored || all->shifted)
        tinker_constraints_solve(model, all->lambda);
    else
        tinker_sparse_ldl_solve(all->ldl, all->lambda);
    memset(displacement, 0, (gsize)model->coordinates * sizeof(double));
    add_impulse(model, all->lambda, displacement);
}

void tinker_constraints_change_speeds(TinkerModel *model, const double *asked, double *v)
{
    TinkerConstraints *all = &model->constraints;
    if (solve_chains(all, &(TinkerRowDemand){.extra = asked, .sign = 1}, FALSE)) {
        finish_chains(all, all->lambda, v, FALSE);
        return;
    }
    memcpy(all->lambda, asked, (gsize)all->rows * sizeof(double));
    tinker_constraints_solve(model, all->lambda);
    add_impulse(model, all->lambda, v);
}

void tinker_constraints_answer(TinkerModel *model, double *v)
{
    TinkerConstraints *all = &model->constraints;
    tinker_constraints_rows_times(all, all->by_point, all->asked);
    for (int32_t row = 0; row < all->rows; row++)
        all->asked[row] = -all->asked[row];
    tinker_constraints_change_speeds(model, all->asked, v);
}

/* One step of iterative refinement, with the residual of the accelerations themselves: S lambda = -(J a + drift). */
static double refine(TinkerModel *model, double *a)
{
    TinkerConstraints *all = &model->constraints;
    double *by_point = model->point_acceleration, *change = all->asked;
    memcpy(by_point, a, (gsize)model->coordinates * sizeof(double));
    tinker_constraints_rows_times(all, by_point, change);
    for (int32_t row = 0; row < all->rows; row++)
        change[row] = -change[row] - all->drift[row];
    const double left = tinker_constraints_solve(model, change);
    add_impulse(model, change, a);
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] += change[row];
    return left;
}

double tinker_constraints_accelerate(TinkerModel *model, double *a)
{
    TinkerConstraints *all = &model->constraints;
    double *by_point = model->point_acceleration;
    memcpy(by_point, a, (gsize)model->coordinates * sizeof(double));
    if (solve_chains(all, &(TinkerRowDemand){by_point, 2, all->drift, -1}, FALSE)) {
        finish_chains(all, all->lambda, a, FALSE);
        return 0;
    }
    tinker_constraints_rows_times(all, by_point, all->lambda);
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] = -all->lambda[row] - all->drift[row];
    double left = tinker_constraints_solve(model, all->lambda);
    add_impulse(model, all->lambda, a);
    return all->rows < TINKER_REFINED_ROWS ? left : refine(model, a);
}

void tinker_constraints_add_power(TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; row < all->rows; row++) {
        if (all->prescribed) model->book_power[TINKER_BOOK_MOTORS] -= all->lambda[row] * all->rate[row];
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
            if (all->points[e] < model->bodies) continue;
            const TinkerPoint *at = &model->point[all->points[e]];
            model->book_power[TINKER_BOOK_SUPPORT_MOTION] -=
                all->lambda[row] * (all->jacobian[2 * e] * at->vx + all->jacobian[2 * e + 1] * at->vy);
        }
    }
}

TinkerStatus tinker_constraints_errors(TinkerModel *model, double t, const double *q, const double *v, double *position,
                                       double *velocity)
{
    TinkerConstraints *all = &model->constraints;
    *position = *velocity = 0;
    if (all->rows == 0) return TINKER_OK;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, v);
    status = tinker_constraints_evaluate(model);
    if (status != TINKER_OK) return status;
    tinker_constraints_rates(model, all->residual);
    for (int32_t row = 0; row < all->rows; row++) {
        *position = MAX(*position, fabs(all->g[row]) / all->scales[row]);
        *velocity = MAX(*velocity, fabs(all->residual[row]));
    }
    return TINKER_OK;
}
