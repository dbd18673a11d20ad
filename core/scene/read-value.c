/* Reading values: numbers, texts with units, vectors, and the properties of blocks. */
#include <math.h>
#include <string.h>

#include "scene/reader-private.h"

const TinkerDimension reader_length = {.length = 1};
const TinkerDimension reader_time = {.time = 1};
const TinkerDimension reader_pure = {0};

static const char *kind_name(const cJSON *json)
{
    if (cJSON_IsObject(json)) return "an object";
    if (cJSON_IsArray(json)) return "an array";
    if (cJSON_IsString(json)) return "a text";
    if (cJSON_IsNumber(json)) return "a number";
    if (cJSON_IsNull(json)) return "null";
    return cJSON_IsTrue(json) ? "true" : "false";
}

gboolean reader_wrong_kind(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, const char *expected)
{
    return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %s was expected, %s is given", what, expected,
                        kind_name(json));
}

gboolean reader_number(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, TinkerDimension dimension,
                       double *value)
{
    if (cJSON_IsNumber(json)) {
        *value = json->valuedouble;
        if (isfinite(*value)) return TRUE;
        return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: the number is too large (at most 1.797e308)",
                            what);
    }
    if (!cJSON_IsString(json)) return reader_wrong_kind(reader, json, at, what, "a number, or a text with a unit,");
    g_autoptr(GError) error = NULL;
    if (tinker_quantity_parse(json->valuestring, dimension, value, &error)) return TRUE;
    /* A wrong dimension is that of the whole text, so the column inside it says nothing. */
    const char *message = error->message, *colon = strstr(message, ": ");
    if (g_error_matches(error, TINKER_UNITS_ERROR, TINKER_UNITS_ERROR_DIMENSION) && colon != NULL &&
        g_str_has_prefix(message, "column "))
        message = colon + 2;
    return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %s", what, message);
}

gboolean reader_vector(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, TinkerDimension dimension,
                       double values[2])
{
    if (!cJSON_IsArray(json)) return reader_wrong_kind(reader, json, at, what, "a vector [x, y]");
    int count = cJSON_GetArraySize(json);
    if (count != 2)
        return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: a vector has 2 numbers, [x, y], %d given", what,
                            count);
    g_autofree char *x = g_strconcat(what, ": x", NULL);
    g_autofree char *y = g_strconcat(what, ": y", NULL);
    gboolean good = reader_number(reader, json->child, at_child(at, 0), x, dimension, &values[0]);
    return reader_number(reader, json->child->next, at_child(at, 1), y, dimension, &values[1]) && good;
}

const char *reader_text(SceneReader *reader, const cJSON *json, JsonAt at, const char *what)
{
    if (cJSON_IsString(json)) return json->valuestring;
    reader_wrong_kind(reader, json, at, what, "a text");
    return NULL;
}

gboolean reader_switch(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, gboolean *value)
{
    *value = cJSON_IsTrue(json);
    return cJSON_IsBool(json) || reader_wrong_kind(reader, json, at, what, "true or false");
}

int reader_choice(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, const char *const *choices)
{
    const char *text = reader_text(reader, json, at, what);
    if (text == NULL) return -1;
    for (int i = 0; choices[i] != NULL; i++)
        if (g_str_equal(choices[i], text)) return i;
    g_autofree char *list = g_strjoinv("\", \"", (char **)choices);
    g_autofree char *otherwise = g_strdup_printf(" (it is one of \"%s\")", list);
    g_autofree char *suggestion = reader_suggestion(text, choices, otherwise);
    reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: \"%s\" is not known%s", what, text, suggestion);
    return -1;
}

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

/* A plain number is in radians; one of more turns than anybody writes was likely meant in degrees. */
#define MOST_TURNS 2.0
static void warn_of_turns(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *type)
{
    static const TinkerDimension angle = {.angle = 1};
    if (!cJSON_IsNumber(json) || !tinker_dimension_equal(type->dimension, angle)) return;
    double turns = fabs(json->valuedouble) / (2 * G_PI);
    if (turns <= MOST_TURNS || !isfinite(turns)) return;
    reader_warning(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %g rad is %.3g turns (did you mean \"%g deg\"?)",
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

void reader_property(SceneReader *reader, const cJSON *json, JsonAt at, SceneTable *table, int32_t row,
                     int32_t property)
{
    const TinkerPropertyType *type = &table->block_class->properties[property];
    if (type->flags & (TINKER_READ_ONLY | TINKER_DERIVED)) {
        reader_warning(reader, at_key(at), TINKER_SCENE_ERROR_VALUE,
                       "%s is worked out, not set: what is given is ignored", type->id);
        return;
    }
    if (type->kind == TINKER_KIND_TEXT) {
        const char *text = reader_text(reader, json, at, type->id);
        if (text != NULL) scene_store_text(table, row, property, text);
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
