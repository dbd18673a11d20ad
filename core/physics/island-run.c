/* Steps within a piece, states within a step. */
#include "physics/contact-run.h"

#include <errno.h>
#include <float.h>
#include <glib/gi18n-lib.h>
#include <string.h>

#include "numerics/integrators.h"
#include "physics/impulse.h"

/* A run that needs more steps than this of the size that it takes would not end in a lifetime: it is given up once so many
 * have been that small, one after the other. A stiff start has a few of them. */
#define MOST_STEPS_TO_COME 1e12
#define MOST_TINY_STEPS    10000
/* Of the extent. */
#define ROUNDING (100 * DBL_EPSILON)
/* What goes on where an exact solution ends with the first contact. */
#define METHOD_OF_CONTACTS "dop853"

static void open_method(TinkerIslandRun *run)
{
    run->summary.method = run->choice.method->id;
    run->summary.adaptive = (run->choice.method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    run->summary.step = run->choice.step;
    run->summary.tolerance = run->choice.tolerance;
}

static void open_summary(TinkerIslandRun *run, const TinkerSummary *whole)
{
    run->summary = (TinkerSummary){.events = whole->events, .warnings = whole->warnings};
    open_method(run);
}

static void open_state(TinkerIslandRun *run)
{
    const TinkerModel *model = run->model;
    gsize n = 2 * (gsize)MAX(model->bodies, 1);
    tinker_model_system_init(&run->system, run->model, run->island->linear);
    run->state.q = g_memdup2(model->q_start, n * sizeof(double));
    run->state.v = g_memdup2(model->v_start, n * sizeof(double));
    run->state.books = g_new0(double, run->system.system.books + 1);
    run->q = run->state.q;
    run->v = run->state.v;
    if (run->system.system.size != 2 * model->bodies) {
        run->q = g_new0(double, n);
        run->v = g_new0(double, n);
        tinker_linear_form_reduce(run->island->linear, model->q_start, model->v_start, run->state.q, run->state.v);
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

static gboolean open_run(TinkerIslandRun *run, double horizon, GError **error)
{
    TinkerModel *model = run->model;
    model->evaluations = 0;
    open_state(run);
    if (!open_stepper(run, error)) return FALSE;
    if (!tinker_island_run_enter_piece(run, horizon, error)) return FALSE;
    if (tinker_books_open(&run->books, &run->system) != TINKER_OK)
        return tinker_island_run_fail(run, model->failure, error);
    run->books.allows_loss = (run->choice.method->flags & TINKER_INTEGRATOR_DISSIPATES) != 0;
    run->stability = tinker_stability_watch_new(&run->system, run->choice.method, run->choice.step);
    if (run->choice.method == &tinker_integrator_impulse) return TRUE;
    run->contacts = tinker_contact_run_new(run);
    return run->contacts == NULL || tinker_contact_run_start(run->contacts, error);
}

TinkerIslandRun *tinker_island_run_new(const TinkerIsland *island, const TinkerChoice *choice, double spectral_radius,
                                       double horizon, const TinkerSummary *whole, GError **error)
{
    TinkerIslandRun *run = g_new0(TinkerIslandRun, 1);
    run->island = island;
    run->model = island->model;
    run->choice = *choice;
    run->step_grid = tinker_time_grid(choice->step);
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
    tinker_stability_watch_free(run->stability);
    if (run->q != run->state.q) {
        g_free(run->q);
        g_free(run->v);
    }
    gpointer arrays[] = {run->state.q, run->state.v, run->state.books, run->sample_x, run->sample_u};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(run);
}

double tinker_island_run_speed_noise(const TinkerIslandRun *run, double extent)
{
    if (!(run->state.t > 0)) return 0;
    return ROUNDING * extent * (double)run->summary.steps / run->state.t;
}

/* The books go on by what they hold, not by their places: contacts have opened others. */
static void carry_books(TinkerIslandRun *run, const double *kept)
{
    g_free(run->state.books);
    run->state.books = g_new0(double, run->system.system.books + 1);
    for (int32_t i = 0; i < run->system.system.books; i++)
        run->state.books[i] = kept[run->system.book_of[i]];
}

gboolean tinker_island_run_enter_plane(TinkerIslandRun *run, GError **error)
{
    double kept[TINKER_BOOK_COUNT] = {0}, speed = run->system.speed;
    double projection_work = run->system.projection_work, position_error = run->system.position_error;
    for (int32_t i = 0; i < run->system.system.books; i++)
        kept[run->system.book_of[i]] = run->state.books[i];
    tinker_island_run_place(run);
    if (run->q != run->state.q) {
        g_free(run->state.q);
        g_free(run->state.v);
        run->state.q = run->q;
        run->state.v = run->v;
    }
    tinker_method_destroy(run->choice.method, run->stepper);
    run->stepper = NULL;
    tinker_model_system_clear(&run->system);
    tinker_model_system_init(&run->system, run->model, NULL);
    tinker_model_system_expect_contacts(&run->system);
    run->system.speed = speed;
    run->system.projection_work = projection_work;
    run->system.position_error = position_error;
    tinker_model_system_keep(&run->system, run->model->q_start, run->model->v_start);
    tinker_model_system_keep(&run->system, run->state.q, run->state.v);
    carry_books(run, kept);
    g_clear_pointer(&run->stability, tinker_stability_watch_free);
    if (run->choice.method->flags & TINKER_INTEGRATOR_LINEAR)
        run->choice.method = tinker_integrator_builtin(METHOD_OF_CONTACTS);
    open_method(run);
    if (!open_stepper(run, error)) return FALSE;
    run->stability = tinker_stability_watch_new(&run->system, run->choice.method, run->choice.step);
    return TRUE;
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
 * coincides. */
static double step_limit(TinkerIslandRun *run, double target, double run_end)
{
    double t = run->state.t, end = MIN(run->piece_end, run_end);
    if (run->choice.method->flags & TINKER_INTEGRATOR_LINEAR) return MIN(end, target);
    if (run->choice.method->flags & TINKER_INTEGRATOR_ADAPTIVE) return end;
    double slack = 1e-9 * run->choice.step, next;
    while ((next = tinker_time_grid_at(&run->step_grid, run->next_step)) <= t + slack)
        run->next_step++;
    return next < end - slack ? next : end;
}

/* Whether the steps of an adaptive method are too small for the run to end. */
static gboolean is_hopeless(TinkerIslandRun *run, double step, double left)
{
    if (!(run->choice.method->flags & TINKER_INTEGRATOR_ADAPTIVE)) return FALSE;
    run->tiny_steps = left > MOST_STEPS_TO_COME * step ? run->tiny_steps + 1 : 0;
    return run->tiny_steps > MOST_TINY_STEPS;
}

/* One step of the method, that ends where contacts change. */
static TinkerStatus step_once(TinkerIslandRun *run, double limit, TinkerStepReport *report)
{
    if (run->contacts == NULL) return tinker_method_step(run->choice.method, run->stepper, &run->state, limit, report);
    limit = tinker_contact_run_begin(run->contacts, limit);
    TinkerStatus status = tinker_method_step(run->choice.method, run->stepper, &run->state, limit, report);
    return status == TINKER_OK ? tinker_contact_run_look(run->contacts, report) : status;
}

gboolean tinker_island_run_step(TinkerIslandRun *run, double target, double end, GError **error)
{
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    TinkerState *state = &run->state;
    if (run->contacts != NULL && !tinker_contact_run_pass(run->contacts, error)) return FALSE;
    if (state->t >= run->piece_end && !tinker_island_run_enter_piece(run, end, error)) return FALSE;
    run->model->failure[0] = '\0';
    run->model->constraints.gave_way = FALSE;
    double from = state->t;
    TinkerStatus status = step_once(run, step_limit(run, target, end), &report);
    if (status == TINKER_OK && !(state->t > from)) {
        status = TINKER_FAILED;
        report.failure =
            N_("the method answers that it made a step, but the time stands still (its plugin is at fault)");
    }
    if (status != TINKER_OK) {
        /* methods are built in or plugins, and do not translate */
        const char *failure = report.failure != NULL && report.failure[0] != '\0' ? _(report.failure) : NULL;
        const char *why = run->model->failure[0] != '\0' ? run->model->failure : failure;
        return tinker_island_run_fail_step(run, why, error);
    }
    if (is_hopeless(run, state->t - from, end - state->t))
        return tinker_island_run_fail_step(
            run,
            _("the motion asks for steps so small that the run would take more than 1e12 "
              "of them (some speed, force or frequency is out of all proportion)"),
            error);
    return tinker_island_run_watch(run, &report, state->t >= end, error);
}

gboolean tinker_island_run_pass_instant(TinkerIslandRun *run, double end, GError **error)
{
    double t = run->state.t;
    if (run->contacts != NULL && !tinker_contact_run_pass(run->contacts, error)) return FALSE;
    if (t < run->piece_end || !run->ends_on_break) return TRUE;
    return tinker_island_run_enter_piece(run, MAX(end, t + 1.0), error);
}

TinkerStatus tinker_island_run_state_at(TinkerIslandRun *run, double t, double *q, double *v)
{
    gboolean own = run->q == run->state.q;
    double *x = own ? q : run->sample_x, *u = own ? v : run->sample_u;
    gsize bytes = (gsize)run->system.system.size * sizeof(double);
    memcpy(x, run->state.q, bytes);
    memcpy(u, run->state.v, bytes);
    TinkerStatus status = TINKER_OK;
    if (t != run->state.t) status = tinker_method_interpolate(run->choice.method, run->stepper, t, x, u, NULL);
    if (!own) tinker_linear_form_expand(run->island->linear, x, u, q, v);
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
