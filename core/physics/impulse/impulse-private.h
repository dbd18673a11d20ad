/* What the files of contact as impulses share. */
#ifndef TINKER_CORE_IMPULSE_PRIVATE_H
#define TINKER_CORE_IMPULSE_PRIVATE_H

#include "physics/contact/contact-neighbours.h"
#include "physics/contact/contact-reach.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse.h"
#include "physics/impulse/pile.h"
#include "physics/model/model-data.h"
#include "physics/system/system.h"

/* Contacts of one body at a time at most; those that are solved together to rounding. */
#define TINKER_MOST_TOUCHES 8

/* A plate as a step sees it. */
typedef struct {
    double normal[2];
    double top[2], middle[2]; /* at the start and the end of the step: normal . centre + half the height, t . centre */
    double velocity[2], mean[2]; /* at the end; of the two ends */
    double half_width;
    gboolean moving;
} TinkerImpulsePlate;

/* A contact in a step. Impulses in N s for 1 kg where the body moves alone. */
typedef struct {
    int32_t body, plate;
    TinkerContactMode was, is;             /* at the start (OPEN: not closed), and from here on */
    double anchor;                         /* along the top, of one that stuck */
    double share;                          /* of the step that was over when they met */
    double before[2];                      /* the body's velocity then */
    double least;                          /* of the body's velocity along the normal */
    double normal, friction;               /* impulses */
    double normal_before, friction_before; /* of them, from before the way of the body was changed elsewhere */
    gboolean strikes, bounces;
} TinkerImpulseTouch;

struct TinkerImpulses {
    TinkerModelSystem *context;
    const TinkerSystem *system;
    TinkerModel *model;
    TinkerContacts *contacts;
    TinkerImpulsePlate *plates;
    TinkerContactNeighbours neighbours;
    double least_reach; /* m: of neighbourhoods */
    gboolean started;
    double *orientation; /* by body */
    double last_impact;

    /* the step in progress, or made last */
    double h;
    TinkerState from, to; /* its ends; books at the start alone */
    double *a, *power;    /* at the start; of the books */
    double *velocity;     /* v*, where several bodies are solved together */
    GArray *next;         /* of TinkerContact: closed at its end */
    double work[TINKER_BOOK_COUNT];

    /* bodies on constraints */
    GArray *held;   /* of TinkerImpulseTouch, by body */
    GArray *chosen; /* of int32_t: those of one group */
    GArray *laws;   /* of TinkerContact: the same, for the Delassus matrix */
    double *room;   /* for their laws */
    gsize room_size;
    TinkerContactReach reach; /* of many; */
    double *delassus;         /* or a matrix */
    gsize delassus_size;

    TinkerPile *pile; /* bodies that turn or collide; NULL: there are none */
    double parted;    /* J that parting what overlapped gave, in the step, and bringing joints together */
};

/* TinkerIntegrator.create and .destroy. */
void *tinker_impulse_create(const TinkerSystem *system, const TinkerIntegratorOptions *options);
void tinker_impulse_destroy(void *stepper);
/* At the first step: what touches and does not part rests, or slides. */
void tinker_impulse_start(TinkerImpulses *self, const TinkerState *state);
/* Notes where plates that move are, and how fast: at the start (0) and at the end (1) of the step. */
void tinker_impulse_read_plates(TinkerImpulses *self, int end);

/* A body by itself on its way through a step. */
typedef struct {
    TinkerImpulses *run;
    int32_t body;
    guint next;        /* see tinker_impulse_closed */
    double x[2], v[2]; /* where it is when `share` of the step is over, and its velocity from there on */
    double base[2];    /* v but for the contacts that touch */
    double start[2];   /* its velocity at the start of the step */
    double share;
    TinkerImpulseTouch touches[TINKER_MOST_TOUCHES]; /* that touch now, whether or not they press */
    int32_t count;
} TinkerImpulseWay;

static inline const TinkerImpulsePlate *tinker_impulse_plate(const TinkerImpulseWay *way,
                                                             const TinkerImpulseTouch *touch)
{
    return &way->run->plates[touch->plate];
}

static inline double tinker_dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* A body that lands is turned along the top, unless it keeps its angle. */
static inline void tinker_impulse_turn(TinkerImpulses *self, int32_t body, int32_t plate)
{
    if (!tinker_contacts_has_outline(self->contacts, body))
        self->orientation[body] = self->contacts->plates[plate].orientation;
}

/* t . a, along the top whose normal is n. */
static inline double tinker_along(const double n[2], const double a[2])
{
    return n[1] * a[0] - n[0] * a[1];
}

/* The gap of a body at a place, `share` of the step being over (m). */
static inline double tinker_impulse_gap(const TinkerImpulses *self, const TinkerImpulsePlate *plate, int32_t body,
                                        const double x[2], double share)
{
    return tinker_dot(plate->normal, x) - (plate->top[0] + share * (plate->top[1] - plate->top[0])) -
           self->contacts->half_height[body];
}

static inline double tinker_impulse_along(const TinkerImpulsePlate *plate, const double x[2], double share)
{
    return tinker_along(plate->normal, x) - (plate->middle[0] + share * (plate->middle[1] - plate->middle[0]));
}

/* The closed contact of a body with a plate at the start of the step, or NULL; `next` is the number of the first closed
 * contact that is not of an earlier body. */
static inline const TinkerContact *tinker_impulse_closed(const TinkerImpulses *self, int32_t body, int32_t plate,
                                                         guint next)
{
    const GArray *closed = self->contacts->closed;
    for (; next < closed->len; next++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, next);
        if (contact->body != body) return NULL;
        if (contact->plate == plate) return contact;
    }
    return NULL;
}

/* The share of the step at which a body that is at x when `share` of it is over, and goes on with velocity v, meets the
 * plate; above 1: it does not. `closed`: it touches the plate. */
double tinker_impulse_meeting(const TinkerImpulses *self, int32_t body, int32_t plate, gboolean closed,
                              const double x[2], const double v[2], double share);

/* The neighbours of a body on its way from x with velocity v for a time. */
static inline const GArray *tinker_impulse_neighbours(TinkerImpulses *self, int32_t body, const double x[2],
                                                      const double v[2], double time)
{
    const double to[2] = {x[0] + time * v[0], x[1] + time * v[1]};
    if (!tinker_contact_neighbours_hold(&self->neighbours, body, x, to, 0))
        tinker_contact_neighbours_list(&self->neighbours, body, x, to,
                                       32 * hypot(time * v[0], time * v[1]) + self->least_reach);
    return self->neighbours.lists[body];
}

/* Books the impulses (N s) of one contact on a body that went from velocity `before` to `after`: what an impact takes
 * along the top is the impact's. */
void tinker_impulse_book(TinkerImpulses *self, const TinkerImpulseTouch *touch, double normal, double friction,
                         const double before[2], const double after[2]);

/* Lists a contact as closed at the end of the step, with its impulses (N s). */
void tinker_impulse_close(TinkerImpulses *self, const TinkerImpulseTouch *touch, double normal, double friction,
                          const double x[2]);

/* Brings a body that no constraint holds to the end of the step. FALSE, with the model's failure set, where no impulses
 * satisfy the laws. */
gboolean tinker_impulse_move_free(TinkerImpulses *self, int32_t body, guint next, double *q, double *v);

/* Sets the velocity from here on, and the impulses of all that touches, by the laws. FALSE where nothing satisfies
 * them. */
gboolean tinker_impulse_solve_way(TinkerImpulseWay *way);

/* Changes the velocities (v* of all bodies) of what is held by constraints by the impulses of its contacts. */
gboolean tinker_impulse_solve_held(TinkerImpulses *self, const double *q, double *v);

/* The laws for contacts with these velocities and their least ones; friction is that of each contact's state. Sets
 * impulses and what each does. FALSE where nothing satisfies them. `room` holds tinker_impulse_laws_room doubles. */
gboolean tinker_impulse_solve_laws(const TinkerImpulses *self, TinkerImpulseTouch **touches, const TinkerImpact *given,
                                   double *room);
gsize tinker_impulse_laws_room(gsize count);

#endif
