/* Holding the energy of motion that nothing takes any from or gives any to.
 *
 * A Runge-Kutta method errs to one side in every step: the energy of a swinging pendulum drifts with t, and as its
 * period goes with the energy, its phase is off by t^2. Brought back onto the energy of its start after every step, the
 * phase is off by t alone. Source: E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., IV.4
 * (projection methods), Springer 2006.
 */
#ifndef TINKER_CORE_HOLD_ENERGY_H
#define TINKER_CORE_HOLD_ENERGY_H

#include "physics/force/forces.h"
#include "physics/model/model.h"
#include "physics/system/system.h"

/* Whether the energy of this model's motion stays what it is: nothing drives it, resists it or gets in its way. */
gboolean tinker_model_keeps_energy(const TinkerModel *model);

/* From now on `project` holds this energy. For methods that step with accelerations and are projected at the end of
 * each step. */
void tinker_model_system_start_holding(TinkerModelSystem *self, const TinkerEnergy *energy);

/* Moves a state that lies on the constraints onto the energy that is held, the shortest way in the norm of masses,
 * velocities measured by the speed and places by the extent of the motion; it is on the constraints again then. *moved
 * becomes TRUE where anything changed. What it gave is booked as work of projection. */
TinkerStatus tinker_model_system_hold_energy(TinkerModelSystem *self, double t, double *q, double *v, gboolean *moved);

#endif
