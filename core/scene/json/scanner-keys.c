/* Duplicate keys, which are looked for when their object closes: pair by pair in a small object, through a hash table
 * in a large one. */
#include "scene/json/position-scanner-private.h"

#include <string.h>

#include <cjson/cJSON.h>

#include "scene/json/text-hash.h"

/* Up to here comparing all pairs is quicker than a hash table. */
#define MOST_PAIRED_KEYS 16

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

void scanner_find_duplicates(Scanner *s, guint first)
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
