/* Times within pieces. */
#ifndef TINKER_CORE_TIME_INSIDE_H
#define TINKER_CORE_TIME_INSIDE_H

#include <math.h>

/* A time between two breaks, or beyond the last where `next` is infinite: at no fraction that what is symmetric would
 * touch a level at. */
static inline double tinker_time_inside(double from, double next)
{
    return from + 0.41421356237309503 * (isfinite(next) ? next - from : 1);
}

#endif
