/* Arrows as they lie in a picture, while they are drawn. */
#ifndef TINKER_RENDER_ARROWS_DIAGRAM_PRIVATE_H
#define TINKER_RENDER_ARROWS_DIAGRAM_PRIVATE_H

#include "render/draw/occupancy.h"
#include "render/draw/strokes.h"
#include "render/picture/arrows.h"

/* Behind so many none has a label or moves beside others. */
#define ARROWS_MOST_LABELS 300

/* An arrow in the picture, m. */
typedef struct {
    const TinkerForceArrow *arrow;
    double x1, y1, x2, y2;
    double label[4]; /* canvas units: its box; all 0: there is none */
} ArrowShaft;

typedef struct {
    cairo_t *cairo;
    const TinkerView *view;
    const TinkerArrowOptions *options;
    TinkerStyleBrush brush;
    GArray *shafts; /* of ArrowShaft, the strongest first */
    TinkerOccupancy map;
} ArrowDiagram;

static inline const double *arrows_colour_of(const ArrowDiagram *diagram, const ArrowShaft *shaft)
{
    return tinker_arrow_colour(diagram->options->theme, shaft->arrow->kind);
}

/* arrows-shafts.c: where the arrows lie that show, into diagram->shafts. */
void arrows_find_shafts(ArrowDiagram *diagram, const TinkerForceArrow *arrows, gsize count);

/* arrows-labels.c */
void arrows_write_labels(ArrowDiagram *diagram);

#endif
