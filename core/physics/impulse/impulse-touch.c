/* What a touch leaves behind: work in the books, a contact that is closed. */
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse-private.h"

void tinker_impulse_book(TinkerImpulses *self, const TinkerImpulseTouch *touch, double normal, double friction,
                         const double before[2], const double after[2])
{
    const TinkerImpulsePlate *plate = &self->plates[touch->plate];
    const double *n = plate->normal, *w = plate->mean;
    const double x = 0.5 * (before[0] + after[0]), y = 0.5 * (before[1] + after[1]);
    const TinkerBook along = touch->strikes ? TINKER_BOOK_CONTACTS : TINKER_BOOK_FRICTION;
    self->work[TINKER_BOOK_CONTACTS] += normal * (n[0] * (x - w[0]) + n[1] * (y - w[1]));
    self->work[along] += friction * (n[1] * (x - w[0]) - n[0] * (y - w[1]));
    if (plate->moving)
        self->work[TINKER_BOOK_SUPPORT_MOTION] +=
            normal * (n[0] * w[0] + n[1] * w[1]) + friction * (n[1] * w[0] - n[0] * w[1]);
}

void tinker_impulse_close(TinkerImpulses *self, const TinkerImpulseTouch *touch, double normal, double friction,
                          const double x[2])
{
    const gboolean stuck = touch->was == TINKER_CONTACT_STICK && touch->is == TINKER_CONTACT_STICK;
    const TinkerContact contact = {
        .body = touch->body,
        .plate = touch->plate,
        .mode = touch->is,
        .anchor = stuck ? touch->anchor : tinker_impulse_along(&self->plates[touch->plate], x, 1),
        .normal = normal / self->h,
        .friction = friction / self->h,
    };
    g_array_append_val(self->next, contact);
}
