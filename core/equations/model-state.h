/* The state of a run at one time, with all forces: what equations, diagrams and books are made from. */
#ifndef TINKER_CORE_MODEL_STATE_H
#define TINKER_CORE_MODEL_STATE_H

#include "physics/run/acting-forces.h"
#include "physics/run/simulation.h"

typedef struct {
    TinkerBlockId block;
    TinkerBodySample at;
    double acceleration[2]; /* m/s^2, by the record; where it has none, by the forces */
} TinkerBodyState;

typedef struct {
    double time;    /* s */
    GArray *bodies; /* of TinkerBodyState, in the order of the scene */
    GArray *forces; /* of TinkerActingForce */
} TinkerModelState;

/* The columns that a run is to have for that: the accelerations of all bodies. (transfer full) */
GArray *tinker_model_state_columns(TinkerScene *scene);

/* Inside a sample function of a simulation of this model with these columns: takes the state there. (transfer full) */
TinkerModelState *tinker_model_state_take(TinkerSimulation *simulation, TinkerModel *model, TinkerScene *scene,
                                          double time, const double *values, GError **error);
void tinker_model_state_free(TinkerModelState *state);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerModelState, tinker_model_state_free)

/* NULL for a block that is no body that can move. */
const TinkerBodySample *tinker_model_state_body(const TinkerModelState *state, TinkerBlockId block);

/* The sum of what `by` does to `on` (-1: to any block), of one kind (-1: of any). FALSE where there is nothing. */
gboolean tinker_model_state_force(const TinkerModelState *state, TinkerBlockId by, TinkerBlockId on, int kind,
                                  double force[2]);

#endif
