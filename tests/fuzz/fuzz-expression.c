/* Expressions of time: compiled, evaluated with both derivatives at some times, searched for breaks, shifted. */
#include <math.h>
#include <string.h>

#include "fuzz-target.h"
#include "units/waveform/waveform.h"

static const double times[] = {0, 1e-300, 0.3, 1, 3.5, 1e3, 1e9, -2};

static void check_breaks(TinkerWaveformEvaluator *evaluator)
{
    const double horizon = 4;
    double t = 0;
    for (int i = 0; i < 3; i++) {
        const double next = tinker_waveform_next_break(evaluator, t, horizon);
        if (isinf(next) && next > 0) return;
        if (!(next > t && next <= horizon)) g_error("the break after %.17g is %.17g", t, next);
        t = next;
    }
}

static void evaluate(TinkerWaveformEvaluator *evaluator, double t, double result[3])
{
    tinker_waveform_enter_piece(evaluator, t);
    tinker_waveform_evaluate(evaluator, t, result);
}

/* The same text gives the same bits; the piece's form can be asked for where there is one. */
static void check_values(TinkerWaveformEvaluator *evaluator, TinkerWaveformEvaluator *twin)
{
    const int signals = tinker_waveform_signals(evaluator);
    g_autofree TinkerSignal *form = g_new0(TinkerSignal, MAX(signals, 1));
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++) {
        double one[3] = {0}, other[3] = {0};
        evaluate(evaluator, times[i], one);
        evaluate(twin, times[i], other);
        for (int k = 0; k < 3; k++) {
            if (one[k] != other[k] && !(isnan(one[k]) && isnan(other[k])))
                g_error("at %g derivative %d is %.17g, and %.17g by the text", times[i], k, one[k], other[k]);
        }
        if (signals > 0) tinker_waveform_form(evaluator, times[i], form);
    }
}

static void check_shifted(TinkerWaveform *waveform)
{
    g_autoptr(TinkerWaveform) shifted = tinker_waveform_shifted(waveform, 0.25);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) read = tinker_waveform_new_expression(tinker_waveform_expression(shifted), &error);
    if (read == NULL) g_error("the shifted \"%s\": %s", tinker_waveform_expression(shifted), error->message);
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(shifted, 1, 1, 0, FALSE);
    double result[3];
    evaluate(evaluator, 0.5, result);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    g_autofree char *text = g_strndup((const char *)data, size);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerWaveform) waveform = tinker_waveform_new_expression(text, &error);
    if (waveform == NULL) {
        if (error == NULL || !g_str_has_prefix(error->message, "column ")) g_error("no column in the message");
        if (!g_utf8_validate(error->message, -1, NULL)) g_error("the message is not UTF-8");
        return 0;
    }
    g_autoptr(TinkerWaveform) again = tinker_waveform_new_expression(tinker_waveform_expression(waveform), NULL);
    if (again == NULL) g_error("the text of the waveform does not compile");
    g_autoptr(TinkerWaveformEvaluator) evaluator = tinker_waveform_evaluator_new(waveform, 1, 1, 0, FALSE);
    g_autoptr(TinkerWaveformEvaluator) twin = tinker_waveform_evaluator_new(again, 1, 1, 0, FALSE);
    check_values(evaluator, twin);
    check_breaks(evaluator);
    check_shifted(waveform);
    return 0;
}
