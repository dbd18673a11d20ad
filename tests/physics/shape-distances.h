/* Outlines to try functions of shapes with, at random poses, and their distances by all of their sides and corners. */
#ifndef TEST_SHAPE_DISTANCES_H
#define TEST_SHAPE_DISTANCES_H

#include <glib.h>

#include "physics/shapes/gaps.h"
#include "physics/shapes/outline-parts.h"

#define SHAPE_POSES 1000000 /* that are tried */
#define SHAPE_MOST  96      /* functions of a pair */

/* Polygons, discs and a line, and behind them an angle and an arrow, which are not convex. */
extern const TinkerOutline shapes[8];
extern const TinkerOutline shape_top;

double shape_between(GRand *random, double from, double to);
TinkerBodyPose shape_turned_by(TinkerBodyPose pose, double angle);
TinkerBodyPose shape_random_pose(GRand *random);
void shape_corner_at(const TinkerOutline *outline, const TinkerBodyPose *pose, int32_t number, double at[2]);

/* Twice the area of a triangle, negative where it is clockwise. */
double shape_side_of(const double a[2], const double b[2], const double p[2]);
double shape_from_segment(const double p[2], const double a[2], const double b[2]);
/* Of a point from a polygon; negative within it. */
double shape_from_polygon(const double p[2], const TinkerOutline *outline, const TinkerBodyPose *pose);
/* Negative where they overlap. */
double shape_distance(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                      const TinkerBodyPose *q);
/* Two corners that are nearest to each other have no function: they meet in no more than single motions. */
double shape_nearest_corners(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                             const TinkerBodyPose *q);

#endif
