/* Products with the stiffness and the damping of a start, f = K d or C d: free, in coordinates, or projected on what
 * constraints leave. */
#include <math.h>
#include <string.h>

#include "physics/constraint/constraints.h"
#include "physics/force/forces.h"
#include "physics/plan/start-matrices-private.h"

static void edge_product(const TinkerLinearSystem *linear, gboolean damping, const double *d, double *f)
{
    memset(f, 0, (gsize)linear->size * sizeof(double));
    for (int32_t i = 0; i < linear->edge_count; i++) {
        const TinkerLinearEdge *edge = &linear->edges[i];
        double apart = (edge->b >= 0 ? d[edge->b] : 0) - (edge->a >= 0 ? d[edge->a] : 0);
        double pull = (damping ? edge->damping : edge->stiffness) * apart;
        if (edge->a >= 0) f[edge->a] -= pull;
        if (edge->b >= 0) f[edge->b] += pull;
    }
    if (!damping || linear->drag == NULL) return;
    for (int32_t i = 0; i < linear->size; i++)
        f[i] += linear->drag[i] * d[i];
}

static void sparse_product(const TinkerPattern *pattern, const double *values, const double *d, double *f)
{
    for (int32_t row = 0; row < pattern->size; row++) {
        double sum = 0;
        for (int32_t e = pattern->row_starts[row]; e < pattern->row_starts[row + 1]; e++)
            sum += values[e] * d[pattern->columns[e]];
        f[row] = sum;
    }
}

/* The model's products are of M^-1 f and have the forces' sign. */
static void model_product(TinkerModel *model, gboolean damping, const double *d, double *f)
{
    TinkerStatus status =
        damping ? tinker_model_damping_product(model, d, f) : tinker_model_stiffness_product(model, d, f);
    for (int32_t i = 0; i < model->coordinates; i++)
        f[i] = status == TINKER_OK ? -f[i] * model->coordinate_mass[i] : NAN;
}

/* Takes (dJ/dt)^T S^-1 (dJ/dt) x off, with x as the input. */
static void turn(TinkerStartMatrices *self)
{
    const GArray *all = self->turning;
    memset(self->tensions, 0, (gsize)self->model->constraints.rows * sizeof(double));
    for (guint k = 0; k < all->len; k++) {
        const TinkerTurningEntry *entry = &g_array_index(all, TinkerTurningEntry, k);
        self->tensions[entry->row] += entry->rate * self->input[entry->coordinate];
    }
    tinker_constraints_solve(self->model, self->tensions);
    for (guint k = 0; k < all->len; k++) {
        const TinkerTurningEntry *entry = &g_array_index(all, TinkerTurningEntry, k);
        self->output[entry->coordinate] -= entry->rate * self->tensions[entry->row];
    }
}

static void free_product(TinkerStartMatrices *self, gboolean damping, const double *x, double *y)
{
    for (int32_t i = 0; i < self->n; i++)
        self->input[i] = x[i] * self->inverse_root[i];
    if (self->linear != NULL)
        edge_product(self->linear, damping, self->input, self->output);
    else if (self->jacobian != NULL)
        sparse_product(tinker_jacobian_pattern(self->jacobian), damping ? self->damping : self->stiffness, self->input,
                       self->output);
    else
        model_product(self->model, damping, self->input, self->output);
    for (guint k = 0; !damping && k < self->geometry->len; k++) {
        const TinkerStiffnessEntry *entry = &g_array_index(self->geometry, TinkerStiffnessEntry, k);
        self->output[entry->row] += entry->stiffness * self->input[entry->column];
    }
    for (int32_t i = 0; i < self->n; i++)
        y[i] = self->output[i] * self->inverse_root[i];
}

void tinker_start_matrices_moving_stiffness(void *matrices, const double *x, double *y)
{
    TinkerStartMatrices *self = matrices;
    free_product(self, FALSE, x, y);
    memset(self->output, 0, (gsize)self->n * sizeof(double));
    turn(self);
    for (int32_t i = 0; i < self->n; i++)
        y[i] += self->output[i] * self->inverse_root[i];
}

gboolean tinker_start_matrices_moves(const TinkerStartMatrices *self)
{
    return self->turning->len > 0;
}

/* P x = M^1/2 (projection of velocities) M^-1/2 x. */
static void project(TinkerStartMatrices *self, double *x)
{
    gboolean moved;
    if (self->linear != NULL || self->model->constraints.rows == 0) return;
    for (int32_t i = 0; i < self->n; i++)
        self->input[i] = x[i] * self->inverse_root[i];
    tinker_constraints_correct_velocities(self->model, self->input, TRUE, &moved);
    for (int32_t i = 0; i < self->n; i++)
        x[i] = self->input[i] / self->inverse_root[i];
}

static void projected_product(TinkerStartMatrices *self, gboolean damping, const double *x, double *y)
{
    memcpy(self->projected, x, (gsize)self->n * sizeof(double));
    project(self, self->projected);
    free_product(self, damping, self->projected, y);
    project(self, y);
}

void tinker_start_matrices_stiffness(void *matrices, const double *x, double *y)
{
    projected_product(matrices, FALSE, x, y);
}

void tinker_start_matrices_damping(void *matrices, const double *x, double *y)
{
    projected_product(matrices, TRUE, x, y);
}

void tinker_start_matrices_turning(void *matrices, const double *x, double *y)
{
    TinkerStartMatrices *self = matrices;
    memset(y, 0, (gsize)self->n * sizeof(double));
    if (!self->turned || self->jacobian == NULL) return;
    memcpy(self->projected, x, (gsize)self->n * sizeof(double));
    project(self, self->projected);
    const TinkerPattern *pattern = tinker_jacobian_pattern(self->jacobian);
    for (int32_t row = 0; row < pattern->size; row++)
        for (int32_t e = pattern->row_starts[row]; e < pattern->row_starts[row + 1]; e++) {
            int32_t column = pattern->columns[e];
            double half = 0.5 * self->damping[e] * self->inverse_root[row] * self->inverse_root[column];
            y[row] += half * self->projected[column];
            y[column] -= half * self->projected[row];
        }
    project(self, y);
}

void tinker_start_matrices_free_stiffness(void *matrices, const double *x, double *y)
{
    free_product(matrices, FALSE, x, y);
}

void tinker_start_matrices_free_damping(void *matrices, const double *x, double *y)
{
    free_product(matrices, TRUE, x, y);
}
