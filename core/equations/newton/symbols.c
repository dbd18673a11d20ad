/* Symbols, definitions, and laws written with them. */
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"
#include "law/derivative.h"
#include "law/reduce.h"
#include "law/simplify.h"
#include "law/value.h"

#include <tinker/kernels.h>

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

/* The symbol that a property has already; NULL. (transfer full) */
static TinkerExpression *known_property(const TinkerEquationWriter *writer, TinkerBlockId block, const char *key)
{
    for (guint i = 0; i < writer->equations->symbols->len; i++) {
        const TinkerEquationSymbol *known = g_ptr_array_index(writer->equations->symbols, i);
        if (known->block == block && g_strcmp0(known->property, key) == 0) return tinker_expression_symbol(known->name);
    }
    return NULL;
}

/* What a property's column stands for: a symbol of this stem, the same for each call; 0 where its value is 0. (transfer
 * full) */
static TinkerExpression *property_symbol(TinkerEquationWriter *writer, TinkerBlockId block, int32_t property,
                                         int32_t component, const char *stem)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
    const TinkerPropertyType *type = &block_class->properties[property];
    const double value = tinker_frame_column(writer->frame, block, block_class->first_columns[property] + component);
    if (value == 0) return tinker_expression_number(0);
    const gboolean vector = type->kind == TINKER_KIND_VECTOR;
    g_autofree char *key = vector ? g_strconcat(type->id, component == 0 ? " x" : " y", NULL) : g_strdup(type->id);
    TinkerExpression *known = known_property(writer, block, key);
    if (known != NULL) return known;
    const char *name = tinker_writer_name(writer, block, stem, 0, NULL);
    return tinker_writer_symbol(writer, name, block, value, type->dimension, key, NULL);
}

TinkerExpression *tinker_writer_meaning(TinkerEquationWriter *writer, TinkerBlockId block, int32_t meaning,
                                        int32_t component, const char *stem)
{
    const int32_t property = tinker_scene_block_class(writer->scene, block)->meanings[meaning];
    return property < 0 ? tinker_expression_number(0) : property_symbol(writer, block, property, component, stem);
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

/* With a value and no more. */
static TinkerExpression *valued_symbol(TinkerEquationWriter *writer, const TinkerSampledSymbol *is, const char *means)
{
    const char *name = tinker_writer_name(writer, is->block, is->stem, is->dots, is->component);
    tinker_writer_note_unwritten(writer, is->block, name, is->why);
    return tinker_writer_symbol(writer, name, is->block, is->values[is->dots], is->dimension, NULL, means);
}

TinkerExpression *tinker_writer_sampled(TinkerEquationWriter *writer, const TinkerSampledSymbol *is, const char *means)
{
    TinkerExpression *symbol = valued_symbol(writer, is, means);
    TinkerSampledSymbol *kept = g_memdup2(is, sizeof *is);
    kept->stem = g_intern_string(is->stem);
    kept->rate = NULL;
    g_hash_table_insert(writer->sampled, (void *)g_intern_string(symbol->name), kept);
    return symbol;
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

/* Laws ------------------------------------------------------------------------------------------------------------- */

void tinker_law_use_init(TinkerLawUse *use, TinkerBlockId block, const TinkerBlockLaw *law)
{
    *use = (TinkerLawUse){
        .block = block,
        .law = law,
        .meanings = g_hash_table_new_full(g_str_hash, g_str_equal, NULL, (GDestroyNotify)tinker_expression_unref)};
}

void tinker_law_use_clear(TinkerLawUse *use)
{
    g_hash_table_unref(use->meanings);
}

void tinker_law_use_set(TinkerLawUse *use, const char *symbol, const TinkerExpression *meaning)
{
    g_hash_table_insert(use->meanings, (void *)g_intern_string(symbol), tinker_expression_ref(meaning));
}

typedef struct {
    TinkerEquationWriter *writer;
    TinkerLawUse *use;
} Use;

static TinkerExpression *zero_for_time(const char *name, void *data)
{
    return strcmp(name, "t") == 0 ? tinker_expression_number(0) : NULL;
}

/* Uses it up. */
static TinkerExpression *at_start(TinkerExpression *is)
{
    TinkerExpression *there = tinker_expression_replace(is, zero_for_time, NULL);
    tinker_expression_unref(is);
    return there;
}

/* A waveform at t or at the start: harmonic, typed, or a table, of which only the value is known. */
static TinkerExpression *waveform(TinkerEquationWriter *writer, const TinkerLawUse *use, const TinkerLawSymbol *symbol)
{
    const TinkerBlockId block = use->block;
    const TinkerBlockClass *block_class = tinker_scene_block_class(writer->scene, block);
    const TinkerPropertyType *type = &block_class->properties[symbol->property];
    TinkerWaveform *wave = tinker_scene_get_waveform(writer->scene, block, symbol->property);
    const TinkerWaveformKind kind = tinker_waveform_kind(wave);
    if (kind == TINKER_WAVEFORM_NONE) return tinker_expression_number(0);
    g_autofree char *stem = symbol->at_start ? g_strconcat(type->symbol, "0", NULL) : g_strdup(symbol->name);
    if (kind == TINKER_WAVEFORM_TABLE) {
        TinkerSampledSymbol sampled = {
            .block = block, .stem = stem, .dimension = symbol->dimension, .why = "its waveform is a table"};
        for (int dots = 0; dots < 3; dots++)
            sampled.values[dots] =
                tinker_frame_column(symbol->at_start ? writer->start : writer->frame, block, symbol->column + dots);
        return symbol->at_start ? valued_symbol(writer, &sampled, type->description)
                                : tinker_writer_sampled(writer, &sampled, type->description);
    }
    TinkerExpression *is;
    if (kind == TINKER_WAVEFORM_EXPRESSION) {
        is = tinker_expression_parse(tinker_waveform_expression(wave), NULL, NULL);
    } else {
        const char *const ids[] = {type->amplitude, type->frequency, type->phase};
        TinkerExpression *parts[3];
        for (int i = 0; i < 3; i++) {
            const int32_t property = ids[i] != NULL ? tinker_block_class_property(block_class, ids[i]) : -1;
            const char *of = property >= 0 ? block_class->properties[property].symbol : NULL;
            parts[i] = property >= 0 ? property_symbol(writer, block, property, 0, of != NULL ? of : ids[i])
                                     : tinker_expression_number(i == 2 ? 0 : 1);
        }
        TinkerExpression *phase =
            tinker_expression_plus(tinker_expression_times(parts[1], tinker_expression_symbol("t")), parts[2]);
        is = tinker_expression_times(parts[0],
                                     tinker_expression_call(kind == TINKER_WAVEFORM_SINE ? "sin" : "cos", phase));
    }
    if (symbol->at_start) is = at_start(is);
    /* any other number is one of SI that lacks its unit */
    if (tinker_expression_is_number(is, 0)) return is;
    const char *name = tinker_writer_name(writer, block, stem, 0, NULL);
    return tinker_writer_define(writer, name, block, symbol->dimension, type->description, is,
                                kind == TINKER_WAVEFORM_EXPRESSION);
}

/* A number of a typed law, the same symbol on every body that a field acts on. */
static TinkerExpression *typed_number(const Use *use, const TinkerLawSymbol *symbol)
{
    const TinkerBlockId block = use->use->block;
    TinkerExpression *known = known_property(use->writer, block, symbol->name);
    if (known != NULL) return known;
    const char *name = tinker_writer_name(use->writer, block, symbol->name, 0, NULL);
    return tinker_writer_symbol(use->writer, name, block, symbol->number, symbol->dimension, symbol->name, NULL);
}

static TinkerExpression *written(const Use *use, const TinkerExpression *is);

static gboolean is_switch(const Use *use, const TinkerLawSymbol *symbol)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(use->writer->scene, use->use->block);
    return symbol->property >= 0 && block_class->properties[symbol->property].kind == TINKER_KIND_SWITCH;
}

/* A switch is no symbol of a textbook: an equation is that of the side it is on. */
static TinkerExpression *switch_number(const Use *use, const TinkerLawSymbol *symbol)
{
    return tinker_expression_number(tinker_frame_column(use->writer->frame, use->use->block, symbol->column));
}

static TinkerExpression *meaning_of(const char *name, void *data)
{
    const Use *use = data;
    TinkerExpression *known = g_hash_table_lookup(use->use->meanings, name);
    if (known != NULL) return tinker_expression_ref(known);
    const TinkerLawSymbol *symbol = tinker_block_law_symbol(use->use->law, name);
    if (symbol != NULL && symbol->absent) return tinker_expression_number(0);
    /* an equation of the same law, as the torque on one end in that on the other */
    const TinkerExpression *stated = symbol == NULL ? tinker_block_law_find(use->use->law, name) : NULL;
    if (stated != NULL) return written(use, stated);
    if (symbol == NULL || symbol->property < 0) return NULL;
    TinkerExpression *found = is_switch(use, symbol) ? switch_number(use, symbol)
                              : use->use->law->typed ? typed_number(use, symbol)
                              : symbol->at_time      ? waveform(use->writer, use->use, symbol)
                                                     : property_symbol(use->writer, use->use->block, symbol->property,
                                                                  symbol->component == 'y' ? 1 : 0, symbol->name);
    tinker_law_use_set(use->use, name, found);
    return found;
}

/* The number that cos or sin of an angle is exactly: along an axis. FALSE for any other. */
static gboolean direction_is_exact(const Use *use, const TinkerExpression *node, double *value)
{
    if (node->kind != TINKER_EXPRESSION_FUNCTION || node->count != 1) return FALSE;
    const gboolean cosine = strcmp(node->name, "cos") == 0;
    if ((!cosine && strcmp(node->name, "sin") != 0) || node->parts[0]->kind != TINKER_EXPRESSION_SYMBOL) return FALSE;
    const TinkerLawSymbol *symbol = tinker_block_law_symbol(use->use->law, node->parts[0]->name);
    if (symbol == NULL || symbol->column < 0 || symbol->at_time || symbol->absent || symbol->dimension.angle != 1)
        return FALSE;
    double direction[2];
    tinker_direction(tinker_frame_column(use->writer->frame, use->use->block, symbol->column), direction);
    *value = cosine ? direction[0] : direction[1];
    return *value == 0 || fabs(*value) == 1;
}

/* The law with such directions as numbers, so that gravity is m g downwards. */
static TinkerExpression *with_directions(const Use *use, const TinkerExpression *node)
{
    double value;
    if (direction_is_exact(use, node, &value)) return tinker_expression_number(value);
    if (node->count == 0) return tinker_expression_ref(node);
    g_autofree TinkerExpression **parts = g_new(TinkerExpression *, (gsize)node->count);
    for (int i = 0; i < node->count; i++)
        parts[i] = with_directions(use, node->parts[i]);
    return tinker_expression_node(node->kind, node->name, parts, node->count);
}

static TinkerExpression *written(const Use *use, const TinkerExpression *is)
{
    g_autoptr(TinkerExpression) directed = with_directions(use, is);
    return tinker_expression_replace(directed, meaning_of, (void *)use);
}

TinkerExpression *tinker_law_use_equation(TinkerEquationWriter *writer, TinkerLawUse *use, const char *wanted)
{
    const Use inside = {writer, use};
    const TinkerExpression *last = tinker_block_law_find(use->law, wanted);
    if (last == NULL) return NULL;
    for (guint i = 0; i < use->law->definitions->len; i++) {
        const TinkerLawDefinition *step = &g_array_index(use->law->definitions, TinkerLawDefinition, i);
        if (!tinker_law_is_step(step->symbol) || g_hash_table_contains(use->meanings, step->symbol)) continue;
        TinkerExpression *is = written(&inside, step->is);
        if (is->count > 0) {
            const char *name = use->index != NULL ? tinker_equations_free_name(writer->equations, use->block,
                                                                               step->symbol, use->index, 0, NULL)
                                                  : tinker_writer_name(writer, use->block, step->symbol, 0, NULL);
            is = tinker_writer_define(writer, name, use->block, step->dimension, step->means, is, FALSE);
        }
        tinker_law_use_set(use, step->symbol, is);
        tinker_expression_unref(is);
    }
    return written(&inside, last);
}
