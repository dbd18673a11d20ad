/* Ways of a model that is held still: how far one leads before an open contact closes on it. */
#include <math.h>
#include <string.h>

#include "physics/contact/contacts.h"
#include "physics/event/still-contacts-private.h"
#include "physics/model/model-data.h"

static gboolean is_closed(const TinkerStillContacts *self, int32_t body, int32_t plate)
{
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        if (contact->body == body && contact->plate == plate) return TRUE;
    }
    return FALSE;
}

/* Where the places cannot be worked out nothing closes. */
static void measure(TinkerStillContacts *self, const double *q, double *gaps)
{
    const TinkerConstraints *all = &self->model->constraints;
    const int32_t plates = self->contacts->plate_count, pairs = self->model->bodies * plates;
    if (tinker_still_set_places(self, q) != TINKER_OK) {
        for (int32_t i = 0; i < pairs + all->rows; i++)
            gaps[i] = INFINITY;
        return;
    }
    for (int32_t i = 0; i < pairs; i++)
        *gaps++ = tinker_contact_place(self->contacts, i / plates, i % plates).gap;
    for (int32_t row = 0; row < all->rows; row++)
        *gaps++ = all->own_g != NULL ? -all->own_g[row] : INFINITY;
}

/* The share of the way at which a gap closes; 1 where it does not, or was behind already. */
static double share_of(double before, double after, double closed)
{
    if (!(before >= -closed) || !(after < -closed)) return 1;
    return before <= closed ? 0 : before / (before - after);
}

/* Whether the foot of a body is over the plate at a share of its way. */
static gboolean is_over(const TinkerStillContacts *self, int32_t body, int32_t number, const double *q,
                        const double *next, double share)
{
    const TinkerPlate *plate = &self->contacts->plates[number];
    const TinkerPoint *centre = &self->model->point[plate->point];
    double x = q[2 * body] + share * (next[2 * body] - q[2 * body]) - centre->x;
    double y = q[2 * body + 1] + share * (next[2 * body + 1] - q[2 * body + 1]) - centre->y;
    return fabs(plate->normal[1] * x - plate->normal[0] * y) <= plate->half_width;
}

static void push(TinkerStillContacts *self, int32_t body, int32_t plate, int32_t row)
{
    TinkerTouch touch = {.contact = {.body = body, .plate = plate, .mode = TINKER_CONTACT_SMOOTH}, .row = row};
    tinker_still_close(self, &touch);
    self->pushed = tinker_contacts_list_rows(self->contacts) == TINKER_OK;
}

double tinker_still_contacts_reach(TinkerStillContacts *self, const double *q, const double *next)
{
    const TinkerConstraints *all = &self->model->constraints;
    const int32_t plates = self->contacts->plate_count, bodies = self->model->bodies;
    double reach = 1;
    int32_t first[3] = {-1, -1, -1}; /* body, plate, row */
    measure(self, q, self->gaps[0]);
    measure(self, next, self->gaps[1]);
    const double *before = self->gaps[0], *after = self->gaps[1];
    for (int32_t i = 0; i < bodies * plates; i++, before++, after++) {
        double share = share_of(*before, *after, TINKER_TOUCHING);
        if (!(share < reach) || is_closed(self, i / plates, i % plates)) continue;
        if (!is_over(self, i / plates, i % plates, q, next, share)) continue;
        reach = share;
        memcpy(first, (int32_t[]){i / plates, i % plates, -1}, sizeof first);
    }
    for (int32_t row = 0; row < all->rows; row++, before++, after++) {
        if (!tinker_still_holds_one_way(self, row) || !all->slack[row]) continue;
        double share = share_of(*before, *after, TINKER_TOUCHING * all->scales[row]);
        if (!(share < reach)) continue;
        reach = share;
        memcpy(first, (int32_t[]){tinker_contacts_row_body(self->contacts, row), 0, row}, sizeof first);
    }
    if (reach == 0) push(self, first[0], first[1], first[2]);
    return reach;
}

gboolean tinker_still_contacts_are_pushed(const TinkerStillContacts *self)
{
    return self->pushed;
}
