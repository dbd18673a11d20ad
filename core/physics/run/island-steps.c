/* Steps within a piece, states within a step. */
#include "physics/event/blows.h"
#include "physics/event/contact-run.h"

#include <errno.h>
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/constraint/constraints.h"
#include "physics/impulse/impulse.h"
#include "physics/island/island-run.h"
#include "physics/island/stability-watch.h"
#include "physics/limit/direction-watch.h"
#include "physics/limit/idle-lines.h"
#include "physics/limit/law-watch.h"
#include "physics/model/breaks.h"
#include "physics/model/failures.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/record/sample-times.h"
#include "physics/run/island-steps.h"
#include "physics/run/tolerances.h"
#include "physics/system/books.h"
#include "physics/system/hold-energy.h"
#include "physics/system/method-call.h"
#include "physics/system/summary.h"
#include "physics/system/system.h"
#include "plugin/call/words.h"

/* A run that needs more steps than this of the size that it takes would not end in a lifetime: it is given up once so
 * many have been that small, one after the other, and none was twice as long as the first of them. A stiff start has a
 * few of them, and steps from rest on may grow slowly. */
#define MOST_STEPS_TO_COME 1e12
#define MOST_TINY_STEPS    10000

static void open_summary(TinkerIslandRun *run, const TinkerSummary *whole)
{
    run->summary = (TinkerSummary){.events = whole->events, .warnings = whole->warnings, .determined_until = INFINITY};
    tinker_island_run_name_method(run);
}

static gboolean check_directions(TinkerIslandRun *run, GError **error)
{
    if (run->directions == NULL || tinker_direction_watch_check(run->directions) == TINKER_OK) return TRUE;
    return tinker_island_run_fail(run, run->model->failure, error);
}

static gboolean open_run(TinkerIslandRun *run, double horizon, GError **error)
{
    TinkerModel *model = run->model;
    model->evaluations = 0;
    model->corrections = 0;
    model->lacks_memory = FALSE;
    tinker_island_run_open_state(run);
    if (!tinker_island_run_open_stepper(run, error)) return FALSE;
    if (!tinker_island_run_enter_piece(run, horizon, NULL, error)) return FALSE;
    if (tinker_books_open(&run->books, &run->system) != TINKER_OK)
        return tinker_island_run_fail(run, model->failure, error);
    tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    if (run->choice.holds_energy) tinker_model_system_start_holding(&run->system, &run->books.start);
    run->books.allows_loss = (run->choice.method->flags & TINKER_INTEGRATOR_DISSIPATES) != 0;
    run->stability = tinker_stability_watch_new(&run->system, run->choice.method, run->choice.step);
    if (!tinker_method_solves_contact(run->choice.method)) run->contacts = tinker_contact_run_new(run);
    if (run->contacts != NULL && !tinker_contact_run_start(run->contacts, error)) return FALSE;
    if (!tinker_island_run_strike(run, error)) return FALSE;
    run->directions = tinker_direction_watch_new(run);
    run->idle = tinker_idle_lines_new(run);
    run->laws = tinker_law_watch_new(run);
    return check_directions(run, error);
}

TinkerIslandRun *tinker_island_run_new(const TinkerIsland *island, const TinkerChoice *choice, double spectral_radius,
                                       double horizon, const TinkerSummary *whole, GArray *jolts, GError **error)
{
    TinkerIslandRun *run = g_new0(TinkerIslandRun, 1);
    run->island = island;
    run->model = island->model;
    run->choice = *choice;
    run->latest = INFINITY;
    run->jolts = jolts;
    run->step_grid = tinker_time_grid(choice->interval > 0 ? choice->interval : choice->step);
    open_summary(run, whole);
    run->spectral_radius = spectral_radius;
    if (!open_run(run, horizon, error)) g_clear_pointer(&run, tinker_island_run_free);
    return run;
}

void tinker_island_run_free(TinkerIslandRun *run)
{
    if (run == NULL) return;
    tinker_contact_run_free(run->contacts);
    tinker_direction_watch_free(run->directions);
    tinker_idle_lines_free(run->idle);
    tinker_law_watch_free(run->laws);
    tinker_island_run_clear(run);
    g_free(run);
}

/* Between breaks that are nearer to one another than its steps the run has what they leave for a step, and a companion
 * the same: half of it tells what that is off by. Of a companion's step to `next` the end of its first half, or of the
 * second. */
static G_NO_INLINE double cut_in_two(TinkerIslandRun *run, double next, double slack)
{
    const double t = run->state.t, middle = t + 0.5 * (next - t);
    if (run->half > t && run->half <= next) return run->half;
    const gboolean beside_break = t == run->piece_from || (next == run->piece_end && run->ends_on_break);
    if (!beside_break || next - t >= run->step_grid.spacing - slack || !(t < middle && middle < next)) return next;
    run->half = next;
    return middle;
}

/* The end of the next step: the next time of the grid, or the end of the piece or the run where that comes first or all
 * but coincides. Never a sample: who looks when changes no step. */
static double step_limit(TinkerIslandRun *run, double run_end)
{
    double t = run->state.t, end = MIN(MIN(run->piece_end, run->pole), run_end);
    if (tinker_method_is_adaptive(run->choice.method)) return run->latest > t ? MIN(end, run->latest) : end;
    double slack = 1e-9 * run->step_grid.spacing, next;
    while ((next = tinker_time_grid_at(&run->step_grid, run->next_step)) <= t + slack)
        run->next_step++;
    next = next < end - slack ? next : end;
    return run->is_companion && !tinker_method_is_exact(run->choice.method) ? cut_in_two(run, next, slack) : next;
}

/* Whether the steps of an adaptive method are too small for the run to end. */
static gboolean is_hopeless(TinkerIslandRun *run, double step, double left)
{
    if (!tinker_method_is_adaptive(run->choice.method)) return FALSE;
    const gboolean is_tiny = left > MOST_STEPS_TO_COME * step;
    if (!is_tiny || step > 2 * run->tiny) {
        run->tiny_steps = 0;
        run->tiny = is_tiny ? step : 0;
    }
    return ++run->tiny_steps > MOST_TINY_STEPS;
}

/* Passes what the state stands on: an event of contact, behind which velocities are others. */
static gboolean pass_event(TinkerIslandRun *run, GError **error)
{
    if (run->contacts == NULL || !tinker_contact_run_has_pending_event(run->contacts)) return TRUE;
    return tinker_contact_run_pass(run->contacts, error) && check_directions(run, error);
}

static TinkerStatus make_step(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    if (run->laws == NULL) return tinker_island_run_make_step(run, limit, report);
    return tinker_law_watch_step(run->laws, limit, report);
}

static TinkerStatus step_with_contacts(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    TinkerStatus status = tinker_contact_run_begin(run->contacts, &limit);
    if (status != TINKER_OK) return status;
    if (run->aside.method != NULL && !(run->choice.method->flags & TINKER_INTEGRATOR_LINEAR))
        tinker_island_run_name_method(run);
    status = make_step(run, limit, report);
    return status == TINKER_OK ? tinker_contact_run_look(run->contacts, report) : status;
}

/* One step of the method, that ends where contacts change. */
static TinkerStatus step_to_contact(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    if (run->contacts == NULL) return make_step(run, limit, report);
    const double from = run->state.t;
    TinkerStatus status = step_with_contacts(run, limit, report);
    const gboolean again = status != TINKER_OK && run->state.t == from && tinker_contact_run_jam(run->contacts);
    return again ? step_with_contacts(run, limit, report) : status;
}

/* One step, that ends where contacts change or a line's direction is lost. */
static TinkerStatus step_once(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    double from = run->state.t;
    if (run->idle != NULL) limit = tinker_idle_lines_limit(run->idle, limit);
    if (run->directions == NULL) return step_to_contact(run, limit, report);
    limit = tinker_direction_watch_begin(run->directions, limit);
    TinkerStatus status = step_to_contact(run, limit, report);
    return status == TINKER_OK ? tinker_direction_watch_look(run->directions, from, report) : status;
}

/* Beyond the end, so that an instant at the end has a piece behind it. */
static double horizon_of(const TinkerIslandRun *run, double end)
{
    return MAX(end, run->state.t + 1.0);
}

/* A step that would end on a pole is not made; only an adaptive method tries how near it gets. */
static gboolean is_at_pole(const TinkerIslandRun *run, double limit)
{
    gboolean adaptive = tinker_method_is_adaptive(run->choice.method);
    return run->state.t >= run->pole || (limit == run->pole && !adaptive);
}

/* Whether it is the pole that lets no step succeed. */
static gboolean is_near_pole(const TinkerIslandRun *run)
{
    return isfinite(run->pole) && run->pole - run->state.t <= TINKER_NEAR_POLE * run->pole;
}

static gboolean fail_at_pole(TinkerIslandRun *run, GError **error)
{
    g_autofree char *why = g_strdup_printf(
        _("%s: at t = %.10g s its waveform has no finite value (let it pass through no pole, and not leave the "
          "numbers for which it is defined: \"if\" and \"max\" keep it away)"),
        tinker_scene_block_name(run->model->scene, run->pole_block), run->pole);
    return tinker_island_run_fail_step(run, why, error);
}

/* Of a step that its method gave up: why, as the model says it, or else the method. */
static G_NO_INLINE gboolean fail_step(TinkerIslandRun *run, const TinkerStepReport *report, GError **error)
{
    TinkerModel *model = run->model;
    /* methods are built in or plugins, and do not translate */
    g_autofree char *words = tinker_plugin_words(NULL, run->choice.method, report->failure);
    if (model->failure[0] == '\0' && words == NULL && !model->lacks_memory)
        tinker_model_tell_failure(
            model, _("the method %s answers that a step failed, and does not say why (its plugin is at fault)"),
            run->choice.method->id);
    const char *why = model->failure[0] != '\0' ? model->failure : words != NULL ? _(words) : NULL;
    return tinker_island_run_fail_step(run, why, error);
}

gboolean tinker_island_run_step(TinkerIslandRun *run, double end, GError **error)
{
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    TinkerState *state = &run->state;
    tinker_constraints_end_look(run->model);
    if (!pass_event(run, error)) return FALSE;
    if (state->t >= run->piece_end && !tinker_island_run_enter_piece(run, horizon_of(run, end), NULL, error))
        return FALSE;
    run->model->failure = "";
    run->model->constraints.gave_way = FALSE;
    double from = state->t, limit = step_limit(run, end);
    if (is_at_pole(run, limit)) return fail_at_pole(run, error);
    if (run->laws != NULL) tinker_law_watch_set_end(run->laws, end);
    TinkerStatus status = step_once(run, limit, &report);
    gboolean failed = status != TINKER_OK || is_hopeless(run, state->t - from, end - state->t);
    if (failed && is_near_pole(run)) return fail_at_pole(run, error);
    if (status != TINKER_OK) return fail_step(run, &report, error);
    if (failed)
        return tinker_island_run_fail_step(
            run,
            _("the motion asks for steps so small that the run would take more than 1e12 "
              "of them (some speed, force or frequency is out of all proportion)"),
            error);
    return tinker_island_run_watch(run, &report, error);
}

/* What joints cannot follow they need not at the end of a run, so a sample there is that before the jump. A run that
 * goes on from here comes to the same break, and is refused then. */
static gboolean pass_break(TinkerIslandRun *run, double end, GError **error)
{
    gboolean jumps;
    GError *refused = NULL;
    if (tinker_island_run_enter_piece(run, horizon_of(run, end), &jumps, &refused)) return TRUE;
    if (!jumps) {
        g_propagate_error(error, refused);
        return FALSE;
    }
    g_error_free(refused);
    tinker_model_enter_piece(run->model, -INFINITY, run->state.t * (1 - TINKER_SAME_INSTANT), run->state.t);
    run->piece_end = run->state.t;
    run->ends_on_break = TRUE;
    return TRUE;
}

gboolean tinker_island_run_pass_instant(TinkerIslandRun *run, double end, GError **error)
{
    double t = run->state.t;
    tinker_constraints_end_look(run->model);
    if (!pass_event(run, error)) return FALSE;
    if (t < run->piece_end || !run->ends_on_break) return TRUE;
    return pass_break(run, end, error);
}
