/* The three columns of each waveform property are filled by evaluators, one for every block, built from the block's own
 * amplitude, frequency and phase. Behind them are those of what t alone switches in typed laws: the laws look at t
 * themselves, so that in every piece they are given times within it. */
#include <math.h>

#include <float.h>

#include "scene/frame/batch-waveforms.h"
#include "units/waveform/waveform-pole.h"

/* A law that is worked out nearer to a break than this many roundings of t may be that of the other side. */
#define ROUNDINGS 8
#define AT_ORIGIN 1e-18 /* s */

/* No break of a waveform lies between `from` and `next`, and none up to `horizon` where next is infinite; the first
 * pole there, INFINITY for none. */
struct _TinkerPiece {
    double from, next, horizon, pole;
    double begin;     /* the break that it begins at, as far as is known; -INFINITY for none */
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
    batch->pieces[next] = (struct _TinkerPiece){NAN, NAN, NAN, INFINITY, -INFINITY, FALSE};
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

/* s: so many roundings of t, or at the origin of time next to nothing. */
static double beside(double t)
{
    return fmax(ROUNDINGS * DBL_EPSILON * fabs(t), AT_ORIGIN);
}

/* Within the pieces of all laws that contain `inside`. */
static void find_inside(TinkerBlockBatch *batch, double inside)
{
    double begin = -INFINITY, end = INFINITY;
    for (int32_t i = waveform_evaluators(batch); i < batch->evaluator_count; i++) {
        const struct _TinkerPiece *piece = &batch->pieces[i];
        if (piece->begin < inside) begin = fmax(begin, piece->next <= inside ? piece->next : piece->begin);
        if (piece->next > inside) end = fmin(end, piece->begin >= inside ? piece->begin : piece->next);
    }
    const double earliest = isfinite(begin) ? begin + beside(begin) : begin;
    const double latest = isfinite(end) ? end - beside(end) : end;
    batch->earliest = fmin(earliest, inside);
    batch->latest = fmax(latest, inside);
}

void tinker_block_batch_enter_piece(TinkerBlockBatch *batch, double inside)
{
    for (int32_t i = 0; i < batch->evaluator_count; i++) {
        struct _TinkerPiece *piece = &batch->pieces[i];
        if (piece->entered && piece->from < inside && inside < piece->next) continue;
        piece->entered = TRUE;
        tinker_waveform_enter_piece(batch->evaluators[i], inside);
    }
    if (batch->evaluator_count > waveform_evaluators(batch)) find_inside(batch, inside);
}

/* What was known before a search from t says where the piece of t began. */
static double begin_of(const struct _TinkerPiece *before, double t)
{
    if (isnan(before->from)) return t; /* all begins here */
    if (t >= before->next) return before->next;
    return t >= before->begin ? before->begin : -INFINITY;
}

static void search_from(TinkerBlockBatch *batch, int32_t i, double t, double horizon)
{
    const TinkerWaveformEvaluator *evaluator = batch->evaluators[i];
    const double next = tinker_waveform_next_break(evaluator, t, horizon), begin = begin_of(&batch->pieces[i], t);
    /* a part of a law may have a pole where the law has none */
    const double pole =
        i < waveform_evaluators(batch) ? tinker_waveform_next_pole(evaluator, t, fmin(next, horizon)) : INFINITY;
    batch->pieces[i] = (struct _TinkerPiece){t, next, horizon, pole, begin, FALSE};
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
