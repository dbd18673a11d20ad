/* What is rounding, and what is let pass, of steps. Each: its unit and what it is relative to; what it says; and where
 * that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_INTEGRATE_TOLERANCES_H
#define TINKER_INTEGRATE_TOLERANCES_H

/* No unit; of the largest product: a damping matrix whose products there and back differ by no more is symmetric.
 * Held by: -. */
#define TINKER_SYMMETRIC_DAMPING 1e-9
/* No unit; of the square of a vector: a part across that is less is rounding. Held by: -. */
#define TINKER_SPANNED 1e-24
/* No unit; of the largest speed so far: slower is rest. Held by: -. */
#define TINKER_DAMPED_REST 1e-12
/* No unit; times the tolerance: an error that a step seldom has by growing too long. Held by: physics-singular. */
#define TINKER_FAR_OFF 100.0
/* No unit; of the way of a step: an error of more is none of a motion. Held by: -. */
#define TINKER_UNMOVED 0.01
/* No unit; of the error: where less of it lies along the motion, the rows nearly depend. Held by: -. */
#define TINKER_ERROR_ALONG 0.01
/* No unit; of the square of what projection takes off: singular places are passed seldom. Held by: -. */
#define TINKER_SQUARE_SHARE 0.1
/* No unit; the error of a trial that another length, hardly shorter, would serve as well as any. Held by: -. */
#define TINKER_MISPLACED 2.0
/* No unit; of the residual: an iteration that leaves more asks for a new matrix. Held by: numerics-integrators,
 * physics-implicit. */
#define TINKER_SLOW_NEWTON 0.1
/* No unit; of the accelerations: where rounding of places is more of them, an old matrix, which leaves the same in each
 * step, is given up for what it leaves of the motion. Held by: physics-implicit. */
#define TINKER_LOOSE_NEWTON 1e-7
/* No unit; of the stiffest beside them: what moves along the rows of constraints. Held by: -. */
#define TINKER_ROW_WEIGHT 1e6
/* No unit; of the tolerance that one step may spend: errors add up over a run. Held by: numerics-adaptive,
 * physics-accurate-run, physics-redundant-rods, physics-singular. */
#define TINKER_STEP_SHARE 0.1
/* No unit; times the tolerance: what one step in which velocities hardly change may be off by in the books, of what is
 * exchanged.
 * Held by: physics-books. */
#define TINKER_BOOKS_LOOSER 1e3
/* No unit; of the kinetic energy: less in a step may be rounding of forces that cancel. Held by: -. */
#define TINKER_BOOKS_ROUNDING 1e-10
/* No unit; of the tolerance: what counts as the last error in the controller's memory is at least this. Held by: -. */
#define TINKER_LEAST_ERROR 1e-4

/* No unit; of the usual step, and of the speed that a force brings about within one: trials that are shorter, and
 * motions that are slower, are those of something that sets in. Held by: physics-typed-start. */
#define TINKER_CUT_DOWN 1e-3
/* No unit; of what is left of the run, or of the piece: how long steps will be, if nothing moves yet and no force
 * tells. Held by: physics-typed-start. */
#define TINKER_USUAL_AT_REST 1e-2
/* No unit; of the time: a force that sets in does so no more exactly. Held by: physics-typed-start. */
#define TINKER_SETS_IN (256 * DBL_EPSILON)

#endif
