/* What the tests of advice share: the one piece of advice of a scene, and its repair. */
#ifndef TEST_ADVICE_CHECKS_H
#define TEST_ADVICE_CHECKS_H

#include "analysis/start/advice.h"
#include "start-fixture.h"

/* The one piece, which is of this kind. (transfer none) */
const TinkerAdvice *advice_only(const GPtrArray *all, TinkerAdviceKind kind);

/* The one piece of advice has these words and is about this block; NULL: no such repair. */
void advice_assert_only(const StartFixture *f, TinkerAdviceKind kind, gboolean blocks_run, const char *block,
                        const char *part, const char *repair);

/* Repairs the one piece of advice; then there is none. */
void advice_repair(StartFixture *f);

#endif
