/* What blocks that speak of angles are shown and answer, beside the points of their ends. */
#ifndef TINKER_CORE_ANGLES_H
#define TINKER_CORE_ANGLES_H

#include "physics/model/model-data.h"

struct _TinkerAngles {
    const int32_t *turns; /* of each end of the batch: the turn of what it is on. Borrowed. */
    int32_t rows;         /* of each block that is a constraint; else 1 */
    TinkerPose *poses;    /* of each end, as they are shown */
    TinkerPoint *placed;  /* of each end: where the scene places it, relative to the model's origin */
    TinkerPose *placed_poses;
    int32_t *has_angle;
    double **placed_columns;     /* memory of its own */
    const double **column_views; /* of them, as they are shown */
    int32_t columns;
    double *angular;  /* what the plugin answers of angles: of each end, or of each end of each row */
    double *jacobian; /* of a constraint: what it answers of its points */
};

/* NULL for a batch that knows no angles. Behind its end points stand the turns. (transfer full) */
TinkerAngles *tinker_angles_new(const TinkerBlockBatch *batch, const int32_t *end_points);
void tinker_angles_free(TinkerAngles *angles);

/* Takes the state in the points as the one that the scene places the blocks in. */
void tinker_model_place_angles(TinkerModel *model);

/* Those of a batch, or NULL. */
TinkerAngles *tinker_model_angles(const TinkerModel *model, const TinkerBlockBatch *batch);

/* The poses of the ends from `from` on, for the state in the points. */
void tinker_angles_gather(TinkerAngles *angles, const TinkerModel *model, int32_t from, int32_t count);

/* Shows them in a view of the batch whose ends begin with the end `from`, `ends` of them. */
void tinker_angles_show(TinkerAngles *angles, TinkerBatch *view, int32_t from, int32_t ends);

#endif
