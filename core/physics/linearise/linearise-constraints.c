/* Constraints made linear: their rows, and of each the second derivative, by differences of the plugin's own Jacobian.
 */
#include <math.h>
#include <string.h>

#include "numerics/solve/symmetric-eigen.h"
#include "physics/constraint/constraints.h"
#include "physics/linearise/linearise-private.h"
#include "physics/linearise/tolerances.h"
#include "physics/model/angles.h"
#include "physics/model/points.h"

/* A row of the constraints, for the Jacobian evaluated last. */
static void add_row(TinkerLinearisation *linear, const TinkerConstraints *all, int32_t row)
{
    tinker_linear_begin_term(linear, linear->rows, 1);
    g_autofree TinkerCoordinateEntry *entries = tinker_constraints_row_room(all);
    const int32_t count = tinker_constraints_list_row(all, row, entries);
    for (int32_t k = 0; k < count; k++)
        tinker_linear_add_entry(linear, linear->rows, entries[k].coordinate, entries[k].value);
}

/* As an arm r turns, the torque of a force F there changes by -r . F an angle. A force that is rounding holds nothing.
 */
static void add_turned_arm(TinkerLinearisation *linear, const TinkerModel *model, const TinkerAttachment *at,
                           const double force[2])
{
    const int32_t turn = tinker_model_turn_of(model, at->body);
    GArray *terms = hypot(force[0], force[1]) <= linear->force_noise ? linear->rounding : linear->stiffness;
    tinker_linear_begin_term(linear, terms, at->arm[0] * force[0] + at->arm[1] * force[1]);
    tinker_linear_add_entry(linear, terms, turn, 1 / model->turns[model->turn_of[at->body]].gyration);
}

void tinker_linear_add_turned_forces(TinkerLinearisation *linear, const TinkerModel *model)
{
    for (int32_t point = model->first_attachment; point < model->first_support; point++)
        add_turned_arm(linear, model, tinker_model_attachment(model, point),
                       tinker_model_attachment(model, point)->force);
}

void tinker_linear_add_turned_rows(TinkerLinearisation *linear, const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t k = 0; k < all->turn_count; k++) {
        const double *j = all->jacobian + 2 * all->turns[k].entry, lambda = all->lambda[all->turns[k].row];
        add_turned_arm(linear, model, tinker_model_attachment(model, all->ends_at[all->turns[k].entry]),
                       (const double[2]){lambda * j[0], lambda * j[1]});
    }
}

/* Entries of a row for each of its ends. */
static int32_t width_of(const TinkerConstraintBatch *part)
{
    return part->angles != NULL ? 2 : 1;
}

/* Second derivatives of all rows of a part by coordinate `axis` of end `slot` of each instance: 2 entries an end. */
typedef struct {
    const TinkerModel *model;
    TinkerConstraintBatch *part;
    TinkerPoint *ends;
    double *g, *drift, *jacobian;
    double *column; /* 2 per entry of the part */
} Difference;

/* m: the shortest way between two ends of a path that follow each other and are not at one place, or `length`. A path
 * is as long as all of it, and as curved as its shortest part. */
static double shortest_way(const Difference *d, int32_t instance, double length)
{
    const int32_t *offsets = d->part->batch->end_offsets;
    double shortest = length;
    for (int32_t e = offsets[instance]; e + 1 < offsets[instance + 1]; e++) {
        const TinkerPoint *from = &d->model->point[d->part->end_points[e]];
        const TinkerPoint *to = &d->model->point[d->part->end_points[e + 1]];
        const double way = hypot(to->x - from->x, to->y - from->y);
        if (way > TINKER_HESSIAN_PART * length) shortest = fmin(shortest, way);
    }
    return shortest;
}

static double step_of(const Difference *d, int32_t instance)
{
    const double *scales = d->model->constraints.scales + d->part->first_row;
    int32_t rows = d->part->constraint->rows;
    double least = scales[instance * rows];
    for (int32_t r = 1; r < rows; r++)
        least = fmin(least, scales[instance * rows + r]);
    if (d->part->constraint->unilateral) least = shortest_way(d, instance, least);
    return TINKER_HESSIAN_STEP * least;
}

/* The coordinate that a difference moves: of an end, or behind the ends of an instance of one's turn. */
static void move(Difference *d, int32_t instance, int32_t slot, int axis, double steps)
{
    const int32_t from = d->part->batch->end_offsets[instance];
    const int32_t ends = d->part->batch->end_offsets[instance + 1] - from;
    if (slot < ends)
        *(axis == 0 ? &d->ends[from + slot].x : &d->ends[from + slot].y) += steps * step_of(d, instance);
    else if (d->part->angles != NULL && slot < 2 * ends && axis == 0)
        d->part->angles->poses[from + slot - ends].angle += steps * TINKER_HESSIAN_ANGLE_STEP;
}

/* How far a step of it is: m, or rad. */
static double step_along(const Difference *d, int32_t instance, int32_t slot)
{
    const int32_t ends = d->part->batch->end_offsets[instance + 1] - d->part->batch->end_offsets[instance];
    return slot < ends ? step_of(d, instance) : TINKER_HESSIAN_ANGLE_STEP;
}

static TinkerStatus differentiate(Difference *d, int32_t slot, int axis)
{
    static const double weights[] = {-1, 9, -45, 0, 45, -9, 1}; /* / 60 h */
    const TinkerBlockBatch *batch = d->part->batch;
    int32_t entries = width_of(d->part) * batch->end_count * d->part->constraint->rows;
    memset(d->column, 0, 2 * (gsize)entries * sizeof(double));
    for (int k = -3; k <= 3; k++) {
        if (k == 0) continue;
        for (int32_t e = 0; e < batch->end_count; e++)
            d->ends[e] = d->model->point[d->part->end_points[e]];
        if (d->part->angles != NULL) tinker_angles_gather(d->part->angles, d->model, 0, batch->end_count);
        for (int32_t i = 0; i < batch->count; i++)
            move(d, i, slot, axis, k);
        TinkerStatus status = tinker_constraints_ask(d->part, &d->part->view, d->ends, d->g, d->jacobian, d->drift);
        if (status != TINKER_OK) return status;
        for (int32_t e = 0; e < 2 * entries; e++)
            d->column[e] += weights[k + 3] * d->jacobian[e];
    }
    for (int32_t e = 0; e < 2 * entries; e++)
        if (fabs(d->column[e]) <= TINKER_HESSIAN_ROUNDING * fabs(d->jacobian[e])) d->column[e] = 0;
    return TINKER_OK;
}

/* The second derivative of one row, as parts of rank one with the weight -lambda. What nothing pulls at holds nothing:
 * a pull that is rounding, as of a rod on which nothing hangs, counts as none. */
static gboolean add_hessian(TinkerLinearisation *linear, const TinkerModel *model, int32_t row, double *hessian)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t first = all->row_starts[row], n = 2 * (all->row_starts[row + 1] - first);
    g_autofree double *vectors = g_new0(double, (gsize)n *(gsize)n);
    double largest = 0;
    for (int32_t i = 0; i < n; i++) {
        vectors[i + n * i] = 1;
        for (int32_t k = 0; k < i; k++)
            hessian[i + n * k] = hessian[k + n * i] = 0.5 * (hessian[i + n * k] + hessian[k + n * i]);
    }
    if (fabs(all->lambda[row]) <= linear->force_noise) return TRUE;
    if (!tinker_symmetric_eigen(n, hessian, n, vectors)) return FALSE;
    for (int32_t i = 0; i < n; i++)
        largest = fmax(largest, fabs(hessian[i + n * i]));
    for (int32_t i = 0; i < n; i++) {
        double value = hessian[i + n * i];
        if (fabs(value) <= TINKER_HESSIAN_NOISE * largest) continue;
        tinker_linear_begin_term(linear, linear->stiffness, -all->lambda[row] * value);
        for (int32_t k = 0; k < n; k += 2)
            tinker_linear_add_point(linear, model, linear->stiffness, all->ends_at[first + k / 2], vectors[k + n * i],
                                    vectors[k + 1 + n * i]);
    }
    return TRUE;
}

/* The second derivatives of all rows, side by side: of each row its columns, from 4 * most * its first entry on. */
static TinkerStatus fill_hessians(Difference *d, int32_t most, double *hessians)
{
    const TinkerConstraints *all = &d->model->constraints;
    const TinkerConstraintBatch *part = d->part;
    for (int32_t slot = 0; slot < most; slot++)
        for (int axis = 0; axis < 2; axis++) {
            TinkerStatus status = differentiate(d, slot, axis);
            if (status != TINKER_OK) return status;
            for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
                int32_t at = all->row_starts[row] - part->first_entry;
                int32_t n = 2 * (all->row_starts[row + 1] - all->row_starts[row]);
                if (2 * slot >= n) continue;
                double *column = hessians + 4 * (gsize)most * (gsize)at + (gsize)n * (gsize)(2 * slot + axis);
                for (int32_t k = 0; k < n; k++)
                    column[k] = d->column[2 * at + k] /
                                (60 * step_along(d, (row - part->first_row) / part->constraint->rows, slot));
            }
        }
    return TINKER_OK;
}

TinkerStatus tinker_linear_add_constraints(TinkerLinearisation *linear, TinkerModel *model, TinkerConstraintBatch *part)
{
    const TinkerConstraints *all = &model->constraints;
    const TinkerBlockBatch *batch = part->batch;
    int32_t rows = part->constraint->rows, most = 0;
    gsize entries = (gsize)width_of(part) * (gsize)batch->end_count * (gsize)rows;
    for (int32_t i = 0; i < batch->count; i++)
        most = MAX(most, width_of(part) * (batch->end_offsets[i + 1] - batch->end_offsets[i]));
    g_autofree TinkerPoint *ends = g_new0(TinkerPoint, MAX(batch->end_count, 1));
    g_autofree double *room = g_new0(double, 2 * (gsize)part->row_count + 4 * entries + 1);
    g_autofree double *hessians = g_new0(double, MAX(4 * entries * (gsize)most, 1)); /* of each row: its columns */
    Difference d = {model,
                    part,
                    ends,
                    room,
                    room + part->row_count,
                    room + 2 * part->row_count,
                    room + 2 * (gsize)part->row_count + 2 * entries};
    TinkerStatus status = fill_hessians(&d, most, hessians);
    if (status != TINKER_OK) return status;
    for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++) {
        if (all->unilateral != NULL && all->slack[row]) continue;
        add_row(linear, all, row);
        gsize at = (gsize)(all->row_starts[row] - part->first_entry);
        if (!add_hessian(linear, model, row, hessians + 4 * (gsize)most * at)) return TINKER_FAILED;
    }
    return TINKER_OK;
}

/* Motions that the rods of a bar allow turn u and w alike, so that the second derivative of h, 2 u' x w' / L, is 0
 * along them: it adds nothing to the stiffness. */
void tinker_linear_add_straight_rows(TinkerLinearisation *linear, const TinkerConstraints *all)
{
    for (int32_t row = all->first_straight; row < all->rows; row++)
        add_row(linear, all, row);
}
