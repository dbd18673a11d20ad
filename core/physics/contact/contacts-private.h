/* What the files about closed contacts share. */
#ifndef TINKER_CORE_CONTACTS_PRIVATE_H
#define TINKER_CORE_CONTACTS_PRIVATE_H

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

/* For the set of a body: of what is tied, or of what may meet. NULL: no memory. Owned by the contacts. */
TinkerContactElimination *tinker_contacts_elimination(TinkerContacts *contacts, gboolean may_meet, int32_t body);

/* Finds the outlines of bodies that turn or meet others, and of tops. */
void tinker_contacts_find_outlines(TinkerContacts *contacts);
/* Then lists the gap functions of those that may touch: tops, and where they `meet` each other. */
void tinker_contacts_list_gaps(TinkerContacts *contacts, gboolean meet);
/* How many are solid and turn, or collide. */
int32_t tinker_model_meeting_bodies(const TinkerModel *model);
/* Whether they meet each other by events: where the scene, whatever part of it the model is, does not have too many. */
gboolean tinker_model_bodies_meet(const TinkerModel *model);
/* The entries of closed gap functions, for the state in the points. */
void tinker_contacts_refresh_entries(TinkerContacts *contacts);

/* A row times a vector by coordinate; and v += what its force (`moves`: a push along itself) does, between
 * begin_pushes and end_pushes. */
double tinker_contact_row_times(const TinkerContacts *contacts, const TinkerContactRow *row,
                                const double *by_coordinate);
void tinker_contact_row_push(TinkerContacts *contacts, const TinkerContactRow *row, double push, gboolean moves,
                             double *v);

/* Solves for the demand of all rows, for the constraint rows evaluated last: how far each row is to push along itself.
 */
void tinker_contacts_solve_moves(TinkerContacts *contacts);

/* What a row was listed with, and what resists in it. */
static inline const TinkerContactEntries *tinker_contact_row_entries(const TinkerContacts *contacts,
                                                                     const TinkerContactRow *row)
{
    return &g_array_index(contacts->entries, TinkerContactEntries, (guint)row->entries);
}

static inline const TinkerContactEntries *tinker_contact_row_resisting(const TinkerContacts *contacts,
                                                                       const TinkerContactRow *row)
{
    return &g_array_index(contacts->entries, TinkerContactEntries, (guint)row->resisting_entries);
}

#endif
