/* What the tests of start conditions do with offers: find them, apply them, and look at what they did. */
#ifndef TEST_START_OFFERS_H
#define TEST_START_OFFERS_H

#include "analysis/start/start-conditions.h"
#include "start-fixture.h"

#define GRAVITY "{'type': 'gravity', 'acceleration': 9.81},"

/* The option of a kind for a block, about `other` (NULL: any); NULL where it is not offered. Borrowed from `options`.
 */
const TinkerStartOption *start_find_option(const StartFixture *f, const GPtrArray *options, TinkerStartKind kind,
                                           const char *other);

gboolean start_is_offered(const StartFixture *f, const char *block, TinkerStartKind kind, const char *other);

/* What the entry would show. */
double start_value_of(const StartFixture *f, const char *block, TinkerStartKind kind, const char *other);

gboolean start_try_apply(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value,
                         GError **error);

/* Applies it; it must succeed, be one step, and where it asks for a value show that value from then on. */
void start_apply(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value);

/* It must fail with a sentence that has this part, and leave the scene untouched. */
void start_assert_refused(StartFixture *f, const char *block, TinkerStartKind kind, const char *other, double value,
                          const char *part);

/* The position of a block in m, and its velocity in m/s. */
void start_assert_at(const StartFixture *f, const char *block, double x, double y);
void start_assert_moves(const StartFixture *f, const char *block, double x, double y);

#endif
