/* The position scanner: a loop over the tokens with a stack of open arrays and objects. */
#include "scene/json/position-scanner-private.h"

#include <glib/gi18n-lib.h>

/* Stands where a key should be; passes over it and its colon. */
static gboolean scan_key(Scanner *s)
{
    scanner_skip_space(s);
    if (scanner_peek(s) != '"') return scanner_fail_key(s);
    Key key = {.start = s->at + 1};
    s->key_at = s->at;
    if (!scanner_string(s, &key.escaped)) return FALSE;
    key.length = s->at - 1 - key.start;
    g_array_append_val(s->keys, key);
    if (s->depth == 1) s->in_blocks = json_key_is(s->text, &(JsonPart){.key = s->key_at}, "blocks");
    scanner_skip_space(s);
    if (scanner_peek(s) != ':') return scanner_fail_expected(s, _("':' behind a key"));
    s->at++;
    return TRUE;
}

static void value_ended(Scanner *s, JsonPart part)
{
    part.end = s->at;
    if (s->depth == 1 && s->frames[0].object) g_array_append_val(s->scan->members, part);
    if (s->depth == 2 && s->in_blocks && s->frames[0].object && !s->frames[1].object)
        g_array_append_val(s->scan->blocks, part);
}

static gboolean open_container(Scanner *s, gboolean object, JsonPart part)
{
    if (s->depth == JSON_MOST_DEPTH)
        return scanner_fail(s, s->at, _("arrays and objects are nested more than %d deep"), JSON_MOST_DEPTH);
    s->frames[s->depth++] = (Frame){object, s->keys->len, part};
    s->at++;
    return TRUE;
}

static void close_container(Scanner *s)
{
    Frame *frame = &s->frames[s->depth - 1];
    if (frame->object) scanner_find_duplicates(s, frame->first_key);
    g_array_set_size(s->keys, frame->first_key);
    s->depth--;
    s->at++;
    value_ended(s, frame->part);
}

/* Passes over a simple value, or opens a container: then `opened` is set. */
static gboolean scan_value(Scanner *s, gboolean *opened)
{
    scanner_skip_space(s);
    gboolean in_object = s->depth > 0 && s->frames[s->depth - 1].object;
    JsonPart part = {.key = in_object ? s->key_at : s->at, .start = s->at};
    gboolean escaped, good;
    int c = scanner_peek(s);
    *opened = c == '{' || c == '[';
    if (*opened) return open_container(s, c == '{', part);
    if (c == '"')
        good = scanner_string(s, &escaped);
    else if (c == '-' || (c >= '0' && c <= '9'))
        good = scanner_number(s);
    else
        good = scanner_word(s, c == 't' ? "true" : c == 'f' ? "false" : "null");
    if (good) value_ended(s, part);
    return good;
}

/* Stands behind a value: closes what closes here. Answers whether another value follows. */
static gboolean scan_behind_value(Scanner *s, gboolean *more)
{
    *more = FALSE;
    while (s->depth > 0) {
        gboolean object = s->frames[s->depth - 1].object;
        scanner_skip_space(s);
        int c = scanner_peek(s);
        if (c == (object ? '}' : ']')) {
            close_container(s);
            continue;
        }
        if (c != ',') return scanner_fail_expected(s, object ? _("',' or '}'") : _("',' or ']'"));
        s->at++;
        *more = TRUE;
        return !object || scan_key(s);
    }
    return TRUE;
}

static gboolean scan_document(Scanner *s)
{
    gboolean more = TRUE;
    while (more) {
        gboolean opened;
        if (!scan_value(s, &opened)) return FALSE;
        if (opened) {
            gboolean object = s->frames[s->depth - 1].object;
            scanner_skip_space(s);
            if (scanner_peek(s) != (object ? '}' : ']')) {
                if (object && !scan_key(s)) return FALSE;
                continue;
            }
        }
        if (!scan_behind_value(s, &more)) return FALSE;
    }
    scanner_skip_space(s);
    return s->at == s->length || scanner_fail_expected(s, _("the end of the text"));
}

static int compare_offsets(gconstpointer a, gconstpointer b)
{
    gsize first = *(const gsize *)a, second = *(const gsize *)b;
    return first < second ? -1 : first > second;
}

gboolean json_scan(JsonScan *scan, const char *text, gsize length)
{
    *scan = (JsonScan){
        .members = g_array_new(FALSE, FALSE, sizeof(JsonPart)),
        .blocks = g_array_new(FALSE, FALSE, sizeof(JsonPart)),
        .duplicates = g_array_new(FALSE, FALSE, sizeof(gsize)),
    };
    Scanner *scanner = g_new0(Scanner, 1);
    scanner->scan = scan;
    scanner->text = text;
    scanner->length = length;
    scanner->keys = g_array_new(FALSE, FALSE, sizeof(Key));
    gboolean good = scan_document(scanner);
    g_array_sort(scan->duplicates, compare_offsets); /* inner objects close first */
    g_array_unref(scanner->keys);
    g_free(scanner);
    return good;
}

void json_scan_clear(JsonScan *scan)
{
    g_array_unref(scan->members);
    g_array_unref(scan->blocks);
    g_array_unref(scan->duplicates);
    g_free(scan->fault);
}
