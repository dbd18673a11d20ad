/* What the files about contacts of a model that is held still share. */
#ifndef TINKER_CORE_STILL_CONTACTS_PRIVATE_H
#define TINKER_CORE_STILL_CONTACTS_PRIVATE_H

#include "physics/event/contact-change-private.h"
#include "physics/event/still-contacts.h"
#include "physics/model/model-data.h"

struct _TinkerStillContacts {
    TinkerModel *model;
    TinkerContacts *contacts;
    double *still;        /* velocities of 0, 2 a body */
    double *acceleration; /* for work, 2 a body */
    GArray *touches;      /* of TinkerTouch: what touches where it was decided last */
    GArray *resting;      /* of TinkerContactPair: touch at the start without sliding */
    GArray *sliding;      /* and slide, there or since */
    guint sliding_at_start;
    gboolean smooth; /* friction is left out everywhere */
    gboolean lands_smoothly;
    gboolean pushed;
    double *gaps[2]; /* m: of each body with each plate, and of each row; at the ends of a way */
};

/* Brings the model to these places, rows included. */
TinkerStatus tinker_still_set_places(TinkerStillContacts *contacts, const double *q);
/* Whether a row holds in one direction only, and on a body. */
gboolean tinker_still_holds_one_way(const TinkerStillContacts *contacts, int32_t row);
/* Closes a contact, whose mode is known, in the model; its rows are listed by whoever has closed all. */
void tinker_still_close(TinkerStillContacts *contacts, TinkerTouch *touch);

#endif
