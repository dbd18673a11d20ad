/* Steps within a piece, states within a step. */
#include "physics/contact-run.h"

#include <errno.h>
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/integrators.h"
#include "physics/direction-watch.h"
#include "physics/hold-energy.h"
#include "physics/impulse.h"
#include "plugin/words.h"

/* A run that needs more steps than this of the size that it takes would not end in a lifetime: it is given up once so many
 * have been that small, one after the other. A stiff start has a few of them. */
#define MOST_STEPS_TO_COME 1e12
#define MOST_TINY_STEPS    10000
/* Of the time at which a pole lies: how near an adaptive method comes to it at least. */
#define NEAR_POLE 1e-6
/* Of the extent. */
#define ROUNDING (100 * DBL_EPSILON)
/* What goes on where an exact solution ends with the first contact. */
#define METHOD_OF_CONTACTS "dop853"

const char *const tinker_method_swapped_state =
    N_("the method put other arrays in the place of those of the state, which it is to fill (its plugin is at fault)");

static void open_method(TinkerIslandRun *run)
{
    run->summary.method = run->choice.method->id;
    run->summary.adaptive = tinker_method_is_adaptive(run->choice.method);
    run->summary.step = run->choice.step;
    run->summary.tolerance = run->choice.tolerance;
}

void tinker_summary_warn_of_scene(TinkerSummary *summary, char *text)
{
    g_ptr_array_add(summary->warnings, text);
    g_ptr_array_add(summary->of_scene, text);
}

static void open_summary(TinkerIslandRun *run, const TinkerSummary *whole)
{
    run->summary = (TinkerSummary){.events = whole->events,
                                   .warnings = whole->warnings,
                                   .of_scene = whole->of_scene,
                                   .determined_until = INFINITY};
    open_method(run);
}

static void open_state(TinkerIslandRun *run)
{
    const TinkerModel *model = run->model;
    gsize n = 2 * (gsize)MAX(model->bodies, 1);
    tinker_model_system_init(&run->system, run->model, run->island->linear);
    run->q = g_memdup2(model->q_start, n * sizeof(double));
    run->v = g_memdup2(model->v_start, n * sizeof(double));
    run->state.q = run->q;
    run->state.v = run->v;
    run->state.books = g_new0(double, run->system.system.books + 1);
    if (run->system.system.size != 2 * model->bodies) {
        run->state.q = run->line_q = g_new0(double, n);
        run->state.v = run->line_v = g_new0(double, n);
        tinker_linear_form_reduce(run->island->linear, run->q, run->v, run->state.q, run->state.v);
    }
    run->sample_x = g_new0(double, n);
    run->sample_u = g_new0(double, n);
}

static gboolean open_stepper(TinkerIslandRun *run, GError **error)
{
    const TinkerIntegrator *method = run->choice.method;
    TinkerIntegratorOptions options = {
        .struct_size = sizeof(TinkerIntegratorOptions),
        .tolerance = run->choice.tolerance,
        .spectral_radius = run->spectral_radius,
    };
    if (method->flags & TINKER_INTEGRATOR_IMPLICIT) tinker_model_system_offer_jacobian(&run->system);
    errno = 0;
    if (!(method->flags & TINKER_INTEGRATOR_LINEAR) || run->system.system.linear != NULL)
        run->stepper = tinker_method_create(method, &run->system.system, &options);
    if (run->stepper != NULL) return TRUE;
    if (errno == ENOMEM)
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY,
                    _("there is no memory for the method %s on %d coordinates"), method->id, run->system.system.size);
    else if (method->flags & TINKER_INTEGRATOR_LINEAR)
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
            _("the method %s does not suit the part of the scene around %s, which is not linear or too large for it "
              "(the method auto takes one that suits)"),
            method->id, tinker_scene_block_name(run->model->scene, run->model->body_blocks[0]));
    else
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
            _("the method %s cannot be set up for %d coordinates (it refuses these options: spectral_radius is below 1 "
              "with constraints)"),
            method->id, run->system.system.size);
    return FALSE;
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
    model->lacks_memory = FALSE;
    open_state(run);
    if (!open_stepper(run, error)) return FALSE;
    if (!tinker_island_run_enter_piece(run, horizon, error)) return FALSE;
    if (tinker_books_open(&run->books, &run->system) != TINKER_OK)
        return tinker_island_run_fail(run, model->failure, error);
    tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    if (run->choice.holds_energy) tinker_model_system_start_holding(&run->system, &run->books.start);
    run->books.allows_loss = (run->choice.method->flags & TINKER_INTEGRATOR_DISSIPATES) != 0;
    run->stability = tinker_stability_watch_new(&run->system, run->choice.method, run->choice.step);
    if (run->choice.method != &tinker_integrator_impulse) run->contacts = tinker_contact_run_new(run);
    if (run->contacts != NULL && !tinker_contact_run_start(run->contacts, error)) return FALSE;
    run->directions = tinker_direction_watch_new(run);
    return check_directions(run, error);
}

TinkerIslandRun *tinker_island_run_new(const TinkerIsland *island, const TinkerChoice *choice, double spectral_radius,
                                       double horizon, const TinkerSummary *whole, GError **error)
{
    TinkerIslandRun *run = g_new0(TinkerIslandRun, 1);
    run->island = island;
    run->model = island->model;
    run->choice = *choice;
    run->longest_step = INFINITY;
    run->step_grid = tinker_time_grid(choice->interval > 0 ? choice->interval : choice->step);
    open_summary(run, whole);
    run->spectral_radius = spectral_radius;
    if (!open_run(run, horizon, error)) g_clear_pointer(&run, tinker_island_run_free);
    return run;
}

void tinker_island_run_free(TinkerIslandRun *run)
{
    if (run == NULL) return;
    if (run->stepper != NULL) tinker_method_destroy(run->choice.method, run->stepper);
    tinker_model_system_clear(&run->system);
    tinker_contact_run_free(run->contacts);
    tinker_direction_watch_free(run->directions);
    tinker_stability_watch_free(run->stability);
    if (run->aside.stepper != NULL) tinker_method_destroy(run->aside.method, run->aside.stepper);
    gpointer arrays[] = {run->q, run->v, run->line_q, run->line_v, run->state.books, run->sample_x, run->sample_u};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(run);
}

double tinker_island_run_speed_noise(const TinkerIslandRun *run, double extent)
{
    if (!(run->state.t > 0)) return 0;
    return ROUNDING * extent * (double)run->summary.steps / run->state.t;
}

/* The method of flights and that of contacts change places; the one that comes forward may have no stepper yet. */
static void change_places(TinkerIslandRun *run)
{
    const TinkerIntegrator *method = run->choice.method;
    void *stepper = run->stepper;
    run->choice.method = run->aside.method;
    run->stepper = run->aside.stepper;
    run->aside.method = method;
    run->aside.stepper = stepper;
}

gboolean tinker_island_run_enter_plane(TinkerIslandRun *run, GError **error)
{
    tinker_island_run_place(run);
    run->state.q = run->q;
    run->state.v = run->v;
    tinker_model_system_enter_plane(&run->system);
    tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    g_clear_pointer(&run->stability, tinker_stability_watch_free);
    if (run->choice.method->flags & TINKER_INTEGRATOR_LINEAR) {
        if (run->aside.method == NULL) run->aside.method = tinker_integrator_builtin(METHOD_OF_CONTACTS);
        change_places(run);
    } else {
        tinker_method_destroy(run->choice.method, run->stepper);
        run->stepper = NULL;
    }
    if (run->stepper == NULL && !open_stepper(run, error)) return FALSE;
    run->stability = tinker_stability_watch_new(&run->system, run->choice.method, run->choice.step);
    return TRUE;
}

void tinker_island_run_leave_plane(TinkerIslandRun *run)
{
    if (run->line_q != NULL) {
        tinker_linear_form_reduce(run->island->linear, run->q, run->v, run->line_q, run->line_v);
        run->state.q = run->line_q;
        run->state.v = run->line_v;
    }
    tinker_model_system_leave_plane(&run->system, run->island->linear);
    change_places(run);
    tinker_method_restart(run->choice.method, run->stepper);
}

void tinker_island_run_place(TinkerIslandRun *run)
{
    if (run->q != run->state.q)
        tinker_linear_form_expand(run->island->linear, run->state.q, run->state.v, run->q, run->v);
}

void tinker_island_run_add_event(TinkerIslandRun *run, const char *kind, const char *blocks)
{
    TinkerEvent *event = g_new0(TinkerEvent, 1);
    *event = (TinkerEvent){run->state.t, g_strdup(kind), g_strdup(blocks)};
    g_ptr_array_add(run->summary.events, event);
}

/* The end of the next step: the next time of the grid, or the end of the piece or the run where that comes first or all but
 * coincides. Never a sample: who looks when changes no step. */
static double step_limit(TinkerIslandRun *run, double run_end)
{
    double t = run->state.t, end = MIN(MIN(run->piece_end, run->pole), run_end);
    if (tinker_method_is_adaptive(run->choice.method)) return MIN(end, t + run->longest_step);
    double slack = 1e-9 * run->step_grid.spacing, next;
    while ((next = tinker_time_grid_at(&run->step_grid, run->next_step)) <= t + slack)
        run->next_step++;
    return next < end - slack ? next : end;
}

/* Whether the steps of an adaptive method are too small for the run to end. */
static gboolean is_hopeless(TinkerIslandRun *run, double step, double left)
{
    if (!tinker_method_is_adaptive(run->choice.method)) return FALSE;
    run->tiny_steps = left > MOST_STEPS_TO_COME * step ? run->tiny_steps + 1 : 0;
    return run->tiny_steps > MOST_TINY_STEPS;
}

/* Passes what the state stands on: an event of contact, behind which velocities are others. */
static gboolean pass_event(TinkerIslandRun *run, GError **error)
{
    if (run->contacts == NULL || !tinker_contact_run_stands_on_event(run->contacts)) return TRUE;
    return tinker_contact_run_pass(run->contacts, error) && check_directions(run, error);
}

/* What a step did against integrator.h, as a sentence in the model's failure; FALSE where it did nothing such. What is
 * recorded between two steps would be made up otherwise. */
static gboolean breaks_contract(TinkerIslandRun *run, double from, double limit, const TinkerStepReport *report)
{
    const TinkerIntegrator *method = run->choice.method;
    const double t = run->state.t, made = t - from;
    const gboolean free_to_end = !tinker_method_is_fixed(method);
    if (G_LIKELY(t > from && (t == limit || (free_to_end && t < limit)) && report->step == made)) return FALSE;
    char *text = run->model->failure;
    const gsize size = sizeof run->model->failure;
    if (!(t > from))
        g_snprintf(text, size,
                   _("the method %s answers that it made a step, but the time stands still (its plugin is at fault)"),
                   method->id);
    else if (!(t <= limit))
        g_snprintf(
            text, size,
            _("the method %s stepped to t = %.9g s, past the limit of %.9g s that it was given (its plugin is at "
              "fault)"),
            method->id, t, limit);
    else if (t != limit && !free_to_end)
        g_snprintf(
            text, size,
            _("the method %s takes fixed steps and was to step to t = %.9g s, but ended at %.9g s (its plugin is "
              "at fault)"),
            method->id, limit, t);
    else if (!(fabs(report->step - made) <= 1e-9 * made + 4 * DBL_EPSILON * fabs(t)))
        g_snprintf(text, size,
                   _("the method %s reports a step of %.9g s and made one of %.9g s (its plugin is at fault)"),
                   method->id, report->step, made);
    else
        return FALSE;
    return TRUE;
}

TinkerStatus tinker_island_run_make_step(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    const double from = run->state.t, work = run->system.projection_work;
    TinkerStatus status = tinker_method_step(run->choice.method, run->stepper, &run->state, limit, report);
    /* where it projects what it only tries, that does no work: what it hands out is projected already */
    if (tinker_method_remembers(run->choice.method)) run->system.projection_work = work;
    if (status != TINKER_OK || !breaks_contract(run, from, limit, report)) return status;
    run->state.t = from;
    return TINKER_FAILED;
}

/* One step of the method, that ends where contacts change. */
static TinkerStatus step_to_contact(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    if (run->contacts == NULL) return tinker_island_run_make_step(run, limit, report);
    limit = tinker_contact_run_begin(run->contacts, limit);
    if (run->aside.method != NULL && !(run->choice.method->flags & TINKER_INTEGRATOR_LINEAR)) open_method(run);
    TinkerStatus status = tinker_island_run_make_step(run, limit, report);
    return status == TINKER_OK ? tinker_contact_run_look(run->contacts, report) : status;
}

/* And where a line's direction is lost. */
static TinkerStatus step_once(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    double from = run->state.t;
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
    return isfinite(run->pole) && run->pole - run->state.t <= NEAR_POLE * run->pole;
}

static gboolean fail_at_pole(TinkerIslandRun *run, GError **error)
{
    g_autofree char *why = g_strdup_printf(
        _("%s: at t = %.10g s its waveform has no finite value (let it pass through no pole, and not leave the "
          "numbers for which it is defined: \"if\" and \"max\" keep it away)"),
        tinker_scene_block_name(run->model->scene, run->pole_block), run->pole);
    return tinker_island_run_fail_step(run, why, error);
}

gboolean tinker_island_run_step(TinkerIslandRun *run, double end, GError **error)
{
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    TinkerState *state = &run->state;
    tinker_constraints_end_look(run->model);
    if (!pass_event(run, error)) return FALSE;
    if (state->t >= run->piece_end && !tinker_island_run_enter_piece(run, horizon_of(run, end), error)) return FALSE;
    run->model->failure[0] = '\0';
    run->model->constraints.gave_way = FALSE;
    double from = state->t, limit = step_limit(run, end);
    if (is_at_pole(run, limit)) return fail_at_pole(run, error);
    TinkerStatus status = step_once(run, limit, &report);
    gboolean failed = status != TINKER_OK || is_hopeless(run, state->t - from, end - state->t);
    if (failed && is_near_pole(run)) return fail_at_pole(run, error);
    if (status != TINKER_OK) {
        /* methods are built in or plugins, and do not translate */
        g_autofree char *failure = tinker_plugin_words(NULL, run->choice.method, report.failure);
        const char *why = run->model->failure[0] != '\0' ? run->model->failure : failure != NULL ? _(failure) : NULL;
        return tinker_island_run_fail_step(run, why, error);
    }
    if (failed)
        return tinker_island_run_fail_step(
            run,
            _("the motion asks for steps so small that the run would take more than 1e12 "
              "of them (some speed, force or frequency is out of all proportion)"),
            error);
    return tinker_island_run_watch(run, &report, error);
}

gboolean tinker_island_run_pass_instant(TinkerIslandRun *run, double end, GError **error)
{
    double t = run->state.t;
    tinker_constraints_end_look(run->model);
    if (!pass_event(run, error)) return FALSE;
    if (t < run->piece_end || !run->ends_on_break) return TRUE;
    return tinker_island_run_enter_piece(run, horizon_of(run, end), error);
}

TinkerStatus tinker_island_run_interpolate(TinkerIslandRun *run, double t, double *x, double *u, double *books)
{
    gint64 evaluations = run->model->evaluations;
    TinkerStatus status = tinker_method_interpolate(run->choice.method, run->stepper, t, x, u, books);
    run->model->evaluations = evaluations;
    return status;
}

TinkerStatus tinker_island_run_unprojected_at(TinkerIslandRun *run, double t, double *q, double *v)
{
    tinker_constraints_begin_look(run->model);
    gboolean own = run->q == run->state.q;
    double *x = own ? q : run->sample_x, *u = own ? v : run->sample_u;
    gsize bytes = (gsize)run->system.system.size * sizeof(double);
    memcpy(x, run->state.q, bytes);
    memcpy(u, run->state.v, bytes);
    TinkerStatus status = TINKER_OK;
    if (t != run->state.t) status = tinker_island_run_interpolate(run, t, x, u, NULL);
    tinker_constraints_begin_look(run->model); /* what dense output evaluated it may not evaluate again */
    if (!own) tinker_linear_form_expand(run->island->linear, x, u, q, v);
    return status;
}

TinkerStatus tinker_island_run_state_at(TinkerIslandRun *run, double t, double *q, double *v)
{
    TinkerStatus status = tinker_island_run_unprojected_at(run, t, q, v);
    if (status != TINKER_OK || t == run->state.t) return status;
    gboolean moved;
    if (tinker_contacts_act(run->model->contacts)) {
        double work;
        status = tinker_contacts_project_positions(run->model->contacts, t, q, v, &moved, &work);
        if (status == TINKER_OK) tinker_contacts_correct_velocities(run->model->contacts, v, FALSE, &moved);
        return status;
    }
    if (run->model->constraints.rows == 0) return TINKER_OK;
    status = tinker_constraints_project_positions(run->model, t, q, v, &moved);
    if (status == TINKER_OK) tinker_constraints_correct_velocities(run->model, v, FALSE, &moved);
    return status;
}
