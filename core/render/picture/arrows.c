/* Arrows are drawn with the helper that blocks draw theirs with, each first with a halo of the background, so that it
 * stands out from what it lies over. */
#include "render/picture/arrows-private.h"

#include <math.h>
#include <string.h>

#include "render/picture/arrows-diagram-private.h"

/* Canvas units. */
#define SYMBOL    14.0 /* what heads are measured by */
#define BREAK     5.0  /* half the width of the gap in a broken shaft */
#define BREAK_ARM 5.0  /* half the length of the strokes at its ends */
#define RING      3.0  /* its radius */

#define HEAD_SHARE  0.8 /* symbols are no larger than this share of the arrow's length */
#define FADED_ALPHA 0.3

/* Two slanted strokes with a gap between them, across the middle of the shaft. */
static void draw_break(const ArrowDiagram *diagram, const ArrowShaft *shaft)
{
    const double *ground = diagram->options->theme->background, *colour = arrows_colour_of(diagram, shaft);
    const double unit = 1 / diagram->view->scale, length = hypot(shaft->x2 - shaft->x1, shaft->y2 - shaft->y1);
    const double ux = (shaft->x2 - shaft->x1) / length, uy = (shaft->y2 - shaft->y1) / length;
    const double middle[] = {(shaft->x1 + shaft->x2) / 2, (shaft->y1 + shaft->y2) / 2};
    const double arm[] = {BREAK_ARM * unit * (0.5 * ux - uy), BREAK_ARM * unit * (0.5 * uy + ux)};
    cairo_t *cairo = diagram->cairo;
    for (int pass = 0; pass < 2; pass++) {
        const double *ink = pass == 0 ? ground : colour;
        for (int side = -1; side <= 1; side += 2) {
            const double x = middle[0] + side * BREAK / 2 * unit * ux, y = middle[1] + side * BREAK / 2 * unit * uy;
            cairo_move_to(cairo, x - arm[0], y - arm[1]);
            cairo_line_to(cairo, x + arm[0], y + arm[1]);
        }
        cairo_set_source_rgba(cairo, ink[0], ink[1], ink[2], ink[3]);
        cairo_set_line_width(cairo, (pass == 0 ? 1.5 * BREAK : 1.6) * unit);
        cairo_stroke(cairo);
    }
}

static void draw_ring(const ArrowDiagram *diagram, const ArrowShaft *shaft)
{
    const double *ground = diagram->options->theme->background, *colour = arrows_colour_of(diagram, shaft);
    cairo_t *cairo = diagram->cairo;
    cairo_arc(cairo, shaft->x1, shaft->y1, RING / diagram->view->scale, 0, 2 * G_PI);
    cairo_set_source_rgba(cairo, ground[0], ground[1], ground[2], ground[3]);
    cairo_fill_preserve(cairo);
    cairo_set_source_rgba(cairo, colour[0], colour[1], colour[2], colour[3]);
    cairo_set_line_width(cairo, 1.6 / diagram->view->scale);
    cairo_stroke(cairo);
}

/* What is not looked at has little of its colour. */
static void set_shaft_colour(const ArrowDiagram *diagram, const ArrowShaft *shaft, TinkerStyle *style)
{
    const double *colour = arrows_colour_of(diagram, shaft), *ground = diagram->options->theme->background;
    const double share = shaft->arrow->look & TINKER_ARROW_FADED ? FADED_ALPHA : 1;
    double *to = style->colours[TINKER_COLOUR_FORCE];
    for (int k = 0; k < 3; k++)
        to[k] = ground[k] + share * (colour[k] - ground[k]);
    to[3] = colour[3];
}

static void draw_shafts(ArrowDiagram *diagram, gboolean halo)
{
    TinkerStyle style = diagram->brush.style;
    const TinkerTheme *theme = diagram->options->theme;
    style.state = halo ? TINKER_STATE_HIGHLIGHTED : 0;
    memcpy(style.colours[TINKER_COLOUR_HIGHLIGHTED], theme->background, sizeof(theme->background));
    /* beneath all arrows, of which another may end where the ring is */
    for (guint i = 0; !halo && i < diagram->shafts->len; i++) {
        const ArrowShaft *shaft = &g_array_index(diagram->shafts, ArrowShaft, i);
        if (shaft->arrow->look & TINKER_ARROW_STUB) draw_ring(diagram, shaft);
    }
    for (guint i = 0; i < diagram->shafts->len; i++) {
        const ArrowShaft *shaft = &g_array_index(diagram->shafts, ArrowShaft, i);
        set_shaft_colour(diagram, shaft, &style);
        double length = hypot(shaft->x2 - shaft->x1, shaft->y2 - shaft->y1);
        style.symbol_size = fmin(diagram->brush.style.symbol_size, HEAD_SHARE * length);
        style.arrow(&style, diagram->cairo, TINKER_COLOUR_FORCE, shaft->x1, shaft->y1, shaft->x2, shaft->y2);
        if (!halo && (shaft->arrow->look & TINKER_ARROW_BROKEN)) draw_break(diagram, shaft);
    }
}

static void tell_places(const ArrowDiagram *diagram, const TinkerForceArrow *arrows, GArray *places)
{
    for (guint i = 0; i < diagram->shafts->len; i++) {
        const ArrowShaft *shaft = &g_array_index(diagram->shafts, ArrowShaft, i);
        TinkerArrowPlace place = {.number = (gsize)(shaft->arrow - arrows)};
        tinker_view_to_canvas(diagram->view, shaft->x1, shaft->y1, &place.shaft[0], &place.shaft[1]);
        tinker_view_to_canvas(diagram->view, shaft->x2, shaft->y2, &place.shaft[2], &place.shaft[3]);
        memcpy(place.label, shaft->label, sizeof place.label);
        g_array_append_val(places, place);
    }
}

void tinker_arrows_draw_noting(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                               const TinkerArrowOptions *options, GPtrArray *written)
{
    ArrowDiagram diagram = {.cairo = cairo, .view = view, .options = options};
    tinker_style_begin(&diagram.brush, cairo, options->theme, view, SYMBOL / view->scale);
    diagram.brush.pen.written = written;
    arrows_find_shafts(&diagram, arrows, count);
    tinker_style_enter_world(&diagram.brush.style, cairo);
    draw_shafts(&diagram, TRUE);
    draw_shafts(&diagram, FALSE);
    cairo_restore(cairo);
    cairo_save(cairo);
    arrows_write_labels(&diagram);
    cairo_restore(cairo);
    if (options->places != NULL) tell_places(&diagram, arrows, options->places);
    g_array_unref(diagram.shafts);
    tinker_style_end(&diagram.brush);
}

void tinker_arrows_draw(cairo_t *cairo, const TinkerView *view, const TinkerForceArrow *arrows, gsize count,
                        const TinkerArrowOptions *options)
{
    tinker_arrows_draw_noting(cairo, view, arrows, count, options, NULL);
}
