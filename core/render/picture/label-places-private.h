/* Where the name of a block may stand: places beside a body or along a connector, as boxes on the canvas. */
#ifndef TINKER_RENDER_LABEL_PLACES_PRIVATE_H
#define TINKER_RENDER_LABEL_PLACES_PRIVATE_H

#include "render/picture/painter-private.h"

/* A block whose name is being placed: what is the same for all its places. Lengths in canvas units, y down. */
typedef struct {
    double name_width, name_height;
    /* A body, or the box of a drawing: */
    double x, y;
    double half_width, half_height; /* of the body or of its drawing */
    double orientation;
    double round; /* the drawing is far smaller than the body: its reach in any direction; else 0 */
    double dot;   /* reach in any direction, at least */
    /* A connector, */
    gboolean is_connector;
    gboolean is_line; /* between two ends or more: */
    double line[4];   /* from (x, y) to (x, y) */
    double thickness;
} TinkerNamed;

/* Looks up where the block is; the name's size is the caller's to fill in. FALSE where it has no place for a name. */
gboolean tinker_named_init(TinkerNamed *named, const TinkerPicture *picture, const TinkerPiece *piece);

/* How many places there are to try. A connector that is shorter than its name has none: beside others it would not be
 * seen whose name it is. */
int tinker_named_places(const TinkerNamed *named);

/* Whether a place is so far from its body that a line has to lead to it; and that line, from the body's edge to the
 * name's box: canvas x, y of both ends. */
gboolean tinker_named_is_far(const TinkerNamed *named, int number);
void tinker_named_leader(const TinkerNamed *named, const double box[4], double line[4]);

/* The name's box (least and greatest x and y) in a place, and what it costs where nothing is in the way: near ones are
 * better, and above is better than below. */
void tinker_named_place(const TinkerNamed *named, int number, double box[4]);
/* A connector's name would be taken for that of another symbol close by: a box beyond the name that should be free as
 * well. Of others the name's own. */
void tinker_named_clearance(const TinkerNamed *named, int number, double box[4]);
double tinker_named_free_cost(const TinkerNamed *named, int number);

/* Whether the drawing is far smaller than the declared size of its body (a support that is a mere anchor). */
gboolean tinker_piece_is_drawn_small(const TinkerPicture *picture, const TinkerPiece *piece);

#endif
