/* Reading controls and meters: what each is of, and where it stands on the canvas. */
#include <glib/gi18n-lib.h>

#include "scene/store/quantities.h"
#include "scene/value/reader.h"

typedef struct {
    TinkerSceneInstrument *instrument;
    gboolean controls;
    gboolean given[2]; /* from, to */
    JsonAt at;
} ReadInstrument;

/* The first member of this name, and its number. */
static const cJSON *member_of(const cJSON *json, const char *key, int *number)
{
    *number = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, ++*number)
        if (g_str_equal(member->string, key)) return member;
    return NULL;
}

static gboolean read_name(SceneReader *reader, const cJSON *json, JsonAt at, const char *key, char **text)
{
    int number;
    const cJSON *member = member_of(json, key, &number);
    if (member == NULL) return reader_error(reader, at, TINKER_SCENE_ERROR_SYNTAX, _("the key \"%s\" is missing"), key);
    const char *given = reader_text(reader, member, at_child(at, number), key);
    if (given == NULL) return FALSE;
    g_free(*text);
    *text = g_strdup(given);
    return TRUE;
}

static TinkerDimension dimension_of(const SceneReader *reader, const TinkerSceneInstrument *instrument)
{
    TinkerNumber number;
    TinkerBlockId block;
    const gboolean known = tinker_scene_find_owner(reader->scene, instrument->block, &block) &&
                           tinker_scene_find_number(reader->scene, block, instrument->of, &number);
    return known ? number.type->dimension : reader_pure;
}

static void read_kind(SceneReader *reader, const cJSON *json, JsonAt at, const ReadInstrument *read)
{
    static const char *const meters[] = {"number", "dial", "bar", NULL}, *const controls[] = {"slider", "knob",
                                                                                              "switch", NULL};
    const int kind = reader_choice(reader, json, at, "kind", read->controls ? controls : meters);
    if (kind >= 0)
        read->instrument->kind = (read->controls ? 0 : TINKER_INSTRUMENT_NUMBER) + (TinkerInstrumentKind)kind;
}

static void read_member(SceneReader *reader, const cJSON *json, JsonAt at, ReadInstrument *read, GString **unknown)
{
    static const char *const of_control[] = {"block", "property", "from",      "to", "step",
                                             "place", "kind",     "makes_way", NULL};
    static const char *const of_meter[] = {"block", "quantity", "kind", "place", "makes_way", NULL};
    TinkerSceneInstrument *instrument = read->instrument;
    const char *key = json->string;
    const TinkerDimension dimension = dimension_of(reader, instrument);
    if (g_str_equal(key, "block") || g_str_equal(key, read->controls ? "property" : "quantity")) return;
    if (g_str_equal(key, "place")) {
        instrument->has_place = reader_vector(reader, json, at, "place", reader_length, instrument->place);
    } else if (g_str_equal(key, "makes_way")) {
        reader_switch(reader, json, at, "makes_way", &instrument->makes_way);
    } else if (g_str_equal(key, "kind")) {
        read_kind(reader, json, at, read);
    } else if (read->controls && g_str_equal(key, "from")) {
        read->given[0] = reader_number(reader, json, at, "from", dimension, &instrument->from);
    } else if (read->controls && g_str_equal(key, "to")) {
        read->given[1] = reader_number(reader, json, at, "to", dimension, &instrument->to);
    } else if (read->controls && g_str_equal(key, "step")) {
        reader_number(reader, json, at, "step", dimension, &instrument->step);
    } else {
        reader_keep_unknown(reader, at, key, read->controls ? of_control : of_meter, unknown);
    }
}

static gboolean check(SceneReader *reader, const ReadInstrument *read)
{
    const TinkerSceneInstrument *instrument = read->instrument;
    TinkerBlockId block;
    if (!tinker_scene_find_owner(reader->scene, instrument->block, &block)) {
        g_autofree char *suggestion = reader_suggest_block(reader, instrument->block);
        return reader_error(reader, read->at, TINKER_SCENE_ERROR_VALUE, _("block: there is no block \"%s\"%s"),
                            instrument->block, suggestion);
    }
    for (int i = 0; i < 2; i++)
        if (read->controls && instrument->kind != TINKER_INSTRUMENT_SWITCH && !read->given[i])
            return reader_error(reader, read->at, TINKER_SCENE_ERROR_SYNTAX,
                                _("the key \"%s\" is missing: a control has a range"), i == 0 ? "from" : "to");
    g_autofree char *fault = scene_instrument_fault(reader->scene, instrument);
    return fault == NULL || reader_error(reader, read->at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
}

static void read_instrument(SceneReader *reader, const cJSON *json, JsonAt at, gboolean controls)
{
    ReadInstrument read = {.controls = controls, .at = at};
    GString *unknown = NULL;
    int step = 0;
    read.instrument =
        tinker_scene_instrument_new(controls ? TINKER_INSTRUMENT_SLIDER : TINKER_INSTRUMENT_NUMBER, "", "");
    const gboolean named = read_name(reader, json, at, "block", &read.instrument->block) &&
                           read_name(reader, json, at, controls ? "property" : "quantity", &read.instrument->of);
    for (const cJSON *member = json->child; member != NULL && named; member = member->next, step++)
        read_member(reader, member, at_child(at, step), &read, &unknown);
    if (named) check(reader, &read);
    read.instrument->extras = unknown == NULL ? NULL : g_string_free(unknown, FALSE);
    g_ptr_array_add(reader->scene->instruments, read.instrument);
}

void reader_instruments(SceneReader *reader, const JsonPart *part, gboolean controls)
{
    const char *list = controls ? "controls" : "meters";
    cJSON *json = reader_parse(reader, part);
    if (json == NULL) return;
    if (!cJSON_IsArray(json)) reader_wrong_kind(reader, json, at_root(part->start), list, _("an array"));
    int number = 0;
    for (const cJSON *entry = cJSON_IsArray(json) ? json->child : NULL; entry != NULL; entry = entry->next, number++) {
        const JsonAt at = at_child(at_root(part->start), number);
        reader_label_entry(reader, list, number, NULL);
        if (cJSON_IsObject(entry))
            read_instrument(reader, entry, at, controls);
        else
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE,
                         _("an entry is an object, {\"block\": ..., \"%s\": ...}"), controls ? "property" : "quantity");
    }
    reader_label(reader, NULL);
    cJSON_Delete(json);
}
