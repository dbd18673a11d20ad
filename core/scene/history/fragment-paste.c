/* Pasting fragments: the text is read as a scene of its own, which finds every mistake and takes the displacement; only
 * what is good then goes over into the scene. */
#include <math.h>
#include <string.h>

#include "scene/history/fragment-private.h"
#include "scene/history/history-private.h"
#include "scene/json/text-hash.h"
#include "scene/value/reader.h"

typedef struct {
    TinkerScene *from; /* the fragment */
    TinkerScene *to;
    GHashTable *kept;   /* the fragment's waveforms by text, see fragment_kept; or NULL */
    TinkerBlockId *ids; /* by id in the fragment: the id in the scene */
} Paste;

/* Reading ------------------------------------------------------------------------------------------------------ */

/* What the fragment's waveforms are kept as; NULL where its text says nothing. (transfer full) */
static char *find_token(const char *text, gsize length)
{
    JsonScan scan;
    char *token = NULL;
    if (json_scan(&scan, text, length)) {
        for (guint i = 0; i < scan.members->len; i++) {
            const JsonPart *part = &g_array_index(scan.members, JsonPart, i);
            if (!json_key_is(text, part, FRAGMENT_KEY) || text[part->start] != '"') continue;
            g_free(token);
            token = g_strndup(text + part->start + 1, part->end - part->start - 2);
        }
    }
    json_scan_clear(&scan);
    return token;
}

/* The waveforms that need not be read, by their texts: the scene's own, and above them what was kept. Borrowed values.
 * (transfer full) */
static GHashTable *known_waveforms(const Paste *paste)
{
    GHashTable *known = g_hash_table_new(tinker_text_hash, g_str_equal);
    GHashTableIter iter;
    gpointer key, value;
    g_hash_table_iter_init(&iter, paste->to->sources);
    while (g_hash_table_iter_next(&iter, &key, &value))
        g_hash_table_replace(known, value, key);
    if (paste->kept == NULL) return known;
    g_hash_table_iter_init(&iter, paste->kept);
    while (g_hash_table_iter_next(&iter, &key, &value))
        g_hash_table_replace(known, key, ((const SceneKeptWaveform *)value)->waveform);
    return known;
}

static gboolean read_fragment(Paste *paste, const char *text, GError **error)
{
    gsize length = strlen(text);
    g_autofree char *token = find_token(text, length);
    paste->kept = token == NULL ? NULL : fragment_kept(token);
    g_autoptr(GHashTable) known = known_waveforms(paste);
    paste->from = reader_read_text(paste->to->catalogue, text, length, NULL, known, NULL, error);
    if (paste->from != NULL && tinker_scene_block_count(paste->from) == 0)
        g_set_error_literal(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_SYNTAX, "it is a scene without blocks");
    if (paste->from != NULL && tinker_scene_block_count(paste->from) > 0) return TRUE;
    g_prefix_error(error, "this cannot be pasted (blocks that were copied can): ");
    return FALSE;
}

/* Displacement ------------------------------------------------------------------------------------------------- */

static gboolean displace_property(TinkerScene *scene, TinkerBlockId id, int32_t property, const double by[2],
                                  GError **error)
{
    int32_t column = tinker_scene_block_class(scene, id)->first_columns[property];
    double values[2] = {tinker_scene_get(scene, id, column) + by[0], tinker_scene_get(scene, id, column + 1) + by[1]};
    return tinker_scene_set(scene, id, property, values, error);
}

static gboolean displace_block(TinkerScene *scene, TinkerBlockId id, const double by[2], GError **error)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, id);
    if (block_class == NULL) return TRUE; /* nobody knows where a placeholder is */
    int32_t position = block_class->meanings[TINKER_MEANING_POSITION];
    int32_t origin = block_class->meanings[TINKER_MEANING_LOCAL_ORIGIN];
    gboolean with_origin = origin >= 0 && tinker_scene_property_given(scene, id, origin);
    const gboolean follows = scene_place_on(scene, id) != NULL; /* the plate that it lies on */
    if (position >= 0 && !follows && !displace_property(scene, id, position, by, error)) return FALSE;
    if (with_origin && !displace_property(scene, id, origin, by, error)) return FALSE;
    for (int32_t number = 0; number < tinker_scene_end_count(scene, id); number++) {
        TinkerSceneEnd end = tinker_scene_end(scene, id, number);
        if (end.block != TINKER_NO_BLOCK) continue;
        end.x += by[0];
        end.y += by[1];
        if (!tinker_scene_set_end(scene, id, number, end, error)) return FALSE;
    }
    return TRUE;
}

static gboolean displace(TinkerScene *scene, const double by[2], GError **error)
{
    if (by[0] == 0 && by[1] == 0) return TRUE;
    for (int32_t place = 0; place < tinker_scene_block_count(scene); place++)
        if (!displace_block(scene, tinker_scene_block_at(scene, place), by, error)) return FALSE;
    for (guint i = 0; i < scene->graphs->len; i++) {
        TinkerSceneGraph *graph = g_ptr_array_index(scene->graphs, i);
        graph->place[0] += by[0];
        graph->place[1] += by[1];
        g_autofree char *fault = scene_graph_fault(scene, graph);
        if (fault == NULL) continue;
        g_set_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_VALUE, "graph of %s: %s", scene_graph_name(graph),
                    fault);
        return FALSE;
    }
    return TRUE;
}

/* Going over --------------------------------------------------------------------------------------------------- */

static void append_block(Paste *paste, TinkerBlockId id)
{
    const TinkerBlockClass *block_class = tinker_scene_block_class(paste->from, id);
    gconstpointer placeholder = g_hash_table_lookup(paste->from->placeholders, GINT_TO_POINTER(id));
    paste->ids[id] = scene_append(paste->to, block_class, tinker_scene_end_count(paste->from, id),
                                  block_class == NULL ? scene_placeholder_copy(placeholder) : NULL);
    if (block_class != NULL) scene_copy_row(paste->from, id, paste->to, paste->ids[id]);
    const char *extras = g_hash_table_lookup(paste->from->extras, GINT_TO_POINTER(id));
    if (extras != NULL) g_hash_table_insert(paste->to->extras, GINT_TO_POINTER(paste->ids[id]), g_strdup(extras));
}

/* Names that are free are kept, so that no other block gets them. */
static void name_blocks(Paste *paste)
{
    for (int32_t place = 0; place < tinker_scene_block_count(paste->from); place++) {
        TinkerBlockId id = tinker_scene_block_at(paste->from, place);
        const char *name = tinker_scene_block_name(paste->from, id);
        if (tinker_scene_find_block(paste->to, name) == TINKER_NO_BLOCK)
            scene_assign_name(paste->to, paste->ids[id], name);
    }
    for (int32_t place = 0; place < tinker_scene_block_count(paste->from); place++) {
        TinkerBlockId id = paste->ids[tinker_scene_block_at(paste->from, place)];
        if (tinker_scene_block_name(paste->to, id) == NULL) scene_assign_default_name(paste->to, id);
    }
}

/* Ends of placeholders are text. */
static void rename_placeholder_ends(Paste *paste)
{
    if (g_hash_table_size(paste->from->placeholders) == 0) return;
    g_autoptr(GHashTable) names = g_hash_table_new(tinker_text_hash, g_str_equal);
    for (int32_t place = 0; place < tinker_scene_block_count(paste->from); place++) {
        TinkerBlockId id = tinker_scene_block_at(paste->from, place);
        g_hash_table_insert(names, (gpointer)tinker_scene_block_name(paste->from, id),
                            (gpointer)tinker_scene_block_name(paste->to, paste->ids[id]));
    }
    GHashTableIter iter;
    gpointer id;
    g_hash_table_iter_init(&iter, paste->from->placeholders);
    while (g_hash_table_iter_next(&iter, &id, NULL))
        scene_placeholder_rename_ends(
            g_hash_table_lookup(paste->to->placeholders, GINT_TO_POINTER(paste->ids[GPOINTER_TO_INT(id)])), names);
}

static void lie_down(Paste *paste, TinkerBlockId id)
{
    const ScenePlaceOn *from = scene_place_on(paste->from, id);
    if (from == NULL) return;
    const ScenePlaceOn on = {paste->ids[from->plate], from->along};
    scene_set_place_on(paste->to, paste->ids[id], &on);
}

static void join_ends(Paste *paste, TinkerBlockId id)
{
    const SceneTable *table = scene_table_of(paste->to, paste->ids[id]);
    if (table == NULL) return;
    TinkerSceneEnd *ends = scene_table_ends(table, scene_slot(paste->to, paste->ids[id])->row);
    for (int32_t end = 0; end < tinker_scene_end_count(paste->from, id); end++) {
        if (ends[end].block != TINKER_NO_BLOCK) ends[end].block = paste->ids[ends[end].block];
        g_autofree gint64 *key = scene_end_key(id, end);
        const char *extras = g_hash_table_lookup(paste->from->end_extras, key);
        if (extras != NULL)
            g_hash_table_insert(paste->to->end_extras, scene_end_key(paste->ids[id], end), g_strdup(extras));
    }
}

/* Waveforms that were read go over with their sources; those that were kept had sources elsewhere. */
static void take_sources(Paste *paste)
{
    GHashTableIter iter;
    gpointer key, value;
    GHashTable *sources = paste->to->sources;
    g_hash_table_iter_init(&iter, paste->from->sources);
    while (g_hash_table_iter_next(&iter, &key, &value))
        if (!g_hash_table_contains(sources, key))
            g_hash_table_insert(sources, tinker_waveform_ref(key), g_strdup(value));
    if (paste->kept == NULL) return;
    g_hash_table_iter_init(&iter, paste->kept);
    while (g_hash_table_iter_next(&iter, &key, &value)) {
        const SceneKeptWaveform *waveform = value;
        if (waveform->source != NULL && !g_hash_table_contains(sources, waveform->waveform))
            g_hash_table_insert(sources, tinker_waveform_ref(waveform->waveform), g_strdup(waveform->source));
    }
}

/* Gives the graph the names that its blocks have now. In two rounds, as one block may have got another's name. */
static void rename_graph(const Paste *paste, TinkerSceneGraph *graph)
{
    for (int round = 0; round < 2; round++)
        for (int32_t place = 0; place < tinker_scene_block_count(paste->from); place++) {
            TinkerBlockId block = tinker_scene_block_at(paste->from, place);
            g_autofree char *between = g_strdup_printf("\001%d", block);
            if (round == 0)
                scene_graph_rename(graph, tinker_scene_block_name(paste->from, block), between);
            else
                scene_graph_rename(graph, between, tinker_scene_block_name(paste->to, paste->ids[block]));
        }
}

static void record(Paste *paste, TinkerHistory *history)
{
    int32_t count = tinker_scene_block_count(paste->from);
    g_autofree TinkerBlockId *pasted = g_new(TinkerBlockId, (gsize)count);
    for (int32_t place = 0; place < count; place++)
        pasted[place] = paste->ids[tinker_scene_block_at(paste->from, place)];
    gboolean own = history_open_several(history, "Paste", pasted, (gsize)count);
    history_note_new(history, "Paste", pasted, (gsize)count);
    for (guint i = 0; i < paste->from->graphs->len; i++) {
        TinkerSceneGraph *graph = tinker_scene_graph_copy(g_ptr_array_index(paste->from->graphs, i));
        rename_graph(paste, graph);
        tinker_history_add_graph(history, graph, NULL);
        tinker_scene_graph_free(graph);
    }
    if (own) tinker_history_end(history);
}

static void go_over(Paste *paste, TinkerHistory *history, GArray *pasted)
{
    int32_t count = tinker_scene_block_count(paste->from);
    paste->ids = g_new(TinkerBlockId, (gsize)tinker_scene_id_limit(paste->from));
    for (int32_t place = 0; place < count; place++)
        append_block(paste, tinker_scene_block_at(paste->from, place));
    name_blocks(paste);
    rename_placeholder_ends(paste);
    for (int32_t place = 0; place < count; place++) {
        TinkerBlockId id = tinker_scene_block_at(paste->from, place);
        join_ends(paste, id);
        lie_down(paste, id);
        if (pasted != NULL) g_array_append_val(pasted, paste->ids[id]);
    }
    take_sources(paste);
    scene_settle(paste->to);
    record(paste, history);
    g_free(paste->ids);
}

gboolean tinker_fragment_paste(TinkerHistory *history, const char *text, double dx, double dy, GArray *pasted,
                               GError **error)
{
    Paste paste = {.to = history_scene(history)};
    gboolean good = read_fragment(&paste, text, error) && displace(paste.from, (const double[]){dx, dy}, error);
    if (good) go_over(&paste, history, pasted);
    tinker_scene_free(paste.from);
    g_clear_pointer(&paste.kept, g_hash_table_unref);
    return good;
}
