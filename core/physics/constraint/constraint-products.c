/* Products with the Jacobian of constraint rows: what multipliers do to bodies, and bodies along rows. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints-private.h"
#include "physics/model/state.h"

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

/* Loops over rows are written once, for a number of entries that the compiler knows (2, nearly all rows there are) or
 * not: LOOP(first entry, their number). Between two ends it would not find that they are two apart. */
#define FOR_ROWS(all, LOOP)                                                                                            \
    do {                                                                                                               \
        if ((all)->two_entries)                                                                                        \
            LOOP(2 * row, 2)                                                                                           \
        else                                                                                                           \
            LOOP((all)->row_starts[row], (all)->row_starts[row + 1] - first)                                           \
    } while (0)

void tinker_constraints_add_impulse(TinkerModel *model, const double *restrict x, double *restrict target)
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
