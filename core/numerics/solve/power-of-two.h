/* Scales that round nothing. */
#ifndef TINKER_NUMERICS_POWER_OF_TWO_H
#define TINKER_NUMERICS_POWER_OF_TWO_H

#include <math.h>

/* The least power of two above a positive number. */
static inline double tinker_power_of_two(double number)
{
    int exponent;
    frexp(number, &exponent);
    return ldexp(1, exponent);
}

#endif
