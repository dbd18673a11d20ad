/* The stiffness that tensions of constraints make: as a constraint turns, so does the force that holds it. A pendulum
 * has no other. */
#ifndef TINKER_CORE_START_GEOMETRY_H
#define TINKER_CORE_START_GEOMETRY_H

#include "physics/model/model.h"

/* What a constraint's tension adds to the stiffness between two coordinates. */
typedef struct {
    int32_t row, column;
    double stiffness;
} TinkerStiffnessEntry;

/* Of the constraints as they are evaluated, whose multipliers are `lambda`: -lambda times the derivative of the
 * Jacobian, by central differences. Entries are added to `found`, an array of TinkerStiffnessEntry; those of one place
 * add up. */
void tinker_start_geometry(TinkerModel *model, const double *lambda, GArray *found);

#endif
