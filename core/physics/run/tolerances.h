/* What is rounding, and what is let pass, of runs. Each: its unit and what it is relative to; what it says. */
#ifndef TINKER_RUN_TOLERANCES_H
#define TINKER_RUN_TOLERANCES_H

#include <float.h>

/* No unit; of the largest energy exchanged: motion with less at its start began at rest. */
#define TINKER_BEGAN_AT_REST 1e-6
/* No unit; of how far bodies are from the middle of what they rest on: an island that moves within less rests. */
#define TINKER_RESTS_WITHIN 1e-9
/* No unit; of a step: times nearer to its ends are those. */
#define TINKER_SAME_TIME_IN_STEP 1e-9
/* No unit; of the time: instants nearer to each other are the same. */
#define TINKER_SAME_INSTANT 1e-12
/* No unit; of the time: a sample nearer to an impact may lie on either side of it. */
#define TINKER_NEAR_IMPACT 1e-6
/* No unit; of the extent: ends nearer to each other pass, or nearly do. */
#define TINKER_ENDS_MEET 1e-9
/* No unit; of the scales: smaller errors are rounding; */
#define TINKER_ERROR_FLOOR (100 * DBL_EPSILON)
/* and with larger ones the motion is not predictable. */
#define TINKER_UNPREDICTABLE 0.1
/* No unit; of the scales: a support whose place or speed changes by less at a break lets no rod feel a jump. */
#define TINKER_JUMP 1e-9
/* No unit; of a column: it is smooth at a break at which it changes by less. */
#define TINKER_SMOOTH 1e-9
/* No unit; of the time at which a pole lies: an adaptive method comes nearer to it. */
#define TINKER_NEAR_POLE 1e-6
/* No unit; of a path's length: the tolerance that it is worked out with, far below what any method is asked for. */
#define TINKER_PATH_TOLERANCE 1e-13
/* No unit; of the greatest speed nearby: a body that is slower is turning back. */
#define TINKER_TURNS_BACK 1e-9

#endif
