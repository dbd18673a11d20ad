/* Right-looking factorisation over the update lists of sparse-pattern.c. Values lie in one array: the diagonal first,
 * in the order of elimination, then the columns of L one after the other with rows ascending. */
#include <string.h>

#include "numerics/solve/sparse-ldl-private.h"

double *tinker_sparse_ldl_values(TinkerSparseLdl *ldl)
{
    return ldl->values;
}

void tinker_sparse_ldl_clear(TinkerSparseLdl *ldl)
{
    memset(ldl->values, 0, ((gsize)ldl->n + tinker_sparse_ldl_fill(ldl)) * sizeof(double));
}

/* Eliminates column k with the reciprocal of its pivot; answers the place in the list behind its updates. */
static inline const int *eliminate(TinkerSparseLdl *ldl, int k, double inverse, const int *update)
{
    double *values = ldl->values;
    ldl->diagonal[k] = inverse;
    if (ldl->is_forest) {
        double entry = values[ldl->n + k], factor = entry * inverse;
        values[ldl->parent_places[k]] -= factor * entry;
        values[ldl->n + k] = factor;
        return update;
    }
    double *column = values + ldl->n + ldl->starts[k];
    int length = ldl->starts[k + 1] - ldl->starts[k];
    for (int p = 0; p < length; p++) {
        double factor = column[p] * inverse;
        for (int q = p; q < length; q++)
            values[*update++] -= factor * column[q];
        column[p] = factor;
    }
    return update;
}

gboolean tinker_sparse_ldl_factor(TinkerSparseLdl *ldl, double shift, double threshold)
{
    double *values = ldl->values, *least = ldl->work;
    const int *update = ldl->updates, inner = ldl->n - ldl->border;
    for (int k = 0; k < inner; k++) {
        values[k] += shift;
        least[k] = threshold * values[k];
    }
    for (int k = 0; k < inner; k++) {
        if (!(values[k] > least[k])) return FALSE;
        update = eliminate(ldl, k, 1.0 / values[k], update);
    }
    for (int k = inner; k < ldl->n; k++) {
        if (!(values[k] < 0)) return FALSE;
        update = eliminate(ldl, k, 1.0 / values[k], update);
    }
    return TRUE;
}

/* What column k has in the border. */
static void add_left_out(TinkerSparseLdl *ldl, int k)
{
    const double *column = ldl->values + ldl->n + ldl->starts[k];
    const int *rows = ldl->rows + ldl->starts[k], length = ldl->starts[k + 1] - ldl->starts[k];
    const int inner = ldl->n - ldl->border;
    for (int p = 0; p < length; p++)
        for (int q = 0; rows[p] >= inner && q < length; q++)
            if (rows[q] >= inner)
                ldl->left_out[(rows[p] - inner) + (rows[q] - inner) * ldl->border] += column[p] * column[q];
}

int tinker_sparse_ldl_count_dependent(TinkerSparseLdl *ldl, double threshold, char *dependent)
{
    double *values = ldl->values, *least = ldl->work;
    const int *update = ldl->updates;
    const int inner = ldl->n - ldl->border;
    int count = 0;
    memset(ldl->left_out, 0, (gsize)ldl->border * (gsize)ldl->border * sizeof(double));
    for (int k = 0; k < inner; k++)
        least[k] = threshold * values[k];
    for (int k = 0; k < inner; k++) {
        gboolean vanishes = !(values[k] > least[k]);
        count += vanishes;
        least[k] = vanishes;
        if (vanishes && ldl->border > 0) add_left_out(ldl, k);
        update = eliminate(ldl, k, vanishes ? 0.0 : 1.0 / values[k], update);
    }
    for (int i = 0; i < ldl->n; i++)
        if (dependent != NULL) dependent[i] = ldl->place[i] < inner && least[ldl->place[i]] != 0;
    return count;
}

void tinker_sparse_ldl_left_out(const TinkerSparseLdl *ldl, double *products)
{
    memcpy(products, ldl->left_out, (gsize)ldl->border * (gsize)ldl->border * sizeof(double));
}

/* A root is its own parent with the factor 0, so that no branch has to tell it apart. */
static void substitute_back(const TinkerSparseLdl *ldl, double *restrict b)
{
    const double *restrict factor = ldl->values + ldl->n, *restrict diagonal = ldl->diagonal;
    const int *restrict sequence = ldl->sequence, *restrict parents = ldl->parents;
    for (int k = ldl->n - 1; k >= 0; k--)
        b[sequence[k]] = b[sequence[k]] * diagonal[k] - factor[k] * b[parents[k]];
}

static void solve_forest(const TinkerSparseLdl *ldl, double *restrict b)
{
    const double *restrict factor = ldl->values + ldl->n;
    const int *restrict sequence = ldl->sequence, *restrict parents = ldl->parents;
    for (int k = 0; k < ldl->n; k++)
        b[parents[k]] -= factor[k] * b[sequence[k]];
    substitute_back(ldl, b);
}

/* Each division waits for the one before it on its branch of the forest, and nothing else does: the substitution of b
 * goes on beside it. */
gboolean tinker_sparse_ldl_factor_and_solve(TinkerSparseLdl *ldl, double threshold, double *b)
{
    if (!ldl->is_forest) {
        if (!tinker_sparse_ldl_factor(ldl, 0.0, threshold)) return FALSE;
        tinker_sparse_ldl_solve(ldl, b);
        return TRUE;
    }
    int n = ldl->n;
    double *restrict pivots = ldl->values, *restrict entries = ldl->values + n, *restrict least = ldl->work;
    double *restrict diagonal = ldl->diagonal, *restrict known = b;
    const int *restrict sequence = ldl->sequence, *restrict parents = ldl->parents,
                        *restrict places = ldl->parent_places;
    for (int k = 0; k < n; k++)
        least[k] = threshold * pivots[k];
    for (int k = 0; k < n; k++) {
        double pivot = pivots[k], entry = entries[k];
        if (!(pivot > least[k])) return FALSE;
        double inverse = 1.0 / pivot, factor = entry * inverse;
        pivots[places[k]] -= entry * entry / pivot;
        known[parents[k]] -= factor * known[sequence[k]];
        diagonal[k] = inverse;
        entries[k] = factor;
    }
    substitute_back(ldl, b);
    return TRUE;
}

void tinker_sparse_ldl_solve(TinkerSparseLdl *ldl, double *b)
{
    if (ldl->is_forest) {
        solve_forest(ldl, b);
        return;
    }
    int n = ldl->n;
    double *x = ldl->work;
    const double *factor = ldl->values + n;
    for (int i = 0; i < n; i++)
        x[ldl->place[i]] = b[i];
    for (int k = 0; k < n; k++) {
        double known = x[k];
        for (int p = ldl->starts[k]; p < ldl->starts[k + 1]; p++)
            x[ldl->rows[p]] -= factor[p] * known;
        x[k] = known * ldl->diagonal[k];
    }
    for (int k = n - 1; k >= 0; k--) {
        double sum = x[k];
        for (int p = ldl->starts[k]; p < ldl->starts[k + 1]; p++)
            sum -= factor[p] * x[ldl->rows[p]];
        x[k] = sum;
    }
    for (int i = 0; i < n; i++)
        b[i] = x[ldl->place[i]];
}
