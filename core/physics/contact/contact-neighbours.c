#include "physics/contact/contact-neighbours.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

#include <string.h>

/* Of the distance to what is not listed. */
#define SURELY 0.9
/* Neighbours that there is room for at first. */
#define MOST_EXPECTED 16

void tinker_contact_neighbours_init(TinkerContactNeighbours *self, const TinkerContacts *contacts)
{
    gsize bodies = (gsize)MAX(contacts->model->bodies, 1);
    *self = (TinkerContactNeighbours){
        .contacts = contacts,
        .centre = g_new0(double, 2 * bodies),
        .reach = g_new0(double, bodies),
        .lists = g_new0(GArray *, bodies),
    };
    for (int32_t i = 0; i < contacts->model->bodies; i++) {
        self->lists[i] =
            g_array_sized_new(FALSE, FALSE, sizeof(int32_t), (guint)MIN(MOST_EXPECTED, contacts->plate_count));
        self->reach[i] = -1;
    }
}

void tinker_contact_neighbours_clear(TinkerContactNeighbours *self)
{
    for (int32_t i = 0; self->lists != NULL && i < self->contacts->model->bodies; i++)
        g_array_unref(self->lists[i]);
    g_clear_pointer(&self->centre, g_free);
    g_clear_pointer(&self->reach, g_free);
    g_clear_pointer(&self->lists, g_free);
}

double tinker_contact_distance(const TinkerContacts *contacts, int32_t body, int32_t number, const double place[2])
{
    const TinkerPlate *plate = &contacts->plates[number];
    const TinkerPoint *centre = &contacts->model->point[plate->point];
    double dx = place[0] - centre->x, dy = place[1] - centre->y;
    double gap = plate->normal[0] * dx + plate->normal[1] * dy - plate->half_height - contacts->half_height[body];
    double beside = fabs(plate->normal[1] * dx - plate->normal[0] * dy) - plate->half_width;
    return hypot(gap, fmax(beside, 0));
}

void tinker_contact_neighbours_list(TinkerContactNeighbours *self, int32_t body, const double from[2],
                                    const double to[2], double reach)
{
    GArray *list = self->lists[body];
    double nearest = INFINITY;
    reach += hypot(to[0] - from[0], to[1] - from[1]);
    memcpy(self->centre + 2 * body, to, 2 * sizeof(double));
    g_array_set_size(list, 0);
    for (int32_t k = 0; k < self->contacts->plate_count; k++) {
        if (self->contacts->plates[k].turned != NULL) continue; /* its gap functions are looked at */
        double away = tinker_contact_distance(self->contacts, body, k, to);
        if (self->contacts->plates[k].moving || away <= reach)
            g_array_append_val(list, k);
        else
            nearest = fmin(nearest, away);
    }
    self->reach[body] = fmax(reach, SURELY * nearest);
}
