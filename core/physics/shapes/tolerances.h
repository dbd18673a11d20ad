/* What is rounding of shapes that meet. Each: its unit and what it is relative to; what it says; and where that was
 * tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_SHAPES_TOLERANCES_H
#define TINKER_SHAPES_TOLERANCES_H

#include <float.h>

/* No unit; of its length: so far an edge goes on behind a corner that turns inwards, within the body, so that what
 * comes to the corner is over both of its edges. Held by: -. */
#define TINKER_INTO_CORNER 1e-6
/* No unit; sines of angles up to this are 0 but for what methods make of it. Held by: -. */
#define TINKER_NOT_INTO 1e-6
/* No unit; sines of angles up to this are 0. Held by: -. */
#define TINKER_UPRIGHT 1e-9
/* m: the edge of the first is the seat, unless the other's parts them by so much more: which it is does not change
 * from step to step. Held by: -. */
#define TINKER_RATHER_FIRST 1e-10
/* No unit; of the product of two edges: up to here three corners lie on one line. Held by: -. */
#define TINKER_ON_ONE_LINE (64 * DBL_EPSILON)
/* No unit; sines of angles up to this are 0: such edges are one. Held by: -. */
#define TINKER_PARALLEL 1e-12
/* m: points this far beside a line are on it. Held by: -. */
#define TINKER_ON_THE_LINE 1e-9
/* No unit; of the speed across what meets there: a speed along it is rounding. Held by: contact-flush. */
#define TINKER_STRAIGHT_DOWN 1e-12

#endif
