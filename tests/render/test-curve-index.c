/* The index of a long curve against a look at every point, and pictures drawn with it against those drawn without. */
#include <math.h>

#include "picture.h"
#include "render/plot/plot.h"

#define COUNT  100000
#define WIDTH  640
#define HEIGHT 420

typedef struct {
    double *x, *y;
    TinkerCurveIndex *index;
} Data;

/* A decaying oscillation with noise on it, its points unevenly spaced, and some at one instant. */
static Data data_new(GRand *random)
{
    Data data = {g_new(double, COUNT), g_new(double, COUNT), tinker_curve_index_new()};
    double x = 0;
    for (int i = 0; i < COUNT; i++) {
        data.x[i] = x;
        data.y[i] = exp(-x / 20) * sin(9 * x) + 0.05 * g_rand_double(random);
        if (g_rand_int_range(random, 0, 50) > 0) x += 1e-3 * g_rand_double(random);
    }
    return data;
}

static void data_clear(Data *data)
{
    g_free(data->x);
    g_free(data->y);
    tinker_curve_index_free(data->index);
}

static void test_extremes(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed((guint32)g_test_rand_int());
    Data data = data_new(random);
    /* in portions, as a record grows */
    for (gsize known = 0; known < COUNT;) {
        const gsize portion = (gsize)g_rand_int_range(random, 1, 3000);
        known = MIN(COUNT, known + portion);
        tinker_curve_index_add(data.index, data.x, data.y, known);
    }
    g_assert_cmpuint(tinker_curve_index_count(data.index), ==, COUNT);
    g_assert_true(tinker_curve_index_is_ordered(data.index));
    for (int try = 0; try < 300; try++) {
        const gsize from = (gsize)g_rand_int_range(random, 0, COUNT - 1);
        const gsize to = (gsize)g_rand_int_range(random, (gint32)from + 1, COUNT + 1);
        gsize least, greatest, low = from, high = from;
        for (gsize i = from; i < to; i++) {
            if (data.y[i] < data.y[low]) low = i;
            if (data.y[i] > data.y[high]) high = i;
        }
        tinker_curve_index_extremes(data.index, data.y, from, to, &least, &greatest);
        g_assert_cmpuint(least, ==, low);
        g_assert_cmpuint(greatest, ==, high);
    }
    data_clear(&data);
}

static TestPicture *draw(const Data *data, const TinkerCurveIndex *index, const double *x_range, const double *y_range,
                         gboolean logarithmic)
{
    const double cursor = data->x[COUNT / 3];
    const TinkerCurve curve = {.x = data->x, .y = data->y, .count = COUNT, .index = index, .label = "noise"};
    const TinkerPlot plot = {.x_label = "X [s]",
                             .y_label = "Y [m]",
                             .x_range = x_range,
                             .y_range = y_range,
                             .y_logarithmic = logarithmic,
                             .cursor = &cursor,
                             .curves = &curve,
                             .curve_count = 1};
    TestPicture *picture = test_picture_new(WIDTH, HEIGHT);
    tinker_plot_draw(picture->cairo, &plot, WIDTH, HEIGHT);
    cairo_surface_flush(picture->surface);
    return picture;
}

/* The largest difference of any colour of any pixel, of 255. */
static int difference(const TestPicture *a, const TestPicture *b)
{
    const guchar *left = cairo_image_surface_get_data(a->surface), *right = cairo_image_surface_get_data(b->surface);
    const gsize stride = (gsize)cairo_image_surface_get_stride(a->surface);
    int largest = 0;
    for (gsize i = 0; i < HEIGHT * stride; i++)
        largest = MAX(largest, ABS((int)left[i] - (int)right[i]));
    return largest;
}

/* All of it, and stretches down to a few points; with what is beyond the frame left out. */
static void test_same_pictures(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed((guint32)g_test_rand_int());
    static const double shares[][2] = {{0, 1}, {0.2, 0.7}, {0.5, 0.51}, {0.9, 0.9002}};
    static const double levels[2] = {-0.3, 0.4};
    Data data = data_new(random);
    tinker_curve_index_add(data.index, data.x, data.y, COUNT);
    for (gsize i = 0; i < G_N_ELEMENTS(shares); i++) {
        const double all = data.x[COUNT - 1], range[2] = {shares[i][0] * all, shares[i][1] * all};
        for (int zoomed = 0; zoomed < 2; zoomed++) {
            const double *y_range = zoomed ? levels : NULL;
            g_autoptr(TestPicture) quick = draw(&data, data.index, range, y_range, FALSE);
            g_autoptr(TestPicture) plain = draw(&data, NULL, range, y_range, FALSE);
            /* what lies beyond the frame takes part in the rounding of shades, in steps of 1/15 */
            g_assert_cmpint(difference(quick, plain), <=, 40);
        }
    }
    g_autoptr(TestPicture) quick = draw(&data, data.index, NULL, NULL, TRUE);
    g_autoptr(TestPicture) plain = draw(&data, NULL, NULL, NULL, TRUE);
    g_assert_cmpint(difference(quick, plain), ==, 0);
    data_clear(&data);
}

/* A path in the plane and a gap are not for it. */
static void test_what_it_is_not_for(void)
{
    const double back[3] = {0, 1, 0.5}, rising[3] = {0, 1, 2}, gap[3] = {0, NAN, 1};
    g_autoptr(TinkerCurveIndex) index = tinker_curve_index_new();
    tinker_curve_index_add(index, back, rising, 3);
    g_assert_false(tinker_curve_index_is_ordered(index));
    tinker_curve_index_clear(index);
    tinker_curve_index_add(index, rising, gap, 3);
    g_assert_false(tinker_curve_index_is_ordered(index));
    tinker_curve_index_clear(index);
    tinker_curve_index_add(index, rising, back, 3);
    g_assert_true(tinker_curve_index_is_ordered(index));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/curve-index/extremes", test_extremes);
    g_test_add_func("/render/curve-index/same-pictures", test_same_pictures);
    g_test_add_func("/render/curve-index/what-it-is-not-for", test_what_it_is_not_for);
    return g_test_run();
}
