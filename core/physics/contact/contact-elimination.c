/* Contacts eliminated from constraint rows; see the header. */
#include "physics/contact/contact-elimination.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/pivoted-solve.h"
#include "numerics/solve/rank.h"
#include "numerics/solve/sparse-ldu.h"
#include "physics/constraint/constraints.h"
#include "physics/constraint/tolerances.h"
#include "physics/contact/tolerances.h"

#define MOST_SOLVES 60

/* For loops whose counts are constants where they are called. */
#define INLINE __attribute__((always_inline)) static inline

/* One end of a row on a body of the group. */
typedef struct {
    int32_t row, entry; /* in the group; in the Jacobian */
} End;

typedef struct {
    int32_t body;
    double inverse_mass;
    int32_t first_end, end_count;
    int32_t first_product; /* of end_count x end_count */
    int32_t first, count;  /* equations */
} Body;

typedef struct {
    double inverse[TINKER_MOST_EQUATIONS]; /* its row of A^-1 */
    double miss, move;                     /* what is still asked for; the force that does so */
} Equation;

struct _TinkerContactElimination {
    TinkerModel *model;
    int32_t bodies, rows, equations;
    gsize room; /* for equations */
    const TinkerContactEquation *of;
    Body *body; /* in the order of the model */
    End *ends;
    int *slots; /* of products */
    TinkerSparseLdu *ldu;
    double *least, *mu; /* by row */
    int *diagonal;
    Equation *equation;
    double *along;   /* by equation */
    double *by_body; /* by coordinate of the model; borrowed */
    gint64 solves;

    /* a solve in progress */
    const double *b;
    double *x;
    double miss, before; /* largest miss of x, and what it was before the last moves */
    int tries;
    gboolean full, done;
    gboolean went_back; /* the last push was not of x */
};

static gboolean is_of_group(const TinkerModel *model, const int32_t *group, int32_t first, int32_t point)
{
    return point < model->bodies && group[point] == group[first];
}

/* Numbers the rows of the group; -1: of another. Answers how many. */
static int32_t number_rows(const TinkerModel *model, const int32_t *group, int32_t first, int32_t *number)
{
    const TinkerConstraints *all = &model->constraints;
    int32_t count = 0;
    for (int32_t row = 0; row < all->rows; row++) {
        gboolean own = FALSE;
        for (int32_t e = all->row_starts[row]; e < all->row_starts[row + 1]; e++)
            own |= is_of_group(model, group, first, all->points[e]);
        number[row] = own ? count++ : -1;
    }
    return count;
}

static gboolean allot(TinkerContactElimination *self, gsize ends, gsize products)
{
    self->body = g_try_new0(Body, MAX(self->bodies, 1));
    self->ends = g_try_new0(End, MAX(ends, 1));
    self->slots = g_try_new0(int, MAX(products, 1));
    self->least = g_try_new0(double, MAX(self->rows, 1));
    self->mu = g_try_new0(double, MAX(self->rows, 1));
    self->diagonal = g_try_new0(int, MAX(self->rows, 1));
    return self->body != NULL && self->ends != NULL && self->slots != NULL && self->least != NULL && self->mu != NULL &&
           self->diagonal != NULL;
}

/* Lists bodies with the ends of rows on them. */
static void list_bodies(TinkerContactElimination *self, const int32_t *group, int32_t first, const int32_t *number)
{
    const TinkerConstraints *all = &self->model->constraints;
    int32_t bodies = 0, ends = 0, products = 0;
    for (int32_t i = 0; i < self->model->bodies; i++) {
        if (!is_of_group(self->model, group, first, i)) continue;
        Body *body = &self->body[bodies++];
        *body = (Body){.body = i, .inverse_mass = self->model->inverse_mass[i], .first_end = ends};
        body->first_product = products;
        for (int32_t k = all->body_starts[i]; k < all->body_starts[i + 1]; k++) {
            const int32_t entry = all->body_entries[k];
            self->ends[ends++] = (End){number[all->row_of[entry]], entry};
        }
        body->end_count = ends - body->first_end;
        products += body->end_count * body->end_count;
    }
}

/* The pattern, and where every product goes. FALSE: no memory. */
static gboolean find_slots(TinkerContactElimination *self, gsize products)
{
    g_autofree int *rows = g_try_new(int, MAX(products, 1)), *columns = g_try_new(int, MAX(products, 1));
    gsize count = 0;
    if (rows == NULL || columns == NULL) return FALSE;
    for (int pass = 0; pass < 2; pass++) {
        count = 0;
        for (int32_t i = 0; i < self->bodies; i++) {
            const End *ends = self->ends + self->body[i].first_end;
            const int32_t n = self->body[i].end_count;
            for (int32_t k = 0; k < n * n; k++) {
                const int row = ends[k / n].row, column = ends[k % n].row;
                if (pass == 1)
                    self->slots[self->body[i].first_product + k] = tinker_sparse_ldu_slot(self->ldu, row, column);
                if (row == column) continue;
                rows[count] = row;
                columns[count++] = column;
            }
        }
        if (pass == 0) self->ldu = tinker_sparse_ldu_new(self->rows, rows, columns, count);
        if (self->ldu == NULL) return FALSE;
    }
    for (int32_t row = 0; row < self->rows; row++)
        self->diagonal[row] = tinker_sparse_ldu_slot(self->ldu, row, row);
    return TRUE;
}

TinkerContactElimination *tinker_contact_elimination_new(TinkerModel *model, const int32_t *group, int32_t first,
                                                         double *by_body)
{
    const TinkerConstraints *all = &model->constraints;
    g_autofree int32_t *number = g_try_new0(int32_t, MAX(all->rows, 1));
    if (number == NULL) return NULL;
    TinkerContactElimination *self = g_new0(TinkerContactElimination, 1);
    gsize ends = 0, products = 0;
    self->model = model;
    self->by_body = by_body;
    self->rows = number_rows(model, group, first, number);
    for (int32_t i = 0; i < model->bodies; i++) {
        if (!is_of_group(model, group, first, i)) continue;
        const gsize count = (gsize)(all->body_starts[i + 1] - all->body_starts[i]);
        self->bodies++;
        ends += count;
        products += count * count;
    }
    gboolean done = products <= G_MAXINT32 && allot(self, ends, products);
    if (done) list_bodies(self, group, first, number);
    if (!done || !find_slots(self, products)) g_clear_pointer(&self, tinker_contact_elimination_free);
    return self;
}

void tinker_contact_elimination_free(TinkerContactElimination *self)
{
    if (self == NULL) return;
    tinker_sparse_ldu_free(self->ldu);
    gpointer arrays[] = {self->body,  self->ends,     self->slots,    self->mu,
                         self->least, self->diagonal, self->equation, self->along};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
    g_free(self);
}

gsize tinker_contact_elimination_fill(const TinkerContactElimination *self)
{
    return 2 * tinker_sparse_ldu_fill(self->ldu);
}

gint64 tinker_contact_elimination_solves(const TinkerContactElimination *self)
{
    return self->solves;
}

gboolean tinker_contact_elimination_make_room(TinkerContactElimination *self, gsize count)
{
    if (count <= self->room) return TRUE;
    g_free(self->equation);
    g_free(self->along);
    self->room = 2 * count;
    self->equation = g_try_new0(Equation, self->room);
    self->along = g_try_new(double, self->room);
    if (self->equation == NULL || self->along == NULL) self->room = 0;
    return self->room > 0;
}

void tinker_contact_elimination_take(TinkerContactElimination *self, const TinkerContactEquation *equations,
                                     int32_t count)
{
    Body *body = self->body, *const end = body + self->bodies;
    for (int32_t k = 0; k < count; body++) {
        const int32_t of = equations[k].body, first = k;
        while (body < end && body->body != of)
            (body++)->count = 0;
        g_assert(body < end);
        while (k < count && equations[k].body == of)
            k++;
        body->first = first;
        body->count = k - first;
    }
    for (; body < end; body++)
        body->count = 0;
    self->of = equations;
    self->equations = count;
}

/* The factor ------------------------------------------------------------------------------------------------------- */

static inline double dot(const double a[2], const double b[2])
{
    return a[0] * b[0] + a[1] * b[1];
}

/* A^-1 of several equations on one body, column by column; FALSE where they depend on one another. */
static gboolean invert(const TinkerContactEquation *of, Equation *equation, int32_t count, double softness)
{
    for (int32_t column = 0; column < count; column++) {
        double matrix[TINKER_MOST_EQUATIONS * TINKER_MOST_EQUATIONS], x[TINKER_MOST_EQUATIONS] = {0};
        int32_t order[TINKER_MOST_EQUATIONS];
        for (int32_t i = 0; i < count; i++)
            for (int32_t j = 0; j < count; j++)
                matrix[i * count + j] = dot(of[i].row, of[j].force) + (i == j ? softness : 0);
        x[column] = 1;
        if (tinker_pivoted_solve(count, matrix, x, order, TINKER_DEPENDENT) < count) return FALSE;
        for (int32_t i = 0; i < count; i++)
            equation[i].inverse[column] = x[i];
    }
    return TRUE;
}

/* A matrix of two equations, as nearly all have, is inverted in closed form. */
static gboolean invert_two(const TinkerContactEquation *of, Equation *equation, double softness)
{
    const double a = dot(of[0].row, of[0].force) + softness, b = dot(of[0].row, of[1].force);
    const double c = dot(of[1].row, of[0].force), d = dot(of[1].row, of[1].force) + softness;
    const double determinant = a * d - b * c, size = fabs(a * d) + fabs(b * c);
    if (!(fabs(determinant) > TINKER_DEPENDENT * size)) return FALSE;
    equation[0].inverse[0] = d / determinant;
    equation[0].inverse[1] = -b / determinant;
    equation[1].inverse[0] = -c / determinant;
    equation[1].inverse[1] = a / determinant;
    return TRUE;
}

/* What is left of the mobility of a body that equations act on. FALSE where they depend on one another. */
static gboolean find_mobility(const TinkerContactElimination *self, const Body *body, double softness,
                              double mobility[2][2])
{
    const TinkerContactEquation *of = self->of + body->first;
    Equation *equation = self->equation + body->first;
    double left[2][2] = {{1, 0}, {0, 1}};
    if (body->count == 1)
        equation->inverse[0] = 1 / (dot(of->row, of->force) + softness);
    else if (!(body->count == 2 ? invert_two(of, equation, softness) : invert(of, equation, body->count, softness)))
        return FALSE;
    for (int32_t a = 0; a < body->count; a++)
        for (int32_t b = 0; b < body->count; b++)
            for (int k = 0; k < 4; k++)
                left[k / 2][k % 2] -= of[a].force[k / 2] * equation[a].inverse[b] * of[b].row[k % 2];
    for (int k = 0; k < 4; k++)
        mobility[k / 2][k % 2] = left[k / 2][k % 2] * body->inverse_mass;
    return TRUE;
}

/* Adds up S with what is left of a body's mobility, and in `least` what its diagonal is without contacts. */
INLINE void add_body(const TinkerContactElimination *self, const Body *body, int32_t count, double mobility[2][2],
                     double *restrict values, double *restrict least)
{
    const double *restrict j = self->model->constraints.jacobian;
    const End *ends = self->ends + body->first_end;
    const int *slot = self->slots + body->first_product;
    for (int32_t b = 0; b < count; b++) {
        const double *at = j + 2 * ends[b].entry;
        const double moved[2] = {dot(mobility[0], at), dot(mobility[1], at)};
        least[ends[b].row] += body->inverse_mass * dot(at, at);
        for (int32_t a = 0; a < count; a++)
            values[slot[a * count + b]] += dot(j + 2 * ends[a].entry, moved);
    }
}

/* The entries of a body that no contact's equation acts on: its mobility is 1 / mass. */
INLINE void add_free_body(const TinkerContactElimination *self, const Body *body, int32_t count,
                          double *restrict values, double *restrict least)
{
    const double *restrict j = self->model->constraints.jacobian;
    const End *ends = self->ends + body->first_end;
    const int *slot = self->slots + body->first_product;
    for (int32_t b = 0; b < count; b++) {
        const double *at = j + 2 * ends[b].entry, own = body->inverse_mass * dot(at, at);
        least[ends[b].row] += own;
        values[slot[b * count + b]] += own;
        for (int32_t a = 0; a < b; a++) {
            const double product = body->inverse_mass * dot(j + 2 * ends[a].entry, at);
            values[slot[a * count + b]] += product;
            values[slot[b * count + a]] += product;
        }
    }
}

/* Adds to mu what is asked of the rows on a body: what it would do by its equations, but for the constraints. */
INLINE void demand_of_body(const TinkerContactElimination *self, const Body *body, int32_t equations, int32_t ends,
                           double *restrict mu)
{
    const double *restrict j = self->model->constraints.jacobian;
    const Equation *restrict equation = self->equation + body->first;
    const TinkerContactEquation *restrict of = self->of + body->first;
    const End *end = self->ends + body->first_end;
    double pushed[2] = {0, 0};
    for (int32_t a = 0; a < equations; a++) {
        double sum = 0;
        for (int32_t k = 0; k < equations; k++)
            sum += equation[a].inverse[k] * equation[k].miss;
        pushed[0] += of[a].force[0] * sum;
        pushed[1] += of[a].force[1] * sum;
    }
    for (int32_t e = 0; e < ends; e++)
        mu[end[e].row] -= dot(j + 2 * end[e].entry, pushed);
}

/* Sums S, and what the misses ask of the rows. Nearly all bodies have two ends of rods and one or two equations, for
 * which the loops are unrolled. FALSE where equations of one body depend on one another. */
static gboolean assemble(TinkerContactElimination *self, double softness)
{
    double *restrict values = tinker_sparse_ldu_values(self->ldu), *restrict least = self->least,
                     *restrict mu = self->mu;
    tinker_sparse_ldu_clear(self->ldu);
    memset(least, 0, (gsize)self->rows * sizeof(double));
    memset(mu, 0, (gsize)self->rows * sizeof(double));
    for (int32_t i = 0; i < self->bodies; i++) {
        const Body *body = &self->body[i];
        const gboolean pair = body->end_count == 2;
        double mobility[2][2];
        if (body->count == 0) {
            if (pair)
                add_free_body(self, body, 2, values, least);
            else
                add_free_body(self, body, body->end_count, values, least);
            continue;
        }
        if (!find_mobility(self, body, softness, mobility)) return FALSE;
        if (pair)
            add_body(self, body, 2, mobility, values, least);
        else
            add_body(self, body, body->end_count, mobility, values, least);
        if (pair && body->count == 1)
            demand_of_body(self, body, 1, 2, mu);
        else if (pair && body->count == 2)
            demand_of_body(self, body, 2, 2, mu);
        else
            demand_of_body(self, body, body->count, body->end_count, mu);
    }
    return TRUE;
}

/* And solves for mu of the misses by the way, which costs next to nothing more. */
static gboolean factor(TinkerContactElimination *self, double softness, double row_softness)
{
    double *values = tinker_sparse_ldu_values(self->ldu);
    self->solves++;
    if (!assemble(self, softness)) return FALSE;
    for (int32_t row = 0; row < self->rows; row++) {
        /* a row that no body feels, or a slack one, has no multiplier */
        if (self->least[row] == 0) values[self->diagonal[row]] = 1;
        values[self->diagonal[row]] += row_softness * self->least[row];
        self->least[row] *= TINKER_DEPENDENT;
    }
    return tinker_sparse_ldu_factor_and_solve(self->ldu, self->least, self->mu);
}

/* With as little softness as will do; answers whether without any. What was soft once is tried without again. */
static gboolean factor_softly(TinkerContactElimination *self)
{
    if (factor(self, 0, 0)) return TRUE;
    if (!factor(self, TINKER_PROXIMAL_SHIFT, 0)) factor(self, TINKER_PROXIMAL_SHIFT, TINKER_PROXIMAL_SHIFT);
    return FALSE;
}

/* Solving ---------------------------------------------------------------------------------------------------------- */

/* mu of the misses, with the last factor. */
static void solve_rows(TinkerContactElimination *self)
{
    memset(self->mu, 0, (gsize)self->rows * sizeof(double));
    for (int32_t i = 0; i < self->bodies; i++)
        if (self->body[i].count > 0)
            demand_of_body(self, &self->body[i], self->body[i].count, self->body[i].end_count, self->mu);
    tinker_sparse_ldu_solve(self->ldu, self->mu);
}

/* The forces of a body's equations that make up for its misses, beside what the rows pull with mu. */
INLINE void move_body(const TinkerContactElimination *self, const Body *body, int32_t equations, int32_t ends)
{
    const double *restrict j = self->model->constraints.jacobian, *restrict mu = self->mu;
    const TinkerContactEquation *restrict of = self->of + body->first;
    const End *end = self->ends + body->first_end;
    Equation *restrict equation = self->equation + body->first;
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
        const Body *body = &self->body[i];
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
    if (self->tries++ > 0 || !self->full) solve_rows(self);
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
    if (!factor(self, softness, 0)) factor(self, softness, TINKER_PROXIMAL_SHIFT);
}

void tinker_contact_elimination_solve_soft(TinkerContactElimination *self, const double *b, double *x)
{
    for (int32_t e = 0; e < self->equations; e++)
        self->equation[e].miss = b[e];
    solve_rows(self);
    find_moves(self);
    for (int32_t e = 0; e < self->equations; e++)
        x[e] = self->equation[e].move;
}
