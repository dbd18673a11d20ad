/* Curves are thinned before they are drawn: of the consecutive points that share a pixel column the first, the least, the
 * greatest and the last are kept, in their order. What is left paints the same pixels, and a spike of one sample among
 * millions stays. As only neighbours are merged, this holds for paths in the plane too. */
#include <math.h>

#include "render/plot-private.h"

#define MARKER_SIZE   3.4
#define RING_SIZE     7.5
#define RING_LINE     2.0
#define GUIDE_LINE    1.2
#define BAND_ALPHA    0.22
#define CURVE_COLOURS 8

/* The points of one column. */
typedef struct {
    TinkerPathFunction path;
    gpointer data;
    double column_width, from, to; /* the open column's borders */
    gboolean open, starts;
    double first[2], low[2], high[2], last[2];
    gsize low_at, high_at, count;
} Thinner;

static void emit(Thinner *thinner, const double point[2])
{
    thinner->path(point[0], point[1], thinner->starts, thinner->data);
    thinner->starts = FALSE;
}

static void close_column(Thinner *thinner)
{
    if (!thinner->open) return;
    thinner->open = FALSE;
    emit(thinner, thinner->first);
    gboolean low_first = thinner->low_at < thinner->high_at;
    const double *early = low_first ? thinner->low : thinner->high, *late = low_first ? thinner->high : thinner->low;
    gsize early_at = MIN(thinner->low_at, thinner->high_at), late_at = MAX(thinner->low_at, thinner->high_at);
    if (early_at > 0 && early_at + 1 < thinner->count) emit(thinner, early);
    if (late_at > early_at && late_at + 1 < thinner->count) emit(thinner, late);
    if (thinner->count > 1) emit(thinner, thinner->last);
}

static void set_point(double to[2], double x, double y)
{
    to[0] = x;
    to[1] = y;
}

static void add_point(Thinner *thinner, double x, double y)
{
    if (!thinner->open || x < thinner->from || x >= thinner->to) {
        close_column(thinner);
        thinner->open = TRUE;
        thinner->from = floor(x / thinner->column_width) * thinner->column_width;
        thinner->to = thinner->from + thinner->column_width;
        thinner->count = thinner->low_at = thinner->high_at = 0;
        set_point(thinner->first, x, y);
        set_point(thinner->low, x, y);
        set_point(thinner->high, x, y);
    }
    if (y < thinner->low[1]) {
        set_point(thinner->low, x, y);
        thinner->low_at = thinner->count;
    }
    if (y > thinner->high[1]) {
        set_point(thinner->high, x, y);
        thinner->high_at = thinner->count;
    }
    set_point(thinner->last, x, y);
    thinner->count++;
}

gboolean tinker_plot_place(const TinkerPlotLayout *layout, const TinkerCurve *curve, gsize i, double *x, double *y)
{
    *x = tinker_axis_place(&layout->x, curve->x[i]);
    *y = tinker_axis_place(&layout->y, curve->y[i]);
    return isfinite(*x) && isfinite(*y);
}

void tinker_plot_walk(const TinkerPlotLayout *layout, const TinkerCurve *curve, double column_width,
                      TinkerPathFunction path, gpointer data)
{
    Thinner thinner = {.path = path, .data = data, .column_width = column_width, .starts = TRUE};
    for (gsize i = 0; i < curve->count; i++) {
        double x, y;
        if (tinker_plot_place(layout, curve, i, &x, &y)) {
            add_point(&thinner, x, y);
        } else {
            close_column(&thinner);
            thinner.starts = TRUE;
        }
    }
    close_column(&thinner);
}

/* Style ---------------------------------------------------------------------------------------------------------------- */

static int colour_number(const TinkerCurve *curve)
{
    return ABS(curve->colour % CURVE_COLOURS);
}

gboolean tinker_plot_has_markers(const TinkerCurve *curve)
{
    return curve->markers || curve->no_line || curve->count == 1 || curve->role == TINKER_CURVE_RING;
}

gboolean tinker_plot_has_line(const TinkerCurve *curve)
{
    return !curve->no_line && curve->role != TINKER_CURVE_RING;
}

void tinker_plot_set_curve_style(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve)
{
    static const double dashes[3][4] = {{7, 3, 7, 3}, {2, 3, 2, 3}, {8, 3, 2, 3}};
    static const double guide_dashes[2] = {5, 4};
    const double *c = curve->role == TINKER_CURVE_DATA    ? layout->theme->curves[colour_number(curve)]
                      : curve->role == TINKER_CURVE_GUIDE ? layout->theme->axis
                                                          : layout->theme->colours[TINKER_COLOUR_TEXT];
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], c[3]);
    cairo_set_line_width(cairo, TINKER_PLOT_LINE);
    if (curve->role == TINKER_CURVE_GUIDE) {
        cairo_set_line_width(cairo, GUIDE_LINE);
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
        cairo_set_dash(cairo, guide_dashes, 2, 0);
        return;
    }
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    /* More curves than colours: the next ones of a colour are dashed. */
    int turn = ABS(curve->colour) / CURVE_COLOURS;
    if (turn > 0) {
        cairo_set_dash(cairo, dashes[(turn - 1) % 3], 4, 0);
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    } else {
        cairo_set_dash(cairo, NULL, 0, 0);
    }
}

void tinker_plot_draw_marker(cairo_t *cairo, const TinkerCurve *curve, double x, double y)
{
    double r = MARKER_SIZE;
    cairo_new_path(cairo);
    if (curve->role == TINKER_CURVE_RING) {
        cairo_set_line_width(cairo, RING_LINE);
        cairo_arc(cairo, x, y, RING_SIZE, 0, 2 * G_PI);
        cairo_stroke(cairo);
        return;
    }
    int turn = ABS(curve->colour) / CURVE_COLOURS;
    switch ((colour_number(curve) + turn) % 4) {
    case 0:
        cairo_arc(cairo, x, y, r, 0, 2 * G_PI);
        break;
    case 1:
        cairo_rectangle(cairo, x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
        break;
    case 2:
        cairo_move_to(cairo, x, y - 1.2 * r);
        cairo_line_to(cairo, x + 1.1 * r, y + 0.8 * r);
        cairo_line_to(cairo, x - 1.1 * r, y + 0.8 * r);
        cairo_close_path(cairo);
        break;
    default:
        cairo_move_to(cairo, x, y - 1.3 * r);
        cairo_line_to(cairo, x + 1.3 * r, y);
        cairo_line_to(cairo, x, y + 1.3 * r);
        cairo_line_to(cairo, x - 1.3 * r, y);
        cairo_close_path(cairo);
    }
    cairo_fill(cairo);
}

/* Drawing -------------------------------------------------------------------------------------------------------------- */

/* A curve on its way to the path. */
typedef struct {
    cairo_t *cairo;
    double x, y;      /* the point before */
    gsize run;        /* points since the pen came down */
    GArray *isolated; /* of x and y in turns: points between two gaps; made at the first */
} Pen;

/* The pen goes up: a lone point is noted. */
static void lift(Pen *pen)
{
    if (pen->run == 1) {
        if (!pen->isolated) pen->isolated = g_array_new(FALSE, FALSE, sizeof(double));
        g_array_append_vals(pen->isolated, (double[]){pen->x, pen->y}, 2);
    }
    pen->run = 0;
}

static void draw_to(double x, double y, gboolean starts, gpointer data)
{
    Pen *pen = data;
    if (starts) {
        lift(pen);
        cairo_move_to(pen->cairo, x, y);
    } else {
        cairo_line_to(pen->cairo, x, y);
    }
    pen->x = x;
    pen->y = y;
    pen->run++;
}

/* A sample between two gaps has no line: it is a dot, a little wider than the line so that it is seen. */
static void draw_line(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve, double column_width)
{
    Pen pen = {.cairo = cairo};
    cairo_new_path(cairo);
    tinker_plot_walk(layout, curve, column_width, draw_to, &pen);
    lift(&pen);
    cairo_stroke(cairo);
    if (!pen.isolated) return;
    for (guint i = 0; i < pen.isolated->len; i += 2) {
        const double *point = &g_array_index(pen.isolated, double, i);
        cairo_arc(cairo, point[0], point[1], TINKER_PLOT_LINE, 0, 2 * G_PI);
        cairo_fill(cairo);
    }
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

void tinker_plot_draw_band(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve,
                           double column_width)
{
    if (!curve->low || !curve->high) return;
    GArray *run = g_array_new(FALSE, FALSE, 3 * sizeof(double));
    const double *c = layout->theme->curves[colour_number(curve)];
    double column = NAN;
    cairo_new_path(cairo);
    for (gsize i = 0; i < curve->count; i++) {
        double x = tinker_axis_place(&layout->x, curve->x[i]);
        double upper = tinker_axis_place(&layout->y, curve->high[i]);
        double lower = tinker_axis_place(&layout->y, curve->low[i]);
        if (layout->y.logarithmic && curve->low[i] <= 0) lower = layout->bottom;
        if (!isfinite(x) || !isfinite(upper) || !isfinite(lower)) {
            fill_run(cairo, run);
            continue;
        }
        if (run->len && floor(x / column_width) == column) {
            double *last = (double *)(void *)run->data + 3 * (run->len - 1);
            last[1] = fmin(last[1], upper);
            last[2] = fmax(last[2], lower);
            continue;
        }
        column = floor(x / column_width);
        const double point[3] = {x, upper, lower};
        g_array_append_vals(run, point, 1);
    }
    fill_run(cairo, run);
    g_array_unref(run);
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], BAND_ALPHA * c[3]);
    cairo_fill(cairo);
}
