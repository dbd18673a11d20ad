/* The step: velocities of all bodies by what is applied to them, then each body's way, or those of bodies on
 * constraints together. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse-private.h"
#include "physics/impulse/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

/* Whether a body is solved for with all that are on constraints. */
static gboolean is_held(const TinkerImpulses *self, int32_t body)
{
    return self->contacts->held[body] && !tinker_pile_has(self->pile, body);
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
    for (int32_t i = 0; i < model->coordinates; i++)
        if (is_held(self, tinker_model_moved_by(model, i)))
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
        tinker_impulse_turn(self, body, at->plate);
        if (!at->bounces) tinker_impulse_close(self, at, at->normal, at->friction, q);
    }
}

/* v* of bodies on constraints, which are solved together, becomes v'. */
static gboolean solve_held(TinkerImpulses *self, TinkerState *state)
{
    for (int32_t i = 0; i < self->model->coordinates; i++)
        if (is_held(self, tinker_model_moved_by(self->model, i))) state->v[i] += self->h * self->a[i];
    memcpy(self->velocity, state->v, (gsize)self->model->coordinates * sizeof(double));
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
    if (self->pile != NULL) tinker_pile_step(self, state);
    for (int32_t i = 0; i < self->model->bodies; i++) {
        double *q = state->q + 2 * i, *v = state->v + 2 * i;
        while (next < contacts->closed->len && tinker_contacts_closed(contacts, next)->body < i)
            next++;
        if (tinker_pile_has(self->pile, i)) continue;
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
    for (int32_t i = 2 * self->model->bodies; i < self->model->coordinates; i++) { /* what turns */
        if (tinker_pile_has(self->pile, tinker_model_moved_by(self->model, i))) continue;
        if (!any_held || !contacts->held[tinker_model_moved_by(self->model, i)]) state->v[i] += self->h * self->a[i];
        state->q[i] += self->h * state->v[i];
    }
    return TRUE;
}

static double kinetic_energy(const TinkerModel *model, const double *v)
{
    double sum = 0;
    for (int32_t i = 0; i < model->coordinates; i++)
        sum += 0.5 * model->coordinate_mass[i] * v[i] * v[i];
    return sum;
}

/* Onto the rows at the end of the step. Velocities of a pile come off the motion's chord there, by an impulse of the
 * order of the step: of what it gives, that on supports which move is theirs. */
static TinkerStatus project(TinkerImpulses *self, TinkerState *state)
{
    const TinkerSystem *system = self->system;
    const TinkerModel *model = self->model;
    const gboolean give = self->pile != NULL && self->pile->joints != NULL && tinker_pile_joints_are_moved(self->pile);
    const double before = give ? kinetic_energy(model, state->v) : 0, projected = self->context->projection_work;
    int32_t moved;
    if ((system->flags & TINKER_SYSTEM_CONSTRAINED) == 0) return TINKER_OK;
    const TinkerStatus status = system->project(system->context, state->t, state->q, state->v, &moved);
    if (give && status == TINKER_OK)
        self->work[TINKER_BOOK_SUPPORT_MOTION] +=
            kinetic_energy(model, state->v) - before -
            (self->context->projection_work - projected - model->constraints.work);
    return status;
}

static TinkerStatus try_step(TinkerImpulses *self, TinkerState *state, double limit)
{
    const TinkerSystem *system = self->system;
    TinkerStatus status = system->acceleration(system->context, state->t, state->q, state->v, self->a,
                                               system->books > 0 ? self->power : NULL);
    if (status != TINKER_OK) return status;
    tinker_impulse_read_plates(self, 0);
    if (!self->started) tinker_impulse_start(self, state);
    status = tinker_model_set_time(self->model, limit);
    if (status != TINKER_OK) return status;
    tinker_impulse_read_plates(self, 1);
    if (!move_bodies(self, state)) return TINKER_FAILED;
    for (int32_t i = 0; i < system->books; i++)
        state->books[i] += self->h * self->power[i];
    state->t = limit;
    return project(self, state);
}

static void note_unsolved(TinkerImpulses *self, double off)
{
    TinkerUnsolved *all = &self->context->unsolved;
    if (all->steps++ == 0) all->first = self->to.t;
    if (off <= all->most) return;
    all->most = off;
    all->most_at = self->to.t;
}

/* Notes what was done. */
static void keep(TinkerImpulses *self, const TinkerState *state)
{
    const gsize bytes = (gsize)self->model->coordinates * sizeof(double);
    memcpy(self->to.q, state->q, bytes);
    memcpy(self->to.v, state->v, bytes);
    GArray *closed = self->contacts->closed;
    self->contacts->closed = self->next;
    self->next = closed;
    for (int k = 0; k < TINKER_BOOK_COUNT; k++)
        self->context->impact_work[k] += self->work[k];
    self->context->projection_work += self->parted;
    if (self->pile != NULL && self->pile->unsolved > 0) note_unsolved(self, self->pile->unsolved);
    self->started = TRUE;
}

static void go_back(const TinkerImpulses *self, TinkerState *state)
{
    const gsize bytes = (gsize)self->model->coordinates * sizeof(double);
    memcpy(state->q, self->from.q, bytes);
    memcpy(state->v, self->from.v, bytes);
    memcpy(state->books, self->from.books, (gsize)self->system->books * sizeof(double));
    state->t = self->from.t;
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    TinkerImpulses *self = data;
    const gsize bytes = (gsize)self->model->coordinates * sizeof(double);
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
    self->parted = 0;
    TinkerStatus status = isfinite(self->h) && self->h > 0 ? try_step(self, state, limit) : TINKER_FAILED;
    if (status == TINKER_OK) {
        keep(self, state);
        return TINKER_OK;
    }
    go_back(self, state);
    report->failure = N_("the system could not be evaluated within the step (a smaller step may succeed)");
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
    for (int32_t i = 0; i < self->model->coordinates; i++) {
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

double tinker_impulse_speed_noise(const void *stepper)
{
    const TinkerImpulses *self = stepper;
    return self->pile != NULL ? TINKER_PILE_RESTS * self->pile->largest : 0;
}

/* By what presses: on the first of its bodies (k is 0), or the opposite on the second. */
static void accelerate(const TinkerModel *model, const TinkerPressing *pressing, int k, double *a)
{
    const int32_t body = k == 0 ? pressing->body : pressing->by, turn = tinker_model_turn_of(model, body);
    const double share = (k == 0 ? 1 : -1) * model->inverse_mass[body];
    const double *n = pressing->normal, press = pressing->press, friction = pressing->friction;
    a[2 * body] += share * (press * n[0] + friction * n[1]);
    a[2 * body + 1] += share * (press * n[1] - friction * n[0]);
    if (turn >= 0) a[turn] += share * (press * pressing->arm[k] + friction * pressing->slide[k]);
}

void tinker_impulse_add_accelerations(const TinkerContacts *contacts, double *a)
{
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const double *n = contacts->plates[contact->plate].normal, share = contacts->model->inverse_mass[contact->body];
        a[2 * contact->body] += share * (contact->normal * n[0] + contact->friction * n[1]);
        a[2 * contact->body + 1] += share * (contact->normal * n[1] - contact->friction * n[0]);
    }
    for (guint i = 0; i < contacts->pressings->len; i++) {
        const TinkerPressing *each = &g_array_index(contacts->pressings, TinkerPressing, i);
        accelerate(contacts->model, each, 0, a);
        if (each->by < contacts->model->bodies) accelerate(contacts->model, each, 1, a);
    }
}

const TinkerIntegrator *tinker_method_without_contact(const TinkerIntegrator *method)
{
    return tinker_method_solves_contact(method) ? tinker_integrator_builtin("semi-implicit-euler") : method;
}

const TinkerIntegrator tinker_integrator_impulse = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT | TINKER_METHOD_SOLVES_CONTACT,
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
    .create = tinker_impulse_create,
    .destroy = tinker_impulse_destroy,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
