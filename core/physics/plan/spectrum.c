/* The spectrum of an island, and what step of a method it limits. */
#include <math.h>

#include "physics/impulse/impulse.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/spectrum-private.h"
#include "physics/plan/tolerances.h"
#include "physics/system/method-call.h"

static TinkerSpectrum *spectrum_new(void)
{
    TinkerSpectrum *spectrum = g_new0(TinkerSpectrum, 1);
    spectrum->eigenvalues = g_array_new(FALSE, FALSE, sizeof(TinkerEigenvalue));
    spectrum->oscillators = g_array_new(FALSE, FALSE, sizeof(TinkerOscillator));
    return spectrum;
}

void tinker_spectrum_free(TinkerSpectrum *spectrum)
{
    if (spectrum == NULL) return;
    g_array_unref(spectrum->eigenvalues);
    g_array_unref(spectrum->oscillators);
    g_free(spectrum->fastest);
    g_free(spectrum->most_damped);
    g_free((double *)(gpointer)spectrum->coupled.stiffness);
    g_free((double *)(gpointer)spectrum->coupled.damping);
    g_free(spectrum);
}

/* Forces across velocities make frequencies that no stiffness has, and no block's stiffness is to blame for. */
static void add_turning(TinkerSpectrum *spectrum)
{
    double most = 0;
    for (guint i = 0; spectrum->turned && i < spectrum->eigenvalues->len; i++)
        most = fmax(most, g_array_index(spectrum->eigenvalues, TinkerEigenvalue, i).im);
    if (!(most > (1 + TINKER_LEAST_GROWTH) * spectrum->omega_max)) return;
    spectrum->omega_max = most;
    g_clear_pointer(&spectrum->fastest, g_free);
}

TinkerSpectrum *tinker_spectrum_new(const TinkerIsland *island)
{
    TinkerSpectrum *spectrum = spectrum_new();
    g_autoptr(TinkerStartMatrices) matrices = tinker_start_matrices_new(island);
    if (matrices == NULL || tinker_start_matrices_size(matrices) == 0) return spectrum;
    gboolean small = tinker_start_matrices_size(matrices) <= TINKER_DENSE_SPECTRUM;
    spectrum->turned = tinker_start_matrices_turned(matrices);
    int32_t coordinates = tinker_model_sizes(island->model).coordinates;
    if (!(small ? spectrum_fill_dense : spectrum_fill_large)(spectrum, matrices, coordinates)) {
        g_array_set_size(spectrum->eigenvalues, 0);
        g_array_set_size(spectrum->oscillators, 0);
        spectrum->complete = FALSE;
    }
    add_turning(spectrum);
    double fastest = fmax(fmax(spectrum->omega_max, spectrum->damping_max), spectrum->growth_max);
    if (spectrum->growth_max < TINKER_LEAST_GROWTH * fastest) spectrum->growth_max = 0;
    spectrum->coupled.growth = spectrum->growth_max;
    /* what falls over without losses comes back at the same rate */
    if (!tinker_start_matrices_damped(matrices)) spectrum->damping_max = 0;
    if (small) spectrum_find_growth_in_motion(matrices, &spectrum->growth_max);
    return spectrum;
}

/* Each eigenvalue as an oscillator that has it: a pair by its size and its decay, a real one as a damper. */
static GArray *oscillators_of(const GArray *eigenvalues)
{
    GArray *oscillators = g_array_new(FALSE, FALSE, sizeof(TinkerOscillator));
    for (guint i = 0; i < eigenvalues->len; i++) {
        TinkerEigenvalue value = g_array_index(eigenvalues, TinkerEigenvalue, i);
        double re = fmin(value.re, 0);
        TinkerOscillator oscillator = {value.im != 0 ? re * re + value.im * value.im : 0,
                                       value.im != 0 ? -2 * re : -re};
        g_array_append_val(oscillators, oscillator);
    }
    return oscillators;
}

/* Bodies that fall over but for such forces are not held to standing still: what is found of them is a limit, but that
 * nothing is found is not known to be the method's fault. */
static double coupled_stable_step(const TinkerSpectrum *spectrum, const TinkerIntegrator *method,
                                  double spectral_radius)
{
    double stable;
    if (spectrum->coupled.size == 0) return NAN;
    TINKER_CALL_VOID(stable = tinker_coupled_stable_step(method, spectral_radius, &spectrum->coupled), .phase = "step",
                     .method = method);
    return stable == 0 && spectrum->falls ? NAN : stable;
}

double tinker_spectrum_stable_step(const TinkerSpectrum *spectrum, const TinkerIntegrator *method,
                                   double spectral_radius)
{
    method = tinker_method_without_contact(method);
    gboolean splits = (method->flags & TINKER_INTEGRATOR_SYMPLECTIC) != 0;
    if (splits && spectrum->turned) return coupled_stable_step(spectrum, method, spectral_radius);
    g_autoptr(GArray) of_roots = splits ? NULL : oscillators_of(spectrum->eigenvalues);
    const GArray *list = splits ? spectrum->oscillators : of_roots;
    const TinkerOscillator *of_all = (const TinkerOscillator *)(gpointer)list->data;
    double stable;
    TINKER_CALL_VOID(stable = tinker_stable_step_of_all(method, spectral_radius, of_all, list->len), .phase = "step",
                     .method = method);
    return stable;
}
