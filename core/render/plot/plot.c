/* The plot's ink: ground, grid, bands, curves, frame and ticks, legend, cursor, texts, reading, in this order. */
#include "render/plot/plot.h"

#include <math.h>

#include "render/draw/paint-memory-content.h"
#include "render/draw/surface.h"
#include "render/plot/plot-private.h"

#define FINEST 0.5 /* device pixels: width of the columns that curves are thinned to */
#define COARSE 1.0 /* likewise where it has to be quick */

static double column_width(cairo_t *cairo, gboolean quick)
{
    double across = 1, down = 0, device_x = 1, device_y = 1;
    cairo_user_to_device_distance(cairo, &across, &down);
    cairo_surface_get_device_scale(cairo_get_group_target(cairo), &device_x, &device_y);
    double pixels = hypot(across, down) * device_x;
    return (quick ? COARSE : FINEST) / (isfinite(pixels) && pixels > 0.01 ? pixels : 1);
}

static void clip_to_frame(cairo_t *cairo, const TinkerPlotLayout *layout, double beyond)
{
    cairo_rectangle(cairo, layout->left - beyond, layout->top - beyond, layout->right - layout->left + 2 * beyond,
                    layout->bottom - layout->top + 2 * beyond);
    cairo_clip(cairo);
}

static void draw_curves(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    const TinkerPlot *plot = layout->plot;
    double column = column_width(cairo, plot->quick);
    cairo_save(cairo);
    clip_to_frame(cairo, layout, 0);
    for (int i = 0; i < plot->curve_count; i++)
        tinker_plot_draw_band(cairo, layout, &plot->curves[i], column);
    cairo_restore(cairo);
    cairo_save(cairo);
    /* Half a line's width beyond the frame, so that a curve along it is not cut in two. */
    clip_to_frame(cairo, layout, 2);
    for (int k = 0; k < 2 * plot->curve_count; k++) {
        const TinkerCurve *curve = &plot->curves[k % plot->curve_count];
        if (curve->behind == (k < plot->curve_count)) tinker_plot_draw_curve(cairo, layout, curve, column);
    }
    cairo_restore(cairo);
}

void tinker_plot_draw_noting(cairo_t *cairo, const TinkerPlot *plot, double width, double height, GPtrArray *written)
{
    TinkerTextPen pen = {.written = written, .memory = tinker_paint_memory_texts(plot->memory)};
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, plot, &pen, width, height);
    gboolean has_text = layout.left > 2;
    cairo_save(cairo);
    /* Never with CAIRO_ANTIALIAS_FAST: what cairo 1.16 does then writes beyond its memory where a curve is crowded. */
    tinker_plot_set_colour(cairo, layout.theme->background, 1);
    cairo_rectangle(cairo, 0, 0, width, height);
    cairo_fill(cairo);
    tinker_plot_draw_grid(cairo, &layout);
    tinker_plot_draw_frame(cairo, &layout);
    const gboolean empty = layout.x.empty || (layout.y.empty && (!layout.has_second || layout.second.empty));
    if (empty) {
        if (has_text) tinker_plot_draw_no_data(cairo, &layout);
    } else {
        draw_curves(cairo, &layout);
        tinker_plot_draw_legend(cairo, &layout);
        tinker_plot_draw_cursor(cairo, &layout);
    }
    if (has_text) tinker_plot_draw_texts(cairo, &layout);
    if (!empty) tinker_plot_draw_reading(cairo, &layout);
    cairo_restore(cairo);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

void tinker_plot_draw(cairo_t *cairo, const TinkerPlot *plot, double width, double height)
{
    tinker_plot_draw_noting(cairo, plot, width, height, NULL);
}

static void draw_file_plot(cairo_t *cairo, double width, double height, gpointer data)
{
    tinker_plot_draw(cairo, data, width, height);
}

gboolean tinker_plot_to_file(const TinkerPlot *plot, int width, int height, const char *path, GError **error)
{
    TinkerPlot copy = *plot;
    return tinker_surface_to_file(draw_file_plot, &copy, width, height, path, error);
}
