/* What the look for shafts finds (find-shafts.c), and of which their form is made (shafts.c). */
#ifndef TINKER_CORE_SHAFTS_H
#define TINKER_CORE_SHAFTS_H

#include "physics/line/linear-form-data.h"

/* A torsional law between two bodies; -1: a support, or nothing. */
typedef struct {
    int32_t body[2];
    double turned; /* rad: how far it is turned from rest at the start */
    double stiffness, damping;
    const TinkerBlockBatch *batch;
    int32_t column, row; /* of its waveform; column -1: it has none */
} TinkerTorsion;

typedef struct {
    const TinkerModel *model;
    int32_t *geared;  /* by body: sets of those that gears tie together */
    int32_t *parent;  /* by body: sets of those whose weights depend on each other, ... */
    double *ratio;    /* ... and its weight over that of its parent */
    int32_t *coaxial; /* by body: sets of those whose centres are kept in one place, ... */
    gboolean *pinned; /* ... and whether one of the set is pinned: of its first */
    GArray *torsions; /* of TinkerTorsion */
} TinkerShaftLook;

/* Whether the model is one of shafts alone. What was found is to be cleared either way. */
gboolean tinker_find_shafts(const TinkerModel *model, TinkerShaftLook *look);
void tinker_shaft_look_clear(TinkerShaftLook *look);

/* The body that stands for the weights of another, and the other's weight over its. */
int32_t tinker_shaft_weight(TinkerShaftLook *look, int32_t body, double *weight);

#endif
