/* A model made linear about a state at which everything is held still: M x'' + C x' + K x = 0 on J x = 0.
 *
 * K and C are kept as sums of parts of rank one, weight * b b^T, as springs, dampers and constraint forces give them:
 * added up in a matrix, a spring of 1 N/m beside one of 1e12 N/m would lose its digits. K holds -df/dq, and of the
 * constraint forces -d(J^T lambda)/dq, whose second derivatives of g are differences of order 6 of the constraints' own
 * Jacobians. Velocities count as 0, of supports too: what a moving support does at t = 0 is where it is, not how fast
 * it goes. */
#ifndef TINKER_CORE_LINEARISE_H
#define TINKER_CORE_LINEARISE_H

#include "physics/model/model.h"

/* One component of b. The first coordinates are those of the model; 2 p + k, where that is beyond them, is the x (k =
 * 0) or y (k = 1) of the point p of a support. */
typedef struct {
    int32_t coordinate;
    double value;
} TinkerLinearEntry;

typedef struct {
    double weight; /* N/m, N s/m; 1 for a constraint's row */
    guint first;   /* of its entries */
    guint count;
} TinkerLinearTerm;

typedef struct {
    int32_t size;            /* coordinates of bodies */
    int32_t coordinates;     /* of all points */
    double *mass;            /* size */
    GArray *entries;         /* of TinkerLinearEntry */
    GArray *stiffness;       /* of TinkerLinearTerm */
    GArray *rounding;        /* of TinkerLinearTerm: stiffness of forces that are rounding, which counts as none */
    GArray *damping;         /* of TinkerLinearTerm */
    GArray *rows;            /* of TinkerLinearTerm: J, of the constraints that are tight and the closed contacts */
    double *other_stiffness; /* size by size, column by column: what is no line and no constraint; NULL: nothing */
    double *other_damping;
    double *force;           /* size, N: applied and constraint forces together, 0 at an equilibrium */
    double force_scale;      /* N: the largest single force; */
    double force_noise;      /* N: what rounding of the places makes of it */
    double extent;           /* m: of the model */
    int32_t undefined_pulls; /* lines whose ends are at one place, where their pull has no derivative: left out of K */
    int32_t undefined_dampers; /* and whose resistance has none: left out of C */
    int32_t rubbing_pins;      /* joints with friction, which is left out */
} TinkerLinearisation;

/* Holds the model still: supports stand where they are at t = 0, and of forces with a waveform acts what is steady
 * (units/waveform/waveform.h), for what varies is forcing. Everything below works on a model that is held, and on
 * places relative to its origin. It is not to be run any more: its supports have lost their velocities. */
TinkerStatus tinker_model_hold(TinkerModel *model);

/* The length (m) of what is off the body that a block is wound on, with the bodies at these places; NAN where it is not
 * wound. */
double tinker_model_held_length(TinkerModel *model, const double *q, TinkerBlockId block);

/* About these places (by coordinate). NULL with TINKER_MODEL_ERROR_RUN where a force cannot be worked out there.
 * (transfer full) */
TinkerLinearisation *tinker_linearise(TinkerModel *model, const double *q, GError **error);
void tinker_linearisation_free(TinkerLinearisation *linear);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerLinearisation, tinker_linearisation_free)

/* The start places and velocities, as the constraints have them (2 entries a body); the bodies' blocks; the origin that
 * places are relative to. */
void tinker_model_start_places(const TinkerModel *model, double *q);
void tinker_model_start_velocities(const TinkerModel *model, double *v);
TinkerBlockId tinker_model_body_block(const TinkerModel *model, int32_t body);
/* The coordinate that a body turns by, which is its angle times *radius (m); -1 where it does not turn. */
int32_t tinker_model_body_turn(const TinkerModel *model, int32_t body, double *radius);
void tinker_model_origin(const TinkerModel *model, double origin[2]);

/* Brings places onto the constraints. FALSE where there is no way there. */
gboolean tinker_model_meet_constraints(TinkerModel *model, double *q);

#endif
