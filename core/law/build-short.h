/* What law/build.h makes, in few letters: for rules of one line each. To be included in sources of rules alone. */
#ifndef TINKER_CORE_LAW_BUILD_SHORT_H
#define TINKER_CORE_LAW_BUILD_SHORT_H

#include "law/build.h"

#define N(x)        tinker_expression_number(x)
#define COPY(x)     tinker_expression_ref(x)
#define PLUS(a, b)  tinker_expression_plus(a, b)
#define MINUS(a, b) tinker_expression_minus(a, b)
#define TIMES(a, b) tinker_expression_times(a, b)
#define OVER(a, b)  tinker_expression_over(a, b)
#define CALL(f, a)  tinker_expression_call(f, a)
#define SQUARE(a)   tinker_expression_squared(a)
#define POWER(a, n) tinker_expression_to_power(a, n)

#endif
