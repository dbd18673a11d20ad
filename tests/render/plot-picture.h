/* Plots that are drawn into a picture in memory. */
#ifndef TEST_PLOT_PICTURE_H
#define TEST_PLOT_PICTURE_H

#include "picture.h"
#include "render/plot/plot-private.h"

#define TEST_PLOT_WIDTH  640
#define TEST_PLOT_HEIGHT 420

typedef struct {
    double x[200], y[200];
} TestPlotData;

/* Values of a function at evenly spaced places. */
void test_plot_fill(TestPlotData *data, double (*function)(double), double from, double to);

/* y = x. */
double test_plot_same(double x);

/* Where a value lies in the plot. */
void test_plot_place(const TinkerPlot *plot, double x, double y, double *canvas_x, double *canvas_y);

/* (transfer full) */
TestPicture *test_plot_draw(const TinkerPlot *plot);

/* Of a curve in the light theme. */
const double *test_plot_colour(int curve);

#endif
