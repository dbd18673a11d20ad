/* Constructors that tidy. */
#include "law/build.h"

#include <math.h>
#include <string.h>

gboolean tinker_expression_is_number(const TinkerExpression *expression, double number)
{
    return expression->kind == TINKER_EXPRESSION_NUMBER && expression->number == number;
}

static gboolean is_number(const TinkerExpression *expression)
{
    return expression->kind == TINKER_EXPRESSION_NUMBER;
}

/* The parts of a node of the kind, or the expression itself as the only one; it is used up. */
static void take_parts(GPtrArray *parts, TinkerExpression *expression, TinkerExpressionKind kind)
{
    if (expression->kind != kind) {
        g_ptr_array_add(parts, expression);
        return;
    }
    for (int i = 0; i < expression->count; i++)
        g_ptr_array_add(parts, tinker_expression_ref(expression->parts[i]));
    tinker_expression_unref(expression);
}

static TinkerExpression *one_or_node(GPtrArray *parts, TinkerExpressionKind kind, double empty)
{
    if (parts->len == 0) return tinker_expression_number(empty);
    if (parts->len == 1) return g_ptr_array_index(parts, 0);
    return tinker_expression_node(kind, NULL, (TinkerExpression *const *)parts->pdata, (int)parts->len);
}

/* One of two, the other used up. */
static TinkerExpression *only(TinkerExpression *kept, TinkerExpression *dropped)
{
    tinker_expression_unref(dropped);
    return kept;
}

/* Two nodes used up, with a third in their place. */
static TinkerExpression *instead(TinkerExpression *a, TinkerExpression *b, TinkerExpression *result)
{
    tinker_expression_unref(a);
    tinker_expression_unref(b);
    return result;
}

TinkerExpression *tinker_expression_plus(TinkerExpression *a, TinkerExpression *b)
{
    if (is_number(a) && is_number(b)) return instead(a, b, tinker_expression_number(a->number + b->number));
    if (tinker_expression_is_number(a, 0)) return only(b, a);
    if (tinker_expression_is_number(b, 0)) return only(a, b);
    g_autoptr(GPtrArray) parts = g_ptr_array_new();
    take_parts(parts, a, TINKER_EXPRESSION_SUM);
    take_parts(parts, b, TINKER_EXPRESSION_SUM);
    return one_or_node(parts, TINKER_EXPRESSION_SUM, 0);
}

TinkerExpression *tinker_expression_negated(TinkerExpression *a)
{
    if (is_number(a)) {
        const double number = a->number == 0 ? 0 : -a->number;
        tinker_expression_unref(a);
        return tinker_expression_number(number);
    }
    if (a->kind == TINKER_EXPRESSION_NEGATIVE) {
        TinkerExpression *inside = tinker_expression_ref(a->parts[0]);
        tinker_expression_unref(a);
        return inside;
    }
    return tinker_expression_node(TINKER_EXPRESSION_NEGATIVE, NULL, &a, 1);
}

TinkerExpression *tinker_expression_minus(TinkerExpression *a, TinkerExpression *b)
{
    if (tinker_expression_equal(a, b)) return instead(a, b, tinker_expression_number(0));
    return tinker_expression_plus(a, tinker_expression_negated(b));
}

/* Takes the sign of a factor off; flips *negative where there is one. */
static TinkerExpression *without_sign(TinkerExpression *a, gboolean *negative)
{
    if (a->kind == TINKER_EXPRESSION_NEGATIVE || (is_number(a) && a->number < 0)) {
        *negative = !*negative;
        return tinker_expression_negated(a);
    }
    return a;
}

static TinkerExpression *signed_again(TinkerExpression *a, gboolean negative)
{
    return negative ? tinker_expression_negated(a) : a;
}

/* a (p / q) is (a p) / q: one fraction line. */
static TinkerExpression *times_quotient(TinkerExpression *a, TinkerExpression *b)
{
    TinkerExpression *quotient = b->kind == TINKER_EXPRESSION_QUOTIENT ? b : a, *other = quotient == b ? a : b;
    TinkerExpression *top = tinker_expression_ref(quotient->parts[0]),
                     *below = tinker_expression_ref(quotient->parts[1]);
    tinker_expression_unref(quotient);
    return tinker_expression_over(
        quotient == b ? tinker_expression_times(other, top) : tinker_expression_times(top, other), below);
}

/* A symbol that is a factor already becomes its square; it is used up. */
static gboolean squares(GPtrArray *parts, guint count, TinkerExpression *part)
{
    for (guint i = 0; part->kind == TINKER_EXPRESSION_SYMBOL && i < count; i++) {
        if (!tinker_expression_equal(g_ptr_array_index(parts, i), part)) continue;
        parts->pdata[i] = tinker_expression_squared(g_ptr_array_index(parts, i));
        tinker_expression_unref(part);
        return TRUE;
    }
    return FALSE;
}

TinkerExpression *tinker_expression_times(TinkerExpression *a, TinkerExpression *b)
{
    gboolean negative = FALSE;
    if (tinker_expression_is_number(a, 0) || tinker_expression_is_number(b, 0))
        return instead(a, b, tinker_expression_number(0));
    a = without_sign(a, &negative);
    b = without_sign(b, &negative);
    if (a->kind == TINKER_EXPRESSION_QUOTIENT || b->kind == TINKER_EXPRESSION_QUOTIENT)
        return signed_again(times_quotient(a, b), negative);
    g_autoptr(GPtrArray) parts = g_ptr_array_new();
    take_parts(parts, a, TINKER_EXPRESSION_PRODUCT);
    take_parts(parts, b, TINKER_EXPRESSION_PRODUCT);
    double number = 1;
    guint kept = 0;
    for (guint i = 0; i < parts->len; i++) {
        TinkerExpression *part = g_ptr_array_index(parts, i);
        if (is_number(part)) {
            number *= part->number;
            tinker_expression_unref(part);
        } else if (!squares(parts, kept, part)) {
            parts->pdata[kept++] = part;
        }
    }
    g_ptr_array_set_size(parts, (int)kept);
    if (number != 1) g_ptr_array_insert(parts, 0, tinker_expression_number(number));
    return signed_again(one_or_node(parts, TINKER_EXPRESSION_PRODUCT, 1), negative);
}

TinkerExpression *tinker_expression_over(TinkerExpression *a, TinkerExpression *b)
{
    gboolean negative = FALSE;
    if (tinker_expression_is_number(a, 0) && !tinker_expression_is_number(b, 0))
        return instead(a, b, tinker_expression_number(0));
    if (tinker_expression_is_number(b, 1)) return only(a, b);
    if (tinker_expression_equal(a, b) && !is_number(a)) return instead(a, b, tinker_expression_number(1));
    a = without_sign(a, &negative);
    b = without_sign(b, &negative);
    TinkerExpression *parts[] = {a, b};
    return signed_again(tinker_expression_node(TINKER_EXPRESSION_QUOTIENT, NULL, parts, 2), negative);
}

TinkerExpression *tinker_expression_to_power(TinkerExpression *base, TinkerExpression *exponent)
{
    const gboolean even = is_number(exponent) && fmod(exponent->number, 2) == 0;
    if (even && base->kind == TINKER_EXPRESSION_NEGATIVE) base = tinker_expression_negated(base);
    TinkerExpression *parts[] = {base, exponent};
    if (tinker_expression_is_number(exponent, 0)) return instead(base, exponent, tinker_expression_number(1));
    if (tinker_expression_is_number(exponent, 1)) return only(base, exponent);
    if (tinker_expression_is_number(base, 0) && is_number(exponent) && exponent->number > 0)
        return instead(base, exponent, tinker_expression_number(0));
    return tinker_expression_node(TINKER_EXPRESSION_POWER, NULL, parts, 2);
}

TinkerExpression *tinker_expression_squared(TinkerExpression *a)
{
    return tinker_expression_to_power(a, tinker_expression_number(2));
}

/* A node of numbers alone becomes a whole number where it is one: cos(0) is 1, sqrt(2) stays. */
static TinkerExpression *tidied(TinkerExpression *node)
{
    double values[3];
    for (int i = 0; i < node->count; i++) {
        if (!is_number(node->parts[i])) return node;
        values[i] = node->parts[i]->number;
    }
    const double value = tinker_expression_apply(node, values);
    if (!isfinite(value) || value != floor(value)) return node;
    tinker_expression_unref(node);
    return tinker_expression_number(value);
}

TinkerExpression *tinker_expression_call(const char *function, TinkerExpression *a)
{
    return tidied(tinker_expression_node(TINKER_EXPRESSION_FUNCTION, function, &a, 1));
}

TinkerExpression *tinker_expression_if(TinkerExpression *condition, TinkerExpression *a, TinkerExpression *b)
{
    TinkerExpression *parts[] = {condition, a, b};
    if (is_number(condition)) {
        const gboolean first = condition->number != 0;
        return only(only(first ? a : b, first ? b : a), condition);
    }
    if (tinker_expression_equal(a, b)) return only(only(a, b), condition);
    return tinker_expression_node(TINKER_EXPRESSION_FUNCTION, "if", parts, 3);
}

TinkerExpression *tinker_expression_compare(const char *sign, TinkerExpression *a, TinkerExpression *b)
{
    TinkerExpression *parts[] = {a, b};
    return tidied(tinker_expression_node(TINKER_EXPRESSION_COMPARISON, sign, parts, 2));
}

static TinkerExpression *rebuilt(const TinkerExpression *node, TinkerExpression **parts)
{
    TinkerExpression *result = parts[0];
    switch (node->kind) {
    case TINKER_EXPRESSION_SUM:
        for (int i = 1; i < node->count; i++)
            result = tinker_expression_plus(result, parts[i]);
        return result;
    case TINKER_EXPRESSION_PRODUCT:
        for (int i = 1; i < node->count; i++)
            result = tinker_expression_times(result, parts[i]);
        return result;
    case TINKER_EXPRESSION_NEGATIVE:
        return tinker_expression_negated(result);
    case TINKER_EXPRESSION_QUOTIENT:
        return tinker_expression_over(result, parts[1]);
    case TINKER_EXPRESSION_POWER:
        return tinker_expression_to_power(result, parts[1]);
    case TINKER_EXPRESSION_FUNCTION:
        if (strcmp(node->name, "if") == 0) return tinker_expression_if(result, parts[1], parts[2]);
        return tidied(tinker_expression_node(node->kind, node->name, parts, node->count));
    default:
        return tidied(tinker_expression_node(node->kind, node->name, parts, node->count));
    }
}

TinkerExpression *tinker_expression_replace(const TinkerExpression *expression, TinkerSymbolFunc replacement,
                                            void *data)
{
    if (is_number(expression)) return tinker_expression_ref(expression);
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) {
        TinkerExpression *other = replacement(expression->name, data);
        return other != NULL ? other : tinker_expression_ref(expression);
    }
    g_autofree TinkerExpression **parts = g_new(TinkerExpression *, (gsize)expression->count);
    for (int i = 0; i < expression->count; i++)
        parts[i] = tinker_expression_replace(expression->parts[i], replacement, data);
    return rebuilt(expression, parts);
}

/* A node of numbers alone, as the number that it is worked out to. */
static TinkerExpression *worked_out(TinkerExpression *node)
{
    double values[3];
    for (int i = 0; i < node->count; i++) {
        if (!is_number(node->parts[i]) || i >= (int)G_N_ELEMENTS(values)) return node;
        values[i] = node->parts[i]->number;
    }
    const double value = tinker_expression_apply(node, values);
    if (node->count == 0 || !isfinite(value)) return node;
    tinker_expression_unref(node);
    return tinker_expression_number(value);
}

TinkerExpression *tinker_expression_folded(const TinkerExpression *expression, TinkerSymbolFunc replacement, void *data)
{
    if (expression->count == 0) return tinker_expression_replace(expression, replacement, data);
    g_autofree TinkerExpression **parts = g_new(TinkerExpression *, (gsize)expression->count);
    for (int i = 0; i < expression->count; i++)
        parts[i] = tinker_expression_folded(expression->parts[i], replacement, data);
    return worked_out(rebuilt(expression, parts));
}

gboolean tinker_expression_uses(const TinkerExpression *expression, const char *symbol)
{
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) return strcmp(expression->name, symbol) == 0;
    for (int i = 0; i < expression->count; i++)
        if (tinker_expression_uses(expression->parts[i], symbol)) return TRUE;
    return FALSE;
}
