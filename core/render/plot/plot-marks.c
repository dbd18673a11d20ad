/* Marks over the curves of a graph in a window: an upright line where time is, with a dot on every curve, and the point
 * that is read, with a bubble beside it that says its values and never leaves the picture of the curves. */
#include <math.h>

#include "render/plot/plot-private.h"

#define DOT_RADIUS    3.2 /* canvas units */
#define DOT_RIM       1.4
#define CURSOR_SHARE  0.75 /* of the axes' colour */
#define MOST_DOTS     32   /* on one curve: a path in the plane may come by often */
#define BUBBLE_INNER  5.0
#define BUBBLE_GAP    8.0 /* from the point */
#define BUBBLE_CORNER 4.0

/* A dot in the curve's colour, with a rim that parts it from its curve. */
static void draw_dot(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve, double x, double y)
{
    cairo_new_path(cairo);
    cairo_arc(cairo, x, y, DOT_RADIUS + DOT_RIM, 0, 2 * G_PI);
    tinker_plot_set_colour(cairo, layout->theme->background, 1);
    cairo_fill(cairo);
    cairo_arc(cairo, x, y, DOT_RADIUS, 0, 2 * G_PI);
    tinker_plot_set_curve_style(cairo, layout, curve);
    cairo_fill(cairo);
}

static gboolean is_inside(const TinkerPlotLayout *layout, double x, double y)
{
    return x >= layout->left - 0.5 && x <= layout->right + 0.5 && y >= layout->top - 0.5 && y <= layout->bottom + 0.5;
}

/* Dots where the curve passes the cursor: on each piece between two points on either side of it, and on its last point.
 */
static void draw_dots(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerCurve *curve, double cursor)
{
    double at = tinker_axis_place(&layout->x, cursor), x1, y1, x2, y2;
    int dots = 0;
    gsize first = 0, end = curve->count;
    if (tinker_plot_can_index(curve, FALSE, FALSE)) {
        const gsize beyond = tinker_curve_first_from(curve->x, curve->count, cursor);
        first = beyond > 0 ? beyond - 1 : 0;
        end = MIN(curve->count, beyond + MOST_DOTS);
    }
    for (gsize i = first; i < end && dots < MOST_DOTS; i++) {
        gsize next = MIN(i + 1, curve->count - 1);
        gboolean passes = curve->x[i] == cursor || (curve->x[i] < cursor) != (curve->x[next] < cursor);
        if (!passes || !tinker_plot_place(layout, curve, i, &x1, &y1)) continue;
        if (!tinker_plot_place(layout, curve, next, &x2, &y2)) {
            x2 = x1;
            y2 = y1;
        }
        double share = x1 != x2 ? CLAMP((at - x1) / (x2 - x1), 0, 1) : 0;
        double x = x1 + share * (x2 - x1), y = y1 + share * (y2 - y1);
        if (fabs(x - at) > 0.5 || !is_inside(layout, x, y)) continue;
        draw_dot(cairo, layout, curve, x, y);
        dots++;
    }
}

void tinker_plot_draw_cursor(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    const TinkerPlot *plot = layout->plot;
    if (!plot->cursor) return;
    double x = tinker_axis_place(&layout->x, *plot->cursor);
    if (!isfinite(x) || x < layout->left - 0.5 || x > layout->right + 0.5) return;
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_width(cairo, 1);
    tinker_plot_set_colour(cairo, layout->theme->axis, CURSOR_SHARE);
    cairo_move_to(cairo, floor(x) + 0.5, layout->top);
    cairo_line_to(cairo, floor(x) + 0.5, layout->bottom);
    cairo_stroke(cairo);
    for (int k = 0; k < 2 * plot->curve_count; k++) {
        const TinkerCurve *curve = &plot->curves[k % plot->curve_count];
        if (curve->role == TINKER_CURVE_DATA && curve->behind == (k < plot->curve_count))
            draw_dots(cairo, layout, curve, *plot->cursor);
    }
}

/* Reading ---------------------------------------------------------------------------------------------------------- */

static TinkerText line_of(const TinkerPlotLayout *layout, const char *words)
{
    double room = layout->right - layout->left - 2 * BUBBLE_INNER;
    return (TinkerText){.text = words, .size = layout->sizes->tick_text, .limit = fmax(room, 1), .passing = TRUE};
}

/* The point that is read: where it lies. FALSE where there is none on the plot. */
static gboolean place_point(const TinkerPlotLayout *layout, double *x, double *y)
{
    const TinkerPlot *plot = layout->plot;
    const TinkerPlotReading *reading = plot->reading;
    if (!reading || reading->curve < 0 || reading->curve >= plot->curve_count) return FALSE;
    const TinkerCurve *curve = &plot->curves[reading->curve];
    if (reading->at != NULL) {
        *x = tinker_axis_place(&layout->x, reading->at[0]);
        *y = tinker_axis_place(tinker_plot_y_axis(layout, curve), reading->at[1]);
        return isfinite(*x) && isfinite(*y) && is_inside(layout, *x, *y);
    }
    return reading->point < curve->count && tinker_plot_place(layout, curve, reading->point, x, y) &&
           is_inside(layout, *x, *y);
}

/* Right of the point and above it, where there is room; else on the other side, and never beyond the frame. */
static double beside(double point, double size, double from, double to, gboolean after)
{
    double wanted = after ? point + BUBBLE_GAP : point - BUBBLE_GAP - size;
    double other = after ? point - BUBBLE_GAP - size : point + BUBBLE_GAP;
    if (wanted >= from && wanted + size <= to) return wanted;
    if (other >= from && other + size <= to) return other;
    return fmax(fmin(wanted, to - size), from);
}

gboolean tinker_plot_place_reading(const TinkerPlotLayout *layout, double box[4])
{
    double x, y, widest = 0, high = 0;
    if (!place_point(layout, &x, &y)) return FALSE;
    const char *const words[] = {layout->plot->reading->x, layout->plot->reading->y};
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        double width, height;
        if (!words[i]) continue;
        TinkerText line = line_of(layout, words[i]);
        tinker_text_measure(layout->pen, &line, &width, &height);
        widest = fmax(widest, width);
        high += height;
    }
    widest += 2 * BUBBLE_INNER;
    high += 2 * BUBBLE_INNER;
    box[0] = beside(x, widest, layout->left, layout->right, TRUE);
    box[1] = beside(y, high, layout->top, layout->bottom, FALSE);
    box[2] = box[0] + widest;
    box[3] = box[1] + high;
    return TRUE;
}

static void rounded_box(cairo_t *cairo, const double box[4])
{
    const double radius = BUBBLE_CORNER;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, box[2] - radius, box[1] + radius, radius, -G_PI / 2, 0);
    cairo_arc(cairo, box[2] - radius, box[3] - radius, radius, 0, G_PI / 2);
    cairo_arc(cairo, box[0] + radius, box[3] - radius, radius, G_PI / 2, G_PI);
    cairo_arc(cairo, box[0] + radius, box[1] + radius, radius, G_PI, 1.5 * G_PI);
    cairo_close_path(cairo);
}

static void draw_bubble(cairo_t *cairo, const TinkerPlotLayout *layout, const double box[4])
{
    const char *const words[] = {layout->plot->reading->x, layout->plot->reading->y};
    double y = box[1] + BUBBLE_INNER;
    rounded_box(cairo, (double[]){floor(box[0]) + 0.5, floor(box[1]) + 0.5, floor(box[2]) - 0.5, floor(box[3]) - 0.5});
    tinker_plot_set_colour(cairo, layout->theme->background, 0.94);
    cairo_fill_preserve(cairo);
    tinker_plot_set_colour(cairo, layout->theme->axis, 0.6);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
    tinker_plot_set_colour(cairo, layout->theme->colours[TINKER_COLOUR_TEXT], 1);
    for (gsize i = 0; i < G_N_ELEMENTS(words); i++) {
        double width, height;
        if (!words[i]) continue;
        TinkerText line = line_of(layout, words[i]);
        tinker_text_measure(layout->pen, &line, &width, &height);
        tinker_text_draw(layout->pen, cairo, &line, box[0] + BUBBLE_INNER, y);
        y += height;
    }
}

void tinker_plot_draw_reading(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    double x, y, box[4];
    if (!place_point(layout, &x, &y) || !tinker_plot_place_reading(layout, box)) return;
    const TinkerPlotReading *reading = layout->plot->reading;
    draw_dot(cairo, layout, &layout->plot->curves[reading->curve], x, y);
    if (reading->x || reading->y) draw_bubble(cairo, layout, box);
}
