/* Reading values: numbers, texts with units, vectors, and the properties of blocks. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "scene/value/reader.h"

const TinkerDimension reader_length = {.length = 1};
const TinkerDimension reader_pure = {0};

static const char *kind_name(const cJSON *json)
{
    if (cJSON_IsObject(json)) return _("an object");
    if (cJSON_IsArray(json)) return _("an array");
    if (cJSON_IsString(json)) return _("a text");
    if (cJSON_IsNumber(json)) return _("a number");
    if (cJSON_IsNull(json)) return "null";
    return cJSON_IsTrue(json) ? "true" : "false";
}

gboolean reader_wrong_kind(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, const char *expected)
{
    return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: %s was expected, %s is given"), what, expected,
                        kind_name(json));
}

gboolean reader_number(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, TinkerDimension dimension,
                       double *value)
{
    if (cJSON_IsNumber(json)) {
        *value = json->valuedouble;
        if (isfinite(*value)) return TRUE;
        return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: the number is too large (at most 1.797e308)"),
                            what);
    }
    if (!cJSON_IsString(json)) return reader_wrong_kind(reader, json, at, what, _("a number, or a text with a unit,"));
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
    if (!cJSON_IsArray(json)) return reader_wrong_kind(reader, json, at, what, _("a vector [x, y]"));
    int count = cJSON_GetArraySize(json);
    if (count != 2)
        return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: a vector has 2 numbers, [x, y], %d given"),
                            what, count);
    g_autofree char *x = g_strconcat(what, ": x", NULL);
    g_autofree char *y = g_strconcat(what, ": y", NULL);
    gboolean good = reader_number(reader, json->child, at_child(at, 0), x, dimension, &values[0]);
    return reader_number(reader, json->child->next, at_child(at, 1), y, dimension, &values[1]) && good;
}

const char *reader_text(SceneReader *reader, const cJSON *json, JsonAt at, const char *what)
{
    if (cJSON_IsString(json)) return json->valuestring;
    reader_wrong_kind(reader, json, at, what, _("a text"));
    return NULL;
}

gboolean reader_switch(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, gboolean *value)
{
    *value = cJSON_IsTrue(json);
    return cJSON_IsBool(json) || reader_wrong_kind(reader, json, at, what, _("true or false"));
}

int reader_choice(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, const char *const *choices)
{
    const char *text = reader_text(reader, json, at, what);
    if (text == NULL) return -1;
    for (int i = 0; choices[i] != NULL; i++)
        if (g_str_equal(choices[i], text)) return i;
    g_autofree char *list = g_strjoinv("\", \"", (char **)choices);
    g_autofree char *otherwise = g_strdup_printf(_(" (it is one of \"%s\")"), list);
    g_autofree char *suggestion = reader_suggestion(text, choices, otherwise);
    reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: \"%s\" is not known%s"), what, text, suggestion);
    return -1;
}
