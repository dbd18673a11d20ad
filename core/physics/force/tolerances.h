/* How far differences of laws reach, and what is too much to go on with. Each: its unit and what it is relative to;
 * what it says; and where that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_FORCE_TOLERANCES_H
#define TINKER_FORCE_TOLERANCES_H

/* No unit; of a length or a rate: rounding and curvature both stay some nine digits below the law. Held by:
 * physics-jacobian. */
#define TINKER_LAW_STEP 1e-6
/* No unit; of a slope at length 0: one that changes by more as the length shrinks has not settled. Held by: -. */
#define TINKER_SLOPE_UNSETTLED 0.1
/* No unit; of a slope at length 0: one that changes by less is good. Held by: -. */
#define TINKER_SLOPE_SETTLED 1e-9
/* m and m/s: a state that is larger in sum has diverged. Held by: -. */
#define TINKER_STATE_BEYOND 1e60
/* No unit; of the largest speed, or m/s where nothing moves: so far differences reach to each side. Held by: -. */
#define TINKER_PRODUCT_STEP 1e-5

#endif
