/* Blocks of the lowest level are of points, those of each further one of blocks of the level below. Only whole blocks
 * are kept: what is behind the last one is looked at a level lower. */
#include "render/plot/curve-index.h"

#include <math.h>

#define BLOCK  32
#define LEVELS 12 /* 32^12 points are more than there can be */

typedef struct {
    gsize least, greatest; /* points */
} Extremes;

struct _TinkerCurveIndex {
    GArray *levels[LEVELS]; /* of Extremes */
    gsize count;
    double last_x;
    gboolean ordered;
};

TinkerCurveIndex *tinker_curve_index_new(void)
{
    TinkerCurveIndex *index = g_new0(TinkerCurveIndex, 1);
    for (int level = 0; level < LEVELS; level++)
        index->levels[level] = g_array_new(FALSE, FALSE, sizeof(Extremes));
    tinker_curve_index_clear(index);
    return index;
}

void tinker_curve_index_free(TinkerCurveIndex *index)
{
    if (index == NULL) return;
    for (int level = 0; level < LEVELS; level++)
        g_array_unref(index->levels[level]);
    g_free(index);
}

void tinker_curve_index_clear(TinkerCurveIndex *index)
{
    for (int level = 0; level < LEVELS; level++)
        g_array_set_size(index->levels[level], 0);
    index->count = 0;
    index->last_x = -INFINITY;
    index->ordered = TRUE;
}

gsize tinker_curve_index_count(const TinkerCurveIndex *index)
{
    return index->count;
}

gboolean tinker_curve_index_is_ordered(const TinkerCurveIndex *index)
{
    return index->ordered;
}

static const Extremes *block_of(const TinkerCurveIndex *index, int level, gsize number)
{
    return &g_array_index(index->levels[level], Extremes, number);
}

static void widen(Extremes *extremes, const Extremes *by, const double *y)
{
    if (y[by->least] < y[extremes->least]) extremes->least = by->least;
    if (y[by->greatest] > y[extremes->greatest]) extremes->greatest = by->greatest;
}

/* The block of points that ends before `count`, and those above that it makes whole. */
static void close_blocks(TinkerCurveIndex *index, const double *y)
{
    Extremes extremes = {index->count - BLOCK, index->count - BLOCK};
    for (gsize i = index->count - BLOCK; i < index->count; i++)
        widen(&extremes, &(Extremes){i, i}, y);
    g_array_append_val(index->levels[0], extremes);
    for (int level = 1; level < LEVELS && index->levels[level - 1]->len % BLOCK == 0; level++) {
        const gsize first = index->levels[level - 1]->len - BLOCK;
        extremes = *block_of(index, level - 1, first);
        for (gsize i = 1; i < BLOCK; i++)
            widen(&extremes, block_of(index, level - 1, first + i), y);
        g_array_append_val(index->levels[level], extremes);
    }
}

void tinker_curve_index_add(TinkerCurveIndex *index, const double *x, const double *y, gsize count)
{
    while (index->ordered && index->count < count) {
        const double at = x[index->count];
        index->ordered = isfinite(at) && isfinite(y[index->count]) && at >= index->last_x;
        index->last_x = at;
        index->count++;
        if (index->count % BLOCK == 0) close_blocks(index, y);
    }
    index->count = count;
}

void tinker_curve_index_extremes(const TinkerCurveIndex *index, const double *y, gsize from, gsize to, gsize *least,
                                 gsize *greatest)
{
    Extremes all = {from, from};
    for (gsize i = from; i < to;) {
        /* the largest block that begins here and is within */
        gsize size = 1;
        int level = -1;
        while (level + 1 < LEVELS && i % (size * BLOCK) == 0 && i + size * BLOCK <= to &&
               i / (size * BLOCK) < index->levels[level + 1]->len) {
            level++;
            size *= BLOCK;
        }
        const Extremes point = {i, i};
        widen(&all, level < 0 ? &point : block_of(index, level, i / size), y);
        i += size;
    }
    *least = all.least;
    *greatest = all.greatest;
}

gsize tinker_curve_first_from(const double *x, gsize count, double from)
{
    gsize low = 0, high = count;
    while (low < high) {
        const gsize middle = low + (high - low) / 2;
        if (x[middle] < from)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
