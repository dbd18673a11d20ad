/* What stands about the curves: grid, frame with ticks, texts. */
#include <math.h>

#include "render/plot/plot-private.h"

#define TICK_LENGTH     4.0
#define MOST_UNLABELLED 4 /* powers of ten from one label to the next, for lines at those between */

/* Middle of the pixel row that a line of width 1 fills. */
static double sharp(double place)
{
    return floor(place) + 0.5;
}

static double place_of_tick(const TinkerAxis *axis, double tick)
{
    return axis->start + (tick - axis->low) / (axis->high - axis->low) * axis->length;
}

/* Grid ------------------------------------------------------------------------------------------------------------- */

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

void tinker_plot_draw_grid(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    cairo_set_line_width(cairo, 1);
    tinker_plot_set_colour(cairo, layout->theme->grid, 0.55);
    draw_minor_grid(cairo, layout, &layout->x);
    draw_minor_grid(cairo, layout, &layout->y);
    cairo_stroke(cairo);
    tinker_plot_set_colour(cairo, layout->theme->grid, 1);
    for (int i = 0; i < layout->x.tick_count; i++)
        draw_grid_line(cairo, layout, &layout->x, layout->x.ticks[i]);
    for (int i = 0; i < layout->y.tick_count; i++)
        draw_grid_line(cairo, layout, &layout->y, layout->y.ticks[i]);
    cairo_stroke(cairo);
    /* The line of y = 0, where curves go to both sides of it. */
    if (!layout->y.logarithmic && layout->y.low < 0 && layout->y.high > 0) {
        tinker_plot_set_colour(cairo, layout->theme->axis, 0.45);
        draw_grid_line(cairo, layout, &layout->y, 0);
        cairo_stroke(cairo);
    }
}

/* Frame and texts -------------------------------------------------------------------------------------------------- */

void tinker_plot_draw_frame(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    double left = sharp(layout->left), top = sharp(layout->top);
    double right = sharp(layout->right), bottom = sharp(layout->bottom);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_MITER);
    cairo_set_line_width(cairo, 1);
    tinker_plot_set_colour(cairo, layout->theme->axis, 1);
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

void tinker_plot_draw_texts(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    tinker_plot_set_colour(cairo, layout->theme->colours[TINKER_COLOUR_TEXT], 1);
    draw_tick_labels(cairo, layout);
    const double top = draw_title(cairo, layout);
    draw_axis_titles(cairo, layout, top);
    draw_second_title(cairo, layout, top);
}

void tinker_plot_draw_no_data(cairo_t *cairo, const TinkerPlotLayout *layout)
{
    TinkerText text = {.text = "no data", .size = layout->sizes->title, .anchor_x = 0.5, .anchor_y = 0.5};
    tinker_plot_set_colour(cairo, layout->theme->colours[TINKER_COLOUR_DETACHED], 1);
    tinker_text_draw(layout->pen, cairo, &text, (layout->left + layout->right) / 2, (layout->top + layout->bottom) / 2);
}
