/* Properties: their values, held to the kind and range that the block's descriptor declares. */
#include <math.h>
#include <string.h>

#include "scene/store/scene-data.h"

/* "0.5 kg": a value in SI with its unit, for messages. */
static char *value_with_unit(double value, TinkerDimension dimension)
{
    char number[64];
    tinker_number_to_text(value, number, sizeof number);
    const char *unit = tinker_unit_si_symbol(dimension);
    return *unit == '\0' ? g_strdup(number) : g_strdup_printf("%s %s", number, unit);
}

static gboolean below_minimum(const TinkerPropertyType *property, double value)
{
    if (!(property->flags & TINKER_HAS_MINIMUM)) return FALSE;
    return property->flags & TINKER_OPEN_MINIMUM ? !(value > property->hard_minimum)
                                                 : !(value >= property->hard_minimum);
}

static gboolean above_maximum(const TinkerPropertyType *property, double value)
{
    if (!(property->flags & TINKER_HAS_MAXIMUM)) return FALSE;
    return property->flags & TINKER_OPEN_MAXIMUM ? !(value < property->hard_maximum)
                                                 : !(value <= property->hard_maximum);
}

/* The name of a component in messages: "mass", "velocity: x". */
static char *component_name(const TinkerPropertyType *property, int32_t component)
{
    if (property->kind != TINKER_KIND_VECTOR) return g_strdup(property->id);
    return g_strdup_printf("%s: %s", property->id, component == 0 ? "x" : "y");
}

static char *range_fault(const TinkerPropertyType *property, int32_t component, double value, const char *typed)
{
    gboolean low = below_minimum(property, value);
    if (!low && !above_maximum(property, value)) return NULL;
    gboolean open = property->flags & (low ? TINKER_OPEN_MINIMUM : TINKER_OPEN_MAXIMUM);
    const char *relation = low ? (open ? "greater than" : "at least") : (open ? "less than" : "at most");
    g_autofree char *name = component_name(property, component);
    g_autofree char *bound =
        value_with_unit(low ? property->hard_minimum : property->hard_maximum, property->dimension);
    g_autofree char *given = typed != NULL ? g_strdup(typed) : value_with_unit(value, property->dimension);
    return g_strdup_printf("%s must be %s %s (it is %s)", name, relation, bound, given);
}

static gboolean is_of_kind(const TinkerPropertyType *property, double value)
{
    const gboolean whole = value == floor(value);
    switch (property->kind) {
    case TINKER_KIND_INTEGER:
        return whole && fabs(value) <= 9007199254740992.0;
    case TINKER_KIND_SWITCH:
        return value == 0 || value == 1;
    case TINKER_KIND_CHOICE:
        return whole && value >= 0 && value < property->choice_count;
    default:
        return TRUE;
    }
}

static char *kind_fault(const TinkerPropertyType *property, int32_t component, double value)
{
    if (isfinite(value) && is_of_kind(property, value)) return NULL;
    g_autofree char *name = component_name(property, component);
    if (!isfinite(value)) return g_strdup_printf("%s must be a finite number", name);
    if (property->kind == TINKER_KIND_INTEGER)
        return g_strdup_printf("%s must be a whole number (it is %.17g)", name, value);
    if (property->kind == TINKER_KIND_SWITCH) return g_strdup_printf("%s must be true or false", name);
    return g_strdup_printf("%s must be one of its %d choices", name, property->choice_count);
}

char *scene_value_fault(const TinkerPropertyType *property, const double *values, const char *const *typed)
{
    for (int32_t c = 0; c < tinker_kind_columns(property->kind); c++) {
        char *fault = kind_fault(property, c, values[c]);
        if (fault == NULL) fault = range_fault(property, c, values[c], typed != NULL ? typed[c] : NULL);
        if (fault != NULL) return fault;
    }
    return NULL;
}

char *scene_row_fault(const SceneTable *table, int32_t row)
{
    const TinkerBlockClass *block_class = table->block_class;
    int32_t fixed = tinker_block_class_meaning_column(block_class, TINKER_MEANING_STATIC_FRICTION);
    int32_t sliding = tinker_block_class_meaning_column(block_class, TINKER_MEANING_DYNAMIC_FRICTION);
    if (fixed < 0 || sliding < 0) return NULL;
    double most = table->columns[fixed][row], given = table->columns[sliding][row];
    if (!(given > most)) return NULL;
    char most_text[64], given_text[64];
    tinker_number_to_text(most, most_text, sizeof most_text);
    tinker_number_to_text(given, given_text, sizeof given_text);
    const int32_t above = block_class->meanings[TINKER_MEANING_DYNAMIC_FRICTION];
    const int32_t below = block_class->meanings[TINKER_MEANING_STATIC_FRICTION];
    const char *above_id = block_class->properties[above].id, *below_id = block_class->properties[below].id;
    const char *not_given = !table->given[above][row] ? above_id : !table->given[below][row] ? below_id : NULL;
    g_autofree char *advice =
        not_given != NULL ? g_strdup_printf("; %s is not given: give both", not_given) : g_strdup("");
    return g_strdup_printf("%s must be at most %s, which is %s (it is %s%s)", above_id, below_id, most_text, given_text,
                           advice);
}

void scene_store(SceneTable *table, int32_t row, int32_t property, const double *values)
{
    const TinkerBlockClass *block_class = table->block_class;
    int32_t first = block_class->first_columns[property];
    for (int32_t c = 0; c < tinker_kind_columns(block_class->properties[property].kind); c++)
        table->columns[first + c][row] = values[c];
    table->given[property][row] = 1;
}

void scene_store_text(SceneTable *table, int32_t row, int32_t property, const char *text)
{
    char *copy = g_strdup(text);
    g_free(table->texts[property][row]);
    table->texts[property][row] = copy;
    table->given[property][row] = copy != NULL;
}

void scene_store_waveform(SceneTable *table, int32_t row, int32_t property, TinkerWaveform *waveform)
{
    if (waveform != NULL) tinker_waveform_ref(waveform);
    g_clear_pointer(&table->waveforms[property][row], tinker_waveform_unref);
    table->waveforms[property][row] = waveform;
    table->given[property][row] = waveform != NULL;
}

/* The table and row of a block that has properties. */
static SceneTable *row_of(const TinkerScene *scene, TinkerBlockId block, int32_t *row)
{
    g_assert(tinker_scene_has_block(scene, block));
    SceneTable *table = scene_table_of(scene, block);
    g_assert(table != NULL);
    *row = scene_slot(scene, block)->row;
    return table;
}

gboolean tinker_scene_property_given(const TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    int32_t row;
    const SceneTable *table = row_of(scene, block, &row);
    g_assert(property >= 0 && property < table->block_class->property_count);
    return table->given[property][row];
}

double tinker_scene_get(const TinkerScene *scene, TinkerBlockId block, int32_t column)
{
    int32_t row;
    const SceneTable *table = row_of(scene, block, &row);
    g_assert(column >= 0 && column < table->block_class->column_count);
    return table->columns[column][row];
}

/* Puts back what a property was, after a change that the row as a whole does not allow. */
static void put_back(SceneTable *table, int32_t row, int32_t property, const double *values, gboolean given)
{
    scene_store(table, row, property, values);
    table->given[property][row] = given ? 1 : 0;
    scene_table_resolve(table, row);
}

/* A position that was given counts from now on; other changes move what lies on tops. */
static void settle_after(TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, block);
    if (property == block_class->meanings[TINKER_MEANING_POSITION] && scene_place_on(scene, block) != NULL)
        scene_fix_place(scene, block);
    scene_settle_after(scene, block);
}

gboolean tinker_scene_set(TinkerScene *scene, TinkerBlockId block, int32_t property, const double *values,
                          GError **error)
{
    int32_t row;
    SceneTable *table = row_of(scene, block, &row);
    g_assert(property >= 0 && property < table->block_class->property_count);
    const TinkerPropertyType *type = &table->block_class->properties[property];
    g_assert(type->kind != TINKER_KIND_TEXT && type->kind != TINKER_KIND_WAVEFORM);

    g_autofree char *fault = NULL;
    if (type->flags & (TINKER_READ_ONLY | TINKER_DERIVED))
        fault = g_strdup_printf("%s is shown, not set", type->id);
    else
        fault = scene_value_fault(type, values, NULL);
    if (fault == NULL) {
        double old[2] = {0, 0};
        for (int32_t c = 0; c < tinker_kind_columns(type->kind); c++)
            old[c] = table->columns[table->block_class->first_columns[property] + c][row];
        gboolean given = table->given[property][row];
        scene_store(table, row, property, values);
        scene_table_resolve(table, row);
        fault = scene_row_fault(table, row);
        if (fault == NULL) {
            settle_after(scene, block, property);
            return TRUE;
        }
        put_back(table, row, property, old, given);
    }
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, "%s: %s", tinker_scene_block_name(scene, block),
                fault);
    return FALSE;
}

void tinker_scene_unset(TinkerScene *scene, TinkerBlockId block, int32_t property)
{
    int32_t row;
    SceneTable *table = row_of(scene, block, &row);
    g_assert(property >= 0 && property < table->block_class->property_count);
    if (table->texts[property] != NULL) scene_store_text(table, row, property, NULL);
    if (table->waveforms[property] != NULL) scene_store_waveform(table, row, property, NULL);
    scene_table_set_default(table, row, property);
    scene_table_resolve(table, row);

    settle_after(scene, block, property);

    /* The default of one friction coefficient may not go with the other as given; then both are the default. */
    g_autofree char *fault = scene_row_fault(table, row);
    if (fault == NULL) return;
    scene_table_set_default(table, row, table->block_class->meanings[TINKER_MEANING_STATIC_FRICTION]);
    scene_table_set_default(table, row, table->block_class->meanings[TINKER_MEANING_DYNAMIC_FRICTION]);
    scene_table_resolve(table, row);
}

void tinker_scene_set_text(TinkerScene *scene, TinkerBlockId block, int32_t property, const char *text)
{
    int32_t row;
    SceneTable *table = row_of(scene, block, &row);
    g_assert(property >= 0 && property < table->block_class->property_count && table->texts[property] != NULL);
    scene_store_text(table, row, property, text);
}

void tinker_scene_set_waveform(TinkerScene *scene, TinkerBlockId block, int32_t property, TinkerWaveform *waveform)
{
    int32_t row;
    SceneTable *table = row_of(scene, block, &row);
    g_assert(property >= 0 && property < table->block_class->property_count && table->waveforms[property] != NULL);
    scene_store_waveform(table, row, property, waveform);
    scene_settle_after(scene, block);
}
