/* The helpers for bodies, supports, arrows, marks and text. All work in world units on a context that has the world's
 * transform; what is not finite is not drawn. */
#include "render/draw/strokes.h"

#include <math.h>
#include <string.h>

#define HATCH_SHARE       0.5 /* of the symbol size: length and distance of hatch strokes */
#define HEAD_LENGTH       0.8 /* likewise: of arrow heads */
#define HEAD_WIDTH        0.6
#define MARK_SHARE        0.24 /* half the size of an end mark */
#define LEAST_CROSS_UNITS 1.7
#define GREATEST_RADIUS   1e6  /* device pixels of a circle */
#define DOT_SHARE         0.25 /* radius of a body without size */
#define LEAST_DOT_UNITS   2.5
#define LEAST_TEXT_SHARE  0.3 /* of its full size: where symbols are smaller on the canvas, texts are left out */
#define LEAST_HATCH_UNITS 3.0
#define LEAST_SEGMENT     0.5 /* device pixels */

void tinker_helper_line(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                        double y2)
{
    const double line[4] = {x1, y1, x2, y2};
    double from, to, length = hypot(x2 - x1, y2 - y1);
    if (!tinker_style_finite(line, 4) || !isfinite(length) || !tinker_style_clip(style, line, &from, &to)) return;
    double ux = length > 0 ? (x2 - x1) / length : 0, uy = length > 0 ? (y2 - y1) / length : 0;
    cairo_move_to(cairo, x1 + from * ux, y1 + from * uy);
    cairo_line_to(cairo, to < length ? x1 + to * ux : x2, to < length ? y1 + to * uy : y2);
    tinker_style_stroke(style, cairo, colour, 1);
}

/* Points nearer to the last one drawn than half a pixel are passed over, so that a path of any number of points costs
 * what can be seen of it; what lies wholly beside the view is left out. */
void tinker_helper_polyline(const TinkerStyle *style, cairo_t *cairo, int32_t colour, const double *points,
                            int32_t count)
{
    const double least = LEAST_SEGMENT * style->pixel;
    double last[2] = {NAN, NAN}, drawn[2] = {NAN, NAN};
    for (int32_t i = 0; i < count; i++) {
        const double line[4] = {last[0], last[1], points[2 * i], points[2 * i + 1]};
        double from, to;
        const gboolean first = isnan(last[0]);
        if (!tinker_style_finite(line + 2, 2)) continue;
        if (!first && i + 1 < count && hypot(line[2] - last[0], line[3] - last[1]) < least) continue;
        if (!first && tinker_style_clip(style, line, &from, &to)) {
            const double length = hypot(line[2] - line[0], line[3] - line[1]);
            const double ux = length > 0 ? (line[2] - line[0]) / length : 0;
            const double uy = length > 0 ? (line[3] - line[1]) / length : 0;
            if (from > 0 || drawn[0] != line[0] || drawn[1] != line[1])
                cairo_move_to(cairo, line[0] + from * ux, line[1] + from * uy);
            memcpy(drawn, line + 2, sizeof drawn);
            if (to < length) drawn[0] = NAN;
            cairo_line_to(cairo, to < length ? line[0] + to * ux : line[2], to < length ? line[1] + to * uy : line[3]);
        }
        memcpy(last, line + 2, sizeof last);
    }
    tinker_style_stroke(style, cairo, colour, 0.7);
}

void tinker_helper_circle(const TinkerStyle *style, cairo_t *cairo, int32_t fill, int32_t edge, double x, double y,
                          double radius)
{
    const double numbers[3] = {x, y, radius};
    /* Cairo makes an arc of pieces, the more the larger it is, and never ends with one beyond its numbers. */
    if (!tinker_style_finite(numbers, 3) || radius < 0 || radius > GREATEST_RADIUS * style->pixel) return;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, x, y, radius, 0, 2 * G_PI);
    cairo_close_path(cairo);
    if (edge < 0) tinker_style_halo(style, cairo, 0);
    if (fill >= 0) tinker_style_fill(style, cairo, fill);
    if (edge >= 0) tinker_style_stroke(style, cairo, edge, 1);
    cairo_new_path(cairo);
}

void tinker_helper_polygon(const TinkerStyle *style, cairo_t *cairo, int32_t fill, int32_t edge, const double *points,
                           int32_t count)
{
    if (count < 2 || !tinker_style_finite(points, 2 * (gsize)count)) return;
    for (int32_t i = 0; i < count; i++)
        cairo_line_to(cairo, points[2 * i], points[2 * i + 1]);
    cairo_close_path(cairo);
    if (edge < 0) tinker_style_halo(style, cairo, 0);
    if (fill >= 0) tinker_style_fill(style, cairo, fill);
    if (edge >= 0) tinker_style_stroke(style, cairo, edge, 1);
    cairo_new_path(cairo);
}

void tinker_helper_box(const TinkerStyle *style, cairo_t *cairo, int32_t fill, int32_t edge, double x, double y,
                       double width, double height, double orientation)
{
    const double numbers[5] = {x, y, width, height, orientation};
    if (!tinker_style_finite(numbers, 5)) return;
    if (width <= 0 && height <= 0) {
        double radius = fmax(DOT_SHARE * style->symbol_size, LEAST_DOT_UNITS * tinker_style_unit(style));
        tinker_helper_circle(style, cairo, edge, edge, x, y, radius);
        return;
    }
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_rotate(cairo, orientation);
    cairo_rectangle(cairo, -width / 2, -height / 2, width, height);
    cairo_restore(cairo);
    if (edge < 0) tinker_style_halo(style, cairo, 0);
    if (fill >= 0) tinker_style_fill(style, cairo, fill);
    if (edge >= 0) tinker_style_stroke(style, cairo, edge, 1);
    cairo_new_path(cairo);
}

void tinker_helper_hatch(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                         double y2)
{
    const double line[4] = {x1, y1, x2, y2};
    double from, to, length = hypot(x2 - x1, y2 - y1);
    if (!tinker_style_finite(line, 4) || !isfinite(length) || !tinker_style_clip(style, line, &from, &to)) return;
    if (tinker_style_is_tiny(style)) return;
    double stroke = HATCH_SHARE * style->symbol_size;
    double spacing = fmax(stroke, LEAST_HATCH_UNITS * tinker_style_unit(style));
    /* Where a stroke's distance is lost in the digits of the length, strokes would never come to its end. */
    if (length < stroke || length > 1e12 * spacing) return;
    double ux = (x2 - x1) / length, uy = (y2 - y1) / length;
    /* A stroke begins at the line and runs back and to the right of it; the first one is the one that still starts over
     * the line's first point. They keep their places when the view moves. */
    double least = fmax(from, stroke);
    for (double s = stroke + ceil((least - stroke) / spacing) * spacing; s <= to + 1e-9 * length; s += spacing) {
        double x = x1 + s * ux, y = y1 + s * uy;
        cairo_move_to(cairo, x, y);
        cairo_line_to(cairo, x - stroke * ux + stroke * uy, y - stroke * uy - stroke * ux);
    }
    tinker_style_stroke(style, cairo, colour, 0.7);
}

void tinker_helper_arrow(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                         double y2)
{
    const double line[4] = {x1, y1, x2, y2};
    double length = hypot(x2 - x1, y2 - y1);
    if (!tinker_style_finite(line, 4) || !isfinite(length) || length == 0) return;
    double ux = (x2 - x1) / length, uy = (y2 - y1) / length;
    double head = HEAD_LENGTH * style->symbol_size, half = HEAD_WIDTH / 2 * style->symbol_size;
    double base_x = x2 - head * ux, base_y = y2 - head * uy;
    if (length > head) {
        /* The shaft ends inside the head, so that no gap shows between them. */
        double inside = 0.25 * head;
        cairo_move_to(cairo, x1, y1);
        cairo_line_to(cairo, base_x + inside * ux, base_y + inside * uy);
        tinker_style_stroke(style, cairo, colour, 1.6);
    }
    cairo_move_to(cairo, x2, y2);
    cairo_line_to(cairo, base_x - half * uy, base_y + half * ux);
    cairo_line_to(cairo, base_x + half * uy, base_y - half * ux);
    cairo_close_path(cairo);
    tinker_style_halo(style, cairo, 0);
    tinker_style_fill(style, cairo, colour);
    if (style->state & TINKER_STATE_DETACHED) tinker_style_stroke(style, cairo, colour, 1);
    cairo_new_path(cairo);
}

void tinker_helper_end_mark(const TinkerStyle *style, cairo_t *cairo, double x, double y, int32_t attached)
{
    double half = MARK_SHARE * style->symbol_size;
    if (!isfinite(x) || !isfinite(y) || tinker_style_is_tiny(style)) return;
    /* A cross of a few pixels would hide the colour of its connector. */
    if (attached && half < LEAST_CROSS_UNITS * tinker_style_unit(style)) return;
    /* An end has its own state: the attached end of a detached connector is marked as attached. */
    TinkerStyle plain = *style;
    plain.state &= ~TINKER_STATE_DETACHED;
    if (attached) {
        cairo_move_to(cairo, x - half, y - half);
        cairo_line_to(cairo, x + half, y + half);
        cairo_move_to(cairo, x - half, y + half);
        cairo_line_to(cairo, x + half, y - half);
        /* The themes' red. */
        tinker_style_stroke(&plain, cairo, TINKER_COLOUR_COMPRESSED, 1.3);
    } else {
        tinker_helper_circle(&plain, cairo, -1, TINKER_COLOUR_DETACHED, x, y, half);
    }
}

void tinker_helper_text(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x, double y, const char *text)
{
    double unit = tinker_style_unit(style);
    if (!isfinite(x) || !isfinite(y) || !text) return;
    if (style->symbol_size < LEAST_TEXT_SHARE * TINKER_STYLE_TEXT * unit) return;
    if (style->state & TINKER_STATE_DETACHED) colour = TINKER_COLOUR_DETACHED;
    const double *c = style->colours[CLAMP(colour, 0, TINKER_COLOUR_COUNT - 1)];
    TinkerText label = {.text = text, .size = TINKER_STYLE_TEXT, .anchor_x = 0.5, .anchor_y = 0.5};
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_scale(cairo, unit, -unit);
    cairo_set_source_rgba(cairo, c[0], c[1], c[2], c[3]);
    tinker_text_draw_apart(style->context, cairo, &label);
    cairo_restore(cairo);
}
