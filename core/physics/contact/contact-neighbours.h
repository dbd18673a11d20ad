/* Which plates are near which body, and which pairs of shapes are near each other: so that what does not touch costs
 * next to nothing. Every body has a neighbourhood, the plates within some reach of where it was; it is listed anew when
 * the body has left. Pairs are listed for all bodies at once, with a margin that any of them may move by before they
 * are listed anew. Source of such lists: L. Verlet, Phys. Rev. 159 (1967) 98-103. */
#ifndef TINKER_CORE_CONTACT_NEIGHBOURS_H
#define TINKER_CORE_CONTACT_NEIGHBOURS_H

#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

/* A neighbourhood reaches at least this share of the island. */
#define TINKER_LEAST_NEIGHBOURHOOD 1e-3

typedef struct {
    TinkerContacts *contacts;
    double *centre; /* 2 by body: where the body was when its neighbours were listed */
    double *reach;  /* by body: plates farther from there are not listed */
    GArray **lists; /* by body: of int32_t; moving plates are in all of them */
    GArray *pairs;  /* of int32_t: numbers of near pairs, in their order; those with moving plates are always near */
    double *placed; /* 2 by body: where all of them were when these were listed */
    double margin;  /* m: pairs that are not listed were farther apart then; -1: none were listed yet */
} TinkerContactNeighbours;

/* The contacts are borrowed. */
void tinker_contact_neighbours_init(TinkerContactNeighbours *self, TinkerContacts *contacts);
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

/* How far (m) what moves of a pair may go before the shapes can touch, by circles around them: of two bodies each as
 * far as the other. */
double tinker_contact_pair_distance(const TinkerContacts *contacts, const TinkerTouchingPair *pair, const double *q);

/* Whether the circles are apart, for the state in the points of the model; FALSE of a support that moves. */
gboolean tinker_contact_pair_is_apart(const TinkerContacts *contacts, const TinkerTouchingPair *pair);

/* Sees to it that the list of pairs holds those that are no farther apart than `travel` (m) in any of two states of the
 * bodies, filled in; where it is made anew, pairs have a margin of about `reach` from there. */
void tinker_contact_neighbours_find_pairs(TinkerContactNeighbours *self, const double *q_from, const double *q_to,
                                          double travel, double reach);
/* How far (m) pairs that are not listed are apart at least. */
double tinker_contact_neighbours_unlisted_distance(const TinkerContactNeighbours *self, const double *q);

#endif
