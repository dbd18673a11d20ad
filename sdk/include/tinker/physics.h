/* Tinker SDK: the physics interface, "tinker.physics/1".
 *
 * A block fills one role, or the body role and one more. The host owns all state: it works out the kinematics, calls
 * a role's function over ranges of instances, and adds up what comes back in an order that never changes. A function
 * is a pure map: same input, same bits; it does not allocate, lock, log, do I/O or keep anything between calls. Models
 * of one scene may be evaluated at once, each on a thread of its own, with a scratch of its own.
 *
 * Symbols: x, v position and velocity; d = x_b - x_a from a connector's first end to its second; L = |d|; n = d / L;
 * rate = dL/dt = n . (v_b - v_a); T tension, positive when it pulls the ends together; g constraint function;
 * J = dg/dx; lambda multiplier.
 *
 * Ends are points. Forces on them turn what they are on, places turn with it, and the host takes care of both: a law
 * of places alone says nothing of angles. One that speaks of angles itself (a torsional spring, a weld, a gear) sets
 * `angles`: it is then shown how what its ends are on is turned, and writes torques or a third column beside what it
 * writes of the points. There angles are those of whole blocks, in the world, and count turns.
 *
 * Every function but those marked "required" may be NULL.
 */
#ifndef TINKER_PHYSICS_H
#define TINKER_PHYSICS_H

#include "block.h"

#ifdef __cplusplus
extern "C" {
#endif

#define TINKER_PHYSICS_INTERFACE "tinker.physics/1"

/* Body ----------------------------------------------------------------------------------------------------------- */

#define TINKER_SHAPE_NONE 0 /* touches nothing */
#define TINKER_SHAPE_BOX                                                                                               \
    1                        /* of a point mass: meets a surface when its centre is height / 2 from it, however it is  \
                                turned; of a rigid body: a box of `width` along its own x axis and `height`, whose     \
                                corners meet surfaces */
#define TINKER_SHAPE_PLATE 2 /* a segment of `width` with one solid side, +height / 2 along its own y axis */
#define TINKER_SHAPE_DISC  3 /* of a rigid body: a disc of `radius` (TINKER_MEANING_RADIUS), which rolls */
#define TINKER_SHAPE_OUTLINE                                                                                           \
    4 /* of a rigid body: the polygon of its list of points (TINKER_TEXT_POINTS), convex or not; its centre of mass is \
         at TINKER_MEANING_CENTRE_OF_MASS among them */

/* Something that connectors attach to. Its place, velocity, mass and size are the properties that carry the meanings
 * TINKER_MEANING_POSITION, _VELOCITY, _MASS, _INERTIA, _ORIENTATION, _ANGULAR_VELOCITY, _WIDTH, _HEIGHT and so on. A
 * rigid body's position is that of its centre of mass. Connectors attach to any place of it, and of what does not move;
 * blocks hear of places in the world alone: the host works out where they are and what forces there do to the body. */
typedef struct TinkerBody {
    uint32_t struct_size;
    int32_t degrees_of_freedom; /* 0: moves as a known function of time; 2: point mass; 3: rigid body, which turns */
    int32_t shape;              /* TINKER_SHAPE_... */
    int32_t reserved;
    /* Required where a property has TINKER_DEFAULT_AS_SHAPED: its value for every instance, from the other properties
     * (an inertia from mass and size). `property` is its number in the order of the declaration; of a vector x and y
     * are written instance by instance. Asked whenever one is left out, before `prepare`. */
    TinkerStatus (*as_shaped)(TinkerBatch *batch, int32_t property, double *values);
} TinkerBody;

/* Line law ------------------------------------------------------------------------------------------------------- */

/* A connector of two ends whose force acts along the line between them. The host does the geometry. */
typedef struct TinkerLineLaw {
    uint32_t struct_size;
    int32_t partly_stores; /* 1: `energy` answers NAN for instances that store nothing; else 0 */
    /* Required: T (N) of every instance. Where L is 0 the direction is undefined: `rate` is 0 there, and only a law
     * with T = 0 at L = 0 is continuous. */
    TinkerStatus (*tension)(TinkerBatch *batch, const double *length, const double *rate, double *tension);
    /* dT/dL (N/m) and dT/drate (N s/m). NULL: the host takes differences. Where T = 0 at L = 0, dT/dL there is the
     * stiffness in every direction. */
    TinkerStatus (*derivatives)(TinkerBatch *batch, const double *length, const double *rate, double *by_length,
                                double *by_rate);
    /* Stored energy (J), whose derivative by L is T at rate 0. NULL: nothing is stored. What remains,
     * (T - T at rate 0) * rate, is booked as taken by dampers. */
    TinkerStatus (*energy)(TinkerBatch *batch, const double *length, double *stored);
    /* T = tension + stiffness * (L - length) + damping * rate, with constants (a spring: length is its rest length,
     * tension is 0): the host then merges the law with the others between the same ends and calls nothing in the loop.
     * Answers TINKER_RETRY_SMALLER where an instance is not linear; all of the type then go through `tension`. */
    TinkerStatus (*linear)(TinkerBatch *batch, double *stiffness, double *damping, double *length, double *tension);
    /* The next time after batch->time at which a derivative of the law jumps, INFINITY for none. Waveforms are
     * looked after by the host. */
    double (*next_break)(TinkerBatch *batch);
} TinkerLineLaw;

/* Force element -------------------------------------------------------------------------------------------------- */

/* n ends to n forces. Ends are laid out instance by instance: with e ends each, end k of instance i is at i * e + k;
 * where the number differs, at end_offsets[i] + k. */
typedef struct TinkerForceElement {
    uint32_t struct_size;
    int32_t angles; /* 1: depends on angles or gives torques: `force` and `energy` have batch->poses, and `force` writes
                       batch->angular[end], the torque on what each end is on, beside its forces; else 0 */
    /* Required: writes force[2 * end] and force[2 * end + 1] (N), the force on each end. */
    TinkerStatus (*force)(TinkerBatch *batch, const TinkerPoint *ends, double *force);
    /* Stored energy (J) of every instance, of which the position-dependent part of the force is minus the gradient.
     * NULL: nothing is stored and all of the power is booked as given by motors. */
    TinkerStatus (*energy)(TinkerBatch *batch, const TinkerPoint *ends, double *stored);
    /* Where the force on each end does not depend on the ends: force = constant + value of the waveform * direction.
     * Writes constant[2 * end], direction[2 * end] and the first column of the waveform, or -1, per instance. What it
     * writes for angles is 0 then, and it does not depend on them.
     * TINKER_RETRY_SMALLER: not of that form. */
    TinkerStatus (*linear)(TinkerBatch *batch, double *constant, double *direction, int32_t *waveform_column);
    double (*next_break)(TinkerBatch *batch); /* as for a line law */
    int32_t dissipates; /* 1: stores nothing, and what it takes is booked as taken by dampers; else 0 */
    int32_t reserved;
    /* Blows: impulses that act at an instant, which joints and contacts answer to as to an impact; no step crosses one,
     * and what they give is booked as given by motors. The next instant after batch->time at which an instance strikes,
     * INFINITY for none. Asked with a time before 0 first: a blow at 0 acts before the first sample. NULL: there are
     * none. */
    double (*next_blow)(TinkerBatch *batch);
    /* Required beside next_blow: writes impulse[2 * end] and impulse[2 * end + 1] (N s), what is given to each end at
     * batch->time, 0 by instances that do not strike then; with `angles`, batch->angular[end] (N m s) as well. The ends
     * are as they are before it. */
    TinkerStatus (*blow)(TinkerBatch *batch, const TinkerPoint *ends, double *impulse);
    /* Where an instance gives no forces, but torques that are linear in the angles of its ends:
     *     stiffness * (theta_2 - theta_1 - rest) + damping * (omega_2 - omega_1) + value of the waveform
     * on the first, and the opposite on the second; of one end alone, the value of the waveform. Writes stiffness
     * (N m/rad), damping (N m s/rad), rest (rad) and the first column of the waveform, or -1, per instance.
     * TINKER_RETRY_SMALLER: not of that form. */
    TinkerStatus (*torsion)(TinkerBatch *batch, double *stiffness, double *damping, double *rest,
                            int32_t *waveform_column);
} TinkerForceElement;

/* Field ---------------------------------------------------------------------------------------------------------- */

/* All bodies that can move, in a fixed order. */
typedef struct TinkerBodies {
    uint32_t struct_size;
    int32_t count;
    const TinkerPoint *points; /* centres */
    const double *masses;      /* kg */
    int32_t first;             /* the range whose forces are wanted */
    int32_t range;
} TinkerBodies;

/* The law of a field that is linear in each body's own velocity:
 * force on a body = mass * acceleration + force - drag * v. */
typedef struct TinkerLinearField {
    double acceleration[2]; /* m/s^2: conservative, with the potential energy -mass * acceleration . x */
    double force[2];        /* N: booked as given by fields */
    double drag;            /* N s/m: booked as given by fields */
} TinkerLinearField;

/* Sees the kinematics of all bodies, read-only, and acts on each: gravity, wind, an attraction. */
typedef struct TinkerField {
    uint32_t struct_size;
    /* 1 where the force on a body depends on other bodies, which ties them into one island; else 0 */
    int32_t couples_bodies;
    /* Required: writes force[2 * i], force[2 * i + 1] for the bodies bodies->first + i, i < bodies->range: the sum over
     * all instances of the batch. */
    TinkerStatus (*force)(TinkerBatch *batch, const TinkerBodies *bodies, double *force);
    /* Potential energy (J), one number for all bodies and all instances. NULL: none; the power is booked as given by
     * fields. */
    TinkerStatus (*energy)(TinkerBatch *batch, const TinkerBodies *bodies, double *potential);
    /* Writes the law of each instance, every member of it; TINKER_RETRY_SMALLER: not of that form. */
    TinkerStatus (*linear)(TinkerBatch *batch, TinkerLinearField *law);
    double (*next_break)(TinkerBatch *batch); /* as for a line law */
    /* Writes jacobian[8 * i ...] for the bodies of the range: d force / d(x, y) row by row, then d force / d(vx, vy),
     * of the body's own state. NULL: differences. */
    TinkerStatus (*derivatives)(TinkerBatch *batch, const TinkerBodies *bodies, double *jacobian);
} TinkerField;

/* Constraint ----------------------------------------------------------------------------------------------------- */

/* Rows g(x, t) = 0 over the ends of an instance. g has the unit of length where its multiplier is a force: a rod has
 * g = L - length, and its multiplier is minus its tension. Ends on supports are ends like the others: the host knows
 * how they move. */
typedef struct TinkerConstraint {
    uint32_t struct_size;
    int32_t rows;       /* rows of each instance, at least 1 */
    int32_t unilateral; /* 1: the rows say g <= 0 (a rope); else 0 */
    /* 1 or 2: a joint of two ends, errors of whose rows are measured against the scene's extent. 1: its first two rows
     * are the two components of one vector. Else 0. */
    int32_t joint;
    /* Required. Row r of instance i is at i * rows + r; its Jacobian over the ends at
     * jacobian[2 * ((i * rows + r) * ends + k)], as d g / d x_k and d g / d y_k. (Where the number of ends differs,
     * row r of instance i starts at 2 * (rows * end_offsets[i] + r * ends of i).)
     * drift[row] is the part of d2g/dt2 without accelerations: (dJ/dt) v + d2g/dt2 of what is prescribed. */
    TinkerStatus (*rows_at)(TinkerBatch *batch, const TinkerPoint *ends, double *g, double *jacobian, double *drift);
    /* dg/dt of what is prescribed (a waveform), with the places held. NULL: 0. */
    TinkerStatus (*prescribed_rate)(TinkerBatch *batch, const TinkerPoint *ends, double *rate);
    /* The length (m) that an error of each row is measured against: a rod's own; of a row in rad, 1. NULL: the largest
     * distance between its ends. Of a constraint with one end, about a place that is a property, it is also the extent
     * of the motion, which steps and forecasts go by: tell it. */
    TinkerStatus (*scale)(TinkerBatch *batch, double *length);
    /* Checks the properties, once before a run. TINKER_FAILED names the instance. */
    TinkerStatus (*check)(TinkerBatch *batch);
    double (*next_break)(TinkerBatch *batch); /* as for a line law */
    /* Where every row says g = L - length between its two ends, with a constant length (m): the length of each
     * instance; the host then works the rows out itself and calls nothing in the loop. For one row an instance, with
     * nothing prescribed. TINKER_RETRY_SMALLER: not of that form; all of the type then go through rows_at. */
    TinkerStatus (*distance)(TinkerBatch *batch, double *length);
    /* 1: the rows depend on how what the ends are on is turned. `rows_at` and `prescribed_rate` then have batch->poses,
     * and `rows_at` writes the third column of each end, d g / d angle (m), to
     * batch->angular[(i * rows + r) * ends + k] (where the number of ends differs, row r of instance i starts at
     * rows * end_offsets[i] + r * ends of i). A row of angles alone may be in rad: its multiplier is a torque. Else
     * 0. */
    int32_t angles;
    /* 1: the two rows of each instance keep its two ends at one place, g = (x_2 - x_1, y_2 - y_1), with nothing
     * prescribed; the host then works the rows out itself and calls nothing in the loop. Else 0. */
    int32_t coincident;
    /* Where the last row of an instance says that a constant combination of how far its ends have been turned since
     * they were placed is 0, g = sum of factors[end] * (theta - theta as placed): writes these factors. Two rows that
     * come before it keep its two ends at one place. TINKER_RETRY_SMALLER: not of that form. */
    TinkerStatus (*turning)(TinkerBatch *batch, double *factors);
    /* Where the two rows of each instance hold its two ends together and leave their turning free: friction resists it
     * with a torque of up to this arm (m), not negative, times the magnitude of the two multipliers; it holds exactly
     * what does not turn. Writes the arm of each instance, 0 for none, once before a run. Its torque is
     * TinkerGraphInput.torques. NULL: none. */
    TinkerStatus (*friction)(TinkerBatch *batch, double *arm);
} TinkerConstraint;

/* Motion --------------------------------------------------------------------------------------------------------- */

/* Moves the body at its one end, which must have no degrees of freedom: displacement from its place, and its exact
 * first and second derivatives; or turns it about its centre. Several motions of one body add up. */
typedef struct TinkerMotion {
    uint32_t struct_size;
    int32_t reserved;
    /* Writes x and y, instance by instance. Required, unless there is `rotation`; NULL: it is not displaced. */
    TinkerStatus (*motion)(TinkerBatch *batch, double *displacement, double *velocity, double *acceleration);
    /* Where displacement = value of a waveform * direction: the direction, and the waveform's first column.
     * TINKER_RETRY_SMALLER: not of that form. */
    TinkerStatus (*linear)(TinkerBatch *batch, double *direction, int32_t *waveform_column);
    double (*next_break)(TinkerBatch *batch); /* as for a line law */
    /* Writes how far each instance turns the body from its orientation, counter-clockwise, and the exact first and
     * second derivatives of that. NULL: it is not turned. */
    TinkerStatus (*rotation)(TinkerBatch *batch, TinkerPose *rotation);
} TinkerMotion;

/* The interface -------------------------------------------------------------------------------------------------- */

typedef struct TinkerPhysics {
    uint32_t struct_size;
    int32_t scratch_size; /* bytes that the host allots per type, 0 for none */
    const TinkerBody *body;
    const TinkerLineLaw *line_law;
    const TinkerForceElement *force_element;
    const TinkerField *field;
    const TinkerConstraint *constraint;
    const TinkerMotion *motion;
    /* Fills the scratch and checks the properties of all instances, once before a run. */
    TinkerStatus (*prepare)(TinkerBatch *batch);
} TinkerPhysics;

#ifdef __cplusplus
}
#endif
#endif
