/* Findings: what is wrong with a scene, where it is, and the message for it. */
#include <glib/gi18n-lib.h>
#include <string.h>

#include "scene/value/reader.h"

/* Longer words are no slips of the finger, and comparing them takes long. */
#define LONGEST_COMPARED 40

static void finding_clear(ReaderFinding *finding)
{
    g_free(finding->message);
}

static void finding_free(TinkerFinding *finding)
{
    g_free(finding->message);
    g_free(finding);
}

GPtrArray *tinker_findings_new(void)
{
    return g_ptr_array_new_with_free_func((GDestroyNotify)finding_free);
}

/* Places ------------------------------------------------------------------------------------------------------- */

gsize reader_offset(SceneReader *reader, JsonAt at)
{
    gsize start = at.root;
    for (int d = 0; d < at.depth; d++) {
        if (reader->split[d].parts == NULL || reader->split[d].start != start) {
            g_clear_pointer(&reader->split[d].parts, g_array_unref);
            reader->split[d].parts = json_split(reader->text, start);
            reader->split[d].start = start;
        }
        const GArray *parts = reader->split[d].parts;
        if ((guint)at.steps[d] >= parts->len) break;
        const JsonPart *part = &g_array_index(parts, JsonPart, at.steps[d]);
        if (at.key && d == at.depth - 1) return part->key;
        start = part->start;
    }
    return start;
}

/* Reporting ---------------------------------------------------------------------------------------------------- */

void reader_label(SceneReader *reader, const char *label)
{
    reader->label = label;
    reader->label_type = NULL;
    reader->label_number = -1;
}

void reader_label_entry(SceneReader *reader, const char *list, int number, const char *type)
{
    reader->label = list;
    reader->label_type = type;
    reader->label_number = number;
}

G_GNUC_PRINTF(5, 0)
static void report(SceneReader *reader, TinkerFindingKind kind, gsize offset, int code, const char *format,
                   va_list arguments)
{
    if (reader->findings->len == 0) g_array_set_clear_func(reader->findings, (GDestroyNotify)finding_clear);
    GString *message = g_string_new(NULL);
    if (reader->label != NULL) g_string_append(message, reader->label);
    if (reader->label != NULL && reader->label_number >= 0)
        g_string_append_printf(message, "[%d]", reader->label_number);
    if (reader->label_type != NULL) g_string_append_printf(message, " (%s)", reader->label_type);
    if (reader->label != NULL) g_string_append(message, ": ");
    g_string_append_vprintf(message, format, arguments);
    ReaderFinding finding = {kind, code, offset, g_string_free(message, FALSE)};
    g_array_append_val(reader->findings, finding);
}

gboolean reader_error(SceneReader *reader, JsonAt at, int code, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report(reader, TINKER_FINDING_ERROR, reader_offset(reader, at), code, format, arguments);
    va_end(arguments);
    return FALSE;
}

void reader_warning(SceneReader *reader, JsonAt at, int code, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report(reader, TINKER_FINDING_WARNING, reader_offset(reader, at), code, format, arguments);
    va_end(arguments);
}

void reader_error_at(SceneReader *reader, gsize offset, int code, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    report(reader, TINKER_FINDING_ERROR, offset, code, format, arguments);
    va_end(arguments);
}

/* The first of the duplicates that does not lie before this place; they are sorted. */
static guint first_duplicate(const GArray *duplicates, gsize start)
{
    guint low = 0, high = duplicates->len;
    while (low < high) {
        guint middle = low + (high - low) / 2;
        if (g_array_index(duplicates, gsize, middle) < start)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void reader_report_duplicates(SceneReader *reader, gsize start, gsize end)
{
    const GArray *duplicates = reader->scan.duplicates;
    for (guint i = first_duplicate(duplicates, start); i < duplicates->len; i++) {
        gsize at = g_array_index(duplicates, gsize, i);
        if (at >= end) return;
        int length = (int)(json_string_end(reader->text, at) - at);
        reader_error_at(reader, at, TINKER_SCENE_ERROR_SYNTAX, _("the key %.*s is given twice"), length,
                        reader->text + at);
    }
}

char *reader_suggestion(const char *word, const char *const *candidates, const char *otherwise)
{
    const char *near = strlen(word) > LONGEST_COMPARED ? NULL : tinker_nearest_word(word, candidates);
    return near == NULL ? g_strdup(otherwise) : g_strdup_printf(_(" (did you mean \"%s\"?)"), near);
}

void reader_keep_unknown(SceneReader *reader, JsonAt at, const char *key, const char *const *candidates,
                         GString **extras)
{
    g_autofree char *known = g_strjoinv(", ", (char **)candidates);
    g_autofree char *kept = g_strdup_printf(_("; it is kept as it is (known here: %s)"), known);
    g_autofree char *suggestion = reader_suggestion(key, candidates, kept);
    reader_keep_member(reader, at, key, suggestion, extras);
}

void reader_keep_member(SceneReader *reader, JsonAt at, const char *key, const char *suggestion, GString **extras)
{
    reader_warning(reader, at_key(at), TINKER_SCENE_ERROR_SYNTAX, _("unknown key \"%s\"%s"), key, suggestion);
    if (*extras == NULL) *extras = g_string_new(NULL);
    const JsonPart *part = &g_array_index(reader->split[at.depth - 1].parts, JsonPart, (guint)at.steps[at.depth - 1]);
    json_append_member(*extras, reader->text, part);
}

/* Conclusion --------------------------------------------------------------------------------------------------- */

static int compare_findings(gconstpointer a, gconstpointer b)
{
    gsize first = ((const ReaderFinding *)a)->offset, second = ((const ReaderFinding *)b)->offset;
    return first < second ? -1 : first > second;
}

/* A place that moves through the text; columns count characters. */
typedef struct {
    gsize at;
    int line, column;
} Cursor;

static void cursor_move(Cursor *cursor, const char *text, gsize to)
{
    for (; cursor->at < to; cursor->at++) {
        guchar c = (guchar)text[cursor->at];
        if (c == '\n') {
            cursor->line++;
            cursor->column = 1;
        } else if ((c & 0xC0) != 0x80) {
            cursor->column++;
        }
    }
}

gboolean reader_conclude(SceneReader *reader, GPtrArray *findings, GError **error)
{
    gboolean good = TRUE;
    g_array_sort(reader->findings, compare_findings); /* stable */
    Cursor cursor = {0, 1, 1};
    for (guint i = 0; i < reader->findings->len; i++) {
        const ReaderFinding *found = &g_array_index(reader->findings, ReaderFinding, i);
        cursor_move(&cursor, reader->text, MIN(found->offset, reader->length));
        if (found->kind == TINKER_FINDING_ERROR && good) {
            good = FALSE;
            g_set_error(error, TINKER_SCENE_ERROR, found->code, "%s:%d:%d: %s", reader->path, cursor.line,
                        cursor.column, found->message);
        }
        if (findings == NULL) continue;
        TinkerFinding *copy = g_new(TinkerFinding, 1);
        *copy = (TinkerFinding){found->kind, found->code, cursor.line, cursor.column, g_strdup(found->message)};
        g_ptr_array_add(findings, copy);
    }
    return good;
}

GArray *tinker_scene_block_places(const char *text, gsize length)
{
    GArray *places = g_array_new(FALSE, FALSE, sizeof(TinkerTextPlace));
    JsonScan scan;
    Cursor cursor = {0, 1, 1};
    const gboolean is_json = json_scan(&scan, text, length);
    for (guint i = 0; is_json && i < scan.blocks->len; i++) {
        cursor_move(&cursor, text, g_array_index(scan.blocks, JsonPart, i).start);
        const TinkerTextPlace place = {cursor.line, cursor.column};
        g_array_append_val(places, place);
    }
    json_scan_clear(&scan);
    return places;
}

char *reader_suggest_block(SceneReader *reader, const char *name)
{
    TinkerScene *scene = reader->scene;
    if (reader->block_names == NULL) {
        reader->block_names = g_ptr_array_new();
        for (int32_t place = 0; place < tinker_scene_block_count(scene); place++)
            g_ptr_array_add(reader->block_names,
                            (gpointer)tinker_scene_block_name(scene, tinker_scene_block_at(scene, place)));
        g_ptr_array_add(reader->block_names, NULL);
    }
    if (reader->suggestions_left <= 0) return g_strdup("");
    reader->suggestions_left -= reader->block_names->len;
    return reader_suggestion(name, (const char *const *)reader->block_names->pdata, "");
}

cJSON *reader_parse(SceneReader *reader, const JsonPart *part)
{
    cJSON *json = cJSON_ParseWithLength(reader->text + part->start, part->end - part->start);
    if (json == NULL) reader_error_at(reader, part->start, TINKER_SCENE_ERROR_SYNTAX, _("this value cannot be parsed"));
    return json;
}
