/* Bringing a state back onto the constraints: positions by mass-weighted Newton steps
 *
 *   S mu = -g,  q <- q + M^-1 J^T mu,
 *
 * velocities by the one linear solve S mu = -(J v + dg/dt), v <- v + M^-1 J^T mu. The factor of the last stage of a
 * step serves the first Newton step: it differs by the stage's error alone, and what is left shows in the next g. */
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/model/turns.h"

#define MOST_NEWTON_STEPS 25

/* What g is rounded by: the row's length, and the coordinates that its ends are made of. */
static double reach_of(const TinkerModel *model, int32_t row)
{
    const TinkerConstraints *all = &model->constraints;
    double reach = all->scales[row];
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const TinkerPoint *at = &model->point[all->ends_at[e]];
        reach = MAX(reach, MAX(fabs(at->x), fabs(at->y)));
    }
    return reach;
}

/* And by the angles, where what it holds lies far from what turns. */
static double reach_of_angles(const TinkerModel *model, int32_t row)
{
    const TinkerConstraints *all = &model->constraints;
    double reach = 0;
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++)
        reach += fabs(all->jacobian[2 * all->entries + k] *
                      model->turns[all->turns[k].coordinate - 2 * model->bodies].place);
    return reach;
}

static gboolean row_is_met(const TinkerModel *model, int32_t row)
{
    const double miss = fabs(model->constraints.g[row]);
    return miss <= 4 * DBL_EPSILON * model->constraints.scales[row] || miss <= 4 * DBL_EPSILON * reach_of(model, row);
}

static gboolean all_met(const TinkerModel *model)
{
    if (model->constraints.miss <= 4 * DBL_EPSILON) return TRUE;
    for (int32_t row = 0; row < model->constraints.rows; row++)
        if (!row_is_met(model, row)) return FALSE;
    return TRUE;
}

/* Whether no angle that a double can hold would do better. */
static gboolean all_met_by_angles(const TinkerModel *model)
{
    for (int32_t row = 0; row < model->constraints.rows; row++)
        if (!row_is_met(model, row) &&
            fabs(model->constraints.g[row]) > 4 * DBL_EPSILON * (reach_of(model, row) + reach_of_angles(model, row)))
            return FALSE;
    return TRUE;
}

static double miss_of(const TinkerConstraints *all, int32_t row)
{
    return fabs(all->g[row]) * all->inverse_scales[row];
}

int32_t tinker_constraints_worst_row(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t worst = 0;
    for (int32_t row = 1; row < all->rows; row++)
        if (miss_of(all, row) > miss_of(all, worst)) worst = row;
    return worst;
}

/* By the law that the class states. */
static const char *unit_of(const TinkerBlockClass *block_class, int32_t row)
{
    g_autofree char *symbol =
        block_class->physics->constraint->rows == 1 ? g_strdup("g") : g_strdup_printf("g%d", row + 1);
    for (int32_t i = 0; i < block_class->law_count; i++) {
        const TinkerDimension *of = &block_class->law[i].dimension;
        if (strcmp(block_class->law[i].symbol, symbol) == 0 && of->length == 0 && of->angle == 1) return "rad";
    }
    return "m";
}

const char *tinker_constraints_row_unit(const TinkerModel *model, int32_t row)
{
    const GArray *batches = model->constraints.batches;
    for (guint i = 0; i < batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(batches, TinkerConstraintBatch, i);
        if (row >= part->first_row && row < part->first_row + part->row_count)
            return unit_of(part->batch->block_class, (row - part->first_row) % part->constraint->rows);
    }
    return "m";
}

double tinker_constraints_worst_miss(const TinkerModel *model)
{
    return model->constraints.miss;
}

static TinkerStatus not_met(TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t worst = tinker_constraints_worst_row(model);
    tinker_model_tell_failure(
        model,
        _("%s: no position within reach satisfies it at t = %g s; it misses by %.3g %s (the constraints contradict "
          "each other there, or the step is too large for this motion)"),
        tinker_scene_block_name(model->scene, all->blocks[worst]), model->time, fabs(all->g[worst]),
        tinker_constraints_row_unit(model, worst));
    return TINKER_FAILED;
}

/* Newton steps do no more: at a singular place a little is left for later. */
static TinkerStatus stop_short(TinkerModel *model)
{
    TinkerConstraints *all = &model->constraints;
    if (!all->shifted || !(tinker_constraints_worst_miss(model) < TINKER_SINGULAR_MISS)) return not_met(model);
    all->gave_way = TRUE;
    return TINKER_OK;
}

/* q += displacement. What moving against the applied forces stores is counted with those evaluated last, which stood
 * within a step's error of here. */
static void move_positions(TinkerModel *model, double *restrict q)
{
    const double *restrict move = model->constraints.displacement, *restrict force = model->force;
    const double *restrict mass = model->mass, *restrict constant = model->constant_acceleration;
    double work[2] = {0, 0};
    for (int32_t i = 0; i < model->bodies; i++)
        for (int k = 0; k < 2; k++) {
            work[k] += (force[2 * i + k] + mass[i] * constant[2 * i + k]) * move[2 * i + k];
            q[2 * i + k] += move[2 * i + k];
        }
    for (int32_t k = 0, i = 2 * model->bodies; k < model->turning; k++, i++) {
        work[0] += (force[i] + mass[model->turns[k].body] * constant[i]) * move[i];
        q[i] += move[i];
    }
    model->constraints.work -= work[0] + work[1];
}

/* Answers whether another Newton step is wanted for rows that were evaluated with this status. FALSE: *status is the
 * answer. `before` is the miss of the step before, at first INFINITY; where that went `roughly`, with a factor of
 * another place, it says nothing of those that follow. */
static gboolean wants_step(TinkerModel *model, gboolean roughly, double *before, TinkerStatus *status)
{
    if (*status != TINKER_OK || all_met(model)) return FALSE;
    double miss = tinker_constraints_worst_miss(model);
    /* Rounding may keep a row just above its bound; no step can then do better. */
    if (!(miss < 0.5 * *before) && (miss < TINKER_ROUNDING_MISS || all_met_by_angles(model))) return FALSE;
    if (!(miss < 4.0 * *before) && !roughly) {
        *status = stop_short(model);
        return FALSE;
    }
    *before = miss;
    return TRUE;
}

static TinkerStatus evaluate_at(TinkerModel *model, const double *q, const double *v)
{
    tinker_model_set_state(model, q, v);
    return tinker_constraints_evaluate(model);
}

TinkerStatus tinker_constraints_project_positions(TinkerModel *model, double t, double *q, const double *v,
                                                  gboolean *moved)
{
    TinkerConstraints *all = &model->constraints;
    double before = INFINITY;
    *moved = FALSE;
    all->work = 0;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    for (int step = 0; step < MOST_NEWTON_STEPS; step++) {
        status = evaluate_at(model, q, v);
        if (!wants_step(model, step == 1, &before, &status)) return status;
        tinker_constraints_newton_step(model, step == 0);
        move_positions(model, q);
        *moved = TRUE;
    }
    return stop_short(model);
}

/* The impulse mu gives mu . J (v + dv / 2), and J dv = -(J v + rate). */
static double work_of_impulse(const TinkerConstraints *all, const double *mu, const double *asked)
{
    double sum = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        double rate = all->prescribed ? all->rate[row] : 0.0;
        sum -= mu[row] * (0.5 * asked[row] + rate);
    }
    return sum;
}

double tinker_constraints_correct_velocities(TinkerModel *model, double *v, gboolean homogeneous, gboolean *moved)
{
    TinkerConstraints *all = &model->constraints;
    double *asked = all->asked;
    *moved = FALSE;
    if (homogeneous) {
        memcpy(all->by_point, v, (gsize)model->coordinates * sizeof(double));
        memset(all->by_point + model->coordinates, 0,
               (2 * (gsize)model->points - (gsize)model->coordinates) * sizeof(double));
        tinker_constraints_rows_times(all, all->by_point, asked);
    } else {
        tinker_constraints_rates(model, asked);
    }
    double most = tinker_largest(all->rows, asked);
    if (most == 0 || most <= 2 * DBL_EPSILON * tinker_largest(model->coordinates, v)) return 0;
    for (int32_t row = 0; row < all->rows; row++)
        asked[row] = -asked[row];
    *moved = TRUE;
    tinker_constraints_change_speeds(model, asked, v);
    return work_of_impulse(all, all->lambda, asked);
}

TinkerStatus tinker_constraints_project_velocities(TinkerModel *model, double t, const double *q, double *v,
                                                   gboolean homogeneous, gboolean *moved)
{
    *moved = FALSE;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    status = evaluate_at(model, q, v);
    if (status == TINKER_OK) tinker_constraints_correct_velocities(model, v, homogeneous, moved);
    return status;
}

/* The Jacobian at a place, where a step begins: of ends that coincide it follows from the angles alone, and is still
 * that of the step before where no body has turned since. */
static TinkerStatus find_directions(TinkerModel *model, gboolean gaps, const double *q, const double *v)
{
    if (!gaps) return evaluate_at(model, q, v);
    if (!model->turned && tinker_model_has_angles(model, q)) return TINKER_OK;
    tinker_model_set_places(model, q);
    return tinker_constraints_evaluate(model);
}

/* g at a place: where that can be had alone, without the rest. */
static TinkerStatus find_misses(TinkerModel *model, gboolean gaps, const double *q, const double *v)
{
    if (!gaps) return evaluate_at(model, q, v);
    tinker_model_set_places(model, q);
    return tinker_constraints_find_gaps(model);
}

/* Whether a Newton step hardly reduced what was nearly met before, and is not rounding. */
static gboolean stalls(const TinkerModel *model, double before)
{
    const double miss = tinker_constraints_worst_miss(model);
    return before < TINKER_SINGULAR_MISS && miss > TINKER_STALLED_MISS && !(miss < 0.5 * before) && !all_met(model);
}

static void move_within_step(const TinkerModel *model, double h, double sign, double *restrict q, double *restrict v)
{
    const double *restrict move = model->constraints.displacement;
    for (int32_t i = 0; i < model->coordinates; i++) {
        q[i] += sign * move[i];
        v[i] += sign * move[i] / h;
    }
}

/* Across a singular place the matrix of the old place says the reverse of what rows do at the new one along what they
 * hardly determine: there each step would enlarge what is rounding. What is left then, the others being met, is taken
 * along the rows of the new place. */
static TinkerStatus rattle_across(TinkerModel *model, double h, double *q, double *v)
{
    double before = INFINITY;
    TinkerStatus status = TINKER_OK;
    for (int step = 0; step < MOST_NEWTON_STEPS; step++) {
        status = evaluate_at(model, q, v);
        if (!wants_step(model, FALSE, &before, &status)) return status;
        tinker_constraints_newton_step(model, FALSE);
        move_within_step(model, h, 1, q, v);
    }
    return stop_short(model);
}

/* Newton steps with the matrix of the old place: the direction J(q_from)^T is what makes the method symmetric, and the
 * matrix differs from the exact one by the turning of a step. */
TinkerStatus tinker_constraints_rattle(TinkerModel *model, double t_from, const double *q_from, double t, double h,
                                       double *q, double *v)
{
    TinkerConstraints *all = &model->constraints;
    const gboolean gaps = tinker_constraints_are_gaps(model);
    TinkerStatus status = tinker_model_set_time(model, t_from);
    if (status == TINKER_OK) status = find_directions(model, gaps, q_from, v);
    if (status != TINKER_OK) return status;
    if (!gaps) memcpy(all->turned, all->jacobian, all->jacobian_size * sizeof(double));
    double before = INFINITY;
    status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    for (int step = 0; step < 2 * MOST_NEWTON_STEPS; step++) {
        status = find_misses(model, gaps, q, v);
        if (status == TINKER_OK && stalls(model, before)) {
            if (!(tinker_constraints_worst_miss(model) < before)) move_within_step(model, h, -1, q, v);
            return rattle_across(model, h, q, v);
        }
        if (!wants_step(model, FALSE, &before, &status)) return status;
        if (!gaps) memcpy(all->jacobian, all->turned, all->jacobian_size * sizeof(double));
        tinker_constraints_newton_step(model, FALSE);
        move_within_step(model, h, 1, q, v);
    }
    return stop_short(model);
}
