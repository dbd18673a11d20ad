/* Rows of a model about one state. Their rank is that of J M^-1/2. */
#include "analysis/modes/null-space-private.h"

#include <math.h>
#include <string.h>

#include "analysis/modes/modal-basis.h"

gboolean tinker_null_space_of(const TinkerLinearisation *linear, TinkerNullSpace *space)
{
    tinker_null_space_open(space, (int32_t)linear->rows->len, linear->size);
    for (guint row = 0; row < linear->rows->len; row++) {
        const TinkerLinearTerm *term = &g_array_index(linear->rows, TinkerLinearTerm, row);
        for (guint k = 0; k < term->count; k++) {
            const TinkerLinearEntry *entry = &g_array_index(linear->entries, TinkerLinearEntry, term->first + k);
            if (entry->coordinate >= linear->size) continue;
            space->r[(gsize)linear->size * row + (gsize)entry->coordinate] +=
                entry->value / sqrt(linear->mass[entry->coordinate]);
        }
    }
    return tinker_null_space_find(space);
}

/* R^T y = P^T b in the rows that count, x = M^-1/2 Q y. */
gboolean tinker_linearisation_follow(const TinkerLinearisation *linear, const double *b, double *x)
{
    gsize n = (gsize)linear->size;
    memset(x, 0, n * sizeof(double));
    if (linear->rows->len == 0 || n == 0) return TRUE;
    g_auto(TinkerNullSpace) space = {0};
    gboolean found = tinker_null_space_of(linear, &space);
    g_autofree double *y = g_new0(double, MAX(space.rank, 1));
    for (int32_t i = 0; found && i < space.rank; i++) {
        double sum = b[space.pivot[i]];
        for (int32_t k = 0; k < i; k++)
            sum -= space.r[(gsize)k + n * (gsize)i] * y[k];
        y[i] = sum / space.r[(gsize)i + n * (gsize)i];
        for (gsize c = 0; c < n; c++)
            x[c] += space.q[c + n * (gsize)i] * y[i] / sqrt(linear->mass[c]);
    }
    return found;
}
