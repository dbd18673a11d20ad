/* What the files of a frame share. */
#ifndef TINKER_CORE_SCENE_FRAME_PRIVATE_H
#define TINKER_CORE_SCENE_FRAME_PRIVATE_H

#include "scene/frame/batch.h"
#include "scene/frame/frame.h"
#include "scene/frame/lanes.h"
#include "scene/frame/motions.h"
#include "scene/frame/paths.h"
#include "scene/frame/spans.h"

typedef struct {
    double x, y, orientation;
} TinkerFramePose;

typedef struct {
    TinkerBlockBatch *batch; /* NULL: a placeholder, or no block at all */
    int32_t row;
} TinkerFrameLocation;

/* How long a block is that is wound, as it was told when bodies had been placed so often. */
typedef struct {
    double length;
    guint64 placings;
} TinkerWoundLength;

struct _TinkerFrame {
    TinkerScene *scene;
    double time;
    GPtrArray *batches;
    int32_t limit;
    TinkerFramePose *placed; /* by block id, without motions */
    TinkerFramePose *poses;  /* by block id, now */
    TinkerMotions *motions;
    TinkerFrameLocation *locations;
    double *columns;            /* of the instance handed out last */
    const char **texts;         /* likewise; borrowed from the scene */
    GArray *ends;               /* likewise, of TinkerEnd */
    double symbol_size;         /* m, that instances report */
    double *lanes;              /* by block id: see lanes.h */
    GArray *wound;              /* of TinkerBlockId: what is wound on bodies */
    TinkerWoundLength *lengths; /* by block id; of other blocks unused */
    guint64 placings;           /* how often a body has been placed: what was told of lengths before holds no longer */
    TinkerPaths *paths;         /* of the blocks that leave one; NULL where there are none */
    TinkerSpans *spans;         /* of the blocks that have one; NULL where there are none */
};

/* An end, on what it is attached to, as that is now; `attached` and `angle` with it. */
void tinker_frame_end_place(const TinkerFrame *frame, const TinkerSceneEnd *end, TinkerEnd *out);

/* Fills in what bodies work out of their other properties where it is left out. FALSE: a plugin refuses. */
gboolean tinker_frame_work_out_shaped(TinkerFrame *frame, GError **error);

/* Fills in, of the ends as they are placed at t = 0: radii, which lengths go by; then lengths from end to end, and
 * angles between two. */
void tinker_frame_work_out_placed(TinkerFrame *frame);

#endif
