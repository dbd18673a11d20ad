/* <complex.h> with CMPLX, which glibc defines for GCC alone. x + I * y is no substitute: it makes 0 * inf of an
 * infinite y. */
#ifndef TINKER_ANALYSIS_COMPLEX_NUMBERS_H
#define TINKER_ANALYSIS_COMPLEX_NUMBERS_H

#include <complex.h>

#ifndef CMPLX
#define CMPLX(x, y) __builtin_complex((double)(x), (double)(y))
#endif

#endif
