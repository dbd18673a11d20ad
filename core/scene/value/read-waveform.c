/* Reading waveforms: a word, an expression, or a table in a file beside the scene. */
#include <errno.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/value/reader.h"
#include "scene/value/table-source.h"

/* The keys of a waveform object. */
typedef struct {
    const cJSON *expression, *table;
    JsonAt expression_at, table_at;
    double column, scale;
    int kind;
    gboolean unknown_keys;
} WaveformObject;

static TinkerWaveform *read_word(SceneReader *reader, const cJSON *json, JsonAt at, const char *what)
{
    static const char *const words[] = {"none", "sine", "cosine", NULL};
    static const TinkerWaveformKind kinds[] = {TINKER_WAVEFORM_NONE, TINKER_WAVEFORM_SINE, TINKER_WAVEFORM_COSINE};
    for (int i = 0; words[i] != NULL; i++)
        if (g_str_equal(words[i], json->valuestring)) return tinker_waveform_new_harmonic(kinds[i]);
    g_autofree char *suggestion = reader_suggestion(
        json->valuestring, words,
        _(" (it is \"none\", \"sine\", \"cosine\", or {\"expression\": \"...\"} for a function of t)"));
    reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, _("%s: \"%s\" is not a waveform%s"), what, json->valuestring,
                 suggestion);
    return NULL;
}

static gboolean is_inside(const char *path, const char *folder)
{
    gsize length = strlen(folder);
    if (g_str_equal(folder, "/")) return TRUE;
    return strncmp(path, folder, length) == 0 && path[length] == '/';
}

char *reader_table_path(const char *folder, const char *file, GError **error)
{
    g_autofree char *base = g_canonicalize_filename(folder, NULL);
    g_autofree char *named = g_canonicalize_filename(file, base);
    if (g_path_is_absolute(file) || !is_inside(named, base)) {
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE,
                    _("\"%s\" lies outside the scene's folder; a table must be a file in it"), file);
        return NULL;
    }
    char *real_base = realpath(base, NULL), *real = real_base != NULL ? realpath(named, NULL) : NULL;
    const int reason = errno;
    char *path = NULL;
    if (real_base == NULL || real == NULL)
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, _("\"%s\" cannot be read: %s"), file,
                    g_strerror(reason));
    else if (!is_inside(real, real_base))
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE,
                    _("\"%s\" is a link that leads outside the scene's folder; a table must be a file in it"), file);
    else if (!g_file_test(real, G_FILE_TEST_IS_REGULAR))
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_FILE, _("\"%s\" is not a file"), file);
    else
        path = g_strdup(real);
    free(real_base);
    free(real);
    return path;
}

/* One key of the object that is not of the two main ones. */
static gboolean read_option(SceneReader *reader, const cJSON *member, JsonAt at, WaveformObject *object)
{
    static const char *const keys[] = {"expression", "table", "column", "scale", "kind", NULL};
    static const char *const kinds[] = {"value", "acceleration", NULL};
    if (g_str_equal(member->string, "column")) {
        if (!reader_number(reader, member, at, "waveform: column", reader_pure, &object->column)) return FALSE;
        if (object->column >= 1 && object->column <= TINKER_TABLE_MOST_COLUMN &&
            object->column == floor(object->column))
            return TRUE;
        return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE,
                            _("waveform: column must be a whole number from 1 (column 0 is the time)"));
    }
    if (g_str_equal(member->string, "scale"))
        return reader_number(reader, member, at, "waveform: scale", reader_pure, &object->scale);
    if (g_str_equal(member->string, "kind")) {
        object->kind = reader_choice(reader, member, at, "waveform: kind", kinds);
        return object->kind >= 0;
    }
    g_autofree char *suggestion = reader_suggestion(member->string, keys, _("; it is kept as it is"));
    reader_warning(reader, at_key(at), TINKER_SCENE_ERROR_SYNTAX, _("waveform: unknown key \"%s\"%s"), member->string,
                   suggestion);
    object->unknown_keys = TRUE;
    return TRUE;
}

static gboolean read_members(SceneReader *reader, const cJSON *json, JsonAt at, WaveformObject *object)
{
    gboolean good = TRUE;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++) {
        if (g_str_equal(member->string, "expression")) {
            object->expression = member;
            object->expression_at = at_child(at, step);
        } else if (g_str_equal(member->string, "table")) {
            object->table = member;
            object->table_at = at_child(at, step);
        } else {
            good = read_option(reader, member, at_child(at, step), object) && good;
        }
    }
    if ((object->expression == NULL) == (object->table == NULL))
        return reader_error(reader, at, TINKER_SCENE_ERROR_VALUE,
                            _("waveform: an object has either \"expression\" or \"table\""));
    return good;
}

static TinkerWaveform *read_expression(SceneReader *reader, const WaveformObject *object, const char *what)
{
    const char *text = reader_text(reader, object->expression, object->expression_at, "waveform: expression");
    if (text == NULL) return NULL;
    g_autoptr(GError) error = NULL;
    TinkerWaveform *waveform = tinker_waveform_new_expression(text, &error);
    if (waveform == NULL)
        reader_error(reader, object->expression_at, TINKER_SCENE_ERROR_VALUE, _("%s: expression: %s"), what,
                     error->message);
    return waveform;
}

/* A file or memory that cannot be had is no mistake in the scene. */
static TinkerSceneError code_of(const GError *error)
{
    if (error->domain == TINKER_SCENE_ERROR) return (TinkerSceneError)error->code;
    return error->code == TINKER_WAVEFORM_ERROR_FILE ? TINKER_SCENE_ERROR_FILE : TINKER_SCENE_ERROR_VALUE;
}

TinkerWaveform *reader_table(const char *path, const TinkerTableSource *source, const TinkerPropertyType *property,
                             GError **error)
{
    g_autoptr(TinkerWaveform) waveform =
        tinker_waveform_new_table_file(path, source->column, source->scale, source->kind, error);
    if (waveform == NULL) return NULL;
    // What drives a place is read as a smooth curve.
    const gboolean smooth = tinker_dimension_equal(property->dimension, reader_length);
    if (!smooth || tinker_waveform_prepare_smooth(waveform, error)) return g_steal_pointer(&waveform);
    g_prefix_error(error, "%s: ", path);
    return NULL;
}

static TinkerWaveform *read_table(SceneReader *reader, const WaveformObject *object, const TinkerPropertyType *property)
{
    const char *file = reader_text(reader, object->table, object->table_at, "waveform: table");
    if (file == NULL) return NULL;
    g_autoptr(GError) error = NULL;
    g_autofree char *path = reader_table_path(reader->folder, file, &error);
    const TinkerTableSource source = {file, (int)object->column, object->scale, (TinkerTableKind)object->kind};
    TinkerWaveform *waveform = path == NULL ? NULL : reader_table(path, &source, property, &error);
    if (waveform == NULL)
        reader_error(reader, object->table_at, code_of(error), _("%s: table: %s"), property->id, error->message);
    return waveform;
}

/* An acceleration is integrated to a displacement, so it can only stand where one is wanted. */
gboolean reader_table_fits(TinkerTableKind kind, const TinkerPropertyType *property, GError **error)
{
    if (kind != TINKER_TABLE_ACCELERATION || tinker_dimension_equal(property->dimension, reader_length)) return TRUE;
    g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE,
                "a table of accelerations can only move a place, this waveform is a %s",
                tinker_dimension_name(property->dimension));
    return FALSE;
}

static gboolean kind_fits(SceneReader *reader, const WaveformObject *object, const TinkerPropertyType *property)
{
    g_autoptr(GError) error = NULL;
    if (object->table == NULL || reader_table_fits((TinkerTableKind)object->kind, property, &error)) return TRUE;
    return reader_error(reader, object->table_at, TINKER_SCENE_ERROR_VALUE, "%s: %s", property->id, error->message);
}

/* The text of the object, on one line. */
static char *object_text(SceneReader *reader, JsonAt at)
{
    gsize start = reader_offset(reader, at);
    g_autoptr(GArray) parts = json_split(reader->text, start);
    gsize end = start;
    if (parts->len > 0) end = g_array_index(parts, JsonPart, parts->len - 1).end;
    while (reader->text[end] != '}')
        end++;
    GString *text = g_string_new(NULL);
    json_append_compact(text, reader->text, start, end + 1);
    return g_string_free(text, FALSE);
}

TinkerWaveform *reader_waveform(SceneReader *reader, const cJSON *json, JsonAt at, const TinkerPropertyType *property)
{
    if (cJSON_IsString(json)) return read_word(reader, json, at, property->id);
    if (!cJSON_IsObject(json)) {
        reader_wrong_kind(reader, json, at, property->id, _("a waveform (a text or an object)"));
        return NULL;
    }
    WaveformObject object = {.column = 1, .scale = 1, .kind = TINKER_TABLE_VALUE};
    if (!read_members(reader, json, at, &object) || !kind_fits(reader, &object, property)) return NULL;

    /* Equal objects mean one waveform: its text or file is read once. */
    char *text = object_text(reader, at);
    TinkerWaveform *waveform = g_hash_table_lookup(reader->waveforms, text);
    if (waveform == NULL && reader->known_waveforms != NULL)
        waveform = g_hash_table_lookup(reader->known_waveforms, text);
    if (waveform != NULL) {
        g_free(text);
        return tinker_waveform_ref(waveform);
    }
    waveform = object.expression != NULL ? read_expression(reader, &object, property->id)
                                         : read_table(reader, &object, property);
    if (waveform == NULL) {
        g_free(text);
        return NULL;
    }
    if (object.table != NULL || object.unknown_keys)
        g_hash_table_insert(reader->scene->sources, tinker_waveform_ref(waveform), g_strdup(text));
    g_hash_table_insert(reader->waveforms, text, tinker_waveform_ref(waveform));
    return waveform;
}
