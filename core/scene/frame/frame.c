/* A frame holds a snapshot of the scene and one place per block id. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "plugin/call/process-state.h"
#include "scene/frame/frame-private.h"

static void locate(TinkerFrame *frame)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        for (int32_t row = 0; row < batch->count; row++) {
            TinkerBlockId id = batch->ids[row];
            frame->locations[id] = (TinkerFrameLocation){batch, row};
            frame->placed[id] =
                (TinkerFramePose){tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, 0, NAN),
                                  tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, 1, NAN),
                                  tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0.0)};
            frame->poses[id] = frame->placed[id];
        }
    }
}

static gboolean move_supports(TinkerFrame *frame, GError **error)
{
    if (!tinker_motions_evaluate(frame->motions, frame->time)) {
        const char *name = tinker_scene_block_name(frame->scene, tinker_motions_failure(frame->motions));
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                    _("%s: its motion at t = %g s is not a number (give it one that is finite at all times)"), name,
                    frame->time);
        return FALSE;
    }
    int32_t count;
    const TinkerBlockId *moved = tinker_motions_blocks(frame->motions, &count);
    for (int32_t i = 0; i < count; i++) {
        const TinkerPlace *place = tinker_motions_place(frame->motions, moved[i]);
        frame->poses[moved[i]].x = frame->placed[moved[i]].x + place->x;
        frame->poses[moved[i]].y = frame->placed[moved[i]].y + place->y;
        if (place->turns) frame->poses[moved[i]].orientation = frame->placed[moved[i]].orientation + place->angle;
    }
    return TRUE;
}

/* A motion may look into the scratch that its `prepare` fills. */
static gboolean prepare_motions(TinkerFrame *frame, GError **error)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        if (physics == NULL || physics->motion == NULL || physics->prepare == NULL) continue;
        TinkerBatch view = tinker_block_batch_view(batch, 0.0);
        if (TINKER_CALL_BATCH(batch, "prepare", &view, tinker_prepare(physics, &view)) == TINKER_OK) continue;
        g_autofree char *why = tinker_block_batch_refusal(batch, &view, _("its plugin refuses these properties"));
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, why);
        return FALSE;
    }
    return TRUE;
}

/* As placed they are as long as their properties say. */
static void list_wound(TinkerFrame *frame)
{
    for (guint i = 0; i < frame->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        if (tinker_block_class_is_wound(batch->block_class))
            g_array_append_vals(frame->wound, batch->ids, (guint)batch->count);
    }
    for (guint i = 0; i < frame->wound->len; i++) {
        const TinkerBlockId block = g_array_index(frame->wound, TinkerBlockId, i);
        tinker_frame_set_length(frame, block, tinker_frame_meaning(frame, block, TINKER_MEANING_LENGTH, 0, NAN));
    }
}

TinkerFrame *tinker_frame_new(TinkerScene *scene, GError **error)
{
    TinkerFrame *frame = g_new0(TinkerFrame, 1);
    frame->scene = scene;
    frame->batches = tinker_batches_new(scene, NULL);
    frame->limit = tinker_scene_id_limit(scene);
    frame->placed = g_new(TinkerFramePose, MAX(frame->limit, 1));
    frame->poses = g_new(TinkerFramePose, MAX(frame->limit, 1));
    for (int32_t id = 0; id < frame->limit; id++)
        frame->placed[id] = frame->poses[id] = (TinkerFramePose){NAN, NAN, 0};
    frame->motions = tinker_motions_new(frame->batches);
    frame->lanes = tinker_lanes_new(scene);
    frame->paths = tinker_paths_new(scene);
    frame->spans = tinker_spans_new(scene);
    frame->locations = g_new0(TinkerFrameLocation, MAX(frame->limit, 1));
    frame->ends = g_array_new(FALSE, TRUE, sizeof(TinkerEnd));
    frame->wound = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    frame->lengths = g_new0(TinkerWoundLength, MAX(frame->limit, 1));
    locate(frame);
    int32_t widest = 1, properties = 1;
    for (guint i = 0; i < frame->batches->len; i++) {
        const TinkerBlockClass *block_class =
            ((const TinkerBlockBatch *)g_ptr_array_index(frame->batches, i))->block_class;
        widest = MAX(widest, block_class->column_count);
        properties = MAX(properties, block_class->property_count);
    }
    frame->columns = g_new0(double, widest);
    frame->texts = g_new0(const char *, properties);
    if (!tinker_frame_work_out_shaped(frame, error) || !prepare_motions(frame, error) ||
        !tinker_frame_set_time(frame, 0.0, error)) {
        tinker_frame_free(frame);
        return NULL;
    }
    tinker_frame_work_out_placed(frame);
    list_wound(frame);
    return frame;
}

void tinker_frame_free(TinkerFrame *frame)
{
    if (frame == NULL) return;
    g_ptr_array_unref(frame->batches);
    g_free(frame->placed);
    g_free(frame->poses);
    tinker_motions_free(frame->motions);
    g_free(frame->lanes);
    tinker_paths_free(frame->paths);
    tinker_spans_free(frame->spans);
    g_array_unref(frame->wound);
    g_free(frame->lengths);
    g_free(frame->locations);
    g_free(frame->columns);
    g_free(frame->texts);
    g_array_unref(frame->ends);
    g_free(frame);
}

TinkerScene *tinker_frame_scene(const TinkerFrame *frame)
{
    return frame->scene;
}

double tinker_frame_time(const TinkerFrame *frame)
{
    return frame->time;
}

double tinker_frame_time_behind(TinkerFrame *frame, double t)
{
    double behind = t;
    for (guint i = 0; i < frame->batches->len; i++)
        behind = fmax(behind, tinker_block_batch_time_behind(g_ptr_array_index(frame->batches, i), t));
    return behind;
}

gboolean tinker_frame_set_time(TinkerFrame *frame, double t, GError **error)
{
    frame->time = t;
    for (guint i = 0; i < frame->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(frame->batches, i);
        /* A frame shows what holds from t on. */
        if (batch->evaluator_count > 0) tinker_block_batch_enter_behind(batch, t);
        if (batch->waveforms > 0) tinker_block_batch_set_time(batch, t);
    }
    return move_supports(frame, error);
}
