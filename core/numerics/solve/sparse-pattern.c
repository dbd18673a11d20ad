/* What depends on the pattern alone: when column k is eliminated, the product of its entries p and q is subtracted at a
 * place that never changes; `updates` lists these places in the order in which they are needed.
 *
 * A pattern without cycles (a chain of rods, a tree) needs no ordering by AMD: eliminating leaves first leaves every
 * column with one entry, the one of its parent, and no update lists. From both ends of a chain at once these are two
 * runs of divisions that do not wait for each other. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "numerics/solve/elimination-order.h"
#include "numerics/solve/sparse-ldl-private.h"

/* Beyond this many updates a factorisation takes longer than anybody waits for at every stage of a step. */
#define MOST_UPDATES ((gsize)400000000)

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

static void free_pattern(Column *pattern, int n)
{
    for (int k = 0; pattern != NULL && k < n; k++)
        g_free(pattern[k].rows);
    g_free(pattern);
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
        column->length = tinker_sort_uniquely(column->rows, column->length);
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
        bsearch(&row, first, (gsize)(ldl->starts[column + 1] - ldl->starts[column]), sizeof(int), tinker_compare_ints);
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

static gboolean compile_general(TinkerSparseLdl *ldl, const TinkerNeighbours *by, const int *rows, const int *columns,
                                gsize count)
{
    g_autofree int *sequence = g_try_new(int, MAX(ldl->n, 1));
    Column *pattern = g_try_new0(Column, MAX(ldl->n, 1));
    gboolean done = sequence != NULL && pattern != NULL && tinker_neighbours_order(by, ldl->border, sequence);
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

/* A forest, unless a cycle is left over. FALSE: no memory. */
static gboolean peel(TinkerSparseLdl *ldl, const TinkerNeighbours *by)
{
    const int taken = tinker_neighbours_peel(by, ldl->sequence, ldl->parents);
    ldl->is_forest = taken == ldl->n && ldl->border == 0;
    return taken >= 0;
}

TinkerSparseLdl *tinker_sparse_ldl_new(int n, const int *rows, const int *columns, gsize count)
{
    return tinker_sparse_ldl_new_bordered(n, 0, rows, columns, count);
}

TinkerSparseLdl *tinker_sparse_ldl_new_bordered(int n, int border, const int *rows, const int *columns, gsize count)
{
    TinkerSparseLdl *ldl = g_new0(TinkerSparseLdl, 1);
    TinkerNeighbours by = {0};
    ldl->n = n;
    ldl->border = border;
    ldl->place = g_try_new0(int, MAX(n, 1));
    ldl->sequence = g_try_new0(int, MAX(n, 1));
    ldl->parents = g_try_new0(int, MAX(n, 1));
    errno = ENOMEM;
    gboolean done = ldl->place != NULL && ldl->sequence != NULL && ldl->parents != NULL &&
                    tinker_neighbours_init(&by, n, rows, columns, count) && peel(ldl, &by) &&
                    (ldl->is_forest ? compile_forest(ldl) : compile_general(ldl, &by, rows, columns, count));
    const int reason = errno;
    tinker_neighbours_clear(&by);
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
