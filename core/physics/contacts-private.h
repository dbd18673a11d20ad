/* What the files about closed contacts share. */
#ifndef TINKER_CORE_CONTACTS_PRIVATE_H
#define TINKER_CORE_CONTACTS_PRIVATE_H

#include "physics/contacts.h"

/* Factors W of the rows that are solved together, for the constraint rows evaluated last: for forces, or for `moves`, which
 * go along the rows themselves. */
void tinker_contacts_factor(TinkerContacts *contacts, gboolean moves);

#endif
