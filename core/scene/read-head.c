/* Reading what stands around the blocks: the version, texts, canvas and run settings, and unknown keys. */
#include <string.h>

#include "scene/reader-private.h"

/* A number of the head, described as a property is, and where it goes. */
typedef struct {
    TinkerPropertyType type;
    gsize offset; /* in TinkerSceneHead */
} HeadNumber;

#define POSITIVE TINKER_HAS_MINIMUM | TINKER_OPEN_MINIMUM
static const HeadNumber canvas_numbers[] = {
    {{.id = "width", .dimension = {.length = 1}, .flags = POSITIVE}, G_STRUCT_OFFSET(TinkerSceneHead, canvas_width)},
    {{.id = "grid", .dimension = {.length = 1}, .flags = POSITIVE}, G_STRUCT_OFFSET(TinkerSceneHead, canvas_grid)},
};
static const HeadNumber run_numbers[] = {
    {{.id = "duration", .dimension = {.time = 1}, .flags = POSITIVE}, G_STRUCT_OFFSET(TinkerSceneHead, run.duration)},
    {{.id = "interval", .dimension = {.time = 1}, .flags = POSITIVE}, G_STRUCT_OFFSET(TinkerSceneHead, run.interval)},
    {{.id = "step", .dimension = {.time = 1}, .flags = POSITIVE}, G_STRUCT_OFFSET(TinkerSceneHead, run.step)},
    {{.id = "tolerance", .flags = POSITIVE | TINKER_HAS_MAXIMUM | TINKER_OPEN_MAXIMUM, .hard_maximum = 1},
     G_STRUCT_OFFSET(TinkerSceneHead, run.tolerance)},
    {{.id = "spectral_radius", .flags = TINKER_HAS_MINIMUM | TINKER_HAS_MAXIMUM, .hard_maximum = 1},
     G_STRUCT_OFFSET(TinkerSceneHead, run.spectral_radius)},
};

/* Reads the number of this name, if it is one of them. */
static gboolean head_number(SceneReader *reader, const cJSON *json, JsonAt at, const HeadNumber *numbers, gsize count)
{
    for (gsize i = 0; i < count; i++) {
        const TinkerPropertyType *type = &numbers[i].type;
        if (!g_str_equal(json->string, type->id)) continue;
        double value;
        if (!reader_number(reader, json, at, type->id, type->dimension, &value)) return TRUE;
        g_autofree char *fault = scene_value_fault(type, &value);
        if (fault != NULL)
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
        else
            G_STRUCT_MEMBER(double, &reader->scene->head, numbers[i].offset) = value;
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
    return head_number(reader, json, at, canvas_numbers, G_N_ELEMENTS(canvas_numbers));
}

static gboolean run_member(SceneReader *reader, const cJSON *json, JsonAt at)
{
    static const char *const contacts[] = {"events", "impulse", NULL};
    TinkerRunSettings *run = &reader->scene->head.run;
    if (g_str_equal(json->string, "method")) {
        head_text(reader, json, at, "method", &run->method);
        return TRUE;
    }
    if (g_str_equal(json->string, "contacts")) {
        int choice = reader_choice(reader, json, at, "contacts", contacts);
        if (choice < 0) return TRUE;
        g_free(run->contacts);
        run->contacts = g_strdup(contacts[choice]);
        return TRUE;
    }
    return head_number(reader, json, at, run_numbers, G_N_ELEMENTS(run_numbers));
}

typedef gboolean (*ReadMember)(SceneReader *reader, const cJSON *json, JsonAt at);

/* An object of known members; the others are kept. */
static void head_object(SceneReader *reader, const cJSON *json, const JsonPart *part, const char *label,
                        ReadMember read_member, const char *const *keys, char **extras)
{
    if (!cJSON_IsObject(json)) {
        reader_wrong_kind(reader, json, at_root(part->start), label, "an object");
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
                    "tinker: the version of the format must be the number 1 (it is %s)", given);
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
    static const char *const run_keys[] = {"duration",  "interval", "method",          "step",
                                           "tolerance", "contacts", "spectral_radius", NULL};
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
    static const char *const keys[] = {"tinker", "title", "description", "author", "units",
                                       "canvas", "run",   "blocks",      "graphs", NULL};
    gboolean has_version = FALSE;
    GString *unknown = NULL;
    reader_label(reader, NULL);
    for (guint i = 0; i < reader->scan.members->len; i++) {
        const JsonPart *part = &g_array_index(reader->scan.members, JsonPart, i);
        g_autofree char *key = part_key(reader, part);
        has_version = has_version || g_str_equal(key, "tinker");
        if (g_str_equal(key, "graphs")) continue;
        if (g_str_equal(key, "blocks")) {
            if (reader->text[part->start] != '[')
                reader_error_at(reader, part->start, TINKER_SCENE_ERROR_VALUE, "blocks: an array was expected");
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
                        "not a scene: the key \"tinker\" with the version of the format, 1, is missing");
    if (unknown != NULL) reader->scene->head_extras = g_string_free(unknown, FALSE);
}
