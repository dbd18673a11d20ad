/* Newton's equations as a page: body by body, then the laws, the constraints, and the values. */
#include "equations/write/write.h"

#include <glib/gi18n-lib.h>
#include <stddef.h>
#include <string.h>

#include "equations/write/latex-text.h"
#include "equations/write/page-private.h"
#include "law/build.h"

static gboolean is_shown(const TinkerEquationsShown *shown, TinkerBlockId block)
{
    if (shown->blocks == NULL) return TRUE;
    for (const TinkerBlockId *each = shown->blocks; *each >= 0; each++)
        if (*each == block) return TRUE;
    return FALSE;
}

static const char *name_of(const TinkerEquations *equations, TinkerBlockId block)
{
    return tinker_scene_block_name(equations->scene, block);
}

/* One of the equations of a body. */
typedef struct {
    const char *coordinate; /* of its state */
    gsize member;           /* of a term */
    TinkerDimension dimension;
} Component;

static const Component components[] = {
    {"x", offsetof(TinkerTerm, x), {1, 1, -2, 0}},
    {"y", offsetof(TinkerTerm, y), {1, 1, -2, 0}},
    {"angle", offsetof(TinkerTerm, torque), {1, 2, -2, 0}},
};

/* Those that a body has. */
static gsize count_components(const TinkerBodyEquation *body)
{
    return body->inertia != NULL ? 3 : 2;
}

static TinkerExpression *part_of(const TinkerTerm *term, const Component *component)
{
    return *(TinkerExpression *const *)(const void *)((const char *)term + component->member);
}

/* The sum of the terms. (transfer full) */
static TinkerExpression *sum_of(const TinkerBodyEquation *body, const Component *component)
{
    TinkerExpression *sum = tinker_expression_number(0);
    for (guint i = 0; i < body->terms->len; i++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, i);
        sum = tinker_expression_plus(sum, tinker_expression_ref(part_of(term, component)));
    }
    return sum;
}

/* m x, or I θ, with two dots; the mass is a symbol or a number. */
static char *left_side(const TinkerPage *page, const TinkerBodyEquation *body, const Component *component)
{
    const gboolean turning = component->dimension.length == 2;
    g_autofree char *state = g_strconcat(name_of(page->equations, body->block), ".", component->coordinate, NULL);
    g_autofree char *mass = tinker_page_expression(page, turning ? body->inertia : body->mass);
    g_autofree char *acceleration = tinker_page_derivative(page, state, 2);
    return g_strconcat(mass, tinker_typeset_sign(page->format, '*'), acceleration, NULL);
}

/* "Gravity + Spring 0": who acts. */
static char *names_of_terms(const TinkerEquations *equations, const TinkerBodyEquation *body,
                            const Component *component)
{
    GString *names = g_string_new(NULL);
    TinkerBlockId last = -1;
    for (guint i = 0; i < body->terms->len; i++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, i);
        if (tinker_expression_is_number(part_of(term, component), 0) || term->block == last) continue;
        g_string_append_printf(names, "%s%s", names->len > 0 ? " + " : "", name_of(equations, term->block));
        last = term->block;
    }
    if (names->len == 0) g_string_append(names, component->dimension.length == 2 ? _("no torque") : _("no force"));
    return g_string_free(names, FALSE);
}

/* The equation with numbers, term by term. */
static void write_values(TinkerPage *page, const TinkerBodyEquation *body, const Component *component,
                         const TinkerExpression *sum)
{
    g_autoptr(GPtrArray) parts = g_ptr_array_new_with_free_func((GDestroyNotify)tinker_expression_unref);
    for (guint i = 0; i < body->terms->len; i++) {
        const TinkerExpression *part = part_of(&g_array_index(body->terms, TinkerTerm, i), component);
        if (!tinker_expression_is_number(part, 0))
            g_ptr_array_add(parts, tinker_expression_number(tinker_equations_shown_value(page->equations, part)));
    }
    const double result = tinker_equations_shown_value(page->equations, sum);
    char *total = tinker_page_amount(page, result, component->dimension, FALSE);
    if (parts->len > 1) {
        for (guint i = 0; i < parts->len; i++)
            tinker_expression_ref(g_ptr_array_index(parts, i));
        g_autoptr(TinkerExpression) numbers = tinker_expression_node(
            TINKER_EXPRESSION_SUM, NULL, (TinkerExpression *const *)parts->pdata, (int)parts->len);
        g_autofree char *terms = tinker_page_expression(page, numbers), *last = total;
        const char *equals = page->format == TINKER_TYPESET_MATHML ? "<mo>=</mo>" : " = ";
        total = g_strconcat(terms, equals, last, NULL);
    }
    tinker_page_equation(page, left_side(page, body, component), total, NULL);
}

/* Where nothing acts the sum is 0, of the body itself. */
static void write_terms(TinkerPage *page, const TinkerBodyEquation *body, const Component *component)
{
    gboolean any = FALSE;
    tinker_page_line_sum(page, left_side(page, body, component), (int)(component - components),
                         names_of_terms(page->equations, body, component));
    for (guint i = 0; i < body->terms->len; i++) {
        const TinkerTerm *term = &g_array_index(body->terms, TinkerTerm, i);
        if (tinker_expression_is_number(part_of(term, component), 0)) continue;
        tinker_page_line_terms(page, term->block, term->kind, part_of(term, component));
        any = TRUE;
    }
    g_autoptr(TinkerExpression) zero = tinker_expression_number(0);
    if (!any) tinker_page_line_terms(page, body->block, TINKER_TERM_FORCE, zero);
}

static void write_component(TinkerPage *page, const TinkerBodyEquation *body, const Component *component,
                            gboolean values)
{
    page->about = body->block;
    if (page->lines != NULL) {
        write_terms(page, body, component);
        return;
    }
    g_autoptr(TinkerExpression) sum = sum_of(body, component);
    tinker_page_equation(page, left_side(page, body, component), tinker_page_expression(page, sum),
                         names_of_terms(page->equations, body, component));
    if (values) write_values(page, body, component, sum);
}

/* The places of a body, whose accelerations stand on the left. */
static void mark_places(const TinkerEquations *equations, const TinkerBodyEquation *body, GHashTable *needed)
{
    for (gsize c = 0; c < count_components(body); c++) {
        g_autofree char *state = g_strconcat(name_of(equations, body->block), ".", components[c].coordinate, NULL);
        g_hash_table_add(needed, (void *)g_intern_string(state));
    }
}

/* (transfer full) */
static GHashTable *needed_names(const TinkerEquations *equations, const TinkerEquationsShown *shown)
{
    GHashTable *needed = g_hash_table_new(g_str_hash, g_str_equal);
    for (guint i = 0; i < equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(equations->bodies, i);
        if (!is_shown(shown, body->block)) continue;
        mark_places(equations, body, needed);
        tinker_equations_mark(equations, body->mass, needed);
        if (body->inertia != NULL) tinker_equations_mark(equations, body->inertia, needed);
        for (guint k = 0; k < body->terms->len; k++)
            for (gsize c = 0; c < count_components(body); c++)
                tinker_equations_mark(equations, part_of(&g_array_index(body->terms, TinkerTerm, k), &components[c]),
                                      needed);
    }
    for (guint i = 0; i < equations->constraints->len; i++) {
        const TinkerConstraintEquation *row = g_ptr_array_index(equations->constraints, i);
        if (!g_hash_table_contains(needed, row->multiplier)) continue;
        tinker_equations_mark(equations, row->g, needed);
        if (row->limit != NULL) tinker_equations_mark(equations, row->limit, needed);
    }
    return needed;
}

/* Within a comment. (transfer full) */
static char *in_text(const TinkerPage *page, const TinkerExpression *expression)
{
    const gboolean latex = page->format == TINKER_TYPESET_LATEX;
    TinkerPage plain = *page;
    plain.format = latex ? TINKER_TYPESET_LATEX : TINKER_TYPESET_TEXT;
    g_autofree char *formula = tinker_page_expression(&plain, expression);
    return latex ? g_strconcat(TINKER_LATEX_FORMULA, formula, TINKER_LATEX_TEXT, NULL) : g_steal_pointer(&formula);
}

/* "Rod (unknown λ: minus its tension)", and how far friction goes. */
static char *held_by(const TinkerPage *page, const TinkerConstraintEquation *row)
{
    const TinkerEquationSymbol *multiplier = tinker_equations_symbol(page->equations, row->multiplier);
    GString *text = g_string_new(name_of(page->equations, row->block));
    const gboolean told = strcmp(multiplier->quantity, "multiplier") != 0;
    g_autoptr(TinkerExpression) unknown = tinker_expression_symbol(row->multiplier);
    g_autofree char *name = in_text(page, unknown), *limit = row->limit != NULL ? in_text(page, row->limit) : NULL;
    g_string_append_printf(text, C_("equations", " (unknown %s: %s"), name,
                           told                                ? tinker_page_words(multiplier->quantity)
                           : multiplier->dimension.length == 1 ? C_("equations", "force")
                                                               : C_("equations", "torque"));
    if (limit != NULL) g_string_append_printf(text, C_("equations", ", sticks while |%s| ≤ %s"), name, limit);
    g_string_append_c(text, ')');
    g_string_append(text, !row->active     ? C_("equations", ", slack")
                          : row->redundant ? C_("equations", ", one of those that share the load: least norm")
                                           : "");
    return g_string_free(text, FALSE);
}

static void write_constraints(TinkerPage *page, GHashTable *needed)
{
    const TinkerEquations *equations = page->equations;
    gboolean first = TRUE;
    for (guint i = 0; i < equations->constraints->len; i++) {
        const TinkerConstraintEquation *row = g_ptr_array_index(equations->constraints, i);
        if (!g_hash_table_contains(needed, row->multiplier)) continue;
        if (first) tinker_page_heading(page, C_("equations", "held to"));
        first = FALSE;
        g_autoptr(TinkerExpression) zero = tinker_expression_number(0);
        page->about = row->block;
        tinker_page_equals(page, tinker_page_expression(page, zero), row->g, held_by(page, row));
    }
}

/* The names of all blocks of which the same is missing as of entry `first`, each once. (transfer full) */
static char *names_of_missing(const TinkerEquations *equations, guint first)
{
    const TinkerNotWritten *missing = g_ptr_array_index(equations->not_written, first);
    g_autoptr(GString) names = g_string_new(NULL);
    g_autoptr(GHashTable) named = g_hash_table_new(NULL, NULL);
    for (guint i = first; i < equations->not_written->len; i++) {
        const TinkerNotWritten *each = g_ptr_array_index(equations->not_written, i);
        if (strcmp(each->why, missing->why) != 0 || !g_hash_table_add(named, GINT_TO_POINTER(each->block))) continue;
        g_string_append_printf(names, "%s%s", names->len > 0 ? ", " : "", name_of(equations, each->block));
    }
    return g_string_free(g_steal_pointer(&names), FALSE);
}

/* Once for each reason. */
static void write_missing(TinkerPage *page)
{
    const TinkerEquations *equations = page->equations;
    g_autoptr(GHashTable) told = g_hash_table_new(g_str_hash, g_str_equal);
    for (guint i = 0; i < equations->not_written->len; i++) {
        const TinkerNotWritten *missing = g_ptr_array_index(equations->not_written, i);
        if (!g_hash_table_add(told, missing->why)) continue;
        g_autofree char *names = names_of_missing(equations, i);
        g_autofree char *sentence = g_strdup_printf(_("not written: %s (%s)"), names, tinker_page_words(missing->why));
        tinker_page_heading(page, sentence);
    }
}

void tinker_equations_put_newton(TinkerPage *page, const TinkerEquationsShown *shown)
{
    const TinkerEquations *equations = page->equations;
    for (guint i = 0; i < equations->bodies->len; i++) {
        const TinkerBodyEquation *body = g_ptr_array_index(equations->bodies, i);
        if (!is_shown(shown, body->block)) continue;
        tinker_page_heading(page, name_of(equations, body->block));
        for (gsize c = 0; c < count_components(body); c++)
            write_component(page, body, &components[c], shown->values);
    }
    g_autoptr(GHashTable) needed = needed_names(equations, shown);
    write_constraints(page, needed);
    tinker_page_names(page, needed);
    write_missing(page);
}
