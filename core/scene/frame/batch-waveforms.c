/* The three columns of each waveform property are filled by evaluators, one for every block, built from the block's own
 * amplitude, frequency and phase. */
#include <math.h>

#include "scene/frame/batch-waveforms.h"
#include "units/waveform/waveform-pole.h"

/* No break of a waveform lies between `from` and `next`, and none up to `horizon` where next is infinite; the first
 * pole there, INFINITY for none. */
struct _TinkerPiece {
    double from, next, horizon, pole;
    gboolean entered; /* the evaluator's switches are those of this piece */
};

static double column_or(const TinkerBlockBatch *batch, const char *property_id, int32_t row, double otherwise)
{
    if (property_id == NULL) return otherwise;
    int32_t property = tinker_block_class_property(batch->block_class, property_id);
    if (property < 0) return otherwise;
    return batch->columns[batch->block_class->first_columns[property]][row];
}

/* A displacement is differentiated twice by whoever rides on it, and by a constraint that prescribes it: its value
 * tables are read as C2 splines. */
static gboolean drives_a_place(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    return physics != NULL && (physics->motion != NULL || physics->constraint != NULL);
}

static void add_evaluators(TinkerBlockBatch *batch, int32_t property)
{
    const TinkerPropertyType *type = &batch->block_class->properties[property];
    gboolean smooth = drives_a_place(batch->block_class);
    for (int32_t row = 0; row < batch->count; row++) {
        TinkerWaveform *waveform = tinker_scene_get_waveform(batch->scene, batch->ids[row], property);
        batch->evaluators[batch->evaluator_count++] = tinker_waveform_evaluator_new(
            waveform, column_or(batch, type->amplitude, row, 1.0), column_or(batch, type->frequency, row, 0.0),
            column_or(batch, type->phase, row, 0.0), smooth);
    }
}

void tinker_block_batch_copy_waveforms(TinkerBlockBatch *batch)
{
    const TinkerBlockClass *block_class = batch->block_class;
    for (int32_t property = 0; property < block_class->property_count; property++)
        batch->waveforms += block_class->properties[property].kind == TINKER_KIND_WAVEFORM;
    if (batch->waveforms == 0) return;
    const gsize count = (gsize)batch->waveforms * (gsize)batch->count;
    batch->waveform_columns = g_new0(int32_t, batch->waveforms);
    batch->evaluators = g_new(TinkerWaveformEvaluator *, count);
    for (int32_t property = 0, number = 0; property < block_class->property_count; property++) {
        if (block_class->properties[property].kind != TINKER_KIND_WAVEFORM) continue;
        batch->waveform_columns[number++] = block_class->first_columns[property];
        add_evaluators(batch, property);
    }
    batch->pieces = g_new(struct _TinkerPiece, count);
    for (gsize i = 0; i < count; i++)
        batch->pieces[i] = (struct _TinkerPiece){NAN, NAN, NAN, INFINITY, FALSE};
}

static TinkerWaveformEvaluator *evaluator_of(const TinkerBlockBatch *batch, int32_t waveform, int32_t row)
{
    return batch->evaluators[waveform * batch->count + row];
}

const TinkerWaveformEvaluator *tinker_block_batch_evaluator(const TinkerBlockBatch *batch, int32_t column, int32_t row)
{
    for (int32_t waveform = 0; waveform < batch->waveforms; waveform++)
        if (batch->waveform_columns[waveform] == column) return evaluator_of(batch, waveform, row);
    return NULL;
}

void tinker_block_batch_set_time(TinkerBlockBatch *batch, double t)
{
    for (int32_t waveform = 0; waveform < batch->waveforms; waveform++) {
        double **columns = batch->columns + batch->waveform_columns[waveform];
        for (int32_t row = 0; row < batch->count; row++) {
            double result[3];
            tinker_waveform_evaluate(evaluator_of(batch, waveform, row), t, result);
            for (int derivative = 0; derivative < 3; derivative++)
                columns[derivative][row] = result[derivative];
        }
    }
}

void tinker_block_batch_set_steady(TinkerBlockBatch *batch)
{
    for (int32_t waveform = 0; waveform < batch->waveforms; waveform++) {
        double **columns = batch->columns + batch->waveform_columns[waveform];
        for (int32_t row = 0; row < batch->count; row++) {
            columns[0][row] = tinker_waveform_steady(evaluator_of(batch, waveform, row));
            columns[1][row] = columns[2][row] = 0;
        }
    }
}

void tinker_block_batch_enter_piece(TinkerBlockBatch *batch, double inside)
{
    for (int32_t i = 0; i < batch->evaluator_count; i++) {
        struct _TinkerPiece *piece = &batch->pieces[i];
        if (piece->entered && piece->from < inside && inside < piece->next) continue;
        piece->entered = TRUE;
        tinker_waveform_enter_piece(batch->evaluators[i], inside);
    }
}

double tinker_block_batch_next_break(TinkerBlockBatch *batch, double t, double horizon)
{
    double next = INFINITY;
    for (int32_t i = 0; i < batch->evaluator_count; i++) {
        struct _TinkerPiece *piece = &batch->pieces[i];
        gboolean known = piece->from <= t && t < piece->next && (isfinite(piece->next) || horizon <= piece->horizon);
        if (!known) {
            const TinkerWaveformEvaluator *evaluator = batch->evaluators[i];
            double at = tinker_waveform_next_break(evaluator, t, horizon);
            double pole = tinker_waveform_next_pole(evaluator, t, fmin(at, horizon));
            *piece = (struct _TinkerPiece){t, at, horizon, pole, FALSE};
        }
        next = MIN(next, piece->next);
    }
    return next <= horizon ? next : INFINITY;
}

int32_t tinker_block_batch_break_row(const TinkerBlockBatch *batch)
{
    int32_t first = 0;
    for (int32_t i = 1; i < batch->evaluator_count; i++)
        if (batch->pieces[i].next < batch->pieces[first].next) first = i;
    return first % batch->count;
}

double tinker_block_batch_next_pole(const TinkerBlockBatch *batch, int32_t *row)
{
    double next = INFINITY;
    for (int32_t i = 0; i < batch->evaluator_count; i++) {
        if (!(batch->pieces[i].pole < next)) continue;
        next = batch->pieces[i].pole;
        *row = i % batch->count;
    }
    return next;
}
