/* Laws of impact for several contacts that close at once, of which Newton's (contact-laws.h) is one. For a single
 * contact without friction they are the same.
 *
 * Poisson's: in a first phase approaching contacts are brought to rest, by impulses p; in a second they push themselves
 * apart by at least e p. In sequence: the pair that approaches fastest strikes by Newton's law as if nothing else
 * touched, then the one that approaches fastest then, until none does. In both what lay at rest rebounds, too, as soon
 * as something else drives it together (`driven` in TinkerImpact).
 *
 * Sources: C. Glocker, F. Pfeiffer, "Multibody Dynamics with Unilateral Contacts" (1996), ch. 8 (Newton's and Poisson's
 * laws); Y.-B. Jia, M. T. Mason, M. A. Erdmann, "Multiple impacts: A state transition diagram approach", Int. J.
 * Robotics Research 32 (2013) 84-114 (impacts in sequence). */
#ifndef TINKER_NUMERICS_IMPACT_LAW_H
#define TINKER_NUMERICS_IMPACT_LAW_H

#include "numerics/contact/contact-laws.h"

/* As scenes name them. */
typedef enum {
    TINKER_IMPACT_NEWTON,
    TINKER_IMPACT_POISSON,
    TINKER_IMPACT_SEQUENTIAL,
    TINKER_IMPACT_LAWS,
} TinkerImpactLaw;

/* Writes the impulses (2m) of an impact without `least`. `pair` (m): contacts of one pair of bodies, which strike
 * together, have one number. No law adds energy: where Poisson's would, all coefficients of restitution are taken as
 * smaller by one common factor. Of very many contacts, which have no matrix, Newton's law is all that is worked out. */
TinkerContactResult tinker_impact_by_law(TinkerImpactLaw law, const TinkerImpact *impact, const int32_t *pair,
                                         double *impulses);

#endif
