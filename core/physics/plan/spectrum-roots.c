/* What a spectrum is made of: eigenvalues, and oscillators that have them. */
#include <math.h>

#include "physics/plan/spectrum-private.h"

void spectrum_add_eigenvalue(TinkerSpectrum *spectrum, double re, double im)
{
    TinkerEigenvalue value = {re, im};
    g_array_append_val(spectrum->eigenvalues, value);
    spectrum->damping_max = fmax(spectrum->damping_max, -re);
    spectrum->growth_max = fmax(spectrum->growth_max, re);
}

void spectrum_add_oscillator(TinkerSpectrum *spectrum, double stiffness, double damping)
{
    TinkerOscillator oscillator = {stiffness, damping};
    g_array_append_val(spectrum->oscillators, oscillator);
}

void spectrum_add_roots(TinkerSpectrum *spectrum, double stiffness, double damping)
{
    double half = 0.5 * damping, square = half * half - stiffness;
    if (square < 0) {
        spectrum_add_eigenvalue(spectrum, -half, sqrt(-square));
        return;
    }
    if (half == 0 && stiffness < 0) {
        spectrum_add_eigenvalue(spectrum, sqrt(square), 0); /* its mirror image is no loss, and limits nothing */
        return;
    }
    double far = half >= 0 ? -half - sqrt(square) : -half + sqrt(square);
    spectrum_add_eigenvalue(spectrum, far, 0);
    spectrum_add_eigenvalue(spectrum, far != 0 ? stiffness / far : 0, 0);
}

double spectrum_mixture_step(double stiffness, double damping, int number)
{
    if (number == SPECTRUM_MIXTURES) return INFINITY;
    double edge = fmin(stiffness > 0 ? 2 / sqrt(stiffness) : INFINITY, damping > 0 ? 2 / damping : INFINITY);
    return edge * (0.4 + 0.6 * number / (SPECTRUM_MIXTURES - 1));
}
