/* What the files that compile a model share. */
#ifndef TINKER_CORE_COMPILE_PRIVATE_H
#define TINKER_CORE_COMPILE_PRIVATE_H

#include "physics/model/model.h"

/* Compiling: each adds its part to the model. */
gboolean tinker_model_compile_bodies(TinkerModel *model, GError **error);
gboolean tinker_model_compile_forces(TinkerModel *model, GError **error);
gboolean tinker_model_compile_constraints(TinkerModel *model, GError **error);
gboolean tinker_model_check_start(TinkerModel *model, GError **error);

#endif
