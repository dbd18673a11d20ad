#include "law/collect.h"

#include "law/build.h"

/* A term, as factors with a sign before them. */
typedef struct {
    gboolean negative;
    GPtrArray *factors; /* of TinkerExpression, owned */
} Term;

typedef struct {
    TinkerApartFunc apart; /* NULL: nothing is */
    void *data;
} Question;

static GPtrArray *factors_new(void)
{
    return g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
}

static Term term_of(const TinkerExpression *expression)
{
    Term term = {expression->kind == TINKER_EXPRESSION_NEGATIVE, factors_new()};
    const TinkerExpression *size = term.negative ? expression->parts[0] : expression;
    const gboolean product = size->kind == TINKER_EXPRESSION_PRODUCT;
    for (int i = 0; i < (product ? size->count : 1); i++)
        g_ptr_array_add(term.factors, tinker_expression_ref(product ? size->parts[i] : size));
    return term;
}

static void term_clear(void *term)
{
    g_ptr_array_unref(((Term *)term)->factors);
}

static TinkerExpression *expression_of(const Term *term, gboolean negative)
{
    TinkerExpression *product = tinker_expression_number(1);
    for (guint i = 0; i < term->factors->len; i++)
        product = tinker_expression_times(product, tinker_expression_ref(g_ptr_array_index(term->factors, i)));
    return negative ? tinker_expression_negated(product) : product;
}

/* Where a factor stands; -1: nowhere. */
static int place_of(const GPtrArray *factors, const TinkerExpression *factor)
{
    for (guint i = 0; i < factors->len; i++)
        if (tinker_expression_equal(g_ptr_array_index(factors, i), factor)) return (int)i;
    return -1;
}

/* Takes a factor out; FALSE where it is none. */
static gboolean take(GPtrArray *factors, const TinkerExpression *factor)
{
    const int place = place_of(factors, factor);
    if (place >= 0) g_ptr_array_remove_index(factors, (guint)place);
    return place >= 0;
}

static GPtrArray *copy_of(const GPtrArray *factors)
{
    GPtrArray *copy = factors_new();
    for (guint i = 0; i < factors->len; i++)
        g_ptr_array_add(copy, tinker_expression_ref(g_ptr_array_index(factors, i)));
    return copy;
}

/* What the first has and the second has not. (transfer full) */
static GPtrArray *left_over(const GPtrArray *first, const GPtrArray *second)
{
    GPtrArray *left = factors_new();
    g_autoptr(GPtrArray) others = copy_of(second);
    for (guint i = 0; i < first->len; i++)
        if (!take(others, g_ptr_array_index(first, i)))
            g_ptr_array_add(left, tinker_expression_ref(g_ptr_array_index(first, i)));
    return left;
}

static gboolean any_apart(const Question *question, GPtrArray *factors)
{
    gboolean any = FALSE;
    for (guint i = 0; i < factors->len; i++)
        any = any || question->apart(g_ptr_array_index(factors, i), question->data);
    g_ptr_array_unref(factors);
    return any;
}

/* Whether a term goes with the first of others, where this is what it has in common with them. */
static gboolean goes_with(const Question *question, const Term *first, const Term *term, const GPtrArray *shared)
{
    const guint count = first->factors->len;
    if (shared->len == 0) return FALSE;
    if (question->apart == NULL) return term->factors->len == count && shared->len + 1 >= count;
    return !any_apart(question, left_over(first->factors, shared)) &&
           !any_apart(question, left_over(term->factors, shared));
}

static TinkerExpression *collected(const Question *question, GArray *terms);

/* The terms as one: what they have in common, which is added to, and the sum of the rest where the first of it stood.
 */
static TinkerExpression *together(const GArray *terms, GPtrArray *common)
{
    static const Question rest_question = {NULL, NULL};
    const Term *first = &g_array_index(terms, Term, 0);
    const gboolean negative = first->negative;
    guint place = 0;
    while (place < common->len && tinker_expression_equal(common->pdata[place], first->factors->pdata[place]))
        place++;
    g_autoptr(GArray) rests = g_array_new(FALSE, FALSE, sizeof(Term));
    g_array_set_clear_func(rests, term_clear);
    for (guint i = 0; i < terms->len; i++) {
        const Term *term = &g_array_index(terms, Term, i);
        const Term rest = {term->negative != negative, left_over(term->factors, common)};
        g_array_append_val(rests, rest);
    }
    g_ptr_array_insert(common, (int)place, collected(&rest_question, rests));
    const Term whole = {negative, common};
    return expression_of(&whole, negative);
}

/* Takes the first term and those that go with it; `common` is filled with what they share. (transfer full) */
static GArray *take_alike(const Question *question, GArray *terms, GPtrArray **common)
{
    GArray *alike = g_array_new(FALSE, FALSE, sizeof(Term));
    g_array_set_clear_func(alike, term_clear);
    *common = copy_of(g_array_index(terms, Term, 0).factors);
    for (guint i = 0; i < terms->len;) {
        const Term term = g_array_index(terms, Term, i);
        g_autoptr(GPtrArray) others = left_over(*common, term.factors), shared = left_over(*common, others);
        if (alike->len > 0 && !goes_with(question, &g_array_index(alike, Term, 0), &term, shared)) {
            i++;
            continue;
        }
        g_ptr_array_unref(*common);
        *common = g_steal_pointer(&shared);
        const Term kept = {term.negative, g_ptr_array_ref(term.factors)};
        g_array_append_val(alike, kept);
        g_array_remove_index(terms, i);
    }
    return alike;
}

/* Uses the terms up. (transfer full) */
static TinkerExpression *collected(const Question *question, GArray *terms)
{
    TinkerExpression *sum = tinker_expression_number(0);
    while (terms->len > 0) {
        g_autoptr(GPtrArray) common = NULL;
        g_autoptr(GArray) alike = take_alike(question, terms, &common);
        const Term *first = &g_array_index(alike, Term, 0);
        sum = tinker_expression_plus(sum,
                                     alike->len > 1 ? together(alike, common) : expression_of(first, first->negative));
    }
    return sum;
}

TinkerExpression *tinker_expression_collected(const TinkerExpression *sum, TinkerApartFunc apart, void *data)
{
    const Question question = {apart, data};
    g_autoptr(GArray) terms = g_array_new(FALSE, FALSE, sizeof(Term));
    const gboolean many = sum->kind == TINKER_EXPRESSION_SUM;
    g_array_set_clear_func(terms, term_clear);
    for (int i = 0; i < (many ? sum->count : 1); i++) {
        const Term term = term_of(many ? sum->parts[i] : sum);
        g_array_append_val(terms, term);
    }
    return collected(&question, terms);
}
