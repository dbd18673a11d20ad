/* How far differences reach, and what is rounding, where a model is taken as linear about its rest. Each: its unit and
 * what it is relative to; what it says; and where that was tried, tests that fail where it is 1e4 times as large or as
 * small ("-": none). */
#ifndef TINKER_LINEARISE_TOLERANCES_H
#define TINKER_LINEARISE_TOLERANCES_H

/* No unit; of the extent, of an extent a second, of the largest force: the step of differences. Held by:
 * analysis-response. */
#define TINKER_PROBE_STEP 1e-3
/* No unit; of the values that a derivative is the difference of: less of it is rounding. Held by: analysis-response. */
#define TINKER_PROBE_ROUNDING 1e-13
/* No unit; of a row's length, or of the shortest part of a path: the step of differences of order 6, whose truncation
 * and rounding are both some 1e-13 there. Held by: analysis-modes, analysis-modes-contacts, analysis-modes-elements,
 * analysis-modes-turning, analysis-response. */
#define TINKER_HESSIAN_STEP 3e-3
/* No unit; of a path's length: parts of it that are shorter have no direction. Held by: -. */
#define TINKER_HESSIAN_PART 1e-9
/* rad: the step of those differences in an angle. Held by: -. */
#define TINKER_HESSIAN_ANGLE_STEP 3e-3
/* No unit; of the largest second derivative: smaller ones are the differences' own. Held by: -. */
#define TINKER_HESSIAN_NOISE 1e-11
/* No unit; of a derivative: what differences of one that is constant, as a gear's, are by rounding, since their weights
 * are 110 together. Held by: analysis-modes-turning. */
#define TINKER_HESSIAN_ROUNDING 1e-13
/* No unit; of the extent, and of an extent a second: the step of differences of order 4 where a field couples
 * bodies.
 Held by: analysis-modes-elements. */
#define TINKER_COUPLING_STEP 2e-4
/* No unit; of what a force changes by from one state to another: what that change differs by at another time is
 * rounding. Held by: analysis-mode-words. */
#define TINKER_VARIES 1e-9

#endif
