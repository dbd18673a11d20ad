/* How much of the rows a start misses, and the shift that rows which depend on each other are solved with. */
#include "physics/compile/start-private.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

void tinker_start_demands(const TinkerModel *model, const double *by_point, const double *terms, double *demand)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; row < all->rows; row++) {
        demand[row] = fabs(terms[row]);
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
            const double *of = by_point + 2 * all->points[e];
            demand[row] += fabs(all->jacobian[2 * e] * of[0]) + fabs(all->jacobian[2 * e + 1] * of[1]);
        }
    }
    for (int32_t k = 0; k < all->turn_count; k++) {
        double *of_row = &demand[all->turns[k].row];
        *of_row = MAX(*of_row, fabs(all->jacobian[2 * all->entries + k] * by_point[all->turns[k].coordinate]));
    }
}

static double largest_demand(const TinkerModel *model, const double *by_point, const double *terms)
{
    const int32_t rows = model->constraints.rows;
    g_autofree double *demand = g_new(double, MAX(rows, 1));
    tinker_start_demands(model, by_point, terms, demand);
    return tinker_largest(rows, demand);
}

/* What a solve of the rows from `given` on misses of them, as a share of what is asked; its answer is `found`. */
typedef double (*Missed)(TinkerModel *model, const double *given, double *found);

/* Of velocities. What is rounding beside the fastest of them stays as it is: that misses nothing. */
static double missed_velocity(TinkerModel *model, const double *given, double *found)
{
    const TinkerConstraints *all = &model->constraints;
    const gsize bytes = (gsize)model->coordinates * sizeof(double);
    double missed = 0, asked, *velocity = all->by_point;
    gboolean moved;
    memcpy(found, given, bytes);
    tinker_model_set_state(model, model->q_start, given);
    tinker_constraints_correct_velocities(model, found, FALSE, &moved);
    if (!moved) return 0;
    tinker_model_set_state(model, model->q_start, found);
    for (int32_t i = model->first_attachment; i < model->points; i++) {
        velocity[2 * i] = model->point[i].vx;
        velocity[2 * i + 1] = model->point[i].vy;
    }
    tinker_constraints_rates(model, all->residual);
    for (int32_t row = 0; row < all->rows; row++)
        missed = MAX(missed, fabs(all->residual[row]));
    memcpy(velocity, given, bytes);
    asked = largest_demand(model, velocity, all->rate);
    memcpy(velocity, found, bytes);
    asked = MAX(asked, largest_demand(model, velocity, all->rate));
    return missed > 0 ? missed / asked : 0;
}

/* Of accelerations, from the applied ones on. */
static double missed_acceleration(TinkerModel *model, const double *applied, double *found)
{
    const gsize bytes = (gsize)model->coordinates * sizeof(double);
    memcpy(found, applied, bytes);
    const double missing = tinker_constraints_accelerate(model, found);
    memcpy(model->point_acceleration, applied, bytes);
    const double asked = largest_demand(model, model->point_acceleration, model->constraints.drift);
    return missing > 0 ? missing / asked : 0;
}

static void take_shift(TinkerConstraints *all, double shift)
{
    all->shift = shift;
    all->factored = all->keeps_factored = FALSE;
}

/* Rows that depend on each other are solved with a shift. What it leaves out may be too much of rows that are nearly
 * dependent, as the bending of a long truss: then a smaller one meets them, and none does where they contradict each
 * other. Answers what the best misses. */
static double choose_shift(TinkerModel *model, Missed missed_of, const double *given, double *found)
{
    TinkerConstraints *all = &model->constraints;
    double least = missed_of(model, given, found), best = all->shift;
    if (!tinker_constraints_are_proximal(all)) return least;
    while (least > TINKER_MET && all->shift * TINKER_SHIFT_STEP >= TINKER_LEAST_SHIFT) {
        take_shift(all, all->shift * TINKER_SHIFT_STEP);
        const double missed = missed_of(model, given, found);
        if (!(missed < 0.5 * least)) continue;
        least = missed;
        best = all->shift;
    }
    take_shift(all, best);
    return missed_of(model, given, found);
}

double tinker_start_meet_velocities(TinkerModel *model, const double *given, double *found)
{
    return choose_shift(model, missed_velocity, given, found);
}

double tinker_start_meet_accelerations(TinkerModel *model, const double *applied, double *found)
{
    return choose_shift(model, missed_acceleration, applied, found);
}

/* Of any motion: what the rows ask for where bodies move every way at once, which they can answer. The softest motions
 * of long chains take part in that, though what acts at the start need not ask for them. */
static double missed_motion(TinkerModel *model, const double *motion, double *found)
{
    TinkerConstraints *all = &model->constraints;
    memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
    memcpy(all->by_point, motion, (gsize)model->coordinates * sizeof(double));
    tinker_constraints_rows_times(all, all->by_point, found);
    const double asked = tinker_largest(all->rows, found);
    const double missed = tinker_constraints_solve(model, found);
    return missed > 0 ? missed / asked : 0;
}

/* Shares of -1 to 1 that neither repeat nor grow along the coordinates: multiples of the golden ratio, without what is
 * whole. */
static void move_every_way(gsize count, double *motion)
{
    for (gsize i = 0; i < count; i++) {
        const double multiple = (double)(i + 1) * 0.5 * (sqrt(5) - 1);
        motion[i] = 2 * (multiple - floor(multiple)) - 1;
    }
}

void tinker_start_reach_soft_motions(TinkerModel *model)
{
    const gsize n = (gsize)MAX(model->coordinates, 1);
    if (!tinker_constraints_are_proximal(&model->constraints)) return;
    g_autofree double *motion = g_new(double, n), *found = g_new(double, model->constraints.rows);
    move_every_way(n, motion);
    choose_shift(model, missed_motion, motion, found);
    model->constraints.rounds = model->constraints.rounds_taken;
}
