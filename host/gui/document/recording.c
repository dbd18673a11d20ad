/* Frames are placed straight between two samples of one segment. */
#include "gui/document/recording.h"

#include <math.h>

#define MOST_VISITS 5000 /* samples that are handed out at once */

static void stop_and_unref(TinkerRunTask *task)
{
    tinker_run_task_stop(task);
    tinker_run_task_unref(task);
}

static void clear_segment(gpointer segment)
{
    tinker_run_task_unref(((TinkerSegment *)segment)->task);
    g_clear_pointer(&((TinkerSegment *)segment)->checks, stop_and_unref);
    tinker_scene_free(((TinkerSegment *)segment)->scene);
}

void tinker_recording_init(TinkerRecording *recording)
{
    recording->segments = g_array_new(FALSE, FALSE, sizeof(TinkerSegment));
    g_array_set_clear_func(recording->segments, clear_segment);
}

void tinker_recording_clear(TinkerRecording *recording)
{
    g_clear_pointer(&recording->segments, g_array_unref);
}

static TinkerSegment *segment_of(const TinkerRecording *recording, guint number)
{
    return &g_array_index(recording->segments, TinkerSegment, number);
}

void tinker_recording_forget(TinkerRecording *recording)
{
    for (guint i = 0; i < recording->segments->len; i++)
        tinker_run_task_stop(segment_of(recording, i)->task);
    g_array_set_size(recording->segments, 0);
    recording->generation++;
}

void tinker_recording_add(TinkerRecording *recording, TinkerRunTask *task, double start)
{
    const TinkerSegment segment = {.task = task, .start = start};
    g_array_append_val(recording->segments, segment);
}

void tinker_recording_share(TinkerRecording *recording, const TinkerRecording *other)
{
    for (guint i = 0; i < other->segments->len; i++) {
        TinkerSegment segment = *segment_of(other, i);
        tinker_run_task_ref(segment.task);
        segment.checks = NULL;
        segment.scene = NULL; // what is kept is looked at, and not run again
        g_array_append_val(recording->segments, segment);
    }
    recording->generation++;
}

TinkerSegment *tinker_recording_last(const TinkerRecording *recording)
{
    return recording->segments->len == 0 ? NULL : segment_of(recording, recording->segments->len - 1);
}

TinkerSegment *tinker_recording_at(const TinkerRecording *recording, double time)
{
    for (guint i = recording->segments->len; i-- > 0;) {
        TinkerSegment *segment = segment_of(recording, i);
        gsize row;
        if (i == 0 || (segment->start <= time && tinker_run_task_find(segment->task, time, &row))) return segment;
    }
    return NULL;
}

gboolean tinker_recording_awaits(const TinkerRecording *recording, double time)
{
    const TinkerSegment *last = tinker_recording_last(recording);
    if (last == NULL || !(last->start < time)) return FALSE;
    const TinkerRunStatus status = tinker_run_task_status(last->task);
    return !status.finished && (status.rows == 0 || status.reached < time);
}

double tinker_recording_end(const TinkerRecording *recording, guint number)
{
    return number + 1 < recording->segments->len ? segment_of(recording, number + 1)->start : INFINITY;
}

guint tinker_recording_generation(TinkerRecording *recording)
{
    for (guint i = 0; i < recording->segments->len; i++) {
        TinkerSegment *segment = segment_of(recording, i);
        const guint replaced = tinker_run_task_status(segment->task).replaced;
        if (replaced != segment->replaced) recording->generation++;
        segment->replaced = replaced;
    }
    return recording->generation;
}

/* Frames ----------------------------------------------------------------------------------------------------------- */

/* How far it turned from one sample to the next: of all whole turns more or less, what its rates make of the time. */
static double turn_between(const TinkerBodySample *a, const TinkerBodySample *b, double time)
{
    const double turn = b->orientation - a->orientation, by_rate = 0.5 * (a->rate + b->rate) * time;
    return isfinite(by_rate) ? turn + 2 * G_PI * round((by_rate - turn) / (2 * G_PI)) : turn;
}

static void place_body(TinkerFrame *frame, TinkerBlockId block, const TinkerBodySample *a, const TinkerBodySample *b,
                       double share, double time)
{
    double orientation = a->orientation;
    if (share > 0 && isfinite(b->orientation)) orientation += share * turn_between(a, b, time);
    if (isnan(orientation)) orientation = tinker_frame_meaning(frame, block, TINKER_MEANING_ORIENTATION, 0, 0);
    tinker_frame_place(frame, block, a->x + share * (b->x - a->x), a->y + share * (b->y - a->y), orientation);
}

/* A row between two samples, or one of them. */
static gboolean place_between(TinkerFrame *frame, TinkerRunTask *task, gsize row, const double *time)
{
    int count, wound_count;
    const TinkerBlockId *bodies = tinker_run_task_bodies(task, &count);
    const TinkerBlockId *wound = tinker_run_task_wound(task, &wound_count);
    g_autofree TinkerBodySample *samples = g_new(TinkerBodySample, 2 * (gsize)count + 1);
    g_autofree double *lengths = g_new(double, 2 * (gsize)wound_count + 1);
    TinkerBodySample *a = samples, *b = samples + count;
    double before, after = 0, share = 0;
    if (!tinker_run_task_read(task, row, &before, a, lengths)) return FALSE;
    if (time == NULL && !tinker_frame_set_time(frame, before, NULL)) return FALSE;
    const gboolean between = time != NULL && *time > before &&
                             tinker_run_task_read(task, row + 1, &after, b, lengths + wound_count) && after > before;
    if (between) share = fmin((*time - before) / (after - before), 1);
    TinkerScene *scene = tinker_frame_scene(frame);
    for (int i = 0; i < count; i++)
        if (tinker_scene_has_block(scene, bodies[i]))
            place_body(frame, bodies[i], &a[i], between ? &b[i] : &a[i], share, after - before);
    for (int i = 0; i < wound_count; i++) {
        const double change = between ? share * (lengths[wound_count + i] - lengths[i]) : 0;
        tinker_frame_set_length(frame, wound[i], lengths[i] + change);
    }
    return TRUE;
}

gboolean tinker_recording_place_sample(TinkerFrame *frame, TinkerRunTask *task, gsize row)
{
    return place_between(frame, task, row, NULL);
}

gboolean tinker_recording_place(const TinkerRecording *recording, TinkerFrame *frame, double time)
{
    const TinkerSegment *segment = tinker_recording_at(recording, time);
    gsize row;
    if (!tinker_frame_set_time(frame, time, NULL)) return FALSE;
    if (segment != NULL && !tinker_recording_awaits(recording, time) && tinker_run_task_find(segment->task, time, &row))
        place_between(frame, segment->task, row, &time);
    return TRUE;
}

/* Curves ----------------------------------------------------------------------------------------------------------- */

gboolean tinker_recording_series(const TinkerRecording *recording, TinkerQuantity quantity, TinkerSeriesCursor *cursor,
                                 GArray *times, GArray *values)
{
    for (; cursor->segment < recording->segments->len; cursor->segment++, cursor->row = cursor->event = 0) {
        TinkerRunTask *task = segment_of(recording, cursor->segment)->task;
        const int column = tinker_run_task_column(task, quantity);
        cursor->behind = FALSE;
        if (column < 0) return FALSE;
        const double end = tinker_recording_end(recording, cursor->segment);
        gsize *event = cursor->at_events ? &cursor->event : NULL;
        cursor->behind = !tinker_run_task_series(task, column, &cursor->row, event, nextafter(end, 0), times, values);
        if (isinf(end) || cursor->behind) break;
    }
    return TRUE;
}

/* What one run ends with is what the next begins with: errors are handed on. */
gboolean tinker_recording_band(const TinkerRecording *recording, TinkerQuantity quantity, double until, double *band)
{
    *band = 0;
    for (guint i = 0; i < recording->segments->len && (i == 0 || segment_of(recording, i)->start <= until); i++) {
        TinkerRunTask *task = segment_of(recording, i)->task;
        const int column = tinker_run_task_column(task, quantity);
        double own;
        if (column < 0 || !tinker_run_task_band(task, column, fmin(until, tinker_recording_end(recording, i)), &own))
            return FALSE;
        *band += own;
    }
    return recording->segments->len > 0;
}

/* Bodies ----------------------------------------------------------------------------------------------------------- */

static gboolean visit_row(TinkerRunTask *task, gsize row, TinkerBodiesFunc visit, void *data)
{
    int count;
    const TinkerBlockId *bodies = tinker_run_task_bodies(task, &count);
    g_autofree TinkerBodySample *samples = g_new(TinkerBodySample, (gsize)count + 1);
    double time;
    if (!tinker_run_task_read(task, row, &time, samples, NULL)) return FALSE;
    visit(time, bodies, samples, count, data);
    return TRUE;
}

void tinker_recording_visit(const TinkerRecording *recording, TinkerSeriesCursor *cursor, TinkerBodiesFunc visit,
                            void *data)
{
    gsize left = MOST_VISITS;
    for (; cursor->segment < recording->segments->len; cursor->segment++, cursor->row = 0) {
        TinkerRunTask *task = segment_of(recording, cursor->segment)->task;
        const double end = tinker_recording_end(recording, cursor->segment);
        gsize last;
        const gboolean any = tinker_run_task_find(task, nextafter(end, 0), &last);
        while (any && left > 0 && cursor->row <= last && visit_row(task, cursor->row, visit, data)) {
            cursor->row++;
            left--;
        }
        cursor->behind = any && cursor->row <= last;
        if (isinf(end) || cursor->behind) break;
    }
}

gboolean tinker_recording_visit_at(const TinkerRecording *recording, double time, TinkerBodiesFunc visit, void *data)
{
    const TinkerSegment *segment = tinker_recording_at(recording, time);
    gsize row;
    return segment != NULL && tinker_run_task_find(segment->task, time, &row) &&
           visit_row(segment->task, row, visit, data);
}
