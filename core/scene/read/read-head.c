/* Reading what stands around the blocks: the version, texts, canvas and run settings, and unknown keys. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "scene/value/reader.h"

/* Reads the number of this name, if it is one of them. */
static gboolean head_number(SceneReader *reader, const cJSON *json, JsonAt at, const char *part)
{
    for (const SceneHeadNumber *number = scene_head_numbers; number->part != NULL; number++) {
        const TinkerPropertyType *type = &number->type;
        if (!g_str_equal(number->part, part) || !g_str_equal(json->string, type->id)) continue;
        double value;
        if (!reader_number(reader, json, at, type->id, type->dimension, &value)) return TRUE;
        g_autofree char *fault = scene_value_fault(type, &value, (const char *const[]){json->valuestring});
        if (fault != NULL)
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
        else
            G_STRUCT_MEMBER(double, &reader->scene->head, number->offset) = value;
        return TRUE;
    }
    return FALSE;
}

static void head_text(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, char **text)
{
    const char *given = reader_text(reader, json, at, what);
    if (given == NULL) return;
    g_free(*text);
    *text = g_strdup(given);
}

static gboolean canvas_member(SceneReader *reader, const cJSON *json, JsonAt at)
{
    if (g_str_equal(json->string, "snap")) {
        reader_switch(reader, json, at, "snap", &reader->scene->head.canvas_snap);
        return TRUE;
    }
    return head_number(reader, json, at, "canvas");
}

/* A text that is one of `choices`. */
static void run_choice(SceneReader *reader, const cJSON *json, JsonAt at, const char *const *choices, char **text)
{
    const int choice = reader_choice(reader, json, at, json->string, choices);
    if (choice < 0) return;
    g_free(*text);
    *text = g_strdup(choices[choice]);
}

static gboolean run_member(SceneReader *reader, const cJSON *json, JsonAt at)
{
    TinkerRunSettings *run = &reader->scene->head.run;
    if (g_str_equal(json->string, "method")) {
        head_text(reader, json, at, "method", &run->method);
        g_autofree char *fault =
            cJSON_IsString(json) ? tinker_catalogue_method_fault(reader->catalogue, run->method) : NULL;
        if (fault != NULL) reader_warning(reader, at, TINKER_SCENE_ERROR_METHOD, "%s", fault);
        return TRUE;
    }
    if (g_str_equal(json->string, "until")) {
        head_text(reader, json, at, "until", &run->until);
        return TRUE;
    }
    if (g_str_equal(json->string, "contacts")) {
        run_choice(reader, json, at, scene_contacts, &run->contacts);
        return TRUE;
    }
    if (g_str_equal(json->string, "impact_law")) {
        run_choice(reader, json, at, tinker_scene_impact_laws, &run->impact_law);
        return TRUE;
    }
    return head_number(reader, json, at, "run");
}

typedef gboolean (*ReadMember)(SceneReader *reader, const cJSON *json, JsonAt at);

/* An object of known members; the others are kept. */
static void head_object(SceneReader *reader, const cJSON *json, const JsonPart *part, const char *label,
                        ReadMember read_member, const char *const *keys, char **extras)
{
    if (!cJSON_IsObject(json)) {
        reader_wrong_kind(reader, json, at_root(part->start), label, _("an object"));
        return;
    }
    reader_label(reader, label);
    GString *unknown = NULL;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++) {
        JsonAt at = at_child(at_root(part->start), step);
        if (!read_member(reader, member, at)) reader_keep_unknown(reader, at, member->string, keys, &unknown);
    }
    reader_label(reader, NULL);
    g_free(*extras);
    *extras = unknown == NULL ? NULL : g_string_free(unknown, FALSE);
}

static void read_version(SceneReader *reader, const cJSON *json, const JsonPart *part)
{
    if (cJSON_IsNumber(json) && json->valuedouble == 1) return;
    g_autofree char *given = g_strndup(reader->text + part->start, MIN(part->end - part->start, 40));
    reader_error_at(reader, part->start, TINKER_SCENE_ERROR_SYNTAX,
                    _("tinker: the version of the format must be the number 1 (it is %s)"), given);
}

static void read_units(SceneReader *reader, const cJSON *json, const JsonPart *part)
{
    static const char *const systems[] = {"SI", "English", NULL};
    int choice = reader_choice(reader, json, at_root(part->start), "units", systems);
    if (choice >= 0) reader->scene->head.units = choice == 0 ? TINKER_UNIT_SYSTEM_SI : TINKER_UNIT_SYSTEM_ENGLISH;
}

/* A top-level key that is neither blocks nor graphs. */
static void read_member(SceneReader *reader, const char *key, const cJSON *json, const JsonPart *part)
{
    static const char *const canvas_keys[] = {"width", "grid", "snap", NULL};
    static const char *const run_keys[] = {"duration",  "interval",   "method",   "step",
                                           "tolerance", "accuracy",   "contacts", "spectral_radius",
                                           "until",     "impact_law", NULL};
    TinkerScene *scene = reader->scene;
    const struct {
        const char *key;
        char **text;
    } texts[] = {
        {"title", &scene->head.title}, {"description", &scene->head.description}, {"author", &scene->head.author}};
    for (gsize i = 0; i < G_N_ELEMENTS(texts); i++) {
        if (!g_str_equal(key, texts[i].key)) continue;
        head_text(reader, json, at_root(part->start), key, texts[i].text);
        return;
    }
    if (g_str_equal(key, "tinker"))
        read_version(reader, json, part);
    else if (g_str_equal(key, "units"))
        read_units(reader, json, part);
    else if (g_str_equal(key, "canvas"))
        head_object(reader, json, part, "canvas", canvas_member, canvas_keys, &scene->canvas_extras);
    else if (g_str_equal(key, "run"))
        head_object(reader, json, part, "run", run_member, run_keys, &scene->run_extras);
}

static char *part_key(SceneReader *reader, const JsonPart *part)
{
    JsonPart key = {part->key, part->key, json_string_end(reader->text, part->key)};
    cJSON *json = reader_parse(reader, &key);
    char *text = g_strdup(json == NULL ? "" : json->valuestring);
    cJSON_Delete(json);
    return text;
}

void reader_head(SceneReader *reader)
{
    static const char *const keys[] = {"tinker", "title",  "description", "author",   "units",  "canvas",
                                       "run",    "blocks", "graphs",      "controls", "meters", NULL};
    gboolean has_version = FALSE;
    GString *unknown = NULL;
    reader_label(reader, NULL);
    for (guint i = 0; i < reader->scan.members->len; i++) {
        const JsonPart *part = &g_array_index(reader->scan.members, JsonPart, i);
        g_autofree char *key = part_key(reader, part);
        has_version = has_version || g_str_equal(key, "tinker");
        if (g_str_equal(key, "graphs") || g_str_equal(key, "controls") || g_str_equal(key, "meters")) continue;
        if (g_str_equal(key, "blocks")) {
            if (reader->text[part->start] != '[')
                reader_error_at(reader, part->start, TINKER_SCENE_ERROR_VALUE, _("blocks: an array was expected"));
        } else if (g_strv_contains(keys, key)) {
            cJSON *json = reader_parse(reader, part);
            if (json != NULL) read_member(reader, key, json, part);
            cJSON_Delete(json);
        } else {
            reader_keep_unknown(reader, at_child(at_root(reader->document), (int)i), key, keys, &unknown);
        }
    }
    if (!has_version)
        reader_error_at(reader, reader->document, TINKER_SCENE_ERROR_SYNTAX,
                        _("not a scene: the key \"tinker\" with the version of the format, 1, is missing"));
    if (unknown != NULL) reader->scene->head_extras = g_string_free(unknown, FALSE);
}
