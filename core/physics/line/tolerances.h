/* What is rounding, and what is let pass, of models that move along lines or turn on fixed axes. Each: its unit and
 * what it is relative to; what it says; and where that was tried, tests that fail where it is 1e4 times as large or as
 * small ("-": none). */
#ifndef TINKER_LINE_TOLERANCES_H
#define TINKER_LINE_TOLERANCES_H

/* No unit; of a ratio: two ways from shaft to shaft that differ by no more are one. Held by: -. */
#define TINKER_SAME_RATIO 1e-12
/* No unit; of the largest stiffness over mass: eigenvalues below are rounding. Held by: -. */
#define TINKER_NEGLIGIBLE_STIFFNESS 1e-9
/* No unit; of the extent, the speeds, the loads: what is off a line by no more lies along it. Held by:
 * physics-linear-form. */
#define TINKER_LINE_ACROSS 1e-12

#endif
