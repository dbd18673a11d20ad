/* Intervals of doubles that enclose: whatever the operands hold, the result holds what the operation makes of it.
 * Bounds are widened outwards by at least the rounding error. An interval whose bounds are NaN is empty: the function
 * is defined nowhere over it. Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, Introduction to Interval Analysis
 * (SIAM, 2009). */
#ifndef TINKER_INTERVAL_H
#define TINKER_INTERVAL_H

#include <glib.h>

typedef struct {
    double low, high;
} TinkerInterval;

TinkerInterval tinker_interval_point(double value);
TinkerInterval tinker_interval_entire(void);
TinkerInterval tinker_interval_empty(void);
gboolean tinker_interval_is_empty(TinkerInterval x);

/* Whether 0 is certainly not among the values. */
gboolean tinker_interval_excludes_zero(TinkerInterval x);

TinkerInterval tinker_interval_negate(TinkerInterval x);
TinkerInterval tinker_interval_add(TinkerInterval x, TinkerInterval y);
TinkerInterval tinker_interval_subtract(TinkerInterval x, TinkerInterval y);
TinkerInterval tinker_interval_multiply(TinkerInterval x, TinkerInterval y);
TinkerInterval tinker_interval_scale(TinkerInterval x, double factor);
TinkerInterval tinker_interval_divide(TinkerInterval x, TinkerInterval y); /* entire where y holds 0 */

/* x^n, whole n and any sign of x; x^p for other p, over x >= 0. */
TinkerInterval tinker_interval_power(TinkerInterval x, double exponent);

/* The elementary functions, over the part of x where they are defined. */
TinkerInterval tinker_interval_sin(TinkerInterval x);
TinkerInterval tinker_interval_cos(TinkerInterval x);
TinkerInterval tinker_interval_tan(TinkerInterval x);
TinkerInterval tinker_interval_asin(TinkerInterval x);
TinkerInterval tinker_interval_acos(TinkerInterval x);
TinkerInterval tinker_interval_atan(TinkerInterval x);
TinkerInterval tinker_interval_sinh(TinkerInterval x);
TinkerInterval tinker_interval_cosh(TinkerInterval x);
TinkerInterval tinker_interval_tanh(TinkerInterval x);
TinkerInterval tinker_interval_exp(TinkerInterval x);
TinkerInterval tinker_interval_log(TinkerInterval x);
TinkerInterval tinker_interval_sqrt(TinkerInterval x);

#endif
