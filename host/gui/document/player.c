/* Play-back of what was recorded, whose last segment may still grow. */
#include "gui/document/player.h"

#include <glib/gi18n.h>
#include <math.h>

#include "gui/document/recorded-quantities.h"
#include "scene/frame/tops.h"
#include "scene/history/continued.h"
#include "scene/history/difference.h"

#define PACE_MEMORY 0.5 /* s: over which the pace is averaged */

struct _TinkerPlayer {
    GObject parent_instance;
    TinkerDocument *document;
    TinkerPlayerState state;
    double time, speed, pace;
    gboolean trial; /* edits are those of a hand that tries */
    double step_to; /* s: as soon as this is recorded it is shown, and time stands still; NAN while it plays freely */
    TinkerRunLane *lane;
    TinkerRecording recording;
    TinkerTimeSpan *span;
    TinkerKeptRuns *kept;
    TinkerScene *ran; /* the scene as the last segment has it; NULL where there is none */
    TinkerFrame *frame;
    guint path_segment; /* where in the record the frame's paths end: everything before this row of this segment */
    gsize path_row;     /* is noted */
    GArray *asked;      /* of TinkerQuantity: asked for in vain */
    GPtrArray *events;  /* of TinkerRunEvent *: of this generation, when there were so many in all tasks */
    guint events_generation, events_counted;
};

G_DEFINE_FINAL_TYPE(TinkerPlayer, tinker_player, G_TYPE_OBJECT)

enum { STATE_CHANGED, MOVED, REWOUND, FAILED, SIGNALS };
static guint signals[SIGNALS];

/* The record ----------------------------------------------------------------------------------------------------------
 */

static TinkerSegment *segment_of(TinkerPlayer *player, guint number)
{
    return &g_array_index(player->recording.segments, TinkerSegment, number);
}

static void forget_record(TinkerPlayer *player)
{
    tinker_recording_forget(&player->recording);
    g_clear_pointer(&player->ran, tinker_scene_free);
}

static void add_segment(TinkerPlayer *player, TinkerScene *scene, double start)
{
    g_autoptr(GArray) columns = tinker_recorded_quantities(player->document, player->asked);
    tinker_recording_add(&player->recording, tinker_run_task_new(player->lane, scene, start, columns), start);
    g_clear_pointer(&player->ran, tinker_scene_free);
    player->ran = tinker_scene_copy(tinker_document_scene(player->document));
}

static void record_from_start(TinkerPlayer *player)
{
    forget_record(player);
    add_segment(player, tinker_scene_copy(tinker_document_scene(player->document)), 0);
}

/* The frame -----------------------------------------------------------------------------------------------------------
 */

/* Takes the frame through all samples that its paths lack, up to the time shown. */
static void note_paths(TinkerPlayer *player)
{
    if (!tinker_frame_leaves_paths(player->frame)) return;
    for (; player->path_segment < player->recording.segments->len; player->path_segment++, player->path_row = 0) {
        TinkerRunTask *task = segment_of(player, player->path_segment)->task;
        const double end = tinker_recording_end(&player->recording, player->path_segment);
        gsize last;
        if (!tinker_run_task_find(task, fmin(player->time, end), &last)) return;
        for (; player->path_row <= last; player->path_row++)
            if (tinker_recording_place_sample(player->frame, task, player->path_row))
                tinker_frame_note_paths(player->frame);
        if (player->time < end) return;
    }
}

static void update_frame(TinkerPlayer *player)
{
    if (player->frame == NULL) return;
    note_paths(player);
    (void)tinker_recording_place(&player->recording, player->frame, player->time);
}

static void renew_frame(TinkerPlayer *player)
{
    g_clear_pointer(&player->frame, tinker_frame_free);
    player->frame = tinker_frame_new(tinker_document_scene(player->document), NULL);
    player->path_segment = 0;
    player->path_row = 0;
    if (player->frame != NULL) tinker_tops_turn_bodies(player->frame);
    update_frame(player);
}

static void moved(TinkerPlayer *player)
{
    update_frame(player);
    g_signal_emit(player, signals[MOVED], 0);
}

static void set_state(TinkerPlayer *player, TinkerPlayerState state)
{
    if (player->state == state) return;
    player->state = state;
    g_signal_emit(player, signals[STATE_CHANGED], 0);
}

/* Edits ---------------------------------------------------------------------------------------------------------------
 */

/* The scene as it is in the document, started from the sample shown now, to which the time is set. NULL where what the
 * scene has become cannot go on from there. (transfer full) */
static TinkerScene *continued_scene(TinkerPlayer *player)
{
    const TinkerSegment *segment = tinker_recording_at(&player->recording, player->time);
    TinkerScene *scene = tinker_document_scene(player->document);
    gsize row;
    if (player->frame == NULL || !tinker_run_task_find(segment->task, player->time, &row)) return NULL;
    int count;
    const TinkerBlockId *bodies = tinker_run_task_bodies(segment->task, &count);
    g_autofree TinkerBodySample *samples = g_new0(TinkerBodySample, (gsize)count + 1);
    g_autofree double *velocities = g_new0(double, 2 * (gsize)tinker_scene_id_limit(scene) + 2);
    double time = player->time;
    if (!tinker_run_task_read(segment->task, row, &player->time, samples, NULL)) return NULL;
    for (int i = 0; i < count; i++) {
        velocities[2 * bodies[i]] = samples[i].vx;
        velocities[2 * bodies[i] + 1] = samples[i].vy;
    }
    if (time != player->time) update_frame(player);
    return tinker_scene_continued(scene, player->frame, player->time, velocities, NULL);
}

/* Goes on from the sample shown now, with the scene as it has become. */
static gboolean go_on(TinkerPlayer *player)
{
    TinkerScene *continued = continued_scene(player);
    if (continued == NULL) return FALSE;
    tinker_scene_head(continued)->run.duration = fmax(tinker_player_duration(player) - player->time, 0);
    guint keep = 0;
    while (keep < player->recording.segments->len && segment_of(player, keep)->start < player->time)
        tinker_run_task_stop(segment_of(player, keep++)->task); // it counts up to here
    for (guint i = keep; i < player->recording.segments->len; i++)
        tinker_run_task_stop(segment_of(player, i)->task);
    g_array_set_size(player->recording.segments, keep);
    player->recording.generation++;
    player->path_segment = MIN(player->path_segment, keep); /* noted up to here, as the frame was made anew */
    player->path_row = 0;
    add_segment(player, continued, player->time);
    return TRUE;
}

TinkerScene *tinker_player_scene_now(TinkerPlayer *player)
{
    if (player->recording.segments->len == 0 || player->time == 0)
        return tinker_scene_copy(tinker_document_scene(player->document));
    double time = player->time;
    TinkerScene *scene = continued_scene(player);
    player->time = time;
    update_frame(player);
    return scene;
}

static void rewind_after_edit(TinkerPlayer *player)
{
    gboolean under_way = player->time > 0;
    forget_record(player);
    player->time = 0;
    set_state(player, TINKER_PLAYER_SETUP);
    renew_frame(player);
    if (under_way) g_signal_emit(player, signals[REWOUND], 0);
}

static gboolean can_run(TinkerPlayer *player, TinkerBlockId *culprit, GError **error);

/* A new run from the start in place of the one there is, at the same time. FALSE where the scene cannot run. */
static gboolean run_anew(TinkerPlayer *player)
{
    TinkerBlockId culprit;
    if (!can_run(player, &culprit, NULL)) return FALSE;
    record_from_start(player);
    player->path_segment = 0;
    player->path_row = 0;
    if (player->state == TINKER_PLAYER_SETUP) set_state(player, TINKER_PLAYER_PAUSED);
    return TRUE;
}

static void on_changed(TinkerPlayer *player)
{
    TinkerDifference difference = player->ran == NULL
                                      ? TINKER_DIFFERENCE_DRAWING
                                      : tinker_scene_difference(player->ran, tinker_document_scene(player->document));
    gboolean under_way = player->time > 0;
    renew_frame(player);
    const gboolean on_the_way = difference == TINKER_DIFFERENCE_TUNABLE && player->state == TINKER_PLAYER_PLAYING;
    const gboolean anew =
        player->trial && !on_the_way && (player->ran == NULL || difference != TINKER_DIFFERENCE_DRAWING);
    if (anew && run_anew(player)) {
        g_signal_emit(player, signals[MOVED], 0);
        return;
    }
    if (difference == TINKER_DIFFERENCE_START || (difference == TINKER_DIFFERENCE_TUNABLE && !under_way))
        rewind_after_edit(player);
    else if (difference == TINKER_DIFFERENCE_TUNABLE && !go_on(player))
        rewind_after_edit(player);
    g_signal_emit(player, signals[MOVED], 0);
}

static void on_replaced(TinkerPlayer *player)
{
    g_clear_pointer(&player->frame, tinker_frame_free);
    forget_record(player);
    g_array_set_size(player->asked, 0);
    tinker_time_span_set(player->span, NULL);
    tinker_kept_runs_remove_all(player->kept);
    player->time = 0;
    set_state(player, TINKER_PLAYER_SETUP);
}

/* Playing -------------------------------------------------------------------------------------------------------------
 */

static gboolean can_run(TinkerPlayer *player, TinkerBlockId *culprit, GError **error)
{
    TinkerScene *scene = tinker_document_scene(player->document);
    *culprit = tinker_scene_first_placeholder(scene);
    if (*culprit != TINKER_NO_BLOCK) {
        g_set_error(
            error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_PLUGIN,
            _("%s is a block of the type “%s”, which no installed plugin provides. Install the plugin, or delete "
              "the block."),
            tinker_scene_block_name(scene, *culprit), tinker_scene_block_type(scene, *culprit));
        return FALSE;
    }
    *culprit = tinker_scene_first_detached(scene);
    if (*culprit == TINKER_NO_BLOCK) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                _("%s is not connected. Drag its loose end onto a block, or delete it."),
                tinker_scene_block_name(scene, *culprit));
    return FALSE;
}

/* Makes sure that there is a record, or one in the making. */
static gboolean have_record(TinkerPlayer *player, TinkerBlockId *culprit, GError **error)
{
    if (player->recording.segments->len > 0) return TRUE;
    if (!can_run(player, culprit, error)) return FALSE;
    record_from_start(player);
    return TRUE;
}

gboolean tinker_player_play(TinkerPlayer *player, TinkerBlockId *culprit, GError **error)
{
    *culprit = TINKER_NO_BLOCK;
    TinkerRunStatus status;
    gboolean at_end = tinker_player_status(player, &status) && status.finished && player->time >= status.reached;
    if (at_end && tinker_recording_last(&player->recording)->failure_told)
        tinker_player_reset(player);
    else if (at_end)
        player->time = 0;
    if (!have_record(player, culprit, error)) return FALSE;
    player->pace = 1;
    player->step_to = NAN;
    set_state(player, TINKER_PLAYER_PLAYING);
    return TRUE;
}

void tinker_player_pause(TinkerPlayer *player)
{
    if (player->state == TINKER_PLAYER_PLAYING) set_state(player, TINKER_PLAYER_PAUSED);
}

gboolean tinker_player_step(TinkerPlayer *player, gboolean forward, TinkerBlockId *culprit, GError **error)
{
    *culprit = TINKER_NO_BLOCK;
    if (!have_record(player, culprit, error)) return FALSE;
    double interval = tinker_scene_head(tinker_document_scene(player->document))->run.interval;
    gboolean under_way =
        player->state == TINKER_PLAYER_PLAYING && !isnan(player->step_to); /* not recorded yet: count on */
    double from = under_way ? player->step_to : player->time;
    double number = forward ? floor(from / interval + 1e-6) + 1 : ceil(from / interval - 1e-6) - 1;
    return tinker_player_go_to(player, fmax(number * interval, 0), culprit, error);
}

gboolean tinker_player_go_to(TinkerPlayer *player, double time, TinkerBlockId *culprit, GError **error)
{
    *culprit = TINKER_NO_BLOCK;
    if (!have_record(player, culprit, error)) return FALSE;
    player->step_to = fmax(time, 0);
    set_state(player, TINKER_PLAYER_PLAYING);
    tinker_player_advance(player, 0);
    return TRUE;
}

void tinker_player_seek(TinkerPlayer *player, double time)
{
    if (player->recording.segments->len == 0) return;
    player->time = CLAMP(time, 0, tinker_player_reached(player));
    if (player->state == TINKER_PLAYER_SETUP) set_state(player, TINKER_PLAYER_PAUSED);
    moved(player);
}

void tinker_player_reset(TinkerPlayer *player)
{
    forget_record(player);
    player->time = 0;
    set_state(player, TINKER_PLAYER_SETUP);
    renew_frame(player);
    g_signal_emit(player, signals[MOVED], 0);
}

void tinker_player_rewind(TinkerPlayer *player)
{
    tinker_player_reset(player);
    g_signal_emit(player, signals[REWOUND], 0);
}

void tinker_player_begin_trial(TinkerPlayer *player)
{
    player->trial = TRUE;
}

void tinker_player_end_trial(TinkerPlayer *player)
{
    player->trial = FALSE;
}

void tinker_player_refresh(TinkerPlayer *player)
{
    moved(player);
}

static void tell_failure(TinkerPlayer *player)
{
    TinkerSegment *segment = tinker_recording_last(&player->recording);
    g_autoptr(GError) error = tinker_run_task_error(segment->task);
    if (error == NULL || segment->failure_told) return;
    segment->failure_told = TRUE;
    g_signal_emit(player, signals[FAILED], 0, error->message);
}

static void note_pace(TinkerPlayer *player, double seconds, double pace)
{
    player->pace += fmin(seconds / PACE_MEMORY, 1) * (pace - player->pace);
}

void tinker_player_advance(TinkerPlayer *player, double seconds)
{
    if (player->state != TINKER_PLAYER_PLAYING) return;
    TinkerRunStatus status = tinker_run_task_status(tinker_recording_last(&player->recording)->task);
    gboolean steps = !isnan(player->step_to);
    double before = player->time, wanted = steps ? player->step_to : before + seconds * player->speed;
    gboolean recorded = status.rows > 0 && wanted <= status.reached, over = status.finished && !recorded;
    /* A run that has just been made anew has first to come to where time stands. */
    const double limit = over ? status.reached : fmax(status.reached, before);
    if (!steps || recorded || over) player->time = fmin(wanted, limit);
    if (!steps && !over && wanted > before) note_pace(player, seconds, (player->time - before) / (wanted - before));
    moved(player);
    if (over || (steps && recorded)) set_state(player, TINKER_PLAYER_PAUSED);
    if (over) tell_failure(player);
}

gboolean tinker_player_wait(TinkerPlayer *player, double time, GError **error)
{
    if (player->recording.segments->len == 0) return TRUE;
    TinkerRunTask *task = tinker_recording_last(&player->recording)->task;
    gboolean to_end =
        tinker_scene_head(player->ran)->run.accuracy > 0; /* else samples of a try that misses may be read */
    for (;;) {
        TinkerRunStatus status = tinker_run_task_status(task);
        if (status.rows > 0 && status.reached >= time && (!to_end || status.finished)) return TRUE;
        if (status.finished) break;
        g_usleep(500);
    }
    GError *failure = tinker_run_task_error(task);
    if (failure == NULL) return TRUE;
    tinker_recording_last(&player->recording)->failure_told = TRUE;
    g_propagate_error(error, failure);
    return FALSE;
}

/* What there is to see ------------------------------------------------------------------------------------------------
 */

TinkerPlayerState tinker_player_state(TinkerPlayer *player)
{
    return player->state;
}

double tinker_player_time(TinkerPlayer *player)
{
    return player->time;
}

double tinker_player_reached(TinkerPlayer *player)
{
    const TinkerSegment *last = tinker_recording_last(&player->recording);
    return last == NULL ? 0 : tinker_run_task_status(last->task).reached;
}

double tinker_player_duration(TinkerPlayer *player)
{
    return tinker_scene_head(tinker_document_scene(player->document))->run.duration;
}

TinkerKeptRuns *tinker_player_kept(TinkerPlayer *player)
{
    return player->kept;
}

gboolean tinker_player_keep(TinkerPlayer *player)
{
    return player->recording.segments->len > 0 &&
           tinker_kept_runs_add(player->kept, tinker_document_scene(player->document), &player->recording);
}

TinkerTimeSpan *tinker_player_span(TinkerPlayer *player)
{
    return player->span;
}

double tinker_player_speed(TinkerPlayer *player)
{
    return player->speed;
}

void tinker_player_set_speed(TinkerPlayer *player, double speed)
{
    player->speed = speed;
    player->pace = 1;
    g_signal_emit(player, signals[STATE_CHANGED], 0);
}

double tinker_player_pace(TinkerPlayer *player)
{
    return player->state == TINKER_PLAYER_PLAYING ? player->pace : 1;
}

TinkerFrame *tinker_player_frame(TinkerPlayer *player)
{
    return player->frame;
}

gboolean tinker_player_value(TinkerPlayer *player, TinkerBlockId block, int32_t quantity, double *value)
{
    const TinkerSegment *segment = tinker_recording_at(&player->recording, player->time);
    gsize row;
    if (segment == NULL || !tinker_run_task_find(segment->task, player->time, &row)) return FALSE;
    int column = tinker_run_task_column(segment->task, (TinkerQuantity){block, quantity});
    return column >= 0 && tinker_run_task_value(segment->task, row, column, value);
}

gboolean tinker_player_status(TinkerPlayer *player, TinkerRunStatus *status)
{
    const TinkerSegment *last = tinker_recording_last(&player->recording);
    if (last == NULL) return FALSE;
    *status = tinker_run_task_status(last->task);
    return TRUE;
}

GPtrArray *tinker_player_warnings(TinkerPlayer *player, gboolean of_scene)
{
    const TinkerSegment *last = tinker_recording_last(&player->recording);
    return last == NULL ? g_ptr_array_new_with_free_func(g_free) : tinker_run_task_warnings(last->task, of_scene);
}

/* A run that was made again for an accuracy has other samples from then on. */
guint tinker_player_generation(TinkerPlayer *player)
{
    const guint before = player->recording.generation, now = tinker_recording_generation(&player->recording);
    if (now != before && player->frame != NULL && tinker_frame_leaves_paths(player->frame))
        renew_frame(player); /* whose paths are those of the new samples */
    return now;
}

/* Of each segment those before the next one begins. */
GPtrArray *tinker_player_events(TinkerPlayer *player)
{
    const guint generation = tinker_player_generation(player);
    guint count = 0;
    for (guint i = 0; i < player->recording.segments->len; i++)
        count += tinker_run_task_event_count(segment_of(player, i)->task);
    if (generation == player->events_generation && count == player->events_counted) return player->events;
    g_ptr_array_unref(player->events);
    player->events = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    player->events_generation = generation;
    player->events_counted = count;
    for (guint i = 0; i < player->recording.segments->len; i++)
        tinker_run_task_add_events(segment_of(player, i)->task, tinker_recording_end(&player->recording, i),
                                   player->events);
    return player->events;
}

static void note_asked(TinkerPlayer *player, TinkerQuantity quantity)
{
    for (guint i = 0; i < player->asked->len; i++) {
        const TinkerQuantity *asked = &g_array_index(player->asked, TinkerQuantity, i);
        if (asked->block == quantity.block && asked->quantity == quantity.quantity) return;
    }
    g_array_append_val(player->asked, quantity);
}

gboolean tinker_player_series(TinkerPlayer *player, TinkerQuantity quantity, TinkerSeriesCursor *cursor, GArray *times,
                              GArray *values)
{
    if (tinker_recording_series(&player->recording, quantity, cursor, times, values)) return TRUE;
    note_asked(player, quantity);
    return FALSE;
}

/* The object ----------------------------------------------------------------------------------------------------------
 */

static void tinker_player_finalize(GObject *object)
{
    TinkerPlayer *player = TINKER_PLAYER(object);
    g_clear_pointer(&player->frame, tinker_frame_free);
    tinker_recording_forget(&player->recording);
    tinker_recording_clear(&player->recording);
    g_object_unref(player->span);
    g_object_unref(player->kept);
    g_ptr_array_unref(player->events);
    tinker_run_lane_unref(player->lane);
    g_clear_pointer(&player->ran, tinker_scene_free);
    g_array_unref(player->asked);
    g_object_unref(player->document);
    G_OBJECT_CLASS(tinker_player_parent_class)->finalize(object);
}

static void tinker_player_class_init(TinkerPlayerClass *class)
{
    G_OBJECT_CLASS(class)->finalize = tinker_player_finalize;
    signals[STATE_CHANGED] =
        g_signal_new("state-changed", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[MOVED] = g_signal_new("moved", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[REWOUND] =
        g_signal_new("rewound", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    signals[FAILED] = g_signal_new("failed", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 1,
                                   G_TYPE_STRING);
}

static void tinker_player_init(TinkerPlayer *player)
{
    player->speed = player->pace = 1;
    player->step_to = NAN;
    player->lane = tinker_run_task_lane();
    player->events = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    tinker_recording_init(&player->recording);
    player->span = tinker_time_span_new();
    player->kept = tinker_kept_runs_new();
    player->asked = g_array_new(FALSE, FALSE, sizeof(TinkerQuantity));
}

TinkerPlayer *tinker_player_new(TinkerDocument *document)
{
    TinkerPlayer *player = g_object_new(TINKER_TYPE_PLAYER, NULL);
    player->document = g_object_ref(document);
    g_signal_connect_object(document, "changed", G_CALLBACK(on_changed), player, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(on_replaced), player, G_CONNECT_SWAPPED);
    renew_frame(player);
    return player;
}
