#include "numerics/solve/largest.h"

#include <string.h>

/* The bits of doubles without sign are ordered as the numbers are, with NaN above all. */
double tinker_largest(int32_t count, const double *x)
{
    uint64_t largest = 0;
    for (int32_t i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &x[i], sizeof bits);
        bits &= UINT64_MAX >> 1;
        if (bits > largest) largest = bits;
    }
    double result;
    memcpy(&result, &largest, sizeof result);
    return result;
}
