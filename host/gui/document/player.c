/* Play-back of what was recorded, whose last segment may still grow. */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/document/player-private.h"

#define PACE_MEMORY 0.5 /* s: over which the pace is averaged */

G_DEFINE_FINAL_TYPE(TinkerPlayer, tinker_player, G_TYPE_OBJECT)

/* Makes sure that there is a record, or one in the making. One that was gone back from is that of a run before, unless
 * a time of it was gone to since. */
static gboolean have_record(TinkerPlayer *player, TinkerBlockId *culprit, GError **error)
{
    if (player->recording.segments->len > 0 && player->state != TINKER_PLAYER_SETUP) {
        player_resume_recording(player);
        return TRUE;
    }
    if (!player_can_run(player, culprit, error)) return FALSE;
    player_record_from_start(player);
    player_note_anew(player, 0);
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
    player_set_state(player, TINKER_PLAYER_PLAYING);
    return TRUE;
}

void tinker_player_pause(TinkerPlayer *player)
{
    if (player->state == TINKER_PLAYER_PLAYING) player_set_state(player, TINKER_PLAYER_PAUSED);
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
    player_set_state(player, TINKER_PLAYER_PLAYING);
    tinker_player_advance(player, 0);
    return TRUE;
}

void tinker_player_seek(TinkerPlayer *player, double time)
{
    if (player->recording.segments->len == 0) return;
    player->time = CLAMP(time, 0, tinker_player_reached(player));
    const gboolean steps = player->state == TINKER_PLAYER_PLAYING && !isnan(player->step_to);
    if (steps || player->state == TINKER_PLAYER_SETUP) player_set_state(player, TINKER_PLAYER_PAUSED);
    player_moved(player);
}

void tinker_player_give_up(TinkerPlayer *player)
{
    player_forget_record(player);
    tinker_player_reset(player);
}

void tinker_player_reset(TinkerPlayer *player)
{
    player_end_recording(player);
    player->time = 0;
    player_set_state(player, TINKER_PLAYER_SETUP);
    player_renew_frame(player);
    g_signal_emit(player, player_signals[PLAYER_MOVED], 0);
}

void tinker_player_rewind(TinkerPlayer *player)
{
    tinker_player_reset(player);
    g_signal_emit(player, player_signals[PLAYER_REWOUND], 0);
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
    player_moved(player);
}

static void tell_failure(TinkerPlayer *player)
{
    TinkerSegment *segment = tinker_recording_last(&player->recording);
    g_autoptr(GError) error = tinker_run_task_error(segment->task);
    if (error == NULL || segment->failure_told) return;
    segment->failure_told = TRUE;
    g_signal_emit(player, player_signals[PLAYER_FAILED], 0, error->message);
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
    player_moved(player);
    if (over || (steps && recorded)) player_set_state(player, TINKER_PLAYER_PAUSED);
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

/* The object ------------------------------------------------------------------------------------------------------- */

static void tinker_player_finalize(GObject *object)
{
    TinkerPlayer *player = TINKER_PLAYER(object);
    g_clear_handle_id(&player->span_timer, g_source_remove);
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
    player_signals[PLAYER_STATE_CHANGED] =
        g_signal_new("state-changed", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    player_signals[PLAYER_MOVED] =
        g_signal_new("moved", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    player_signals[PLAYER_REWOUND] =
        g_signal_new("rewound", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL, G_TYPE_NONE, 0);
    player_signals[PLAYER_FAILED] = g_signal_new("failed", TINKER_TYPE_PLAYER, G_SIGNAL_RUN_LAST, 0, NULL, NULL, NULL,
                                                 G_TYPE_NONE, 1, G_TYPE_STRING);
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
    g_signal_connect_object(document, "changed", G_CALLBACK(player_on_changed), player, G_CONNECT_SWAPPED);
    g_signal_connect_object(document, "replaced", G_CALLBACK(player_on_replaced), player, G_CONNECT_SWAPPED);
    player_renew_frame(player);
    return player;
}
