/* The forces of closed contacts, between events. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contact-pins.h"
#include "physics/contact/contacts-private.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

/* Accelerations that cancel leave this share of their magnitudes, and as often as much as there are this many rows of
 * one block: the solve of n rows rounds n times. */
#define CANCELLED      (16 * DBL_EPSILON)
#define CANCELLED_ROWS 4.0

static const double *acceleration_of(const TinkerContacts *contacts, const TinkerContact *contact)
{
    return contacts->model->point_acceleration + 2 * contacts->plates[contact->plate].point;
}

void tinker_contacts_relative_acceleration(const TinkerContacts *contacts, const TinkerContact *contact,
                                           const double *a, double along[2])
{
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    const double *n = plate->normal, *at = a + 2 * contact->body, *base = acceleration_of(contacts, contact);
    TinkerContactEntries entries;
    if (plate->gap == NULL) {
        along[0] = n[0] * (at[0] - base[0]) + n[1] * (at[1] - base[1]);
        along[1] = n[1] * (at[0] - base[0]) - n[0] * (at[1] - base[1]);
        return;
    }
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    for (int which = 0; which < 2; which++)
        along[which] = tinker_contact_times(&entries, which, a) + entries.drift[which];
}

static void refresh(TinkerContacts *contacts, int32_t closed, int32_t entries)
{
    tinker_contact_gap_entries(contacts, tinker_contacts_closed(contacts, (guint)closed)->plate,
                               &g_array_index(contacts->entries, TinkerContactEntries, (guint)entries));
}

void tinker_contacts_refresh_entries(TinkerContacts *contacts)
{
    for (guint i = 0; contacts->entries->len > 0 && i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
        if (row->resisting >= 0) refresh(contacts, row->resisting, row->resisting_entries);
        if (row->entries < 0 || (row->tangential && !tinker_contacts_resists(contacts, contact))) continue;
        refresh(contacts, row->contact, row->entries);
    }
}

/* Rows that are solved together ------------------------------------------------------------------------------------ */

static int32_t body_of(const TinkerContacts *contacts, const TinkerContactRow *row)
{
    return tinker_contacts_closed(contacts, (guint)row->contact)->body;
}

static gboolean has_turning_pins(const TinkerContacts *contacts, const TinkerContactBlock *block)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    gboolean any = FALSE;
    for (int32_t i = 0; contacts->pin_count > 0 && i < block->count; i++)
        any |= rows[i].pin_slope != 0;
    return any;
}

/* Pins that turn are moved by nobody: 0 = 0. */
static void leave_out_pins(TinkerContacts *contacts, const TinkerContactBlock *block)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    double *matrix = contacts->delassus + block->matrix;
    for (int32_t i = 0; i < block->count; i++)
        for (int32_t j = 0; j < block->count; j++)
            if (rows[i].pin_slope != 0 || rows[j].pin_slope != 0) matrix[i * block->count + j] = i == j;
}

/* Whether its matrix has a column j that is to be worked out. */
static gboolean asks_for(const TinkerContactBlock *block, gboolean moves, int32_t j)
{
    return block->elimination == NULL && !block->factored[moves] && j < block->count;
}

/* A column of a block's matrix: what a push along row j, which was made, does along all of its rows. */
static void take_column(TinkerContacts *contacts, const TinkerContactBlock *block, gboolean moves, int32_t j)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    double *matrix = contacts->delassus + block->matrix;
    for (int32_t i = 0; i < block->count; i++)
        matrix[i * block->count + j] =
            tinker_contact_row_times(contacts, &rows[i], contacts->column) * (rows[i].weight * rows[j].weight);
    if (!moves && contacts->pin_count > 0)
        tinker_contact_pins_keep(contacts, block, contacts->pins.answers + 2 * block->matrix + j, (gsize)block->count);
}

/* The matrices of all blocks that have to be factored anew. What is done to one moves no other: column by column they
 * are pushed at once, as constraints answer by a solve of the whole model. */
static void fill_matrices(TinkerContacts *contacts, gboolean moves)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data;
    const TinkerContactBlock *blocks = (const TinkerContactBlock *)(const void *)contacts->blocks->data;
    gboolean any = TRUE;
    for (int32_t j = 0; any; j++) {
        any = FALSE;
        for (guint i = 0; i < contacts->blocks->len; i++) {
            if (!asks_for(&blocks[i], moves, j)) continue;
            if (!any) {
                memset(contacts->column, 0, (gsize)contacts->model->coordinates * sizeof(double));
                tinker_contacts_begin_pushes(contacts);
                any = TRUE;
            }
            tinker_contact_row_push(contacts, &rows[blocks[i].first + j], 1, moves, contacts->column);
        }
        if (any) tinker_contacts_end_pushes(contacts, contacts->column);
        for (guint i = 0; any && i < contacts->blocks->len; i++)
            if (asks_for(&blocks[i], moves, j)) take_column(contacts, &blocks[i], moves, j);
    }
}

/* Takes its matrix, if that was filled anew. */
static void factor_block(TinkerContacts *contacts, TinkerContactBlock *block, gboolean moves)
{
    if (block->factored[moves]) return;
    const gboolean turning = has_turning_pins(contacts, block);
    if (turning && moves) leave_out_pins(contacts, block);
    if (turning && !moves) return; /* their rows depend on the solution */
    tinker_dense_solve_factor(block->solve[moves], contacts->delassus + block->matrix);
    block->factored[moves] = !block->held;
}

/* `near`: what forces that nothing determines are near to; NULL: 0. */
static void begin_elimination(TinkerContacts *contacts, const TinkerContactBlock *block, gboolean moves,
                              const double *near)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    double *asked = contacts->demand + block->first, *found = contacts->found + block->first;
    for (int32_t i = 0; i < block->count; i++) {
        found[i] = near != NULL ? near[i] * rows[i].weight : 0;
        asked[i] /= rows[i].weight;
    }
    tinker_contact_elimination_take(block->elimination, contacts->equations[moves] + block->first, block->count);
    tinker_contact_elimination_begin(block->elimination, asked, found);
}

static void take_found(TinkerContacts *contacts, TinkerContactBlock *block, gboolean moves)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    if (!moves) block->full = tinker_contact_elimination_is_full(block->elimination);
    for (int32_t i = block->first; i < block->first + block->count; i++)
        contacts->demand[i] = contacts->found[i] / rows[i - block->first].weight;
}

/* All blocks that are solved by elimination. */
static void eliminate_blocks(TinkerContacts *contacts, gboolean moves)
{
    TinkerContactBlock *blocks = (TinkerContactBlock *)(void *)contacts->blocks->data;
    if (contacts->eliminated->len == 0) return;
    for (guint i = 0; i < contacts->blocks->len; i++)
        if (blocks[i].elimination != NULL)
            begin_elimination(contacts, &blocks[i], moves, moves ? NULL : contacts->base + blocks[i].first);
    tinker_contact_eliminations_end((TinkerContactElimination *const *)contacts->eliminated->pdata,
                                    contacts->eliminated->len);
    for (guint i = 0; i < contacts->blocks->len; i++)
        if (blocks[i].elimination != NULL) take_found(contacts, &blocks[i], moves);
}

void tinker_contacts_solve_moves(TinkerContacts *contacts)
{
    eliminate_blocks(contacts, TRUE);
    fill_matrices(contacts, TRUE);
    for (guint i = 0; i < contacts->blocks->len; i++) {
        TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        if (block->elimination != NULL) continue;
        factor_block(contacts, block, TRUE);
        tinker_dense_solve(block->solve[TRUE], contacts->demand + block->first);
    }
}

/* Twice is enough up to where W says nothing of the heavy bodies any more. */
#define MOST_REFINEMENTS 3

/* What the forces found so far leave of `asked`, into the demand: by the accelerations of the bodies, in which forces
 * that cancel do so before they are divided by a small mass; W has them divided before. Answers whether any is left. */
static gboolean measure_miss(TinkerContacts *contacts, const TinkerContactBlock *block, const double *asked)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    double *found = contacts->found + block->first, *miss = contacts->demand + block->first;
    gboolean any = FALSE;
    memset(contacts->column, 0, (gsize)contacts->model->coordinates * sizeof(double));
    tinker_contacts_begin_pushes(contacts);
    for (int32_t i = 0; i < block->count; i++)
        tinker_contact_row_push(contacts, &rows[i], found[i] * rows[i].weight, FALSE, contacts->column);
    tinker_contacts_end_pushes(contacts, contacts->column);
    for (int32_t i = 0; i < block->count; i++) {
        miss[i] = asked[i] - tinker_contact_row_times(contacts, &rows[i], contacts->column) * rows[i].weight;
        any |= miss[i] != 0;
    }
    return any;
}

/* Solves for a block of uneven bodies: beside 1/m of a light body W has little left of 1/M of a heavy one that leans on
 * it, so that what it gives is brought nearer by what that leaves. Source: N. J. Higham, "Accuracy and Stability of
 * Numerical Algorithms", SIAM 2002, chapter 12: iterative refinement. */
static void solve_uneven(TinkerContacts *contacts, TinkerContactBlock *block)
{
    const gsize bytes = (gsize)block->count * sizeof(double);
    double *found = contacts->found + block->first, *left = contacts->demand + block->first;
    double *asked = contacts->asked + block->first;
    memcpy(asked, left, bytes);
    tinker_dense_solve_near(block->solve[FALSE], contacts->base + block->first, left);
    memcpy(found, left, bytes);
    for (int pass = 0; pass < MOST_REFINEMENTS && measure_miss(contacts, block, asked); pass++) {
        tinker_dense_solve(block->solve[FALSE], left);
        for (int32_t i = 0; i < block->count; i++)
            found[i] += left[i];
    }
    memcpy(left, found, bytes);
}

static void solve_forces(TinkerContacts *contacts)
{
    eliminate_blocks(contacts, FALSE);
    fill_matrices(contacts, FALSE);
    for (guint i = 0; i < contacts->blocks->len; i++) {
        TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        if (block->elimination != NULL) continue;
        factor_block(contacts, block, FALSE);
        if (has_turning_pins(contacts, block))
            tinker_contact_pins_solve(contacts, block, contacts->demand + block->first);
        else if (block->uneven)
            solve_uneven(contacts, block);
        else
            tinker_dense_solve_near(block->solve[FALSE], contacts->base + block->first,
                                    contacts->demand + block->first);
    }
}

/* a += M^-1 times a force along the tangential row of entries. */
static void accelerate_along(const TinkerContacts *contacts, const TinkerContactEntries *entries, double force,
                             double *a)
{
    for (int32_t k = 0; k < entries->count; k++) {
        const int32_t at = entries->coordinate[k], body = tinker_model_moved_by(contacts->model, at);
        const double part = entries->row[1][k] * force * contacts->model->inverse_mass[body];
        a[at] += part;
        contacts->acts[at] += fabs(part);
    }
}

/* a += M^-1 times a row's force; constraints answer later. */
static void accelerate_by(const TinkerContacts *contacts, const TinkerContactRow *row, double force, double *a)
{
    const TinkerModel *model = contacts->model;
    const int32_t body = body_of(contacts, row);
    if (row->entries < 0) {
        a[2 * body] += row->force[0] * force * model->inverse_mass[body];
        a[2 * body + 1] += row->force[1] * force * model->inverse_mass[body];
        return;
    }
    const TinkerContactEntries *entries = tinker_contact_row_entries(contacts, row);
    for (int32_t k = 0; k < entries->count; k++) {
        const int32_t at = entries->coordinate[k];
        const double along = entries->row[row->tangential][k] + (row->tangential ? 0 : row->share * entries->row[1][k]);
        const double part = along * force * model->inverse_mass[tinker_model_moved_by(model, at)];
        a[at] += part;
        contacts->acts[at] += fabs(part);
    }
    if (row->resisting >= 0)
        accelerate_along(contacts, tinker_contact_row_resisting(contacts, row), force * row->resisting_share, a);
}

/* Takes over the force of a row that was solved for. */
static void note_force(TinkerContacts *contacts, const TinkerContactRow *row, double force)
{
    TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
    if (row->tangential) {
        contact->friction = force;
        return;
    }
    contact->normal = force;
    contact->friction = force * tinker_contact_slip_share(contacts, contact);
    if (row->resisting >= 0)
        tinker_contacts_closed(contacts, (guint)row->resisting)->friction = force * row->resisting_share;
}

/* What resists knows the normal force that bounds it. */
static void share_normals(TinkerContacts *contacts)
{
    for (guint i = 0; contacts->resistance_count > 0 && i < contacts->closed->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->bearer >= 0) contact->normal = tinker_contacts_closed(contacts, (guint)contact->bearer)->normal;
    }
}

static void accelerate_rows(TinkerContacts *contacts, double *a)
{
    TinkerModel *model = contacts->model;
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data;
    double *free_of_contacts = contacts->accelerations, *demand = contacts->demand;
    tinker_contacts_refresh_entries(contacts);
    memcpy(free_of_contacts, a, (gsize)model->coordinates * sizeof(double));
    if (model->constraints.rows > 0) tinker_constraints_accelerate(model, free_of_contacts);
    for (guint i = 0; contacts->pin_count > 0 && i < contacts->blocks->len; i++) {
        const TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        tinker_contact_pins_keep(contacts, block, contacts->pins.free + 2 * (gsize)block->first, 1);
    }
    for (guint i = 0; i < contacts->rows->len; i++) {
        const double *at = free_of_contacts + 2 * body_of(contacts, &rows[i]);
        if (rows[i].entries >= 0) {
            const TinkerContactEntries *entries = tinker_contact_row_entries(contacts, &rows[i]);
            const int which = rows[i].tangential;
            demand[i] =
                -(tinker_contact_times(entries, which, free_of_contacts) + entries->drift[which]) * rows[i].weight;
            continue;
        }
        const double *plate = acceleration_of(contacts, tinker_contacts_closed(contacts, (guint)rows[i].contact));
        demand[i] = -(rows[i].row[0] * (at[0] - plate[0]) + rows[i].row[1] * (at[1] - plate[1])) * rows[i].weight;
    }
    solve_forces(contacts);
    for (guint i = 0; i < contacts->rows->len; i++) {
        const double force = demand[i] * rows[i].weight;
        accelerate_by(contacts, &rows[i], force, a);
        note_force(contacts, &rows[i], force);
    }
    share_normals(contacts);
}

/* One by one ------------------------------------------------------------------------------------------------------- */

static inline void accelerate_alone(TinkerContacts *contacts, TinkerContact *contact, double *a)
{
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    const double *base = acceleration_of(contacts, contact), mass = contacts->model->mass[contact->body];
    const double nx = plate->normal[0], ny = plate->normal[1];
    double *at = a + 2 * contact->body;
    const double rx = at[0] - base[0], ry = at[1] - base[1], along = ny * rx - nx * ry;
    contact->normal = -mass * (nx * rx + ny * ry);
    if (contact->mode == TINKER_CONTACT_STICK) {
        contact->friction = -mass * along;
        at[0] = base[0];
        at[1] = base[1];
        return;
    }
    contact->friction = tinker_contact_slip_share(contacts, contact) * contact->normal;
    const double slides = along + contact->friction / mass;
    at[0] = base[0] + ny * slides;
    at[1] = base[1] - nx * slides;
}

/* What forces that cancel leave of accelerations is nothing, up to a share of their magnitudes: else the steps of what
 * lies still would resolve it. */
static void clear_rest(const TinkerContacts *contacts, const TinkerContactEntries *entries, double share, double *a)
{
    for (int32_t k = 0; k < entries->count; k++) {
        const int32_t at = entries->coordinate[k], body = tinker_model_moved_by(contacts->model, at);
        const double *of_body = contacts->acts + 2 * body;
        if (fabs(a[at]) <= share * (of_body[0] + of_body[1] + contacts->acts[at])) a[at] = 0;
    }
}

/* Of each block by its own rows, so that nothing depends on what others there are. */
static void clear_rests(const TinkerContacts *contacts, double *a)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data;
    for (guint i = 0; contacts->entries->len > 0 && i < contacts->blocks->len; i++) {
        const TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        const double share = CANCELLED * fmax(1, block->count / CANCELLED_ROWS);
        for (int32_t k = block->first; k < block->first + block->count; k++) {
            if (rows[k].entries >= 0) clear_rest(contacts, tinker_contact_row_entries(contacts, &rows[k]), share, a);
            if (rows[k].resisting >= 0)
                clear_rest(contacts, tinker_contact_row_resisting(contacts, &rows[k]), share, a);
        }
    }
}

void tinker_contacts_accelerate(TinkerContacts *contacts, double *a)
{
    const int32_t *simple = (const int32_t *)(const void *)contacts->simple->data;
    contacts->evaluations++;
    for (guint i = 0; i < contacts->simple->len; i++)
        accelerate_alone(contacts, tinker_contacts_closed(contacts, (guint)simple[i]), a);
    for (int32_t i = 0; contacts->entries->len > 0 && i < contacts->model->coordinates; i++)
        contacts->acts[i] = fabs(a[i]);
    if (contacts->rows->len > 0) accelerate_rows(contacts, a);
    if (contacts->model->constraints.rows > 0) tinker_constraints_accelerate(contacts->model, a);
    tinker_contacts_note_pin_forces(contacts);
    clear_rests(contacts, a);
}

static void add_gap_friction(const TinkerContacts *contacts, const TinkerContact *contact, double *a)
{
    TinkerContactEntries entries;
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    accelerate_along(contacts, &entries, contact->friction, a);
}

void tinker_contacts_add_friction(const TinkerContacts *contacts, double *a)
{
    for (guint i = 0; contacts->any_slip_friction && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->mode == TINKER_CONTACT_STICK) continue;
        const double *n = contacts->plates[contact->plate].normal;
        if (tinker_contacts_is_gap(contacts, contact)) {
            add_gap_friction(contacts, contact, a);
            continue;
        }
        double push = contact->friction * contacts->model->inverse_mass[contact->body];
        a[2 * contact->body] += n[1] * push;
        a[2 * contact->body + 1] -= n[0] * push;
    }
}
