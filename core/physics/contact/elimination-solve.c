/* The forces of contacts' equations, refined until they do what is asked of them. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/contact/elimination-private.h"
#include "physics/contact/tolerances.h"

#define MOST_SOLVES 60

/* With as little softness as will do; answers whether without any. What was soft once is tried without again. */
static gboolean factor_softly(TinkerContactElimination *self)
{
    if (tinker_elimination_factor(self, 0, 0)) return TRUE;
    if (!tinker_elimination_factor(self, TINKER_PROXIMAL_SHIFT, 0))
        tinker_elimination_factor(self, TINKER_PROXIMAL_SHIFT, TINKER_PROXIMAL_SHIFT);
    return FALSE;
}

/* The forces of a body's equations that make up for its misses, beside what the rows pull with mu. */
INLINE void move_body(const TinkerContactElimination *self, const EliminationBody *body, int32_t equations,
                      int32_t ends)
{
    const double *restrict j = self->model->constraints.jacobian, *restrict mu = self->mu;
    const TinkerContactEquation *restrict of = self->of + body->first;
    const EliminationEnd *end = self->ends + body->first_end;
    EliminationEquation *restrict equation = self->equation + body->first;
    double asked[TINKER_MOST_EQUATIONS], pull[2] = {0, 0};
    for (int32_t e = 0; e < ends; e++)
        for (int k = 0; k < 2; k++)
            pull[k] += j[2 * end[e].entry + k] * mu[end[e].row];
    for (int32_t a = 0; a < equations; a++)
        asked[a] = equation[a].miss / body->inverse_mass - dot(of[a].row, pull);
    for (int32_t a = 0; a < equations; a++) {
        double move = 0;
        for (int32_t k = 0; k < equations; k++)
            move += equation[a].inverse[k] * asked[k];
        equation[a].move = move;
    }
}

/* The moves that would make up for the misses, from mu of these. */
static void find_moves(TinkerContactElimination *self)
{
    self->solves++;
    for (int32_t i = 0; i < self->bodies; i++) {
        const EliminationBody *body = &self->body[i];
        if (body->count == 0) continue;
        if (body->end_count == 2 && body->count == 1)
            move_body(self, body, 1, 2);
        else if (body->end_count == 2 && body->count == 2)
            move_body(self, body, 2, 2);
        else
            move_body(self, body, body->count, body->end_count);
    }
}

static void begin_push(TinkerModel *model)
{
    memset(model->constraints.by_point, 0, 2 * (gsize)model->points * sizeof(double));
}

static void add_push(TinkerContactElimination *self, const double *x)
{
    const TinkerModel *model = self->model;
    double *by_point = model->constraints.by_point;
    self->solves++;
    for (int32_t e = 0; e < self->equations; e++) {
        const int32_t body = self->of[e].body;
        for (int k = 0; k < 2; k++)
            by_point[2 * body + k] += x[e] * self->of[e].force[k] * model->inverse_mass[body];
    }
}

/* What the pushes do to all bodies, and the constraints' answer. */
static void end_push(TinkerModel *model, double *by_body)
{
    memcpy(by_body, model->constraints.by_point, (gsize)model->coordinates * sizeof(double));
    tinker_constraints_answer(model, by_body);
}

/* What bodies did by a push, along its equations. */
static void look_along(const TinkerContactElimination *self, const double *by_body, double *along)
{
    for (int32_t e = 0; e < self->equations; e++)
        along[e] = dot(self->of[e].row, by_body + 2 * self->of[e].body);
}

void tinker_contact_elimination_push(TinkerContactElimination *self, const double *x, double *along)
{
    begin_push(self->model);
    add_push(self, x);
    end_push(self->model, self->by_body);
    look_along(self, self->by_body, along);
}

const double *tinker_contact_elimination_pushed(const TinkerContactElimination *self)
{
    return self->by_body;
}

/* What x still misses, by the last push; answers the largest beside what meets there. */
static double find_misses(TinkerContactElimination *self, const double *by_body)
{
    double most = 0, size = 0;
    look_along(self, by_body, self->along);
    for (int32_t e = 0; e < self->equations; e++) {
        const double miss = self->b[e] - self->along[e];
        const double meets = fabs(self->b[e]) + fabs(self->x[e]) * self->model->inverse_mass[self->of[e].body];
        self->equation[e].miss = miss;
        most = MAX(fabs(miss), most); /* which keeps what it was beside a NaN */
        size = MAX(meets, size);
    }
    return size > 0 ? most / size : 0;
}

/* Moves x by what makes up for the misses, unless these are rounding. */
static void move_on(TinkerContactElimination *self)
{
    self->before = self->miss;
    self->done = !(self->miss > TINKER_MISS_ROUNDING) || self->tries == MOST_SOLVES;
    if (self->done) return;
    if (self->tries++ > 0 || !self->full) tinker_elimination_solve_rows(self);
    find_moves(self);
    for (int32_t e = 0; e < self->equations; e++)
        self->x[e] += self->equation[e].move;
}

/* Looks what the last moves were good for: no further where they left more than half, back where they made it worse. */
static void judge(TinkerContactElimination *self, const double *by_body)
{
    self->miss = find_misses(self, by_body);
    if (self->tries == 0 || self->miss <= 0.5 * self->before) {
        move_on(self);
        return;
    }
    self->done = TRUE;
    if (self->miss <= self->before) return;
    for (int32_t e = 0; e < self->equations; e++)
        self->x[e] -= self->equation[e].move;
    self->went_back = TRUE;
}

void tinker_contact_elimination_begin(TinkerContactElimination *self, const double *b, double *x)
{
    self->b = b;
    self->x = x;
    for (int32_t e = 0; e < self->equations; e++)
        self->equation[e].miss = b[e];
    self->full = factor_softly(self);
    self->tries = 0;
    self->miss = 1;
    self->done = self->went_back = FALSE;
    if (!self->full) return; /* what x is near to has to be pushed first */
    /* what is determined does not depend on what it was */
    memset(x, 0, (gsize)self->equations * sizeof(double));
    move_on(self);
}

void tinker_contact_eliminations_end(TinkerContactElimination *const *all, guint count)
{
    guint left = count;
    while (left > 0) {
        begin_push(all[0]->model);
        for (guint i = 0; i < count; i++)
            if (!all[i]->done) add_push(all[i], all[i]->x);
        end_push(all[0]->model, all[0]->by_body);
        left = 0;
        for (guint i = 0; i < count; i++) {
            if (!all[i]->done) judge(all[i], all[0]->by_body);
            left += !all[i]->done;
        }
    }
}

gboolean tinker_contact_elimination_is_full(const TinkerContactElimination *self)
{
    return self->full;
}

gboolean tinker_contact_elimination_solve(TinkerContactElimination *self, const double *b, double *x)
{
    tinker_contact_elimination_begin(self, b, x);
    tinker_contact_eliminations_end(&self, 1);
    if (self->went_back) tinker_contact_elimination_push(self, x, self->along);
    return self->full;
}

void tinker_contact_elimination_soften(TinkerContactElimination *self, double softness)
{
    if (!tinker_elimination_factor(self, softness, 0)) tinker_elimination_factor(self, softness, TINKER_PROXIMAL_SHIFT);
}

void tinker_contact_elimination_solve_soft(TinkerContactElimination *self, const double *b, double *x)
{
    for (int32_t e = 0; e < self->equations; e++)
        self->equation[e].miss = b[e];
    tinker_elimination_solve_rows(self);
    find_moves(self);
    for (int32_t e = 0; e < self->equations; e++)
        x[e] = self->equation[e].move;
}
