/* The largest of many numbers. */
#ifndef TINKER_NUMERICS_LARGEST_H
#define TINKER_NUMERICS_LARGEST_H

#include <stdint.h>

/* The largest |x|; NaN or infinite where an entry is. */
double tinker_largest(int32_t count, const double *x);

#endif
