/* What the tests of modes share: from the text of a scene, as of physics-fixture.h, to its modes. */
#ifndef TEST_MODES_FIXTURE_H
#define TEST_MODES_FIXTURE_H

#include "analysis/modes/mode-analysis.h"
#include "physics-fixture.h"

typedef struct {
    TinkerScene *scene;
    TinkerModeAnalysis *analysis;
} ModesFixture;

/* About rest or the start. Must succeed. (transfer full) */
ModesFixture *modes_fixture_new(gboolean rest, const char *blocks);
ModesFixture *modes_about_rest(const char *blocks);
void modes_fixture_free(ModesFixture *fixture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(ModesFixture, modes_fixture_free)

/* Borrowed; there must be one at this place. */
const TinkerMode *modes_at(const ModesFixture *fixture, guint place);

guint modes_count(const ModesFixture *fixture, TinkerModeKind kind);

/* A value is this one, but for a share of it. */
void modes_assert_relative(const char *what, double value, double truth, double bound);

/* The oscillations, in order, have these natural frequencies (rad/s). */
void modes_assert_frequencies(const ModesFixture *fixture, const double *truth, guint count);

#endif
