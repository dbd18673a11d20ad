#include "shape-distances.h"

#include <math.h>

static const double box_corners[] = {-0.5, -0.2, 0.5, -0.2, 0.5, 0.2, -0.5, 0.2};
static const double triangle_corners[] = {-0.4, -0.3, 0.6, -0.1, -0.1, 0.5};
static const double hexagon_corners[] = {0.4, 0, 0.2, 0.35, -0.2, 0.35, -0.4, 0, -0.2, -0.35, 0.2, -0.35};
static const double line_corners[] = {-0.6, 0, 0.6, 0};
static const double top_corners[] = {-0.7, 0.1, 0.7, 0.1};

/* An L, an arrow whose notch is deep, and how they are cut into triangles (any that are right will do for the tests).
 */
static const double angle_corners[] = {-0.2, -0.2, 0.6, -0.2, 0.6, 0, 0, 0, 0, 0.5, -0.2, 0.5};
static const double angle_parts[] = {-0.2, -0.2, 0.6, -0.2, 0.6, 0,   -0.2, -0.2, 0.6, 0,   0,    0,
                                     -0.2, -0.2, 0,   0,    0,   0.5, -0.2, -0.2, 0,   0.5, -0.2, 0.5};
static const double arrow_corners[] = {0.5, 0, -0.4, 0.4, -0.1, 0, -0.4, -0.4};
static const double arrow_parts[] = {0.5, 0, -0.4, 0.4, -0.1, 0, 0.5, 0, -0.1, 0, -0.4, -0.4};

const TinkerOutline shapes[8] = {
    {TINKER_OUTLINE_POLYGON, 0.6, 4, box_corners},
    {TINKER_OUTLINE_POLYGON, 0.7, 3, triangle_corners},
    {TINKER_OUTLINE_POLYGON, 0.5, 6, hexagon_corners},
    {TINKER_OUTLINE_DISC, 0.3, 0, NULL},
    {TINKER_OUTLINE_DISC, 0.5, 0, NULL},
    {TINKER_OUTLINE_POLYGON, 0.6, 2, line_corners},
    {TINKER_OUTLINE_POLYGON, 0.7, 6, angle_corners, 4, angle_parts},
    {TINKER_OUTLINE_POLYGON, 0.6, 4, arrow_corners, 2, arrow_parts},
};
const TinkerOutline shape_top = {TINKER_OUTLINE_TOP, 0.75, 2, top_corners};

double shape_between(GRand *random, double from, double to)
{
    return g_rand_double_range(random, from, to);
}

TinkerBodyPose shape_turned_by(TinkerBodyPose pose, double angle)
{
    pose.angle = angle;
    pose.cosine = cos(angle);
    pose.sine = sin(angle);
    return pose;
}

TinkerBodyPose shape_random_pose(GRand *random)
{
    const TinkerBodyPose pose = {shape_between(random, -1.2, 1.2), shape_between(random, -1.2, 1.2),
                                 shape_between(random, -7, 7),     shape_between(random, -2, 2),
                                 shape_between(random, -2, 2),     shape_between(random, -3, 3)};
    return shape_turned_by(pose, pose.angle);
}

void shape_corner_at(const TinkerOutline *outline, const TinkerBodyPose *pose, int32_t number, double at[2])
{
    const double *local = outline->corners + 2 * (number % outline->count), c = cos(pose->angle), s = sin(pose->angle);
    at[0] = pose->x + c * local[0] - s * local[1];
    at[1] = pose->y + s * local[0] + c * local[1];
}

double shape_from_segment(const double p[2], const double a[2], const double b[2])
{
    const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    const double share = fmax(0, fmin(1, ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square));
    return hypot(p[0] - a[0] - share * x, p[1] - a[1] - share * y);
}

double shape_from_polygon(const double p[2], const TinkerOutline *outline, const TinkerBodyPose *pose)
{
    double least = INFINITY;
    gboolean inside = FALSE; /* where a ray upwards crosses an odd number of edges */
    for (int32_t i = 0; i < outline->count; i++) {
        double a[2], b[2];
        shape_corner_at(outline, pose, i, a);
        shape_corner_at(outline, pose, i + 1, b);
        least = fmin(least, shape_from_segment(p, a, b));
        const gboolean spans = outline->count > 2 && (a[0] > p[0]) != (b[0] > p[0]);
        if (spans && p[1] < a[1] + (p[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1])) inside = !inside;
    }
    return inside ? -least : least;
}

double shape_side_of(const double a[2], const double b[2], const double p[2])
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static gboolean sides_cross(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                            const TinkerBodyPose *q)
{
    for (int32_t i = 0; i < first->count; i++)
        for (int32_t k = 0; k < second->count; k++) {
            double a[2], b[2], c[2], d[2];
            shape_corner_at(first, p, i, a);
            shape_corner_at(first, p, i + 1, b);
            shape_corner_at(second, q, k, c);
            shape_corner_at(second, q, k + 1, d);
            if (shape_side_of(a, b, c) * shape_side_of(a, b, d) < 0 &&
                shape_side_of(c, d, a) * shape_side_of(c, d, b) < 0)
                return TRUE;
        }
    return FALSE;
}

double shape_distance(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                      const TinkerBodyPose *q)
{
    const double at_p[2] = {p->x, p->y}, at_q[2] = {q->x, q->y};
    const gboolean disc = first->kind == TINKER_OUTLINE_DISC, other_disc = second->kind == TINKER_OUTLINE_DISC;
    if (disc && other_disc) return hypot(p->x - q->x, p->y - q->y) - first->radius - second->radius;
    if (disc) return shape_from_polygon(at_p, second, q) - first->radius;
    if (other_disc) return shape_from_polygon(at_q, first, p) - second->radius;
    double least = sides_cross(first, p, second, q) ? -1 : INFINITY;
    for (int32_t i = 0; i < first->count; i++) {
        double at[2];
        shape_corner_at(first, p, i, at);
        least = fmin(least, shape_from_polygon(at, second, q));
    }
    for (int32_t i = 0; i < second->count; i++) {
        double at[2];
        shape_corner_at(second, q, i, at);
        least = fmin(least, shape_from_polygon(at, first, p));
    }
    return least;
}

double shape_nearest_corners(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                             const TinkerBodyPose *q)
{
    double least = INFINITY;
    for (int32_t i = 0; i < first->count; i++)
        for (int32_t k = 0; k < second->count; k++) {
            double a[2], b[2];
            shape_corner_at(first, p, i, a);
            shape_corner_at(second, q, k, b);
            least = fmin(least, hypot(a[0] - b[0], a[1] - b[1]));
        }
    return least;
}
