/* Constraint rows at the state in the points: g, Jacobian and drift, and how far they are off. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/constraint/distance-rows.h"
#include "physics/constraint/straight-bars.h"
#include "physics/model/angles.h"
#include "physics/model/failures.h"
#include "physics/model/points.h"

static G_NO_INLINE TinkerStatus refuse_rows(TinkerModel *model, const TinkerConstraintBatch *part, TinkerStatus status)
{
    const TinkerConstraints *all = &model->constraints;
    if (status == TINKER_RETRY_SMALLER && part->view.failure == NULL) return status;
    if (status != TINKER_OK) {
        const TinkerStatus failed =
            tinker_model_fail(model, part->batch, part->view.failed_instance, "constraint", part->view.failure);
        return status == TINKER_RETRY_SMALLER ? status : failed; // a number that is no status is a failure
    }
    int32_t row = part->first_row;
    while (row < part->first_row + part->row_count - 1 && isfinite(all->g[row] + all->drift[row]))
        row++;
    return tinker_model_not_finite(model, part->batch, (row - part->first_row) / part->constraint->rows, "constraint");
}

/* Sums of zeros, unless something is not finite; several of them, so that additions do not wait for each other. Finds
 * the largest miss on the way. */
static gboolean look_at_rows(TinkerConstraints *all, const TinkerConstraintBatch *part)
{
    const double *restrict g = all->g + part->first_row, *restrict drift = all->drift + part->first_row;
    const double *restrict inverse = all->inverse_scales + part->first_row;
    double sums[4] = {0, 0, 0, 0}, most[4] = {all->miss, 0, 0, 0};
    int32_t row = 0;
    for (; row + 4 <= part->row_count; row += 4)
        for (int k = 0; k < 4; k++) {
            sums[k] += 0.0 * (g[row + k] + drift[row + k]);
            most[k] = MAX(most[k], fabs(g[row + k]) * inverse[row + k]);
        }
    for (; row < part->row_count; row++) {
        sums[0] += 0.0 * (g[row] + drift[row]);
        most[0] = MAX(most[0], fabs(g[row]) * inverse[row]);
    }
    all->miss = MAX(MAX(most[0], most[1]), MAX(most[2], most[3]));
    return sums[0] + sums[1] + sums[2] + sums[3] == 0;
}

static void gather(const TinkerModel *model, const int32_t *points, int32_t count)
{
    TinkerPoint *restrict ends = model->constraints.ends;
    const TinkerPoint *restrict point = model->point;
#pragma GCC unroll 4
    for (int32_t e = 0; e < count; e++)
        ends[e] = point[points[e]];
}

/* What rows that depend on angles answered, in the order of the entries: of each row its ends, then their turns. */
static void spread_columns(const TinkerConstraintBatch *part, const TinkerBatch *view, const double *columns,
                           double *jacobian)
{
    const int32_t *offsets = part->batch->end_offsets + view->first, rows = part->constraint->rows;
    const double *angular = view->angular;
    for (int32_t i = 0; i < view->count; i++)
        for (int32_t r = 0; r < rows; r++) {
            const int32_t ends = offsets[i + 1] - offsets[i];
            memcpy(jacobian, columns, 2 * (gsize)ends * sizeof(double));
            jacobian += 2 * ends;
            columns += 2 * ends;
            for (int32_t k = 0; k < ends; k++) {
                *jacobian++ = *angular++;
                *jacobian++ = 0;
            }
        }
}

TinkerStatus tinker_constraints_ask(const TinkerConstraintBatch *part, TinkerBatch *view, const TinkerPoint *ends,
                                    double *g, double *jacobian, double *drift)
{
    TinkerAngles *angles = part->angles;
    const TinkerConstraint *constraint = part->constraint;
    if (G_LIKELY(angles == NULL))
        return TINKER_CALL_BATCH(part->batch, "rows_at", view, constraint->rows_at(view, ends, g, jacobian, drift));
    const int32_t *offsets = part->batch->end_offsets + view->first;
    tinker_angles_show(angles, view, offsets[0], offsets[view->count] - offsets[0]);
    TinkerStatus status =
        TINKER_CALL_BATCH(part->batch, "rows_at", view, constraint->rows_at(view, ends, g, angles->jacobian, drift));
    if (status == TINKER_OK) spread_columns(part, view, angles->jacobian, jacobian);
    return status;
}

/* Asks for the rows of a range of blocks. */
static TinkerStatus ask_rows(TinkerModel *model, const TinkerConstraintBatch *part, TinkerBatch *view)
{
    TinkerConstraints *all = &model->constraints;
    const int32_t *offsets = part->batch->end_offsets;
    int32_t from = offsets[view->first], rows = part->constraint->rows,
            count = offsets[view->first + view->count] - from;
    int32_t first_row = part->first_row + view->first * rows;
    int32_t first_entry = part->first_entry + (part->angles != NULL ? 2 : 1) * from * rows;
    gather(model, part->end_points + from, count);
    if (part->angles != NULL) tinker_angles_gather(part->angles, model, from, count);
    TinkerStatus status = tinker_constraints_ask(part, view, all->ends, all->g + first_row,
                                                 all->jacobian + 2 * first_entry, all->drift + first_row);
    if (status == TINKER_OK && part->constraint->prescribed_rate != NULL) {
        status = TINKER_CALL_BATCH(part->batch, "prescribed_rate", view,
                                   part->constraint->prescribed_rate(view, all->ends, all->rate + first_row));
        all->prescribed = TRUE;
    }
    return status;
}

/* In chunks whose ends stay in the cache. */
static TinkerStatus ask_by_chunks(TinkerModel *model, TinkerConstraintBatch *part)
{
    TinkerStatus status = TINKER_OK;
    for (int32_t first = 0; first < part->batch->count && status == TINKER_OK; first += TINKER_CHUNK) {
        int32_t count = MIN(TINKER_CHUNK, part->batch->count - first);
        TinkerBatch view = tinker_model_view(model, part->batch, first, count, model->column_views);
        status = ask_rows(model, part, &view);
        part->view.failure = view.failure;
        part->view.failed_instance = first + MAX(view.failed_instance, 0);
    }
    return status;
}

/* Rows that keep a distance are worked out from the points where they are. */
static inline TinkerStatus evaluate_distances(TinkerModel *model, const TinkerConstraintBatch *part)
{
    TinkerConstraints *all = &model->constraints;
    int32_t first = part->first_row;
    TinkerDistances rows = {part->row_count, part->end_points, part->distances, all->inverse_scales + first};
    if (G_LIKELY(tinker_distance_rows(&rows, model->point, all->g + first, all->jacobian + 2 * part->first_entry,
                                      all->drift + first, &all->miss)))
        return TINKER_OK;
    return refuse_rows(model, part, TINKER_OK);
}

/* What an end on a body that turns adds to the two rows of ends that coincide: their entries in the column of the turn,
 * and their drift. */
static inline void turn_coincident(const TinkerModel *model, int32_t point, double sign, double column[2],
                                   double drift[2])
{
    const TinkerAttachment *at = tinker_model_attachment(model, point);
    const TinkerTurn *turn = &model->turns[model->turn_of[at->body]];
    const double square = turn->rate * turn->rate, arm[2] = {sign * at->arm[0], sign * at->arm[1]};
    column[0] = -arm[1] * turn->by_gyration;
    column[1] = arm[0] * turn->by_gyration;
    drift[0] -= square * arm[0];
    drift[1] -= square * arm[1];
}

static inline void find_gap(const TinkerModel *model, const int32_t ends[2], double gap[2])
{
    const TinkerPoint *a = &model->point[ends[0]], *b = &model->point[ends[1]];
    gap[0] = b->x - a->x;
    gap[1] = b->y - a->y;
}

/* Rows whose ends coincide, with their columns of turns: of both rows of a block the same ones, row by row. */
static TinkerStatus evaluate_coincident(TinkerModel *model, const TinkerConstraintBatch *part)
{
    static const double jacobian[8] = {-1, 0, 1, 0, 0, -1, 0, 1};
    TinkerConstraints *all = &model->constraints;
    double *turned = all->jacobian + 2 * all->entries + tinker_row_turns(all, part->first_row);
    double most = all->miss, sum = 0;
    for (int32_t i = 0, row = part->first_row; i < part->batch->count; i++, row += 2) {
        const int32_t *ends = part->end_points + 2 * i;
        double gap[2], drift[2] = {0, 0}, column[2][2];
        int turns = 0;
        find_gap(model, ends, gap);
        for (int k = 0; k < 2; k++)
            if (ends[k] >= model->first_attachment && ends[k] < model->first_support)
                turn_coincident(model, ends[k], k == 0 ? -1 : 1, column[turns++], drift);
        for (int k = 0; k < turns; k++) {
            turned[k] = column[k][0];
            turned[turns + k] = column[k][1];
        }
        turned += 2 * turns;
        memcpy(all->jacobian + 2 * part->first_entry + 8 * i, jacobian, sizeof(jacobian));
        memcpy(all->g + row, gap, sizeof(gap));
        memcpy(all->drift + row, drift, sizeof(drift));
        most = MAX(most, MAX(fabs(gap[0]), fabs(gap[1])) * all->inverse_scales[row]);
        sum += 0.0 * (gap[0] + gap[1] + drift[0] + drift[1]);
    }
    all->miss = most;
    if (G_LIKELY(sum == 0)) return TINKER_OK;
    return refuse_rows(model, part, TINKER_OK);
}

/* Rows that their plugin works out. */
static G_NO_INLINE TinkerStatus evaluate_asked(TinkerModel *model, TinkerConstraintBatch *part)
{
    part->view.time = tinker_block_batch_inside(part->batch, model->time);
    part->view.failure = NULL;
    part->view.failed_instance = -1;
    TinkerStatus status =
        part->batch->count > TINKER_CHUNK ? ask_by_chunks(model, part) : ask_rows(model, part, &part->view);
    if (G_LIKELY(status == TINKER_OK && look_at_rows(&model->constraints, part))) return TINKER_OK;
    return refuse_rows(model, part, status);
}

/* The Jacobian that was factored is kept by writing the next one elsewhere. */
static void turn_jacobians(TinkerConstraints *all)
{
    if (!all->keeps_factored) return;
    double *kept = all->jacobian;
    all->jacobian = all->factored_jacobian;
    all->factored_jacobian = kept;
    all->keeps_factored = FALSE;
}

/* Rows are over points; what they are over the coordinates of a body that turns: of a point at its arm r a row with the
 * entry j has r x j / (radius of gyration) in the column of the turn, and w^2 r of the point's acceleration is drift.
 */
static G_NO_INLINE void turn_rows(TinkerModel *model, int32_t first_row, int32_t end_row)
{
    TinkerConstraints *all = &model->constraints;
    double *restrict turned = all->jacobian + 2 * all->entries;
    const TinkerAttachment *attachments = (const TinkerAttachment *)(const void *)model->attachments->data;
    for (int32_t k = tinker_row_turns(all, first_row); k < tinker_row_turns(all, end_row); k++) {
        const TinkerTurnEntry *of = &all->turns[k];
        const TinkerTurn *turn = &model->turns[of->turn];
        const TinkerAttachment *at = &attachments[of->attachment];
        double *j = all->jacobian + 2 * of->entry;
        const double *r = at->arm;
        if (at->turn) { // not along the body's centre, which it shares its entries with
            turned[k] = j[0] * turn->by_gyration;
            j[0] = 0;
            continue;
        }
        turned[k] = (r[0] * j[1] - r[1] * j[0]) * turn->by_gyration;
        all->drift[of->row] -= turn->rate * turn->rate * (r[0] * j[0] + r[1] * j[1]);
    }
}

TinkerStatus tinker_constraints_evaluate(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    turn_jacobians(all);
    model->turned = TRUE;
    all->miss = 0;
    for (guint i = 0; i < all->batches->len; i++) {
        TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        TinkerStatus status = part->distances != NULL ? evaluate_distances(model, part)
                              : part->coincident      ? evaluate_coincident(model, part)
                                                      : evaluate_asked(model, part);
        if (status != TINKER_OK) return status;
        if (G_UNLIKELY(all->turn_count > 0 && !part->coincident))
            turn_rows(model, part->first_row, part->first_row + part->row_count);
    }
    if (G_UNLIKELY(all->straight->len > 0)) {
        tinker_straight_rows_evaluate(model);
        if (all->turn_count > 0) turn_rows(model, all->first_straight, all->rows);
    }
    if (G_UNLIKELY(all->unilateral != NULL)) tinker_constraints_hide_slack(all);
    model->turned = FALSE;
    return TINKER_OK;
}

gboolean tinker_constraints_are_gaps(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    gboolean gaps = all->straight->len == 0 && all->unilateral == NULL;
    for (guint i = 0; i < all->batches->len; i++)
        gaps &= g_array_index(all->batches, TinkerConstraintBatch, i).coincident;
    return gaps;
}

TinkerStatus tinker_constraints_find_gaps(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    double most = 0;
    for (guint p = 0; p < all->batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, p);
        double *restrict g = all->g + part->first_row, sum = 0;
        const double *restrict inverse = all->inverse_scales + part->first_row;
        for (int32_t i = 0; i < part->row_count; i += 2) {
            find_gap(model, part->end_points + i, g + i);
            most = MAX(most, MAX(fabs(g[i]), fabs(g[i + 1])) * inverse[i]);
            sum += 0.0 * (g[i] + g[i + 1]);
        }
        if (G_UNLIKELY(sum != 0)) return refuse_rows(model, part, TINKER_OK);
    }
    all->miss = most;
    return TINKER_OK;
}
