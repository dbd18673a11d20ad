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
#include "physics/plan/islands.h"
#include "physics/plan/plan-cost.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/sample-times.h"
#include "physics/run/island-steps.h"
#include "physics/run/simulation-private.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"

/* Between two looks at whether the user has had enough: steps, each counted once for every body that it moves, so that few looks
 * fall into many short steps and many into few long ones. */
#define WORK_BETWEEN_CALLS 256

void tinker_event_free(gpointer data)
{
    TinkerEvent *event = data;
    g_free(event->kind);
    g_free(event->blocks);
    g_free(event);
}

static void island_summary_free(gpointer data)
{
    TinkerIslandSummary *island = data;
    g_array_unref(island->bodies);
    g_free(island);
}

static void open_summary(TinkerSimulation *simulation)
{
    TinkerSummary *summary = &simulation->summary;
    const TinkerModel *model = simulation->model;
    summary->start_impulse = model->start_impulse;
    summary->error_estimate = NAN;
    summary->predictable_until = INFINITY;
    summary->accuracy = simulation->options.accuracy;
    summary->tries = g_array_new(FALSE, FALSE, sizeof(TinkerTry));
    summary->determined_until = INFINITY;
    summary->islands = g_ptr_array_new_with_free_func(island_summary_free);
    summary->events = g_ptr_array_new_with_free_func(tinker_event_free);
    summary->warnings = g_ptr_array_new_with_free_func(g_free);
    summary->of_scene = g_ptr_array_new();
    for (guint i = 0; i < model->warnings->len; i++)
        tinker_summary_warn_of_scene(summary, g_strdup(g_ptr_array_index(model->warnings, i)));
}

static void describe_island(TinkerSimulation *simulation, const TinkerIslandRun *run)
{
    TinkerIslandSummary *island = g_new0(TinkerIslandSummary, 1);
    *island = (TinkerIslandSummary){g_array_new(FALSE, FALSE, sizeof(TinkerBlockId)), run->summary.method,
                                    run->summary.adaptive, run->summary.step, run->summary.tolerance};
    g_array_append_vals(island->bodies, run->model->body_blocks, (guint)run->model->bodies);
    g_ptr_array_add(simulation->summary.islands, island);
}

/* Where steps end, whatever is recorded: at the scene's duration, and where samples are asked for beyond that, at every multiple
 * of it. */
static double steps_end(const TinkerSimulation *simulation, double t)
{
    double duration = simulation->options.duration;
    if (!(duration > 0)) return MAX(simulation->times.duration, t + 1.0);
    if (t < duration) return duration; /* nearly always: no division then */
    double count = floor(t / duration) + 1;
    while (count * duration <= t)
        count++;
    return count * duration;
}

/* Whether nobody has had enough. */
static gboolean goes_on(TinkerSimulation *simulation, GError **error)
{
    const TinkerRunOptions *options = &simulation->options;
    if (options->cancelled == NULL || !options->cancelled(options->data)) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED, _("stopped at t = %.6g s of %.6g s"),
                simulation->runs->len > 0 ? tinker_simulation_time(simulation) : 0.0, simulation->times.duration);
    return FALSE;
}

static gboolean open_runs(TinkerSimulation *simulation, const TinkerChoice *choices, GError **error)
{
    double duration = steps_end(simulation, 0);
    simulation->runs = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_island_run_free);
    for (guint i = 0; i < simulation->islands->len; i++) {
        const TinkerIsland *island = g_ptr_array_index(simulation->islands, i);
        TinkerChoice choice;
        if (!goes_on(simulation, error)) return FALSE;
        if (choices != NULL)
            choice = choices[i];
        else if (!tinker_plan_choose(island, &simulation->options, &choice, simulation->summary.warnings, error))
            return FALSE;
        TinkerIslandRun *run = tinker_island_run_new(island, &choice, simulation->options.spectral_radius,
                                                     MAX(duration, 1.0), &simulation->summary, error);
        if (run == NULL) return FALSE;
        g_ptr_array_add(simulation->runs, run);
        describe_island(simulation, run);
    }
    if (simulation->model->start_impulse > 0)
        tinker_island_run_add_event(g_ptr_array_index(simulation->runs, 0), "start", "");
    return TRUE;
}

/* NULL and an error where the options are no good whatever the method: before anything is worked out with them. */
static gboolean check_times(const TinkerRunOptions *options, GError **error)
{
    return tinker_run_options_check(options, NULL, tinker_options_duration(options), error);
}

TinkerSimulation *tinker_simulation_new_chosen(TinkerModel *model, const TinkerRunOptions *options,
                                               const TinkerChoice *choices, GError **error)
{
    if (!check_times(options, error)) return NULL;
    g_autoptr(TinkerSimulation) simulation = g_new0(TinkerSimulation, 1);
    gsize n = 2 * (gsize)MAX(model->bodies, 1);
    simulation->model = model;
    simulation->options = *options;
    simulation->times =
        tinker_sample_times(tinker_options_duration(options), options->interval, options->at, options->at_count);
    simulation->times.duration = tinker_options_duration(options);
    simulation->sample_q = g_new0(double, n);
    simulation->sample_v = g_new0(double, n);
    simulation->part_q = g_new0(double, n);
    simulation->part_v = g_new0(double, n);
    simulation->orientation = g_new(double, n);
    for (gsize i = 0; i < n; i++)
        simulation->orientation[i] = NAN;
    simulation->piece_end = -INFINITY;
    open_summary(simulation);
    if (model->contacts != NULL) model->contacts->impulses = FALSE; /* whatever ran before */
    simulation->islands = tinker_islands_for(model, options->impulses, error);
    if (simulation->islands == NULL || !open_runs(simulation, choices, error)) return NULL;
    return g_steal_pointer(&simulation);
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
    tinker_sampler_free(simulation->sampler);
    g_clear_pointer(&simulation->runs, g_ptr_array_unref);
    g_clear_pointer(&simulation->islands, g_ptr_array_unref);
    tinker_sample_times_clear(&simulation->times);
    g_clear_pointer(&simulation->summary.tries, g_array_unref);
    g_clear_pointer(&simulation->summary.islands, g_ptr_array_unref);
    g_clear_pointer(&simulation->summary.events, g_ptr_array_unref);
    g_clear_pointer(&simulation->summary.of_scene, g_ptr_array_unref);
    g_clear_pointer(&simulation->summary.warnings, g_ptr_array_unref);
    gpointer arrays[] = {simulation->sample_q, simulation->sample_v, simulation->part_q,
                         simulation->part_v,   simulation->values,   simulation->orientation};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(simulation);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static gboolean call_back(TinkerSimulation *simulation, TinkerIslandRun *run, GError **error)
{
    const TinkerRunOptions *options = &simulation->options;
    simulation->work += MAX(run->model->bodies, 1);
    if (simulation->work < WORK_BETWEEN_CALLS) return TRUE;
    simulation->work = 0;
    if (options->progress != NULL)
        options->progress(tinker_simulation_time(simulation), simulation->times.duration, options->data);
    if (goes_on(simulation, error)) return TRUE;
    tinker_island_run_vouch(run);
    return FALSE;
}

/* How the bodies of one island were turned by what they touched, among all. */
static void collect_orientations(TinkerSimulation *simulation, const TinkerIslandRun *run)
{
    gboolean impulses = run->choice.method == &tinker_integrator_impulse;
    for (int32_t i = 0; (run->contacts != NULL || impulses) && i < run->model->bodies; i++)
        simulation->orientation[run->island->body_of[i]] =
            impulses ? tinker_impulse_orientation(run->stepper, i) : tinker_contact_run_orientation(run->contacts, i);
}

/* Where the bodies of one island are at t, among all. */
static TinkerStatus collect(TinkerSimulation *simulation, TinkerIslandRun *run, double t)
{
    const TinkerModel *whole = simulation->model, *part = run->model;
    if (part == whole) return tinker_island_run_state_at(run, t, simulation->sample_q, simulation->sample_v);
    TinkerStatus status = tinker_island_run_state_at(run, t, simulation->part_q, simulation->part_v);
    for (int32_t i = 0; i < part->bodies; i++) {
        int32_t body = 2 * run->island->body_of[i];
        for (int k = 0; k < 2; k++) {
            simulation->sample_q[body + k] = simulation->part_q[2 * i + k] + (part->origin[k] - whole->origin[k]);
            simulation->sample_v[body + k] = simulation->part_v[2 * i + k];
        }
    }
    return status;
}

static int32_t plate_of_block(const TinkerContacts *contacts, TinkerBlockId block)
{
    int32_t plate = 0;
    while (contacts->plates[plate].block != block)
        plate++;
    return plate;
}

/* The whole model's rows that hold in one direction only are slack as those of the islands; the rows of one block have one
 * order in all models. */
static void gather_slack(TinkerSimulation *simulation)
{
    TinkerConstraints *all = &simulation->model->constraints;
    if (all->unilateral == NULL) return;
    g_autofree int32_t *next = g_new0(int32_t, simulation->runs->len + 1);
    for (int32_t row = 0; row < all->rows; row++) {
        for (guint i = 0; all->unilateral[row] && i < simulation->runs->len; i++) {
            const TinkerIslandRun *run = g_ptr_array_index(simulation->runs, i);
            const TinkerConstraints *part = &run->model->constraints;
            while (next[i] < part->rows && part->blocks[next[i]] != all->blocks[row] &&
                   !(part->unilateral != NULL && part->unilateral[next[i]]))
                next[i]++;
            if (next[i] >= part->rows || part->blocks[next[i]] != all->blocks[row]) continue;
            tinker_constraints_set_slack(simulation->model, row, part->slack[next[i]++]);
        }
    }
}

static gint64 count_contact_changes(const TinkerSimulation *simulation)
{
    gint64 changes = 0;
    for (guint i = 0; i < simulation->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(simulation->runs, i);
        if (run->contacts != NULL) changes += tinker_contact_run_changes(run->contacts);
    }
    return changes;
}

/* Where the islands are stepped apart, the whole model's contacts are closed as theirs are. */
static gboolean gather_contacts(TinkerSimulation *simulation, GError **error)
{
    TinkerContacts *all = simulation->model->contacts;
    if (all == NULL || simulation->runs->len < 2) return TRUE;
    gint64 changes = count_contact_changes(simulation);
    if (changes == simulation->contact_changes) return TRUE;
    simulation->contact_changes = changes;
    g_array_set_size(all->closed, 0);
    for (guint i = 0; i < simulation->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(simulation->runs, i);
        const TinkerContacts *part = run->model->contacts;
        for (guint k = 0; part != NULL && k < part->closed->len; k++) {
            TinkerContact contact = *tinker_contacts_closed(part, k);
            contact.body = run->island->body_of[contact.body];
            contact.plate = plate_of_block(all, part->plates[contact.plate].block);
            g_array_append_val(all->closed, contact);
        }
    }
    gather_slack(simulation);
    if (tinker_contacts_list_rows(all) == TINKER_OK) return TRUE;
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY, simulation->model->failure);
    return FALSE;
}

gboolean tinker_simulation_step_island(TinkerSimulation *simulation, guint number, GError **error)
{
    TinkerIslandRun *run = g_ptr_array_index(simulation->runs, number);
    return tinker_island_run_step(run, steps_end(simulation, run->state.t), error) && call_back(simulation, run, error);
}

static gboolean follow(TinkerSimulation *simulation, guint number, double t, GError **error)
{
    return simulation->estimate == NULL || tinker_estimate_follow(simulation->estimate, number, t, error);
}

/* A sample that falls on a break is taken behind it: at the instant of a jump the state after it counts. */
gboolean tinker_simulation_advance(TinkerSimulation *simulation, double t, GError **error)
{
    for (guint i = 0; i < simulation->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(simulation->runs, i);
        if (run->abandoned) continue;
        if (!follow(simulation, i, t, error)) return FALSE;
        while (run->state.t < t)
            if (!tinker_simulation_step_island(simulation, i, error) || !follow(simulation, i, t, error)) return FALSE;
        double end = steps_end(simulation, t);
        if (t > 0 && run->state.t == t && !tinker_island_run_pass_instant(run, end, error)) return FALSE;
        TinkerStatus status = collect(simulation, run, t);
        if (status != TINKER_OK) return tinker_island_run_fail(run, run->model->failure, error);
        collect_orientations(simulation, run);
    }
    simulation->sample_time = t;
    return gather_contacts(simulation, error);
}

gboolean tinker_simulation_step(TinkerSimulation *simulation, GError **error)
{
    TinkerIslandRun *behind = g_ptr_array_index(simulation->runs, 0);
    for (guint i = 1; i < simulation->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(simulation->runs, i);
        if (run->state.t < behind->state.t) behind = run;
    }
    return tinker_island_run_step(behind, steps_end(simulation, behind->state.t), error);
}

/* Samples ---------------------------------------------------------------------------------------------------------- */

/* The whole model has its own waveforms where it is not stepped itself: they enter the piece that t begins or lies in. */
static void enter_piece_at(TinkerSimulation *simulation, double t)
{
    const TinkerIslandRun *first = g_ptr_array_index(simulation->runs, 0);
    if (first->model == simulation->model || t < simulation->piece_end) return;
    double horizon = MAX(simulation->times.duration, t + 1.0);
    double next = tinker_model_next_break(simulation->model, t, horizon);
    simulation->piece_end = MIN(next, horizon);
    tinker_model_enter_piece(simulation->model, 0.5 * (t + simulation->piece_end));
}

TinkerStatus tinker_simulation_sample(TinkerSimulation *simulation, double t)
{
    gint64 evaluations = simulation->model->evaluations;
    enter_piece_at(simulation, t);
    TinkerStatus status =
        tinker_sampler_values(simulation->sampler, t, simulation->sample_q, simulation->sample_v, simulation->values);
    simulation->model->evaluations = evaluations;
    return status;
}

static gboolean close_runs(TinkerSimulation *simulation, GError **error)
{
    for (guint i = 0; i < simulation->runs->len; i++)
        if (!tinker_island_run_close(g_ptr_array_index(simulation->runs, i), simulation->times.duration, error))
            return FALSE;
    return TRUE;
}

/* Tells, once, of bodies that pass through each other. */
static void look_for_overlap(TinkerSimulation *simulation, double t)
{
    TinkerBlockId pair[2];
    if (simulation->watch == NULL ||
        !tinker_box_watch_look(simulation->watch, simulation->sample_q, simulation->orientation, pair))
        return;
    const TinkerScene *scene = simulation->model->scene;
    tinker_summary_warn_of_scene(
        &simulation->summary,
        g_strdup_printf(_("%s and %s overlap at %.6g s: they pass through each other, as contact between "
                          "bodies is not modelled"),
                        tinker_scene_block_name(scene, pair[0]), tinker_scene_block_name(scene, pair[1]), t));
    g_clear_pointer(&simulation->watch, tinker_box_watch_free);
}

static gboolean run_to_end(TinkerSimulation *simulation, TinkerSampleFunc sample, void *data, GError **error)
{
    for (gint64 i = 0; i < simulation->times.count; i++) {
        double t = tinker_sample_times_at(&simulation->times, i);
        if (!tinker_simulation_advance(simulation, t, error)) return FALSE;
        look_for_overlap(simulation, t);
        if (tinker_simulation_sample(simulation, t) != TINKER_OK)
            return tinker_island_run_fail(g_ptr_array_index(simulation->runs, 0), simulation->model->failure, error);
        if (simulation->estimate != NULL && !tinker_estimate_look(simulation->estimate, t, error)) return FALSE;
        if (sample != NULL && !sample(simulation, t, simulation->values, data, error)) return FALSE;
    }
    return close_runs(simulation, error);
}

gboolean tinker_simulation_run(TinkerSimulation *simulation, const GArray *columns, TinkerSampleFunc sample, void *data,
                               GError **error)
{
    gint64 started = g_get_monotonic_time();
    simulation->sampler = tinker_sampler_new(simulation->model, columns);
    simulation->values = g_new0(double, columns != NULL ? columns->len + 1 : 1);
    simulation->watch = tinker_box_watch_new(simulation->model);
    if (simulation->options.estimate) simulation->estimate = tinker_estimate_new(simulation, columns);
    gboolean done = run_to_end(simulation, sample, data, error);
    if (simulation->estimate != NULL) tinker_estimate_close(simulation->estimate);
    simulation->summary.wall_s = 1e-6 * (double)(g_get_monotonic_time() - started);
    tinker_simulation_add_up(simulation);
    return done;
}

const double *tinker_simulation_bands(TinkerSimulation *simulation)
{
    return simulation->estimate != NULL ? tinker_estimate_bands(simulation->estimate) : NULL;
}

gboolean tinker_simulation_place(TinkerSimulation *simulation, TinkerFrame *frame, GError **error)
{
    const TinkerModel *model = simulation->model;
    if (!tinker_frame_set_time(frame, simulation->sample_time, error)) return FALSE;
    for (int32_t i = 0; i < model->bodies; i++) {
        double x, y, orientation, turned = simulation->orientation[i];
        tinker_frame_centre(frame, model->body_blocks[i], &x, &y, &orientation);
        if (!isnan(turned)) orientation = turned;
        tinker_frame_place(frame, model->body_blocks[i], simulation->sample_q[2 * i] + model->origin[0],
                           simulation->sample_q[2 * i + 1] + model->origin[1], orientation);
    }
    return TRUE;
}

gboolean tinker_simulation_body(const TinkerSimulation *simulation, TinkerBlockId block, TinkerBodySample *sample)
{
    const TinkerModel *model = simulation->model;
    int32_t body = model->centre_point[block];
    if (body < 0 || body >= model->bodies) return FALSE;
    *sample = (TinkerBodySample){simulation->sample_q[2 * body] + model->origin[0],
                                 simulation->sample_q[2 * body + 1] + model->origin[1], simulation->sample_v[2 * body],
                                 simulation->sample_v[2 * body + 1], simulation->orientation[body]};
    return TRUE;
}

const TinkerSummary *tinker_simulation_summary(TinkerSimulation *simulation)
{
    tinker_simulation_add_up(simulation);
    return &simulation->summary;
}

double tinker_simulation_time(const TinkerSimulation *simulation)
{
    double t = INFINITY;
    for (guint i = 0; i < simulation->runs->len; i++)
        t = MIN(t, ((const TinkerIslandRun *)g_ptr_array_index(simulation->runs, i))->state.t);
    return t;
}

gboolean tinker_simulation_state(TinkerSimulation *simulation, TinkerBlockId block, double position[2],
                                 double velocity[2])
{
    for (guint r = 0; r < simulation->runs->len; r++) {
        TinkerIslandRun *run = g_ptr_array_index(simulation->runs, r);
        int32_t point = run->model->centre_point[block];
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
