/* Curves of plots by their pixels: where the data are, spikes kept, gaps kept, and their bands. */
#include <math.h>

#include "plot-picture.h"

/* y = x runs from corner to corner of the data's box, and the places agree with the frame's own geometry: the first
 * tick pixel of the frame is where the axis says 0 is. */
static void test_diagonal(void)
{
    TestPlotData data;
    test_plot_fill(&data, test_plot_same, 0, 10);
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.x_label = "X [m]", .y_label = "Y [m]", .curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    double left, bottom, right, top;
    test_plot_place(&plot, 0, 0, &left, &bottom);
    test_plot_place(&plot, 10, 10, &right, &top);
    g_assert_cmpfloat(left, <, right - 400);
    g_assert_cmpfloat(top, <, bottom - 250);
    for (int i = 1; i < 40; i++) {
        double x = left + (right - left) * i / 40, y = bottom + (top - bottom) * i / 40;
        g_assert_true(test_picture_shows(picture, x, y, 1, test_plot_colour(0)));
        g_assert_false(test_picture_shows(picture, x, y + 12, 3, test_plot_colour(0)));
        g_assert_false(test_picture_shows(picture, x, y - 12, 3, test_plot_colour(0)));
    }
}

static void test_logarithmic(void)
{
    double x[7], y[7];
    for (int i = 0; i < 7; i++) {
        x[i] = pow(10, i - 3);
        y[i] = pow(10, -2 * i);
    }
    y[3] = -1; /* cannot be shown */
    const TinkerCurve curve = {.x = x, .y = y, .count = 7, .no_line = TRUE};
    const TinkerPlot plot = {
        .curves = &curve, .curve_count = 1, .x_logarithmic = TRUE, .y_logarithmic = TRUE, .x_label = "X"};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    double x0, y0, x6, y6;
    test_plot_place(&plot, x[0], y[0], &x0, &y0);
    test_plot_place(&plot, x[6], y[6], &x6, &y6);
    for (int i = 0; i < 7; i++) {
        gboolean shown =
            test_picture_shows(picture, x0 + (x6 - x0) * i / 6, y0 + (y6 - y0) * i / 6, 1, test_plot_colour(0));
        g_assert_cmpint(shown, ==, i != 3);
    }
}

/* A ring leaves the point that it is about to be seen; a guide is dashed and in no curve's colour. */
static void test_roles(void)
{
    double x[2] = {1e-6, 1e-2}, y[2] = {1e-9, 1e-3}, level[2] = {1e-6, 1e-6};
    const TinkerCurve curves[] = {
        {.x = x, .y = y, .count = 2, .markers = TRUE},
        {.x = x + 1, .y = y + 1, .count = 1, .role = TINKER_CURVE_RING},
        {.x = x, .y = level, .count = 2, .role = TINKER_CURVE_GUIDE},
    };
    const TinkerPlot plot = {.curves = curves, .curve_count = 3, .x_logarithmic = TRUE, .y_logarithmic = TRUE};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    const TinkerTheme *theme = tinker_theme_find("light");
    double ring_x, ring_y, from, to, line;
    test_plot_place(&plot, x[1], y[1], &ring_x, &ring_y);
    g_assert_true(test_picture_shows(picture, ring_x, ring_y, 1, test_plot_colour(0)));
    for (int i = 0; i < 8; i++) {
        double angle = (i + 0.5) * G_PI / 4;
        g_assert_true(test_picture_shows(picture, ring_x + 7.5 * cos(angle), ring_y + 7.5 * sin(angle), 1,
                                         theme->colours[TINKER_COLOUR_TEXT]));
    }
    test_plot_place(&plot, 1e-5, 1e-6, &from, &line);
    test_plot_place(&plot, 3e-5, 1e-6, &to, &line);
    int dark = 0, light = 0;
    for (double place_x = from; place_x < to; place_x++) {
        double darkest = 1;
        for (int row = -1; row <= 1; row++) {
            double pixel[4];
            test_picture_pixel(picture, (int)place_x, (int)line + row, pixel);
            darkest = fmin(darkest, pixel[0]);
        }
        *(darkest < 0.7 ? &dark : &light) += 1;
    }
    g_assert_cmpint(dark, >, 8);
    g_assert_cmpint(light, >, 4);
}

/* Of two curves in one place that is seen which is not behind, whichever comes first; the other one keeps its colour
 * elsewhere. */
static void test_behind(void)
{
    TestPlotData data;
    test_plot_fill(&data, test_plot_same, 0, 10);
    for (int behind = 0; behind < 2; behind++) {
        const TinkerCurve curves[] = {
            {.x = data.x, .y = data.y, .count = 200, .behind = behind == 0},
            {.x = data.x, .y = data.y, .count = 100, .colour = 1, .behind = behind == 1},
        };
        const TinkerPlot plot = {.curves = curves, .curve_count = 2};
        g_autoptr(TestPicture) picture = test_plot_draw(&plot);
        double x, y;
        test_plot_place(&plot, 2.5, 2.5, &x, &y);
        g_assert_true(test_picture_shows(picture, x, y, 1, test_plot_colour(1 - behind)));
        g_assert_false(test_picture_shows(picture, x, y, 1, test_plot_colour(behind)));
        test_plot_place(&plot, 7.5, 7.5, &x, &y);
        g_assert_true(test_picture_shows(picture, x, y, 1, test_plot_colour(0)));
    }
}

/* One sample among a million stands out of the line. */
static void test_spike(void)
{
    const gsize count = 1000000;
    g_autofree double *x = g_new(double, count), *y = g_new(double, count);
    for (gsize i = 0; i < count; i++) {
        x[i] = (double)i;
        y[i] = 0;
    }
    y[654321] = 1;
    y[123456] = -1;
    const TinkerCurve curve = {.x = x, .y = y, .count = count};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .x_label = "X", .y_label = "Y"};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    for (int i = 0; i < 2; i++) {
        double canvas_x, canvas_y;
        test_plot_place(&plot, i ? 654321 : 123456, i ? 0.8 : -0.8, &canvas_x, &canvas_y);
        g_assert_true(test_picture_shows(picture, canvas_x, canvas_y, 1, test_plot_colour(0)));
    }
}

typedef struct {
    gsize points;
    double least, greatest;
} Walked;

static void note_point(double x, double y, gboolean starts, gpointer data)
{
    Walked *walked = data;
    walked->points++;
    walked->least = fmin(walked->least, y);
    walked->greatest = fmax(walked->greatest, y);
}

/* Thinned, a curve has at most four points a column, and its extremes. */
static void test_thinning(void)
{
    const gsize count = 300000;
    g_autofree double *x = g_new(double, count), *y = g_new(double, count);
    double least = INFINITY, greatest = -INFINITY;
    for (gsize i = 0; i < count; i++) {
        x[i] = (double)i;
        y[i] = g_test_rand_double_range(-1, 1);
        least = fmin(least, y[i]);
        greatest = fmax(greatest, y[i]);
    }
    const TinkerCurve curve = {.x = x, .y = y, .count = count};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, &plot, &pen, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    Walked walked = {0, INFINITY, -INFINITY};
    tinker_plot_walk(&layout, &curve, 1, note_point, &walked);
    g_assert_cmpuint(walked.points, <=, 4 * (TEST_PLOT_WIDTH + 1));
    g_assert_cmpfloat(walked.least, ==, tinker_axis_place(&layout.y, greatest));
    g_assert_cmpfloat(walked.greatest, ==, tinker_axis_place(&layout.y, least));
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

/* Six swings to a pixel, and a growing amplitude: ink from -A to A everywhere, without a seam, and none beyond. */
static void test_crowd(void)
{
    const gsize count = 1000000;
    g_autofree double *x = g_new(double, count), *y = g_new(double, count);
    for (gsize i = 0; i < count; i++) {
        x[i] = (double)i / (double)(count - 1);
        y[i] = (0.3 + 0.7 * x[i]) * cos(20000 * x[i]);
    }
    const TinkerCurve curve = {.x = x, .y = y, .count = count};
    for (int quick = 0; quick < 2; quick++) {
        const TinkerPlot plot = {
            .curves = &curve, .curve_count = 1, .x_label = "X", .y_label = "Y", .quick = quick != 0};
        g_autoptr(TestPicture) picture = test_plot_draw(&plot);
        double corners[2][2]; /* of x = 0 and y = 0, of x = 1 and y = 1 */
        for (int k = 0; k < 2; k++)
            test_plot_place(&plot, k, k, &corners[k][0], &corners[k][1]);
        for (double at = 0.02; at < 0.98; at += 0.0031) {
            const double amplitude = (0.3 + 0.7 * at) * (corners[0][1] - corners[1][1]);
            const double across = corners[0][0] + at * (corners[1][0] - corners[0][0]);
            const double top = corners[0][1] - amplitude, bottom = corners[0][1] + amplitude;
            for (double down = top + 2; down < bottom - 2; down++)
                g_assert_true(test_picture_shows(picture, across, down, 0, test_plot_colour(0)));
            g_assert_false(test_picture_shows(picture, across, top - 4, 0, test_plot_colour(0)));
            g_assert_false(test_picture_shows(picture, across, bottom + 4, 0, test_plot_colour(0)));
        }
    }
}

static void test_gap(void)
{
    TestPlotData data;
    test_plot_fill(&data, test_plot_same, 0, 10);
    for (int i = 80; i < 120; i++)
        data.y[i] = i % 2 ? NAN : INFINITY;
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    double x, y;
    test_plot_place(&plot, 5, 5, &x, &y);
    g_assert_false(test_picture_shows(picture, x, y, 10, test_plot_colour(0)));
    test_plot_place(&plot, 3, 3, &x, &y);
    g_assert_true(test_picture_shows(picture, x, y, 1, test_plot_colour(0)));
    test_plot_place(&plot, 7, 7, &x, &y);
    g_assert_true(test_picture_shows(picture, x, y, 1, test_plot_colour(0)));
}

/* How high the name of the axis across is written (canvas units). */
static double height_of_label(double enlargement)
{
    const double x[2] = {0, 1}, y[2] = {0, 1};
    const TinkerCurve curve = {.x = x, .y = y, .count = 2};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .x_label = "Time [s]", .enlargement = enlargement};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    g_autoptr(GPtrArray) written = tinker_written_texts_new();
    tinker_plot_draw_noting(picture->cairo, &plot, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT, written);
    for (guint n = 0; n < written->len; n++) {
        const TinkerWrittenText *text = g_ptr_array_index(written, n);
        if (g_str_equal(text->text, "Time [s]")) return text->box[3] - text->box[1];
    }
    g_assert_not_reached();
}

static void test_enlargement(void)
{
    g_assert_cmpfloat(height_of_label(1), ==, height_of_label(0));
    g_assert_cmpfloat_with_epsilon(height_of_label(2) / height_of_label(1), 2, 0.15); /* heights are whole pixels */
}

/* A single point, a constant, nothing at all, nothing but NaN, one point between gaps. */
static void test_degenerate(void)
{
    const double x[3] = {1, 2, 3}, y[3] = {7, 7, 7}, gaps[3] = {NAN, 7, NAN}, none[3] = {NAN, NAN, NAN};
    const struct {
        TinkerCurve curve;
        gboolean shown;
    } cases[] = {
        {{.x = x, .y = y, .count = 1}, TRUE},    {{.x = x, .y = y, .count = 3}, TRUE},
        {{.x = x, .y = gaps, .count = 3}, TRUE}, {{.x = x, .y = none, .count = 3}, FALSE},
        {{.x = x, .y = y, .count = 0}, FALSE},   {{.count = 0}, FALSE},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const TinkerPlot plot = {.curves = &cases[i].curve, .curve_count = 1, .y_label = "Y [m]"};
        g_autoptr(TestPicture) picture = test_plot_draw(&plot);
        g_assert_cmpint(test_picture_count(picture, test_plot_colour(0)) > 0, ==, cases[i].shown);
        g_autoptr(GPtrArray) written = tinker_written_texts_new();
        tinker_plot_draw_noting(picture->cairo, &plot, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT, written);
        gboolean says_so = FALSE;
        for (guint n = 0; n < written->len; n++)
            says_so |= g_str_equal(((TinkerWrittenText *)g_ptr_array_index(written, n))->text, "no data");
        g_assert_cmpint(says_so, ==, !cases[i].shown);
    }
    const TinkerPlot nothing = {.curves = NULL};
    g_autoptr(TestPicture) picture = test_plot_draw(&nothing);
}

static void test_band(void)
{
    TestPlotData data;
    double low[200], high[200];
    test_plot_fill(&data, test_plot_same, 0, 10);
    for (int i = 0; i < 200; i++) {
        low[i] = data.y[i] - 3;
        high[i] = data.y[i] + 3;
    }
    const TinkerCurve curve = {.x = data.x, .y = data.y, .low = low, .high = high, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    double x, y, inside[4], outside[4];
    test_plot_place(&plot, 5.3, 7.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, inside);
    test_plot_place(&plot, 5.3, 9.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, outside);
    /* The first colour is blue: its band takes red away from the white ground. */
    g_assert_cmpfloat(outside[0] - inside[0], >, 0.1);
}

/* Where its borders are not known a band has a gap, and what follows hangs together with nothing before it. */
static void test_band_with_gap(void)
{
    TestPlotData data;
    double low[200], high[200];
    test_plot_fill(&data, test_plot_same, 0, 10);
    for (int i = 0; i < 200; i++) {
        gboolean known = i < 80 || i > 130;
        low[i] = known ? data.y[i] - 3 : NAN;
        high[i] = known ? data.y[i] + 3 : NAN;
    }
    const TinkerCurve curve = {.x = data.x, .y = data.y, .low = low, .high = high, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = test_plot_draw(&plot);
    double x, y, before[4], gap[4], after[4];
    test_plot_place(&plot, 2.3, 4.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, before);
    test_plot_place(&plot, 5.3, 7.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, gap);
    test_plot_place(&plot, 8.3, 10.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, after);
    g_assert_cmpfloat(gap[0] - before[0], >, 0.1);
    g_assert_cmpfloat(gap[0] - after[0], >, 0.1);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/plot/diagonal", test_diagonal);
    g_test_add_func("/render/plot/logarithmic", test_logarithmic);
    g_test_add_func("/render/plot/roles", test_roles);
    g_test_add_func("/render/plot/spike", test_spike);
    g_test_add_func("/render/plot/thinning", test_thinning);
    g_test_add_func("/render/plot/crowd", test_crowd);
    g_test_add_func("/render/plot/gap", test_gap);
    g_test_add_func("/render/plot/behind", test_behind);
    g_test_add_func("/render/plot/degenerate", test_degenerate);
    g_test_add_func("/render/plot/enlargement", test_enlargement);
    g_test_add_func("/render/plot/band", test_band);
    g_test_add_func("/render/plot/band-with-gap", test_band_with_gap);
    return g_test_run();
}
