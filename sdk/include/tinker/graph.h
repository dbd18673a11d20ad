/* Tinker SDK: the graph interface, "tinker.graph/1": the values of a block's quantities.
 *
 * Called only at the instants that somebody wants to see, never inside a step.
 */
#ifndef TINKER_GRAPH_H
#define TINKER_GRAPH_H

#include "block.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_GRAPH_INTERFACE "tinker.graph/1"

/* What is known of the instances at the instant batch->time. Indexed as in physics.h; of a block that is itself a body,
 * its own centre is its one end. A field has no ends. Positions are relative to batch->origin, which is 0 for bodies
 * and fields. */
typedef struct TinkerGraphInput {
    uint32_t struct_size;
    int32_t reserved;
    const TinkerPoint *ends;     /* position and velocity */
    const double *accelerations; /* ax, ay of each end (m/s^2) */
    const double *multipliers;   /* of a constraint: lambda of each row (N); else NULL */
    const double *forces;        /* of a force element: fx, fy on each end (N); else NULL */
    const TinkerPoint *bodies;   /* of a field: the centres of all bodies that can move; else NULL */
    const double *masses;        /* likewise their masses */
    int32_t body_count;
    int32_t reserved2;
    /* Of a body or a plate: four numbers an instance (N), of what acts on it through its contacts. The sum of the
     * normal forces, which is not negative; the friction along the tops, positive towards +x of the plate's own axes
     * (the force on the body, or of a plate that on the plate); the whole force in x and in y. NULL where nothing is
     * solid. */
    const double *contacts;
    const TinkerPose *poses; /* of each end: how what it is on is turned; of a body itself: how that is */
    const double *torques;   /* of a force element that asks for angles, and of a constraint with `friction` that of the
                                friction: the torque on what each end is on (N m); else NULL */
} TinkerGraphInput;

typedef struct TinkerGraph {
    uint32_t struct_size;
    int32_t reserved;
    /* Required: the quantity of this number, in the order of the declaration, of every instance. */
    TinkerStatus (*values)(TinkerBatch *batch, const TinkerGraphInput *input, int32_t quantity, double *values);
} TinkerGraph;

#ifdef __cplusplus
}
#endif
#endif
