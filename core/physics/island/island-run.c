/* The state of an island on its way, the method that steps it, and states within its last step. */
#include "physics/island/island-run.h"

#include <errno.h>
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse.h"
#include "physics/island/stability-watch.h"
#include "physics/line/linear-form.h"
#include "physics/model/failures.h"
#include "physics/model/model.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* Of the extent. */
#define ROUNDING (100 * DBL_EPSILON)
/* What goes on where an exact solution ends with the first contact. */
#define METHOD_OF_CONTACTS "dop853"

void tinker_island_run_name_method(TinkerIslandRun *run)
{
    run->summary.method = run->choice.method->id;
    run->summary.adaptive = tinker_method_is_adaptive(run->choice.method);
    run->summary.step = run->choice.step;
    run->summary.tolerance = run->choice.tolerance;
}

void tinker_island_run_open_state(TinkerIslandRun *run)
{
    TinkerModel *model = run->model;
    tinker_constraints_set_all_slack(model, TRUE); /* a run before this one may have left others */
    gsize n = (gsize)MAX(model->coordinates, 1);
    tinker_model_system_init(&run->system, run->model, run->island->linear);
    run->room = g_new0(double, 6 * n + (gsize)run->system.system.books + 1);
    run->q = memcpy(run->room, model->q_start, n * sizeof(double));
    run->v = memcpy(run->room + n, model->v_start, n * sizeof(double));
    run->sample_x = run->room + 2 * n;
    run->sample_u = run->room + 3 * n;
    run->state.q = run->q;
    run->state.v = run->v;
    run->state.books = run->room + 6 * n;
    if (run->system.system.size != model->coordinates) {
        run->state.q = run->line_q = run->room + 4 * n;
        run->state.v = run->line_v = run->room + 5 * n;
        tinker_linear_form_reduce(run->island->linear, run->q, run->v, run->state.q, run->state.v);
    }
}

gboolean tinker_island_run_open_stepper(TinkerIslandRun *run, GError **error)
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
            _("the method %s cannot be set up for %d coordinates, and does not say why (its plugin's create answered "
              "nothing; the method auto takes one that suits)"),
            method->id, run->system.system.size);
    return FALSE;
}

void tinker_island_run_clear(TinkerIslandRun *run)
{
    if (run->stepper != NULL) tinker_method_destroy(run->choice.method, run->stepper);
    if (run->aside.stepper != NULL) tinker_method_destroy(run->aside.method, run->aside.stepper);
    tinker_stability_watch_free(run->stability);
    tinker_model_system_clear(&run->system);
    g_free(run->room);
}

double tinker_island_run_speed_noise(const TinkerIslandRun *run, double extent)
{
    if (!(run->state.t > 0)) return 0;
    const double rounding = ROUNDING * extent * (double)run->summary.steps / run->state.t;
    if (!tinker_method_solves_contact(run->choice.method)) return rounding;
    return fmax(rounding, tinker_impulse_speed_noise(run->stepper));
}

/* The method of flights and that of contacts change places; the one that comes forward may have no stepper yet. */
static void exchange_methods(TinkerIslandRun *run)
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
        exchange_methods(run);
    } else {
        tinker_method_destroy(run->choice.method, run->stepper);
        run->stepper = NULL;
    }
    if (run->stepper == NULL && !tinker_island_run_open_stepper(run, error)) return FALSE;
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
    exchange_methods(run);
    tinker_method_restart(run->choice.method, run->stepper);
}

void tinker_island_run_place(TinkerIslandRun *run)
{
    if (run->q != run->state.q)
        tinker_linear_form_expand(run->island->linear, run->state.q, run->state.v, run->q, run->v);
}

/* What a step did against integrator.h, as a sentence in the model's failure; FALSE where it did nothing such. What is
 * recorded between two steps would be made up otherwise. */
static gboolean breaks_contract(TinkerIslandRun *run, double from, double limit, const TinkerStepReport *report)
{
    const TinkerIntegrator *method = run->choice.method;
    const double t = run->state.t, made = t - from;
    const gboolean free_to_end = !tinker_method_is_fixed(method);
    if (G_LIKELY(t > from && (t == limit || (free_to_end && t < limit)) && report->step == made)) return FALSE;
    TinkerModel *model = run->model;
    if (!(t > from))
        tinker_model_tell_failure(
            model, _("the method %s answers that it made a step, but the time stands still (its plugin is at fault)"),
            method->id);
    else if (!(t <= limit))
        tinker_model_tell_failure(
            model,
            _("the method %s stepped to t = %.9g s, past the limit of %.9g s that it was given (its plugin is at "
              "fault)"),
            method->id, t, limit);
    else if (t != limit && !free_to_end)
        tinker_model_tell_failure(
            model,
            _("the method %s takes fixed steps and was to step to t = %.9g s, but ended at %.9g s (its plugin is "
              "at fault)"),
            method->id, limit, t);
    else if (!(fabs(report->step - made) <= 1e-9 * made + 4 * DBL_EPSILON * fabs(t)))
        tinker_model_tell_failure(
            model, _("the method %s reports a step of %.9g s and made one of %.9g s (its plugin is at fault)"),
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

void tinker_island_run_go_back(TinkerIslandRun *run, const TinkerState *from, double projection_work,
                               double position_error)
{
    const gsize bytes = (gsize)run->system.system.size * sizeof(double);
    run->state.t = from->t;
    memmove(run->state.q, from->q, bytes);
    memmove(run->state.v, from->v, bytes);
    memmove(run->state.books, from->books, (gsize)run->system.system.books * sizeof(double));
    run->system.projection_work = projection_work;
    run->system.position_error = position_error;
    tinker_method_restart(run->choice.method, run->stepper);
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
    const gboolean own = run->q == run->state.q;
    double *x = run->state.q, *u = run->state.v;
    TinkerStatus status = TINKER_OK;
    if (own || t != run->state.t) {
        const gsize bytes = (gsize)run->system.system.size * sizeof(double);
        x = memcpy(own ? q : run->sample_x, run->state.q, bytes);
        u = memcpy(own ? v : run->sample_u, run->state.v, bytes);
    }
    if (t != run->state.t) {
        status = tinker_island_run_interpolate(run, t, x, u, NULL);
        tinker_constraints_begin_look(run->model); /* what dense output evaluated it may not evaluate again */
    }
    if (own) return status;
    tinker_linear_form_expand(run->island->linear, x, u, q, v);
    /* the steps of shafts evaluate no constraint: a look finds what the last one left there, to the sign of a 0 */
    if (run->model->constraints.rows > 0)
        memset(run->model->point_acceleration, 0, 2 * (gsize)run->model->points * sizeof(double));
    return status;
}

TinkerStatus tinker_island_run_meet(TinkerIslandRun *run, double t, double *q, double *v)
{
    TinkerStatus status;
    gboolean moved;
    if (tinker_contacts_act(run->model->contacts)) {
        double work;
        status = tinker_contacts_project_positions(run->model->contacts, t, q, v, &moved, &work);
        if (status == TINKER_OK) tinker_contacts_correct_velocities(run->model->contacts, v, FALSE, &moved);
        return status;
    }
    /* the coordinates of shafts meet the constraints as they are */
    if (run->model->constraints.rows == 0 || run->q != run->state.q) return TINKER_OK;
    status = tinker_constraints_project_positions(run->model, t, q, v, &moved);
    if (status == TINKER_OK) tinker_constraints_correct_velocities(run->model, v, FALSE, &moved);
    return status;
}

TinkerStatus tinker_island_run_state_at(TinkerIslandRun *run, double t, double *q, double *v)
{
    TinkerStatus status = tinker_island_run_unprojected_at(run, t, q, v);
    return status == TINKER_OK && t != run->state.t ? tinker_island_run_meet(run, t, q, v) : status;
}
