/* How a curve is told from others: colour, dashes, marks. */
#include <math.h>

#include "render/plot/plot-private.h"

#define FADED         0.3 /* what is left of a colour */
#define MARKER_SIZE   3.4
#define RING_SIZE     7.5
#define RING_LINE     2.0
#define GUIDE_LINE    1.2
#define CURVE_COLOURS 8

static int colour_number(const TinkerCurve *curve)
{
    return ABS(curve->colour % CURVE_COLOURS);
}

const double *tinker_plot_curve_colour(const TinkerPlotLayout *layout, const TinkerCurve *curve)
{
    return layout->theme->curves[colour_number(curve)];
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
    const double *c = curve->role == TINKER_CURVE_DATA    ? tinker_plot_curve_colour(layout, curve)
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
