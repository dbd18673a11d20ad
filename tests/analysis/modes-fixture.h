/* What the tests of modes share: from the text of a scene, as of physics-fixture.h, to its modes. */
#ifndef TEST_MODES_FIXTURE_H
#define TEST_MODES_FIXTURE_H

#include "analysis/mode-analysis.h"
#include "physics-fixture.h"

typedef struct {
    TinkerScene *scene;
    TinkerModeAnalysis *analysis;
} ModesFixture;

/* About rest or the start. Must succeed. (transfer full) */
ModesFixture *modes_fixture_new(gboolean rest, const char *blocks);
void modes_fixture_free(ModesFixture *fixture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(ModesFixture, modes_fixture_free)

#endif
