/* What the runs of the islands make of the whole model at an instant: where its bodies are, which of its contacts are
 * closed, and the values of columns. */
#include <math.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/event/contact-run.h"
#include "physics/impulse/impulse.h"
#include "physics/island/island-run.h"
#include "physics/model/breaks.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/run/island-samples.h"
#include "physics/run/tolerances.h"
#include "physics/system/method-call.h"

/* How the bodies of one island were turned by what they touched, among all. */
static void collect_orientations(TinkerIslandRuns *self, const TinkerIslandRun *run, double t)
{
    gboolean impulses = tinker_method_solves_contact(run->choice.method);
    for (int32_t i = 0; (run->contacts != NULL || impulses) && i < run->model->bodies; i++)
        self->orientation[run->island->body_of[i]] = impulses ? tinker_impulse_orientation(run->stepper, i)
                                                              : tinker_contact_run_orientation(run->contacts, i, t);
}

int32_t tinker_island_runs_coordinate(const TinkerIslandRuns *self, const TinkerIslandRun *run, int32_t coordinate)
{
    const TinkerModel *part = run->model;
    if (part == self->model) return coordinate;
    if (coordinate < 2 * part->bodies) return 2 * run->island->body_of[coordinate / 2] + coordinate % 2;
    return tinker_model_turn_of(self->model, run->island->body_of[tinker_model_moved_by(part, coordinate)]);
}

void tinker_island_runs_spread(const TinkerIslandRuns *self, const TinkerIslandRun *run, const double *part_q,
                               const double *part_v, double *q, double *v)
{
    const TinkerModel *whole = self->model, *part = run->model;
    const double shift[2] = {part->origin[0] - whole->origin[0], part->origin[1] - whole->origin[1]};
    for (int32_t i = 0; i < part->coordinates; i++) {
        const int32_t at = tinker_island_runs_coordinate(self, run, i);
        q[at] = i < 2 * part->bodies ? part_q[i] + shift[i % 2] : part_q[i];
        v[at] = part_v[i];
    }
}

/* Where the bodies of one island are at t, among all. */
static TinkerStatus collect_states(TinkerIslandRuns *self, TinkerIslandRun *run, double t)
{
    if (run->model == self->model) return tinker_island_run_state_at(run, t, self->sample_q, self->sample_v);
    TinkerStatus status = tinker_island_run_state_at(run, t, self->part_q, self->part_v);
    tinker_island_runs_spread(self, run, self->part_q, self->part_v, self->sample_q, self->sample_v);
    return status;
}

TinkerStatus tinker_island_runs_collect(TinkerIslandRuns *self, TinkerIslandRun *run, double t)
{
    TinkerStatus status = collect_states(self, run, t);
    if (status == TINKER_OK) collect_orientations(self, run, t);
    return status;
}

/* The first row of each block of a model, by its number. (transfer full) */
static int32_t *first_rows(const TinkerModel *model)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t *first = g_new0(int32_t, MAX(tinker_block_index_count(model->numbers), 1));
    for (int32_t row = all->rows - 1; row >= 0; row--)
        first[tinker_block_index_find(model->numbers, all->blocks[row])] = row;
    return first;
}

/* The whole model's rows that hold in one direction only are slack as those of the islands; the rows of one block stand
 * together and have one order in all models. */
static void gather_slack(TinkerIslandRuns *self)
{
    if (self->model->constraints.unilateral == NULL) return;
    g_autofree int32_t *first = first_rows(self->model);
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        const TinkerConstraints *part = &run->model->constraints;
        for (int32_t row = 0, begin = 0; part->unilateral != NULL && row < part->rows; row++) {
            if (part->blocks[row] != part->blocks[begin]) begin = row;
            const int32_t number = tinker_block_index_find(self->model->numbers, part->blocks[row]);
            if (part->unilateral[row])
                tinker_constraints_set_slack(self->model, first[number] + row - begin, part->slack[row]);
        }
    }
}

static gint64 count_contact_changes(const TinkerIslandRuns *self)
{
    gint64 changes = 0;
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        if (run->contacts != NULL) changes += tinker_contact_run_changes(run->contacts);
    }
    return changes;
}

gboolean tinker_island_runs_gather_contacts(TinkerIslandRuns *self, GError **error)
{
    TinkerContacts *all = self->model->contacts;
    if (all == NULL || self->runs->len < 2) return TRUE;
    gint64 changes = count_contact_changes(self);
    if (changes == self->contact_changes) return TRUE;
    self->contact_changes = changes;
    g_array_set_size(all->closed, 0);
    for (guint i = 0; i < self->runs->len; i++) {
        const TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        const TinkerContacts *part = run->model->contacts;
        for (guint k = 0; part != NULL && k < part->closed->len; k++) {
            TinkerContact contact = *tinker_contacts_closed(part, k);
            const int32_t body = run->island->body_of[contact.body];
            contact.plate = tinker_contacts_plate_of_part(all, part, &contact, body);
            contact.body = body;
            g_array_append_val(all->closed, contact);
        }
    }
    gather_slack(self);
    if (tinker_contacts_list_rows(all) == TINKER_OK) return TRUE;
    g_set_error_literal(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_MEMORY, self->model->failure);
    return FALSE;
}

/* The whole model has its own waveforms where it is not stepped itself: they enter the piece that t begins or lies in.
 */
static void enter_piece_at(TinkerIslandRuns *self, double t)
{
    const TinkerIslandRun *first = g_ptr_array_index(self->runs, 0);
    if (first->model == self->model || t < self->piece_end) return;
    double horizon = MAX(self->times.duration, t + 1.0);
    double next = tinker_model_next_break(self->model, t, horizon);
    self->piece_end = MIN(next, horizon);
    tinker_model_enter_piece(self->model, t, tinker_time_inside(t, self->piece_end), self->piece_end);
}

/* The whole model enters the piece that ends at t or holds it, where none of its islands is the whole. */
static void enter_piece_before(TinkerIslandRuns *self, double t)
{
    if (t != self->piece_end) enter_piece_at(self, t * (1 - TINKER_SAME_INSTANT));
}

static TinkerStatus sample(TinkerIslandRuns *self, double t)
{
    const gint64 evaluations = self->model->evaluations;
    TinkerStatus status = tinker_sampler_values(self->sampler, t, self->sample_q, self->sample_v, self->values);
    if (status == TINKER_OK && self->along != NULL) status = tinker_along_run_values(self->along, t, self->values);
    self->model->evaluations = evaluations;
    return status;
}

TinkerStatus tinker_island_runs_sample(TinkerIslandRuns *self, double t)
{
    enter_piece_at(self, t);
    return sample(self, t);
}

TinkerStatus tinker_island_runs_sample_before(TinkerIslandRuns *self, double t)
{
    enter_piece_before(self, t);
    return sample(self, t);
}

double tinker_island_runs_wound_length(TinkerIslandRuns *self, TinkerBlockId block)
{
    for (guint i = 0; i < self->runs->len; i++) {
        TinkerIslandRun *run = g_ptr_array_index(self->runs, i);
        /* a state may cost a projection: of one island alone */
        if (run->model->constraints.unilateral == NULL || tinker_block_index_find(run->model->numbers, block) < 0 ||
            tinker_island_run_state_at(run, self->sample_time, self->part_q, self->part_v) != TINKER_OK)
            continue;
        const double length =
            tinker_constraints_wound_length(run->model, self->sample_time, self->part_q, self->part_v, block);
        if (!isnan(length)) return length;
    }
    return NAN;
}
