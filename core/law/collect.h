/* Common factors of a sum, as a textbook has them. */
#ifndef TINKER_CORE_LAW_COLLECT_H
#define TINKER_CORE_LAW_COLLECT_H

#include "units/expression/expression-tree.h"

/* Whether a factor is kept apart: terms are put together whose such factors are the same. */
typedef gboolean (*TinkerApartFunc)(const TinkerExpression *factor, void *data);

/* (m1 + m2) g l sin(q) of m1 g l sin(q) + m2 g l sin(q), where sin(q) is apart: what all terms with the same factors
 * apart have in common stands once, and among what is left so do the factors of terms that differ in one. (transfer
 * full) */
TinkerExpression *tinker_expression_collected(const TinkerExpression *sum, TinkerApartFunc apart, void *data);

#endif
