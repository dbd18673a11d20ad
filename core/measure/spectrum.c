/* With weights w the amplitude of a line is 2 |X_k| / sum(w); of the mean and of half the rate of sampling half that.
 */
#include "measure/spectrum.h"

#include <kissfft/kiss_fftr.h>
#include <math.h>

#define LEAST_SAMPLES  4
#define LARGEST_FACTOR 100  /* of the number of samples: the time to transform them goes with it */
#define UNEVEN         1e-6 /* of the spacing: what is farther from its place is not of the row */

gboolean tinker_spectrum(const double *values, gsize count, TinkerWindow window, double *amplitudes)
{
    g_assert(count % 2 == 0 && count > 0 && count <= G_MAXINT);
    double mean = 0, largest = 0, weights = 0;
    for (gsize i = 0; i < count; i++)
        mean += values[i] / (double)count;
    for (gsize i = 0; i < count; i++)
        largest = fmax(largest, fabs(values[i] - mean));
    kiss_fftr_cfg plan = kiss_fftr_alloc((int)count, 0, NULL, NULL);
    g_autofree float *in = g_try_new(float, count);
    g_autofree kiss_fft_cpx *out = g_try_new(kiss_fft_cpx, count / 2 + 1);
    const gboolean good = plan != NULL && in != NULL && out != NULL;
    for (gsize i = 0; good && i < count; i++) {
        const double s = sin(G_PI * (double)i / (double)count), w = window == TINKER_WINDOW_HANN ? s * s : 1;
        in[i] = largest > 0 ? (float)(w * (values[i] - mean) / largest) : 0;
        weights += w;
    }
    if (good) kiss_fftr(plan, in, out);
    for (gsize k = 0; good && k <= count / 2; k++) {
        const double share = k == 0 || k == count / 2 ? 1 : 2;
        amplitudes[k] = share * largest * hypot((double)out[k].r, (double)out[k].i) / weights;
    }
    kiss_fftr_free(plan);
    return good;
}

/* How many samples from the first on are evenly spaced and not later than `to`. */
static gsize count_even(const double *times, gsize count, double to)
{
    gsize even = MIN(count, 1);
    while (even < count && times[even] <= to) {
        const double step = times[1] - times[0];
        if (!(fabs(times[even] - times[0] - (double)even * step) <= UNEVEN * step)) break;
        even++;
    }
    return even;
}

static gboolean is_quick(gsize count)
{
    for (gsize factor = 2; factor <= LARGEST_FACTOR; factor++)
        while (count % factor == 0)
            count /= factor;
    return count == 1;
}

gboolean tinker_spectrum_of_curve(const double *times, const double *values, gsize count, double from, double to,
                                  TinkerWindow window, GArray *frequencies, GArray *amplitudes)
{
    gsize first = 0;
    g_array_set_size(frequencies, 0);
    g_array_set_size(amplitudes, 0);
    while (first < count && times[first] < from)
        first++;
    gsize even = MIN(count_even(times + first, count - first, to), G_MAXINT);
    for (even -= even % 2; even >= LEAST_SAMPLES && !is_quick(even);)
        even -= 2;
    if (even < LEAST_SAMPLES) return FALSE;
    const double step = times[first + 1] - times[first];
    g_array_set_size(amplitudes, (guint)(even / 2 + 1));
    if (!tinker_spectrum(values + first, even, window, (double *)(gpointer)amplitudes->data)) {
        g_array_set_size(amplitudes, 0);
        return FALSE;
    }
    for (gsize k = 0; k <= even / 2; k++) {
        const double frequency = (double)k / ((double)even * step);
        g_array_append_val(frequencies, frequency);
    }
    return TRUE;
}
