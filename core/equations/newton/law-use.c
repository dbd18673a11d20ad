/* The law of one block, with its own names: what a symbol of the law is there, and its steps as definitions. */
#include <math.h>
#include <string.h>

#include "equations/newton/writer.h"
#include "law/build-short.h"

#include <tinker/kernels.h>

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
        return symbol->at_start ? tinker_writer_valued(writer, &sampled, type->description)
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
            parts[i] = property >= 0 ? tinker_writer_property(writer, block, property, 0, of != NULL ? of : ids[i])
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
    TinkerExpression *known = tinker_writer_known_property(use->writer, block, symbol->name);
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
                              : symbol->at_time
                                  ? waveform(use->writer, use->use, symbol)
                                  : tinker_writer_property(use->writer, use->use->block, symbol->property,
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
