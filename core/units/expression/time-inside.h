/* Times within pieces. */
#ifndef TINKER_CORE_TIME_INSIDE_H
#define TINKER_CORE_TIME_INSIDE_H

#include <float.h>
#include <math.h>

/* A time between two breaks, or beyond the last where `next` is infinite. Not the middle: there what is symmetric about
 * it may touch a level, and be on another side of that than in all the rest of the piece. */
static inline double tinker_time_inside(double from, double next)
{
    return from + 0.41421356237309503 * (isfinite(next) ? next - from : 1);
}

/* s: how far from an end of a piece, at t, and so long, the other side is not met by rounding: of t, and of the
 * argument of a switch, which may be some units off t. */
static inline double tinker_time_beside(double t, double length)
{
    return 16 * DBL_EPSILON * fabs(t) + 1e-13 * fmin(length, 1);
}

#endif
