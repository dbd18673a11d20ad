/* The contacts of a model that is held still (physics/linearise.h): which of them press, stick, pull at places that are
 * given.
 *
 * What presses or pulls there is closed in the model, so that forces, projections and linearisations take it for a
 * constraint in both directions; what does not is left out. Where friction can hold a body it sticks. It does not where
 * the body slides at the start, or once its place asked for more than static friction gives: from then on it slides
 * smoothly, its friction left out, since that has no linear form about rest. The forces are those of the laws that also
 * rule at events (numerics/contact/contact-laws.h), with everything at rest. */
#ifndef TINKER_CORE_STILL_CONTACTS_H
#define TINKER_CORE_STILL_CONTACTS_H

#include "physics/model/model.h"

typedef struct _TinkerStillContacts TinkerStillContacts;

/* Of a model that starts with its own velocities: before it is held. NULL where nothing of it can touch anything. The
 * model is borrowed. (transfer full) */
TinkerStillContacts *tinker_still_contacts_new(TinkerModel *model);
void tinker_still_contacts_free(TinkerStillContacts *contacts);
/* From now on friction holds nothing. */
void tinker_still_contacts_leave_out_friction(TinkerStillContacts *contacts);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TinkerStillContacts, tinker_still_contacts_free)

/* Closes what acts at the places q (2 a body, relative to the model's origin) and opens all else. FALSE with an error
 * where forces cannot be worked out there, or none satisfy the laws. */
gboolean tinker_still_contacts_decide(TinkerStillContacts *contacts, const double *q, GError **error);

/* From the start, as a search for rest leaves it: forgets what began to slide since. `lands_smoothly`: friction holds
 * nothing that does not touch at the start, so that what comes down on the way does not depend on where it does; until
 * it has landed. */
void tinker_still_contacts_begin_anew(TinkerStillContacts *contacts, gboolean lands_smoothly);
void tinker_still_contacts_have_landed(TinkerStillContacts *contacts);

/* How far the way from the places q to `next` leads before an open contact closes on it: a share, 1 where none does.
 * Something that touches at q already and is pushed on makes it 0; it is closed, for this way, until the next decision.
 */
double tinker_still_contacts_reach(TinkerStillContacts *contacts, const double *q, const double *next);

/* Whether something is closed for the way alone, so that the forces there are none of the laws. */
gboolean tinker_still_contacts_are_pushed(const TinkerStillContacts *contacts);

typedef enum {
    TINKER_STILL_SLIDES,  /* lies on a plate and slides along it; of a rough one, its friction is left out */
    TINKER_STILL_STICKS,  /* friction holds it there */
    TINKER_STILL_TOUCHES, /* touches a plate without pressing: the contact is left out */
    TINKER_STILL_TAUT,    /* a constraint that holds in one direction only, and pulls: it holds in both */
    TINKER_STILL_SLACK,   /* one that does not pull: it is left out */
} TinkerStillContactKind;

typedef struct {
    TinkerStillContactKind kind;
    TinkerBlockId block, plate; /* the body, or the constraint, which has no plate */
    double force;               /* N: that it presses or pulls with */
    gboolean rough;             /* its friction is left out */
} TinkerStillContact;

/* What was decided last, body by body; element: TinkerStillContact. (transfer full) */
GArray *tinker_still_contacts_list(const TinkerStillContacts *contacts);

/* "slides", "sticks", "touches", "taut", "slack". */
const char *tinker_still_contact_kind_name(TinkerStillContactKind kind);

#endif
