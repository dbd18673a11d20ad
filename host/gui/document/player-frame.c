/* What the other files of a player stand on: its state, its record, and the frame that shows one time of it. */
#include <glib/gi18n.h>
#include <math.h>

#include "gui/document/player-private.h"
#include "gui/document/recorded-quantities.h"
#include "scene/frame/tops.h"

#define MOST_SPANNED 50000  /* blocks times samples that spans are taken from at once: some milliseconds */
#define AWAITED_US   250000 /* for which what was shown before a run was made anew stays on view */
#define SPANS_LAG_MS 100    /* until what has been recorded meanwhile is looked at */

guint player_signals[PLAYER_SIGNALS];

void player_set_state(TinkerPlayer *player, TinkerPlayerState state)
{
    if (player->state == state) return;
    player->state = state;
    g_signal_emit(player, player_signals[PLAYER_STATE_CHANGED], 0);
}

gboolean player_can_run(TinkerPlayer *player, TinkerBlockId *culprit, GError **error)
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

TinkerSegment *player_segment(TinkerPlayer *player, guint number)
{
    return &g_array_index(player->recording.segments, TinkerSegment, number);
}

void player_forget_record(TinkerPlayer *player)
{
    tinker_recording_forget(&player->recording);
    g_clear_pointer(&player->ran, tinker_scene_free);
}

TinkerRunTask *player_new_task(TinkerPlayer *player, TinkerScene *scene, double start, gboolean estimate)
{
    g_autoptr(GArray) columns = tinker_recorded_quantities(player->document, player->asked, !estimate);
    return tinker_run_task_new(player->lane, scene, start, columns, estimate);
}

void player_add_segment(TinkerPlayer *player, TinkerScene *scene, double start)
{
    tinker_recording_add(&player->recording, player_new_task(player, scene, start, !player->trial), start);
    g_clear_pointer(&player->ran, tinker_scene_free);
    player->ran = tinker_scene_copy(tinker_document_scene(player->document));
}

void player_record_from_start(TinkerPlayer *player)
{
    player_forget_record(player);
    player->anew_us = g_get_monotonic_time();
    player_add_segment(player, tinker_scene_copy(tinker_document_scene(player->document)), 0);
}

void player_end_recording(TinkerPlayer *player)
{
    TinkerSegment *last = tinker_recording_last(&player->recording);
    if (last == NULL || tinker_run_task_status(last->task).finished) return;
    if (tinker_kept_runs_have(player->kept, last->task)) return;
    tinker_run_task_stop(last->task);
    last->cut = TRUE;
}

void player_resume_recording(TinkerPlayer *player)
{
    TinkerSegment *last = tinker_recording_last(&player->recording);
    if (!last->cut) return;
    const TinkerScene *scene = last->scene != NULL ? last->scene : player->ran;
    tinker_run_task_unref(last->task);
    last->task = player_new_task(player, tinker_scene_copy(scene), last->start, TRUE);
    last->replaced = 0;
    last->cut = FALSE;
    player->recording.generation++;
    player_note_anew(player, player->recording.segments->len - 1);
}

/* Takes the frame through all samples that its paths lack, up to the time shown. */
static void note_paths(TinkerPlayer *player)
{
    if (!tinker_frame_leaves_paths(player->frame)) return;
    for (; player->path_segment < player->recording.segments->len; player->path_segment++, player->path_row = 0) {
        TinkerRunTask *task = player_segment(player, player->path_segment)->task;
        const double end = tinker_recording_end(&player->recording, player->path_segment);
        gsize last;
        if (!tinker_run_task_find(task, fmin(player->time, end), &last)) return;
        for (; player->path_row <= last; player->path_row++)
            if (tinker_recording_place_sample(player->frame, task, player->path_row))
                tinker_frame_note_paths(player->frame);
        if (player->time < end) return;
    }
}

/* What is shown when nothing moves is not drawn again for what is recorded: but where a span has grown by it. */
static gboolean on_spans_lag(gpointer data)
{
    TinkerPlayer *player = data;
    player->span_timer = 0;
    if (player->frame == NULL) return G_SOURCE_REMOVE;
    player->spans_grew = FALSE;
    player_update_frame(player);
    if (player->spans_grew) g_signal_emit(player, player_signals[PLAYER_MOVED], 0);
    return G_SOURCE_REMOVE;
}

/* Takes the frame through what has been recorded since, however far it is ahead of what is shown: spans are those of
 * the whole run. So much at once that no picture waits for it, and the rest a moment later. */
static void note_spans(TinkerPlayer *player)
{
    if (!tinker_frame_has_spans(player->frame)) return;
    const guint segments = player->recording.segments->len;
    int left = MAX(MOST_SPANNED / MAX(tinker_scene_block_count(tinker_frame_scene(player->frame)), 1), 1);
    gboolean lag = FALSE;
    for (; player->span_segment < segments; player->span_segment++, player->span_row = 0) {
        TinkerRunTask *task = player_segment(player, player->span_segment)->task;
        const gboolean is_last = player->span_segment + 1 == segments;
        gsize last;
        lag = is_last && !tinker_run_task_status(task).finished; /* asked first: rows that come meanwhile are seen */
        if (!tinker_run_task_find(task, tinker_recording_end(&player->recording, player->span_segment), &last)) break;
        for (; player->span_row <= last && left > 0; player->span_row++, left--)
            if (tinker_recording_place_sample(player->frame, task, player->span_row))
                player->spans_grew |= tinker_frame_note_spans(player->frame);
        lag |= player->span_row <= last;
        if (is_last || player->span_row <= last) break;
    }
    if (lag && player->span_timer == 0) player->span_timer = g_timeout_add(SPANS_LAG_MS, on_spans_lag, player);
}

void player_note_anew(TinkerPlayer *player, guint segment)
{
    player->path_segment = MIN(player->path_segment, segment);
    player->path_row = player->span_row = 0;
    player->span_segment = 0;
    if (player->frame != NULL) tinker_frame_forget_spans(player->frame);
}

void player_update_frame(TinkerPlayer *player)
{
    if (player->frame == NULL) return;
    note_paths(player);
    note_spans(player);
    (void)tinker_recording_place(&player->recording, player->frame, player->time);
}

void player_renew_frame(TinkerPlayer *player)
{
    g_clear_pointer(&player->frame, tinker_frame_free);
    player->frame = tinker_frame_new(tinker_document_scene(player->document), NULL);
    player_note_anew(player, 0);
    if (player->frame != NULL) tinker_tops_turn_bodies(player->frame);
    player_update_frame(player);
}

/* A run that is made anew has come to the time shown within moments, mostly: until then nothing is told, or all that is
 * shown would go to the start and back at every move of a hand. */
void player_moved(TinkerPlayer *player)
{
    player_update_frame(player);
    if (tinker_recording_awaits(&player->recording, player->time) &&
        g_get_monotonic_time() - player->anew_us < AWAITED_US)
        return;
    g_signal_emit(player, player_signals[PLAYER_MOVED], 0);
}
