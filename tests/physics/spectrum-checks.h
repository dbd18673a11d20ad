/* What the tests of spectra share: compiled scenes, chains, and the limit that is observed when the method itself steps
 * the scene. */
#ifndef TEST_SPECTRUM_CHECKS_H
#define TEST_SPECTRUM_CHECKS_H

#include "physics-fixture.h"
#include "physics/plan/islands.h"
#include "physics/plan/plan.h"

/* A compiled scene of one island. */
typedef struct {
    TinkerScene *scene;
    TinkerModel *model;
    GPtrArray *islands;
} SpectrumCase;

/* The text as of physics-fixture.h. To be cleared. */
SpectrumCase spectrum_case(const char *blocks);
void spectrum_case_clear(SpectrumCase *compiled);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SpectrumCase, spectrum_case_clear)

const TinkerIsland *spectrum_case_island(const SpectrumCase *compiled);

/* The longest stable step (s) that is forecast. */
double spectrum_limit(const TinkerSpectrum *spectrum, const TinkerIntegrator *method);

/* The forecast is within 5 % of the limit: 5 % below it nothing grows, 5 % above it does. `rate` in 1/s: of the fastest
 * motion. */
void spectrum_assert_limit(const TinkerIsland *island, const TinkerSpectrum *spectrum, const TinkerIntegrator *method,
                           double rate, const char *what);
/* Of every explicit method of fixed steps. */
void spectrum_assert_limits(const TinkerIsland *island, const TinkerSpectrum *spectrum, double rate, const char *what);

/* A chain of `count` masses from wall to wall, at rest; dampers where `damping` is not 0, all of them or every third.
 * (transfer full) */
char *spectrum_chain(int count, double mass, double stiffness, double damping, int every);

#endif
