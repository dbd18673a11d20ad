/* The rules of differentiation, one line a function. */
#include "law/derivative.h"

#include <math.h>
#include <string.h>

#include "law/build-short.h"

#define PI 3.14159265358979323846

typedef struct {
    TinkerSymbolFunc derivative;
    void *data;
} Rule;

static TinkerExpression *differentiate(const TinkerExpression *expression, const Rule *rule);

static TinkerExpression *of_product(const TinkerExpression *node, const Rule *rule)
{
    TinkerExpression *sum = N(0);
    for (int i = 0; i < node->count; i++) {
        TinkerExpression *term = N(1); /* its factors stay in their order */
        for (int k = 0; k < node->count; k++)
            term = TIMES(term, k == i ? differentiate(node->parts[k], rule) : COPY(node->parts[k]));
        sum = PLUS(sum, term);
    }
    return sum;
}

/* (a' - (a/b) b') / b, which is a'/b where b is constant. */
static TinkerExpression *of_quotient(const TinkerExpression *node, const Rule *rule)
{
    const TinkerExpression *b = node->parts[1];
    TinkerExpression *da = differentiate(node->parts[0], rule), *db = differentiate(b, rule);
    return OVER(MINUS(da, TIMES(COPY(node), db)), COPY(b));
}

/* n a^(n-1) a' + a^n log(a) n' */
static TinkerExpression *of_power(const TinkerExpression *node, const Rule *rule)
{
    const TinkerExpression *a = node->parts[0], *n = node->parts[1];
    TinkerExpression *da = differentiate(a, rule), *dn = differentiate(n, rule);
    TinkerExpression *less = PLUS(COPY(n), N(-1)); /* a number where n is */
    TinkerExpression *base = TIMES(TIMES(COPY(n), tinker_expression_to_power(COPY(a), less)), da);
    return PLUS(base, TIMES(TIMES(COPY(node), CALL("log", COPY(a))), dn));
}

static TinkerExpression *of_atan2(const TinkerExpression *node, const Rule *rule)
{
    const TinkerExpression *y = node->parts[0], *x = node->parts[1];
    TinkerExpression *dy = differentiate(y, rule), *dx = differentiate(x, rule);
    return OVER(MINUS(TIMES(COPY(x), dy), TIMES(COPY(y), dx)), PLUS(SQUARE(COPY(x)), SQUARE(COPY(y))));
}

/* Of min, max and `if`: the derivative of the one that is chosen. */
static TinkerExpression *of_choice(const TinkerExpression *node, const Rule *rule)
{
    const gboolean conditional = strcmp(node->name, "if") == 0;
    const TinkerExpression *a = node->parts[conditional ? 1 : 0], *b = node->parts[conditional ? 2 : 1];
    TinkerExpression *da = differentiate(a, rule), *db = differentiate(b, rule);
    if (conditional) return tinker_expression_if(COPY(node->parts[0]), da, db);
    const char *sign = strcmp(node->name, "min") == 0 ? "<" : ">=";
    return tinker_expression_if(tinker_expression_compare(sign, COPY(a), COPY(b)), da, db);
}

/* a - b floor(a/b) */
static TinkerExpression *of_mod(const TinkerExpression *node, const Rule *rule)
{
    const TinkerExpression *a = node->parts[0], *b = node->parts[1];
    TinkerExpression *da = differentiate(a, rule), *db = differentiate(b, rule);
    return MINUS(da, TIMES(CALL("floor", OVER(COPY(a), COPY(b))), db));
}

/* Of sqrt(a^2 + b^2 + ...): (a a' + b b' + ...) / sqrt(...), as one writes it; of other terms c it has c'/2. */
static TinkerExpression *of_root(const TinkerExpression *node, const Rule *rule)
{
    TinkerExpression *const inside = node->parts[0];
    const gboolean sum = inside->kind == TINKER_EXPRESSION_SUM;
    TinkerExpression *halves = N(0);
    for (int i = 0; i < (sum ? inside->count : 1); i++) {
        const TinkerExpression *term = sum ? inside->parts[i] : inside;
        const gboolean square = term->kind == TINKER_EXPRESSION_POWER && tinker_expression_is_number(term->parts[1], 2);
        TinkerExpression *half = square ? TIMES(COPY(term->parts[0]), differentiate(term->parts[0], rule))
                                        : OVER(differentiate(term, rule), N(2));
        halves = PLUS(halves, half);
    }
    return OVER(halves, COPY(node));
}

/* f' of a smooth function of one argument x; NULL where it is not one of these. */
static TinkerExpression *slope(const char *name, const TinkerExpression *node)
{
    const TinkerExpression *x = node->parts[0];
    if (strcmp(name, "sin") == 0) return CALL("cos", COPY(x));
    if (strcmp(name, "cos") == 0) return tinker_expression_negated(CALL("sin", COPY(x)));
    if (strcmp(name, "tan") == 0) return PLUS(N(1), SQUARE(COPY(node)));
    if (strcmp(name, "asin") == 0) return OVER(N(1), CALL("sqrt", MINUS(N(1), SQUARE(COPY(x)))));
    if (strcmp(name, "acos") == 0) return OVER(N(-1), CALL("sqrt", MINUS(N(1), SQUARE(COPY(x)))));
    if (strcmp(name, "atan") == 0) return OVER(N(1), PLUS(N(1), SQUARE(COPY(x))));
    if (strcmp(name, "sinh") == 0) return CALL("cosh", COPY(x));
    if (strcmp(name, "cosh") == 0) return CALL("sinh", COPY(x));
    if (strcmp(name, "tanh") == 0) return MINUS(N(1), SQUARE(COPY(node)));
    if (strcmp(name, "exp") == 0) return COPY(node);
    if (strcmp(name, "log") == 0) return OVER(N(1), COPY(x));
    if (strcmp(name, "abs") == 0)
        return tinker_expression_if(tinker_expression_compare("<", COPY(x), N(0)), N(-1), N(1));
    if (strcmp(name, "ramp") == 0) return CALL("step", COPY(x));
    if (strcmp(name, "sawtooth") == 0) return N(1 / PI);
    return NULL;
}

static TinkerExpression *of_function(const TinkerExpression *node, const Rule *rule)
{
    const char *name = node->name;
    if (strcmp(name, "if") == 0 || strcmp(name, "min") == 0 || strcmp(name, "max") == 0) return of_choice(node, rule);
    if (strcmp(name, "atan2") == 0) return of_atan2(node, rule);
    if (strcmp(name, "mod") == 0) return of_mod(node, rule);
    if (strcmp(name, "sqrt") == 0) return of_root(node, rule);
    TinkerExpression *inner = differentiate(node->parts[0], rule);
    if (tinker_expression_is_number(inner, 0)) return inner;
    TinkerExpression *outer = slope(name, node);
    /* step, pulse, square, floor */
    return TIMES(inner, outer != NULL ? outer : N(0));
}

static TinkerExpression *differentiate(const TinkerExpression *expression, const Rule *rule)
{
    TinkerExpression *sum;
    switch (expression->kind) {
    case TINKER_EXPRESSION_SYMBOL:
        sum = rule->derivative(expression->name, rule->data);
        return sum != NULL ? sum : N(0);
    case TINKER_EXPRESSION_SUM:
        sum = N(0);
        for (int i = 0; i < expression->count; i++)
            sum = PLUS(sum, differentiate(expression->parts[i], rule));
        return sum;
    case TINKER_EXPRESSION_PRODUCT:
        return of_product(expression, rule);
    case TINKER_EXPRESSION_NEGATIVE:
        return tinker_expression_negated(differentiate(expression->parts[0], rule));
    case TINKER_EXPRESSION_QUOTIENT:
        return of_quotient(expression, rule);
    case TINKER_EXPRESSION_POWER:
        return of_power(expression, rule);
    case TINKER_EXPRESSION_FUNCTION:
        return of_function(expression, rule);
    default: /* numbers; comparisons, which are constant within a piece */
        return N(0);
    }
}

TinkerExpression *tinker_expression_derivative(const TinkerExpression *expression, TinkerSymbolFunc derivative,
                                               void *data)
{
    const Rule rule = {derivative, data};
    return differentiate(expression, &rule);
}

static TinkerExpression *of_symbol(const char *symbol, void *data)
{
    return strcmp(symbol, data) == 0 ? N(1) : NULL;
}

TinkerExpression *tinker_expression_derivative_by(const TinkerExpression *expression, const char *symbol)
{
    return tinker_expression_derivative(expression, of_symbol, (void *)symbol);
}
