/* The template is a scene file among the resources: it names the blocks that every new scene begins with, so that this
 * code names none. */
#include "gui/document/new-scene.h"

#include <cjson/cJSON.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "gui/text/number-text.h"

#define TEMPLATE       "/org/tinker/Tinker/new-scene.tinker.json"
#define LEAST_WIDTH    1e-6 /* m */
#define GREATEST_WIDTH 1e6
#define GRID_LINES     50.0 /* across the canvas, about */

static const TinkerDimension length = {.length = 1};

const char *tinker_new_scene_default_width(TinkerUnitSystem units)
{
    return units == TINKER_UNIT_SYSTEM_ENGLISH ? "30 ft" : "10 m";
}

gboolean tinker_new_scene_parse_width(const char *text, TinkerUnitSystem units, double *width, GError **error)
{
    const char *example = tinker_new_scene_default_width(units);
    g_autoptr(GError) reason = NULL;
    if (text[strspn(text, " \t")] == '\0') {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, _("Type a length, such as “%s”."), example);
        return FALSE;
    }
    if (!tinker_number_read(text, length, tinker_unit_for(length, units), width, &reason)) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, _("Not a length such as “%s”: %s"), example,
                    reason->message);
        return FALSE;
    }
    if (*width >= LEAST_WIDTH && *width <= GREATEST_WIDTH) return TRUE;
    g_autofree char *least = tinker_quantity_format(LEAST_WIDTH, length, "mm", units, 3);
    g_autofree char *greatest = tinker_quantity_format(GREATEST_WIDTH, length, "km", units, 0);
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, _("The width must be between %s and %s."), least,
                greatest);
    return FALSE;
}

/* The greatest of 1, 2, 5, 10, ... in the system's own unit that leaves about GRID_LINES lines. In m. */
static double round_grid(const TinkerNewScene *settings)
{
    static const double steps[] = {5, 2, 1};
    TinkerUnit unit;
    if (!tinker_unit_parse(tinker_unit_for(length, settings->units), &unit, NULL)) return settings->width / GRID_LINES;
    double wanted = settings->width / unit.factor / GRID_LINES * (1 + 1e-9);
    double power = pow(10, floor(log10(wanted)));
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++)
        if (steps[i] * power <= wanted) return steps[i] * power * unit.factor;
    return power * unit.factor;
}

static void set_number(cJSON *object, const char *key, double value)
{
    char text[64];
    tinker_number_to_text(value, text, sizeof text);
    cJSON_DeleteItemFromObject(object, key);
    cJSON_AddRawToObject(object, key, text);
}

gboolean tinker_new_scene_start(TinkerDocument *document, const TinkerNewScene *settings, GError **error)
{
    g_autoptr(GBytes) bytes = g_resources_lookup_data(TEMPLATE, G_RESOURCE_LOOKUP_FLAGS_NONE, error);
    if (bytes == NULL) return FALSE;
    gsize size;
    const char *data = g_bytes_get_data(bytes, &size);
    cJSON *json = cJSON_ParseWithLength(data, size);
    cJSON *canvas = cJSON_GetObjectItemCaseSensitive(json, "canvas");
    if (canvas == NULL) canvas = cJSON_AddObjectToObject(json, "canvas");
    set_number(canvas, "width", settings->width);
    set_number(canvas, "grid", round_grid(settings));
    cJSON_DeleteItemFromObject(json, "units");
    cJSON_AddStringToObject(json, "units", settings->units == TINKER_UNIT_SYSTEM_ENGLISH ? "English" : "SI");
    char *text = cJSON_PrintUnformatted(json);
    cJSON_Delete(json);
    gboolean started = tinker_document_start(document, text, strlen(text), NULL, error);
    cJSON_free(text);
    return started;
}
