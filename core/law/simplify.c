/* A product is a fraction of numbers and a list of factors, each a base with an exponent; a sum a list of products.
 * What an expression is made of is sorted into such lists, and put together again. */
#include "law/simplify.h"

#include <math.h>
#include <string.h>

#include "law/build.h"

#define LARGEST 1e9 /* of whole numbers that are factors */

typedef struct {
    TinkerExpression *base;
    double power;
} Factor;

/* above / below times the factors. */
typedef struct {
    double above, below;
    GArray *factors; /* of Factor, as they are met */
} Term;

static void factor_clear(void *factor)
{
    tinker_expression_unref(((Factor *)factor)->base);
}

static void term_clear(void *term)
{
    g_array_unref(((Term *)term)->factors);
}

static Term term_new(void)
{
    const Term term = {1, 1, g_array_new(FALSE, FALSE, sizeof(Factor))};
    g_array_set_clear_func(term.factors, factor_clear);
    return term;
}

static const Factor *factor_at(const Term *term, guint number)
{
    return &g_array_index(term->factors, Factor, number);
}

static Term *term_at(const GArray *terms, guint number)
{
    return &g_array_index(terms, Term, number);
}

static gboolean is_whole(double number)
{
    return number == floor(number) && fabs(number) <= LARGEST;
}

static double common_divisor(double a, double b)
{
    return b == 0 ? fabs(a) : common_divisor(b, fmod(a, b));
}

static GArray *terms_of(const TinkerExpression *expression);
static TinkerExpression *sum_of(const GArray *terms);

/* Products ----------------------------------------------------------------------------------------------------------*/

/* Takes the base over. */
static void multiply(Term *term, TinkerExpression *base, double power)
{
    for (guint i = 0; i < term->factors->len; i++) {
        Factor *factor = &g_array_index(term->factors, Factor, i);
        if (!tinker_expression_equal(factor->base, base)) continue;
        tinker_expression_unref(base);
        factor->power += power;
        if (factor->power == 0) g_array_remove_index(term->factors, i);
        return;
    }
    const Factor factor = {base, power};
    g_array_append_val(term->factors, factor);
}

static void multiply_number(Term *term, double number, double power)
{
    *(power > 0 ? &term->above : &term->below) *= pow(number, fabs(power));
}

/* A whole number that is in all terms comes before the bracket, and so does a sign that all have; one that begins with
 * minus begins with another of its terms. */
static void multiply_sum(Term *term, GArray *terms, double power)
{
    double common = 0;
    guint negative = 0, positive = terms->len; /* how many are, and the first that is */
    for (guint i = 0; i < terms->len; i++) {
        const Term *part = term_at(terms, i);
        common = is_whole(part->above) && part->below == 1 ? common_divisor(common, part->above) : 1;
        if (part->above < 0)
            negative++;
        else
            positive = MIN(positive, i);
    }
    if (negative == terms->len) common = -common;
    for (guint i = 0; i < terms->len; i++)
        term_at(terms, i)->above /= common;
    if (positive < terms->len && positive > 0) {
        const Term leading = *term_at(terms, positive);
        memmove(term_at(terms, 1), term_at(terms, 0), positive * sizeof(Term));
        *term_at(terms, 0) = leading;
    }
    multiply_number(term, common, power);
    multiply(term, sum_of(terms), power);
}

/* Not where numbers divide by 0, or become too large. */
static gboolean is_sound(const GArray *terms)
{
    for (guint i = 0; i < terms->len; i++)
        if (!isfinite(term_at(terms, i)->above) || !isnormal(term_at(terms, i)->below)) return FALSE;
    return TRUE;
}

static TinkerExpression *with_simple_parts(const TinkerExpression *node)
{
    const gboolean choice = node->kind == TINKER_EXPRESSION_FUNCTION && strcmp(node->name, "if") == 0;
    g_autofree TinkerExpression **parts = g_new(TinkerExpression *, (gsize)node->count);
    for (int i = 0; i < node->count; i++)
        parts[i] =
            choice && i == 0 ? tinker_expression_ref(node->parts[i]) : tinker_expression_simplified(node->parts[i]);
    return tinker_expression_node(node->kind, node->name, parts, node->count);
}

/* Multiplies by the expression to a power that is a whole number. */
static void multiply_by(Term *term, const TinkerExpression *node, double power)
{
    const gboolean by_number =
        node->kind == TINKER_EXPRESSION_POWER && node->parts[1]->kind == TINKER_EXPRESSION_NUMBER;
    if (node->kind == TINKER_EXPRESSION_NUMBER) {
        multiply_number(term, node->number, power);
    } else if (node->kind == TINKER_EXPRESSION_NEGATIVE) {
        multiply_number(term, -1, power);
        multiply_by(term, node->parts[0], power);
    } else if (node->kind == TINKER_EXPRESSION_PRODUCT) {
        for (int i = 0; i < node->count; i++)
            multiply_by(term, node->parts[i], power);
    } else if (node->kind == TINKER_EXPRESSION_QUOTIENT) {
        multiply_by(term, node->parts[0], power);
        multiply_by(term, node->parts[1], -power);
    } else if (by_number && is_whole(node->parts[1]->number) && node->parts[1]->number != 0) {
        multiply_by(term, node->parts[0], power * node->parts[1]->number);
    } else if (by_number) {
        multiply(term, tinker_expression_simplified(node->parts[0]), power * node->parts[1]->number);
    } else if (node->kind == TINKER_EXPRESSION_FUNCTION && strcmp(node->name, "sqrt") == 0) {
        multiply(term, tinker_expression_simplified(node->parts[0]), power / 2);
    } else if (node->kind == TINKER_EXPRESSION_SUM) {
        g_autoptr(GArray) terms = terms_of(node);
        if (!is_sound(terms)) {
            multiply(term, tinker_expression_ref(node), power);
        } else if (terms->len > 1) {
            multiply_sum(term, terms, power);
        } else {
            g_autoptr(TinkerExpression) one = sum_of(terms);
            multiply_by(term, one, power);
        }
    } else {
        multiply(term, node->count == 0 ? tinker_expression_ref(node) : with_simple_parts(node), power);
    }
}

/* Letters before brackets, and these before functions and roots. */
static int rank_of(const Factor *factor)
{
    if (factor->base->kind == TINKER_EXPRESSION_SYMBOL && is_whole(factor->power)) return 0;
    return factor->base->kind == TINKER_EXPRESSION_SUM && is_whole(factor->power) ? 1 : 2;
}

static TinkerExpression *power_of(const TinkerExpression *base, double power)
{
    TinkerExpression *is = tinker_expression_ref(base);
    if (power == 1) return is;
    if (power == 0.5) return tinker_expression_node(TINKER_EXPRESSION_FUNCTION, "sqrt", &is, 1);
    TinkerExpression *exponent = tinker_expression_number(power);
    if (!is_whole(power) && is_whole(2 * power)) {
        TinkerExpression *halves[] = {tinker_expression_number(2 * power), tinker_expression_number(2)};
        tinker_expression_unref(exponent);
        exponent = tinker_expression_node(TINKER_EXPRESSION_QUOTIENT, NULL, halves, 2);
    }
    TinkerExpression *parts[] = {is, exponent};
    return tinker_expression_node(TINKER_EXPRESSION_POWER, NULL, parts, 2);
}

/* What stands above the line, sign 1, or below it. (transfer full) */
static TinkerExpression *side_of(const Term *term, double number, int sign)
{
    g_autoptr(GPtrArray) parts = g_ptr_array_new();
    if (number != 1) g_ptr_array_add(parts, tinker_expression_number(number));
    for (int rank = 0; rank < 3; rank++)
        for (guint i = 0; i < term->factors->len; i++)
            if (rank_of(factor_at(term, i)) == rank && factor_at(term, i)->power * sign > 0)
                g_ptr_array_add(parts, power_of(factor_at(term, i)->base, fabs(factor_at(term, i)->power)));
    if (parts->len == 0) return tinker_expression_number(1);
    if (parts->len == 1) return g_ptr_array_index(parts, 0);
    return tinker_expression_node(TINKER_EXPRESSION_PRODUCT, NULL, (TinkerExpression *const *)parts->pdata,
                                  (int)parts->len);
}

/* In lowest terms, or as one number where it is one exactly; the sign is above. */
static void reduce(Term *term)
{
    if (term->below < 0) {
        term->above = -term->above;
        term->below = -term->below;
    }
    const double quotient = term->above / term->below;
    double common = 1;
    if (is_whole(term->above) && is_whole(term->below))
        common = common_divisor(term->above, term->below);
    else if (quotient * term->below == term->above)
        common = term->below;
    term->above /= common;
    term->below /= common;
}

static TinkerExpression *product_of(const Term *term)
{
    TinkerExpression *sides[] = {side_of(term, fabs(term->above), 1), side_of(term, term->below, -1)};
    TinkerExpression *is = sides[0];
    if (tinker_expression_is_number(sides[1], 1))
        tinker_expression_unref(sides[1]);
    else
        is = tinker_expression_node(TINKER_EXPRESSION_QUOTIENT, NULL, sides, 2);
    return term->above < 0 ? tinker_expression_negated(is) : is;
}

/* Sums ------------------------------------------------------------------------------------------------------------- */

static gboolean same_factors(const Term *a, const Term *b)
{
    guint found = 0;
    for (guint i = 0; i < a->factors->len; i++)
        for (guint k = 0; k < b->factors->len; k++)
            found += factor_at(a, i)->power == factor_at(b, k)->power &&
                     tinker_expression_equal(factor_at(a, i)->base, factor_at(b, k)->base);
    return a->factors->len == b->factors->len && found == a->factors->len;
}

/* Takes the term over. */
static void add_term(GArray *terms, Term term)
{
    reduce(&term);
    for (guint i = 0; i < terms->len; i++) {
        Term *known = term_at(terms, i);
        if (!same_factors(known, &term)) continue;
        known->above = known->below == term.below ? known->above + term.above
                                                  : known->above * term.below + term.above * known->below;
        known->below *= known->below == term.below ? 1 : term.below;
        reduce(known);
        term_clear(&term);
        if (known->above == 0) g_array_remove_index(terms, i);
        return;
    }
    if (term.above != 0)
        g_array_append_val(terms, term);
    else
        term_clear(&term);
}

static void add_terms_of(GArray *terms, const TinkerExpression *node, double sign)
{
    if (node->kind == TINKER_EXPRESSION_NEGATIVE) {
        add_terms_of(terms, node->parts[0], -sign);
    } else if (node->kind == TINKER_EXPRESSION_SUM) {
        for (int i = 0; i < node->count; i++)
            add_terms_of(terms, node->parts[i], sign);
    } else {
        Term term = term_new();
        multiply_by(&term, node, 1);
        term.above *= sign;
        add_term(terms, term);
    }
}

/* (transfer full) */
static GArray *terms_of(const TinkerExpression *expression)
{
    GArray *terms = g_array_new(FALSE, FALSE, sizeof(Term));
    g_array_set_clear_func(terms, term_clear);
    add_terms_of(terms, expression, 1);
    return terms;
}

static TinkerExpression *sum_of(const GArray *terms)
{
    if (terms->len == 0) return tinker_expression_number(0);
    g_autoptr(GPtrArray) parts = g_ptr_array_new();
    for (guint i = 0; i < terms->len; i++)
        g_ptr_array_add(parts, product_of(term_at(terms, i)));
    if (parts->len == 1) return g_ptr_array_index(parts, 0);
    return tinker_expression_node(TINKER_EXPRESSION_SUM, NULL, (TinkerExpression *const *)parts->pdata,
                                  (int)parts->len);
}

TinkerExpression *tinker_expression_simplified(const TinkerExpression *expression)
{
    if (expression->count == 0 || expression->kind == TINKER_EXPRESSION_COMPARISON)
        return tinker_expression_ref(expression);
    g_autoptr(GArray) terms = terms_of(expression);
    return is_sound(terms) ? sum_of(terms) : tinker_expression_ref(expression);
}
