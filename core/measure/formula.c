/* Each name in braces is a column of the record, or a property, whose value is looked up once. */
#include "measure/formula.h"

#include <math.h>
#include <string.h>

#include "law/build.h"
#include "law/dimension.h"
#include "law/value.h"
#include "physics/record/columns.h"
#include "scene/frame/frame.h"

typedef struct {
    const char *symbol; /* interned */
    TinkerDimension dimension;
    const char *units[2]; /* that it is shown in: SI, English */
    gint column;          /* of the record; -1: a property, */
    double value;         /* that has this value */
} Name;

struct _TinkerFormula {
    TinkerSceneExpression *read;
    GArray *names; /* of Name */
};

static gint find_column(GArray *columns, TinkerScene *scene, const TinkerReference *reference)
{
    for (guint i = 0; i < columns->len; i++) {
        const TinkerColumn *column = &g_array_index(columns, TinkerColumn, i);
        if (column->block == reference->block && column->quantity == reference->quantity) return (gint)i;
    }
    tinker_columns_add_quantity(columns, scene, reference->block, reference->quantity);
    return (gint)columns->len - 1;
}

/* What is left to the placing of the blocks, such as a rest length, is as they stand at the start. */
static gboolean find_property(TinkerScene *scene, const TinkerReference *reference, double *value, GError **error)
{
    *value = tinker_scene_get(scene, reference->block, reference->column);
    if (isfinite(*value)) return TRUE;
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, error);
    TinkerInstance instance;
    if (frame == NULL) return FALSE;
    if (tinker_frame_instance(frame, reference->block, &instance)) *value = instance.columns[reference->column];
    return TRUE;
}

/* As their block shows a quantity or a property. */
static void find_units(TinkerScene *scene, const TinkerReference *reference, const char *units[2])
{
    if (reference->block == TINKER_NO_BLOCK) return;
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, reference->block);
    const char *id = NULL;
    if (reference->quantity >= 0) id = tinker_scene_quantity_type(scene, reference->block, reference->quantity).id;
    for (int32_t p = 0; reference->quantity < 0 && p < block_class->property_count; p++)
        if (block_class->first_columns[p] <= reference->column) id = block_class->properties[p].id;
    for (int english = 0; id != NULL && english < 2; english++)
        units[english] = tinker_block_class_unit(block_class, id, reference->dimension, english);
}

TinkerFormula *tinker_formula_new(TinkerScene *scene, const char *text, GArray *columns, GError **error)
{
    TinkerSceneExpression *read = tinker_scene_expression_new(scene, text, error);
    if (read == NULL) return NULL;
    g_autoptr(TinkerFormula) formula = g_new0(TinkerFormula, 1);
    formula->read = read;
    formula->names = g_array_new(FALSE, FALSE, sizeof(Name));
    for (guint i = 0; i < read->references->len; i++) {
        const TinkerReference *reference = &g_array_index(read->references, TinkerReference, i);
        Name name = {reference->symbol, reference->dimension, {NULL, NULL}, -1, NAN};
        find_units(scene, reference, name.units);
        if (reference->quantity >= 0)
            name.column = find_column(columns, scene, reference);
        else if (!find_property(scene, reference, &name.value, error))
            return NULL;
        g_array_append_val(formula->names, name);
    }
    return g_steal_pointer(&formula);
}

void tinker_formula_free(TinkerFormula *formula)
{
    if (formula == NULL) return;
    tinker_scene_expression_free(formula->read);
    if (formula->names != NULL) g_array_unref(formula->names);
    g_free(formula);
}

typedef struct {
    const TinkerFormula *formula;
    double t;
    const double *columns;
    const double *bands; /* of which `moved` is added to its column; NULL */
    guint moved;
} Instant;

/* Names are interned, so that equal ones are equal pointers. */
static const Name *find_name(const TinkerFormula *formula, const char *symbol)
{
    for (guint i = 0; i < formula->names->len; i++) {
        const Name *name = &g_array_index(formula->names, Name, i);
        if (name->symbol == symbol) return name;
    }
    return NULL;
}

static double value_of(const char *symbol, void *data)
{
    const Instant *instant = data;
    const Name *name = find_name(instant->formula, symbol);
    if (name == NULL) return instant->t;
    if (name->column < 0) return name->value;
    double value = instant->columns[name->column];
    if (instant->bands != NULL && name == &g_array_index(instant->formula->names, Name, instant->moved))
        value += instant->bands[name->column];
    return value;
}

double tinker_formula_value(const TinkerFormula *formula, double t, const double *columns)
{
    Instant instant = {formula, t, columns, NULL, 0};
    return tinker_expression_value(formula->read->tree, value_of, &instant);
}

double tinker_formula_band(const TinkerFormula *formula, double t, const double *columns, const double *bands)
{
    const double value = tinker_formula_value(formula, t, columns);
    double sum = 0;
    for (guint i = 0; i < formula->names->len; i++) {
        Instant instant = {formula, t, columns, bands, i};
        if (g_array_index(formula->names, Name, i).column < 0) continue;
        sum += fabs(tinker_expression_value(formula->read->tree, value_of, &instant) - value);
    }
    return sum;
}

static gboolean dimension_of(const char *symbol, TinkerDimension *dimension, void *data)
{
    static const TinkerDimension time = {.time = 1};
    const Name *name = find_name(data, symbol);
    *dimension = name != NULL ? name->dimension : time;
    return TRUE;
}

gboolean tinker_formula_dimension(const TinkerFormula *formula, TinkerDimension *dimension, char **why)
{
    TinkerLawDimension found;
    g_autofree char *reason = NULL;
    gboolean known = tinker_expression_dimension(formula->read->tree, dimension_of, (gpointer)formula, &found, &reason);
    const double exponents[3] = {found.mass, found.length, found.time};
    for (int i = 0; known && i < 3; i++)
        known = fabs(exponents[i]) < 100 && exponents[i] == nearbyint(exponents[i]);
    if (known) {
        *dimension =
            (TinkerDimension){.mass = (int8_t)found.mass, .length = (int8_t)found.length, .time = (int8_t)found.time};
        return TRUE;
    }
    if (why != NULL)
        *why = reason != NULL ? g_steal_pointer(&reason) : g_strdup("its dimension is no whole power of kg, m and s");
    return FALSE;
}

typedef struct {
    const TinkerFormula *formula;
    int english;
} UnitQuestion;

static const char *unit_of(const TinkerExpression *node, const UnitQuestion *question);

/* Of parts that all have the same; NULL. */
static const char *common_unit(const TinkerExpression *node, int from, const UnitQuestion *question)
{
    const char *common = NULL;
    for (int i = from; i < node->count; i++) {
        if (tinker_expression_is_number(node->parts[i], 0)) continue; /* which has any */
        const char *unit = unit_of(node->parts[i], question);
        if (unit == NULL || (common != NULL && strcmp(unit, common) != 0)) return NULL;
        common = unit;
    }
    return common;
}

static gboolean is_plain(const TinkerExpression *node)
{
    gboolean plain = node->kind != TINKER_EXPRESSION_SYMBOL;
    for (int i = 0; plain && i < node->count; i++)
        plain = is_plain(node->parts[i]);
    return plain;
}

/* Of a product with plain numbers, or what is divided by one. */
static const char *unit_of_product(const TinkerExpression *node, const UnitQuestion *question)
{
    const TinkerExpression *only = NULL;
    for (int i = 0; i < node->count; i++) {
        if (is_plain(node->parts[i])) continue;
        if (only != NULL || (i > 0 && node->kind == TINKER_EXPRESSION_QUOTIENT)) return NULL;
        only = node->parts[i];
    }
    return only != NULL ? unit_of(only, question) : NULL;
}

static const char *unit_of(const TinkerExpression *node, const UnitQuestion *question)
{
    static const char *const keep[] = {"abs", "ramp", "min", "max", NULL};
    const Name *name;
    switch (node->kind) {
    case TINKER_EXPRESSION_SYMBOL:
        name = find_name(question->formula, node->name);
        return name != NULL ? name->units[question->english] : NULL;
    case TINKER_EXPRESSION_NEGATIVE:
    case TINKER_EXPRESSION_SUM:
        return common_unit(node, 0, question);
    case TINKER_EXPRESSION_PRODUCT:
    case TINKER_EXPRESSION_QUOTIENT:
        return unit_of_product(node, question);
    case TINKER_EXPRESSION_FUNCTION:
        if (strcmp(node->name, "if") == 0) return common_unit(node, 1, question);
        return g_strv_contains(keep, node->name) ? common_unit(node, 0, question) : NULL;
    default:
        return NULL;
    }
}

const char *tinker_formula_unit(const TinkerFormula *formula, TinkerUnitSystem system)
{
    static const TinkerDimension of_both = TINKER_DIMENSION_ENERGY;
    const UnitQuestion question = {formula, system == TINKER_UNIT_SYSTEM_ENGLISH ? 1 : 0};
    TinkerDimension dimension;
    if (!tinker_formula_dimension(formula, &dimension, NULL) || !tinker_dimension_equal(dimension, of_both))
        return NULL;
    return unit_of(formula->read->tree, &question);
}

gboolean tinker_formula_is_comparison(const TinkerFormula *formula)
{
    return formula->read->tree->kind == TINKER_EXPRESSION_COMPARISON;
}
