/* Plots by their pixels: curves where the data are, spikes kept, gaps kept; and no texts over each other. */
#include <math.h>
#include <string.h>

#include "picture.h"
#include "render/plot/plot-private.h"

#define WIDTH  640
#define HEIGHT 420

typedef struct {
    double x[200], y[200];
} Data;

static void fill(Data *data, double (*function)(double), double from, double to)
{
    for (int i = 0; i < 200; i++) {
        data->x[i] = from + (to - from) * i / 199;
        data->y[i] = function(data->x[i]);
    }
}

static double same(double x)
{
    return x;
}

/* Where a value lies in the plot. */
static void place(const TinkerPlot *plot, double x, double y, double *canvas_x, double *canvas_y)
{
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, plot, &pen, WIDTH, HEIGHT);
    *canvas_x = tinker_axis_place(&layout.x, x);
    *canvas_y = tinker_axis_place(&layout.y, y);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

static TestPicture *draw(const TinkerPlot *plot)
{
    TestPicture *picture = test_picture_new(WIDTH, HEIGHT);
    tinker_plot_draw(picture->cairo, plot, WIDTH, HEIGHT);
    return picture;
}

static const double *colour_of(int curve)
{
    return tinker_theme_find("light")->curves[curve];
}

/* y = x runs from corner to corner of the data's box, and the places agree with the frame's own geometry: the first
 * tick pixel of the frame is where the axis says 0 is. */
static void test_diagonal(void)
{
    Data data;
    fill(&data, same, 0, 10);
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.x_label = "X [m]", .y_label = "Y [m]", .curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = draw(&plot);
    double left, bottom, right, top;
    place(&plot, 0, 0, &left, &bottom);
    place(&plot, 10, 10, &right, &top);
    g_assert_cmpfloat(left, <, right - 400);
    g_assert_cmpfloat(top, <, bottom - 250);
    for (int i = 1; i < 40; i++) {
        double x = left + (right - left) * i / 40, y = bottom + (top - bottom) * i / 40;
        g_assert_true(test_picture_shows(picture, x, y, 1, colour_of(0)));
        g_assert_false(test_picture_shows(picture, x, y + 12, 3, colour_of(0)));
        g_assert_false(test_picture_shows(picture, x, y - 12, 3, colour_of(0)));
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
    g_autoptr(TestPicture) picture = draw(&plot);
    double x0, y0, x6, y6;
    place(&plot, x[0], y[0], &x0, &y0);
    place(&plot, x[6], y[6], &x6, &y6);
    for (int i = 0; i < 7; i++) {
        gboolean shown = test_picture_shows(picture, x0 + (x6 - x0) * i / 6, y0 + (y6 - y0) * i / 6, 1, colour_of(0));
        g_assert_cmpint(shown, ==, i != 3);
    }
}

/* Where labels stand at every other power of ten, lines stand at all of them. */
static void test_decades_without_labels(void)
{
    double x[2] = {1, 10}, y[2] = {1e-15, 1};
    const TinkerCurve curve = {.x = x, .y = y, .count = 2, .markers = TRUE, .no_line = TRUE};
    const TinkerPlot plot = {
        .curves = &curve, .curve_count = 1, .x_logarithmic = TRUE, .y_logarithmic = TRUE, .y_label = "Y"};
    g_autoptr(TestPicture) picture = draw(&plot);
    for (int decade = -14; decade < 0; decade++) {
        double right, line, ground[4], between[4];
        place(&plot, 6.5, pow(10, decade), &right, &line);
        test_picture_pixel(picture, (int)right, (int)floor(line), ground);
        test_picture_pixel(picture, (int)right, (int)floor(line) + 6, between);
        g_assert_cmpfloat(ground[0], <, between[0] - 0.02);
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
    g_autoptr(TestPicture) picture = draw(&plot);
    const TinkerTheme *theme = tinker_theme_find("light");
    double ring_x, ring_y, from, to, line;
    place(&plot, x[1], y[1], &ring_x, &ring_y);
    g_assert_true(test_picture_shows(picture, ring_x, ring_y, 1, colour_of(0)));
    for (int i = 0; i < 8; i++) {
        double angle = (i + 0.5) * G_PI / 4;
        g_assert_true(test_picture_shows(picture, ring_x + 7.5 * cos(angle), ring_y + 7.5 * sin(angle), 1,
                                         theme->colours[TINKER_COLOUR_TEXT]));
    }
    place(&plot, 1e-5, 1e-6, &from, &line);
    place(&plot, 3e-5, 1e-6, &to, &line);
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
    g_autoptr(TestPicture) picture = draw(&plot);
    for (int i = 0; i < 2; i++) {
        double canvas_x, canvas_y;
        place(&plot, i ? 654321 : 123456, i ? 0.8 : -0.8, &canvas_x, &canvas_y);
        g_assert_true(test_picture_shows(picture, canvas_x, canvas_y, 1, colour_of(0)));
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
    tinker_plot_lay_out(&layout, &plot, &pen, WIDTH, HEIGHT);
    Walked walked = {0, INFINITY, -INFINITY};
    tinker_plot_walk(&layout, &curve, 1, note_point, &walked);
    g_assert_cmpuint(walked.points, <=, 4 * (WIDTH + 1));
    g_assert_cmpfloat(walked.least, ==, tinker_axis_place(&layout.y, greatest));
    g_assert_cmpfloat(walked.greatest, ==, tinker_axis_place(&layout.y, least));
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

static void test_gap(void)
{
    Data data;
    fill(&data, same, 0, 10);
    for (int i = 80; i < 120; i++)
        data.y[i] = i % 2 ? NAN : INFINITY;
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = draw(&plot);
    double x, y;
    place(&plot, 5, 5, &x, &y);
    g_assert_false(test_picture_shows(picture, x, y, 10, colour_of(0)));
    place(&plot, 3, 3, &x, &y);
    g_assert_true(test_picture_shows(picture, x, y, 1, colour_of(0)));
    place(&plot, 7, 7, &x, &y);
    g_assert_true(test_picture_shows(picture, x, y, 1, colour_of(0)));
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
        g_autoptr(TestPicture) picture = draw(&plot);
        g_assert_cmpint(test_picture_count(picture, colour_of(0)) > 0, ==, cases[i].shown);
        g_autoptr(GPtrArray) written = tinker_written_texts_new();
        tinker_plot_draw_noting(picture->cairo, &plot, WIDTH, HEIGHT, written);
        gboolean says_so = FALSE;
        for (guint n = 0; n < written->len; n++)
            says_so |= g_str_equal(((TinkerWrittenText *)g_ptr_array_index(written, n))->text, "no data");
        g_assert_cmpint(says_so, ==, !cases[i].shown);
    }
    const TinkerPlot nothing = {.curves = NULL};
    g_autoptr(TestPicture) picture = draw(&nothing);
}

static void test_band(void)
{
    Data data;
    double low[200], high[200];
    fill(&data, same, 0, 10);
    for (int i = 0; i < 200; i++) {
        low[i] = data.y[i] - 3;
        high[i] = data.y[i] + 3;
    }
    const TinkerCurve curve = {.x = data.x, .y = data.y, .low = low, .high = high, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = draw(&plot);
    double x, y, inside[4], outside[4];
    place(&plot, 5.3, 7.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, inside);
    place(&plot, 5.3, 9.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, outside);
    /* The first colour is blue: its band takes red away from the white ground. */
    g_assert_cmpfloat(outside[0] - inside[0], >, 0.1);
}

/* Where its borders are not known a band has a gap, and what follows hangs together with nothing before it. */
static void test_band_with_gap(void)
{
    Data data;
    double low[200], high[200];
    fill(&data, same, 0, 10);
    for (int i = 0; i < 200; i++) {
        gboolean known = i < 80 || i > 130;
        low[i] = known ? data.y[i] - 3 : NAN;
        high[i] = known ? data.y[i] + 3 : NAN;
    }
    const TinkerCurve curve = {.x = data.x, .y = data.y, .low = low, .high = high, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = draw(&plot);
    double x, y, before[4], gap[4], after[4];
    place(&plot, 2.3, 4.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, before);
    place(&plot, 5.3, 7.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, gap);
    place(&plot, 8.3, 10.3, &x, &y);
    test_picture_pixel(picture, (int)x, (int)y, after);
    g_assert_cmpfloat(gap[0] - before[0], >, 0.1);
    g_assert_cmpfloat(gap[0] - after[0], >, 0.1);
}

/* Equal scales: a unit is as long in both directions. */
static void test_equal_scales(void)
{
    Data data;
    fill(&data, sin, 0, 10);
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .equal_scales = TRUE, .x_label = "X"};
    double x0, y0, x1, y1;
    place(&plot, 0, 0, &x0, &y0);
    place(&plot, 1, 1, &x1, &y1);
    g_assert_cmpfloat_with_epsilon(x1 - x0, y0 - y1, 1e-9);
}

/* An axis shows just what it is told to, whatever the data. */
static void test_ranges(void)
{
    Data data;
    fill(&data, sin, 0, 10);
    const double across[2] = {2, 4}, up[2] = {-3, 1};
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .x_range = across, .y_range = up};
    double left, bottom, right, top, middle, centre;
    place(&plot, 2, -3, &left, &bottom);
    place(&plot, 4, 1, &right, &top);
    place(&plot, 3, -1, &middle, &centre);
    g_assert_cmpfloat(left, >, 0);
    g_assert_cmpfloat(right - left, >, 0.7 * WIDTH);
    g_assert_cmpfloat(bottom - top, >, 0.7 * HEIGHT);
    g_assert_cmpfloat_with_epsilon(middle, 0.5 * (left + right), 1e-9);
    g_assert_cmpfloat_with_epsilon(centre, 0.5 * (bottom + top), 1e-9);
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, &plot, &pen, WIDTH, HEIGHT);
    g_assert_cmpfloat_with_epsilon(layout.left, left, 1e-9);
    g_assert_cmpfloat_with_epsilon(layout.right, right, 1e-9);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

/* A curve of the second axis, a thousand times as high, lies where that of the first does; both axes have their texts,
 * those of the second at the right of the frame. */
static void test_second_axis(void)
{
    Data left, right;
    fill(&left, same, 0, 10);
    right = left;
    for (int i = 0; i < 200; i++)
        right.y[i] *= 1000;
    const TinkerCurve curves[] = {{.x = left.x, .y = left.y, .count = 200},
                                  {.x = right.x, .y = right.y, .count = 200, .colour = 1, .right = TRUE}};
    TinkerPlot plot = {
        .x_label = "X", .y_label = "Left [m]", .right_label = "Right [N]", .curves = curves, .curve_count = 2};
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, &plot, &pen, WIDTH, HEIGHT);
    for (gsize i = 0; i < 200; i += 50) {
        double x, y, other_x, other_y;
        g_assert_true(tinker_plot_place(&layout, &curves[0], i, &x, &y));
        g_assert_true(tinker_plot_place(&layout, &curves[1], i, &other_x, &other_y));
        g_assert_cmpfloat(fabs(x - other_x) + fabs(y - other_y), <, 1e-9);
    }
    g_assert_cmpfloat(layout.right, <, WIDTH - 60);
    g_assert_cmpstr(layout.second.title, ==, "Right [N]");
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);

    g_autoptr(GPtrArray) written = tinker_written_texts_new();
    g_autoptr(TestPicture) picture = test_picture_new(WIDTH, HEIGHT);
    tinker_plot_draw_noting(picture->cairo, &plot, WIDTH, HEIGHT, written);
    gboolean titled = FALSE;
    for (guint i = 0; i < written->len; i++)
        titled |= g_str_equal(((TinkerWrittenText *)g_ptr_array_index(written, i))->text, "Right [N]");
    g_assert_true(titled);
    plot.right_logarithmic = TRUE;
    const double range[2] = {10, 1000};
    plot.right_range = range;
    tinker_plot_lay_out(&layout, &plot, &pen, WIDTH, HEIGHT);
    /* 100 is in the middle of 10 and 1000 */
    double middle = tinker_axis_place(&layout.second, 100);
    g_assert_cmpfloat(fabs(middle - 0.5 * (layout.top + layout.bottom)), <, 1e-9);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

static void test_pick(void)
{
    Data data;
    fill(&data, same, 0, 10);
    const TinkerCurve curve = {.x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.curves = &curve, .curve_count = 1, .x_label = "X", .title = "T"};
    double x, y;
    place(&plot, data.x[77], data.y[77], &x, &y);
    TinkerPlotPoint point;
    g_assert_true(tinker_plot_pick(&plot, WIDTH, HEIGHT, x + 0.4, y - 0.4, 5, &point));
    g_assert_cmpint(point.curve, ==, 0);
    g_assert_cmpuint(point.point, ==, 77);
    g_assert_cmpfloat_with_epsilon(point.canvas_x, x, 1e-9);
    g_assert_false(tinker_plot_pick(&plot, WIDTH, HEIGHT, x + 60, y + 60, 5, &point));
}

/* Texts
 * ---------------------------------------------------------------------------------------------------------------- */

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
        Data data[3];
        TinkerCurve curves[3];
        double size = pow(10, g_test_rand_double_range(-200, 200)), offset = g_test_rand_double_range(-1e6, 1e6);
        for (int n = 0; n < 3; n++) {
            fill(&data[n], sin, 0, g_test_rand_double_range(0.001, 1e5));
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
    Data data;
    fill(&data, same, 0, 10);
    const TinkerCurve curve = {.label = "L", .x = data.x, .y = data.y, .count = 200};
    const TinkerPlot plot = {.title = "T", .x_label = "X", .y_label = "Y", .curves = &curve, .curve_count = 1};
    g_autoptr(TestPicture) picture = test_picture_new(WIDTH, HEIGHT);
    for (int width = 0; width < 130; width += 7)
        for (int height = 0; height < 130; height += 11)
            tinker_plot_draw(picture->cairo, &plot, width, height);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/plot/diagonal", test_diagonal);
    g_test_add_func("/render/plot/logarithmic", test_logarithmic);
    g_test_add_func("/render/plot/decades-without-labels", test_decades_without_labels);
    g_test_add_func("/render/plot/roles", test_roles);
    g_test_add_func("/render/plot/spike", test_spike);
    g_test_add_func("/render/plot/thinning", test_thinning);
    g_test_add_func("/render/plot/gap", test_gap);
    g_test_add_func("/render/plot/degenerate", test_degenerate);
    g_test_add_func("/render/plot/band", test_band);
    g_test_add_func("/render/plot/band-with-gap", test_band_with_gap);
    g_test_add_func("/render/plot/equal-scales", test_equal_scales);
    g_test_add_func("/render/plot/ranges", test_ranges);
    g_test_add_func("/render/plot/second-axis", test_second_axis);
    g_test_add_func("/render/plot/pick", test_pick);
    g_test_add_func("/render/plot/texts", test_texts);
    g_test_add_func("/render/plot/tiny", test_tiny);
    return g_test_run();
}
