/* Where things are on a plot that is not drawn: its geometry, and what is at a place of the canvas. */
#include "render/plot/plot.h"

#include <math.h>

#include "render/draw/paint-memory-content.h"
#include "render/plot/plot-private.h"

static TinkerPlotScale scale_of(const TinkerAxis *axis)
{
    return (TinkerPlotScale){axis->logarithmic, axis->low, axis->high, axis->start, axis->length};
}

void tinker_plot_measure(const TinkerPlot *plot, double width, double height, TinkerPlotGeometry *geometry)
{
    TinkerTextPen pen = {.memory = tinker_paint_memory_texts(plot->memory)};
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, plot, &pen, width, height);
    *geometry = (TinkerPlotGeometry){layout.left,
                                     layout.top,
                                     layout.right,
                                     layout.bottom,
                                     scale_of(&layout.x),
                                     scale_of(&layout.y),
                                     scale_of(&layout.second),
                                     layout.has_second};
    for (int i = 0; i < 4 && layout.legend.kind != TINKER_LEGEND_NONE; i++)
        geometry->legend[i] = layout.legend.box[i];
    geometry->shortens_legend = tinker_plot_shortens_legend(&layout);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
}

static TinkerAxis axis_of(const TinkerPlotScale *scale)
{
    return (TinkerAxis){.logarithmic = scale->logarithmic,
                        .low = scale->low,
                        .high = scale->high,
                        .start = scale->start,
                        .length = scale->length};
}

double tinker_plot_scale_place(const TinkerPlotScale *scale, double value)
{
    const TinkerAxis axis = axis_of(scale);
    return tinker_axis_place(&axis, value);
}

double tinker_plot_scale_value(const TinkerPlotScale *scale, double place)
{
    const TinkerAxis axis = axis_of(scale);
    return tinker_axis_value(&axis, place);
}

gboolean tinker_plot_pick(const TinkerPlot *plot, double width, double height, double canvas_x, double canvas_y,
                          double reach, TinkerPlotPoint *found)
{
    TinkerTextPen pen = {.memory = tinker_paint_memory_texts(plot->memory)};
    TinkerPlotLayout layout;
    double nearest = reach;
    gboolean any = FALSE;
    tinker_plot_lay_out(&layout, plot, &pen, width, height);
    for (int i = 0; i < plot->curve_count; i++) {
        const TinkerCurve *curve = &plot->curves[i];
        gsize first = 0, end = curve->count;
        if (tinker_plot_can_index(curve, FALSE, FALSE)) {
            first = tinker_curve_first_from(curve->x, curve->count, tinker_axis_value(&layout.x, canvas_x - reach));
            end = tinker_curve_first_from(curve->x, curve->count, tinker_axis_value(&layout.x, canvas_x + reach));
        }
        for (gsize n = first; n < end; n++) {
            double x, y;
            if (!tinker_plot_place(&layout, curve, n, &x, &y)) continue;
            double distance = hypot(x - canvas_x, y - canvas_y);
            if (distance > nearest) continue;
            nearest = distance;
            any = TRUE;
            *found = (TinkerPlotPoint){.curve = i, .point = n, .canvas_x = x, .canvas_y = y};
        }
    }
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
    return any;
}

int tinker_plot_pick_legend(const TinkerPlot *plot, double width, double height, double canvas_x, double canvas_y)
{
    TinkerTextPen pen = {.memory = tinker_paint_memory_texts(plot->memory)};
    TinkerPlotLayout layout;
    tinker_plot_lay_out(&layout, plot, &pen, width, height);
    const int curve = tinker_plot_legend_curve(&layout, canvas_x, canvas_y);
    tinker_plot_layout_clear(&layout);
    tinker_text_pen_clear(&pen);
    return curve;
}
