/* The first event in a step: what must not fall below zero is worked out at a few nodes of the step, from dense output; the
 * polynomials through these values have all their roots found. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/contact-run-private.h"

/* Below this share of what it is made of a value is rounding. */
#define FORCE_ROUNDING 1e-11
#define SPEED_ROUNDING 1e-13
#define PLACE_ROUNDING (16 * DBL_EPSILON)
/* Of the largest value in a step: what a polynomial through them does not resolve. */
#define NOTHING 1e-13
/* A polynomial follows so much of a swing (rad) to rounding. */
#define LONGEST_ARC 1.5
#define MOST_PARTS  256
#define MOST_FALLS  8
/* Triggers of one closed contact. */
#define MOST_OF_ONE 4
/* What rises and falls within so small a share of a step is looked at as closely as this many times. */
#define DEEPEST     12
#define FIRST_SHARE 1e-3

/* States on the way ------------------------------------------------------------------------------------------------- */

/* The bodies at time t within the last step. */
static TinkerStatus state_at(TinkerContactRun *self, double t, double **q, double **v)
{
    TinkerIslandRun *run = self->run;
    const TinkerState *ends[2] = {&self->from, &run->state};
    gsize bytes = (gsize)run->system.system.size * sizeof(double);
    TinkerStatus status = TINKER_OK;
    memcpy(self->node_x, run->state.q, bytes);
    memcpy(self->node_u, run->state.v, bytes);
    for (int k = 0; k < 2; k++) {
        if (t != ends[k]->t) continue;
        memcpy(self->node_x, ends[k]->q, bytes);
        memcpy(self->node_u, ends[k]->v, bytes);
    }
    if (t != self->from.t && t != run->state.t)
        status = run->choice.method->interpolate(run->stepper, t, self->node_x, self->node_u, NULL);
    *q = self->node_x;
    *v = self->node_u;
    if (self->in_plane || run->q == run->state.q) return status;
    tinker_linear_form_expand(run->island->linear, self->node_x, self->node_u, self->node_q, self->node_v);
    *q = self->node_q;
    *v = self->node_v;
    return status;
}

/* Brings the model to a state, and works out the forces of its closed contacts. */
static TinkerStatus look_at(TinkerContactRun *self, double t, const double *q, const double *v)
{
    TinkerModel *model = self->model;
    if (self->contacts->closed->len > 0 || self->leaving->len > 0)
        return self->run->system.system.acceleration(&self->run->system, t, q, v, self->force, NULL);
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status == TINKER_OK) tinker_model_set_state(model, q, v);
    return status;
}

/* How the body accelerates away from the plate, by the accelerations worked out last. */
static double parting_acceleration(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerPlate *plate = &self->contacts->plates[trigger->plate];
    const double *base = self->model->point_acceleration + 2 * plate->point, *at = self->force + 2 * trigger->body;
    return plate->normal[0] * (at[0] - base[0]) + plate->normal[1] * (at[1] - base[1]);
}

static double value_of(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerContacts *contacts = self->contacts;
    TinkerContactPlace place = tinker_contact_place(contacts, trigger->body, trigger->plate);
    if (trigger->kind == TINKER_TRIGGER_GAP) return place.gap;
    if (trigger->kind == TINKER_TRIGGER_LEAVING) return parting_acceleration(self, trigger);
    const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)trigger->closed);
    const TinkerPlate *plate = &contacts->plates[trigger->plate];
    switch (trigger->kind) {
    case TINKER_TRIGGER_NORMAL:
        return contact->normal;
    case TINKER_TRIGGER_FORWARD:
        return plate->static_friction * contact->normal - contact->friction;
    case TINKER_TRIGGER_BACKWARD:
        return plate->static_friction * contact->normal + contact->friction;
    case TINKER_TRIGGER_SPEED:
        return contact->mode == TINKER_CONTACT_SLIP_FORWARD ? place.tangential_speed : -place.tangential_speed;
    case TINKER_TRIGGER_END:
        return plate->half_width - place.along;
    default:
        return plate->half_width + place.along;
    }
}

TinkerStatus tinker_contact_run_value(TinkerContactRun *self, double t, const double *q, const double *v,
                                      const TinkerTrigger *trigger, double *value)
{
    TinkerStatus status = look_at(self, t, q, v);
    if (status == TINKER_OK) *value = value_of(self, trigger);
    return status;
}

/* What is watched -------------------------------------------------------------------------------------------------- */

static void add_trigger(TinkerContactRun *self, TinkerTriggerKind kind, int32_t body, int32_t plate, int32_t closed)
{
    TinkerTrigger trigger = {kind, body, plate, closed, 0};
    g_array_append_val(self->triggers, trigger);
}

/* Without friction the direction of sliding makes no difference, so that nobody watches it; both ends may come. */
static void watch_closed(TinkerContactRun *self, int32_t number)
{
    const TinkerContact *contact = tinker_contacts_closed(self->contacts, (guint)number);
    const TinkerPlate *plate = &self->contacts->plates[contact->plate];
    int32_t body = contact->body, on = contact->plate;
    gboolean forward = contact->mode == TINKER_CONTACT_SLIP_FORWARD, slips_freely = plate->dynamic_friction == 0;
    add_trigger(self, TINKER_TRIGGER_NORMAL, body, on, number);
    if (contact->mode == TINKER_CONTACT_STICK) {
        add_trigger(self, TINKER_TRIGGER_FORWARD, body, on, number);
        add_trigger(self, TINKER_TRIGGER_BACKWARD, body, on, number);
        return;
    }
    if (!slips_freely) add_trigger(self, TINKER_TRIGGER_SPEED, body, on, number);
    if (forward || slips_freely) add_trigger(self, TINKER_TRIGGER_END, body, on, number);
    if (!forward || slips_freely) add_trigger(self, TINKER_TRIGGER_BEGINNING, body, on, number);
}

void tinker_contact_run_make_room(TinkerContactRun *self)
{
    guint closed = self->contacts->closed->len, watched = MOST_OF_ONE * closed + 2 * self->near->len;
    gsize room = MAX(watched, self->triggers->len) * (gsize)(TINKER_MOST_DEGREE + 1);
    if (watched > self->triggers->len) {
        guint now = self->triggers->len;
        g_array_set_size(self->triggers, watched);
        g_array_set_size(self->triggers, now);
    }
    if (room > self->values_room) {
        self->values_room = 2 * room;
        self->values = g_renew(double, self->values, self->values_room);
    }
    if (closed > self->closed_room) {
        self->closed_room = 2 * closed;
        self->force_scale = g_renew(double, self->force_scale, self->closed_room);
    }
}

static void list_triggers(TinkerContactRun *self)
{
    g_array_set_size(self->triggers, 0);
    for (guint i = 0; i < self->contacts->closed->len; i++)
        watch_closed(self, (int32_t)i);
    for (guint i = 0; i < self->near->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->near, TinkerContactPair, i);
        gboolean leaves = tinker_contact_run_leaves(self, pair->body, pair->plate);
        add_trigger(self, leaves ? TINKER_TRIGGER_LEAVING : TINKER_TRIGGER_GAP, pair->body, pair->plate, -1);
    }
    tinker_contact_run_make_room(self);
    memset(self->force_scale, 0, self->contacts->closed->len * sizeof(double));
}

static double rounding_of_place(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const TinkerPlate *plate = &self->contacts->plates[trigger->plate];
    const TinkerPoint *at = &self->model->point[trigger->body], *base = &self->model->point[plate->point];
    return PLACE_ROUNDING * (fabs(at->x) + fabs(at->y) + fabs(base->x) + fabs(base->y) + plate->half_height +
                             self->contacts->half_height[trigger->body]);
}

static void note_force_scales(TinkerContactRun *self)
{
    const TinkerModel *model = self->model;
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        int32_t k = 2 * contact->body;
        double applied = fabs(model->force[k]) + fabs(model->force[k + 1]) +
                         model->mass[contact->body] *
                             (fabs(model->constant_acceleration[k]) + fabs(model->constant_acceleration[k + 1]));
        self->force_scale[i] = fmax(self->force_scale[i], applied + fabs(contact->normal) + fabs(contact->friction));
    }
}

static double acceleration_scale(const TinkerContactRun *self, const TinkerTrigger *trigger)
{
    const double *base = self->model->point_acceleration + 2 * self->contacts->plates[trigger->plate].point;
    int32_t k = 2 * trigger->body;
    return fabs(base[0]) + fabs(base[1]) + fabs(self->model->constant_acceleration[k]) +
           fabs(self->model->constant_acceleration[k + 1]) +
           (fabs(self->model->force[k]) + fabs(self->model->force[k + 1])) * self->model->inverse_mass[trigger->body];
}

static double level_of(const TinkerContactRun *self, const TinkerTrigger *trigger, double speed)
{
    switch (trigger->kind) {
    case TINKER_TRIGGER_GAP:
    case TINKER_TRIGGER_END:
    case TINKER_TRIGGER_BEGINNING:
        return -rounding_of_place(self, trigger);
    case TINKER_TRIGGER_SPEED:
        return -SPEED_ROUNDING * speed;
    case TINKER_TRIGGER_LEAVING:
        return -FORCE_ROUNDING * acceleration_scale(self, trigger);
    default:
        return -FORCE_ROUNDING * self->force_scale[trigger->closed];
    }
}

/* Finding ---------------------------------------------------------------------------------------------------------- */

static TinkerStatus fill_values(TinkerContactRun *self, double from, double to)
{
    double nodes[TINKER_MOST_DEGREE + 1], speed = self->run->system.speed;
    int32_t count = self->degree + 1;
    tinker_step_nodes(self->degree, nodes);
    for (int32_t k = 0; k < count; k++) {
        double t = k == 0 ? from : k == count - 1 ? to : from + nodes[k] * (to - from), *q, *v;
        TinkerStatus status = state_at(self, t, &q, &v);
        if (status == TINKER_OK) status = look_at(self, t, q, v);
        if (status != TINKER_OK) return status;
        note_force_scales(self);
        for (guint i = 0; i < self->triggers->len; i++)
            self->values[i * (guint)count + (guint)k] =
                value_of(self, &g_array_index(self->triggers, TinkerTrigger, i));
        for (int32_t i = 0; i < 2 * self->model->bodies; i++)
            speed = fmax(speed, fabs(v[i]));
    }
    for (guint i = 0; i < self->triggers->len; i++) {
        TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        trigger->level = level_of(self, trigger, speed);
    }
    return TINKER_OK;
}

/* Whether a body whose gap falls through 0 at t meets the top there, and not the space beside it. */
static gboolean meets(TinkerContactRun *self, const TinkerTrigger *trigger, double t)
{
    double *q, *v;
    if (trigger->kind != TINKER_TRIGGER_GAP) return TRUE;
    if (state_at(self, t, &q, &v) != TINKER_OK || tinker_model_set_time(self->model, t) != TINKER_OK) return FALSE;
    tinker_model_set_state(self->model, q, v);
    TinkerContactPlace place = tinker_contact_place(self->contacts, trigger->body, trigger->plate);
    return tinker_contact_is_over(&self->contacts->plates[trigger->plate], &place, rounding_of_place(self, trigger));
}

/* Whether it has fallen by the first node, from a value that is nothing beside what follows. */
static gboolean falls_soon(const TinkerContactRun *self, const TinkerTrigger *trigger, const double *values)
{
    double most = 0;
    for (int32_t k = 0; k <= self->degree; k++)
        most = fmax(most, fabs(values[k]));
    if (!(values[1] < trigger->level) || values[0] > NOTHING * most) return FALSE;
    return trigger->kind != TINKER_TRIGGER_GAP || values[0] >= trigger->level; /* from behind it passes */
}

/* Whether it rises first, by less than the polynomial resolves. */
static gboolean rises_first(TinkerContactRun *self, const TinkerTrigger *trigger, double from, double to)
{
    double *q, *v, at_first, soon, t = from + FIRST_SHARE * (to - from);
    if (state_at(self, from, &q, &v) != TINKER_OK) return FALSE;
    if (tinker_contact_run_value(self, from, q, v, trigger, &at_first) != TINKER_OK) return FALSE;
    if (trigger->kind == TINKER_TRIGGER_GAP)
        return tinker_contact_place(self->contacts, trigger->body, trigger->plate).normal_speed > 0;
    if (state_at(self, t, &q, &v) != TINKER_OK) return FALSE;
    return tinker_contact_run_value(self, t, q, v, trigger, &soon) == TINKER_OK && soon > at_first;
}

/* The first fall of one trigger between two times; INFINITY for none, NAN where it has to be looked at more closely. */
static double first_fall(TinkerContactRun *self, const TinkerTrigger *trigger, const double *values, double from,
                         double to)
{
    double places[MOST_FALLS];
    if (tinker_step_least(self->degree, values) > trigger->level) return INFINITY;
    if (falls_soon(self, trigger, values) && meets(self, trigger, from))
        return rises_first(self, trigger, from, to) ? NAN : from;
    int32_t falls = tinker_step_falls(self->degree, values, trigger->level, places, MOST_FALLS);
    for (int32_t k = 0; k < falls; k++) {
        double t = from + places[k] * (to - from);
        if (meets(self, trigger, t)) return t;
    }
    return INFINITY;
}

/* `depth`: how often it may look more closely at the first part. */
static TinkerStatus search_part(TinkerContactRun *self, double from, double to, int depth, TinkerTrigger *found,
                                double *time)
{
    TinkerStatus status = fill_values(self, from, to);
    TinkerTrigger unclear = {.kind = TINKER_TRIGGER_NONE};
    for (guint i = 0; status == TINKER_OK && i < self->triggers->len; i++) {
        const TinkerTrigger *trigger = &g_array_index(self->triggers, TinkerTrigger, i);
        double t = first_fall(self, trigger, self->values + i * (guint)(self->degree + 1), from, to);
        if (isnan(t)) unclear = *trigger;
        if (!(t < *time)) continue;
        *time = t;
        *found = *trigger;
    }
    if (status != TINKER_OK || unclear.kind == TINKER_TRIGGER_NONE || *time == from) return status;
    *time = from;
    *found = unclear;
    if (depth == 0) return TINKER_OK;
    found->kind = TINKER_TRIGGER_NONE;
    *time = INFINITY;
    double nodes[TINKER_MOST_DEGREE + 1];
    tinker_step_nodes(self->degree, nodes);
    return search_part(self, from, from + nodes[1] * (to - from), depth - 1, found, time);
}

double tinker_contact_run_swing(TinkerContactRun *self, int32_t point, double from, double to)
{
    double speed = 0, change = 0;
    for (int k = 0; k <= 8; k++) {
        if (tinker_model_set_time(self->model, from + k * (to - from) / 8) != TINKER_OK) return 0;
        const double *a = self->model->point_acceleration + 2 * point;
        speed = fmax(speed, hypot(self->model->point[point].vx, self->model->point[point].vy));
        change = fmax(change, hypot(a[0], a[1]));
    }
    return speed > 0 ? change / speed : 0;
}

/* The fastest swing of what is watched: of moving plates, and of the island where it is solved exactly. */
static double highest_frequency(TinkerContactRun *self, double from, double to)
{
    const TinkerContacts *contacts = self->contacts;
    double highest = self->highest_frequency;
    for (int32_t i = 0; contacts->moving_plates > 0 && i < contacts->plate_count; i++)
        if (contacts->plates[i].moving)
            highest = fmax(highest, tinker_contact_run_swing(self, contacts->plates[i].point, from, to));
    return highest;
}

/* How fast the trigger falls there. */
static TinkerStatus find_slope(TinkerContactRun *self, const TinkerTrigger *trigger, double from, double to, double t,
                               double *slope)
{
    double near = 1e-4 * (to - from), at[2] = {fmax(t - near, from), fmin(t + near, to)}, value[2] = {0, 0};
    for (int k = 0; k < 2; k++) {
        double *q, *v;
        TinkerStatus status = state_at(self, at[k], &q, &v);
        if (status == TINKER_OK) status = tinker_contact_run_value(self, at[k], q, v, trigger, &value[k]);
        if (status != TINKER_OK) return status;
    }
    *slope = (value[1] - value[0]) / (at[1] - at[0]);
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_search(TinkerContactRun *self, double from, double to, TinkerTrigger *found,
                                       double *time, double *slope)
{
    TinkerStatus status = TINKER_OK;
    found->kind = TINKER_TRIGGER_NONE;
    *time = INFINITY;
    list_triggers(self);
    if (self->triggers->len == 0) return TINKER_OK;
    double arc = highest_frequency(self, from, to) * (to - from);
    int parts = (int)CLAMP(ceil(arc / LONGEST_ARC), 1, MOST_PARTS);
    for (int k = 0; k < parts && status == TINKER_OK && found->kind == TINKER_TRIGGER_NONE; k++) {
        double begin = from + k * (to - from) / parts, end = k == parts - 1 ? to : from + (k + 1) * (to - from) / parts;
        status = search_part(self, begin, end, DEEPEST, found, time);
    }
    if (status != TINKER_OK || found->kind == TINKER_TRIGGER_NONE) return status;
    return find_slope(self, found, from, to, *time, slope);
}
