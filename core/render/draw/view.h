/* The view: from world to canvas and back. World coordinates are in m with y up, canvas coordinates in pixels (or
 * points) with y down. */
#ifndef TINKER_CORE_VIEW_H
#define TINKER_CORE_VIEW_H

#include <glib.h>

typedef struct {
    double scale;              /* canvas units per m */
    double origin_x, origin_y; /* where the world's origin lies on the canvas */
    double width, height;      /* of the canvas */
    double covered;            /* of the height at the top, by something that lies over it */
} TinkerView;

/* Shows the world box (least x, least y, greatest x, greatest y) with a margin (canvas units) on every side. An empty
 * or degenerate box is widened. */
TinkerView tinker_view_fit(const double box[4], double width, double height, double margin);

void tinker_view_to_canvas(const TinkerView *view, double x, double y, double *canvas_x, double *canvas_y);
void tinker_view_to_world(const TinkerView *view, double canvas_x, double canvas_y, double *x, double *y);

/* Zooms by a factor about a canvas point; pans by canvas units. */
void tinker_view_zoom(TinkerView *view, double factor, double canvas_x, double canvas_y);
void tinker_view_pan(TinkerView *view, double canvas_dx, double canvas_dy);

/* The spacing of a grid with round numbers (1, 2 or 5 times a power of ten) at least `least` canvas units apart. */
double tinker_view_grid(const TinkerView *view, double least);

#endif
