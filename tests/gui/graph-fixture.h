/* What the tests of graphs share: a mass that falls, and its graphs. */
#ifndef TEST_GRAPH_FIXTURE_H
#define TEST_GRAPH_FIXTURE_H

#include "gui-fixture.h"
#include "gui/curve/graph-data.h"

#define GRAVITY 9.81

/* A mass falls from rest at the origin. (transfer full) */
GuiFixture *graph_fixture_fall(const char *units, const char *graphs);

/* Runs it up to a time (s), which is shown. */
void graph_fixture_run_until(GuiFixture *fixture, double time);

/* Data of the scene's first graph. (transfer full) */
TinkerGraphData *graph_fixture_data(GuiFixture *fixture);

#endif
