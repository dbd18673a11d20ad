/* Interval arithmetic. Basic operations round correctly, so one step outwards encloses; the C library's functions are
 * good to a few units in the last place, so their bounds go out by eight. */
#include "units/expression/interval.h"

#include <float.h>
#include <math.h>

#define LIBRARY_ERROR (8 * DBL_EPSILON)
#define PI            3.14159265358979323846

static TinkerInterval outwards(double low, double high)
{
    if (isnan(low) || isnan(high)) return tinker_interval_entire();
    return (TinkerInterval){nextafter(low, -INFINITY), nextafter(high, INFINITY)};
}

static TinkerInterval library(double low, double high)
{
    if (isnan(low) || isnan(high)) return tinker_interval_entire();
    const double below = isfinite(low) ? low - LIBRARY_ERROR * fabs(low) - DBL_MIN : nextafter(low, -INFINITY);
    const double above = isfinite(high) ? high + LIBRARY_ERROR * fabs(high) + DBL_MIN : nextafter(high, INFINITY);
    return (TinkerInterval){below, above};
}

/* Of a function that grows with x. */
static TinkerInterval growing(double (*function)(double), TinkerInterval x)
{
    return library(function(x.low), function(x.high));
}

static TinkerInterval clip(TinkerInterval x, double low, double high)
{
    if (tinker_interval_is_empty(x) || x.high < low || x.low > high) return tinker_interval_empty();
    return (TinkerInterval){fmax(x.low, low), fmin(x.high, high)};
}

/* Whether one of offset + k * period may lie in x. */
static gboolean may_hold_multiple(TinkerInterval x, double offset, double period)
{
    const double slack = LIBRARY_ERROR * (1 + fabs(x.low) + fabs(x.high));
    const double next = offset + period * ceil((x.low - slack - offset) / period);
    return !(next > x.high + slack);
}

/* The sum's bound, a step further out in `direction` unless the sum is exact (D. E. Knuth's two-sum), so that whole
 * numbers stay points. */
static double sum_towards(double a, double b, double direction)
{
    const double sum = a + b;
    const double part = sum - a;
    const double error = (a - (sum - part)) + (b - part);
    return error == 0 ? sum : nextafter(sum, direction);
}

static gboolean is_zero(TinkerInterval x)
{
    return x.low == 0 && x.high == 0;
}

/* 0 times infinity is 0 here: an infinite bound stands for "arbitrarily large". */
static double product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

TinkerInterval tinker_interval_point(double value)
{
    return (TinkerInterval){value, value};
}

TinkerInterval tinker_interval_entire(void)
{
    return (TinkerInterval){-INFINITY, INFINITY};
}

TinkerInterval tinker_interval_empty(void)
{
    return (TinkerInterval){NAN, NAN};
}

gboolean tinker_interval_is_empty(TinkerInterval x)
{
    return isnan(x.low) || isnan(x.high);
}

gboolean tinker_interval_excludes_zero(TinkerInterval x)
{
    return x.low > 0 || x.high < 0;
}

TinkerInterval tinker_interval_negate(TinkerInterval x)
{
    return (TinkerInterval){-x.high, -x.low};
}

TinkerInterval tinker_interval_add(TinkerInterval x, TinkerInterval y)
{
    if (tinker_interval_is_empty(x) || tinker_interval_is_empty(y)) return tinker_interval_empty();
    const double low = sum_towards(x.low, y.low, -INFINITY);
    const double high = sum_towards(x.high, y.high, INFINITY);
    if (isnan(low) || isnan(high)) return tinker_interval_entire();
    return (TinkerInterval){low, high};
}

TinkerInterval tinker_interval_subtract(TinkerInterval x, TinkerInterval y)
{
    return tinker_interval_add(x, tinker_interval_negate(y));
}

TinkerInterval tinker_interval_multiply(TinkerInterval x, TinkerInterval y)
{
    if (tinker_interval_is_empty(x) || tinker_interval_is_empty(y)) return tinker_interval_empty();
    if (is_zero(x) || is_zero(y)) return tinker_interval_point(0);
    const double a = product(x.low, y.low), b = product(x.low, y.high);
    const double c = product(x.high, y.low), d = product(x.high, y.high);
    return outwards(fmin(fmin(a, b), fmin(c, d)), fmax(fmax(a, b), fmax(c, d)));
}

TinkerInterval tinker_interval_scale(TinkerInterval x, double factor)
{
    return tinker_interval_multiply(x, tinker_interval_point(factor));
}

TinkerInterval tinker_interval_divide(TinkerInterval x, TinkerInterval y)
{
    if (tinker_interval_is_empty(x) || tinker_interval_is_empty(y)) return tinker_interval_empty();
    if (!tinker_interval_excludes_zero(y)) return tinker_interval_entire();
    const double a = x.low / y.low, b = x.low / y.high, c = x.high / y.low, d = x.high / y.high;
    if (isnan(a) || isnan(b) || isnan(c) || isnan(d)) return tinker_interval_entire();
    return outwards(fmin(fmin(a, b), fmin(c, d)), fmax(fmax(a, b), fmax(c, d)));
}

TinkerInterval tinker_interval_power(TinkerInterval x, double exponent)
{
    if (tinker_interval_is_empty(x)) return x;
    if (exponent == 0) return tinker_interval_point(1);
    if (exponent == 1) return x;
    if (exponent < 0) return tinker_interval_divide(tinker_interval_point(1), tinker_interval_power(x, -exponent));
    const gboolean whole = floor(exponent) == exponent;
    const gboolean even = whole && fmod(exponent, 2) == 0;
    if (!whole) x = clip(x, 0, INFINITY);
    if (tinker_interval_is_empty(x)) return x;
    const double low = pow(x.low, exponent), high = pow(x.high, exponent);
    if (!even) return library(low, high);
    TinkerInterval result = library(fmin(low, high), fmax(low, high));
    if (!tinker_interval_excludes_zero(x) || result.low < 0) result.low = 0;
    return result;
}

TinkerInterval tinker_interval_sin(TinkerInterval x)
{
    return tinker_interval_cos((TinkerInterval){x.low - PI / 2, x.high - PI / 2});
}

TinkerInterval tinker_interval_cos(TinkerInterval x)
{
    if (tinker_interval_is_empty(x)) return x;
    if (!isfinite(x.low) || !isfinite(x.high)) return (TinkerInterval){-1, 1};
    const double a = cos(x.low), b = cos(x.high);
    /* the absolute slack pays for the argument that a caller shifted by a quarter turn */
    const double slack = LIBRARY_ERROR * (1 + fmax(fabs(x.low), fabs(x.high)));
    TinkerInterval result = {fmin(a, b) - slack, fmax(a, b) + slack};
    if (may_hold_multiple(x, 0, 2 * PI) || result.high > 1) result.high = 1;
    if (may_hold_multiple(x, PI, 2 * PI) || result.low < -1) result.low = -1;
    return result;
}

TinkerInterval tinker_interval_tan(TinkerInterval x)
{
    if (tinker_interval_is_empty(x)) return x;
    if (!isfinite(x.low) || !isfinite(x.high) || may_hold_multiple(x, PI / 2, PI)) return tinker_interval_entire();
    return growing(tan, x);
}

TinkerInterval tinker_interval_asin(TinkerInterval x)
{
    x = clip(x, -1, 1);
    return tinker_interval_is_empty(x) ? x : growing(asin, x);
}

TinkerInterval tinker_interval_acos(TinkerInterval x)
{
    x = clip(x, -1, 1);
    return tinker_interval_is_empty(x) ? x : library(acos(x.high), acos(x.low));
}

TinkerInterval tinker_interval_atan(TinkerInterval x)
{
    return tinker_interval_is_empty(x) ? x : growing(atan, x);
}

TinkerInterval tinker_interval_sinh(TinkerInterval x)
{
    return tinker_interval_is_empty(x) ? x : growing(sinh, x);
}

TinkerInterval tinker_interval_cosh(TinkerInterval x)
{
    if (tinker_interval_is_empty(x)) return x;
    const double a = cosh(x.low), b = cosh(x.high);
    TinkerInterval result = library(fmin(a, b), fmax(a, b));
    if (!tinker_interval_excludes_zero(x) || result.low < 1) result.low = 1;
    return result;
}

TinkerInterval tinker_interval_tanh(TinkerInterval x)
{
    return tinker_interval_is_empty(x) ? x : growing(tanh, x);
}

TinkerInterval tinker_interval_exp(TinkerInterval x)
{
    if (tinker_interval_is_empty(x)) return x;
    TinkerInterval result = growing(exp, x);
    if (result.low < 0) result.low = 0;
    return result;
}

TinkerInterval tinker_interval_log(TinkerInterval x)
{
    x = clip(x, 0, INFINITY);
    return tinker_interval_is_empty(x) ? x : growing(log, x);
}

TinkerInterval tinker_interval_sqrt(TinkerInterval x)
{
    x = clip(x, 0, INFINITY);
    if (tinker_interval_is_empty(x)) return x;
    TinkerInterval result = growing(sqrt, x);
    if (result.low < 0) result.low = 0;
    return result;
}
