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
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "numerics/solve/rank.h"
#include "physics/constraint/constraints-private.h"
#include "physics/constraint/pin-chains.h"
#include "physics/constraint/repeated-rows.h"
#include "physics/constraint/row-chains.h"
#include "physics/constraint/tolerances.h"

#define MOST_PROXIMAL_ITERATIONS 60

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
        all->rounds_taken = iteration + 1;
        tinker_constraints_substitute(all, r);
        for (int32_t row = 0; row < all->rows; row++)
            x[row] += r[row];
        memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
        tinker_constraints_add_impulse(model, x, all->by_point);
        tinker_constraints_rows_times(all, all->by_point, r);
        for (int32_t row = 0; row < all->rows; row++)
            r[row] = tinker_row_repeats(all, row) ? 0 : b[row] - r[row];
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
    tinker_repeated_rows_spread(all, x);
}

/* What all rows ask for as the first ones of those that repeat them are to: itself where none does, else in lambda. */
static const double *fold(TinkerConstraints *all, const double *extra)
{
    if (all->repeated_count == 0) return extra;
    memcpy(all->lambda, extra, (gsize)all->rows * sizeof(double));
    tinker_repeated_rows_fold(all, all->lambda);
    return all->lambda;
}

/* Where the rows are chains without dependent ones, solves for a demand up to the last pass, with the factor of the
 * rows evaluated last, or `roughly` with any. FALSE: the general way is left, with a shifted factor where the rows
 * turned out to depend on each other here. */
static gboolean solve_chains(TinkerConstraints *all, const TinkerRowDemand *demand, gboolean roughly)
{
    if ((all->chains == NULL && all->pin_chains == NULL) || tinker_constraints_are_proximal(all)) return FALSE;
    const gboolean any = roughly && all->factored && !all->shifted,
                   of_factor = !any && tinker_constraints_are_factored(all);
    if (any || of_factor) {
        if (!all->shifted) substitute_chains(all, demand, of_factor);
        return !all->shifted;
    }
    all->factored = all->keeps_factored = TRUE;
    all->shifted = FALSE;
    if (factor_chains(all, demand)) return TRUE;
    tinker_constraints_factor_shifted(all);
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
            tinker_constraints_factor_shifted(all);
        else if (!solve_chains(all, &(TinkerRowDemand){.extra = all->correction, .sign = 1}, FALSE))
            tinker_constraints_factor_and_solve(all, all->correction);
    }
    memcpy(all->jacobian, all->kept_jacobian, bytes);
    memcpy(all->factored_jacobian, all->kept_factored_jacobian, bytes);
    all->factored = all->kept.factored;
    all->keeps_factored = all->kept.keeps_factored;
    all->shifted = all->kept.shifted;
    model->turned = TRUE;
}

/* Without the rows that repeat others, for which b is 0. */
static double solve_first(TinkerModel *model, double *b)
{
    TinkerConstraints *all = &model->constraints;
    if (solve_chains(all, &(TinkerRowDemand){.extra = b, .sign = 1}, FALSE)) {
        finish_chains(all, b, NULL, FALSE);
        return 0;
    }
    if (!tinker_constraints_are_factored(all) && tinker_constraints_factor_and_solve(all, b)) return 0;
    if (all->shifted) return solve_proximally(model, b);
    tinker_constraints_substitute(all, b);
    return 0;
}

double tinker_constraints_solve(TinkerModel *model, double *b)
{
    const double disagreement = tinker_repeated_rows_fold(&model->constraints, b);
    const double left = solve_first(model, b);
    tinker_repeated_rows_spread(&model->constraints, b);
    return MAX(left, disagreement);
}

void tinker_constraints_newton_step(TinkerModel *model, gboolean roughly)
{
    TinkerConstraints *all = &model->constraints;
    double *displacement = all->displacement; /* 0 on bodies without rows */
    model->corrections++;
    if (solve_chains(all, &(TinkerRowDemand){.extra = fold(all, all->g), .sign = -1}, roughly)) {
        finish_chains(all, all->lambda, displacement, TRUE);
        return;
    }
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] = -all->g[row];
    if (!roughly || !all->factored || all->shifted) {
        tinker_constraints_solve(model, all->lambda);
    } else {
        tinker_repeated_rows_fold(all, all->lambda);
        tinker_constraints_substitute(all, all->lambda);
        tinker_repeated_rows_spread(all, all->lambda);
    }
    memset(displacement, 0, (gsize)model->coordinates * sizeof(double));
    tinker_constraints_add_impulse(model, all->lambda, displacement);
}

void tinker_constraints_change_speeds(TinkerModel *model, const double *asked, double *v)
{
    TinkerConstraints *all = &model->constraints;
    if (solve_chains(all, &(TinkerRowDemand){.extra = fold(all, asked), .sign = 1}, FALSE)) {
        finish_chains(all, all->lambda, v, FALSE);
        return;
    }
    memcpy(all->lambda, asked, (gsize)all->rows * sizeof(double));
    tinker_constraints_solve(model, all->lambda);
    tinker_constraints_add_impulse(model, all->lambda, v);
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
    tinker_constraints_add_impulse(model, change, a);
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] += change[row];
    return left;
}

double tinker_constraints_accelerate(TinkerModel *model, double *a)
{
    TinkerConstraints *all = &model->constraints;
    double *by_point = model->point_acceleration;
    memcpy(by_point, a, (gsize)model->coordinates * sizeof(double));
    if (solve_chains(all, &(TinkerRowDemand){by_point, 2, fold(all, all->drift), -1}, FALSE)) {
        finish_chains(all, all->lambda, a, FALSE);
        return 0;
    }
    tinker_constraints_rows_times(all, by_point, all->lambda);
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] = -all->lambda[row] - all->drift[row];
    double left = tinker_constraints_solve(model, all->lambda);
    tinker_constraints_add_impulse(model, all->lambda, a);
    return all->rows < TINKER_REFINED_ROWS ? left : refine(model, a);
}
