/* From the last point that was kept, the anchor, all straight lines that pass every later point within the tolerance
 * lie in a cone. It gets narrower with each point; one outside of it, or behind points that were passed before, makes
 * the point before it the next anchor. Source: J. Sklansky, V. Gonzalez, Fast polygonal approximation of digitized
 * curves (1980). */
#include "gui/widget/path-thin.h"

#include <math.h>
#include <string.h>

/* Directions, of length 1, in units of the tolerances. */
typedef struct {
    gboolean is_open; /* no point was beyond the tolerance yet: all directions */
    double left[2], right[2];
    double farthest; /* from the anchor, so far */
} Cone;

static double cross(const double a[2], const double b[2])
{
    return a[0] * b[1] - a[1] * b[0];
}

/* Whether the way from the anchor, of this length, leads on. */
static gboolean leads_on(const Cone *cone, const double way[2], double length)
{
    if (length + 1 < cone->farthest) return FALSE;
    return cone->is_open || length <= 1 || (cross(cone->right, way) >= 0 && cross(way, cone->left) >= 0);
}

/* Leaves only directions that pass the end of the way within 1. */
static void narrow(Cone *cone, const double way[2], double length)
{
    cone->farthest = fmax(cone->farthest, length);
    if (length <= 1) return;
    double along[2] = {way[0] / length, way[1] / length}, sine = 1 / length, cosine = sqrt(1 - sine * sine);
    double left[2] = {cosine * along[0] - sine * along[1], cosine * along[1] + sine * along[0]};
    double right[2] = {cosine * along[0] + sine * along[1], cosine * along[1] - sine * along[0]};
    if (cone->is_open || cross(left, cone->left) > 0) memcpy(cone->left, left, sizeof left);
    if (cone->is_open || cross(cone->right, right) > 0) memcpy(cone->right, right, sizeof right);
    cone->is_open = FALSE;
}

/* What a path is thinned to so far. */
typedef struct {
    const double *x, *y, *tolerance;
    GArray *kept;
    guint anchor;
    Cone cone;
} Thinning;

static void keep(Thinning *thinning, guint point)
{
    GArray *kept = thinning->kept;
    if (kept->len == 0 || g_array_index(kept, guint, kept->len - 1) != point) g_array_append_val(kept, point);
    thinning->anchor = point;
    thinning->cone = (Cone){.is_open = TRUE};
}

/* The way from the anchor to a point. Answers its length. */
static double way_to(const Thinning *thinning, guint point, double way[2])
{
    way[0] = (thinning->x[point] - thinning->x[thinning->anchor]) / thinning->tolerance[0];
    way[1] = (thinning->y[point] - thinning->y[thinning->anchor]) / thinning->tolerance[1];
    return hypot(way[0], way[1]);
}

void tinker_path_thin(const double *x, const double *y, gsize count, const double tolerance[2], GArray *kept)
{
    Thinning thinning = {.x = x, .y = y, .tolerance = tolerance, .kept = kept};
    for (guint point = 0; point < count; point++) {
        double way[2], length = way_to(&thinning, point, way);
        if (point == 0 || !isfinite(length)) { /* there is no way over a gap */
            if (point > 0) keep(&thinning, point - 1);
            keep(&thinning, point);
            continue;
        }
        if (!leads_on(&thinning.cone, way, length)) {
            keep(&thinning, point - 1);
            length = way_to(&thinning, point, way);
        }
        narrow(&thinning.cone, way, length);
    }
    if (count > 0) keep(&thinning, (guint)count - 1);
}
