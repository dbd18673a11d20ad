/* Matrices of islands with many coordinates, most of whose entries are 0. */
#include "equations/matrix/matrix-private.h"
#include "law/build.h"

void tinker_matrix_sparse_init(TinkerMatrixIsland *island)
{
    for (int kind = 0; kind < TINKER_MATRICES; kind++)
        island->sparse[kind] =
            g_hash_table_new_full(g_direct_hash, g_direct_equal, NULL, (GDestroyNotify)tinker_expression_unref);
}

void tinker_matrix_sparse_add(TinkerMatrixIsland *island, TinkerMatrixKind kind, guint number, TinkerExpression *more)
{
    TinkerExpression *before = g_hash_table_lookup(island->sparse[kind], GUINT_TO_POINTER(number));
    TinkerExpression *sum = before != NULL ? tinker_expression_plus(tinker_expression_ref(before), more) : more;
    g_hash_table_insert(island->sparse[kind], GUINT_TO_POINTER(number), sum);
}

static int by_number(const void *left, const void *right)
{
    const guint l = GPOINTER_TO_UINT(*(const gpointer *)left), r = GPOINTER_TO_UINT(*(const gpointer *)right);
    return l < r ? -1 : l > r;
}

void tinker_matrix_each(const TinkerMatrixIsland *island, TinkerMatrixKind kind, TinkerMatrixFunc func, void *data)
{
    const guint n = island->coordinates->len;
    guint count = n * n;
    g_autofree gpointer *numbers = NULL;
    if (island->sparse[kind] != NULL) {
        numbers = g_hash_table_get_keys_as_array(island->sparse[kind], &count);
        qsort(numbers, count, sizeof *numbers, by_number);
    }
    for (guint i = 0; i < count; i++) {
        const guint number = numbers != NULL ? GPOINTER_TO_UINT(numbers[i]) : i;
        const TinkerExpression *entry = numbers != NULL ? g_hash_table_lookup(island->sparse[kind], numbers[i])
                                                        : g_ptr_array_index(island->matrices[kind], i);
        if (!tinker_expression_is_number(entry, 0)) func(number / n, number % n, entry, data);
    }
}
