/* Velocity and acceleration of bodies, and the sum of the forces on them, as vectors that are drawn beside the arrows
 * of single forces. */
#ifndef TINKER_HOST_MOTION_VECTORS_H
#define TINKER_HOST_MOTION_VECTORS_H

#include "physics/run/acting-forces.h"
#include "physics/run/simulation.h"
#include "render/draw/view.h"
#include "render/picture/arrows.h"
#include "scene/frame/frame.h"

typedef enum { TINKER_VECTOR_VELOCITY, TINKER_VECTOR_ACCELERATION, TINKER_VECTOR_NET_FORCE } TinkerVectorKind;
#define TINKER_VECTOR_KINDS (TINKER_VECTOR_NET_FORCE + 1)

typedef struct {
    TinkerBlockId of;
    TinkerVectorKind kind;
    double x, y;             /* m: where it starts, the body's centre */
    double value_x, value_y; /* m/s, m/s^2 or N */
} TinkerMotionVector;

/* Whether a block is a body that can move. */
gboolean tinker_block_moves(TinkerScene *scene, TinkerBlockId block);

/* Which kinds are wanted. */
typedef struct {
    gboolean kinds[TINKER_VECTOR_KINDS];
} TinkerVectorChoice;

gboolean tinker_vector_choice_any(const TinkerVectorChoice *choice);

/* What a kind looks like: its arrow's, its sign before the value ("v"), its word, its dimension. */
typedef struct {
    TinkerArrowKind arrow;
    const char *sign, *word; /* static; the word is not translated yet */
    TinkerDimension dimension;
} TinkerVectorLook;
const TinkerVectorLook *tinker_vector_look(TinkerVectorKind kind);

/* Element: TinkerMotionVector. (transfer full) */
GArray *tinker_motion_vectors_array(void);

/* Adds the net force and the acceleration of every body that can move, as far as they are wanted, from all forces that
 * act (TinkerActingForce) at the frame's time: the acceleration is their sum over the body's mass. */
void tinker_motion_vectors_add_forces(GArray *vectors, TinkerFrame *frame, const GArray *acting,
                                      const TinkerVectorChoice *wanted);

/* Adds a body's velocity (m/s). */
void tinker_motion_vectors_add_velocity(GArray *vectors, TinkerFrame *frame, TinkerBlockId body, double vx, double vy);

/* Adds the velocity of every body that moves, inside a sample function of a simulation. */
void tinker_motion_vectors_add_velocities(GArray *vectors, TinkerFrame *frame, TinkerSimulation *simulation);

/* Raises the greatest magnitude of each kind (SI) by those of these vectors. */
void tinker_motion_vectors_measure(const GArray *vectors, double greatest[TINKER_VECTOR_KINDS]);

/* Canvas units per SI unit at which the greatest magnitude is well seen; `previous` as in tinker_arrows_scale, 0: none.
 * 0 where all are 0. */
double tinker_motion_vectors_scale(double greatest, const TinkerView *view, double previous);

#endif
