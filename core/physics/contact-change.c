/* What happens at an event: impacts where bodies approach what they touch, then which contacts are closed and which stick.
 *
 * 1. All contacts that are closed, or whose gap is closed and not opening, are taken together.
 * 2. Where one of them approaches, an impact changes velocities (numerics/contact-laws.h).
 * 3. Of those that do not part by then, the laws at the level of accelerations tell the modes from here on.
 * 4. Where no acceleration satisfies them (Painleve), an impulse ends the sliding that jams, and 3. is asked again. */
#include <math.h>
#include <string.h>

#include "physics/contact-run-private.h"

/* Speeds below this share of the largest are rounding. */
#define STILL 1e-12
/* A rebound below this share of the largest speed ends in rest, but for one that loses nothing. */
#define LEAST_REBOUND 1e-6
#define MOST_JAMS     8
/* Forces below this share of what acts are rounding. */
#define FORCE_NOISE 1e-10

typedef struct {
    TinkerContact contact;
    TinkerContactPlace place;
    TinkerContactMode was; /* before the event; OPEN where it was not closed */
    gboolean struck;
    int8_t sliding;
} Touch;

typedef struct {
    TinkerContactRun *run;
    TinkerModel *model;
    TinkerTrigger trigger;
    int32_t group;
    GArray *touches; /* of Touch: of this group of bodies */
    double speed, slow;
} Change;

static Touch *touch(const Change *change, guint number)
{
    return &g_array_index(change->touches, Touch, number);
}

static const TinkerPlate *plate_of(const Change *change, guint number)
{
    return &change->run->contacts->plates[touch(change, number)->contact.plate];
}

static void add_event(Change *change, const char *kind, const Touch *of)
{
    TinkerScene *scene = change->model->scene;
    g_autofree char *names =
        g_strdup_printf("%s, %s", tinker_scene_block_name(scene, change->model->body_blocks[of->contact.body]),
                        tinker_scene_block_name(scene, change->run->contacts->plates[of->contact.plate].block));
    tinker_island_run_add_event(change->run->run, kind, names);
}

static TinkerStatus set_state(const Change *change)
{
    TinkerIslandRun *run = change->run->run;
    TinkerStatus status = tinker_model_set_time(change->model, run->state.t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(change->model, run->state.q, run->state.v);
    return change->model->constraints.rows > 0 ? tinker_constraints_evaluate(change->model) : TINKER_OK;
}

/* Step 1 ----------------------------------------------------------------------------------------------------------- */

static gboolean is_trigger(const Change *change, const TinkerContact *contact)
{
    return change->trigger.kind != TINKER_TRIGGER_NONE && change->trigger.body == contact->body &&
           change->trigger.plate == contact->plate;
}

static gboolean ends_now(const Change *change, const TinkerContact *contact)
{
    return is_trigger(change, contact) &&
           (change->trigger.kind == TINKER_TRIGGER_END || change->trigger.kind == TINKER_TRIGGER_BEGINNING);
}

static void take_closed(Change *change)
{
    const TinkerContacts *contacts = change->run->contacts;
    for (guint i = 0; i < contacts->closed->len; i++) {
        Touch taken = {.contact = *tinker_contacts_closed(contacts, i)};
        if (contacts->group[taken.contact.body] != change->group) continue;
        taken.was = taken.contact.mode;
        taken.place = tinker_contact_place(contacts, taken.contact.body, taken.contact.plate);
        if (ends_now(change, &taken.contact))
            add_event(change, "end", &taken);
        else
            g_array_append_val(change->touches, taken);
    }
}

static void take_open(Change *change, double tolerance)
{
    const TinkerContactRun *self = change->run;
    for (guint i = 0; i < self->near->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->near, TinkerContactPair, i);
        if (self->contacts->group[pair->body] != change->group) continue;
        Touch taken = {.contact = {.body = pair->body, .plate = pair->plate}, .was = TINKER_CONTACT_OPEN};
        taken.place = tinker_contact_place(self->contacts, pair->body, pair->plate);
        gboolean met = is_trigger(change, &taken.contact) &&
                       (change->trigger.kind == TINKER_TRIGGER_GAP || change->trigger.kind == TINKER_TRIGGER_LEAVING);
        gboolean closed = fabs(taken.place.gap) <= tolerance && taken.place.normal_speed <= STILL * change->speed &&
                          tinker_contact_is_over(&self->contacts->plates[pair->plate], &taken.place, tolerance);
        if (met || closed) g_array_append_val(change->touches, taken);
    }
}

/* Step 2 ----------------------------------------------------------------------------------------------------------- */

/* Contacts as the laws see them. */
typedef struct {
    gsize count;
    double *delassus, *pairs, *answers; /* 2m x 2m, 2m, 2m */
    double *first, *second;             /* m */
    int8_t *sliding;
    TinkerContactMode *modes;
} Laws;

static void laws_clear(Laws *laws)
{
    gpointer arrays[] = {laws->delassus, laws->pairs, laws->answers, laws->first,
                         laws->second,   laws->modes, laws->sliding};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Laws, laws_clear)

static Laws laws_of(const Change *change)
{
    gsize m = change->touches->len;
    Laws laws = {m,
                 g_new0(double, 4 * m * m),
                 g_new0(double, 2 * m),
                 g_new0(double, 2 * m),
                 g_new0(double, m),
                 g_new0(double, m),
                 g_new0(int8_t, m),
                 g_new0(TinkerContactMode, m)};
    g_autofree TinkerContact *contacts = g_new0(TinkerContact, m);
    for (guint i = 0; i < m; i++)
        contacts[i] = touch(change, i)->contact;
    tinker_contacts_delassus(change->run->contacts, contacts, (int32_t)m, laws.delassus);
    return laws;
}

static void measure_places(Change *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        Touch *at = touch(change, i);
        at->place = tinker_contact_place(change->run->contacts, at->contact.body, at->contact.plate);
    }
}

static double kinetic_change(const TinkerModel *model, const double *before, const double *after)
{
    double sum = 0;
    for (int32_t i = 0; i < 2 * model->bodies; i++)
        sum += 0.5 * model->coordinate_mass[i] * (after[i] - before[i]) * (after[i] + before[i]);
    return sum;
}

/* Lets impulses act; books what they take: what contacts do, and the rest by what moves. */
static gboolean push_all(Change *change, const double *impulses)
{
    TinkerModel *model = change->model;
    TinkerContactRun *self = change->run;
    double *v = self->run->state.v, *work = self->run->system.impact_work;
    g_autofree double *before = g_memdup2(v, 2 * (gsize)model->bodies * sizeof(double));
    for (guint i = 0; i < change->touches->len; i++) {
        const double *n = plate_of(change, i)->normal, pn = impulses[2 * i], pt = impulses[2 * i + 1];
        if (pn != 0 || pt != 0)
            tinker_contacts_push(self->contacts, touch(change, i)->contact.body, pn * n[0] + pt * n[1],
                                 pn * n[1] - pt * n[0], v);
    }
    if (set_state(change) != TINKER_OK) return FALSE;
    double rest = kinetic_change(model, before, v);
    for (guint i = 0; i < change->touches->len; i++) {
        TinkerContactPlace was = touch(change, i)->place;
        TinkerContactPlace is =
            tinker_contact_place(self->contacts, touch(change, i)->contact.body, touch(change, i)->contact.plate);
        double by_normal = 0.5 * impulses[2 * i] * (was.normal_speed + is.normal_speed);
        double by_friction = 0.5 * impulses[2 * i + 1] * (was.tangential_speed + is.tangential_speed);
        work[TINKER_BOOK_CONTACTS] += by_normal + by_friction;
        rest -= by_normal + by_friction;
    }
    work[model->moving_supports > 0 ? TINKER_BOOK_SUPPORT_MOTION : TINKER_BOOK_CONTACTS] += rest;
    self->last_impact = self->run->state.t;
    measure_places(change);
    return TRUE;
}

static gboolean refuse(Change *change, const char *why, GError **error)
{
    return tinker_island_run_fail_step(change->run->run, why, error);
}

static gboolean approaches(const Change *change)
{
    for (guint i = 0; i < change->touches->len; i++)
        if (touch(change, i)->place.normal_speed < -STILL * change->speed) return TRUE;
    return FALSE;
}

/* A rebound that would be too slow to be seen is none: else infinitely many follow. */
static double restitution_of(const Change *change, guint number)
{
    double e = plate_of(change, number)->restitution, approach = -touch(change, number)->place.normal_speed;
    return e < 1 && e * approach < LEAST_REBOUND * change->speed ? 0 : e;
}

/* Parts, but too slowly to be seen. */
static gboolean lingers(const Change *change, guint number)
{
    double speed = touch(change, number)->place.normal_speed;
    return speed > STILL * change->speed && speed < LEAST_REBOUND * change->speed &&
           plate_of(change, number)->restitution < 1;
}

/* Bodies that rods couple may strike by turns, each blow throwing up the other less and less, infinitely often in finite
 * time: what parts too slowly to be seen does not part. Taking speeds away along normals takes energy only. */
static gboolean settle(Change *change)
{
    guint m = change->touches->len;
    g_autofree gboolean *rests = g_new0(gboolean, m);
    gboolean any = FALSE;
    for (guint i = 0; i < m; i++) {
        rests[i] = touch(change, i)->place.normal_speed < LEAST_REBOUND * change->speed;
        any |= lingers(change, i);
    }
    if (!any) return TRUE;
    g_auto(Laws) laws = laws_of(change);
    g_autofree double *matrix = g_new0(double, (gsize)m *m);
    for (guint i = 0; i < m; i++)
        for (guint k = 0; k < m; k++)
            matrix[i * m + k] = rests[i] && rests[k] ? laws.delassus[2 * i * 2 * m + 2 * k] : i == k;
    for (guint i = 0; i < m; i++)
        laws.first[i] = rests[i] ? -touch(change, i)->place.normal_speed : 0;
    TinkerDenseSolve *solve = tinker_dense_solve_new((int32_t)m);
    tinker_dense_solve_factor(solve, matrix);
    tinker_dense_solve(solve, laws.first);
    tinker_dense_solve_free(solve);
    for (guint i = 0; i < m; i++)
        laws.answers[2 * i] = laws.first[i];
    return push_all(change, laws.answers);
}

static gboolean strike(Change *change, GError **error)
{
    if (!approaches(change)) return TRUE;
    g_auto(Laws) laws = laws_of(change);
    for (guint i = 0; i < laws.count; i++) {
        laws.pairs[2 * i] = touch(change, i)->place.normal_speed;
        laws.pairs[2 * i + 1] = touch(change, i)->place.tangential_speed;
        laws.first[i] = restitution_of(change, i);
        laws.second[i] = plate_of(change, i)->dynamic_friction;
    }
    TinkerImpact impact = {(int32_t)laws.count, laws.delassus, laws.pairs, laws.first, laws.second, NULL};
    if (tinker_impact_solve(&impact, laws.answers) != TINKER_CONTACT_SOLVED)
        return refuse(change, "no impulses satisfy the laws of impact for all bodies that touch there", error);
    for (guint i = 0; i < laws.count; i++) {
        Touch *at = touch(change, i);
        at->struck = laws.answers[2 * i] > 0;
        if (at->struck) at->contact.normal = laws.answers[2 * i];
    }
    if (push_all(change, laws.answers) && settle(change)) return TRUE;
    return refuse(change, change->model->failure, error);
}

/* Steps 3 and 4 ---------------------------------------------------------------------------------------------------- */

/* Which way it slides; 0 where it is slow enough to stick. An event says that it stops, or that it begins. */
static int8_t sliding_of(const Change *change, guint number, double acceleration)
{
    const Touch *at = touch(change, number);
    const TinkerPlate *plate = plate_of(change, number);
    double speed = at->place.tangential_speed;
    if (is_trigger(change, &at->contact) && !at->struck) {
        if (change->trigger.kind == TINKER_TRIGGER_FORWARD) return -1;
        if (change->trigger.kind == TINKER_TRIGGER_BACKWARD) return 1;
        if (change->trigger.kind == TINKER_TRIGGER_SPEED) return 0;
    }
    if (plate->static_friction == 0) return 1; /* either way is the same */
    if (at->was == TINKER_CONTACT_STICK && !at->struck) return 0;
    /* what falls over the length of the plate is a scale for what is the only thing that moves */
    double scale = change->speed + sqrt(acceleration * (plate->half_width + plate->half_height));
    return fabs(speed) <= change->slow * scale ? 0 : speed > 0 ? 1 : -1;
}

/* What parts is not asked. */
static void drop_parting(Change *change)
{
    for (guint i = change->touches->len; i-- > 0;) {
        const Touch *at = touch(change, i);
        if (!(at->place.normal_speed > STILL * change->speed)) continue;
        if (at->was != TINKER_CONTACT_OPEN)
            add_event(change, "take-off", at);
        else if (at->struck)
            add_event(change, "impact", at);
        g_array_remove_index(change->touches, i);
    }
}

/* Accelerations with constraints but without contacts, relative to the plates. */
static gboolean relative_accelerations(Change *change, double *pairs, double *scale)
{
    TinkerModel *model = change->model;
    double *a = change->run->force;
    if (tinker_model_applied(model, a, FALSE) != TINKER_OK) return FALSE;
    if (model->constraints.rows > 0) tinker_constraints_accelerate(model, a);
    *scale = 0;
    for (guint i = 0; i < change->touches->len; i++) {
        int32_t body = touch(change, i)->contact.body;
        const double *n = plate_of(change, i)->normal,
                     *base = model->point_acceleration + 2 * plate_of(change, i)->point;
        double x = a[2 * body] - base[0], y = a[2 * body + 1] - base[1];
        pairs[2 * i] = n[0] * x + n[1] * y;
        pairs[2 * i + 1] = n[1] * x - n[0] * y;
        *scale = fmax(*scale, hypot(x, y) + (fabs(model->force[2 * body]) + fabs(model->force[2 * body + 1])) *
                                                model->inverse_mass[body]);
    }
    return TRUE;
}

static TinkerContactResult ask_modes(Change *change, Laws *laws, double scale)
{
    for (guint i = 0; i < laws->count; i++) {
        laws->sliding[i] = sliding_of(change, i, scale);
        laws->first[i] = plate_of(change, i)->static_friction;
        laws->second[i] = plate_of(change, i)->dynamic_friction;
    }
    TinkerClosedContacts closed = {(int32_t)laws->count, laws->delassus, laws->pairs,        laws->sliding,
                                   laws->first,          laws->second,   FORCE_NOISE * scale};
    TinkerContactResult result = tinker_contact_modes(&closed, laws->modes, laws->answers);
    if (result != TINKER_CONTACT_NO_ACCELERATION) return result;
    g_autofree double *velocity = g_new0(double, 2 * laws->count);
    for (guint i = 0; i < laws->count; i++) {
        velocity[2 * i] = touch(change, i)->place.normal_speed;
        velocity[2 * i + 1] = touch(change, i)->place.tangential_speed;
    }
    return tinker_contact_jam(&closed, velocity, laws->answers) == TINKER_CONTACT_SOLVED ? result
                                                                                         : TINKER_CONTACT_GAVE_UP;
}

/* A contact whose force has just come to 0 opens, unless something presses it again. */
static gboolean lets_go(const Change *change, const Touch *at, double force, double noise)
{
    return is_trigger(change, &at->contact) && change->trigger.kind == TINKER_TRIGGER_NORMAL &&
           force <= FORCE_NOISE * noise;
}

static void note_modes(Change *change, const Laws *laws, double scale)
{
    for (guint i = 0; i < laws->count; i++) {
        Touch *at = touch(change, i);
        double mass = change->model->mass[at->contact.body];
        at->contact.mode = laws->modes[i];
        if (!at->struck) at->contact.normal = laws->answers[2 * i];
        if (lets_go(change, at, laws->answers[2 * i], mass * scale)) at->contact.mode = TINKER_CONTACT_OPEN;
    }
}

static gboolean decide(Change *change, GError **error)
{
    for (int jams = 0; jams <= MOST_JAMS; jams++) {
        double scale;
        drop_parting(change);
        if (change->touches->len == 0) return TRUE;
        g_auto(Laws) laws = laws_of(change);
        if (!relative_accelerations(change, laws.pairs, &scale)) return refuse(change, change->model->failure, error);
        TinkerContactResult result = ask_modes(change, &laws, scale);
        if (result == TINKER_CONTACT_SOLVED) {
            note_modes(change, &laws, scale);
            return TRUE;
        }
        if (result == TINKER_CONTACT_GAVE_UP) break;
        add_event(change, "jam", touch(change, 0));
        if (!push_all(change, laws.answers)) return refuse(change, change->model->failure, error);
    }
    return refuse(change, "no motion satisfies the laws of friction for all bodies that touch there", error);
}

/* After it --------------------------------------------------------------------------------------------------------- */

/* `landed`: it has come down to the plate just now, with a blow or without. */
static const char *name_of_change(TinkerContactMode was, TinkerContactMode is, gboolean landed)
{
    if (was == TINKER_CONTACT_OPEN) return !landed ? NULL : is != TINKER_CONTACT_OPEN ? "rest" : "impact";
    if (is == TINKER_CONTACT_OPEN) return "take-off";
    if (is == was) return NULL;
    if (is == TINKER_CONTACT_STICK) return "stick";
    return was == TINKER_CONTACT_STICK ? "slip" : "reversal";
}

/* Every body lies along what pushes it hardest. */
static void turn_bodies(Change *change)
{
    for (guint i = 0; i < change->touches->len; i++) {
        const Touch *at = touch(change, i);
        gboolean hardest = at->struck || at->contact.mode != TINKER_CONTACT_OPEN;
        for (guint k = 0; k < change->touches->len; k++)
            if (touch(change, k)->contact.body == at->contact.body &&
                touch(change, k)->contact.normal > at->contact.normal)
                hardest = FALSE;
        if (hardest) change->run->orientation[at->contact.body] = plate_of(change, i)->orientation;
    }
}

/* What opens of its own accord is watched by its acceleration; what an event was about is done with. */
static void note_leaving(Change *change)
{
    GArray *leaving = change->run->leaving;
    for (guint i = leaving->len; i-- > 0;) {
        const TinkerContactPair *pair = &g_array_index(leaving, TinkerContactPair, i);
        if (change->trigger.body == pair->body && change->trigger.plate == pair->plate)
            g_array_remove_index_fast(leaving, i);
    }
    for (guint i = 0; i < change->touches->len; i++) {
        const Touch *at = touch(change, i);
        TinkerContactPair pair = {at->contact.body, at->contact.plate};
        if (at->was != TINKER_CONTACT_OPEN && !at->struck && at->contact.mode == TINKER_CONTACT_OPEN)
            g_array_append_val(leaving, pair);
    }
}

static gboolean close_contacts(Change *change, GError **error)
{
    TinkerContactRun *self = change->run;
    TinkerContacts *contacts = self->contacts;
    for (guint i = contacts->closed->len; i-- > 0;)
        if (contacts->group[tinker_contacts_closed(contacts, i)->body] == change->group)
            g_array_remove_index(contacts->closed, i);
    for (guint i = 0; i < change->touches->len; i++) {
        Touch *at = touch(change, i);
        gboolean landed =
            at->struck || (is_trigger(change, &at->contact) && change->trigger.kind == TINKER_TRIGGER_GAP);
        const char *name = name_of_change(at->was, at->contact.mode, landed);
        if (name != NULL && !(plate_of(change, i)->static_friction == 0 && g_str_equal(name, "reversal")))
            add_event(change, name, at);
        if (at->contact.mode == TINKER_CONTACT_OPEN) continue;
        if (at->was != TINKER_CONTACT_STICK) at->contact.anchor = at->place.along;
        g_array_append_val(contacts->closed, at->contact);
    }
    tinker_contacts_list_rows(contacts);
    tinker_contact_run_make_room(self);
    self->changes++;
    int32_t moved;
    TinkerSystem *system = &self->run->system.system;
    TinkerState *state = &self->run->state;
    if (contacts->closed->len > 0 &&
        system->project(system->context, state->t, state->q, state->v, &moved) != TINKER_OK)
        return refuse(change, change->model->failure, error);
    return TRUE;
}

/* Takes what touches of one group through all four steps. */
static gboolean change_group(TinkerContactRun *self, const TinkerTrigger *trigger, int32_t group, double tolerance,
                             double slow, GError **error)
{
    TinkerIslandRun *run = self->run;
    double extent;
    Change change = {self, self->model, *trigger, group, g_array_new(FALSE, TRUE, sizeof(Touch)), 0, fmax(slow, STILL)};
    run->system.system.scales(&run->system, run->state.q, run->state.v, &extent, &change.speed);
    gboolean done = set_state(&change) == TINKER_OK || refuse(&change, self->model->failure, error);
    if (done) {
        take_closed(&change);
        take_open(&change, tolerance);
        done = strike(&change, error);
    }
    if (done) turn_bodies(&change);
    done = done && decide(&change, error);
    if (done) turn_bodies(&change);
    if (done) note_leaving(&change);
    done = done && close_contacts(&change, error);
    g_array_unref(change.touches);
    return done;
}

/* The groups that something of touches: at a start and at a break all of them are asked. (transfer full) */
static gboolean *groups_near(const TinkerContactRun *self)
{
    const TinkerContacts *contacts = self->contacts;
    gboolean *asked = g_new0(gboolean, MAX(self->model->bodies, 1));
    for (guint i = 0; i < self->near->len; i++)
        asked[contacts->group[g_array_index(self->near, TinkerContactPair, i).body]] = TRUE;
    for (guint i = 0; i < contacts->closed->len; i++)
        asked[contacts->group[tinker_contacts_closed(contacts, i)->body]] = TRUE;
    return asked;
}

gboolean tinker_contact_run_change(TinkerContactRun *self, const TinkerTrigger *trigger, double tolerance, double slow,
                                   GError **error)
{
    double reach = tolerance;
    if (tinker_model_set_time(self->model, self->run->state.t) != TINKER_OK)
        return tinker_island_run_fail(self->run, self->model->failure, error);
    tinker_model_set_state(self->model, self->run->state.q, self->run->state.v);
    if (trigger->kind == TINKER_TRIGGER_GAP)
        reach += 2 * fabs(tinker_contact_place(self->contacts, trigger->body, trigger->plate).gap);
    tinker_contact_run_find_near(self, self->run->state.q, self->run->state.q, reach);
    if (trigger->kind != TINKER_TRIGGER_NONE)
        return change_group(self, trigger, self->contacts->group[trigger->body], tolerance, slow, error);
    g_autofree gboolean *asked = groups_near(self);
    for (int32_t group = 0; group < self->model->bodies; group++)
        if (asked[group] && !change_group(self, trigger, group, tolerance, slow, error)) return FALSE;
    return TRUE;
}
