/* Thinning a path: no point may be farther from what is left of it than was promised, measured straight by the
 * geometry. */
#include "gui/widget/path-thin.h"

#include <math.h>

#define COUNT 20000

typedef struct {
    double x[COUNT], y[COUNT];
} Path;

static double distance_to_piece(const Path *path, guint point, guint from, guint to, double tolerance)
{
    double dx = path->x[to] - path->x[from], dy = path->y[to] - path->y[from];
    double px = path->x[point] - path->x[from], py = path->y[point] - path->y[from];
    double square = dx * dx + dy * dy;
    double share = square > 0 ? CLAMP((px * dx + py * dy) / square, 0, 1) : 0;
    return hypot(px - share * dx, py - share * dy) / tolerance;
}

/* Thins, checks, and answers how many points are left. */
static guint check(const Path *path, double tolerance)
{
    g_autoptr(GArray) kept = g_array_new(FALSE, FALSE, sizeof(guint));
    tinker_path_thin(path->x, path->y, COUNT, (double[]){tolerance, tolerance}, kept);
    g_assert_cmpuint(g_array_index(kept, guint, 0), ==, 0);
    g_assert_cmpuint(g_array_index(kept, guint, kept->len - 1), ==, COUNT - 1);
    for (guint i = 0; i + 1 < kept->len; i++) {
        guint from = g_array_index(kept, guint, i), to = g_array_index(kept, guint, i + 1);
        g_assert_cmpuint(from, <, to);
        for (guint point = from + 1; point < to; point++)
            g_assert_cmpfloat(distance_to_piece(path, point, from, to, tolerance), <=, 2 + 1e-9);
    }
    return kept->len;
}

/* A chord that stays within e of a circle spans at most 2 arccos(1 - e) of it; the cone may be half as good. */
static void test_circle(void)
{
    g_autofree Path *path = g_new(Path, 1);
    const double tolerance = 1e-3, turns = 5;
    for (int i = 0; i < COUNT; i++) {
        path->x[i] = cos(2 * G_PI * turns * i / COUNT);
        path->y[i] = sin(2 * G_PI * turns * i / COUNT);
    }
    double least = 2 * G_PI * turns / (2 * acos(1 - 2 * tolerance));
    guint left = check(path, tolerance);
    g_assert_cmpfloat(left, >=, least);
    g_assert_cmpfloat(left, <=, 4 * least);
}

/* Forth and back on one line: the turning points must stay. */
static void test_turning_points(void)
{
    g_autofree Path *path = g_new(Path, 1);
    for (int i = 0; i < COUNT; i++)
        path->x[i] = path->y[i] = (1 + 1e-4 * i) * sin(2 * G_PI * 10 * i / COUNT);
    g_assert_cmpuint(check(path, 1e-3), <, COUNT / 20);
}

static void test_random_walk(void)
{
    g_autofree Path *path = g_new0(Path, 1);
    for (int i = 1; i < COUNT; i++) {
        path->x[i] = path->x[i - 1] + g_test_rand_double_range(-1, 1);
        path->y[i] = path->y[i - 1] + g_test_rand_double_range(-1, 1);
    }
    check(path, 0.1);
    check(path, 3);
    check(path, 100);
}

/* A gap stays a gap, with the points beside it; and nothing is too short. */
static void test_gaps(void)
{
    const double x[] = {0, 1, 2, 3, NAN, NAN, 6, 7, 8}, y[9] = {0};
    const guint expected[] = {0, 3, 4, 5, 6, 8};
    g_autoptr(GArray) kept = g_array_new(FALSE, FALSE, sizeof(guint));
    tinker_path_thin(x, y, 9, (double[]){0.1, 0.1}, kept);
    g_assert_cmpmem(kept->data, kept->len * sizeof(guint), expected, sizeof expected);
    for (gsize count = 0; count < 3; count++) {
        g_array_set_size(kept, 0);
        tinker_path_thin(x, y, count, (double[]){0.1, 0.1}, kept);
        g_assert_cmpuint(kept->len, ==, count);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/gui/path-thin/circle", test_circle);
    g_test_add_func("/gui/path-thin/turning-points", test_turning_points);
    g_test_add_func("/gui/path-thin/random-walk", test_random_walk);
    g_test_add_func("/gui/path-thin/gaps", test_gaps);
    return g_test_run();
}
