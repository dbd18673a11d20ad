/* The dimensions of expressions. Angles have none here: rad is 1, as in a law that multiplies one. */
#ifndef TINKER_CORE_LAW_DIMENSION_H
#define TINKER_CORE_LAW_DIMENSION_H

#include "units/expression/expression-tree.h"

#include <tinker/types.h>

/* Exponents of kg, m, s; real, since a root halves them. `any`: the number 0, which fits everything. */
typedef struct {
    gboolean any;
    double mass, length, time;
} TinkerLawDimension;

/* The dimension of a symbol; FALSE where it is not known. */
typedef gboolean (*TinkerDimensionFunc)(const char *symbol, TinkerDimension *dimension, void *data);

/* The dimension of an expression. FALSE where two things are added, compared or put into a function that do not go
 * together: `why` says which (transfer full). */
gboolean tinker_expression_dimension(const TinkerExpression *expression, TinkerDimensionFunc of_symbol, void *data,
                                     TinkerLawDimension *dimension, char **why);

gboolean tinker_law_dimension_is(const TinkerLawDimension *found, TinkerDimension wanted);

/* "kg m/s^2", "1" where it has none. (transfer full) */
char *tinker_law_dimension_text(const TinkerLawDimension *dimension);

#endif
