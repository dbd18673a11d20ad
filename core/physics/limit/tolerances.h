/* What is rounding, and what is let pass, where steps are limited. Each: its unit and what it is relative to; what it
 * says; and where that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_LIMIT_TOLERANCES_H
#define TINKER_LIMIT_TOLERANCES_H

#include <float.h>

/* No unit; of the length at which the force is 0: evaluations nearer to length 0 are noted; steps that resolve the
 * motion come nearer than that. */
#define TINKER_LOST_NEAR 0.25
/* No unit; of a length: a law that gives no force there and so far on either side is idle about it. */
#define TINKER_IDLE_PROBE 1e-3
/* No unit; of the length as placed: so many times as far, and as near, a law is asked whether it is idle. */
#define TINKER_IDLE_FAR 1e6
/* No unit; of a length, or of the time: so near to the end of its range an idle line is at it. */
#define TINKER_IDLE_END 1e-11
/* No unit; of a length: so far beyond the end of its range a first step goes. */
#define TINKER_IDLE_BEYOND 1e-3
/* No unit; of the speed, and of what a distance is accelerated by: a distance that changes by less, as that of two
 * places of one bar, is one that stays. */
#define TINKER_IDLE_STEADY 1e-9
/* No unit; of the fastest: a typed law that a fixed step passes over is told where its impulse is above this. */
#define TINKER_LAW_MISSED 1e-3
/* m/s: what a typed law gives to what has never moved is nothing below this, as the tail of an exponential. */
#define TINKER_LAW_NOTHING 1e-290
/* No unit; of the speed that a typed law gives in a usual step: what is slower is at rest. Held by:
 * physics-typed-start. */
#define TINKER_LAW_AT_REST 1e-3
/* No unit; of the usual length of steps, from one that is shorter to the next. Held by: -. */
#define TINKER_LAW_FADING 0.9
/* No unit; of the time, or of a step: shorter ones are not divided for what a typed law does in them. */
#define TINKER_LAW_LEAST 1e-11
/* No unit; of the larger of two forces: how far a law goes from one to the other in a jump. Held by:
 * physics-typed-start. */
#define TINKER_LAW_JUMP 1e-3
/* No unit; of the extent: ends so near to each other are at one place but for rounding. */
#define TINKER_DIRECTION_ROUNDING 1e-13
/* No unit; of the extent: ends that are exactly at one place are parted by so much. */
#define TINKER_PARTED (64 * DBL_EPSILON)
/* No unit; of the extent times the speed: what rounding makes of moments of the relative motion. */
#define TINKER_ROUNDING_OF_MOMENTS (8 * DBL_EPSILON)
/* No unit; of what was seen of it: the run's energy is off by at most so many times that. */
#define TINKER_SEEN 2.0
/* No unit; of |T0| times the extent: beyond it nobody asks how far the energy is off. */
#define TINKER_DIRECTION_FAR 0.1

#endif
