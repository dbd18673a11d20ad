/* Fractions of whole numbers in lowest terms. */
#ifndef TINKER_CORE_LAW_REDUCE_H
#define TINKER_CORE_LAW_REDUCE_H

#include "units/expression/expression-tree.h"

/* The expression with whole numbers cancelled that are factors both above and below a fraction line: 2 k x / 2 is k x,
 * 6 x / 4 is 3 x / 2. For print: it rounds otherwise than what it is made from. (transfer full) */
TinkerExpression *tinker_expression_reduced(const TinkerExpression *expression);

#endif
