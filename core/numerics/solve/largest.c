#include "numerics/solve/largest.h"

#include <string.h>
#include <tinker/types.h>

/* The bits of doubles without sign are ordered as the numbers are, with NaN above all. */
TINKER_VARIANTS double tinker_largest(int32_t count, const double *x)
{
    int64_t largest = 0;
    for (int32_t i = 0; i < count; i++) {
        int64_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        bits &= INT64_MAX;
        largest = bits > largest ? bits : largest;
    }
    double result;
    memcpy(&result, &largest, sizeof result);
    return result;
}
