/* Bringing a state back onto closed contacts and constraints. A body that stands alone is set onto its plate, and one
 * that sticks onto its anchor, to the last bit; the others move along their rows, as little as their masses allow,
 * until neither a contact nor a constraint is missed. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "physics/constraint/constraints.h"
#include "physics/contact/contacts-private.h"
#include "physics/contact/contacts.h"
#include "physics/force/forces.h"
#include "physics/model/model-data.h"
#include "physics/model/state.h"

#define MOST_STEPS 25

/* How far (m) off a place may be and still be rounding. */
static double rounding_of(const TinkerContacts *contacts, const TinkerContact *contact)
{
    const TinkerPoint *at = &contacts->model->point[contact->body];
    const TinkerPoint *base = &contacts->model->point[contacts->plates[contact->plate].point];
    double places = fabs(at->x) + fabs(at->y) + fabs(base->x) + fabs(base->y);
    if (tinker_contacts_resists(contacts, contact))
        places += fabs(contact->anchor) + contacts->plates[contact->plate].arm;
    if (tinker_contacts_is_gap(contacts, contact)) return 4 * DBL_EPSILON * (places + contacts->thickness);
    return 4 * DBL_EPSILON *
           (places + contacts->half_height[contact->body] + contacts->plates[contact->plate].half_height);
}

static void set_state(TinkerContacts *contacts, const double *q, const double *v)
{
    tinker_model_set_state(contacts->model, q, v);
    tinker_contacts_refresh_entries(contacts);
}

/* Adds a move by dn along the normal and dt along the top. */
static void shift(const TinkerPlate *plate, double dn, double dt, double x[2])
{
    const double *n = plate->normal;
    x[0] += dn * n[0] + dt * n[1];
    x[1] += dn * n[1] - dt * n[0];
}

/* What the applied forces that were evaluated last do along the moves of bodies from `first` to `end` - 1 (`moves`
 * begins with the first's); booked as the rods' own moves are. */
static double work_of_moves(const TinkerModel *model, int32_t first, int32_t end, const double *moves)
{
    double work = 0;
    for (int32_t i = 2 * first; i < 2 * end; i++)
        work += (model->force[i] + model->coordinate_mass[i] * model->constant_acceleration[i]) * moves[i - 2 * first];
    return work;
}

/* Of the moves of turns; constant accelerations have no part in them. */
static double work_of_turns(const TinkerModel *model, const double *moves)
{
    double work = 0;
    for (int32_t i = 2 * model->bodies; i < model->coordinates; i++)
        work += model->force[i] * moves[i];
    return work;
}

/* Places bodies that stand alone. `rate`: v gets the move times this as well (0: it does not). */
static gboolean place_alone(TinkerContacts *contacts, double *q, double *v, double rate, double *work)
{
    gboolean moved = FALSE;
    for (guint i = 0; i < contacts->simple->len; i++) {
        const TinkerContact *contact =
            tinker_contacts_closed(contacts, (guint)g_array_index(contacts->simple, int32_t, i));
        TinkerContactPlace place = tinker_contact_place(contacts, contact->body, contact->plate);
        double dn = -place.gap, dt = contact->mode == TINKER_CONTACT_STICK ? contact->anchor - place.along : 0.0;
        if (fmax(fabs(dn), fabs(dt)) <= rounding_of(contacts, contact)) continue;
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        double move[2] = {0, 0};
        shift(plate, dn, dt, move);
        *work -= work_of_moves(contacts->model, contact->body, contact->body + 1, move);
        shift(plate, dn, dt, q + 2 * contact->body);
        if (rate != 0) shift(plate, dn * rate, dt * rate, v + 2 * contact->body);
        moved = TRUE;
    }
    return moved;
}

/* Writes how far the rows are off into the demand; answers the largest share of rounding. */
static double measure_rows(TinkerContacts *contacts)
{
    double most = 0;
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
        TinkerContactPlace place = tinker_contact_place(contacts, contact->body, contact->plate);
        double miss = row->tangential ? tinker_contact_creep(&place, contact->anchor) : place.gap;
        if (row->pin_slope != 0) miss = 0;
        most = fmax(most, fabs(miss) / rounding_of(contacts, contact));
        contacts->demand[i] = -miss * row->weight;
    }
    return most;
}

/* Solves for the demand, and adds what the rows' pushes do to all bodies to x. */
static void push_rows(TinkerContacts *contacts, double *x)
{
    tinker_contacts_solve_moves(contacts);
    tinker_contacts_begin_pushes(contacts);
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        tinker_contact_row_push(contacts, row, contacts->demand[i] * row->weight, TRUE, x);
    }
    tinker_contacts_end_pushes(contacts, x);
}

/* Moves the bodies of rows once; FALSE where nothing is to be gained any more. */
static gboolean move_rows(TinkerContacts *contacts, double *q, double *v, double rate, double *before, double *work)
{
    double miss = measure_rows(contacts), *moves = contacts->before;
    if (miss <= 1 || !(miss < 0.5 * *before)) return FALSE;
    *before = miss;
    int32_t n = contacts->model->coordinates;
    memset(moves, 0, (gsize)n * sizeof(double));
    push_rows(contacts, moves);
    *work -= work_of_moves(contacts->model, 0, contacts->model->bodies, moves) + work_of_turns(contacts->model, moves);
    for (int32_t i = 0; i < n; i++) {
        q[i] += moves[i];
        if (rate != 0) v[i] += rate * moves[i];
    }
    return TRUE;
}

TinkerStatus tinker_contacts_project_positions(TinkerContacts *contacts, double t, double *q, const double *v,
                                               gboolean *moved, double *work)
{
    TinkerModel *model = contacts->model;
    double before = INFINITY;
    *moved = FALSE;
    *work = 0;
    TinkerStatus status = tinker_model_set_time(model, t);
    if (status != TINKER_OK) return status;
    set_state(contacts, q, v);
    *moved = place_alone(contacts, q, NULL, 0, work);
    for (int step = 0; step < MOST_STEPS; step++) {
        gboolean by_constraints = FALSE;
        if (model->constraints.rows > 0) {
            status = tinker_constraints_project_positions(model, t, q, v, &by_constraints);
            if (status != TINKER_OK) return status;
            *work += model->constraints.work;
            *moved |= by_constraints;
        }
        set_state(contacts, q, v);
        if (contacts->rows->len == 0 || !move_rows(contacts, q, NULL, 0, &before, work)) break;
        *moved = TRUE;
    }
    return TINKER_OK;
}

/* Contacts answer along the directions that they have at the start of the step, as constraints do: that is what makes
 * the method symmetric. Of tops that keep their direction there is but one. */
static TinkerStatus keep_directions(TinkerContacts *contacts, double t_from, const double *q_from, const double *v)
{
    if (contacts->entries->len == 0) return TINKER_OK;
    const TinkerStatus status = tinker_model_set_time(contacts->model, t_from);
    if (status == TINKER_OK) set_state(contacts, q_from, v);
    return status;
}

TinkerStatus tinker_contacts_rattle(TinkerContacts *contacts, double t_from, const double *q_from, double t, double h,
                                    double *q, double *v)
{
    TinkerModel *model = contacts->model;
    double before = INFINITY, work = 0;
    TinkerStatus status = keep_directions(contacts, t_from, q_from, v);
    for (int step = 0; status == TINKER_OK && step < MOST_STEPS; step++) {
        if (model->constraints.rows > 0) status = tinker_constraints_rattle(model, t_from, q_from, t, h, q, v);
        if (status == TINKER_OK) status = tinker_model_set_time(model, t);
        if (status != TINKER_OK) return status;
        tinker_model_set_state(model, q, v);
        if (step == 0) place_alone(contacts, q, v, 1 / h, &work);
        if (contacts->rows->len == 0) break;
        if (model->constraints.rows > 0)
            memcpy(model->constraints.jacobian, model->constraints.turned,
                   model->constraints.jacobian_size * sizeof(double));
        if (!move_rows(contacts, q, v, 1 / h, &before, &work)) break;
    }
    return status;
}

/* Velocities ------------------------------------------------------------------------------------------------------- */

static const TinkerPoint still;

static void correct_alone(TinkerContacts *contacts, double *v, gboolean homogeneous)
{
    for (guint i = 0; i < contacts->simple->len; i++) {
        const TinkerContact *contact =
            tinker_contacts_closed(contacts, (guint)g_array_index(contacts->simple, int32_t, i));
        const TinkerPlate *plate = &contacts->plates[contact->plate];
        const TinkerPoint *base = homogeneous ? &still : &contacts->model->point[plate->point];
        double *at = v + 2 * contact->body;
        double along = plate->normal[1] * (at[0] - base->vx) - plate->normal[0] * (at[1] - base->vy);
        if (contact->mode == TINKER_CONTACT_STICK) along = 0;
        at[0] = base->vx + along * plate->normal[1];
        at[1] = base->vy - along * plate->normal[0];
    }
}

static void correct_rows(TinkerContacts *contacts, double *v, gboolean homogeneous)
{
    for (guint i = 0; i < contacts->rows->len; i++) {
        const TinkerContactRow *row = &g_array_index(contacts->rows, TinkerContactRow, i);
        const TinkerContact *contact = tinker_contacts_closed(contacts, (guint)row->contact);
        if (row->entries >= 0) {
            const TinkerContactEntries *entries =
                &g_array_index(contacts->entries, TinkerContactEntries, (guint)row->entries);
            const double moved = homogeneous ? 0 : entries->of_supports[row->tangential];
            contacts->demand[i] = -(tinker_contact_row_times(contacts, row, v) + moved) * row->weight;
            if (row->pin_slope != 0) contacts->demand[i] = 0;
            continue;
        }
        const TinkerPoint *base =
            homogeneous ? &still : &contacts->model->point[contacts->plates[contact->plate].point];
        const double *at = v + 2 * contact->body;
        contacts->demand[i] = -(row->row[0] * (at[0] - base->vx) + row->row[1] * (at[1] - base->vy)) * row->weight;
    }
    push_rows(contacts, v);
}

double tinker_contacts_correct_velocities(TinkerContacts *contacts, double *v, gboolean homogeneous, gboolean *moved)
{
    TinkerModel *model = contacts->model;
    double *before = contacts->before, most = 0;
    gsize n = (gsize)model->coordinates;
    memcpy(before, v, n * sizeof(double));
    tinker_contacts_refresh_entries(contacts);
    correct_alone(contacts, v, homogeneous);
    if (model->constraints.rows > 0) {
        tinker_model_set_velocities(model, v);
        tinker_constraints_correct_velocities(model, v, homogeneous, moved);
    }
    if (contacts->rows->len > 0) correct_rows(contacts, v, homogeneous);
    for (gsize i = 0; i < n; i++)
        most = fmax(most, fabs(v[i] - before[i]));
    *moved = most > 2 * DBL_EPSILON * tinker_largest((int32_t)n, v);
    return tinker_model_kinetic_change(model, before, v);
}
