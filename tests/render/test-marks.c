/* The cursor and the reading of a live graph, and graphs that are small, by their pixels and their texts. */
#include <math.h>

#include "picture.h"
#include "render/plot/plot-private.h"

#define COUNT 400

typedef struct {
    double t[COUNT], y[2][COUNT];
    TinkerCurve curves[2];
    TinkerPlot plot;
} Graph;

/* A straight line and a wave, of which the wave ends earlier. */
static void graph_init(Graph *graph)
{
    for (int i = 0; i < COUNT; i++) {
        graph->t[i] = 10.0 * i / (COUNT - 1);
        graph->y[0][i] = 0.2 * graph->t[i];
        graph->y[1][i] = 1 + sin(2 * graph->t[i]);
    }
    for (int i = 0; i < 2; i++)
        graph->curves[i] = (TinkerCurve){.x = graph->t, .y = graph->y[i], .count = i ? COUNT / 2 : COUNT, .colour = i};
    graph->plot = (TinkerPlot){.x_label = "Time [s]", .y_label = "Y [m]", .curves = graph->curves, .curve_count = 2};
}

static TestPicture *draw(const TinkerPlot *plot, int width, int height)
{
    TestPicture *picture = test_picture_new(width, height);
    tinker_plot_draw(picture->cairo, plot, width, height);
    return picture;
}

static void lay_out(const TinkerPlot *plot, int width, int height, TinkerPlotLayout *layout, TinkerTextPen *pen)
{
    *pen = (TinkerTextPen)TINKER_TEXT_PEN_INIT;
    tinker_plot_lay_out(layout, plot, pen, width, height);
}

static void clear(TinkerPlotLayout *layout, TinkerTextPen *pen)
{
    tinker_plot_layout_clear(layout);
    tinker_text_pen_clear(pen);
}

/* Pixels in a column that differ between two pictures. */
static int changed_in_column(const TestPicture *a, const TestPicture *b, int x)
{
    int count = 0;
    for (int y = 0; y < a->height; y++) {
        double first[4], second[4];
        test_picture_pixel(a, x, y, first);
        test_picture_pixel(b, x, y, second);
        count += fabs(first[0] - second[0]) + fabs(first[1] - second[1]) + fabs(first[2] - second[2]) > 0.1;
    }
    return count;
}

/* The line stands at its x over the whole height, and nowhere else but for dots, which lie on the curves' own values.
 */
static void test_cursor(void)
{
    static const double cursors[] = {0, 1.234, 4.9, 7.3, 10};
    const double(*colours)[4] = tinker_theme_find("light")->curves;
    Graph graph;
    graph_init(&graph);
    TinkerPlot plain = graph.plot;
    g_autoptr(TestPicture) before = draw(&plain, 480, 320);
    for (gsize i = 0; i < G_N_ELEMENTS(cursors); i++) {
        graph.plot.cursor = &cursors[i];
        g_autoptr(TestPicture) picture = draw(&graph.plot, 480, 320);
        TinkerPlotLayout layout;
        TinkerTextPen pen;
        lay_out(&graph.plot, 480, 320, &layout, &pen);
        double x = tinker_axis_place(&layout.x, cursors[i]), high = layout.bottom - layout.top;
        gboolean on_frame = i == 0 || i + 1 == G_N_ELEMENTS(cursors);
        if (!on_frame) g_assert_cmpint(changed_in_column(before, picture, (int)floor(x)), >, 0.8 * high);
        for (int column = 0; column < 480; column++)
            if (fabs(column + 0.5 - x) > 6) g_assert_cmpint(changed_in_column(before, picture, column), ==, 0);
        double line = tinker_axis_place(&layout.y, 0.2 * cursors[i]);
        double wave = tinker_axis_place(&layout.y, 1 + sin(2 * cursors[i]));
        g_assert_true(test_picture_shows(picture, x, line, 0, colours[0]) || fabs(wave - line) < 5);
        if (cursors[i] < 4.97) g_assert_true(test_picture_shows(picture, x, wave, 0, colours[1]));
        clear(&layout, &pen);
    }
}

/* A cursor beyond what the axis shows, or none that is a number, is no cursor. */
static void test_no_cursor(void)
{
    static const double odd[] = {-1, 10.5, NAN, INFINITY, 1e300};
    Graph graph;
    graph_init(&graph);
    g_autoptr(TestPicture) before = draw(&graph.plot, 320, 200);
    for (gsize i = 0; i < G_N_ELEMENTS(odd); i++) {
        graph.plot.cursor = &odd[i];
        g_autoptr(TestPicture) picture = draw(&graph.plot, 320, 200);
        for (int x = 0; x < 320; x++)
            g_assert_cmpint(changed_in_column(before, picture, x), ==, 0);
    }
}

/* The bubble of any point lies within the curves' rectangle, and not on its point where there is room beside it, and
 * both texts within the bubble. */
static void check_reading(const TinkerPlot *plot, int width, int height)
{
    const TinkerPlotReading *reading = plot->reading;
    const TinkerCurve *curve = &plot->curves[reading->curve];
    g_autoptr(GPtrArray) written = tinker_written_texts_new();
    g_autoptr(TestPicture) picture = test_picture_new(width, height);
    TinkerPlotLayout layout;
    TinkerTextPen pen;
    double box[4], x, y;
    tinker_plot_draw_noting(picture->cairo, plot, width, height, written);
    lay_out(plot, width, height, &layout, &pen);
    g_assert_true(tinker_plot_place_reading(&layout, box));
    g_assert_true(tinker_plot_place(&layout, curve, reading->point, &x, &y));
    g_assert_true(box[0] >= layout.left && box[2] <= layout.right);
    g_assert_true(box[1] >= layout.top && box[3] <= layout.bottom);
    gboolean covered = x > box[0] && x < box[2] && y > box[1] && y < box[3];
    gboolean roomy = layout.right - layout.left > 2.5 * (box[2] - box[0]);
    g_assert_false(covered && roomy);
    if (!covered) g_assert_true(test_picture_shows(picture, x, y, 0, layout.theme->curves[curve->colour]));
    int found = 0;
    for (guint i = 0; i < written->len; i++) {
        const TinkerWrittenText *text = g_ptr_array_index(written, i);
        if (!g_str_equal(text->text, reading->x) && !g_str_equal(text->text, reading->y)) continue;
        found++;
        g_assert_true(text->box[0] >= box[0] && text->box[2] <= box[2]);
        g_assert_true(text->box[1] >= box[1] && text->box[3] <= box[3]);
    }
    g_assert_cmpint(found, ==, 2);
    clear(&layout, &pen);
}

static void test_reading(void)
{
    Graph graph;
    graph_init(&graph);
    TinkerPlotReading reading = {.x = "t = 1.25000 s", .y = "y = −0.20000 m"};
    graph.plot.reading = &reading;
    for (int curve = 0; curve < 2; curve++)
        for (gsize point = 0; point < graph.curves[curve].count; point += 13) {
            reading.curve = curve;
            reading.point = point;
            graph.plot.compact = FALSE;
            check_reading(&graph.plot, 480, 320);
            graph.plot.compact = TRUE;
            check_reading(&graph.plot, 300, 200);
            check_reading(&graph.plot, 150, 120);
        }
}

/* A point that is not there, or beyond the shown range, has no bubble. */
static void test_no_reading(void)
{
    const double range[2] = {0, 2};
    const TinkerPlotReading odd[] = {
        {-1, 0, "a", "b"}, {2, 0, "a", "b"}, {0, COUNT, "a", "b"}, {0, COUNT - 1, "a", "b"}};
    Graph graph;
    graph_init(&graph);
    graph.plot.x_range = range;
    for (gsize i = 0; i < G_N_ELEMENTS(odd); i++) {
        TinkerPlotLayout layout;
        TinkerTextPen pen;
        double box[4];
        graph.plot.reading = &odd[i];
        lay_out(&graph.plot, 320, 200, &layout, &pen);
        g_assert_false(tinker_plot_place_reading(&layout, box));
        clear(&layout, &pen);
        test_picture_free(draw(&graph.plot, 320, 200));
    }
}

static gboolean are_apart(const TinkerWrittenText *a, const TinkerWrittenText *b)
{
    return a->box[2] <= b->box[0] || b->box[2] <= a->box[0] || a->box[3] <= b->box[1] || b->box[3] <= a->box[1];
}

/* Small and compact: the curves have more room than an ordinary plot of this size gives them, all texts stand apart and
 * on the picture, and both axes have numbers. */
static void test_compact(void)
{
    Graph graph;
    graph_init(&graph);
    graph.curves[0].label = "Mass 0";
    graph.curves[1].label = "Mass 1";
    graph.plot.title = "Position";
    double area[2];
    for (int compact = 0; compact < 2; compact++) {
        TinkerPlotLayout layout;
        TinkerTextPen pen;
        graph.plot.compact = compact;
        lay_out(&graph.plot, 240, 160, &layout, &pen);
        area[compact] = (layout.right - layout.left) * (layout.bottom - layout.top);
        if (compact) {
            g_assert_cmpint(layout.x.tick_count, >=, 2);
            g_assert_cmpint(layout.y.tick_count, >=, 2);
            g_assert_cmpint(layout.legend.kind, ==, TINKER_LEGEND_INSIDE);
        }
        clear(&layout, &pen);
    }
    g_assert_cmpfloat(area[1], >, 1.25 * area[0]);
    g_autoptr(GPtrArray) written = tinker_written_texts_new();
    g_autoptr(TestPicture) picture = test_picture_new(240, 160);
    tinker_plot_draw_noting(picture->cairo, &graph.plot, 240, 160, written);
    g_assert_cmpuint(written->len, >=, 2 + 2 + 3 + 2);
    for (guint i = 0; i < written->len; i++) {
        const TinkerWrittenText *text = g_ptr_array_index(written, i);
        g_assert_true(text->box[0] >= 0 && text->box[1] >= 0 && text->box[2] <= 240 && text->box[3] <= 160);
        for (guint n = 0; n < i; n++)
            g_assert_true(are_apart(text, g_ptr_array_index(written, n)));
    }
}

/* Pictures that share a memory are those that do not. */
static void test_memory(void)
{
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    const double cursor = 3;
    Graph graph;
    graph_init(&graph);
    graph.curves[0].label = "Mass 0";
    graph.plot.cursor = &cursor;
    g_autoptr(TestPicture) wanted = draw(&graph.plot, 320, 200);
    graph.plot.memory = memory;
    for (int i = 0; i < 3; i++) {
        g_autoptr(TestPicture) picture = draw(&graph.plot, 320, 200);
        for (int x = 0; x < 320; x++)
            g_assert_cmpint(changed_in_column(wanted, picture, x), ==, 0);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/marks/cursor", test_cursor);
    g_test_add_func("/render/marks/no-cursor", test_no_cursor);
    g_test_add_func("/render/marks/reading", test_reading);
    g_test_add_func("/render/marks/no-reading", test_no_reading);
    g_test_add_func("/render/marks/compact", test_compact);
    g_test_add_func("/render/marks/memory", test_memory);
    return g_test_run();
}
