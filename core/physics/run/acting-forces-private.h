/* What the files that tell forces apart share. */
#ifndef TINKER_CORE_ACTING_FORCES_PRIVATE_H
#define TINKER_CORE_ACTING_FORCES_PRIVATE_H

#include "physics/model/points.h"
#include "physics/run/acting-forces.h"

struct _TinkerActingForces {
    TinkerModel *model;
    double *acceleration;
    GArray *out;     /* borrowed, of the call in progress */
    GArray *touches; /* of TinkerActingTouch */
};

/* What of a torque acts on the body of a point: nothing turns a mass, though a row that speaks of angles has an answer
 * for its end as well. On a support it is what holds that. */
static inline double tinker_acting_torque_on(const TinkerModel *model, int32_t point, double torque)
{
    const int32_t body = tinker_model_body_of(model, point);
    return body < 0 || tinker_model_turn(model, body) != NULL ? torque : 0;
}

/* Adds those of all contacts that are closed, as they were evaluated last. */
void tinker_acting_add_contacts(TinkerActingForces *forces);

#endif
