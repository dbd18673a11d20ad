/* A triangle of three successive corners that turns outwards and holds no other corner is an *ear*; each polygon with
 * more than three corners has two. Ears are cut off one by one, each time the one that is least narrow, so that
 * rounding finds no triangle without area. */
#include "physics/shapes/outline-parts.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/shapes/tolerances.h"

static double cross(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static double length(const double *a, const double *b)
{
    return hypot(b[0] - a[0], b[1] - a[1]);
}

static double area_of(const double *points, int32_t count)
{
    double twice = 0;
    for (int32_t i = 1; i + 1 < count; i++)
        twice += cross(points, points + 2 * i, points + 2 * (i + 1));
    return 0.5 * twice;
}

int32_t tinker_outline_normalise(const double *points, int32_t count, const double origin[2], double *corners)
{
    const gboolean turned = area_of(points, count) < 0;
    int32_t kept = 0;
    for (int32_t i = 0; i < count; i++) {
        const int32_t at = turned ? count - 1 - i : i, step = turned ? count - 1 : 1;
        const double *a = points + 2 * ((at + count - step) % count), *b = points + 2 * at,
                     *c = points + 2 * ((at + step) % count);
        if (fabs(cross(a, b, c)) <= TINKER_ON_ONE_LINE * length(a, b) * length(b, c)) continue;
        corners[2 * kept] = b[0] - origin[0];
        corners[2 * kept++ + 1] = b[1] - origin[1];
    }
    return kept;
}

gboolean tinker_outline_is_convex(const double *corners, int32_t count)
{
    for (int32_t i = 0; i < count; i++)
        if (cross(corners + 2 * i, corners + 2 * ((i + 1) % count), corners + 2 * ((i + 2) % count)) < 0) return FALSE;
    return TRUE;
}

static gboolean is_inside(const double *a, const double *b, const double *c, const double *p)
{
    return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;
}

/* How far the ear at corner i is from a line: its height over its longest side; below 0 where it is none. */
static double height_of_ear(const double *left, int32_t count, int32_t i)
{
    const double *a = left + 2 * ((i + count - 1) % count), *b = left + 2 * i, *c = left + 2 * ((i + 1) % count);
    const double area = cross(a, b, c);
    if (!(area > 0)) return -1;
    for (int32_t k = 0; k < count; k++) {
        const double *p = left + 2 * k;
        if (p != a && p != b && p != c && is_inside(a, b, c, p)) return -1;
    }
    return area / fmax(length(a, b), fmax(length(b, c), length(c, a)));
}

void tinker_outline_cut(const double *corners, int32_t count, double *triangles)
{
    g_autofree double *left = g_memdup2(corners, 2 * (gsize)count * sizeof(double));
    for (; count >= 3; count--, triangles += 6) {
        int32_t best = 0;
        double highest = -INFINITY;
        for (int32_t i = 0; i < count; i++) {
            const double height = height_of_ear(left, count, i);
            if (height <= highest) continue;
            highest = height;
            best = i;
        }
        memcpy(triangles, left + 2 * ((best + count - 1) % count), 2 * sizeof(double));
        memcpy(triangles + 2, left + 2 * best, 2 * sizeof(double));
        memcpy(triangles + 4, left + 2 * ((best + 1) % count), 2 * sizeof(double));
        memmove(left + 2 * best, left + 2 * (best + 1), 2 * (gsize)(count - 1 - best) * sizeof(double));
    }
}
