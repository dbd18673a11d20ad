/* What of a waveform is there all the time: the rest varies about it, or comes later. */
#include <math.h>

#include "units/waveform/waveform.h"

double tinker_waveform_steady(const TinkerWaveformEvaluator *evaluator)
{
    const int count = tinker_waveform_signals(evaluator);
    g_autofree TinkerSignal *signals = g_new0(TinkerSignal, MAX(count, 1));
    double steady = 0;
    if (count > 0) tinker_waveform_form(evaluator, 0, signals);
    for (int i = 0; i < count; i++) {
        const double *c = signals[i].coefficient;
        if (signals[i].kind == TINKER_SIGNAL_HARMONIC)
            steady += c[1] == 0 ? c[0] * sin(c[2]) : 0; /* one that does not swing is a constant */
        else
            steady += c[0]; /* of the powers of t, about t = 0 */
    }
    return steady;
}
