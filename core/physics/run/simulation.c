/* The run of a whole scene: its islands are brought from sample to sample, each in steps of its own. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse.h"
#include "physics/island/island-run.h"
#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/sample-times.h"
#include "physics/run/island-steps.h"
#include "physics/run/simulation-private.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

TinkerSimulation *tinker_simulation_new_chosen(TinkerModel *model, const TinkerRunOptions *options,
                                               const TinkerChoice *choices, GError **error)
{
    TinkerIslandRuns *all = tinker_island_runs_new(model, options, choices, error);
    if (all == NULL) return NULL;
    TinkerSimulation *simulation = g_new0(TinkerSimulation, 1);
    simulation->all = all;
    return simulation;
}

TinkerSimulation *tinker_simulation_new(TinkerModel *model, const TinkerRunOptions *options, GError **error)
{
    return tinker_simulation_new_chosen(model, options, NULL, error);
}

void tinker_simulation_free(TinkerSimulation *simulation)
{
    if (simulation == NULL) return;
    tinker_estimate_free(simulation->estimate);
    tinker_box_watch_free(simulation->watch);
    tinker_event_values_free(simulation->events);
    tinker_sample_watch_free(simulation->all->samples);
    tinker_island_runs_free(simulation->all);
    g_free(simulation);
}

/* Tells, once, of bodies that pass through each other. */
static void look_for_overlap(TinkerSimulation *simulation, double t)
{
    TinkerBlockId pair[2];
    if (simulation->watch == NULL ||
        !tinker_box_watch_look(simulation->watch, simulation->all->sample_q, simulation->all->orientation, pair))
        return;
    const TinkerScene *scene = simulation->all->model->scene;
    tinker_summary_warn_of_scene(
        &simulation->all->summary,
        g_strdup_printf(_("%s and %s overlap at %.6g s: they pass through each other, as not both of them have "
                          "\"collides\" on"),
                        tinker_scene_block_name(scene, pair[0]), tinker_scene_block_name(scene, pair[1]), t));
    g_clear_pointer(&simulation->watch, tinker_box_watch_free);
}

static gboolean hand_out_event(void *taker, double t, const double *before, const double *behind, GError **error)
{
    TinkerSimulation *simulation = taker;
    return simulation->at_events(simulation, t, before, behind, simulation->data, error);
}

static gboolean advance(TinkerSimulation *simulation, double t, GError **error)
{
    if (simulation->events != NULL) return tinker_event_values_advance(simulation->events, t, error);
    return tinker_island_runs_advance(simulation->all, t, error);
}

static gboolean run_to_end(TinkerSimulation *simulation, TinkerSampleFunc sample, void *data, GError **error)
{
    for (gint64 i = 0; i < simulation->all->times.count; i++) {
        double t = tinker_sample_times_at(&simulation->all->times, i);
        if (simulation->all->samples != NULL) tinker_sample_watch_expect(simulation->all->samples, t);
        if (!advance(simulation, t, error)) return FALSE;
        if (simulation->all->samples != NULL) tinker_sample_watch_take(simulation->all->samples);
        look_for_overlap(simulation, t);
        if (tinker_island_runs_sample(simulation->all, t) != TINKER_OK)
            return tinker_island_run_fail(g_ptr_array_index(simulation->all->runs, 0), simulation->all->model->failure,
                                          error);
        if (simulation->estimate != NULL && !tinker_estimate_look(simulation->estimate, t, error)) return FALSE;
        if (sample != NULL && !sample(simulation, t, simulation->all->values, data, error)) return FALSE;
    }
    return tinker_island_runs_close(simulation->all, error);
}

static void add_up(TinkerSimulation *simulation)
{
    TinkerSummary *summary = &simulation->all->summary;
    tinker_island_runs_add_up(simulation->all);
    if (simulation->estimate == NULL || !simulation->ended) return;
    summary->error_estimate = tinker_simulation_error(simulation);
    if (summary->error_estimate < summary->missed) summary->error_estimate = summary->missed;
    summary->predictable_until = tinker_estimate_predictable_until(simulation->estimate);
}

gboolean tinker_simulation_run(TinkerSimulation *simulation, const GArray *columns, TinkerSampleFunc sample, void *data,
                               GError **error)
{
    gint64 started = g_get_monotonic_time();
    tinker_island_runs_take_columns(simulation->all, columns);
    simulation->watch = tinker_box_watch_new(simulation->all->model);
    simulation->all->samples = tinker_sample_watch_new(simulation->all);
    if (simulation->all->options.estimate) simulation->estimate = tinker_estimate_new(simulation->all, columns);
    simulation->data = data;
    if (simulation->at_events != NULL)
        simulation->events = tinker_event_values_new(simulation->all, hand_out_event, simulation);
    gboolean done = run_to_end(simulation, sample, data, error);
    if (simulation->estimate != NULL && !tinker_estimate_close(simulation->estimate, done ? error : NULL)) done = FALSE;
    if (simulation->all->samples != NULL) tinker_sample_watch_tell(simulation->all->samples, &simulation->all->summary);
    simulation->ended = TRUE;
    simulation->all->summary.wall_s = 1e-6 * (double)(g_get_monotonic_time() - started);
    add_up(simulation);
    return done;
}

void tinker_simulation_ask_at_events(TinkerSimulation *simulation, TinkerEventsFunc at_events)
{
    simulation->at_events = at_events;
}

double tinker_simulation_error(TinkerSimulation *simulation)
{
    /* at the start alone there is no error yet: a run that got no further has no estimate */
    return simulation->estimate != NULL && simulation->all->sample_time > 0
               ? tinker_estimate_error(simulation->estimate)
               : (double)NAN;
}

const double *tinker_simulation_bands(TinkerSimulation *simulation)
{
    return simulation->estimate != NULL ? tinker_estimate_bands(simulation->estimate) : NULL;
}

gboolean tinker_simulation_place(TinkerSimulation *simulation, TinkerFrame *frame, GError **error)
{
    const TinkerModel *model = simulation->all->model;
    if (!tinker_frame_set_time(frame, simulation->all->sample_time, error)) return FALSE;
    for (int32_t i = 0; i < model->bodies; i++) {
        double x, y, orientation, turned = simulation->all->orientation[i];
        tinker_frame_centre(frame, model->body_blocks[i], &x, &y, &orientation);
        if (!isnan(turned)) orientation = turned;
        if (tinker_model_turn_of(model, i) >= 0) orientation = tinker_model_angle(model, i, simulation->all->sample_q);
        tinker_frame_place(frame, model->body_blocks[i], simulation->all->sample_q[2 * i] + model->origin[0],
                           simulation->all->sample_q[2 * i + 1] + model->origin[1], orientation);
    }
    int32_t count;
    const TinkerBlockId *wound = tinker_frame_wound(frame, &count);
    for (int32_t i = 0; i < count; i++)
        tinker_frame_set_length(frame, wound[i], tinker_simulation_wound_length(simulation, wound[i]));
    return TRUE;
}

double tinker_simulation_wound_length(TinkerSimulation *simulation, TinkerBlockId block)
{
    return tinker_island_runs_wound_length(simulation->all, block);
}

gboolean tinker_simulation_body(const TinkerSimulation *simulation, TinkerBlockId block, TinkerBodySample *sample)
{
    const TinkerModel *model = simulation->all->model;
    int32_t body = tinker_model_centre(model, block);
    if (body < 0 || body >= model->bodies) return FALSE;
    *sample = (TinkerBodySample){simulation->all->sample_q[2 * body] + model->origin[0],
                                 simulation->all->sample_q[2 * body + 1] + model->origin[1],
                                 simulation->all->sample_v[2 * body],
                                 simulation->all->sample_v[2 * body + 1],
                                 simulation->all->orientation[body],
                                 tinker_model_angle(model, body, simulation->all->sample_v)};
    if (tinker_model_turn_of(model, body) >= 0)
        sample->orientation = tinker_model_angle(model, body, simulation->all->sample_q);
    return TRUE;
}

const TinkerSummary *tinker_simulation_summary(TinkerSimulation *simulation)
{
    add_up(simulation);
    return &simulation->all->summary;
}

gboolean tinker_simulation_state(TinkerSimulation *simulation, TinkerBlockId block, double position[2],
                                 double velocity[2])
{
    for (guint r = 0; r < simulation->all->runs->len; r++) {
        TinkerIslandRun *run = g_ptr_array_index(simulation->all->runs, r);
        int32_t point = tinker_model_centre(run->model, block);
        if (point < 0 || point >= run->model->bodies) continue;
        tinker_island_run_place(run);
        for (int k = 0; k < 2; k++) {
            position[k] = run->q[2 * point + k] + run->model->origin[k];
            velocity[k] = run->v[2 * point + k];
        }
        return TRUE;
    }
    return FALSE;
}

double tinker_simulation_time(const TinkerSimulation *simulation)
{
    return tinker_island_runs_time(simulation->all);
}

gboolean tinker_simulation_step(TinkerSimulation *simulation, GError **error)
{
    return tinker_island_runs_step_behind(simulation->all, error);
}
