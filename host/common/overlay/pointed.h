/* What is pointed at in one view, whose counterparts light up in all others; and where in a picture the things lie that
 * can be pointed at. */
#ifndef TINKER_HOST_POINTED_H
#define TINKER_HOST_POINTED_H

#include <glib.h>

#include "scene/store/scene.h"

/* Which of the two forces of a contact. */
typedef enum { TINKER_POINTED_WHOLE, TINKER_POINTED_NORMAL, TINKER_POINTED_FRICTION } TinkerPointedPart;

/* A block with all that comes from it, or of it the force on one body alone. */
typedef struct {
    TinkerBlockId block; /* TINKER_NO_BLOCK: nothing */
    TinkerBlockId on;    /* the body that the force acts on; TINKER_NO_BLOCK: all that comes from the block */
    TinkerPointedPart part;
} TinkerPointed;

/* Nothing where it is TINKER_NO_BLOCK. */
TinkerPointed tinker_pointed_block(TinkerBlockId block);

/* Whether it is one force, not all of a block. */
gboolean tinker_pointed_is_force(const TinkerPointed *pointed);
gboolean tinker_pointed_same(const TinkerPointed *a, const TinkerPointed *b);

/* Whether a thing is a counterpart of what is pointed at: of a force those that stand for it alone, and those that
 * stand for all of its block. NULL is nothing. */
gboolean tinker_pointed_lights(const TinkerPointed *pointed, const TinkerPointed *thing);

/* Places ----------------------------------------------------------------------------------------------------------- */

/* A thing in a picture, in its units. */
typedef struct {
    double at[4];     /* of a line its ends, x and y; of a box the least and greatest */
    gboolean is_line; /* else it is a box */
    TinkerPointed what;
    char *text; /* what it says: "Spring 12.3 N" */
} TinkerSpot;

/* Element: TinkerSpot. (transfer full) */
GArray *tinker_spots_new(void);
/* `text` is copied. Where `spots` is NULL nothing is noted. */
void tinker_spots_add_box(GArray *spots, const double box[4], TinkerPointed what, const char *text);
void tinker_spots_add_line(GArray *spots, const double ends[4], TinkerPointed what, const char *text);
/* Moves those from number `first` on by (dx, dy). */
void tinker_spots_move(GArray *spots, guint first, double dx, double dy);

/* Keys go through what there is, each thing once, in the order in which it was noted: the one so many behind this one,
 * or the first; it ends at both ends. NULL: there is none. Borrowed. */
const TinkerSpot *tinker_spots_next(const GArray *spots, const TinkerPointed *from, int step);

/* The nearest within reach, of those as near the last one; NULL: none. Borrowed. */
const TinkerSpot *tinker_spots_at(const GArray *spots, double x, double y, double reach);

#endif
