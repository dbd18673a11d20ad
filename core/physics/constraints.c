/* Constraint rows and the solve S lambda = b, S = J M^-1 J^T.
 *
 * Where the rows are independent, one factorisation solves it. Where a pivot vanishes (redundant rods, singular places)
 * the solve goes on as a proximal iteration with the shifted matrix S + eps I, which needs no rank:
 *
 *   lambda <- lambda + (S + eps I)^-1 (b - S lambda),  from lambda = 0,  eps = 1e-8 * mean diagonal.
 *
 * It converges to the solution of least norm, since it never leaves the range of S. Source: Parikh, Boyd, "Proximal
 * Algorithms" (2014), section 4.1; tested by rank-deficient frames in tests/physics. A residual that stalls at a state on
 * the constraints means that the rows contradict each other. */
#include "physics/model-private.h"

#include <math.h>
#include <string.h>

/* A row whose pivot falls to this share of its diagonal entry counts as dependent on the others: a mechanism within 1e-5 rad
 * of a singular place. Smaller, and what is left of the row is mostly rounding, which the solve would magnify; larger, and
 * chains of masses in the ratio 1e9 would be taken for singular. */
#define DEPENDENT_PIVOT 1e-10
#define PROXIMAL_SHIFT 1e-8
#define MOST_PROXIMAL_ITERATIONS 60

static TinkerStatus check_rows(TinkerModel *model, const TinkerConstraintBatch *part, const TinkerBatch *view,
                               TinkerStatus status)
{
    const TinkerConstraints *all = &model->constraints;
    if (status == TINKER_FAILED)
        return tinker_model_fail(model, part->batch, view->failed_instance, "constraint", view->failure);
    if (status != TINKER_OK) return status;
    double sum = 0;
    for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++)
        sum += all->g[row] + all->drift[row];
    if (isfinite(sum)) return TINKER_OK;
    for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++)
        if (!isfinite(all->g[row] + all->drift[row]))
            return tinker_model_fail(model, part->batch, (row - part->first_row) / part->constraint->rows, "constraint", NULL);
    return TINKER_OK;
}

static TinkerStatus evaluate_part(TinkerModel *model, const TinkerConstraintBatch *part)
{
    TinkerConstraints *all = &model->constraints;
    TinkerBlockBatch *batch = part->batch;
    for (int32_t e = 0; e < batch->end_count; e++)
        all->ends[e] = model->point[part->end_points[e]];
    TinkerBatch view = tinker_model_view(model, batch, 0, batch->count, model->column_views);
    TinkerStatus status = part->constraint->rows_at(&view, all->ends, all->g + part->first_row,
                                                    all->jacobian + 2 * part->first_entry, all->drift + part->first_row);
    if (status == TINKER_OK && part->constraint->prescribed_rate != NULL) {
        status = part->constraint->prescribed_rate(&view, all->ends, all->rate + part->first_row);
        all->prescribed = TRUE;
    }
    return check_rows(model, part, &view, status);
}

TinkerStatus tinker_constraints_evaluate(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    for (guint i = 0; i < all->batches->len; i++) {
        TinkerStatus status = evaluate_part(model, &g_array_index(all->batches, TinkerConstraintBatch, i));
        if (status != TINKER_OK) return status;
    }
    return TINKER_OK;
}

/* The matrix ------------------------------------------------------------------------------------------------------- */

static void assemble(TinkerConstraints *all)
{
    tinker_sparse_ldl_clear(all->ldl);
    double *values = tinker_sparse_ldl_values(all->ldl);
    const double *restrict j = all->jacobian;
    const TinkerProduct *products = (const TinkerProduct *)(const void *)all->products->data;
    for (guint i = 0; i < all->products->len; i++) {
        const TinkerProduct *p = &products[i];
        const double *first = j + 2 * p->first_entry, *second = j + 2 * p->second_entry;
        values[p->slot] += p->inverse_mass * (first[0] * second[0] + first[1] * second[1]);
    }
}

static double mean_diagonal(const TinkerConstraints *all)
{
    double sum = 0;
    const double *j = all->jacobian;
    const TinkerProduct *products = (const TinkerProduct *)(const void *)all->products->data;
    for (guint i = 0; i < all->products->len; i++) {
        const TinkerProduct *p = &products[i];
        const double *at = j + 2 * p->first_entry;
        if (p->first_entry == p->second_entry) sum += p->inverse_mass * (at[0] * at[0] + at[1] * at[1]);
    }
    return sum / all->rows;
}

/* The matrix depends on the Jacobian alone, so the factor is kept as long as that stays the same to the bit: after a
 * projection the next step's first stage needs no other. */
static void factor(TinkerConstraints *all)
{
    gsize bytes = 2 * (gsize)all->entries * sizeof(double);
    if (all->factored && memcmp(all->jacobian, all->factored_jacobian, bytes) == 0) return;
    memcpy(all->factored_jacobian, all->jacobian, bytes);
    all->factored = TRUE;
    assemble(all);
    all->shifted = FALSE;
    if (all->redundant == 0) {
        if (tinker_sparse_ldl_factor(all->ldl, 0.0, DEPENDENT_PIVOT)) return;
        assemble(all);
    }
    all->shifted = TRUE;
    double shift = PROXIMAL_SHIFT * mean_diagonal(all);
    /* Rows between supports alone have no diagonal at all: the shift stands for all of it. */
    tinker_sparse_ldl_factor(all->ldl, shift > 0 ? shift : 1.0, 0.0);
}

int32_t tinker_constraints_count_dependent(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    assemble(all);
    all->factored = FALSE;
    return tinker_sparse_ldl_count_dependent(all->ldl, DEPENDENT_PIVOT, NULL);
}

/* Loops over rows are written once, for a number of entries that the compiler knows (2, nearly all rows there are) or not.
 * Points on supports carry the weight 0 and the number of the first body, so that no loop has to tell them apart. */
#define FOR_ROWS(all, LOOP)                              \
    do {                                                 \
        if ((all)->two_entries)                          \
            LOOP(2 * row, 2 * row + 2)                   \
        else                                             \
            LOOP((all)->row_starts[row], (all)->row_starts[row + 1]) \
    } while (0)

void tinker_constraints_add_impulse(TinkerModel *model, const double *x, double *target)
{
    const TinkerConstraints *all = &model->constraints;
    const double *restrict j = all->jacobian, *restrict weight = all->weights;
    const int32_t *restrict body = all->targets;
#define ADD_IMPULSE(first, end)                        \
    for (int32_t row = 0; row < all->rows; row++)      \
        for (int32_t e = (first); e < (end); e++) {    \
            double impulse = x[row] * weight[e];       \
            target[2 * body[e]] += impulse * j[2 * e]; \
            target[2 * body[e] + 1] += impulse * j[2 * e + 1]; \
        }
    FOR_ROWS(all, ADD_IMPULSE);
#undef ADD_IMPULSE
}

void tinker_constraints_rows_times(const TinkerConstraints *all, const double *by_point, double *out)
{
    const double *restrict j = all->jacobian;
    const int32_t *restrict point = all->points;
#define ROW_TIMES(first, end)                          \
    for (int32_t row = 0; row < all->rows; row++) {    \
        double sum = 0;                                \
        for (int32_t e = (first); e < (end); e++)      \
            sum += j[2 * e] * by_point[2 * point[e]] + j[2 * e + 1] * by_point[2 * point[e] + 1]; \
        out[row] = sum;                                \
    }
    FOR_ROWS(all, ROW_TIMES);
#undef ROW_TIMES
}

void tinker_constraints_rates(const TinkerModel *model, double *out)
{
    const TinkerConstraints *all = &model->constraints;
    const double *restrict j = all->jacobian;
    const int32_t *restrict point = all->points;
#define ROW_RATE(first, end)                           \
    for (int32_t row = 0; row < all->rows; row++) {    \
        double sum = 0;                                \
        for (int32_t e = (first); e < (end); e++)      \
            sum += j[2 * e] * model->point[point[e]].vx + j[2 * e + 1] * model->point[point[e]].vy; \
        out[row] = sum;                                \
    }
    FOR_ROWS(all, ROW_RATE);
#undef ROW_RATE
    for (int32_t row = 0; all->prescribed && row < all->rows; row++)
        out[row] += all->rate[row];
}

static double greatest(const double *x, int32_t n)
{
    double most = 0;
    for (int32_t i = 0; i < n; i++)
        most = MAX(most, fabs(x[i]));
    return most;
}

/* Answers the residual that is left. Stages of a step stand off the constraints by the step's error, where rows that
 * depend on each other ask for slightly different things: what no multiplier can meet is left over, and does not reach the
 * accelerations, since J^T annuls it. */
static double solve_proximally(TinkerModel *model, double *b)
{
    TinkerConstraints *all = &model->constraints;
    double *x = all->residual, *r = all->correction;
    double scale = greatest(b, all->rows), before = INFINITY, left = scale;
    memset(x, 0, (gsize)all->rows * sizeof(double));
    memcpy(r, b, (gsize)all->rows * sizeof(double));
    for (int iteration = 0; iteration < MOST_PROXIMAL_ITERATIONS; iteration++) {
        if (!(left > 1e-15 * scale) || !(left < 0.5 * before)) break;
        before = left;
        tinker_sparse_ldl_solve(all->ldl, r);
        for (int32_t row = 0; row < all->rows; row++)
            x[row] += r[row];
        memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
        tinker_constraints_add_impulse(model, x, all->by_point);
        tinker_constraints_rows_times(all, all->by_point, r);
        for (int32_t row = 0; row < all->rows; row++)
            r[row] = b[row] - r[row];
        left = greatest(r, all->rows);
    }
    memcpy(b, x, (gsize)all->rows * sizeof(double));
    return scale > 0 ? left / scale : 0;
}

double tinker_constraints_solve(TinkerModel *model, double *b)
{
    TinkerConstraints *all = &model->constraints;
    factor(all);
    if (all->shifted) return solve_proximally(model, b);
    tinker_sparse_ldl_solve(all->ldl, b);
    return 0;
}

void tinker_constraints_solve_roughly(TinkerModel *model, double *b)
{
    TinkerConstraints *all = &model->constraints;
    if (!all->factored || all->shifted)
        tinker_constraints_solve(model, b);
    else
        tinker_sparse_ldl_solve(all->ldl, b);
}

double tinker_constraints_accelerate(TinkerModel *model, double *a)
{
    TinkerConstraints *all = &model->constraints;
    memcpy(model->point_acceleration, a, 2 * (gsize)model->bodies * sizeof(double));
    tinker_constraints_rows_times(all, model->point_acceleration, all->lambda);
    for (int32_t row = 0; row < all->rows; row++)
        all->lambda[row] = -(all->lambda[row] + all->drift[row]);
    double left = tinker_constraints_solve(model, all->lambda);
    tinker_constraints_add_impulse(model, all->lambda, a);
    return left;
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
