/* What of a law t alone decides. */
#ifndef TINKER_CORE_TIMED_PARTS_H
#define TINKER_CORE_TIMED_PARTS_H

#include "units/expression/expression-tree.h"

/* The sum of those parts of an expression that name t and nothing else, as large as they are: of step(t - 1)*L + sin(t)
 * that is step(t - 1) + sin(t). NULL: there is none. (transfer full) */
TinkerExpression *tinker_expression_timed_parts(const TinkerExpression *law);

#endif
