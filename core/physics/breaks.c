/* Breaks: times at which a derivative of some waveform or law jumps. No step crosses one. */
#include <math.h>

#include "physics/model-private.h"

typedef double (*NextBreak)(TinkerBatch *batch);

static double plugin_break(TinkerModel *model, TinkerBlockBatch *batch, double t)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    const NextBreak offered[] = {
        physics->line_law != NULL ? physics->line_law->next_break : NULL,
        physics->force_element != NULL ? physics->force_element->next_break : NULL,
        physics->field != NULL ? physics->field->next_break : NULL,
        physics->constraint != NULL ? physics->constraint->next_break : NULL,
        physics->motion != NULL ? physics->motion->next_break : NULL,
    };
    double next = INFINITY;
    for (gsize i = 0; i < G_N_ELEMENTS(offered); i++) {
        if (offered[i] == NULL) continue;
        TinkerBatch view = tinker_block_batch_view(batch, t);
        double at = INFINITY;
        TINKER_CALL_VOID(at = offered[i](&view), .phase = "next_break", .block_class = batch->block_class,
                         .batch = &view, .name = tinker_block_batch_name, .source = batch);
        if (at > t && at < next) next = at;
    }
    return next;
}

double tinker_model_next_break(TinkerModel *model, double t, double horizon)
{
    double next = INFINITY;
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->waveforms > 0) next = MIN(next, tinker_block_batch_next_break(batch, t, MIN(horizon, next)));
        if (batch->block_class->physics != NULL) next = MIN(next, plugin_break(model, batch, t));
    }
    return next <= horizon ? next : INFINITY;
}

void tinker_model_enter_piece(TinkerModel *model, double inside)
{
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->waveforms > 0) tinker_block_batch_enter_piece(batch, inside);
    }
    model->time = NAN; /* what was evaluated belongs to the piece before */
}
