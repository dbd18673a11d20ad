/* What an edit means to the motion: nothing, another segment from here on, or another start. */
#include <math.h>

#include "gui/document/player-private.h"
#include "scene/history/continued.h"
#include "scene/history/difference.h"

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
    g_autofree double *velocities = g_new0(double, 3 * (gsize)tinker_scene_id_limit(scene) + 3);
    double time = player->time;
    if (!tinker_run_task_read(segment->task, row, &player->time, samples, NULL)) return NULL;
    for (int i = 0; i < count; i++) {
        velocities[3 * bodies[i]] = samples[i].vx;
        velocities[3 * bodies[i] + 1] = samples[i].vy;
        velocities[3 * bodies[i] + 2] = samples[i].rate;
    }
    if (time != player->time) player_update_frame(player);
    return tinker_scene_continued(scene, player->frame, player->time, velocities, NULL);
}

/* Goes on from the sample shown now, with the scene as it has become. */
static gboolean continue_from_now(TinkerPlayer *player)
{
    TinkerScene *continued = continued_scene(player);
    if (continued == NULL) return FALSE;
    tinker_scene_head(continued)->run.duration = fmax(tinker_player_duration(player) - player->time, 0);
    guint keep = 0;
    for (; keep < player->recording.segments->len && player_segment(player, keep)->start < player->time; keep++) {
        TinkerSegment *kept = player_segment(player, keep);
        tinker_run_task_stop(kept->task); // it counts up to here
        if (kept->checks != NULL) tinker_run_task_stop(kept->checks);
    }
    for (guint i = keep; i < player->recording.segments->len; i++)
        tinker_run_task_stop(player_segment(player, i)->task);
    g_array_set_size(player->recording.segments, keep);
    player->recording.generation++;
    player_note_anew(player, keep); /* the frame is made anew: its paths reach up to here, its spans beyond */
    TinkerSegment *before = player_segment(player, keep - 1);
    if (before->scene == NULL) before->scene = tinker_scene_copy(player->ran);
    TinkerScene *from_here = tinker_scene_copy(continued);
    player_add_segment(player, continued, player->time);
    tinker_recording_last(&player->recording)->scene = from_here;
    return TRUE;
}

TinkerScene *tinker_player_scene_shown(TinkerPlayer *player, double *start)
{
    const TinkerSegment *segment =
        player->recording.segments->len > 0 ? tinker_recording_at(&player->recording, player->time) : NULL;
    const gboolean own = segment != NULL && segment->scene != NULL && player->state != TINKER_PLAYER_SETUP;
    *start = own ? segment->start : 0;
    return tinker_scene_copy(own ? segment->scene : tinker_document_scene(player->document));
}

TinkerScene *tinker_player_scene_now(TinkerPlayer *player, double *behind)
{
    *behind = 0;
    if (player->recording.segments->len == 0 || player->time == 0)
        return tinker_scene_copy(tinker_document_scene(player->document));
    double time = player->time;
    TinkerScene *scene = continued_scene(player);
    *behind = fmax(time - player->time, 0);
    player->time = time;
    player_update_frame(player);
    return scene;
}

/* The samples are those that were there before, but where these were only some, or the scene asks for an accuracy. */
static void show_checked(TinkerPlayer *player, TinkerSegment *segment)
{
    const gsize rows = tinker_run_task_status(segment->task).rows;
    tinker_run_task_unref(segment->task);
    segment->task = g_steal_pointer(&segment->checks);
    segment->replaced = tinker_run_task_status(segment->task).replaced;
    if (tinker_scene_head(player->ran)->run.accuracy > 0 || tinker_run_task_status(segment->task).rows != rows)
        player->recording.generation++;
}

gboolean tinker_player_estimate(TinkerPlayer *player)
{
    TinkerSegment *segment = tinker_recording_last(&player->recording);
    if (segment == NULL || segment->cut) return FALSE;
    const TinkerRunStatus status = tinker_run_task_status(segment->task);
    if (!status.estimate_due) return FALSE;
    if (!status.finished) return TRUE;
    if (segment->checks == NULL) {
        TinkerScene *scene = segment->scene != NULL ? segment->scene : player->ran;
        segment->checks = player_new_task(player, tinker_scene_copy(scene), segment->start, TRUE);
    }
    if (!tinker_run_task_status(segment->checks).finished) return TRUE;
    show_checked(player, segment);
    player_moved(player);
    return FALSE;
}

static void rewind_after_edit(TinkerPlayer *player)
{
    gboolean under_way = player->time > 0;
    player_forget_record(player);
    player->time = 0;
    player_set_state(player, TINKER_PLAYER_SETUP);
    player_renew_frame(player);
    if (under_way) g_signal_emit(player, player_signals[PLAYER_REWOUND], 0);
}

/* A new run from the start in place of the one there is, at the same time. FALSE where the scene cannot run. */
static gboolean record_anew(TinkerPlayer *player)
{
    TinkerBlockId culprit;
    if (!player_can_run(player, &culprit, NULL)) return FALSE;
    player_record_from_start(player);
    player_note_anew(player, 0);
    if (player->state == TINKER_PLAYER_SETUP) player_set_state(player, TINKER_PLAYER_PAUSED);
    return TRUE;
}

gboolean tinker_player_run_anew(TinkerPlayer *player)
{
    if (!record_anew(player)) return FALSE;
    player->step_to = player->time;
    player_set_state(player, TINKER_PLAYER_PLAYING);
    player_moved(player);
    return TRUE;
}

double tinker_player_changed_at(TinkerPlayer *player)
{
    const guint count = player->recording.segments->len;
    return count > 1 && player->state != TINKER_PLAYER_SETUP ? player_segment(player, count - 1)->start : NAN;
}

void player_on_changed(TinkerPlayer *player)
{
    TinkerDifference difference = player->ran == NULL
                                      ? TINKER_DIFFERENCE_DRAWING
                                      : tinker_scene_difference(player->ran, tinker_document_scene(player->document));
    gboolean under_way = player->time > 0;
    player_renew_frame(player);
    const gboolean playing = player->state == TINKER_PLAYER_PLAYING && isnan(player->step_to);
    /* of a run that has come to its end nothing is left that could go on with the change */
    const gboolean ended = difference == TINKER_DIFFERENCE_TUNABLE && under_way && !playing &&
                           player->time >= tinker_player_duration(player);
    const gboolean tries = player->trial && (player->ran == NULL || difference != TINKER_DIFFERENCE_DRAWING);
    if (ended && !tries && tinker_player_run_anew(player)) return;
    if (tries && record_anew(player)) {
        player_moved(player);
        return;
    }
    if (difference == TINKER_DIFFERENCE_START || (difference == TINKER_DIFFERENCE_TUNABLE && !under_way))
        rewind_after_edit(player);
    else if (difference == TINKER_DIFFERENCE_TUNABLE && !continue_from_now(player))
        rewind_after_edit(player);
    player_moved(player);
}

void player_on_replaced(TinkerPlayer *player)
{
    g_clear_pointer(&player->frame, tinker_frame_free);
    player_forget_record(player);
    g_array_set_size(player->asked, 0);
    tinker_time_span_set(player->span, NULL);
    tinker_kept_runs_remove_all(player->kept);
    player->time = 0;
    player_set_state(player, TINKER_PLAYER_SETUP);
}
