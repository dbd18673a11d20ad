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

/* An entry of dJ/dt, how the constraints' Jacobian J turns as the start moves on. */
typedef struct {
    int32_t row, coordinate;
    double rate; /* 1/s times that of J */
} TinkerTurningEntry;

/* Of the constraints at the start, by a difference along its velocities; nothing of what is at rest. Element:
 * TinkerTurningEntry. Leaves the constraints evaluated at the start. What constraints leave of the motion turns with
 * them: beside a motion of velocity v, one that is off by x has an acceleration across the constraints of
 * -M^-1 J^T S^-1 (dJ/dt) x at its rate, whose square is missing in what the tensions make. So the stiffness is less by
 * (dJ/dt)^T S^-1 dJ/dt (the curvature of what constraints leave, by Gauss's equation). What damping adds, as it turns,
 * is left out. */
TinkerStatus tinker_start_turning(TinkerModel *model, GArray *found);

#endif
