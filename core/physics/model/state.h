/* Bringing a compiled model to a time and a state. All q and v are relative to the origin. */
#ifndef TINKER_CORE_STATE_H
#define TINKER_CORE_STATE_H

#include "numerics/sharing/sharing.h"
#include "physics/model/model-data.h"

/* Brings the model to a time that is another one than the present. */
TinkerStatus tinker_model_change_time(TinkerModel *model, double t);

/* Brings waveforms, moving supports and their points to time t; does nothing where they are there already. Called
 * several times an evaluation, so without a call. */
static inline TinkerStatus tinker_model_set_time(TinkerModel *model, double t)
{
    return t == model->time ? TINKER_OK : tinker_model_change_time(model, t);
}

/* Packs q and v into the points: of many bodies, shared among threads, or of some that turn. */
void tinker_model_share_state(TinkerModel *model, const double *q, const double *v);

/* Packs q and v into the points. */
static inline void tinker_model_set_state(TinkerModel *model, const double *q, const double *v)
{
    TinkerPoint *point = model->point;
    if (G_UNLIKELY(model->bodies >= TINKER_SHARE_LEAST || model->turning > 0)) {
        tinker_model_share_state(model, q, v);
        return;
    }
    for (int32_t i = 0; i < model->bodies; i++)
        point[i] = (TinkerPoint){q[2 * i], q[2 * i + 1], v[2 * i], v[2 * i + 1]};
}

/* Places alone; and velocities alone, of places that were set before. */
void tinker_model_set_places(TinkerModel *model, const double *q);
void tinker_model_set_velocities(TinkerModel *model, const double *v);

#endif
