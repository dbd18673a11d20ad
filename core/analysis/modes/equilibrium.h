/* The rest state: where forces and constraints balance. */
#ifndef TINKER_CORE_EQUILIBRIUM_H
#define TINKER_CORE_EQUILIBRIUM_H

#include "physics/event/still-contacts.h"
#include "physics/model/model.h"

typedef struct {
    gboolean found;
    int iterations;
    double unbalanced; /* N: the largest force left on a body, constraint forces included */
    char why[256];     /* why none was found */
} TinkerEquilibrium;

/* Moves the places q (2 a body, relative to the model's origin) of a held model downhill to rest, by Newton steps along
 * its modes: each by force / |square|, so that they lead away from unstable places, held within a radius that shrinks
 * where a step would have to be pushed. A state that starts in balance stays, stable or not. None is found where forces
 * grow without bound as bodies fall into one place, or a line pulls with both ends at one place. Where none is found q
 * is as before. With `contacts` (NULL: none) steps end where something is touched, and bodies move along what they
 * press on; what acts at the rest is closed in the model. FALSE with an error where forces cannot be worked out. */
gboolean tinker_equilibrium_find(TinkerModel *model, TinkerStillContacts *contacts, double *q,
                                 TinkerEquilibrium *result, GError **error);

#endif
