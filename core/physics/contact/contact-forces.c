/* The forces of closed contacts, between events. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts-private.h"
#include "physics/contact/contacts.h"
#include "physics/model/model-data.h"

static const double *acceleration_of(const TinkerContacts *contacts, const TinkerContact *contact)
{
    return contacts->model->point_acceleration + 2 * contacts->plates[contact->plate].point;
}

void tinker_contacts_begin_pushes(TinkerContacts *contacts)
{
    contacts->pushed = FALSE;
}

void tinker_contacts_add_push(TinkerContacts *contacts, int32_t body, double px, double py, double *v)
{
    const TinkerModel *model = contacts->model;
    const double change[2] = {px * model->inverse_mass[body], py * model->inverse_mass[body]};
    double *by_point = model->constraints.by_point;
    v[2 * body] += change[0];
    v[2 * body + 1] += change[1];
    if (!contacts->held[body]) return;
    if (!contacts->pushed) memset(by_point, 0, 2 * (gsize)model->points * sizeof(double));
    contacts->pushed = TRUE;
    by_point[2 * body] += change[0];
    by_point[2 * body + 1] += change[1];
}

void tinker_contacts_end_pushes(TinkerContacts *contacts, double *v)
{
    if (contacts->pushed) tinker_constraints_answer(contacts->model, v);
}

void tinker_contacts_push(TinkerContacts *contacts, int32_t body, double px, double py, double *v)
{
    tinker_contacts_begin_pushes(contacts);
    tinker_contacts_add_push(contacts, body, px, py, v);
    tinker_contacts_end_pushes(contacts, v);
}

/* What a push in a direction does to all bodies, in contacts->column. */
static const double *answer_to(TinkerContacts *contacts, int32_t body, const double direction[2])
{
    memset(contacts->column, 0, (gsize)contacts->model->coordinates * sizeof(double));
    tinker_contacts_push(contacts, body, direction[0], direction[1], contacts->column);
    return contacts->column;
}

void tinker_contacts_delassus(TinkerContacts *contacts, const TinkerContact *touching, int32_t count, double *delassus)
{
    for (int32_t column = 0; column < 2 * count; column++) {
        const double *normal = contacts->plates[touching[column / 2].plate].normal;
        const double push[2] = {column % 2 == 0 ? normal[0] : normal[1], column % 2 == 0 ? normal[1] : -normal[0]};
        const double *change = answer_to(contacts, touching[column / 2].body, push);
        for (int32_t i = 0; i < count; i++) {
            const double *n = contacts->plates[touching[i].plate].normal, *at = change + 2 * touching[i].body;
            delassus[2 * i * 2 * count + column] = n[0] * at[0] + n[1] * at[1];
            delassus[(2 * i + 1) * 2 * count + column] = n[1] * at[0] - n[0] * at[1];
        }
    }
}

/* Rows that are solved together ---------------------------------------------------------------------------------------
 */

static int32_t body_of(const TinkerContacts *contacts, const TinkerContactRow *row)
{
    return tinker_contacts_closed(contacts, (guint)row->contact)->body;
}

static void factor_block(TinkerContacts *contacts, TinkerContactBlock *block, gboolean moves)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    for (int32_t j = 0; j < block->count; j++) {
        const double *change = answer_to(contacts, body_of(contacts, &rows[j]), moves ? rows[j].row : rows[j].force);
        for (int32_t i = 0; i < block->count; i++) {
            const double *at = change + 2 * body_of(contacts, &rows[i]);
            contacts->delassus[i * block->count + j] =
                (rows[i].row[0] * at[0] + rows[i].row[1] * at[1]) * (rows[i].weight * rows[j].weight);
        }
    }
    tinker_dense_solve_factor(block->solve[moves], contacts->delassus);
    block->factored[moves] = !block->held;
}

/* `near`: what forces that nothing determines are near to; NULL: 0. */
static void eliminate_block(TinkerContacts *contacts, TinkerContactBlock *block, gboolean moves, const double *near)
{
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data + block->first;
    double *asked = contacts->demand + block->first, *found = contacts->found + block->first;
    for (int32_t i = 0; i < block->count; i++) {
        found[i] = near != NULL ? near[i] * rows[i].weight : 0;
        asked[i] /= rows[i].weight;
    }
    tinker_contact_elimination_take(block->elimination, contacts->equations[moves] + block->first, block->count);
    const gboolean full = tinker_contact_elimination_solve(block->elimination, asked, found);
    if (!moves) block->full = full;
    for (int32_t i = 0; i < block->count; i++)
        asked[i] = found[i] / rows[i].weight;
}

void tinker_contacts_solve_moves(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->blocks->len; i++) {
        TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        if (block->elimination != NULL) {
            eliminate_block(contacts, block, TRUE, NULL);
            continue;
        }
        if (!block->factored[TRUE]) factor_block(contacts, block, TRUE);
        tinker_dense_solve(block->solve[TRUE], contacts->demand + block->first);
    }
}

static void solve_forces(TinkerContacts *contacts)
{
    for (guint i = 0; i < contacts->blocks->len; i++) {
        TinkerContactBlock *block = &g_array_index(contacts->blocks, TinkerContactBlock, i);
        if (block->elimination != NULL) {
            eliminate_block(contacts, block, FALSE, contacts->base + block->first);
            continue;
        }
        if (!block->factored[FALSE]) factor_block(contacts, block, FALSE);
        tinker_dense_solve_near(block->solve[FALSE], contacts->base + block->first, contacts->demand + block->first);
    }
}

static void accelerate_rows(TinkerContacts *contacts, double *a)
{
    TinkerModel *model = contacts->model;
    const TinkerContactRow *rows = (const TinkerContactRow *)(const void *)contacts->rows->data;
    double *free_of_contacts = contacts->accelerations, *demand = contacts->demand;
    memcpy(free_of_contacts, a, (gsize)model->coordinates * sizeof(double));
    if (model->constraints.rows > 0) tinker_constraints_accelerate(model, free_of_contacts);
    for (guint i = 0; i < contacts->rows->len; i++) {
        const double *at = free_of_contacts + 2 * body_of(contacts, &rows[i]);
        const double *plate = acceleration_of(contacts, tinker_contacts_closed(contacts, (guint)rows[i].contact));
        demand[i] = -(rows[i].row[0] * (at[0] - plate[0]) + rows[i].row[1] * (at[1] - plate[1])) * rows[i].weight;
    }
    solve_forces(contacts);
    for (guint i = 0; i < contacts->rows->len; i++) {
        TinkerContact *contact = tinker_contacts_closed(contacts, (guint)rows[i].contact);
        double force = demand[i] * rows[i].weight, *at = a + 2 * contact->body;
        at[0] += rows[i].force[0] * force * model->inverse_mass[contact->body];
        at[1] += rows[i].force[1] * force * model->inverse_mass[contact->body];
        if (rows[i].tangential) {
            contact->friction = force;
        } else {
            contact->normal = force;
            contact->friction = force * tinker_contact_slip_share(&contacts->plates[contact->plate], contact->mode);
        }
    }
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
    contact->friction = tinker_contact_slip_share(plate, contact->mode) * contact->normal;
    const double slides = along + contact->friction / mass;
    at[0] = base[0] + ny * slides;
    at[1] = base[1] - nx * slides;
}

void tinker_contacts_accelerate(TinkerContacts *contacts, double *a)
{
    const int32_t *simple = (const int32_t *)(const void *)contacts->simple->data;
    contacts->evaluations++;
    for (guint i = 0; i < contacts->simple->len; i++)
        accelerate_alone(contacts, tinker_contacts_closed(contacts, (guint)simple[i]), a);
    if (contacts->rows->len > 0) accelerate_rows(contacts, a);
    if (contacts->model->constraints.rows > 0) tinker_constraints_accelerate(contacts->model, a);
}

void tinker_contacts_add_friction(const TinkerContacts *contacts, double *a)
{
    for (guint i = 0; contacts->any_slip_friction && i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        if (contact->mode == TINKER_CONTACT_STICK) continue;
        const double *n = contacts->plates[contact->plate].normal;
        double push = contact->friction * contacts->model->inverse_mass[contact->body];
        a[2 * contact->body] += n[1] * push;
        a[2 * contact->body + 1] -= n[0] * push;
    }
}

void tinker_contacts_add_power(TinkerContacts *contacts)
{
    TinkerModel *model = contacts->model;
    model->book_power[TINKER_BOOK_FRICTION] = 0;
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        const double nx = plate->normal[0], ny = plate->normal[1];
        const TinkerPoint *at = &model->point[contact->body], *base = &model->point[plate->point];
        if (contact->mode != TINKER_CONTACT_STICK)
            model->book_power[TINKER_BOOK_FRICTION] +=
                contact->friction * (ny * (at->vx - base->vx) - nx * (at->vy - base->vy));
        if (plate->moving)
            model->book_power[TINKER_BOOK_SUPPORT_MOTION] +=
                (contact->normal * nx + contact->friction * ny) * base->vx +
                (contact->normal * ny - contact->friction * nx) * base->vy;
    }
}

static void add_force(double *sums, double normal, double friction, double fx, double fy)
{
    sums[0] += normal;
    sums[1] += friction;
    sums[2] += fx;
    sums[3] += fy;
}

void tinker_contacts_sum_forces(const TinkerContacts *contacts, double *by_point)
{
    memset(by_point, 0, 4 * (gsize)contacts->model->points * sizeof(double));
    for (guint i = 0; i < contacts->closed->len; i++) {
        const TinkerContact *contact = tinker_contacts_closed(contacts, i);
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        const double nx = plate->normal[0], ny = plate->normal[1];
        double fx = contact->normal * nx + contact->friction * ny, fy = contact->normal * ny - contact->friction * nx;
        add_force(by_point + 4 * contact->body, contact->normal, contact->friction, fx, fy);
        add_force(by_point + 4 * plate->point, contact->normal, -contact->friction, -fx, -fy);
    }
}

int32_t tinker_contacts_row_body(const TinkerContacts *contacts, int32_t row)
{
    const TinkerConstraints *all = &contacts->model->constraints;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        if (all->points[e] < contacts->model->bodies) return all->points[e];
    return -1;
}

void tinker_contacts_pull(TinkerContacts *contacts, int32_t row, double lambda, double *v)
{
    TinkerModel *model = contacts->model;
    TinkerConstraints *all = &model->constraints;
    memset(all->by_point, 0, 2 * (gsize)model->points * sizeof(double));
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
        int32_t body = all->points[e];
        if (body >= model->bodies) continue;
        for (int k = 0; k < 2; k++) {
            double change = lambda * all->own_jacobian[2 * e + k] * model->inverse_mass[body];
            all->by_point[2 * body + k] += change;
            v[2 * body + k] += change;
        }
    }
    for (int32_t k = tinker_row_turns(all, row); k < tinker_row_turns(all, row + 1); k++) {
        const TinkerTurnEntry *of = &all->turns[k];
        double change = lambda * all->own_jacobian[2 * all->entries + k] * model->inverse_mass[all->points[of->entry]];
        all->by_point[of->coordinate] += change;
        v[of->coordinate] += change;
    }
    tinker_constraints_answer(contacts->model, v);
}
