/* The object that stands for a table in a scene's file is kept as text beside its waveform; here it is made and asked.
 */
#include <glib/gi18n-lib.h>

#include "scene/value/table-source.h"

#include "scene/value/reader.h"

/* Those that TinkerTableSource says all of. */
static gboolean is_known(const char *text, const JsonPart *member)
{
    static const char *const keys[] = {"table", "column", "scale", "kind"};
    for (gsize i = 0; i < G_N_ELEMENTS(keys); i++)
        if (json_key_is(text, member, keys[i])) return TRUE;
    return FALSE;
}

static void append_unknown(GString *members, const char *object)
{
    g_autoptr(GArray) parts = json_split(object, 0);
    for (guint i = 0; i < parts->len; i++) {
        const JsonPart *member = &g_array_index(parts, JsonPart, i);
        if (!is_known(object, member)) json_append_member(members, object, member);
    }
}

/* The object on one line, without what has its default. `former` is such an object, or NULL. (transfer full) */
static char *object_text(const TinkerTableSource *source, const char *former)
{
    g_autoptr(GString) members = g_string_new("\"table\": ");
    json_append_string(members, source->file);
    if (source->column != 1) g_string_append_printf(members, ", \"column\": %d", source->column);
    if (source->scale != 1) {
        char number[32];
        tinker_number_to_text(source->scale, number, sizeof number);
        g_string_append_printf(members, ", \"scale\": %s", number);
    }
    if (source->kind == TINKER_TABLE_ACCELERATION) g_string_append(members, ", \"kind\": \"acceleration\"");
    if (former != NULL) append_unknown(members, former);
    return g_strdup_printf("{%s}", members->str);
}

TinkerWaveform *tinker_scene_read_table(TinkerScene *scene, const char *path, const TinkerTableSource *source,
                                        const TinkerPropertyType *property, TinkerWaveform *former, GError **error)
{
    if (!reader_table_fits(source->kind, property, error)) return NULL;
    if (!g_utf8_validate(source->file, -1, NULL)) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE,
                    _("the name of the file is not UTF-8, and a scene can hold no other text"));
        return NULL;
    }
    g_autofree char *folder = g_path_get_dirname(path);
    g_autofree char *file = reader_table_path(folder, source->file, error);
    if (file == NULL) return NULL;
    TinkerWaveform *waveform = reader_table(file, source, property, error);
    if (waveform == NULL) return NULL;
    const char *before = former != NULL ? g_hash_table_lookup(scene->sources, former) : NULL;
    g_hash_table_insert(scene->sources, tinker_waveform_ref(waveform), object_text(source, before));
    return waveform;
}

char *tinker_scene_table_file(const TinkerScene *scene, TinkerWaveform *waveform)
{
    const char *source = g_hash_table_lookup(scene->sources, waveform);
    cJSON *object = source != NULL ? cJSON_Parse(source) : NULL;
    char *file = g_strdup(cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(object, "table")));
    cJSON_Delete(object);
    return file;
}

/* All files of a scene --------------------------------------------------------------------------------------------- */

static void collect_from_json(const cJSON *json, GHashTable *files)
{
    for (const cJSON *child = json->child; child != NULL; child = child->next) {
        if (g_strcmp0(child->string, "table") == 0 && cJSON_IsString(child))
            g_hash_table_add(files, g_strdup(child->valuestring));
        collect_from_json(child, files);
    }
}

static void collect_from_object(const char *text, GHashTable *files)
{
    cJSON *json = text != NULL ? cJSON_Parse(text) : NULL;
    if (json != NULL) collect_from_json(json, files);
    cJSON_Delete(json);
}

/* Of the waveforms that one property has in the blocks of a class. */
static void collect_from_column(const TinkerScene *scene, TinkerWaveform *const *waveforms, int32_t count,
                                GHashTable *files)
{
    const TinkerWaveform *last = NULL; /* neighbours often share one */
    for (int32_t row = 0; row < count; row++) {
        if (waveforms[row] != NULL && waveforms[row] != last)
            collect_from_object(g_hash_table_lookup(scene->sources, waveforms[row]), files);
        last = waveforms[row];
    }
}

static void collect_from_blocks(const TinkerScene *scene, GHashTable *files)
{
    for (guint number = 0; number < scene->tables->len; number++) {
        const SceneTable *table = g_ptr_array_index(scene->tables, number);
        for (int32_t property = 0; property < table->block_class->property_count; property++)
            if (table->waveforms[property] != NULL)
                collect_from_column(scene, table->waveforms[property], table->count, files);
    }
}

static void collect_from_unread(const TinkerScene *scene, GHashTable *files)
{
    GHashTableIter iter;
    gpointer id, kept;
    g_hash_table_iter_init(&iter, scene->placeholders);
    while (g_hash_table_iter_next(&iter, &id, &kept))
        if (scene_slot(scene, GPOINTER_TO_INT(id))->table == SCENE_PLACEHOLDER)
            collect_from_object(((const ScenePlaceholder *)kept)->text, files);
    g_hash_table_iter_init(&iter, scene->extras);
    while (g_hash_table_iter_next(&iter, &id, &kept)) {
        if (scene_slot(scene, GPOINTER_TO_INT(id))->table == SCENE_REMOVED) continue;
        g_autofree char *object = g_strdup_printf("{%s}", (const char *)kept);
        collect_from_object(object, files);
    }
}

GPtrArray *tinker_scene_table_files(const TinkerScene *scene)
{
    g_autoptr(GHashTable) files = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    collect_from_blocks(scene, files);
    collect_from_unread(scene, files);
    GPtrArray *list = g_ptr_array_new_with_free_func(g_free);
    GHashTableIter iter;
    gpointer file;
    g_hash_table_iter_init(&iter, files);
    while (g_hash_table_iter_next(&iter, &file, NULL))
        g_ptr_array_add(list, g_strdup(file));
    return list;
}
