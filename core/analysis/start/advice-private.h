/* What the files of advice share. */
#ifndef TINKER_CORE_ADVICE_PRIVATE_H
#define TINKER_CORE_ADVICE_PRIVATE_H

#include "analysis/start/advice.h"
#include "physics/model/model.h"

/* An array for advice. (transfer full) */
GPtrArray *advice_array_new(void);

/* Adds one; the message is taken over. The answer is borrowed: blocks and repair are still to be filled. */
TinkerAdvice *advice_add(GPtrArray *all, TinkerAdviceKind kind, gboolean blocks_run, char *message);
void advice_add_block(TinkerAdvice *advice, TinkerBlockId block);
void advice_add_vector(TinkerAdvice *advice, TinkerBlockId block, double x, double y, double rate);

/* Start velocities that the constraints of the compiled scene do not allow. */
void advice_on_velocities(GPtrArray *all, const TinkerFrame *frame, const TinkerModel *model);

/* Bodies that are not solid and would fall through a top, or lie at one. */
void advice_on_passing(GPtrArray *all, const TinkerFrame *frame);

#endif
