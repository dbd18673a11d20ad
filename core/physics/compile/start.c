/* The start: positions that nearly fit the constraints and velocities that do not are projected; what does not fit is
 * refused by name. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/compile/compile-private.h"
#include "physics/compile/start-private.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

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
        tinker_warnings_add(
            model->warnings, TINKER_WARNING_START,
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

/* The blocks of the rows that the residual is more than rounding of, as shares of what each row asks for where points
 * move as `by_point` has them: so rows in rad and in m are told by one measure, and one that a gear of a high ratio
 * hides behind another is seen. Joined by ", "; `several`: whether they are more than one block, or NULL. (transfer
 * full)
 */
static char *names_of_residual(const TinkerModel *model, const double *by_point, const double *terms, gboolean *several)
{
    const TinkerConstraints *all = &model->constraints;
    g_autofree double *demand = g_new(double, MAX(all->rows, 1));
    tinker_start_demands(model, by_point, terms, demand);
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

/* Brings the start velocities to the rows. They meet what is prescribed, of drives and of supports that move, unless
 * several prescribe the same freedom: then what they ask for has to be the same. */
static gboolean correct_velocities(TinkerModel *model, GError **error)
{
    const gsize bytes = (gsize)MAX(model->coordinates, 1) * sizeof(double);
    const gboolean prescribed = model->constraints.prescribed || model->moving_supports > 0;
    g_autofree double *given = g_memdup2(model->v_start, bytes);
    const double missed = tinker_start_meet_velocities(model, given, model->v_start);
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
    if (tinker_start_meet_accelerations(model, applied, a) > TINKER_START_MISS)
        return refuse_contradiction(model, a, error);
    tinker_start_reach_soft_motions(model);
    return TRUE;
}

/* Of rows that hold in one direction only, those that are stretched: they are brought back with the start positions. A
 * run asks which of the others hold. */
static void hold_stretched_only(TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++)
        if (all->unilateral[row]) tinker_constraints_set_slack(model, row, all->own_g[row] <= 0);
}

gboolean tinker_model_check_start(TinkerModel *model, GError **error)
{
    TinkerConstraints *all = &model->constraints;
    if (tinker_model_set_time(model, 0.0) != TINKER_OK) return run_error(model, TINKER_MODEL_ERROR_RUN, error);
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (all->rows == 0) return TRUE;
    /* what cannot be where the scene puts it, as a gear on a mass, is the scene's mistake */
    if (tinker_constraints_evaluate(model) != TINKER_OK) return run_error(model, TINKER_MODEL_ERROR_SCENE, error);
    if (!tinker_start_check_positions(model, error)) return FALSE;
    tinker_constraints_find_redundant(model);
    gboolean moved;
    hold_stretched_only(model);
    if (tinker_constraints_project_positions(model, 0.0, model->q_start, model->v_start, &moved) != TINKER_OK)
        return run_error(model, TINKER_MODEL_ERROR_CONTRADICTION, error);
    tinker_constraints_set_all_slack(model, TRUE);
    if (all->unilateral != NULL && tinker_constraints_evaluate(model) != TINKER_OK)
        return run_error(model, TINKER_MODEL_ERROR_RUN, error);
    return correct_velocities(model, error) && check_accelerations(model, error);
}
