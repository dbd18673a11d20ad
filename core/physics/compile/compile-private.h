/* What the files that compile a model share. */
#ifndef TINKER_CORE_COMPILE_PRIVATE_H
#define TINKER_CORE_COMPILE_PRIVATE_H

#include "physics/model/model.h"

/* A model of nothing yet; takes the batches over. (transfer full) */
TinkerModel *tinker_model_new_of_batches(TinkerScene *scene, GPtrArray *batches);
/* Fills in the lengths that the scene leaves to where the blocks are placed, and what it leaves to their shapes. */
gboolean tinker_model_resolve_placed(TinkerModel *model, GError **error);
/* Bodies, forces and constraints: all but contacts and the start. */
gboolean tinker_model_compile_parts(TinkerModel *model, GError **error);

/* Compiling: each adds its part to the model. */
gboolean tinker_model_compile_bodies(TinkerModel *model, GError **error);
gboolean tinker_model_compile_points(TinkerModel *model, GError **error);
gboolean tinker_model_compile_forces(TinkerModel *model, GError **error);
gboolean tinker_model_compile_constraints(TinkerModel *model, GError **error);
gboolean tinker_model_check_start(TinkerModel *model, GError **error);

#endif
