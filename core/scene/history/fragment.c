/* Writing fragments, and keeping the waveforms that their texts do not hold. */
#include "scene/history/fragment-private.h"

#include "scene/json/text-hash.h"

/* Of how many fragments waveforms are kept: the clipboard holds one, a history of it a few more. */
#define MOST_KEPT 8

typedef struct {
    char *token;
    GHashTable *texts;
} Kept;

static struct {
    GMutex mutex;
    GQueue fragments; /* of Kept, the newest first */
} kept;

static void kept_waveform_free(gpointer data)
{
    SceneKeptWaveform *waveform = data;
    tinker_waveform_unref(waveform->waveform);
    g_free(waveform->source);
    g_free(waveform);
}

static void keep(const char *token, GHashTable *texts)
{
    Kept *fragment = g_new(Kept, 1);
    *fragment = (Kept){g_strdup(token), g_hash_table_ref(texts)};
    g_mutex_lock(&kept.mutex);
    g_queue_push_head(&kept.fragments, fragment);
    Kept *oldest = kept.fragments.length > MOST_KEPT ? g_queue_pop_tail(&kept.fragments) : NULL;
    g_mutex_unlock(&kept.mutex);
    if (oldest == NULL) return;
    g_hash_table_unref(oldest->texts);
    g_free(oldest->token);
    g_free(oldest);
}

GHashTable *fragment_kept(const char *token)
{
    GHashTable *texts = NULL;
    g_mutex_lock(&kept.mutex);
    for (GList *link = kept.fragments.head; link != NULL && texts == NULL; link = link->next) {
        const Kept *fragment = link->data;
        if (g_str_equal(fragment->token, token)) texts = g_hash_table_ref(fragment->texts);
    }
    g_mutex_unlock(&kept.mutex);
    return texts;
}

char *tinker_fragment_to_text(TinkerScene *scene, const TinkerBlockId *blocks, int32_t count)
{
    g_autofree guint8 *only = g_new0(guint8, (gsize)tinker_scene_id_limit(scene) + 1);
    for (int32_t i = 0; i < count; i++) {
        g_assert(tinker_scene_has_block(scene, blocks[i]));
        only[blocks[i]] = 1;
    }
    g_autoptr(GHashTable) texts = g_hash_table_new_full(tinker_text_hash, g_str_equal, g_free, kept_waveform_free);
    SceneWriter writer = {.scene = scene,
                          .units = TINKER_WRITE_SI,
                          .out = g_string_new("{\n  \"tinker\": 1"),
                          .only = only,
                          .texts = texts};
    scene_write_blocks(&writer);
    scene_write_graphs(&writer);
    if (g_hash_table_size(texts) > 0) {
        g_autofree char *token = g_uuid_string_random();
        keep(token, texts);
        g_string_append_printf(writer.out, ",\n  \"" FRAGMENT_KEY "\": \"%s\"", token);
    }
    g_string_append(writer.out, "\n}\n");
    g_free(writer.named);
    return g_string_free(writer.out, FALSE);
}
