/* Compiling, second part: ends off the centres of bodies that turn, supports and the places on them become points. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "physics/compile/compile-private.h"
#include "physics/model/angles.h"
#include "physics/model/points.h"

/* An attachment to be, and the end that is to have its point. */
typedef struct {
    TinkerAttachment point;
    int32_t *end;
} Attached;

static int compare_attached(const void *left, const void *right)
{
    const Attached *l = left, *r = right;
    if (l->point.body != r->point.body) return l->point.body < r->point.body ? -1 : 1;
    return (l->point.turn != 0) - (r->point.turn != 0);
}

/* Tells each body that turns which attachments it has. */
static void share_attachments(TinkerModel *model)
{
    int32_t point = model->first_attachment;
    for (int32_t k = 0; k < model->turning; k++) {
        TinkerTurn *turn = &model->turns[k];
        turn->first_attachment = point;
        while (point < model->first_support && tinker_model_attachment(model, point)->body == turn->body)
            point++;
        turn->end_attachment = point;
    }
}

/* Attachments to one body stand together, so that its angle is looked at once; its turn is one for all ends. */
static void attach_to_bodies(TinkerModel *model)
{
    model->first_support = model->points;
    if (model->turning == 0) return;
    g_autoptr(GArray) attached = g_array_new(FALSE, FALSE, sizeof(Attached));
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const gboolean turns = tinker_block_class_speaks_of_angles(batch->block_class);
        int32_t *points = model->end_points[i];
        for (int32_t e = 0; e < batch->end_count; e++) {
            const TinkerSceneEnd *end = &batch->end[e];
            const int32_t number = tinker_block_index_find(model->numbers, end->block);
            const int32_t body = number < 0 ? -1 : model->centre_point[number];
            if (body < 0 || model->turn_of[body] < 0) continue;
            Attached point = {{.block = end->block, .body = body, .x = end->x, .y = end->y}, &points[e]};
            Attached turn = {{.block = end->block, .body = body, .turn = TRUE}, &points[batch->end_count + e]};
            if (end->x != 0 || end->y != 0) g_array_append_val(attached, point);
            if (turns) g_array_append_val(attached, turn);
        }
    }
    g_array_sort(attached, compare_attached);
    for (guint i = 0; i < attached->len; i++) {
        const Attached *at = &g_array_index(attached, Attached, i);
        const Attached *last = i > 0 ? at - 1 : NULL;
        const gboolean again = last != NULL && at->point.turn && compare_attached(last, at) == 0;
        if (!again) {
            g_array_append_val(model->attachments, at->point);
            model->points++;
        }
        *at->end = model->points - 1;
    }
    model->first_support = model->points;
    share_attachments(model);
}

/* A point of a support: its place, with the support unmoved. */
static int32_t add_support_point(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, double x, double y)
{
    double angle = tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0), c = cos(angle),
           s = sin(angle);
    double place[2] = {tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, 0, 0),
                       tinker_block_batch_meaning(batch, row, TINKER_MEANING_POSITION, 1, 0)};
    TinkerAttachment point = {
        .block = batch->ids[row],
        .body = -1,
        .x = place[0] - model->origin[0] + (x == 0 && y == 0 ? 0 : c * x - s * y),
        .y = place[1] - model->origin[1] + (x == 0 && y == 0 ? 0 : s * x + c * y),
        .arm = {c * x - s * y, s * x + c * y},
    };
    g_array_append_val(model->attachments, point);
    return model->points++;
}

/* The turn of a support, which has a batch, or of a mass, which has no angle: that is one for all of them. */
static int32_t add_support_turn(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row)
{
    TinkerAttachment turn = {.block = TINKER_NO_BLOCK, .body = -1, .turn = TRUE};
    if (batch != NULL) {
        turn.block = batch->ids[row];
        turn.x = tinker_block_batch_meaning(batch, row, TINKER_MEANING_ORIENTATION, 0, 0);
    }
    for (int32_t point = model->first_support; batch == NULL && point < model->points; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        if (at->turn && at->block == TINKER_NO_BLOCK) return point;
    }
    g_array_append_val(model->attachments, turn);
    return model->points++;
}

/* Where a block's row is, to find a support from an end. */
typedef struct {
    const TinkerBlockBatch *batch;
    int32_t row;
} Location;

/* By number of a block. */
static Location *locate_supports(TinkerModel *model)
{
    Location *locations = g_new0(Location, MAX(tinker_block_index_count(model->numbers), 1)), *of_batch = locations;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        const TinkerPhysics *physics = batch->block_class->physics;
        const gboolean stands = physics != NULL && physics->body != NULL && physics->body->degrees_of_freedom == 0;
        for (int32_t row = 0; stands && row < batch->count; row++) {
            of_batch[row] = (Location){batch, row};
            model->centre_point[tinker_block_index_find(model->numbers, batch->ids[row])] =
                add_support_point(model, batch, row, 0, 0);
        }
        of_batch += batch->count;
    }
    return locations;
}

static gboolean refuse_end(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, int32_t end, GError **error)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE,
                _("%s: end %d is not connected (attach it to a mass or a support; nothing runs while an end is loose)"),
                tinker_scene_block_name(model->scene, batch->ids[row]), end + 1);
    return FALSE;
}

static gboolean connect_batch(TinkerModel *model, const TinkerBlockBatch *batch, const Location *locations,
                              int32_t *points, GError **error)
{
    for (int32_t row = 0; row < batch->count; row++) {
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++) {
            const TinkerSceneEnd *end = &batch->end[e];
            const int32_t number = tinker_block_index_find(model->numbers, end->block);
            if (points[e] >= 0) continue;
            if (number < 0 || model->centre_point[number] < 0)
                return refuse_end(model, batch, row, e - batch->end_offsets[row], error);
            points[e] = model->centre_point[number];
            const Location *at = &locations[number];
            if (at->batch != NULL && (end->x != 0 || end->y != 0))
                points[e] = add_support_point(model, at->batch, at->row, end->x, end->y);
        }
    }
    return TRUE;
}

static void connect_turns(TinkerModel *model, const TinkerBlockBatch *batch, const Location *locations, int32_t *turns)
{
    for (int32_t e = 0; e < batch->end_count; e++) {
        const Location *at = &locations[tinker_block_index_find(model->numbers, batch->end[e].block)];
        if (turns[e] < 0) turns[e] = add_support_turn(model, at->batch, at->row);
    }
}

static gboolean connect_ends(TinkerModel *model, const Location *locations, GError **error)
{
    for (guint i = 0; i < model->batches->len; i++) {
        int32_t *points = model->end_points[i];
        if (points != NULL && !connect_batch(model, g_ptr_array_index(model->batches, i), locations, points, error))
            return FALSE;
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (points != NULL && tinker_block_class_speaks_of_angles(batch->block_class))
            connect_turns(model, batch, locations, points + batch->end_count);
    }
    return TRUE;
}

/* The ends of a batch; where it speaks of angles, their turns stand behind. */
static gsize end_point_count(const TinkerBlockBatch *batch)
{
    return (tinker_block_class_speaks_of_angles(batch->block_class) ? 2 : 1) * (gsize)batch->end_count;
}

/* Of each batch, -1 for what is not known yet. */
static void allot_end_points(TinkerModel *model)
{
    const guint batches = model->batches->len;
    gsize points = 0;
    gboolean any_angles = FALSE;
    if (batches == 0) return;
    for (guint i = 0; i < batches; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        points += end_point_count(batch);
        any_angles |= batch->end_count > 0 && tinker_block_class_speaks_of_angles(batch->block_class);
    }
    model->end_points = g_malloc(batches * sizeof(int32_t *) + points * sizeof(int32_t));
    if (any_angles) model->angles = g_new0(TinkerAngles *, batches);
    int32_t *next = (int32_t *)(gpointer)(model->end_points + batches);
    memset(next, 0xff, points * sizeof(int32_t));
    for (guint i = 0; i < batches; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        model->end_points[i] = batch->end_count > 0 ? next : NULL;
        if (any_angles) model->angles[i] = tinker_angles_new(batch, next);
        next += end_point_count(batch);
    }
}

static void mark_moving(TinkerModel *model)
{
    int32_t count;
    tinker_motions_blocks(model->motions, &count);
    model->moving_supports = count;
    for (int32_t point = model->first_support; point < model->points; point++) {
        TinkerAttachment *at = tinker_model_attachment(model, point);
        at->moving = tinker_motions_moves(model->motions, at->block);
    }
}

static void allot_points(TinkerModel *model)
{
    gsize n = (gsize)MAX(model->points, 1);
    model->point = g_malloc0_n(n, sizeof(TinkerPoint) + 2 * sizeof(double) + sizeof(gboolean));
    model->point_acceleration = (double *)(gpointer)(model->point + n);
    model->point_used = (gboolean *)(gpointer)(model->point_acceleration + 2 * n);
    model->force = g_new0(double, 2 * n);
    for (int32_t point = model->first_support; point < model->points; point++) {
        const TinkerAttachment *at = tinker_model_attachment(model, point);
        model->point[point] = (TinkerPoint){at->x, at->y, 0, 0};
    }
}

gboolean tinker_model_compile_points(TinkerModel *model, GError **error)
{
    allot_end_points(model);
    attach_to_bodies(model);
    g_autofree Location *locations = locate_supports(model);
    if (!connect_ends(model, locations, error)) return FALSE;
    model->motions = tinker_motions_new(model->batches);
    mark_moving(model);
    allot_points(model);
    return TRUE;
}
