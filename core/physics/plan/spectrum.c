/* Small islands: K and C projected on a basis of the tangent space. Where K and C commute (no damping, or
 * damping in proportion) they have common shapes, and each is a damped oscillator of its own. Large ones: extreme
 * values by Lanczos and Arnoldi iterations. */
#include "physics/plan/spectrum.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/eigen.h"
#include "numerics/solve/lapack.h"
#include "physics/impulse/impulse.h"
#include "physics/model/model.h"
#include "physics/plan/islands.h"
#include "physics/plan/start-matrices.h"
#include "physics/system/method-call.h"

#define COMMUTES  1e-10
#define SYMMETRIC 1e-9
/* Growth below this share of the fastest rate is rounding: of bodies that nothing holds. */
#define LEAST_GROWTH 1e-6
/* Of the large iterations: residuals relative to the eigenvalue. */
#define LARGE_TOLERANCE 1e-2
#define MOST_PRODUCTS   300
#define WANTED          6
/* Coordinates up to which a matrix that is not symmetric, twice as large, is worth all its eigenvalues. */
#define MOST_STATES 60
/* Shapes between that of the largest stiffness and that of the largest damping. */
#define MIXTURES 5

static void add_eigenvalue(TinkerSpectrum *spectrum, double re, double im)
{
    TinkerEigenvalue value = {re, im};
    g_array_append_val(spectrum->eigenvalues, value);
    spectrum->damping_max = fmax(spectrum->damping_max, -re);
    spectrum->growth_max = fmax(spectrum->growth_max, re);
}

static void add_oscillator(TinkerSpectrum *spectrum, double stiffness, double damping)
{
    TinkerOscillator oscillator = {stiffness, damping};
    g_array_append_val(spectrum->oscillators, oscillator);
}

/* The roots of s^2 + damping s + stiffness. */
static void add_roots(TinkerSpectrum *spectrum, double stiffness, double damping)
{
    double half = 0.5 * damping, square = half * half - stiffness;
    if (square < 0) {
        add_eigenvalue(spectrum, -half, sqrt(-square));
        return;
    }
    if (half == 0 && stiffness < 0) {
        add_eigenvalue(spectrum, sqrt(square), 0); /* its mirror image is no loss, and limits nothing */
        return;
    }
    double far = half >= 0 ? -half - sqrt(square) : -half + sqrt(square);
    add_eigenvalue(spectrum, far, 0);
    add_eigenvalue(spectrum, far != 0 ? stiffness / far : 0, 0);
}

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

/* Dense ------------------------------------------------------------------------------------------------------------ */

/* An island's matrices over a basis of its tangent space, m by m. */
typedef struct {
    TinkerStartMatrices *matrices;
    gsize n, m;
    double *basis;               /* n by m */
    double *stiffness, *damping; /* as they are */
    double greatest[2];          /* entries in size */
} Dense;

static void dense_clear(Dense *dense)
{
    g_free(dense->basis);
    g_free(dense->stiffness);
    g_free(dense->damping);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Dense, dense_clear)

/* basis^T (product of the basis' vectors); answers the largest entry, NAN where one is not finite. */
static double over_basis(const Dense *dense, TinkerOperator product, double *out)
{
    g_autofree double *y = g_new0(double, MAX(dense->n, 1));
    double greatest = 0, sum = 0;
    for (gsize j = 0; j < dense->m; j++) {
        product(dense->matrices, dense->basis + j * dense->n, y);
        for (gsize i = 0; i < dense->m; i++) {
            double entry = 0;
            for (gsize k = 0; k < dense->n; k++)
                entry += dense->basis[i * dense->n + k] * y[k];
            out[j * dense->m + i] = entry;
            greatest = fmax(greatest, fabs(entry));
            sum += 0 * entry;
        }
    }
    return sum == 0 ? greatest : NAN;
}

static gboolean dense_open(Dense *dense, TinkerStartMatrices *matrices)
{
    gsize n = (gsize)tinker_start_matrices_size(matrices);
    *dense = (Dense){.matrices = matrices, .n = n, .basis = g_new0(double, MAX(n * n, 1))};
    int32_t tangents = tinker_start_matrices_tangents(matrices, dense->basis);
    if (tangents < 0) return FALSE;
    dense->m = (gsize)tangents;
    dense->stiffness = g_new0(double, MAX(dense->m * dense->m, 1));
    dense->damping = g_new0(double, MAX(dense->m * dense->m, 1));
    dense->greatest[0] = over_basis(dense, tinker_start_matrices_free_stiffness, dense->stiffness);
    dense->greatest[1] = over_basis(dense, tinker_start_matrices_free_damping, dense->damping);
    return isfinite(dense->greatest[0]) && isfinite(dense->greatest[1]);
}

/* first * the symmetric part of `a` + second * that of b. */
static double *mixture(const Dense *dense, double first, const double *a, double second, const double *b)
{
    double *out = g_new0(double, MAX(dense->m * dense->m, 1));
    for (gsize i = 0; i < dense->m; i++)
        for (gsize j = 0; j < dense->m; j++) {
            gsize there = j * dense->m + i, back = i * dense->m + j;
            out[there] = 0.5 * (first * (a[there] + a[back]) + second * (b[there] + b[back]));
        }
    return out;
}

static gboolean is_symmetric(const Dense *dense, const double *a, double greatest)
{
    for (gsize i = 0; i < dense->m; i++)
        for (gsize j = 0; j < i; j++)
            if (fabs(a[j * dense->m + i] - a[i * dense->m + j]) > SYMMETRIC * greatest) return FALSE;
    return TRUE;
}

/* x . A x. */
static double form(const Dense *dense, const double *a, const double *x)
{
    double sum = 0;
    for (gsize j = 0; j < dense->m; j++)
        for (gsize i = 0; i < dense->m; i++)
            sum += x[i] * a[j * dense->m + i] * x[j];
    return sum;
}

/* K C = C K, to rounding. */
static gboolean commute(const Dense *dense)
{
    if (dense->greatest[0] == 0 || dense->greatest[1] == 0) return TRUE;
    const double *k = dense->stiffness, *c = dense->damping;
    double bound = COMMUTES * dense->greatest[0] * dense->greatest[1];
    for (gsize i = 0; i < dense->m; i++)
        for (gsize j = 0; j < dense->m; j++) {
            double difference = 0;
            for (gsize l = 0; l < dense->m; l++)
                difference += k[l * dense->m + i] * c[j * dense->m + l] - c[l * dense->m + i] * k[j * dense->m + l];
            if (fabs(difference) > bound) return FALSE;
        }
    return TRUE;
}

/* Displacements of a vector over the basis. */
static double *shape_of(const Dense *dense, const double *x, int32_t coordinates)
{
    g_autofree double *sum = g_new0(double, MAX(dense->n, 1));
    double *shape = g_new0(double, MAX(coordinates, 1));
    for (gsize j = 0; j < dense->m; j++)
        for (gsize i = 0; i < dense->n; i++)
            sum[i] += x[j] * dense->basis[j * dense->n + i];
    tinker_start_matrices_shape(dense->matrices, sum, shape);
    return shape;
}

/* Common shapes of commuting matrices: those of a mixture in which no two different pairs fall together. */
static gboolean add_common_shapes(TinkerSpectrum *spectrum, const Dense *dense)
{
    const double share = 0.3819660112501051; /* irrational, to the word length */
    gboolean both = dense->greatest[0] > 0 && dense->greatest[1] > 0;
    double first = both ? 1 / dense->greatest[0] : 1, second = both ? share / dense->greatest[1] : 1;
    g_autofree double *vectors = mixture(dense, first, dense->stiffness, second, dense->damping);
    g_autofree double *values = g_new0(double, MAX(dense->m, 1));
    if (!tinker_eigen_symmetric((int32_t)dense->m, vectors, values)) return FALSE;
    for (gsize j = 0; j < dense->m; j++) {
        const double *x = vectors + j * dense->m;
        double stiffness = dense->greatest[1] == 0 ? values[j] : form(dense, dense->stiffness, x);
        double damping = dense->greatest[1] == 0 ? 0 : form(dense, dense->damping, x);
        add_roots(spectrum, stiffness, damping);
        add_oscillator(spectrum, stiffness, damping);
    }
    return TRUE;
}

/* z' = [0 s; -K/s -C] z with z = (s u, u'), s about the largest frequency, so that all entries are rates. */
static gboolean add_state_matrix(TinkerSpectrum *spectrum, const Dense *dense)
{
    gsize m = dense->m, order = 2 * m;
    double s = fmax(sqrt(dense->greatest[0]), dense->greatest[1]);
    g_autofree double *state = g_new0(double, order *order), *re = g_new0(double, order), *im = g_new0(double, order);
    for (gsize j = 0; j < m; j++) {
        state[(m + j) * order + j] = s;
        for (gsize i = 0; i < m; i++) {
            state[j * order + m + i] = -dense->stiffness[j * m + i] / s;
            state[(m + j) * order + m + i] = -dense->damping[j * m + i];
        }
    }
    if (!tinker_eigen_general((int32_t)order, state, re, im, NULL)) return FALSE;
    for (gsize i = 0; i < order; i++)
        if (im[i] >= 0) add_eigenvalue(spectrum, re[i], im[i]);
    return TRUE;
}

/* Steps between which the edge of semi-implicit Euler lies, for a largest stiffness and damping: h^2 stiffness + 2 h
 * damping is at least 4 at the largest of them, and at most 4 at the smallest. Last, INFINITY: where damping limits
 * nothing. */
static double mixture_step(double stiffness, double damping, int number)
{
    if (number == MIXTURES) return INFINITY;
    double edge = fmin(stiffness > 0 ? 2 / sqrt(stiffness) : INFINITY, damping > 0 ? 2 / damping : INFINITY);
    return edge * (0.4 + 0.6 * number / (MIXTURES - 1));
}

static gboolean add_mixtures(TinkerSpectrum *spectrum, const Dense *dense, double stiffness, double damping)
{
    g_autofree double *values = g_new0(double, MAX(dense->m, 1));
    for (int number = 0; number <= MIXTURES; number++) {
        double h = mixture_step(stiffness, damping, number), inverse = 1 / h;
        g_autofree double *vectors = mixture(dense, 1, dense->stiffness, 2 * inverse, dense->damping);
        if (!tinker_eigen_symmetric((int32_t)dense->m, vectors, values)) return FALSE;
        const double *x = vectors + (dense->m - 1) * dense->m;
        add_oscillator(spectrum, form(dense, dense->stiffness, x), form(dense, dense->damping, x));
    }
    return TRUE;
}

/* What methods that split places from velocities are tried on. */
static gboolean keep_coupled(TinkerSpectrum *spectrum, const Dense *dense)
{
    if (!spectrum->turned || dense->m > TINKER_MOST_COUPLED) return TRUE;
    gsize size = dense->m * dense->m * sizeof(double);
    g_autofree double *vectors = mixture(dense, 1, dense->stiffness, 0, dense->stiffness);
    g_autofree double *values = g_new0(double, dense->m);
    if (!tinker_eigen_symmetric((int32_t)dense->m, vectors, values)) return FALSE;
    spectrum->falls = values[0] < -SYMMETRIC * dense->greatest[0];
    spectrum->coupled =
        (TinkerCoupled){(int32_t)dense->m, g_memdup2(dense->stiffness, size), g_memdup2(dense->damping, size),
                        fmax(sqrt(dense->greatest[0]), dense->greatest[1]), 0};
    return TRUE;
}

/* The largest eigenvalue of a symmetric part, and its shape where it is above 0. */
static double largest(const Dense *dense, const double *a, int32_t coordinates, double **shape)
{
    g_autofree double *vectors = mixture(dense, 1, a, 0, a), *values = g_new0(double, dense->m);
    if (!tinker_eigen_symmetric((int32_t)dense->m, vectors, values)) return NAN;
    double value = values[dense->m - 1];
    if (value > 0) *shape = shape_of(dense, vectors + (dense->m - 1) * dense->m, coordinates);
    return value;
}

/* Large ------------------------------------------------------------------------------------------------------------ */

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
    for (int number = 0; number <= MIXTURES; number++) {
        gboolean settled;
        double inverse = 1 / mixture_step(stiffness, damping, number);
        large->first = 1;
        large->second = 2 * inverse;
        largest_of(large, mixed_product, large, x, &settled);
        if (settled)
            add_oscillator(spectrum, quadratic(large, tinker_start_matrices_stiffness, x),
                           quadratic(large, tinker_start_matrices_damping, x));
    }
    add_oscillator(spectrum, stiffness, 0);
}

static void add_large_state(TinkerSpectrum *spectrum, Large *large)
{
    double re[WANTED + 1], im[WANTED + 1];
    int32_t found = tinker_arnoldi_largest(2 * (int32_t)large->n, WANTED, state_product, large, MOST_PRODUCTS,
                                           LARGE_TOLERANCE, re, im);
    for (int32_t i = 0; i < found; i++)
        if (im[i] >= 0) add_eigenvalue(spectrum, re[i], im[i]);
    for (guint i = 0; found == 0 && i < spectrum->oscillators->len; i++) {
        TinkerOscillator oscillator = g_array_index(spectrum->oscillators, TinkerOscillator, i);
        add_roots(spectrum, oscillator.stiffness, oscillator.damping);
    }
}

static gboolean fill_large(TinkerSpectrum *spectrum, TinkerStartMatrices *matrices, int32_t coordinates)
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
        add_oscillator(spectrum, stiffness, 0);
        add_roots(spectrum, stiffness, 0);
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

static gboolean fill_dense(TinkerSpectrum *spectrum, TinkerStartMatrices *matrices, int32_t coordinates)
{
    g_auto(Dense) dense = {0};
    if (!dense_open(&dense, matrices)) return FALSE;
    spectrum->complete = TRUE;
    if (dense.m == 0) return TRUE;
    gboolean symmetric = is_symmetric(&dense, dense.stiffness, dense.greatest[0]) &&
                         is_symmetric(&dense, dense.damping, dense.greatest[1]);
    gboolean common = symmetric && commute(&dense);
    // Constraints may leave nothing of what turns free bodies.
    spectrum->turned = !is_symmetric(&dense, dense.damping, dense.greatest[1]);
    if (!common && dense.m > MOST_STATES) {
        spectrum->complete = FALSE;
        return fill_large(spectrum, matrices, coordinates);
    }
    double stiffness = largest(&dense, dense.stiffness, coordinates, &spectrum->fastest);
    double damping = largest(&dense, dense.damping, coordinates, &spectrum->most_damped);
    spectrum->omega_max = sqrt(fmax(stiffness, 0));
    if (common) return add_common_shapes(spectrum, &dense);
    if (!add_state_matrix(spectrum, &dense)) return FALSE;
    if (spectrum->turned && !(damping > SYMMETRIC * dense.greatest[1])) spectrum->damping_max = 0; /* rounding */
    return add_mixtures(spectrum, &dense, stiffness, damping) && keep_coupled(spectrum, &dense);
}

/* All -------------------------------------------------------------------------------------------------------------- */

/* Forces across velocities make frequencies that no stiffness has, and no block's stiffness is to blame for. */
static void add_turning(TinkerSpectrum *spectrum)
{
    double most = 0;
    for (guint i = 0; spectrum->turned && i < spectrum->eigenvalues->len; i++)
        most = fmax(most, g_array_index(spectrum->eigenvalues, TinkerEigenvalue, i).im);
    if (!(most > (1 + LEAST_GROWTH) * spectrum->omega_max)) return;
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
    if (!(small ? fill_dense : fill_large)(spectrum, matrices, coordinates)) {
        g_array_set_size(spectrum->eigenvalues, 0);
        g_array_set_size(spectrum->oscillators, 0);
        spectrum->complete = FALSE;
    }
    add_turning(spectrum);
    double fastest = fmax(fmax(spectrum->omega_max, spectrum->damping_max), spectrum->growth_max);
    if (spectrum->growth_max < LEAST_GROWTH * fastest) spectrum->growth_max = 0;
    spectrum->coupled.growth = spectrum->growth_max;
    /* what falls over without losses comes back at the same rate */
    if (!tinker_start_matrices_damped(matrices)) spectrum->damping_max = 0;
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
