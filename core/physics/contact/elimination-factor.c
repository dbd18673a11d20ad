/* What constraint rows have left of the bodies that contacts hold, summed up and factored. */
#include <math.h>
#include <string.h>

#include "numerics/solve/pivoted-solve.h"
#include "numerics/solve/rank.h"
#include "physics/constraint/tolerances.h"
#include "physics/contact/elimination-private.h"

/* A^-1 of several equations on one body, column by column; FALSE where they depend on one another. */
static gboolean invert(const TinkerContactEquation *of, EliminationEquation *equation, int32_t count, double softness)
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
static gboolean invert_two(const TinkerContactEquation *of, EliminationEquation *equation, double softness)
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
static gboolean find_mobility(const TinkerContactElimination *self, const EliminationBody *body, double softness,
                              double mobility[2][2])
{
    const TinkerContactEquation *of = self->of + body->first;
    EliminationEquation *equation = self->equation + body->first;
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
INLINE void add_body(const TinkerContactElimination *self, const EliminationBody *body, int32_t count,
                     double mobility[2][2], double *restrict values, double *restrict least)
{
    const double *restrict j = self->model->constraints.jacobian;
    const EliminationEnd *ends = self->ends + body->first_end;
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
INLINE void add_free_body(const TinkerContactElimination *self, const EliminationBody *body, int32_t count,
                          double *restrict values, double *restrict least)
{
    const double *restrict j = self->model->constraints.jacobian;
    const EliminationEnd *ends = self->ends + body->first_end;
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
INLINE void demand_of_body(const TinkerContactElimination *self, const EliminationBody *body, int32_t equations,
                           int32_t ends, double *restrict mu)
{
    const double *restrict j = self->model->constraints.jacobian;
    const EliminationEquation *restrict equation = self->equation + body->first;
    const TinkerContactEquation *restrict of = self->of + body->first;
    const EliminationEnd *end = self->ends + body->first_end;
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
        const EliminationBody *body = &self->body[i];
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

gboolean tinker_elimination_factor(TinkerContactElimination *self, double softness, double row_softness)
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

void tinker_elimination_solve_rows(TinkerContactElimination *self)
{
    memset(self->mu, 0, (gsize)self->rows * sizeof(double));
    for (int32_t i = 0; i < self->bodies; i++)
        if (self->body[i].count > 0)
            demand_of_body(self, &self->body[i], self->body[i].count, self->body[i].end_count, self->mu);
    tinker_sparse_ldu_solve(self->ldu, self->mu);
}
