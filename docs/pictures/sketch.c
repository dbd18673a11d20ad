/* The brush is that of scenes, so that drawings look as those do. */
#include "sketch.h"

#include <math.h>

#define LETTER 0.17 /* m: height of notes */
#define STROKE 0.06 /* m: half of those across the ends of a length */

void sketch_note(const Sketch *s, int colour, double x, double y, const char *text)
{
    s->style->note(s->style, s->cairo, colour, x, y, LETTER, text);
}

void sketch_arrow(const Sketch *s, int colour, double x, double y, double dx, double dy)
{
    s->style->arrow(s->style, s->cairo, colour, x, y, x + dx, y + dy);
}

void sketch_line(const Sketch *s, int colour, double x1, double y1, double x2, double y2)
{
    s->style->line(s->style, s->cairo, colour, x1, y1, x2, y2);
}

void sketch_dashed(const Sketch *s, double x1, double y1, double x2, double y2)
{
    static const double dash[] = {0.05, 0.04};
    cairo_save(s->cairo);
    cairo_set_dash(s->cairo, dash, 2, 0.0);
    cairo_move_to(s->cairo, x1, y1);
    cairo_line_to(s->cairo, x2, y2);
    cairo_set_line_width(s->cairo, 0.01);
    cairo_set_source_rgb(s->cairo, 0.45, 0.45, 0.45);
    cairo_stroke(s->cairo);
    cairo_restore(s->cairo);
}

void sketch_dot(const Sketch *s, int colour, double x, double y)
{
    s->style->circle(s->style, s->cairo, colour, -1, x, y, 0.045);
}

void sketch_disc(const Sketch *s, double x, double y, double radius)
{
    s->style->circle(s->style, s->cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, x, y, radius);
}

/* A box about a point, turned counter-clockwise (rad). */
void sketch_box(const Sketch *s, double x, double y, double width, double height, double turned)
{
    s->style->box(s->style, s->cairo, TINKER_COLOUR_BODY, TINKER_COLOUR_BODY_EDGE, x, y, width, height, turned);
}

/* The slab of a support, whose top goes from (x, y) so far along the angle. */
void sketch_slab(const Sketch *s, double x, double y, double length, double angle)
{
    const double c = cos(angle), sn = sin(angle), thick = 0.3;
    const double corners[] = {x,
                              y,
                              x + length * c,
                              y + length * sn,
                              x + length * c + thick * sn,
                              y + length * sn - thick * c,
                              x + thick * sn,
                              y - thick * c};
    s->style->polygon(s->style, s->cairo, TINKER_COLOUR_SUPPORT, -1, corners, 4);
    s->style->hatch(s->style, s->cairo, TINKER_COLOUR_BODY_EDGE, x, y, x + length * c, y + length * sn);
    sketch_line(s, TINKER_COLOUR_BODY_EDGE, x, y, x + length * c, y + length * sn);
}

/* A length between two points, with strokes across its ends. */
void sketch_measure(const Sketch *s, double x1, double y1, double x2, double y2)
{
    const double length = hypot(x2 - x1, y2 - y1), nx = -(y2 - y1) / length * STROKE, ny = (x2 - x1) / length * STROKE;
    sketch_line(s, TINKER_COLOUR_COMPRESSED, x1, y1, x2, y2);
    sketch_line(s, TINKER_COLOUR_COMPRESSED, x1 - nx, y1 - ny, x1 + nx, y1 + ny);
    sketch_line(s, TINKER_COLOUR_COMPRESSED, x2 - nx, y2 - ny, x2 + nx, y2 + ny);
}

void sketch_axes(const Sketch *s, double x, double y, double angle)
{
    const double c = cos(angle), sn = sin(angle);
    sketch_arrow(s, TINKER_COLOUR_MOTION, x, y, -0.6 * sn, 0.6 * c);
    sketch_arrow(s, TINKER_COLOUR_MOTION, x, y, 0.6 * c, 0.6 * sn);
    sketch_note(s, TINKER_COLOUR_MOTION, x - 0.75 * sn, y + 0.75 * c, "$n$");
    sketch_note(s, TINKER_COLOUR_MOTION, x + 0.68 * c - 0.14 * sn, y + 0.68 * sn + 0.14 * c, "$t$");
}
