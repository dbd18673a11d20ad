/* Gaps between two shapes, and how they change as the shapes move.
 *
 * A gap function is of one *tip* and one *seat*, each fixed to a frame (a body or a support):
 *
 *     tip:   a corner, or the centre of a disc of radius r
 *     seat:  an edge, with its outward normal n, or a round: a corner, or the centre of a disc, of radius s
 *
 *          tip o                            gap = n . (P - C) - r        edge:  n is the edge's
 *              | gap                        gap = |P - C| - s - r        round: n points from C to P
 *        ------C------ seat   t --->
 *
 * t = (n_y, -n_x) runs along the seat. Two shapes touch where one of their gap functions is 0 and its tip is over the
 * seat, `along` within +-half_width; each corner has functions of its own, which never jump. Where a disc goes from an
 * edge over a corner, one function takes over from another with the same gap and speed. Corners that turn inwards are
 * neither tips nor rounds: what comes to one touches both of its edges. So nothing has to be convex: a gap that falls
 * through 0 over its seat is a tip that goes in there.
 *
 * Derivatives are by the six coordinates of both frames, x, y and angle of the tip's, then those of the seat's:
 *
 *     gap'' = row[0] . (x_tip'', y_tip'', angle_tip'', ...) + drift[0]
 *     u'    = row[1] . (...) + drift[1],   u: speed along t of the tip's material at the contact, relative to the
 * seat's
 *
 * `rolled` is the integral of u while the gap is 0: what stays constant of a contact that sticks. */
#ifndef TINKER_CORE_GAPS_H
#define TINKER_CORE_GAPS_H

#include <glib.h>
#include <stdint.h>

typedef enum {
    TINKER_OUTLINE_DISC,
    TINKER_OUTLINE_POLYGON, /* simple: convex or not */
    TINKER_OUTLINE_TOP,     /* of a support: two corners, towards -x first, and the solid side between them */
} TinkerOutlineKind;

#define TINKER_MOST_CORNERS 64

/* In the axes of its frame. */
typedef struct {
    TinkerOutlineKind kind;
    double radius;         /* m: of a disc; of others the farthest corner's distance from the frame's place */
    int32_t count;         /* corners, counter-clockwise; of a polygon 2 are the ends of a line, 1 is a point */
    const double *corners; /* 2 each */
    int32_t triangle_count;
    const double *triangles; /* 6 each: what a polygon that is not convex consists of (outline-parts.h); else NULL */
} TinkerOutline;

typedef struct {
    double x, y, angle;
    double vx, vy, rate;
    double cosine, sine; /* of the angle: whoever moves a body has them */
} TinkerBodyPose;

/* Of shapes 0 and 1; places and directions in the axes of the frames that they are fixed to. */
typedef struct {
    int32_t tip_of; /* 0 or 1; the seat is of the other */
    gboolean round; /* the seat */
    gboolean rolls; /* the tip or the seat has a radius: it moves along the seat without slipping, too */
    double tip[2], tip_radius;
    double inset; /* m: what is at the tip touches so far from it, where the tip stands for more than a point */
    double seat[2], seat_radius; /* the middle of an edge; the centre of a round */
    double normal[2];            /* of an edge; of a round the middle of the directions in which it is the nearest */
    double half_width;           /* m; INFINITY: all around */
    double sides[2][2];          /* of a corner: the directions of its edges; (0, 0): none */
    double above[2];             /* the end of a top meets what comes from there alone; (0, 0): no end of a top */
    int32_t reverse; /* of a corner over a line: so much farther on in the list it is over the other side; else 0 */
} TinkerGapFunction;

typedef struct {
    double gap, along, rolled; /* m */
    double period;             /* m: `rolled` is known but for multiples of this; 0: for none */
    double normal_speed, tangential_speed, along_speed;
    double normal[2]; /* from the seat to the tip */
    double point[2];  /* where the tip's surface is nearest to the seat */
    double row[2][6], drift[2];
} TinkerGap;

/* Writes the gap functions of two shapes, at most `room`; answers how many there are. */
int32_t tinker_gap_functions(const TinkerOutline *first, const TinkerOutline *second, TinkerGapFunction *list,
                             int32_t room);

/* As many as two shapes have at most. */
int32_t tinker_gap_functions_most(const TinkerOutline *first, const TinkerOutline *second);

void tinker_gap_measure(const TinkerGapFunction *function, const TinkerBodyPose *first, const TinkerBodyPose *second,
                        TinkerGap *gap);

/* The gap (m) alone, bit for bit TinkerGap.gap: it asks for places and no motion, and is told much sooner. */
double tinker_gap_alone(const TinkerGapFunction *function, const TinkerBodyPose *first, const TinkerBodyPose *second);

/* Whether the tip is over the seat, and none of its own edges leads on into it, so that the gap is one between the
 * shapes: of two boxes on one floor whose lower corners meet, none is above or below the other. Within `tolerance` (m)
 * of an end one that moves on over it is not; what moves straight at the seat, to rounding, does not. */
gboolean tinker_gap_is_over(const TinkerGapFunction *function, const TinkerBodyPose *first,
                            const TinkerBodyPose *second, const TinkerGap *gap, double tolerance);

/* How far (m) two shapes overlap: the least way along one of their normals that parts them; negative: they are that far
 * apart, along such a normal. A top has no inside: of it, how far anything of the other is below the top and over it.
 */
double tinker_outlines_overlap(const TinkerOutline *first, const TinkerBodyPose *at_first, const TinkerOutline *second,
                               const TinkerBodyPose *at_second);

#endif
