#include "gui/instrument/measure-drawing.h"

#include <math.h>

#include "gui/widget/desktop-theme.h"

#define RADIUS 3.5
#define ARC    34.0 /* widget units: of an angle */
#define INNER  5.0

/* A text on a ground of its own about a place, all of it on the canvas. */
static void draw_text(GtkWidget *widget, cairo_t *cairo, PangoLayout *layout, const double at[2],
                      const TinkerTheme *theme)
{
    const double *ground = theme->background, *colour = theme->colours[TINKER_COLOUR_TEXT];
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    const double most_left = gtk_widget_get_width(widget) - width - INNER;
    const double left = CLAMP(at[0] - width / 2.0, INNER, fmax(most_left, INNER));
    const double lowest = gtk_widget_get_height(widget) - height - INNER;
    const double top = CLAMP(at[1] - height / 2.0, INNER, fmax(lowest, INNER));
    cairo_rectangle(cairo, left - INNER, top - INNER / 2, width + 2 * INNER, height + INNER);
    cairo_set_source_rgba(cairo, ground[0], ground[1], ground[2], 0.9);
    cairo_fill(cairo);
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    cairo_move_to(cairo, left, top);
    pango_cairo_show_layout(cairo, layout);
}

/* Where the first leg points (rad, on the canvas), and from it the shorter way to the second. */
static void find_turn(double at[3][2], double *from, double *turn)
{
    *from = atan2(at[1][1] - at[0][1], at[1][0] - at[0][0]);
    *turn = remainder(atan2(at[2][1] - at[0][1], at[2][0] - at[0][0]) - *from, 2 * G_PI);
}

/* The middle of the text: of a distance that of its line, as on a drawing, or above a line that it would cover; of an
 * angle beyond the arc, between the legs. */
static void place_text(const TinkerMeasuring *measuring, double at[3][2], PangoLayout *layout, double middle[2])
{
    const double dx = at[1][0] - at[0][0], dy = at[1][1] - at[0][1];
    int width, height;
    pango_layout_get_pixel_size(layout, &width, &height);
    middle[0] = at[0][0] + dx / 2;
    middle[1] = at[0][1] + dy / 2;
    if (measuring->kind == TINKER_RULER) {
        const gboolean fits = fabs(dx) > width + 6 * INNER || fabs(dy) > height + 6 * INNER;
        if (!fits) middle[1] = fmin(at[0][1], at[1][1]) - height / 2.0 - 3 * INNER;
        return;
    }
    double from, turn;
    find_turn(at, &from, &turn);
    const double along[2] = {cos(from + turn / 2), sin(from + turn / 2)};
    const double off = ARC + INNER + hypot(width, height) / 2;
    for (int k = 0; k < 2; k++)
        middle[k] = at[0][k] + off * along[k];
}

/* From the first leg to the second, the shorter way. */
static void draw_arc(cairo_t *cairo, double at[3][2])
{
    double from, turn;
    find_turn(at, &from, &turn);
    cairo_new_sub_path(cairo);
    if (turn > 0)
        cairo_arc(cairo, at[0][0], at[0][1], ARC, from, from + turn);
    else
        cairo_arc_negative(cairo, at[0][0], at[0][1], ARC, from, from + turn);
}

void tinker_measuring_draw(const TinkerMeasuring *measuring, TinkerFrame *frame, const TinkerView *view,
                           GtkWidget *widget, cairo_t *cairo)
{
    const TinkerTheme *theme = tinker_desktop_theme();
    const double *colour = theme->colours[TINKER_COLOUR_SELECTED];
    double at[3][2];
    if (measuring->count == 0) return;
    for (int i = 0; i < measuring->count; i++) {
        double world[2];
        tinker_frame_end(frame, measuring->ends[i], world);
        tinker_view_to_canvas(view, world[0], world[1], &at[i][0], &at[i][1]);
    }
    cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
    cairo_set_line_width(cairo, 2);
    for (int i = 1; i < measuring->count; i++) {
        cairo_move_to(cairo, at[0][0], at[0][1]);
        cairo_line_to(cairo, at[i][0], at[i][1]);
    }
    if (measuring->count == 3) draw_arc(cairo, at);
    cairo_stroke(cairo);
    for (int i = 0; i < measuring->count; i++) {
        cairo_arc(cairo, at[i][0], at[i][1], RADIUS, 0, 2 * G_PI);
        cairo_fill(cairo);
    }
    g_autofree char *text = tinker_measuring_text(measuring, frame, FALSE);
    if (text == NULL) return;
    g_autoptr(PangoLayout) layout = gtk_widget_create_pango_layout(widget, text);
    double middle[2];
    place_text(measuring, at, layout, middle);
    draw_text(widget, cairo, layout, middle, theme);
}
