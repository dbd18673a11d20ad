#include "graph-fixture.h"

GuiFixture *graph_fixture_fall(const char *units, const char *graphs)
{
    GuiFixture *fixture = gui_fixture_new("");
    g_autofree char *members = g_strdup_printf("'units': '%s', 'run': {'duration': 0.5, 'interval': 0.01}, 'blocks': "
                                               "[{'type': 'gravity', 'name': 'Gravity'}, {'type': 'mass', 'name': "
                                               "'Mass 0', 'mass': 1, 'position': [0, 0]}], 'graphs': [%s]",
                                               units, graphs);
    gui_fixture_start_scene(fixture, members);
    return fixture;
}

void graph_fixture_run_until(GuiFixture *fixture, double time)
{
    TinkerBlockId culprit;
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_player_play(fixture->player, &culprit, &error));
    g_assert_no_error(error);
    g_assert_true(tinker_player_wait(fixture->player, time, &error));
    g_assert_no_error(error);
    tinker_player_pause(fixture->player);
    tinker_player_seek(fixture->player, time);
}

TinkerGraphData *graph_fixture_data(GuiFixture *fixture)
{
    TinkerGraphData *data = tinker_graph_data_new(fixture->document, fixture->player);
    tinker_graph_data_set_graph(data,
                                g_ptr_array_index(tinker_scene_graphs(tinker_document_scene(fixture->document)), 0));
    tinker_graph_data_update(data);
    return data;
}
