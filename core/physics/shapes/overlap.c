/* How far two shapes overlap. Two convex shapes are apart where they are so along a normal of one of their edges or
 * along the way from a corner to the centre of a disc: the axes of separation. */
#include <math.h>

#include "physics/shapes/gaps.h"

static void place_of(const TinkerBodyPose *pose, const double local[2], double out[2])
{
    const double c = pose->cosine, s = pose->sine;
    out[0] = pose->x + c * local[0] - s * local[1];
    out[1] = pose->y + s * local[0] + c * local[1];
}

/* The shadow of a shape along a direction of length 1. */
static void shadow_of(const TinkerOutline *outline, const TinkerBodyPose *pose, const double axis[2], double shadow[2])
{
    if (outline->kind == TINKER_OUTLINE_DISC) {
        const double middle = axis[0] * pose->x + axis[1] * pose->y;
        shadow[0] = middle - outline->radius;
        shadow[1] = middle + outline->radius;
        return;
    }
    shadow[0] = INFINITY;
    shadow[1] = -INFINITY;
    for (int32_t i = 0; i < outline->count; i++) {
        double at[2];
        place_of(pose, outline->corners + 2 * i, at);
        const double along = axis[0] * at[0] + axis[1] * at[1];
        shadow[0] = fmin(shadow[0], along);
        shadow[1] = fmax(shadow[1], along);
    }
}

typedef struct {
    const TinkerOutline *outline[2];
    const TinkerBodyPose *pose[2];
    double least;
} Pair;

static void try_axis(Pair *pair, double x, double y)
{
    const double length = hypot(x, y), axis[2] = {x / length, y / length};
    double first[2], second[2];
    if (!(length > 0)) return;
    shadow_of(pair->outline[0], pair->pose[0], axis, first);
    shadow_of(pair->outline[1], pair->pose[1], axis, second);
    pair->least = fmin(pair->least, fmin(first[1] - second[0], second[1] - first[0]));
}

static void try_axes_of(Pair *pair, int which)
{
    const TinkerOutline *outline = pair->outline[which], *other = pair->outline[1 - which];
    const TinkerBodyPose *pose = pair->pose[which], *at_other = pair->pose[1 - which];
    if (outline->kind == TINKER_OUTLINE_DISC) {
        if (other->kind == TINKER_OUTLINE_DISC) try_axis(pair, at_other->x - pose->x, at_other->y - pose->y);
        return;
    }
    for (int32_t i = 0; i < outline->count; i++) {
        double a[2], b[2];
        place_of(pose, outline->corners + 2 * i, a);
        place_of(pose, outline->corners + 2 * ((i + 1) % outline->count), b);
        try_axis(pair, b[1] - a[1], a[0] - b[0]);
        if (outline->count == 2) try_axis(pair, b[0] - a[0], b[1] - a[1]); /* past an end of a line */
        if (other->kind == TINKER_OUTLINE_DISC) try_axis(pair, at_other->x - a[0], at_other->y - a[1]);
    }
}

/* Over a top from -half to half along its x: the least and the greatest height of a convex shape over it. FALSE: no
 * part of it is over the top; *beside is how far it is beside it. */
typedef struct {
    double along[2], height[2], beside;
} Over;

static void take(Over *over, double height)
{
    over->height[0] = fmin(over->height[0], height);
    over->height[1] = fmax(over->height[1], height);
}

static void take_line(Over *over, const double a[2], const double b[2])
{
    for (int k = 0; k < 2; k++) {
        const double at = over->along[k], span = b[0] - a[0], share = span != 0 ? (at - a[0]) / span : -1;
        if (share >= 0 && share <= 1) take(over, a[1] + share * (b[1] - a[1]));
    }
    if (a[0] >= over->along[0] && a[0] <= over->along[1]) take(over, a[1]);
    over->beside = fmin(over->beside, fmax(over->along[0] - a[0], a[0] - over->along[1]));
}

static void take_disc(Over *over, const double at[2], double radius)
{
    const double nearest = fmin(fmax(at[0], over->along[0]), over->along[1]), off = fabs(at[0] - nearest);
    over->beside = off - radius;
    if (off > radius) return;
    const double half = sqrt(radius * radius - off * off);
    take(over, at[1] - half);
    take(over, at[1] + half);
}

static double overlap_of_top(const TinkerOutline *top, const TinkerBodyPose *at_top, const TinkerOutline *other,
                             const TinkerBodyPose *at_other)
{
    Over over = {{top->corners[0], top->corners[2]}, {INFINITY, -INFINITY}, INFINITY};
    const double c = at_top->cosine, s = at_top->sine, raised = top->corners[1];
    double before[2] = {0, 0};
    const int32_t count = other->kind == TINKER_OUTLINE_DISC ? 0 : other->count;
    for (int32_t i = 0; i <= count; i++) {
        const double centre[2] = {0, 0};
        double at[2], local[2];
        place_of(at_other, count == 0 ? centre : other->corners + 2 * (i % count), at);
        const double dx = at[0] - at_top->x, dy = at[1] - at_top->y;
        local[0] = c * dx + s * dy;
        local[1] = c * dy - s * dx - raised;
        if (count == 0) take_disc(&over, local, other->radius);
        if (i > 0) take_line(&over, before, local);
        before[0] = local[0];
        before[1] = local[1];
    }
    return over.height[1] < over.height[0] ? -over.beside : fmin(-over.height[0], over.height[1]);
}

/* Of two of which one is no convex shape: the most of any of its parts. */
static double overlap_of_parts(const TinkerOutline *whole, const TinkerBodyPose *at_whole, const TinkerOutline *other,
                               const TinkerBodyPose *at_other)
{
    double most = -INFINITY;
    for (int32_t i = 0; i < whole->triangle_count; i++) {
        const TinkerOutline part = {TINKER_OUTLINE_POLYGON, whole->radius, 3, whole->triangles + 6 * i, 0, NULL};
        most = fmax(most, tinker_outlines_overlap(&part, at_whole, other, at_other));
    }
    return most;
}

double tinker_outlines_overlap(const TinkerOutline *first, const TinkerBodyPose *at_first, const TinkerOutline *second,
                               const TinkerBodyPose *at_second)
{
    if (first->triangles != NULL) return overlap_of_parts(first, at_first, second, at_second);
    if (second->triangles != NULL) return overlap_of_parts(second, at_second, first, at_first);
    if (first->kind == TINKER_OUTLINE_TOP) return overlap_of_top(first, at_first, second, at_second);
    if (second->kind == TINKER_OUTLINE_TOP) return overlap_of_top(second, at_second, first, at_first);
    Pair pair = {{first, second}, {at_first, at_second}, INFINITY};
    try_axes_of(&pair, 0);
    try_axes_of(&pair, 1);
    return isfinite(pair.least) ? pair.least : 0; /* two points */
}
