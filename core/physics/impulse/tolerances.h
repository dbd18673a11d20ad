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

/* Piles. */

/* No unit; of the radius: gaps up to this are closed, so that rounding asks for nothing. Held by: -. */
#define TINKER_PILE_CLOSED 1e-10
/* No unit; of what forces make of the speeds of two in a step: what they approach each other by no faster is rounding.
 * Held by: -. */
#define TINKER_PILE_NO_BLOW 1e-6
/* No unit; of the radius: how far below a top what comes to it past an end may be. Held by: -. */
#define TINKER_PILE_EVEN 1e-4
/* No unit; of the speeds that contacts take: what a sweep changes less by is rounding. Held by: -. */
#define TINKER_PILE_SOLVED 1e-11
/* No unit; of the speeds that contacts take: what rests has up to this, since sweeps leave something step by step.
 * Held by: test-pile. */
#define TINKER_PILE_RESTS 1e-7
/* No unit; of the energies that impulses exchange: what is given beyond that is rounding, or, by the second, of sweeps
 * that were cut short. Held by: -. */
#define TINKER_PILE_NO_MORE        1e-9
#define TINKER_PILE_NEARLY_NO_MORE 1e-3

#endif
