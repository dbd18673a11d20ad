/* The step: velocities of all bodies by what is applied to them, then each body's way, or those of bodies on constraints
 * together. */
#include <math.h>
#include <string.h>

#include "physics/impulse-private.h"

/* Of the extent: see TinkerContactNeighbours. */
#define LEAST_SHARE 1e-3
/* A start that slides along a top slower than this share of the largest speed may stick. */
#define START_SLOW 1e-9
/* And one that parts slower than this rests. */
#define STILL 1e-12
/* Contacts that there is room for at first, beside one a body. */
#define EXPECTED 16

/* Setting up -------------------------------------------------------------------------------------------------------- */

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
            .static_friction = from->static_friction,
            .dynamic_friction = from->dynamic_friction,
            .restitution = from->restitution,
            .moving = from->moving,
        };
        read_plate(self, i, 0);
        read_plate(self, i, 1);
    }
}

/* Bodies that constraints join, known by the first of them. */
static void find_groups(TinkerImpulses *self)
{
    const TinkerConstraints *all = &self->model->constraints;
    gboolean changed = all->rows > 0;
    for (int32_t i = 0; i < self->model->bodies; i++)
        self->group[i] = i;
    while (changed) {
        changed = FALSE;
        for (int32_t row = 0; row < all->rows; row++) {
            int32_t least = G_MAXINT32;
            for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
                if (all->points[e] < self->model->bodies) least = MIN(least, self->group[all->points[e]]);
            for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
                if (all->points[e] >= self->model->bodies || self->group[all->points[e]] == least) continue;
                self->group[all->points[e]] = least;
                changed = TRUE;
            }
        }
    }
}

static void allot(TinkerImpulses *self)
{
    const gsize n = 2 * (gsize)MAX(self->model->bodies, 1);
    double **arrays[] = {&self->from.q, &self->from.v, &self->to.q, &self->to.v, &self->a, &self->velocity};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_new0(double, n);
    self->from.books = g_new0(double, TINKER_BOOK_COUNT + 1);
    self->power = g_new0(double, TINKER_BOOK_COUNT + 1);
    self->orientation = g_new(double, n);
    for (gsize i = 0; i < n; i++)
        self->orientation[i] = NAN;
    self->group = g_new(int32_t, n);
    guint room = (guint)self->model->bodies + EXPECTED;
    self->next = g_array_sized_new(FALSE, TRUE, sizeof(TinkerContact), room);
    self->held = g_array_sized_new(FALSE, TRUE, sizeof(TinkerImpulseTouch), EXPECTED);
    self->chosen = g_array_sized_new(FALSE, TRUE, sizeof(int32_t), EXPECTED);
    self->laws = g_array_sized_new(FALSE, TRUE, sizeof(TinkerContact), EXPECTED);
    g_array_set_size(self->contacts->closed, room);
    g_array_set_size(self->contacts->closed, 0);
    tinker_contacts_list_rows(self->contacts); /* none: whatever ran before */
}

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    TinkerModelSystem *context = system->context;
    TinkerModel *model = context->model;
    if (model->contacts == NULL || system->size != 2 * model->bodies) return NULL;
    TinkerImpulses *self = g_new0(TinkerImpulses, 1);
    self->context = context;
    self->system = system;
    self->model = model;
    self->contacts = model->contacts;
    self->last_impact = -INFINITY;
    self->contacts->impulses = TRUE;
    allot(self);
    open_plates(self);
    find_groups(self);
    tinker_contact_neighbours_init(&self->neighbours, self->contacts);
    return self;
}

static void destroy(void *data)
{
    TinkerImpulses *self = data;
    tinker_contact_neighbours_clear(&self->neighbours);
    GArray *lists[] = {self->next, self->held, self->chosen, self->laws};
    for (gsize i = 0; i < G_N_ELEMENTS(lists); i++)
        g_array_unref(lists[i]);
    gpointer arrays[] = {self->plates, self->orientation, self->from.q, self->from.v, self->from.books, self->to.q,
                         self->to.v,   self->a,           self->power,  self->group,  self->room,       self->velocity};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

/* At the first step: what touches and does not part rests, or slides. */
static void close_start(TinkerImpulses *self, const TinkerState *state)
{
    TinkerContacts *contacts = self->contacts;
    const double extent =
        hypot(self->context->box[2] - self->context->box[0], self->context->box[3] - self->context->box[1]);
    double slow = START_SLOW * self->context->speed;
    self->least_reach = isfinite(extent) ? LEAST_SHARE * extent : 0;
    g_array_set_size(contacts->closed, 0);
    for (int32_t i = 0; i < self->model->bodies; i++) {
        if (isnan(contacts->half_height[i])) continue;
        const double *x = state->q + 2 * i, *v = state->v + 2 * i;
        for (int32_t k = 0; k < contacts->plate_count; k++) {
            const TinkerImpulsePlate *plate = &self->plates[k];
            const double *n = plate->normal, u[2] = {v[0] - plate->velocity[0], v[1] - plate->velocity[1]};
            const double along = n[1] * u[0] - n[0] * u[1], middle = tinker_impulse_along(plate, x, 0);
            gboolean touches = fabs(tinker_impulse_gap(self, plate, i, x, 0)) <= TINKER_TOUCHING &&
                               fabs(middle) <= plate->half_width + TINKER_TOUCHING &&
                               fabs(n[0] * u[0] + n[1] * u[1]) <= fmax(STILL * self->context->speed, slow);
            if (!touches) continue;
            TinkerContactMode mode = along > 0 ? TINKER_CONTACT_SLIP_FORWARD : TINKER_CONTACT_SLIP_BACKWARD;
            if (fabs(along) <= slow && plate->static_friction > 0) mode = TINKER_CONTACT_STICK;
            TinkerContact contact = {.body = i, .plate = k, .mode = mode, .anchor = middle};
            g_array_append_val(contacts->closed, contact);
        }
    }
}

/* Steps ------------------------------------------------------------------------------------------------------------- */

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

static void read_moving(TinkerImpulses *self, int end)
{
    for (int32_t i = 0; self->contacts->moving_plates > 0 && i < self->contacts->plate_count; i++)
        if (self->plates[i].moving) read_plate(self, i, end);
}

/* Bodies on constraints: what contacts did beside the constraints' answer to it goes to what moves. */
static void finish_held(TinkerImpulses *self, TinkerState *state)
{
    const TinkerModel *model = self->model;
    double total = 0, before = 0;
    for (int k = 0; k < TINKER_BOOK_COUNT; k++)
        before += self->work[k];
    for (guint i = 0; i < self->held->len; i++) {
        const TinkerImpulseTouch *touch = &g_array_index(self->held, TinkerImpulseTouch, i);
        if (touch->is != TINKER_CONTACT_OPEN)
            tinker_impulse_book(self, touch, touch->normal, touch->friction, self->from.v + 2 * touch->body,
                                state->v + 2 * touch->body);
    }
    for (int k = 0; k < TINKER_BOOK_COUNT; k++)
        before -= self->work[k];
    for (int32_t i = 0; i < 2 * model->bodies; i++)
        if (self->contacts->held[i / 2])
            total +=
                0.5 * model->coordinate_mass[i] * (state->v[i] - self->velocity[i]) * (state->v[i] + self->from.v[i]);
    self->work[TINKER_BOOK_SUPPORT_MOTION] += total + before;
}

static void move_held(TinkerImpulses *self, int32_t body, guint *touch, double *q, const double *v)
{
    for (int k = 0; k < 2; k++)
        q[k] += self->h * v[k];
    for (; *touch < self->held->len; ++*touch) {
        const TinkerImpulseTouch *at = &g_array_index(self->held, TinkerImpulseTouch, *touch);
        if (at->body != body) return;
        if (at->is == TINKER_CONTACT_OPEN) continue;
        self->orientation[body] = self->contacts->plates[at->plate].orientation;
        if (!at->bounces) tinker_impulse_close(self, at, at->normal, at->friction, q);
    }
}

/* v* of bodies on constraints, which are solved together, becomes v'. */
static gboolean solve_held(TinkerImpulses *self, TinkerState *state)
{
    for (int32_t i = 0; i < 2 * self->model->bodies; i++)
        if (self->contacts->held[i / 2]) state->v[i] += self->h * self->a[i];
    memcpy(self->velocity, state->v, 2 * (gsize)self->model->bodies * sizeof(double));
    if (!tinker_impulse_solve_held(self, state->q, state->v)) return FALSE;
    finish_held(self, state);
    return TRUE;
}

static gboolean move_bodies(TinkerImpulses *self, TinkerState *state)
{
    TinkerContacts *contacts = self->contacts;
    const gboolean any_held = self->model->constraints.rows > 0;
    guint next = 0, touch = 0;
    g_array_set_size(self->next, 0);
    if (any_held && !solve_held(self, state)) return FALSE;
    for (int32_t i = 0; i < self->model->bodies; i++) {
        double *q = state->q + 2 * i, *v = state->v + 2 * i;
        while (next < contacts->closed->len && tinker_contacts_closed(contacts, next)->body < i)
            next++;
        if (any_held && contacts->held[i]) {
            move_held(self, i, &touch, q, v);
        } else if (!isnan(contacts->half_height[i])) {
            if (!tinker_impulse_move_free(self, i, next, q, v)) return FALSE;
        } else {
            for (int k = 0; k < 2; k++) {
                v[k] += self->h * self->a[2 * i + k];
                q[k] += self->h * v[k];
            }
        }
    }
    return TRUE;
}

static TinkerStatus try_step(TinkerImpulses *self, TinkerState *state, double limit)
{
    const TinkerSystem *system = self->system;
    TinkerStatus status = system->acceleration(system->context, state->t, state->q, state->v, self->a,
                                               system->books > 0 ? self->power : NULL);
    if (status != TINKER_OK) return status;
    read_moving(self, 0);
    if (!self->started) close_start(self, state);
    status = tinker_model_set_time(self->model, limit);
    if (status != TINKER_OK) return status;
    read_moving(self, 1);
    if (!move_bodies(self, state)) return TINKER_FAILED;
    for (int32_t i = 0; i < system->books; i++)
        state->books[i] += self->h * self->power[i];
    state->t = limit;
    int32_t moved;
    return (system->flags & TINKER_SYSTEM_CONSTRAINED) != 0
               ? system->project(system->context, limit, state->q, state->v, &moved)
               : TINKER_OK;
}

/* Notes what was done. */
static void keep(TinkerImpulses *self, const TinkerState *state)
{
    const gsize bytes = 2 * (gsize)self->model->bodies * sizeof(double);
    memcpy(self->to.q, state->q, bytes);
    memcpy(self->to.v, state->v, bytes);
    GArray *closed = self->contacts->closed;
    self->contacts->closed = self->next;
    self->next = closed;
    for (int k = 0; k < TINKER_BOOK_COUNT; k++)
        self->context->impact_work[k] += self->work[k];
    self->started = TRUE;
}

static void go_back(const TinkerImpulses *self, TinkerState *state)
{
    const gsize bytes = 2 * (gsize)self->model->bodies * sizeof(double);
    memcpy(state->q, self->from.q, bytes);
    memcpy(state->v, self->from.v, bytes);
    memcpy(state->books, self->from.books, (gsize)self->system->books * sizeof(double));
    state->t = self->from.t;
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    TinkerImpulses *self = data;
    const gsize bytes = 2 * (gsize)self->model->bodies * sizeof(double);
    self->h = limit - state->t;
    report->rejected = 0;
    report->t_from = self->from.t = state->t;
    report->step = self->h;
    report->error = 0;
    report->failure = NULL;
    self->to.t = limit;
    memcpy(self->from.q, state->q, bytes);
    memcpy(self->from.v, state->v, bytes);
    memcpy(self->from.books, state->books, (gsize)self->system->books * sizeof(double));
    memset(self->work, 0, sizeof(self->work));
    TinkerStatus status = isfinite(self->h) && self->h > 0 ? try_step(self, state, limit) : TINKER_FAILED;
    if (status == TINKER_OK) {
        keep(self, state);
        return TINKER_OK;
    }
    go_back(self, state);
    report->failure = "the system could not be evaluated within the step (a smaller step may succeed)";
    return TINKER_FAILED;
}

static void restart(void *data)
{
    (void)data;
}

/* Straight from end to end, and out of what moves towards it. */
static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    TinkerImpulses *self = data;
    const double share = (t - self->from.t) / (self->to.t - self->from.t);
    for (int32_t i = 0; i < 2 * self->model->bodies; i++) {
        q[i] = self->from.q[i] + share * (self->to.q[i] - self->from.q[i]);
        v[i] = self->from.v[i] + share * (self->to.v[i] - self->from.v[i]);
    }
    for (int32_t i = 0; books != NULL && i < self->system->books; i++)
        books[i] = self->from.books[i] + (t - self->from.t) * self->power[i];
    if (self->contacts->moving_plates == 0) return TINKER_OK;
    const TinkerStatus status = tinker_model_set_time(self->model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(self->model, q, v);
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        const double *n = self->plates[contact->plate].normal;
        const double gap = tinker_contact_place(self->contacts, contact->body, contact->plate).gap;
        if (!(gap < 0) || !self->plates[contact->plate].moving) continue;
        q[2 * contact->body] -= gap * n[0];
        q[2 * contact->body + 1] -= gap * n[1];
    }
    return TINKER_OK;
}

double tinker_impulse_orientation(const void *stepper, int32_t body)
{
    const TinkerImpulses *self = stepper;
    return self->orientation[body];
}

double tinker_impulse_last_impact(const void *stepper)
{
    const TinkerImpulses *self = stepper;
    return self->last_impact;
}

void tinker_impulse_add_accelerations(const TinkerContacts *contacts, double *a)
{
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const double *n = contacts->plates[contact->plate].normal, share = contacts->model->inverse_mass[contact->body];
        a[2 * contact->body] += share * (contact->normal * n[0] + contact->friction * n[1]);
        a[2 * contact->body + 1] += share * (contact->normal * n[1] - contact->friction * n[0]);
    }
}

const TinkerIntegrator tinker_integrator_impulse = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT,
    .id = "impulse",
    .title = "Contact as impulses (Moreau, Jean), order 1",
    .summary = "Many bodies that touch: one velocity solve a step, no events.",
    .source = "J. J. Moreau 1988; M. Jean 1999; V. Acary, B. Brogliato, Numerical Methods for Nonsmooth Dynamical "
              "Systems, Springer 2008",
    .order = 1,
    .dense_order = 1,
    .evaluations_per_step = 1,
    .imaginary_limit = 2.0,
    .real_limit = 2.0,
    .create = create,
    .destroy = destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
