/* Which forces act on each body at an instant, one by one, each with the block that it comes from: what a free-body
 * diagram shows. */
#ifndef TINKER_CORE_ACTING_FORCES_H
#define TINKER_CORE_ACTING_FORCES_H

#include "numerics/contact/contact-laws.h"
#include "physics/model/model.h"
#include "physics/run/simulation.h"
#include "physics/shapes/gaps.h"

typedef enum {
    TINKER_ACTING_LINE,       /* of a connector that pulls its two ends together, or pushes them apart */
    TINKER_ACTING_CONSTRAINT, /* of what keeps a distance */
    TINKER_ACTING_ELEMENT,    /* of a force element: a motor */
    TINKER_ACTING_FIELD,
    TINKER_ACTING_NORMAL,   /* of a contact, across what touches, */
    TINKER_ACTING_FRICTION, /* and along it */
} TinkerActingKind;

/* One force. `by` is the connector, force element or field; of a contact, the other of the two blocks that touch. `on`
 * is a body that can move or a support. It may be 0: a slack rope, a wind that stands still. A contact has four, behind
 * one another: its normal force and the answer to that, its friction and the answer to that. */
typedef struct {
    TinkerBlockId by, on;
    TinkerActingKind kind;
    double x, y;        /* m: where it acts, in the world */
    double fx, fy;      /* N */
    double torque;      /* N m: beside that of the force at its arm */
    int32_t end;        /* of `by`: the number of the end it acts at; -1: at none */
    int32_t touch;      /* of a contact whose gap function is known: its number among the touches; else -1 */
    gboolean is_answer; /* of a contact: the opposite, on the other body, of the force that stands before it */
    gboolean is_mean;   /* of the last step, as impulses have contact */
} TinkerActingForce;

/* Two shapes that touch, by one of their gap functions. */
typedef struct {
    TinkerBlockId block[2]; /* of shapes 0 and 1 */
    double angle[2];        /* rad: of a shape whose block has no angle of its own, as that of a mass */
    TinkerGapFunction gap;
    double normal[2];       /* from what has the seat to what has the tip */
    TinkerContactMode mode; /* its friction is on what has the tip, along t */
    gboolean at_limit;      /* slips by its static coefficient */
    double friction[2];     /* coefficients: static, dynamic */
} TinkerActingTouch;

typedef struct _TinkerActingForces TinkerActingForces;

/* An array for tinker_acting_forces_at. Element: TinkerActingForce. (transfer full) */
GArray *tinker_acting_forces_array(void);

/* What lists the forces of a model, which is borrowed and outlives it. (transfer full) */
TinkerActingForces *tinker_acting_forces_new(TinkerModel *model);
void tinker_acting_forces_free(TinkerActingForces *forces);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerActingForces, tinker_acting_forces_free)

/* Inside a sample function of a simulation of this model: fills `out` anew with all forces at the sample, class by
 * class in the order of the scene, contacts last. What acts on a body adds up to its mass times its acceleration; where
 * contact acts as impulses, its forces are the means of the last step. The run goes on as if it had not been asked, to
 * the bit; after the first call memory is needed only where more touches than ever before. Errors:
 * TINKER_MODEL_ERROR_RUN where a plugin does not give its forces. */
gboolean tinker_acting_forces_at(TinkerActingForces *forces, TinkerSimulation *simulation, GArray *out, GError **error);

/* What touched when forces were asked for last: valid until the next time. Element: TinkerActingTouch. Borrowed. */
const GArray *tinker_acting_forces_touches(const TinkerActingForces *forces);

/* The forces in a scene as it is set up, at t = 0: compiles it and lets it touch what it touches. Errors are those of
 * compiling. */
gboolean tinker_acting_forces_at_start(TinkerScene *scene, GArray *out, GError **error);

/* Those so long (s, above 0) after that, of a run that is given up where it takes longer than the patience (s). Errors
 * are those of running. */
gboolean tinker_acting_forces_after(TinkerScene *scene, double time, double patience, GArray *out, GError **error);

#endif
