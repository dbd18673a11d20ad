#include "law/value.h"

#include <string.h>

double tinker_expression_value(const TinkerExpression *expression, TinkerValueFunc value, void *data)
{
    if (expression->kind == TINKER_EXPRESSION_NUMBER) return expression->number;
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) return value(expression->name, data);
    if (expression->kind == TINKER_EXPRESSION_FUNCTION && strcmp(expression->name, "if") == 0) {
        const gboolean first = tinker_expression_value(expression->parts[0], value, data) != 0;
        return tinker_expression_value(expression->parts[first ? 1 : 2], value, data);
    }
    double few[8];
    g_autofree double *many = expression->count > (int)G_N_ELEMENTS(few) ? g_new(double, expression->count) : NULL;
    double *values = many != NULL ? many : few;
    for (int i = 0; i < expression->count; i++)
        values[i] = tinker_expression_value(expression->parts[i], value, data);
    return tinker_expression_apply(expression, values);
}
