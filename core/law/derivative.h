/* Exact derivatives of expressions. */
#ifndef TINKER_CORE_LAW_DERIVATIVE_H
#define TINKER_CORE_LAW_DERIVATIVE_H

#include "law/build.h"

/* The derivative of an expression, by the derivatives of its symbols (NULL: 0), tidied. What switches is differentiated
 * within its pieces: that of step(x) is 0. (transfer full) */
TinkerExpression *tinker_expression_derivative(const TinkerExpression *expression, TinkerSymbolFunc derivative,
                                               void *data);

/* The derivative by one symbol, on which no other depends. (transfer full) */
TinkerExpression *tinker_expression_derivative_by(const TinkerExpression *expression, const char *symbol);

#endif
