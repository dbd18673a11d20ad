/* All points are thinned anew only once they are a good deal more than at the last time. */
#include "gui/curve/thin-path.h"

#include <math.h>

#include "gui/widget/path-thin.h"

#define SHARE 3000.0 /* of the range: less than a pixel */
#define TAIL  50     /* the part of the points that may be new before all are thinned again */

void tinker_thin_path_init(TinkerThinPath *path)
{
    path->kept = g_array_new(FALSE, FALSE, sizeof(guint));
    path->x = g_array_new(FALSE, FALSE, sizeof(double));
    path->y = g_array_new(FALSE, FALSE, sizeof(double));
    path->thinned = 0;
}

void tinker_thin_path_clear(TinkerThinPath *path)
{
    GArray *arrays[] = {path->kept, path->x, path->y};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_array_unref(arrays[i]);
}

void tinker_thin_path_forget(TinkerThinPath *path)
{
    g_array_set_size(path->kept, 0);
    path->thinned = 0;
}

static double range_of(const double *values, gsize count)
{
    double least = INFINITY, greatest = -INFINITY;
    for (gsize i = 0; i < count; i++) {
        least = values[i] < least ? values[i] : least;
        greatest = values[i] > greatest ? values[i] : greatest;
    }
    return greatest > least ? greatest - least : 1;
}

void tinker_thin_path_update(TinkerThinPath *path, const double *x, const double *y, gsize count)
{
    if (count > path->thinned + path->thinned / TAIL) {
        double tolerance[2] = {range_of(x, count) / SHARE, range_of(y, count) / SHARE};
        g_array_set_size(path->kept, 0);
        tinker_path_thin(x, y, count, tolerance, path->kept);
        path->thinned = count;
    }
    for (guint i = g_array_index(path->kept, guint, path->kept->len - 1) + 1; i < count; i++)
        g_array_append_val(path->kept, i);
    g_array_set_size(path->x, 0);
    g_array_set_size(path->y, 0);
    for (guint i = 0; i < path->kept->len; i++) {
        const guint point = g_array_index(path->kept, guint, i);
        g_array_append_val(path->x, x[point]);
        g_array_append_val(path->y, y[point]);
    }
}
