/* Names looked up: how they look, what their values are. */
#include "equations/equations.h"
#include "law/value.h"

void tinker_equations_look(const char *symbol, TinkerSymbolLook *look, void *data)
{
    const TinkerEquations *equations = data;
    const TinkerEquationLook *known = g_hash_table_lookup(equations->looks, symbol);
    *look = known != NULL ? (TinkerSymbolLook){known->stem, known->index, known->dots, known->component}
                          : (TinkerSymbolLook){symbol, "", 0, NULL};
}

static double value_of(const char *symbol, void *data)
{
    const double *value = g_hash_table_lookup(((const TinkerEquations *)data)->values, symbol);
    return value != NULL ? *value : 0;
}

double tinker_equations_value(const TinkerEquations *equations, const TinkerExpression *expression)
{
    return tinker_expression_value(expression, value_of, (void *)equations);
}

const char *tinker_term_kind_name(TinkerTermKind kind)
{
    static const char *const names[] = {"connector", "constraint", "force", "field", "normal", "friction"};
    return names[kind];
}
