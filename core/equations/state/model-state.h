/* The state of a run at one time, with all forces: what equations, diagrams and books are made from. */
#ifndef TINKER_CORE_MODEL_STATE_H
#define TINKER_CORE_MODEL_STATE_H

#include "physics/run/acting-forces.h"
#include "physics/run/simulation.h"

/* Forces, moments, and what they give, below this share of the greatest that act with them are what rounding leaves,
 * and shown as 0. */
#define TINKER_FORCE_NOTHING 1e-12

typedef struct {
    TinkerBlockId block;
    TinkerBodySample at;
    double acceleration[2];                   /* m/s^2, by the record; where it has none, by the forces */
    gboolean turns;                           /* a body that turns has besides, by the record: */
    double angle, rate, angular_acceleration; /* rad, rad/s, rad/s^2; else 0 */
} TinkerBodyState;

typedef struct {
    double time;     /* s */
    GArray *bodies;  /* of TinkerBodyState, in the order of the scene */
    GArray *forces;  /* of TinkerActingForce */
    GArray *touches; /* of TinkerActingTouch */
} TinkerModelState;

/* The columns that a run is to have for that: the accelerations of all bodies. (transfer full) */
GArray *tinker_model_state_columns(TinkerScene *scene);

/* Inside a sample function of a simulation of this model with these columns: takes the state there. (transfer full) */
TinkerModelState *tinker_model_state_take(TinkerSimulation *simulation, TinkerModel *model, TinkerScene *scene,
                                          double time, const double *values, GError **error);
void tinker_model_state_free(TinkerModelState *state);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerModelState, tinker_model_state_free)

/* NULL for a block that is no body that can move. */
const TinkerBodyState *tinker_model_state_find(const TinkerModelState *state, TinkerBlockId block);
const TinkerBodySample *tinker_model_state_body(const TinkerModelState *state, TinkerBlockId block);

/* The moment of a force about the centre of the body it acts on (N m). */
double tinker_model_state_moment(const TinkerModelState *state, const TinkerActingForce *acting);

/* What rounding alone may leave of a force on a body (N), or of a moment about its centre (N m). */
double tinker_model_state_nothing(const TinkerModelState *state, TinkerBlockId body, gboolean moment);

/* The sum of what `by` does to `on` (-1: to any block): force, and moment about the centre of each body. FALSE where
 * there is nothing. */
gboolean tinker_model_state_force(const TinkerModelState *state, TinkerBlockId by, TinkerBlockId on, double force[3]);

/* What a block does at one of its ends: force, and torque beside that, or (where not NULL) about a place. FALSE where
 * there is nothing. */
gboolean tinker_model_state_end_force(const TinkerModelState *state, TinkerBlockId by, int32_t end,
                                      const double about[2], double force[3]);

#endif
