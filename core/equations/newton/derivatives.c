/* Derivatives through definitions, by a symbol or by time. */
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"
#include "law/derivative.h"
#include "law/reduce.h"
#include "law/simplify.h"

/* What a derivative is taken by: a symbol, or time where it is NULL. */
typedef struct {
    TinkerEquationWriter *writer;
    const char *by;
} Derivative;

/* The velocity of a body's place: "Mass 0.x" to "Mass 0.vx", "Bar 0.angle" to "Bar 0.rate". */
static TinkerExpression *velocity_of(const TinkerEquationWriter *writer, const char *symbol)
{
    const char *dot = strrchr(symbol, '.');
    if (dot == NULL) return NULL;
    const char *rate = strcmp(dot, ".x") == 0       ? "vx"
                       : strcmp(dot, ".y") == 0     ? "vy"
                       : strcmp(dot, ".angle") == 0 ? "rate"
                                                    : NULL;
    if (rate == NULL) return NULL;
    g_autofree char *velocity = g_strdup_printf("%.*s.%s", (int)(dot - symbol), symbol, rate);
    return g_hash_table_contains(writer->equations->values, velocity) ? tinker_expression_symbol(velocity) : NULL;
}

/* The derivative by time of what is known by values; NULL: the symbol is of none. */
static TinkerExpression *sampled_rate(TinkerEquationWriter *writer, const char *symbol)
{
    TinkerSampledSymbol *known = g_hash_table_lookup(writer->sampled, symbol);
    if (known == NULL || known->dots == 2) return NULL;
    if (known->rate != NULL) return tinker_expression_symbol(known->rate);
    TinkerSampledSymbol next = *known;
    next.dots++;
    next.dimension.time--;
    TinkerExpression *rate = tinker_writer_sampled(writer, &next, next.dots == 1 ? "its velocity" : "its acceleration");
    known->rate = g_intern_string(rate->name);
    return rate;
}

static TinkerExpression *derivative_of(const char *symbol, void *data)
{
    const Derivative *asked = data;
    if (asked->by != NULL ? strcmp(symbol, asked->by) == 0 : strcmp(symbol, "t") == 0)
        return tinker_expression_number(1);
    const TinkerEquationDefinition *definition = g_hash_table_lookup(asked->writer->by_name, symbol);
    if (definition == NULL) {
        if (asked->by != NULL) return NULL;
        TinkerExpression *rate = sampled_rate(asked->writer, symbol);
        return rate != NULL ? rate : velocity_of(asked->writer, symbol);
    }
    if (asked->by != NULL && g_hash_table_contains(asked->writer->places, symbol)) return NULL;
    TinkerExpression *found = tinker_expression_derivative(definition->is, derivative_of, data);
    /* that of a distance L has L below the line, which has a name */
    const gboolean negative = found->kind == TINKER_EXPRESSION_NEGATIVE;
    const TinkerExpression *quotient = negative ? found->parts[0] : found;
    if (quotient->kind != TINKER_EXPRESSION_QUOTIENT || !tinker_expression_equal(quotient->parts[1], definition->is))
        return found;
    TinkerExpression *shorter =
        tinker_expression_over(tinker_expression_ref(quotient->parts[0]), tinker_expression_symbol(symbol));
    tinker_expression_unref(found);
    return negative ? tinker_expression_negated(shorter) : shorter;
}

TinkerExpression *tinker_writer_derivative(TinkerEquationWriter *writer, const TinkerExpression *expression,
                                           const char *symbol)
{
    Derivative asked = {writer, symbol};
    g_autoptr(TinkerExpression) raw = tinker_expression_derivative(expression, derivative_of, &asked);
    return tinker_expression_reduced(raw);
}

TinkerExpression *tinker_writer_slope(TinkerEquationWriter *writer, const TinkerExpression *potential,
                                      const char *symbol, int sign)
{
    g_autoptr(TinkerExpression) slope = tinker_writer_derivative(writer, potential, symbol);
    g_autoptr(TinkerExpression) raw =
        sign < 0 ? tinker_expression_negated(g_steal_pointer(&slope)) : g_steal_pointer(&slope);
    TinkerExpression *simple = tinker_expression_simplified(raw);
    /* powers that stand apart may be beyond what a number can be where their quotient is not */
    const gboolean lost = !isfinite(tinker_equations_value(writer->equations, simple)) &&
                          isfinite(tinker_equations_value(writer->equations, raw));
    if (!lost) return simple;
    tinker_expression_unref(simple);
    return g_steal_pointer(&raw);
}

TinkerExpression *tinker_writer_rate(TinkerEquationWriter *writer, const TinkerExpression *expression)
{
    return tinker_writer_derivative(writer, expression, NULL);
}
