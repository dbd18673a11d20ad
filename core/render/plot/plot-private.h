/* The plot's parts: axes, layout, curves, legend. Canvas coordinates have y down; those of axes run along the axis. */
#ifndef TINKER_RENDER_PLOT_PRIVATE_H
#define TINKER_RENDER_PLOT_PRIVATE_H

#include <math.h>

#include "render/draw/text.h"
#include "render/plot/plot.h"

#define TINKER_PLOT_LINE       1.8 /* canvas units */
#define TINKER_PLOT_MOST_TICKS 24

/* Sizes of texts and of the room about them, canvas units. */
typedef struct {
    double text, title, tick_text;
    double pad;         /* between parts */
    double tick_gap;    /* between the frame and tick labels: those of both axes meet in the corner */
    double label_room;  /* between tick labels of the x axis, at least */
    double column, row; /* what one tick of the x axis gets at least, and one of the y axis */
    double legend_row;
    double legend_sample; /* length of a curve's sample */
    double legend_inset;  /* between the legend and the plot's frame */
} TinkerPlotSizes;

/* One axis. `low` and `high` are what it shows, as common logarithms where it is logarithmic. */
typedef struct {
    gboolean logarithmic;
    gboolean empty; /* there were no data */
    double low, high;
    double start, length; /* on the canvas: where `low` lies, and the way from there to `high` (up is negative) */
    int tick_count;
    double ticks[TINKER_PLOT_MOST_TICKS]; /* as `low` and `high` */
    char *labels[TINKER_PLOT_MOST_TICKS];
    int decade_stride; /* of a logarithmic axis: from one power of ten with a label to the next; 0: ticks are numbers */
    char *title;       /* the label, with the factor and the offset that the ticks' labels leave out */
} TinkerAxis;

/* Puts the box of all numbers into the axis; a range without extent is widened, and `margin` (a share) is added. */
void tinker_axis_set_range(TinkerAxis *axis, double least, double greatest, double margin);

/* Chooses at most `most` ticks and writes their labels, and the title after the plain label, "Y Position [m]". */
void tinker_axis_choose_ticks(TinkerAxis *axis, int most, const char *label);

void tinker_axis_clear(TinkerAxis *axis);

#define TINKER_AXIS_GREATEST 1e300
#define TINKER_AXIS_LEAST    1e-300 /* of a logarithmic axis */

/* Where a number of the data lies on the canvas; NAN where it cannot be shown. */
static inline double tinker_axis_place(const TinkerAxis *axis, double value)
{
    if (axis->logarithmic) value = value > 0 ? log10(fmax(value, TINKER_AXIS_LEAST)) : NAN;
    if (!isfinite(value)) return NAN;
    value = CLAMP(value, -TINKER_AXIS_GREATEST, TINKER_AXIS_GREATEST);
    return axis->start + (value - axis->low) / (axis->high - axis->low) * axis->length;
}

/* The number that lies at a place of the canvas. */
static inline double tinker_axis_value(const TinkerAxis *axis, double place)
{
    const double value = axis->low + (place - axis->start) / axis->length * (axis->high - axis->low);
    return axis->logarithmic ? pow(10, value) : value;
}

/* Whether a curve's index can be asked on these axes: what a logarithm does not have is not in the way of it. */
gboolean tinker_plot_can_index(const TinkerCurve *curve, gboolean x_logarithmic, gboolean y_logarithmic);

/* Where the legend stands. */
typedef enum { TINKER_LEGEND_NONE, TINKER_LEGEND_INSIDE, TINKER_LEGEND_OUTSIDE, TINKER_LEGEND_ABOVE } TinkerLegendKind;
typedef struct {
    TinkerLegendKind kind;
    double box[4];
    int entries;         /* that are shown; more are counted in a last line */
    int columns;         /* that they stand in, row by row, */
    double column_width; /* each so wide */
    double limit;        /* width of a label, */
    gboolean keeps_ends; /* of which a longer one keeps its end: beginnings alone would not tell them apart */
} TinkerLegend;

/* Everything about a plot but its ink. */
typedef struct {
    const TinkerPlot *plot;
    const TinkerTheme *theme;
    TinkerPlotSizes own_sizes; /* of what is larger or smaller than the usual ones */
    const TinkerPlotSizes *sizes;
    TinkerTextPen *pen;
    double width, height;
    double left, top, right, bottom; /* the rectangle of the curves */
    double x_range[2], y_range[2],
        second_range[2];     /* from, to: of the data, or as the plot asks for; from > to where there are none */
    gboolean with_marks;     /* curves have marks, which need room at the sides */
    TinkerAxis x, y, second; /* the second y axis stands at the right */
    gboolean has_second;
    TinkerLegend legend;
} TinkerPlotLayout;

/* The y axis that a curve belongs to. */
static inline const TinkerAxis *tinker_plot_y_axis(const TinkerPlotLayout *layout, const TinkerCurve *curve)
{
    return curve->right ? &layout->second : &layout->y;
}

void tinker_plot_lay_out(TinkerPlotLayout *layout, const TinkerPlot *plot, TinkerTextPen *pen, double width,
                         double height);
void tinker_plot_layout_clear(TinkerPlotLayout *layout);

/* Whether point i of a curve can be shown, and where. */
gboolean tinker_plot_place(const TinkerPlotLayout *layout, const TinkerCurve *curve, gsize i, double *x, double *y);

/* Takes a thinned curve point by point; `starts` where the pen comes down anew. */
typedef void (*TinkerPathFunction)(double x, double y, gboolean starts, gpointer data);
void tinker_plot_walk(const TinkerPlotLayout *layout, const TinkerCurve *curve, double column_width,
                      TinkerPathFunction path, gpointer data);

/* One column of a part of a curve that is crowded (plot-crowd.c); `begins`: it has none on its left. */
typedef struct {
    double left, right, top, bottom;
    gboolean begins;
} TinkerPlotSolid;

/* Adds points in a row to the path, which it begins with a move; what is crowded is added to `solids` instead, to be
 * filled once the path is stroked. `width`: of the columns that the curve was thinned to. */
void tinker_plot_trace(cairo_t *cairo, const double (*points)[2], gsize count, double width, GArray *solids);
void tinker_plot_fill_solids(cairo_t *cairo, const GArray *solids);

static inline void tinker_plot_set_colour(cairo_t *cairo, const double colour[4], double share)
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], share * colour[3]);
}

/* What stands about the curves; plot-frame.c. `no_data` stands in their place. */
void tinker_plot_draw_grid(cairo_t *cairo, const TinkerPlotLayout *layout);
void tinker_plot_draw_frame(cairo_t *cairo, const TinkerPlotLayout *layout);
void tinker_plot_draw_texts(cairo_t *cairo, const TinkerPlotLayout *layout);
void tinker_plot_draw_no_data(cairo_t *cairo, const TinkerPlotLayout *layout);

void tinker_plot_draw_band(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve,
                           double column_width);
void tinker_plot_draw_curve(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve,
                            double column_width);
/* Of data: its own among the theme's. */
const double *tinker_plot_curve_colour(const TinkerPlotLayout *layout, const TinkerCurve *curve);
/* Colour, line style and mark of a curve, for the curve itself and the legend's sample. */
void tinker_plot_set_curve_style(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve);
void tinker_plot_draw_marker(cairo_t *cairo, const TinkerCurve *curve, double x, double y);
gboolean tinker_plot_has_markers(const TinkerCurve *curve);
gboolean tinker_plot_has_line(const TinkerCurve *curve);

/* Finds a place for the legend; OUTSIDE and ABOVE where the rectangle of the curves must give way for it. */
void tinker_plot_place_legend(TinkerPlotLayout *layout);
void tinker_plot_draw_legend(cairo_t *cairo, const TinkerPlotLayout *layout);
/* The curve whose entry is at a place of the canvas; -1: none. */
int tinker_plot_legend_curve(const TinkerPlotLayout *layout, double x, double y);
/* Whether it leaves out something of what the curves are called. */
gboolean tinker_plot_shortens_legend(const TinkerPlotLayout *layout);

/* The cursor with its dots; plot-marks.c. */
void tinker_plot_draw_cursor(cairo_t *cairo, const TinkerPlotLayout *layout);

/* The bubble of the point that is read. FALSE where there is no such point on the plot. */
gboolean tinker_plot_place_reading(const TinkerPlotLayout *layout, double box[4]);
void tinker_plot_draw_reading(cairo_t *cairo, const TinkerPlotLayout *layout);

/* tinker_plot_draw, which also notes every text it writes in `written` (may be NULL). */
void tinker_plot_draw_noting(cairo_t *cairo, const TinkerPlot *plot, double width, double height, GPtrArray *written);

#endif
