/* Breadth-first search, level by level, neighbours of small degree first, from a row at the far end of its component.
 */
#include "numerics/solve/narrow-band.h"

#include <glib.h>
#include <string.h>

/* Searches for a start that is farther away; each finds a longer way or ends. */
#define MOST_SEARCHES 8

typedef struct {
    const TinkerPattern *pattern;
    int32_t *queue;
    int32_t *level; /* -1: not reached */
} Search;

static int32_t degree(const TinkerPattern *pattern, int32_t row)
{
    return pattern->row_starts[row + 1] - pattern->row_starts[row];
}

/* Of equal degree, in the order of their rows. */
static int compare_degrees(const void *left, const void *right, void *data)
{
    const TinkerPattern *pattern = data;
    int32_t l = *(const int32_t *)left, r = *(const int32_t *)right;
    int32_t difference = degree(pattern, l) - degree(pattern, r);
    return difference != 0 ? difference : l - r;
}

/* Reaches the component of `start`, into the queue from `first` on; answers where the queue ends. */
static int32_t reach(Search *search, int32_t start, int32_t first)
{
    const TinkerPattern *pattern = search->pattern;
    int32_t end = first;
    search->queue[end++] = start;
    search->level[start] = 0;
    for (int32_t i = first; i < end; i++) {
        int32_t row = search->queue[i], before = end;
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++) {
            int32_t other = pattern->columns[k];
            if (search->level[other] >= 0) continue;
            search->level[other] = search->level[row] + 1;
            search->queue[end++] = other;
        }
        g_qsort_with_data(search->queue + before, end - before, sizeof(int32_t), compare_degrees, (void *)pattern);
    }
    return end;
}

/* The component of `start`, from the far end that repeated searches find. */
static int32_t reach_from_far_end(Search *search, int32_t start, int32_t first)
{
    int32_t length = -1, end = reach(search, start, first);
    for (int i = 0; i < MOST_SEARCHES && search->level[search->queue[end - 1]] > length; i++) {
        int32_t far = search->queue[end - 1];
        length = search->level[far];
        for (int32_t k = first; k < end; k++)
            search->level[search->queue[k]] = -1;
        end = reach(search, far, first);
    }
    return end;
}

static int32_t bandwidth(const TinkerPattern *pattern, const int32_t *place)
{
    int32_t widest = 0;
    for (int32_t row = 0; row < pattern->size; row++)
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
            widest = MAX(widest, ABS(place[row] - place[pattern->columns[k]]));
    return widest;
}

int32_t tinker_narrow_band(const TinkerPattern *pattern, int32_t *place)
{
    int32_t n = pattern->size, end = 0;
    g_autofree int32_t *queue = g_new(int32_t, MAX(n, 1)), *level = g_new(int32_t, MAX(n, 1));
    for (int32_t i = 0; i < n; i++) {
        level[i] = -1;
        place[i] = i;
    }
    int32_t natural = bandwidth(pattern, place);
    Search search = {pattern, queue, level};
    for (int32_t i = 0; i < n; i++)
        if (level[i] < 0) end = reach_from_far_end(&search, i, end);
    for (int32_t i = 0; i < n; i++)
        place[queue[i]] = n - 1 - i;
    int32_t found = bandwidth(pattern, place);
    if (found < natural) return found;
    for (int32_t i = 0; i < n; i++)
        place[i] = i;
    return natural;
}
