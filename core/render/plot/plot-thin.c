/* Curves are thinned before they are drawn: of the consecutive points that share a pixel column the first, the least,
 * the greatest and the last are kept, in their order. What is left paints the same pixels, and a spike of one sample
 * among millions stays. As only neighbours are merged, this holds for paths in the plane too. */
#include <math.h>

#include "render/plot/plot-private.h"

#define BEYOND 6.0 /* canvas units beyond the frame, whose ink may reach into it */

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
