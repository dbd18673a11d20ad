/* Watching a run: numbers that are none stop it at once, an energy that does not balance warns or stops it. */
#include <math.h>

#include "physics/guard.h"
#include "physics/simulation-private.h"

#define WARN_IMBALANCE 0.01
#define STOP_IMBALANCE 1.0
/* The books cost about one evaluation: they are looked into after this many. */
#define EVALUATIONS_BETWEEN_LOOKS 40

gboolean tinker_simulation_fail(TinkerSimulation *simulation, const char *why, GError **error)
{
    TinkerSummary *summary = &simulation->summary;
    summary->simulated_s = simulation->state.t;
    g_autofree char *advice = tinker_guard_explain(simulation->model, simulation->method, simulation->options.step);
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                "the run stopped at t = %.6g s: %s; what was computed is to be believed up to t = %.6g s. %s",
                simulation->state.t, why != NULL ? why : "no reason was given", summary->valid_until, advice);
    return FALSE;
}

static gboolean all_finite(const TinkerSimulation *simulation)
{
    /* A sum of zeros is 0 unless one factor is infinite or not a number. */
    double sum = 0;
    for (int32_t i = 0; i < simulation->system.system.size; i++)
        sum += 0.0 * simulation->state.q[i] + 0.0 * simulation->state.v[i];
    return sum == 0;
}

static gboolean watch_constraints(TinkerSimulation *simulation)
{
    TinkerModel *model = simulation->model;
    TinkerSummary *summary = &simulation->summary;
    if (model->constraints.rows == 0) return TRUE;
    double position, velocity, extent, speed;
    const TinkerState *state = &simulation->state;
    if (tinker_constraints_errors(model, state->t, state->q, state->v, &position, &velocity) != TINKER_OK) return FALSE;
    simulation->system.system.scales(&simulation->system, state->q, state->v, &extent, &speed);
    position = fmax(position, simulation->system.position_error);
    summary->constraint_position_error = fmax(summary->constraint_position_error, position);
    if (speed > 0) summary->constraint_velocity_error = fmax(summary->constraint_velocity_error, velocity / speed);
    return TRUE;
}

static gboolean look(TinkerSimulation *simulation, GError **error)
{
    TinkerSummary *summary = &simulation->summary;
    simulation->looked_at = summary->steps;
    tinker_model_system_keep(&simulation->system, simulation->state.q, simulation->state.v);
    if (tinker_books_look(&simulation->books, &simulation->state, summary) != TINKER_OK || !watch_constraints(simulation))
        return tinker_simulation_fail(simulation, simulation->model->failure, error);
    double imbalance = simulation->books.imbalance;
    if (imbalance > STOP_IMBALANCE || !isfinite(imbalance)) {
        g_autofree char *why = g_strdup_printf("it diverged: its energy is off by %.3g times the largest energy exchanged", imbalance);
        return tinker_simulation_fail(simulation, why, error);
    }
    if (imbalance <= WARN_IMBALANCE) {
        summary->valid_until = simulation->state.t;
    } else if (!simulation->warned_imbalance) {
        simulation->warned_imbalance = TRUE;
        g_autofree char *advice = tinker_guard_explain(simulation->model, simulation->method, simulation->options.step);
        g_ptr_array_add(summary->warnings,
                        g_strdup_printf("from t = %.6g s on the energy is off by more than 1 %% of the largest energy exchanged: %s",
                                        simulation->state.t, advice));
    }
    return TRUE;
}

gboolean tinker_simulation_watch(TinkerSimulation *simulation, const TinkerStepReport *report, gboolean last,
                                 GError **error)
{
    TinkerSummary *summary = &simulation->summary;
    summary->steps++;
    summary->rejected_steps += report->rejected;
    summary->evaluations = simulation->model->evaluations;
    summary->simulated_s = simulation->state.t;
    if (!all_finite(simulation)) return tinker_simulation_fail(simulation, "it diverged: a position or velocity is not a number", error);
    if (summary->adaptive) tinker_model_system_keep(&simulation->system, simulation->state.q, simulation->state.v);
    gint64 since = (summary->steps - simulation->looked_at) * simulation->method->evaluations_per_step;
    return (!last && since < EVALUATIONS_BETWEEN_LOOKS) || look(simulation, error);
}
