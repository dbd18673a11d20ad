/* Amplitude spectra by the fast Fourier transform (KissFFT, in single precision: what is below a millionth of the
 * largest amplitude is rounding). */
#ifndef TINKER_CORE_MEASURE_SPECTRUM_H
#define TINKER_CORE_MEASURE_SPECTRUM_H

#include <glib.h>

typedef enum {
    TINKER_WINDOW_RECTANGULAR, /* none: exact where the curve has whole periods in the interval */
    TINKER_WINDOW_HANN,        /* sin^2: lines are wider, and leak little */
} TinkerWindow;

/* The amplitudes (of sines, in the unit of the values) at the frequencies k / (count * step), in Hz, k from 0 to count
 * / 2, of a curve sampled evenly every `step` seconds, its mean taken away. `count` is even. `amplitudes` has room for
 * count / 2 + 1. FALSE where there is no memory. */
gboolean tinker_spectrum(const double *values, gsize count, TinkerWindow window, double *amplitudes);

/* The spectrum of a curve given by samples at rising times between `from` and `to` (s): of those that follow the first
 * of them at even spacing, but for as few at the end as make their number even and quick to transform. Frequencies (Hz)
 * and amplitudes, double, take the place of what the arrays hold. FALSE, and empty arrays, where there are fewer than
 * four such samples, or no memory. */
gboolean tinker_spectrum_of_curve(const double *times, const double *values, gsize count, double from, double to,
                                  TinkerWindow window, GArray *frequencies, GArray *amplitudes);

#endif
