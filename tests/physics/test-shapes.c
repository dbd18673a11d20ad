/* Gap functions, overlaps and manifolds of pairs of shapes, against distances of all their sides from one another at
 * many random poses. */
#include <glib.h>
#include <math.h>
#include <string.h>

#include "physics/shapes/gaps.h"
#include "physics/shapes/manifold.h"
#include "physics/shapes/unturned.h"
#include "shape-distances.h"

/* Brute force ------------------------------------------------------------------------------------------------------ */

/* Tests ------------------------------------------------------------------------------------------------------------ */

static void test_distance(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(11);
    double worst = 0;
    guint apart = 0;
    for (int32_t i = 0; i < SHAPE_POSES; i++) {
        const TinkerOutline *first = &shapes[g_rand_int_range(random, 0, G_N_ELEMENTS(shapes))];
        const TinkerOutline *second = &shapes[g_rand_int_range(random, 0, G_N_ELEMENTS(shapes))];
        const TinkerBodyPose p = shape_random_pose(random), q = shape_random_pose(random);
        const double distance = shape_distance(first, &p, second, &q);
        const double overlap = tinker_outlines_overlap(first, &p, second, &q);
        if (fabs(distance) < 1e-9) continue;
        g_assert_true((overlap > 0) == (distance < 0));
        if (distance < 0) continue;
        g_assert_cmpfloat(-overlap, <=, distance + 1e-12);
        TinkerGapFunction functions[SHAPE_MOST];
        const int32_t count = tinker_gap_functions(first, second, functions, SHAPE_MOST);
        double least = shape_nearest_corners(first, &p, second, &q);
        g_assert_cmpint(count, <, SHAPE_MOST);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &p, &q, &gap);
            g_assert_true(tinker_gap_alone(&functions[k], &p, &q) == gap.gap);
            if (gap.gap > 0 && fabs(gap.along) <= functions[k].half_width) least = fmin(least, gap.gap);
        }
        worst = fmax(worst, fabs(least - distance));
        apart++;
    }
    g_test_message("%u poses apart: the least gap is off by %.1e m", apart, worst);
    g_assert_cmpuint(apart, >, SHAPE_POSES / 4);
    g_assert_cmpfloat(worst, <, 1e-13);
}

/* Shapes that keep their angles, as a point and a grown shape: the distance of both is that of the shapes, and so is
 * whether they overlap. */
static void test_unturned(void)
{
    static const int32_t numbers[] = {0, 1, 5}; /* box, triangle, line */
    static const double way[2] = {1, 0};
    g_autoptr(GRand) random = g_rand_new_with_seed(12);
    double worst = 0;
    for (int32_t i = 0; i < SHAPE_POSES / 10; i++) {
        const TinkerOutline *first = &shapes[numbers[g_rand_int_range(random, 0, G_N_ELEMENTS(numbers))]];
        const TinkerOutline *second = &shapes[numbers[g_rand_int_range(random, 0, G_N_ELEMENTS(numbers))]];
        TinkerBodyPose p = shape_random_pose(random), q = shape_random_pose(random);
        const double distance = shape_distance(first, &p, second, &q);
        TinkerUnturned both;
        TinkerGapFunction functions[SHAPE_MOST];
        tinker_unturned_init(&both, first, p.angle, second, q.angle);
        const int32_t count = tinker_unturned_functions(&both, first, p.angle, way, functions, SHAPE_MOST);
        p = shape_turned_by(p, 0);
        q = shape_turned_by(q, 0);
        if (fabs(distance) < 1e-9) continue;
        g_assert_true((tinker_outlines_overlap(&both.point, &p, &both.around, &q) > 0) == (distance < 0));
        if (distance < 0) continue;
        double least = shape_nearest_corners(&both.point, &p, &both.around, &q);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &p, &q, &gap);
            g_assert_true(tinker_gap_alone(&functions[k], &p, &q) == gap.gap);
            if (gap.gap > 0 && fabs(gap.along) <= functions[k].half_width) least = fmin(least, gap.gap);
        }
        worst = fmax(worst, fabs(least - distance));
    }
    g_assert_cmpfloat(worst, <, 1e-13);
}

/* The part of a top that is within a polygon, by cutting it at all sides. */
static double length_within(const TinkerBodyPose *at_top, const TinkerOutline *other, const TinkerBodyPose *pose)
{
    double a[2], b[2], from = 0, to = 1;
    shape_corner_at(&shape_top, at_top, 0, a);
    shape_corner_at(&shape_top, at_top, 1, b);
    for (int32_t i = 0; i < other->count; i++) {
        double c[2], d[2];
        shape_corner_at(other, pose, i, c);
        shape_corner_at(other, pose, i + 1, d);
        const double first = shape_side_of(c, d, a), last = shape_side_of(c, d, b);
        if (first < 0 && last < 0) return -1;
        if (first < 0) from = fmax(from, first / (first - last));
        if (last < 0) to = fmin(to, first / (first - last));
    }
    return to - from;
}

static void test_tops(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(12);
    guint within = 0;
    for (int32_t i = 0; i < SHAPE_POSES / 4; i++) {
        const TinkerBodyPose p = shape_random_pose(random), q = shape_random_pose(random);
        const TinkerOutline *other = &shapes[g_rand_int_range(random, 0, 5)];
        const double overlap = tinker_outlines_overlap(&shape_top, &p, other, &q);
        gboolean is_within;
        if (other->kind == TINKER_OUTLINE_DISC) {
            double a[2], b[2];
            const double at[2] = {q.x, q.y};
            shape_corner_at(&shape_top, &p, 0, a);
            shape_corner_at(&shape_top, &p, 1, b);
            is_within = shape_from_segment(at, a, b) < other->radius;
        } else {
            is_within = length_within(&p, other, &q) > 0;
        }
        if (fabs(overlap) > 1e-9) g_assert_true((overlap > 0) == is_within);
        within += is_within;
    }
    g_assert_cmpuint(within, >, SHAPE_POSES / 40);
}

/* Outlines --------------------------------------------------------------------------------------------------------- */

static void place(const TinkerOutline *outline, const TinkerBodyPose *pose, double *room, TinkerPlacedShape *shape)
{
    *shape = (TinkerPlacedShape){.kind = outline->kind,
                                 .count = outline->count,
                                 .radius = outline->radius,
                                 .corners = room,
                                 .normals = room + 2 * outline->count};
    double local[4 * TINKER_MOST_CORNERS];
    tinker_shape_corners(outline, local);
    tinker_place_shape(shape, pose->x, pose->y, cos(pose->angle), sin(pose->angle), local);
}

/* The nearest point of a manifold has the least gap of all gap functions over their seats, and their normal. Corners
 * over corners of polygons have no gap function: then it has no points, or those of an edge that the other is past. */
static void test_manifolds(void)
{
    GRand *random = g_rand_new_with_seed(7);
    int compared = 0;
    for (int i = 0; i < SHAPE_POSES / 4; i++) {
        const int a = g_rand_int_range(random, 0, G_N_ELEMENTS(shapes)),
                  b = g_rand_int_range(random, 0, G_N_ELEMENTS(shapes) + 1);
        const TinkerOutline *first = &shapes[a], *second = b < (int)G_N_ELEMENTS(shapes) ? &shapes[b] : &shape_top;
        if (first->triangles != NULL || second->triangles != NULL) continue;
        const TinkerBodyPose at_first = shape_random_pose(random), at_second = shape_random_pose(random);
        double rooms[2][4 * TINKER_MOST_CORNERS];
        TinkerPlacedShape placed[2];
        TinkerManifold manifold;
        place(first, &at_first, rooms[0], &placed[0]);
        place(second, &at_second, rooms[1], &placed[1]);
        tinker_manifold_find(&placed[0], &placed[1], 1, &manifold);
        if (!(manifold.separation > 1e-6) || manifold.count == 0) continue;
        double nearest = manifold.points[0].gap, least = INFINITY, normal[2] = {0, 0};
        if (manifold.count > 1) nearest = fmin(nearest, manifold.points[1].gap);
        g_assert_cmpfloat(nearest, >=, manifold.separation - 1e-12);
        if (nearest > manifold.separation + 1e-9) continue; /* of a corner that is past the seat */
        TinkerGapFunction functions[SHAPE_MOST];
        const int32_t count = tinker_gap_functions(first, second, functions, SHAPE_MOST);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &at_first, &at_second, &gap);
            if (gap.gap < 0 || !tinker_gap_is_over(&functions[k], &at_first, &at_second, &gap, 0)) continue;
            if (gap.gap >= least) continue;
            least = gap.gap;
            for (int axis = 0; axis < 2; axis++)
                normal[axis] = functions[k].tip_of == 0 ? gap.normal[axis] : -gap.normal[axis];
        }
        if (!isfinite(least)) continue;
        g_assert_cmpfloat(fabs(nearest - least), <, 1e-12);
        g_assert_cmpfloat(fabs(manifold.normal[0] - normal[0]) + fabs(manifold.normal[1] - normal[1]), <, 1e-6);
        compared++;
    }
    g_assert_cmpint(compared, >, SHAPE_POSES / 40);
    g_rand_free(random);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/shapes/distance", test_distance);
    g_test_add_func("/physics/shapes/unturned", test_unturned);
    g_test_add_func("/physics/shapes/tops", test_tops);
    g_test_add_func("/physics/shapes/manifolds", test_manifolds);
    return g_test_run();
}
