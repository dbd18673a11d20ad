/* A coarse map of what is drawn where, by which labels and legends find a free place. */
#ifndef TINKER_RENDER_OCCUPANCY_H
#define TINKER_RENDER_OCCUPANCY_H

#include <glib.h>

/* Cells of some canvas units, each with what it is taken by. */
typedef struct {
    double left, top, cell;
    int columns, rows;
    guint8 *taken;
} TinkerOccupancy;

/* What takes a cell, as flags. */
#define TINKER_TAKEN_BY_DRAWING (1u << 0)
#define TINKER_TAKEN_BY_TEXT    (1u << 1)

void tinker_occupancy_init(TinkerOccupancy *map, double left, double top, double width, double height, double cell);
void tinker_occupancy_clear(TinkerOccupancy *map);

/* Takes a box (least and greatest x and y), or the strip of this thickness about a line. What lies outside the map is
 * cut off. */
void tinker_occupancy_take_box(TinkerOccupancy *map, const double box[4], guint8 by);
void tinker_occupancy_take_line(TinkerOccupancy *map, double x1, double y1, double x2, double y2, double thickness,
                                guint8 by);

/* The share of the box's cells that any of `by` takes; cells outside the map count as taken. */
double tinker_occupancy_share(const TinkerOccupancy *map, const double box[4], guint8 by);

#endif
