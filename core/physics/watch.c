/* Watching a run: numbers that are none stop it at once, an energy that does not balance warns or stops it. */
#include <math.h>

#include "physics/guard.h"
#include "physics/simulation-private.h"

#define WARN_IMBALANCE 0.01
#define STOP_IMBALANCE 1.0
/* The books cost about one evaluation: they are looked into after this many. */
#define EVALUATIONS_BETWEEN_LOOKS 40
/* A step that is far too large shows at once. */
#define FIRST_LOOKS         8
#define MOST_SINGULAR_STEPS 30

gboolean tinker_simulation_fail(TinkerSimulation *simulation, const char *why, GError **error)
{
    TinkerSummary *summary = &simulation->summary;
    summary->simulated_s = simulation->state.t;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                "the run stopped at t = %.6g s: %s; what was computed is to be believed up to t = %.6g s",
                simulation->state.t,
                why != NULL && why[0] != '\0' ? why : "a force or a constraint cannot be worked out there",
                summary->valid_until);
    return FALSE;
}

static gboolean diverged(TinkerSimulation *simulation, const char *how, GError **error)
{
    g_autofree char *advice = tinker_guard_explain(simulation->model, simulation->method, simulation->options.step);
    g_autofree char *why = g_strdup_printf("it diverged: %s (%s)", how, advice);
    return tinker_simulation_fail(simulation, why, error);
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
    for (int32_t i = model->bodies; i < model->points; i++)
        speed = fmax(speed, hypot(model->point[i].vx, model->point[i].vy));
    position = fmax(position, simulation->system.position_error);
    summary->constraint_position_error = fmax(summary->constraint_position_error, position);
    if (speed > 0) summary->constraint_velocity_error = fmax(summary->constraint_velocity_error, velocity / speed);
    return TRUE;
}

TinkerStatus tinker_simulation_vouch(TinkerSimulation *simulation)
{
    TinkerSummary *summary = &simulation->summary;
    simulation->looked_at = summary->steps;
    tinker_model_system_keep(&simulation->system, simulation->state.q, simulation->state.v);
    TinkerStatus status = tinker_books_look(&simulation->books, &simulation->state, summary);
    if (status == TINKER_OK && simulation->books.imbalance <= WARN_IMBALANCE)
        summary->valid_until = simulation->state.t;
    return status;
}

gboolean tinker_simulation_fail_step(TinkerSimulation *simulation, const char *why, GError **error)
{
    g_autofree char *kept = g_strdup(why);
    tinker_simulation_vouch(simulation);
    return tinker_simulation_fail(simulation, kept, error);
}

/* Judged at the end: in the first steps from rest nearly nothing has been exchanged, and any share of that is large. */
static void warn_of_imbalance(TinkerSimulation *simulation)
{
    const TinkerSummary *summary = &simulation->summary;
    if (summary->energy_balance_error <= WARN_IMBALANCE) return;
    g_autofree char *advice = tinker_guard_explain(simulation->model, simulation->method, simulation->options.step);
    g_ptr_array_add(summary->warnings,
                    g_strdup_printf("the energy is off by up to %.2g %% of the largest energy exchanged: %s",
                                    100 * summary->energy_balance_error, advice));
}

static gboolean look(TinkerSimulation *simulation, gboolean last, GError **error)
{
    TinkerModel *model = simulation->model;
    if (tinker_simulation_vouch(simulation) != TINKER_OK || !watch_constraints(simulation))
        return tinker_simulation_fail(simulation, model->failure, error);
    tinker_passing_look(simulation->passing, simulation->state.t, simulation->summary.warnings);
    double imbalance = simulation->books.imbalance;
    if (imbalance > STOP_IMBALANCE || !isfinite(imbalance)) {
        g_autofree char *how =
            g_strdup_printf("its energy is off by %.3g times the largest energy exchanged", imbalance);
        return diverged(simulation, how, error);
    }
    if (last) warn_of_imbalance(simulation);
    return TRUE;
}

/* One event for a passage, however many steps it takes; a place that is not left is no passage. */
static gboolean watch_singular_place(TinkerSimulation *simulation, GError **error)
{
    const TinkerConstraints *all = &simulation->model->constraints;
    if (!all->gave_way) {
        simulation->singular_steps = 0;
        return TRUE;
    }
    int32_t row = tinker_constraints_worst_row(simulation->model);
    const char *name = tinker_scene_block_name(simulation->model->scene, all->blocks[row]);
    simulation->singular_steps++;
    if (simulation->singular_steps == 1) tinker_simulation_add_event(simulation, "bifurcation", name);
    if (simulation->singular_steps <= MOST_SINGULAR_STEPS) return TRUE;
    g_autofree char *why =
        g_strdup_printf("%s and what it holds are stuck at a singular place, where no finite force in "
                        "them balances the load (move an end, or use a spring)",
                        name);
    return tinker_simulation_fail(simulation, why, error);
}

gboolean tinker_simulation_watch(TinkerSimulation *simulation, const TinkerStepReport *report, gboolean last,
                                 GError **error)
{
    TinkerSummary *summary = &simulation->summary;
    summary->steps++;
    summary->rejected_steps += report->rejected;
    summary->evaluations = simulation->model->evaluations;
    summary->simulated_s = simulation->state.t;
    if (!watch_singular_place(simulation, error)) return FALSE;
    if (!all_finite(simulation)) return diverged(simulation, "a position or velocity is not a number", error);
    if (summary->adaptive) tinker_model_system_keep(&simulation->system, simulation->state.q, simulation->state.v);
    gint64 since = (summary->steps - simulation->looked_at) * simulation->method->evaluations_per_step;
    gboolean looks = last || summary->steps <= FIRST_LOOKS || since >= EVALUATIONS_BETWEEN_LOOKS;
    return !looks || look(simulation, last, error);
}
