/* What compiling constraints stands on: memory for their parts, their lengths, and the pattern of S = J M^-1 J^T. */
#ifndef TINKER_CORE_CONSTRAINT_PARTS_H
#define TINKER_CORE_CONSTRAINT_PARTS_H

#include "physics/model/model-data.h"

/* A part of what constraints need, all zero; what lacks is told once, when all has been asked for. */
gpointer tinker_constraints_allot(TinkerModel *model, gsize count, gsize size);
#define ALLOT(model, type, count) ((type *)tinker_constraints_allot((model), (gsize)(count), sizeof(type)))
/* Answers FALSE. */
gboolean tinker_constraints_lack_memory(const TinkerModel *model, GError **error);

/* The rows' lengths: the block's own word, else the largest distance between its ends at the start; of ends in one
 * place the scene's extent. */
void tinker_constraints_find_scales(TinkerModel *model);

/* Bodies that S leaves out: which they are, where all entries by body are listed; what the rows have on them; and,
 * where the pattern is compiled, where that stands. FALSE: there is no memory. */
gboolean tinker_constraints_find_hubs(TinkerModel *model);
void tinker_constraints_list_hubs(TinkerModel *model);
void tinker_constraints_place_hubs(TinkerModel *model);

/* Lists what each body has of the Jacobian, and where every product falls. FALSE where there is no memory for it. */
gboolean tinker_constraints_compile_pattern(TinkerModel *model, GError **error);

#endif
