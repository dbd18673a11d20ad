/* Assembling: where bodies stand at t = 0 once what joins them fits, and how they move then. */
#ifndef TINKER_CORE_ASSEMBLE_H
#define TINKER_CORE_ASSEMBLE_H

#include "scene/store/scene.h"

/* A body, or a support, that somebody has in hand: what is held of it moves last, whatever its mass. */
typedef struct {
    TinkerBlockId block;
    gboolean place, orientation;
    gboolean rate; /* velocities are brought onto what joins, too */
} TinkerHeldBody;

/* Where a body stands then. */
typedef struct {
    TinkerBlockId block;
    double place[2];    /* m */
    double orientation; /* rad; of a body that turns, as is the rate */
    double velocity[2]; /* m/s; as given, unless the rate is held */
    double rate;        /* rad/s */
    gboolean turns;
} TinkerAssembledBody;

/* Brings the bodies that are joined to `held`, directly or by others, onto what joins them, each moved as little as its
 * mass and its inertia weigh: joints and lengths that are given. Lengths as placed, ropes, and what a waveform drives
 * leave them free. Answers all these bodies, `held` among them; none where nothing joins it. The scene is left as it
 * is. NULL: there is no such place within reach. Of TinkerAssembledBody. (transfer full) */
GArray *tinker_assemble(TinkerScene *scene, const TinkerHeldBody *held, GError **error);

#endif
