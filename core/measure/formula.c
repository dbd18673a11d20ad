/* Each name in braces is a column of the record, or a property, whose value is looked up once. */
#include "measure/formula.h"

#include <math.h>

#include "law/dimension.h"
#include "law/value.h"
#include "physics/record/columns.h"
#include "scene/frame/frame.h"

typedef struct {
    const char *symbol; /* interned */
    TinkerDimension dimension;
    gint column;  /* of the record; -1: a property, */
    double value; /* that has this value */
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

TinkerFormula *tinker_formula_new(TinkerScene *scene, const char *text, GArray *columns, GError **error)
{
    TinkerSceneExpression *read = tinker_scene_expression_new(scene, text, error);
    if (read == NULL) return NULL;
    g_autoptr(TinkerFormula) formula = g_new0(TinkerFormula, 1);
    formula->read = read;
    formula->names = g_array_new(FALSE, FALSE, sizeof(Name));
    for (guint i = 0; i < read->references->len; i++) {
        const TinkerReference *reference = &g_array_index(read->references, TinkerReference, i);
        Name name = {reference->symbol, reference->dimension, -1, NAN};
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

gboolean tinker_formula_is_comparison(const TinkerFormula *formula)
{
    return formula->read->tree->kind == TINKER_EXPRESSION_COMPARISON;
}
