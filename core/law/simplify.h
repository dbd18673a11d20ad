/* Derivatives as a textbook has them. */
#ifndef TINKER_CORE_LAW_SIMPLIFY_H
#define TINKER_CORE_LAW_SIMPLIFY_H

#include "units/expression/expression-tree.h"

/* The expression with equal factors as powers, cancelled above and below one fraction line, with equal terms of sums
 * put together and signs pulled out: a x / √u / √u / √u is a x / u^(3/2), L² / L³ is 1 / L, −(−a x + b x³) is a x − b
 * x³. Conditions stay as they are. In real arithmetic it is equal wherever `expression` has a value: exponents are
 * added, and powers of powers multiplied where the outer one is a whole number, but √(x²) stays. It rounds otherwise.
 * (transfer full) */
TinkerExpression *tinker_expression_simplified(const TinkerExpression *expression);

#endif
