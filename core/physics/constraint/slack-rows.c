/* Constraint rows that hold in one direction only (a rope): a slack one is a row of zeros in everything that is solved,
 * with 1 on the diagonal of S, so that its multiplier is 0. Which are slack changes at events
 * (contact-change-private.h). */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/model/model-data.h"

void tinker_constraints_set_slack(TinkerModel *model, int32_t row, gboolean slack)
{
    model->constraints.slack[row] = slack;
    model->constraints.factored = model->constraints.keeps_factored = FALSE;
}

void tinker_constraints_set_all_slack(TinkerModel *model, gboolean slack)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->unilateral[row]) tinker_constraints_set_slack(model, row, slack);
}

void tinker_constraints_hide_slack(TinkerConstraints *all)
{
    gsize rows = (gsize)all->rows;
    memcpy(all->own_g, all->g, rows * sizeof(double));
    memcpy(all->own_drift, all->drift, rows * sizeof(double));
    memcpy(all->own_rate, all->rate, rows * sizeof(double));
    memcpy(all->own_jacobian, all->jacobian, all->jacobian_size * sizeof(double));
    all->miss = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        if (!all->slack[row]) {
            all->miss = fmax(all->miss, fabs(all->g[row]) * all->inverse_scales[row]);
            continue;
        }
        int32_t first = all->row_starts[row], entries = all->row_starts[row + 1] - first;
        all->g[row] = all->drift[row] = all->rate[row] = 0;
        memset(all->jacobian + 2 * first, 0, 2 * (gsize)entries * sizeof(double));
    }
    for (int32_t k = 0; k < all->turn_count; k++)
        if (all->slack[all->turns[k].row]) all->jacobian[2 * all->entries + k] = 0;
}

double tinker_constraints_own_rate(const TinkerModel *model, int32_t row)
{
    const TinkerConstraints *all = &model->constraints;
    double sum = all->prescribed ? all->own_rate[row] : 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const TinkerPoint *at = &model->point[all->points[e]];
        sum += all->own_jacobian[2 * e] * at->vx + all->own_jacobian[2 * e + 1] * at->vy;
    }
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++)
        sum += all->own_jacobian[2 * all->entries + k] * model->turns[all->turns[k].turn].speed;
    return sum;
}

double tinker_constraints_own_row_times(const TinkerModel *model, int32_t row, const double *by_body)
{
    const TinkerConstraints *all = &model->constraints;
    double sum = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const double *j = all->own_jacobian + 2 * e, *of = by_body + 2 * all->points[e];
        if (all->points[e] < model->bodies) sum += j[0] * of[0] + j[1] * of[1];
    }
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++)
        sum += all->own_jacobian[2 * all->entries + k] * by_body[all->turns[k].coordinate];
    return sum;
}

double tinker_constraints_own_drift(const TinkerModel *model, int32_t row)
{
    const TinkerConstraints *all = &model->constraints;
    double sum = all->own_drift[row];
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const double *j = all->own_jacobian + 2 * e, *of = model->point_acceleration + 2 * all->points[e];
        if (all->points[e] >= model->bodies) sum += j[0] * of[0] + j[1] * of[1];
    }
    return sum;
}
