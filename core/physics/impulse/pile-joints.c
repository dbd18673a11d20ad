/* Constraints on bodies of a pile. Contacts are solved for one by one, the rows of constraints all at once, exactly,
 * before each sweep along the contacts:
 *
 *     J v' = J v - h/2 drift,   drift = dJ/dt v:   J v of the motion's chord through the step, to second order,
 *
 * so that q + h v' misses the rows by the third order of h, which the projection after the step takes away, and nothing
 * that goes round gains or loses speed thereby (RATTLE with one Newton step). Where something strikes a group of
 * bodies, that goes on with J v' = J v: impulses at one place, with constraints that take no energy, and none that asks
 * for more than bodies which come to rest between two contacts could do. Source: H. C. Andersen, "Rattle: a velocity
 * version of the Shake algorithm", J. Comput. Phys. 52 (1983) 24-34. */
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts.h"
#include "physics/impulse/impulse-private.h"
#include "physics/impulse/pile.h"
#include "physics/model/points.h"

/* Whether bodies of the pile are on a row. */
static gboolean row_is_of(const TinkerPile *pile, int32_t row)
{
    const int32_t body = tinker_contacts_row_body(pile->contacts, row);
    return body >= 0 && tinker_pile_has(pile, body);
}

TinkerPileJoints *tinker_pile_joints_new(const TinkerPile *pile)
{
    const TinkerConstraints *all = &pile->model->constraints;
    const gsize rows = (gsize)all->rows;
    gboolean any = FALSE;
    for (int32_t row = 0; row < all->rows; row++)
        any |= row_is_of(pile, row);
    if (!any) return NULL;
    TinkerPileJoints *joints = g_new0(TinkerPileJoints, 1);
    joints->has = g_new0(gboolean, rows);
    for (int32_t row = 0; row < all->rows; row++)
        joints->has[row] = row_is_of(pile, row);
    joints->before = g_new0(double, rows);
    joints->wanted = g_new0(double, rows);
    joints->asked = g_new0(double, rows);
    joints->v = g_new0(double, 2 * (gsize)pile->model->points);
    joints->struck = g_new0(gboolean, (gsize)pile->model->bodies);
    return joints;
}

void tinker_pile_joints_free(TinkerPileJoints *joints)
{
    if (joints == NULL) return;
    gpointer arrays[] = {joints->has, joints->before, joints->wanted, joints->asked, joints->v, joints->struck};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(joints);
}

/* Velocities of bodies by coordinate; `stride` numbers lie between those of two shapes. */
static void gather(const TinkerPile *pile, const double *of_shapes, gsize stride)
{
    double *v = pile->joints->v;
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i], turn = tinker_model_turn_of(pile->model, body);
        const double *from = of_shapes + stride * (gsize)body;
        v[2 * body] = from[0];
        v[2 * body + 1] = from[1];
        if (turn >= 0) v[turn] = from[2];
    }
}

static void scatter(TinkerPile *pile)
{
    const double *v = pile->joints->v;
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i], turn = tinker_model_turn_of(pile->model, body);
        double *to = pile->bodies[body].v;
        to[0] = v[2 * body];
        to[1] = v[2 * body + 1];
        if (turn >= 0) to[2] = v[turn];
    }
}

/* W: what supports that move and prescribed rows give through the rows now, with the multipliers solved last. */
static double power_given(const TinkerPile *pile)
{
    const TinkerConstraints *all = &pile->model->constraints;
    double sum = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        if (!pile->joints->has[row]) continue;
        if (all->prescribed) sum -= all->lambda[row] * all->rate[row];
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++) {
            if (all->points[e] < pile->model->bodies) continue;
            const TinkerPoint *at = &pile->model->point[all->points[e]];
            sum -= all->lambda[row] * (all->jacobian[2 * e] * at->vx + all->jacobian[2 * e + 1] * at->vy);
        }
    }
    return sum;
}

void tinker_pile_joints_begin(TinkerPile *pile, double h)
{
    TinkerPileJoints *joints = pile->joints;
    const TinkerConstraints *all = &pile->model->constraints;
    joints->power = power_given(pile);
    gather(pile, pile->before, 3);
    tinker_constraints_rows_times(all, joints->v, joints->before);
    for (int32_t row = 0; row < all->rows; row++)
        joints->wanted[row] = joints->before[row] - 0.5 * h * all->drift[row];
    tinker_pile_joints_solve(pile);
}

/* NULL: rest. */
static void bring(TinkerPile *pile, const double *wanted)
{
    TinkerPileJoints *joints = pile->joints;
    const TinkerConstraints *all = &pile->model->constraints;
    gather(pile, pile->bodies[0].v, sizeof(TinkerPileBody) / sizeof(double));
    tinker_constraints_rows_times(all, joints->v, joints->asked);
    for (int32_t row = 0; row < all->rows; row++)
        joints->asked[row] = joints->has[row] ? (wanted != NULL ? wanted[row] : 0) - joints->asked[row] : 0;
    tinker_constraints_change_speeds(pile->model, joints->asked, joints->v);
    scatter(pile);
}

void tinker_pile_joints_solve(TinkerPile *pile)
{
    bring(pile, pile->joints->wanted);
}

void tinker_pile_joints_answer(TinkerPile *pile)
{
    bring(pile, NULL);
}

void tinker_pile_joints_strike(TinkerPile *pile)
{
    TinkerPileJoints *joints = pile->joints;
    const int32_t *group = pile->contacts->group;
    memset(joints->struck, 0, (gsize)pile->model->bodies * sizeof(gboolean));
    for (int32_t i = 0; i < pile->touch_count; i++) {
        const TinkerPileTouch *touch = &pile->touches[i];
        for (int32_t k = 0; k < touch->count; k++)
            for (int side = 0; pile->marks[touch->first + k].strikes && side < 2; side++)
                if (touch->body[side] < pile->model->bodies) joints->struck[group[touch->body[side]]] = TRUE;
    }
    for (int32_t row = 0; row < pile->model->constraints.rows; row++)
        if (joints->has[row] && joints->struck[group[tinker_contacts_row_body(pile->contacts, row)]])
            joints->wanted[row] = joints->before[row];
    tinker_pile_joints_solve(pile);
}

void tinker_pile_joints_hold(TinkerPile *pile)
{
    memset(pile->joints->wanted, 0, (gsize)pile->model->constraints.rows * sizeof(double));
}

double tinker_pile_joints_give(const TinkerImpulses *self)
{
    const TinkerPile *pile = self->pile;
    const TinkerModel *model = self->model;
    double sum = 0;
    for (int32_t i = 0; i < pile->solved_count; i++) {
        const int32_t body = pile->solved[i], turn = tinker_model_turn_of(model, body);
        for (int k = 0; k < (turn < 0 ? 2 : 3); k++) {
            const int32_t c = k < 2 ? 2 * body + k : turn;
            const double was = pile->before[3 * body + k], is = pile->bodies[body].v[k], mass = model->mass[body];
            const double force = model->force[c] + mass * model->constant_acceleration[c];
            sum += 0.5 * (mass * (is - was) - self->h * force) * (is + was);
        }
    }
    return sum;
}
