/* Symbols and definitions. */
#include <string.h>

#include "equations/newton/writer.h"

const TinkerDimension tinker_length_dimension = {0, 1, 0, 0}, tinker_velocity_dimension = {0, 1, -1, 0},
                      tinker_force_dimension = {1, 1, -2, 0}, tinker_pure_dimension = {0, 0, 0, 0},
                      tinker_torque_dimension = {1, 2, -2, 0}, tinker_angle_dimension = {0, 0, 0, 1};

TinkerExpression *tinker_writer_symbol(TinkerEquationWriter *writer, const char *name, TinkerBlockId block,
                                       double value, TinkerDimension dimension, const char *property,
                                       const char *quantity)
{
    TinkerEquationSymbol *symbol = g_new0(TinkerEquationSymbol, 1);
    *symbol = (TinkerEquationSymbol){g_strdup(name), value, dimension, block, g_strdup(property), quantity};
    g_ptr_array_add(writer->equations->symbols, symbol);
    tinker_equations_set_value(writer->equations, name, value);
    return tinker_expression_symbol(name);
}

TinkerExpression *tinker_writer_known_property(const TinkerEquationWriter *writer, TinkerBlockId block, const char *key)
{
    for (guint i = 0; i < writer->equations->symbols->len; i++) {
        const TinkerEquationSymbol *known = g_ptr_array_index(writer->equations->symbols, i);
        if (known->block == block && g_strcmp0(known->property, key) == 0) return tinker_expression_symbol(known->name);
    }
    return NULL;
}

TinkerExpression *tinker_writer_property(TinkerEquationWriter *writer, TinkerBlockId block, int32_t property,
                                         int32_t component, const char *stem)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
    const TinkerPropertyType *type = &block_class->properties[property];
    const double value = tinker_frame_column(writer->frame, block, block_class->first_columns[property] + component);
    if (value == 0) return tinker_expression_number(0);
    const gboolean vector = type->kind == TINKER_KIND_VECTOR;
    g_autofree char *key = vector ? g_strconcat(type->id, component == 0 ? " x" : " y", NULL) : g_strdup(type->id);
    TinkerExpression *known = tinker_writer_known_property(writer, block, key);
    if (known != NULL) return known;
    const char *name = tinker_writer_name(writer, block, stem, 0, NULL);
    return tinker_writer_symbol(writer, name, block, value, type->dimension, key, NULL);
}

TinkerExpression *tinker_writer_meaning(TinkerEquationWriter *writer, TinkerBlockId block, int32_t meaning,
                                        int32_t component, const char *stem)
{
    const int32_t property = tinker_scene_block_class(writer->scene, block)->meanings[meaning];
    return property < 0 ? tinker_expression_number(0)
                        : tinker_writer_property(writer, block, property, component, stem);
}

TinkerExpression *tinker_writer_define(TinkerEquationWriter *writer, const char *name, TinkerBlockId block,
                                       TinkerDimension dimension, const char *means, TinkerExpression *is,
                                       gboolean typed)
{
    TinkerEquationDefinition *definition = g_new0(TinkerEquationDefinition, 1);
    *definition = (TinkerEquationDefinition){.name = g_strdup(name),
                                             .block = block,
                                             .dimension = dimension,
                                             .means = g_strdup(means),
                                             .energy = means != NULL && strcmp(means, TINKER_STORED_ENERGY) == 0,
                                             .is = is,
                                             .typed = typed,
                                             .value = tinker_equations_value(writer->equations, is)};
    g_ptr_array_add(writer->equations->definitions, definition);
    g_hash_table_insert(writer->by_name, definition->name, definition);
    tinker_equations_set_value(writer->equations, name, definition->value);
    return tinker_expression_symbol(name);
}

void tinker_writer_drop_definitions(TinkerEquationWriter *writer, guint from)
{
    GPtrArray *definitions = writer->equations->definitions;
    for (guint i = from; i < definitions->len; i++)
        g_hash_table_remove(writer->by_name, ((TinkerEquationDefinition *)g_ptr_array_index(definitions, i))->name);
    g_ptr_array_set_size(definitions, (int)from);
}

TinkerExpression *tinker_writer_valued(TinkerEquationWriter *writer, const TinkerSampledSymbol *is, const char *means)
{
    const char *name = tinker_writer_name(writer, is->block, is->stem, is->dots, is->component);
    tinker_writer_note_unwritten(writer, is->block, name, is->why);
    return tinker_writer_symbol(writer, name, is->block, is->values[is->dots], is->dimension, NULL, means);
}

TinkerExpression *tinker_writer_sampled(TinkerEquationWriter *writer, const TinkerSampledSymbol *is, const char *means)
{
    TinkerExpression *symbol = tinker_writer_valued(writer, is, means);
    TinkerSampledSymbol *kept = g_memdup2(is, sizeof *is);
    kept->stem = g_intern_string(is->stem);
    kept->rate = NULL;
    g_hash_table_insert(writer->sampled, (void *)g_intern_string(symbol->name), kept);
    return symbol;
}

void tinker_writer_note_unwritten(TinkerEquationWriter *writer, TinkerBlockId block, const char *symbol,
                                  const char *why)
{
    GPtrArray *list = writer->equations->not_written;
    TinkerNotWritten *last = list->len > 0 ? g_ptr_array_index(list, list->len - 1) : NULL;
    if (last == NULL || last->block != block) {
        last = g_new(TinkerNotWritten, 1);
        *last = (TinkerNotWritten){block, g_ptr_array_new_with_free_func(g_free), g_strdup(why)};
        g_ptr_array_add(list, last);
    }
    g_ptr_array_add(last->symbols, g_strdup(symbol));
}
