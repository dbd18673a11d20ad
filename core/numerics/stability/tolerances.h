/* What is rounding where a method's stability is looked for. Each: its unit and what it is relative to; what it says;
 * and where that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_STABILITY_TOLERANCES_H
#define TINKER_STABILITY_TOLERANCES_H

/* No unit; a map of one oscillator may grow by this much a step. Held by: -. */
#define TINKER_GROWTH 1e-9
/* No unit; a map of coupled oscillators may grow by this much a step, and in proportion more at long ones. Held by:
 * physics-guard. */
#define TINKER_COUPLED_GROWTH 1e-10
/* No unit; it decays where it does so by more than this a step. Held by: -. */
#define TINKER_LEAST_DECAY 1e-12
/* No unit; eigenvalues this near to 1 are of what stays or drifts freely: two that fall together are taken apart by
 * rounding. Held by: physics-guard. */
#define TINKER_EIGENVALUE_STAYS 1e-6

#endif
