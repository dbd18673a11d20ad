/* Antiderivatives, where there is one among the functions of the grammar. */
#ifndef TINKER_CORE_LAW_INTEGRAL_H
#define TINKER_CORE_LAW_INTEGRAL_H

#include "units/expression/expression-tree.h"

/* An expression whose derivative by the symbol is this one: of sums, products with what does not depend on the symbol,
 * powers and functions of an expression u beside its own derivative u', products of sums, and what switches at a number
 * (min, max, `if`, ramp, abs), of which the antiderivative has no jump. NULL where none is found, which says nothing of
 * whether there is one. (transfer full) */
TinkerExpression *tinker_expression_integral(const TinkerExpression *expression, const char *symbol);

#endif
