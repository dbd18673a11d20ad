/* Friction of pins as closed contacts see it; see the source. */
#ifndef TINKER_CORE_CONTACT_PINS_H
#define TINKER_CORE_CONTACT_PINS_H

#include "physics/contact/contacts.h"

/* How many joints of the model have friction. */
int32_t tinker_model_rubbing_pins(const TinkerModel *model);
/* FALSE where one has friction that joins no two things with an angle. */
gboolean tinker_model_check_pins(const TinkerModel *model, GError **error);
/* Lists them, `count` in all, behind all other plates. */
void tinker_contacts_list_pins(TinkerContacts *contacts, int32_t count);
/* The body that counts as that of a pin's contact. */
int32_t tinker_contact_pin_body(const TinkerContacts *contacts, int32_t number);
/* Adds all of them to what is closed, undecided (TINKER_CONTACT_SMOOTH): at the start of a run. */
void tinker_contacts_close_pins(TinkerContacts *contacts);
/* Whether the rows evaluated last determine the force of a pin. */
gboolean tinker_contact_pin_is_determined(TinkerModel *model, const TinkerPlate *plate);

/* The magnitude of its force (N) by the multipliers solved last; and the same noted as the `normal` of all of them. */
double tinker_contact_pin_force(const TinkerContacts *contacts, const TinkerPlate *plate);
void tinker_contacts_note_pin_forces(TinkerContacts *contacts);

/* The torques (N m) of friction on what the ends of a batch of constraints are on, two an instance. */
void tinker_contacts_pin_torques(const TinkerContacts *contacts, const TinkerConstraintBatch *part, double *torques);

/* Keeps the multipliers solved last of the pins of a block that turn: two numbers a row, `stride` apart. */
void tinker_contact_pins_keep(TinkerContacts *contacts, const TinkerContactBlock *block, double *into, gsize stride);
/* Solves for the forces of a block in which pins turn, whose other rows are in its matrix; in place of its demand. Kept
 * are the forces without any contact (pins.free) and what a unit of each row's force adds (pins.answers). */
void tinker_contact_pins_solve(TinkerContacts *contacts, TinkerContactBlock *block, double *demand);

#endif
