/* Outlines that are cut into convex parts, and brought into order, against areas and points within. */
#include <glib.h>
#include <math.h>
#include <string.h>

#include "physics/shapes/outline-parts.h"
#include "shape-distances.h"

static double area_of(const double *corners, int32_t count)
{
    double twice = 0;
    for (int32_t i = 0; i < count; i++) {
        const double *a = corners + 2 * i, *b = corners + 2 * ((i + 1) % count);
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return 0.5 * twice;
}

/* A star of corners at random distances: any place is in as many of its triangles as it is in the star, one or none. */
static void check_star(GRand *random)
{
    enum { MOST_CORNERS = 24 };
    static const double origin[2] = {0, 0};
    const int32_t count = g_rand_int_range(random, 4, MOST_CORNERS + 1);
    double points[2 * MOST_CORNERS], corners[2 * MOST_CORNERS], triangles[6 * MOST_CORNERS], area = 0;
    for (int32_t i = 0; i < count; i++) {
        const double angle = -2 * G_PI * i / count,
                     far = shape_between(random, 0.1, 1); /* clockwise: it is turned round */
        points[2 * i] = far * cos(angle);
        points[2 * i + 1] = far * sin(angle);
    }
    g_assert_cmpint(tinker_outline_normalise(points, count, origin, corners), ==, count);
    tinker_outline_cut(corners, count, triangles);
    for (int32_t i = 0; i < count - 2; i++) {
        g_assert_cmpfloat(area_of(triangles + 6 * i, 3), >, 0);
        area += area_of(triangles + 6 * i, 3);
    }
    g_assert_cmpfloat_with_epsilon(area, area_of(corners, count), 1e-14);
    const TinkerOutline star = {TINKER_OUTLINE_POLYGON, 1, count, corners, 0, NULL};
    const TinkerBodyPose still = {.cosine = 1};
    for (int32_t k = 0; k < 50; k++) {
        const double p[2] = {shape_between(random, -1, 1), shape_between(random, -1, 1)};
        int32_t in = 0;
        for (int32_t i = 0; i < count - 2; i++) {
            const TinkerOutline part = {TINKER_OUTLINE_POLYGON, 1, 3, triangles + 6 * i, 0, NULL};
            in += shape_from_polygon(p, &part, &still) < 0;
        }
        g_assert_cmpint(in, ==, shape_from_polygon(p, &star, &still) < 0);
    }
}

static void test_parts(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(17);
    for (int32_t i = 0; i < 2000; i++)
        check_star(random);
}

/* Corners on the line of their neighbours are none, however the outline is given. */
static void test_normalised(void)
{
    static const double points[] = {1, 1, 1, 2, 1, 3, 2, 3, 3, 3, 3, 1, 2, 1}; /* clockwise */
    static const double origin[2] = {2, 2}, expected[] = {1, -1, 1, 1, -1, 1, -1, -1};
    double corners[14];
    g_assert_cmpint(tinker_outline_normalise(points, 7, origin, corners), ==, 4);
    g_assert_true(tinker_outline_is_convex(corners, 4));
    for (int k = 0; k < 8; k++)
        g_assert_cmpfloat(corners[k], ==, expected[k]);
    g_assert_false(tinker_outline_is_convex(shapes[6].corners, shapes[6].count));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/shapes-parts/parts", test_parts);
    g_test_add_func("/physics/shapes-parts/normalised", test_normalised);
    return g_test_run();
}
