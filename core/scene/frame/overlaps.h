/* Overlaps: bodies that start in a solid plate. Such a body passes the plate as from behind, which is seldom meant. */
#ifndef TINKER_CORE_OVERLAPS_H
#define TINKER_CORE_OVERLAPS_H

#include "scene/frame/frame.h"

/* A start this near to a top touches it (m); one farther behind it passes as from behind. */
#define TINKER_TOUCHING 1e-9

/* So many are told of one by one; of the rest, how many there are. */
#define TINKER_OVERLAPS_TOLD 5

typedef struct {
    TinkerBlockId body, plate;
    double depth;     /* m: how far the body's nearest side lies below the top */
    double normal[2]; /* of the top; depth times it takes the body out */
} TinkerOverlap;

/* Every pair of a body and a plate with a solid side that overlap where the frame has them, plate by plate and body by
 * body in the order of creation. A body counts with its height, whatever its angle, because that is what contact goes
 * by; it overlaps a plate while the foot of its centre lies within the plate's width and some of its height, by more
 * than TINKER_TOUCHING, lies between the plate's top and its underside. One that is wholly in front or wholly behind
 * does not. Costs what the plates' boxes cover, not the product. Element: TinkerOverlap. (transfer full) */
GArray *tinker_overlaps_new(const TinkerFrame *frame);

/* Adds a warning (of char *) for each of the first overlaps at t = 0, with what would be right, and one for the rest. A
 * scene whose motions fail there has none to tell of. */
void tinker_overlaps_tell(TinkerScene *scene, GPtrArray *warnings);

#endif
