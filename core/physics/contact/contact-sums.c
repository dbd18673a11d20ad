/* What closed contacts do in all: their power in the books, and their forces on each body. */
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts-private.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

static void add_gap_power(TinkerContacts *contacts, const TinkerContact *contact)
{
    TinkerModel *model = contacts->model;
    TinkerContactEntries entries;
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    if (contact->mode != TINKER_CONTACT_STICK)
        model->book_power[TINKER_BOOK_FRICTION] +=
            contact->friction * tinker_contact_gap_place(contacts, contact->plate).tangential_speed;
    if (contacts->plates[contact->plate].moving)
        model->book_power[TINKER_BOOK_SUPPORT_MOTION] -=
            contact->normal * entries.of_supports[0] + contact->friction * entries.of_supports[1];
}

void tinker_contacts_add_power(TinkerContacts *contacts)
{
    TinkerModel *model = contacts->model;
    model->book_power[TINKER_BOOK_FRICTION] = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        const double nx = plate->normal[0], ny = plate->normal[1];
        const TinkerPoint *at = &model->point[contact->body], *base = &model->point[plate->point];
        if (plate->gap != NULL) {
            add_gap_power(contacts, contact);
            continue;
        }
        if (contact->mode != TINKER_CONTACT_STICK)
            model->book_power[TINKER_BOOK_FRICTION] +=
                contact->friction * (ny * (at->vx - base->vx) - nx * (at->vy - base->vy));
        if (plate->moving)
            model->book_power[TINKER_BOOK_SUPPORT_MOTION] +=
                (contact->normal * nx + contact->friction * ny) * base->vx +
                (contact->normal * ny - contact->friction * nx) * base->vy;
    }
}

double tinker_contacts_moment(const TinkerContacts *contacts, int32_t number)
{
    for (guint i = 0; contacts->resistance_count > 0 && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->bearer == number) return contact->friction * contacts->plates[contact->plate].arm;
    }
    return 0;
}

static void add_force(double *sums, double normal, double friction, double fx, double fy)
{
    sums[0] += normal;
    sums[1] += friction;
    sums[2] += fx;
    sums[3] += fy;
}

/* On the second of the pair along its own axes, as supports have it. A moment is no force. */
static void add_gap_force(const TinkerContacts *contacts, const TinkerContact *contact, double *by_point)
{
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    if (tinker_contacts_resists(contacts, contact)) return;
    const int32_t tip = plate->gap->tip_of, on = plate->pair->point[0], by = plate->pair->point[1];
    TinkerContactEntries entries;
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    const double *n = entries.normal, sign = tip == 0 ? 1 : -1;
    const double fx = sign * (contact->normal * n[0] + contact->friction * n[1]);
    const double fy = sign * (contact->normal * n[1] - contact->friction * n[0]);
    add_force(by_point + 4 * on, contact->normal, contact->friction, fx, fy);
    add_force(by_point + 4 * by, contact->normal, -contact->friction, -fx, -fy);
}

void tinker_contacts_sum_forces(const TinkerContacts *contacts, double *by_point)
{
    memset(by_point, 0, 4 * (gsize)contacts->model->points * sizeof(double));
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        const double nx = plate->normal[0], ny = plate->normal[1];
        if (plate->gap != NULL) {
            add_gap_force(contacts, contact, by_point);
            continue;
        }
        double fx = contact->normal * nx + contact->friction * ny, fy = contact->normal * ny - contact->friction * nx;
        add_force(by_point + 4 * contact->body, contact->normal, contact->friction, fx, fy);
        add_force(by_point + 4 * plate->point, contact->normal, -contact->friction, -fx, -fy);
    }
    for (guint i = 0; i < contacts->pressings->len; i++) {
        const TinkerPressing *each = &g_array_index(contacts->pressings, TinkerPressing, i);
        const double fx = each->press * each->normal[0] + each->friction * each->normal[1];
        const double fy = each->press * each->normal[1] - each->friction * each->normal[0];
        add_force(by_point + 4 * each->body, each->press, each->friction, fx, fy);
        add_force(by_point + 4 * each->by, each->press, -each->friction, -fx, -fy);
    }
}
