/* Three ways to a product: a linear form by its edges; a model of moderate size by its sparse Jacobian, evaluated once;
 * a large one by products of the forces' derivatives, so that nothing of the size of a matrix is made. */
#include <math.h>
#include <string.h>

#include "numerics/solve/largest.h"
#include "numerics/solve/null-space.h"
#include "numerics/solve/symmetric-solver.h"
#include "physics/constraint/constraints.h"
#include "physics/force/forces.h"
#include "physics/line/linear-form.h"
#include "physics/model/points.h"
#include "physics/model/state.h"
#include "physics/plan/start-matrices-private.h"
#include "physics/plan/tolerances.h"

/* Coordinates up to which the sparse Jacobian is worked out. */
#define MOST_SPARSE 2000

/* Accelerations at the start, constraints included; the tensions of these go into the geometry, but of what is linear
 * in coordinates of its own: there they change nothing. */
static gboolean find_acceleration(TinkerStartMatrices *self, double *a)
{
    TinkerModel *model = self->model;
    if (tinker_model_set_time(model, 0.0) != TINKER_OK) return FALSE;
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (tinker_model_applied(model, a, FALSE) != TINKER_OK) return FALSE;
    if (model->constraints.rows == 0) return TRUE;
    if (tinker_constraints_evaluate(model) != TINKER_OK) return FALSE;
    tinker_constraints_accelerate(model, a);
    if (self->linear != NULL) return TRUE;
    g_autofree double *lambda = g_memdup2(model->constraints.lambda, (gsize)model->constraints.rows * sizeof(double));
    tinker_start_geometry(model, lambda, self->geometry);
    self->tensions = g_new0(double, (gsize)model->constraints.rows);
    return tinker_start_turning(model, self->turning) == TINKER_OK;
}

static gboolean evaluate_jacobian(TinkerStartMatrices *self)
{
    TinkerModel *model = self->model;
    if (self->linear != NULL || self->n > MOST_SPARSE) return TRUE;
    self->jacobian = tinker_jacobian_new(model);
    gsize entries = (gsize)MAX(tinker_jacobian_pattern(self->jacobian)->entries, 1);
    self->stiffness = g_new0(double, entries);
    self->damping = g_new0(double, entries);
    return tinker_jacobian_evaluate(self->jacobian, 0.0, model->q_start, model->v_start, self->stiffness,
                                    self->damping) == TINKER_OK;
}

/* Whether any force resists a velocity. */
static gboolean is_damped(const TinkerStartMatrices *self)
{
    const TinkerModel *model = self->model;
    if (self->linear != NULL) {
        for (int32_t i = 0; i < self->linear->edge_count; i++)
            if (self->linear->edges[i].damping != 0) return TRUE;
        return self->linear->drag != NULL && tinker_largest(self->n, self->linear->drag) > 0;
    }
    if (self->jacobian != NULL)
        return tinker_largest(tinker_jacobian_pattern(self->jacobian)->entries, self->damping) > 0;
    return tinker_model_feels_velocities(model);
}

/* x . C y - y . C x, of two vectors that are not like any shape. */
static gboolean is_turned(TinkerStartMatrices *self)
{
    gsize n = (gsize)self->n;
    if (self->linear != NULL || !self->damped || n == 0) return FALSE;
    g_autofree double *room = g_new0(double, 4 * n);
    double *x = room, *y = x + n, *cx = y + n, *cy = cx + n, there = 0, back = 0, most = 0;
    for (gsize i = 0; i < n; i++) {
        x[i] = 1.0 + 0.5 * sin(12.9898 * (double)(i + 1));
        y[i] = 1.0 + 0.5 * sin(78.233 * (double)(i + 1));
    }
    tinker_start_matrices_free_damping(self, x, cx);
    tinker_start_matrices_free_damping(self, y, cy);
    for (gsize i = 0; i < n; i++) {
        there += x[i] * cy[i];
        back += y[i] * cx[i];
        most += fabs(x[i] * cy[i]) + fabs(y[i] * cx[i]);
    }
    return fabs(there - back) > TINKER_SYMMETRIC_DIFFERENCES * most;
}

/* The start's acceleration and velocity in coordinates, times M^1/2. */
static gboolean find_start(TinkerStartMatrices *self)
{
    TinkerModel *model = self->model;
    g_autofree double *a = g_new0(double, (gsize)MAX(model->coordinates, 1));
    gint64 evaluations = model->evaluations;
    gboolean fine = find_acceleration(self, a);
    model->evaluations = evaluations;
    if (!fine) return FALSE;
    if (self->linear != NULL) {
        g_autofree double *place = g_new0(double, MAX(self->n, 1));
        tinker_linear_form_reduce(self->island->linear, model->q_start, a, place, self->acceleration);
        tinker_linear_form_reduce(self->island->linear, model->q_start, model->v_start, place, self->velocity);
    } else {
        memcpy(self->acceleration, a, (gsize)self->n * sizeof(double));
        memcpy(self->velocity, model->v_start, (gsize)self->n * sizeof(double));
    }
    for (int32_t i = 0; i < self->n; i++) {
        self->acceleration[i] /= self->inverse_root[i];
        self->velocity[i] /= self->inverse_root[i];
    }
    return TRUE;
}

TinkerStartMatrices *tinker_start_matrices_new(const TinkerIsland *island)
{
    TinkerStartMatrices *self = g_new0(TinkerStartMatrices, 1);
    self->island = island;
    self->model = island->model;
    self->linear = island->linear != NULL ? tinker_linear_form_system(island->linear) : NULL;
    self->n = self->linear != NULL ? self->linear->size : island->model->coordinates;
    gsize n = (gsize)MAX(self->n, 1);
    self->inverse_root = g_new0(double, 6 * n);
    self->geometry = g_array_new(FALSE, FALSE, sizeof(TinkerStiffnessEntry));
    self->turning = g_array_new(FALSE, FALSE, sizeof(TinkerTurningEntry));
    self->acceleration = self->inverse_root + n;
    self->velocity = self->acceleration + n;
    self->input = self->velocity + n;
    self->output = self->input + n;
    self->projected = self->output + n;
    const double *mass = self->linear != NULL ? self->linear->mass : island->model->coordinate_mass;
    for (int32_t i = 0; i < self->n; i++)
        self->inverse_root[i] = 1.0 / sqrt(mass[i]);
    if (!evaluate_jacobian(self) || !find_start(self)) g_clear_pointer(&self, tinker_start_matrices_free);
    if (self == NULL) return NULL;
    self->damped = is_damped(self);
    self->turned = is_turned(self);
    return self;
}

void tinker_start_matrices_free(TinkerStartMatrices *self)
{
    if (self == NULL) return;
    tinker_jacobian_free(self->jacobian);
    g_array_unref(self->geometry);
    g_array_unref(self->turning);
    g_free(self->tensions);
    g_free(self->inverse_root);
    g_free(self->stiffness);
    g_free(self->damping);
    g_free(self);
}

int32_t tinker_start_matrices_size(const TinkerStartMatrices *self)
{
    return self->n;
}

gboolean tinker_start_matrices_damped(const TinkerStartMatrices *self)
{
    return self->damped;
}

gboolean tinker_start_matrices_turned(const TinkerStartMatrices *self)
{
    return self->turned;
}

int32_t tinker_start_matrices_tangents(TinkerStartMatrices *self, double *basis)
{
    const TinkerConstraints *all = &self->model->constraints;
    int32_t rows = self->linear != NULL ? 0 : all->rows;
    gsize n = (gsize)self->n;
    g_auto(TinkerNullSpace) space = {0};
    tinker_null_space_open(&space, rows, self->n);
    g_autofree TinkerCoordinateEntry *entries = tinker_constraints_row_room(all);
    for (int32_t row = 0; row < rows; row++) {
        const int32_t count = tinker_constraints_list_row(all, row, entries);
        for (int32_t k = 0; k < count; k++) {
            const int32_t i = entries[k].coordinate;
            if (i < self->n) space.r[(gsize)row * n + (gsize)i] += entries[k].value * self->inverse_root[i];
        }
    }
    if (!tinker_null_space_find(&space)) return -1;
    const gsize free_columns = n - (gsize)space.rank;
    memcpy(basis, space.q + n * (gsize)space.rank, n * free_columns * sizeof(double));
    return (int32_t)free_columns;
}

const double *tinker_start_matrices_acceleration(const TinkerStartMatrices *self)
{
    return self->acceleration;
}

const double *tinker_start_matrices_velocity(const TinkerStartMatrices *self)
{
    return self->velocity;
}

static double held_energy(const TinkerStartMatrices *self, const TinkerPattern *pattern, const double *stiffness,
                          double *omega)
{
    double sum = 0, square = 0;
    g_autofree double *u = g_new(double, MAX(self->n, 1));
    TinkerSymmetricSolver *solver = tinker_symmetric_solver_new(pattern, TINKER_SOLVER_FITTING);
    if (solver == NULL) return NAN;
    for (int32_t i = 0; i < self->n; i++)
        u[i] = self->acceleration[i] / self->inverse_root[i]; /* the force */
    gboolean solved = tinker_symmetric_solver_factor(solver, stiffness);
    if (solved) tinker_symmetric_solver_solve(solver, u);
    for (int32_t i = 0; i < self->n; i++) {
        double x = u[i] / self->inverse_root[i];
        sum += x * self->acceleration[i];
        square += x * x;
    }
    *omega = square > 0 ? sqrt(sum / square) : 0;
    tinker_symmetric_solver_free(solver);
    return solved && isfinite(sum) && sum >= 0 ? sum : NAN;
}

double tinker_start_matrices_held_energy(TinkerStartMatrices *self, double *omega)
{
    TinkerLinearForm *form = self->island->linear;
    if (self->n > MOST_SPARSE) return NAN;
    if (form != NULL && form->one_coordinate) {
        tinker_linear_form_differentiate(form);
        return held_energy(self, &form->pattern, form->stiffness, omega);
    }
    if (self->jacobian == NULL || self->model->constraints.rows > 0) return NAN;
    return held_energy(self, tinker_jacobian_pattern(self->jacobian), self->stiffness, omega);
}

void tinker_start_matrices_shape(const TinkerStartMatrices *self, const double *x, double *shape)
{
    gsize n = (gsize)self->model->coordinates;
    g_autofree double *moved = g_new0(double, MAX(self->n, 1));
    for (int32_t i = 0; i < self->n; i++)
        moved[i] = x[i] * self->inverse_root[i];
    if (self->linear == NULL) {
        memcpy(shape, moved, n * sizeof(double));
        return;
    }
    /* velocities are expanded without an offset */
    g_autofree double *place = g_new0(double, MAX(self->n, 1)), *q = g_new0(double, MAX(n, 1));
    tinker_linear_form_expand(self->island->linear, place, moved, q, shape);
}
