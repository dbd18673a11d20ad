/* Compiling: from a scene to a model. */
#ifndef TINKER_CORE_COMPILE_H
#define TINKER_CORE_COMPILE_H

#include "physics/model/model.h"

/* Compiles a scene. Checks that it can run: no placeholders, no detached ends, start positions that fit the constraints
 * (supports where they are at t = 0), no contradictory constraints. (transfer full) */
TinkerModel *tinker_model_new(TinkerScene *scene, GError **error);
/* A model of those blocks alone that `include` has TRUE for (by block id; NULL: all). What one of them has an end on is
 * to be among them. (transfer full) */
TinkerModel *tinker_model_new_part(TinkerScene *scene, const gboolean *include, GError **error);
/* A model of some of a model's blocks: `numbers` as tinker_batches_take has them. What one of them has an end on is to
 * be among them. It costs what it holds, however large the whole is, which it borrows from. (transfer full) */
TinkerModel *tinker_model_new_of(const TinkerModel *whole, const int32_t *numbers, int32_t count, GError **error);
void tinker_model_free(TinkerModel *model);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerModel, tinker_model_free)

#endif
