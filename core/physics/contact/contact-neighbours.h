/* Which plates are near which body: so that what does not touch costs next to nothing. Every body has a neighbourhood,
 * the plates within some reach of where it was; it is listed anew when the body has left. */
#ifndef TINKER_CORE_CONTACT_NEIGHBOURS_H
#define TINKER_CORE_CONTACT_NEIGHBOURS_H

#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

/* A neighbourhood reaches at least this share of the island. */
#define TINKER_LEAST_NEIGHBOURHOOD 1e-3

typedef struct {
    const TinkerContacts *contacts;
    double *centre; /* 2 by body: where the body was when its neighbours were listed */
    double *reach;  /* by body: plates farther from there are not listed */
    GArray **lists; /* by body: of int32_t; moving plates are in all of them */
} TinkerContactNeighbours;

/* The contacts are borrowed. */
void tinker_contact_neighbours_init(TinkerContactNeighbours *self, const TinkerContacts *contacts);
void tinker_contact_neighbours_clear(TinkerContactNeighbours *self);

/* The distance (m) of a body at a place (relative to the origin) from where it would touch the plate. */
double tinker_contact_distance(const TinkerContacts *contacts, int32_t body, int32_t plate, const double place[2]);

/* Lists anew what is near a body on its way between two places; beyond the way it is looked at least as far as `reach`.
 */
void tinker_contact_neighbours_list(TinkerContactNeighbours *self, int32_t body, const double from[2],
                                    const double to[2], double reach);

/* Whether the list holds whatever the body may come upon on a way between two places that leads no farther than
 * `travel` away from either. */
static inline gboolean tinker_contact_neighbours_hold(const TinkerContactNeighbours *self, int32_t body,
                                                      const double from[2], const double to[2], double travel)
{
    const double *centre = self->centre + 2 * body, left = self->reach[body] - travel;
    const double from_x = from[0] - centre[0], from_y = from[1] - centre[1];
    const double to_x = to[0] - centre[0], to_y = to[1] - centre[1];
    const double away = MAX(from_x * from_x + from_y * from_y, to_x * to_x + to_y * to_y);
    return left > 0 && away < left * left;
}

#endif
