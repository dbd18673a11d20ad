/* Which pairs of body and plate a step may bring together: by distances, so that what does not touch costs next to
 * nothing; and which shapes overlap where they should have met. */
#include <glib/gi18n-lib.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/disjoint-sets.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run-private.h"
#include "physics/island/island-run.h"
#include "physics/model/failures.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"

/* A neighbourhood reaches as far as so many steps like this one lead. */
#define STEPS_AHEAD 32
/* So far lead pairs, which are many to look through. */
#define STEPS_AHEAD_OF_PAIRS 4

/* Whether the pair is closed; `next` is where to look: closed contacts are in the order of their bodies. */
static gboolean is_closed(const TinkerContacts *contacts, int32_t body, int32_t plate, guint next)
{
    for (; next < contacts->closed->len; next++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, next);
        if (contact->body != body) return FALSE;
        if (contact->plate == plate) return TRUE;
    }
    return FALSE;
}

/* Both ends of the way beyond the same bound by more than the way may lead back. */
static gboolean stays_beyond(double from, double to, double bound, double travel)
{
    return MIN(from, to) > bound + travel || MAX(from, to) < -bound - travel;
}

static gboolean may_touch(const TinkerContacts *contacts, int32_t body, int32_t number, const double *from,
                          const double *to, double travel)
{
    const TinkerPlate *plate = &contacts->plates[number];
    if (plate->moving) return TRUE;
    const TinkerPoint *centre = &contacts->model->point[plate->point];
    double gap[2], along[2];
    for (int k = 0; k < 2; k++) {
        const double *at = k == 0 ? from : to;
        double dx = at[0] - centre->x, dy = at[1] - centre->y;
        gap[k] = plate->normal[0] * dx + plate->normal[1] * dy - plate->half_height - contacts->half_height[body];
        along[k] = plate->normal[1] * dx - plate->normal[0] * dy;
    }
    return !stays_beyond(gap[0], gap[1], 0, travel) && !stays_beyond(along[0], along[1], plate->half_width, travel);
}

static gboolean pair_may_touch(const TinkerContacts *contacts, const TinkerTouchingPair *pair, const double *q_from,
                               const double *q_to, double travel)
{
    if (pair->moving) return TRUE;
    return fmin(tinker_contact_pair_distance(contacts, pair, q_from),
                tinker_contact_pair_distance(contacts, pair, q_to)) <= travel;
}

/* How far (rad) a body turns while nothing of the state moves farther than `travel` (m): turns count in metres, by
 * their gyration. */
static double turn_within(const TinkerContacts *contacts, int32_t point, double travel)
{
    const TinkerTurn *turn = point < contacts->model->bodies ? tinker_model_turn(contacts->model, point) : NULL;
    return turn != NULL ? travel / turn->gyration : 0;
}

/* Whether a gap may reach 0 while nothing of the state in the points moves farther than `travel` (m). With P of the
 * tip, C of the seat on a body at X, which turns by at most a: |gap'| - |gap| is at most |P' - P| + |C' - C| +
 * a |P' - X'|. What is far below an edge stays below it as what is far above stays above. */
static gboolean gap_may_close(const TinkerContacts *contacts, int32_t number, double travel)
{
    const TinkerPlate *plate = &contacts->plates[number];
    const TinkerTouchingPair *pair = plate->pair;
    const TinkerPoint *at[2];
    double turns[2], moves[2];
    for (int k = 0; k < 2; k++) {
        const int32_t point = pair->point[k];
        at[k] = &contacts->model->point[point];
        turns[k] = turn_within(contacts, point, travel);
        moves[k] = point < contacts->model->bodies ? travel + turns[k] * pair->outline[k]->radius : 0;
    }
    const int tip = plate->gap->tip_of;
    const double apart = hypot(at[0]->x - at[1]->x, at[0]->y - at[1]->y) + pair->outline[tip]->radius;
    const double most = moves[0] + moves[1] + turns[1 - tip] * (apart + moves[0] + moves[1]);
    return !(fabs(tinker_contact_gap_alone(contacts, number)) > most + TINKER_TOUCHING);
}

/* Whether a step that ends in the state in the points may close a gap, or it has to be watched whatever it does. */
static gboolean is_of_interest(const TinkerContactRun *self, const TinkerContactPair *each, double travel)
{
    if (self->contacts->plates[each->plate].moving || tinker_contact_run_leaves(self, each)) return TRUE;
    return gap_may_close(self->contacts, each->plate, 2 * travel);
}

static TinkerTouchingPair *near_pair(const TinkerContactRun *self, guint number)
{
    return &self->contacts->pairs[g_array_index(self->neighbours.pairs, int32_t, number)];
}

/* Gap functions of a body; *number is of the first of its pairs among those listed, then of the next body's. */
static void find_near_gaps(TinkerContactRun *self, int32_t body, const double *q_from, const double *q_to,
                           double travel, guint next, guint *number)
{
    const TinkerContacts *contacts = self->contacts;
    for (; *number < self->neighbours.pairs->len; ++*number) {
        const TinkerTouchingPair *pair = near_pair(self, *number);
        if (pair->point[0] != body) return;
        if (!pair_may_touch(contacts, pair, q_from, q_to, travel)) continue;
        for (int32_t k = pair->first; k < pair->first + pair->count; k++) {
            const TinkerContactPair each = {body, k, -1};
            if (!is_closed(contacts, body, k, next) && !tinker_contact_run_is_across(self, body, k) &&
                is_of_interest(self, &each, travel))
                g_array_append_val(self->near, each);
        }
    }
}

void tinker_contact_run_find_near(TinkerContactRun *self, const double *q_from, const double *q_to, double travel)
{
    const TinkerContacts *contacts = self->contacts;
    double extent =
        hypot(self->run->system.box[2] - self->run->system.box[0], self->run->system.box[3] - self->run->system.box[1]);
    double reach = fmax(STEPS_AHEAD * travel, isfinite(extent) ? TINKER_LEAST_NEIGHBOURHOOD * extent : 0);
    guint next = 0, number = 0;
    g_array_set_size(self->near, 0);
    self->pair_margin = fmax(STEPS_AHEAD_OF_PAIRS * travel, isfinite(extent) ? TINKER_LEAST_NEIGHBOURHOOD * extent : 0);
    tinker_contact_neighbours_find_pairs(&self->neighbours, q_from, q_to, travel, self->pair_margin);
    for (int32_t i = 0; i < self->model->bodies; i++) {
        const double *from = q_from + 2 * i, *to = q_to + 2 * i;
        while (next < contacts->closed->len && tinker_contacts_closed(contacts, next)->body < i)
            next++;
        find_near_gaps(self, i, q_from, q_to, travel, next, &number);
        if (isnan(contacts->half_height[i])) continue;
        if (!tinker_contact_neighbours_hold(&self->neighbours, i, from, to, travel))
            tinker_contact_neighbours_list(&self->neighbours, i, from, to, reach);
        for (guint k = 0; k < self->neighbours.lists[i]->len; k++) {
            TinkerContactPair pair = {i, g_array_index(self->neighbours.lists[i], int32_t, k), -1};
            if (may_touch(contacts, i, pair.plate, from, to, travel) && !is_closed(contacts, i, pair.plate, next))
                g_array_append_val(self->near, pair);
        }
    }
}

gboolean tinker_contact_run_is_quiet(const TinkerContactRun *self, const double *x, double travel)
{
    if (!(self->quiet > travel)) return FALSE;
    double most = 0;
    for (int32_t i = 0; i < self->run->system.system.size; i++)
        most = MAX(most, fabs(x[i] - self->quiet_x[i]));
    return G_SQRT2 * most + travel < self->quiet;
}

void tinker_contact_run_note_quiet(TinkerContactRun *self, const double *x, const double *q)
{
    const TinkerContacts *contacts = self->contacts;
    self->quiet = 0;
    if (contacts->moving_plates > 0 || contacts->closed->len > 0) return;
    double nearest = INFINITY;
    for (guint i = 0; i < self->neighbours.pairs->len; i++)
        nearest = fmin(nearest, tinker_contact_pair_distance(contacts, near_pair(self, i), q));
    if (nearest > tinker_contact_neighbours_unlisted_distance(&self->neighbours, q))
        for (int32_t i = 0; i < contacts->pair_count; i++)
            nearest = fmin(nearest, tinker_contact_pair_distance(contacts, &contacts->pairs[i], q));
    for (int32_t i = 0; i < self->model->bodies; i++) {
        if (isnan(contacts->half_height[i])) continue;
        /* plates beyond the neighbourhood are farther than what is left of it */
        const double *centre = self->neighbours.centre + 2 * i;
        double left = self->neighbours.reach[i] - hypot(q[2 * i] - centre[0], q[2 * i + 1] - centre[1]);
        nearest = fmin(nearest, left);
        for (guint k = 0; k < self->neighbours.lists[i]->len; k++) {
            int32_t plate = g_array_index(self->neighbours.lists[i], int32_t, k);
            nearest = fmin(nearest, tinker_contact_distance(contacts, i, plate, q + 2 * i));
        }
    }
    memcpy(self->quiet_x, x, (gsize)self->run->system.system.size * sizeof(double));
    self->quiet = nearest;
}

/* Together --------------------------------------------------------------------------------------------------------- */

static void join(TinkerContactRun *self, int32_t plate)
{
    const TinkerTouchingPair *pair = self->contacts->plates[plate].pair;
    if (pair != NULL && pair->point[1] < self->model->bodies)
        tinker_sets_join(self->together, pair->point[0], pair->point[1]);
}

/* Of a few bodies all that may ever meet: what noise is to their contacts is the same for all of them. */
void tinker_contact_run_find_together(TinkerContactRun *self)
{
    const TinkerContacts *contacts = self->contacts;
    const gsize bytes = (gsize)self->model->bodies * sizeof(int32_t);
    memcpy(self->together, self->many ? contacts->tied : contacts->group, bytes);
    if (!self->many) return;
    for (guint i = 0; i < contacts->closed->len; i++)
        join(self, tinker_contacts_closed(contacts, i)->plate);
    for (guint i = 0; i < self->near->len; i++)
        join(self, g_array_index(self->near, TinkerContactPair, i).plate);
    for (guint i = 0; i < self->leaving->len; i++) {
        const TinkerContactPair *pair = &g_array_index(self->leaving, TinkerContactPair, i);
        if (pair->row < 0) join(self, pair->plate);
    }
    tinker_sets_settle(self->together, self->model->bodies);
}

/* Overlaps --------------------------------------------------------------------------------------------------------- */

/* How far two shapes overlap; at most 0 where circles around them are apart by more than `touching` (m). */
static double overlap_of(const TinkerContactRun *self, TinkerTouchingPair *pair, double touching)
{
    TinkerContacts *contacts = self->contacts;
    if (!pair->moving && tinker_contact_pair_distance(contacts, pair, self->run->q) > touching) return -touching;
    return tinker_contact_pair_overlap(contacts, pair);
}

void tinker_contact_run_note_overlaps(TinkerContactRun *self)
{
    TinkerContacts *contacts = self->contacts;
    if (contacts->pair_count == 0) return;
    const double touching = tinker_contact_run_touching(self);
    for (int32_t i = 0; i < contacts->pair_count; i++)
        contacts->pairs[i].passes = overlap_of(self, &contacts->pairs[i], touching) > touching;
}

/* Whether a gap of the pair has just opened, and is watched by its acceleration. */
static gboolean has_just_parted(const TinkerContactRun *self, const TinkerTouchingPair *pair)
{
    for (guint i = 0; i < self->leaving->len; i++) {
        const TinkerContactPair *leaving = &g_array_index(self->leaving, TinkerContactPair, i);
        const int32_t gap = leaving->plate - pair->first;
        if (leaving->row < 0 && gap >= 0 && gap < pair->count) return TRUE;
    }
    return FALSE;
}

static TinkerStatus tell_missed(TinkerContactRun *self, const TinkerTouchingPair *pair, double overlap)
{
    TinkerModel *model = self->model;
    tinker_model_tell_failure(model,
                              _("%s and %s overlap there, by %.3g m: that they met was missed (a smaller tolerance or "
                                "step may find it)"),
                              tinker_scene_block_name(model->scene, tinker_model_block_of(model, pair->point[0])),
                              tinker_scene_block_name(model->scene, tinker_model_block_of(model, pair->point[1])),
                              overlap);
    return TINKER_FAILED;
}

/* Bodies have no side from which they pass, as tops have. Those that have just parted may overlap by the error of a
 * step. */
TinkerStatus tinker_contact_run_watch_overlaps(TinkerContactRun *self)
{
    TinkerContacts *contacts = self->contacts;
    TinkerIslandRun *run = self->run;
    if (contacts->pair_count == 0) return TINKER_OK;
    TinkerStatus status = tinker_model_set_time(self->model, run->state.t);
    if (status != TINKER_OK) return status;
    tinker_island_run_place(run);
    tinker_model_set_state(self->model, run->q, run->v);
    const double touching = tinker_contact_run_touching(self);
    tinker_contact_neighbours_find_pairs(&self->neighbours, run->q, run->q, touching, self->pair_margin);
    for (guint i = 0; i < self->neighbours.pairs->len && status == TINKER_OK; i++) {
        TinkerTouchingPair *pair = near_pair(self, i);
        const double overlap = overlap_of(self, pair, touching);
        const gboolean overlaps = overlap > touching;
        const gboolean bodies = pair->point[1] < self->model->bodies;
        const gboolean parted = overlaps && bodies && has_just_parted(self, pair);
        if (overlaps && bodies && !parted && !pair->passes) status = tell_missed(self, pair, overlap);
        pair->passes = (overlaps && !parted) || (pair->passes && overlap > 0);
    }
    return status;
}
