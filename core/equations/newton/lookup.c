/* Names looked up: what they stand for, how they look, what their values are. */
#include <string.h>

#include "equations/newton/writer.h"
#include "law/value.h"

const TinkerEquationDefinition *tinker_equations_definition(const TinkerEquations *equations, const char *name)
{
    for (guint i = 0; i < equations->definitions->len; i++) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i);
        if (strcmp(definition->name, name) == 0) return definition;
    }
    return NULL;
}

const TinkerEquationSymbol *tinker_equations_symbol(const TinkerEquations *equations, const char *name)
{
    for (guint i = 0; i < equations->symbols->len; i++) {
        const TinkerEquationSymbol *symbol = g_ptr_array_index(equations->symbols, i);
        if (strcmp(symbol->name, name) == 0) return symbol;
    }
    return NULL;
}

const char *tinker_equations_typed_text(const TinkerEquations *equations, const TinkerEquationSymbol *symbol)
{
    const TinkerBlockClass *block_class =
        symbol->block >= 0 ? tinker_scene_block_class(equations->scene, symbol->block) : NULL;
    const int32_t property = block_class != NULL && symbol->property != NULL
                                 ? tinker_block_class_property(block_class, symbol->property)
                                 : -1;
    if (property < 0 || (block_class->properties[property].flags & TINKER_TEXT_QUANTITY) == 0) return NULL;
    return tinker_scene_get_text(equations->scene, symbol->block, property);
}

gboolean tinker_equations_is_not_written(const TinkerEquations *equations, const char *symbol)
{
    for (guint i = 0; i < equations->not_written->len; i++) {
        const TinkerNotWritten *missing = g_ptr_array_index(equations->not_written, i);
        for (guint k = 0; k < missing->symbols->len; k++)
            if (strcmp(g_ptr_array_index(missing->symbols, k), symbol) == 0) return TRUE;
    }
    return FALSE;
}

void tinker_equations_look(const char *symbol, TinkerSymbolLook *look, void *data)
{
    const TinkerEquations *equations = data;
    const TinkerEquationLook *known = g_hash_table_lookup(equations->looks, symbol);
    *look = known != NULL ? (TinkerSymbolLook){known->stem, known->index, known->dots, known->component}
                          : (TinkerSymbolLook){symbol, "", 0, NULL};
}

void tinker_equations_mark(const TinkerEquations *equations, const TinkerExpression *expression, GHashTable *needed)
{
    for (int i = 0; i < expression->count; i++)
        tinker_equations_mark(equations, expression->parts[i], needed);
    if (expression->kind == TINKER_EXPRESSION_SYMBOL) g_hash_table_add(needed, (void *)expression->name);
}

void tinker_equations_mark_definitions(const TinkerEquations *equations, GHashTable *needed)
{
    for (guint i = equations->definitions->len; i > 0; i--) {
        const TinkerEquationDefinition *definition = g_ptr_array_index(equations->definitions, i - 1);
        if (g_hash_table_contains(needed, definition->name)) tinker_equations_mark(equations, definition->is, needed);
    }
}

void tinker_equations_set_value(TinkerEquations *equations, const char *name, double value)
{
    double *kept = g_new(double, 1);
    *kept = value;
    g_hash_table_insert(equations->values, g_strdup(name), kept);
}

static double value_of(const char *symbol, void *data)
{
    const double *value = g_hash_table_lookup(((const TinkerEquations *)data)->values, symbol);
    return value != NULL ? *value : 0;
}

double tinker_equations_value(const TinkerEquations *equations, const TinkerExpression *expression)
{
    return tinker_expression_value(expression, value_of, (void *)equations);
}

const char *tinker_term_kind_name(TinkerTermKind kind)
{
    static const char *const names[] = {"connector", "constraint", "force", "field", "normal", "friction"};
    return names[kind];
}
