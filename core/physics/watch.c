/* Watching a run: numbers that are none stop it at once, an energy that does not balance warns or stops it. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/contacts.h"
#include "physics/guard.h"
#include "physics/island-run.h"

#define WARN_IMBALANCE 0.01
#define STOP_IMBALANCE 1.0
/* In the first steps from rest a method of order 1 is off by as much as has been exchanged. */
#define STOP_AT_FIRST 10.0
#define FIRST_STEPS   3
/* The books cost about one evaluation: they are looked into after this many. */
#define EVALUATIONS_BETWEEN_LOOKS 40
/* A step that is far too large shows at once. */
#define FIRST_LOOKS         8
#define MOST_SINGULAR_STEPS 30

gboolean tinker_island_run_fail(TinkerIslandRun *run, const char *why, GError **error)
{
    TinkerSummary *summary = &run->summary;
    summary->simulated_s = run->state.t;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                _("the run stopped at t = %.6g s: %s; what was computed is to be believed up to t = %.6g s"),
                run->state.t,
                why != NULL && why[0] != '\0' ? why : _("a force or a constraint cannot be worked out there"),
                summary->valid_until);
    return FALSE;
}

static gboolean diverged(TinkerIslandRun *run, const char *how, GError **error)
{
    g_autofree char *advice = tinker_guard_explain(run->model, run->choice.method, run->choice.step);
    g_autofree char *why = g_strdup_printf(_("it diverged: %s (%s)"), how, advice);
    return tinker_island_run_fail(run, why, error);
}

static gboolean all_finite(const TinkerIslandRun *run)
{
    /* A sum of zeros is 0 unless one factor is infinite or not a number. */
    double sum = 0;
    for (int32_t i = 0; i < run->system.system.size; i++)
        sum += 0.0 * run->state.q[i] + 0.0 * run->state.v[i];
    return sum == 0;
}

static gboolean watch_constraints(TinkerIslandRun *run)
{
    TinkerModel *model = run->model;
    TinkerSummary *summary = &run->summary;
    if (model->constraints.rows == 0) return TRUE;
    double position, velocity, extent, speed;
    const TinkerState *state = &run->state;
    if (tinker_constraints_errors(model, state->t, state->q, state->v, &position, &velocity) != TINKER_OK) return FALSE;
    run->system.system.scales(&run->system, state->q, state->v, &extent, &speed);
    for (int32_t i = model->bodies; i < model->points; i++)
        speed = fmax(speed, hypot(model->point[i].vx, model->point[i].vy));
    position = fmax(position, run->system.position_error);
    summary->constraint_position_error = fmax(summary->constraint_position_error, position);
    if (speed > tinker_island_run_speed_noise(run, extent))
        summary->constraint_velocity_error = fmax(summary->constraint_velocity_error, velocity / speed);
    return TRUE;
}

TinkerStatus tinker_island_run_vouch(TinkerIslandRun *run)
{
    TinkerSummary *summary = &run->summary;
    run->looked_at = summary->steps;
    tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    tinker_island_run_place(run);
    double extent, speed;
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &speed);
    if (tinker_contacts_act(run->model->contacts)) extent = fmax(extent, tinker_contacts_extent(run->model->contacts));
    TinkerState plane = {run->state.t, run->q, run->v, run->state.books};
    TinkerStatus status = tinker_books_look(&run->books, &plane, extent, summary);
    if (status == TINKER_OK && run->books.imbalance <= WARN_IMBALANCE) summary->valid_until = run->state.t;
    return status;
}

gboolean tinker_island_run_fail_step(TinkerIslandRun *run, const char *why, GError **error)
{
    g_autofree char *kept = g_strdup(why);
    tinker_island_run_vouch(run);
    return tinker_island_run_fail(run, kept, error);
}

/* Judged at the end: in the first steps from rest nearly nothing has been exchanged, and any share of that is large. */
static void warn_of_imbalance(TinkerIslandRun *run)
{
    const TinkerSummary *summary = &run->summary;
    if (summary->energy_balance_error <= WARN_IMBALANCE) return;
    if (run->books.allows_loss && run->books.imbalance <= WARN_IMBALANCE) {
        g_ptr_array_add(
            summary->warnings,
            g_strdup_printf(_("%s took up to %.2g %% of the largest energy exchanged from motion that its steps "
                              "do not resolve, as it is made to (a smaller step takes less)"),
                            run->choice.method->id, 100 * summary->energy_balance_error));
        return;
    }
    g_autofree char *advice = tinker_guard_explain(run->model, run->choice.method, run->choice.step);
    g_ptr_array_add(summary->warnings,
                    g_strdup_printf(_("the energy is off by up to %.3g %% of the largest energy exchanged: %s"),
                                    100 * summary->energy_balance_error, advice));
}

static void watch_stability(TinkerIslandRun *run)
{
    double stable = tinker_stability_watch_look(run->stability);
    if (!(stable > 0)) return;
    g_ptr_array_add(
        run->summary.warnings,
        g_strdup_printf(_("from t = %.6g s on %s is stable up to a step of about %.3g s only, the step is %g s: "
                          "the motion has become stiffer, and diverges if it goes on so"),
                        run->state.t, run->choice.method->id, stable, run->choice.step));
}

static gboolean look(TinkerIslandRun *run, gboolean last, GError **error)
{
    TinkerModel *model = run->model;
    if (tinker_island_run_vouch(run) != TINKER_OK || !watch_constraints(run))
        return tinker_island_run_fail(run, model->failure, error);
    double imbalance = run->books.imbalance;
    gboolean first = run->summary.steps <= FIRST_STEPS && run->choice.method->order == 1;
    double most = first ? STOP_AT_FIRST : STOP_IMBALANCE;
    if (imbalance > most || !isfinite(imbalance)) {
        g_autofree char *how =
            isfinite(imbalance)
                ? g_strdup_printf(_("its energy is off by %.3g times the largest energy exchanged"), imbalance)
                : g_strdup(_("its energy is beyond all numbers"));
        return diverged(run, how, error);
    }
    watch_stability(run);
    if (last) warn_of_imbalance(run);
    return TRUE;
}

/* One event for a passage, however many steps it takes; a place that is not left is no passage. */
static gboolean watch_singular_place(TinkerIslandRun *run, GError **error)
{
    const TinkerConstraints *all = &run->model->constraints;
    if (!all->gave_way) {
        run->singular_steps = 0;
        return TRUE;
    }
    int32_t row = tinker_constraints_worst_row(run->model);
    const char *name = tinker_scene_block_name(run->model->scene, all->blocks[row]);
    run->singular_steps++;
    if (run->singular_steps == 1) tinker_island_run_add_event(run, "bifurcation", name);
    if (run->singular_steps <= MOST_SINGULAR_STEPS) return TRUE;
    g_autofree char *why =
        g_strdup_printf(_("%s and what it holds are stuck at a singular place, where no finite force in "
                          "them balances the load (move an end, or use a spring)"),
                        name);
    return tinker_island_run_fail(run, why, error);
}

gboolean tinker_island_run_watch(TinkerIslandRun *run, const TinkerStepReport *report, gboolean last, GError **error)
{
    TinkerSummary *summary = &run->summary;
    summary->steps++;
    summary->rejected_steps += report->rejected;
    summary->evaluations = run->model->evaluations;
    summary->simulated_s = run->state.t;
    if (!watch_singular_place(run, error)) return FALSE;
    if (!all_finite(run)) return diverged(run, _("a position or velocity is not a number"), error);
    if (summary->adaptive) tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    gint64 since = (summary->steps - run->looked_at) * run->choice.method->evaluations_per_step;
    gboolean looks = last || summary->steps <= FIRST_LOOKS || since >= EVALUATIONS_BETWEEN_LOOKS;
    return !looks || look(run, last, error);
}
