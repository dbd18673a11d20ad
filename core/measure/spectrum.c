/* With weights w the amplitude of a line is 2 |X_k| / sum(w); of the mean and of half the rate of sampling half that.
 */
#include "measure/spectrum.h"

#include <kissfft/kiss_fftr.h>
#include <math.h>

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
