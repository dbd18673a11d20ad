/* What pushes at contacts do to velocities, constraints answering to them. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts-private.h"
#include "physics/contact/contacts.h"
#include "physics/contact/tolerances.h"
#include "physics/model/model-data.h"
#include "physics/model/points.h"

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

/* Pushes along a row of entries, by so many N s. */
static void add_entry_push(TinkerContacts *contacts, const TinkerContactEntries *entries, double normal,
                           double tangential, double *v)
{
    const TinkerModel *model = contacts->model;
    double *by_point = model->constraints.by_point;
    for (int32_t k = 0; k < entries->count; k++) {
        const int32_t at = entries->coordinate[k], body = tinker_model_moved_by(model, at);
        const double change =
            (entries->row[0][k] * normal + entries->row[1][k] * tangential) * model->inverse_mass[body];
        v[at] += change;
        if (!contacts->held[body]) continue;
        if (!contacts->pushed) memset(by_point, 0, 2 * (gsize)model->points * sizeof(double));
        contacts->pushed = TRUE;
        by_point[at] += change;
    }
}

void tinker_contacts_push_along(TinkerContacts *contacts, const TinkerContact *contact, double normal,
                                double tangential, double *v)
{
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    const double *n = plate->normal;
    TinkerContactEntries entries;
    if (plate->gap == NULL) {
        tinker_contacts_add_push(contacts, contact->body, normal * n[0] + tangential * n[1],
                                 normal * n[1] - tangential * n[0], v);
        return;
    }
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    add_entry_push(contacts, &entries, normal, tangential, v);
}

void tinker_contacts_along(const TinkerContacts *contacts, const TinkerContact *contact, const double *by_coordinate,
                           double along[2])
{
    const TinkerPlate *plate = &contacts->plates[contact->plate];
    const double *n = plate->normal, *at = by_coordinate + 2 * contact->body;
    TinkerContactEntries entries;
    if (plate->gap == NULL) {
        along[0] = n[0] * at[0] + n[1] * at[1];
        along[1] = n[1] * at[0] - n[0] * at[1];
        return;
    }
    tinker_contact_gap_entries(contacts, contact->plate, &entries);
    for (int which = 0; which < 2; which++)
        along[which] = tinker_contact_times(&entries, which, by_coordinate);
}

double tinker_contact_row_times(const TinkerContacts *contacts, const TinkerContactRow *row,
                                const double *by_coordinate)
{
    const double *at = by_coordinate + 2 * tinker_contacts_closed(contacts, (guint)row->contact)->body;
    if (row->entries >= 0)
        return tinker_contact_times(tinker_contact_row_entries(contacts, row), row->tangential, by_coordinate);
    return row->row[0] * at[0] + row->row[1] * at[1];
}

void tinker_contact_row_push(TinkerContacts *contacts, const TinkerContactRow *row, double push, gboolean moves,
                             double *v)
{
    const double *direction = moves ? row->row : row->force;
    if (row->entries < 0)
        tinker_contacts_add_push(contacts, tinker_contacts_closed(contacts, (guint)row->contact)->body,
                                 push * direction[0], push * direction[1], v);
    else if (row->tangential)
        add_entry_push(contacts, tinker_contact_row_entries(contacts, row), 0, push, v);
    else
        add_entry_push(contacts, tinker_contact_row_entries(contacts, row), push, moves ? 0 : push * row->share, v);
    if (row->resisting >= 0 && !moves)
        add_entry_push(contacts, tinker_contact_row_resisting(contacts, row), 0, push * row->resisting_share, v);
}

void tinker_contacts_end_pushes(TinkerContacts *contacts, double *v)
{
    const TinkerConstraints *all = &contacts->model->constraints;
    if (contacts->pushed)
        tinker_constraints_answer(contacts->model, v);
    else if (contacts->pin_count > 0) /* pins ask what joints answered with: nothing, where no push reached them */
        memset(all->lambda, 0, (gsize)all->rows * sizeof(double));
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

int32_t tinker_contacts_row_body(const TinkerContacts *contacts, int32_t row)
{
    const TinkerConstraints *all = &contacts->model->constraints;
    for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
        if (all->points[e] < contacts->model->bodies) return all->points[e];
    return -1;
}

/* v += what the multiplier of a row does to its own bodies; other constraints have not answered yet. */
static void pull_own(TinkerContacts *contacts, int32_t row, double lambda, double *v)
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
}

void tinker_contacts_pull(TinkerContacts *contacts, int32_t row, double lambda, double *v)
{
    pull_own(contacts, row, lambda, v);
    tinker_constraints_answer(contacts->model, v);
}

gboolean tinker_contacts_row_is_held(TinkerContacts *contacts, int32_t row)
{
    TinkerModel *model = contacts->model;
    double *moves = contacts->column;
    memset(moves, 0, (gsize)model->coordinates * sizeof(double));
    pull_own(contacts, row, 1, moves);
    const double alone = fabs(tinker_constraints_own_row_times(model, row, moves));
    tinker_constraints_answer(model, moves);
    return fabs(tinker_constraints_own_row_times(model, row, moves)) <= TINKER_ROW_HELD * alone;
}
