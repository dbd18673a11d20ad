/* Right-looking factorisation over precompiled update lists. Values lie in one array: the diagonal first, in the order
 * of elimination, then the columns of L one after the other with rows ascending. When column k is eliminated, the
 * product of its entries p and q is subtracted at a place that depends on the pattern alone; `updates` lists these
 * places in the order in which they are needed.
 *
 * A pattern without cycles (a chain of rods, a tree) needs no ordering by AMD: eliminating leaves first leaves every
 * column with one entry, the one of its parent, and no update lists. Leaves are taken in turns, so a chain is
 * eliminated from both ends at once: two runs of divisions that do not wait for each other. */
#include "numerics/solve/sparse-ldl-private.h"

#include <errno.h>
#include <string.h>
#include <suitesparse/amd.h>

/* Beyond this many updates a factorisation takes longer than anybody waits for at every stage of a step. */
#define MOST_UPDATES ((gsize)400000000)

static int compare_ints(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* A column of a pattern in the making. The patterns of large scenes take more than there may be, so none of this ends
 * the program. */
typedef struct {
    int *rows;
    gsize length, room;
} Column;

static gboolean append_rows(Column *column, const int *rows, gsize count)
{
    if (count > column->room - column->length) {
        const gsize room = MAX(column->length + count, 2 * column->room);
        int *larger = g_try_realloc_n(column->rows, room, sizeof(int));
        if (larger == NULL) return FALSE;
        column->rows = larger;
        column->room = room;
    }
    memcpy(column->rows + column->length, rows, count * sizeof(int));
    column->length += count;
    return TRUE;
}

static void sort_uniquely(Column *column)
{
    if (column->length < 2) return;
    qsort(column->rows, column->length, sizeof(int), compare_ints);
    gsize kept = 1;
    for (gsize i = 1; i < column->length; i++)
        if (column->rows[i] != column->rows[kept - 1]) column->rows[kept++] = column->rows[i];
    column->length = kept;
}

static void free_pattern(Column *pattern, int n)
{
    for (int k = 0; pattern != NULL && k < n; k++)
        g_free(pattern[k].rows);
    g_free(pattern);
}

/* The pattern by columns, both triangles, sorted and without repetition. */
typedef struct {
    int *starts, *entries;
} Neighbours;

static gboolean find_neighbours(Neighbours *by, int n, const int *rows, const int *columns, gsize count)
{
    int *starts = g_try_new0(int, n + 2), *entries = g_try_new(int, 2 * count + 1);
    *by = (Neighbours){starts, entries};
    if (starts == NULL || entries == NULL) return FALSE;
    for (gsize k = 0; k < count; k++)
        starts[rows[k] + 2]++, starts[columns[k] + 2]++;
    for (int i = 0; i < n; i++)
        starts[i + 2] += starts[i + 1];
    for (gsize k = 0; k < count; k++) {
        entries[starts[rows[k] + 1]++] = columns[k];
        entries[starts[columns[k] + 1]++] = rows[k];
    }
    int kept = 0, from = 0;
    for (int i = 0; i < n; i++) {
        int until = starts[i + 1], first = kept;
        qsort(entries + from, (gsize)(until - from), sizeof(int), compare_ints);
        for (int e = from; e < until; e++)
            if (kept == first || entries[e] != entries[kept - 1]) entries[kept++] = entries[e];
        starts[i] = first;
        from = until;
    }
    starts[n] = kept;
    return TRUE;
}

/* Takes leaves away in turns: a forest, unless a cycle is left over. FALSE: no memory. */
static gboolean peel(TinkerSparseLdl *ldl, const Neighbours *by)
{
    int n = ldl->n, taken = 0, seen = 0;
    g_autofree int *degree = g_try_new(int, MAX(n, 1));
    g_autofree gboolean *gone = g_try_new0(gboolean, MAX(n, 1));
    if (degree == NULL || gone == NULL) return FALSE;
    for (int i = 0; i < n; i++) {
        degree[i] = by->starts[i + 1] - by->starts[i];
        if (degree[i] <= 1) ldl->sequence[taken++] = i;
    }
    for (; seen < taken; seen++) {
        int row = ldl->sequence[seen];
        gone[row] = TRUE;
        ldl->parents[seen] = row;
        for (int e = by->starts[row]; e < by->starts[row + 1]; e++) {
            int other = by->entries[e];
            if (gone[other]) continue;
            ldl->parents[seen] = other;
            if (--degree[other] == 1) ldl->sequence[taken++] = other;
        }
    }
    ldl->is_forest = taken == n && ldl->border == 0;
    return TRUE;
}

/* The border goes behind all others. */
static void put_border_last(const TinkerSparseLdl *ldl, int *sequence)
{
    const int inner = ldl->n - ldl->border;
    int kept = 0;
    for (int k = 0; k < ldl->n; k++)
        if (sequence[k] < inner) sequence[kept++] = sequence[k];
    for (int i = inner; i < ldl->n; i++)
        sequence[i] = i;
}

/* FALSE: no memory. */
static gboolean order(TinkerSparseLdl *ldl, const Neighbours *by, int *sequence)
{
    const int result = amd_order(ldl->n, by->starts, by->entries, sequence, NULL, NULL);
    for (int i = 0; result < 0 && i < ldl->n; i++)
        sequence[i] = i;
    if (ldl->border > 0) put_border_last(ldl, sequence);
    return result != AMD_OUT_OF_MEMORY;
}

/* The pattern of L: below the diagonal, column k holds what A has there, and what earlier columns whose first entry is
 * k pass on. Stops where it grows beyond what `compile` takes. FALSE: no memory. */
static gboolean fill_pattern(const TinkerSparseLdl *ldl, const int *rows, const int *columns, gsize count,
                             Column *pattern)
{
    for (gsize e = 0; e < count; e++) {
        int i = ldl->place[rows[e]], j = ldl->place[columns[e]];
        int low = MIN(i, j), high = MAX(i, j);
        if (low != high && !append_rows(&pattern[low], &high, 1)) return FALSE;
    }
    gsize updates = 0;
    for (int k = 0; k < ldl->n && updates <= MOST_UPDATES; k++) {
        Column *column = &pattern[k];
        sort_uniquely(column);
        updates += column->length * (column->length + 1) / 2;
        if (column->length < 2) continue;
        if (!append_rows(&pattern[column->rows[0]], column->rows + 1, column->length - 1)) return FALSE;
    }
    return TRUE;
}

static int slot_of(const TinkerSparseLdl *ldl, int row, int column)
{
    if (row == column) return row;
    if (ldl->is_forest) return ldl->n + column;
    const int *first = ldl->rows + ldl->starts[column];
    const int *found =
        bsearch(&row, first, (gsize)(ldl->starts[column + 1] - ldl->starts[column]), sizeof(int), compare_ints);
    return ldl->n + (int)(found - ldl->rows);
}

static void list_updates(TinkerSparseLdl *ldl)
{
    int *update = ldl->updates;
    for (int k = 0; k < ldl->n; k++)
        for (int p = ldl->starts[k]; p < ldl->starts[k + 1]; p++)
            for (int q = p; q < ldl->starts[k + 1]; q++)
                *update++ = slot_of(ldl, ldl->rows[q], ldl->rows[p]);
}

static gboolean allot_values(TinkerSparseLdl *ldl, gsize entries)
{
    ldl->values = g_try_new0(double, (gsize)ldl->n + entries + 1);
    ldl->diagonal = g_try_new0(double, MAX(ldl->n, 1));
    ldl->work = g_try_new0(double, MAX(ldl->n, 1));
    ldl->left_out = g_try_new0(double, (gsize)ldl->border *(gsize)ldl->border + 1);
    if (ldl->left_out == NULL) return FALSE;
    return ldl->values != NULL && ldl->diagonal != NULL && ldl->work != NULL;
}

/* FALSE with errno. */
static gboolean compile(TinkerSparseLdl *ldl, const Column *pattern)
{
    gsize entries = 0, updates = 0;
    for (int k = 0; k < ldl->n; k++) {
        gsize length = pattern[k].length;
        entries += length;
        updates += length * (length + 1) / 2;
    }
    errno = updates > MOST_UPDATES ? EOVERFLOW : ENOMEM;
    if (updates > MOST_UPDATES) return FALSE;
    ldl->starts = g_try_new(int, ldl->n + 1);
    ldl->rows = g_try_new(int, MAX(entries, 1));
    ldl->updates = g_try_new(int, MAX(updates, 1));
    if (ldl->starts == NULL || ldl->rows == NULL || ldl->updates == NULL || !allot_values(ldl, entries)) return FALSE;
    ldl->starts[0] = 0;
    for (int k = 0; k < ldl->n; k++) {
        if (pattern[k].length > 0) memcpy(ldl->rows + ldl->starts[k], pattern[k].rows, pattern[k].length * sizeof(int));
        ldl->starts[k + 1] = ldl->starts[k] + (int)pattern[k].length;
    }
    list_updates(ldl);
    return TRUE;
}

static gboolean compile_general(TinkerSparseLdl *ldl, const Neighbours *by, const int *rows, const int *columns,
                                gsize count)
{
    g_autofree int *sequence = g_try_new(int, MAX(ldl->n, 1));
    Column *pattern = g_try_new0(Column, MAX(ldl->n, 1));
    gboolean done = sequence != NULL && pattern != NULL && order(ldl, by, sequence);
    for (int k = 0; done && k < ldl->n; k++)
        ldl->place[sequence[k]] = k;
    errno = ENOMEM;
    done = done && fill_pattern(ldl, rows, columns, count, pattern) && compile(ldl, pattern);
    free_pattern(pattern, ldl->n);
    return done;
}

static gboolean compile_forest(TinkerSparseLdl *ldl)
{
    for (int k = 0; k < ldl->n; k++)
        ldl->place[ldl->sequence[k]] = k;
    ldl->parent_places = g_try_new0(int, MAX(ldl->n, 1));
    if (ldl->parent_places == NULL || !allot_values(ldl, (gsize)ldl->n)) return FALSE;
    for (int k = 0; k < ldl->n; k++)
        ldl->parent_places[k] = ldl->place[ldl->parents[k]];
    return TRUE;
}

TinkerSparseLdl *tinker_sparse_ldl_new(int n, const int *rows, const int *columns, gsize count)
{
    return tinker_sparse_ldl_new_bordered(n, 0, rows, columns, count);
}

TinkerSparseLdl *tinker_sparse_ldl_new_bordered(int n, int border, const int *rows, const int *columns, gsize count)
{
    TinkerSparseLdl *ldl = g_new0(TinkerSparseLdl, 1);
    Neighbours by = {NULL, NULL};
    ldl->n = n;
    ldl->border = border;
    ldl->place = g_try_new0(int, MAX(n, 1));
    ldl->sequence = g_try_new0(int, MAX(n, 1));
    ldl->parents = g_try_new0(int, MAX(n, 1));
    errno = ENOMEM;
    gboolean done = ldl->place != NULL && ldl->sequence != NULL && ldl->parents != NULL &&
                    find_neighbours(&by, n, rows, columns, count) && peel(ldl, &by) &&
                    (ldl->is_forest ? compile_forest(ldl) : compile_general(ldl, &by, rows, columns, count));
    const int reason = errno;
    g_free(by.starts);
    g_free(by.entries);
    if (!done) g_clear_pointer(&ldl, tinker_sparse_ldl_free);
    errno = reason;
    return ldl;
}

void tinker_sparse_ldl_free(TinkerSparseLdl *ldl)
{
    if (ldl == NULL) return;
    g_free(ldl->place);
    g_free(ldl->starts);
    g_free(ldl->rows);
    g_free(ldl->updates);
    g_free(ldl->values);
    g_free(ldl->diagonal);
    g_free(ldl->work);
    g_free(ldl->left_out);
    g_free(ldl->sequence);
    g_free(ldl->parents);
    g_free(ldl->parent_places);
    g_free(ldl);
}

int tinker_sparse_ldl_slot(const TinkerSparseLdl *ldl, int row, int column)
{
    int i = ldl->place[row], j = ldl->place[column];
    return slot_of(ldl, MAX(i, j), MIN(i, j));
}

double *tinker_sparse_ldl_values(TinkerSparseLdl *ldl)
{
    return ldl->values;
}

gsize tinker_sparse_ldl_fill(const TinkerSparseLdl *ldl)
{
    return (gsize)(ldl->is_forest ? ldl->n : ldl->starts[ldl->n]);
}

gsize tinker_sparse_ldl_updates(const TinkerSparseLdl *ldl)
{
    gsize updates = 0;
    for (int k = 0; !ldl->is_forest && k < ldl->n; k++) {
        const gsize length = (gsize)(ldl->starts[k + 1] - ldl->starts[k]);
        updates += length * (length + 1) / 2;
    }
    return ldl->is_forest ? (gsize)ldl->n : updates;
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
