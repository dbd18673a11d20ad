/* What a typed law does to energy. It is looked for when it is first asked for: most laws are made for a look at the
 * scene, where nobody does. */
#ifndef TINKER_CORE_TYPED_ENERGY_H
#define TINKER_CORE_TYPED_ENERGY_H

#include "units/compiled/compiled.h"

typedef struct {
    TinkerExpression *laws[2]; /* the law itself, or of two forces that of x and that of y; NULL: none is typed */
    const char *const *names;  /* of its arguments, which outlive it */
    int count;
} TinkerEnergySource;

/* What is found: one of both, or neither where it stores none that is known. */
typedef struct {
    TinkerCompiled *compiled;                                                    /* over its arguments */
    double (*summed)(const struct TinkerTypedLaw *law, const double *arguments); /* by a sum of its values */
} TinkerStoredEnergy;

typedef TinkerStoredEnergy (*TinkerFindEnergyFunc)(const struct TinkerTypedLaw *law, const TinkerEnergySource *source);

/* Keeps what a law is compiled from, over these arguments, which outlive it; and that, NULL where nothing was kept.
 * Both are borrowed. */
void tinker_typed_keep(struct TinkerTypedLaw *law, const TinkerExpression *is, const char *const *names);
TinkerExpression *tinker_typed_is(const struct TinkerTypedLaw *law);

/* Tells how the energy of a law that was kept is found, of which none is known otherwise: from these expressions, which
 * are borrowed. */
void tinker_typed_set_energy(struct TinkerTypedLaw *law, TinkerFindEnergyFunc find, TinkerExpression *const laws[2]);

/* Whether it stores energy; how much, NAN where that is not known. The first of these calls needs memory; any thread
 * may ask. */
gboolean tinker_typed_stores(const struct TinkerTypedLaw *law);
double tinker_typed_stored(const struct TinkerTypedLaw *law, const double *arguments);

/* Of tinker_typed_free. */
void tinker_typed_energy_free(TinkerTypedEnergy *energy);

#endif
