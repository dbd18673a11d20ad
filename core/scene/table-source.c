/* The object that stands for a table in a scene's file is kept as text beside its waveform; here it is made and asked. */
#include "scene/table-source.h"

#include "scene/reader-private.h"

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
                    "the name of the file is not UTF-8, and a scene can hold no other text");
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
