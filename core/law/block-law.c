/* Reading the law of a block type. */
#include "law/block-law.h"

#include <string.h>

#include "law/build.h"
#include "units/waveform/waveform.h"

static const TinkerDimension length = {0, 1, 0, 0}, velocity = {0, 1, -1, 0}, seconds = {0, 0, 1, 0},
                             kilograms = {1, 0, 0, 0}, angle = {0, 0, 0, 1}, angular_velocity = {0, 0, -1, 1},
                             pure = {0, 0, 0, 0};

TinkerLawRole tinker_law_role(const TinkerBlockClass *block_class)
{
    const TinkerPhysics *physics = block_class->physics;
    if (physics == NULL) return TINKER_LAW_NONE;
    if (physics->line_law != NULL) return TINKER_LAW_LINE;
    if (physics->force_element != NULL) return TINKER_LAW_FORCE;
    if (physics->field != NULL) return TINKER_LAW_FIELD;
    if (physics->constraint != NULL) return TINKER_LAW_CONSTRAINT;
    return physics->motion != NULL ? TINKER_LAW_MOTION : TINKER_LAW_NONE;
}

static void clear_symbol(void *data)
{
    g_free(((TinkerLawSymbol *)data)->name);
}

static void clear_definition(void *data)
{
    g_clear_pointer(&((TinkerLawDefinition *)data)->is, tinker_expression_unref);
}

static void add_symbol(TinkerBlockLaw *law, char *name, TinkerDimension dimension)
{
    const TinkerLawSymbol symbol = {.name = name, .property = -1, .column = -1, .end = -1, .dimension = dimension};
    g_array_append_val(law->symbols, symbol);
}

static void add_point(TinkerBlockLaw *law, const char *number)
{
    add_symbol(law, g_strconcat("x", number, NULL), length);
    add_symbol(law, g_strconcat("y", number, NULL), length);
    add_symbol(law, g_strconcat("vx", number, NULL), velocity);
    add_symbol(law, g_strconcat("vy", number, NULL), velocity);
}

/* Ends are counted where there may be several; those from `ends` to `most` are absent. */
static void add_ends(TinkerBlockLaw *law, int32_t ends, int32_t most)
{
    const struct {
        const char *quantity, *stem, *behind;
        gboolean of_force, of_constraint;
        TinkerDimension dimension;
    } known[] = {
        {"x", "x", "", TRUE, TRUE, length},
        {"y", "y", "", TRUE, TRUE, length},
        {"vx", "vx", "", TRUE, FALSE, velocity},
        {"vy", "vy", "", TRUE, FALSE, velocity},
        {"theta", "theta", "", TRUE, TRUE, angle},
        {"omega", "omega", "", TRUE, FALSE, angular_velocity},
        {"turns", "turns", "", TRUE, TRUE, pure},
        {"x_start", "x", "_start", FALSE, TRUE, length},
        {"y_start", "y", "_start", FALSE, TRUE, length},
        {"theta_start", "theta", "_start", FALSE, TRUE, angle},
    };
    for (int32_t i = 0; i < MAX(ends, most); i++) {
        g_autofree char *number = i == 0 && ends == 1 ? g_strdup("") : g_strdup_printf("%d", i + 1);
        for (gsize k = 0; k < G_N_ELEMENTS(known); k++) {
            if (law->role == TINKER_LAW_FORCE ? !known[k].of_force : !known[k].of_constraint) continue;
            const TinkerLawSymbol symbol = {.name = g_strconcat(known[k].stem, number, known[k].behind, NULL),
                                            .property = -1,
                                            .column = -1,
                                            .end = i < ends ? i : -1,
                                            .absent = i >= ends,
                                            .quantity = known[k].quantity,
                                            .dimension = known[k].dimension};
            g_array_append_val(law->symbols, symbol);
        }
    }
}

static void add_role(TinkerBlockLaw *law, const TinkerBlockClass *block_class, int32_t ends)
{
    add_symbol(law, g_strdup("t"), seconds);
    if (law->role == TINKER_LAW_LINE || law->role == TINKER_LAW_CONSTRAINT) add_symbol(law, g_strdup("L"), length);
    if (law->role == TINKER_LAW_LINE) add_symbol(law, g_strdup("rate"), velocity);
    if (law->role == TINKER_LAW_FORCE || law->role == TINKER_LAW_CONSTRAINT)
        add_ends(law, ends, block_class->type->most_ends);
    if (law->role != TINKER_LAW_FIELD) return;
    add_point(law, "");
    add_symbol(law, g_strdup("m"), kilograms);
    if (!block_class->physics->field->couples_bodies) return;
    add_point(law, "2");
    add_symbol(law, g_strdup("m2"), kilograms);
}

/* By its symbol, or by its id where it has none; components of the first are "wx", of the second "wind_x". */
static void add_property(TinkerBlockLaw *law, const TinkerBlockClass *block_class, int32_t number)
{
    const TinkerPropertyType *property = &block_class->properties[number];
    if (property->kind == TINKER_KIND_TEXT || (property->flags & TINKER_READ_ONLY) != 0) return;
    const gboolean vector = property->kind == TINKER_KIND_VECTOR, named = property->symbol != NULL;
    for (int component = 0; component < (vector ? 2 : 1); component++) {
        const char *behind = !vector ? "" : component == 0 ? "x" : "y";
        const TinkerLawSymbol symbol = {
            .name = g_strconcat(named ? property->symbol : property->id, vector && !named ? "_" : "", behind, NULL),
            .property = number,
            .column = block_class->first_columns[number] + component,
            .component = behind[0],
            .end = -1,
            .at_time = property->kind == TINKER_KIND_WAVEFORM,
            .dimension = property->dimension,
        };
        g_array_append_val(law->symbols, symbol);
        if (!symbol.at_time || law->role != TINKER_LAW_CONSTRAINT) continue;
        g_array_append_val(law->symbols, symbol);
        TinkerLawSymbol *start = &g_array_index(law->symbols, TinkerLawSymbol, law->symbols->len - 1);
        start->name = g_strconcat(symbol.name, "_start", NULL);
        start->at_start = TRUE;
    }
}

/* The names that the next equation may use. (transfer full) */
static GPtrArray *names_so_far(const TinkerBlockLaw *law)
{
    GPtrArray *names = g_ptr_array_new();
    for (guint i = 0; i < law->symbols->len; i++)
        g_ptr_array_add(names, g_array_index(law->symbols, TinkerLawSymbol, i).name);
    for (guint i = 0; i < law->definitions->len; i++)
        g_ptr_array_add(names, (void *)g_array_index(law->definitions, TinkerLawDefinition, i).symbol);
    g_ptr_array_add(names, NULL);
    return names;
}

static gboolean add_equation(TinkerBlockLaw *law, const TinkerLawEquation *equation, GError **error)
{
    g_autoptr(GPtrArray) names = names_so_far(law);
    if (g_strv_contains((const char *const *)names->pdata, equation->symbol)) {
        g_set_error(error, TINKER_WAVEFORM_ERROR, TINKER_WAVEFORM_ERROR_SYNTAX,
                    "the symbol \"%s\" has a meaning already (an equation needs one of its own)", equation->symbol);
        return FALSE;
    }
    const TinkerLawDefinition definition = {
        .symbol = equation->symbol,
        .means = equation->means,
        .dimension = equation->dimension,
        .is = tinker_expression_parse(equation->is, (const char *const *)names->pdata, error),
    };
    if (definition.is == NULL) {
        g_prefix_error(error, "%s = %s: ", equation->symbol, equation->is);
        return FALSE;
    }
    g_array_append_val(law->definitions, definition);
    return TRUE;
}

static TinkerBlockLaw *law_new(const TinkerBlockClass *block_class, int32_t ends)
{
    TinkerBlockLaw *law = g_new0(TinkerBlockLaw, 1);
    law->role = tinker_law_role(block_class);
    law->symbols = g_array_new(FALSE, TRUE, sizeof(TinkerLawSymbol));
    law->definitions = g_array_new(FALSE, TRUE, sizeof(TinkerLawDefinition));
    g_array_set_clear_func(law->symbols, clear_symbol);
    g_array_set_clear_func(law->definitions, clear_definition);
    add_role(law, block_class, ends);
    return law;
}

TinkerBlockLaw *tinker_block_law_new(const TinkerBlockClass *block_class, int32_t ends, GError **error)
{
    if (block_class->law_count == 0 || tinker_law_role(block_class) == TINKER_LAW_NONE) return NULL;
    TinkerBlockLaw *law = law_new(block_class, ends);
    for (int32_t i = 0; i < block_class->property_count; i++)
        add_property(law, block_class, i);
    for (int32_t i = 0; i < block_class->law_count; i++) {
        if (add_equation(law, &block_class->law[i], error)) continue;
        tinker_block_law_free(law);
        return NULL;
    }
    return law;
}

/* A number that the texts name. */
static gboolean add_number(TinkerBlockLaw *law, const TinkerPropertyType *type, int32_t property, const char *text,
                           GError **error)
{
    TinkerLawSymbol symbol = {.name = g_strdup(type->id), .property = property, .column = -1, .end = -1};
    const gboolean good = tinker_any_quantity_parse(text, &symbol.number, &symbol.dimension, error);
    if (good)
        g_array_append_val(law->symbols, symbol);
    else
        g_free(symbol.name);
    return good;
}

static gboolean add_typed(TinkerBlockLaw *law, const TinkerBlockClass *block_class, int32_t property, const char *text,
                          GError **error)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    if (text[0] == '\0') return TRUE;
    if ((type->flags & TINKER_TEXT_QUANTITY) != 0) return add_number(law, type, property, text, error);
    TinkerExpression *is = tinker_typed_parse(block_class, property, text, error);
    const TinkerLawDefinition definition = {.symbol = type->id, .dimension = type->dimension, .is = is};
    if (is != NULL) g_array_append_val(law->definitions, definition);
    return is != NULL;
}

TinkerBlockLaw *tinker_block_law_new_typed(const TinkerBlockClass *block_class, int32_t ends,
                                           TinkerTypedLawTextFunc text_of, void *data, GError **error)
{
    TinkerBlockLaw *law = law_new(block_class, ends);
    law->typed = TRUE;
    if (law->role == TINKER_LAW_FORCE) add_symbol(law, g_strdup("m"), kilograms);
    gboolean good = TRUE;
    for (int32_t i = 0; i < block_class->property_count && good; i++)
        if ((block_class->properties[i].flags & (TINKER_TEXT_LAW | TINKER_TEXT_QUANTITY)) != 0)
            good = add_typed(law, block_class, i, text_of(i, data), error);
    if (good && law->definitions->len > 0) return law;
    tinker_block_law_free(law);
    return NULL;
}

void tinker_block_law_free(TinkerBlockLaw *law)
{
    g_array_unref(law->symbols);
    g_array_unref(law->definitions);
    g_free(law);
}

const TinkerLawDefinition *tinker_block_law_definition(const TinkerBlockLaw *law, const char *symbol)
{
    for (guint i = 0; i < law->definitions->len; i++) {
        const TinkerLawDefinition *definition = &g_array_index(law->definitions, TinkerLawDefinition, i);
        if (strcmp(definition->symbol, symbol) == 0) return definition;
    }
    return NULL;
}

const TinkerExpression *tinker_block_law_find(const TinkerBlockLaw *law, const char *symbol)
{
    const TinkerLawDefinition *definition = tinker_block_law_definition(law, symbol);
    return definition != NULL ? definition->is : NULL;
}

gboolean tinker_block_law_names(const TinkerBlockLaw *law, const char *symbol)
{
    for (guint i = 0; i < law->definitions->len; i++)
        if (tinker_expression_uses(g_array_index(law->definitions, TinkerLawDefinition, i).is, symbol)) return TRUE;
    return FALSE;
}

const TinkerLawSymbol *tinker_block_law_symbol(const TinkerBlockLaw *law, const char *name)
{
    for (guint i = 0; i < law->symbols->len; i++) {
        const TinkerLawSymbol *symbol = &g_array_index(law->symbols, TinkerLawSymbol, i);
        if (strcmp(symbol->name, name) == 0) return symbol;
    }
    return NULL;
}

gboolean tinker_law_is_step(const char *symbol)
{
    static const char *const asked[] = {
        "tension",        "potential", "g", "displacement_x", "displacement_y", "pair_force_x", "pair_force_y",
        "pair_potential", "rotation",  NULL};
    if (g_strv_contains(asked, symbol)) return FALSE;
    static const char *const counted[] = {"force_x", "force_y", "torque", "impulse_x", "impulse_y", "angular_impulse"};
    for (gsize i = 0; i < G_N_ELEMENTS(counted); i++)
        if (g_str_has_prefix(symbol, counted[i]) &&
            strspn(symbol + strlen(counted[i]), "0123456789") == strlen(symbol + strlen(counted[i])))
            return FALSE;
    return symbol[0] != 'g' || strspn(symbol + 1, "0123456789") != strlen(symbol + 1);
}
