/* Lines, marks and bands of curves. */
#include <math.h>
#include <string.h>

#include "render/plot/plot-private.h"

#define BAND_ALPHA 0.22

/* A curve on its way to the path. */
typedef struct {
    cairo_t *cairo;
    double column_width;
    GArray *points;   /* of double[2]: since the pen came down */
    GArray *solids;   /* of TinkerPlotSolid */
    GArray *isolated; /* of double[2]: points between two gaps */
} Pen;

/* The pen goes up: a lone point is noted. */
static void lift(Pen *pen)
{
    if (pen->points->len == 1)
        g_array_append_vals(pen->isolated, pen->points->data, 1);
    else
        tinker_plot_trace(pen->cairo, (const double(*)[2])(gconstpointer)pen->points->data, pen->points->len,
                          pen->column_width, pen->solids);
    g_array_set_size(pen->points, 0);
}

static void draw_to(double x, double y, gboolean starts, gpointer data)
{
    Pen *pen = data;
    const double point[2] = {x, y};
    if (starts) lift(pen);
    g_array_append_vals(pen->points, point, 1);
}

/* A sample between two gaps has no line: it is a dot, a little wider than the line so that it is seen. */
static void draw_line(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve, double column_width)
{
    Pen pen = {cairo, column_width, g_array_new(FALSE, FALSE, sizeof(double[2])),
               g_array_new(FALSE, FALSE, sizeof(TinkerPlotSolid)), g_array_new(FALSE, FALSE, sizeof(double[2]))};
    cairo_new_path(cairo);
    tinker_plot_walk(layout, curve, column_width, draw_to, &pen);
    lift(&pen);
    cairo_stroke(cairo);
    tinker_plot_fill_solids(cairo, pen.solids);
    const double(*isolated)[2] = (const double(*)[2])(gconstpointer)pen.isolated->data;
    for (guint i = 0; i < pen.isolated->len; i++) {
        cairo_arc(cairo, isolated[i][0], isolated[i][1], TINKER_PLOT_LINE, 0, 2 * G_PI);
        cairo_fill(cairo);
    }
    g_array_unref(pen.points);
    g_array_unref(pen.solids);
    g_array_unref(pen.isolated);
}

static void draw_markers(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve)
{
    double last_x = INFINITY, last_y = INFINITY;
    for (gsize i = 0; i < curve->count; i++) {
        double x, y;
        if (!tinker_plot_place(layout, curve, i, &x, &y)) continue;
        if (fabs(x - last_x) < 0.5 && fabs(y - last_y) < 0.5) continue;
        tinker_plot_draw_marker(cairo, curve, x, y);
        last_x = x;
        last_y = y;
    }
}

void tinker_plot_draw_curve(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve,
                            double column_width)
{
    tinker_plot_set_curve_style(cairo, layout, curve);
    if (tinker_plot_has_line(curve)) draw_line(cairo, layout, curve, column_width);
    if (tinker_plot_has_markers(curve)) draw_markers(cairo, layout, curve);
}

/* One run of the band, there along its upper border and back along the lower one. Element: x, upper y, lower y. */
static void fill_run(cairo_t *cairo, GArray *run)
{
    double(*points)[3] = (double(*)[3])(void *)run->data;
    /* Else the first line would come from the corner where the run before was closed. */
    cairo_new_sub_path(cairo);
    for (guint i = 0; i < run->len; i++)
        cairo_line_to(cairo, points[i][0], points[i][1]);
    for (guint i = run->len; i-- > 0;)
        cairo_line_to(cairo, points[i][0], points[i][2]);
    if (run->len) cairo_close_path(cairo);
    g_array_set_size(run, 0);
}

/* Of the points of a column of pixels: the first, the last, and how far all of them reach. A jump within one is as
 * broad as the column, whatever comes before and behind. */
typedef struct {
    double number; /* NAN: there is none */
    double first[3], reach[3], last[3];
    gboolean several;
} BandColumn;

static void close_band_column(BandColumn *column, GArray *run)
{
    if (isnan(column->number)) return;
    g_array_append_val(run, column->first);
    if (column->several) {
        g_array_append_val(run, column->reach);
        g_array_append_val(run, column->last);
    }
    column->number = NAN;
}

static void add_to_band(BandColumn *column, GArray *run, double number, const double point[3])
{
    if (number != column->number) {
        close_band_column(column, run);
        *column = (BandColumn){.number = number};
        memcpy(column->first, point, sizeof column->first);
        memcpy(column->reach, point, sizeof column->reach);
        return;
    }
    column->several = TRUE;
    column->reach[1] = fmin(column->reach[1], point[1]);
    column->reach[2] = fmax(column->reach[2], point[2]);
    memcpy(column->last, point, sizeof column->last);
}

void tinker_plot_draw_band(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve,
                           double column_width)
{
    if (!curve->low || !curve->high) return;
    GArray *run = g_array_new(FALSE, FALSE, 3 * sizeof(double));
    const double *c = tinker_plot_curve_colour(layout, curve);
    BandColumn column = {.number = NAN};
    cairo_new_path(cairo);
    for (gsize i = 0; i < curve->count; i++) {
        double x = tinker_axis_place(&layout->x, curve->x[i]);
        double upper = tinker_axis_place(tinker_plot_y_axis(layout, curve), curve->high[i]);
        double lower = tinker_axis_place(tinker_plot_y_axis(layout, curve), curve->low[i]);
        if (tinker_plot_y_axis(layout, curve)->logarithmic && curve->low[i] <= 0) lower = layout->bottom;
        if (!isfinite(x) || !isfinite(upper) || !isfinite(lower)) {
            close_band_column(&column, run);
            fill_run(cairo, run);
            continue;
        }
        const double point[3] = {x, upper, lower};
        add_to_band(&column, run, floor(x / column_width), point);
    }
    close_band_column(&column, run);
    fill_run(cairo, run);
    g_array_unref(run);
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], curve->filled ? c[3] : BAND_ALPHA * c[3]);
    cairo_fill(cairo);
}
