/* Contact as impulses: the time stepping of Moreau and Jean. One velocity solve a step, whatever touches, and no
 * events.
 *
 *     v* = v + h a(q, v, t),   v' = v* + M^-1 D p,   q' = q + h v'
 *
 * with the impulses p of the contacts that the step brings together or holds together, by the laws of impact
 * (numerics/contact/contact-laws.h) for the velocities of the plates at the end of the step:
 *
 *     u_n' >= 0, or -e u_n where the body strikes;  |p_t| <= mu p_n,  u_t' = 0 or p_t = -mu p_n sign(u_t').
 *
 * A body that no constraint holds goes straight to where it meets a plate and on from there, so that it lies on the top
 * to rounding and passes none at any speed. Bodies on constraints are solved together, for velocities at which no gap
 * is negative at the end of the step.
 *
 * Sources: J. J. Moreau, "Unilateral contact and dry friction in finite freedom dynamics" (1988); M. Jean, "The
 * non-smooth contact dynamics method", Comput. Methods Appl. Mech. Engrg. 177 (1999) 235-257; V. Acary, B. Brogliato,
 * "Numerical Methods for Nonsmooth Dynamical Systems" (2008), ch. 10. */
#ifndef TINKER_CORE_IMPULSE_H
#define TINKER_CORE_IMPULSE_H

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

/* A method like others but for its system, which has to be that of a model with contacts, in the plane. Not to be had
 * by its name: a run asks for `impulses`. */
extern const TinkerIntegrator tinker_integrator_impulse;

/* The method of the same steps where nothing touches: what is found out about a method by trying it on oscillators is
 * that one's. Any other method is its own. */
const TinkerIntegrator *tinker_method_without_contact(const TinkerIntegrator *method);

/* Of a stepper of it: how a body has been turned by what it touched (rad; NAN: as it was placed), and the end of the
 * last step in which a body struck a plate (s; -INFINITY: none did). */
double tinker_impulse_orientation(const void *stepper, int32_t body);
double tinker_impulse_last_impact(const void *stepper);

/* Of a stepper of it: speeds (m/s) up to here are what sweeps along a pile leave of those that contacts take. */
double tinker_impulse_speed_noise(const void *stepper);

/* Adds warnings (TinkerWarning *) of bodies that overlap each other at the start, where there are too many for the
 * contacts to have told of them. */
void tinker_impulse_tell_overlaps(const TinkerContacts *contacts, GPtrArray *warnings);

/* Adds what contacts did to bodies in the last step to accelerations without contact (2 per body). */
void tinker_impulse_add_accelerations(const TinkerContacts *contacts, double *a);

#endif
