/* The position scanner: a loop over the tokens with a stack of open arrays and objects. Keys are looked at for
 * duplicates when their object closes, pair by pair in a small object, through a hash table in a large one. */
#include "scene/json/position-scanner.h"

#include <glib/gi18n-lib.h>
#include <string.h>

#include <cjson/cJSON.h>

#include "scene/json/text-hash.h"

/* Up to here comparing all pairs is quicker than a hash table. */
#define MOST_PAIRED_KEYS 16

typedef struct {
    gboolean object;
    guint first_key; /* in Scanner.keys */
    JsonPart part;   /* of this container in the one around it */
} Frame;

typedef struct {
    gsize start, length; /* without the quotes */
    gboolean escaped;
} Key;

typedef struct {
    JsonScan *scan;
    const char *text;
    gsize length, at;
    GArray *keys;       /* of Key: those of all open objects */
    gboolean in_blocks; /* the member of the top level that is being read is "blocks" */
    gsize key_at;       /* of the member that is being read */
    int depth;
    Frame frames[JSON_MOST_DEPTH];
} Scanner;

/* Tokens ------------------------------------------------------------------------------------------------------- */

static gboolean G_GNUC_PRINTF(3, 4) fail(Scanner *s, gsize at, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    s->scan->fault = g_strdup_vprintf(format, arguments);
    va_end(arguments);
    s->scan->fault_at = at;
    return FALSE;
}

static inline int peek(const Scanner *s)
{
    return s->at < s->length ? (guchar)s->text[s->at] : -1;
}

static inline void skip_space(Scanner *s)
{
    while (s->at < s->length) {
        char c = s->text[s->at];
        if (c != ' ' && c != '\n' && c != '\r' && c != '\t') return;
        s->at++;
    }
}

/* The length of the word that is there, cut where it is long. */
static gsize word_length(const Scanner *s)
{
    const char *from = s->text + s->at;
    gsize room = MIN(s->length - s->at, 20), word = 0;
    while (word < room && (g_ascii_isalnum(from[word]) || from[word] == '_' || from[word] == '-'))
        word++;
    return word;
}

/* "expected X, Y found" with the word or character that is there. */
static gboolean fail_expected(Scanner *s, const char *expected)
{
    if (s->at == 0 && s->length >= 3 && memcmp(s->text, "\xEF\xBB\xBF", 3) == 0)
        return fail(s, 0, _("the text begins with a byte-order mark (save it as UTF-8 without one)"));
    if (s->at >= s->length) return fail(s, s->at, _("not JSON: %s was expected, but the text ends here"), expected);
    const char *from = s->text + s->at;
    gsize before = s->at;
    while ((*from == ']' || *from == '}') && before > 0 && strchr(" \n\r\t", s->text[before - 1]) != NULL)
        before--;
    if ((*from == ']' || *from == '}') && before > 0 && s->text[before - 1] == ',')
        return fail(s, before - 1, _("not JSON: a comma stands before '%c' (take it out)"), *from);
    gsize word = word_length(s);
    if (word > 0) return fail(s, s->at, _("not JSON: %s was expected, \"%.*s\" found"), expected, (int)word, from);
    gunichar c = g_utf8_get_char_validated(from, (gssize)(s->length - s->at));
    if (c == (gunichar)-1 || c == (gunichar)-2)
        return fail(s, s->at, _("not UTF-8: byte 0x%02X cannot stand here"), (guchar)*from);
    if (!g_unichar_isprint(c)) return fail(s, s->at, _("not JSON: %s was expected, U+%04X found"), expected, c);
    return fail(s, s->at, _("not JSON: %s was expected, '%.*s' found"), expected, (int)(g_utf8_next_char(from) - from),
                from);
}

/* How many characters of a number stand before a place. */
static gsize number_before(const Scanner *s, gsize at)
{
    gsize count = 0;
    while (count < at && (g_ascii_isdigit(s->text[at - count - 1]) || strchr("+-.eE", s->text[at - count - 1]) != NULL))
        count++;
    return count;
}

/* A number with a decimal comma, "1,5", where a key is expected behind the comma; 0: it is none. */
static gsize decimal_comma(const Scanner *s)
{
    if (s->at < 2 || !g_ascii_isdigit(s->text[s->at]) || s->text[s->at - 1] != ',') return 0;
    return number_before(s, s->at - 1);
}

static gboolean fail_key(Scanner *s)
{
    const char *expected = _("a key in double quotes");
    const gsize word = word_length(s), whole = word > 0 ? decimal_comma(s) : 0;
    if (whole > 0)
        return fail(s, s->at - 1,
                    _("not JSON: decimals are written with a point, not a comma (\"%.*s,%.*s\" is no number)"),
                    (int)whole, s->text + s->at - 1 - whole, (int)word, s->text + s->at);
    if (word == 0) return fail_expected(s, expected);
    return fail(s, s->at, _("not JSON: %s was expected, found %.*s without quotes"), expected, (int)word,
                s->text + s->at);
}

/* The four digits behind \u, or -1. */
static int hex4(const Scanner *s, gsize at)
{
    int value = 0;
    for (int i = 0; i < 4; i++) {
        int digit = at + i < s->length ? g_ascii_xdigit_value(s->text[at + i]) : -1;
        if (digit < 0) return -1;
        value = value * 16 + digit;
    }
    return value;
}

/* Stands on a backslash; passes over the escape. */
static gboolean scan_escape(Scanner *s)
{
    gsize start = s->at++;
    int c = peek(s);
    s->at++;
    if (c != -1 && c != 0 && strchr("\"\\/bfnrt", c) != NULL) return TRUE;
    if (c != 'u')
        return fail(s, start,
                    _("not JSON: a backslash is followed by one of \" \\ / b f n r t u (write \\\\ for a backslash)"));
    int unit = hex4(s, s->at);
    if (unit < 0) return fail(s, start, _("not JSON: \\u is followed by four hexadecimal digits"));
    if (unit == 0) return fail(s, start, _("the character U+0000 cannot stand in a text of a scene"));
    s->at += 4;
    if (unit < 0xD800 || unit > 0xDFFF) return TRUE;
    gboolean pair = unit < 0xDC00 && s->at + 1 < s->length && s->text[s->at] == '\\' && s->text[s->at + 1] == 'u';
    int second = pair ? hex4(s, s->at + 2) : -1;
    if (second < 0xDC00 || second > 0xDFFF)
        return fail(s, start, _("\\u%04X is half of a surrogate pair"), (guint)unit);
    s->at += 6;
    return TRUE;
}

/* Stands on the opening quote; passes over the text. */
static gboolean scan_string(Scanner *s, gboolean *escaped)
{
    gsize start = s->at++;
    *escaped = FALSE;
    for (;;) {
        int c = peek(s);
        if (c == -1) return fail(s, start, _("not JSON: a text that begins here has no closing quote"));
        if (c == '"') break;
        if (c == '\\') {
            *escaped = TRUE;
            if (!scan_escape(s)) return FALSE;
        } else if (c < 0x20) {
            return fail(s, s->at, _("not JSON: a control character (U+%04X) in a text must be written as \\u%04X"), c,
                        c);
        } else if (c < 0x80) {
            s->at++;
        } else {
            const char *from = s->text + s->at;
            gunichar wide = g_utf8_get_char_validated(from, (gssize)(s->length - s->at));
            if (wide == (gunichar)-1 || wide == (gunichar)-2)
                return fail(s, s->at, _("not UTF-8: byte 0x%02X cannot stand here"), (guint)c);
            s->at += (gsize)(g_utf8_next_char(from) - from);
        }
    }
    s->at++;
    return TRUE;
}

static gboolean scan_digits(Scanner *s)
{
    gsize start = s->at;
    while (s->at < s->length && g_ascii_isdigit(s->text[s->at]))
        s->at++;
    return s->at > start || fail_expected(s, _("a digit"));
}

static gboolean scan_number(Scanner *s)
{
    gsize start = s->at;
    if (peek(s) == '-') s->at++;
    if (peek(s) == '0')
        s->at++;
    else if (!scan_digits(s))
        return FALSE;
    if (g_ascii_isdigit(peek(s) == -1 ? ' ' : peek(s)))
        return fail(s, start, _("not JSON: a number must not begin with a zero that means nothing"));
    if (peek(s) == '.') {
        s->at++;
        if (!scan_digits(s)) return FALSE;
    }
    if (peek(s) == 'e' || peek(s) == 'E') {
        s->at++;
        if (peek(s) == '+' || peek(s) == '-') s->at++;
        if (!scan_digits(s)) return FALSE;
    }
    if (s->at - start > JSON_LONGEST_NUMBER)
        return fail(s, start, _("a number of more than %d characters (17 digits say all that is kept)"),
                    JSON_LONGEST_NUMBER);
    return TRUE;
}

static gboolean scan_word(Scanner *s, const char *word)
{
    gsize length = strlen(word);
    if (s->length - s->at >= length && memcmp(s->text + s->at, word, length) == 0) {
        gboolean longer = s->at + length < s->length && g_ascii_isalnum(s->text[s->at + length]);
        if (!longer) {
            s->at += length;
            return TRUE;
        }
    }
    return fail_expected(s, _("a value"));
}

/* Duplicate keys ----------------------------------------------------------------------------------------------- */

static void report_duplicate(Scanner *s, const Key *key)
{
    gsize at = key->start - 1;
    g_array_append_val(s->scan->duplicates, at);
}

static char *decode_key(const Scanner *s, const Key *key)
{
    if (!key->escaped) return g_strndup(s->text + key->start, key->length);
    cJSON *json = cJSON_ParseWithLength(s->text + key->start - 1, key->length + 2);
    char *decoded = g_strdup(json == NULL ? "" : json->valuestring);
    cJSON_Delete(json);
    return decoded;
}

static void find_duplicates_hashed(Scanner *s, guint first)
{
    g_autoptr(GHashTable) seen = g_hash_table_new_full(tinker_text_hash, g_str_equal, g_free, NULL);
    for (guint i = first; i < s->keys->len; i++) {
        const Key *key = &g_array_index(s->keys, Key, i);
        if (!g_hash_table_add(seen, decode_key(s, key))) report_duplicate(s, key);
    }
}

static void find_duplicates(Scanner *s, guint first)
{
    guint count = s->keys->len - first;
    if (count < 2) return;
    const Key *keys = &g_array_index(s->keys, Key, first);
    gboolean escaped = FALSE;
    for (guint i = 0; i < count && count <= MOST_PAIRED_KEYS; i++)
        escaped = escaped || keys[i].escaped;
    if (escaped || count > MOST_PAIRED_KEYS) {
        find_duplicates_hashed(s, first);
        return;
    }
    for (guint i = 1; i < count; i++) {
        for (guint j = 0; j < i; j++) {
            if (keys[i].length != keys[j].length ||
                memcmp(s->text + keys[i].start, s->text + keys[j].start, keys[i].length) != 0)
                continue;
            report_duplicate(s, &keys[i]);
            break;
        }
    }
}

/* Structure ---------------------------------------------------------------------------------------------------- */

/* Stands where a key should be; passes over it and its colon. */
static gboolean scan_key(Scanner *s)
{
    skip_space(s);
    if (peek(s) != '"') return fail_key(s);
    Key key = {.start = s->at + 1};
    s->key_at = s->at;
    if (!scan_string(s, &key.escaped)) return FALSE;
    key.length = s->at - 1 - key.start;
    g_array_append_val(s->keys, key);
    if (s->depth == 1) s->in_blocks = json_key_is(s->text, &(JsonPart){.key = s->key_at}, "blocks");
    skip_space(s);
    if (peek(s) != ':') return fail_expected(s, _("':' behind a key"));
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
        return fail(s, s->at, _("arrays and objects are nested more than %d deep"), JSON_MOST_DEPTH);
    s->frames[s->depth++] = (Frame){object, s->keys->len, part};
    s->at++;
    return TRUE;
}

static void close_container(Scanner *s)
{
    Frame *frame = &s->frames[s->depth - 1];
    if (frame->object) find_duplicates(s, frame->first_key);
    g_array_set_size(s->keys, frame->first_key);
    s->depth--;
    s->at++;
    value_ended(s, frame->part);
}

/* Passes over a simple value, or opens a container: then `opened` is set. */
static gboolean scan_value(Scanner *s, gboolean *opened)
{
    skip_space(s);
    gboolean in_object = s->depth > 0 && s->frames[s->depth - 1].object;
    JsonPart part = {.key = in_object ? s->key_at : s->at, .start = s->at};
    gboolean escaped, good;
    int c = peek(s);
    *opened = c == '{' || c == '[';
    if (*opened) return open_container(s, c == '{', part);
    if (c == '"')
        good = scan_string(s, &escaped);
    else if (c == '-' || (c >= '0' && c <= '9'))
        good = scan_number(s);
    else
        good = scan_word(s, c == 't' ? "true" : c == 'f' ? "false" : "null");
    if (good) value_ended(s, part);
    return good;
}

/* Stands behind a value: closes what closes here. Answers whether another value follows. */
static gboolean scan_behind_value(Scanner *s, gboolean *more)
{
    *more = FALSE;
    while (s->depth > 0) {
        gboolean object = s->frames[s->depth - 1].object;
        skip_space(s);
        int c = peek(s);
        if (c == (object ? '}' : ']')) {
            close_container(s);
            continue;
        }
        if (c != ',') return fail_expected(s, object ? _("',' or '}'") : _("',' or ']'"));
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
            skip_space(s);
            if (peek(s) != (object ? '}' : ']')) {
                if (object && !scan_key(s)) return FALSE;
                continue;
            }
        }
        if (!scan_behind_value(s, &more)) return FALSE;
    }
    skip_space(s);
    return s->at == s->length || fail_expected(s, _("the end of the text"));
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
