/* Plots: line graphs with round ticks, units, a legend and an optional band. */
#ifndef TINKER_CORE_PLOT_H
#define TINKER_CORE_PLOT_H

#include <cairo.h>
#include <glib.h>

#include "render/draw/paint-memory.h"
#include "render/draw/theme.h"
#include "render/plot/curve-index.h"

/* What a curve is for. */
typedef enum {
    TINKER_CURVE_DATA,  /* in a colour of the theme's, by its number */
    TINKER_CURVE_RING,  /* rings about points of other curves, to point them out; no line */
    TINKER_CURVE_GUIDE, /* a dashed line in the axes' colour: a limit, a mean */
} TinkerCurveRole;

typedef struct {
    const char *label;        /* in the legend; NULL: none */
    const double *x, *y;      /* `count` points; a NaN interrupts the curve */
    const double *low, *high; /* a band about the curve, or NULL */
    gboolean filled;          /* the band is an area of the curve's own colour, one of a stack; else a pale one */
    gsize count;
    const TinkerCurveIndex *index; /* of all these points, where there are many: it is quicker to draw; NULL */
    int colour;                    /* number of the theme's curve colour */
    gboolean markers;              /* a mark at every point */
    gboolean no_line;
    gboolean right;  /* its values belong to the axis at the right */
    gboolean behind; /* those that are not are drawn over it, wherever it stands among them */
    gboolean faded;  /* others are what is looked at */
    TinkerCurveRole role;
} TinkerCurve;

/* A point of a curve that is pointed out, with its values in a bubble beside it. */
typedef struct {
    int curve;
    gsize point;
    const char *x, *y; /* the bubble's lines, "t = 1.25 s"; NULL: left out */
    const double *at;  /* x and y of the place itself, where it lies between points; NULL: the point */
} TinkerPlotReading;

typedef struct {
    const char *title;   /* may be NULL */
    const char *x_label; /* "Time [s]" */
    const char *y_label;
    const char *right_label; /* of the axis at the right, which there is where a curve belongs to it; may be NULL */
    gboolean x_logarithmic, y_logarithmic, right_logarithmic;
    gboolean equal_scales;                         /* of a path in the plane */
    const double *x_range, *y_range, *right_range; /* from, to: what an axis shows; NULL: all data */
    const TinkerCurve *curves;
    int curve_count;
    const TinkerTheme *theme;
    gboolean compact;   /* for a small graph among others: smaller texts and margins, fewer ticks, a bare legend */
    double enlargement; /* of texts and the room about them, for those who sit far off; 0 or 1: none */
    /* Of a graph in a window */
    const double *cursor;             /* x of an upright line with a dot on every curve there: "now"; NULL: none */
    const TinkerPlotReading *reading; /* NULL: none */
    gboolean quick;                   /* curves in coarser columns: for what is drawn anew at once */
    TinkerPaintMemory *memory;        /* that all pictures of the graph share, so that each takes less time; or NULL */
} TinkerPlot;

/* Draws the plot into the rectangle (0, 0, width, height) of the context. Long records are thinned to what pixels can
 * show: least and greatest value of each pixel column are kept. */
void tinker_plot_draw(cairo_t *cairo, const TinkerPlot *plot, double width, double height);

/* A point of a curve, and where it is drawn. */
typedef struct {
    int curve;
    gsize point;
    double canvas_x, canvas_y;
} TinkerPlotPoint;

/* The point of any curve nearest to a place of the canvas, for reading values off a plot of this size. FALSE where
 * there is none within `reach` (canvas units). */
gboolean tinker_plot_pick(const TinkerPlot *plot, double width, double height, double canvas_x, double canvas_y,
                          double reach, TinkerPlotPoint *found);

/* The curve whose sample or label in the legend is at a place of the canvas; -1: none. */
int tinker_plot_pick_legend(const TinkerPlot *plot, double width, double height, double canvas_x, double canvas_y);

/* Where the axes of a plot of this size lie. */
typedef struct {
    gboolean logarithmic;
    double low, high;     /* what it shows, as common logarithms where it is logarithmic */
    double start, length; /* canvas units: where `low` is, and the way from there to `high` */
} TinkerPlotScale;
typedef struct {
    double left, top, right, bottom; /* canvas units: the rectangle of the curves */
    TinkerPlotScale x, y, second;
    gboolean has_second;      /* an axis at the right */
    double legend[4];         /* left, top, right, bottom; empty where there is none */
    gboolean shortens_legend; /* labels are cut there, or left out */
} TinkerPlotGeometry;
void tinker_plot_measure(const TinkerPlot *plot, double width, double height, TinkerPlotGeometry *geometry);

/* The place of a value on the canvas, NAN where it has none; and back. */
double tinker_plot_scale_place(const TinkerPlotScale *scale, double value);
double tinker_plot_scale_value(const TinkerPlotScale *scale, double place);

/* Draws to .png, .svg or .pdf by the ending. */
gboolean tinker_plot_to_file(const TinkerPlot *plot, int width, int height, const char *path, GError **error);

/* Round tick positions for a range: at most `most` of them, each a multiple of 1, 2 or 5 times a power of ten; decimals
 * behind the point that their labels need. Answers how many. */
int tinker_plot_ticks(double low, double high, int most, double *ticks, int *decimals);

#endif
