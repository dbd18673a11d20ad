/* A sample hits neither an extremum nor a zero: the curve is taken for smooth across a few of its points, but where it
 * has a kink. */
#include "gui/curve/graph-reading.h"

#include <glib/gi18n.h>
#include <math.h>
#include <string.h>

#include "gui/curve/graph-data.h"
#include "measure/curve-pieces.h"

#define BISECTIONS 60
#define SAME_TIME  1e-9 /* of the time: nearer to it is not the next */
#define CONSTANT   1e-9 /* of the largest value: what varies by less is constant */

static gboolean can_read(const TinkerGraphSeries *series)
{
    const TinkerCurveIndex *index = tinker_graph_series_index(series);
    return index != NULL && tinker_curve_index_is_ordered(index);
}

/* The parabola through three points, by Lagrange. */
static double interpolated(const double x[3], const double y[3], double at)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double product = y[i];
        for (int k = 0; k < 3; k++)
            if (k != i) product *= (at - x[k]) / (x[i] - x[k]);
        sum += product;
    }
    return sum;
}

/* Of the parabola through three points. Slopes of the two chords; its slope is 0 where the line through them at their
 * middles is. */
static void find_vertex(const double x[3], const double y[3], double place[2])
{
    const double before = (y[1] - y[0]) / (x[1] - x[0]), after = (y[2] - y[1]) / (x[2] - x[1]);
    place[0] = CLAMP(0.5 * (x[0] + x[1]) + before / (before - after) * 0.5 * (x[2] - x[0]), x[0], x[2]);
    place[1] = interpolated(x, y, place[0]);
}

/* The farthest that the curve goes to one side (1: up, -1: down) between the neighbours of a point. */
static void find_turn(const TinkerCurveSamples *samples, gsize point, double side, double place[2])
{
    place[0] = samples->times[point];
    place[1] = samples->values[point];
    for (gsize i = point - 1; i <= point; i++) {
        if (!(samples->times[i] < samples->times[i + 1])) continue; /* a jump */
        TinkerCurvePiece pieces[2];
        const guint count = tinker_curve_pieces(samples, i, pieces);
        for (guint k = 0; k < count; k++) {
            double level[3] = {0};
            tinker_curve_piece_level(&pieces[k], level + 1);
            for (int n = 0; n < 3; n++) {
                if (!(level[n] >= 0 && level[n] <= 1)) continue;
                const double value = tinker_curve_piece_value(&pieces[k], level[n]);
                if (!(side * value > side * place[1])) continue;
                place[0] = pieces[k].start + level[n] * pieces[k].width;
                place[1] = value;
            }
        }
    }
}

/* Which side of a jump a point is on: -1 before it, 1 behind it; 0 of all others. */
static int side_of_jump(const double *x, gsize count, gsize point)
{
    if (point + 1 < count && x[point] == x[point + 1]) return -1;
    return point > 0 && x[point] == x[point - 1] ? 1 : 0;
}

/* What is before a jump is read at a time just before it: at its own the curve has what is behind it. */
static gboolean extremum_about(const double *x, const double *y, gsize count, gsize point, TinkerGraphReading *reading)
{
    if (point == 0 || point + 1 >= count) return FALSE;
    const double *at = x + point - 1, *values = y + point - 1;
    const gboolean highest = values[1] > values[0] && values[1] >= values[2],
                   lowest = values[1] < values[0] && values[1] <= values[2];
    if (!(highest || lowest)) return FALSE;
    const TinkerCurveSamples samples = {x, y, count};
    if (count >= TINKER_CURVE_LEAST)
        find_turn(&samples, point, highest ? 1 : -1, reading->at);
    else if (at[0] < at[1] && at[1] < at[2])
        find_vertex(at, values, reading->at);
    else
        memcpy(reading->at, (const double[]){at[1], values[1]}, sizeof reading->at);
    if (side_of_jump(x, count, point) < 0 && reading->at[0] == x[point])
        reading->at[0] = nextafter(x[point], -INFINITY);
    reading->kind = highest ? TINKER_READING_MAXIMUM : TINKER_READING_MINIMUM;
    return TRUE;
}

/* Between `nothing` on either side a value is 0. */
static int sign_of(double value, double nothing)
{
    return value > nothing ? 1 : value < -nothing ? -1 : 0;
}

/* The first place in a piece where the curve changes its sign from *sign, the last one before it that was not 0: where
 * it touches 0 it has an extremum. `start` and `end` are its values at both ends. */
static gboolean zero_of_piece(const TinkerCurvePiece *piece, double start, double end, double nothing, int *sign,
                              double *time)
{
    double edges[4] = {0, 0, 0, 1}, values[4] = {start, start, start, end};
    tinker_curve_piece_level(piece, edges + 1);
    for (int i = 1; i < 3; i++) {
        if (edges[i] > edges[i - 1] && edges[i] < 1) {
            values[i] = tinker_curve_piece_value(piece, edges[i]);
        } else { /* NAN, too */
            edges[i] = edges[i - 1];
            values[i] = values[i - 1];
        }
    }
    for (int i = 0; i < 3; i++) {
        const int before = *sign, behind = sign_of(values[i + 1], nothing);
        const gboolean below = before < 0;
        double low = edges[i], high = edges[i + 1];
        if (behind != 0) *sign = behind;
        if (before == 0 || behind != -before) continue;
        for (int k = 0; k < BISECTIONS; k++) {
            const double half = 0.5 * (low + high);
            if ((tinker_curve_piece_value(piece, half) < 0) == below)
                low = half;
            else
                high = half;
        }
        *time = piece->start + 0.5 * (low + high) * piece->width;
        return TRUE;
    }
    return FALSE;
}

/* Of few points on the straight line between two. */
static gboolean zero_behind(const double *x, const double *y, gsize count, gsize point, TinkerGraphReading *reading)
{
    if (point + 1 >= count || !(x[point] < x[point + 1])) return FALSE;
    const double nothing = CONSTANT * fmax(fabs(y[point]), fabs(y[point + 1]));
    if (!(nothing > 0)) return FALSE; /* it stays at 0, perhaps for all of a long curve */
    TinkerCurvePiece pieces[2] = {{x[point], x[point + 1] - x[point], y[point], y[point + 1] - y[point], 0, 0}};
    const TinkerCurveSamples samples = {x, y, count};
    const guint parts = count >= TINKER_CURVE_LEAST ? tinker_curve_pieces(&samples, point, pieces) : 1;
    double start = y[point];
    int sign = 0;
    for (gsize before = point + 1; before > 0 && sign == 0; before--)
        sign = sign_of(y[before - 1], nothing);
    for (guint i = 0; i < parts; i++) {
        const double end = i + 1 < parts ? pieces[i + 1].a : y[point + 1];
        if (zero_of_piece(&pieces[i], start, end, nothing, &sign, &reading->at[0])) {
            reading->at[1] = 0;
            reading->kind = TINKER_READING_ZERO;
            return TRUE;
        }
        start = end;
    }
    return FALSE;
}

/* The extremum about a point, and the zero between it and the next one, as many as there are: of the curve that
 * statistics are of, or of few points by the parabola through three and the line through two. Not of a curve whose x
 * turns back. */
static guint readings_about(const TinkerGraphSeries *series, gsize point, const TinkerGraphReading *as,
                            TinkerGraphReading found[2])
{
    const double *x = tinker_graph_series_x(series), *y = tinker_graph_series_y(series);
    const gsize count = tinker_graph_series_count(series);
    found[0] = *as;
    found[0].point = point;
    guint readings = extremum_about(x, y, count, point, &found[0]);
    found[readings] = *as;
    found[readings].point = point;
    return readings + zero_behind(x, y, count, point, &found[readings]);
}

gboolean tinker_graph_reading_snap(const TinkerGraphSeries *series, const TinkerPlotGeometry *geometry, double x,
                                   double y, double reach, TinkerGraphReading *reading)
{
    const TinkerPlotScale *up = tinker_graph_series_is_right(series) ? &geometry->second : &geometry->y;
    const gsize count = tinker_graph_series_count(series);
    double nearest = reach;
    if (!can_read(series)) return FALSE;
    const double *points = tinker_graph_series_x(series);
    gsize first = tinker_curve_first_from(points, count, tinker_plot_scale_value(&geometry->x, x - reach));
    const gsize end = tinker_curve_first_from(points, count, tinker_plot_scale_value(&geometry->x, x + reach));
    for (first = first > 0 ? first - 1 : 0; first < end; first++) {
        TinkerGraphReading found[2];
        const guint readings = readings_about(series, first, reading, found);
        for (guint i = 0; i < readings; i++) {
            const double away = hypot(tinker_plot_scale_place(&geometry->x, found[i].at[0]) - x,
                                      tinker_plot_scale_place(up, found[i].at[1]) - y);
            if (!(away <= nearest)) continue;
            nearest = away;
            *reading = found[i];
        }
    }
    return nearest < reach;
}

gboolean tinker_graph_reading_extremum_at(const TinkerGraphSeries *series, double time, TinkerGraphReading *reading)
{
    const double *x = tinker_graph_series_x(series), *y = tinker_graph_series_y(series);
    const gsize count = tinker_graph_series_count(series);
    if (!can_read(series) || count == 0) return FALSE;
    const gsize next = tinker_curve_first_from(x, count, time);
    double nearest = SAME_TIME * fmax(1, fabs(time));
    gboolean any = FALSE;
    for (gsize point = next > 1 ? next - 2 : 0; point < count && point <= next + 1; point++) {
        TinkerGraphReading tried = {.point = point};
        if (!extremum_about(x, y, count, point, &tried) || !(fabs(tried.at[0] - time) <= nearest)) continue;
        nearest = fabs(tried.at[0] - time);
        *reading = tried;
        any = TRUE;
    }
    return any;
}

gboolean tinker_graph_reading_next(const TinkerGraphSeries *series, double time, gboolean forward,
                                   TinkerGraphReading *reading)
{
    const gsize count = tinker_graph_series_count(series);
    const double near = SAME_TIME * fmax(1, fabs(time)), way = forward ? 1 : -1;
    const TinkerGraphReading as = *reading;
    double nearest = INFINITY;
    if (!can_read(series) || count == 0) return FALSE;
    const double *x = tinker_graph_series_x(series);
    gsize i = tinker_curve_first_from(x, count, time);
    i = forward ? (i > 1 ? i - 2 : 0) : MIN(i + 1, count - 1);
    for (; i < count; i = forward ? i + 1 : i - 1) {
        const gboolean is_known = isfinite(nearest);
        TinkerGraphReading found[2];
        const guint readings = readings_about(series, i, &as, found);
        for (guint k = 0; k < readings; k++) {
            const double away = way * (found[k].at[0] - time);
            const gboolean at_jump = side_of_jump(x, count, found[k].point) != 0;
            if (!(away > (at_jump ? 0 : near)) || !(away < nearest)) continue;
            nearest = away;
            *reading = found[k];
        }
        if (is_known || (!forward && i == 0)) break; /* that about the point behind it may come before it */
    }
    return isfinite(nearest);
}

gboolean tinker_graph_reading_at(const TinkerGraphSeries *series, double x, TinkerGraphReading *reading)
{
    const double *xs = tinker_graph_series_x(series), *ys = tinker_graph_series_y(series);
    const gsize count = tinker_graph_series_count(series);
    if (!can_read(series) || count == 0 || x < xs[0] || x > xs[count - 1]) return FALSE;
    gsize next = tinker_curve_first_from(xs, count, x);
    while (next < count && xs[next] == x) /* at the instant of a jump the state after it counts */
        next++;
    const gsize before = MAX(next, 1) - 1;
    const double span = next < count ? xs[next] - xs[before] : 0, share = span > 0 ? (x - xs[before]) / span : 0;
    reading->point = before;
    reading->kind = TINKER_READING_POINT;
    reading->at[0] = x;
    reading->at[1] = ys[before] + (share > 0 ? share * (ys[next] - ys[before]) : 0);
    return TRUE;
}

/* By more than rounding makes of what is constant. */
static gboolean varies(const TinkerGraphSeries *series)
{
    const double *y = tinker_graph_series_y(series);
    const TinkerCurveIndex *index = tinker_graph_series_index(series);
    const gsize count = tinker_curve_index_count(index);
    gsize least, greatest;
    if (count == 0) return FALSE;
    tinker_curve_index_extremes(index, y, 0, count, &least, &greatest);
    return y[greatest] - y[least] > CONSTANT * fmax(fabs(y[least]), fabs(y[greatest]));
}

GArray *tinker_graph_reading_extrema(const TinkerGraphSeries *series, guint most)
{
    GArray *found = g_array_new(FALSE, FALSE, sizeof(TinkerGraphReading));
    const double *x = tinker_graph_series_x(series), *y = tinker_graph_series_y(series);
    const gsize count = can_read(series) && varies(series) ? tinker_graph_series_count(series) : 0;
    for (gsize i = 1; i + 1 < count && found->len < most; i++) {
        TinkerGraphReading reading = {.point = i};
        if (extremum_about(x, y, count, i, &reading)) g_array_append_val(found, reading);
    }
    return found;
}

char *tinker_graph_reading_text(const TinkerGraphSeries *series, const TinkerGraphReading *reading)
{
    static const char *const kinds[] = {NULL, N_("maximum"), N_("minimum"), N_("zero")};
    char *value = tinker_graph_value_text(tinker_graph_series_symbol(series), reading->at[1],
                                          tinker_graph_series_y_axis(series)->unit);
    if (reading->kind == TINKER_READING_POINT) return value;
    g_autofree char *plain = value;
    return g_strdup_printf("%s (%s)", plain, _(kinds[reading->kind]));
}
