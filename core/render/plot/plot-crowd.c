/* A curve that swings to and fro hundreds of times within a pixel inks all that is between its extremes there:
 *
 *      |\/\/\/|           +------+      top: the least y of each column of pixels
 *      |/\/\/\|    as     |######|
 *      |\/\/\/|           +------+      bottom: the greatest
 *
 * Stroked, each of its lines crosses all the others, and cairo works every crossing out: of a thousand columns that
 * takes a tenth of a second. Filled, it is one polygon, without a seam between columns. */
#include <math.h>

#include "render/plot/plot-private.h"

#define TALL     10.0 /* canvas units: what is less high is stroked */
#define IN_A_ROW 8    /* columns: where fewer are crowded they are stroked */
#define COMMON   0.5  /* of the lower one's height: what two neighbours have in common; of a steep line it is nothing */

typedef struct {
    double number, top, bottom; /* number: of the column, from the canvas's left */
    gsize first, last;          /* points */
} Column;

static gsize column_from(const double (*points)[2], gsize count, gsize first, double width, Column *column)
{
    gsize i = first;
    *column = (Column){floor(points[first][0] / width), INFINITY, -INFINITY, first, first};
    for (; i < count && floor(points[i][0] / width) == column->number; i++) {
        column->top = fmin(column->top, points[i][1]);
        column->bottom = fmax(column->bottom, points[i][1]);
        column->last = i;
    }
    return i;
}

static gboolean goes_on(const Column *one, const Column *next)
{
    const double heights[2] = {one->bottom - one->top, next->bottom - next->top};
    const double common = fmin(one->bottom, next->bottom) - fmax(one->top, next->top);
    return next->number == one->number + 1 && fmin(heights[0], heights[1]) >= TALL &&
           common >= COMMON * fmin(heights[0], heights[1]);
}

static void add_polygon(GArray *polygons, const Column *columns, gsize count, double width)
{
    for (gsize i = 0; i < count; i++) {
        const TinkerPlotSolid solid = {columns[i].number * width, (columns[i].number + 1) * width,
                                       columns[i].top - 0.5 * TINKER_PLOT_LINE,
                                       columns[i].bottom + 0.5 * TINKER_PLOT_LINE, i == 0};
        g_array_append_val(polygons, solid);
    }
}

void tinker_plot_trace(cairo_t *cairo, const double (*points)[2], gsize count, double width, GArray *solids)
{
    g_autoptr(GArray) columns = g_array_new(FALSE, FALSE, sizeof(Column));
    for (gsize i = 0; i < count;) {
        Column column;
        i = column_from(points, count, i, width, &column);
        g_array_append_val(columns, column);
    }
    const Column *all = (const Column *)(gconstpointer)columns->data;
    gboolean down = FALSE; /* the pen */
    for (gsize k = 0; k < columns->len;) {
        gsize end = k + 1;
        while (end < columns->len && goes_on(&all[end - 1], &all[end]))
            end++;
        const gboolean crowded = end - k >= IN_A_ROW;
        if (!crowded) end = k + 1;
        const gsize last = crowded ? all[k].first : all[k].last;
        for (gsize i = all[k].first; i <= last; i++) {
            (down ? cairo_line_to : cairo_move_to)(cairo, points[i][0], points[i][1]);
            down = TRUE;
        }
        if (crowded) {
            add_polygon(solids, all + k, end - k, width);
            cairo_move_to(cairo, points[all[end - 1].last][0], points[all[end - 1].last][1]);
        }
        k = end;
    }
}

void tinker_plot_fill_solids(cairo_t *cairo, const GArray *solids)
{
    const TinkerPlotSolid *all = (const TinkerPlotSolid *)(gconstpointer)solids->data;
    for (guint first = 0, end; first < solids->len; first = end) {
        cairo_new_path(cairo);
        for (end = first; end < solids->len && (end == first || !all[end].begins); end++) {
            cairo_line_to(cairo, all[end].left, all[end].top);
            cairo_line_to(cairo, all[end].right, all[end].top);
        }
        for (guint i = end; i-- > first;) {
            cairo_line_to(cairo, all[i].right, all[i].bottom);
            cairo_line_to(cairo, all[i].left, all[i].bottom);
        }
        cairo_fill(cairo);
    }
}
