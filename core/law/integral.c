/* Substitution: a product is f(u) u' times what is constant for one of its factors f(u), or is multiplied out. */
#include "law/integral.h"

#include <math.h>
#include <string.h>

#include "law/build-short.h"
#include "law/derivative.h"
#include "law/simplify.h"

#define DEEPEST 12 /* products that are multiplied out within each other */

/* base^power, of what depends on the symbol. */
typedef struct {
    TinkerExpression *base;
    double power;
} Factor;

static void factor_clear(void *factor)
{
    tinker_expression_unref(((Factor *)factor)->base);
}

static const Factor *factor_at(const GArray *factors, guint number)
{
    return &g_array_index(factors, Factor, number);
}

static TinkerExpression *integral(const TinkerExpression *expression, const char *symbol, int depth);

static gboolean is_function(const TinkerExpression *node, const char *name)
{
    return node->kind == TINKER_EXPRESSION_FUNCTION && strcmp(node->name, name) == 0;
}

static gboolean is_fraction(const TinkerExpression *node)
{
    return node->kind == TINKER_EXPRESSION_QUOTIENT && node->parts[0]->kind == TINKER_EXPRESSION_NUMBER &&
           node->parts[1]->kind == TINKER_EXPRESSION_NUMBER;
}

/* Sorts a simplified product to the power of 1 or -1: what is constant goes to *constant, the rest to factors. */
static void sort(const TinkerExpression *node, const char *symbol, int sign, TinkerExpression **constant,
                 GArray *factors)
{
    const gboolean by_number = node->kind == TINKER_EXPRESSION_POWER && !tinker_expression_uses(node->parts[1], symbol);
    double exponent = NAN;
    if (by_number && node->parts[1]->kind == TINKER_EXPRESSION_NUMBER) exponent = node->parts[1]->number;
    if (by_number && is_fraction(node->parts[1]))
        exponent = node->parts[1]->parts[0]->number / node->parts[1]->parts[1]->number;
    if (is_function(node, "sqrt")) exponent = 0.5;
    if (!tinker_expression_uses(node, symbol)) {
        *constant = sign > 0 ? TIMES(*constant, COPY(node)) : OVER(*constant, COPY(node));
    } else if (node->kind == TINKER_EXPRESSION_PRODUCT) {
        for (int i = 0; i < node->count; i++)
            sort(node->parts[i], symbol, sign, constant, factors);
    } else if (node->kind == TINKER_EXPRESSION_QUOTIENT) {
        sort(node->parts[0], symbol, sign, constant, factors);
        sort(node->parts[1], symbol, -sign, constant, factors);
    } else if (node->kind == TINKER_EXPRESSION_NEGATIVE) {
        *constant = tinker_expression_negated(*constant);
        sort(node->parts[0], symbol, sign, constant, factors);
    } else {
        const gboolean raised = exponent == exponent;
        const Factor factor = {COPY(raised ? node->parts[0] : node), raised ? sign * exponent : sign};
        g_array_append_val(factors, factor);
    }
}

static TinkerExpression *raised(const Factor *factor, double power)
{
    return POWER(COPY(factor->base), N(power));
}

/* The product of all factors but one. */
static TinkerExpression *others(const GArray *factors, guint but)
{
    TinkerExpression *product = N(1);
    for (guint i = 0; i < factors->len; i++)
        if (i != but) product = TIMES(product, raised(factor_at(factors, i), factor_at(factors, i)->power));
    return product;
}

/* Of f(u) by u; NULL where it is not one of these. */
static TinkerExpression *of_function(const TinkerExpression *node)
{
    const char *name = node->name;
    const TinkerExpression *u = node->parts[0];
    if (strcmp(name, "exp") == 0) return COPY(node);
    if (strcmp(name, "sin") == 0) return tinker_expression_negated(CALL("cos", COPY(u)));
    if (strcmp(name, "cos") == 0) return CALL("sin", COPY(u));
    if (strcmp(name, "sinh") == 0) return CALL("cosh", COPY(u));
    if (strcmp(name, "cosh") == 0) return CALL("sinh", COPY(u));
    if (strcmp(name, "tanh") == 0) return CALL("log", CALL("cosh", COPY(u)));
    if (strcmp(name, "abs") == 0) return OVER(TIMES(COPY(u), COPY(node)), N(2));
    if (strcmp(name, "ramp") == 0) return OVER(SQUARE(COPY(node)), N(2));
    if (strcmp(name, "step") == 0) return CALL("ramp", COPY(u));
    return NULL;
}

/* What is made of the factor where the others are its base's derivative but for a constant. NULL: they are not. */
static TinkerExpression *substituted(const GArray *factors, guint number, const char *symbol)
{
    const Factor *factor = factor_at(factors, number);
    const gboolean function = factor->base->kind == TINKER_EXPRESSION_FUNCTION && factor->base->count == 1;
    for (int inside = 0; inside < (function && factor->power == 1 ? 2 : 1); inside++) {
        const TinkerExpression *u = inside == 1 ? factor->base->parts[0] : factor->base;
        g_autoptr(TinkerExpression) slope = tinker_expression_derivative_by(u, symbol);
        if (tinker_expression_is_number(slope, 0)) continue;
        g_autoptr(TinkerExpression) ratio = OVER(others(factors, number), COPY(slope));
        g_autoptr(TinkerExpression) constant = tinker_expression_simplified(ratio);
        if (tinker_expression_uses(constant, symbol)) continue;
        TinkerExpression *outer = NULL;
        if (inside == 1)
            outer = of_function(factor->base);
        else if (factor->power == -1)
            outer = CALL("log", CALL("abs", COPY(u)));
        else
            outer = OVER(raised(factor, factor->power + 1), N(factor->power + 1));
        if (outer != NULL) return TIMES(g_steal_pointer(&constant), outer);
    }
    return NULL;
}

/* A sum among the factors multiplied out. */
static TinkerExpression *multiplied_out(const GArray *factors, const char *symbol, int depth)
{
    for (guint i = 0; i < factors->len; i++) {
        const Factor *factor = factor_at(factors, i);
        if (factor->base->kind != TINKER_EXPRESSION_SUM || factor->power < 1 || factor->power != (int)factor->power)
            continue;
        TinkerExpression *sum = N(0);
        for (int part = 0; part < factor->base->count && sum != NULL; part++) {
            g_autoptr(TinkerExpression) term =
                TIMES(TIMES(COPY(factor->base->parts[part]), raised(factor, factor->power - 1)), others(factors, i));
            TinkerExpression *of_term = integral(term, symbol, depth + 1);
            if (of_term == NULL) g_clear_pointer(&sum, tinker_expression_unref);
            if (of_term != NULL) sum = PLUS(sum, of_term);
        }
        return sum;
    }
    return NULL;
}

typedef struct {
    const char *symbol;
    const TinkerExpression *is;
} Instead;

static TinkerExpression *instead(const char *name, void *data)
{
    const Instead *replaced = data;
    return strcmp(name, replaced->symbol) == 0 ? COPY(replaced->is) : NULL;
}

/* Less what it is at a place, so that it is 0 there; takes it over. */
static TinkerExpression *from(TinkerExpression *is, const char *symbol, const TinkerExpression *place)
{
    Instead replaced = {symbol, place};
    return MINUS(is, tinker_expression_folded(is, instead, &replaced));
}

/* `if` by where the symbol is, against what is constant: each side is counted from the place where it switches. */
static TinkerExpression *of_cases(const TinkerExpression *node, const char *symbol, int depth)
{
    const TinkerExpression *when = node->parts[0];
    if (when->kind != TINKER_EXPRESSION_COMPARISON || strchr("<>", when->name[0]) == NULL) return NULL;
    const int side = when->parts[0]->kind == TINKER_EXPRESSION_SYMBOL ? 0 : 1;
    const TinkerExpression *own = when->parts[side], *place = when->parts[1 - side];
    if (own->kind != TINKER_EXPRESSION_SYMBOL || strcmp(own->name, symbol) != 0 ||
        tinker_expression_uses(place, symbol))
        return NULL;
    g_autoptr(TinkerExpression) a = integral(node->parts[1], symbol, depth + 1);
    g_autoptr(TinkerExpression) b = integral(node->parts[2], symbol, depth + 1);
    if (a == NULL || b == NULL) return NULL;
    return tinker_expression_if(COPY(when), from(g_steal_pointer(&a), symbol, place),
                                from(g_steal_pointer(&b), symbol, place));
}

/* max(a, b) is b + ramp(a - b), min(a, b) a - ramp(a - b). */
static TinkerExpression *of_larger(const TinkerExpression *node, const char *symbol, int depth)
{
    const gboolean larger = strcmp(node->name, "max") == 0;
    TinkerExpression *const a = node->parts[0], *const b = node->parts[1];
    TinkerExpression *ramp = CALL("ramp", MINUS(COPY(a), COPY(b)));
    g_autoptr(TinkerExpression) same = larger ? PLUS(COPY(b), ramp) : MINUS(COPY(a), ramp);
    return integral(same, symbol, depth + 1);
}

static TinkerExpression *of_product(const TinkerExpression *node, const char *symbol, int depth)
{
    g_autoptr(GArray) factors = g_array_new(FALSE, FALSE, sizeof(Factor));
    g_array_set_clear_func(factors, factor_clear);
    TinkerExpression *constant = N(1), *found = NULL;
    sort(node, symbol, 1, &constant, factors);
    const Factor *first = factors->len > 0 ? factor_at(factors, 0) : NULL;
    if (first == NULL) {
        found = tinker_expression_symbol(symbol);
    } else if (factors->len == 1 && first->power == 1 && is_function(first->base, "if")) {
        found = of_cases(first->base, symbol, depth);
    } else if (factors->len == 1 && first->power == 1 &&
               (is_function(first->base, "max") || is_function(first->base, "min"))) {
        found = of_larger(first->base, symbol, depth);
    }
    for (guint i = 0; i < factors->len && found == NULL; i++)
        found = substituted(factors, i, symbol);
    if (found == NULL) found = multiplied_out(factors, symbol, depth);
    if (found != NULL) return TIMES(constant, found);
    tinker_expression_unref(constant);
    return NULL;
}

static TinkerExpression *integral(const TinkerExpression *expression, const char *symbol, int depth)
{
    if (depth > DEEPEST) return NULL;
    g_autoptr(TinkerExpression) node = tinker_expression_simplified(expression);
    if (node->kind != TINKER_EXPRESSION_SUM) return of_product(node, symbol, depth);
    TinkerExpression *sum = N(0);
    for (int i = 0; i < node->count && sum != NULL; i++) {
        TinkerExpression *term = of_product(node->parts[i], symbol, depth);
        if (term == NULL) g_clear_pointer(&sum, tinker_expression_unref);
        if (term != NULL) sum = PLUS(sum, term);
    }
    return sum;
}

TinkerExpression *tinker_expression_integral(const TinkerExpression *expression, const char *symbol)
{
    return integral(expression, symbol, 0);
}
