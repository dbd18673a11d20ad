/* Putting expressions together, tidied as one would by hand: no zero terms, no factors of 1, signs pulled out. Each
 * function takes over its arguments. (transfer full) */
#ifndef TINKER_CORE_LAW_BUILD_H
#define TINKER_CORE_LAW_BUILD_H

#include "units/expression/expression-tree.h"

TinkerExpression *tinker_expression_plus(TinkerExpression *a, TinkerExpression *b);
TinkerExpression *tinker_expression_minus(TinkerExpression *a, TinkerExpression *b);
TinkerExpression *tinker_expression_times(TinkerExpression *a, TinkerExpression *b);
TinkerExpression *tinker_expression_over(TinkerExpression *a, TinkerExpression *b);
TinkerExpression *tinker_expression_negated(TinkerExpression *a);
TinkerExpression *tinker_expression_to_power(TinkerExpression *base, TinkerExpression *exponent);
TinkerExpression *tinker_expression_squared(TinkerExpression *a);
TinkerExpression *tinker_expression_call(const char *function, TinkerExpression *a);
TinkerExpression *tinker_expression_if(TinkerExpression *condition, TinkerExpression *a, TinkerExpression *b);
TinkerExpression *tinker_expression_compare(const char *sign, TinkerExpression *a, TinkerExpression *b);

gboolean tinker_expression_is_number(const TinkerExpression *expression, double number);

/* What stands for a symbol; NULL: it stays. (transfer full) */
typedef TinkerExpression *(*TinkerSymbolFunc)(const char *symbol, void *data);

/* The expression with symbols replaced, and tidied. `expression` is borrowed. (transfer full) */
TinkerExpression *tinker_expression_replace(const TinkerExpression *expression, TinkerSymbolFunc replacement,
                                            void *data);

/* As tinker_expression_replace, with what is made of numbers alone worked out at once, so that its derivatives are
 * short: with 5 for a, a/2*x^2 becomes 2.5*x^2. (transfer full) */
TinkerExpression *tinker_expression_folded(const TinkerExpression *expression, TinkerSymbolFunc replacement,
                                           void *data);

/* Whether a symbol stands anywhere in it. */
gboolean tinker_expression_uses(const TinkerExpression *expression, const char *symbol);

#endif
