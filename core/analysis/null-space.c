/* QR with column pivoting; rank as everywhere: on J M^-1/2, 1e-10 of the largest counts as zero. */
#include "analysis/null-space-private.h"

#include <math.h>
#include <string.h>

#include <lapacke.h>

#include "analysis/modal-basis.h"

#define LEAST_PIVOT 1e-10

static void fill(const TinkerLinearisation *linear, double *matrix)
{
    for (guint row = 0; row < linear->rows->len; row++) {
        const TinkerLinearTerm *term = &g_array_index(linear->rows, TinkerLinearTerm, row);
        for (guint k = 0; k < term->count; k++) {
            const TinkerLinearEntry *entry = &g_array_index(linear->entries, TinkerLinearEntry, term->first + k);
            if (entry->coordinate >= linear->size) continue;
            matrix[(gsize)linear->size * row + (gsize)entry->coordinate] +=
                entry->value / sqrt(linear->mass[entry->coordinate]);
        }
    }
}

static gboolean decompose(TinkerNullSpace *space)
{
    int n = space->size, rows = space->rows, least = MIN(n, rows);
    g_autofree double *tau = g_new0(double, least);
    if (LAPACKE_dgeqp3(LAPACK_COL_MAJOR, n, rows, space->r, n, space->pivot, tau) != 0) return FALSE;
    while (space->rank < least &&
           fabs(space->r[space->rank + (gsize)n * (gsize)space->rank]) > LEAST_PIVOT * fabs(space->r[0]))
        space->rank++;
    for (int row = 0; row < rows; row++)
        space->pivot[row]--;
    memcpy(space->q, space->r, sizeof(double) * (gsize)n * (gsize)least);
    return LAPACKE_dorgqr(LAPACK_COL_MAJOR, n, n, least, space->q, n, tau) == 0;
}

gboolean tinker_null_space_find(TinkerNullSpace *space, const TinkerLinearisation *linear)
{
    gsize n = (gsize)linear->size, rows = linear->rows->len;
    *space = (TinkerNullSpace){
        .size = linear->size,
        .rows = (int32_t)rows,
        .q = g_new0(double, n *n),
        .r = g_new0(double, n *rows),
        .pivot = g_new0(int32_t, rows),
    };
    fill(linear, space->r);
    for (gsize i = 0; i < n * rows; i++)
        if (!isfinite(space->r[i])) return FALSE;
    return decompose(space);
}

void tinker_null_space_clear(TinkerNullSpace *space)
{
    g_free(space->q);
    g_free(space->r);
    g_free(space->pivot);
}

/* R^T y = P^T b in the rows that count, x = M^-1/2 Q y. */
gboolean tinker_linearisation_follow(const TinkerLinearisation *linear, const double *b, double *x)
{
    gsize n = (gsize)linear->size;
    memset(x, 0, n * sizeof(double));
    if (linear->rows->len == 0 || n == 0) return TRUE;
    TinkerNullSpace space;
    gboolean found = tinker_null_space_find(&space, linear);
    g_autofree double *y = g_new0(double, MAX(space.rank, 1));
    for (int32_t i = 0; found && i < space.rank; i++) {
        double sum = b[space.pivot[i]];
        for (int32_t k = 0; k < i; k++)
            sum -= space.r[(gsize)k + n * (gsize)i] * y[k];
        y[i] = sum / space.r[(gsize)i + n * (gsize)i];
        for (gsize c = 0; c < n; c++)
            x[c] += space.q[c + n * (gsize)i] * y[i] / sqrt(linear->mass[c]);
    }
    tinker_null_space_clear(&space);
    return found;
}
