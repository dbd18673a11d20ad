/* The spectrum of an island, linearised about its start: M u'' + C u' + K u = 0 on the tangent space of its
 * constraints, the stiffness that tensions of constraints give included.
 *
 * Up to TINKER_DENSE_SPECTRUM coordinates all eigenvalues (LAPACK), beyond that the extreme ones (ARPACK, by products);
 * where dampers couple the modes the extreme ones earlier. Explicit methods are limited by two lists: those that treat
 * all of a state alike by the eigenvalues of z' = A z; those that treat places and velocities differently by pairs (u.K
 * u, u.C u) for unit vectors u, of which the extreme ones are kept. For semi-implicit Euler this is exact where K and C
 * are symmetric and C takes energy: with q_k = (-1)^k u it is at its edge where (h^2 K + 2 h C) u = 4 M u; for Verlet
 * where h^2 K u = 4 M u, whatever C is. Where forces act across velocities (Coriolis's, a magnet's; C is not symmetric)
 * no such pairs say enough, and the method itself steps K and C. */
#ifndef TINKER_CORE_SPECTRUM_H
#define TINKER_CORE_SPECTRUM_H

#include "numerics/stability/amplification.h"
#include "numerics/stability/coupled.h"
#include "physics/plan/islands.h"

#define TINKER_DENSE_SPECTRUM 150

/* One pair (or real value) of the linearised island's spectrum: z' = (re + i im) z. */
typedef struct {
    double re, im; /* 1/s, rad/s */
} TinkerEigenvalue;

typedef struct {
    gboolean complete;  /* `eigenvalues` are all there are */
    gboolean turned;    /* forces act across velocities */
    double omega_max;   /* rad/s: largest undamped frequency, constraints included; of a turned one largest frequency */
    double damping_max; /* 1/s: largest rate of decay */
    double growth_max;  /* 1/s: largest rate of growth; 0 where the start is stable */
    GArray *eigenvalues;   /* of TinkerEigenvalue; of a pair the one with im > 0 */
    GArray *oscillators;   /* of TinkerOscillator */
    double *fastest;       /* 2 a body: displacements of the fastest undamped mode; NULL where no stiffness makes it */
    double *most_damped;   /* 2 a body: of the shape with the largest damping over mass; NULL where nothing damps */
    TinkerCoupled coupled; /* of a turned one that is small, owned; size 0: not known */
    gboolean falls;        /* and its stiffness is negative in some direction */
} TinkerSpectrum;

/* What cannot be worked out is left empty. (transfer full) */
TinkerSpectrum *tinker_spectrum_new(const TinkerIsland *island);
void tinker_spectrum_free(TinkerSpectrum *spectrum);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerSpectrum, tinker_spectrum_free)

/* The largest step at which a fixed-step method is stable. INFINITY where nothing limits it, 0 where no step is stable,
 * NAN where it is not known: of methods that treat places and velocities differently where forces act across the
 * velocities of many bodies, or of bodies that would fall over without them. */
double tinker_spectrum_stable_step(const TinkerSpectrum *spectrum, const TinkerIntegrator *method,
                                   double spectral_radius);

#endif
