/* The numbers of a matrix form: its rest, and its roots. Source of the roots: LAPACK Users' Guide, xGEEV. */
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "equations/matrix/matrix-private.h"
#include "law/derivative.h"

/* A matrix whose inverse is larger than this share of it is singular; a root that small beside the largest is 0. */
#define SINGULAR 1e-13
#define NO_ROOT  1e-12
#define SOLVE    4 /* roundings of a solve, in units of the last place of the largest number */

#define NO_SQUARE 8 /* roundings of the largest square of a frequency, times the coordinates: what is less is 0 */

typedef struct {
    const TinkerEquations *equations;
    double *numbers;
    guint n;
} Numbers;

static void put_number(guint row, guint column, const TinkerExpression *entry, void *data)
{
    const Numbers *self = data;
    self->numbers[row * self->n + column] = tinker_equations_value(self->equations, entry);
}

/* A matrix by rows. (transfer full) */
static double *numbers_of(const TinkerEquations *equations, const TinkerMatrixIsland *island, TinkerMatrixKind kind)
{
    const guint n = island->coordinates->len;
    Numbers self = {equations, g_new0(double, (gsize)n *n), n};
    tinker_matrix_each(island, kind, put_number, &self);
    return self.numbers;
}

/* Rest ------------------------------------------------------------------------------------------------------------- */

/* Functions of time alone, which have names. */
static gboolean varies(const TinkerEquations *equations, const char *symbol)
{
    if (tinker_equations_is_not_written(equations, symbol)) return TRUE;
    const TinkerEquationDefinition *definition = tinker_equations_definition(equations, symbol);
    return definition != NULL && tinker_expression_uses(definition->is, "t");
}

typedef struct {
    const TinkerEquations *equations;
} Rest;

static TinkerExpression *definition_or_zero(const char *symbol, void *data)
{
    const Rest *rest = data;
    if (varies(rest->equations, symbol)) return tinker_expression_number(0);
    const TinkerEquationDefinition *definition = tinker_equations_definition(rest->equations, symbol);
    return definition != NULL ? tinker_expression_replace(definition->is, definition_or_zero, data) : NULL;
}

/* Through definitions, of which those that vary are symbols themselves. */
typedef struct {
    const TinkerEquations *equations;
    const char *by;
} Slope;

static TinkerExpression *slope_of(const char *symbol, void *data)
{
    const Slope *slope = data;
    if (strcmp(symbol, slope->by) == 0) return tinker_expression_number(1);
    if (varies(slope->equations, symbol)) return NULL;
    const TinkerEquationDefinition *definition = tinker_equations_definition(slope->equations, symbol);
    return definition != NULL ? tinker_expression_derivative(definition->is, slope_of, data) : NULL;
}

/* A load's part that is linear in a function of time, added to a sum, which is used up. */
static TinkerExpression *plus_part(TinkerExpression *sum, const TinkerEquations *equations,
                                   const TinkerExpression *load, const char *symbol)
{
    Slope slope = {equations, symbol};
    TinkerExpression *factor = tinker_expression_derivative(load, slope_of, &slope);
    return tinker_expression_plus(sum, tinker_expression_times(factor, tinker_expression_symbol(symbol)));
}

/* What varies of a load: linear in the functions of time. (transfer full) */
static TinkerExpression *varying_part(const TinkerEquations *equations, const TinkerExpression *load)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        if (tinker_expression_uses(definition->is, "t")) sum = plus_part(sum, equations, load, definition->name);
    }
    for (guint i = 0; i < equations->not_written->len; i++) {
        const TinkerNotWritten *missing = g_ptr_array_index(equations->not_written, i);
        for (guint k = 0; k < missing->symbols->len; k++)
            sum = plus_part(sum, equations, load, g_ptr_array_index(missing->symbols, k));
    }
    return sum;
}

void tinker_matrix_count_from_rest(const TinkerEquations *equations, TinkerMatrixIsland *island)
{
    const lapack_int n = (lapack_int)island->coordinates->len;
    g_autofree double *k = numbers_of(equations, island, TINKER_MATRIX_STIFFNESS), *rest = g_new(double, 2 * n);
    double *rounding = rest + n, farthest = 0;
    g_autofree lapack_int *pivots = g_new(lapack_int, n);
    Rest question = {equations};
    double largest = 0;
    for (lapack_int i = 0; i < n * n; i++)
        largest = fmax(largest, fabs(k[i]));
    for (lapack_int i = 0; i < n; i++) {
        g_autoptr(TinkerExpression) constant =
            tinker_expression_replace(g_ptr_array_index(island->load, i), definition_or_zero, &question);
        rest[i] = tinker_equations_value(equations, constant);
        rounding[i] = tinker_equations_rounding(equations, constant);
    }
    if (largest == 0 || LAPACKE_dgetrf(LAPACK_ROW_MAJOR, n, n, k, n, pivots) != 0) return;
    for (lapack_int i = 0; i < n; i++)
        if (fabs(k[i * n + i]) <= SINGULAR * largest) return;
    LAPACKE_dgetrs(LAPACK_ROW_MAJOR, 'N', n, 1, k, n, pivots, rest, 1);
    LAPACKE_dgetrs(LAPACK_ROW_MAJOR, 'N', n, 1, k, n, pivots, rounding, 1);
    for (lapack_int i = 0; i < n; i++)
        farthest = fmax(farthest, fabs(rest[i]));
    island->about_rest = TRUE;
    for (lapack_int i = 0; i < n; i++) {
        TinkerMatrixCoordinate *coordinate = &g_array_index(island->coordinates, TinkerMatrixCoordinate, i);
        coordinate->about = rest[i];
        coordinate->rounding = SOLVE * DBL_EPSILON * farthest + fabs(rounding[i]);
        TinkerExpression *varying = varying_part(equations, g_ptr_array_index(island->load, i));
        tinker_expression_unref(g_ptr_array_index(island->load, i));
        island->load->pdata[i] = varying;
    }
}

/* Roots ------------------------------------------------------------------------------------------------------------ */

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

/* Complex roots pair with their conjugates, real ones with the next in size. */
static void keep_pair(TinkerMatrixIsland *island, guint number, Root one, Root other, double largest)
{
    const gboolean swings = one.im != 0;
    const double product = swings ? one.re * one.re + one.im * one.im : one.re * other.re, sum = one.re + other.re;
    island->zeta[number] = island->decay[number] = NAN;
    if (!swings && fmin(fabs(one.re), fabs(other.re)) <= NO_ROOT * largest) {
        island->omega[number] = 0;
        if (fabs(sum) > NO_ROOT * largest) island->decay[number] = -sum;
    } else if (product < 0) {
        island->omega[number] = NAN;
        island->unstable[2 * number] = one.re;
        island->unstable[2 * number + 1] = other.re;
    } else {
        island->omega[number] = sqrt(product);
        island->zeta[number] = -sum / (2 * island->omega[number]);
    }
}

static void keep_roots(TinkerMatrixIsland *island, Root *roots, guint count)
{
    qsort(roots, count, sizeof *roots, by_size);
    const double largest = fmax(hypot(roots[count - 1].re, roots[count - 1].im), 1e-300);
    int waiting = -1;
    guint number = 0;
    for (guint i = 0; i < count && number < count / 2; i++) {
        if (roots[i].im < 0) continue; /* with its conjugate */
        if (roots[i].im > 0) {
            keep_pair(island, number++, roots[i], roots[i], largest);
        } else if (waiting < 0) {
            waiting = (int)i;
        } else {
            keep_pair(island, number++, roots[waiting], roots[i], largest);
            waiting = -1;
        }
    }
}

static void count_entry(G_GNUC_UNUSED guint row, G_GNUC_UNUSED guint column,
                        G_GNUC_UNUSED const TinkerExpression *entry, void *data)
{
    ++*(guint *)data;
}

gboolean tinker_matrix_is_symmetric(const TinkerEquations *equations, const TinkerMatrixIsland *island)
{
    const guint n = island->coordinates->len;
    guint dampers = 0;
    tinker_matrix_each(island, TINKER_MATRIX_DAMPING, count_entry, &dampers);
    if (dampers > 0) return FALSE;
    g_autofree double *k = numbers_of(equations, island, TINKER_MATRIX_STIFFNESS);
    for (guint i = 0; i < n; i++)
        for (guint j = 0; j < i; j++)
            if (k[i * n + j] != k[j * n + i]) return FALSE;
    return TRUE;
}

/* The squares of the frequencies are the eigenvalues of M^-1/2 K M^-1/2. FALSE: they are not found. */
static gboolean symmetric_roots(const double *m, double *k, guint n, Root *roots)
{
    g_autofree double *square = g_new(double, n);
    for (guint i = 0; i < n; i++)
        for (guint j = 0; j < n; j++)
            k[i * n + j] /= sqrt(m[i * n + i]) * sqrt(m[j * n + j]);
    if (LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'N', 'U', (lapack_int)n, k, (lapack_int)n, square) != 0) return FALSE;
    const double least = NO_SQUARE * n * DBL_EPSILON * fmax(fabs(square[0]), fabs(square[n - 1]));
    for (guint i = 0; i < n; i++) {
        const double root = fabs(square[i]) > least ? sqrt(fabs(square[i])) : 0;
        roots[2 * i] = square[i] < 0 ? (Root){-root, 0} : (Root){0, -root};
        roots[2 * i + 1] = square[i] < 0 ? (Root){root, 0} : (Root){0, root};
    }
    return TRUE;
}

/* A x = s x with A = [0 1; -M^-1 K, -M^-1 C]; M is diagonal. FALSE: they are not found. */
static gboolean general_roots(const double *m, const double *k, const double *c, guint n, Root *roots)
{
    const guint size = 2 * n;
    g_autofree double *a = g_new0(double, (gsize)size *size);
    g_autofree double *re = g_new0(double, size), *im = g_new0(double, size);
    for (guint i = 0; i < n; i++) {
        a[i * size + n + i] = 1;
        for (guint j = 0; j < n; j++) {
            a[(n + i) * size + j] = -k[i * n + j] / m[i * n + i];
            a[(n + i) * size + n + j] = -c[i * n + j] / m[i * n + i];
        }
    }
    const lapack_int order = (lapack_int)size;
    if (LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'N', order, a, order, re, im, NULL, 1, NULL, 1) != 0) return FALSE;
    for (guint i = 0; i < size; i++)
        roots[i] = (Root){re[i], im[i]};
    return TRUE;
}

void tinker_matrix_roots(const TinkerEquations *equations, TinkerMatrixIsland *island)
{
    const guint n = island->coordinates->len, size = 2 * n;
    g_autofree double *m = numbers_of(equations, island, TINKER_MATRIX_MASS);
    g_autofree double *k = numbers_of(equations, island, TINKER_MATRIX_STIFFNESS);
    g_autofree double *c = numbers_of(equations, island, TINKER_MATRIX_DAMPING);
    g_autofree Root *roots = g_new0(Root, size);
    double **const results[] = {&island->omega, &island->zeta, &island->decay, &island->unstable};
    for (gsize i = 0; i < G_N_ELEMENTS(results); i++) {
        *results[i] = g_new(double, size);
        for (guint j = 0; j < size; j++)
            (*results[i])[j] = NAN;
    }
    const gboolean symmetric = island->sparse[0] != NULL && tinker_matrix_is_symmetric(equations, island);
    if (symmetric ? symmetric_roots(m, k, n, roots) : general_roots(m, k, c, n, roots)) keep_roots(island, roots, size);
}
