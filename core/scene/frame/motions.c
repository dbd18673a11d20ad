/* Motions are asked through their own vtable, batch by batch; several motions of one block add up. */
#include "scene/frame/motions.h"

#include <math.h>
#include <string.h>

struct _TinkerMotions {
    GPtrArray *batches;  /* those that are motions; borrowed elements */
    GArray *blocks;      /* of TinkerBlockId */
    TinkerPlace *places; /* by block id */
    double *values;      /* six for each motion of the largest batch */
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

TinkerMotions *tinker_motions_new(GPtrArray *batches, int32_t id_limit)
{
    TinkerMotions *motions = g_new0(TinkerMotions, 1);
    motions->batches = g_ptr_array_new();
    motions->blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    motions->places = g_new0(TinkerPlace, MAX(id_limit, 1));
    motions->failed = TINKER_NO_BLOCK;
    g_autofree gboolean *seen = g_new0(gboolean, MAX(id_limit, 1));
    int32_t largest = 0;
    for (guint i = 0; i < batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(batches, i);
        if (motion_of(batch) == NULL) continue;
        g_ptr_array_add(motions->batches, batch);
        largest = MAX(largest, batch->count);
        for (int32_t row = 0; row < batch->count; row++) {
            TinkerBlockId block = moved_block(batch, row);
            if (block == TINKER_NO_BLOCK || seen[block]) continue;
            seen[block] = TRUE;
            g_array_append_val(motions->blocks, block);
        }
    }
    motions->values = g_new0(double, 6 * (gsize)largest);
    return motions;
}

void tinker_motions_free(TinkerMotions *motions)
{
    if (motions == NULL) return;
    g_ptr_array_unref(motions->batches);
    g_array_unref(motions->blocks);
    g_free(motions->places);
    g_free(motions->values);
    g_free(motions);
}

const TinkerBlockId *tinker_motions_blocks(const TinkerMotions *motions, int32_t *count)
{
    *count = (int32_t)motions->blocks->len;
    return (const TinkerBlockId *)(const void *)motions->blocks->data;
}

static gboolean add_batch(TinkerMotions *motions, TinkerBlockBatch *batch, double t)
{
    double *displacement = motions->values;
    double *velocity = displacement + 2 * batch->count, *acceleration = velocity + 2 * batch->count;
    tinker_block_batch_set_time(batch, t);
    TinkerBatch view = tinker_block_batch_view(batch, t);
    if (TINKER_CALL_BATCH(batch, "motion", &view,
                          motion_of(batch)->motion(&view, displacement, velocity, acceleration)) != TINKER_OK) {
        motions->failed = batch->ids[CLAMP(view.failed_instance, 0, batch->count - 1)];
        return FALSE;
    }
    for (int32_t row = 0; row < batch->count; row++) {
        TinkerBlockId block = moved_block(batch, row);
        if (block == TINKER_NO_BLOCK) continue;
        TinkerPlace *place = &motions->places[block];
        place->x += displacement[2 * row];
        place->y += displacement[2 * row + 1];
        place->vx += velocity[2 * row];
        place->vy += velocity[2 * row + 1];
        place->ax += acceleration[2 * row];
        place->ay += acceleration[2 * row + 1];
        if (!isfinite(place->x + place->y + place->vx + place->vy + place->ax + place->ay)) {
            motions->failed = batch->ids[row];
            return FALSE;
        }
    }
    return TRUE;
}

gboolean tinker_motions_evaluate(TinkerMotions *motions, double t)
{
    for (guint i = 0; i < motions->blocks->len; i++)
        memset(&motions->places[g_array_index(motions->blocks, TinkerBlockId, i)], 0, sizeof(TinkerPlace));
    for (guint i = 0; i < motions->batches->len; i++)
        if (!add_batch(motions, g_ptr_array_index(motions->batches, i), t)) return FALSE;
    return TRUE;
}

const TinkerPlace *tinker_motions_place(const TinkerMotions *motions, TinkerBlockId block)
{
    return &motions->places[block];
}

TinkerBlockId tinker_motions_failure(const TinkerMotions *motions)
{
    return motions->failed;
}
