/* Friction of a contact in the equations: another unknown where it sticks, a share of the normal force where it slides.
 */
#ifndef TINKER_CORE_CONTACT_FRICTION_H
#define TINKER_CORE_CONTACT_FRICTION_H

#include "equations/newton/contact-pair.h"

void tinker_contact_add_friction(const TinkerContactTerms *terms);

#endif
