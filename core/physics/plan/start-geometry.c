#include "physics/plan/start-geometry.h"

#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/model/angles.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

/* Of a row's length: differences of its Jacobian. */
#define DIFFERENCE 1e-6

typedef struct {
    TinkerModel *model;
    const TinkerConstraintBatch *part;
    const double *lambda;
    TinkerPoint *ends;
    double *g, *drift, *low, *high; /* of the batch; low and high are Jacobians */
    GArray *found;                  /* of TinkerStiffnessEntry */
} Geometry;

static double *moved_coordinate(TinkerPoint *end, int k)
{
    return k == 0 ? &end->x : &end->y;
}

static int32_t end_count(const TinkerConstraintBatch *part, int32_t instance)
{
    return part->batch->end_offsets[instance + 1] - part->batch->end_offsets[instance];
}

/* Entries of a row of an instance: its ends, and behind them their turns where the rows depend on angles. */
static int32_t entry_count(const TinkerConstraintBatch *part, int32_t instance)
{
    return (part->angles != NULL ? 2 : 1) * end_count(part, instance);
}

/* The point of an entry of an instance. */
static int32_t entry_point(const TinkerConstraintBatch *part, int32_t instance, int32_t slot)
{
    const int32_t from = part->batch->end_offsets[instance], ends = end_count(part, instance);
    return slot < ends ? part->end_points[from + slot] : part->angles->turns[from + slot - ends];
}

/* How far differences go: m, or rad. */
static double reach_of(const TinkerConstraintBatch *part, const TinkerConstraints *all, int32_t instance, int32_t slot)
{
    if (slot >= end_count(part, instance)) return DIFFERENCE;
    return DIFFERENCE * all->scales[part->first_row + instance * part->constraint->rows];
}

/* Moves end number `slot` of every instance along coordinate k and evaluates all rows. */
static gboolean evaluate_moved(Geometry *work, int32_t slot, int k, double sign, double *jacobian)
{
    const TinkerConstraintBatch *part = work->part;
    const TinkerConstraints *all = &work->model->constraints;
    for (int32_t e = 0; e < part->batch->end_count; e++)
        work->ends[e] = work->model->point[part->end_points[e]];
    if (part->angles != NULL) tinker_angles_gather(part->angles, work->model, 0, part->batch->end_count);
    for (int32_t i = 0; i < part->batch->count; i++) {
        const int32_t from = part->batch->end_offsets[i], ends = end_count(part, i);
        const double step = sign * reach_of(part, all, i, slot);
        if (slot < ends)
            *moved_coordinate(&work->ends[from + slot], k) += step;
        else if (k == 0 && slot < entry_count(part, i))
            part->angles->poses[from + slot - ends].angle += step;
    }
    TinkerBatch view = part->view;
    view.time = 0;
    return tinker_constraints_ask(part, &view, work->ends, work->g, jacobian, work->drift) == TINKER_OK;
}

static void add_entry(Geometry *work, int32_t on, int d, int32_t of, int k, double stiffness)
{
    const TinkerModel *model = work->model;
    TinkerCoordinateEntry rows[2], columns[2];
    if (on >= model->first_support || of >= model->first_support || stiffness == 0 || !isfinite(stiffness)) return;
    const int32_t row_count = tinker_model_point_entries(model, on, d, rows);
    const int32_t column_count = tinker_model_point_entries(model, of, k, columns);
    for (int32_t r = 0; r < row_count; r++)
        for (int32_t c = 0; c < column_count; c++) {
            TinkerStiffnessEntry entry = {rows[r].coordinate, columns[c].coordinate,
                                          stiffness * rows[r].value * columns[c].value};
            g_array_append_val(work->found, entry);
        }
}

/* The torque of what a constraint does at the arm r changes as that turns: by -r . F an angle. */
static void add_turned_arms(TinkerModel *model, const double *lambda, GArray *found)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t k = 0; k < all->turn_count; k++) {
        const TinkerTurnEntry *of = &all->turns[k];
        const double *r = tinker_model_attachment(model, all->ends_at[of->entry])->arm;
        const double *j = all->jacobian + 2 * of->entry, gyration = model->turns[of->turn].gyration;
        const double along = lambda[of->row] * (r[0] * j[0] + r[1] * j[1]);
        TinkerStiffnessEntry entry = {of->coordinate, of->coordinate, along / (gyration * gyration)};
        if (isfinite(along)) g_array_append_val(found, entry);
    }
}

/* -lambda times the difference of the two Jacobians, row by row. */
static void add_differences(Geometry *work, int32_t slot, int k)
{
    const TinkerConstraintBatch *part = work->part;
    const TinkerConstraints *all = &work->model->constraints;
    gsize first = 0;
    for (int32_t i = 0; i < part->batch->count; i++) {
        const int32_t entries = entry_count(part, i);
        for (int32_t r = 0; r < part->constraint->rows; r++, first += 2 * (gsize)entries) {
            if (slot >= entries) continue;
            const double lambda = work->lambda[part->first_row + i * part->constraint->rows + r];
            const double factor = -lambda / (2 * reach_of(part, all, i, slot));
            for (int32_t e = 0; e < 2 * entries; e++)
                add_entry(work, entry_point(part, i, e / 2), e % 2, entry_point(part, i, slot), k,
                          factor * (work->high[first + (gsize)e] - work->low[first + (gsize)e]));
        }
    }
}

static void add_part(Geometry *work)
{
    int32_t most = 0;
    for (int32_t i = 0; i < work->part->batch->count; i++)
        most = MAX(most, entry_count(work->part, i));
    for (int32_t slot = 0; slot < most; slot++)
        for (int k = 0; k < 2; k++)
            if (evaluate_moved(work, slot, k, -1, work->low) && evaluate_moved(work, slot, k, 1, work->high))
                add_differences(work, slot, k);
}

static void add_batches(TinkerModel *model, const double *lambda, GArray *found)
{
    const TinkerConstraints *all = &model->constraints;
    for (guint p = 0; p < all->batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, p);
        gsize rows = (gsize)MAX(part->row_count, 1), entries = (gsize)MAX(part->batch->end_count, 1);
        entries *= (gsize)MAX(part->constraint->rows, 1) * (part->angles != NULL ? 2 : 1);
        g_autofree TinkerPoint *ends = g_new(TinkerPoint, MAX(part->batch->end_count, 1));
        g_autofree double *room = g_new0(double, 2 * rows + 4 * entries);
        Geometry work = {model, part, lambda, ends, room, room + rows, room + 2 * rows, room + 2 * rows + 2 * entries,
                         found};
        add_part(&work);
    }
}

void tinker_start_geometry(TinkerModel *model, const double *lambda, GArray *found)
{
    add_batches(model, lambda, found);
    add_turned_arms(model, lambda, found);
}

/* s: in which nothing moves farther than differences go. */
static double short_time(const TinkerModel *model)
{
    double fastest = 0, least = INFINITY;
    for (int32_t i = 0; i < model->coordinates; i++)
        fastest = fmax(fastest, fabs(model->v_start[i]));
    for (int32_t i = model->first_support; i < model->points; i++)
        fastest = fmax(fastest, hypot(model->point[i].vx, model->point[i].vy));
    for (int32_t row = 0; row < model->constraints.rows; row++)
        least = fmin(least, model->constraints.scales[row]);
    return fastest > 0 ? DIFFERENCE * least / fastest : 0;
}

static TinkerStatus evaluate_at(TinkerModel *model, double t)
{
    g_autofree double *q = g_memdup2(model->q_start, (gsize)MAX(model->coordinates, 1) * sizeof(double));
    for (int32_t i = 0; i < model->coordinates; i++)
        q[i] += t * model->v_start[i];
    const TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, model->v_start);
    return tinker_constraints_evaluate(model);
}

/* Adds `factor` times the Jacobian at t along the start's motion. */
static TinkerStatus add_jacobian(TinkerModel *model, double t, double factor, double *sum)
{
    const TinkerStatus status = evaluate_at(model, t);
    for (gsize i = 0; i < model->constraints.jacobian_size; i++)
        sum[i] += factor * model->constraints.jacobian[i];
    return status;
}

TinkerStatus tinker_start_turning(TinkerModel *model, GArray *found)
{
    const double factors[] = {-1.5, 2, -0.5}; /* of the second order, and never before the start */
    const double h = short_time(model);
    if (!(h > 0)) return TINKER_OK;
    TinkerConstraints turning = model->constraints;
    g_autofree double *change = g_new0(double, turning.jacobian_size);
    g_autofree TinkerCoordinateEntry *entries = tinker_constraints_row_room(&turning);
    TinkerStatus status = TINKER_OK;
    for (int k = 2; k >= 0 && status == TINKER_OK; k--)
        status = add_jacobian(model, k * h, factors[k] / h, change);
    turning.jacobian = change;
    for (int32_t row = 0; status == TINKER_OK && row < turning.rows; row++) {
        const int32_t count = tinker_constraints_list_row(&turning, row, entries);
        for (int32_t k = 0; k < count; k++) {
            const TinkerTurningEntry entry = {row, entries[k].coordinate, entries[k].value};
            if (entry.rate != 0 && entry.coordinate < model->coordinates) g_array_append_val(found, entry);
        }
    }
    return status;
}
