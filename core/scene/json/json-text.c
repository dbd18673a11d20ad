/* Pieces of JSON text that the scanner has accepted: splitting them, and copying them on one line. No check is made
 * here that the scanner made already. */
#include <string.h>

#include <cjson/cJSON.h>

#include "scene/json/position-scanner.h"

static gsize skip_space(const char *text, gsize at)
{
    while (text[at] == ' ' || text[at] == '\n' || text[at] == '\r' || text[at] == '\t')
        at++;
    return at;
}

gsize json_string_end(const char *text, gsize start)
{
    gsize at = start + 1;
    for (; text[at] != '"'; at++)
        if (text[at] == '\\') at++;
    return at + 1;
}

static gsize skip_value(const char *text, gsize at)
{
    int depth = 0;
    do {
        at = skip_space(text, at);
        char c = text[at];
        if (c == '"') {
            at = json_string_end(text, at);
        } else if (c == '{' || c == '[') {
            depth++;
            at++;
        } else if (c == '}' || c == ']') {
            depth--;
            at++;
        } else if (c == ',' || c == ':') {
            at++;
        } else {
            while (g_ascii_isalnum(text[at]) || text[at] == '-' || text[at] == '+' || text[at] == '.')
                at++;
        }
    } while (depth > 0);
    return at;
}

GArray *json_split(const char *text, gsize start)
{
    GArray *parts = g_array_new(FALSE, FALSE, sizeof(JsonPart));
    char open = text[start];
    if (open != '{' && open != '[') return parts;
    gsize at = skip_space(text, start + 1);
    while (text[at] != '}' && text[at] != ']') {
        JsonPart part = {.key = at};
        if (open == '{') at = skip_space(text, skip_space(text, json_string_end(text, at)) + 1);
        part.start = at;
        part.end = at = skip_value(text, at);
        g_array_append_val(parts, part);
        at = skip_space(text, at);
        if (text[at] == ',') at = skip_space(text, at + 1);
    }
    return parts;
}

gboolean json_key_is(const char *text, const JsonPart *part, const char *word)
{
    const char *key = text + part->key;
    gsize key_length = json_string_end(text, part->key) - part->key, length = strlen(word);
    if (memchr(key, '\\', key_length) == NULL) return key_length == length + 2 && memcmp(key + 1, word, length) == 0;
    cJSON *decoded = cJSON_ParseWithLength(key, key_length);
    gboolean same = g_strcmp0(cJSON_GetStringValue(decoded), word) == 0;
    cJSON_Delete(decoded);
    return same;
}

void json_append_compact(GString *out, const char *text, gsize start, gsize end)
{
    for (gsize at = skip_space(text, start); at < end;) {
        gsize from = at;
        if (text[at] == '"')
            at = json_string_end(text, at);
        else
            at++;
        g_string_append_len(out, text + from, (gssize)(at - from));
        if (text[from] == ',' || text[from] == ':') g_string_append_c(out, ' ');
        while (at < end && strchr(" \n\r\t", text[at]) != NULL)
            at++;
    }
}

void json_append_member(GString *out, const char *text, const JsonPart *part)
{
    if (out->len > 0) g_string_append(out, ", ");
    gsize key_end = json_string_end(text, part->key);
    g_string_append_len(out, text + part->key, (gssize)(key_end - part->key));
    g_string_append(out, ": ");
    json_append_compact(out, text, part->start, part->end);
}

void json_append_string(GString *out, const char *string)
{
    g_string_append_c(out, '"');
    for (const char *c = string; *c != '\0'; c++) {
        switch (*c) {
        case '"':
            g_string_append(out, "\\\"");
            break;
        case '\\':
            g_string_append(out, "\\\\");
            break;
        case '\n':
            g_string_append(out, "\\n");
            break;
        case '\r':
            g_string_append(out, "\\r");
            break;
        case '\t':
            g_string_append(out, "\\t");
            break;
        default:
            if ((guchar)*c < 0x20)
                g_string_append_printf(out, "\\u%04x", (guint)*c);
            else
                g_string_append_c(out, *c);
        }
    }
    g_string_append_c(out, '"');
}
