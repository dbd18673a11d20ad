/* How a spectrum is filled: from all eigenvalues of a small island, or from the extreme ones of a large one. */
#ifndef TINKER_CORE_SPECTRUM_PRIVATE_H
#define TINKER_CORE_SPECTRUM_PRIVATE_H

#include "physics/plan/spectrum.h"
#include "physics/plan/start-matrices.h"

/* Shapes between that of the largest stiffness and that of the largest damping. */
#define SPECTRUM_MIXTURES 5

void spectrum_add_eigenvalue(TinkerSpectrum *spectrum, double re, double im);
void spectrum_add_oscillator(TinkerSpectrum *spectrum, double stiffness, double damping);
/* The roots of s^2 + damping s + stiffness. */
void spectrum_add_roots(TinkerSpectrum *spectrum, double stiffness, double damping);

/* Steps between which the edge of semi-implicit Euler lies, for a largest stiffness and damping: h^2 stiffness + 2 h
 * damping is at least 4 at the largest of them, and at most 4 at the smallest. Last, INFINITY: where damping limits
 * nothing. */
double spectrum_mixture_step(double stiffness, double damping, int number);

/* FALSE where something is not finite or an iteration failed: what was added is void. */
gboolean spectrum_fill_dense(TinkerSpectrum *spectrum, TinkerStartMatrices *matrices, int32_t coordinates);
gboolean spectrum_fill_large(TinkerSpectrum *spectrum, TinkerStartMatrices *matrices, int32_t coordinates);

/* What leaves a start in motion of a small island that is held grows by the stiffness beside that motion: sets the rate
 * (1/s). Steps are limited by the other stiffness: where the motion is all that there is, as of a driven linkage, this
 * one is 0, and has no frequency. Left as it is of a start at rest, where it cannot be had, and where both are slower
 * than differences can tell. */
void spectrum_find_growth_in_motion(TinkerStartMatrices *matrices, double *growth);

#endif
