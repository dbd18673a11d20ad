/* Orders of elimination from the pattern alone. */
#include "numerics/solve/elimination-order.h"

#include <stdlib.h>
#include <string.h>
#include <suitesparse/amd.h>

gboolean tinker_neighbours_init(TinkerNeighbours *by, int n, const int *rows, const int *columns, gsize count)
{
    int *starts = g_try_new0(int, n + 2), *entries = g_try_new(int, 2 * count + 1);
    *by = (TinkerNeighbours){n, starts, entries};
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
        const int until = starts[i + 1];
        const gsize distinct = tinker_sort_uniquely(entries + from, (gsize)(until - from));
        memmove(entries + kept, entries + from, distinct * sizeof(int));
        starts[i] = kept;
        kept += (int)distinct;
        from = until;
    }
    starts[n] = kept;
    return TRUE;
}

void tinker_neighbours_clear(TinkerNeighbours *by)
{
    g_clear_pointer(&by->starts, g_free);
    g_clear_pointer(&by->entries, g_free);
}

int tinker_neighbours_peel(const TinkerNeighbours *by, int *sequence, int *parents)
{
    int taken = 0;
    g_autofree int *degree = g_try_new(int, MAX(by->n, 1));
    g_autofree gboolean *gone = g_try_new0(gboolean, MAX(by->n, 1));
    if (degree == NULL || gone == NULL) return -1;
    for (int i = 0; i < by->n; i++) {
        degree[i] = by->starts[i + 1] - by->starts[i];
        if (degree[i] <= 1) sequence[taken++] = i;
    }
    for (int seen = 0; seen < taken; seen++) {
        const int row = sequence[seen];
        gone[row] = TRUE;
        parents[seen] = row;
        for (int e = by->starts[row]; e < by->starts[row + 1]; e++) {
            const int other = by->entries[e];
            if (gone[other]) continue;
            parents[seen] = other;
            if (--degree[other] == 1) sequence[taken++] = other;
        }
    }
    return taken;
}

static void put_border_last(int n, int border, int *sequence)
{
    const int inner = n - border;
    int kept = 0;
    for (int k = 0; k < n; k++)
        if (sequence[k] < inner) sequence[kept++] = sequence[k];
    for (int i = inner; i < n; i++)
        sequence[i] = i;
}

gboolean tinker_neighbours_order(const TinkerNeighbours *by, int border, int *sequence)
{
    const int result = amd_order(by->n, by->starts, by->entries, sequence, NULL, NULL);
    for (int i = 0; result < 0 && i < by->n; i++)
        sequence[i] = i;
    if (border > 0) put_border_last(by->n, border, sequence);
    return result != AMD_OUT_OF_MEMORY;
}

gsize tinker_sort_uniquely(int *values, gsize count)
{
    if (count < 2) return count;
    qsort(values, count, sizeof(int), tinker_compare_ints);
    gsize kept = 1;
    for (gsize i = 1; i < count; i++)
        if (values[i] != values[kept - 1]) values[kept++] = values[i];
    return kept;
}
