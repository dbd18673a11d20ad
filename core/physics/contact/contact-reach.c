/* What contacts do to one another, by solves; see the header. */
#include "physics/contact/contact-reach.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/contact/contacts-private.h"

/* What meets in an entry: the push itself, and each multiplier on its body. */
static double size_of(const TinkerModel *model, const TinkerContactEquation *of, double push)
{
    const TinkerConstraints *all = &model->constraints;
    double sum = fabs(push);
    for (int32_t k = all->body_starts[of->body]; k < all->body_starts[of->body + 1]; k++) {
        const int32_t entry = all->body_entries[k];
        sum += fabs(all->lambda[all->row_of[entry]] *
                    (all->jacobian[2 * entry] * of->row[0] + all->jacobian[2 * entry + 1] * of->row[1]));
    }
    return sum * model->inverse_mass[of->body];
}

/* How all contacts move by what the elimination pushed last, with impulses p. */
static void read_motion(const TinkerContactReach *self, const double *p, double *v, double *size)
{
    const double *by_body = tinker_contact_elimination_pushed(self->elimination);
    for (int32_t i = 0; i < 2 * self->count; i++) {
        const TinkerContactEquation *of = &self->all[i];
        v[i] = of->row[0] * by_body[2 * of->body] + of->row[1] * by_body[2 * of->body + 1];
        if (size != NULL) size[i] = size_of(self->contacts->model, of, p[i]);
    }
}

static void times(void *context, const double *p, double *v, double *size)
{
    TinkerContactReach *self = context;
    const int32_t count = 2 * self->count;
    for (int32_t i = 0; i < count; i++) {
        const int32_t at = 2 * self->order[i / 2] + i % 2;
        self->equations[i] = self->all[at];
        self->x[i] = p[at];
    }
    tinker_contact_elimination_take(self->elimination, self->equations, count);
    tinker_contact_elimination_push(self->elimination, self->x, self->b);
    read_motion(self, p, v, size);
}

/* Takes the equations of what is unknown. */
static void take_unknown(TinkerContactReach *self, const int8_t *unknown, const double *slope)
{
    self->unknown = 0;
    for (int32_t i = 0; i < 2 * self->count; i++) {
        const int32_t k = self->order[i / 2], at = 2 * k + i % 2;
        if (!unknown[at]) continue;
        TinkerContactEquation *equation = &self->equations[self->unknown];
        *equation = self->all[at];
        if (i % 2 == 0 && !unknown[at + 1]) {
            equation->slope = slope[k];
            for (int d = 0; d < 2; d++)
                equation->force[d] += slope[k] * self->all[at + 1].row[d];
        }
        self->entry[self->unknown++] = at;
    }
    tinker_contact_elimination_take(self->elimination, self->equations, self->unknown);
}

static void put_found(const TinkerContactReach *self, double *p)
{
    memset(p, 0, 2 * (gsize)self->count * sizeof(double));
    for (int32_t e = 0; e < self->unknown; e++) {
        p[self->entry[e]] = self->x[e];
        if (self->equations[e].slope != 0) p[self->entry[e] + 1] = self->equations[e].slope * self->x[e];
    }
}

static int solve(void *context, const int8_t *unknown, const double *slope, const double *b, double *p, double *v,
                 double *size)
{
    TinkerContactReach *self = context;
    take_unknown(self, unknown, slope);
    for (int32_t e = 0; e < self->unknown; e++) {
        self->b[e] = b[self->entry[e]];
        self->x[e] = 0;
    }
    tinker_contact_elimination_solve(self->elimination, self->b, self->x);
    put_found(self, p);
    read_motion(self, p, v, size);
    return 1;
}

static void soften(void *context, const int8_t *unknown, const double *slope, double softness)
{
    TinkerContactReach *self = context;
    take_unknown(self, unknown, slope);
    tinker_contact_elimination_soften(self->elimination, softness);
}

static void solve_soft(void *context, const double *b, double *p)
{
    TinkerContactReach *self = context;
    for (int32_t e = 0; e < self->unknown; e++)
        self->b[e] = b[self->entry[e]];
    tinker_contact_elimination_solve_soft(self->elimination, self->b, self->x);
    put_found(self, p);
}

static int by_body(const void *left, const void *right, void *data)
{
    const TinkerContactEquation *all = data;
    const int32_t l = *(const int32_t *)left, r = *(const int32_t *)right;
    if (all[2 * l].body != all[2 * r].body) return all[2 * l].body < all[2 * r].body ? -1 : 1;
    return l < r ? -1 : l > r;
}

/* Sorting may allot, which steps must not: theirs are. */
static gboolean is_sorted(const TinkerContactReach *self)
{
    for (int32_t k = 1; k < self->count; k++)
        if (self->all[2 * k].body < self->all[2 * k - 2].body) return FALSE;
    return TRUE;
}

static gboolean make_room(TinkerContactReach *self, gsize count)
{
    if (count <= self->room) return TRUE;
    tinker_contact_reach_clear(self);
    const gsize room = 2 * count;
    self->all = g_try_new(TinkerContactEquation, 2 * room);
    self->equations = g_try_new(TinkerContactEquation, 2 * room);
    self->order = g_try_new(int32_t, room);
    self->entry = g_try_new(int32_t, 2 * room);
    self->mass = g_try_new(double, room);
    self->b = g_try_new(double, 2 * room);
    self->x = g_try_new(double, 2 * room);
    if (self->all == NULL || self->equations == NULL || self->order == NULL || self->entry == NULL ||
        self->mass == NULL || self->b == NULL || self->x == NULL)
        return FALSE;
    self->room = room;
    return TRUE;
}

/* The elimination goes along rods between points: what pins do to the turns of bodies is left to the matrix. */
static gboolean fits(const TinkerContactReach *self)
{
    if (self->contacts->model->constraints.turn_count > 0) return FALSE;
    const int32_t most = TINKER_MOST_EQUATIONS / 2;
    for (int32_t i = most; i < self->count; i++)
        if (self->all[2 * self->order[i]].body == self->all[2 * self->order[i - most]].body) return FALSE;
    return TRUE;
}

gboolean tinker_contact_reach_take(TinkerContactReach *self, TinkerContacts *contacts, const TinkerContact *touching,
                                   int32_t count)
{
    self->motion.context = NULL;
    if (!make_room(self, (gsize)count)) return FALSE;
    self->contacts = contacts;
    self->count = count;
    for (int32_t k = 0; k < count; k++) {
        const double *n = contacts->plates[touching[k].plate].normal;
        const int32_t body = touching[k].body;
        self->all[2 * k] = (TinkerContactEquation){body, {n[0], n[1]}, {n[0], n[1]}, 0};
        self->all[2 * k + 1] = (TinkerContactEquation){body, {n[1], -n[0]}, {n[1], -n[0]}, 0};
        self->mass[k] = contacts->model->mass[body];
        self->order[k] = k;
    }
    if (!is_sorted(self)) g_qsort_with_data(self->order, count, sizeof(int32_t), by_body, self->all);
    self->elimination = tinker_contacts_elimination(contacts, TRUE, touching[0].body);
    if (self->elimination == NULL) return FALSE;
    if (!fits(self)) return TRUE;
    if (!tinker_contact_elimination_make_room(self->elimination, 2 * (gsize)count)) return FALSE;
    self->motion = (TinkerContactMotion){self, times, solve, soften, solve_soft, self->mass};
    return TRUE;
}

void tinker_contact_reach_clear(TinkerContactReach *self)
{
    gpointer arrays[] = {self->all, self->equations, self->order, self->entry, self->mass, self->b, self->x};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    *self = (TinkerContactReach){.room = 0};
}
