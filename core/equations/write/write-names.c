/* What the symbols of a page stand for: definitions, and values. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "equations/write/page-private.h"

static const TinkerDimension seconds = TINKER_DIMENSION_TIME;

static const char *name_of(const TinkerEquations *equations, TinkerBlockId block)
{
    return tinker_scene_block_name(equations->scene, block);
}

/* Whose it is, and what it means. (transfer full) */
static char *comment_of(const TinkerEquations *equations, const TinkerEquationDefinition *definition)
{
    const char *block = name_of(equations, definition->block);
    if (definition->span > 0) {
        const char *ends[2];
        for (int32_t k = 0; k < 2; k++)
            ends[k] = name_of(equations,
                              tinker_scene_end(equations->scene, definition->block, definition->span - 1 + k).block);
        return g_strdup_printf(C_("equations", "%s: span %d, from %s to %s"), block, definition->span, ends[0],
                               ends[1]);
    }
    const char *means = tinker_page_words(definition->means != NULL ? definition->means : "a step of its law");
    return definition->typed ? g_strdup_printf(C_("equations", "%s: %s, in SI"), block, means)
                             : g_strdup_printf("%s: %s", block, means);
}

static void write_laws(TinkerPage *page, GHashTable *needed)
{
    const TinkerEquations *equations = page->equations;
    gboolean first = TRUE;
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        if (!g_hash_table_contains(needed, definition->name)) continue;
        if (first) tinker_page_heading(page, C_("equations", "with"));
        first = FALSE;
        page->about = definition->block;
        char *comment = comment_of(equations, definition);
        tinker_page_equals(page, tinker_page_symbol(page, definition->name), definition->is, comment);
    }
}

static char *meaning_of(const TinkerEquations *equations, const TinkerEquationSymbol *symbol)
{
    const char *quantity = symbol->quantity;
    if (symbol->block < 0) return g_strdup(quantity != NULL ? quantity : symbol->property);
    g_autofree char *words = quantity != NULL           ? g_strdup(tinker_page_words(quantity))
                             : symbol->property != NULL ? tinker_page_property_words(equations, symbol)
                                                        : g_strdup("");
    return g_strdup_printf("%s: %s", name_of(equations, symbol->block), words);
}

static char *value_of(const TinkerPage *page, const char *name, TinkerDimension dimension, gboolean energy)
{
    g_autoptr(TinkerExpression) symbol = tinker_expression_symbol(name);
    return tinker_page_amount(page, tinker_equations_shown_value(page->equations, symbol), dimension, energy);
}

/* What is given: the values of properties. */
static void write_given(TinkerPage *page, GHashTable *needed)
{
    const TinkerEquations *equations = page->equations;
    gboolean first = TRUE;
    for (guint i = 0; i < equations->symbols->len; i++) {
        const TinkerEquationSymbol *symbol = g_ptr_array_index(equations->symbols, i);
        if (!g_hash_table_contains(needed, symbol->name) || symbol->quantity != NULL) continue;
        if (first) tinker_page_heading(page, C_("equations", "where"));
        first = FALSE;
        page->about = symbol->block;
        const char *typed = tinker_equations_typed_text(equations, symbol);
        char *value = typed != NULL ? tinker_page_typed(page, typed, symbol->value, symbol->dimension)
                                    : value_of(page, symbol->name, symbol->dimension, FALSE);
        tinker_page_equation(page, tinker_page_symbol(page, symbol->name), value, meaning_of(equations, symbol));
    }
}

void tinker_page_state(TinkerPage *page, TinkerBlockId block, char *symbol, char *value, char *comment)
{
    if (!page->in_state) {
        g_autofree char *heading = g_strdup_printf(C_("equations", "at t = %g s"), page->equations->time);
        tinker_page_heading(page, heading);
        page->in_state = TRUE;
    }
    page->about = block;
    tinker_page_equation(page, symbol, value, comment);
}

/* What the run gives: places, multipliers, and the values of definitions. */
static void write_state(TinkerPage *page, GHashTable *needed)
{
    const TinkerEquations *equations = page->equations;
    for (guint i = 0; i < equations->symbols->len; i++) {
        const TinkerEquationSymbol *symbol = g_ptr_array_index(equations->symbols, i);
        if (!g_hash_table_contains(needed, symbol->name) || symbol->quantity == NULL) continue;
        tinker_page_state(page, symbol->block, tinker_page_symbol(page, symbol->name),
                          value_of(page, symbol->name, symbol->dimension, FALSE), meaning_of(equations, symbol));
    }
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        if (!g_hash_table_contains(needed, definition->name)) continue;
        tinker_page_state(page, definition->block, tinker_page_symbol(page, definition->name),
                          value_of(page, definition->name, definition->dimension, definition->energy), NULL);
    }
    if (g_hash_table_contains(needed, "t"))
        tinker_page_state(page, TINKER_NO_BLOCK, tinker_page_symbol(page, "t"),
                          tinker_page_quantity(page, equations->time, seconds), g_strdup(C_("equations", "time")));
}

void tinker_page_names(TinkerPage *page, GHashTable *needed)
{
    tinker_equations_mark_definitions(page->equations, needed);
    write_laws(page, needed);
    write_given(page, needed);
    write_state(page, needed);
}
