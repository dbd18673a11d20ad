/* Expressions of several arguments, compiled: what typed laws are worked out by. */
#ifndef TINKER_CORE_COMPILED_H
#define TINKER_CORE_COMPILED_H

#include "units/expression-tree.h"

typedef struct _TinkerCompiled TinkerCompiled;

/* Compiles an expression over these names. What the tree shares is worked out once. NULL where it has become too long.
 * (transfer full) */
TinkerCompiled *tinker_compiled_new(const TinkerExpression *expression, const char *const *names, int count);
void tinker_compiled_free(TinkerCompiled *compiled);

/* The value; needs no memory, and may be asked on any thread. */
double tinker_compiled_value(const TinkerCompiled *compiled, const double *arguments);

/* What plugins know as a formula (tinker/typed-law.h): an expression, its slopes and its curvatures. */
struct TinkerTypedLaw {
    int count; /* of arguments */
    TinkerCompiled *value;
    TinkerCompiled **slopes;     /* by each argument */
    TinkerCompiled **curvatures; /* by two, row by row */
};

#endif
