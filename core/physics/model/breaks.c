/* Breaks: times at which a derivative of some waveform or law jumps. No step crosses one. */
#include <glib/gi18n-lib.h>
#include <math.h>

#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "scene/frame/batch-waveforms.h"

/* A run that needs more pieces than this of the size that they have would not end in a lifetime: so many of them in a
 * row are no pulse, but what goes on. */
#define MOST_PIECES_TO_COME 1e9
#define MOST_TINY_PIECES    1000
/* From the start on, before a run. */
#define MOST_PIECES_CHECKED 4096

typedef double (*NextBreak)(TinkerBatch *batch);

static double plugin_break(TinkerModel *model, TinkerBlockBatch *batch, double t)
{
    const TinkerPhysics *physics = batch->block_class->physics;
    const NextBreak offered[] = {
        physics->line_law != NULL ? physics->line_law->next_break : NULL,
        physics->force_element != NULL ? physics->force_element->next_break : NULL,
        physics->force_element != NULL ? physics->force_element->next_blow : NULL,
        physics->field != NULL ? physics->field->next_break : NULL,
        physics->constraint != NULL ? physics->constraint->next_break : NULL,
        physics->motion != NULL ? physics->motion->next_break : NULL,
    };
    double next = INFINITY;
    for (gsize i = 0; i < G_N_ELEMENTS(offered); i++) {
        if (offered[i] == NULL) continue;
        TinkerBatch view = tinker_block_batch_view(batch, t);
        view.time = t; /* of whatever piece is entered */
        double at = INFINITY;
        TINKER_CALL_VOID(at = offered[i](&view), .phase = "next_break", .block_class = batch->block_class,
                         .batch = &view, .name = tinker_block_batch_name, .source = batch);
        if (at <= t) at = nextafter(t, INFINITY); /* too near for time to tell */
        if (at < next) next = at;
    }
    return next;
}

double tinker_model_next_break(TinkerModel *model, double t, double horizon)
{
    double next = INFINITY;
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->evaluator_count > 0) next = MIN(next, tinker_block_batch_next_break(batch, t, MIN(horizon, next)));
        if (batch->block_class->physics != NULL) next = MIN(next, plugin_break(model, batch, t));
    }
    return next <= horizon ? next : INFINITY;
}

/* The block whose break at `next` was found by a search from t. */
static TinkerBlockId break_block(TinkerModel *model, double t, double next)
{
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->evaluator_count > 0 && tinker_block_batch_next_break(batch, t, next) <= next)
            return batch->ids[tinker_block_batch_break_row(batch)];
        if (batch->block_class->physics != NULL && plugin_break(model, batch, t) <= next) return batch->ids[0];
    }
    return TINKER_NO_BLOCK;
}

double tinker_model_next_pole(const TinkerModel *model, TinkerBlockId *block)
{
    double next = INFINITY;
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        int32_t row;
        double at = batch->waveforms > 0 ? tinker_block_batch_next_pole(batch, &row) : INFINITY;
        if (!(at < next)) continue;
        next = at;
        *block = batch->ids[row];
    }
    return next;
}

gboolean tinker_break_crowd_add(TinkerBreakCrowd *crowd, double t, double next, double end)
{
    double left = end - t;
    crowd->count = left > MOST_PIECES_TO_COME * (next - t) ? crowd->count + 1 : 0;
    return crowd->count > MOST_TINY_PIECES;
}

char *tinker_break_crowd_text(TinkerModel *model, double t, double next)
{
    TinkerBlockId block = break_block(model, t, next);
    return g_strdup_printf(
        _("%s: from t = %.6g s on it switches every %.2g s, and no run comes to an end of that (let it "
          "switch more slowly)"),
        tinker_scene_block_name(model->scene, block), t, next - t);
}

gboolean tinker_model_check_breaks(TinkerModel *model, double duration, GError **error)
{
    TinkerBreakCrowd crowd = {0};
    double t = 0;
    for (int i = 0; i < MOST_PIECES_CHECKED && t < duration; i++) {
        double next = tinker_model_next_break(model, t, duration);
        if (!isfinite(next)) return TRUE;
        if (tinker_break_crowd_add(&crowd, t, next, duration)) {
            g_autofree char *text = tinker_break_crowd_text(model, t, next);
            g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE, text);
            return FALSE;
        }
        t = next;
    }
    return TRUE;
}

void tinker_model_enter_piece(TinkerModel *model, double from, double inside, double to)
{
    for (guint i = 0; i < model->batches->len; i++) {
        TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (batch->evaluator_count == 0) continue;
        tinker_block_batch_enter_piece(batch, inside);
        tinker_block_batch_bound_laws(batch, from, to);
    }
    model->time = NAN; /* what was evaluated belongs to the piece before */
}

gboolean tinker_model_is_struck(const TinkerModel *model)
{
    for (guint i = 0; i < model->batches->len; i++) {
        const TinkerBlockBatch *batch = g_ptr_array_index(model->batches, i);
        if (tinker_block_class_strikes(batch->block_class)) return TRUE;
    }
    return FALSE;
}
