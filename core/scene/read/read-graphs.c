/* Reading graphs: which quantity of which block, and where the graph stands on the canvas. */
#include "scene/value/reader.h"

/* What a graph's members are, and where; the places are for messages. */
typedef struct {
    TinkerSceneGraph graph;
    JsonAt block_at, quantity_at, against_at;
} ReadGraph;

static void take_text(SceneReader *reader, const cJSON *json, JsonAt at, char **text)
{
    const char *given = reader_text(reader, json, at, json->string);
    if (given == NULL) return;
    g_free(*text);
    *text = g_strdup(given);
}

static gboolean read_size(SceneReader *reader, const cJSON *json, JsonAt at, double size[2])
{
    if (!reader_vector(reader, json, at, "size", reader_length, size)) return FALSE;
    g_autofree char *fault = scene_graph_size_fault(size);
    return fault == NULL || reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s", fault);
}

static void read_member(SceneReader *reader, const cJSON *json, JsonAt at, ReadGraph *read, GString **unknown)
{
    static const char *const keys[] = {"block", "quantity", "against", "place", "size", "title", NULL};
    TinkerSceneGraph *graph = &read->graph;
    if (g_str_equal(json->string, "block")) {
        read->block_at = at;
        take_text(reader, json, at, &graph->block);
    } else if (g_str_equal(json->string, "quantity")) {
        read->quantity_at = at;
        take_text(reader, json, at, &graph->quantity);
    } else if (g_str_equal(json->string, "against")) {
        read->against_at = at;
        take_text(reader, json, at, &graph->against);
    } else if (g_str_equal(json->string, "title")) {
        take_text(reader, json, at, &graph->title);
    } else if (g_str_equal(json->string, "place")) {
        graph->has_place = reader_vector(reader, json, at, "place", reader_length, graph->place);
    } else if (g_str_equal(json->string, "size")) {
        graph->has_size = read_size(reader, json, at, graph->size);
    } else {
        reader_keep_unknown(reader, at, json->string, keys, unknown);
    }
}

static void check_quantity(SceneReader *reader, JsonAt at, const char *what, const TinkerBlockClass *block_class,
                           const char *quantity)
{
    g_autofree char *fault = scene_quantity_fault(block_class, quantity);
    if (fault != NULL) reader_error(reader, at, TINKER_SCENE_ERROR_VALUE, "%s: %s", what, fault);
}

static void check_graph(SceneReader *reader, JsonAt at, const ReadGraph *read)
{
    const TinkerSceneGraph *graph = &read->graph;
    if (graph->block == NULL && read->block_at.depth == 0)
        reader_error(reader, at, TINKER_SCENE_ERROR_SYNTAX, "the key \"block\" is missing");
    if (graph->quantity == NULL && read->quantity_at.depth == 0)
        reader_error(reader, at, TINKER_SCENE_ERROR_SYNTAX, "the key \"quantity\" is missing");
    if (graph->block == NULL) return;
    TinkerBlockId block = tinker_scene_find_block(reader->scene, graph->block);
    if (block == TINKER_NO_BLOCK) {
        g_autofree char *suggestion = reader_suggest_block(reader, graph->block);
        reader_error(reader, read->block_at, TINKER_SCENE_ERROR_VALUE, "block: there is no block \"%s\"%s",
                     graph->block, suggestion);
        return;
    }
    const TinkerBlockClass *block_class = tinker_scene_block_class(reader->scene, block);
    if (block_class == NULL) return; /* nobody knows the quantities of a placeholder */
    if (graph->quantity != NULL) check_quantity(reader, read->quantity_at, "quantity", block_class, graph->quantity);
    if (g_strcmp0(graph->against, "time") != 0)
        check_quantity(reader, read->against_at, "against", block_class, graph->against);
}

static void read_graph(SceneReader *reader, const cJSON *json, JsonAt at)
{
    ReadGraph read = {.graph = {.against = g_strdup("time")}};
    GString *unknown = NULL;
    int step = 0;
    for (const cJSON *member = json->child; member != NULL; member = member->next, step++)
        read_member(reader, member, at_child(at, step), &read, &unknown);
    check_graph(reader, at, &read);
    TinkerSceneGraph *graph = g_new(TinkerSceneGraph, 1);
    *graph = read.graph;
    graph->extras = unknown == NULL ? NULL : g_string_free(unknown, FALSE);
    g_ptr_array_add(reader->scene->graphs, graph);
}

void reader_graphs(SceneReader *reader, const JsonPart *part)
{
    cJSON *json = reader_parse(reader, part);
    if (json == NULL) return;
    if (!cJSON_IsArray(json)) reader_wrong_kind(reader, json, at_root(part->start), "graphs", "an array");
    int number = 0;
    for (const cJSON *member = cJSON_IsArray(json) ? json->child : NULL; member != NULL;
         member = member->next, number++) {
        JsonAt at = at_child(at_root(part->start), number);
        reader_label_entry(reader, "graphs", number, NULL);
        if (cJSON_IsObject(member))
            read_graph(reader, member, at);
        else
            reader_error(reader, at, TINKER_SCENE_ERROR_VALUE,
                         "a graph is an object, {\"block\": ..., \"quantity\": ...}");
    }
    reader_label(reader, NULL);
    cJSON_Delete(json);
}
