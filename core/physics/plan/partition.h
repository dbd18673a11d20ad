/* The parts of a model that nothing ties together: sets of bodies, and the blocks that a model of each needs. */
#ifndef TINKER_CORE_PARTITION_H
#define TINKER_CORE_PARTITION_H

#include "physics/model/model.h"

typedef struct {
    int32_t count;   /* of sets, in the order of their first bodies */
    GArray *starts;  /* of guint: where the blocks of each set begin in `numbers`, and where those of the last end */
    GArray *numbers; /* of int32_t: blocks of each set, ascending, as tinker_model_new_of wants them */
    gint64 blocks_asked; /* blocks and ends that were looked at */
} TinkerPartition;

/* Bodies belong to one set where a connector, a constraint or a field that couples bodies links them; a support links
 * nobody. With the bodies of a set are whatever has an end on one of them, the blocks at its other ends, what moves
 * those, all fields, and, where one of the bodies has a shape, all solid plates, which it may come upon wherever it is;
 * where plates and sets are so many that these would not fit into memory, all bodies with a shape are one set. What
 * nothing ties to a body is in no set. (transfer full) */
TinkerPartition *tinker_partition_new(const TinkerModel *model);
void tinker_partition_free(TinkerPartition *partition);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerPartition, tinker_partition_free)

#endif
