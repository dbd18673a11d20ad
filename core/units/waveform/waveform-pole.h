/* Poles of waveforms. */
#ifndef TINKER_WAVEFORM_POLE_H
#define TINKER_WAVEFORM_POLE_H

#include "units/waveform/waveform.h"

/* The first time after t and not after `end` at which the value has no finite limit, or behind which it is no number: a
 * pole (1/t, tan), a logarithm of 0, the edge of where sqrt, asin or acos are defined; INFINITY where none is found.
 * There is no break between t and `end`. Places are found as breaks are, to about 4 ulp, a divisor that only touches 0
 * to the root of that; places at which the value has a limit (sin(t)/t at 0) count as none. The work is bounded: what
 * is not searched by then counts as free of them. */
double tinker_waveform_next_pole(const TinkerWaveformEvaluator *evaluator, double t, double end);

#endif
