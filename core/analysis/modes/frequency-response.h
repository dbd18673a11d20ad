/* Frequency response: what a quantity does, in amplitude and phase, where a waveform swings as sin(omega t) with the
 * amplitude 1, once everything else has died away.
 *
 * H(omega) = L (-omega^2 M + i omega C + K)^-1 (B0 + i omega B1) + D on what the constraints allow, in the coordinates
 * of the modes. A support's motion brings with it what is tied to it by constraints, and pulls on the rest through
 * springs and dampers. Source: Ewins, "Modal Testing" (2nd edition, 2000), chapter 2. */
#ifndef TINKER_CORE_FREQUENCY_RESPONSE_H
#define TINKER_CORE_FREQUENCY_RESPONSE_H

#include "analysis/modes/complex-numbers.h"
#include "analysis/modes/modes.h"
#include "physics/linearise/linear-probe.h"

typedef struct _TinkerFrequencyResponse TinkerFrequencyResponse;

/* The response of `output` to `input` for a model linearised about some places. All are borrowed. Errors:
 * TINKER_MODEL_ERROR_RUN. (transfer full) */
TinkerFrequencyResponse *tinker_frequency_response_new(const TinkerLinearisation *linear, const TinkerModalBasis *basis,
                                                       const TinkerLinearInput *input, const TinkerLinearOutput *output,
                                                       GError **error);
void tinker_frequency_response_free(TinkerFrequencyResponse *response);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerFrequencyResponse, tinker_frequency_response_free)

/* H at omega (rad/s). Infinite at the frequency of an undamped mode that is driven. */
double complex tinker_frequency_response_at(TinkerFrequencyResponse *response, double omega);

/* The unit of H, of those of what answers and of what drives: "m/N", "m/(N m)". (transfer full) */
char *tinker_frequency_response_unit(const char *output, const char *input);

/* Frequencies (rad/s, ascending) that show the response from `from` to `to`: `count` of them evenly spread, over their
 * logarithm or not, and more around each mode. (transfer full) */
GArray *tinker_frequency_response_grid(const GPtrArray *modes, double from, double to, int count, gboolean logarithmic);

/* A range (rad/s) that takes in all modes that oscillate. */
void tinker_frequency_response_range(const GPtrArray *modes, double *from, double *to);

typedef struct {
    double omega;      /* rad/s */
    double complex at; /* H there; its absolute value is infinite where the mode is undamped */
} TinkerResponsePeak;

/* The local maxima of |H| over a grid, sharpened between its points; of TinkerResponsePeak, by frequency. (transfer
 * full) */
GArray *tinker_frequency_response_peaks(TinkerFrequencyResponse *response, const GArray *grid);

#endif
