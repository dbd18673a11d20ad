/* What is rounding, and what is let pass, of a model as a second-order system, and of its books. Each: its unit and
 * what it is relative to; what it says; and where that was tried, tests that fail where it is 1e4 times as large or as
 * small ("-": none). */
#ifndef TINKER_SYSTEM_TOLERANCES_H
#define TINKER_SYSTEM_TOLERANCES_H

#include <float.h>

/* No unit; of forces times extent: smaller energies are errors of place that every tolerance allows. Held by: -. */
#define TINKER_BOOK_REST 1e-9
/* No unit; of the energy there is: smaller differences of energies are rounding. Held by: -. */
#define TINKER_BOOK_ROUNDING (1e4 * DBL_EPSILON)
/* No unit; of forces times extent and the energy there is: no imbalance, however little was exchanged. Held by: -. */
#define TINKER_BOOK_LAST_BITS (16 * DBL_EPSILON)
/* No unit; of the state: one that is off by more is left alone, since the run is failing and whoever watches it
 * shall see that. Held by: -. */
#define TINKER_MOST_HELD_CHANGE 1e-3
/* No unit; of the extent, or of a speed: the step of differences. Held by: physics-jacobian. */
#define TINKER_JACOBIAN_STEP 1e-6
/* rad and rad/s: the step of differences of angles, which have no extent. Held by: -. */
#define TINKER_JACOBIAN_ANGLE_STEP 1e-6

#endif
