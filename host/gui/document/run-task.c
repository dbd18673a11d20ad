/* The owner's side of a task, which is freed by whichever of thread and owner lets go last. */
#include <math.h>
#include <string.h>

#include "gui/document/run-task-private.h"
#include "physics/record/columns.h"
#include "units/waveform/times.h"

#define PIECE   ((gsize)64 << 10) /* bytes of the record that are read at once */
#define PORTION ((gsize)2 << 20)  /* and for one call, of which a frame may need a dozen */

void tinker_run_event_free(TinkerRunEvent *event)
{
    g_free(event->text);
    g_free(event);
}

TinkerRunEvent *run_task_event_new(double time, const char *text)
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
    g_array_unref(task->wound);
    g_clear_error(&task->error);
    g_ptr_array_unref(task->warnings);
    g_ptr_array_unref(task->events);
    g_array_unref(task->bands);
    run_task_record_clear(&task->record);
    g_mutex_clear(&task->mutex);
    run_task_record_clear(&task->next);
    g_clear_pointer(&task->until, tinker_until_free);
    g_free(task->row);
    g_free(task->event_row);
    g_free(task);
}

gsize run_task_row_width(const TinkerRunTask *task)
{
    return 1 + RUN_TASK_STATE * (gsize)task->bodies->len + task->wound->len + task->columns->len;
}

gsize run_task_event_width(const TinkerRunTask *task)
{
    return 1 + 2 * (gsize)task->columns->len;
}

void run_task_record_init(const TinkerRunTask *task, RunTaskRecord *record)
{
    record->samples.record = tinker_record_new(run_task_row_width(task), RUN_TASK_IN_MEMORY - RUN_TASK_OF_EVENTS);
    record->events.record = tinker_record_new(run_task_event_width(task), RUN_TASK_OF_EVENTS);
    record->samples.times = g_array_new(FALSE, FALSE, sizeof(double));
    record->events.times = g_array_new(FALSE, FALSE, sizeof(double));
}

void run_task_record_clear(RunTaskRecord *record)
{
    RunTaskRows *all[] = {&record->samples, &record->events};
    for (gsize i = 0; i < G_N_ELEMENTS(all); i++) {
        g_clear_pointer(&all[i]->record, tinker_record_free);
        g_clear_pointer(&all[i]->times, g_array_unref);
    }
}

static void list_blocks(TinkerRunTask *task, const TinkerScene *scene)
{
    task->bodies = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    task->wound = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++) {
        TinkerBlockId block = tinker_scene_block_at(scene, place);
        const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
        if (block_class == NULL || block_class->physics == NULL) continue;
        if (tinker_block_class_is_wound(block_class)) g_array_append_val(task->wound, block);
        if (tinker_block_class_moves(block_class)) g_array_append_val(task->bodies, block);
    }
}

TinkerRunTask *tinker_run_task_new(TinkerRunLane *lane, TinkerScene *scene, double start, const GArray *columns,
                                   gboolean estimate)
{
    TinkerRunTask *task = g_new0(TinkerRunTask, 1);
    g_atomic_ref_count_init(&task->references);
    g_mutex_init(&task->mutex);
    task->scene = scene;
    task->start = start;
    task->estimate = estimate;
    task->status.estimate_due = !estimate;
    task->columns = tinker_columns_new();
    for (guint i = 0; i < columns->len; i++) {
        const TinkerQuantity *quantity = &g_array_index(columns, TinkerQuantity, i);
        tinker_columns_add_quantity(task->columns, scene, quantity->block, quantity->quantity);
    }
    list_blocks(task, scene);
    task->warnings = tinker_warnings_new();
    task->events = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    task->bands = g_array_new(FALSE, FALSE, sizeof(double));
    run_task_record_init(task, &task->record);
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

GPtrArray *tinker_run_task_warnings(TinkerRunTask *task)
{
    GPtrArray *copy = tinker_warnings_new();
    g_mutex_lock(&task->mutex);
    tinker_warnings_add_copies(copy, task->warnings);
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
        if (event->time < until) g_ptr_array_add(to, run_task_event_new(event->time, event->text));
    }
    g_mutex_unlock(&task->mutex);
}

const TinkerBlockId *tinker_run_task_bodies(TinkerRunTask *task, int *count)
{
    *count = (int)task->bodies->len;
    return (const TinkerBlockId *)(gpointer)task->bodies->data;
}

const TinkerBlockId *tinker_run_task_wound(TinkerRunTask *task, int *count)
{
    *count = (int)task->wound->len;
    return (const TinkerBlockId *)(gpointer)task->wound->data;
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
    TinkerRecord *record = task->record.samples.record;
    gboolean there = first + count <= task->status.rows;
    g_mutex_unlock(&task->mutex);
    return there && tinker_record_read(record, first, count, rows, NULL);
}

gboolean tinker_run_task_read(TinkerRunTask *task, gsize row, double *time, TinkerBodySample *bodies, double *lengths)
{
    g_autofree double *numbers = g_new(double, run_task_row_width(task));
    if (!read_rows(task, row, 1, numbers)) return FALSE;
    *time = numbers[0];
    const double *next = numbers + 1;
    for (guint i = 0; i < task->bodies->len; i++, next += RUN_TASK_STATE)
        bodies[i] = (TinkerBodySample){next[0], next[1], next[2], next[3], next[4], next[5]};
    if (lengths != NULL) memcpy(lengths, next, task->wound->len * sizeof(double));
    return TRUE;
}

static gsize count_until(const GArray *times, double time)
{
    return tinker_times_until((const double *)(const void *)times->data, times->len, time);
}

/* A column on one side of an event. FALSE where there is no such event, or none that is not later than `until`. */
static gboolean read_event(TinkerRunTask *task, gsize number, double until, int column, double values[3])
{
    const gsize columns = task->columns->len;
    g_mutex_lock(&task->mutex);
    TinkerRecord *record = task->record.events.record;
    const GArray *times = task->record.events.times;
    const gboolean there = number < times->len && g_array_index(times, double, number) <= until;
    g_mutex_unlock(&task->mutex);
    if (!there) return FALSE;
    g_autofree double *row = g_new(double, run_task_event_width(task));
    if (!tinker_record_read(record, number, 1, row, NULL)) return FALSE;
    values[0] = row[0];
    values[1] = row[1 + column];
    values[2] = row[1 + columns + (gsize)column];
    return TRUE;
}

gboolean tinker_run_task_value(TinkerRunTask *task, gsize row, int column, double time, double *value)
{
    const gsize width = run_task_row_width(task), place = width - task->columns->len + (gsize)column;
    g_autofree double *numbers = g_new(double, 2 * width);
    double event[3];
    if (!read_rows(task, row, 1, numbers)) return FALSE;
    double from = numbers[0], to, next;
    *value = numbers[place];
    if (!(time > from) || !read_rows(task, row + 1, 1, numbers + width)) return TRUE;
    to = numbers[width];
    next = numbers[width + place];
    g_mutex_lock(&task->mutex);
    const gsize passed = count_until(task->record.events.times, time);
    g_mutex_unlock(&task->mutex);
    if (passed > 0 && read_event(task, passed - 1, time, column, event) && event[0] > from) {
        from = event[0];
        *value = event[2];
    }
    if (read_event(task, passed, to, column, event)) {
        to = event[0];
        next = event[1];
    }
    if (to > from) *value += fmin((time - from) / (to - from), 1) * (next - *value);
    return TRUE;
}

gboolean tinker_run_task_band(TinkerRunTask *task, int column, double until, double *band)
{
    const guint width = 1 + task->columns->len;
    gboolean known = FALSE;
    g_mutex_lock(&task->mutex);
    for (guint row = 0; row < task->bands->len && !known; row += width) {
        known = g_array_index(task->bands, double, row) >= MIN(until, task->status.reached);
        *band = g_array_index(task->bands, double, row + 1 + (guint)column);
    }
    g_mutex_unlock(&task->mutex);
    return known && isfinite(*band);
}

gboolean tinker_run_task_find(TinkerRunTask *task, double time, gsize *row)
{
    g_mutex_lock(&task->mutex);
    const gsize count = count_until(task->record.samples.times, time);
    g_mutex_unlock(&task->mutex);
    *row = count - 1;
    return count > 0;
}

/* Both sides of the events from *event on that are not later than `until`. */
static void add_events(TinkerRunTask *task, int column, gsize *event, double until, GArray *times, GArray *values)
{
    double sides[3];
    for (; event != NULL && read_event(task, *event, until, column, sides); ++*event) {
        const double twice[] = {sides[0], sides[0]};
        g_array_append_vals(times, twice, 2);
        g_array_append_vals(values, sides + 1, 2);
    }
}

gboolean tinker_run_task_series(TinkerRunTask *task, int column, gsize *next, gsize *event, double until, GArray *times,
                                GArray *values)
{
    const gsize width = run_task_row_width(task), place = width - task->columns->len + (gsize)column;
    const gsize at_once = MAX(PIECE / (width * sizeof(double)), 1);
    gsize last;
    if (!tinker_run_task_find(task, until, &last)) return TRUE;
    const gsize end = MIN(last + 1, *next + MAX(PORTION / (width * sizeof(double)), 1));
    g_autofree double *rows = g_new(double, at_once *width);
    while (*next < end) {
        const gsize count = MIN(end - *next, at_once);
        if (!read_rows(task, *next, count, rows)) break;
        for (gsize i = 0; i < count; i++) {
            add_events(task, column, event, rows[i * width], times, values);
            g_array_append_val(times, rows[i * width]);
            g_array_append_val(values, rows[i * width + place]);
        }
        *next += count;
    }
    if (end == last + 1 && tinker_run_task_status(task).reached > until)
        add_events(task, column, event, until, times, values);
    return end == last + 1;
}
