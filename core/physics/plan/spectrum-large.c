/* Large islands: extreme values by Lanczos and Arnoldi iterations. */
#include <math.h>

#include "numerics/solve/eigen.h"
#include "numerics/solve/lapack.h"
#include "physics/plan/spectrum-private.h"

/* Of the iterations: residuals relative to the eigenvalue. */
#define LARGE_TOLERANCE 1e-2
#define MOST_PRODUCTS   300
#define WANTED          6

/* first * K + second * C, or the state matrix. */
typedef struct {
    TinkerStartMatrices *matrices;
    gsize n;
    double first, second;
    double scale; /* s of the state matrix */
    double *room;
} Large;

static void mixed_product(void *data, const double *x, double *y)
{
    Large *large = data;
    tinker_start_matrices_stiffness(large->matrices, x, y);
    if (large->second == 0) return;
    tinker_start_matrices_damping(large->matrices, x, large->room);
    for (gsize i = 0; i < large->n; i++)
        y[i] = large->first * y[i] + large->second * large->room[i];
}

static void state_product(void *data, const double *x, double *y)
{
    Large *large = data;
    const double *velocity = x + large->n;
    tinker_start_matrices_stiffness(large->matrices, x, y + large->n);
    tinker_start_matrices_damping(large->matrices, velocity, large->room);
    for (gsize i = 0; i < large->n; i++) {
        y[i] = large->scale * velocity[i];
        y[large->n + i] = -y[large->n + i] / large->scale - large->room[i];
    }
}

/* The largest eigenvalue, and into x its vector; where the iteration did not settle, from below and without one. */
static double largest_of(Large *large, TinkerOperator product, void *data, double *x, gboolean *settled)
{
    double value = 0;
    TinkerSpectralMeasure measure;
    int32_t n = (int32_t)large->n;
    *settled = tinker_lanczos_largest(n, product, data, MOST_PRODUCTS, LARGE_TOLERANCE, &value, x);
    if (*settled) return value;
    for (int32_t i = 0; i < n; i++)
        x[i] = 1.0 + 0.5 * sin(12.9898 * (i + 1));
    int32_t count = tinker_spectral_measure(n, TINKER_MOST_NODES, product, NULL, data, x, &measure);
    return count > 0 ? measure.nodes[count - 1] : NAN;
}

static double quadratic(Large *large, TinkerOperator product, const double *x)
{
    double sum = 0;
    product(large->matrices, x, large->room);
    for (gsize i = 0; i < large->n; i++)
        sum += x[i] * large->room[i];
    return sum;
}

static void add_large_mixtures(TinkerSpectrum *spectrum, Large *large, double stiffness, double damping, double *x)
{
    for (int number = 0; number <= SPECTRUM_MIXTURES; number++) {
        gboolean settled;
        double inverse = 1 / spectrum_mixture_step(stiffness, damping, number);
        large->first = 1;
        large->second = 2 * inverse;
        largest_of(large, mixed_product, large, x, &settled);
        if (settled)
            spectrum_add_oscillator(spectrum, quadratic(large, tinker_start_matrices_stiffness, x),
                                    quadratic(large, tinker_start_matrices_damping, x));
    }
    spectrum_add_oscillator(spectrum, stiffness, 0);
}

static void add_large_state(TinkerSpectrum *spectrum, Large *large)
{
    double re[WANTED + 1], im[WANTED + 1];
    int32_t found = tinker_arnoldi_largest(2 * (int32_t)large->n, WANTED, state_product, large, MOST_PRODUCTS,
                                           LARGE_TOLERANCE, re, im);
    for (int32_t i = 0; i < found; i++)
        if (im[i] >= 0) spectrum_add_eigenvalue(spectrum, re[i], im[i]);
    for (guint i = 0; found == 0 && i < spectrum->oscillators->len; i++) {
        TinkerOscillator oscillator = g_array_index(spectrum->oscillators, TinkerOscillator, i);
        spectrum_add_roots(spectrum, oscillator.stiffness, oscillator.damping);
    }
}

gboolean spectrum_fill_large(TinkerSpectrum *spectrum, TinkerStartMatrices *matrices, int32_t coordinates)
{
    gsize n = (gsize)tinker_start_matrices_size(matrices);
    g_autofree double *room = g_new0(double, n), *x = g_new0(double, n);
    Large large = {matrices, n, 1, 0, 1, room};
    gboolean settled;
    double stiffness = largest_of(&large, tinker_start_matrices_stiffness, matrices, x, &settled), damping = 0;
    if (!isfinite(stiffness)) return FALSE;
    spectrum->omega_max = sqrt(fmax(stiffness, 0));
    spectrum->fastest = g_new0(double, coordinates);
    tinker_start_matrices_shape(matrices, x, spectrum->fastest);
    if (!tinker_start_matrices_damped(matrices)) {
        spectrum_add_oscillator(spectrum, stiffness, 0);
        spectrum_add_roots(spectrum, stiffness, 0);
        return TRUE;
    }
    damping = largest_of(&large, tinker_start_matrices_damping, matrices, x, &settled);
    if (!isfinite(damping)) return FALSE;
    spectrum->most_damped = g_new0(double, coordinates);
    tinker_start_matrices_shape(matrices, x, spectrum->most_damped);
    add_large_mixtures(spectrum, &large, stiffness, damping, x);
    large.scale = fmax(spectrum->omega_max, damping);
    add_large_state(spectrum, &large);
    return TRUE;
}
