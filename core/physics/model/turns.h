/* The part of a state that belongs to bodies that turn: their angles, and where these put what is attached to them. The
 * centres of the bodies are set before (state.h). */
#ifndef TINKER_CORE_TURNS_H
#define TINKER_CORE_TURNS_H

#include "physics/model/model-data.h"

/* Angles alone: attachments to bodies are put where they are then. */
void tinker_model_set_angles(TinkerModel *model, const double *q);

/* Whether the angles set last are those of q. */
gboolean tinker_model_has_angles(const TinkerModel *model, const double *q);

/* Rates alone, of angles that were set before: velocities of attachments to bodies. */
void tinker_model_set_rates(TinkerModel *model, const double *v);

#endif
