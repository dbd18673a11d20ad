/* A style begins with the theme's colours and the view's measures. Everything that is drawn ends in one of three
 * functions, stroke, fill and halo, and they alone know what detached, selected and highlighted look like. */
#include "render/draw/strokes.h"

#include <math.h>
#include <string.h>

#define SYMBOL_UNITS       20.0 /* canvas units of a symbol, unless that is large beside the blocks */
#define SYMBOL_SHARE       0.36 /* of a typical block, at most */
#define HALO_UNITS         6.0  /* of what is highlighted, */
#define HALO_ALPHA         0.5
#define OUTLINE_UNITS      4.0 /* and of what is selected, whose outline is as thin as can be seen */
#define LEAST_SYMBOL_UNITS 4.0
#define THIN_PIXELS_COARSE 2.1 /* up to the crosses of ends */
#define GREATEST_DASHES    2000.0

gboolean tinker_style_is_tiny(const TinkerStyle *style)
{
    return style->symbol_size < LEAST_SYMBOL_UNITS * tinker_style_unit(style);
}

double tinker_style_line_width(const TinkerStyle *style)
{
    return fmax(style->line_width, style->pixel);
}

gboolean tinker_style_finite(const double *numbers, int count)
{
    for (int i = 0; i < count; i++)
        if (!isfinite(numbers[i])) return FALSE;
    return TRUE;
}

/* The colour that a state leaves of the one asked for. */
static const double *colour_of(const TinkerStyle *style, int32_t colour)
{
    if (style->state & TINKER_STATE_DETACHED) colour = TINKER_COLOUR_DETACHED;
    if (colour < 0 || colour >= TINKER_COLOUR_COUNT) colour = TINKER_COLOUR_CONNECTOR;
    return style->colours[colour];
}

static void set_dashes(const TinkerStyle *style, cairo_t *cairo, double width)
{
    double x1, y1, x2, y2;
    cairo_path_extents(cairo, &x1, &y1, &x2, &y2);
    /* Dashes of a line that runs far out of the picture grow, so that their number stays small. */
    double dash = fmax(4 * width, hypot(x2 - x1, y2 - y1) / GREATEST_DASHES);
    const double dashes[] = {dash, 0.6 * dash};
    cairo_set_dash(cairo, dashes, 2, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
}

void tinker_style_halo(const TinkerStyle *style, cairo_t *cairo, double width)
{
    if (!(style->state & (TINKER_STATE_SELECTED | TINKER_STATE_HIGHLIGHTED))) return;
    gboolean highlighted = style->state & TINKER_STATE_HIGHLIGHTED;
    const double *c = style->colours[highlighted ? TINKER_COLOUR_HIGHLIGHTED : TINKER_COLOUR_SELECTED];
    cairo_save(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, width + (highlighted ? HALO_UNITS : OUTLINE_UNITS) * tinker_style_unit(style));
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], (highlighted ? HALO_ALPHA : 1) * c[3]);
    cairo_stroke_preserve(cairo);
    cairo_restore(cairo);
}

void tinker_style_fill(const TinkerStyle *style, cairo_t *cairo, int32_t colour)
{
    const double *c = colour_of(style, colour);
    double alpha = style->state & TINKER_STATE_DETACHED ? 0.25 * c[3] : c[3];
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], alpha);
    cairo_fill_preserve(cairo);
}

void tinker_style_stroke(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double factor)
{
    double width = fmax(factor * style->line_width, style->pixel);
    tinker_style_halo(style, cairo, width);
    const double *c = colour_of(style, colour);
    /* Ends and corners of a thin line look the same whatever their shape, and round ones take the most time. */
    gboolean coarse = cairo_get_antialias(cairo) == CAIRO_ANTIALIAS_FAST;
    gboolean thin = width <= (coarse ? THIN_PIXELS_COARSE : 1) * style->pixel;
    cairo_set_line_width(cairo, width);
    cairo_set_line_join(cairo, thin ? CAIRO_LINE_JOIN_BEVEL : CAIRO_LINE_JOIN_ROUND);
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], c[3]);
    if (style->state & TINKER_STATE_DETACHED) {
        set_dashes(style, cairo, width);
    } else {
        cairo_set_dash(cairo, NULL, 0, 0);
        cairo_set_line_cap(cairo, thin ? CAIRO_LINE_CAP_SQUARE : CAIRO_LINE_CAP_ROUND);
    }
    cairo_stroke(cairo);
}

/* Liang and Barsky, "A new concept and method for line clipping" (1984): each side of the box cuts the range of the
 * line's parameter. */
gboolean tinker_style_clip(const TinkerStyle *style, const double line[4], double *from, double *to)
{
    double room = 2 * style->symbol_size + HALO_UNITS * tinker_style_unit(style);
    double dx = line[2] - line[0], dy = line[3] - line[1];
    const double steps[4] = {-dx, dx, -dy, dy};
    const double rooms[4] = {line[0] - style->view[0] + room, style->view[2] + room - line[0],
                             line[1] - style->view[1] + room, style->view[3] + room - line[1]};
    double first = 0, last = 1;
    for (int side = 0; side < 4; side++) {
        if (steps[side] == 0 && rooms[side] < 0) return FALSE;
        if (steps[side] < 0) first = fmax(first, rooms[side] / steps[side]);
        if (steps[side] > 0) last = fmin(last, rooms[side] / steps[side]);
    }
    double length = hypot(dx, dy);
    *from = first * length;
    *to = last * length;
    return first <= last;
}

void tinker_style_enter_world(const TinkerStyle *style, cairo_t *cairo)
{
    const double *t = style->transform;
    cairo_matrix_t matrix;
    cairo_matrix_init(&matrix, t[0], t[3], t[1], t[4], t[2], t[5]);
    cairo_save(cairo);
    cairo_transform(cairo, &matrix);
}

double tinker_style_symbol(double scale, double typical)
{
    double symbol = SYMBOL_UNITS / scale;
    return typical > 0 ? fmin(symbol, SYMBOL_SHARE * typical) : symbol;
}
