/* What the helpers share: strokes and fills that heed the state of the block. */
#ifndef TINKER_RENDER_STROKES_H
#define TINKER_RENDER_STROKES_H

#include <math.h>

#include "render/draw/style.h"

/* Length of one canvas unit in m. */
static inline double tinker_style_unit(const TinkerStyle *style)
{
    return 1 / hypot(style->transform[0], style->transform[3]);
}

/* Whether symbols are too small on the canvas to be told from lines and dots: marks and hatching are left out then. */
gboolean tinker_style_is_tiny(const TinkerStyle *style);

/* The width of ordinary lines in m: never below a device pixel. */
double tinker_style_line_width(const TinkerStyle *style);

gboolean tinker_style_finite(const double *numbers, int count);

/* Strokes the present path and clears it. `factor` times the ordinary width; detached: grey and dashed; selected or
 * highlighted: with a halo beneath. */
void tinker_style_stroke(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double factor);

/* Fills the present path, and keeps it. */
void tinker_style_fill(const TinkerStyle *style, cairo_t *cairo, int32_t colour);

/* Draws the halo of a selected or highlighted block about the present path, and keeps it. */
void tinker_style_halo(const TinkerStyle *style, cairo_t *cairo, double width);

/* Cuts a line to what is visible and a little more, so that a far end costs nothing. FALSE where nothing is left.
 * `from` and `to` are the places along the line (m from its first point) where it enters and leaves. */
gboolean tinker_style_clip(const TinkerStyle *style, const double line[4], double *from, double *to);

/* Starts in helpers.c and helpers-connector.c; every one has the signature of its member of TinkerStyle. */
void tinker_helper_line(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                        double y2);
void tinker_helper_box(const TinkerStyle *style, cairo_t *cairo, int32_t fill, int32_t edge, double x, double y,
                       double width, double height, double orientation);
void tinker_helper_hatch(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                         double y2);
void tinker_helper_arrow(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                         double y2);
void tinker_helper_end_mark(const TinkerStyle *style, cairo_t *cairo, double x, double y, int32_t attached);
void tinker_helper_circle(const TinkerStyle *style, cairo_t *cairo, int32_t fill, int32_t edge, double x, double y,
                          double radius);
void tinker_helper_polygon(const TinkerStyle *style, cairo_t *cairo, int32_t fill, int32_t edge, const double *points,
                           int32_t count);
void tinker_helper_text(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x, double y, const char *text);
void tinker_helper_polyline(const TinkerStyle *style, cairo_t *cairo, int32_t colour, const double *points,
                            int32_t count);
void tinker_helper_coil(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                        double y2, double rest_length);
void tinker_helper_dashpot(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                           double y2);
void tinker_helper_bar(const TinkerStyle *style, cairo_t *cairo, int32_t colour, double x1, double y1, double x2,
                       double y2);

#endif
