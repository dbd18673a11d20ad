/* Small islands: K and C projected on a basis of the tangent space. Where K and C commute (no damping, or damping in
 * proportion) they have common shapes, and each is a damped oscillator of its own. */
#include <math.h>
#include <string.h>

#include "numerics/solve/eigen.h"
#include "numerics/solve/lapack.h"
#include "physics/plan/spectrum-private.h"
#include "physics/plan/tolerances.h"

/* Coordinates up to which a matrix that is not symmetric, twice as large, is worth all its eigenvalues. */
#define MOST_STATES 60

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
            if (fabs(a[j * dense->m + i] - a[i * dense->m + j]) > TINKER_SYMMETRIC_MATRIX * greatest) return FALSE;
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
    double bound = TINKER_COMMUTES * dense->greatest[0] * dense->greatest[1];
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
        spectrum_add_roots(spectrum, stiffness, damping);
        spectrum_add_oscillator(spectrum, stiffness, damping);
    }
    return TRUE;
}

/* The 2 m roots of z' = [0 s; -K/s -C] z with z = (s u, u'), s about the largest frequency, so that all entries are
 * rates. */
static gboolean find_roots(const Dense *dense, double *re, double *im)
{
    gsize m = dense->m, order = 2 * m;
    double s = fmax(sqrt(dense->greatest[0]), dense->greatest[1]);
    g_autofree double *state = g_new0(double, order *order);
    for (gsize j = 0; j < m; j++) {
        state[(m + j) * order + j] = s;
        for (gsize i = 0; i < m; i++) {
            state[j * order + m + i] = -dense->stiffness[j * m + i] / s;
            state[(m + j) * order + m + i] = -dense->damping[j * m + i];
        }
    }
    return tinker_eigen_general((int32_t)order, state, re, im, NULL);
}

static gboolean add_state_matrix(TinkerSpectrum *spectrum, const Dense *dense)
{
    gsize order = 2 * dense->m;
    g_autofree double *re = g_new0(double, order), *im = g_new0(double, order);
    if (!find_roots(dense, re, im)) return FALSE;
    for (gsize i = 0; i < order; i++)
        if (im[i] >= 0) spectrum_add_eigenvalue(spectrum, re[i], im[i]);
    return TRUE;
}

static gboolean add_mixtures(TinkerSpectrum *spectrum, const Dense *dense, double stiffness, double damping)
{
    g_autofree double *values = g_new0(double, MAX(dense->m, 1));
    for (int number = 0; number <= SPECTRUM_MIXTURES; number++) {
        double h = spectrum_mixture_step(stiffness, damping, number), inverse = 1 / h;
        g_autofree double *vectors = mixture(dense, 1, dense->stiffness, 2 * inverse, dense->damping);
        if (!tinker_eigen_symmetric((int32_t)dense->m, vectors, values)) return FALSE;
        const double *x = vectors + (dense->m - 1) * dense->m;
        spectrum_add_oscillator(spectrum, form(dense, dense->stiffness, x), form(dense, dense->damping, x));
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
    spectrum->falls = values[0] < -TINKER_SYMMETRIC_MATRIX * dense->greatest[0];
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

gboolean spectrum_fill_dense(TinkerSpectrum *spectrum, TinkerStartMatrices *matrices, int32_t coordinates)
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
        return spectrum_fill_large(spectrum, matrices, coordinates);
    }
    double stiffness = largest(&dense, dense.stiffness, coordinates, &spectrum->fastest);
    double damping = largest(&dense, dense.damping, coordinates, &spectrum->most_damped);
    spectrum->omega_max = sqrt(fmax(stiffness, 0));
    if (common) return add_common_shapes(spectrum, &dense);
    if (!add_state_matrix(spectrum, &dense)) return FALSE;
    if (spectrum->turned && !(damping > TINKER_SYMMETRIC_MATRIX * dense.greatest[1]))
        spectrum->damping_max = 0; /* rounding */
    return add_mixtures(spectrum, &dense, stiffness, damping) && keep_coupled(spectrum, &dense);
}

void spectrum_find_growth_in_motion(TinkerStartMatrices *matrices, double *growth)
{
    g_auto(Dense) dense = {0};
    if (!tinker_start_matrices_moves(matrices) || !dense_open(&dense, matrices) || dense.m == 0) return;
    gsize order = 2 * dense.m;
    g_autofree double *re = g_new0(double, order), *im = g_new0(double, order);
    double greatest = over_basis(&dense, tinker_start_matrices_moving_stiffness, dense.stiffness), most = 0;
    dense.greatest[0] = fmax(dense.greatest[0], greatest);
    if (dense.m > MOST_STATES || !isfinite(greatest) || !find_roots(&dense, re, im)) return;
    for (gsize i = 0; i < order; i++)
        most = fmax(most, re[i]);
    /* what is slower may be rounding, and says of the other only that it is not as fast */
    const double told = TINKER_LEAST_GROWTH_IN_MOTION * sqrt(dense.greatest[0]);
    if (most >= told)
        *growth = most;
    else if (*growth >= told)
        *growth = 0;
}
