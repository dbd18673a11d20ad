/* Reading ends, and joining them to the blocks that they name, which may come later in the file. */
#include <glib/gi18n-lib.h>

#include "scene/value/reader.h"

/* Joins an end to a block, or says why not. */
static void attach(SceneReader *reader, const ReaderEnd *end, TinkerBlockId target)
{
    const SceneTable *table = scene_table_of(reader->scene, end->block);
    TinkerSceneEnd *stored = &scene_table_ends(table, scene_slot(reader->scene, end->block)->row)[end->end];
    TinkerSceneEnd to = {target, stored->x, stored->y};
    g_autofree char *fault = scene_end_fault(reader->scene, end->block, end->end, to);
    if (fault == NULL) {
        *stored = to;
        return;
    }
    gboolean is_place = target != end->block && (to.x != 0 || to.y != 0) && end->at_at.depth > 0;
    reader_error(reader, is_place ? end->at_at : end->name_at, TINKER_SCENE_ERROR_END, "%s", fault);
}

static void read_name(SceneReader *reader, const cJSON *json, ReaderEnd end)
{
    TinkerBlockId target = tinker_scene_find_block(reader->scene, json->valuestring);
    if (target != TINKER_NO_BLOCK) {
        attach(reader, &end, target);
        return;
    }
    end.name = g_string_chunk_insert(reader->end_names, json->valuestring);
    g_array_append_val(reader->later_ends, end);
}

/* {"block": name, "at": [x, y]} */
static void read_object(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, ReaderEnd end)
{
    static const char *const keys[] = {"block", "at", NULL};
    const cJSON *name = NULL;
    double place[2] = {0, 0};
    gboolean good = TRUE;
    GString *unknown = NULL;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++) {
        if (g_str_equal(member->string, "block")) {
            name = member;
            end.name_at = at_child(at, step);
            g_autofree char *path = g_strconcat(what, ": block", NULL);
            good = reader_text(reader, member, end.name_at, path) != NULL && good;
        } else if (g_str_equal(member->string, "at")) {
            end.at_at = at_child(at, step);
            g_autofree char *path = g_strconcat(what, ": at", NULL);
            good = reader_vector(reader, member, end.at_at, path, reader_length, place) && good;
        } else {
            reader_keep_unknown(reader, at_child(at, step), member->string, keys, &unknown);
        }
    }
    if (unknown != NULL)
        g_hash_table_insert(reader->scene->end_extras, scene_end_key(end.block, end.end),
                            g_string_free(unknown, FALSE));
    if (name == NULL) {
        reader_error(reader, at, TINKER_SCENE_ERROR_END, _("%s: an end that is an object names its \"block\""), what);
    } else if (good) {
        const SceneTable *table = scene_table_of(reader->scene, end.block);
        TinkerSceneEnd *stored = &scene_table_ends(table, scene_slot(reader->scene, end.block)->row)[end.end];
        *stored = (TinkerSceneEnd){TINKER_NO_BLOCK, place[0], place[1]};
        read_name(reader, name, end);
    }
}

static void read_detached(SceneReader *reader, const cJSON *json, JsonAt at, const char *what, TinkerBlockId block,
                          int32_t number)
{
    double place[2];
    if (!reader_vector(reader, json, at, what, reader_length, place)) return;
    const SceneTable *table = scene_table_of(reader->scene, block);
    scene_table_ends(table, scene_slot(reader->scene, block)->row)[number] =
        (TinkerSceneEnd){TINKER_NO_BLOCK, place[0], place[1]};
}

void reader_ends(SceneReader *reader, const cJSON *json, JsonAt at, TinkerBlockId block)
{
    int32_t number = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, number++) {
        JsonAt end_at = at_child(at, number);
        ReaderEnd end = {.block = block, .end = number, .name_at = end_at, .at_at = at_root(0)};
        if (cJSON_IsString(member)) {
            read_name(reader, member, end);
            continue;
        }
        char what[32];
        g_snprintf(what, sizeof what, _("end %d"), number + 1);
        if (cJSON_IsObject(member))
            read_object(reader, member, end_at, what, end);
        else if (cJSON_IsArray(member))
            read_detached(reader, member, end_at, what, block, number);
        else
            reader_wrong_kind(reader, member, end_at, what, _("the name of a block, an object or a place"));
    }
}

static void name_unnamed(SceneReader *reader)
{
    TinkerScene *scene = reader->scene;
    for (guint i = 0; i < reader->unnamed->len; i++) {
        TinkerBlockId id = g_array_index(reader->unnamed, TinkerBlockId, i);
        scene_assign_default_name(scene, id);
        ScenePlaceholder *placeholder = g_hash_table_lookup(scene->placeholders, GINT_TO_POINTER(id));
        if (placeholder != NULL) placeholder->name = g_strdup(tinker_scene_block_name(scene, id));
    }
}

void reader_finish_blocks(SceneReader *reader)
{
    name_unnamed(reader);
    for (guint i = 0; i < reader->later_ends->len; i++) {
        const ReaderEnd *end = &g_array_index(reader->later_ends, ReaderEnd, i);
        reader_label(reader, tinker_scene_block_name(reader->scene, end->block));
        TinkerBlockId target = tinker_scene_find_block(reader->scene, end->name);
        if (target != TINKER_NO_BLOCK) {
            attach(reader, end, target);
            continue;
        }
        g_autofree char *suggestion = reader_suggest_block(reader, end->name);
        reader_error(reader, end->name_at, TINKER_SCENE_ERROR_END, _("end %d names no block \"%s\"%s"), end->end + 1,
                     end->name, suggestion);
    }
    reader_finish_places_on(reader);
    reader_label(reader, NULL);
}
