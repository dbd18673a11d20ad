/* Expressions worked out with numbers. */
#ifndef TINKER_CORE_LAW_VALUE_H
#define TINKER_CORE_LAW_VALUE_H

#include "units/expression/expression-tree.h"

typedef double (*TinkerValueFunc)(const char *symbol, void *data);

/* The value, by those of the symbols. Of an `if` only the branch that is taken is looked at. */
double tinker_expression_value(const TinkerExpression *expression, TinkerValueFunc value, void *data);

#endif
