/* The plot's ink: ground, grid, bands, curves, frame and ticks, legend, cursor, texts, reading, in this order. */
#include "render/plot/plot.h"

#include <math.h>

#include "render/draw/paint-memory-content.h"
#include "render/draw/surface.h"
#include "render/plot/plot-private.h"

#define TICK_LENGTH     4.0
#define MOST_UNLABELLED 4   /* powers of ten from one label to the next, for lines at those between */
#define FINEST          0.5 /* device pixels: width of the columns that curves are thinned to */
#define COARSE          1.0 /* likewise where it has to be quick */

static void set_colour(cairo_t *cairo, const double colour[4], double share)
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], share * colour[3]);
}

/* Middle of the pixel row that a line of width 1 fills. */
static double sharp(double place)
{
    return floor(place) + 0.5;
}

static double place_of_tick(const TinkerAxis *axis, double tick)
{
    return axis->start + (tick - axis->low) / (axis->high - axis->low) * axis->length;
}

/* Grid
 * ----------------------------------------------------------------------------------------------------------------- */

static void draw_grid_line(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerAxis *axis, double tick)
{
    double place = sharp(place_of_tick(axis, tick));
    gboolean upright = axis == &layout->x;
    cairo_move_to(cairo, upright ? place : layout->left, upright ? layout->bottom : place);
    cairo_line_to(cairo, upright ? place : layout->right, upright ? layout->top : place);
}

/* The lines at 2 to 9 times each power of ten; where not every power has a label, those at the others. */
static void draw_minor_grid(cairo_t *cairo, const TinkerPlotLayout *layout, const TinkerAxis *axis)
{
    if (axis->decade_stride == 0 || axis->decade_stride > MOST_UNLABELLED) return;
    int digits = axis->decade_stride == 1 ? 9 : 1;
    for (double decade = floor(axis->low); decade <= axis->high; decade++)
        for (int digit = digits > 1 ? 2 : 1; digit <= digits; digit++) {
            double tick = decade + log10(digit);
            if (tick >= axis->low && tick <= axis->high) draw_grid_line(cairo, layout, axis, tick);
        }
}

static void draw_grid(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    cairo_set_line_width(cairo, 1);
    set_colour(cairo, layout->theme->grid, 0.55);
    draw_minor_grid(cairo, layout, &layout->x);
    draw_minor_grid(cairo, layout, &layout->y);
    cairo_stroke(cairo);
    set_colour(cairo, layout->theme->grid, 1);
    for (int i = 0; i < layout->x.tick_count; i++)
        draw_grid_line(cairo, layout, &layout->x, layout->x.ticks[i]);
    for (int i = 0; i < layout->y.tick_count; i++)
        draw_grid_line(cairo, layout, &layout->y, layout->y.ticks[i]);
    cairo_stroke(cairo);
    /* The line of y = 0, where curves go to both sides of it. */
    if (!layout->y.logarithmic && layout->y.low < 0 && layout->y.high > 0) {
        set_colour(cairo, layout->theme->axis, 0.45);
        draw_grid_line(cairo, layout, &layout->y, 0);
        cairo_stroke(cairo);
    }
}

/* Frame and texts
 * ------------------------------------------------------------------------------------------------------ */

static void draw_frame(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    double left = sharp(layout->left), top = sharp(layout->top);
    double right = sharp(layout->right), bottom = sharp(layout->bottom);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_MITER);
    cairo_set_line_width(cairo, 1);
    set_colour(cairo, layout->theme->axis, 1);
    cairo_rectangle(cairo, left, top, right - left, bottom - top);
    for (int i = 0; i < layout->x.tick_count; i++) {
        double x = sharp(place_of_tick(&layout->x, layout->x.ticks[i]));
        cairo_move_to(cairo, x, bottom);
        cairo_line_to(cairo, x, bottom - TICK_LENGTH);
    }
    for (int i = 0; i < layout->y.tick_count; i++) {
        double y = sharp(place_of_tick(&layout->y, layout->y.ticks[i]));
        cairo_move_to(cairo, left, y);
        cairo_line_to(cairo, left + TICK_LENGTH, y);
    }
    for (int i = 0; i < layout->second.tick_count; i++) {
        double y = sharp(place_of_tick(&layout->second, layout->second.ticks[i]));
        cairo_move_to(cairo, right, y);
        cairo_line_to(cairo, right - TICK_LENGTH, y);
    }
    cairo_stroke(cairo);
}

static void draw_tick_labels(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    TinkerText text = {.size = layout->sizes->tick_text, .anchor_x = 0.5};
    for (int i = 0; i < layout->x.tick_count; i++) {
        text.text = layout->x.labels[i];
        double x = place_of_tick(&layout->x, layout->x.ticks[i]);
        tinker_text_draw(layout->pen, cairo, &text, x, layout->bottom + layout->sizes->tick_gap);
    }
    text.anchor_x = 1;
    text.anchor_y = 0.5;
    for (int i = 0; i < layout->y.tick_count; i++) {
        text.text = layout->y.labels[i];
        double y = place_of_tick(&layout->y, layout->y.ticks[i]);
        tinker_text_draw(layout->pen, cairo, &text, layout->left - layout->sizes->tick_gap, y);
    }
    text.anchor_x = 0;
    for (int i = 0; i < layout->second.tick_count; i++) {
        text.text = layout->second.labels[i];
        double y = place_of_tick(&layout->second, layout->second.ticks[i]);
        tinker_text_draw(layout->pen, cairo, &text, layout->right + layout->sizes->tick_gap, y);
    }
}

/* Where a centred text of this width stands that is wished in the middle and has to stay between two borders. */
static double held_between(double middle, double width, double from, double to)
{
    return fmax(fmin(middle, to - width / 2), from + width / 2);
}

/* The title, over the middle of the curves where it is short enough for that. Answers where it ends. */
static double draw_title(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    TinkerText title = {.text = layout->plot->title,
                        .size = layout->sizes->title,
                        .bold = TRUE,
                        .limit = layout->width - 2 * layout->sizes->pad,
                        .lines = 2,
                        .anchor_x = 0.5};
    double width, height, middle = (layout->left + layout->right) / 2;
    if (!title.text || !*title.text) return 0;
    tinker_text_measure(layout->pen, &title, &width, &height);
    tinker_text_draw(layout->pen, cairo, &title,
                     held_between(middle, width, layout->sizes->pad, layout->width - layout->sizes->pad),
                     layout->sizes->pad);
    return layout->sizes->pad + height;
}

static void draw_axis_titles(cairo_t *cairo, const TinkerPlotLayout *layout, double top)
{
    double width, height, middle = (layout->left + layout->right) / 2, centre = (layout->top + layout->bottom) / 2;
    double right = layout->width - layout->sizes->pad, bottom = layout->height - layout->sizes->pad;
    TinkerText across = {.text = layout->x.title,
                         .size = layout->sizes->text,
                         .limit = fmax(right - layout->left, layout->sizes->pad),
                         .anchor_x = 0.5,
                         .anchor_y = 1};
    tinker_text_measure(layout->pen, &across, &width, &height);
    tinker_text_draw(layout->pen, cairo, &across, held_between(middle, width, layout->left, right), bottom);
    TinkerText up = {.text = layout->y.title,
                     .size = layout->sizes->text,
                     .limit = fmax(bottom - top - layout->sizes->pad / 2, layout->sizes->pad),
                     .angle = -G_PI / 2,
                     .anchor_x = 0.5};
    tinker_text_measure(layout->pen, &up, &width, &height);
    tinker_text_draw(layout->pen, cairo, &up, layout->sizes->pad,
                     held_between(centre, width, top + layout->sizes->pad / 2, bottom));
}

/* Beside its labels, since a legend may stand farther out. */
static void draw_second_title(cairo_t *cairo, const TinkerPlotLayout *layout, double top)
{
    double width, height, labels = 0, bottom = layout->height - layout->sizes->pad;
    if (!layout->has_second || layout->second.title == NULL) return;
    for (int i = 0; i < layout->second.tick_count; i++) {
        TinkerText label = {.text = layout->second.labels[i], .size = layout->sizes->tick_text};
        tinker_text_measure(layout->pen, &label, &width, &height);
        labels = fmax(labels, width);
    }
    TinkerText up = {.text = layout->second.title,
                     .size = layout->sizes->text,
                     .limit = fmax(bottom - top - layout->sizes->pad / 2, layout->sizes->pad),
                     .angle = -G_PI / 2,
                     .anchor_x = 0.5};
    tinker_text_measure(layout->pen, &up, &width, &height);
    tinker_text_draw(layout->pen, cairo, &up, layout->right + layout->sizes->tick_gap + labels + layout->sizes->pad / 2,
                     held_between((layout->top + layout->bottom) / 2, width, top + layout->sizes->pad / 2, bottom));
}

static void draw_texts(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    set_colour(cairo, layout->theme->colours[TINKER_COLOUR_TEXT], 1);
    draw_tick_labels(cairo, layout);
    const double top = draw_title(cairo, layout);
    draw_axis_titles(cairo, layout, top);
    draw_second_title(cairo, layout, top);
}

static void draw_no_data(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    TinkerText text = {.text = "no data", .size = layout->sizes->title, .anchor_x = 0.5, .anchor_y = 0.5};
    set_colour(cairo, layout->theme->colours[TINKER_COLOUR_DETACHED], 1);
    tinker_text_draw(layout->pen, cairo, &text, (layout->left + layout->right) / 2, (layout->top + layout->bottom) / 2);
}

/* Curves
 * --------------------------------------------------------------------------------------------------------------- */

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
    set_colour(cairo, layout.theme->background, 1);
    cairo_rectangle(cairo, 0, 0, width, height);
    cairo_fill(cairo);
    draw_grid(cairo, &layout);
    draw_frame(cairo, &layout);
    const gboolean empty = layout.x.empty || (layout.y.empty && (!layout.has_second || layout.second.empty));
    if (empty) {
        if (has_text) draw_no_data(cairo, &layout);
    } else {
        draw_curves(cairo, &layout);
        tinker_plot_draw_legend(cairo, &layout);
        tinker_plot_draw_cursor(cairo, &layout);
    }
    if (has_text) draw_texts(cairo, &layout);
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
