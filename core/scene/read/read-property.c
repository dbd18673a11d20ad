/* Reading the value of one property. */
#include <glib/gi18n-lib.h>

#include "scene/value/reader.h"

#include "law/typed-law.h"
#include "units/quantity/point-text.h"
#include "units/quantity/units.h"

/* A plain number is in radians; one of more turns than anybody writes was likely meant in degrees. */
#define MOST_TURNS 2.0

static gboolean property_choice(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *type,
                                double *value)
{
    g_autofree const char **choices = g_new0(const char *, (gsize)type->choice_count + 1);
    for (int32_t i = 0; i < type->choice_count; i++)
        choices[i] = type->choices[i];
    int choice = reader_choice(reader, json, at, type->id, choices);
    *value = choice;
    return choice >= 0;
}

static void warn_of_turns(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *type)
{
    static const TinkerDimension angle = {.angle = 1};
    if (!cJSON_IsNumber(json) || !tinker_dimension_equal(type->dimension, angle)) return;
    double turns = fabs(json->valuedouble) / (2 * G_PI);
    if (turns <= MOST_TURNS || !isfinite(turns)) return;
    reader_warning(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: %g rad is %.3g turns (did you mean \"%g deg\"?)"),
                   type->id, json->valuedouble, turns, json->valuedouble);
}

/* The numbers of a property that has columns. */
static gboolean property_numbers(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *type,
                                 double values[2])
{
    gboolean on;
    switch (type->kind) {
    case TINKER_KIND_VECTOR:
        return reader_vector(reader, json, at, type->id, type->dimension, values);
    case TINKER_KIND_SWITCH:
        if (!reader_switch(reader, json, at, type->id, &on)) return FALSE;
        values[0] = on ? 1 : 0;
        return TRUE;
    case TINKER_KIND_CHOICE:
        return property_choice(reader, json, at, type, values);
    default:
        return reader_number(reader, json, at, type->id, type->dimension, values);
    }
}

/* What typed laws and their numbers must be. */
static gboolean text_is_good(SceneReader *reader, JsonAt at, const TinkerBlockClass *block_class, int32_t property,
                             const char *text)
{
    const TinkerPropertyType *type = &block_class->properties[property];
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerExpression) parsed = NULL;
    if (text[0] != '\0' && (type->flags & TINKER_TEXT_LAW) != 0)
        parsed = tinker_typed_parse(block_class, property, text, &error);
    double si;
    TinkerDimension dimension;
    if (text[0] != '\0' && (type->flags & TINKER_TEXT_QUANTITY) != 0)
        (void)tinker_any_quantity_parse(text, &si, &dimension, &error);
    if (error != NULL) reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %s", type->id, error->message);
    return error == NULL;
}

/* [[x, y], ...], or a text of points as the window has it. (transfer full) */
static char *property_points(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *type)
{
    g_autoptr(GArray) points = g_array_new(FALSE, FALSE, sizeof(double));
    g_autoptr(GError) error = NULL;
    if (cJSON_IsString(json)) {
        g_array_unref(points);
        points = tinker_point_text_parse(json->valuestring, type->dimension, &error);
        if (error != NULL) reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %s", type->id, error->message);
        return points != NULL ? g_strdup(json->valuestring) : NULL;
    }
    if (!cJSON_IsArray(json) || cJSON_GetArraySize(json) > TINKER_MOST_POINTS) {
        reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: it is a list of at most %d points, [[x, y], ...]"),
                     type->id, TINKER_MOST_POINTS);
        return NULL;
    }
    int number = 0;
    for (const cJSON *point = json->child; point != NULL; point = point->next, number++) {
        g_autofree char *what = g_strdup_printf(_("%s: point %d"), type->id, number + 1);
        double values[2];
        if (!reader_vector(reader, point, at_child(at, number), what, type->dimension, values)) return NULL;
        g_array_append_vals(points, values, 2);
    }
    return tinker_point_text_new((const double *)(void *)points->data, (int32_t)points->len / 2);
}

void reader_property(SceneReader *reader, const cJSON *json, JsonAt at, SceneTable *table, int32_t row,
                     int32_t property)
{
    const TinkerPropertyType *type = &table->block_class->properties[property];
    if (type->flags & (TINKER_READ_ONLY | TINKER_DERIVED)) {
        reader_warning(reader, at_key(at), TINKER_SCENE_ERROR_VALUE,
                       _("%s is worked out, not set: what is given is ignored"), type->id);
        return;
    }
    if ((type->flags & TINKER_TEXT_POINTS) != 0) {
        g_autofree char *points = property_points(reader, json, at, type);
        if (points != NULL) scene_store_text(table, row, property, points);
        return;
    }
    if (type->kind == TINKER_KIND_TEXT) {
        /* a number that laws name may stand without quotes */
        const gboolean plain = (type->flags & TINKER_TEXT_QUANTITY) != 0 && cJSON_IsNumber(json);
        g_autofree char *digits =
            plain ? tinker_quantity_to_text(json->valuedouble, type->dimension, TINKER_UNIT_SYSTEM_SI) : NULL;
        const char *text = plain ? digits : reader_text(reader, json, at, type->id);
        if (text != NULL && text_is_good(reader, at, table->block_class, property, text))
            scene_store_text(table, row, property, text);
        return;
    }
    warn_of_turns(reader, json, at, type);
    if (type->kind == TINKER_KIND_WAVEFORM) {
        g_autoptr(TinkerWaveform) waveform = reader_waveform(reader, json, at, type);
        if (waveform != NULL) scene_store_waveform(table, row, property, waveform);
        return;
    }
    double values[2] = {0, 0};
    if (!property_numbers(reader, json, at, type, values)) return;
    const gboolean vector = type->kind == TINKER_KIND_VECTOR;
    const char *const typed[2] = {vector ? json->child->valuestring : json->valuestring,
                                  vector ? json->child->next->valuestring : NULL};
    g_autofree char *fault = scene_value_fault(type, values, typed);
    if (fault != NULL)
        reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
    else
        scene_store(table, row, property, values);
}
