/* What the tests of the estimate share. */
#ifndef TEST_ESTIMATE_CASE_H
#define TEST_ESTIMATE_CASE_H

#include <float.h>

/* Of a motion, evenly over its duration. */
#define ESTIMATE_SAMPLES 50

/* Errors below this share of the scales are rounding. */
#define ESTIMATE_FLOOR (100 * DBL_EPSILON)

/* One method or more of each kind: of fixed steps, adaptive, symplectic, implicit. */
#define ESTIMATE_METHODS                                                                                               \
    {                                                                                                                  \
        "rk4", "verlet", "semi-implicit-euler", "dopri5", "dop853", "verlet6", "newmark", "generalized-alpha"          \
    }

#endif
