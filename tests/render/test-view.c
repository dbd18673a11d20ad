/* The view: there and back again, what stays in place, round grids. */
#include <math.h>

#include "render/draw/view.h"

static TinkerView random_view(void)
{
    double x = g_test_rand_double_range(-1e3, 1e3), y = g_test_rand_double_range(-1e3, 1e3);
    double width = pow(10, g_test_rand_double_range(-3, 4)), height = pow(10, g_test_rand_double_range(-3, 4));
    const double box[4] = {x, y, x + width, y + height};
    return tinker_view_fit(box, g_test_rand_int_range(50, 2000), g_test_rand_int_range(50, 2000), 20);
}

static void test_round_trip(void)
{
    for (int i = 0; i < 1000; i++) {
        TinkerView view = random_view();
        double canvas_x = g_test_rand_double_range(0, view.width), canvas_y = g_test_rand_double_range(0, view.height);
        double x, y, back_x, back_y;
        tinker_view_to_world(&view, canvas_x, canvas_y, &x, &y);
        tinker_view_to_canvas(&view, x, y, &back_x, &back_y);
        double resolution = 1e-12 * (fabs(view.origin_x) + fabs(view.origin_y) + 1e4);
        g_assert_cmpfloat_with_epsilon(canvas_x, back_x, resolution);
        g_assert_cmpfloat_with_epsilon(canvas_y, back_y, resolution);
    }
}

static void test_up_is_up(void)
{
    TinkerView view = tinker_view_fit((double[4]){0, 0, 1, 1}, 100, 100, 0);
    double x, low, high;
    tinker_view_to_canvas(&view, 0, 0, &x, &low);
    tinker_view_to_canvas(&view, 0, 1, &x, &high);
    g_assert_cmpfloat_with_epsilon(low, 100, 1e-9);
    g_assert_cmpfloat_with_epsilon(high, 0, 1e-9);
}

static void test_fit(void)
{
    for (int i = 0; i < 1000; i++) {
        double x = g_test_rand_double_range(-10, 10), y = g_test_rand_double_range(-10, 10);
        const double box[4] = {x, y, x + g_test_rand_double_range(0.1, 9), y + g_test_rand_double_range(0.1, 9)};
        TinkerView view = tinker_view_fit(box, 640, 480, 30);
        double left, top, right, bottom;
        tinker_view_to_canvas(&view, box[0], box[3], &left, &top);
        tinker_view_to_canvas(&view, box[2], box[1], &right, &bottom);
        /* Inside the margins, centred, and touching one pair of them. */
        g_assert_cmpfloat(left, >=, 30 - 1e-6);
        g_assert_cmpfloat(top, >=, 30 - 1e-6);
        g_assert_cmpfloat_with_epsilon(left + right, 640, 1e-6);
        g_assert_cmpfloat_with_epsilon(top + bottom, 480, 1e-6);
        g_assert_cmpfloat_with_epsilon(fmin(left, top), 30, 1e-6);
    }
}

static void test_odd_boxes(void)
{
    const double boxes[][4] = {{0, 0, 0, 0},   {5, 5, 5, 9},
                               {NAN, 0, 1, 1}, {-INFINITY, 0, INFINITY, 1},
                               {1, 1, -1, -1}, {1e300, 1e300, 2e300, 2e300},
                               {3, 3, 3, 3},   {1e9, 0, 1e9, 0}};
    for (gsize i = 0; i < G_N_ELEMENTS(boxes); i++) {
        TinkerView view = tinker_view_fit(boxes[i], i % 2 ? 0 : 300, 200, 1000);
        g_assert_true(isfinite(view.scale) && view.scale > 0);
        g_assert_cmpfloat(view.width, >=, 1);
    }
    TinkerView point = tinker_view_fit((double[4]){3, 4, 3, 4}, 300, 200, 10);
    double x, y;
    tinker_view_to_canvas(&point, 3, 4, &x, &y);
    g_assert_cmpfloat_with_epsilon(x, 150, 1e-9);
    g_assert_cmpfloat_with_epsilon(y, 100, 1e-9);
}

static void test_zoom(void)
{
    for (int i = 0; i < 1000; i++) {
        TinkerView view = random_view(), before = view;
        double canvas_x = g_test_rand_double_range(0, view.width), canvas_y = g_test_rand_double_range(0, view.height);
        double x, y, after_x, after_y, factor = pow(10, g_test_rand_double_range(-1, 1));
        tinker_view_to_world(&before, canvas_x, canvas_y, &x, &y);
        tinker_view_zoom(&view, factor, canvas_x, canvas_y);
        tinker_view_to_canvas(&view, x, y, &after_x, &after_y);
        double resolution = 1e-11 * (fabs(view.origin_x) + fabs(view.origin_y) + fabs(before.origin_x) * factor +
                                     fabs(before.origin_y) * factor + 1e4);
        g_assert_cmpfloat_with_epsilon(after_x, canvas_x, resolution);
        g_assert_cmpfloat_with_epsilon(after_y, canvas_y, resolution);
        g_assert_cmpfloat_with_epsilon(view.scale / before.scale, factor, 1e-12 * factor);
    }
    TinkerView view = random_view(), before = view;
    tinker_view_zoom(&view, NAN, 1, 1);
    tinker_view_zoom(&view, -2, 1, 1);
    tinker_view_zoom(&view, INFINITY, 1, 1);
    tinker_view_pan(&view, NAN, 0);
    g_assert_cmpmem(&view, sizeof view, &before, sizeof before);
    for (int i = 0; i < 1000; i++)
        tinker_view_zoom(&view, 10, 0, 0);
    g_assert_true(isfinite(view.scale));
}

static void test_pan(void)
{
    TinkerView view = tinker_view_fit((double[4]){0, 0, 1, 1}, 100, 100, 0);
    tinker_view_pan(&view, 5, -7);
    double x, y;
    tinker_view_to_canvas(&view, 0, 0, &x, &y);
    g_assert_cmpfloat_with_epsilon(x, 5, 1e-9);
    g_assert_cmpfloat_with_epsilon(y, 93, 1e-9);
}

static void test_grid(void)
{
    for (int i = 0; i < 2000; i++) {
        TinkerView view = {.scale = pow(10, g_test_rand_double_range(-6, 6)), .width = 100, .height = 100};
        double least = g_test_rand_double_range(5, 60), spacing = tinker_view_grid(&view, least);
        double mantissa = spacing / pow(10, floor(log10(spacing) + 1e-9));
        g_assert_true(fabs(mantissa - 1) < 1e-9 || fabs(mantissa - 2) < 1e-9 || fabs(mantissa - 5) < 1e-9);
        g_assert_cmpfloat(spacing * view.scale, >=, least * (1 - 1e-12));
        /* The next smaller round number, at most 2.5 times smaller, would be too dense. */
        g_assert_cmpfloat(spacing * view.scale, <, 2.5 * least * (1 + 1e-9));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/view/round-trip", test_round_trip);
    g_test_add_func("/render/view/up-is-up", test_up_is_up);
    g_test_add_func("/render/view/fit", test_fit);
    g_test_add_func("/render/view/odd-boxes", test_odd_boxes);
    g_test_add_func("/render/view/zoom", test_zoom);
    g_test_add_func("/render/view/pan", test_pan);
    g_test_add_func("/render/view/grid", test_grid);
    return g_test_run();
}
