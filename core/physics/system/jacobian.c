/* The derivatives of the applied forces as sparse matrices: the pattern, lines, and all of it together. */
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/force/derivatives.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/system/jacobian-private.h"
#include "physics/system/jacobian.h"

/* Beyond these, what presses two bodies together that nothing else couples is no part of the matrix. */
#define MOST_PAIRS_A_BODY 16

typedef struct {
    int32_t row, column; /* bodies */
} Block;

/* Pattern ---------------------------------------------------------------------------------------------------------- */

static void note_block(const TinkerModel *model, GArray *blocks, int32_t one, int32_t other)
{
    const int32_t a = tinker_model_body_of(model, one), b = tinker_model_body_of(model, other);
    if (a < 0 || b < 0 || a == b) return;
    Block there = {a, b}, back = {b, a};
    g_array_append_val(blocks, there);
    g_array_append_val(blocks, back);
}

static void note_element(const TinkerModel *model, const TinkerAskedBatch *asked, GArray *blocks)
{
    const TinkerBlockBatch *batch = asked->batch;
    for (int32_t row = 0; row < batch->count; row++)
        for (int32_t e = batch->end_offsets[row]; e < batch->end_offsets[row + 1]; e++)
            for (int32_t k = batch->end_offsets[row]; k < e; k++)
                note_block(model, blocks, asked->end_points[k], asked->end_points[e]);
}

static void note_constraints(const TinkerConstraints *constraints, const TinkerModel *model, GArray *blocks)
{
    for (int32_t row = 0; row < constraints->rows; row++)
        for (int32_t e = constraints->row_starts[row]; e < constraints->row_starts[row + 1]; e++)
            for (int32_t k = constraints->row_starts[row]; k < e; k++)
                note_block(model, blocks, constraints->points[k], constraints->points[e]);
}

/* Bodies that may touch, where these are not so many pairs that they would fill the matrix. */
static void note_contacts(const TinkerModel *model, GArray *blocks)
{
    const TinkerContacts *contacts = model->contacts;
    if (contacts->pair_count > MOST_PAIRS_A_BODY * model->bodies) return;
    for (int32_t i = 0; i < contacts->pair_count; i++)
        note_block(model, blocks, contacts->pairs[i].point[0], contacts->pairs[i].point[1]);
}

static int compare_blocks(const void *left, const void *right)
{
    const Block *l = left, *r = right;
    if (l->row != r->row) return l->row < r->row ? -1 : 1;
    return (l->column > r->column) - (l->column < r->column);
}

/* All blocks, sorted, each once. */
static GArray *collect_blocks(const TinkerModel *model)
{
    GArray *blocks = g_array_new(FALSE, FALSE, sizeof(Block));
    for (int32_t i = 0; i < model->bodies; i++) {
        Block own = {i, i};
        g_array_append_val(blocks, own);
    }
    for (int32_t i = 0; i < model->lines.count; i++)
        note_block(model, blocks, model->lines.a[i], model->lines.b[i]);
    for (guint i = 0; i < model->asked_lines->len; i++)
        note_element(model, &g_array_index(model->asked_lines, TinkerAskedBatch, i), blocks);
    for (guint i = 0; i < model->asked_forces->len; i++)
        note_element(model, &g_array_index(model->asked_forces, TinkerAskedBatch, i), blocks);
    note_constraints(&model->constraints, model, blocks);
    if (model->contacts != NULL) note_contacts(model, blocks);
    g_array_sort(blocks, compare_blocks);
    guint kept = 0;
    for (guint i = 0; i < blocks->len; i++) {
        Block block = g_array_index(blocks, Block, i);
        if (kept > 0 && compare_blocks(&g_array_index(blocks, Block, kept - 1), &block) == 0) continue;
        g_array_index(blocks, Block, kept++) = block;
    }
    g_array_set_size(blocks, kept);
    return blocks;
}

/* The columns of the turns of the bodies of a row of blocks, which are numbered as the bodies are. */
static int32_t add_turn_columns(TinkerJacobian *self, const GArray *blocks, guint first, guint end, int32_t entry)
{
    for (guint i = first; i < end && self->model->turning > 0; i++) {
        const int32_t turn = tinker_model_turn_of(self->model, g_array_index(blocks, Block, i).column);
        if (turn >= 0) self->columns[entry++] = turn;
    }
    return entry;
}

/* The rows of turns, which have the columns that the body's other rows have. */
static int32_t add_turn_rows(TinkerJacobian *self, const GArray *blocks, int32_t entry)
{
    const TinkerModel *model = self->model;
    for (guint first = 0, end; first < blocks->len; first = end) {
        const int32_t row = g_array_index(blocks, Block, first).row, turn = tinker_model_turn_of(model, row);
        for (end = first; end < blocks->len && g_array_index(blocks, Block, end).row == row;)
            end++;
        if (turn < 0) continue;
        for (guint i = first; i < end; i++)
            for (int32_t k = 0; k < 2; k++)
                self->columns[entry++] = 2 * g_array_index(blocks, Block, i).column + k;
        entry = add_turn_columns(self, blocks, first, end, entry);
        self->row_starts[turn + 1] = entry;
    }
    return entry;
}

static void make_pattern(TinkerJacobian *self)
{
    g_autoptr(GArray) blocks = collect_blocks(self->model);
    int32_t n = self->model->coordinates, entry = 0;
    self->row_starts = g_new0(int32_t, (gsize)n + 1);
    self->columns = g_new(int32_t, (self->model->turning > 0 ? 9 : 4) * (gsize)MAX(blocks->len, 1));
    self->diagonal = g_new(int32_t, MAX(self->model->bodies, 1));
    for (guint first = 0, end; first < blocks->len; first = end) {
        int32_t row = g_array_index(blocks, Block, first).row;
        for (end = first; end < blocks->len && g_array_index(blocks, Block, end).row == row;)
            end++;
        for (int half = 0; half < 2; half++) {
            for (guint i = first; i < end; i++) {
                int32_t column = g_array_index(blocks, Block, i).column;
                if (half == 0 && column == row) self->diagonal[row] = entry;
                self->columns[entry++] = 2 * column;
                self->columns[entry++] = 2 * column + 1;
            }
            entry = add_turn_columns(self, blocks, first, end, entry);
            self->row_starts[2 * row + half + 1] = entry;
        }
    }
    if (self->model->turning > 0) entry = add_turn_rows(self, blocks, entry);
    self->pattern = (TinkerPattern){n, entry, self->row_starts, self->columns};
}

static TinkerLineSlots find_slots(const TinkerJacobian *self, int32_t a, int32_t b)
{
    if (self->model->turning > 0) return (TinkerLineSlots){-1, -1};
    if (a >= self->model->bodies || b >= self->model->bodies) return (TinkerLineSlots){-1, -1};
    return (TinkerLineSlots){tinker_jacobian_find(self, a, b), tinker_jacobian_find(self, b, a)};
}

static void find_all_slots(TinkerJacobian *self)
{
    const TinkerModel *model = self->model;
    self->merged = g_new(TinkerLineSlots, MAX(model->lines.count, 1));
    for (int32_t i = 0; i < model->lines.count; i++)
        self->merged[i] = find_slots(self, model->lines.a[i], model->lines.b[i]);
    self->asked = g_new0(TinkerLineSlots *, MAX(model->asked_lines->len, 1));
    for (guint k = 0; k < model->asked_lines->len; k++) {
        const TinkerAskedBatch *asked = &g_array_index(model->asked_lines, TinkerAskedBatch, k);
        self->asked[k] = g_new(TinkerLineSlots, MAX(asked->batch->count, 1));
        for (int32_t i = 0; i < asked->batch->count; i++)
            self->asked[k][i] = find_slots(self, asked->end_points[2 * i], asked->end_points[2 * i + 1]);
    }
}

static int32_t most_ends(const TinkerModel *model)
{
    int32_t most = 1;
    for (guint k = 0; k < model->asked_forces->len; k++) {
        const TinkerBlockBatch *batch = g_array_index(model->asked_forces, TinkerAskedBatch, k).batch;
        for (int32_t row = 0; row < batch->count; row++)
            most = MAX(most, batch->end_offsets[row + 1] - batch->end_offsets[row]);
    }
    return most;
}

TinkerJacobian *tinker_jacobian_new(TinkerModel *model)
{
    TinkerJacobian *self = g_new0(TinkerJacobian, 1);
    self->model = model;
    make_pattern(self);
    find_all_slots(self);
    self->force = g_new(double, 8 * (gsize)most_ends(model)); /* forces, and twice forces with torques */
    return self;
}

void tinker_jacobian_free(TinkerJacobian *self)
{
    if (self == NULL) return;
    for (guint k = 0; k < self->model->asked_lines->len; k++)
        g_free(self->asked[k]);
    g_free(self->asked);
    g_free(self->merged);
    g_free(self->row_starts);
    g_free(self->columns);
    g_free(self->diagonal);
    g_free(self->force);
    g_free(self);
}

const TinkerPattern *tinker_jacobian_pattern(const TinkerJacobian *self)
{
    return &self->pattern;
}

/* Values ----------------------------------------------------------------------------------------------------------- */

/* A line pulls at both ends: the force on b is opposite to that on a. */
static inline void add_to_ends(const TinkerJacobian *self, double *values, int32_t a, int32_t b, TinkerLineSlots slots,
                               const double block[4])
{
    if (a == b) return;
    if (G_UNLIKELY(self->model->turning > 0)) {
        const int32_t ends[2] = {a, b};
        for (int i = 0; i < 4; i++)
            tinker_jacobian_spread(self, values, ends[i / 2], ends[i % 2], i / 2 == i % 2 ? 1 : -1, block);
        return;
    }
    if (a < self->model->bodies) tinker_jacobian_add(self, values, a, self->diagonal[a], 1, block);
    if (b < self->model->bodies) tinker_jacobian_add(self, values, b, self->diagonal[b], 1, block);
    if (slots.ab < 0) return;
    tinker_jacobian_add(self, values, a, slots.ab, -1, block);
    tinker_jacobian_add(self, values, b, slots.ba, -1, block);
}

static inline void add_line(const TinkerJacobian *self, int32_t a, int32_t b, TinkerLineSlots slots,
                            const TinkerLineDerivatives *line)
{
    double block[4];
    tinker_line_stiffness(line, block);
    add_to_ends(self, self->stiffness, a, b, slots, block);
    if (line->damping == 0) return;
    tinker_line_damping(line, block);
    add_to_ends(self, self->damping, a, b, slots, block);
}

static void add_merged(const TinkerJacobian *self)
{
    const TinkerMergedLines *lines = &self->model->lines;
    for (int32_t i = 0; i < lines->count; i++) {
        TinkerLineDerivatives line = tinker_merged_line_derivatives(self->model, i);
        add_line(self, lines->a[i], lines->b[i], self->merged[i], &line);
    }
}

static TinkerStatus add_asked_lines(TinkerJacobian *self, const TinkerAskedBatch *asked, const TinkerLineSlots *slots)
{
    for (int32_t i = 0; i < asked->batch->count; i++) {
        TinkerLineDerivatives line;
        TinkerStatus status = tinker_asked_line_derivatives(self->model, asked, i, &line);
        if (status != TINKER_OK) return status;
        add_line(self, asked->end_points[2 * i], asked->end_points[2 * i + 1], slots[i], &line);
    }
    return TINKER_OK;
}

static void add_drag(const TinkerJacobian *self)
{
    double block[4] = {self->model->field_drag, 0, 0, self->model->field_drag};
    for (int32_t i = 0; i < self->model->bodies; i++)
        tinker_jacobian_add(self, self->damping, i, self->diagonal[i], 1, block);
}

TinkerStatus tinker_jacobian_evaluate(TinkerJacobian *self, double t, const double *q, const double *v,
                                      double *stiffness, double *damping)
{
    TinkerModel *model = self->model;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_state(model, q, v);
    tinker_jacobian_choose_differences(self);
    self->stiffness = stiffness;
    self->damping = damping;
    memset(stiffness, 0, sizeof(double) * (gsize)self->pattern.entries);
    memset(damping, 0, sizeof(double) * (gsize)self->pattern.entries);
    if (model->turning > 0) status = tinker_jacobian_add_turned_arms(self);
    add_merged(self);
    add_drag(self);
    for (guint i = 0; i < model->asked_lines->len && status == TINKER_OK; i++)
        status = add_asked_lines(self, &g_array_index(model->asked_lines, TinkerAskedBatch, i), self->asked[i]);
    for (guint i = 0; i < model->asked_forces->len && status == TINKER_OK; i++)
        status = tinker_jacobian_add_elements(self, &g_array_index(model->asked_forces, TinkerAskedBatch, i));
    for (guint i = 0; i < model->asked_fields->len && status == TINKER_OK; i++)
        status = tinker_jacobian_add_field(self, &g_array_index(model->asked_fields, TinkerAskedBatch, i));
    return status;
}

/* The mass that moves along a row: 1 / (J M^-1 J^T). */
static double row_mass(const TinkerModel *model, int32_t row)
{
    const TinkerConstraints *all = &model->constraints;
    double mobility = 0;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        const double *j = all->jacobian + 2 * (gsize)e;
        if (all->points[e] < model->bodies)
            mobility += model->inverse_mass[all->points[e]] * (j[0] * j[0] + j[1] * j[1]);
    }
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++) {
        const double j = all->jacobian[2 * all->entries + k];
        mobility += model->inverse_mass[all->points[all->turns[k].entry]] * j * j;
    }
    return mobility > 0 ? 1 / mobility : 0;
}

static void add_row_mass(const TinkerJacobian *self, int32_t row, double *values)
{
    const TinkerConstraints *all = &self->model->constraints;
    double mass = row_mass(self->model, row);
    if (self->model->turning > 0) {
        tinker_jacobian_add_row_mass(self, row, mass, values);
        return;
    }
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        for (int32_t k = all->row_starts[row]; k < all->row_starts[row + 1]; k++) {
            int32_t on = all->points[e], of = all->points[k];
            if (on >= self->model->bodies || of >= self->model->bodies) continue;
            const double *j = all->jacobian + 2 * (gsize)e, *i = all->jacobian + 2 * (gsize)k;
            double block[4] = {j[0] * i[0], j[0] * i[1], j[1] * i[0], j[1] * i[1]};
            tinker_jacobian_add(self, values, on, tinker_jacobian_find(self, on, of), mass, block);
        }
}

/* A body on a plate moves along its top, or not at all. */
static void add_contact_masses(const TinkerJacobian *self, double *values)
{
    const TinkerContacts *contacts = self->model->contacts;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const double *n = contacts->plates[contact->plate].normal;
        if (tinker_contacts_is_gap(contacts, contact)) {
            tinker_jacobian_add_gap_mass(self, contact, values);
            continue;
        }
        double stuck = contact->mode == TINKER_CONTACT_STICK ? 1.0 : 0.0;
        double block[4] = {n[0] * n[0] + stuck * n[1] * n[1], (1 - stuck) * n[0] * n[1], (1 - stuck) * n[0] * n[1],
                           n[1] * n[1] + stuck * n[0] * n[0]};
        tinker_jacobian_add(self, values, contact->body, tinker_jacobian_find(self, contact->body, contact->body),
                            self->model->mass[contact->body], block);
    }
}

/* Rows depend on places alone: the velocities are those of the state set last. */
TinkerStatus tinker_jacobian_row_masses(TinkerJacobian *self, double t, const double *q, double *values)
{
    TinkerModel *model = self->model;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    tinker_model_set_places(model, q);
    status = tinker_constraints_evaluate(model);
    if (status != TINKER_OK) return status;
    memset(values, 0, sizeof(double) * (gsize)self->pattern.entries);
    for (int32_t row = 0; row < model->constraints.rows; row++)
        add_row_mass(self, row, values);
    if (tinker_contacts_act(model->contacts)) add_contact_masses(self, values);
    return TINKER_OK;
}
