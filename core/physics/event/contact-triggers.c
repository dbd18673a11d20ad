/* What ends a phase of a contact: its value at any state of a step, and below which level it has passed zero. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"

/* Triggers of one closed contact. */
#define MOST_OF_ONE 5

/* States on the way ------------------------------------------------------------------------------------------------ */

/* The bodies at time t within the last step. */
TinkerStatus tinker_contact_run_state_at(TinkerContactRun *self, double t, double **q, double **v)
{
    TinkerIslandRun *run = self->run;
    const TinkerState *near = t == self->from.t && t != run->state.t ? &self->from : &run->state;
    gsize bytes = (gsize)run->system.system.size * sizeof(double);
    TinkerStatus status = TINKER_OK;
    memcpy(self->node_x, near->q, bytes);
    memcpy(self->node_u, near->v, bytes);
    if (t != near->t) status = tinker_island_run_interpolate(run, t, self->node_x, self->node_u, NULL);
    *q = self->node_x;
    *v = self->node_u;
    if (self->in_plane || run->q == run->state.q) return status;
    tinker_linear_form_expand(run->island->linear, self->node_x, self->node_u, self->node_q, self->node_v);
    *q = self->node_q;
    *v = self->node_v;
    return status;
}

TinkerStatus tinker_contact_run_place_at(TinkerContactRun *self, double t, double **v)
{
    double *q;
    TinkerStatus status = tinker_contact_run_state_at(self, t, &q, v);
    if (status == TINKER_OK) status = tinker_model_set_time(self->model, t);
    if (status == TINKER_OK) tinker_model_set_state(self->model, q, *v);
    return status;
}

/* Brings the model to a state, and works out the forces of its closed contacts. */
TinkerStatus tinker_contact_run_look_at(TinkerContactRun *self, double t, const double *q, const double *v,
                                        double *power)
{
    self->looks++;
    TinkerModel *model = self->model;
    const gboolean closed = self->contacts->closed->len > 0;
    TinkerStatus status;
    if (closed || self->leaving->len > 0 || model->constraints.unilateral != NULL) {
        const TinkerSystem *system = &self->run->system.system;
        status = system->acceleration(system->context, t, q, v, self->force, power);
    } else {
        status = tinker_model_set_time(model, t);
        if (status == TINKER_OK) tinker_model_set_state(model, q, v);
    }
    self->looked_time = status == TINKER_OK && closed ? t : NAN; /* only evaluations of closed contacts are counted */
    self->looked_evaluation = self->contacts->evaluations;
    return status;
}

gboolean tinker_contact_run_has_looked(const TinkerContactRun *self, double t)
{
    return t == self->looked_time && self->contacts->evaluations == self->looked_evaluation;
}

/* How the contact opens, by the accelerations worked out last. */
static double parting_acceleration(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    if (trigger->row >= 0)
        return -tinker_constraints_own_row_times(self->model, trigger->row, self->force) -
               tinker_constraints_own_drift(self->model, trigger->row);
    const TinkerContact pair = {.body = trigger->body, .plate = trigger->plate};
    double along[2];
    tinker_contacts_relative_acceleration(self->contacts, &pair, self->force, along);
    return along[0];
}

/* How the contact speeds up the way it slips, by the accelerations worked out last. */
static double starting_acceleration(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerContact *contact = tinker_contacts_closed(self->contacts, (guint)trigger->closed);
    double along[2];
    tinker_contacts_relative_acceleration(self->contacts, contact, self->force, along);
    return contact->mode == TINKER_CONTACT_SLIP_FORWARD ? along[1] : -along[1];
}

/* A row is slack as long as g is below 0, and taut as long as it pulls. */
static double row_value(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerConstraints *all = &self->model->constraints;
    return trigger->kind == TINKER_TRIGGER_GAP ? -all->own_g[trigger->row] : -all->lambda[trigger->row];
}

/* What friction may be more on a contact that sticks, in a direction (1: along t, -1: against it). Corners of one edge
 * on another hold the body along one line: nothing determines how they share that, and they slip together, where it is
 * more than all of them can hold. */
static double friction_left(const TinkerContacts *contacts, guint number, double direction)
{
    const TinkerContact *contact = tinker_contacts_closed(contacts, number);
    const gboolean corner = tinker_contacts_is_gap(contacts, contact);
    double normal = contact->normal, friction = contact->friction;
    guint i = number;
    while (corner && i > 0 && tinker_contacts_closed(contacts, i - 1)->body == contact->body)
        i--;
    for (; corner && i < contacts->closed->len; i++) {
        const TinkerContact *other = tinker_contacts_closed(contacts, i);
        if (other->body != contact->body) break;
        if (other == contact || !tinker_contacts_stick_together(contacts, contact, other)) continue;
        normal += other->normal;
        friction += other->friction;
    }
    const TinkerSurface surface = tinker_contact_surface(contacts, contact->body, contact->plate);
    return surface.static_friction * normal - direction * friction;
}

double tinker_trigger_value(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerContacts *contacts = self->contacts;
    if (trigger->kind == TINKER_TRIGGER_LEAVING) return parting_acceleration(self, trigger);
    if (trigger->kind == TINKER_TRIGGER_STARTING) return starting_acceleration(self, trigger);
    if (trigger->row >= 0) return row_value(self, trigger);
    const TinkerContact *contact =
        trigger->closed >= 0 ? tinker_contacts_closed(contacts, (guint)trigger->closed) : NULL;
    if (trigger->kind == TINKER_TRIGGER_NORMAL) return contact->normal;
    if (trigger->kind == TINKER_TRIGGER_FORWARD) return friction_left(contacts, (guint)trigger->closed, 1);
    if (trigger->kind == TINKER_TRIGGER_BACKWARD) return friction_left(contacts, (guint)trigger->closed, -1);
    if (trigger->kind == TINKER_TRIGGER_GAP && contacts->plates[trigger->plate].gap != NULL)
        return tinker_contact_gap_alone(contacts, trigger->plate); /* most of what bodies that turn have watched */
    const TinkerContactPlace place = tinker_contact_place(contacts, trigger->body, trigger->plate);
    const double half_width = contacts->plates[trigger->plate].half_width;
    switch (trigger->kind) {
    case TINKER_TRIGGER_GAP:
        return place.gap;
    case TINKER_TRIGGER_SPEED:
        return contact->mode == TINKER_CONTACT_SLIP_FORWARD ? place.tangential_speed : -place.tangential_speed;
    case TINKER_TRIGGER_END:
        return half_width - place.along;
    default:
        return half_width + place.along;
    }
}

TinkerStatus tinker_contact_run_value(TinkerContactRun *self, double t, const double *q, const double *v,
                                      const TinkerTrigger *trigger, double *value, double *power)
{
    TinkerStatus status = tinker_contact_run_look_at(self, t, q, v, power);
    if (status == TINKER_OK) *value = tinker_trigger_value(self, trigger);
    return status;
}

/* What is watched -------------------------------------------------------------------------------------------------- */

const TinkerTrigger *tinker_trigger_of_contact(const GArray *triggers, int32_t body, int32_t plate)
{
    for (guint i = 0; i < triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(triggers, TinkerTrigger, i);
        if (trigger->row < 0 && trigger->body == body && trigger->plate == plate) return trigger;
    }
    return NULL;
}

static void add_trigger(TinkerContactRun *self, TinkerTriggerKind kind, int32_t body, int32_t plate, int32_t closed)
{
    TinkerTrigger trigger = {kind, body, plate, closed, -1, 0};
    g_array_append_val(self->triggers, trigger);
}

/* Rows that hold in one direction only. */
static void watch_rows(TinkerContactRun *self)
{
    const TinkerConstraints *all = &self->model->constraints;
    for (int32_t row = 0; all->unilateral != NULL && row < all->rows; row++) {
        TinkerContactPair pair = {tinker_contacts_row_body(self->contacts, row), 0, row};
        if (!all->unilateral[row] || pair.body < 0) continue;
        TinkerTrigger trigger = {TINKER_TRIGGER_NORMAL, pair.body, 0, -1, row, 0};
        if (all->slack[row])
            trigger.kind = tinker_contact_run_leaves(self, &pair) ? TINKER_TRIGGER_LEAVING : TINKER_TRIGGER_GAP;
        g_array_append_val(self->triggers, trigger);
    }
}

/* Without friction the direction of sliding makes no difference, so that nobody watches it; both ends may come. */
static void watch_closed(TinkerContactRun *self, int32_t number)
{
    const TinkerContact *contact = tinker_contacts_closed(self->contacts, (guint)number);
    const TinkerPlate *plate = &self->contacts->plates[contact->plate];
    int32_t body = contact->body, on = contact->plate;
    const gboolean forward = contact->mode == TINKER_CONTACT_SLIP_FORWARD;
    const gboolean slips_freely = tinker_contact_surface(self->contacts, body, on).dynamic_friction == 0;
    /* what rolls, or lies on what turns, moves along without slipping, too */
    gboolean ends = isfinite(plate->half_width), rolls = plate->gap != NULL;
    const gboolean resists = tinker_contacts_resists(self->contacts, contact);
    if (!resists) add_trigger(self, TINKER_TRIGGER_NORMAL, body, on, number);
    if (contact->mode == TINKER_CONTACT_STICK) {
        add_trigger(self, TINKER_TRIGGER_FORWARD, body, on, number);
        add_trigger(self, TINKER_TRIGGER_BACKWARD, body, on, number);
    } else if (!slips_freely) {
        add_trigger(self, contact->starts ? TINKER_TRIGGER_STARTING : TINKER_TRIGGER_SPEED, body, on, number);
    }
    if (resists) return;
    if (rolls ? !plate->gap->rolls && contact->mode == TINKER_CONTACT_STICK : contact->mode == TINKER_CONTACT_STICK)
        return;
    if (ends && (forward || slips_freely || rolls)) add_trigger(self, TINKER_TRIGGER_END, body, on, number);
    if (ends && (!forward || slips_freely || rolls)) add_trigger(self, TINKER_TRIGGER_BEGINNING, body, on, number);
}

/* FALSE: no memory. */
static gboolean enlarge(double **array, gsize count)
{
    double *larger = g_try_renew(double, *array, count);
    if (larger != NULL) *array = larger;
    return larger != NULL;
}

TinkerStatus tinker_contact_run_make_room(TinkerContactRun *self)
{
    guint closed = self->contacts->closed->len, watched = MOST_OF_ONE * closed + 2 * self->near->len;
    gsize room = MAX(watched, self->triggers->len) * (gsize)(TINKER_MOST_DEGREE + 1);
    if (watched > self->triggers->len) {
        guint now = self->triggers->len;
        g_array_set_size(self->triggers, watched);
        g_array_set_size(self->triggers, now);
        g_array_set_size(self->falling, watched);
    }
    if (room > self->values_room) {
        if (!enlarge(&self->values, 2 * room) || !enlarge(&self->end_values, 2 * room))
            return tinker_contacts_lack_memory(self->contacts, closed);
        self->values_room = 2 * room;
    }
    if (closed > self->closed_room) {
        if (!enlarge(&self->force_scale, 2 * (gsize)closed) || !enlarge(&self->start.loads, 4 * (gsize)closed))
            return tinker_contacts_lack_memory(self->contacts, closed);
        self->closed_room = 2 * (gsize)closed;
    }
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_list_triggers(TinkerContactRun *self)
{
    g_array_set_size(self->triggers, 0);
    for (guint i = 0; i < self->contacts->closed->len; i++)
        watch_closed(self, (int32_t)i);
    for (guint i = 0; i < self->near->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->near, TinkerContactPair, i);
        if (tinker_contacts_is_guided(self->contacts, pair->body, pair->plate)) continue;
        gboolean leaves = tinker_contact_run_leaves(self, pair);
        add_trigger(self, leaves ? TINKER_TRIGGER_LEAVING : TINKER_TRIGGER_GAP, pair->body, pair->plate, -1);
    }
    watch_rows(self);
    TinkerStatus status = tinker_contact_run_make_room(self);
    if (status == TINKER_OK && self->contacts->closed->len > 0)
        memset(self->force_scale, 0, self->contacts->closed->len * sizeof(double));
    return status;
}

double tinker_trigger_place_rounding(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    if (trigger->row >= 0) return TINKER_PLACE_ROUNDING * self->model->constraints.scales[trigger->row];
    const TinkerPlate *plate = &self->contacts->plates[trigger->plate];
    const TinkerPoint *at = &self->model->point[trigger->body], *base = &self->model->point[plate->point];
    const double thick = plate->gap != NULL ? self->contacts->thickness
                                            : plate->half_height + self->contacts->half_height[trigger->body];
    return TINKER_PLACE_ROUNDING * (fabs(at->x) + fabs(at->y) + fabs(base->x) + fabs(base->y) + thick);
}

/* What constraints pull a body with, each by itself: what presses may be what is left of it. */
static double constraint_forces(const TinkerModel *model, int32_t body)
{
    const TinkerConstraints *all = &model->constraints;
    double sum = 0;
    for (int32_t k = all->body_starts[body]; k < all->body_starts[body + 1]; k++) {
        int32_t entry = all->body_entries[k];
        sum += fabs(all->lambda[all->row_of[entry]]) *
               (fabs(all->jacobian[2 * entry]) + fabs(all->jacobian[2 * entry + 1]));
    }
    return sum;
}

void tinker_contact_run_note_force_scales(TinkerContactRun *self)
{
    const TinkerModel *model = self->model;
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        int32_t k = 2 * contact->body;
        double applied = fabs(model->force[k]) + fabs(model->force[k + 1]) +
                         model->mass[contact->body] *
                             (fabs(model->constant_acceleration[k]) + fabs(model->constant_acceleration[k + 1]));
        if (self->contacts->held[contact->body]) applied += constraint_forces(model, contact->body);
        self->force_scale[i] = fmax(self->force_scale[i], applied + fabs(contact->normal) + fabs(contact->friction));
    }
}

/* The magnitudes of all that accelerates a body along the plane by the forces worked out last, those of contacts
 * included, added up; 0 of a support. */
static double acts_on(const TinkerContactRun *self, int32_t body)
{
    const TinkerContacts *contacts = self->contacts;
    if (contacts->entries->len == 0 || body >= self->model->bodies) return 0;
    return contacts->acts[2 * body] + contacts->acts[2 * body + 1];
}

/* The other body or support that shapes of a trigger are of; the same body where it is a top as masses meet it. */
static int32_t other_point(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerTouchingPair *pair = trigger->row < 0 ? self->contacts->plates[trigger->plate].pair : NULL;
    if (pair == NULL) return trigger->body;
    return pair->point[0] == trigger->body ? pair->point[1] : pair->point[0];
}

/* What presses on the two bodies besides, beside which the force of a contact that opens and closes again and again is
 * rounding; and what that accelerates them by. */
static double loads_of_both(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const int32_t other = other_point(self, trigger);
    double sum = acts_on(self, trigger->body) * self->model->mass[trigger->body];
    if (other < self->model->bodies && other != trigger->body) sum += acts_on(self, other) * self->model->mass[other];
    return sum;
}

static double acceleration_scale(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    int32_t k = 2 * trigger->body;
    double scale = 0;
    if (tinker_contact_run_repeats(self))
        scale = acts_on(self, trigger->body) + acts_on(self, other_point(self, trigger));
    const int32_t plate_point = trigger->row < 0 ? self->contacts->plates[trigger->plate].point : -1;
    if (plate_point >= self->model->bodies) { /* of bodies only samples keep accelerations there */
        const double *base = self->model->point_acceleration + 2 * plate_point;
        scale += fabs(base[0]) + fabs(base[1]);
    }
    return scale + fabs(self->model->constant_acceleration[k]) + fabs(self->model->constant_acceleration[k + 1]) +
           (fabs(self->model->force[k]) + fabs(self->model->force[k + 1])) * self->model->inverse_mass[trigger->body];
}

/* What dense output makes of a force that is 0, as a share of what acts. One that a redundant contact leaves at 0 for
 * good, and what friction may be more there, is held to that once the contact opens and closes again and again. */
static double force_noise(const TinkerContactRun *self)
{
    return tinker_contact_run_repeats(self) ? fmax(TINKER_FORCE_ROUNDING, self->run->choice.tolerance)
                                            : TINKER_FORCE_ROUNDING;
}

/* The same of an acceleration. */
static double acceleration_noise(const TinkerContactRun *self)
{
    return self->remembers ? fmax(TINKER_FORCE_ROUNDING, self->run->choice.tolerance) : force_noise(self);
}

static double force_rounding(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    if (trigger->row >= 0)
        return TINKER_FORCE_ROUNDING * self->model->mass[trigger->body] * acceleration_scale(self, trigger);
    if (tinker_contact_run_repeats(self))
        return force_noise(self) * fmax(self->force_scale[trigger->closed], loads_of_both(self, trigger));
    return force_noise(self) * self->force_scale[trigger->closed];
}

/* m/s^2: what turning by the rounding of a speed makes of accelerations. Where no other force acts, as on what has met
 * and goes on together, nothing but this presses. */
static double rounding_of_turning(const TinkerContactRun *self, double speed)
{
    return self->size > 0 ? TINKER_TURNING_ROUNDING * speed * speed / self->size : 0;
}

double tinker_trigger_level(const TinkerContactRun *self, const TinkerTrigger *trigger, double speed)
{
    switch (trigger->kind) {
    case TINKER_TRIGGER_GAP:
    case TINKER_TRIGGER_END:
    case TINKER_TRIGGER_BEGINNING:
        return -tinker_trigger_place_rounding(self, trigger);
    case TINKER_TRIGGER_SPEED:
        return -tinker_contact_run_speed_noise(self) * speed;
    case TINKER_TRIGGER_LEAVING:
    case TINKER_TRIGGER_STARTING:
        return -acceleration_noise(self) * acceleration_scale(self, trigger) - rounding_of_turning(self, speed);
    case TINKER_TRIGGER_NORMAL:
        return -force_rounding(self, trigger) - self->model->mass[trigger->body] * rounding_of_turning(self, speed);
    default:
        return -force_rounding(self, trigger);
    }
}
