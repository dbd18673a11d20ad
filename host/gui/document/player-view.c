/* What there is to see of a player: its state, values, events and series. */
#include "gui/document/player-private.h"

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
    if (player->recording.segments->len == 0) return FALSE;
    player_update_frame(player); /* which notes the spans of what is recorded */
    return tinker_kept_runs_add(player->kept, tinker_document_scene(player->document), &player->recording,
                                player->frame);
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
    g_signal_emit(player, player_signals[PLAYER_STATE_CHANGED], 0);
}

double tinker_player_pace(TinkerPlayer *player)
{
    return player->state == TINKER_PLAYER_PLAYING ? player->pace : 1;
}

TinkerFrame *tinker_player_frame(TinkerPlayer *player)
{
    return player->frame;
}

gboolean tinker_player_place(TinkerPlayer *player, TinkerFrame *frame, double time)
{
    return player->recording.segments->len > 0 && time <= tinker_player_reached(player) &&
           tinker_recording_place(&player->recording, frame, time);
}

gboolean tinker_player_value(TinkerPlayer *player, TinkerBlockId block, int32_t quantity, double *value)
{
    const TinkerSegment *segment = tinker_recording_at(&player->recording, player->time);
    const gboolean is_former = player->state == TINKER_PLAYER_SETUP && player->recording.segments->len > 1;
    gsize row;
    if (segment == NULL || is_former || tinker_recording_awaits(&player->recording, player->time)) return FALSE;
    if (!tinker_run_task_find(segment->task, player->time, &row)) return FALSE;
    int column = tinker_run_task_column(segment->task, (TinkerQuantity){block, quantity});
    return column >= 0 && tinker_run_task_value(segment->task, row, column, player->time, value);
}

gboolean tinker_player_status(TinkerPlayer *player, TinkerRunStatus *status)
{
    const TinkerSegment *last = tinker_recording_last(&player->recording);
    if (last == NULL) return FALSE;
    *status = tinker_run_task_status(last->task);
    if (last->cut) status->estimate_due = FALSE; /* none follows */
    return TRUE;
}

GPtrArray *tinker_player_warnings(TinkerPlayer *player)
{
    const TinkerSegment *last = tinker_recording_last(&player->recording);
    return last == NULL ? tinker_warnings_new() : tinker_run_task_warnings(last->task);
}

/* A run that was made again for an accuracy has other samples from then on. */
guint tinker_player_generation(TinkerPlayer *player)
{
    const guint before = player->recording.generation, now = tinker_recording_generation(&player->recording);
    if (now != before && player->frame != NULL &&
        (tinker_frame_leaves_paths(player->frame) || tinker_frame_has_spans(player->frame)))
        player_renew_frame(player); /* whose paths are those of the new samples */
    return now;
}

/* Of each segment those before the next one begins. */
GPtrArray *tinker_player_events(TinkerPlayer *player)
{
    const guint generation = tinker_player_generation(player);
    guint count = 0;
    for (guint i = 0; i < player->recording.segments->len; i++)
        count += tinker_run_task_event_count(player_segment(player, i)->task);
    if (generation == player->events_generation && count == player->events_counted) return player->events;
    g_ptr_array_unref(player->events);
    player->events = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_run_event_free);
    player->events_generation = generation;
    player->events_counted = count;
    for (guint i = 0; i < player->recording.segments->len; i++)
        tinker_run_task_add_events(player_segment(player, i)->task, tinker_recording_end(&player->recording, i),
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

gboolean tinker_player_band(TinkerPlayer *player, TinkerQuantity quantity, double until, double *band)
{
    return tinker_recording_band(&player->recording, quantity, until, band);
}

void tinker_player_visit(TinkerPlayer *player, TinkerSeriesCursor *cursor, TinkerBodiesFunc visit, void *data)
{
    tinker_recording_visit(&player->recording, cursor, visit, data);
}

gboolean tinker_player_visit_now(TinkerPlayer *player, TinkerBodiesFunc visit, void *data)
{
    return player->recording.segments->len > 0 &&
           tinker_recording_visit_at(&player->recording, player->time, visit, data);
}
