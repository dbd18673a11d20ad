/* The numerics and the geometry that the SDK offers to blocks. */
#include <float.h>
#include <math.h>

#include <glib.h>

#include <tinker/sdk.h>

#define PI 3.14159265358979323846

/* 3-4-5 triangles of any size that a double holds. */
static void test_length(void)
{
    for (int exponent = -1060; exponent <= 1020; exponent += 20) {
        const double size = ldexp(1, exponent);
        g_assert_cmpfloat_with_epsilon(tinker_length(3 * size, -4 * size) / size, 5, 5 * 4 * DBL_EPSILON);
    }
    g_assert_cmpfloat(tinker_length(0, 0), ==, 0);
    g_assert_true(isnan(tinker_length(NAN, 1)));
    g_assert_true(isinf(tinker_length(INFINITY, 1)));
}

/* Directions are unit vectors at the angle asked for; only quarter turns are rounded to exact ones. */
static void test_direction(void)
{
    double direction[2];
    for (int k = -4000; k <= 4000; k++) {
        tinker_direction(k * (PI / 2), direction);
        g_assert_cmpfloat(fabs(direction[0]) + fabs(direction[1]), ==, 1);
        g_assert_cmpfloat_with_epsilon(direction[0], cos(k * (PI / 2)), 1e-11);
        g_assert_cmpfloat_with_epsilon(direction[1], sin(k * (PI / 2)), 1e-11);
        const double angle = k * 0.01 + 0.005;
        tinker_direction(angle, direction);
        g_assert_cmpfloat(direction[0], ==, cos(angle));
        g_assert_cmpfloat(direction[1], ==, sin(angle));
    }
    tinker_direction(PI / 2 + 1e-12, direction);
    g_assert_cmpfloat(direction[0], ==, cos(PI / 2 + 1e-12));
    tinker_direction(NAN, direction);
    g_assert_true(isnan(direction[0]));
}

/* Turned from rest by what was asked for, whatever the arms' lengths and wherever the first one points; at most half a
 * turn either way. */
static void test_turn_from_rest(void)
{
    for (int first = -8; first <= 8; first++)
        for (int rest = -8; rest <= 8; rest++)
            for (double turn = -3.1; turn <= 3.1; turn += 0.3) {
                const double from = 0.7 * first, to = from + 0.7 * rest + turn;
                const double found =
                    tinker_turn_from_rest(2 * cos(from), 2 * sin(from), 3 * cos(to), 3 * sin(to), 0.7 * rest);
                g_assert_cmpfloat_with_epsilon(found, turn, 1e-14);
            }
    g_assert_cmpfloat(tinker_turn_from_rest(1, 0, -1, 0, PI), ==, 0);
}

/* The pair of forces has no resultant and the moment that was asked for about any place, across the arm. */
static void test_moment(void)
{
    const TinkerPoint hinge = {.x = 2, .y = -1}, tip = {.x = 5, .y = 3};
    double on_hinge[2] = {0, 0}, on_tip[2] = {0, 0};
    g_assert_true(tinker_add_moment(&hinge, &tip, 7, on_hinge, on_tip));
    g_assert_cmpfloat(on_hinge[0] + on_tip[0], ==, 0);
    g_assert_cmpfloat(on_hinge[1] + on_tip[1], ==, 0);
    g_assert_cmpfloat_with_epsilon((tip.x - hinge.x) * on_tip[1] - (tip.y - hinge.y) * on_tip[0], 7, 1e-14);
    g_assert_cmpfloat_with_epsilon((tip.x - hinge.x) * on_tip[0] + (tip.y - hinge.y) * on_tip[1], 0, 1e-14);
    g_assert_false(tinker_add_moment(&tip, &tip, 7, on_hinge, on_tip));
}

static void test_segment_distance(void)
{
    g_assert_cmpfloat(tinker_segment_distance(2, 3, 0, 0, 10, 0), ==, 3);
    g_assert_cmpfloat(tinker_segment_distance(-3, 4, 0, 0, 10, 0), ==, 5);
    g_assert_cmpfloat(tinker_segment_distance(13, -4, 0, 0, 10, 0), ==, 5);
    g_assert_cmpfloat(tinker_segment_distance(3, 4, 0, 0, 0, 0), ==, 5);
    g_assert_cmpfloat_with_epsilon(tinker_segment_distance(0, 2, 0, 0, 5, 5), sqrt(2), 1e-15);
}

TINKER_LINE_LOOP(bumper, k, c, L < 1 ? k * (L - 1) + c * rate : 0)

static void test_line_loop(void)
{
    const double k[3] = {10, 20, 30}, c[3] = {1, 2, 3}, length[3] = {0.5, 2, 0}, rate[3] = {-1, -1, 0};
    const double wanted[3] = {-6, 0, -30};
    double tension[3];
    bumper(3, k, c, length, rate, tension);
    g_assert_cmpmem(tension, sizeof tension, wanted, sizeof wanted);
}

static void test_end_geometry(void)
{
    const TinkerPoint ends[6] = {{0, 0, 0, 0}, {3, 4, 5, 0}, {1, 1, 0, 0},
                                 {1, 1, 2, 2}, {0, 0, 1, 0}, {1e200, 0, 3, 0}};
    double length[3], rate[3];
    tinker_end_distances(3, ends, length);
    tinker_end_rates(3, ends, rate);
    g_assert_cmpfloat(length[0], ==, 5);
    g_assert_cmpfloat_with_epsilon(rate[0], 3, 1e-15);
    g_assert_cmpfloat(length[1], ==, 0);
    g_assert_cmpfloat(rate[1], ==, 0);
    g_assert_cmpfloat(length[2], ==, 1e200);
    g_assert_cmpfloat(rate[2], ==, 2);
}

/* A point in a block's own axes and back in the world. */
static void test_own_axes(void)
{
    TinkerInstance instance = {.struct_size = sizeof instance, .x = 3, .y = -2, .orientation = PI / 2};
    double x, y, own_x, own_y;
    tinker_box_to_world(&instance, 1, 0, &x, &y);
    g_assert_cmpfloat(x, ==, 3);
    g_assert_cmpfloat(y, ==, -1);
    for (int k = 0; k < 100; k++) {
        instance.orientation = g_test_rand_double_range(-10, 10);
        const double at[2] = {g_test_rand_double_range(-5, 5), g_test_rand_double_range(-5, 5)};
        tinker_box_to_world(&instance, at[0], at[1], &x, &y);
        tinker_box_to_own(&instance, x, y, &own_x, &own_y);
        g_assert_cmpfloat_with_epsilon(own_x, at[0], 1e-14);
        g_assert_cmpfloat_with_epsilon(own_y, at[1], 1e-14);
    }
}

/* A connector of three ends, round a corner: its ends, both of its lines, and not the line that closes the triangle. */
static void test_connector_hit(void)
{
    const TinkerEnd ends[3] = {{.x = 0, .y = 0}, {.x = 4, .y = 0}, {.x = 4, .y = 4}};
    const TinkerInstance instance = {.struct_size = sizeof(TinkerInstance), .ends = 3, .end = ends};
    g_assert_cmpint(tinker_connector_hit(&instance, 0.1, 0.1, 0.2), ==, 0);
    g_assert_cmpint(tinker_connector_hit(&instance, 4, 3.9, 0.2), ==, 2);
    g_assert_cmpint(tinker_connector_hit(&instance, 2, 0.1, 0.2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(tinker_connector_hit(&instance, 3.9, 2, 0.2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(tinker_connector_hit(&instance, 2, 2, 0.2), ==, TINKER_PART_NONE);
}

/* y = a cosh(x / a) between two places is a (sinh(x2 / a) - sinh(x1 / a)) long; drawn either way. */
static void test_hanging_line(void)
{
    const double rows[][3] = {{1, -1, 1}, {1, -2, 0.5}, {0.3, 0.2, 1.5}, {5, -3, 2}, {0.01, -0.1, 0.12}};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        const double a = rows[i][0], from = rows[i][1], to = rows[i][2];
        const double length = a * (sinh(to / a) - sinh(from / a));
        double there[2 * TINKER_HANGING_POINTS], back[2 * TINKER_HANGING_POINTS];
        tinker_hanging_line(from, a * cosh(from / a), to, a * cosh(to / a), length, there);
        tinker_hanging_line(to, a * cosh(to / a), from, a * cosh(from / a), length, back);
        for (int k = 0; k < TINKER_HANGING_POINTS; k++) {
            const double *other = &back[2 * (TINKER_HANGING_POINTS - 1 - k)];
            g_assert_cmpfloat_with_epsilon(there[2 * k + 1], a * cosh(there[2 * k] / a), 1e-8 * length);
            g_assert_cmpfloat_with_epsilon(there[2 * k], other[0], 1e-8 * length);
            g_assert_cmpfloat_with_epsilon(there[2 * k + 1], other[1], 1e-8 * length);
        }
        g_assert_cmpfloat_with_epsilon(there[2 * TINKER_HANGING_POINTS - 2], to, 1e-8 * length);
    }
    double points[2 * TINKER_HANGING_POINTS];
    tinker_hanging_line(2, 1, 2, 0, 3, points); /* straight down and up again */
    g_assert_cmpfloat_with_epsilon(points[TINKER_HANGING_POINTS - 1], 2, 1e-4);
    const int lowest = 2 * (TINKER_HANGING_POINTS - 1) / 3; /* of its length 3, 2 go down */
    g_assert_cmpfloat_with_epsilon(points[2 * lowest + 1], -1, 1e-4);
    tinker_hanging_line(0, 0, 4, 4, 1, points); /* too short */
    g_assert_cmpfloat(points[TINKER_HANGING_POINTS - 1], ==, 2);
    g_assert_cmpfloat(points[TINKER_HANGING_POINTS], ==, 2);
}

static void test_first_end(void)
{
    const int32_t offsets[3] = {0, 2, 7};
    const TinkerBatch alike = {.count = 2, .ends = 3}, different = {.count = 2, .ends = -1, .end_offsets = offsets};
    g_assert_cmpint(tinker_first_end(&alike, 1), ==, 3);
    g_assert_cmpint(tinker_first_end(&alike, 2), ==, 6);
    g_assert_cmpint(tinker_first_end(&different, 1), ==, 2);
    g_assert_cmpint(tinker_first_end(&different, 2), ==, 7);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/sdk/kernels/length", test_length);
    g_test_add_func("/sdk/kernels/direction", test_direction);
    g_test_add_func("/sdk/kernels/turn-from-rest", test_turn_from_rest);
    g_test_add_func("/sdk/kernels/moment", test_moment);
    g_test_add_func("/sdk/kernels/segment-distance", test_segment_distance);
    g_test_add_func("/sdk/kernels/line-loop", test_line_loop);
    g_test_add_func("/sdk/kernels/end-geometry", test_end_geometry);
    g_test_add_func("/sdk/kernels/own-axes", test_own_axes);
    g_test_add_func("/sdk/kernels/connector-hit", test_connector_hit);
    g_test_add_func("/sdk/kernels/first-end", test_first_end);
    g_test_add_func("/sdk/kernels/hanging-line", test_hanging_line);
    return g_test_run();
}
