/* What is rounding, and what is let pass, of steps. Each: its unit and what it is relative to; what it says; and where
 * that was tried, tests that fail where it is 1e4 times as large or as small ("-": none). */
#ifndef TINKER_INTEGRATE_TOLERANCES_H
#define TINKER_INTEGRATE_TOLERANCES_H

/* No unit; of the largest product: a damping matrix whose products there and back differ by no more is symmetric. */
#define TINKER_SYMMETRIC 1e-9
/* No unit; of the square of a vector: a part across that is less is rounding. */
#define TINKER_SPANNED 1e-24
/* No unit; of the largest speed so far: slower is rest. */
#define TINKER_DAMPED_REST 1e-12
/* No unit; times the tolerance: an error that a step seldom has by growing too long. */
#define TINKER_FAR_OFF 100.0
/* No unit; of the way of a step: an error of more is none of a motion. */
#define TINKER_UNMOVED 0.01
/* No unit; of the error: where less of it lies along the motion, the rows nearly depend. */
#define TINKER_ERROR_ALONG 0.01
/* No unit; of the square of what projection takes off: singular places are passed seldom. */
#define TINKER_SQUARE_SHARE 0.1
/* No unit; the error of a trial that another length, hardly shorter, would serve as well as any. */
#define TINKER_MISPLACED 2.0
/* No unit; of the residual: an iteration that leaves more asks for a new matrix. */
#define TINKER_SLOW_NEWTON 0.1
/* No unit; of the stiffest beside them: what moves along the rows of constraints. */
#define TINKER_ROW_WEIGHT 1e6
/* No unit; of the tolerance that one step may spend: errors add up over a run. */
#define TINKER_STEP_SHARE 0.1
/* No unit; of the tolerance: what counts as the last error in the controller's memory is at least this. */
#define TINKER_LEAST_ERROR 1e-4

#endif
