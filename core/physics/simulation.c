/* The run: pieces between breaks, steps within a piece, samples within a step. */
#include <math.h>
#include <string.h>

#include "physics/sampler.h"
#include "physics/simulation-private.h"

/* Steps between two looks at whether the user has had enough. */
#define STEPS_BETWEEN_CALLS 256

static void event_free(gpointer data)
{
    TinkerEvent *event = data;
    g_free(event->kind);
    g_free(event->blocks);
    g_free(event);
}

void tinker_simulation_add_event(TinkerSimulation *simulation, const char *kind, const char *blocks)
{
    TinkerEvent *event = g_new0(TinkerEvent, 1);
    *event = (TinkerEvent){simulation->state.t, g_strdup(kind), g_strdup(blocks)};
    g_ptr_array_add(simulation->summary.events, event);
}

static void open_summary(TinkerSimulation *simulation)
{
    TinkerSummary *summary = &simulation->summary;
    const TinkerModel *model = simulation->model;
    summary->method = simulation->method->id;
    summary->adaptive = (simulation->method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    summary->step = simulation->options.step;
    summary->tolerance = simulation->options.tolerance;
    summary->start_impulse = model->start_impulse;
    summary->events = g_ptr_array_new_with_free_func(event_free);
    summary->warnings = g_ptr_array_new_with_free_func(g_free);
    for (guint i = 0; i < model->warnings->len; i++)
        g_ptr_array_add(summary->warnings, g_strdup(g_ptr_array_index(model->warnings, i)));
    if (model->start_impulse > 0) tinker_simulation_add_event(simulation, "start", "");
}

static gboolean open_state(TinkerSimulation *simulation, GError **error)
{
    TinkerModel *model = simulation->model;
    gsize n = 2 * (gsize)MAX(model->bodies, 1);
    tinker_model_system_init(&simulation->system, model);
    simulation->state =
        (TinkerState){0.0, g_memdup2(model->q_start, n * sizeof(double)), g_memdup2(model->v_start, n * sizeof(double)),
                      g_new0(double, simulation->system.system.books + 1)};
    simulation->sample_q = g_new0(double, n);
    simulation->sample_v = g_new0(double, n);
    model->evaluations = 0;
    TinkerIntegratorOptions options = {
        .struct_size = sizeof(TinkerIntegratorOptions),
        .tolerance = simulation->options.tolerance,
        .spectral_radius = simulation->options.spectral_radius,
    };
    simulation->stepper = simulation->method->create(&simulation->system.system, &options);
    if (simulation->stepper == NULL) {
        g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_METHOD,
                    "the method %s has not enough memory for %d coordinates", simulation->method->id,
                    simulation->system.system.size);
        return FALSE;
    }
    if (!tinker_simulation_enter_piece(simulation, MAX(simulation->times.duration, 1.0), error)) return FALSE;
    if (tinker_books_open(&simulation->books, &simulation->system) != TINKER_OK)
        return tinker_simulation_fail(simulation, model->failure, error);
    simulation->passing = tinker_passing_new(model);
    tinker_passing_look(simulation->passing, 0.0, simulation->summary.warnings);
    return TRUE;
}

TinkerSimulation *tinker_simulation_new(TinkerModel *model, const TinkerRunOptions *options, GError **error)
{
    g_autoptr(TinkerSimulation) simulation = g_new0(TinkerSimulation, 1);
    simulation->model = model;
    simulation->options = *options;
    simulation->method = tinker_run_method(model->scene, options->method, error);
    if (simulation->method == NULL) return NULL;
    double duration = options->duration;
    if (options->at != NULL) duration = 0;
    for (gsize i = 0; options->at != NULL && i < options->at_count; i++)
        duration = fmax(duration, options->at[i]);
    if (!tinker_run_options_check(options, simulation->method, duration, error)) return NULL;
    simulation->times = tinker_sample_times(duration, options->interval, options->at, options->at_count);
    simulation->times.duration = duration;
    simulation->step_grid = tinker_time_grid(options->step);
    open_summary(simulation);
    if (!open_state(simulation, error)) return NULL;
    return g_steal_pointer(&simulation);
}

void tinker_simulation_free(TinkerSimulation *simulation)
{
    if (simulation == NULL) return;
    if (simulation->stepper != NULL) simulation->method->destroy(simulation->stepper);
    tinker_model_system_clear(&simulation->system);
    tinker_passing_free(simulation->passing);
    tinker_sample_times_clear(&simulation->times);
    g_clear_pointer(&simulation->summary.events, g_ptr_array_unref);
    g_clear_pointer(&simulation->summary.warnings, g_ptr_array_unref);
    g_free(simulation->state.q);
    g_free(simulation->state.v);
    g_free(simulation->state.books);
    g_free(simulation->sample_q);
    g_free(simulation->sample_v);
    g_free(simulation);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* The end of the next step: the next time of the grid, or the end of the piece or the run where that comes first or all but
 * coincides. */
static double step_limit(TinkerSimulation *simulation, double run_end)
{
    double t = simulation->state.t, end = MIN(simulation->piece_end, run_end);
    if (simulation->method->flags & TINKER_INTEGRATOR_ADAPTIVE) return end;
    double slack = 1e-9 * simulation->options.step, next;
    while ((next = tinker_time_grid_at(&simulation->step_grid, simulation->next_step)) <= t + slack)
        simulation->next_step++;
    return next < end - slack ? next : end;
}

static gboolean take_step(TinkerSimulation *simulation, double end, GError **error)
{
    TinkerStepReport report = {.struct_size = sizeof(TinkerStepReport)};
    TinkerState *state = &simulation->state;
    if (state->t >= simulation->piece_end && !tinker_simulation_enter_piece(simulation, end, error)) return FALSE;
    simulation->model->failure[0] = '\0';
    simulation->model->constraints.gave_way = FALSE;
    double from = state->t;
    TinkerStatus status = simulation->method->step(simulation->stepper, state, step_limit(simulation, end), &report);
    if (status == TINKER_OK && !(state->t > from)) {
        status = TINKER_FAILED;
        report.failure = "the method answers that it made a step, but the time stands still (its plugin is at fault)";
    }
    if (status != TINKER_OK) {
        const char *why = simulation->model->failure[0] != '\0' ? simulation->model->failure : report.failure;
        return tinker_simulation_fail_step(simulation, why, error);
    }
    return tinker_simulation_watch(simulation, &report, state->t >= end, error);
}

gboolean tinker_simulation_step(TinkerSimulation *simulation, GError **error)
{
    double ahead = MAX(simulation->times.duration, 1.0);
    return take_step(simulation, simulation->state.t + ahead, error);
}

/* Samples ---------------------------------------------------------------------------------------------------------- */

typedef struct {
    TinkerSampler *sampler;
    double *values;
    TinkerSampleFunc sample;
    void *data;
    gint64 next; /* number of the next sample */
} Sampling;

/* The state at time t within the last step, on the constraints. */
static TinkerStatus state_at(TinkerSimulation *simulation, double t)
{
    const TinkerState *state = &simulation->state;
    double *q = simulation->sample_q, *v = simulation->sample_v;
    gsize bytes = (gsize)simulation->system.system.size * sizeof(double);
    simulation->sample_time = t;
    memcpy(q, state->q, bytes);
    memcpy(v, state->v, bytes);
    if (t == state->t) return TINKER_OK;
    TinkerStatus status = simulation->method->interpolate(simulation->stepper, t, q, v, NULL);
    if (status != TINKER_OK || simulation->model->constraints.rows == 0) return status;
    gboolean moved;
    status = tinker_constraints_project_positions(simulation->model, t, q, v, &moved);
    if (status == TINKER_OK) tinker_constraints_correct_velocities(simulation->model, v, FALSE, &moved);
    return status;
}

/* Hands out all samples before `until`, or up to it. */
static gboolean hand_out(TinkerSimulation *simulation, Sampling *sampling, double until, gboolean inclusive,
                         GError **error)
{
    while (sampling->next < simulation->times.count) {
        double t = tinker_sample_times_at(&simulation->times, sampling->next);
        if (t > until || (t == until && !inclusive)) break;
        sampling->next++;
        gint64 evaluations = simulation->model->evaluations;
        TinkerStatus status = state_at(simulation, t);
        if (status == TINKER_OK)
            status = tinker_sampler_values(sampling->sampler, t, simulation->sample_q, simulation->sample_v,
                                           sampling->values);
        simulation->model->evaluations = evaluations;
        if (status != TINKER_OK) return tinker_simulation_fail(simulation, simulation->model->failure, error);
        if (sampling->sample != NULL && !sampling->sample(simulation, t, sampling->values, sampling->data, error))
            return FALSE;
    }
    return TRUE;
}

static gboolean call_back(TinkerSimulation *simulation, GError **error)
{
    const TinkerRunOptions *options = &simulation->options;
    if (simulation->summary.steps % STEPS_BETWEEN_CALLS != 0) return TRUE;
    if (options->progress != NULL) options->progress(simulation->state.t, simulation->times.duration, options->data);
    if (options->cancelled == NULL || !options->cancelled(options->data)) return TRUE;
    tinker_simulation_vouch(simulation);
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED, "stopped at t = %.6g s of %.6g s",
                simulation->state.t, simulation->times.duration);
    return FALSE;
}

/* A sample that falls on a break is taken behind it: at the instant of a jump the state after it counts. */
static gboolean run_to_end(TinkerSimulation *simulation, Sampling *sampling, GError **error)
{
    double end = simulation->times.duration;
    if (!hand_out(simulation, sampling, 0.0, TRUE, error)) return FALSE;
    while (simulation->state.t < end) {
        if (!take_step(simulation, end, error)) return FALSE;
        double t = simulation->state.t;
        gboolean at_break = t >= simulation->piece_end && simulation->ends_on_break;
        if (!hand_out(simulation, sampling, t, !at_break, error) || !call_back(simulation, error)) return FALSE;
        if (!at_break) continue;
        if (!tinker_simulation_enter_piece(simulation, MAX(end, t + 1.0), error) ||
            !hand_out(simulation, sampling, t, TRUE, error))
            return FALSE;
    }
    return TRUE;
}

gboolean tinker_simulation_run(TinkerSimulation *simulation, const GArray *columns, TinkerSampleFunc sample, void *data,
                               GError **error)
{
    Sampling sampling = {
        .sampler = tinker_sampler_new(simulation->model, columns),
        .values = g_new0(double, columns != NULL ? columns->len + 1 : 1),
        .sample = sample,
        .data = data,
    };
    simulation->started = g_get_monotonic_time();
    gboolean done = run_to_end(simulation, &sampling, error);
    simulation->summary.wall_s = 1e-6 * (double)(g_get_monotonic_time() - simulation->started);
    simulation->summary.evaluations = simulation->model->evaluations;
    tinker_sampler_free(sampling.sampler);
    g_free(sampling.values);
    return done;
}

gboolean tinker_simulation_place(TinkerSimulation *simulation, TinkerFrame *frame, GError **error)
{
    const TinkerModel *model = simulation->model;
    if (!tinker_frame_set_time(frame, simulation->sample_time, error)) return FALSE;
    for (int32_t i = 0; i < model->bodies; i++) {
        double x, y, orientation;
        tinker_frame_centre(frame, model->body_blocks[i], &x, &y, &orientation);
        tinker_frame_place(frame, model->body_blocks[i], simulation->sample_q[2 * i] + model->origin[0],
                           simulation->sample_q[2 * i + 1] + model->origin[1], orientation);
    }
    return TRUE;
}

const TinkerSummary *tinker_simulation_summary(TinkerSimulation *simulation)
{
    return &simulation->summary;
}

double tinker_simulation_time(const TinkerSimulation *simulation)
{
    return simulation->state.t;
}

gboolean tinker_simulation_state(TinkerSimulation *simulation, TinkerBlockId block, double position[2],
                                 double velocity[2])
{
    const TinkerModel *model = simulation->model;
    int32_t point = model->centre_point[block];
    if (point < 0 || point >= model->bodies) return FALSE;
    for (int k = 0; k < 2; k++) {
        position[k] = simulation->state.q[2 * point + k] + model->origin[k];
        velocity[k] = simulation->state.v[2 * point + k];
    }
    return TRUE;
}
