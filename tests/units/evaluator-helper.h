/* What the tests of waveforms share: making an evaluator of a text, and one value of it. */
#ifndef EVALUATOR_HELPER_H
#define EVALUATOR_HELPER_H

#include "units/waveform/waveform.h"

static inline TinkerWaveformEvaluator *evaluator_of(const char *text)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(text, &error);
    g_assert_no_error(error);
    g_assert_nonnull(waveform);
    return tinker_waveform_evaluator_new(waveform, 1, 1, 0, FALSE);
}

/* Value and derivatives at t, a time inside a piece. */
static inline void evaluate_inside(const char *text, double t, double result[3])
{
    g_autoptr(TinkerWaveformEvaluator) evaluator = evaluator_of(text);
    tinker_waveform_enter_piece(evaluator, t);
    tinker_waveform_evaluate(evaluator, t, result);
}

#endif
