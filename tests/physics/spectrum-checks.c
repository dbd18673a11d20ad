#include "spectrum-checks.h"

#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/compile/compile.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

SpectrumCase spectrum_case(const char *blocks)
{
    g_autoptr(GError) error = NULL;
    SpectrumCase compiled = {.scene = physics_scene(NULL, blocks)};
    compiled.model = tinker_model_new(compiled.scene, &error);
    if (compiled.model != NULL) compiled.islands = tinker_islands_new(compiled.model, &error);
    if (compiled.islands == NULL) g_error("%s", error->message);
    return compiled;
}

void spectrum_case_clear(SpectrumCase *compiled)
{
    g_ptr_array_unref(compiled->islands);
    tinker_model_free(compiled->model);
    tinker_scene_free(compiled->scene);
}

const TinkerIsland *spectrum_case_island(const SpectrumCase *compiled)
{
    return g_ptr_array_index(compiled->islands, 0);
}

double spectrum_limit(const TinkerSpectrum *spectrum, const TinkerIntegrator *method)
{
    return tinker_spectrum_stable_step(spectrum, method, 0.8);
}

/* The largest departure from the start, in some steps of h from step number `from` on. */
static double largest_departure(const TinkerIntegrator *method, void *stepper, TinkerState *state, const double *start,
                                int32_t n, double h, double rate, int from)
{
    double largest = 0;
    for (int i = from + 1; i <= from + 1000; i++) {
        TinkerStepReport report = {.struct_size = sizeof report};
        if (method->step(stepper, state, i * h, &report) != TINKER_OK) return INFINITY;
        double size = 0;
        for (int32_t k = 0; k < n; k++)
            size = fmax(size, fmax(rate * fabs(state->q[k] - start[k]), fabs(state->v[k])));
        if (!isfinite(size) || size > 1e-3 * rate) return INFINITY;
        if (size < 1e-12 * rate) return 0; /* died down to rounding of the places */
        largest = fmax(largest, size);
    }
    return largest;
}

/* Whether the motion that begins with small velocities of every shape still grows after some hundred steps of h. The
 * start is at rest and in balance. */
static gboolean grows(const TinkerIsland *island, const TinkerIntegrator *method, double h, double rate)
{
    TinkerModelSystem system;
    tinker_model_system_init(&system, island->model, island->linear);
    int32_t n = system.system.size;
    g_autofree double *start = g_new0(double, n), *q = g_new0(double, n), *v = g_new0(double, n);
    g_autofree double *books = g_new0(double, TINKER_BOOK_COUNT), *room = g_new0(double, n);
    if (island->linear != NULL)
        tinker_linear_form_reduce(island->linear, island->model->q_start, island->model->v_start, start, room);
    else
        memcpy(start, island->model->q_start, (gsize)n * sizeof(double));
    memcpy(q, start, (gsize)n * sizeof(double));
    for (int32_t i = 0; i < n; i++)
        v[i] = 1e-7 * rate * sin(1.7 * i + 0.3);
    TinkerIntegratorOptions options = {.struct_size = sizeof options, .tolerance = 1e-9, .spectral_radius = 0.8};
    void *stepper = method->create(&system.system, &options);
    g_assert_nonnull(stepper);
    TinkerState state = {0, q, v, books};
    /* the first steps are left out: what was not in balance settles there */
    double sizes[4] = {largest_departure(method, stepper, &state, start, n, h, rate, 0)};
    for (int part = 1; part < 4; part++) {
        gboolean over = sizes[part - 1] == 0 || !isfinite(sizes[part - 1]);
        sizes[part] =
            over ? sizes[part - 1] : largest_departure(method, stepper, &state, start, n, h, rate, 1000 * part);
    }
    method->destroy(stepper);
    tinker_model_system_clear(&system);
    return !isfinite(sizes[3]) || sizes[3] > 1.15 * sizes[1];
}

void spectrum_assert_limit(const TinkerIsland *island, const TinkerSpectrum *spectrum, const TinkerIntegrator *method,
                           double rate, const char *what)
{
    double limit = spectrum_limit(spectrum, method);
    g_assert_cmpfloat(limit, >, 0);
    if (grows(island, method, 0.95 * fmin(limit, 1e3 / rate), rate))
        g_test_fail_printf("%s: %s grows at 0.95 of the forecast limit %g s", what, method->id, limit);
    if (isfinite(limit) && !grows(island, method, 1.05 * limit, rate))
        g_test_fail_printf("%s: %s does not grow at 1.05 of the forecast limit %g s", what, method->id, limit);
}

void spectrum_assert_limits(const TinkerIsland *island, const TinkerSpectrum *spectrum, double rate, const char *what)
{
    int seen = 0;
    for (const TinkerIntegrator *const *each = tinker_integrator_builtins(); *each != NULL; each++) {
        if (!tinker_method_is_fixed_explicit(*each)) continue;
        spectrum_assert_limit(island, spectrum, *each, rate, what);
        seen++;
    }
    g_assert_cmpint(seen, >=, 3);
}

char *spectrum_chain(int count, double mass, double stiffness, double damping, int every)
{
    GString *text = g_string_new("{'type': 'support'}");
    for (int i = 0; i < count; i++)
        g_string_append_printf(text, ",{'type': 'mass', 'mass': %.17g, 'position': [%d, 0]}", mass, i + 1);
    g_string_append_printf(text, ",{'type': 'support', 'position': [%d, 0]}", count + 1);
    for (int i = 0; i <= count; i++) {
        g_autofree char *a = i == 0 ? g_strdup("Support 0") : g_strdup_printf("Mass %d", i - 1);
        g_autofree char *b = i == count ? g_strdup("Support 1") : g_strdup_printf("Mass %d", i);
        g_string_append_printf(text, ",{'type': 'spring', 'ends': ['%s', '%s'], 'stiffness': %.17g, 'rest_length': 1}",
                               a, b, stiffness);
        if (damping > 0 && i % every == 0)
            g_string_append_printf(text, ",{'type': 'damper', 'ends': ['%s', '%s'], 'damping': %.17g}", a, b, damping);
    }
    return g_string_free(text, FALSE);
}
