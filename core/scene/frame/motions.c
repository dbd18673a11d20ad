/* Motions are asked through their own vtable, batch by batch; several motions of one block add up. */
#include "scene/frame/motions.h"

#include <math.h>
#include <string.h>

#include "scene/frame/block-index.h"

struct _TinkerMotions {
    GPtrArray *batches;      /* those that are motions; borrowed elements */
    GArray *blocks;          /* of TinkerBlockId: those that are moved, without repetition */
    TinkerBlockIndex *index; /* of what each motion moves, in the order of the batches and their rows */
    TinkerPlace *places;     /* by number in the index */
    int32_t *number;         /* of each motion: that of what it moves */
    double *values;          /* six for each motion of the largest batch */
    TinkerPose *rotations;   /* one for each of them */
    TinkerBlockId failed;
};

static const TinkerMotion *motion_of(const TinkerBlockBatch *batch)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    return physics != NULL ? physics->motion : NULL;
}

static TinkerBlockId moved_block(const TinkerBlockBatch *batch, int32_t row)
{
    return batch->end[batch->end_offsets[row]].block;
}

/* What the rows of all batches move; their number is answered. */
static int32_t list_moved(const TinkerMotions *motions, TinkerBlockId *moved)
{
    int32_t count = 0;
    for (guint i = 0; i < motions->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(motions->batches, i);
        for (int32_t row = 0; row < batch->count; row++)
            moved[count++] = moved_block(batch, row);
    }
    return count;
}

TinkerMotions *tinker_motions_new(GPtrArray *batches)
{
    gboolean any = FALSE;
    for (guint i = 0; i < batches->len; i++)
        any |= motion_of(g_ptr_array_index(batches, i)) != NULL;
    if (!any) return NULL;
    TinkerMotions *motions = g_new0(TinkerMotions, 1);
    motions->batches = g_ptr_array_new();
    motions->blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    motions->failed = TINKER_NO_BLOCK;
    int32_t largest = 0, all = 0;
    for (guint i = 0; i < batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(batches, i);
        if (motion_of(batch) == NULL) continue;
        g_ptr_array_add(motions->batches, batch);
        largest = MAX(largest, batch->count);
        all += batch->count;
    }
    g_autofree TinkerBlockId *moved = g_new(TinkerBlockId, MAX(all, 1));
    motions->index = tinker_block_index_new(moved, list_moved(motions, moved));
    motions->number = g_new(int32_t, MAX(all, 1));
    for (int32_t i = 0; i < all; i++) {
        motions->number[i] = tinker_block_index_find(motions->index, moved[i]);
        if (motions->number[i] == i && moved[i] != TINKER_NO_BLOCK) g_array_append_val(motions->blocks, moved[i]);
    }
    motions->places = g_new0(TinkerPlace, MAX(all, 1));
    motions->values = g_new0(double, 6 * (gsize)largest);
    motions->rotations = g_new0(TinkerPose, largest);
    return motions;
}

void tinker_motions_free(TinkerMotions *motions)
{
    if (motions == NULL) return;
    g_ptr_array_unref(motions->batches);
    g_array_unref(motions->blocks);
    tinker_block_index_free(motions->index);
    g_free(motions->places);
    g_free(motions->number);
    g_free(motions->values);
    g_free(motions->rotations);
    g_free(motions);
}

const TinkerBlockId *tinker_motions_blocks(const TinkerMotions *motions, int32_t *count)
{
    *count = motions != NULL ? (int32_t)motions->blocks->len : 0;
    return *count == 0 ? NULL : (const TinkerBlockId *)(const void *)motions->blocks->data;
}

static gboolean fail(TinkerMotions *motions, const TinkerBlockBatch *batch, int32_t row)
{
    motions->failed = batch->ids[CLAMP(row, 0, batch->count - 1)];
    return FALSE;
}

/* `number` of what each row moves. */
static gboolean add_displacements(TinkerMotions *motions, TinkerBlockBatch *batch, const int32_t *number,
                                  TinkerBatch *view)
{
    double *displacement = motions->values;
    double *velocity = displacement + 2 * batch->count, *acceleration = velocity + 2 * batch->count;
    if (TINKER_CALL_BATCH(batch, "motion", view,
                          motion_of(batch)->motion(view, displacement, velocity, acceleration)) != TINKER_OK)
        return fail(motions, batch, view->failed_instance);
    for (int32_t row = 0; row < batch->count; row++) {
        if (moved_block(batch, row) == TINKER_NO_BLOCK) continue;
        TinkerPlace *place = &motions->places[number[row]];
        place->x += displacement[2 * row];
        place->y += displacement[2 * row + 1];
        place->vx += velocity[2 * row];
        place->vy += velocity[2 * row + 1];
        place->ax += acceleration[2 * row];
        place->ay += acceleration[2 * row + 1];
        if (!isfinite(place->x + place->y + place->vx + place->vy + place->ax + place->ay))
            return fail(motions, batch, row);
    }
    return TRUE;
}

static gboolean add_rotations(TinkerMotions *motions, TinkerBlockBatch *batch, const int32_t *number, TinkerBatch *view)
{
    TinkerPose *rotations = motions->rotations;
    if (TINKER_CALL_BATCH(batch, "rotation", view, motion_of(batch)->rotation(view, rotations)) != TINKER_OK)
        return fail(motions, batch, view->failed_instance);
    for (int32_t row = 0; row < batch->count; row++) {
        if (moved_block(batch, row) == TINKER_NO_BLOCK) continue;
        TinkerPlace *place = &motions->places[number[row]];
        place->turns = TRUE;
        place->angle += rotations[row].angle;
        place->rate += rotations[row].rate;
        place->angular_acceleration += rotations[row].acceleration;
        if (!isfinite(place->angle + place->rate + place->angular_acceleration)) return fail(motions, batch, row);
    }
    return TRUE;
}

static gboolean add_batch(TinkerMotions *motions, TinkerBlockBatch *batch, const int32_t *number, double t)
{
    tinker_block_batch_set_time(batch, t);
    TinkerBatch view = tinker_block_batch_view(batch, t);
    return (motion_of(batch)->motion == NULL || add_displacements(motions, batch, number, &view)) &&
           (motion_of(batch)->rotation == NULL || add_rotations(motions, batch, number, &view));
}

gboolean tinker_motions_evaluate(TinkerMotions *motions, double t)
{
    if (motions == NULL) return TRUE;
    memset(motions->places, 0, (gsize)tinker_block_index_count(motions->index) * sizeof(TinkerPlace));
    const int32_t *number = motions->number;
    for (guint i = 0; i < motions->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(motions->batches, i);
        if (!add_batch(motions, batch, number, t)) return FALSE;
        number += batch->count;
    }
    return TRUE;
}

gboolean tinker_motions_moves(const TinkerMotions *motions, TinkerBlockId block)
{
    return motions != NULL && tinker_block_index_find(motions->index, block) >= 0;
}

const TinkerPlace *tinker_motions_place(const TinkerMotions *motions, TinkerBlockId block)
{
    return &motions->places[tinker_block_index_find(motions->index, block)];
}

TinkerBlockId tinker_motions_failure(const TinkerMotions *motions)
{
    return motions->failed;
}
