/* What lies over the curves of a graph while it is worked at. */
#include <math.h>

#include "gui/graph/graph-plot-private.h"

#define INNER  5.0 /* widget units: between a text and its box */
#define RADIUS 3.5

#define NO_BREAK "\u00a0" /* a blank at which no line ends */

static void set_colour(cairo_t *cairo, const double colour[4], double share)
{
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], share * colour[3]);
}

/* A text on a ground of its own; (x, y) is its middle at the bottom. It stays between the sides. */
static void draw_text(TinkerGraphPlot *plot, cairo_t *cairo, const char *text, double x, double y)
{
    const TinkerTheme *theme = plot->picture.theme;
    g_autoptr(PangoLayout) layout = gtk_widget_create_pango_layout(GTK_WIDGET(plot), text);
    g_autoptr(PangoAttrList) attributes = pango_attr_list_new();
    int width, height;
    pango_attr_list_insert(attributes, pango_attr_scale_new(PANGO_SCALE_SMALL));
    pango_layout_set_attributes(layout, attributes);
    pango_layout_set_width(layout, MAX(plot->picture.width - 4 * (int)INNER, 1) * PANGO_SCALE);
    pango_layout_get_pixel_size(layout, &width, &height);
    const double across = width + 2 * INNER, down = height + INNER;
    const double left = floor(CLAMP(x - across / 2, 1, fmax(plot->picture.width - across - 1, 1)));
    const double top = floor(fmax(y - down, 1));
    cairo_rectangle(cairo, left + 0.5, top + 0.5, across, down);
    set_colour(cairo, theme->background, 0.92);
    cairo_fill_preserve(cairo);
    set_colour(cairo, theme->axis, 0.6);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
    set_colour(cairo, theme->colours[TINKER_COLOUR_TEXT], 1);
    cairo_move_to(cairo, left + INNER, top + INNER / 2);
    pango_cairo_show_layout(cairo, layout);
}

static void draw_box(TinkerGraphPlot *plot, cairo_t *cairo)
{
    const TinkerPlotGeometry *at = &plot->geometry;
    const TinkerGraphAxes axes = tinker_graph_box_axes(plot);
    if (plot->drag != TINKER_GRAPH_BOX || axes == 0) return;
    double left = fmin(plot->drag_start[0], plot->drag_now[0]), right = fmax(plot->drag_start[0], plot->drag_now[0]);
    double top = fmin(plot->drag_start[1], plot->drag_now[1]), bottom = fmax(plot->drag_start[1], plot->drag_now[1]);
    if (!(axes & TINKER_GRAPH_X)) {
        left = at->left;
        right = at->right;
    }
    if (!(axes & TINKER_GRAPH_UP)) {
        top = at->top;
        bottom = at->bottom;
    }
    cairo_rectangle(cairo, floor(left) + 0.5, floor(top) + 0.5, right - left, bottom - top);
    set_colour(cairo, plot->picture.theme->curves[0], 0.15);
    cairo_fill_preserve(cairo);
    set_colour(cairo, plot->picture.theme->curves[0], 0.9);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
}

static void draw_cursor(TinkerGraphPlot *plot, cairo_t *cairo, int number)
{
    static const double dashes[2] = {4, 3};
    static const char *const letters[] = {"A", "B"};
    const TinkerPlotGeometry *at = &plot->geometry;
    const TinkerGraphReading *cursor = &plot->cursors[number];
    const gboolean right = tinker_graph_series_is_right(tinker_graph_data_curve(plot->data, cursor->curve));
    const double x = tinker_plot_scale_place(&at->x, cursor->at[0]);
    const double y = tinker_plot_scale_place(right ? &at->second : &at->y, cursor->at[1]);
    if (!(x >= at->left - 0.5 && x <= at->right + 0.5)) return;
    set_colour(cairo, plot->picture.theme->colours[TINKER_COLOUR_TEXT], 0.8);
    cairo_set_line_width(cairo, 1);
    cairo_set_dash(cairo, dashes, 2, 0);
    cairo_move_to(cairo, floor(x) + 0.5, at->top);
    cairo_line_to(cairo, floor(x) + 0.5, at->bottom);
    cairo_stroke(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
    if (y >= at->top && y <= at->bottom) {
        cairo_arc(cairo, x, y, RADIUS, 0, 2 * G_PI);
        cairo_fill(cairo);
    }
    draw_text(plot, cairo, letters[number], x, at->top + 3 * INNER);
}

/* What the cursors say, which may be broken between its parts, but not within one. (transfer full) */
static char *cursor_text_in_parts(TinkerGraphPlot *plot)
{
    g_autofree char *text = tinker_graph_plot_cursor_text(plot);
    if (text == NULL) return NULL;
    GString *parts = g_string_new(text);
    g_string_replace(parts, " ", NO_BREAK, 0);
    g_string_replace(parts, "," NO_BREAK, ", ", 0);
    return g_string_free(parts, FALSE);
}

void tinker_graph_plot_draw_marks(TinkerGraphPlot *plot, cairo_t *cairo)
{
    g_autofree char *text = cursor_text_in_parts(plot);
    for (int i = 0; i < plot->cursor_count; i++)
        draw_cursor(plot, cairo, i);
    if (text != NULL)
        draw_text(plot, cairo, text, (plot->geometry.left + plot->geometry.right) / 2, plot->geometry.bottom - INNER);
    draw_box(plot, cairo);
}
