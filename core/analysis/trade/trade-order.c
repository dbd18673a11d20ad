/* The observed order: the slope of log(error) over log(mean step), by least squares over the asymptotic range. That is
 * the longest range, clear of what the reference is confirmed to, over which the slope from one row to the next holds
 * still. Adaptive methods are judged by their mean step as well. */
#include <math.h>

#include "analysis/trade/trade-private.h"

#define MOST_ERROR     0.1  /* larger ones are of no order */
#define CLEAR_OF_LIMIT 10   /* times the limit, which then is a tenth of the error at most */
#define STILL_FIXED    0.1  /* how far the slope may wander */
#define STILL_ADAPTIVE 0.15 /* likewise, as a share of the order: tolerances are not steps */
#define LEAST_POINTS   3
#define LEAST_OCTAVES  0.9 /* of mean steps: a slope over less says nothing */
#define FINER_COUNTS   4.0 /* times as much as the next coarser point */

typedef struct {
    double x, y; /* logarithms of mean step and error */
} Point;

/* Rows that tell of the method's order alone, the coarsest first. */
static GArray *usable_points(const TinkerTradeMethod *method, double level)
{
    GArray *points = g_array_new(FALSE, FALSE, sizeof(Point));
    double least = INFINITY;
    for (guint i = 0; i < method->rows->len; i++)
        least = fmin(least, g_array_index(method->rows, TinkerTradeRow, i).error);
    /* Where the sweep ended because the error stopped falling, its least value is the method's own limit. */
    double limit = method->out_of_time ? level : fmax(level, least);
    for (guint i = 0; i < method->rows->len; i++) {
        const TinkerTradeRow *row = &g_array_index(method->rows, TinkerTradeRow, i);
        Point point = {log(row->mean_step), log(row->error)};
        if (!(row->error < MOST_ERROR && row->error > CLEAR_OF_LIMIT * limit)) continue;
        if (points->len > 0 && point.x > g_array_index(points, Point, points->len - 1).x - 0.05) continue;
        g_array_append_val(points, point);
    }
    return points;
}

/* How far the mean steps of the points reach. */
static double octaves_of(const GArray *points)
{
    if (points->len < 2) return 0;
    return (g_array_index(points, Point, 0).x - g_array_index(points, Point, points->len - 1).x) / log(2);
}

static double slope_between(const GArray *points, guint i)
{
    const Point *a = &g_array_index(points, Point, i), *b = &g_array_index(points, Point, i + 1);
    return (a->y - b->y) / (a->x - b->x);
}

/* By least squares; what higher orders add to the slope halves from row to row, so each point counts four times as much
 * as the one before. */
static double fitted_slope(const GArray *points, guint first, guint count)
{
    double sum = 0, x = 0, y = 0, xx = 0, xy = 0, weight = 1;
    for (guint i = first; i < first + count; i++, weight *= FINER_COUNTS) {
        const Point *point = &g_array_index(points, Point, i);
        sum += weight;
        x += weight * point->x;
        y += weight * point->y;
    }
    weight = 1;
    for (guint i = first; i < first + count; i++, weight *= FINER_COUNTS) {
        const Point *point = &g_array_index(points, Point, i);
        double dx = point->x - x / sum;
        xx += weight * dx * dx;
        xy += weight * dx * (point->y - y / sum);
    }
    return xy / xx;
}

/* How many points from `first` on have slopes between neighbours that all lie within a band of this width. */
static guint still_from(const GArray *points, guint first, double width)
{
    double least = INFINITY, greatest = -INFINITY;
    guint count = 1;
    for (guint i = first; i + 1 < points->len; i++, count++) {
        double slope = slope_between(points, i);
        least = fmin(least, slope);
        greatest = fmax(greatest, slope);
        if (greatest - least > width) break;
    }
    return count;
}

void tinker_trade_observe_order(TinkerTradeMethod *method, double level)
{
    g_autoptr(GArray) points = usable_points(method, level);
    gboolean adaptive = (method->integrator->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    double width = adaptive ? STILL_ADAPTIVE * method->integrator->order : STILL_FIXED;
    guint first = 0, longest = 0;
    for (guint i = 0; i < points->len; i++) {
        guint count = still_from(points, i, width);
        if (count < longest) continue; /* of two as long as each other the finer one */
        longest = count;
        first = i;
    }
    method->asymptotic = longest >= LEAST_POINTS;
    method->order = NAN;
    if (method->asymptotic)
        method->order = fitted_slope(points, first, longest);
    else if (octaves_of(points) >= LEAST_OCTAVES)
        method->order = fitted_slope(points, 0, points->len);
}
