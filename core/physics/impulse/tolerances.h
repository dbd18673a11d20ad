/* What is rounding, and what is let pass, of impulses. Rebounds: physics/contact/tolerances.h. Each: its unit and
 * what it is relative to; what it says; and where that was tried, tests that fail where it is 1e4 times as large or
 * as small ("-": none). */
#ifndef TINKER_IMPULSE_TOLERANCES_H
#define TINKER_IMPULSE_TOLERANCES_H

#include <float.h>

/* No unit; of a step: shares that lack no more are as good as one. */
#define TINKER_WHOLE_STEP 1e-12
/* No unit; of what meets in a speed: rounding. */
#define TINKER_MEETING_ROUNDING (16 * DBL_EPSILON)
/* No unit; of the coordinates that a gap is the difference of: rounding. */
#define TINKER_GAP_ROUNDING (64 * DBL_EPSILON)

#endif
