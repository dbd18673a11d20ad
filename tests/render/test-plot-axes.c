/* Axes of plots: their ranges and scales, what the pointer picks, and no texts over each other. */
#include <math.h>

#include "plot-picture.h"

/* Where labels stand at every other power of ten, lines stand at all of them. */
static void test_decades_without_labels(void)
{
    double x[2] = {1, 10}, y[2] = {1e-15, 1};
    const TinkerCurve curve = {.x = x, .y = y, .count = 2, .markers = TRUE, .no_line = TRUE};
    const TinkerPlot plot = {
        .curves = &curve, .curve_count = 1, .x_logarithmic = TRUE, .y_logarithmic = TRUE, .y_label = "Y"};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    for (int decade = -14; decade < 0; decade++) {
        double right, line, ground[4], between[4];
        test_plot_place(&plot, 6.5, pow(10, decade), &right, &line);
        test_picture_pixel(picture, (int)right, (int)floor(line), ground);
        test_picture_pixel(picture, (int)right, (int)floor(line) + 6, between);
        g_assert_cmpfloat(ground[0], <, between[0] - 0.02);
    }
}

/* Equal scales: a unit is as long in both directions. */
static void test_equal_scales(void)
{
    TestPlotData data;
    test_plot_fill(&data, sin, 0, 10);
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .equal_scales = TRUE, .x_label = "X"};
    double x0, y0, x1, y1;
    test_plot_place(&plot, 0, 0, &x0, &y0);
    test_plot_place(&plot, 1, 1, &x1, &y1);
    g_assert_cmpfloat_with_epsilon(x1 - x0, y0 - y1, 1e-9);
}

/* An axis shows just what it is told to, whatever the data. */
static void test_ranges(void)
{
    TestPlotData data;
    test_plot_fill(&data, sin, 0, 10);
    const double across[2] = {2, 4}, up[2] = {-3, 1};
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .x_range = across, .y_range = up};
    double left, bottom, right, top, middle, centre;
    test_plot_place(&plot, 2, -3, &left, &bottom);
    test_plot_place(&plot, 4, 1, &right, &top);
    test_plot_place(&plot, 3, -1, &middle, &centre);
    g_assert_cmpfloat(left, >, 0);
    g_assert_cmpfloat(right - left, >, 0.7 * TEST_PLOT_WIDTH);
    g_assert_cmpfloat(bottom - top, >, 0.7 * TEST_PLOT_HEIGHT);
    g_assert_cmpfloat_with_epsilon(middle, 0.5 * (left + right), 1e-9);
    g_assert_cmpfloat_with_epsilon(centre, 0.5 * (bottom + top), 1e-9);
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, &plot, &pen, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    g_assert_cmpfloat_with_epsilon(layout.left, left, 1e-9);
    g_assert_cmpfloat_with_epsilon(layout.right, right, 1e-9);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

/* A curve of the second axis, a thousand times as high, lies where that of the first does; both axes have their texts,
 * those of the second at the right of the frame. */
static void test_second_axis(void)
{
    TestPlotData left, right;
    test_plot_fill(&left, test_plot_same, 0, 10);
    right = left;
    for (int i = 0; i < 200; i++)
        right.y[i] *= 1000;
    const TinkerCurve curves[] = {{.x = left.x, .y = left.y, .count = 200},
                                  {.x = right.x, .y = right.y, .count = 200, .colour = 1, .right = TRUE}};
    TinkerPlot plot = {
        .x_label = "X", .y_label = "Left [m]", .right_label = "Right [N]", .curves = curves, .curve_count = 2};
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, &plot, &pen, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    for (gsize i = 0; i < 200; i += 50) {
        double x, y, other_x, other_y;
        g_assert_true(tinker_plot_place(&layout, &curves[0], i, &x, &y));
        g_assert_true(tinker_plot_place(&layout, &curves[1], i, &other_x, &other_y));
        g_assert_cmpfloat(fabs(x - other_x) + fabs(y - other_y), <, 1e-9);
    }
    g_assert_cmpfloat(layout.right, <, TEST_PLOT_WIDTH - 60);
    g_assert_cmpstr(layout.second.title, ==, "Right [N]");
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);

    g_autoptr(GPtrArray) written = tinker_written_texts_new();
    g_autoptr(TestPicture) picture = test_picture_new(TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    tinker_plot_draw_noting(picture->cairo, &plot, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT, written);
    gboolean titled = FALSE;
    for (guint i = 0; i < written->len; i++)
        titled |= g_str_equal(((TinkerWrittenText *)g_ptr_array_index(written, i))->text, "Right [N]");
    g_assert_true(titled);
    plot.right_logarithmic = TRUE;
    const double range[2] = {10, 1000};
    plot.right_range = range;
    tinker_plot_lay_out(&layout, &plot, &pen, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    /* 100 is in the middle of 10 and 1000 */
    double middle = tinker_axis_place(&layout.second, 100);
    g_assert_cmpfloat(fabs(middle - 0.5 * (layout.top + layout.bottom)), <, 1e-9);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

static void test_pick(void)
{
    TestPlotData data;
    test_plot_fill(&data, test_plot_same, 0, 10);
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .x_label = "X", .title = "T"};
    double x, y;
    test_plot_place(&plot, data.x[77], data.y[77], &x, &y);
    TinkerPlotPoint point;
    g_assert_true(tinker_plot_pick(&plot, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT, x + 0.4, y - 0.4, 5, &point));
    g_assert_cmpint(point.curve, ==, 0);
    g_assert_cmpuint(point.point, ==, 77);
    g_assert_cmpfloat_with_epsilon(point.canvas_x, x, 1e-9);
    g_assert_false(tinker_plot_pick(&plot, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT, x + 60, y + 60, 5, &point));
}

static void check_texts(const TinkerPlot *plot, int width, int height)
{
    g_autoptr(TestPicture) picture = test_picture_new(width, height);
    g_autoptr(GPtrArray) written = tinker_written_texts_new();
    tinker_plot_draw_noting(picture->cairo, plot, width, height, written);
    for (guint i = 0; i < written->len; i++) {
        const TinkerWrittenText *a = g_ptr_array_index(written, i);
        if (a->box[0] < -1 || a->box[1] < -1 || a->box[2] > width + 1 || a->box[3] > height + 1)
            g_error("\"%s\" lies outside at %d by %d: %g to %g, %g to %g", a->text, width, height, a->box[0], a->box[2],
                    a->box[1], a->box[3]);
        for (guint n = 0; n < i; n++) {
            const TinkerWrittenText *b = g_ptr_array_index(written, n);
            gboolean apart = a->box[2] <= b->box[0] || b->box[2] <= a->box[0] || a->box[3] <= b->box[1] + 0.5 ||
                             b->box[3] <= a->box[1] + 0.5;
            if (!apart)
                g_error("\"%s\" lies over \"%s\" at %d by %d: %g to %g, %g to %g", a->text, b->text, width, height,
                        b->box[0], a->box[2], b->box[1], a->box[3]);
        }
    }
}

static void test_texts(void)
{
    static const char *const labels[] = {"Mass 0 y", "a far longer name of a curve than anybody would give", "S"};
    static const int sizes[][2] = {{640, 420}, {320, 240}, {1200, 300}, {300, 900}, {200, 160}};
    for (int i = 0; i < 200; i++) {
        TestPlotData data[3];
        TinkerCurve curves[3];
        double size = pow(10, g_test_rand_double_range(-200, 200)), offset = g_test_rand_double_range(-1e6, 1e6);
        for (int n = 0; n < 3; n++) {
            test_plot_fill(&data[n], sin, 0, g_test_rand_double_range(0.001, 1e5));
            for (int k = 0; k < 200; k++)
                data[n].y[k] = size * (data[n].y[k] * (n + 1) + (i % 2 ? offset : 0));
            curves[n] = (TinkerCurve){
                .label = i % 5 ? labels[n] : NULL, .x = data[n].x, .y = data[n].y, .count = 200, .colour = n};
        }
        const TinkerPlot plot = {
            .title = i % 3 ? "A title that is long enough to be broken into two lines on a small picture" : NULL,
            .x_label = "Time since the beginning of the measurement [s]",
            .y_label = "Y Position of the second mass [m]",
            .y_logarithmic = i % 4 == 3,
            .x_logarithmic = i % 7 == 3,
            .curves = curves,
            .curve_count = 1 + i % 3};
        check_texts(&plot, sizes[i % 5][0], sizes[i % 5][1]);
    }
}

static void test_tiny(void)
{
    TestPlotData data;
    test_plot_fill(&data, test_plot_same, 0, 10);
    const TinkerCurve curve = {.label = "L", .x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.title = "T", .x_label = "X", .y_label = "Y", .curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = test_picture_new(TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    for (int width = 0; width < 130; width += 7)
        for (int height = 0; height < 130; height += 11)
            tinker_plot_draw(picture->cairo, &plot, width, height);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/plot/decades-without-labels", test_decades_without_labels);
    g_test_add_func("/render/plot/equal-scales", test_equal_scales);
    g_test_add_func("/render/plot/ranges", test_ranges);
    g_test_add_func("/render/plot/second-axis", test_second_axis);
    g_test_add_func("/render/plot/pick", test_pick);
    g_test_add_func("/render/plot/texts", test_texts);
    g_test_add_func("/render/plot/tiny", test_tiny);
    return g_test_run();
}
