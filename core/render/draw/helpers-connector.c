/* The helpers for connectors: coil, dashpot, bar. Each is drawn along the x axis from 0 to its length, on a context
 * that is turned so that this is the line between the two points; where symbols are too small to be seen, it is a line.
 */
#include "render/draw/strokes.h"

#include <math.h>

#define COIL_HALF_WIDTH 0.42 /* of the symbol size */
#define COIL_PITCH      0.6  /* length of a turn at rest, likewise, where the number of turns is not limited */
#define LEAST_PITCH     7.0  /* canvas units: likewise, at least */
#define LEAST_TURNS     4
#define GREATEST_TURNS  16
#define LEAD_SHARE      0.12 /* of the length: the straight piece at each end of a coil */
#define LEAST_TOOTH     1.5  /* canvas units of half a turn */
#define LEAST_LENGTH    4.0  /* canvas units: below, symbols become lines */
#define GREATEST_LENGTH 1e5  /* device pixels: beyond, likewise */
#define CYLINDER_LENGTH 1.6  /* of the symbol size */
#define CYLINDER_HALF   0.36
#define BAR_HALF        0.16

/* Turns the context so that the symbol lies along the x axis. FALSE where a plain line was drawn instead, or nothing.
 */
static gboolean enter(const TinkerStyle *style, cairo_t *cairo, int32_t colour, const double line[4], double *length)
{
    *length = hypot(line[2] - line[0], line[3] - line[1]);
    if (!tinker_style_finite(line, 4) || !isfinite(*length)) return FALSE;
    double unit = tinker_style_unit(style);
    if (tinker_style_is_tiny(style) || *length < LEAST_LENGTH * unit || *length > GREATEST_LENGTH * style->pixel) {
        tinker_helper_line(style, cairo, colour, line[0], line[1], line[2], line[3]);
        return FALSE;
    }
    cairo_save(cairo);
    cairo_translate(cairo, line[0], line[1]);
    cairo_rotate(cairo, atan2(line[3] - line[1], line[2] - line[0]));
    return TRUE;
}

/* The path survives the change of axes; the line width is the same in both. */
static void leave(const TinkerStyle *style, cairo_t *cairo, int32_t colour)
{
    cairo_restore(cairo);
    tinker_style_stroke(style, cairo, colour, 1);
}

/* The number of turns goes by the length at rest alone, so that the coil of a moving spring keeps them. */
static int turns_of(const TinkerStyle *style, double length, double rest_length)
{
    double rest = isfinite(rest_length) && rest_length > 0 ? rest_length : length;
    double unit = tinker_style_unit(style), pitch = fmax(COIL_PITCH * style->symbol_size, LEAST_PITCH * unit);
    double turns = CLAMP(round(rest / pitch), LEAST_TURNS, GREATEST_TURNS);
    double visible = (1 - 2 * LEAD_SHARE) * length / (2 * LEAST_TOOTH * unit);
    return (int)fmax(1, fmin(turns, floor(visible)));
}

void tinker_helper_coil(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                        double y2, double rest_length)
{
    const double line[4] = {x1, y1, x2, y2};
    double length;
    if (!enter(style, cairo, colour, line, &length)) return;
    int turns = turns_of(style, length, rest_length);
    double lead = fmin(LEAD_SHARE * length, style->symbol_size);
    double tooth = (length - 2 * lead) / (2 * turns), half = COIL_HALF_WIDTH * style->symbol_size;
    cairo_move_to(cairo, 0, 0);
    cairo_line_to(cairo, lead, 0);
    for (int i = 0; i < 2 * turns; i++)
        cairo_line_to(cairo, lead + (i + 0.5) * tooth, i % 2 ? -half : half);
    cairo_line_to(cairo, length - lead, 0);
    cairo_line_to(cairo, length, 0);
    leave(style, cairo, colour);
}

void tinker_helper_dashpot(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                           double y2)
{
    const double line[4] = {x1, y1, x2, y2};
    double length;
    if (!enter(style, cairo, colour, line, &length)) return;
    double cylinder = fmin(CYLINDER_LENGTH * style->symbol_size, 0.5 * length);
    double half = CYLINDER_HALF * style->symbol_size;
    double bottom = (length - cylinder) / 2, rim = bottom + cylinder, piston = length / 2;
    /* The cylinder, open at its rim, on the first end; piston and its rod on the second. */
    cairo_move_to(cairo, 0, 0);
    cairo_line_to(cairo, bottom, 0);
    cairo_move_to(cairo, rim, half);
    cairo_line_to(cairo, bottom, half);
    cairo_line_to(cairo, bottom, -half);
    cairo_line_to(cairo, rim, -half);
    cairo_move_to(cairo, piston, 0.72 * half);
    cairo_line_to(cairo, piston, -0.72 * half);
    cairo_move_to(cairo, piston, 0);
    cairo_line_to(cairo, length, 0);
    leave(style, cairo, colour);
}

void tinker_helper_bar(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                       double y2)
{
    const double line[4] = {x1, y1, x2, y2};
    double length;
    if (!enter(style, cairo, colour, line, &length)) return;
    double half = BAR_HALF * style->symbol_size;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, 0, 0, half, G_PI / 2, 3 * G_PI / 2);
    cairo_arc(cairo, length, 0, half, -G_PI / 2, G_PI / 2);
    cairo_close_path(cairo);
    tinker_style_fill(style, cairo, TINKER_COLOUR_BODY);
    leave(style, cairo, colour);
}
