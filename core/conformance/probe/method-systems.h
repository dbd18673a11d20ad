/* Systems whose motion is known, to try methods on. */
#ifndef TINKER_CONFORMANCE_METHOD_SYSTEMS_H
#define TINKER_CONFORMANCE_METHOD_SYSTEMS_H

#include <tinker/integrator.h>

#define KIT_SYSTEM_SIZE  2
#define KIT_SYSTEM_OMEGA 2.0 /* rad/s: of small motions */

typedef struct {
    const char *name; /* "an oscillator" */
    const TinkerSystem *system;
    void (*exact)(double t, double q[KIT_SYSTEM_SIZE], double v[KIT_SYSTEM_SIZE]);
} KitMotion;

extern const KitMotion kit_oscillator; /* damped, linear */
extern const KitMotion kit_driven;     /* not linear, and without a linear form; its force depends on time */

/* The largest error of a state, relative to an extent of 1 m and KIT_SYSTEM_OMEGA; INFINITY where it is not finite. */
double kit_motion_error(const KitMotion *motion, double t, const double *q, const double *v);

/* One coordinate with a spring, a damper and a mass of 1 kg, with a linear form. It must stay where it is. */
typedef struct {
    TinkerLinearEdge edge;
    TinkerLinearSystem linear;
    TinkerSystem system;
} KitProbe;

void kit_probe_begin(KitProbe *probe, double stiffness, double damping);

/* A point on a rod about the origin; small swings have the frequency KIT_SYSTEM_OMEGA. */
#define KIT_PENDULUM_LENGTH 0.75 /* m */
extern const TinkerSystem kit_pendulum;
/* A start that fits the rod. */
void kit_pendulum_start(double q[KIT_SYSTEM_SIZE], double v[KIT_SYSTEM_SIZE]);

#endif
