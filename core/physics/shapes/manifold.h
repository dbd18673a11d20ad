/* Where two shapes touch, or are about to, as a step of many bodies asks for it: one normal, and at most two points,
 * each of them a corner of one over an edge of the other (shapes/gaps.h has such gaps one by one, with their
 * derivatives).
 *
 *       first                           The seat is the edge, of either, along whose normal the two are farthest apart;
 *      p0 o------o p1                   the points are the ends of what of the facing edge lies over it.
 *         |      |   gap
 *    =====+======+======== seat         n from the second to the first,  t = (n_y, -n_x)
 *       second
 */
#ifndef TINKER_CORE_MANIFOLD_H
#define TINKER_CORE_MANIFOLD_H

#include "physics/shapes/gaps.h"

/* A shape where it is. */
typedef struct {
    TinkerOutlineKind kind;
    int32_t count;   /* of corners */
    double place[2]; /* of its frame */
    double radius;   /* m: of a disc, or of its farthest corner */
    double *corners; /* 2 each; borrowed */
    double *normals; /* 2 each, behind the corners: outward, of the edge that begins at a corner; of a top of its one
                        edge */
} TinkerPlacedShape;

typedef struct {
    double gap;     /* m */
    double at[2];   /* where the two touch, or the nearer side of it */
    int32_t corner; /* which corner that is: of the first as it is, of the second behind TINKER_MOST_CORNERS */
} TinkerManifoldPoint;

typedef struct {
    double normal[2];
    double separation; /* m: how far they are apart along it; negative: they overlap, or one is below a top */
    gboolean beside;   /* the first is wholly past an end of a top, or below it */
    int32_t count;
    TinkerManifoldPoint points[2]; /* along t */
} TinkerManifold;

/* The corners of an outline, then the normals of its edges (of a top of its one edge, twice), 2 doubles each. */
void tinker_shape_corners(const TinkerOutline *outline, double *corners);
/* Turns these to where the frame is: into the corners and, behind them, normals of a shape. */
void tinker_place_shape(TinkerPlacedShape *shape, double x, double y, double cosine, double sine, const double *local);

/* Points whose gap is larger than `reach` (m) are left out. The first is no top. */
void tinker_manifold_find(const TinkerPlacedShape *first, const TinkerPlacedShape *second, double reach,
                          TinkerManifold *manifold);

#endif
