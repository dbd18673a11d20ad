/* Curves are thinned before they are drawn: of the consecutive points that share a pixel column the first, the least,
 * the greatest and the last are kept, in their order. What is left paints the same pixels, and a spike of one sample
 * among millions stays. As only neighbours are merged, this holds for paths in the plane too. */
#include <math.h>
#include <string.h>

#include "render/plot/plot-private.h"

#define FADED         0.3 /* what is left of a colour */
#define MARKER_SIZE   3.4
#define RING_SIZE     7.5
#define RING_LINE     2.0
#define GUIDE_LINE    1.2
#define BAND_ALPHA    0.22
#define CURVE_COLOURS 8
#define BEYOND        6.0 /* canvas units beyond the frame, whose ink may reach into it */

/* The points of one column, by their numbers. They are compared as numbers of the data: only those that are kept are
 * placed on the canvas. */
typedef struct {
    const TinkerPlotLayout *layout;
    const TinkerCurve *curve;
    TinkerPathFunction path;
    gpointer data;
    double column_width;
    double from, to; /* x of the data at the column's borders */
    gboolean open, starts;
    gsize first, least, greatest, last;
} Thinner;

gboolean tinker_plot_place(const TinkerPlotLayout *layout, const TinkerCurve *curve, gsize i, double *x, double *y)
{
    *x = tinker_axis_place(&layout->x, curve->x[i]);
    *y = tinker_axis_place(tinker_plot_y_axis(layout, curve), curve->y[i]);
    return isfinite(*x) && isfinite(*y);
}

static void emit(Thinner *thinner, gsize i)
{
    double x, y;
    if (!tinker_plot_place(thinner->layout, thinner->curve, i, &x, &y)) return;
    thinner->path(x, y, thinner->starts, thinner->data);
    thinner->starts = FALSE;
}

static void close_column(Thinner *thinner)
{
    if (!thinner->open) return;
    thinner->open = FALSE;
    gsize early = MIN(thinner->least, thinner->greatest), late = MAX(thinner->least, thinner->greatest);
    emit(thinner, thinner->first);
    if (early > thinner->first && early < thinner->last) emit(thinner, early);
    if (late > early && late < thinner->last) emit(thinner, late);
    if (thinner->last > thinner->first) emit(thinner, thinner->last);
}

static void open_column(Thinner *thinner, gsize i)
{
    const TinkerAxis *axis = &thinner->layout->x;
    double column = floor(tinker_axis_place(axis, thinner->curve->x[i]) / thinner->column_width);
    thinner->from = tinker_axis_value(axis, column * thinner->column_width);
    thinner->to = tinker_axis_value(axis, (column + 1) * thinner->column_width);
    thinner->first = thinner->least = thinner->greatest = i;
    thinner->open = TRUE;
}

static void add_point(Thinner *thinner, gsize i)
{
    const double *y = thinner->curve->y, x = thinner->curve->x[i];
    if (!thinner->open || x < thinner->from || x >= thinner->to) {
        close_column(thinner);
        open_column(thinner, i);
    }
    if (y[i] < y[thinner->least]) thinner->least = i;
    if (y[i] > y[thinner->greatest]) thinner->greatest = i;
    thinner->last = i;
}

gboolean tinker_plot_can_index(const TinkerCurve *curve, gboolean x_logarithmic, gboolean y_logarithmic)
{
    gsize least, greatest;
    if (curve->index == NULL || curve->count == 0 || tinker_curve_index_count(curve->index) != curve->count ||
        !tinker_curve_index_is_ordered(curve->index))
        return FALSE;
    if (x_logarithmic && !(curve->x[0] > 0)) return FALSE;
    if (!y_logarithmic) return TRUE;
    tinker_curve_index_extremes(curve->index, curve->y, 0, curve->count, &least, &greatest);
    return curve->y[least] > 0;
}

/* Column by column, as add_point() would come upon them; from a little left of the frame and the point before
 * it to the first point beyond the right edge. */
static void walk_by_index(Thinner *thinner)
{
    const TinkerCurve *curve = thinner->curve;
    const TinkerPlotLayout *layout = thinner->layout;
    const double width = thinner->column_width;
    const double left = tinker_axis_value(&layout->x, floor((layout->left - BEYOND) / width) * width);
    const double right = tinker_axis_value(&layout->x, layout->right + BEYOND);
    gsize i = tinker_curve_first_from(curve->x, curve->count, left);
    for (i = i > 0 ? i - 1 : 0; i < curve->count;) {
        open_column(thinner, i);
        const gsize beyond = i + tinker_curve_first_from(curve->x + i, curve->count - i, thinner->to);
        const gsize end = MAX(beyond, i + 1);
        tinker_curve_index_extremes(curve->index, curve->y, i, end, &thinner->least, &thinner->greatest);
        thinner->last = end - 1;
        close_column(thinner);
        if (curve->x[i] > right) return;
        i = end;
    }
}

void tinker_plot_walk(const TinkerPlotLayout *layout, const TinkerCurve *curve, double column_width,
                      TinkerPathFunction path, gpointer data)
{
    Thinner thinner = {
        .layout = layout, .curve = curve, .path = path, .data = data, .column_width = column_width, .starts = TRUE};
    gboolean positive_x = layout->x.logarithmic, positive_y = tinker_plot_y_axis(layout, curve)->logarithmic;
    if (tinker_plot_can_index(curve, positive_x, positive_y)) {
        walk_by_index(&thinner);
        return;
    }
    for (gsize i = 0; i < curve->count; i++) {
        double x = curve->x[i], y = curve->y[i];
        if (isfinite(x) && isfinite(y) && !(positive_x && x <= 0) && !(positive_y && y <= 0)) {
            add_point(&thinner, i);
        } else {
            close_column(&thinner);
            thinner.starts = TRUE;
        }
    }
    close_column(&thinner);
}

/* Style
 * ---------------------------------------------------------------------------------------------------------------- */

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
    const double *ground = layout->theme->background, share = curve->faded ? FADED : 1;
    cairo_set_source_rgba(cairo, ground[0] + share * (c[0] - ground[0]), ground[1] + share * (c[1] - ground[1]),
                          ground[2] + share * (c[2] - ground[2]), c[3]);
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

/* Drawing
 * -------------------------------------------------------------------------------------------------------------- */

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
    const double *c = layout->theme->curves[colour_number(curve)];
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
