/* All islands of a scene are brought from sample to sample, each in steps of its own. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/island/island-run.h"
#include "physics/model/model-data.h"
#include "physics/plan/plan.h"
#include "physics/plan/run-options.h"
#include "physics/run/island-runs.h"
#include "physics/run/island-samples.h"
#include "physics/run/island-steps.h"
#include "physics/run/sample-watch.h"
#include "physics/system/summary.h"

/* Between two looks at whether the user has had enough: steps, each counted once for every body that it moves, so that
 * few looks fall into many short steps and many into few long ones; and no fewer than there are islands, which such a
 * look goes through. */
#define WORK_BETWEEN_CALLS 256

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
                                                     &self->summary, self->options.jolts, error);
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
    if (options->jolts != NULL) g_array_set_size(options->jolts, 0);
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
    tinker_island_runs_open_summary(self);
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
    tinker_island_runs_clear_summary(self);
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
    const double from = run->state.t;
    if (!follow_paths(self, number, from, error)) return FALSE;
    if (!tinker_island_run_step(run, steps_end(self, from), error)) return FALSE;
    if (self->samples != NULL) tinker_sample_watch_step(self->samples, number, from);
    return call_back(self, run, error);
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
    TinkerStatus status = tinker_island_runs_collect(self, run, t);
    if (status != TINKER_OK) return tinker_island_run_fail_at(run, t, run->model->failure, error);
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
    return tinker_island_runs_gather_contacts(self, error);
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
    return tinker_island_runs_gather_contacts(self, error);
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
