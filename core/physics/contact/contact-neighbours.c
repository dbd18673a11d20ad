#include "physics/contact/contact-neighbours.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

#include <string.h>

/* Of the distance to what is not listed. */
#define SURELY 0.9
/* Neighbours that there is room for at first. */
#define MOST_EXPECTED 16

void tinker_contact_neighbours_init(TinkerContactNeighbours *self, TinkerContacts *contacts)
{
    gsize bodies = (gsize)MAX(contacts->model->bodies, 1);
    *self = (TinkerContactNeighbours){
        .contacts = contacts,
        .centre = g_new0(double, 2 * bodies),
        .reach = g_new0(double, bodies),
        .lists = g_new0(GArray *, bodies),
        .pairs = g_array_sized_new(FALSE, FALSE, sizeof(int32_t), (guint)contacts->pair_count),
        .placed = g_new0(double, 2 * bodies),
        .margin = -1,
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
    g_clear_pointer(&self->placed, g_free);
    g_clear_pointer(&self->pairs, g_array_unref);
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

/* Pairs ------------------------------------------------------------------------------------------------------------ */

/* How far a body's centre is from a top, from end to end. */
static double from_top(const TinkerContacts *contacts, const TinkerTouchingPair *pair, const double *at)
{
    const TinkerPlate *plate = &contacts->plates[pair->top];
    const TinkerPoint *centre = &contacts->model->point[pair->point[1]];
    const double dx = at[0] - centre->x, dy = at[1] - centre->y, *corners = pair->outline[1]->corners;
    const double over = plate->normal[0] * dx + plate->normal[1] * dy - corners[1];
    const double beside = fabs(plate->normal[1] * dx - plate->normal[0] * dy) - corners[2];
    return hypot(over, fmax(beside, 0));
}

double tinker_contact_pair_distance(const TinkerContacts *contacts, const TinkerTouchingPair *pair, const double *q)
{
    const int32_t a = pair->point[0], b = pair->point[1];
    if (b < contacts->model->bodies)
        return 0.5 *
               (hypot(q[2 * a] - q[2 * b], q[2 * a + 1] - q[2 * b + 1]) - contacts->reach[a] - contacts->reach[b]);
    return from_top(contacts, pair, q + 2 * pair->point[0]) - contacts->reach[pair->point[0]];
}

gboolean tinker_contact_pair_is_apart(const TinkerContacts *contacts, const TinkerTouchingPair *pair)
{
    const TinkerPoint *a = &contacts->model->point[pair->point[0]], *b = &contacts->model->point[pair->point[1]];
    const double at[2] = {a->x, a->y}, reach = contacts->reach[pair->point[0]];
    if (pair->moving) return FALSE;
    if (pair->top >= 0) return from_top(contacts, pair, at) - reach > TINKER_TOUCHING;
    return hypot(a->x - b->x, a->y - b->y) - reach - contacts->reach[pair->point[1]] > TINKER_TOUCHING;
}

/* The longest way (m) of any body between two states. */
static double longest_way(const TinkerContacts *contacts, const double *from, const double *to)
{
    double most = 0;
    for (int32_t i = 0; i < contacts->model->bodies; i++) {
        const double x = to[2 * i] - from[2 * i], y = to[2 * i + 1] - from[2 * i + 1];
        most = fmax(most, x * x + y * y);
    }
    return sqrt(most);
}

double tinker_contact_neighbours_unlisted_distance(const TinkerContactNeighbours *self, const double *q)
{
    return self->margin - longest_way(self->contacts, self->placed, q);
}

/* As tinker_contact_pair_distance has it, without a root. */
static gboolean is_beyond(const TinkerContacts *contacts, const TinkerTouchingPair *pair, const double *q,
                          double margin)
{
    const int32_t a = pair->point[0], b = pair->point[1];
    if (b >= contacts->model->bodies) return !pair->moving && tinker_contact_pair_distance(contacts, pair, q) > margin;
    const double x = q[2 * a] - q[2 * b], y = q[2 * a + 1] - q[2 * b + 1];
    const double reach = contacts->reach[a] + contacts->reach[b] + 2 * margin;
    return x * x + y * y > reach * reach;
}

/* What passes is listed until it is seen to have parted. */
static void list_pairs(TinkerContactNeighbours *self, const double *q, double margin)
{
    TinkerContacts *contacts = self->contacts;
    g_array_set_size(self->pairs, 0);
    self->margin = margin;
    memcpy(self->placed, q, 2 * (gsize)contacts->model->bodies * sizeof(double));
    for (int32_t k = 0; k < contacts->pair_count; k++) {
        TinkerTouchingPair *pair = &contacts->pairs[k];
        if (!pair->passes && is_beyond(contacts, pair, q, margin)) continue;
        tinker_contacts_fill_pair(contacts, pair);
        g_array_append_val(self->pairs, k);
    }
}

void tinker_contact_neighbours_find_pairs(TinkerContactNeighbours *self, const double *q_from, const double *q_to,
                                          double travel, double reach)
{
    if (tinker_contact_neighbours_unlisted_distance(self, q_from) > travel &&
        tinker_contact_neighbours_unlisted_distance(self, q_to) > travel)
        return;
    list_pairs(self, q_to, fmax(reach, travel) + longest_way(self->contacts, q_from, q_to));
}
