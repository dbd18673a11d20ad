/* What waveforms of driven forces are, as sums of signals. */
#include "physics/line/linear-form-data.h"

#include <math.h>

int32_t tinker_driven_column(const TinkerDrivenForce *driven)
{
    for (int32_t column = 0; column < driven->batch->block_class->column_count; column++)
        if (driven->value == &driven->batch->columns[column][driven->row]) return column;
    return -1;
}

double tinker_driven_steady(const TinkerDrivenForce *driven)
{
    const TinkerWaveformEvaluator *evaluator =
        tinker_block_batch_evaluator(driven->batch, tinker_driven_column(driven), driven->row);
    int signals = evaluator != NULL ? tinker_waveform_signals(evaluator) : 0;
    double steady = 0;
    if (signals == 0) return 0;
    g_autofree TinkerSignal *forms = g_new(TinkerSignal, signals);
    tinker_waveform_form(evaluator, 0.0, forms);
    for (int i = 0; i < signals; i++) {
        const double *c = forms[i].coefficient;
        if (forms[i].kind == TINKER_SIGNAL_POLYNOMIAL) steady += c[0];
        if (forms[i].kind == TINKER_SIGNAL_HARMONIC && c[1] == 0) steady += c[0] * sin(c[2]);
    }
    return steady;
}
