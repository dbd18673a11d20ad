#include "history-fixture.h"

char *history_text(TinkerScene *scene)
{
    return tinker_scene_to_text(scene, TINKER_WRITE_SI);
}

TinkerSceneGraph *history_graph(const char *block, const char *quantity)
{
    static GPtrArray *made; /* of all graphs */
    if (made == NULL) made = g_ptr_array_new();
    TinkerSceneGraph *graph = tinker_scene_graph_new();
    tinker_scene_graph_add(graph, block, quantity);
    g_ptr_array_add(made, graph);
    return graph;
}
