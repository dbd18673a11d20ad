#include "plot-picture.h"

void test_plot_fill(TestPlotData *data, double (*function)(double), double from, double to)
{
    for (int i = 0; i < 200; i++) {
        data->x[i] = from + (to - from) * i / 199;
        data->y[i] = function(data->x[i]);
    }
}

double test_plot_same(double x)
{
    return x;
}

void test_plot_place(const TinkerPlot *plot, double x, double y, double *canvas_x, double *canvas_y)
{
    TinkerTextPen pen = TINKER_TEXT_PEN_INIT;
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, plot, &pen, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    *canvas_x = tinker_axis_place(&layout.x, x);
    *canvas_y = tinker_axis_place(&layout.y, y);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

TestPicture *test_plot_draw(const TinkerPlot *plot)
{
    TestPicture *picture = test_picture_new(TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    tinker_plot_draw(picture->cairo, plot, TEST_PLOT_WIDTH, TEST_PLOT_HEIGHT);
    return picture;
}

const double *test_plot_colour(int curve)
{
    return tinker_theme_find("light")->curves[curve];
}
