/* A style for the time that one block is drawn: sizes for the view, and the functions that blocks draw with. */
#include "render/draw/strokes.h"

#include <math.h>
#include <string.h>

#define SYMBOL_UNITS 20.0 /* canvas units of a symbol, unless that is large beside the blocks */

static void set_helpers(TinkerStyle *style)
{
    style->line = tinker_helper_line;
    style->box = tinker_helper_box;
    style->hatch = tinker_helper_hatch;
    style->coil = tinker_helper_coil;
    style->dashpot = tinker_helper_dashpot;
    style->bar = tinker_helper_bar;
    style->arrow = tinker_helper_arrow;
    style->end_mark = tinker_helper_end_mark;
    style->circle = tinker_helper_circle;
    style->text = tinker_helper_text;
    style->polyline = tinker_helper_polyline;
    style->polygon = tinker_helper_polygon;
}

/* Device pixels to a canvas unit: of a surface for a dense screen more than one. */
static double pixels_per_unit(cairo_t *cairo)
{
    double across = 1, down = 0, device_x = 1, device_y = 1;
    cairo_user_to_device_distance(cairo, &across, &down);
    cairo_surface_get_device_scale(cairo_get_group_target(cairo), &device_x, &device_y);
    double pixels = hypot(across, down) * device_x;
    return isfinite(pixels) && pixels > 0 ? pixels : 1;
}

void tinker_style_begin(TinkerStyleBrush *brush, cairo_t *cairo, const TinkerTheme *theme, const TinkerView *view,
                        double symbol)
{
    memset(brush, 0, sizeof *brush);
    TinkerStyle *style = &brush->style;
    style->struct_size = sizeof *style;
    style->symbol_size = symbol;
    style->pixel = 1 / (view->scale * pixels_per_unit(cairo));
    /* Lines get thinner with the symbols, where the whole scene is small on the canvas. */
    double share = fmin(1, symbol * view->scale / (0.7 * SYMBOL_UNITS));
    style->line_width = fmax(TINKER_STYLE_LINE * share / view->scale, style->pixel);
    tinker_view_to_world(view, 0, view->height, &style->view[0], &style->view[1]);
    tinker_view_to_world(view, view->width, 0, &style->view[2], &style->view[3]);
    const double transform[6] = {view->scale, 0, view->origin_x, 0, -view->scale, view->origin_y};
    memcpy(style->transform, transform, sizeof transform);
    memcpy(style->colours, theme->colours, sizeof style->colours);
    style->context = &brush->pen;
    set_helpers(style);
}

void tinker_style_end(TinkerStyleBrush *brush)
{
    tinker_text_pen_clear(&brush->pen);
}
