/* The task is shared by the thread and its owner, and freed by whichever lets go last. The record guards itself; the
 * mutex is held only to note or to ask how far the run is, so that nobody waits for the other's work. */
#include "gui/document/run-task.h"

#include <math.h>
#include <string.h>

#include "event-words.h"
#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "physics/plan/run-options.h"
#include "physics/record/columns.h"
#include "physics/record/record.h"
#include "physics/run/accurate-run.h"
#include "physics/run/simulation.h"
#include "physics/system/summary.h"
#include "plugin/call/crash.h"

#define STATE            5                  /* doubles of a body in a row: x, y, vx, vy, orientation */
#define LATELY           0.5                /* s: over which the rate is measured */
#define RECORD_IN_MEMORY ((gsize)256 << 20) /* bytes; beyond, a temporary file */
#define PIECE            ((gsize)64 << 10)  /* bytes of the record that are read at once */
#define MOST_EVENTS      10000              /* that are kept: what rattles has more than anybody looks at */
#define PORTION          ((gsize)2 << 20)   /* and for one call, of which a frame may need a dozen */

struct _TinkerRunTask {
    gatomicrefcount references;
    TinkerScene *scene;
    double start;
    GArray *columns; /* of TinkerColumn */
    GArray *bodies;  /* of TinkerBlockId */
    gint cancelled;  /* atomic */

    GMutex mutex;         /* of what follows */
    TinkerRecord *record; /* which guards itself: the pointer alone is meant */
    GArray *times;        /* of double, one a row that may be read */
    TinkerRunStatus status;
    GError *error;
    GPtrArray *warnings, *of_scene;
    GPtrArray *events; /* of TinkerRunEvent *, in order */

    /* The thread's own. */
    double *row;
    TinkerRecord *next_record; /* of a further try, until it is over; NULL in the first */
    GArray *next_times;
    gint64 rate_began; /* us */
    double rate_from;  /* s */
};

void tinker_run_event_free(TinkerRunEvent *event)
{
    g_free(event->text);
    g_free(event);
}

static TinkerRunEvent *event_new(double time, const char *text)
{
    TinkerRunEvent *event = g_new(TinkerRunEvent, 1);
    *event = (TinkerRunEvent){time, g_strdup(text)};
    return event;
}

TinkerRunTask *tinker_run_task_ref(TinkerRunTask *task)
{
    g_atomic_ref_count_inc(&task->references);
    return task;
}

void tinker_run_task_unref(TinkerRunTask *task)
{
    if (!g_atomic_ref_count_dec(&task->references)) return;
    tinker_scene_free(task->scene);
    g_array_unref(task->columns);
    g_array_unref(task->bodies);
    g_array_unref(task->times);
    g_clear_error(&task->error);
    g_ptr_array_unref(task->warnings);
    g_ptr_array_unref(task->of_scene);
    g_ptr_array_unref(task->events);
    tinker_record_free(task->record);
    g_mutex_clear(&task->mutex);
    g_clear_pointer(&task->next_record, tinker_record_free);
    g_clear_pointer(&task->next_times, g_array_unref);
    g_free(task->row);
    g_free(task);
}

static gsize row_width(const TinkerRunTask *task)
{
    return 1 + STATE * (gsize)task->bodies->len + task->columns->len;
}

/* The thread ----------------------------------------------------------------------------------------------------------
 */

static gboolean is_cancelled(void *data)
{
    return g_atomic_int_get(&((TinkerRunTask *)data)->cancelled);
}

static void fill_row(TinkerRunTask *task, TinkerSimulation *simulation, double time, const double *values)
{
    double *row = task->row;
    *row++ = time;
    for (guint i = 0; i < task->bodies->len; i++, row += STATE) {
        TinkerBodySample body = {0};
        tinker_simulation_body(simulation, g_array_index(task->bodies, TinkerBlockId, i), &body);
        memcpy(row, (double[]){body.x, body.y, body.vx, body.vy, body.orientation}, STATE * sizeof(double));
    }
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
    status->error_estimate = summary->error_estimate;
    status->energy_balance_error = summary->energy_balance_error;
    status->constraint_error = summary->constraint_position_error;
    status->predictable_until = task->start + summary->predictable_until;
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
        g_ptr_array_add(task->events, event_new(task->start + event->time, text));
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

static gboolean take_next(TinkerRunTask *task, double time, GError **error)
{
    if (!tinker_record_append(task->next_record, task->row, error)) return FALSE;
    g_array_append_val(task->next_times, time);
    return !is_cancelled(task);
}

static gboolean take_sample(TinkerSimulation *simulation, double time, const double *values, void *data, GError **error)
{
    TinkerRunTask *task = data;
    time += task->start;
    fill_row(task, simulation, time, values);
    if (task->next_record != NULL) return take_next(task, time, error);
    if (!tinker_record_append(task->record, task->row, error)) return FALSE;
    g_mutex_lock(&task->mutex);
    g_array_append_val(task->times, time);
    task->status.reached = time;
    task->status.rows = task->times->len;
    g_mutex_unlock(&task->mutex);
    note_rate(task, simulation, time);
    return !is_cancelled(task);
}

static void begin_again(void *data)
{
    TinkerRunTask *task = data;
    g_clear_pointer(&task->next_record, tinker_record_free);
    g_clear_pointer(&task->next_times, g_array_unref);
    task->next_record = tinker_record_new(row_width(task), RECORD_IN_MEMORY);
    task->next_times = g_array_new(FALSE, FALSE, sizeof(double));
}

/* The samples of the last try take the place of the first one's, which whoever reads them just now may go on reading.
 * Called with the mutex held. */
static void show_next(TinkerRunTask *task)
{
    if (task->next_record == NULL || task->next_times->len == 0 || is_cancelled(task)) return;
    TinkerRecord *record = task->record;
    GArray *times = task->times;
    task->record = task->next_record;
    task->times = task->next_times;
    task->next_record = record;
    task->next_times = times;
    task->status.rows = task->times->len;
    task->status.reached = g_array_index(task->times, double, task->times->len - 1);
    task->status.replaced++;
    g_ptr_array_set_size(task->events, 0);
}

static void add_copies(GPtrArray *to, const GPtrArray *from)
{
    for (guint i = 0; i < from->len; i++)
        g_ptr_array_add(to, g_strdup(g_ptr_array_index(from, i)));
}

/* A run that misses the accuracy asked for is whole: that is a warning. */
static void note_miss(TinkerRunTask *task, GError **failure)
{
    if (!g_error_matches(*failure, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_ACCURACY)) return;
    g_ptr_array_add(task->warnings, g_strdup((*failure)->message));
    g_clear_error(failure);
}

static gboolean run_scene(TinkerRunTask *task, GError **error)
{
    g_autoptr(TinkerModel) model = is_cancelled(task) ? NULL : tinker_model_new(task->scene, error);
    if (model == NULL || is_cancelled(task)) return FALSE;
    TinkerRunOptions options = tinker_run_options_of(task->scene);
    options.cancelled = is_cancelled;
    options.data = task;
    g_autoptr(TinkerSimulation) simulation = tinker_simulation_new(model, &options, error);
    if (simulation == NULL) return FALSE;
    const TinkerSampleTaker taker = {take_sample, begin_again, task};
    GError *failure = NULL;
    gboolean done = tinker_accurate_run(&simulation, task->columns, &taker, &failure);
    note_summary(task, simulation);
    g_mutex_lock(&task->mutex);
    show_next(task);
    note_miss(task, &failure);
    add_copies(task->warnings, tinker_simulation_summary(simulation)->warnings);
    add_copies(task->of_scene, tinker_simulation_summary(simulation)->of_scene);
    g_mutex_unlock(&task->mutex);
    note_events(task, tinker_simulation_summary(simulation)->events);
    if (failure != NULL) g_propagate_error(error, failure);
    return done;
}

/* What a failed run is not to be believed in is forgotten. Called with the mutex held. */
static void forget_invalid(TinkerRunTask *task)
{
    gsize rows = task->times->len;
    while (rows > 1 && g_array_index(task->times, double, rows - 1) > task->status.valid_until)
        rows--;
    for (guint i = task->events->len; i-- > 0;)
        if (((TinkerRunEvent *)g_ptr_array_index(task->events, i))->time > task->status.valid_until)
            g_ptr_array_remove_index(task->events, i);
    if (rows == task->times->len) return;
    g_array_set_size(task->times, (guint)rows);
    tinker_record_cut(task->record, rows);
    task->status.rows = rows;
    task->status.reached = g_array_index(task->times, double, rows - 1);
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
    task->row = g_new0(double, row_width(task));
    task->rate_began = g_get_monotonic_time();
    task->rate_from = task->start;
    if (!run_scene(task, &error) && is_cancelled(task)) g_clear_error(&error);
    finish(task, error);
}

static void drop(void *item)
{
    finish(item, NULL);
}

/* The owner -----------------------------------------------------------------------------------------------------------
 */

static GArray *movable_bodies(const TinkerScene *scene)
{
    GArray *bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block_class == NULL || block_class->physics == NULL || block_class->physics->body == NULL) continue;
        if (block_class->physics->body->degrees_of_freedom > 0) g_array_append_val(bodies, block);
    }
    return bodies;
}

TinkerRunLane *tinker_run_task_lane(void)
{
    return tinker_run_lane_new(work, drop);
}

TinkerRunTask *tinker_run_task_new(TinkerRunLane *lane, TinkerScene *scene, double start, const GArray *columns)
{
    TinkerRunTask *task = g_new0(TinkerRunTask, 1);
    g_atomic_ref_count_init(&task->references);
    g_mutex_init(&task->mutex);
    task->scene = scene;
    task->start = start;
    task->columns = tinker_columns_new();
    for (guint i = 0; i < columns->len; i++) {
        const TinkerQuantity *quantity = &g_array_index(columns, TinkerQuantity, i);
        tinker_columns_add_quantity(task->columns, scene, quantity->block, quantity->quantity);
    }
    task->bodies = movable_bodies(scene);
    task->times = g_array_new(FALSE, FALSE, sizeof(double));
    task->warnings = g_ptr_array_new_with_free_func(g_free);
    task->of_scene = g_ptr_array_new_with_free_func(g_free);
    task->events = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    task->record = tinker_record_new(row_width(task), RECORD_IN_MEMORY);
    task->status.reached = start;
    task->status.error_estimate = NAN;
    task->status.predictable_until = task->status.valid_until = INFINITY;
    g_atomic_ref_count_inc(&task->references);
    tinker_run_lane_add(lane, task);
    return task;
}

void tinker_run_task_stop(TinkerRunTask *task)
{
    g_atomic_int_set(&task->cancelled, TRUE);
}

void tinker_run_task_free(TinkerRunTask *task)
{
    if (task == NULL) return;
    tinker_run_task_stop(task);
    tinker_run_task_unref(task);
}

TinkerRunStatus tinker_run_task_status(TinkerRunTask *task)
{
    g_mutex_lock(&task->mutex);
    TinkerRunStatus status = task->status;
    g_mutex_unlock(&task->mutex);
    return status;
}

GError *tinker_run_task_error(TinkerRunTask *task)
{
    g_mutex_lock(&task->mutex);
    GError *error = task->error != NULL ? g_error_copy(task->error) : NULL;
    g_mutex_unlock(&task->mutex);
    return error;
}

GPtrArray *tinker_run_task_warnings(TinkerRunTask *task, gboolean of_scene)
{
    GPtrArray *copy = g_ptr_array_new_with_free_func(g_free);
    g_mutex_lock(&task->mutex);
    add_copies(copy, of_scene ? task->of_scene : task->warnings);
    g_mutex_unlock(&task->mutex);
    return copy;
}

guint tinker_run_task_event_count(TinkerRunTask *task)
{
    g_mutex_lock(&task->mutex);
    guint count = task->events->len;
    g_mutex_unlock(&task->mutex);
    return count;
}

void tinker_run_task_add_events(TinkerRunTask *task, double until, GPtrArray *to)
{
    g_mutex_lock(&task->mutex);
    for (guint i = 0; i < task->events->len; i++) {
        const TinkerRunEvent *event = g_ptr_array_index(task->events, i);
        if (event->time < until) g_ptr_array_add(to, event_new(event->time, event->text));
    }
    g_mutex_unlock(&task->mutex);
}

const TinkerBlockId *tinker_run_task_bodies(TinkerRunTask *task, int *count)
{
    *count = (int)task->bodies->len;
    return (const TinkerBlockId *)(gpointer)task->bodies->data;
}

int tinker_run_task_column(TinkerRunTask *task, TinkerQuantity quantity)
{
    for (guint i = 0; i < task->columns->len; i++) {
        const TinkerColumn *column = &g_array_index(task->columns, TinkerColumn, i);
        if (column->block == quantity.block && column->quantity == quantity.quantity) return (int)i;
    }
    return -1;
}

static gboolean read_rows(TinkerRunTask *task, gsize first, gsize count, double *rows)
{
    g_mutex_lock(&task->mutex);
    TinkerRecord *record = task->record;
    gboolean there = first + count <= task->status.rows;
    g_mutex_unlock(&task->mutex);
    return there && tinker_record_read(record, first, count, rows, NULL);
}

gboolean tinker_run_task_read(TinkerRunTask *task, gsize row, double *time, TinkerBodySample *bodies, double *values)
{
    g_autofree double *numbers = g_new(double, row_width(task));
    if (!read_rows(task, row, 1, numbers)) return FALSE;
    *time = numbers[0];
    const double *next = numbers + 1;
    for (guint i = 0; i < task->bodies->len; i++, next += STATE)
        bodies[i] = (TinkerBodySample){next[0], next[1], next[2], next[3], next[4]};
    if (values != NULL && task->columns->len > 0) memcpy(values, next, task->columns->len * sizeof(double));
    return TRUE;
}

gboolean tinker_run_task_value(TinkerRunTask *task, gsize row, int column, double *value)
{
    gsize width = row_width(task);
    g_autofree double *numbers = g_new(double, width);
    if (!read_rows(task, row, 1, numbers)) return FALSE;
    *value = numbers[width - task->columns->len + (gsize)column];
    return TRUE;
}

gboolean tinker_run_task_find(TinkerRunTask *task, double time, gsize *row)
{
    g_mutex_lock(&task->mutex);
    gsize low = 0, high = task->times->len;
    while (low < high) {
        gsize middle = low + (high - low) / 2;
        if (g_array_index(task->times, double, middle) <= time)
            low = middle + 1;
        else
            high = middle;
    }
    g_mutex_unlock(&task->mutex);
    *row = low - 1;
    return low > 0;
}

gboolean tinker_run_task_series(TinkerRunTask *task, int column, gsize *next, double until, GArray *times,
                                GArray *values)
{
    const gsize width = row_width(task), place = width - task->columns->len + (gsize)column;
    const gsize at_once = MAX(PIECE / (width * sizeof(double)), 1);
    gsize last;
    if (!tinker_run_task_find(task, until, &last)) return TRUE;
    const gsize end = MIN(last + 1, *next + MAX(PORTION / (width * sizeof(double)), 1));
    g_autofree double *rows = g_new(double, at_once *width);
    while (*next < end) {
        const gsize count = MIN(end - *next, at_once);
        if (!read_rows(task, *next, count, rows)) break;
        for (gsize i = 0; i < count; i++) {
            g_array_append_val(times, rows[i * width]);
            g_array_append_val(values, rows[i * width + place]);
        }
        *next += count;
    }
    return end == last + 1;
}
