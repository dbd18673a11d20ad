/* The energy books of a run: what the state holds, what was given and taken, and how far the two disagree. */
#ifndef TINKER_CORE_BOOKS_H
#define TINKER_CORE_BOOKS_H

#include "physics/force/forces.h"
#include "physics/system/summary.h"
#include "physics/system/system.h"

typedef struct {
    TinkerModelSystem *system;
    TinkerEnergy start;
    double world_offset; /* J: potential relative to the world's origin less that relative to the model's */
    double exchanged;    /* J: the largest energy moved so far */
    double missing;      /* J: largest */
    double
        imbalance; /* of the last look, relative to what is exchanged; only what is gained where losses are allowed */
    gboolean allows_loss; /* the method dissipates on purpose */
    double forces;        /* N: the largest sum of applied forces on all bodies so far */
} TinkerBooks;

/* The potential of bodies relative to the world's origin less that relative to the model's (J). */
double tinker_books_potential_of_origin(const TinkerModel *model);

/* Opens the books at the model's start. */
TinkerStatus tinker_books_open(TinkerBooks *books, TinkerModelSystem *system);

/* Looks at a state of the model's bodies with its integrals; updates the balance and fills `summary`'s energies.
 * `extent` (m) of the motion so far is what rounding is measured against at rest. */
TinkerStatus tinker_books_look(TinkerBooks *books, const TinkerState *state, double extent, TinkerSummary *summary);

#endif
