/* ARPACK's reverse communication, and a Lanczos process of our own where a
 * few products have to do: it keeps all its vectors and orthogonalises against them, which a few bear. */
#include "numerics/solve/eigen.h"

#include <arpack/arpack.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/lapack.h"

/* ARPACK ----------------------------------------------------------------------------------------------------------- */

/* A vector without symmetry, the same every time. */
static void fill_start(int32_t n, double *x)
{
    for (int32_t i = 0; i < n; i++)
        x[i] = 1.0 + 0.5 * sin(12.9898 * (i + 1));
}

/* What both iterations of ARPACK need. */
typedef struct {
    int32_t n, wanted, columns;
    double *start, *basis, *work, *inner;
    int32_t inner_size;
    a_int parameters[11], places[14], info, ido;
} Iteration;

static void iteration_open(Iteration *it, int32_t n, int32_t wanted, int32_t most_products)
{
    int32_t columns = MIN(n, MAX(2 * wanted + 1, 20));
    *it = (Iteration){.n = n, .wanted = wanted, .columns = columns, .info = 1};
    it->start = g_new(double, n);
    it->basis = g_new0(double, (gsize)n *(gsize)columns);
    it->work = g_new0(double, 3 * (gsize)n);
    it->inner_size = 3 * columns * columns + 8 * columns;
    it->inner = g_new0(double, it->inner_size);
    it->parameters[0] = 1;
    it->parameters[2] = MAX(1, most_products / MAX(columns - wanted, 1));
    it->parameters[3] = 1;
    it->parameters[6] = 1;
    fill_start(n, it->start);
}

static void iteration_clear(Iteration *it)
{
    g_free(it->start);
    g_free(it->basis);
    g_free(it->work);
    g_free(it->inner);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Iteration, iteration_clear)

/* Answers a request for a product; FALSE where there is none left. */
static gboolean iteration_serve(Iteration *it, TinkerOperator apply, void *data)
{
    if (it->ido != -1 && it->ido != 1) return FALSE;
    apply(data, it->work + it->places[0] - 1, it->work + it->places[1] - 1);
    return TRUE;
}

gboolean tinker_lanczos_largest(int32_t n, TinkerOperator apply, void *data, int32_t most_products, double tolerance,
                                double *value, double *vector)
{
    g_auto(Iteration) it = {0};
    iteration_open(&it, n, 1, most_products);
    do
        dsaupd_c(&it.ido, "I", n, "LA", it.wanted, tolerance, it.start, it.columns, it.basis, n, it.parameters,
                 it.places, it.work, it.inner, it.inner_size, &it.info);
    while (iteration_serve(&it, apply, data));
    if (it.info != 0) return FALSE;
    g_autofree a_int *select = g_new0(a_int, it.columns);
    dseupd_c(1, "A", select, value, vector, n, 0.0, "I", n, "LA", it.wanted, tolerance, it.start, it.columns, it.basis,
             n, it.parameters, it.places, it.work, it.inner, it.inner_size, &it.info);
    return it.info == 0 && isfinite(*value);
}

int32_t tinker_arnoldi_largest(int32_t n, int32_t wanted, TinkerOperator apply, void *data, int32_t most_products,
                               double tolerance, double *re, double *im)
{
    g_auto(Iteration) it = {0};
    iteration_open(&it, n, wanted, most_products);
    do
        dnaupd_c(&it.ido, "I", n, "LM", wanted, tolerance, it.start, it.columns, it.basis, n, it.parameters, it.places,
                 it.work, it.inner, it.inner_size, &it.info);
    while (iteration_serve(&it, apply, data));
    if (it.info != 0) return 0;
    g_autofree a_int *select = g_new0(a_int, it.columns);
    g_autofree double *vectors = g_new0(double, (gsize)n *(gsize)(wanted + 1)), *room = g_new0(double, 3 * it.columns);
    dneupd_c(0, "A", select, re, im, vectors, n, 0.0, 0.0, room, "I", n, "LM", wanted, tolerance, it.start, it.columns,
             it.basis, n, it.parameters, it.places, it.work, it.inner, it.inner_size, &it.info);
    return it.info == 0 ? it.parameters[4] : 0;
}

/* Spectral measure ------------------------------------------------------------------------------------------------- */

static double dot(int32_t n, const double *x, const double *y)
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* Makes y orthogonal to the first `count` vectors; twice, which is enough. */
static void orthogonalise(int32_t n, int32_t count, const double *basis, double *y)
{
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = 0; k < count; k++) {
            const double *x = basis + (gsize)k * (gsize)n;
            double part = dot(n, x, y);
            for (int32_t i = 0; i < n; i++)
                y[i] -= part * x[i];
        }
}

/* x . B x of the node's vector, which is the process' vectors times the tridiagonal matrix's. */
static double form_of_node(int32_t n, int32_t count, TinkerOperator other, void *data, const double *basis,
                           const double *parts, double *x)
{
    double *y = x + n;
    memset(x, 0, (gsize)n * sizeof(double));
    for (int32_t k = 0; k < count; k++)
        for (int32_t i = 0; i < n; i++)
            x[i] += parts[k] * basis[(gsize)k * (gsize)n + (gsize)i];
    other(data, x, y);
    return dot(n, x, y);
}

/* Nodes and weights of a tridiagonal matrix: eigenvalues, and squares of the vectors' first entries. */
static int32_t gauss(int32_t n, int32_t count, double *diagonal, double *beside, TinkerOperator other, void *data,
                     const double *basis, TinkerSpectralMeasure *measure)
{
    g_autofree double *vectors = g_new0(double, (gsize)count *(gsize)count), *x = g_new(double, 2 * (gsize)n);
    if (!tinker_eigen_tridiagonal(count, diagonal, beside, vectors)) return 0;
    for (int32_t k = 0; k < count; k++) {
        const double *parts = vectors + (gsize)k * (gsize)count;
        measure->nodes[k] = diagonal[k];
        measure->weights[k] = parts[0] * parts[0];
        measure->forms[k] = other != NULL ? form_of_node(n, count, other, data, basis, parts, x) : 0;
    }
    return count;
}

int32_t tinker_spectral_measure(int32_t n, int32_t steps, TinkerOperator apply, TinkerOperator other, void *data,
                                const double *vector, TinkerSpectralMeasure *measure)
{
    steps = MIN(MIN(steps, n), TINKER_MOST_NODES);
    double diagonal[TINKER_MOST_NODES], beside[TINKER_MOST_NODES], size = sqrt(dot(n, vector, vector)), greatest = 0;
    measure->count = 0;
    if (!(size > 0) || !isfinite(size)) return 0;
    g_autofree double *basis = g_new(double, (gsize)n *((gsize)steps + 1));
    for (int32_t i = 0; i < n; i++)
        basis[i] = vector[i] / size;
    int32_t count = 0;
    while (count < steps) {
        double *x = basis + (gsize)count * (gsize)n, *y = x + n;
        apply(data, x, y);
        diagonal[count] = dot(n, x, y);
        orthogonalise(n, count + 1, basis, y);
        beside[count] = sqrt(dot(n, y, y));
        greatest = fmax(greatest, fabs(diagonal[count]) + beside[count]);
        if (!isfinite(diagonal[count] + beside[count])) return 0;
        if (beside[count++] <= 1e-14 * greatest) break;
        for (int32_t i = 0; i < n && count < steps; i++)
            y[i] /= beside[count - 1];
    }
    measure->count = gauss(n, count, diagonal, beside, other, data, basis, measure);
    return measure->count;
}
