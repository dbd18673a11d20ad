#include "law/reduce.h"

#include <math.h>

#include "law/build.h"

#define LARGEST 1e9 /* beyond, a number is no factor that somebody wrote */

/* The whole number that leads a product, or that the expression is; 1 where there is none. */
static gint64 leading_number(const TinkerExpression *expression)
{
    const TinkerExpression *first = expression;
    while (first->kind == TINKER_EXPRESSION_PRODUCT)
        first = first->parts[0];
    if (first->kind != TINKER_EXPRESSION_NUMBER || first->number != floor(first->number)) return 1;
    return first->number >= 1 && first->number <= LARGEST ? (gint64)first->number : 1;
}

/* The expression over one of its leading number's divisors. */
static TinkerExpression *divided(const TinkerExpression *expression, gint64 divisor)
{
    if (expression->kind != TINKER_EXPRESSION_PRODUCT)
        return tinker_expression_number((double)(leading_number(expression) / divisor));
    TinkerExpression *result = divided(expression->parts[0], divisor);
    for (int i = 1; i < expression->count; i++)
        result = tinker_expression_times(result, tinker_expression_ref(expression->parts[i]));
    return result;
}

static gint64 common_divisor(gint64 a, gint64 b)
{
    return b == 0 ? a : common_divisor(b, a % b);
}

TinkerExpression *tinker_expression_reduced(const TinkerExpression *expression)
{
    if (expression->count == 0) return tinker_expression_ref(expression);
    g_autofree TinkerExpression **parts = g_new(TinkerExpression *, (gsize)expression->count);
    for (int i = 0; i < expression->count; i++)
        parts[i] = tinker_expression_reduced(expression->parts[i]);
    if (expression->kind != TINKER_EXPRESSION_QUOTIENT)
        return tinker_expression_node(expression->kind, expression->name, parts, expression->count);
    /* with its sign before it */
    g_autoptr(TinkerExpression) whole = tinker_expression_over(parts[0], parts[1]);
    const gboolean negative = whole->kind == TINKER_EXPRESSION_NEGATIVE;
    const TinkerExpression *quotient = negative ? whole->parts[0] : whole;
    if (quotient->kind != TINKER_EXPRESSION_QUOTIENT) return g_steal_pointer(&whole);
    const TinkerExpression *above = quotient->parts[0], *below = quotient->parts[1];
    const gint64 common = common_divisor(leading_number(above), leading_number(below));
    if (common == 1) return g_steal_pointer(&whole);
    TinkerExpression *result = tinker_expression_over(divided(above, common), divided(below, common));
    return negative ? tinker_expression_negated(result) : result;
}
