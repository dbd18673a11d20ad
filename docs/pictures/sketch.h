/* Parts of drawings that explain contact. Lengths are in m, angles in rad, counter-clockwise; colours are
 * TINKER_COLOUR_*.
 */
#ifndef DOCS_SKETCH_H
#define DOCS_SKETCH_H

#include <cairo.h>

#include "render/draw/style.h"

typedef struct {
    cairo_t *cairo; /* in world units */
    const TinkerStyle *style;
} Sketch;

/* Text about a point; what stands between dollar signs is a formula. */
void sketch_note(const Sketch *s, int colour, double x, double y, const char *text);

void sketch_arrow(const Sketch *s, int colour, double x, double y, double dx, double dy);
void sketch_line(const Sketch *s, int colour, double x1, double y1, double x2, double y2);
/* A thin grey line: of construction. */
void sketch_dashed(const Sketch *s, double x1, double y1, double x2, double y2);
void sketch_dot(const Sketch *s, int colour, double x, double y);
void sketch_disc(const Sketch *s, double x, double y, double radius);
/* A box about a point, turned. */
void sketch_box(const Sketch *s, double x, double y, double width, double height, double turned);
/* A support whose top goes from (x, y) so far along the angle. */
void sketch_slab(const Sketch *s, double x, double y, double length, double angle);
/* A length between two points, with strokes across its ends. */
void sketch_measure(const Sketch *s, double x1, double y1, double x2, double y2);
/* Normal and tangent from a point; the tangent points along the angle. */
void sketch_axes(const Sketch *s, double x, double y, double angle);

#endif
