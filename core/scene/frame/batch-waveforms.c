/* The three columns of each waveform property are filled by evaluators, one for every block, built from the block's own
 * amplitude, frequency and phase. Behind them are those of what t alone switches in typed laws: the laws look at t
 * themselves, so that in every piece they are given times within it. */
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

static void add_evaluator(TinkerBlockBatch *batch, int32_t row, TinkerWaveformEvaluator *evaluator)
{
    const int32_t next = batch->evaluator_count++;
    batch->evaluators[next] = evaluator;
    batch->evaluator_rows[next] = row;
    batch->pieces[next] = (struct _TinkerPiece){NAN, NAN, NAN, INFINITY, FALSE};
}

static void make_room(TinkerBlockBatch *batch, int32_t evaluators)
{
    batch->evaluators = g_renew(TinkerWaveformEvaluator *, batch->evaluators, evaluators);
    batch->evaluator_rows = g_renew(int32_t, batch->evaluator_rows, evaluators);
    batch->pieces = g_renew(struct _TinkerPiece, batch->pieces, evaluators);
}

static void add_evaluators(TinkerBlockBatch *batch, int32_t property)
{
    const TinkerPropertyType *type = &batch->block_class->properties[property];
    gboolean smooth = drives_a_place(batch->block_class);
    for (int32_t row = 0; row < batch->count; row++) {
        TinkerWaveform *waveform = tinker_scene_get_waveform(batch->scene, batch->ids[row], property);
        TinkerWaveformEvaluator *evaluator = tinker_waveform_evaluator_new(
            waveform, column_or(batch, type->amplitude, row, 1.0), column_or(batch, type->frequency, row, 0.0),
            column_or(batch, type->phase, row, 0.0), smooth);
        add_evaluator(batch, row, evaluator);
    }
}

void tinker_block_batch_copy_waveforms(TinkerBlockBatch *batch)
{
    const TinkerBlockClass *block_class = batch->block_class;
    for (int32_t property = 0; property < block_class->property_count; property++)
        batch->waveforms += block_class->properties[property].kind == TINKER_KIND_WAVEFORM;
    if (batch->waveforms == 0) return;
    batch->waveform_columns = g_new0(int32_t, batch->waveforms);
    make_room(batch, batch->waveforms * batch->count);
    for (int32_t property = 0, number = 0; property < block_class->property_count; property++) {
        if (block_class->properties[property].kind != TINKER_KIND_WAVEFORM) continue;
        batch->waveform_columns[number++] = block_class->first_columns[property];
        add_evaluators(batch, property);
    }
}

static int32_t waveform_evaluators(const TinkerBlockBatch *batch)
{
    return batch->waveforms * batch->count;
}

void tinker_block_batch_add_switches(TinkerBlockBatch *batch, int32_t row, TinkerWaveform *switches)
{
    const int32_t laws = batch->evaluator_count - waveform_evaluators(batch);
    if ((laws & (laws - 1)) == 0) make_room(batch, batch->evaluator_count + MAX(laws, 1));
    add_evaluator(batch, row, tinker_waveform_evaluator_new(switches, 1, 0, 0, FALSE));
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

void tinker_block_batch_bound_laws(TinkerBlockBatch *batch, double from, double to)
{
    if (batch->evaluator_count == waveform_evaluators(batch)) return;
    batch->earliest = isfinite(from) ? from + tinker_time_beside(from, to - from) : from;
    batch->latest = isfinite(to) ? to - tinker_time_beside(to, to - from) : to;
    if (batch->earliest > batch->latest) batch->earliest = batch->latest = from + 0.5 * (to - from);
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

static void search_from(TinkerBlockBatch *batch, int32_t i, double t, double horizon)
{
    const TinkerWaveformEvaluator *evaluator = batch->evaluators[i];
    const double next = tinker_waveform_next_break(evaluator, t, horizon);
    /* a part of a law may have a pole where the law has none */
    const double pole =
        i < waveform_evaluators(batch) ? tinker_waveform_next_pole(evaluator, t, fmin(next, horizon)) : INFINITY;
    batch->pieces[i] = (struct _TinkerPiece){t, next, horizon, pole, FALSE};
}

double tinker_block_batch_next_break(TinkerBlockBatch *batch, double t, double horizon)
{
    double next = INFINITY;
    for (int32_t i = 0; i < batch->evaluator_count; i++) {
        struct _TinkerPiece *piece = &batch->pieces[i];
        gboolean known = piece->from <= t && t < piece->next && (isfinite(piece->next) || horizon <= piece->horizon);
        if (!known) search_from(batch, i, t, horizon);
        next = MIN(next, piece->next);
    }
    return next <= horizon ? next : INFINITY;
}

void tinker_block_batch_enter_behind(TinkerBlockBatch *batch, double t)
{
    const double next = tinker_block_batch_next_break(batch, t, t + 1.0);
    tinker_block_batch_enter_piece(batch, tinker_time_inside(t, next));
    tinker_block_batch_bound_laws(batch, t, next);
}

double tinker_block_batch_time_behind(TinkerBlockBatch *batch, double t)
{
    const double beside = tinker_time_beside(t, 1);
    return isfinite(tinker_block_batch_next_break(batch, t - beside, t + beside)) ? t + beside : t;
}

int32_t tinker_block_batch_break_row(const TinkerBlockBatch *batch)
{
    int32_t first = 0;
    for (int32_t i = 1; i < batch->evaluator_count; i++)
        if (batch->pieces[i].next < batch->pieces[first].next) first = i;
    return batch->evaluator_rows[first];
}

double tinker_block_batch_next_pole(const TinkerBlockBatch *batch, int32_t *row)
{
    double next = INFINITY;
    for (int32_t i = 0; i < batch->evaluator_count; i++) {
        if (!(batch->pieces[i].pole < next)) continue;
        next = batch->pieces[i].pole;
        *row = batch->evaluator_rows[i];
    }
    return next;
}
