/* The thread of a task: runs its scene and records, sample by sample, until it is over or cancelled. */
#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "common/words/event-words.h"
#include "gui/document/run-task-private.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/run/accurate-run.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"
#include "plugin/call/crash.h"

#define LATELY      0.5   /* s: over which the rate is measured */
#define BANDS       32    /* times in a run at which is noted how far it may be off */
#define QUICK_ROWS  1000  /* samples, about, of a run without an estimate: no curve shows more */
#define MOST_EVENTS 10000 /* that are kept: what rattles has more than anybody looks at */

static gboolean is_cancelled(void *data)
{
    return g_atomic_int_get(&((TinkerRunTask *)data)->cancelled);
}

static void fill_row(TinkerRunTask *task, TinkerSimulation *simulation, double time, const double *values)
{
    double *row = task->row;
    *row++ = time;
    for (guint i = 0; i < task->bodies->len; i++, row += RUN_TASK_STATE) {
        TinkerBodySample body = {0};
        tinker_simulation_body(simulation, g_array_index(task->bodies, TinkerBlockId, i), &body);
        const double state[RUN_TASK_STATE] = {body.x, body.y, body.vx, body.vy, body.orientation, body.rate};
        memcpy(row, state, sizeof state);
    }
    for (guint i = 0; i < task->wound->len; i++)
        *row++ = tinker_simulation_wound_length(simulation, g_array_index(task->wound, TinkerBlockId, i));
    if (task->columns->len > 0) memcpy(row, values, task->columns->len * sizeof(double));
}

static void note_summary(TinkerRunTask *task, TinkerSimulation *simulation)
{
    const TinkerSummary *summary = tinker_simulation_summary(simulation);
    TinkerRunStatus *status = &task->status;
    g_mutex_lock(&task->mutex);
    g_strlcpy(status->method, summary->method != NULL ? summary->method : "", sizeof status->method);
    status->adaptive = summary->adaptive;
    status->step = summary->step;
    status->tolerance = summary->tolerance;
    status->energy_balance_error = summary->energy_balance_error;
    status->constraint_error = summary->constraint_position_error;
    status->valid_until = task->start + summary->valid_until;
    g_mutex_unlock(&task->mutex);
}

/* Those of a further try show when its samples do. What came since is added: earlier ones stay as they were told. */
static void note_events(TinkerRunTask *task, const GPtrArray *events)
{
    const guint count = events != NULL ? MIN(events->len, MOST_EVENTS) : 0;
    g_mutex_lock(&task->mutex);
    for (guint i = task->events->len; i < count; i++) {
        const TinkerEvent *event = g_ptr_array_index(events, i);
        g_autofree char *text = tinker_event_text(task->scene, event);
        g_ptr_array_add(task->events, run_task_event_new(task->start + event->time, text));
    }
    g_mutex_unlock(&task->mutex);
}

static void note_rate(TinkerRunTask *task, TinkerSimulation *simulation, double time)
{
    gint64 now = g_get_monotonic_time();
    double elapsed = 1e-6 * (double)(now - task->rate_began);
    if (elapsed < LATELY) return;
    g_mutex_lock(&task->mutex);
    task->status.rate = (time - task->rate_from) / elapsed;
    g_mutex_unlock(&task->mutex);
    task->rate_began = now;
    task->rate_from = time;
    note_summary(task, simulation);
    note_events(task, tinker_simulation_summary(simulation)->events);
}

/* How far the columns may be off until `time`: of an exact run without a companion by no more than rounding. Called
 * with the mutex held. */
static void note_bands(TinkerRunTask *task, const double *bands, double time)
{
    const guint row = task->bands->len;
    g_array_set_size(task->bands, row + 1 + task->columns->len);
    g_array_index(task->bands, double, row) = time;
    for (guint i = 0; i < task->columns->len; i++)
        g_array_index(task->bands, double, row + 1 + i) = bands != NULL ? bands[i] : 0;
}

/* The companion has come to a sample, on its own thread maybe. Bands of a try that is made again are forgotten. */
static void note_found(const TinkerFound *found, void *data)
{
    TinkerRunTask *task = data;
    const double time = task->start + found->t;
    g_mutex_lock(&task->mutex);
    if (found->t > 0) task->status.error_estimate = found->error;
    task->status.predictable_until = task->start + found->predictable_until;
    if (time >= task->next_bands) {
        note_bands(task, found->bands, time);
        task->next_bands = time + tinker_scene_head(task->scene)->run.duration / BANDS;
    }
    g_mutex_unlock(&task->mutex);
}

/* The run is over, and its companion has caught up. */
static void note_estimate(TinkerRunTask *task, TinkerSimulation *simulation, gboolean done)
{
    const TinkerSummary *summary = tinker_simulation_summary(simulation);
    const double *bands = tinker_simulation_bands(simulation);
    g_mutex_lock(&task->mutex);
    task->status.error_estimate = summary->error_estimate;
    task->status.predictable_until = task->start + summary->predictable_until;
    if (done && task->estimate && (bands != NULL || !isnan(summary->error_estimate))) note_bands(task, bands, INFINITY);
    g_mutex_unlock(&task->mutex);
}

static gboolean append_row(RunTaskRows *rows, const double *row, GError **error)
{
    if (!tinker_record_append(rows->record, row, error)) return FALSE;
    g_array_append_val(rows->times, row[0]);
    return TRUE;
}

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    TinkerRunTask *task = data;
    time += task->start;
    fill_row(task, simulation, time, values);
    if (task->next.samples.record != NULL)
        return append_row(&task->next.samples, task->row, error) && !is_cancelled(task);
    if (!tinker_record_append(task->record.samples.record, task->row, error)) return FALSE;
    g_mutex_lock(&task->mutex);
    g_array_append_val(task->record.samples.times, time);
    task->status.reached = time;
    task->status.rows = task->record.samples.times->len;
    g_mutex_unlock(&task->mutex);
    note_rate(task, simulation, time);
    return !is_cancelled(task);
}

/* The columns on both sides of an event, which comes before the next sample. */
static gboolean take_event(G_GNUC_UNUSED TinkerSimulation *simulation, double time, const double *before,
                           const double *behind, void *data, GError **error)
{
    TinkerRunTask *task = data;
    const gsize columns = task->columns->len;
    task->event_row[0] = task->start + time;
    memcpy(task->event_row + 1, before, columns * sizeof(double));
    memcpy(task->event_row + 1 + columns, behind, columns * sizeof(double));
    if (task->next.events.record != NULL) return append_row(&task->next.events, task->event_row, error);
    if (!tinker_record_append(task->record.events.record, task->event_row, error)) return FALSE;
    g_mutex_lock(&task->mutex);
    g_array_append_val(task->record.events.times, task->event_row[0]);
    g_mutex_unlock(&task->mutex);
    return TRUE;
}

static void begin_again(void *data)
{
    TinkerRunTask *task = data;
    run_task_record_clear(&task->next);
    run_task_record_init(task, &task->next);
    g_mutex_lock(&task->mutex);
    task->next_bands = task->start;
    g_array_set_size(task->bands, 0);
    g_mutex_unlock(&task->mutex);
}

/* The samples of the last try take the place of the first one's, which whoever reads them just now may go on reading.
 * Called with the mutex held. */
static void show_next(TinkerRunTask *task)
{
    if (task->next.samples.record == NULL || task->next.samples.times->len == 0 || is_cancelled(task)) return;
    const RunTaskRecord last = task->record;
    task->record = task->next;
    task->next = last;
    const GArray *times = task->record.samples.times;
    task->status.rows = times->len;
    task->status.reached = g_array_index(times, double, times->len - 1);
    task->status.replaced++;
    g_ptr_array_set_size(task->events, 0);
}

/* A run that misses the accuracy asked for is whole: that is a warning. */
static void note_miss(TinkerRunTask *task, GError **failure)
{
    if (!g_error_matches(*failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY)) return;
    tinker_warnings_add(task->warnings, TINKER_WARNING_METHOD, g_strdup((*failure)->message));
    g_clear_error(failure);
}

/* While the end is looked for; who is told of it would not want to be of a moment. */
static void note_look(double t, G_GNUC_UNUSED double duration, void *data)
{
    TinkerRunTask *task = data;
    if (1e-6 * (double)(g_get_monotonic_time() - task->rate_began) < LATELY) return;
    g_mutex_lock(&task->mutex);
    task->status.looks = TRUE;
    task->status.looked = task->start + t;
    g_mutex_unlock(&task->mutex);
}

/* Where the scene has conditions that end it: ends it where the first of them holds. FALSE where that cannot be said,
 * and the run is not to begin. */
static gboolean end_at_condition(TinkerRunTask *task, TinkerModel *model, TinkerRunOptions *options, GError **error)
{
    task->until = tinker_until_new(task->scene, task->start);
    if (!tinker_until_add_all(task->until, tinker_scene_head(task->scene)->run.until, error)) {
        g_prefix_error(error, _("The condition that stops the run: "));
        return FALSE;
    }
    options->progress = note_look;
    const gboolean found = tinker_until_end(task->until, model, options->interval, options, &task->stopped_by, error);
    options->progress = NULL;
    task->rate_began = g_get_monotonic_time();
    g_mutex_lock(&task->mutex);
    task->status.looks = FALSE;
    g_mutex_unlock(&task->mutex);
    return found;
}

/* What the conditions did to a run that came to its end is the last of its events. */
static void note_end(TinkerRunTask *task)
{
    if (tinker_until_count(task->until) == 0) return;
    const char *all = tinker_scene_head(task->scene)->run.until;
    g_autofree char *text =
        task->stopped_by >= 0 ? g_strdup_printf(_("Stopped where %s"), tinker_until_text(task->until, task->stopped_by))
                              : g_strdup_printf(_("Nothing stopped it: %s did not come true"), all);
    g_mutex_lock(&task->mutex);
    g_ptr_array_add(task->events, run_task_event_new(task->status.reached, text));
    g_mutex_unlock(&task->mutex);
}

/* A run that another one is to follow has samples as far apart as curves need: at some of the times that the other one
 * has them at. Not what goes on from a change on the way, of which a next change goes on from a sample. */
static void choose_interval(const TinkerRunTask *task, TinkerRunOptions *options)
{
    const double rows = options->duration / options->interval;
    if (!task->estimate && task->start == 0 && rows > QUICK_ROWS) options->interval *= ceil(rows / QUICK_ROWS);
}

static gboolean run_scene(TinkerRunTask *task, GError **error)
{
    g_autoptr(TinkerModel) model = is_cancelled(task) ? NULL : tinker_model_new(task->scene, error);
    if (model == NULL || is_cancelled(task)) return FALSE;
    TinkerRunOptions options = tinker_run_options_of(task->scene);
    options.cancelled = is_cancelled;
    options.data = task;
    options.estimate = options.bands = task->estimate;
    options.found = note_found;
    choose_interval(task, &options);
    if (!end_at_condition(task, model, &options, error)) return FALSE;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    const TinkerSampleTaker taker = {take_sample, begin_again, take_event, task};
    GError *failure = NULL;
    gboolean done = tinker_accurate_run(&simulation, task->columns, &taker, &failure);
    note_summary(task, simulation);
    note_estimate(task, simulation, done);
    g_mutex_lock(&task->mutex);
    show_next(task);
    note_miss(task, &failure);
    tinker_warnings_add_copies(task->warnings, tinker_simulation_summary(simulation)->warnings);
    g_mutex_unlock(&task->mutex);
    note_events(task, tinker_simulation_summary(simulation)->events);
    if (done) note_end(task);
    if (failure != NULL) g_propagate_error(error, failure);
    return done;
}

static void cut_rows(RunTaskRows *rows, double until, gsize least)
{
    gsize count = rows->times->len;
    while (count > least && g_array_index(rows->times, double, count - 1) > until)
        count--;
    if (count == rows->times->len) return;
    g_array_set_size(rows->times, (guint)count);
    tinker_record_cut(rows->record, count);
}

/* What a failed run is not to be believed in is forgotten. Called with the mutex held. */
static void forget_invalid(TinkerRunTask *task)
{
    const double until = task->status.valid_until;
    GArray *times = task->record.samples.times;
    for (guint i = task->events->len; i-- > 0;)
        if (((TinkerRunEvent *)g_ptr_array_index(task->events, i))->time > until)
            g_ptr_array_remove_index(task->events, i);
    cut_rows(&task->record.samples, until, 1);
    cut_rows(&task->record.events, until, 0);
    if (times->len == task->status.rows) return;
    task->status.rows = times->len;
    task->status.reached = g_array_index(times, double, times->len - 1);
}

/* There is nothing more to come: the thread, or who would have had one, lets go. */
static void finish(TinkerRunTask *task, GError *error)
{
    g_mutex_lock(&task->mutex);
    task->error = error;
    if (error != NULL) forget_invalid(task);
    task->status.finished = TRUE;
    g_mutex_unlock(&task->mutex);
    tinker_run_task_unref(task);
}

static void work(void *item)
{
    TinkerRunTask *task = item;
    tinker_crash_watch_thread();
    GError *error = NULL;
    task->row = g_new0(double, run_task_row_width(task));
    task->event_row = g_new0(double, run_task_event_width(task));
    task->rate_began = g_get_monotonic_time();
    task->rate_from = task->next_bands = task->start;
    if (!run_scene(task, &error) && is_cancelled(task)) g_clear_error(&error);
    finish(task, error);
}

static void drop(void *item)
{
    finish(item, NULL);
}

TinkerRunLane *tinker_run_task_lane(void)
{
    return tinker_run_lane_new(work, drop);
}
