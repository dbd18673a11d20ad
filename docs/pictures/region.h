/* A region of a plane, as bands and lines that a plot can draw. */
#ifndef DOCS_REGION_H
#define DOCS_REGION_H

#include "growth.h"
#include "render/plot/plot.h"

/* What is drawn: from and to along x, from and to along y. */
typedef double View[4];

/* Growth on a grid of places over a view. */
typedef struct {
    const double *view; /* View */
    double *growth;
} Grid;

void docs_grid_init(Grid *grid, const Method *method, const double *view);
void docs_grid_clear(Grid *grid);

/* Adds a band that fills where growth is at most `level`, in a colour of the theme's curves. `curves`: of TinkerCurve,
 * whose numbers are added to `numbers`, to be freed with it. */
void docs_add_shade(GArray *curves, GPtrArray *numbers, const Grid *grid, double level, int colour);

/* Adds the line where growth is `level`. */
void docs_add_edge(GArray *curves, GPtrArray *numbers, const Grid *grid, double level, const char *label, int colour);

/* Adds the curve of so many points that `place` gives for 0 to 1. */
typedef void (*PlaceFunction)(const void *data, double share, double *x, double *y);
void docs_add_curve(GArray *curves, GPtrArray *numbers, PlaceFunction place, const void *data, int points,
                    TinkerCurve style);

#endif
