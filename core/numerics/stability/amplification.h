/* What one step of a fixed-step method does to a damped oscillator x'' = -stiffness x - damping x': a linear map of
 * (x, x'), found by stepping the oscillator with the method's own functions, so that it is known of every method there
 * is.
 *
 * A Runge-Kutta method treats all parts of a state alike, and its map has the eigenvalues R(h lambda). One that treats
 * places and velocities differently has not: Verlet is stable for h omega <= 2 whatever the damping. */
#ifndef TINKER_CORE_AMPLIFICATION_H
#define TINKER_CORE_AMPLIFICATION_H

#include <glib.h>

#include <tinker/integrator.h>

typedef struct {
    double stiffness; /* 1/s^2: omega^2 */
    double damping;   /* 1/s */
} TinkerOscillator;

/* The map of one step, row by row: (x, v) becomes (map[0] x + map[1] v, map[2] x + map[3] v). FALSE where the method
 * cannot take the step. `spectral_radius` is that of a dissipative method. */
gboolean tinker_amplification(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator,
                              double step, double map[4]);

/* The larger eigenvalue of such a map, its amount: what the oscillator's swing is multiplied by at a step, in the long
 * run. */
double tinker_map_growth(const double map[4]);

/* What an oscillator's swing is multiplied by at a step of a method whose step also depends on those before
 * (generalized-alpha), from many steps in a row: good to about a percent. INFINITY where the method cannot take the
 * step. */
double tinker_long_run_growth(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator,
                              double step);

/* The largest step below which every step is stable for all of these oscillators: no eigenvalue of the map is larger
 * than 1. INFINITY where nothing limits it, 0 where no step is stable. Negative stiffness and damping count as 0: what
 * grows of its own accord limits no step. */
double tinker_stable_step_of_all(const TinkerIntegrator *method, double spectral_radius,
                                 const TinkerOscillator *oscillators, gsize count);

/* The largest difference from the exact motion at any time up to `duration`, relative to the energy norm of the start:
 * |(x, v)|^2 = omega^2 x^2 + v^2. INFINITY where the method cannot take the step. */
double tinker_step_error(const TinkerIntegrator *method, double spectral_radius, TinkerOscillator oscillator,
                         double step, double duration);

#endif
