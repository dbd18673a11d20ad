/* Setting up and starting contact as impulses. */
#include <math.h>

#include "physics/contact/contacts.h"
#include "physics/impulse/impulse-private.h"
#include "physics/model/model-data.h"
#include "physics/system/system.h"

/* Contacts that there is room for at first, beside one a body. */
#define EXPECTED 16

static void read_plate(TinkerImpulses *self, int32_t number, int end)
{
    const TinkerPlate *from = &self->contacts->plates[number];
    const TinkerPoint *centre = &self->model->point[from->point];
    TinkerImpulsePlate *plate = &self->plates[number];
    const double *n = plate->normal;
    plate->top[end] = n[0] * centre->x + n[1] * centre->y + from->half_height;
    plate->middle[end] = n[1] * centre->x - n[0] * centre->y;
    const double velocity[2] = {centre->vx, centre->vy};
    for (int k = 0; k < 2; k++) {
        plate->mean[k] = end == 0 ? velocity[k] : 0.5 * (plate->mean[k] + velocity[k]);
        plate->velocity[k] = velocity[k];
    }
}

static void open_plates(TinkerImpulses *self)
{
    const TinkerContacts *contacts = self->contacts;
    self->plates = g_new0(TinkerImpulsePlate, contacts->plate_count);
    for (int32_t i = 0; i < contacts->plate_count; i++) {
        const TinkerPlate *from = &contacts->plates[i];
        self->plates[i] = (TinkerImpulsePlate){
            .normal = {from->normal[0], from->normal[1]},
            .half_width = from->half_width,
            .moving = from->moving,
        };
        read_plate(self, i, 0);
        read_plate(self, i, 1);
    }
}

static void allot(TinkerImpulses *self)
{
    const gsize n = (gsize)MAX(self->model->coordinates, 1);
    double **arrays[] = {&self->from.q, &self->from.v, &self->to.q, &self->to.v, &self->a, &self->velocity};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_new0(double, n);
    self->from.books = g_new0(double, TINKER_BOOK_COUNT + 1);
    self->power = g_new0(double, TINKER_BOOK_COUNT + 1);
    self->orientation = g_new(double, n);
    for (gsize i = 0; i < n; i++)
        self->orientation[i] = NAN;
    guint room = (guint)self->model->bodies + EXPECTED;
    self->next = g_array_sized_new(FALSE, TRUE, sizeof(TinkerContact), room);
    self->held = g_array_sized_new(FALSE, TRUE, sizeof(TinkerImpulseTouch), EXPECTED);
    self->chosen = g_array_sized_new(FALSE, TRUE, sizeof(int32_t), EXPECTED);
    self->laws = g_array_sized_new(FALSE, TRUE, sizeof(TinkerContact), EXPECTED);
    g_array_set_size(self->contacts->closed, room);
    tinker_contacts_open_all(self->contacts); /* whatever ran before */
}

void *tinker_impulse_create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    TinkerModelSystem *context = system->context;
    TinkerModel *model = context->model;
    if (model->contacts == NULL || system->size != model->coordinates) return NULL;
    TinkerImpulses *self = g_new0(TinkerImpulses, 1);
    self->context = context;
    self->system = system;
    self->model = model;
    self->contacts = model->contacts;
    self->last_impact = -INFINITY;
    self->contacts->impulses = TRUE;
    allot(self);
    open_plates(self);
    tinker_contact_neighbours_init(&self->neighbours, self->contacts);
    self->pile = tinker_pile_new(self->contacts);
    return self;
}

void tinker_impulse_destroy(void *data)
{
    TinkerImpulses *self = data;
    tinker_contact_neighbours_clear(&self->neighbours);
    GArray *lists[] = {self->next, self->held, self->chosen, self->laws};
    for (gsize i = 0; i < G_N_ELEMENTS(lists); i++)
        g_array_unref(lists[i]);
    tinker_pile_free(self->pile);
    tinker_contact_reach_clear(&self->reach);
    gpointer arrays[] = {self->plates,     self->orientation, self->from.q, self->from.v,
                         self->from.books, self->to.q,        self->to.v,   self->a,
                         self->power,      self->velocity,    self->room,   self->delassus};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

/* At the first step: what touches and does not part rests, or slides. */
void tinker_impulse_start(TinkerImpulses *self, const TinkerState *state)
{
    TinkerContacts *contacts = self->contacts;
    const double extent =
        hypot(self->context->box[2] - self->context->box[0], self->context->box[3] - self->context->box[1]);
    double slow = TINKER_START_SLOW * self->context->speed;
    self->least_reach = isfinite(extent) ? TINKER_LEAST_NEIGHBOURHOOD * extent : 0;
    g_array_set_size(contacts->closed, 0);
    for (int32_t i = 0; i < self->model->bodies; i++) {
        if (isnan(contacts->half_height[i]) || tinker_pile_has(self->pile, i)) continue;
        const double *x = state->q + 2 * i, *v = state->v + 2 * i;
        for (int32_t k = 0; k < contacts->plate_count; k++) {
            const TinkerImpulsePlate *plate = &self->plates[k];
            const double *n = plate->normal, u[2] = {v[0] - plate->velocity[0], v[1] - plate->velocity[1]};
            const double along = n[1] * u[0] - n[0] * u[1], middle = tinker_impulse_along(plate, x, 0);
            gboolean touches = fabs(tinker_impulse_gap(self, plate, i, x, 0)) <= TINKER_TOUCHING &&
                               fabs(middle) <= plate->half_width + TINKER_TOUCHING &&
                               fabs(n[0] * u[0] + n[1] * u[1]) <= slow;
            if (!touches) continue;
            TinkerContactMode mode = along > 0 ? TINKER_CONTACT_SLIP_FORWARD : TINKER_CONTACT_SLIP_BACKWARD;
            if (fabs(along) <= slow && tinker_contact_surface(contacts, i, k).static_friction > 0)
                mode = TINKER_CONTACT_STICK;
            TinkerContact contact = {.body = i, .plate = k, .mode = mode, .anchor = middle};
            g_array_append_val(contacts->closed, contact);
        }
    }
}

void tinker_impulse_read_plates(TinkerImpulses *self, int end)
{
    for (int32_t i = 0; self->contacts->moving_plates > 0 && i < self->contacts->plate_count; i++)
        if (self->plates[i].moving) read_plate(self, i, end);
}
