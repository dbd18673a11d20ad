/* Watching a run: numbers that are none stop it at once, an energy that does not balance warns or stops it. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/island/island-run.h"
#include "physics/island/stability-watch.h"
#include "physics/limit/law-watch.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/plan/guard.h"
#include "physics/run/island-steps.h"
#include "physics/run/tolerances.h"
#include "physics/system/summary.h"
#include "physics/system/system.h"

#define STOP_IMBALANCE 1.0
/* Steps that an energy is off by more than was exchanged, until the run has diverged. */
#define LASTING 16
/* An energy swings to and fro about that share where it diverges slowly: below this one it has come back. */
#define BALANCED_AGAIN 0.5
/* Of the largest energy exchanged. */
#define DRIVEN 0.01
/* The books cost about one evaluation: they are looked into after this many. A step that needs none counts as one. */
#define EVALUATIONS_BETWEEN_LOOKS 40
/* Times the tolerance and the number of steps: an energy that is off by more is not so by the steps. */
#define FAR_BEYOND 100.0
/* A step that is far too large shows at once. */
#define FIRST_LOOKS         8
#define MOST_SINGULAR_STEPS 30

static gboolean diverged(TinkerIslandRun *run, const char *how, GError **error)
{
    g_autofree char *advice = tinker_guard_explain(run->model, run->choice.method, run->choice.step, FALSE);
    g_autofree char *why = g_strdup_printf(_("it diverged: %s (%s)"), how, advice);
    return tinker_island_run_fail(run, why, error);
}

static gboolean all_finite(const TinkerIslandRun *run)
{
    /* A sum of zeros is 0 unless one factor is infinite or not a number; four of them, so that an addition need not
     * wait for the one before. */
    const double *q = run->state.q, *v = run->state.v;
    const int32_t n = run->system.system.size;
    double sums[4] = {0, 0, 0, 0};
    int32_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++)
            sums[k] += 0.0 * q[i + k] + 0.0 * v[i + k];
    for (; i < n; i++)
        sums[0] += 0.0 * q[i] + 0.0 * v[i];
    return (sums[0] + sums[1]) + (sums[2] + sums[3]) == 0;
}

static gboolean watch_constraints(TinkerIslandRun *run)
{
    TinkerModel *model = run->model;
    TinkerSummary *summary = &run->summary;
    if (model->constraints.rows == 0) return TRUE;
    double position, velocity, extent, speed;
    const TinkerState *state = &run->state;
    tinker_island_run_place(run);
    if (tinker_constraints_errors(model, state->t, run->q, run->v, &position, &velocity) != TINKER_OK) return FALSE;
    run->system.system.scales(&run->system, state->q, state->v, &extent, &speed);
    for (int32_t i = model->bodies; i < model->points; i++)
        speed = fmax(speed, hypot(model->point[i].vx, model->point[i].vy));
    position = fmax(position, run->system.position_error);
    summary->constraint_position_error = fmax(summary->constraint_position_error, position);
    if (speed > tinker_island_run_speed_noise(run, extent))
        summary->constraint_velocity_error = fmax(summary->constraint_velocity_error, velocity / speed);
    return TRUE;
}

/* Whether the energy is off by far more than the errors of all steps, each held to the tolerance, add up to. */
static gboolean is_accurate(const TinkerIslandRun *run)
{
    const TinkerSummary *summary = &run->summary;
    if (!(run->choice.method->flags & TINKER_INTEGRATOR_ADAPTIVE)) return FALSE;
    return summary->energy_balance_error > FAR_BEYOND * run->choice.tolerance * (double)summary->steps;
}

/* Judged at the end: in the first steps from rest nearly nothing has been exchanged, and any share of that is large. */
static void warn_of_imbalance(TinkerIslandRun *run)
{
    const TinkerSummary *summary = &run->summary;
    if (summary->energy_balance_error <= TINKER_BALANCED) return;
    if (run->books.allows_loss && run->books.imbalance <= TINKER_BALANCED) {
        tinker_summary_warn_of_method(
            &run->summary,
            g_strdup_printf(_("%s took up to %.2g %% of the largest energy exchanged from motion that its steps "
                              "do not resolve, as it is made to (a smaller step takes less)"),
                            run->choice.method->id, 100 * summary->energy_balance_error));
        return;
    }
    g_autofree char *advice = tinker_guard_explain(run->model, run->choice.method, run->choice.step, is_accurate(run));
    tinker_summary_warn_of_method(
        &run->summary, g_strdup_printf(_("the energy is off by up to %.3g %% of the largest energy exchanged: %s"),
                                       100 * summary->energy_balance_error, advice));
}

/* Sweeps along the contacts of a pile are cut short where a step would take too long (impulse/pile-solve.c). */
static void warn_of_unsolved(TinkerIslandRun *run)
{
    const TinkerUnsolved *all = &run->system.unsolved;
    if (all->steps == 0) return;
    tinker_summary_warn_of_scene(
        &run->summary,
        g_strdup_printf(_("from t = %.6g s on, %.0f of %.0f steps went on before the impulses of all contacts were "
                          "solved for: at t = %.6g s one more sweep would have changed speeds by %.3g m/s (smaller "
                          "steps leave less)"),
                        all->first, (double)all->steps, (double)run->summary.steps, all->most_at, all->most));
}

static void watch_stability(TinkerIslandRun *run)
{
    double stable = tinker_stability_watch_look(run->stability);
    if (!(stable > 0)) return;
    tinker_summary_warn_of_method(
        &run->summary,
        g_strdup_printf(_("from t = %.6g s on %s is stable up to a step of about %.3g s only, the step is %g s: "
                          "the motion has become stiffer, and diverges if it goes on so"),
                        run->state.t, run->choice.method->id, stable, run->choice.step));
}

/* Whether it began at rest, with a step at which the method is stable. */
static gboolean is_set_going(TinkerIslandRun *run)
{
    if (run->books.start.kinetic > TINKER_BEGAN_AT_REST * run->books.exchanged) return FALSE;
    gint64 evaluations = run->model->evaluations;
    double stable = tinker_guard_stable_step(run->model, run->choice.method);
    run->model->evaluations = evaluations;
    return !(run->choice.step > stable);
}

/* Whether much of what was exchanged came from motors, moving supports or fields. */
static gboolean is_driven(const TinkerIslandRun *run)
{
    const double *books = run->summary.books;
    double driven = fmax(fabs(books[TINKER_BOOK_MOTORS]), fabs(books[TINKER_BOOK_SUPPORT_MOTION]));
    return fmax(driven, fabs(books[TINKER_BOOK_FIELDS])) > DRIVEN * run->books.exchanged;
}

/* Where something sets going what rests, the first steps of any size exchange little and may be wrong by more: that
 * passes, at the start, or later where something drives it. An energy that goes on to be off by more than was exchanged
 * does not. */
static gboolean has_diverged(TinkerIslandRun *run, gboolean last)
{
    double imbalance = run->books.imbalance;
    if (!isfinite(imbalance)) return TRUE;
    gboolean off = imbalance > STOP_IMBALANCE;
    if (imbalance < BALANCED_AGAIN) run->steps_off = 0;
    if (off) run->steps_off++;
    if (!off) return FALSE;
    gboolean may_pass = run->steps_off <= LASTING && (run->summary.steps <= LASTING || is_driven(run));
    return !may_pass || (last && !is_set_going(run));
}

static gboolean look(TinkerIslandRun *run, gboolean last, GError **error)
{
    TinkerModel *model = run->model;
    if (tinker_model_check_guards(model) != TINKER_OK || tinker_island_run_mark_valid(run) != TINKER_OK ||
        !watch_constraints(run))
        return tinker_island_run_fail(run, model->failure, error);
    double imbalance = run->books.imbalance;
    if (has_diverged(run, last)) {
        g_autofree char *how =
            isfinite(imbalance)
                ? g_strdup_printf(_("its energy is off by %.3g times the largest energy exchanged"), imbalance)
                : g_strdup(_("its energy is beyond all numbers"));
        return diverged(run, how, error);
    }
    watch_stability(run);
    return TRUE;
}

/* The state at a time within the last step in place of the one at its end. */
static TinkerStatus go_back_to(TinkerIslandRun *run, double t)
{
    TinkerState *state = &run->state;
    gsize bytes = (gsize)run->system.system.size * sizeof(double);
    g_autofree double *x = g_memdup2(state->q, bytes), *u = g_memdup2(state->v, bytes);
    TinkerStatus status = tinker_island_run_interpolate(run, t, x, u, state->books);
    if (status == TINKER_OK && run->q == state->q) status = tinker_island_run_state_at(run, t, x, u);
    memcpy(state->q, x, bytes);
    memcpy(state->v, u, bytes);
    state->t = t;
    return status;
}

gboolean tinker_island_run_close(TinkerIslandRun *run, double t, GError **error)
{
    TinkerSummary *summary = &run->summary;
    if (t < run->state.t && go_back_to(run, t) != TINKER_OK)
        return tinker_island_run_fail(run, run->model->failure, error);
    summary->simulated_s = t;
    summary->valid_until = fmin(summary->valid_until, t);
    if (!look(run, TRUE, error)) return FALSE;
    warn_of_imbalance(run);
    warn_of_unsolved(run);
    if (run->laws != NULL) tinker_law_watch_tell(run->laws);
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

gboolean tinker_island_run_watch(TinkerIslandRun *run, const TinkerStepReport *report, GError **error)
{
    TinkerSummary *summary = &run->summary;
    summary->steps++;
    summary->rejected_steps += report->rejected;
    summary->evaluations = run->model->evaluations;
    summary->simulated_s = run->state.t;
    if (!watch_singular_place(run, error)) return FALSE;
    if (!all_finite(run)) return diverged(run, _("a position or velocity is not a number"), error);
    if (tinker_constraints_rewind(run->model, run->state.t, run->q, run->v) != TINKER_OK)
        return tinker_island_run_fail(run, run->model->failure, error);
    if (summary->adaptive) tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    gint64 since = (summary->steps - run->looked_at) * MAX(run->choice.method->evaluations_per_step, 1);
    gboolean soon = summary->steps <= FIRST_LOOKS || run->steps_off > 0;
    gboolean looks = soon || since >= EVALUATIONS_BETWEEN_LOOKS;
    return !looks || look(run, FALSE, error);
}
