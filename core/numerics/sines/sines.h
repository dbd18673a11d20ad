/* Sine and cosine of many angles. */
#ifndef TINKER_NUMERICS_SINES_H
#define TINKER_NUMERICS_SINES_H

#include <stdint.h>

/* `sines` and `cosines` of `count` angles (rad), each with an error below 0.8 units in its last place, or 1.1 where it
 * is nearly 0; not a number for an angle that is infinite or none. What an angle gives depends on it alone: not on
 * those beside it, nor on the processor. */
void tinker_sines(int32_t count, const double *angles, double *sines, double *cosines);

#endif
