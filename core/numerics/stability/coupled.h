/* What one step of a fixed-step method does to coupled oscillators, x'' = -K x - C x': a linear map of (x, x'), found
 * by stepping them with the method's own functions. For matrices that no shapes take apart: where forces act across
 * velocities (Coriolis's, a magnet's), C has an antisymmetric part, and no single damped oscillator (amplification.h)
 * does as they do. */
#ifndef TINKER_CORE_COUPLED_H
#define TINKER_CORE_COUPLED_H

#include <glib.h>

#include <tinker/integrator.h>

/* Of one degree of freedom more, a look costs too much. */
#define TINKER_MOST_COUPLED 12

typedef struct {
    int32_t size;
    const double *stiffness, *damping; /* over mass, size by size, column by column (borrowed) */
    double rate;                       /* 1/s: the fastest of them, about */
    double growth;                     /* 1/s: of their own accord */
} TinkerCoupled;

/* The largest step up to which none that is tried grows beside what grows of its own accord; they are tried at every 2
 * % from 0.01 / rate on, and smaller ones where that grows and damping may help. INFINITY where nothing limits it up to
 * 1e6 / rate, 0 where no step is stable. */
double tinker_coupled_stable_step(const TinkerIntegrator *method, double spectral_radius, const TinkerCoupled *coupled);

#endif
