/* The start: positions that nearly fit the constraints and velocities that do not are projected; what does not fit is
 * refused by name. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/compile/compile-private.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

/* The column of the length that a row keeps from end to end; -1 where it says no such thing, as of what is wound. */
static int32_t path_column(const TinkerBlockClass *block_class, int32_t ends)
{
    int32_t property = block_class->meanings[TINKER_MEANING_LENGTH];
    if (property < 0 || ends < 2 || tinker_block_class_is_wound(block_class)) return -1;
    gboolean along = ends == 2 || (block_class->properties[property].flags & TINKER_DEFAULT_AS_PLACED) != 0;
    return along ? block_class->first_columns[property] : -1;
}

static double path_length(const TinkerModel *model, int32_t row, int32_t ends)
{
    const TinkerConstraints *all = &model->constraints;
    double length = 0;
    for (int32_t e = all->row_starts[row] + 1; e < all->row_starts[row] + ends; e++) {
        const TinkerPoint *a = &model->point[all->ends_at[e - 1]], *b = &model->point[all->ends_at[e]];
        length += hypot(b->x - a->x, b->y - a->y);
    }
    return length;
}

/* Where the row would be met if one end moved, a body's, by the row's derivatives: exactly for a row that is linear
 * along them, roughly for others. Answers that body, or -1 where the row moves none. */
static int32_t nearest_fit(const TinkerModel *model, int32_t row, double place[2])
{
    const TinkerConstraints *all = &model->constraints;
    int32_t body = -1;
    double steepest = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const int32_t point = all->points[e];
        const double *slope = &all->jacobian[2 * e], square = slope[0] * slope[0] + slope[1] * slope[1];
        if (point >= model->bodies || !(square > steepest)) continue;
        steepest = square;
        body = point;
        place[0] = model->origin[0] + model->point[point].x - all->g[row] * slope[0] / square;
        place[1] = model->origin[1] + model->point[point].y - all->g[row] * slope[1] / square;
    }
    return body >= 0 && isfinite(place[0]) && isfinite(place[1]) ? body : -1;
}

static void refuse_misfit(const TinkerModel *model, int32_t row, const char *name, GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    double place[2];
    const char *unit = tinker_constraints_row_unit(model, row);
    const int32_t body = nearest_fit(model, row, place);
    const gboolean turned = strcmp(unit, "rad") == 0;
    g_autofree char *hint =
        turned ? g_strdup(_("turn what one of its ends is on, or change its properties"))
        : body < 0
            ? g_strdup(_("move its ends, or change its properties"))
            : g_strdup_printf(_("it fits with %s at about (%.5g, %.5g) m"),
                              tinker_scene_block_name(model->scene, model->body_blocks[body]), place[0], place[1]);
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                _("%s: the start positions miss it by %.3g %s (at most %.3g %s is corrected; %s)"), name,
                fabs(all->g[row]), unit, TINKER_START_MISS * all->scales[row], unit, hint);
}

/* A joint by one of its rows in m: both components of what lies between its ends, or that across a line. */
static void refuse_joint(const TinkerModel *model, const TinkerConstraintBatch *part, int32_t row, const char *name,
                         GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    const TinkerPoint *a = &model->point[all->ends_at[all->row_starts[row]]];
    const TinkerPoint *b = &model->point[all->ends_at[all->row_starts[row] + 1]];
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                part->constraint->joint == 1
                    ? _("%s: its ends do not fit together at t = 0: they are at (%.10g, %.10g) and (%.10g, %.10g) m "
                        "(move one to the other; at most %.0e of the scene's extent, %.3g m, is corrected)")
                    : _("%s: its ends do not fit together at t = 0: they are at (%.10g, %.10g) and (%.10g, %.10g) m "
                        "(move one onto the line through the other, or turn that; at most %.0e of the scene's extent, "
                        "%.3g m, is corrected)"),
                name, a->x + model->origin[0], a->y + model->origin[1], b->x + model->origin[0],
                b->y + model->origin[1], TINKER_START_MISS, TINKER_START_MISS * all->scales[row]);
}

static gboolean refuse_row(TinkerModel *model, const TinkerConstraintBatch *part, int32_t row, GError **error)
{
    const TinkerBlockBatch *batch = part->batch;
    int32_t instance = (row - part->first_row) / part->constraint->rows;
    int32_t ends = batch->end_offsets[instance + 1] - batch->end_offsets[instance];
    int32_t column = path_column(batch->block_class, ends);
    const char *name = tinker_scene_block_name(model->scene, batch->ids[instance]);
    const gboolean of_angle = strcmp(tinker_constraints_row_unit(model, row), "rad") == 0;
    if (part->constraint->joint != 0 && !of_angle) {
        refuse_joint(model, part, row, name, error);
    } else if (column >= 0) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                    ends == 2 ? _("%s: its length is %.10g m, but its ends are %.10g m apart at t = 0 (move an end, "
                                  "change the length, or leave the length out)")
                              : _("%s: its length is %.10g m, but the path through its ends is %.10g m long at t = 0 "
                                  "(move an end, change the length, or leave the length out)"),
                    name, batch->columns[column][instance], path_length(model, row, ends));
    } else {
        refuse_misfit(model, row, name, error);
    }
    return FALSE;
}

static gboolean check_positions(TinkerModel *model, GError **error)
{
    const TinkerConstraints *all = &model->constraints;
    for (guint i = 0; i < all->batches->len; i++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, i);
        TinkerBatch view = tinker_block_batch_view(part->batch, 0.0);
        if (part->constraint->check != NULL &&
            TINKER_CALL_BATCH(part->batch, "check", &view, part->constraint->check(&view)) != TINKER_OK) {
            g_autofree char *why =
                tinker_block_batch_refusal(part->batch, &view, _("its properties do not make a constraint"));
            g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE, why);
            return FALSE;
        }
        for (int32_t row = part->first_row; row < part->first_row + part->row_count; row++)
            if (part->constraint->unilateral ? !(all->g[row] <= TINKER_START_MISS * all->scales[row])
                                             : !(fabs(all->g[row]) <= TINKER_START_MISS * all->scales[row]))
                return refuse_row(model, part, row, error);
    }
    return TRUE;
}

/* Whether the user said how fast a body starts along a coordinate: what was left open is for the constraints to say. */
static gboolean is_said(const TinkerModel *model, int32_t coordinate)
{
    const TinkerBlockId block = model->body_blocks[tinker_model_moved_by(model, coordinate)];
    const TinkerBlockClass *block_class = tinker_scene_block_class(model->scene, block);
    const int32_t meaning = coordinate < 2 * model->bodies ? TINKER_MEANING_VELOCITY : TINKER_MEANING_ANGULAR_VELOCITY;
    const int32_t property = block_class->meanings[meaning];
    return property >= 0 && tinker_scene_property_given(model->scene, block, property);
}

static void warn_start_velocity(TinkerModel *model, const double *given)
{
    double change = 0, fastest = 0, impulse = 0;
    for (int32_t i = 0; i < model->coordinates; i++) {
        double dv = model->v_start[i] - given[i];
        if (is_said(model, i)) change = MAX(change, fabs(dv));
        fastest = MAX(fastest, MAX(fabs(given[i]), fabs(model->v_start[i])));
        impulse += model->coordinate_mass[i] * model->coordinate_mass[i] * dv * dv;
    }
    model->start_impulse = sqrt(impulse);
    model->start_changed = change > TINKER_START_MISS * fastest;
    if (model->start_changed)
        g_ptr_array_add(
            model->warnings,
            g_strdup_printf(_("the start velocities did not fit the constraints: they were changed by up to %.3g "
                              "m/s (an impulse of %.3g N s)"),
                            change, model->start_impulse));
}

static gboolean run_error(TinkerModel *model, TinkerModelError code, GError **error)
{
    g_set_error_literal(error, TINKER_MODEL_ERROR, code,
                        model->failure[0] != '\0' ? model->failure
                                                  : _("the forces cannot be worked out at the start positions"));
    return FALSE;
}

/* Of each row: the largest sum of what its ends by themselves, as `by_point` has them move, and its own term ask for:
 * where they cancel each other, rounding of it is all that is left. */
static void find_demands(const TinkerModel *model, const double *by_point, const double *terms, double *demand)
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
    find_demands(model, by_point, terms, demand);
    return tinker_largest(rows, demand);
}

/* The blocks of the rows that the residual is more than rounding of, as shares of what each row asks for where points
 * move as `by_point` has them: so rows in rad and in m are told by one measure, and one that a gear of a high ratio
 * hides behind another is seen. Joined by ", "; `several`: whether they are more than one block, or NULL. (transfer
 * full)
 */
static char *names_of_residual(const TinkerModel *model, const double *by_point, const double *terms, gboolean *several)
{
    const TinkerConstraints *all = &model->constraints;
    g_autofree double *demand = g_new(double, MAX(all->rows, 1));
    find_demands(model, by_point, terms, demand);
    const double rounding = TINKER_ROUNDING_MISS * tinker_largest(all->rows, all->residual);
    g_autoptr(GString) names = g_string_new(NULL);
    TinkerBlockId last = TINKER_NO_BLOCK;
    int count = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        const double missed = fabs(all->residual[row]);
        if (!(missed > rounding && missed > TINKER_START_MISS * demand[row]) || all->blocks[row] == last) continue;
        count++;
        last = all->blocks[row];
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", tinker_scene_block_name(model->scene, last));
    }
    if (several != NULL) *several = count > 1;
    return g_string_free(g_steal_pointer(&names), FALSE);
}

/* Names the rows that the accelerations a cannot meet. */
static gboolean refuse_contradiction(TinkerModel *model, const double *a, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    memcpy(model->point_acceleration, a, (gsize)model->coordinates * sizeof(double));
    tinker_constraints_rows_times(all, model->point_acceleration, all->residual);
    for (int32_t row = 0; row < all->rows; row++)
        all->residual[row] += all->drift[row];
    g_autofree char *names = names_of_residual(model, model->point_acceleration, all->drift, NULL);
    g_set_error(
        error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_CONTRADICTION,
        _("%s: no motion satisfies these constraints at the start: they contradict each other (remove one, or give "
          "what lies between them another place or velocity)"),
        names);
    return FALSE;
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

static void reach_soft_motions(TinkerModel *model)
{
    const gsize n = (gsize)MAX(model->coordinates, 1);
    if (!tinker_constraints_are_proximal(&model->constraints)) return;
    g_autofree double *motion = g_new(double, n), *found = g_new(double, model->constraints.rows);
    move_every_way(n, motion);
    choose_shift(model, missed_motion, motion, found);
    model->constraints.rounds = model->constraints.rounds_taken;
}

/* Brings the start velocities to the rows. They meet what is prescribed, of drives and of supports that move, unless
 * several prescribe the same freedom: then what they ask for has to be the same. */
static gboolean correct_velocities(TinkerModel *model, GError **error)
{
    const gsize bytes = (gsize)MAX(model->coordinates, 1) * sizeof(double);
    const gboolean prescribed = model->constraints.prescribed || model->moving_supports > 0;
    g_autofree double *given = g_memdup2(model->v_start, bytes);
    const double missed = choose_shift(model, missed_velocity, given, model->v_start);
    if (!prescribed || missed <= TINKER_START_MISS) {
        if (memcmp(given, model->v_start, bytes) != 0) warn_start_velocity(model, given);
        return TRUE;
    }
    gboolean several;
    g_autofree char *names = names_of_residual(model, model->constraints.by_point, model->constraints.rate, &several);
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_CONTRADICTION,
                several
                    ? _("%s: no velocity satisfies these constraints at the start: what is prescribed there "
                        "contradicts another constraint (remove one, or let both ask for the same)")
                    : _("%s: no velocity satisfies this constraint at the start: what it asks for, nothing that it is "
                        "on is free to do (attach it to something that can move or turn that way)"),
                names);
    return FALSE;
}

static gboolean check_accelerations(TinkerModel *model, GError **error)
{
    const gsize n = (gsize)MAX(model->coordinates, 1);
    g_autofree double *applied = g_new0(double, n), *a = g_new0(double, n);
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (tinker_model_applied(model, applied, FALSE) != TINKER_OK || tinker_constraints_evaluate(model) != TINKER_OK)
        return run_error(model, TINKER_MODEL_ERROR_RUN, error);
    if (choose_shift(model, missed_acceleration, applied, a) > TINKER_START_MISS)
        return refuse_contradiction(model, a, error);
    reach_soft_motions(model);
    return TRUE;
}

/* Rows that hold in one direction only are slack until a run asks which of them are not, but for what is `stretched`:
 * that is brought back with the start positions. */
static void slacken(TinkerModel *model, gboolean stretched)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->unilateral[row]) tinker_constraints_set_slack(model, row, !stretched || all->own_g[row] <= 0);
}

gboolean tinker_model_check_start(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    if (tinker_model_set_time(model, 0.0) != TINKER_OK) return run_error(model, TINKER_MODEL_ERROR_RUN, error);
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (all->rows == 0) return TRUE;
    /* what cannot be where the scene puts it, as a gear on a mass, is the scene's mistake */
    if (tinker_constraints_evaluate(model) != TINKER_OK) return run_error(model, TINKER_MODEL_ERROR_SCENE, error);
    if (!check_positions(model, error)) return FALSE;
    tinker_constraints_find_redundant(model);
    gboolean moved;
    slacken(model, TRUE);
    if (tinker_constraints_project_positions(model, 0.0, model->q_start, model->v_start, &moved) != TINKER_OK)
        return run_error(model, TINKER_MODEL_ERROR_CONTRADICTION, error);
    slacken(model, FALSE);
    if (all->unilateral != NULL && tinker_constraints_evaluate(model) != TINKER_OK)
        return run_error(model, TINKER_MODEL_ERROR_RUN, error);
    return correct_velocities(model, error) && check_accelerations(model, error);
}
