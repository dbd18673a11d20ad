/* Separating axes and clipping. Source: C. Ericson, "Real-Time Collision Detection", Morgan Kaufmann 2005, sec. 5.2 and
 * 5.5. */
#include "physics/shapes/manifold.h"

#include <math.h>

#include "physics/shapes/tolerances.h"

static double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

void tinker_shape_corners(const TinkerOutline *outline, double *corners)
{
    const int32_t count = outline->count;
    const double side = outline->kind == TINKER_OUTLINE_TOP ? -1 : 1;
    for (int32_t i = 0; i < count; i++) {
        const double *from = outline->corners + 2 * i, *to = outline->corners + 2 * ((i + 1) % count);
        const double x = to[0] - from[0], y = to[1] - from[1], length = sqrt(x * x + y * y);
        corners[2 * i] = from[0];
        corners[2 * i + 1] = from[1];
        corners[2 * (count + i)] = length > 0 ? side * y / length : 0;
        corners[2 * (count + i) + 1] = length > 0 ? -side * x / length : 0;
    }
}

void tinker_place_shape(TinkerPlacedShape *shape, double x, double y, double cosine, double sine, const double *local)
{
    const int32_t count = shape->count;
    double *corners = shape->corners, *normals = shape->normals;
    shape->place[0] = x;
    shape->place[1] = y;
    for (int32_t i = 0; i < count; i++) {
        const double *at = local + 2 * i, *n = local + 2 * (count + i);
        corners[2 * i] = x + (cosine * at[0] - sine * at[1]);
        corners[2 * i + 1] = y + (sine * at[0] + cosine * at[1]);
        normals[2 * i] = cosine * n[0] - sine * n[1];
        normals[2 * i + 1] = sine * n[0] + cosine * n[1];
    }
}

/* Round the corners of a shape; a remainder would take longer than all else that is done for one. */
static int32_t next_corner(int32_t corner, const TinkerPlacedShape *shape)
{
    return corner + 1 < shape->count ? corner + 1 : 0;
}

/* Edges that may be seats: of a top its one. */
static int32_t edges_of(const TinkerPlacedShape *shape)
{
    return shape->count < 2 ? 0 : shape->kind == TINKER_OUTLINE_TOP ? 1 : shape->count;
}

/* The edge of `seats` that all of `tips` are farthest outside of, and how far. Against a top those alone count that
 * face it: it has no underside. */
static double farthest_edge(const TinkerPlacedShape *seats, const TinkerPlacedShape *tips, int32_t *edge)
{
    const int32_t edges = edges_of(seats), count = tips->count;
    const double *const corners = tips->corners;
    double best = -INFINITY;
    int32_t found = -1;
    for (int32_t i = 0; i < edges; i++) {
        const double *n = seats->normals + 2 * i, base = dot(n, seats->corners + 2 * i);
        if (tips->kind == TINKER_OUTLINE_TOP && !(dot(n, tips->normals) < -TINKER_UPRIGHT)) continue;
        double least = INFINITY;
        for (int32_t k = 0; k < count; k++) {
            const double out = dot(n, corners + 2 * k);
            least = out < least ? out : least;
        }
        if (!(least - base > best)) continue;
        best = least - base;
        found = i;
    }
    *edge = found;
    return best;
}

/* The edge of a shape that faces a normal most. */
static int32_t facing_edge(const TinkerPlacedShape *shape, const double n[2])
{
    int32_t facing = 0;
    double most = INFINITY;
    const int32_t edges = edges_of(shape);
    for (int32_t i = 0; i < edges; i++) {
        const double turned = dot(n, shape->normals + 2 * i);
        if (turned < most) {
            most = turned;
            facing = i;
        }
    }
    return facing;
}

typedef struct {
    double along, gap;
    int32_t corner;
} End;

/* A corner as seen from an edge that begins at `base` along t. */
static End end_at(const TinkerPlacedShape *shape, int32_t corner, const double base[2], const double t[2],
                  const double n[2], int32_t first)
{
    const double off[2] = {shape->corners[2 * corner] - base[0], shape->corners[2 * corner + 1] - base[1]};
    return (End){dot(t, off), dot(n, off), first + corner};
}

/* One end of the facing edge, cut off where the seat ends: `limit` along t, `seat_corner` there. */
static void cut(End *end, const End *other, double limit, double sign, int32_t seat_corner)
{
    if (!(sign * (end->along - limit) > 0)) return;
    const double share = (limit - end->along) / (other->along - end->along);
    end->gap += share * (other->gap - end->gap);
    end->along = limit;
    end->corner = seat_corner;
}

static void add_point(TinkerManifold *manifold, const double n[2], const double base[2], const End *end, double reach)
{
    if (end->gap > reach) return;
    TinkerManifoldPoint *point = &manifold->points[manifold->count++];
    *point = (TinkerManifoldPoint){
        end->gap,
        {base[0] + end->along * n[1] + end->gap * n[0], base[1] - end->along * n[0] + end->gap * n[1]},
        end->corner};
}

/* The points of the facing edge of `tips` over an edge of `seats`. */
static void clip(const TinkerPlacedShape *seats, int32_t seat, int32_t seat_base, const TinkerPlacedShape *tips,
                 int32_t tip_base, double reach, TinkerManifold *manifold)
{
    const int32_t next = next_corner(seat, seats);
    const int32_t facing = facing_edge(tips, seats->normals + 2 * seat);
    const double *n = seats->normals + 2 * seat, *base = seats->corners + 2 * seat, t[2] = {n[1], -n[0]};
    const double *far = seats->corners + 2 * next, way[2] = {far[0] - base[0], far[1] - base[1]};
    const double length = dot(t, way), low = fmin(0, length), high = fmax(0, length);
    const int32_t at_low = seat_base + (length < 0 ? next : seat), at_high = seat_base + (length < 0 ? seat : next);
    const End one = end_at(tips, facing, base, t, n, tip_base),
              other = end_at(tips, next_corner(facing, tips), base, t, n, tip_base);
    const gboolean left = other.along < one.along;
    End first = left ? other : one, last = left ? one : other;
    if (last.along < low || first.along > high) return;
    const End whole[2] = {first, last};
    cut(&first, &whole[1], low, -1, at_low);
    cut(&last, &whole[0], high, 1, at_high);
    add_point(manifold, n, base, &first, reach);
    if (last.along > first.along) add_point(manifold, n, base, &last, reach);
}

/* The normal and the order of points are those of the first over the second. */
static void turn_over(TinkerManifold *manifold)
{
    manifold->normal[0] = -manifold->normal[0];
    manifold->normal[1] = -manifold->normal[1];
    if (manifold->count < 2) return;
    const TinkerManifoldPoint kept = manifold->points[0];
    manifold->points[0] = manifold->points[1];
    manifold->points[1] = kept;
}

/* Whether all of a shape is past an end of a top, or below it. */
static gboolean is_beside(const TinkerPlacedShape *shape, const TinkerPlacedShape *top)
{
    const double *n = top->normals, t[2] = {n[1], -n[0]}, *base = top->corners;
    const double way[2] = {base[2] - base[0], base[3] - base[1]}, length = fabs(dot(t, way));
    const double round = shape->kind == TINKER_OUTLINE_DISC ? shape->radius : 0;
    double least = INFINITY, most = -INFINITY, height = -INFINITY;
    for (int32_t i = 0; i < (shape->count > 0 ? shape->count : 1); i++) {
        const double *at = shape->count > 0 ? shape->corners + 2 * i : shape->place;
        const double off[2] = {at[0] - base[0], at[1] - base[1]}, along = dot(t, off);
        least = fmin(least, along);
        most = fmax(most, along);
        height = fmax(height, dot(n, off));
    }
    return most + round < 0 || least - round > length || height + round < 0;
}

static void find_polygons(const TinkerPlacedShape *first, const TinkerPlacedShape *second, double reach,
                          TinkerManifold *manifold)
{
    int32_t of_first, of_second;
    const double by_second = farthest_edge(second, first, &of_second);
    if (by_second > reach) {
        manifold->separation = by_second;
        return;
    }
    const double by_first = farthest_edge(first, second, &of_first);
    manifold->separation = fmax(by_first, by_second);
    if (manifold->separation > reach || (of_first < 0 && of_second < 0)) return;
    const gboolean on_second = of_second >= 0 && !(by_first > by_second + TINKER_RATHER_FIRST);
    const TinkerPlacedShape *seats = on_second ? second : first;
    const int32_t seat = on_second ? of_second : of_first;
    manifold->normal[0] = seats->normals[2 * seat];
    manifold->normal[1] = seats->normals[2 * seat + 1];
    if (on_second) {
        clip(second, seat, TINKER_MOST_CORNERS, first, 0, reach, manifold);
        return;
    }
    clip(first, seat, 0, second, TINKER_MOST_CORNERS, reach, manifold);
    turn_over(manifold);
}

/* From a point of the seat to the centre of a disc. */
static void touch_round(const TinkerPlacedShape *disc, const double seat[2], double seat_radius, double reach,
                        TinkerManifold *manifold)
{
    const double off[2] = {disc->place[0] - seat[0], disc->place[1] - seat[1]};
    const double far = sqrt(dot(off, off)), gap = far - disc->radius - seat_radius;
    double *n = manifold->normal;
    n[0] = far > 0 ? off[0] / far : 0;
    n[1] = far > 0 ? off[1] / far : 1;
    manifold->separation = gap;
    if (gap > reach) return;
    manifold->count = 1;
    manifold->points[0] =
        (TinkerManifoldPoint){gap, {disc->place[0] - disc->radius * n[0], disc->place[1] - disc->radius * n[1]}, 0};
}

/* A disc over an edge or a corner of a polygon or a top. */
static void find_disc(const TinkerPlacedShape *disc, const TinkerPlacedShape *other, double reach,
                      TinkerManifold *manifold)
{
    const gboolean top = other->kind == TINKER_OUTLINE_TOP;
    double at[2] = {disc->place[0], disc->place[1]};
    const TinkerPlacedShape centre = {TINKER_OUTLINE_POLYGON, 1, {0, 0}, 0, at, NULL};
    int32_t edge;
    const double out = farthest_edge(other, &centre, &edge);
    if (edge < 0) {
        touch_round(disc, other->corners, 0, reach, manifold);
        return;
    }
    manifold->separation = out - disc->radius;
    if (manifold->separation > reach) return;
    const int32_t next = next_corner(edge, other);
    const double *n = other->normals + 2 * edge, *from = other->corners + 2 * edge, *to = other->corners + 2 * next;
    const double way[2] = {to[0] - from[0], to[1] - from[1]};
    const double off[2] = {disc->place[0] - from[0], disc->place[1] - from[1]};
    const double share = dot(off, way) / dot(way, way);
    if (share < 0 || share > 1) {
        if (out > 0 || !top) touch_round(disc, share < 0 ? from : to, 0, reach, manifold);
        return;
    }
    manifold->normal[0] = n[0];
    manifold->normal[1] = n[1];
    manifold->count = 1;
    manifold->points[0] = (TinkerManifoldPoint){
        out - disc->radius, {disc->place[0] - disc->radius * n[0], disc->place[1] - disc->radius * n[1]}, 0};
}

void tinker_manifold_find(const TinkerPlacedShape *first, const TinkerPlacedShape *second, double reach,
                          TinkerManifold *manifold)
{
    const gboolean round = first->kind == TINKER_OUTLINE_DISC, other_round = second->kind == TINKER_OUTLINE_DISC;
    manifold->count = 0;
    manifold->separation = INFINITY;
    manifold->beside = second->kind == TINKER_OUTLINE_TOP && is_beside(first, second);
    if (round && other_round) {
        touch_round(first, second->place, second->radius, reach, manifold);
    } else if (round) {
        find_disc(first, second, reach, manifold);
    } else if (other_round) {
        find_disc(second, first, reach, manifold);
        turn_over(manifold);
    } else {
        find_polygons(first, second, reach, manifold);
    }
}
