/* The matrices of a start, which start-matrices.c sets up and start-products.c multiplies with. */
#ifndef TINKER_CORE_START_MATRICES_PRIVATE_H
#define TINKER_CORE_START_MATRICES_PRIVATE_H

#include "physics/plan/start-matrices.h"

#include "physics/line/linear-form-data.h"
#include "physics/plan/islands.h"
#include "physics/plan/start-geometry.h"
#include "physics/system/jacobian.h"

struct _TinkerStartMatrices {
    const TinkerIsland *island;
    TinkerModel *model;
    const TinkerLinearSystem *linear; /* else NULL */
    int32_t n;
    double *inverse_root; /* of each coordinate's mass */
    TinkerJacobian *jacobian;
    double *stiffness, *damping; /* of the Jacobian's pattern */
    GArray *geometry;            /* of TinkerStiffnessEntry */
    GArray *turning;             /* of TinkerTurningEntry */
    double *tensions;            /* of the constraints, one a row: of the free products. NULL where there are none */
    double *acceleration, *velocity;
    double *input, *output; /* of the free products */
    double *projected;      /* of the others */
    gboolean damped, turned;
};

#endif
