/* Free-body and kinetic diagram of one body or of several together: every force from outside at its point, and what the
 * forces make, m a. */
#ifndef TINKER_CORE_DIAGRAM_H
#define TINKER_CORE_DIAGRAM_H

#include "equations/newton/equations.h"

typedef struct {
    TinkerBlockId from; /* the block that acts; of a contact the other one that touches */
    TinkerTermKind kind;
    double point[2];       /* m */
    double force[2];       /* N */
    double torque;         /* N m: beside that of the force at its point */
    TinkerBlockId on;      /* which of the bodies it acts on */
    TinkerBlockId partner; /* the block at the other end, on which the opposite force acts; -1: no single one */
    TinkerBlockId second;  /* of a rope over a wheel: the other neighbour on its path; else -1 */
    int32_t end;           /* of a rope over more than two ends: the number of the one it acts at, from 1 on; else 0 */
} TinkerDiagramForce;

typedef struct {
    double time;
    double mass;       /* kg: of all together */
    double inertia;    /* kg m^2: of one body that turns; NAN of others, whose moments are not balanced */
    double centre[2];  /* m: of mass; of a block that does not move its place */
    GArray *forces;    /* of TinkerDiagramForce: those from outside */
    GArray *cancelled; /* of TinkerBlockId: what acts between the bodies */
    gboolean moves;    /* FALSE: a support, which has no kinetic diagram */
    double kinetic[2]; /* N: m a, by the run's accelerations */
    double turning;    /* N m: I alpha */
} TinkerDiagram;

/* Of these blocks (ended by -1) at a state: bodies, or one block that stands still. (transfer full) */
TinkerDiagram *tinker_diagram_new(TinkerScene *scene, const TinkerModelState *state, const TinkerBlockId *blocks,
                                  GError **error);
void tinker_diagram_free(TinkerDiagram *diagram);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerDiagram, tinker_diagram_free)

#endif
