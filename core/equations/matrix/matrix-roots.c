/* The roots s of a matrix form, M s^2 + C s + K: in pairs, of which each is a mode.
 *
 * Where K is symmetric they are sought in coordinates of the modes without damping, M^-1/2 K M^-1/2 = V L V^T: what no
 * spring brings back has L = 0, and its place drops out, so that its root is 0 and no root of rounding. Where damping
 * couples none of these modes each has its own quadratic. Otherwise they are those of a state space, with W = |L|^1/2:
 * z = (W y, y'), z' = [0 W; -sign(L) W, -V^T M^-1/2 C M^-1/2 V] z. Source: LAPACK Users' Guide, xSYEV and xGEEV. */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "equations/matrix/matrix-private.h"

#define NO_ROOT   1e-12 /* of the largest root: what is less is 0 */
#define NO_SQUARE 8     /* roundings of the largest square of a frequency, times the coordinates: what is less is 0 */
#define COUPLED   1e-12 /* of the damping of two modes: what couples them by less does not */
#define UNLIKE    1e-14 /* of the largest entry: what differs across the diagonal by less is symmetric */
#define ROUNDING  1e-15 /* of the greater damping of two modes: likewise */

typedef struct {
    double re, im;
} Root;

static int by_size(const void *a, const void *b)
{
    const Root *first = a, *second = b;
    const double x = hypot(first->re, first->im), y = hypot(second->re, second->im);
    if (x != y) return (x > y) - (x < y);
    return (first->im > second->im) - (first->im < second->im);
}

/* Pairs ------------------------------------------------------------------------------------------------------------ */

/* A pair that `omega` and the others tell of; roots up to `least` are 0. */
static void keep_pair(TinkerMatrixIsland *island, guint number, Root one, Root other, double least)
{
    const gboolean swings = one.im != 0;
    const double product = swings ? one.re * one.re + one.im * one.im : one.re * other.re, sum = one.re + other.re;
    island->zeta[number] = island->decay[number] = NAN;
    if (!swings && fmin(fabs(one.re), fabs(other.re)) <= least) {
        island->omega[number] = 0;
        if (fabs(sum) > least) island->decay[number] = -sum;
    } else if (product < 0) {
        island->omega[number] = NAN;
        island->unstable[2 * number] = one.re;
        island->unstable[2 * number + 1] = other.re;
    } else {
        island->omega[number] = sqrt(product);
        island->zeta[number] = -sum / (2 * island->omega[number]);
    }
}

/* The first real root from `from` on that is not taken; `count`: none. */
static guint next_real(const Root *roots, const gboolean *taken, guint count, guint from)
{
    while (from < count && (taken[from] || roots[from].im != 0))
        from++;
    return from;
}

/* Complex roots pair with their conjugates; of what no spring brings back, `rigid` coordinates, a root of 0 with the
 * other one, which is 0 as well unless it is braked; other real ones with the next in size. */
static void keep_roots(TinkerMatrixIsland *island, Root *roots, guint count, guint rigid)
{
    qsort(roots, count, sizeof *roots, by_size);
    const double largest = fmax(hypot(roots[count - 1].re, roots[count - 1].im), 1e-300), least = NO_ROOT * largest;
    g_autofree gboolean *taken = g_new0(gboolean, count);
    guint zeros = 0, number = 0;
    while (zeros < count && hypot(roots[zeros].re, roots[zeros].im) <= least)
        roots[zeros++].im = 0;
    guint braked = 2 * rigid > zeros ? 2 * rigid - zeros : 0, alike = zeros - MIN(braked, zeros);
    for (guint i = 0; i < count && number < count / 2; i++) {
        if (taken[i] || roots[i].im < 0) continue; /* with its conjugate */
        guint other = i;
        if (roots[i].im == 0) {
            const gboolean both_are_zero = i < zeros && alike >= 2;
            if (both_are_zero) alike -= 2;
            other = next_real(roots, taken, count, both_are_zero ? i + 1 : MAX(i + 1, zeros));
            if (other == count) continue;
        }
        taken[i] = taken[other] = TRUE;
        keep_pair(island, number++, roots[i], roots[other], least);
    }
}

/* Modes ------------------------------------------------------------------------------------------------------------ */

typedef struct {
    guint n, rigid;  /* coordinates, and those that no spring brings back */
    double *square;  /* of the frequencies without damping, ascending; negative: it falls */
    double *damping; /* between modes, by rows */
} Modes;

/* V^T D V of D by rows; V has its vectors in columns. */
static double *between_modes(const double *d, const double *v, guint n)
{
    double *result = g_new0(double, (gsize)n *n);
    g_autofree double *half = g_new0(double, (gsize)n *n);
    for (guint i = 0; i < n; i++)
        for (guint k = 0; k < n; k++)
            for (guint j = 0; d[i * n + k] != 0 && j < n; j++)
                half[i * n + j] += d[i * n + k] * v[k * n + j];
    for (guint k = 0; k < n; k++)
        for (guint i = 0; i < n; i++)
            for (guint j = 0; j < n; j++)
                result[i * n + j] += v[k * n + i] * half[k * n + j];
    return result;
}

static void by_masses(const double *m, double *matrix, guint n)
{
    for (guint i = 0; i < n; i++)
        for (guint j = 0; j < n; j++)
            matrix[i * n + j] /= sqrt(m[i * n + i]) * sqrt(m[j * n + j]);
}

/* M is diagonal, and K symmetric; both K and C are used up. FALSE: they are not found. */
static gboolean find_modes(const double *m, double *k, double *c, gboolean damped, Modes *modes)
{
    const guint n = modes->n;
    by_masses(m, k, n);
    if (LAPACKE_dsyev(LAPACK_ROW_MAJOR, damped ? 'V' : 'N', 'U', (lapack_int)n, k, (lapack_int)n, modes->square) != 0)
        return FALSE;
    const double least = NO_SQUARE * n * DBL_EPSILON * fmax(fabs(modes->square[0]), fabs(modes->square[n - 1]));
    for (guint i = 0; i < n; i++) {
        if (fabs(modes->square[i]) > least) continue;
        modes->square[i] = 0;
        modes->rigid++;
    }
    if (!damped) return TRUE;
    by_masses(m, c, n);
    modes->damping = between_modes(c, k, n);
    return TRUE;
}

static gboolean is_coupled(const Modes *modes)
{
    const guint n = modes->n;
    for (guint i = 0; i < n; i++)
        for (guint j = 0; j < i; j++) {
            const double a = fabs(modes->damping[i * n + i]), b = fabs(modes->damping[j * n + j]);
            const double between = fmax(fabs(modes->damping[i * n + j]), fabs(modes->damping[j * n + i]));
            if (between > COUPLED * sqrt(a) * sqrt(b) + ROUNDING * fmax(a, b)) return TRUE;
        }
    return FALSE;
}

/* s^2 + c s + square = 0; the smaller root by the product of both, so that it keeps its digits. */
static void roots_of_one(double square, double c, Root pair[2])
{
    const double half = 0.5 * c, under = half * half - square;
    if (under < 0) {
        pair[0] = (Root){-half, sqrt(-under)};
        pair[1] = (Root){-half, -pair[0].im};
        return;
    }
    const double far = -(half + copysign(sqrt(under), half));
    pair[0] = (Root){far != 0 ? square / far : 0, 0};
    pair[1] = (Root){far, 0};
}

/* Each mode by itself. */
static void keep_modes(TinkerMatrixIsland *island, const Modes *modes)
{
    const guint n = modes->n;
    g_autofree Root *roots = g_new(Root, 2 * n);
    double largest = 1e-300;
    for (guint i = 0; i < n; i++) {
        roots_of_one(modes->square[i], modes->damping != NULL ? modes->damping[i * n + i] : 0, roots + 2 * i);
        for (guint k = 2 * i; k < 2 * i + 2; k++)
            largest = fmax(largest, hypot(roots[k].re, roots[k].im));
    }
    for (guint i = 0; i < n; i++)
        keep_pair(island, i, roots[2 * i], roots[2 * i + 1], NO_ROOT * largest);
}

/* Roots ------------------------------------------------------------------------------------------------------------ */

/* The roots of a matrix by rows, which is used up. */
static gboolean eigenvalues(double *a, guint size, Root *roots)
{
    g_autofree double *re = g_new0(double, size), *im = g_new0(double, size);
    const lapack_int order = (lapack_int)size;
    if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', order, a, order, re, im, NULL, 1, NULL, 1) != 0) return FALSE;
    for (guint i = 0; i < size; i++)
        roots[i] = (Root){re[i], im[i]};
    return TRUE;
}

/* Of modes that damping couples; 0 is a root of each that is rigid. */
static gboolean coupled_roots(const Modes *modes, Root *roots)
{
    const guint n = modes->n, places = n - modes->rigid, size = places + n;
    g_autofree double *a = g_new0(double, (gsize)size *size);
    for (guint i = 0, place = 0; i < n; i++) {
        for (guint j = 0; j < n; j++)
            a[(places + i) * size + places + j] = -modes->damping[i * n + j];
        if (modes->square[i] == 0) continue;
        const double w = sqrt(fabs(modes->square[i]));
        a[place * size + places + i] = w;
        a[(places + i) * size + place++] = -copysign(w, modes->square[i]);
    }
    return eigenvalues(a, size, roots);
}

/* A x = s x with A = [0 1; -M^-1 K, -M^-1 C]; M is diagonal. */
static gboolean general_roots(const double *m, const double *k, const double *c, guint n, Root *roots)
{
    const guint size = 2 * n;
    g_autofree double *a = g_new0(double, (gsize)size *size);
    for (guint i = 0; i < n; i++) {
        a[i * size + n + i] = 1;
        for (guint j = 0; j < n; j++) {
            a[(n + i) * size + j] = -k[i * n + j] / m[i * n + i];
            a[(n + i) * size + n + j] = -c[i * n + j] / m[i * n + i];
        }
    }
    return eigenvalues(a, size, roots);
}

static void count_entry(G_GNUC_UNUSED guint row, G_GNUC_UNUSED guint column,
                        G_GNUC_UNUSED const TinkerExpression *entry, void *data)
{
    ++*(guint *)data;
}

static gboolean is_damped(const TinkerMatrixIsland *island)
{
    guint dampers = 0;
    tinker_matrix_each(island, TINKER_MATRIX_DAMPING, count_entry, &dampers);
    return dampers > 0;
}

static gboolean is_symmetric(const double *k, guint n)
{
    double largest = 0;
    for (guint i = 0; i < n * n; i++)
        largest = fmax(largest, fabs(k[i]));
    for (guint i = 0; i < n; i++)
        for (guint j = 0; j < i; j++)
            if (fabs(k[i * n + j] - k[j * n + i]) > UNLIKE * largest) return FALSE;
    return TRUE;
}

gboolean tinker_matrix_is_symmetric(const TinkerEquations *equations, const TinkerMatrixIsland *island)
{
    if (is_damped(island)) return FALSE;
    g_autofree double *k = tinker_matrix_numbers(equations, island, TINKER_MATRIX_STIFFNESS);
    return is_symmetric(k, island->coordinates->len);
}

void tinker_matrix_roots(const TinkerEquations *equations, TinkerMatrixIsland *island)
{
    const guint n = island->coordinates->len, size = 2 * n;
    g_autofree double *m = tinker_matrix_numbers(equations, island, TINKER_MATRIX_MASS);
    g_autofree double *k = tinker_matrix_numbers(equations, island, TINKER_MATRIX_STIFFNESS);
    g_autofree double *c = tinker_matrix_numbers(equations, island, TINKER_MATRIX_DAMPING);
    g_autofree Root *roots = g_new0(Root, size);
    g_autofree double *square = g_new0(double, n);
    double **const results[] = {&island->omega, &island->zeta, &island->decay, &island->unstable};
    for (gsize i = 0; i < G_N_ELEMENTS(results); i++) {
        *results[i] = g_new(double, size);
        for (guint j = 0; j < size; j++)
            (*results[i])[j] = NAN;
    }
    if (!is_symmetric(k, n)) {
        if (general_roots(m, k, c, n, roots)) keep_roots(island, roots, size, 0);
        return;
    }
    Modes modes = {.n = n, .square = square};
    if (!find_modes(m, k, c, is_damped(island), &modes)) return;
    if (modes.damping == NULL || !is_coupled(&modes))
        keep_modes(island, &modes);
    else if (coupled_roots(&modes, roots))
        keep_roots(island, roots, size, modes.rigid);
    g_free(modes.damping);
}
