/* All islands of a scene are brought from sample to sample, each in steps of its own. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run.h"
#include "physics/impulse/impulse.h"
#include "physics/island/island-run.h"
#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "physics/plan/plan-cost.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/record/sample-times.h"
#include "physics/run/island-runs.h"
#include "physics/run/island-steps.h"
#include "physics/run/simulation.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"
#include "physics/system/summary.h"

/* Between two looks at whether the user has had enough: steps, each counted once for every body that it moves, so that
 * few looks fall into many short steps and many into few long ones; and no fewer than there are islands, which such a
 * look goes through. */
#define WORK_BETWEEN_CALLS 256

void tinker_event_free(gpointer data)
{
    TinkerEvent *event = data;
    g_free(event->kind);
    g_free(event->blocks);
    g_clear_pointer(&event->alternatives, g_array_unref);
    g_free(event);
}

static void island_summary_free(gpointer data)
{
    TinkerIslandSummary *island = data;
    g_array_unref(island->bodies);
    g_free(island);
}

static void open_summary(TinkerIslandRuns *self)
{
    TinkerSummary *summary = &self->summary;
    const TinkerModel *model = self->model;
    summary->start_impulse = model->start_impulse;
    summary->error_estimate = NAN;
    summary->predictable_until = INFINITY;
    summary->accuracy = self->options.accuracy;
    summary->tries = g_array_new(FALSE, FALSE, sizeof(TinkerTry));
    summary->determined_until = INFINITY;
    summary->islands = g_ptr_array_new_with_free_func(island_summary_free);
    summary->events = g_ptr_array_new_with_free_func(tinker_event_free);
    summary->warnings = g_ptr_array_new_with_free_func(g_free);
    summary->of_scene = g_ptr_array_new();
    for (guint i = 0; i < model->warnings->len; i++)
        tinker_summary_warn_of_scene(summary, g_strdup(g_ptr_array_index(model->warnings, i)));
    char *unmet = tinker_options_unmet(&self->options, model);
    if (unmet != NULL) tinker_summary_warn_of_scene(summary, unmet);
}

/* Where steps end, whatever is recorded: at the scene's duration, and where samples are asked for beyond that, at every
 * multiple of it. */
static double steps_end(const TinkerIslandRuns *self, double t)
{
    double duration = self->options.duration;
    if (!(duration > 0)) return MAX(self->times.duration, t + 1.0);
    if (t < duration) return duration; /* nearly always: no division then */
    double count = floor(t / duration) + 1;
    while (count * duration <= t)
        count++;
    return count * duration;
}

gboolean tinker_island_runs_fail_stopped(const TinkerIslandRuns *self, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_STOPPED, _("stopped at t = %.6g s of %.6g s"),
                self->runs->len > 0 ? tinker_island_runs_time(self) : 0.0, self->times.duration);
    return FALSE;
}

/* Whether nobody has had enough. */
static gboolean check_cancelled(TinkerIslandRuns *self, GError **error)
{
    const TinkerRunOptions *options = &self->options;
    if (options->cancelled == NULL || !options->cancelled(options->data)) return TRUE;
    return tinker_island_runs_fail_stopped(self, error);
}

static gboolean open_runs(TinkerIslandRuns *self, const TinkerChoice *choices, GError **error)
{
    double duration = steps_end(self, 0);
    self->runs = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_island_run_free);
    for (guint i = 0; i < self->islands->len; i++) {
        const TinkerIsland *island = g_ptr_array_index(self->islands, i);
        TinkerChoice choice;
        if (!check_cancelled(self, error)) return FALSE;
        if (choices != NULL)
            choice = choices[i];
        else if (!tinker_plan_choose(island, &self->options, &choice, self->summary.warnings, error))
            return FALSE;
        TinkerIslandRun *run = tinker_island_run_new(island, &choice, self->options.spectral_radius, MAX(duration, 1.0),
                                                     &self->summary, error);
        if (run == NULL) return FALSE;
        g_ptr_array_add(self->runs, run);
    }
    if (self->model->start_changed) tinker_island_run_add_event(g_ptr_array_index(self->runs, 0), "start", "");
    return TRUE;
}

/* NULL and an error where the options are no good whatever the method: before anything is worked out with them. */
static gboolean check_times(const TinkerRunOptions *options, GError **error)
{
    return tinker_run_options_check(options, NULL, tinker_options_duration(options), error);
}

TinkerIslandRuns *tinker_island_runs_new(TinkerModel *model, const TinkerRunOptions *options,
                                         const TinkerChoice *choices, GError **error)
{
    if (!check_times(options, error)) return NULL;
    g_autoptr(TinkerIslandRuns) self = g_new0(TinkerIslandRuns, 1);
    gsize n = (gsize)MAX(model->coordinates, 1);
    self->model = model;
    self->options = *options;
    self->times =
        tinker_sample_times(tinker_options_duration(options), options->interval, options->at, options->at_count);
    self->times.duration = tinker_options_duration(options);
    self->sample_q = g_new0(double, n);
    self->sample_v = g_new0(double, n);
    self->part_q = g_new0(double, n);
    self->part_v = g_new0(double, n);
    self->orientation = g_new(double, n);
    for (gsize i = 0; i < n; i++)
        self->orientation[i] = NAN;
    self->piece_end = -INFINITY;
    open_summary(self);
    if (model->contacts != NULL) model->contacts->impulses = FALSE; /* whatever ran before */
    self->islands = tinker_islands_for(model, options->impulses, error);
    if (self->islands == NULL || !open_runs(self, choices, error)) return NULL;
    return g_steal_pointer(&self);
}

void tinker_island_runs_free(TinkerIslandRuns *self)
{
    if (self == NULL) return;
    tinker_sampler_free(self->sampler);
    tinker_along_run_free(self->along);
    g_clear_pointer(&self->runs, g_ptr_array_unref);
    g_clear_pointer(&self->islands, g_ptr_array_unref);
    tinker_sample_times_clear(&self->times);
    g_clear_pointer(&self->summary.tries, g_array_unref);
    g_clear_pointer(&self->summary.islands, g_ptr_array_unref);
    g_clear_pointer(&self->summary.events, g_ptr_array_unref);
    g_clear_pointer(&self->summary.of_scene, g_ptr_array_unref);
    g_clear_pointer(&self->summary.warnings, g_ptr_array_unref);
    gpointer arrays[] = {self->sample_q, self->sample_v, self->part_q, self->part_v, self->values, self->orientation};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

static gboolean call_back(TinkerIslandRuns *self, TinkerIslandRun *run, GError **error)
{
    const TinkerRunOptions *options = &self->options;
    self->work += MAX(run->model->bodies, 1);
    if (self->work < MAX(WORK_BETWEEN_CALLS, (gint64)self->runs->len)) return TRUE;
    self->work = 0;
    if (options->progress != NULL)
        options->progress(tinker_island_runs_time(self), self->times.duration, options->data);
    if (check_cancelled(self, error)) return TRUE;
    tinker_island_run_mark_valid(run);
    return FALSE;
}

/* How the bodies of one island were turned by what they touched, among all. */
static void collect_orientations(TinkerIslandRuns *self, const TinkerIslandRun *run, double t)
{
    gboolean impulses = tinker_method_solves_contact(run->choice.method);
    for (int32_t i = 0; (run->contacts != NULL || impulses) && i < run->model->bodies; i++)
        self->orientation[run->island->body_of[i]] = impulses ? tinker_impulse_orientation(run->stepper, i)
                                                              : tinker_contact_run_orientation(run->contacts, i, t);
}

/* Where the bodies of one island are at t, among all. */
static TinkerStatus collect(TinkerIslandRuns *self, TinkerIslandRun *run, double t)
{
    const TinkerModel *whole = self->model, *part = run->model;
    if (part == whole) return tinker_island_run_state_at(run, t, self->sample_q, self->sample_v);
    TinkerStatus status = tinker_island_run_state_at(run, t, self->part_q, self->part_v);
    for (int32_t i = 0; i < part->bodies; i++) {
        int32_t body = 2 * run->island->body_of[i];
        for (int k = 0; k < 2; k++) {
            self->sample_q[body + k] = self->part_q[2 * i + k] + (part->origin[k] - whole->origin[k]);
            self->sample_v[body + k] = self->part_v[2 * i + k];
        }
    }
    for (int32_t i = 2 * part->bodies; i < part->coordinates; i++) {
        const int32_t at = tinker_model_turn_of(whole, run->island->body_of[tinker_model_moved_by(part, i)]);
        self->sample_q[at] = self->part_q[i];
        self->sample_v[at] = self->part_v[i];
    }
    return status;
}

/* The first row of each block of a model, by its number. (transfer full) */
static int32_t *first_rows(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t *first = g_new0(int32_t, MAX(tinker_block_index_count(model->numbers), 1));
    for (int32_t row = all->rows - 1; row >= 0; row--)
        first[tinker_block_index_find(model->numbers, all->blocks[row])] = row;
    return first;
}

/* The whole model's rows that hold in one direction only are slack as those of the islands; the rows of one block stand
 * together and have one order in all models. */
static void gather_slack(TinkerIslandRuns *self)
{
    if (self->model->constraints.unilateral == NULL) return;
    g_autofree int32_t *first = first_rows(self->model);
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        const TinkerConstraints *part = &run->model->constraints;
        for (int32_t row = 0, begin = 0; part->unilateral != NULL && row < part->rows; row++) {
            if (part->blocks[row] != part->blocks[begin]) begin = row;
            const int32_t number = tinker_block_index_find(self->model->numbers, part->blocks[row]);
            if (part->unilateral[row])
                tinker_constraints_set_slack(self->model, first[number] + row - begin, part->slack[row]);
        }
    }
}

static gint64 count_contact_changes(const TinkerIslandRuns *self)
{
    gint64 changes = 0;
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        if (run->contacts != NULL) changes += tinker_contact_run_changes(run->contacts);
    }
    return changes;
}

/* Where the islands are stepped apart, the whole model's contacts are closed as theirs are. */
static gboolean gather_contacts(TinkerIslandRuns *self, GError **error)
{
    TinkerContacts *all = self->model->contacts;
    if (all == NULL || self->runs->len < 2) return TRUE;
    gint64 changes = count_contact_changes(self);
    if (changes == self->contact_changes) return TRUE;
    self->contact_changes = changes;
    g_array_set_size(all->closed, 0);
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        const TinkerContacts *part = run->model->contacts;
        for (guint k = 0; part != NULL && k < part->closed->len; k++) {
            TinkerContact contact = *tinker_contacts_closed(part, k);
            const int32_t body = run->island->body_of[contact.body];
            contact.plate = tinker_contacts_plate_of_part(all, part, &contact, body);
            contact.body = body;
            g_array_append_val(all->closed, contact);
        }
    }
    gather_slack(self);
    if (tinker_contacts_list_rows(all) == TINKER_OK) return TRUE;
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY, self->model->failure);
    return FALSE;
}

/* What adds up along the island's last step. */
static gboolean follow_paths(TinkerIslandRuns *self, guint number, double t, GError **error)
{
    if (self->along == NULL || tinker_along_run_follow(self->along, number, t) == TINKER_OK) return TRUE;
    TinkerIslandRun *run = g_ptr_array_index(self->runs, number);
    return tinker_island_run_fail(run, run->model->failure, error);
}

gboolean tinker_island_runs_step(TinkerIslandRuns *self, guint number, GError **error)
{
    TinkerIslandRun *run = g_ptr_array_index(self->runs, number);
    if (!follow_paths(self, number, run->state.t, error)) return FALSE;
    return tinker_island_run_step(run, steps_end(self, run->state.t), error) && call_back(self, run, error);
}

static gboolean follow(TinkerIslandRuns *self, guint number, double t, GError **error)
{
    return self->follow == NULL || self->follow(self->follower, number, t, error);
}

gboolean tinker_island_runs_step_towards(TinkerIslandRuns *self, guint number, double t, GError **error)
{
    return follow(self, number, t, error) && tinker_island_runs_step(self, number, error) &&
           follow(self, number, t, error);
}

/* Brings one island's bodies, among all, to where they are at t, which its last step has come to. */
static gboolean place_island(TinkerIslandRuns *self, guint number, double t, gboolean passes, GError **error)
{
    TinkerIslandRun *run = g_ptr_array_index(self->runs, number);
    if (!follow_paths(self, number, t, error)) return FALSE;
    if (passes && t > 0 && run->state.t == t && !tinker_island_run_pass_instant(run, steps_end(self, t), error))
        return FALSE;
    TinkerStatus status = collect(self, run, t);
    if (status != TINKER_OK) return tinker_island_run_fail_at(run, t, run->model->failure, error);
    collect_orientations(self, run, t);
    return TRUE;
}

gboolean tinker_island_runs_place(TinkerIslandRuns *self, double t, double sample, gboolean passes, GError **error)
{
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        while (run->state.t < t)
            if (!tinker_island_runs_step_towards(self, i, sample, error)) return FALSE;
        if (!place_island(self, i, t, passes, error)) return FALSE;
    }
    return gather_contacts(self, error);
}

/* A sample that falls on a break is taken behind it: at the instant of a jump the state after it counts. */
gboolean tinker_island_runs_advance(TinkerIslandRuns *self, double t, GError **error)
{
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        if (run->abandoned) continue;
        if (!follow(self, i, t, error)) return FALSE;
        while (run->state.t < t)
            if (!tinker_island_runs_step(self, i, error) || !follow(self, i, t, error)) return FALSE;
        if (!place_island(self, i, t, TRUE, error)) return FALSE;
    }
    self->sample_time = t;
    return gather_contacts(self, error);
}

gboolean tinker_island_runs_step_behind(TinkerIslandRuns *self, GError **error)
{
    TinkerIslandRun *behind = g_ptr_array_index(self->runs, 0);
    for (guint i = 1; i < self->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        if (run->state.t < behind->state.t) behind = run;
    }
    return tinker_island_run_step(behind, steps_end(self, behind->state.t), error);
}

/* Samples ---------------------------------------------------------------------------------------------------------- */

/* The whole model has its own waveforms where it is not stepped itself: they enter the piece that t begins or lies in.
 */
static void enter_piece_at(TinkerIslandRuns *self, double t)
{
    const TinkerIslandRun *first = g_ptr_array_index(self->runs, 0);
    if (first->model == self->model || t < self->piece_end) return;
    double horizon = MAX(self->times.duration, t + 1.0);
    double next = tinker_model_next_break(self->model, t, horizon);
    self->piece_end = MIN(next, horizon);
    tinker_model_enter_piece(self->model, 0.5 * (t + self->piece_end));
}

/* Likewise the piece that ends at t or holds it. */
static void enter_piece_before(TinkerIslandRuns *self, double t)
{
    if (t != self->piece_end) enter_piece_at(self, t * (1 - TINKER_SAME_INSTANT));
}

static TinkerStatus sample(TinkerIslandRuns *self, double t)
{
    const gint64 evaluations = self->model->evaluations;
    TinkerStatus status = tinker_sampler_values(self->sampler, t, self->sample_q, self->sample_v, self->values);
    if (status == TINKER_OK && self->along != NULL) status = tinker_along_run_values(self->along, t, self->values);
    self->model->evaluations = evaluations;
    return status;
}

TinkerStatus tinker_island_runs_sample(TinkerIslandRuns *self, double t)
{
    enter_piece_at(self, t);
    return sample(self, t);
}

TinkerStatus tinker_island_runs_sample_before(TinkerIslandRuns *self, double t)
{
    enter_piece_before(self, t);
    return sample(self, t);
}

double tinker_island_runs_wound_length(TinkerIslandRuns *self, TinkerBlockId block)
{
    for (guint i = 0; i < self->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        /* a state may cost a projection: of one island alone */
        if (run->model->constraints.unilateral == NULL || tinker_block_index_find(run->model->numbers, block) < 0 ||
            tinker_island_run_state_at(run, self->sample_time, self->part_q, self->part_v) != TINKER_OK)
            continue;
        const double length =
            tinker_constraints_wound_length(run->model, self->sample_time, self->part_q, self->part_v, block);
        if (!isnan(length)) return length;
    }
    return NAN;
}

gboolean tinker_island_runs_close(TinkerIslandRuns *self, GError **error)
{
    for (guint i = 0; i < self->runs->len; i++)
        if (!tinker_island_run_close(g_ptr_array_index(self->runs, i), self->times.duration, error)) return FALSE;
    return TRUE;
}

double tinker_island_runs_time(const TinkerIslandRuns *self)
{
    double t = INFINITY;
    for (guint i = 0; i < self->runs->len; i++)
        t = MIN(t, ((const TinkerIslandRun *)g_ptr_array_index(self->runs, i))->state.t);
    return t;
}

void tinker_island_runs_take_columns(TinkerIslandRuns *self, const GArray *columns)
{
    self->sampler = tinker_sampler_new(self->model, columns);
    self->along = tinker_along_run_new(self->model, self->runs, columns);
    self->columns = columns != NULL ? columns->len : 0;
    self->values = g_new0(double, self->columns + 1);
}
