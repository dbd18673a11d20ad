/* The layout: ranges from the data, then the margins that titles and tick labels need, then as many ticks as have room.
 * Each depends a little on the others, so it goes round twice; a legend that has no place among the curves costs one
 * more round. */
#include <math.h>
#include <string.h>

#include "render/plot/plot-private.h"

#define Y_MARGIN       0.05
#define X_MARGIN       0.03 /* of plots with marks or equal scales; curves over time reach from side to side */
#define LEAST_FOR_TEXT 60.0 /* a smaller plot has no text */

static const TinkerPlotSizes ordinary_sizes = {.text = 12,
                                               .title = 15,
                                               .tick_text = 11,
                                               .pad = 8,
                                               .tick_gap = 7,
                                               .label_room = 16,
                                               .column = 50,
                                               .row = 34,
                                               .legend_row = 17,
                                               .legend_sample = 26,
                                               .legend_inset = 9};
static const TinkerPlotSizes compact_sizes = {.text = 10,
                                              .title = 11,
                                              .tick_text = 9.5,
                                              .pad = 4,
                                              .tick_gap = 4,
                                              .label_room = 14,
                                              .column = 50,
                                              .row = 28,
                                              .legend_row = 13,
                                              .legend_sample = 14,
                                              .legend_inset = 2};

static void add_values(const double *values, gsize count, gboolean logarithmic, double range[2])
{
    double least = range[0], greatest = range[1];
    for (gsize i = 0; values && i < count; i++) {
        if (!isfinite(values[i]) || (logarithmic && values[i] <= 0)) continue;
        if (values[i] < least) least = values[i];
        if (values[i] > greatest) greatest = values[i];
    }
    range[0] = least;
    range[1] = greatest;
}

/* Both numbers of a curve that has an index. */
static void add_extremes(const TinkerCurve *curve, double x[2], double y[2])
{
    gsize least, greatest;
    tinker_curve_index_extremes(curve->index, curve->y, 0, curve->count, &least, &greatest);
    x[0] = fmin(x[0], curve->x[0]);
    x[1] = fmax(x[1], curve->x[curve->count - 1]);
    y[0] = fmin(y[0], curve->y[least]);
    y[1] = fmax(y[1], curve->y[greatest]);
}

/* What the axes have to show. */
static void find_ranges(TinkerPlotLayout *layout)
{
    const TinkerPlot *plot = layout->plot;
    double *x = layout->x_range, *left = layout->y_range, *second = layout->second_range;
    x[0] = left[0] = second[0] = INFINITY;
    x[1] = left[1] = second[1] = -INFINITY;
    layout->with_marks = plot->equal_scales;
    for (int i = 0; i < plot->curve_count; i++) {
        const TinkerCurve *curve = &plot->curves[i];
        double *y = curve->right ? second : left;
        const gboolean logarithmic = curve->right ? plot->right_logarithmic : plot->y_logarithmic;
        if (tinker_plot_can_index(curve, plot->x_logarithmic, logarithmic)) {
            add_extremes(curve, x, y);
        } else {
            add_values(curve->x, curve->count, plot->x_logarithmic, x);
            add_values(curve->y, curve->count, logarithmic, y);
        }
        add_values(curve->low, curve->count, logarithmic, y);
        add_values(curve->high, curve->count, logarithmic, y);
        layout->has_second = layout->has_second || curve->right;
        layout->with_marks = layout->with_marks || tinker_plot_has_markers(curve);
    }
    if (plot->x_range) memcpy(x, plot->x_range, sizeof layout->x_range);
    if (plot->y_range) memcpy(left, plot->y_range, sizeof layout->y_range);
    if (plot->right_range) memcpy(second, plot->right_range, sizeof layout->second_range);
    layout->x.logarithmic = plot->x_logarithmic;
    layout->y.logarithmic = plot->y_logarithmic;
    layout->second.logarithmic = plot->right_logarithmic;
}

static void set_ranges(TinkerPlotLayout *layout)
{
    const TinkerPlot *plot = layout->plot;
    const double *x = layout->x_range, *y = layout->y_range;
    tinker_axis_set_range(&layout->x, x[0], x[1], layout->with_marks && !plot->x_range ? X_MARGIN : 0);
    tinker_axis_set_range(&layout->y, y[0], y[1], plot->y_range ? 0 : Y_MARGIN);
    if (layout->has_second)
        tinker_axis_set_range(&layout->second, layout->second_range[0], layout->second_range[1],
                              plot->right_range ? 0 : Y_MARGIN);
}

static gboolean has_text(const TinkerPlotLayout *layout)
{
    return fmin(layout->width, layout->height) >= LEAST_FOR_TEXT;
}

/* Width and height of the largest tick label. */
static void measure_labels(TinkerPlotLayout *layout, const TinkerAxis *axis, double *width, double *height)
{
    *width = *height = 0;
    for (int i = 0; i < axis->tick_count; i++) {
        double w, h;
        TinkerText text = {.text = axis->labels[i], .size = layout->sizes->tick_text};
        tinker_text_measure(layout->pen, &text, &w, &h);
        *width = fmax(*width, w);
        *height = fmax(*height, h);
    }
}

static double text_height(TinkerPlotLayout *layout, const char *words, double size, gboolean bold, double limit,
                          int lines)
{
    if (!words || !*words) return 0;
    double width, height;
    TinkerText text = {.text = words, .size = size, .bold = bold, .limit = limit, .lines = lines, .anchor_x = 0.5};
    tinker_text_measure(layout->pen, &text, &width, &height);
    return height;
}

static void set_axes(TinkerPlotLayout *layout)
{
    layout->x.start = layout->left;
    layout->x.length = layout->right - layout->left;
    layout->y.start = layout->bottom;
    layout->y.length = layout->top - layout->bottom;
    layout->second.start = layout->y.start;
    layout->second.length = layout->y.length;
}

/* Takes away the labels that would touch the one before, where even the fewest ticks are too many. */
static void thin_labels(TinkerAxis *axis, double size)
{
    double last = -INFINITY;
    for (int i = 0; i < axis->tick_count; i++) {
        double place = fabs((axis->ticks[i] - axis->low) / (axis->high - axis->low) * axis->length);
        if (place - last < size)
            axis->labels[i][0] = '\0';
        else
            last = place;
    }
}

/* Fewer ticks until their labels stand apart. */
static void choose_x_ticks(TinkerPlotLayout *layout)
{
    double room = layout->right - layout->left, width = 0, height;
    int most = (int)CLAMP(room / layout->sizes->column, 2, 11);
    for (; most >= 2; most--) {
        tinker_axis_choose_ticks(&layout->x, most, layout->plot->x_label);
        measure_labels(layout, &layout->x, &width, &height);
        double closest = INFINITY;
        for (int i = 1; i < layout->x.tick_count; i++)
            closest = fmin(closest, (layout->x.ticks[i] - layout->x.ticks[i - 1]) / (layout->x.high - layout->x.low));
        if (closest * room >= width + layout->sizes->label_room) return;
    }
    thin_labels(&layout->x, width + 2);
}

static void choose_y_ticks(TinkerPlotLayout *layout, TinkerAxis *axis, const char *label)
{
    int most = (int)CLAMP((layout->bottom - layout->top) / layout->sizes->row, 2, 12);
    double width, height;
    tinker_axis_choose_ticks(axis, most, label);
    measure_labels(layout, axis, &width, &height);
    thin_labels(axis, height + 1);
}

/* What the second axis needs beside the curves. */
static double room_at_right(TinkerPlotLayout *layout)
{
    double width = 0, height = 0;
    if (!layout->has_second) return 0;
    measure_labels(layout, &layout->second, &width, &height);
    double title = text_height(layout, layout->second.title, layout->sizes->text, FALSE, 0, 1);
    return layout->sizes->pad + (title > 0 ? title + layout->sizes->pad : 0) + width + layout->sizes->tick_gap;
}

/* Margins from what has to stand in them; `aside` and `above` are what a legend takes at the right and at the top. */
static void set_margins(TinkerPlotLayout *layout, double aside, double above)
{
    const TinkerPlotSizes *sizes = layout->sizes;
    double x_width = 0, x_height = 0, y_width = 0, y_height = 0;
    measure_labels(layout, &layout->x, &x_width, &x_height);
    measure_labels(layout, &layout->y, &y_width, &y_height);
    double title = text_height(layout, layout->plot->title, sizes->title, TRUE, layout->width - 2 * sizes->pad, 2);
    double x_title = text_height(layout, layout->x.title, sizes->text, FALSE, 0, 1);
    double y_title = text_height(layout, layout->y.title, sizes->text, FALSE, 0, 1);
    layout->left = sizes->pad + (y_title > 0 ? y_title + sizes->pad : 0) + y_width + sizes->tick_gap;
    layout->right =
        layout->width - aside - fmax(fmax(x_width / 2 + 2, sizes->pad) + sizes->pad / 2, room_at_right(layout));
    layout->top = (title > 0 ? sizes->pad + title : 0) + fmax(y_height / 2, sizes->pad) + 2 + above;
    layout->bottom =
        layout->height - sizes->pad - (x_title > 0 ? x_title + sizes->pad / 2 : 0) - x_height - sizes->tick_gap;
    /* What is too small for its margins keeps half of itself for the curves. */
    if (layout->right - layout->left < 0.4 * layout->width) {
        layout->left = fmin(layout->left, 0.5 * layout->width);
        layout->right = fmin(fmax(layout->right, layout->left + 0.4 * layout->width), layout->width - 1);
    }
    if (layout->bottom - layout->top < 0.3 * layout->height) {
        layout->top = fmin(layout->top, 0.4 * layout->height);
        layout->bottom = fmin(fmax(layout->bottom, layout->top + 0.3 * layout->height), layout->height - 1);
    }
}

/* The axis whose data take fewer units per length is widened. */
static void equalise(TinkerPlotLayout *layout)
{
    if (!layout->plot->equal_scales || layout->x.logarithmic || layout->y.logarithmic) return;
    double across = layout->right - layout->left, up = layout->bottom - layout->top;
    double unit = fmax((layout->x.high - layout->x.low) / across, (layout->y.high - layout->y.low) / up);
    double more_x = unit * across - (layout->x.high - layout->x.low);
    double more_y = unit * up - (layout->y.high - layout->y.low);
    layout->x.low -= more_x / 2;
    layout->x.high += more_x / 2;
    layout->y.low -= more_y / 2;
    layout->y.high += more_y / 2;
}

static void arrange(TinkerPlotLayout *layout, double aside, double above)
{
    for (int round = 0; round < 3; round++) {
        if (has_text(layout)) set_margins(layout, aside, above);
        set_ranges(layout);
        equalise(layout);
        set_axes(layout);
        choose_y_ticks(layout, &layout->y, layout->plot->y_label);
        if (layout->has_second) choose_y_ticks(layout, &layout->second, layout->plot->right_label);
        choose_x_ticks(layout);
    }
}

static TinkerPlotSizes enlarged(const TinkerPlotSizes *sizes, double by)
{
    return (TinkerPlotSizes){.text = by * sizes->text,
                             .title = by * sizes->title,
                             .tick_text = by * sizes->tick_text,
                             .pad = by * sizes->pad,
                             .tick_gap = by * sizes->tick_gap,
                             .label_room = by * sizes->label_room,
                             .column = by * sizes->column,
                             .row = by * sizes->row,
                             .legend_row = by * sizes->legend_row,
                             .legend_sample = by * sizes->legend_sample,
                             .legend_inset = by * sizes->legend_inset};
}

/* The curves give way for a legend that stands beside or above them, and then it is known where. */
static void give_way(TinkerPlotLayout *layout)
{
    TinkerLegend *legend = &layout->legend;
    const double width = legend->box[2] - legend->box[0], height = legend->box[3] - legend->box[1];
    const double pad = layout->sizes->pad;
    if (legend->kind == TINKER_LEGEND_OUTSIDE) {
        arrange(layout, width + pad, 0);
        legend->box[0] = layout->width - width - pad;
        legend->box[1] = layout->top;
    } else if (legend->kind == TINKER_LEGEND_ABOVE) {
        arrange(layout, 0, height + 2);
        legend->box[0] = fmin(layout->left, layout->width - pad - width);
        legend->box[1] = layout->top - 2 - height;
    } else {
        return;
    }
    legend->box[2] = legend->box[0] + width;
    legend->box[3] = legend->box[1] + height;
}

void tinker_plot_lay_out(TinkerPlotLayout *layout, const TinkerPlot *plot, TinkerTextPen *pen, double width,
                         double height)
{
    memset(layout, 0, sizeof *layout);
    layout->plot = plot;
    layout->theme = plot->theme ? plot->theme : tinker_theme_find("light");
    layout->own_sizes =
        enlarged(plot->compact ? &compact_sizes : &ordinary_sizes, plot->enlargement > 0 ? plot->enlargement : 1);
    layout->sizes = &layout->own_sizes;
    layout->pen = pen;
    layout->width = fmax(width, 4);
    layout->height = fmax(height, 4);
    layout->left = layout->top = 1;
    layout->right = layout->width - 1;
    layout->bottom = layout->height - 1;
    find_ranges(layout);
    arrange(layout, 0, 0);
    if (!has_text(layout)) return;
    tinker_plot_place_legend(layout);
    give_way(layout);
}

void tinker_plot_layout_clear(TinkerPlotLayout *layout)
{
    tinker_axis_clear(&layout->x);
    tinker_axis_clear(&layout->y);
    tinker_axis_clear(&layout->second);
}
