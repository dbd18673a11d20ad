/* What went wrong in an evaluation, as the failure of the model. */
#ifndef TINKER_CORE_FAILURES_H
#define TINKER_CORE_FAILURES_H

#include "physics/model/model-data.h"

/* Writes a failure down, in place of the last one. */
void tinker_model_tell_failure(TinkerModel *model, const char *format, ...) G_GNUC_PRINTF(2, 3);

/* Records that a plugin failed in its callback `what`. Answers TINKER_FAILED. */
TinkerStatus tinker_model_fail(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what,
                               const char *why);

/* Looks whether a plugin wrote beyond the memory that it was given (plugin/guarded.h). TINKER_FAILED and its name where
 * one did. */
TinkerStatus tinker_model_check_guards(TinkerModel *model);

/* Records that `what` of a block is not a finite number. Answers TINKER_RETRY_SMALLER: a trial that reached too far may
 * be cut; a method that cannot do so stops with what was recorded. */
TinkerStatus tinker_model_not_finite(TinkerModel *model, const TinkerBlockBatch *batch, int32_t row, const char *what);

#endif
