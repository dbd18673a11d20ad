/* QR with column pivoting: beside singular values it costs a fraction, and tells which rows depend on others. */
#include "numerics/solve/null-space.h"

#include <math.h>

#include "numerics/solve/lapack.h"
#include "numerics/solve/rank.h"

void tinker_null_space_open(TinkerNullSpace *space, int32_t rows, int32_t size)
{
    const gsize n = (gsize)size, columns = (gsize)rows;
    *space = (TinkerNullSpace){
        .size = size,
        .rows = rows,
        .q = g_new0(double, MAX(n * n, 1)),
        .r = g_new0(double, MAX(n * columns, 1)),
        .pivot = g_new0(int32_t, MAX(columns, 1)),
    };
}

gboolean tinker_null_space_find(TinkerNullSpace *space)
{
    const gsize n = (gsize)space->size;
    const int32_t least = MIN(space->size, space->rows);
    for (gsize i = 0; i < n * (gsize)space->rows; i++)
        if (!isfinite(space->r[i])) return FALSE;
    for (gsize i = 0; least == 0 && i < n; i++)
        space->q[i + n * i] = 1;
    if (least == 0) return TRUE;
    if (!tinker_pivoted_qr(space->size, space->rows, space->r, space->q, space->pivot)) return FALSE;
    while (space->rank < least &&
           fabs(space->r[space->rank + (gint64)n * space->rank]) > TINKER_DEPENDENT * fabs(space->r[0]))
        space->rank++;
    return TRUE;
}

void tinker_null_space_clear(TinkerNullSpace *space)
{
    g_free(space->q);
    g_free(space->r);
    g_free(space->pivot);
    *space = (TinkerNullSpace){0};
}
