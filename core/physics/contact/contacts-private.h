/* What the files about closed contacts share. */
#ifndef TINKER_CORE_CONTACTS_PRIVATE_H
#define TINKER_CORE_CONTACTS_PRIVATE_H

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

/* For the bodies that constraints join to one; NULL: no memory. Owned by the contacts. */
TinkerContactElimination *tinker_contacts_elimination(TinkerContacts *contacts, int32_t body);

/* Solves for the demand of all rows, for the constraint rows evaluated last: how far each row is to push along itself.
 */
void tinker_contacts_solve_moves(TinkerContacts *contacts);

#endif
