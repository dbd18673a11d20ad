/* Two shapes of which neither turns touch where the centre of the first is on the rim of one convex shape that goes
 * with the second: all places that keep the two in touch, the second's own grown by what the first is from its centre
 * (the Minkowski difference). So their gap is that of a point, and boxes that face each other touch at one contact. */
#ifndef TINKER_CORE_UNTURNED_H
#define TINKER_CORE_UNTURNED_H

#include "physics/shapes/gaps.h"

/* Of two boxes. */
#define TINKER_UNTURNED_CORNERS 8

/* Polygons; in the world's axes, from the centre of the second. */
typedef struct {
    TinkerOutline point; /* the first as it is here */
    TinkerOutline around;
    double corners[2 * TINKER_UNTURNED_CORNERS];
} TinkerUnturned;

/* Of two polygons of at most 4 corners, with the angles (rad) that they keep. */
void tinker_unturned_init(TinkerUnturned *both, const TinkerOutline *first, double first_angle,
                          const TinkerOutline *second, double second_angle);

/* Their gap functions, at most `room`, with poses of angle 0. What has no width along some direction ends there, which
 * is a contact on that one line; of two points on the line along `way`, from the second to the first. */
int32_t tinker_unturned_functions(const TinkerUnturned *both, const TinkerOutline *first, double first_angle,
                                  const double way[2], TinkerGapFunction *list, int32_t room);

#endif
