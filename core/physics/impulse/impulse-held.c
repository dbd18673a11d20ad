/* Bodies on constraints: the contacts of those that constraints join are solved together, for velocities at which no
 * gap is negative at the end of the step. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse-private.h"
#include "physics/impulse/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

static TinkerImpulseTouch *held(const TinkerImpulses *self, guint number)
{
    return &g_array_index(self->held, TinkerImpulseTouch, number);
}

/* The least velocity along the normal: out of the plate by the end of the step, or what restitution asks for. */
static void find_least(const TinkerImpulses *self, TinkerImpulseTouch *touch, const double *q)
{
    const TinkerImpulsePlate *plate = &self->plates[touch->plate];
    const double *n = plate->normal, *x = q + 2 * touch->body, rest = tinker_dot(n, plate->velocity);
    const double gap = tinker_impulse_gap(self, plate, touch->body, x, 1);
    const double rounding = TINKER_GAP_ROUNDING *
                            (fabs(x[0]) + fabs(x[1]) + fabs(plate->top[1]) + self->contacts->half_height[touch->body]);
    touch->least = fabs(gap) <= rounding ? 0 : -gap / self->h;
    if (touch->was != TINKER_CONTACT_OPEN || touch->share > 1) return;
    const double approach = tinker_dot(n, self->from.v + 2 * touch->body) - rest;
    touch->strikes = approach < -self->h * fabs(tinker_dot(n, self->a + 2 * touch->body));
    if (!touch->strikes) return;
    const double e = tinker_contact_surface(self->contacts, touch->body, touch->plate).restitution;
    touch->bounces = e > 0 && -e * approach + rest > touch->least;
    if (touch->bounces) touch->least = rest - e * approach;
}

/* Whether a body that does not meet the plate of its own may be brought there by what other contacts do to it. */
static gboolean may_be_pushed(const TinkerImpulses *self, int32_t body, int32_t number, gboolean closed,
                              const double *x, const double *v_star)
{
    const TinkerImpulsePlate *plate = &self->plates[number];
    const double *v = self->from.v + 2 * body, end[2] = {x[0] + self->h * v_star[0], x[1] + self->h * v_star[1]};
    const double travel = self->h * (hypot(v_star[0], v_star[1]) + hypot(v[0], v[1]));
    if (fabs(tinker_impulse_along(plate, closed ? x : end, closed ? 0 : 1)) > plate->half_width) return FALSE;
    return closed || (tinker_impulse_gap(self, plate, body, x, 0) >= 0 &&
                      tinker_impulse_gap(self, plate, body, end, 1) <= travel);
}

/* All that the step may bring together or holds together. */
static void list_held(TinkerImpulses *self, const double *q, const double *v_star)
{
    const TinkerContacts *contacts = self->contacts;
    guint next = 0;
    g_array_set_size(self->held, 0);
    for (int32_t i = 0; i < self->model->bodies; i++) {
        while (next < contacts->closed->len && tinker_contacts_closed(contacts, next)->body < i)
            next++;
        if (!contacts->held[i] || isnan(contacts->half_height[i]) || tinker_pile_has(self->pile, i)) continue;
        const GArray *near = tinker_impulse_neighbours(self, i, q + 2 * i, v_star + 2 * i, self->h);
        for (guint k = 0; k < near->len; k++) {
            const int32_t plate = g_array_index(near, int32_t, k);
            const TinkerContact *closed = tinker_impulse_closed(self, i, plate, next);
            const double share = tinker_impulse_meeting(self, i, plate, closed != NULL, q + 2 * i, v_star + 2 * i, 0);
            if (share > 1 && !may_be_pushed(self, i, plate, closed != NULL, q + 2 * i, v_star + 2 * i)) continue;
            TinkerImpulseTouch touch = {
                .body = i,
                .plate = plate,
                .was = closed != NULL ? closed->mode : TINKER_CONTACT_OPEN,
                .anchor = closed != NULL ? closed->anchor : 0,
                .share = share,
            };
            find_least(self, &touch, q);
            g_array_append_val(self->held, touch);
        }
    }
}

static gboolean make_larger(const TinkerImpulses *self, double **array, gsize *size, gsize wanted, gsize contacts)
{
    if (wanted <= *size) return TRUE;
    g_free(*array);
    *size = 2 * wanted;
    *array = g_try_new(double, *size);
    if (*array != NULL) return TRUE;
    *size = 0;
    tinker_contacts_lack_memory(self->contacts, contacts);
    return FALSE;
}

/* FALSE, with the model's failure set: no memory. */
static gboolean make_matrix(TinkerImpulses *self, gsize count)
{
    return make_larger(self, &self->delassus, &self->delassus_size, 4 * count * count, count);
}

/* For velocities, least ones, laws and touches. FALSE, with the model's failure set: no memory. */
static gboolean make_room(TinkerImpulses *self, gsize count)
{
    const gsize size = 2 * count + count + tinker_impulse_laws_room(count) + count;
    return make_larger(self, &self->room, &self->room_size, size, count);
}

/* Contacts of one group, from `first` on. */
static void choose_group(TinkerImpulses *self, guint first)
{
    const int32_t group = self->contacts->group[held(self, first)->body];
    g_array_set_size(self->chosen, 0);
    g_array_set_size(self->laws, 0);
    for (guint i = first; i < self->held->len; i++) {
        if (self->contacts->group[held(self, i)->body] != group) continue;
        const int32_t number = (int32_t)i;
        const TinkerContact contact = {.body = held(self, i)->body, .plate = held(self, i)->plate};
        g_array_append_val(self->chosen, number);
        g_array_append_val(self->laws, contact);
    }
}

static void add_push(TinkerImpulses *self, const TinkerImpulseTouch *touch, double *v)
{
    const double *n = self->plates[touch->plate].normal;
    if (touch->normal == 0 && touch->friction == 0) return;
    tinker_contacts_add_push(self->contacts, touch->body, touch->normal * n[0] + touch->friction * n[1],
                             touch->normal * n[1] - touch->friction * n[0], v);
}

/* What sticks has the velocity of its plate, to the last bit. */
static void settle(const TinkerImpulses *self, const TinkerImpulseTouch *touch, double *v)
{
    const TinkerImpulsePlate *plate = &self->plates[touch->plate];
    if (touch->is == TINKER_CONTACT_STICK && touch->least == tinker_dot(plate->normal, plate->velocity))
        memcpy(v + 2 * touch->body, plate->velocity, 2 * sizeof(double));
}

/* How the chosen contacts answer to one another: many by solves, few by a matrix. FALSE, with the model's failure set:
 * no memory. */
static gboolean find_answers(TinkerImpulses *self, TinkerImpact *impact)
{
    const int32_t count = impact->count;
    const TinkerContact *touching = (const TinkerContact *)(const void *)self->laws->data;
    if (count > TINKER_FEW_CONTACTS) {
        if (!tinker_contact_reach_take(&self->reach, self->contacts, touching, count)) {
            tinker_contacts_lack_memory(self->contacts, (gsize)count);
            return FALSE;
        }
        if (self->reach.motion.context != NULL) impact->motion = &self->reach.motion;
        if (impact->motion != NULL) return TRUE;
    }
    if (!make_matrix(self, (gsize)count)) return FALSE;
    tinker_contacts_delassus(self->contacts, touching, count, self->delassus);
    impact->delassus = self->delassus;
    return TRUE;
}

/* v* but for what constraints do not let be. Impulses change what they let be alone; where bodies stick at both ends of
 * a rod what is left, of second order in the step, would be a contradiction, which only as much stress as friction can
 * hold resolves. The projection after the step takes it away in any case. */
static const double *find_allowed(TinkerImpulses *self, const double *v)
{
    TinkerModel *model = self->model;
    TinkerConstraints *all = &model->constraints;
    double *allowed = self->contacts->accelerations;
    tinker_model_set_velocities(model, v);
    memcpy(allowed, v, (gsize)model->coordinates * sizeof(double));
    tinker_constraints_rates(model, all->asked);
    for (int32_t row = 0; row < all->rows; row++)
        all->asked[row] = -all->asked[row];
    tinker_constraints_change_speeds(model, all->asked, allowed);
    return allowed;
}

static gboolean solve_group(TinkerImpulses *self, double *v)
{
    const gsize count = self->chosen->len;
    if (!make_room(self, count)) return FALSE;
    const double *from = count > TINKER_FEW_CONTACTS ? find_allowed(self, v) : v;
    double *velocity = self->room, *least = velocity + 2 * count, *room = least + count;
    TinkerImpulseTouch **touches = (TinkerImpulseTouch **)(void *)(room + tinker_impulse_laws_room(count));
    for (gsize k = 0; k < count; k++) {
        TinkerImpulseTouch *touch = touches[k] = held(self, (guint)g_array_index(self->chosen, int32_t, k));
        const TinkerImpulsePlate *plate = &self->plates[touch->plate];
        const double *at = from + 2 * touch->body;
        velocity[2 * k] = tinker_dot(plate->normal, at);
        velocity[2 * k + 1] = tinker_along(plate->normal, at) - tinker_along(plate->normal, plate->velocity);
        least[k] = touch->least;
    }
    TinkerImpact impact = {.count = (int32_t)count, .velocity = velocity, .least = least};
    if (!find_answers(self, &impact) || !tinker_impulse_solve_laws(self, touches, &impact, room)) return FALSE;
    tinker_contacts_begin_pushes(self->contacts);
    for (gsize k = 0; k < count; k++)
        add_push(self, touches[k], v);
    tinker_contacts_end_pushes(self->contacts, v);
    for (gsize k = 0; k < count; k++)
        settle(self, touches[k], v);
    return TRUE;
}

gboolean tinker_impulse_solve_held(TinkerImpulses *self, const double *q, double *v)
{
    list_held(self, q, v);
    for (guint i = 0; i < self->held->len; i++) {
        gboolean solved = FALSE;
        for (guint k = 0; k < i && !solved; k++)
            solved = self->contacts->group[held(self, k)->body] == self->contacts->group[held(self, i)->body];
        if (solved) continue;
        choose_group(self, i);
        if (!solve_group(self, v)) return FALSE;
    }
    for (guint i = 0; i < self->held->len; i++)
        if (held(self, i)->strikes && held(self, i)->normal > 0) self->last_impact = self->to.t;
    return TRUE;
}
