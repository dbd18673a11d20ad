/* A forecast of an island's motion from its start: which frequencies it contains, and how fast the fastest are. Bounded
 * by about thirty products with vectors.
 *
 * On small displacements u from the equilibrium, M a = -K u, so a mode of frequency omega that the start's acceleration
 * contains with a_k holds the energy a_k^2 / (2 omega^2), constant loads included, and one that the velocity contains
 * with v_k holds v_k^2 / 2. The spectral measures of both vectors (numerics/eigen.h) give these energies without any
 * mode being worked out; up to TINKER_FORECAST_STEPS coordinates they are exact. Beyond, slow modes that a local load
 * reaches far away are not seen; the energy that all of them hold together is, by one solve, and is put down to the
 * frequency of their common displacement. */
#ifndef TINKER_CORE_FORECAST_H
#define TINKER_CORE_FORECAST_H

#include "physics/line/linear-form.h"
#include "physics/plan/islands.h"

#define TINKER_FORECAST_STEPS 10

typedef struct {
    double omega;   /* rad/s */
    double damping; /* 1/s: of x'' + damping x' + omega^2 x = 0 */
    double share;   /* of the energy, 0 to 1 */
    double reach;   /* likewise of the squares of displacements; 0 where nothing holds it */
} TinkerForecastPart;

typedef struct {
    gboolean known;         /* else nothing could be worked out */
    gboolean turned;        /* forces act across velocities */
    double omega_max;       /* rad/s: from below, but for what forces across velocities add, which is from above */
    double damping_max;     /* 1/s: largest damping over mass, from below */
    double speed_of_change; /* rad/s: how fast the state changes whatever the stiffness: sqrt(a / extent), v / extent */
    double drive;           /* rad/s: fastest harmonic input; 0 */
    double fading;          /* 1/s: how fast motion that nothing holds is slowed down; 0 where nothing slows it */
    double turning;         /* rad/s: of a motion that is not linear, which no mode at the start knows of; else 0 */
    int32_t count;
    TinkerForecastPart parts[2 * TINKER_FORECAST_STEPS + 1];
} TinkerForecast;

/* The fastest harmonic input (rad/s) of a linear form; 0 for none, and for NULL. */
double tinker_forecast_drive(const TinkerLinearForm *form);

void tinker_forecast(const TinkerIsland *island, TinkerForecast *forecast);

#endif
