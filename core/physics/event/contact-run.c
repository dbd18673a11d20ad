/* Contact in the run of an island: begins and ends steps, and passes events. */
#include <float.h>
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contact-pins.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/event/tolerances.h"
#include "physics/island/island-run.h"
#include "physics/line/linear-form.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"
#include "physics/system/method-call.h"
#include "physics/system/system.h"

/* So many events within TINKER_CROWDED never end, nor do so many times as many, each within TINKER_SLOW_CROWDED. */
#define CROWD       500
#define SLOW_CROWDS 20
/* So few bodies with outlines are decided upon all together. */
#define FEW_MEET 64
/* Near pairs that there is room for at first. */
#define MOST_EXPECTED 16

static void allot(TinkerContactRun *self)
{
    gsize n = (gsize)MAX(self->model->coordinates, 1);
    double **arrays[] = {&self->from.q, &self->from.v, &self->node_x,  &self->node_u,     &self->node_q,
                         &self->node_v, &self->force,  &self->quiet_x, &self->start.force};
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
    self->struck = g_array_new(FALSE, FALSE, sizeof(int32_t));
    self->alike = g_array_new(FALSE, FALSE, sizeof(TinkerTrigger));
    self->asked = g_array_new(FALSE, FALSE, sizeof(TinkerTrigger));
    self->turns = tinker_contact_turns_new();
    self->triggers = g_array_sized_new(FALSE, FALSE, sizeof(TinkerTrigger), 2 * pairs);
    self->falling = g_array_sized_new(FALSE, FALSE, sizeof(guint), 2 * pairs);
    self->values_room = 2 * pairs * (gsize)(TINKER_MOST_DEGREE + 1);
    self->values = g_new0(double, self->values_room);
    self->end_values = g_new0(double, self->values_room);
    self->plate_speed = g_new0(double, self->model->points - self->model->first_support + 1);
    self->together = g_new0(int32_t, n);
    self->many = tinker_contacts_outlines(self->contacts) > FEW_MEET;
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
        .jammed = NAN,
        .looked_time = NAN,
        .start.at.t = NAN,
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
    g_array_unref(self->struck);
    g_array_unref(self->alike);
    g_array_unref(self->asked);
    g_array_unref(self->turns);
    g_array_unref(self->triggers);
    g_array_unref(self->falling);
    gpointer arrays[] = {self->from.q,      self->from.v,      self->from.books, self->node_x,      self->node_u,
                         self->node_q,      self->node_v,      self->force,      self->orientation, self->quiet_x,
                         self->values,      self->force_scale, self->end_values, self->plate_speed, self->start.force,
                         self->start.loads, self->together};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

/* Lies along a top that a motion turns, and stays as it left it. */
static void turn_along(TinkerContactRun *self, int32_t body, double t)
{
    const TinkerContacts *contacts = self->contacts;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerTouchingPair *pair = contacts->plates[contact->plate].pair;
        if (contact->body != body || pair == NULL || pair->turned == NULL) continue;
        if (tinker_model_set_time(self->model, t) == TINKER_OK)
            self->orientation[body] = tinker_plate_angle(&contacts->plates[contact->plate]);
    }
}

double tinker_contact_run_orientation(TinkerContactRun *self, int32_t body, double t)
{
    const TinkerContacts *contacts = self->contacts;
    const gboolean is_mass = !isnan(contacts->half_height[body]) && !tinker_contacts_has_outline(contacts, body);
    if (is_mass && contacts->first_gap[body] < contacts->first_gap[body + 1]) turn_along(self, body, t);
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
    /* at a start the time itself is as short as what has passed of it */
    const double t = self->run->state.t, passed = t - self->crowd_began, most = fmax(fabs(t), self->usual);
    if (++self->crowd < CROWD) return FALSE;
    self->crowd = 0;
    self->crowd_began = t;
    self->slow_crowds = passed <= TINKER_SLOW_CROWDED * most ? self->slow_crowds + 1 : 0;
    return passed <= TINKER_CROWDED * most || self->slow_crowds >= SLOW_CROWDS;
}

/* Where pins that rub hold more than is needed, nothing says how they share it. */
static void warn_of_pins(TinkerContactRun *self)
{
    TinkerModel *model = self->model;
    for (guint i = 0; i < self->contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(self->contacts, i);
        const TinkerPlate *plate = &self->contacts->plates[contact->plate];
        if (!tinker_contacts_is_pin(self->contacts, contact) || tinker_contact_pin_is_determined(model, plate))
            continue;
        tinker_summary_warn_of_method(
            &self->run->summary,
            g_strdup_printf(_("the force of %s is not determined, since more joints hold what it holds than "
                              "are needed: its friction, and so the motion, depends on the share chosen, "
                              "that of least norm (leave out a joint, or the friction)"),
                            tinker_scene_block_name(model->scene, plate->block)));
        return;
    }
}

gboolean tinker_contact_run_start(TinkerContactRun *self, GError **error)
{
    TinkerIslandRun *run = self->run;
    TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    double speed;
    tinker_island_run_place(run);
    run->system.system.scales(&run->system, run->state.q, run->state.v, &self->size, &speed);
    self->size += self->contacts->thickness;
    if (tinker_model_set_time(self->model, 0.0) != TINKER_OK)
        return tinker_island_run_fail(run, self->model->failure, error);
    tinker_model_set_state(self->model, run->q, run->v);
    tinker_contact_run_note_overlaps(self);
    if (self->model->constraints.unilateral == NULL && !tinker_contacts_touch(self->contacts)) return TRUE;
    if (!enter_plane(self, error)) return FALSE;
    tinker_contacts_close_pins(self->contacts);
    if (!tinker_contact_run_change_until_parting(self, &none, TINKER_TOUCHING, TINKER_START_SLOW, error)) return FALSE;
    if (self->contacts->pin_count > 0) warn_of_pins(self);
    tinker_method_restart(run->choice.method, run->stepper);
    return TRUE;
}

gboolean tinker_contact_run_reclassify(TinkerContactRun *self, GError **error)
{
    TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    if (self->contacts->closed->len == 0 && self->model->constraints.unilateral == NULL) return TRUE;
    return tinker_contact_run_change(self, &none, tinker_contact_run_closed_gap(self), 0, error);
}

gboolean tinker_contact_run_open_blow(TinkerContactRun *self, GError **error)
{
    const TinkerTrigger none = {.kind = TINKER_TRIGGER_NONE, .row = -1};
    return enter_plane(self, error) &&
           tinker_contact_run_change_until_parting(self, &none, tinker_contact_run_closed_gap(self), 0, error);
}

gboolean tinker_contact_run_close_blow(TinkerContactRun *self, const double *given, GError **error)
{
    const TinkerTrigger blow = {.kind = TINKER_TRIGGER_BLOW, .row = -1};
    self->passed = TRUE;
    self->quiet = 0;
    self->hint = INFINITY;
    self->expects = FALSE;
    self->given = given;
    const gboolean done =
        tinker_contact_run_change_until_parting(self, &blow, tinker_contact_run_closed_gap(self), 0, error);
    self->given = NULL;
    return done;
}

/* The event that the state stands on. */
static gboolean pass_pending(TinkerContactRun *self, GError **error)
{
    if (is_crowded(self))
        return tinker_island_run_fail_step(self->run,
                                           _("contacts open and close so often there that the run would hardly end "
                                             "(a little friction, or a restitution below 1, ends such a sequence)"),
                                           error);
    return enter_plane(self, error) && pass_trigger(self, &self->pending_trigger, error);
}

gboolean tinker_contact_run_pass(TinkerContactRun *self, GError **error)
{
    TinkerIslandRun *run = self->run;
    if (!self->pending) return TRUE;
    self->pending = FALSE;
    self->passed_impact = self->last_impact;
    self->passed = TRUE;
    self->quiet = 0;
    g_array_set_size(self->asked, 0);
    do
        if (!pass_pending(self, error)) return FALSE;
    while (tinker_contact_run_next_at_once(self, &self->pending_trigger));
    g_array_set_size(self->alike, 0);
    tinker_method_restart(run->choice.method, run->stepper);
    return TRUE;
}

/* Steps ------------------------------------------------------------------------------------------------------------ */

/* Forgets pairs that are clear of each other. What stands at the very end of its plate may be beyond it by rounding:
 * watched by its gap, it would close where it has just opened, again and again. */
static void prune_separating(TinkerContactRun *self)
{
    TinkerIslandRun *run = self->run;
    if (tinker_model_set_time(self->model, run->state.t) != TINKER_OK) return;
    tinker_model_set_state(self->model, run->state.q, run->state.v);
    if (self->model->constraints.unilateral != NULL && tinker_constraints_evaluate(self->model) != TINKER_OK) return;
    const double closed = tinker_contact_run_closed_gap(self), clear = TINKER_CLEAR * (closed / TINKER_CLOSED_GAP);
    for (guint i = self->leaving->len; i-- > 0;) {
        const TinkerContactPair *pair = &g_array_index(self->leaving, TinkerContactPair, i);
        gboolean left;
        if (pair->row >= 0) {
            left = -self->model->constraints.own_g[pair->row] > clear;
        } else {
            TinkerContactPlace place = tinker_contact_place(self->contacts, pair->body, pair->plate);
            left = place.gap > clear || fabs(place.along) > self->contacts->plates[pair->plate].half_width + closed;
        }
        if (left) g_array_remove_index_fast(self->leaving, i);
    }
}

/* Forgets sides of lines that corners are clear of, whichever way. */
static void prune_struck(TinkerContactRun *self)
{
    const TinkerIslandRun *run = self->run;
    if (tinker_model_set_time(self->model, run->state.t) != TINKER_OK) return;
    tinker_model_set_state(self->model, run->q, run->v);
    const double touching = tinker_contact_run_touching(self);
    for (guint i = self->struck->len; i-- > 0;)
        if (fabs(tinker_contact_gap_alone(self->contacts, g_array_index(self->struck, int32_t, i))) > touching)
            g_array_remove_index_fast(self->struck, i);
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

TinkerStatus tinker_contact_run_begin(TinkerContactRun *self, double *limit)
{
    const TinkerIslandRun *run = self->run;
    TinkerStatus status = tinker_contact_run_watch_overlaps(self);
    if (status != TINKER_OK) return status;
    if (self->leaving->len > 0) prune_separating(self);
    if (self->struck->len > 0) prune_struck(self);
    if (self->starts_low) note_slipping(self);
    if (self->in_plane && tinker_contact_flight_is_free(self)) leave_plane(self);
    self->limit = tinker_contact_run_step_limit(self, *limit);
    self->from.t = run->state.t;
    self->projection_work = run->system.projection_work;
    self->position_error = run->system.position_error;
    self->speed_bound = 0;
    if (!tinker_method_is_adaptive(run->choice.method) && self->quiet > 0) {
        double speed = TINKER_FASTER * fastest(self, run->state.v);
        if (tinker_contact_run_is_quiet(self, run->state.q, travel_at(speed, self->limit - run->state.t)))
            self->speed_bound = speed;
    }
    if (self->speed_bound > 0)
        tinker_contact_run_forget_start(self);
    else
        tinker_contact_run_keep_start(self);
    tinker_contact_run_expect(self);
    self->passed = FALSE;
    self->carried = FALSE;
    *limit = MIN(self->limit, self->hint);
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

/* Whether a step that began as quiet was so to its end. */
static gboolean stayed_quiet(const TinkerContactRun *self)
{
    const TinkerState *state = &self->run->state;
    const double speed = fastest(self, state->v);
    return speed <= self->speed_bound ||
           tinker_contact_run_is_quiet(self, state->q, travel_at(speed, state->t - self->from.t));
}

/* Looks for what the step met. Apart, as most steps are quiet. */
static G_NO_INLINE TinkerStatus look_for_contact(TinkerContactRun *self, TinkerStepReport *report)
{
    TinkerIslandRun *run = self->run;
    TinkerStatus status = self->speed_bound > 0 ? recall_start(self) : TINKER_OK;
    double time, slope, *from = self->from.q;
    TinkerTrigger found;
    if (status != TINKER_OK) return status;
    double speed = fmax(run->system.speed, fmax(fastest(self, run->state.v), fastest(self, self->from.v)));
    double travel = travel_at(speed, run->state.t - self->from.t);
    const gboolean expected = self->expects && run->state.t == self->hint;
    if (run->state.t == self->hint && !expected) {
        found = self->hint_trigger;
        return tinker_contact_run_end_at(self, &found, self->hint, self->hint_slope, report);
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
    tinker_model_set_state(self->model, run->q, run->v);
    tinker_contact_run_find_near(self, from, run->q, travel);
    status = tinker_contact_run_search(self, self->from.t, run->state.t, &found, &time, &slope);
    if (status != TINKER_OK) return status;
    if (found.kind == TINKER_TRIGGER_NONE && expected) tinker_contact_run_take_expected(self, &found, &time, &slope);
    if (found.kind != TINKER_TRIGGER_NONE) return tinker_contact_run_end_at(self, &found, time, slope, report);
    if (self->near->len == 0 && self->model->constraints.unilateral == NULL)
        tinker_contact_run_note_quiet(self, run->state.q, run->q);
    return TINKER_OK;
}

TinkerStatus tinker_contact_run_look(TinkerContactRun *self, TinkerStepReport *report)
{
    self->run->system.known = NULL;
    if (self->speed_bound > 0) self->hint = INFINITY;
    return self->speed_bound > 0 && stayed_quiet(self) ? TINKER_OK : look_for_contact(self, report);
}
