/* Contact in the run of an island: begins and ends steps, and passes events. */
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* What was large and is no more loses so much of its say in every step. */
#define FADING 0.9
/* So many events within TINKER_CROWDED never end, nor do so many times as many, each within TINKER_SLOW_CROWDED. */
#define CROWD       500
#define SLOW_CROWDS 20
#define MOST_TRIALS 12
/* Near pairs that there is room for at first. */
#define MOST_EXPECTED 16

static void allot(TinkerContactRun *self)
{
    gsize n = (gsize)MAX(self->model->coordinates, 1);
    double **arrays[] = {&self->from.q, &self->from.v, &self->node_x, &self->node_u,
                         &self->node_q, &self->node_v, &self->force,  &self->quiet_x};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        *arrays[i] = g_new0(double, n);
    self->from.books = g_new0(double, TINKER_BOOK_COUNT + 1);
    tinker_contact_neighbours_init(&self->neighbours, self->contacts);
    self->orientation = g_new(double, n);
    for (int32_t i = 0; i < self->model->bodies; i++)
        self->orientation[i] = NAN;
    guint pairs = MIN(MOST_EXPECTED, (guint)(self->model->bodies * (gint64)self->contacts->plate_count));
    self->near = g_array_sized_new(FALSE, FALSE, sizeof(TinkerContactPair), pairs);
    self->leaving = g_array_sized_new(FALSE, FALSE, sizeof(TinkerContactPair), pairs);
    self->triggers = g_array_sized_new(FALSE, FALSE, sizeof(TinkerTrigger), 2 * pairs);
    self->values_room = 2 * pairs * (gsize)(TINKER_MOST_DEGREE + 1);
    self->values = g_new0(double, self->values_room);
    self->end_values = g_new0(double, self->values_room);
    self->plate_speed = g_new0(double, self->model->points - self->model->first_support + 1);
}

/* As many as dense output has degrees, and one to spare. */
static void choose_nodes(TinkerContactRun *self)
{
    const TinkerIntegrator *method = self->run->choice.method;
    self->remembers = tinker_method_remembers(method);
    self->starts_low = method->order == 1 || self->remembers;
    self->degree = method->dense_order <= 3 ? 4 : 8;
    tinker_step_nodes(self->degree, self->nodes);
}

TinkerContactRun *tinker_contact_run_new(TinkerIslandRun *run)
{
    if (run->model->contacts == NULL) return NULL;
    TinkerContactRun *self = g_new0(TinkerContactRun, 1);
    *self = (TinkerContactRun){
        .run = run,
        .contacts = run->model->contacts,
        .model = run->model,
        .last_impact = -INFINITY,
        .passed_impact = -INFINITY,
        .hint = INFINITY,
        .crowd_began = -INFINITY,
        .end_time = NAN,
    };
    self->exact = (run->choice.method->flags & TINKER_INTEGRATOR_LINEAR) != 0;
    tinker_contact_flight_init(&self->flight, self, self->exact);
    tinker_contacts_open_all(self->contacts);
    choose_nodes(self);
    allot(self);
    return self;
}

void tinker_contact_run_free(TinkerContactRun *self)
{
    if (self == NULL) return;
    tinker_contact_neighbours_clear(&self->neighbours);
    tinker_contact_flight_clear(&self->flight);
    g_array_unref(self->near);
    g_array_unref(self->leaving);
    g_array_unref(self->triggers);
    gpointer arrays[] = {self->from.q, self->from.v,      self->from.books, self->node_x,      self->node_u,
                         self->node_q, self->node_v,      self->force,      self->orientation, self->quiet_x,
                         self->values, self->force_scale, self->end_values, self->plate_speed};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

double tinker_contact_run_orientation(const TinkerContactRun *self, int32_t body)
{
    return self->orientation[body];
}

double tinker_contact_run_last_impact(const TinkerContactRun *self)
{
    return self->last_impact;
}

double tinker_contact_run_passed_impact(const TinkerContactRun *self)
{
    return self->passed_impact;
}

gboolean tinker_contact_run_has_pending_event(const TinkerContactRun *self)
{
    return self->pending;
}

gint64 tinker_contact_run_looks(const TinkerContactRun *self)
{
    return self->looks;
}

gint64 tinker_contact_run_changes(const TinkerContactRun *self)
{
    return self->changes;
}

/* Events ----------------------------------------------------------------------------------------------------------- */

/* From here on the island is stepped in the plane, by a method that takes constraints. */
static gboolean enter_plane(TinkerContactRun *self, GError **error)
{
    if (self->in_plane) return TRUE;
    if (!tinker_island_run_enter_plane(self->run, error)) return FALSE;
    self->in_plane = TRUE;
    self->exact = FALSE;
    choose_nodes(self);
    return TRUE;
}

/* From here on the island is solved exactly again. */
static void leave_plane(TinkerContactRun *self)
{
    tinker_island_run_leave_plane(self->run);
    self->in_plane = FALSE;
    self->exact = TRUE;
    self->quiet = 0;
    choose_nodes(self);
}

static gboolean pass_trigger(TinkerContactRun *self, const TinkerTrigger *trigger, GError **error)
{
    TinkerStatus status = tinker_contact_flight_meet(self, trigger);
    if (status == TINKER_OK) {
        if (!tinker_contact_run_change(self, trigger, tinker_contact_run_closed_gap(self), 0, error)) return FALSE;
        status = tinker_contact_flight_part(self, trigger);
    }
    return status == TINKER_OK || tinker_island_run_fail_step(self->run, self->model->failure, error);
}

static gboolean is_crowded(TinkerContactRun *self)
{
    double t = self->run->state.t, passed = t - self->crowd_began;
    if (++self->crowd < CROWD) return FALSE;
    self->crowd = 0;
    self->crowd_began = t;
    self->slow_crowds = passed <= TINKER_SLOW_CROWDED * fabs(t) ? self->slow_crowds + 1 : 0;
    return passed <= TINKER_CROWDED * fabs(t) || self->slow_crowds >= SLOW_CROWDS;
}

/* Shapes that have come to overlap without touching, from below or past an end of a top, do so until they have parted.
 */
static void watch_overlaps(TinkerContactRun *self)
{
    TinkerContacts *contacts = self->contacts;
    TinkerIslandRun *run = self->run;
    if (contacts->pair_count == 0 || tinker_model_set_time(self->model, run->state.t) != TINKER_OK) return;
    tinker_island_run_place(run);
    tinker_model_set_state(self->model, run->q, run->v);
    for (int32_t i = 0; i < contacts->pair_count; i++) {
        TinkerTouchingPair *pair = &contacts->pairs[i];
        const double overlap = tinker_contact_pair_overlap(contacts, pair);
        pair->passes = overlap > TINKER_TOUCHING || (pair->passes && overlap > 0);
    }
}

gboolean tinker_contact_run_start(TinkerContactRun *self, GError **error)
{
    TinkerIslandRun *run = self->run;
    TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    tinker_island_run_place(run);
    if (tinker_model_set_time(self->model, 0.0) != TINKER_OK)
        return tinker_island_run_fail(run, self->model->failure, error);
    tinker_model_set_state(self->model, run->q, run->v);
    for (int32_t i = 0; i < self->contacts->pair_count; i++)
        self->contacts->pairs[i].passes = FALSE;
    watch_overlaps(self);
    if (self->model->constraints.unilateral == NULL && !tinker_contacts_touch(self->contacts)) return TRUE;
    if (!enter_plane(self, error)) return FALSE;
    if (!tinker_contact_run_change(self, &none, TINKER_TOUCHING, TINKER_START_SLOW, error)) return FALSE;
    tinker_method_restart(run->choice.method, run->stepper);
    return TRUE;
}

gboolean tinker_contact_run_reclassify(TinkerContactRun *self, GError **error)
{
    TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    if (self->contacts->closed->len == 0 && self->model->constraints.unilateral == NULL) return TRUE;
    return tinker_contact_run_change(self, &none, tinker_contact_run_closed_gap(self), 0, error);
}

gboolean tinker_contact_run_pass(TinkerContactRun *self, GError **error)
{
    TinkerIslandRun *run = self->run;
    if (!self->pending) return TRUE;
    self->pending = FALSE;
    self->passed_impact = self->last_impact;
    self->passed = TRUE;
    self->quiet = 0;
    if (is_crowded(self))
        return tinker_island_run_fail_step(run,
                                           _("contacts open and close without end there (a little friction, or a "
                                             "restitution below 1, ends such a sequence)"),
                                           error);
    if (!enter_plane(self, error) || !pass_trigger(self, &self->pending_trigger, error)) return FALSE;
    tinker_method_restart(run->choice.method, run->stepper);
    return TRUE;
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* Forgets pairs that are clear of each other. */
static void prune_separating(TinkerContactRun *self)
{
    TinkerIslandRun *run = self->run;
    if (tinker_model_set_time(self->model, run->state.t) != TINKER_OK) return;
    tinker_model_set_state(self->model, run->state.q, run->state.v);
    if (self->model->constraints.unilateral != NULL && tinker_constraints_evaluate(self->model) != TINKER_OK) return;
    double clear = TINKER_CLEAR * (tinker_contact_run_closed_gap(self) / TINKER_CLOSED_GAP);
    for (guint i = self->leaving->len; i-- > 0;) {
        const TinkerContactPair *pair = &g_array_index(self->leaving, TinkerContactPair, i);
        gboolean left;
        if (pair->row >= 0) {
            left = -self->model->constraints.own_g[pair->row] > clear;
        } else {
            TinkerContactPlace place = tinker_contact_place(self->contacts, pair->body, pair->plate);
            left = place.gap > clear || fabs(place.along) > self->contacts->plates[pair->plate].half_width;
        }
        if (left) g_array_remove_index_fast(self->leaving, i);
    }
}

/* Contacts that slip clearly by now are watched by their speed. */
static void note_slipping(TinkerContactRun *self)
{
    TinkerIslandRun *run = self->run;
    gboolean any = FALSE;
    for (guint i = 0; i < self->contacts->closed->len; i++)
        any |= tinker_contacts_closed(self->contacts, i)->starts;
    if (!any || tinker_model_set_time(self->model, run->state.t) != TINKER_OK) return;
    tinker_model_set_state(self->model, run->state.q, run->state.v);
    double unclear = tinker_contact_run_unclear_speed(self);
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        TinkerContactPlace place = tinker_contact_place(self->contacts, contact->body, contact->plate);
        if (fabs(place.tangential_speed) > unclear) contact->starts = FALSE;
    }
}

/* What supports that move do to bodies that rest is a function of time that no error control sees, since the bodies
 * stay or go along: its work needs steps that resolve it. */
static double resolved_limit(TinkerContactRun *self, double limit)
{
    const TinkerModel *model = self->model;
    double from = self->run->state.t;
    for (int32_t point = model->first_support; self->contacts->closed->len > 0 && point < model->points; point++) {
        if (!tinker_model_attachment(model, point)->moving) continue;
        double swing = tinker_contact_run_swing(self, point, from, limit);
        if (swing > 0) limit = MIN(limit, from + TINKER_LONGEST_SWING / swing);
    }
    return limit;
}

/* The greatest speed (m/s) of any body, at most. */
static double fastest(const TinkerContactRun *self, const double *v)
{
    return G_SQRT2 * tinker_largest(self->run->system.system.size, v);
}

/* How far (m) anything may go from either end of a step at a speed. */
static double travel_at(double speed, double step)
{
    return 0.75 * speed * step;
}

static void keep_start(TinkerContactRun *self, const TinkerState *state)
{
    gsize bytes = (gsize)self->run->system.system.size * sizeof(double);
    memcpy(self->from.q, state->q, bytes);
    memcpy(self->from.v, state->v, bytes);
    memcpy(self->from.books, state->books, (gsize)self->run->system.system.books * sizeof(double));
}

/* How fast the motion swings that holds the energy: its largest acceleration beside its largest speed, of late. From
 * rest the speed is at first what one short step makes of the acceleration, so that steps grow as fast as the motion
 * does. */
static double swing_limit(TinkerContactRun *self, double limit)
{
    TinkerIslandRun *run = self->run;
    TinkerSystem *system = &run->system.system;
    const TinkerState *state = &run->state;
    gint64 evaluations = self->model->evaluations;
    if (system->acceleration(system->context, state->t, state->q, state->v, self->force, NULL) == TINKER_OK)
        self->strongest = fmax(FADING * self->strongest, tinker_largest(system->size, self->force));
    self->model->evaluations = evaluations;
    self->fastest = fmax(FADING * self->fastest, tinker_largest(system->size, state->v));
    if (!(self->strongest > 0)) return limit;
    double share = TINKER_FIRST_WAY * (limit - state->t);
    return fmin(limit, state->t + fmax(share, TINKER_LONGEST_ARC * self->fastest / self->strongest));
}

/* The search for events follows no more turns than so many within a step. */
static double turning_limit(const TinkerContactRun *self, double limit)
{
    const TinkerModel *model = self->model;
    double rate = 0;
    for (int32_t k = 0; self->contacts->gap_count > 0 && k < model->turning; k++)
        rate = fmax(rate, fabs(self->run->state.v[2 * model->bodies + k]) / model->turns[k].gyration);
    return rate > 0 ? fmin(limit, self->run->state.t + TINKER_LONGEST_TURN / rate) : limit;
}

double tinker_contact_run_begin(TinkerContactRun *self, double limit)
{
    const TinkerIslandRun *run = self->run;
    watch_overlaps(self);
    limit = turning_limit(self, limit);
    if (self->leaving->len > 0) prune_separating(self);
    if (self->starts_low) note_slipping(self);
    if (self->in_plane && tinker_contact_flight_is_free(self)) leave_plane(self);
    gboolean adaptive = tinker_method_is_adaptive(run->choice.method);
    if (adaptive && self->model->moving_supports > 0) limit = resolved_limit(self, limit);
    if (self->exact) limit = swing_limit(self, limit);
    self->limit = limit;
    self->from.t = run->state.t;
    self->projection_work = run->system.projection_work;
    self->position_error = run->system.position_error;
    self->speed_bound = 0;
    if (!adaptive && self->quiet > 0) {
        double speed = TINKER_FASTER * fastest(self, run->state.v);
        if (tinker_contact_run_is_quiet(self, run->state.q, travel_at(speed, limit - run->state.t)))
            self->speed_bound = speed;
    }
    if (!(self->speed_bound > 0)) keep_start(self, &run->state);
    tinker_contact_run_expect(self);
    self->passed = FALSE;
    return MIN(limit, self->hint);
}

static void go_back(TinkerContactRun *self)
{
    TinkerIslandRun *run = self->run;
    run->system.projection_work = self->projection_work;
    run->system.position_error = self->position_error;
    gsize bytes = (gsize)run->system.system.size * sizeof(double);
    run->state.t = self->from.t;
    memcpy(run->state.q, self->from.q, bytes);
    memcpy(run->state.v, self->from.v, bytes);
    memcpy(run->state.books, self->from.books, (gsize)run->system.system.books * sizeof(double));
    tinker_method_restart(run->choice.method, run->stepper);
}

/* A trial of the time of an event: what the trigger's value was there. */
typedef struct {
    double time, value;
} Trial;

/* Where the secant through two trials falls through 0; the first knows its slope from dense output. */
static double next_trial(const Trial *trial, const Trial *before, double *slope)
{
    if (trial->time != before->time) *slope = (trial->value - before->value) / (trial->time - before->time);
    return *slope < 0 ? trial->time - trial->value / *slope : trial->time;
}

static void stand_on_event(TinkerContactRun *self, const TinkerTrigger *trigger)
{
    self->hint = INFINITY;
    self->pending = TRUE;
    self->pending_trigger = *trigger;
    if (trigger->kind == TINKER_TRIGGER_GAP) self->last_impact = self->run->state.t;
}

/* The trigger's value at a time within the step that was made, for the state that the run would go on from there. */
static TinkerStatus value_from(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double *value)
{
    TinkerModelSystem *system = &self->run->system;
    double *q, *v, work = system->projection_work, off = system->position_error;
    int32_t moved;
    TinkerStatus status = tinker_contact_run_state_at(self, time, &q, &v);
    if (status == TINKER_OK) status = system->system.project(system, time, q, v, &moved);
    system->projection_work = work;
    system->position_error = off;
    return status == TINKER_OK ? tinker_contact_run_value(self, time, q, v, trigger, value) : status;
}

/* When the trigger falls through 0 in the step that was made, to rounding. */
static TinkerStatus refine_event(TinkerContactRun *self, const TinkerTrigger *trigger, double slope, double *time)
{
    const double from = self->from.t, end = self->run->state.t;
    Trial trial = {CLAMP(*time, from, end), 0}, before = trial;
    for (int k = 0; k < MOST_TRIALS; k++) {
        TinkerStatus status = value_from(self, trigger, trial.time, &trial.value);
        if (status != TINKER_OK) return status;
        const double next = CLAMP(next_trial(&trial, &before, &slope), from, end);
        if (fabs(next - trial.time) <= 2 * DBL_EPSILON * fabs(next)) break;
        before = trial;
        trial.time = next;
    }
    *time = fmin(fmax(trial.time, from + 4 * DBL_EPSILON * fabs(from)), end);
    return TINKER_OK;
}

/* The step ends at the event, by its dense output. */
static TinkerStatus cut_to_event(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                 TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    TinkerState *state = &run->state;
    TinkerSystem *system = &run->system.system;
    int32_t moved;
    TinkerStatus status = refine_event(self, trigger, slope, &time);
    if (status == TINKER_OK && time < state->t) {
        state->t = time;
        status = tinker_method_interpolate(run->choice.method, run->stepper, time, state->q, state->v, state->books);
        if (status == TINKER_OK) status = system->project(system->context, time, state->q, state->v, &moved);
        report->step = time - self->from.t;
    }
    if (status == TINKER_OK) stand_on_event(self, trigger);
    return status;
}

/* The step is made again, to the event: dense output says when it is, the step itself how far it is off there. Where
 * the method makes several steps of it, the last of them goes on from here. */
static TinkerStatus step_to_event(TinkerContactRun *self, const TinkerTrigger *trigger, double time, double slope,
                                  TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    double from = self->from.t, end = self->limit;
    double first = MIN(from + fmax(TINKER_AT_ONCE * (run->state.t - from), 4 * DBL_EPSILON * fabs(from)), end);
    Trial trial = {CLAMP(time, first, end), 0}, before = trial;
    if (tinker_contact_run_ends_near(self, trial.time)) before.time = trial.time = run->state.t;
    for (int k = 0; k < MOST_TRIALS; k++) {
        TinkerStatus status = TINKER_OK;
        self->hint = trial.time;
        if (run->state.t != trial.time) {
            go_back(self);
            status = tinker_island_run_make_step(run, trial.time, report);
        }
        if (status != TINKER_OK || run->state.t < trial.time) {
            self->hint_trigger = *trigger;
            self->hint_slope = slope;
            return status;
        }
        tinker_island_run_place(run);
        status = tinker_contact_run_value(self, run->state.t, run->q, run->v, trigger, &trial.value);
        if (status != TINKER_OK) return status;
        double next = CLAMP(next_trial(&trial, &before, &slope), first, end);
        if (fabs(next - trial.time) <= 2 * DBL_EPSILON * fabs(next)) break;
        gboolean there;
        status = tinker_contact_run_carry_to(self, trigger, next, report, &there);
        if (status != TINKER_OK) return status;
        if (there) break;
        before = trial;
        trial.time = next;
    }
    stand_on_event(self, trigger);
    return TINKER_OK;
}

/* Of a step that was taken for quiet and turned out too fast for that: its start, from dense output. */
static TinkerStatus recall_start(TinkerContactRun *self)
{
    TinkerIslandRun *run = self->run;
    TinkerState start = {self->from.t, self->from.q, self->from.v, self->from.books};
    self->speed_bound = 0;
    return tinker_island_run_interpolate(run, start.t, start.q, start.v, start.books);
}

TinkerStatus tinker_contact_run_look(TinkerContactRun *self, TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    TinkerStatus status = TINKER_OK;
    double time, slope, *from = self->from.q;
    TinkerTrigger found;
    if (self->speed_bound > 0) {
        self->hint = INFINITY;
        double speed = fastest(self, run->state.v);
        if (speed <= self->speed_bound) return TINKER_OK;
        if (tinker_contact_run_is_quiet(self, run->state.q, travel_at(speed, run->state.t - self->from.t)))
            return TINKER_OK;
        status = recall_start(self);
        if (status != TINKER_OK) return status;
    }
    double speed = fmax(run->system.speed, fmax(fastest(self, run->state.v), fastest(self, self->from.v)));
    double travel = travel_at(speed, run->state.t - self->from.t);
    const gboolean expected = self->expects && run->state.t == self->hint;
    if (run->state.t == self->hint && !expected) {
        found = self->hint_trigger;
        return step_to_event(self, &found, self->hint, self->hint_slope, report);
    }
    self->hint = INFINITY;
    self->expects = FALSE;
    if (!expected) self->usual = run->state.t - self->from.t;
    if (tinker_contact_run_is_quiet(self, run->state.q, travel)) return TINKER_OK;
    tinker_island_run_place(run);
    if (!self->in_plane && run->q != run->state.q) {
        tinker_linear_form_expand(run->island->linear, self->from.q, self->from.v, self->node_q, self->node_v);
        from = self->node_q;
    }
    status = tinker_model_set_time(self->model, run->state.t);
    if (status != TINKER_OK) return status;
    tinker_contact_run_find_near(self, from, run->q, travel);
    status = tinker_contact_run_search(self, self->from.t, run->state.t, &found, &time, &slope);
    if (status != TINKER_OK) return status;
    if (found.kind == TINKER_TRIGGER_NONE && expected) tinker_contact_run_take_expected(self, &found, &time, &slope);
    if (found.kind != TINKER_TRIGGER_NONE)
        return self->remembers ? cut_to_event(self, &found, time, slope, report)
                               : step_to_event(self, &found, time, slope, report);
    if (self->near->len == 0 && self->model->constraints.unilateral == NULL)
        tinker_contact_run_note_quiet(self, run->state.q, run->q);
    return TINKER_OK;
}
