/* In order: the motions Z that constraints allow; K there as G^T S G with one row of G a part of rank one; the singular
 * vectors of the rows with positive weights; the others, if any, as a change of that diagonal, by Jacobi's rotations.
 */
#include "analysis/modes/modal-basis.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/lapack.h"

#include "analysis/modes/null-space-private.h"
#include "numerics/solve/symmetric-eigen.h"

/* Up to here Jacobi's methods are quick; beyond, a tridiagonal one. */
#define MOST_FOR_JACOBI 320
/* Singular values this small beside the largest are rounding. */
#define LEAST_SINGULAR 1e-13
/* What is left of parts that cancel each other. */
#define CANCELLED 1e-11
/* Of a matrix' entries: what is not symmetric by rounding, or by differences. */
#define NOT_SYMMETRIC 1e-8

/* What is worked with, all column by column. */
typedef struct {
    const TinkerLinearisation *linear;
    int32_t n, m;
    double *basis;   /* n by m: M^-1/2 Z, then times the vectors */
    double *squares; /* m */
    double *total;   /* m: the sum of the absolute parts of each square */
} Work;

/* One row of G: weight^1/2 b^T basis. */
static void row_times(const Work *work, const TinkerLinearTerm *term, double factor, double *out, gsize stride)
{
    const TinkerLinearEntry *entries =
        (const TinkerLinearEntry *)(const void *)work->linear->entries->data + term->first;
    for (int32_t c = 0; c < work->m; c++) {
        const double *column = work->basis + (gsize)work->n * (gsize)c;
        double sum = 0;
        for (guint k = 0; k < term->count; k++)
            if (entries[k].coordinate < work->n) sum += entries[k].value * column[entries[k].coordinate];
        out[stride * (gsize)c] = factor * sum;
    }
}

static gboolean start_basis(Work *work)
{
    const TinkerLinearisation *linear = work->linear;
    gsize n = (gsize)work->n;
    work->m = work->n;
    work->basis = g_new0(double, n *n);
    if (linear->rows->len == 0) {
        for (gsize i = 0; i < n; i++)
            work->basis[i + n * i] = 1 / sqrt(linear->mass[i]);
        return TRUE;
    }
    g_auto(TinkerNullSpace) space = {0};
    gboolean found = tinker_null_space_of(linear, &space);
    work->m = found ? work->n - space.rank : 0;
    for (gsize c = 0; c < (gsize)work->m; c++)
        for (gsize i = 0; i < n; i++)
            work->basis[i + n * c] = space.q[i + n * (c + (gsize)space.rank)] / sqrt(linear->mass[i]);
    return found;
}

/* basis <- basis * vectors. */
static void turn_basis(Work *work, const double *vectors)
{
    gsize n = (gsize)work->n, m = (gsize)work->m;
    double *turned = g_new0(double, n *m);
    for (gsize c = 0; c < m; c++)
        for (gsize k = 0; k < m; k++) {
            double factor = vectors[k + m * c];
            if (factor == 0) continue;
            const double *from = work->basis + n * k;
            for (gsize i = 0; i < n; i++)
                turned[i + n * c] += factor * from[i];
        }
    g_free(work->basis);
    work->basis = turned;
}

/* Positive parts --------------------------------------------------------------------------------------------------- */

static guint count_positive(const GArray *terms)
{
    guint count = 0;
    for (guint i = 0; i < terms->len; i++)
        count += g_array_index(terms, TinkerLinearTerm, i).weight > 0;
    return count;
}

/* Turns the basis into the singular vectors of the positive parts. */
static gboolean diagonalise_positive(Work *work)
{
    const GArray *terms = work->linear->stiffness;
    gsize m = (gsize)work->m, rows = MAX(count_positive(terms), m), row = 0;
    g_autofree double *g = g_new0(double, rows *m), *v = g_new0(double, m *m);
    for (guint i = 0; i < terms->len; i++) {
        const TinkerLinearTerm *term = &g_array_index(terms, TinkerLinearTerm, i);
        if (term->weight > 0) row_times(work, term, sqrt(term->weight), g + row++, rows);
    }
    double largest = 0;
    for (gsize i = 0; i < rows * m; i++) {
        if (!isfinite(g[i])) return FALSE;
        largest = fmax(largest, fabs(g[i]));
    }
    if (largest == 0) return TRUE;
    double scale = 1;
    if (!tinker_singular_values((int32_t)rows, (int32_t)m, g, work->squares, v, &scale)) return FALSE;
    double most = scale * work->squares[0];
    for (gsize i = 0; i < m; i++) {
        double value = scale * work->squares[i];
        work->squares[i] = value > LEAST_SINGULAR * most ? value * value : 0;
    }
    turn_basis(work, v);
    return TRUE;
}

/* The others ------------------------------------------------------------------------------------------------------- */

/* matrix (m by m) += the symmetric part of basis^T other basis; the largest of the other part is answered, and the part
 * itself left in `following`, where that is not NULL. */
static double add_dense(const Work *work, const double *other, double *matrix, double *following)
{
    gsize n = (gsize)work->n, m = (gsize)work->m;
    g_autofree double *product = g_new0(double, n *m), *full = g_new0(double, m *m);
    double largest = 0, most = 0;
    for (gsize c = 0; c < m; c++)
        for (gsize k = 0; k < n; k++)
            for (gsize i = 0; i < n; i++)
                product[i + n * c] += other[i + n * k] * work->basis[k + n * c];
    for (gsize c = 0; c < m; c++)
        for (gsize r = 0; r < m; r++)
            for (gsize i = 0; i < n; i++)
                full[r + m * c] += work->basis[i + n * r] * product[i + n * c];
    for (gsize c = 0; c < m; c++)
        for (gsize r = 0; r < m; r++) {
            double half = 0.5 * (full[r + m * c] - full[c + m * r]);
            matrix[r + m * c] += 0.5 * (full[r + m * c] + full[c + m * r]);
            if (following != NULL) following[r + m * c] = half;
            largest = fmax(largest, fabs(half));
            most = fmax(most, fabs(full[r + m * c]));
        }
    return largest > NOT_SYMMETRIC * most ? largest : 0;
}

static void add_square(const Work *work, const TinkerLinearTerm *term, double *matrix, double *row)
{
    gsize m = (gsize)work->m;
    row_times(work, term, 1, row, 1);
    for (gsize c = 0; c < m; c++)
        for (gsize r = 0; r < m && row[c] != 0; r++)
            matrix[r + m * c] += term->weight * row[r] * row[c];
}

static gboolean diagonalise(Work *work, double *matrix)
{
    gsize m = (gsize)work->m;
    if (work->m <= MOST_FOR_JACOBI) {
        if (!tinker_symmetric_eigen(work->m, matrix, work->n, work->basis)) return FALSE;
        for (gsize i = 0; i < m; i++)
            work->squares[i] = matrix[i + m * i];
        return TRUE;
    }
    for (gsize i = 0; i < m * m; i++)
        if (!isfinite(matrix[i])) return FALSE;
    if (!tinker_eigen_symmetric_large(work->m, matrix, work->squares)) return FALSE;
    turn_basis(work, matrix);
    return TRUE;
}

static gboolean find_modes(Work *work)
{
    const TinkerLinearisation *linear = work->linear;
    gsize m = (gsize)work->m;
    gboolean factored = work->m <= MOST_FOR_JACOBI;
    if (factored && !diagonalise_positive(work)) return FALSE;
    gboolean positive = factored && linear->other_stiffness == NULL;
    for (guint i = 0; i < linear->stiffness->len && positive; i++)
        positive = g_array_index(linear->stiffness, TinkerLinearTerm, i).weight > 0;
    if (positive) return TRUE;
    g_autofree double *matrix = g_new0(double, m *m), *row = g_new0(double, m);
    for (gsize i = 0; i < m && factored; i++)
        matrix[i + m * i] = work->squares[i];
    for (guint i = 0; i < linear->stiffness->len; i++) {
        const TinkerLinearTerm *term = &g_array_index(linear->stiffness, TinkerLinearTerm, i);
        if (!factored || term->weight < 0) add_square(work, term, matrix, row);
    }
    if (linear->other_stiffness != NULL) add_dense(work, linear->other_stiffness, matrix, NULL);
    return diagonalise(work, matrix);
}

/* Finishing -------------------------------------------------------------------------------------------------------- */

/* The largest that a part alone can make of a square: what its rounding is measured by. */
static double strongest(const TinkerLinearisation *linear, const GArray *terms)
{
    double most = 0;
    for (guint i = 0; i < terms->len; i++) {
        const TinkerLinearTerm *term = &g_array_index(terms, TinkerLinearTerm, i);
        double sum = 0;
        for (guint k = 0; k < term->count; k++) {
            const TinkerLinearEntry *entry = &g_array_index(linear->entries, TinkerLinearEntry, term->first + k);
            if (entry->coordinate < linear->size) sum += entry->value * entry->value / linear->mass[entry->coordinate];
        }
        most = fmax(most, fabs(term->weight) * sum);
    }
    return most;
}

/* A square that is what cancelling parts left over is 0: the sums of the parts' absolute values tell. */
static void drop_rounding(Work *work)
{
    const TinkerLinearisation *linear = work->linear;
    gsize m = (gsize)work->m, n = (gsize)work->n;
    g_autofree double *row = g_new0(double, m), *total = g_new0(double, m);
    double most = 0, least = LEAST_SINGULAR * LEAST_SINGULAR * strongest(linear, linear->stiffness);
    for (guint i = 0; i < linear->stiffness->len; i++) {
        const TinkerLinearTerm *term = &g_array_index(linear->stiffness, TinkerLinearTerm, i);
        row_times(work, term, 1, row, 1);
        for (gsize c = 0; c < m; c++)
            total[c] += fabs(term->weight) * row[c] * row[c];
    }
    for (gsize c = 0; c < m && linear->other_stiffness != NULL; c++)
        for (gsize k = 0; k < n; k++)
            for (gsize i = 0; i < n; i++)
                total[c] += fabs(linear->other_stiffness[i + n * k] * work->basis[i + n * c] * work->basis[k + n * c]);
    for (gsize c = 0; c < m; c++)
        most = fmax(most, fabs(work->squares[c]));
    double floor = fmax(least, most * LEAST_SINGULAR * (work->m <= MOST_FOR_JACOBI ? LEAST_SINGULAR : 1));
    for (gsize c = 0; c < m; c++)
        if (fabs(work->squares[c]) <= CANCELLED * total[c] || fabs(work->squares[c]) <= floor) work->squares[c] = 0;
}

static int compare_squares(const void *left, const void *right, void *data)
{
    const double *squares = data, l = squares[*(const int32_t *)left], r = squares[*(const int32_t *)right];
    if (l != r) return l < r ? -1 : 1;
    return *(const int32_t *)left < *(const int32_t *)right ? -1 : 1;
}

static void sort_modes(Work *work, TinkerModalBasis *basis)
{
    gsize n = (gsize)work->n, m = (gsize)work->m;
    g_autofree int32_t *order = g_new0(int32_t, MAX(m, 1));
    for (gsize i = 0; i < m; i++)
        order[i] = (int32_t)i;
    g_qsort_with_data(order, (int)m, sizeof(int32_t), compare_squares, work->squares);
    basis->shapes = g_new0(double, MAX(n * m, 1));
    basis->squares = g_new0(double, MAX(m, 1));
    for (gsize i = 0; i < m; i++) {
        basis->squares[i] = work->squares[order[i]];
        memcpy(basis->shapes + n * i, work->basis + n * (gsize)order[i], n * sizeof(double));
    }
    g_free(work->basis);
    work->basis = basis->shapes;
}

static void add_damping(const Work *work, TinkerModalBasis *basis)
{
    const TinkerLinearisation *linear = work->linear;
    gsize m = (gsize)work->m;
    if (m == 0) return;
    if (linear->damping->len > 0 || linear->other_damping != NULL) {
        g_autofree double *row = g_new0(double, m), *gyration = g_new0(double, m *m);
        double least = LEAST_SINGULAR * LEAST_SINGULAR * strongest(linear, linear->damping);
        basis->damping = g_new0(double, m *m);
        for (guint i = 0; i < linear->damping->len; i++)
            add_square(work, &g_array_index(linear->damping, TinkerLinearTerm, i), basis->damping, row);
        for (gsize i = 0; i < m * m; i++)
            if (fabs(basis->damping[i]) <= least) basis->damping[i] = 0;
        if (linear->other_damping != NULL && add_dense(work, linear->other_damping, basis->damping, gyration) > 0)
            for (gsize i = 0; i < m * m; i++)
                basis->damping[i] += gyration[i];
    }
    if (linear->other_stiffness == NULL) return;
    g_autofree double *unused = g_new0(double, m *m);
    basis->following = g_new0(double, m *m);
    if (add_dense(work, linear->other_stiffness, unused, basis->following) == 0)
        g_clear_pointer(&basis->following, g_free);
}

static gboolean refuse(GError **error, const char *why)
{
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN, "its modes cannot be worked out: %s", why);
    return FALSE;
}

gboolean tinker_modal_basis_fits(int32_t coordinates, GError **error)
{
    if (coordinates <= TINKER_MOST_MODAL_COORDINATES) return TRUE;
    g_set_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_RUN,
                "its bodies have %d coordinates, too many for an analysis of modes (at most %d are, those of %d masses "
                "or of %d bodies that turn)",
                coordinates, TINKER_MOST_MODAL_COORDINATES, TINKER_MOST_MODAL_COORDINATES / 2,
                TINKER_MOST_MODAL_COORDINATES / 3);
    return FALSE;
}

TinkerModalBasis *tinker_modal_basis_new(const TinkerLinearisation *linear, GError **error)
{
    Work work = {.linear = linear, .n = linear->size};
    if (!tinker_modal_basis_fits(linear->size, error)) return NULL;
    g_autoptr(TinkerModalBasis) basis = g_new0(TinkerModalBasis, 1);
    gboolean done = work.n == 0 || start_basis(&work);
    work.squares = g_new0(double, MAX(work.m, 1));
    if (done && work.m > 0) done = find_modes(&work);
    if (done && work.m > 0) drop_rounding(&work);
    basis->size = work.n;
    basis->count = work.m;
    sort_modes(&work, basis);
    g_free(work.squares);
    if (done) add_damping(&work, basis);
    if (done || refuse(error, "its numbers leave the range that can be computed with")) return g_steal_pointer(&basis);
    return NULL;
}

void tinker_modal_basis_free(TinkerModalBasis *basis)
{
    if (basis == NULL) return;
    g_free(basis->shapes);
    g_free(basis->squares);
    g_free(basis->damping);
    g_free(basis->following);
    g_free(basis);
}

void tinker_modal_basis_reduce(const TinkerModalBasis *basis, const double *x, double *out)
{
    for (int32_t c = 0; c < basis->count; c++) {
        const double *shape = basis->shapes + (gsize)basis->size * (gsize)c;
        out[c] = 0;
        for (int32_t i = 0; i < basis->size; i++)
            out[c] += shape[i] * x[i];
    }
}

void tinker_modal_basis_expand(const TinkerModalBasis *basis, const double *y, double *out)
{
    memset(out, 0, sizeof(double) * (gsize)basis->size);
    for (int32_t c = 0; c < basis->count; c++)
        for (int32_t i = 0; i < basis->size; i++)
            out[i] += basis->shapes[i + (gsize)basis->size * (gsize)c] * y[c];
}
