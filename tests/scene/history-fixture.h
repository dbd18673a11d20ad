/* What the tests of the history share. */
#ifndef TEST_HISTORY_FIXTURE_H
#define TEST_HISTORY_FIXTURE_H

#include "scene-fixture.h"
#include "scene/history/history.h"

/* (transfer full) */
char *history_text(TinkerScene *scene);

/* A graph of one quantity, which the tests may add to; the history copies it. Borrowed; it lives to the end. */
TinkerSceneGraph *history_graph(const char *block, const char *quantity);

#endif
