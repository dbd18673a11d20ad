/* Three ways to a product: a linear form by its edges; a model of moderate size by its sparse Jacobian, evaluated once;
 * a large one by products of the forces' derivatives, so that nothing of the size of a matrix is made. */
#include "physics/plan/start-matrices.h"
#include "numerics/solve/largest.h"

#include <math.h>
#include <string.h>

#include "numerics/solve/null-space.h"
#include "numerics/solve/symmetric-solver.h"
#include "physics/constraint/constraints.h"
#include "physics/force/forces.h"
#include "physics/line/linear-form-data.h"
#include "physics/line/linear-form.h"
#include "physics/model/angles.h"
#include "physics/plan/islands.h"
#include "physics/system/jacobian.h"

/* Coordinates up to which the sparse Jacobian is worked out. */
#define MOST_SPARSE 2000
/* Of a row's length: differences of its Jacobian. */
#define DIFFERENCE 1e-6
/* Two products that agree to this are of a symmetric matrix, whose entries may be differences. */
#define SYMMETRIC 1e-6

/* What a constraint's tension adds to the stiffness between two coordinates. */
typedef struct {
    int32_t row, column;
    double stiffness;
} Entry;

struct _TinkerStartMatrices {
    const TinkerIsland *island;
    TinkerModel *model;
    const TinkerLinearSystem *linear; /* else NULL */
    int32_t n;
    double *inverse_root; /* of each coordinate's mass */
    TinkerJacobian *jacobian;
    double *stiffness, *damping; /* of the Jacobian's pattern */
    GArray *geometry;            /* of Entry */
    double *acceleration, *velocity;
    double *input, *output; /* of the free products */
    double *projected;      /* of the others */
    gboolean damped, turned;
};

/* Free products: f = K d or C d, in coordinates ------------------------------------------------------------------- */

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
        const Entry *entry = &g_array_index(self->geometry, Entry, k);
        self->output[entry->row] += entry->stiffness * self->input[entry->column];
    }
    for (int32_t i = 0; i < self->n; i++)
        y[i] = self->output[i] * self->inverse_root[i];
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

/* What constraints' tensions add ------------------------------------------------------------------------------------
 */

typedef struct {
    TinkerStartMatrices *matrices;
    const TinkerConstraintBatch *part;
    const double *lambda;
    TinkerPoint *ends;
    double *g, *drift, *low, *high; /* of the batch; low and high are Jacobians */
    GArray *found;                  /* of Entry */
} Geometry;

static double *moved_coordinate(TinkerPoint *end, int k)
{
    return k == 0 ? &end->x : &end->y;
}

static int32_t end_count(const TinkerConstraintBatch *part, int32_t instance)
{
    return part->batch->end_offsets[instance + 1] - part->batch->end_offsets[instance];
}

/* Entries of a row of an instance: its ends, and behind them their turns where the rows depend on angles. */
static int32_t entry_count(const TinkerConstraintBatch *part, int32_t instance)
{
    return (part->angles != NULL ? 2 : 1) * end_count(part, instance);
}

/* The point of an entry of an instance. */
static int32_t entry_point(const TinkerConstraintBatch *part, int32_t instance, int32_t slot)
{
    const int32_t from = part->batch->end_offsets[instance], ends = end_count(part, instance);
    return slot < ends ? part->end_points[from + slot] : part->angles->turns[from + slot - ends];
}

/* How far differences go: m, or rad. */
static double reach_of(const TinkerConstraintBatch *part, const TinkerConstraints *all, int32_t instance, int32_t slot)
{
    if (slot >= end_count(part, instance)) return DIFFERENCE;
    return DIFFERENCE * all->scales[part->first_row + instance * part->constraint->rows];
}

/* Moves end number `slot` of every instance along coordinate k and evaluates all rows. */
static gboolean evaluate_moved(Geometry *work, int32_t slot, int k, double sign, double *jacobian)
{
    const TinkerConstraintBatch *part = work->part;
    const TinkerConstraints *all = &work->matrices->model->constraints;
    for (int32_t e = 0; e < part->batch->end_count; e++)
        work->ends[e] = work->matrices->model->point[part->end_points[e]];
    if (part->angles != NULL) tinker_angles_gather(part->angles, work->matrices->model, 0, part->batch->end_count);
    for (int32_t i = 0; i < part->batch->count; i++) {
        const int32_t from = part->batch->end_offsets[i], ends = end_count(part, i);
        const double step = sign * reach_of(part, all, i, slot);
        if (slot < ends)
            *moved_coordinate(&work->ends[from + slot], k) += step;
        else if (k == 0 && slot < entry_count(part, i))
            part->angles->poses[from + slot - ends].angle += step;
    }
    TinkerBatch view = part->view;
    view.time = 0;
    return tinker_constraints_ask(part, &view, work->ends, work->g, jacobian, work->drift) == TINKER_OK;
}

static void add_entry(Geometry *work, int32_t on, int d, int32_t of, int k, double stiffness)
{
    const TinkerModel *model = work->matrices->model;
    TinkerCoordinateEntry rows[2], columns[2];
    if (on >= model->first_support || of >= model->first_support || stiffness == 0 || !isfinite(stiffness)) return;
    const int32_t row_count = tinker_model_point_entries(model, on, d, rows);
    const int32_t column_count = tinker_model_point_entries(model, of, k, columns);
    for (int32_t r = 0; r < row_count; r++)
        for (int32_t c = 0; c < column_count; c++) {
            Entry entry = {rows[r].coordinate, columns[c].coordinate, stiffness * rows[r].value * columns[c].value};
            g_array_append_val(work->found, entry);
        }
}

/* The torque of what a constraint does at the arm r changes as that turns: by -r . F an angle. */
static void add_turned_arms(TinkerStartMatrices *self, const double *lambda)
{
    const TinkerModel *model = self->model;
    const TinkerConstraints *all = &model->constraints;
    for (int32_t k = 0; k < all->turn_count; k++) {
        const TinkerTurnEntry *of = &all->turns[k];
        const double *r = tinker_model_attachment(model, all->ends_at[of->entry])->arm;
        const double *j = all->jacobian + 2 * of->entry, gyration = model->turns[of->turn].gyration;
        const double along = lambda[of->row] * (r[0] * j[0] + r[1] * j[1]);
        Entry entry = {of->coordinate, of->coordinate, along / (gyration * gyration)};
        if (isfinite(along)) g_array_append_val(self->geometry, entry);
    }
}

/* -lambda times the difference of the two Jacobians, row by row. */
static void add_differences(Geometry *work, int32_t slot, int k)
{
    const TinkerConstraintBatch *part = work->part;
    const TinkerConstraints *all = &work->matrices->model->constraints;
    gsize first = 0;
    for (int32_t i = 0; i < part->batch->count; i++) {
        const int32_t entries = entry_count(part, i);
        for (int32_t r = 0; r < part->constraint->rows; r++, first += 2 * (gsize)entries) {
            if (slot >= entries) continue;
            const double lambda = work->lambda[part->first_row + i * part->constraint->rows + r];
            const double factor = -lambda / (2 * reach_of(part, all, i, slot));
            for (int32_t e = 0; e < 2 * entries; e++)
                add_entry(work, entry_point(part, i, e / 2), e % 2, entry_point(part, i, slot), k,
                          factor * (work->high[first + (gsize)e] - work->low[first + (gsize)e]));
        }
    }
}

static void add_part(Geometry *work)
{
    int32_t most = 0;
    for (int32_t i = 0; i < work->part->batch->count; i++)
        most = MAX(most, entry_count(work->part, i));
    for (int32_t slot = 0; slot < most; slot++)
        for (int k = 0; k < 2; k++)
            if (evaluate_moved(work, slot, k, -1, work->low) && evaluate_moved(work, slot, k, 1, work->high))
                add_differences(work, slot, k);
}

static void add_geometry(TinkerStartMatrices *self, const double *lambda)
{
    const TinkerConstraints *all = &self->model->constraints;
    for (guint p = 0; p < all->batches->len; p++) {
        const TinkerConstraintBatch *part = &g_array_index(all->batches, TinkerConstraintBatch, p);
        gsize rows = (gsize)MAX(part->row_count, 1), entries = (gsize)MAX(part->batch->end_count, 1);
        entries *= (gsize)MAX(part->constraint->rows, 1) * (part->angles != NULL ? 2 : 1);
        g_autofree TinkerPoint *ends = g_new(TinkerPoint, MAX(part->batch->end_count, 1));
        g_autofree double *room = g_new0(double, 2 * rows + 4 * entries);
        Geometry work = {self,          part,        lambda,          ends,
                         room,          room + rows, room + 2 * rows, room + 2 * rows + 2 * entries,
                         self->geometry};
        add_part(&work);
    }
}

/* Setting up --------------------------------------------------------------------------------------------------------
 */

/* Accelerations at the start, constraints included; the tensions of these go into the geometry. */
static gboolean find_acceleration(TinkerStartMatrices *self, double *a)
{
    TinkerModel *model = self->model;
    if (tinker_model_set_time(model, 0.0) != TINKER_OK) return FALSE;
    tinker_model_set_state(model, model->q_start, model->v_start);
    if (tinker_model_applied(model, a, FALSE) != TINKER_OK) return FALSE;
    if (model->constraints.rows == 0) return TRUE;
    if (tinker_constraints_evaluate(model) != TINKER_OK) return FALSE;
    tinker_constraints_accelerate(model, a);
    g_autofree double *lambda = g_memdup2(model->constraints.lambda, (gsize)model->constraints.rows * sizeof(double));
    add_geometry(self, lambda);
    add_turned_arms(self, lambda);
    return TRUE;
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
    return model->lines.any_damping || model->field_drag != 0 || model->asked_lines->len > 0 ||
           model->asked_forces->len > 0 || model->asked_fields->len > 0;
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
    return fabs(there - back) > SYMMETRIC * most;
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
    self->inverse_root = g_new0(double, n);
    self->geometry = g_array_new(FALSE, FALSE, sizeof(Entry));
    self->acceleration = g_new0(double, n);
    self->velocity = g_new0(double, n);
    self->input = g_new0(double, n);
    self->output = g_new0(double, n);
    self->projected = g_new0(double, n);
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
    gpointer arrays[] = {self->inverse_root, self->stiffness, self->damping, self->acceleration,
                         self->velocity,     self->input,     self->output,  self->projected};
    for (gsize i = 0; i < G_N_ELEMENTS(arrays); i++)
        g_free(arrays[i]);
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
    if (form != NULL && form->straight) {
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
