/* The ends of placeholders. Nobody knows what a type that is missing means by its keys, but the format says what ends
 * are: where blocks get other names, the names in a placeholder's ends follow; where a block goes, the ends on it stay
 * lying where they were; and everything else stays as it was read. */
#include <math.h>

#include "scene/value/reader.h"

/* Appends what becomes of an end. */
typedef void (*AppendEnd)(GString *out, const char *text, const JsonPart *end, gpointer data);

static void append_as_it_is(GString *out, const char *text, const JsonPart *part)
{
    g_string_append_len(out, text + part->start, (gssize)(part->end - part->start));
}

/* Appends a value: the new name of the block that it names, or as it is. */
static void append_name(GString *out, const char *text, const JsonPart *part, GHashTable *names)
{
    cJSON *json = cJSON_ParseWithLength(text + part->start, part->end - part->start);
    const char *name = cJSON_GetStringValue(json);
    const char *new_name = name == NULL ? NULL : g_hash_table_lookup(names, name);
    if (new_name != NULL)
        json_append_string(out, new_name);
    else
        append_as_it_is(out, text, part);
    cJSON_Delete(json);
}

/* {"block": name, ...} */
static void append_object(GString *out, const char *text, const JsonPart *part, GHashTable *names)
{
    g_autoptr(GArray) members = json_split(text, part->start);
    gsize from = part->start;
    for (guint i = 0; i < members->len; i++) {
        const JsonPart *member = &g_array_index(members, JsonPart, i);
        if (!json_key_is(text, member, "block")) continue;
        g_string_append_len(out, text + from, (gssize)(member->start - from));
        append_name(out, text, member, names);
        from = member->end;
    }
    g_string_append_len(out, text + from, (gssize)(part->end - from));
}

static void append_renamed(GString *out, const char *text, const JsonPart *end, gpointer names)
{
    if (text[end->start] == '{')
        append_object(out, text, end, names);
    else
        append_name(out, text, end, names);
}

static void append_ends(GString *out, const char *text, const JsonPart *part, AppendEnd append, gpointer data)
{
    g_autoptr(GArray) ends = json_split(text, part->start);
    gsize from = part->start;
    for (guint i = 0; text[part->start] == '[' && i < ends->len; i++) {
        const JsonPart *end = &g_array_index(ends, JsonPart, i);
        g_string_append_len(out, text + from, (gssize)(end->start - from));
        append(out, text, end, data);
        from = end->end;
    }
    g_string_append_len(out, text + from, (gssize)(part->end - from));
}

/* Answers whether that changed anything. */
static gboolean rewrite_ends(ScenePlaceholder *placeholder, AppendEnd append, gpointer data)
{
    g_autofree char *text = placeholder->text;
    g_autoptr(GArray) members = json_split(text, 0);
    GString *out = g_string_new(NULL);
    gsize from = 0;
    for (guint i = 0; i < members->len; i++) {
        const JsonPart *member = &g_array_index(members, JsonPart, i);
        if (!json_key_is(text, member, "ends")) continue;
        g_string_append_len(out, text + from, (gssize)(member->start - from));
        append_ends(out, text, member, append, data);
        from = member->end;
    }
    g_string_append(out, text + from);
    placeholder->text = g_string_free(out, FALSE);
    return !g_str_equal(placeholder->text, text);
}

gboolean scene_placeholder_rename_ends(ScenePlaceholder *placeholder, GHashTable *names)
{
    return rewrite_ends(placeholder, append_renamed, names);
}

/* (transfer full) */
static GHashTable *one_name(const char *old_name, const char *new_name)
{
    GHashTable *names = g_hash_table_new(g_str_hash, g_str_equal);
    g_hash_table_insert(names, (gpointer)old_name, (gpointer)new_name);
    return names;
}

void scene_placeholders_follow(TinkerScene *scene, const char *old_name, const char *new_name)
{
    g_autoptr(GHashTable) names = one_name(old_name, new_name);
    GHashTableIter iter;
    gpointer placeholder;
    g_hash_table_iter_init(&iter, scene->placeholders);
    while (g_hash_table_iter_next(&iter, NULL, &placeholder))
        scene_placeholder_rename_ends(placeholder, names);
}

/* The names of blocks, each to be replaced by none. (transfer full) */
static GHashTable *names_of(const TinkerScene *scene, GHashTable *blocks)
{
    GHashTable *names = g_hash_table_new(g_str_hash, g_str_equal);
    GHashTableIter iter;
    gpointer id;
    g_hash_table_iter_init(&iter, blocks);
    while (g_hash_table_iter_next(&iter, &id, NULL))
        g_hash_table_insert(names, (gpointer)tinker_scene_block_name(scene, GPOINTER_TO_INT(id)), (gpointer) "");
    return names;
}

/* A block is named where another name in its place would change the text. */
GArray *scene_placeholders_on(const TinkerScene *scene, GHashTable *blocks)
{
    GArray *naming = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    if (g_hash_table_size(scene->placeholders) == 0) return naming;
    g_autoptr(GHashTable) names = names_of(scene, blocks);
    GHashTableIter iter;
    gpointer id, placeholder;
    g_hash_table_iter_init(&iter, scene->placeholders);
    while (g_hash_table_iter_next(&iter, &id, &placeholder)) {
        TinkerBlockId of = GPOINTER_TO_INT(id);
        if (!tinker_scene_has_block(scene, of) || g_hash_table_contains(blocks, id)) continue;
        ScenePlaceholder *copy = scene_placeholder_copy(placeholder);
        if (scene_placeholder_rename_ends(copy, names)) g_array_append_val(naming, of);
        scene_placeholder_free(copy);
    }
    return naming;
}

/* Detaching ---------------------------------------------------------------------------------------------------- */

typedef struct {
    const TinkerScene *scene;
    GHashTable *blocks;
} Leaving;

/* A length as the format writes one (m); what nobody can read counts as none. */
static double length_of(const cJSON *json)
{
    double value = 0;
    if (cJSON_IsNumber(json)) value = json->valuedouble;
    if (cJSON_IsString(json) && !tinker_quantity_parse(json->valuestring, reader_length, &value, NULL)) value = 0;
    return isfinite(value) ? value : 0;
}

static void append_length(GString *out, double value)
{
    char text[64];
    tinker_number_to_text(isfinite(value) ? value : 0, text, sizeof text);
    g_string_append(out, text);
}

/* An end on a block that leaves becomes a place, which is how the format writes one that is detached. */
static void append_detached(GString *out, const char *text, const JsonPart *end, gpointer data)
{
    const Leaving *leaving = data;
    cJSON *json = cJSON_ParseWithLength(text + end->start, end->end - end->start);
    const cJSON *name = cJSON_IsObject(json) ? cJSON_GetObjectItemCaseSensitive(json, "block") : json;
    const cJSON *at = cJSON_IsObject(json) ? cJSON_GetObjectItemCaseSensitive(json, "at") : NULL;
    const char *named = cJSON_GetStringValue(name);
    const TinkerBlockId block = named != NULL ? tinker_scene_find_block(leaving->scene, named) : TINKER_NO_BLOCK;
    if (g_hash_table_contains(leaving->blocks, GINT_TO_POINTER(block))) {
        double place[2];
        TinkerSceneEnd on = {block, length_of(cJSON_GetArrayItem(at, 0)), length_of(cJSON_GetArrayItem(at, 1))};
        scene_end_place(leaving->scene, on, place);
        g_string_append_c(out, '[');
        append_length(out, place[0]);
        g_string_append(out, ", ");
        append_length(out, place[1]);
        g_string_append_c(out, ']');
    } else {
        append_as_it_is(out, text, end);
    }
    cJSON_Delete(json);
}

void scene_placeholders_detach(TinkerScene *scene, GHashTable *blocks)
{
    g_autoptr(GArray) naming = scene_placeholders_on(scene, blocks);
    Leaving leaving = {scene, blocks};
    for (guint i = 0; i < naming->len; i++) {
        gpointer id = GINT_TO_POINTER(g_array_index(naming, TinkerBlockId, i));
        rewrite_ends(g_hash_table_lookup(scene->placeholders, id), append_detached, &leaving);
    }
}
