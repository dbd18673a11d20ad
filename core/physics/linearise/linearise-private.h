/* The parts of a linearisation. */
#ifndef TINKER_CORE_LINEARISE_PRIVATE_H
#define TINKER_CORE_LINEARISE_PRIVATE_H

#include "physics/linearise/linearise.h"
#include "physics/model/model-data.h"

/* Begins a part of rank one at the end of `terms`, and adds a component to it; zeros are left out. */
void tinker_linear_begin_term(const TinkerLinearisation *linear, GArray *terms, double weight);
void tinker_linear_add_entry(TinkerLinearisation *linear, GArray *terms, int32_t coordinate, double value);
/* Adds (x, y) times the place of a point. */
void tinker_linear_add_point(TinkerLinearisation *linear, const TinkerModel *model, GArray *terms, int32_t point,
                             double x, double y);

/* Force elements and fields, as dense matrices: what the jacobian has more than lines and turned arms, which are there
 * already; where a field couples bodies, by differences of its own. `still` is a velocity of 0. */
TinkerStatus tinker_linear_add_others(TinkerLinearisation *linear, TinkerModel *model, const double *q,
                                      const double *still);

/* The rows of straight bars (straight-bars.h), for the Jacobian evaluated last. */
void tinker_linear_add_straight_rows(TinkerLinearisation *linear, const TinkerConstraints *all);

/* Rows of one class of constraints that are tight, and what their forces do as they turn: for the rows and multipliers
 * evaluated last. */
TinkerStatus tinker_linear_add_constraints(TinkerLinearisation *linear, TinkerModel *model,
                                           TinkerConstraintBatch *part);
/* What forces on places of bodies that turn do as their arms turn: those applied, and those of constraints, evaluated
 * last. */
void tinker_linear_add_turned_forces(TinkerLinearisation *linear, const TinkerModel *model);
void tinker_linear_add_turned_rows(TinkerLinearisation *linear, const TinkerModel *model);

#endif
