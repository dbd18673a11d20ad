/* The position scanner: checks that a text is JSON (RFC 8259), and finds where its parts are.
 *
 * It reads the text once, without recursion, and keeps no tree: of a scene of half a million blocks it remembers where
 * the members of the top level and the entries of `blocks` begin and end. The parts are then parsed one by one.
 */
#ifndef TINKER_CORE_POSITION_SCANNER_H
#define TINKER_CORE_POSITION_SCANNER_H

#include <glib.h>

/* The deepest nesting of arrays and objects that is read. */
#define JSON_MOST_DEPTH 200

/* The longest number that is read, in characters; the shortest exact text of any double has 24. */
#define JSON_LONGEST_NUMBER 60

/* A member of an object or an entry of an array: offsets in bytes. */
typedef struct {
    gsize key;   /* of the key's opening quote; of an entry of an array the same as start */
    gsize start; /* of the value's first byte */
    gsize end;   /* behind its last */
} JsonPart;

typedef struct {
    GArray *members;    /* of JsonPart: the top level */
    GArray *blocks;     /* of JsonPart: the entries of the top level's "blocks", where that is an array */
    GArray *duplicates; /* of gsize: keys that their object had already, where they begin */
    gsize fault_at;     /* where the text stops being JSON */
    char *fault;        /* what is wrong there, or NULL */
} JsonScan;

/* Scans a text. FALSE where it is not JSON, with `fault` set; also for what this program cannot hold: U+0000 in a text,
 * half a surrogate pair, numbers and nesting beyond the limits above. Clear the scan in any case. */
gboolean json_scan(JsonScan *scan, const char *text, gsize length);
void json_scan_clear(JsonScan *scan);

/* What follows reads text that json_scan has accepted. */

/* The parts of the object or array that begins at `start`, empty for other values; of JsonPart. (transfer full) */
GArray *json_split(const char *text, gsize start);

/* Behind the closing quote of the text whose opening quote is here. */
gsize json_string_end(const char *text, gsize start);

/* Whether the part's key is this word, however it is escaped. */
gboolean json_key_is(const char *text, const JsonPart *part, const char *word);

/* Appends a value's text on one line, with a space behind each comma and colon and none elsewhere; tokens stay as they
 * are. */
void json_append_compact(GString *out, const char *text, gsize start, gsize end);

/* Appends a member, `"key": value`, with ", " in front if there is something in `out`. */
void json_append_member(GString *out, const char *text, const JsonPart *part);

/* Appends a text with quotes and escapes. */
void json_append_string(GString *out, const char *string);

#endif
