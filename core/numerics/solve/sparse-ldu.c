/* Values lie in one array: the diagonal in the order of elimination, the entries of L column by column, the entries of
 * U row by row in the same order. Eliminating k takes l_i u_j / d_k off every entry (i, j), at the places that the
 * symmetric factor lists for (i, j) with i >= j: there the product l_i u_j goes into L and l_j u_i into U.
 *
 * Tested against dense elimination in tests/numerics. */
#include "numerics/solve/sparse-ldu.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/sparse-ldl-private.h"

struct _TinkerSparseLdu {
    TinkerSparseLdl *pattern; /* its values are not used */
    gsize fill;
    double *values; /* n + 2 fill */
};

TinkerSparseLdu *tinker_sparse_ldu_new(int n, const int *rows, const int *columns, gsize count)
{
    TinkerSparseLdl *pattern = tinker_sparse_ldl_new(n, rows, columns, count);
    if (pattern == NULL) return NULL;
    TinkerSparseLdu *ldu = g_new0(TinkerSparseLdu, 1);
    ldu->pattern = pattern;
    ldu->fill = tinker_sparse_ldl_fill(pattern);
    ldu->values = g_try_new0(double, (gsize)n + 2 * ldu->fill + 1);
    if (ldu->values == NULL) g_clear_pointer(&ldu, tinker_sparse_ldu_free);
    return ldu;
}

void tinker_sparse_ldu_free(TinkerSparseLdu *ldu)
{
    if (ldu == NULL) return;
    tinker_sparse_ldl_free(ldu->pattern);
    g_free(ldu->values);
    g_free(ldu);
}

int tinker_sparse_ldu_slot(const TinkerSparseLdu *ldu, int row, int column)
{
    const int lower = tinker_sparse_ldl_slot(ldu->pattern, row, column);
    return ldu->pattern->place[row] < ldu->pattern->place[column] ? lower + (int)ldu->fill : lower;
}

double *tinker_sparse_ldu_values(TinkerSparseLdu *ldu)
{
    return ldu->values;
}

gsize tinker_sparse_ldu_fill(const TinkerSparseLdu *ldu)
{
    return ldu->fill;
}

void tinker_sparse_ldu_clear(TinkerSparseLdu *ldu)
{
    memset(ldu->values, 0, ((gsize)ldu->pattern->n + 2 * ldu->fill) * sizeof(double));
}

/* A root is its own parent with the entries 0, so that no branch has to tell it apart. */
static void substitute_forest(const TinkerSparseLdu *ldu, double *restrict b)
{
    const TinkerSparseLdl *pattern = ldu->pattern;
    const double *restrict upper = ldu->values + pattern->n + ldu->fill, *restrict diagonal = pattern->diagonal;
    const int *restrict sequence = pattern->sequence, *restrict parents = pattern->parents;
    for (int k = pattern->n - 1; k >= 0; k--)
        b[sequence[k]] = b[sequence[k]] * diagonal[k] - upper[k] * b[parents[k]];
}

static void solve_forest(const TinkerSparseLdu *ldu, double *restrict b)
{
    const TinkerSparseLdl *pattern = ldu->pattern;
    const double *restrict lower = ldu->values + pattern->n;
    const int *restrict sequence = pattern->sequence, *restrict parents = pattern->parents;
    for (int k = 0; k < pattern->n; k++)
        b[parents[k]] -= lower[k] * b[sequence[k]];
    substitute_forest(ldu, b);
}

/* Of a forest every column of L has one entry, and so has every row of U. Each division waits for the one before it on
 * its branch, and nothing else does: the substitution of b goes on beside it. */
static gboolean factor_forest(TinkerSparseLdu *ldu, const double *restrict least, double *restrict b)
{
    const TinkerSparseLdl *pattern = ldu->pattern;
    double *restrict pivots = ldu->values, *restrict lower = pivots + pattern->n, *restrict upper = lower + ldu->fill;
    double *restrict diagonal = pattern->diagonal;
    const int *restrict sequence = pattern->sequence, *restrict parents = pattern->parents,
                        *restrict places = pattern->parent_places;
    for (int k = 0; k < pattern->n; k++) {
        if (!(fabs(pivots[k]) > least[sequence[k]])) return FALSE;
        const double inverse = 1.0 / pivots[k], l = lower[k] * inverse;
        pivots[places[k]] -= l * upper[k];
        b[parents[k]] -= l * b[sequence[k]];
        diagonal[k] = inverse;
        lower[k] = l;
        upper[k] *= inverse;
    }
    substitute_forest(ldu, b);
    return TRUE;
}

/* Answers the place in the list of updates behind its own. An update on the diagonal has one place, any other has two.
 */
static const int *eliminate(TinkerSparseLdu *ldu, int k, double inverse, const int *update)
{
    const TinkerSparseLdl *pattern = ldu->pattern;
    const int first = pattern->starts[k], length = pattern->starts[k + 1] - first;
    double *values = ldu->values, *lower = values + pattern->n + first, *upper = lower + ldu->fill;
    for (int p = 0; p < length; p++) {
        const double l = lower[p] * inverse, u = upper[p] * inverse;
        values[*update++] -= l * upper[p];
        for (int q = p + 1; q < length; q++, update++) {
            values[*update] -= lower[q] * u;
            values[*update + (int)ldu->fill] -= l * upper[q];
        }
    }
    for (int p = 0; p < length; p++) {
        lower[p] *= inverse;
        upper[p] *= inverse;
    }
    return update;
}

gboolean tinker_sparse_ldu_factor_and_solve(TinkerSparseLdu *ldu, const double *least, double *b)
{
    const TinkerSparseLdl *pattern = ldu->pattern;
    const int *update = pattern->updates;
    double *bound = pattern->work;
    if (pattern->is_forest) return factor_forest(ldu, least, b);
    for (int i = 0; i < pattern->n; i++)
        bound[pattern->place[i]] = least[i];
    for (int k = 0; k < pattern->n; k++) {
        if (!(fabs(ldu->values[k]) > bound[k])) return FALSE;
        const double inverse = pattern->diagonal[k] = 1.0 / ldu->values[k];
        update = eliminate(ldu, k, inverse, update);
    }
    tinker_sparse_ldu_solve(ldu, b);
    return TRUE;
}

void tinker_sparse_ldu_solve(TinkerSparseLdu *ldu, double *b)
{
    const TinkerSparseLdl *pattern = ldu->pattern;
    if (pattern->is_forest) {
        solve_forest(ldu, b);
        return;
    }
    const double *lower = ldu->values + pattern->n, *upper = lower + ldu->fill;
    const int n = pattern->n, *starts = pattern->starts;
    double *x = pattern->work;
    for (int i = 0; i < n; i++)
        x[pattern->place[i]] = b[i];
    for (int k = 0; k < n; k++)
        for (int p = starts[k]; p < starts[k + 1]; p++)
            x[pattern->rows[p]] -= lower[p] * x[k];
    for (int k = n - 1; k >= 0; k--) {
        x[k] *= pattern->diagonal[k];
        for (int p = starts[k]; p < starts[k + 1]; p++)
            x[k] -= upper[p] * x[pattern->rows[p]];
    }
    for (int i = 0; i < n; i++)
        b[i] = x[pattern->place[i]];
}
