/* Typed laws. */
#include "law/typed-law.h"

#include <glib/gi18n-lib.h>
#include <string.h>

#include "law/derivative.h"
#include "law/dimension.h"
#include "units/compiled/compiled.h"
#include "units/compiled/typed-energy.h"
#include "units/quantity/units.h"
#include "units/waveform/waveform.h"

gboolean tinker_any_quantity_parse(const char *text, double *si, TinkerDimension *dimension, GError **error)
{
    static const TinkerDimension pure = {0, 0, 0, 0};
    g_autofree char *stripped = g_strstrip(g_strdup(text));
    char *unit_text = NULL;
    TinkerUnit unit = {1, pure};
    (void)g_ascii_strtod(stripped, &unit_text);
    while (g_ascii_isspace(*unit_text))
        unit_text++;
    if (unit_text != stripped && *unit_text != '\0' && !tinker_unit_parse(unit_text, &unit, error)) return FALSE;
    *dimension = unit.dimension;
    return tinker_quantity_parse(stripped, unit.dimension, si, error);
}

/* The ids of the block's numbers and the formula's arguments but for t, which the grammar has. (transfer full) */
static GPtrArray *names_of(const TinkerBlockClass *block_class, int32_t property)
{
    GPtrArray *names = g_ptr_array_new();
    const TinkerPropertyType *type = &block_class->properties[property];
    for (int32_t i = 0; i < type->choice_count; i++)
        if (strcmp(type->choices[i], "t") != 0) g_ptr_array_add(names, (void *)type->choices[i]);
    for (int32_t i = 0; i < block_class->property_count; i++)
        if ((block_class->properties[i].flags & TINKER_TEXT_QUANTITY) != 0)
            g_ptr_array_add(names, (void *)block_class->properties[i].id);
    g_ptr_array_add(names, NULL);
    return names;
}

static gboolean is_argument(const TinkerPropertyType *type, const char *name)
{
    for (int32_t i = 0; i < type->choice_count; i++)
        if (strcmp(type->choices[i], name) == 0) return TRUE;
    return FALSE;
}

/* t stands in the grammar, whether the formula has it or not. */
static gboolean names_time_in_vain(const TinkerExpression *expression, const TinkerPropertyType *type)
{
    return !is_argument(type, "t") && tinker_expression_uses(expression, "t");
}

TinkerExpression *tinker_typed_parse(const TinkerBlockClass *block_class, int32_t property, const char *text,
                                     GError **error)
{
    g_autoptr(GPtrArray) names = names_of(block_class, property);
    TinkerExpression *expression = tinker_expression_parse(text, (const char *const *)names->pdata, error);
    if (expression == NULL || !names_time_in_vain(expression, &block_class->properties[property])) return expression;
    tinker_expression_unref(expression);
    g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_SYNTAX,
                _("\"%s\" names t, which %s does not depend on"), text, block_class->properties[property].id);
    return NULL;
}

typedef struct {
    const TinkerBlockClass *block_class;
    const TinkerPropertyType *type;
    TinkerTypedLawTextFunc text_of;
    void *data;
    GError **error;
    gboolean failed;
} Numbers;

/* A number of the block's, or NULL where the name is an argument. */
static TinkerExpression *number_of(const char *name, void *data)
{
    Numbers *numbers = data;
    if (is_argument(numbers->type, name) || numbers->failed) return NULL;
    const int32_t property = tinker_block_class_property(numbers->block_class, name);
    const char *text = numbers->text_of(property, numbers->data);
    double si = 0;
    TinkerDimension dimension;
    numbers->failed = text[0] == '\0' || !tinker_any_quantity_parse(text, &si, &dimension, numbers->error);
    if (text[0] == '\0')
        g_set_error(numbers->error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_SYNTAX,
                    _("%s names %s, which has no value (give \"%s\" a number, with a unit or without)"),
                    numbers->type->id, name, name);
    else if (numbers->failed)
        g_prefix_error(numbers->error, "%s: ", name);
    return numbers->failed ? NULL : tinker_expression_number(si);
}

/* By argument `by`; takes nothing over. NULL where it has become too long. */
static TinkerCompiled *compiled(const TinkerExpression *expression, const TinkerPropertyType *type)
{
    return tinker_compiled_new(expression, type->choices, type->choice_count);
}

static gboolean compile_all(TinkerTypedLaw *formula, const TinkerExpression *is, const TinkerPropertyType *type)
{
    const int n = formula->count;
    gboolean good = (formula->value = compiled(is, type)) != NULL;
    for (int i = 0; i < n && good; i++) {
        g_autoptr(TinkerExpression) slope = tinker_expression_derivative_by(is, type->choices[i]);
        good = (formula->slopes[i] = compiled(slope, type)) != NULL;
        for (int k = 0; k < n && good; k++) {
            g_autoptr(TinkerExpression) curvature = tinker_expression_derivative_by(slope, type->choices[k]);
            good = (formula->curvatures[i * n + k] = compiled(curvature, type)) != NULL;
        }
    }
    return good;
}

/* The expression with the block's numbers in it. (transfer full) */
static TinkerExpression *folded(const TinkerBlockClass *block_class, int32_t property, TinkerTypedLawTextFunc text_of,
                                void *data, GError **error)
{
    g_autoptr(TinkerExpression) typed = tinker_typed_parse(block_class, property, text_of(property, data), error);
    if (typed == NULL) return NULL;
    Numbers numbers = {block_class, &block_class->properties[property], text_of, data, error, FALSE};
    g_autoptr(TinkerExpression) is = tinker_expression_folded(typed, number_of, &numbers);
    return numbers.failed ? NULL : g_steal_pointer(&is);
}

TinkerTypedLaw *tinker_typed_new(const TinkerBlockClass *block_class, int32_t property, TinkerTypedLawTextFunc text_of,
                                 void *data, GError **error)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    g_autoptr(TinkerExpression) is = folded(block_class, property, text_of, data, error);
    if (is == NULL) return NULL;
    TinkerTypedLaw *formula = g_new0(TinkerTypedLaw, 1);
    formula->count = type->choice_count;
    tinker_typed_keep(formula, is, type->choices);
    formula->slopes = g_new0(TinkerCompiled *, formula->count);
    formula->curvatures = g_new0(TinkerCompiled *, formula->count * formula->count);
    formula->depends_on_time = tinker_expression_uses(is, "t");
    formula->depends_on_velocity =
        tinker_expression_uses(is, "rate") || tinker_expression_uses(is, "vx") || tinker_expression_uses(is, "vy");
    if (compile_all(formula, is, type)) return formula;
    tinker_typed_free(formula);
    g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_SYNTAX,
                _("%s and its derivatives are too long to be compiled (about a tenth of that can be)"), type->id);
    return NULL;
}

typedef struct {
    const TinkerBlockClass *block_class;
    TinkerTypedLawTextFunc text_of;
    void *data;
} Units;

static gboolean unit_of(const char *symbol, TinkerDimension *dimension, void *data)
{
    static const struct {
        const char *name;
        TinkerDimension dimension;
    } arguments[] = {
        {"L", {0, 1, 0, 0}}, {"rate", {0, 1, -1, 0}}, {"t", {0, 0, 1, 0}},   {"x", {0, 1, 0, 0}},
        {"y", {0, 1, 0, 0}}, {"vx", {0, 1, -1, 0}},   {"vy", {0, 1, -1, 0}}, {"m", {1, 0, 0, 0}},
    };
    const Units *units = data;
    double si;
    for (gsize i = 0; i < G_N_ELEMENTS(arguments); i++) {
        if (strcmp(arguments[i].name, symbol) != 0) continue;
        *dimension = arguments[i].dimension;
        return TRUE;
    }
    const int32_t property = tinker_block_class_property(units->block_class, symbol);
    return property >= 0 && tinker_any_quantity_parse(units->text_of(property, units->data), &si, dimension, NULL);
}

char *tinker_typed_note(const TinkerBlockClass *block_class, int32_t property, TinkerTypedLawTextFunc text_of,
                        void *data)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    const char *text = text_of(property, data);
    g_autoptr(TinkerExpression) is = text[0] != '\0' ? tinker_typed_parse(block_class, property, text, NULL) : NULL;
    if (is == NULL) return NULL;
    Units units = {block_class, text_of, data};
    const TinkerDimension wanted = type->dimension;
    const TinkerLawDimension expected = {FALSE, wanted.mass, wanted.length, wanted.time};
    TinkerLawDimension found;
    g_autofree char *why = NULL, *law = tinker_law_dimension_text(&expected);
    if (!tinker_expression_dimension(is, unit_of, &units, &found, &why))
        return g_strdup_printf(_("%s has %s: taken in SI"), type->id, why);
    if (tinker_law_dimension_is(&found, wanted)) return NULL;
    g_autofree char *given = tinker_law_dimension_text(&found);
    return g_strdup_printf(_("%s is in %s where %s was expected: taken in SI"), type->id, given, law);
}
