/* The view is a uniform scale, a mirrored y axis and a shift; all its functions are total: what is not finite or not
 * positive is replaced or passed over, so that a window of size 0 or a wild zoom cannot break a drawing. */
#include "render/draw/view.h"

#include <math.h>

#define LEAST_SCALE    1e-9
#define GREATEST_SCALE 1e9

/* Makes a span usable: finite, in order, and wide enough to be told apart in doubles at its distance from 0. */
static void usable_span(double low, double high, double *middle, double *width)
{
    if (!isfinite(low) || !isfinite(high) || low > high) {
        *middle = 0;
        *width = 0;
        return;
    }
    *middle = low / 2 + high / 2;
    *width = high - low;
    double resolution = 1e-9 * fmax(fabs(low), fabs(high));
    if (*width < resolution) *width = 0;
}

TinkerView tinker_view_fit(const double box[4], double width, double height, double margin)
{
    TinkerView view = {.width = fmax(width, 1), .height = fmax(height, 1)};
    double x, y, world_width, world_height;
    usable_span(box[0], box[2], &x, &world_width);
    usable_span(box[1], box[3], &y, &world_height);
    if (world_width <= 0 && world_height <= 0) world_width = world_height = 2;

    /* A margin never takes more than four fifths of the canvas. */
    double across = fmax(view.width - 2 * fmax(margin, 0), 0.2 * view.width);
    double up = fmax(view.height - 2 * fmax(margin, 0), 0.2 * view.height);
    double scale = INFINITY;
    if (world_width > 0) scale = fmin(scale, across / world_width);
    if (world_height > 0) scale = fmin(scale, up / world_height);
    view.scale = CLAMP(scale, LEAST_SCALE, GREATEST_SCALE);
    view.origin_x = view.width / 2 - view.scale * x;
    view.origin_y = view.height / 2 + view.scale * y;
    return view;
}

void tinker_view_to_canvas(const TinkerView *view, double x, double y, double *canvas_x, double *canvas_y)
{
    *canvas_x = view->origin_x + view->scale * x;
    *canvas_y = view->origin_y - view->scale * y;
}

void tinker_view_to_world(const TinkerView *view, double canvas_x, double canvas_y, double *x, double *y)
{
    *x = (canvas_x - view->origin_x) / view->scale;
    *y = (view->origin_y - canvas_y) / view->scale;
}

void tinker_view_zoom(TinkerView *view, double factor, double canvas_x, double canvas_y)
{
    if (!(factor > 0) || !isfinite(factor)) return;
    double scale = CLAMP(view->scale * factor, LEAST_SCALE, GREATEST_SCALE);
    double grown = scale / view->scale;
    view->scale = scale;
    view->origin_x = canvas_x + (view->origin_x - canvas_x) * grown;
    view->origin_y = canvas_y + (view->origin_y - canvas_y) * grown;
}

void tinker_view_pan(TinkerView *view, double canvas_dx, double canvas_dy)
{
    if (!isfinite(canvas_dx) || !isfinite(canvas_dy)) return;
    view->origin_x += canvas_dx;
    view->origin_y += canvas_dy;
}

double tinker_view_grid(const TinkerView *view, double least)
{
    static const double mantissas[] = {1, 2, 5, 10};
    double wanted = fmax(least, 1e-3) / view->scale;
    double decade = pow(10, floor(log10(wanted)));
    for (gsize i = 0; i < G_N_ELEMENTS(mantissas); i++)
        if (mantissas[i] * decade >= wanted) return mantissas[i] * decade;
    return 20 * decade; /* only where the rounding of log10 was a decade short */
}
