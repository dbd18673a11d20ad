/* Contacts as impulses have them: forces that are the means of a step, so that no row tells of them at its end. */
#ifndef TINKER_CORE_CONTACT_MEANS_H
#define TINKER_CORE_CONTACT_MEANS_H

#include "equations/newton/contact-geometry.h"

/* Where such a contact is: the arms to it on both, and the direction of its normal force, as numbers of that time. */
void tinker_contact_mean_geometry(TinkerEquationWriter *writer, const TinkerContactForce *contact,
                                  TinkerContactGeometry *geometry);

/* Says of symbols of such a contact that they are numbers. */
void tinker_contact_note_mean(TinkerEquationWriter *writer, const TinkerContactForce *contact, const char *symbol);

#endif
