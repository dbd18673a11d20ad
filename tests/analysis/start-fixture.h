/* What the tests of start conditions and advice share: a scene with its history. */
#ifndef TEST_START_FIXTURE_H
#define TEST_START_FIXTURE_H

#include "physics-fixture.h"
#include "scene/history/history.h"

typedef struct {
    TinkerScene *scene;
    TinkerHistory *history;
    char *text; /* of the scene as it was read */
} StartFixture;

/* The text as of physics-fixture.h. (transfer full) */
StartFixture *start_fixture_new(const char *blocks);
void start_fixture_free(StartFixture *fixture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(StartFixture, start_fixture_free)

TinkerBlockId start_fixture_block(const StartFixture *fixture, const char *name);

/* A component of the property with a meaning. */
double start_fixture_get(const StartFixture *fixture, const char *name, int32_t meaning, int32_t component);

/* What was done is one step: undone it leaves the text as it was read; it is done again. */
void start_fixture_assert_one_step(StartFixture *fixture);
/* Nothing was done. */
void start_fixture_assert_untouched(StartFixture *fixture);

#endif
