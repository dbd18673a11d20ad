/* The legend stands where no curve passes, or beside or above the plot. */
#include <math.h>

#include "render/plot/plot-private.h"

#define COUNT 400

/* Whether a curve passes the box. */
static gboolean passes(const TinkerPlotLayout *layout, const TinkerCurve *curve, const double box[4])
{
    for (gsize i = 0; i < curve->count; i++) {
        double x, y;
        if (!tinker_plot_place(layout, curve, i, &x, &y)) continue;
        if (x >= box[0] && x <= box[2] && y >= box[1] && y <= box[3]) return TRUE;
    }
    return FALSE;
}

static void test_place(void)
{
    int inside = 0, outside = 0;
    for (int i = 0; i < 200; i++) {
        double x[COUNT], y[3][COUNT];
        TinkerCurve curves[3];
        double frequency = g_test_rand_double_range(0.1, 40), slope = g_test_rand_double_range(-2, 2);
        for (int n = 0; n < 3; n++) {
            for (int k = 0; k < COUNT; k++) {
                x[k] = k * 0.01;
                y[n][k] = slope * x[k] + sin(frequency * x[k] + n);
            }
            curves[n] = (TinkerCurve){.label = "Mass 0.x", .x = x, .y = y[n], .count = COUNT, .colour = n};
        }
        const TinkerPlot plot = {.x_label = "Time [s]", .y_label = "X [m]", .curves = curves, .curve_count = 3};
        TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
        TinkerPlotLayout layout;
        tinker_plot_lay_out(&layout, &plot, &pen, 640, 420);
        const double *box = layout.legend.box;
        if (layout.legend.kind == TINKER_LEGEND_INSIDE) {
            inside++;
            for (int n = 0; n < 3; n++)
                g_assert_false(passes(&layout, &curves[n], box));
            g_assert_true(box[0] > layout.left && box[2] < layout.right);
            g_assert_true(box[1] > layout.top && box[3] < layout.bottom);
        } else {
            outside++;
            g_assert_cmpint(layout.legend.kind, ==, TINKER_LEGEND_OUTSIDE);
            g_assert_true(box[0] > layout.right && box[2] <= 640);
        }
        tinker_plot_layout_clear(&layout);
        tinker_text_pen_clear(&pen);
    }
    /* Both happen. */
    g_assert_cmpint(inside, >, 0);
    g_assert_cmpint(outside, >, 0);
}

/* The small plots there are, from the least graph of the window on: a legend covers no curve, lies within the picture
 * and leaves the curves their height. */
static void test_small(void)
{
    int above = 0;
    for (int i = 0; i < 400; i++) {
        double x[COUNT], y[5][COUNT];
        TinkerCurve curves[5];
        const int count = g_test_rand_int_range(1, 6);
        const double width = g_test_rand_double_range(190, 480), height = g_test_rand_double_range(110, 300);
        const double frequency = g_test_rand_double_range(0.1, 40), slope = g_test_rand_double_range(-2, 2);
        for (int n = 0; n < count; n++) {
            for (int k = 0; k < COUNT; k++) {
                x[k] = k * 0.01;
                y[n][k] = slope * x[k] + sin(frequency * x[k] + n);
            }
            curves[n] = (TinkerCurve){.label = n % 2 ? "Mass 0: Velocity" : "Spring of the left side: Tension",
                                      .x = x,
                                      .y = y[n],
                                      .count = COUNT,
                                      .colour = n};
        }
        const TinkerPlot plot = {.x_label = "Time [s]",
                                 .y_label = "X [m]",
                                 .curves = curves,
                                 .curve_count = count,
                                 .compact = g_test_rand_bit() != 0};
        TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
        TinkerPlotLayout layout;
        tinker_plot_lay_out(&layout, &plot, &pen, width, height);
        const TinkerLegend *legend = &layout.legend;
        TinkerPlotGeometry geometry;
        tinker_plot_measure(&plot, width, height, &geometry);
        if (legend->kind == TINKER_LEGEND_NONE) g_assert_cmpfloat(geometry.legend[2], ==, 0);
        above += legend->kind == TINKER_LEGEND_ABOVE;
        if (legend->kind != TINKER_LEGEND_NONE) {
            for (int n = 0; n < count; n++)
                g_assert_false(passes(&layout, &curves[n], legend->box));
            g_assert_true(legend->box[0] >= 0 && legend->box[2] <= width);
            g_assert_true(legend->box[1] >= 0 && legend->box[3] <= height);
            g_assert_cmpint(legend->entries, >, 0);
        }
        if (legend->kind == TINKER_LEGEND_ABOVE) g_assert_cmpfloat(layout.bottom - layout.top, >=, 0.3 * height);
        tinker_plot_layout_clear(&layout);
        tinker_text_pen_clear(&pen);
    }
    g_assert_cmpint(above, >, 0);
}

static void test_none(void)
{
    const double x[2] = {0, 1}, y[2] = {0, 1};
    const TinkerCurve curves[2] = {{.x = x, .y = y, .count = 2}, {.label = "", .x = x, .y = y, .count = 2}};
    const TinkerPlot plot = {.curves = curves, .curve_count = 2};
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, &plot, &pen, 640, 420);
    g_assert_cmpint(layout.legend.kind, ==, TINKER_LEGEND_NONE);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

/* What the legend of a narrow plot writes of labels that are too long. (transfer full) */
static GPtrArray *labels_of(const char *const labels[], int count, gboolean *keeps_ends)
{
    const double x[2] = {0, 1}, y[2] = {0, 1};
    TinkerCurve curves[3];
    for (int i = 0; i < count; i++)
        curves[i] = (TinkerCurve){.label = labels[i], .x = x, .y = y, .count = 2};
    const TinkerPlot plot = {.curves = curves, .curve_count = count, .compact = TRUE};
    GPtrArray *written = tinker_written_texts_new();
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 190, 150);
    cairo_t *cairo = cairo_create(surface);
    tinker_plot_lay_out(&layout, &plot, &pen, 190, 150);
    layout.theme = tinker_theme_find("light");
    *keeps_ends = layout.legend.keeps_ends;
    TinkerPlotGeometry geometry;
    tinker_plot_measure(&plot, 190, 150, &geometry);
    if (*keeps_ends) g_assert_true(geometry.shortens_legend);
    for (int i = 0; i < 4; i++)
        g_assert_cmpfloat(geometry.legend[i], ==, layout.legend.box[i]);
    pen.written = written;
    tinker_plot_draw_legend(cairo, &layout);
    for (guint i = 0; i < written->len; i++) {
        const double *box = ((TinkerWrittenText *)g_ptr_array_index(written, i))->box;
        g_assert_cmpfloat(box[2] - box[0], <=, layout.legend.limit + 1e-6);
    }
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return written;
}

/* Where the ends tell labels apart, as names of runs do, these stay whole; where the beginnings do, those are read. */
static void test_cut(void)
{
    static const char *const runs[] = {"The heavy disc on its way (Run 1)", "The heavy disc on its way (Run 2)"};
    static const char *const quantities[] = {"Left mass: X Position", "Right mass: X Position",
                                             "First spring: Tension"};
    gboolean keeps_ends;
    g_autoptr(GPtrArray) of_runs = labels_of(runs, 2, &keeps_ends);
    g_assert_true(keeps_ends);
    g_assert_cmpuint(of_runs->len, ==, 2);
    for (guint i = 0; i < 2; i++) {
        const char *text = ((TinkerWrittenText *)g_ptr_array_index(of_runs, i))->text;
        g_assert_true(g_str_has_prefix(text, "The"));
        g_assert_true(g_str_has_suffix(text, i == 0 ? "… (Run 1)" : "… (Run 2)"));
    }
    g_autoptr(GPtrArray) of_quantities = labels_of(quantities, 3, &keeps_ends);
    g_assert_false(keeps_ends);
    g_assert_cmpuint(of_quantities->len, ==, 3);
}

/* Going down the middle of its samples, the entries come in order, each of the curve with that label, and nothing is
 * beside the legend. */
static void test_entries(void)
{
    static const double x[] = {0, 1}, y[] = {0, 1};
    const TinkerCurve curves[] = {{.label = "first", .x = x, .y = y, .count = 2},
                                  {.x = x, .y = y, .count = 2},
                                  {.label = "third", .x = x, .y = y, .count = 2}};
    const TinkerPlot plot = {.x_label = "x", .y_label = "y", .curves = curves, .curve_count = 3};
    TinkerPlotGeometry at;
    int last = -1;
    tinker_plot_measure(&plot, 640, 420, &at);
    for (double down = at.legend[1]; down < at.legend[3]; down++) {
        const int curve = tinker_plot_pick_legend(&plot, 640, 420, at.legend[0] + 12, down);
        g_assert_cmpint(tinker_plot_pick_legend(&plot, 640, 420, at.legend[0] - 2, down), ==, -1);
        if (curve < 0) continue;
        g_assert_cmpint(curve, >=, last);
        g_assert_cmpint(curve, !=, 1);
        last = curve;
    }
    g_assert_cmpint(last, ==, 2);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/legend/place", test_place);
    g_test_add_func("/render/legend/small", test_small);
    g_test_add_func("/render/legend/none", test_none);
    g_test_add_func("/render/legend/cut", test_cut);
    g_test_add_func("/render/legend/entries", test_entries);
    return g_test_run();
}
