/* Dimensions, worked out from the leaves. */
#include "law/dimension.h"

#include <math.h>
#include <string.h>

#include "units/quantity/units.h"

typedef struct {
    TinkerDimensionFunc of_symbol;
    void *data;
    char **why;
} Question;

static const TinkerLawDimension pure = {FALSE, 0, 0, 0};

static gboolean find(const TinkerExpression *node, const Question *question, TinkerLawDimension *dimension);

static gboolean same(const TinkerLawDimension *a, const TinkerLawDimension *b)
{
    return a->any || b->any ||
           (fabs(a->mass - b->mass) < 1e-9 && fabs(a->length - b->length) < 1e-9 && fabs(a->time - b->time) < 1e-9);
}

/* Two parts that must agree; what is any takes the other's. */
static gboolean agree(TinkerLawDimension *a, const TinkerLawDimension *b, const char *what, const Question *question)
{
    if (!same(a, b)) {
        g_autofree char *first = tinker_law_dimension_text(a), *second = tinker_law_dimension_text(b);
        *question->why = g_strdup_printf("%s of %s and %s", what, first, second);
        return FALSE;
    }
    if (a->any) *a = *b;
    return TRUE;
}

static gboolean all_agree(const TinkerExpression *node, int from, const char *what, const Question *question,
                          TinkerLawDimension *dimension)
{
    *dimension = (TinkerLawDimension){.any = TRUE};
    for (int i = from; i < node->count; i++) {
        TinkerLawDimension part;
        if (!find(node->parts[i], question, &part) || !agree(dimension, &part, what, question)) return FALSE;
    }
    return TRUE;
}

static void add(TinkerLawDimension *dimension, const TinkerLawDimension *part, double factor)
{
    dimension->any = dimension->any || part->any;
    dimension->mass += factor * part->mass;
    dimension->length += factor * part->length;
    dimension->time += factor * part->time;
}

static gboolean of_product(const TinkerExpression *node, const Question *question, TinkerLawDimension *dimension)
{
    *dimension = pure;
    for (int i = 0; i < node->count; i++) {
        TinkerLawDimension part;
        if (!find(node->parts[i], question, &part)) return FALSE;
        add(dimension, &part, i > 0 && node->kind == TINKER_EXPRESSION_QUOTIENT ? -1 : 1);
    }
    return TRUE;
}

static gboolean of_power(const TinkerExpression *node, const Question *question, TinkerLawDimension *dimension)
{
    TinkerLawDimension base, exponent;
    if (!find(node->parts[0], question, &base) || !find(node->parts[1], question, &exponent)) return FALSE;
    if (!agree(&exponent, &pure, "an exponent", question)) return FALSE;
    const TinkerExpression *power = node->parts[1];
    const gboolean negative = power->kind == TINKER_EXPRESSION_NEGATIVE;
    const TinkerExpression *number = negative ? power->parts[0] : power;
    *dimension = pure;
    if (number->kind != TINKER_EXPRESSION_NUMBER) return agree(&base, &pure, "a power that varies,", question);
    add(dimension, &base, negative ? -number->number : number->number);
    return TRUE;
}

static gboolean of_function(const TinkerExpression *node, const Question *question, TinkerLawDimension *dimension)
{
    static const char *const keep[] = {"abs", "ramp", "min", "max", "mod", NULL};
    static const char *const compare[] = {"atan2", "pulse", "step", NULL};
    if (strcmp(node->name, "if") == 0) {
        TinkerLawDimension condition;
        return find(node->parts[0], question, &condition) && all_agree(node, 1, "branches", question, dimension);
    }
    if (!all_agree(node, 0, node->name, question, dimension)) return FALSE;
    if (g_strv_contains(keep, node->name)) return TRUE;
    if (strcmp(node->name, "sqrt") == 0) {
        dimension->mass /= 2;
        dimension->length /= 2;
        dimension->time /= 2;
        return TRUE;
    }
    if (!g_strv_contains(compare, node->name) && !agree(dimension, &pure, node->name, question)) return FALSE;
    *dimension = pure;
    return TRUE;
}

static gboolean of_symbol(const TinkerExpression *node, const Question *question, TinkerLawDimension *dimension)
{
    TinkerDimension found;
    if (!question->of_symbol(node->name, &found, question->data)) {
        *question->why = g_strdup_printf("\"%s\" has no dimension", node->name);
        return FALSE;
    }
    *dimension = (TinkerLawDimension){FALSE, found.mass, found.length, found.time};
    return TRUE;
}

static gboolean find(const TinkerExpression *node, const Question *question, TinkerLawDimension *dimension)
{
    switch (node->kind) {
    case TINKER_EXPRESSION_NUMBER:
        *dimension = pure;
        dimension->any = node->number == 0;
        return TRUE;
    case TINKER_EXPRESSION_SYMBOL:
        return of_symbol(node, question, dimension);
    case TINKER_EXPRESSION_SUM:
        return all_agree(node, 0, "a sum", question, dimension);
    case TINKER_EXPRESSION_PRODUCT:
    case TINKER_EXPRESSION_QUOTIENT:
        return of_product(node, question, dimension);
    case TINKER_EXPRESSION_NEGATIVE:
        return find(node->parts[0], question, dimension);
    case TINKER_EXPRESSION_POWER:
        return of_power(node, question, dimension);
    case TINKER_EXPRESSION_COMPARISON:
        if (!all_agree(node, 0, "a comparison", question, dimension)) return FALSE;
        *dimension = pure;
        return TRUE;
    default:
        return of_function(node, question, dimension);
    }
}

gboolean tinker_expression_dimension(const TinkerExpression *expression, TinkerDimensionFunc symbols, void *data,
                                     TinkerLawDimension *dimension, char **why)
{
    const Question question = {symbols, data, why};
    *why = NULL;
    return find(expression, &question, dimension);
}

gboolean tinker_law_dimension_is(const TinkerLawDimension *found, TinkerDimension wanted)
{
    const TinkerLawDimension other = {FALSE, wanted.mass, wanted.length, wanted.time};
    return same(found, &other);
}

char *tinker_law_dimension_text(const TinkerLawDimension *dimension)
{
    const double whole[] = {round(dimension->mass), round(dimension->length), round(dimension->time)};
    if (dimension->any) return g_strdup("0");
    if (whole[0] != dimension->mass || whole[1] != dimension->length || whole[2] != dimension->time)
        return g_strdup_printf("kg^%g m^%g s^%g", dimension->mass, dimension->length, dimension->time);
    const char *symbol =
        tinker_unit_si_symbol((TinkerDimension){(int8_t)whole[0], (int8_t)whole[1], (int8_t)whole[2], 0});
    return g_strdup(symbol[0] != '\0' ? symbol : "1");
}
