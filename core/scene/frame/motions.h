/* Motions: how blocks without degrees of freedom are moved. */
#ifndef TINKER_CORE_MOTIONS_H
#define TINKER_CORE_MOTIONS_H

#include "scene/frame/batch.h"

/* Displacement of one block's centre from its place (m), its velocity and its acceleration; how far it is turned from
 * its orientation (rad), and the derivatives of that. */
typedef struct {
    double x, y, vx, vy, ax, ay;
    double angle, rate, angular_acceleration;
    gboolean turns; /* some motion turns it */
} TinkerPlace;

typedef struct _TinkerMotions TinkerMotions;

/* All motions among the batches, which are borrowed. NULL where there are none, which all below take for that.
 * (transfer full) */
TinkerMotions *tinker_motions_new(GPtrArray *batches);
void tinker_motions_free(TinkerMotions *motions);

/* The blocks that are moved, without repetition. Borrowed. */
const TinkerBlockId *tinker_motions_blocks(const TinkerMotions *motions, int32_t *count);

/* Works out all displacements at t; waveforms must be inside the piece that t belongs to. Allocates nothing. FALSE
 * where a plugin fails or a value is not finite: see tinker_motions_failure. */
gboolean tinker_motions_evaluate(TinkerMotions *motions, double t);

/* Whether some motion moves the block. */
gboolean tinker_motions_moves(const TinkerMotions *motions, TinkerBlockId block);

/* The displacement of a block that is moved, as of the last evaluation. */
const TinkerPlace *tinker_motions_place(const TinkerMotions *motions, TinkerBlockId block);

/* The motion that failed last; TINKER_NO_BLOCK where none did. */
TinkerBlockId tinker_motions_failure(const TinkerMotions *motions);

#endif
