/* Guides: two tops that face each other just as far apart as a body is high. It moves along them as along a slot, and
 * one contact at a time stands for both: the one that presses. Where its force changes sign the other takes over,
 * without a take-off, since there is no way between them that the body could go. */
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/contact/tolerances.h"
#include "physics/model/model-data.h"

/* Whether two points of supports move alike at this time. */
static gboolean move_alike(const TinkerModel *model, int32_t a, int32_t b)
{
    const TinkerPoint *p = &model->point[a], *q = &model->point[b];
    const double *at_p = model->point_acceleration + 2 * a, *at_q = model->point_acceleration + 2 * b;
    return p->vx == q->vx && p->vy == q->vy && at_p[0] == at_q[0] && at_p[1] == at_q[1];
}

gboolean tinker_contacts_are_guide(const TinkerContacts *contacts, int32_t body, int32_t a, int32_t b)
{
    const TinkerPlate *p = &contacts->plates[a], *q = &contacts->plates[b];
    if (p->normal[0] * q->normal[0] + p->normal[1] * q->normal[1] > -1 + TINKER_OPPOSITE) return FALSE;
    const TinkerPoint *from = &contacts->model->point[p->point], *to = &contacts->model->point[q->point];
    double apart = p->normal[0] * (to->x - from->x) + p->normal[1] * (to->y - from->y);
    double play = apart - p->half_height - q->half_height - 2 * contacts->half_height[body];
    return fabs(play) <= TINKER_TOUCHING && move_alike(contacts->model, p->point, q->point);
}

gboolean tinker_contacts_is_guided(const TinkerContacts *contacts, int32_t body, int32_t plate)
{
    if (plate >= contacts->plate_count) return FALSE;
    for (guint i = 0; contacts->plate_count > 1 && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->body == body && contact->plate != plate && contact->plate < contacts->plate_count &&
            tinker_contacts_are_guide(contacts, body, contact->plate, plate))
            return TRUE;
    }
    return FALSE;
}
