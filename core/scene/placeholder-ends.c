/* The ends of placeholders. Nobody knows what a type that is missing means by its keys, but the format says what ends are: where
 * blocks get other names, the names in a placeholder's ends follow, and everything else stays as it was read. */
#include "scene/reader-private.h"

/* Appends a value: the new name of the block that it names, or as it is. */
static void append_name(GString *out, const char *text, const JsonPart *part, GHashTable *names)
{
    cJSON *json = cJSON_ParseWithLength(text + part->start, part->end - part->start);
    const char *name = cJSON_GetStringValue(json);
    const char *new_name = name == NULL ? NULL : g_hash_table_lookup(names, name);
    if (new_name != NULL)
        json_append_string(out, new_name);
    else
        g_string_append_len(out, text + part->start, (gssize)(part->end - part->start));
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

static void append_ends(GString *out, const char *text, const JsonPart *part, GHashTable *names)
{
    g_autoptr(GArray) ends = json_split(text, part->start);
    gsize from = part->start;
    for (guint i = 0; text[part->start] == '[' && i < ends->len; i++) {
        const JsonPart *end = &g_array_index(ends, JsonPart, i);
        g_string_append_len(out, text + from, (gssize)(end->start - from));
        if (text[end->start] == '{')
            append_object(out, text, end, names);
        else
            append_name(out, text, end, names);
        from = end->end;
    }
    g_string_append_len(out, text + from, (gssize)(part->end - from));
}

gboolean scene_placeholder_rename_ends(ScenePlaceholder *placeholder, GHashTable *names)
{
    g_autofree char *text = placeholder->text;
    g_autoptr(GArray) members = json_split(text, 0);
    GString *out = g_string_new(NULL);
    gsize from = 0;
    for (guint i = 0; i < members->len; i++) {
        const JsonPart *member = &g_array_index(members, JsonPart, i);
        if (!json_key_is(text, member, "ends")) continue;
        g_string_append_len(out, text + from, (gssize)(member->start - from));
        append_ends(out, text, member, names);
        from = member->end;
    }
    g_string_append(out, text + from);
    placeholder->text = g_string_free(out, FALSE);
    return !g_str_equal(placeholder->text, text);
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

/* A block is named where another name in its place would change the text. */
GArray *scene_placeholders_on(const TinkerScene *scene, TinkerBlockId block)
{
    GArray *blocks = g_array_new(FALSE, FALSE, sizeof(TinkerBlockId));
    g_autoptr(GHashTable) names = one_name(scene_slot(scene, block)->name, "");
    GHashTableIter iter;
    gpointer id, placeholder;
    g_hash_table_iter_init(&iter, scene->placeholders);
    while (g_hash_table_iter_next(&iter, &id, &placeholder)) {
        TinkerBlockId of = GPOINTER_TO_INT(id);
        ScenePlaceholder *copy = scene_placeholder_copy(placeholder);
        if (tinker_scene_has_block(scene, of) && scene_placeholder_rename_ends(copy, names))
            g_array_append_val(blocks, of);
        scene_placeholder_free(copy);
    }
    return blocks;
}
