/* A step: start, Newton's iteration for the acceleration, end. Norms are mass-weighted. */
#include "numerics/integrate/newmark-family.h"

#include <float.h>
#include <glib.h>

#include "numerics/integrate/hermite.h"
#include "numerics/integrate/linear-band.h"
#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"
#include "numerics/solve/symmetric-solver.h"

#define NEWTON_CAP 50

static const char *const no_derivatives =
    "the method needs the derivatives of the forces, which this system does not give; choose an explicit method";
static const char *const no_convergence =
    "the iteration for the step's implicit equations does not converge: choose a smaller step, or an adaptive method";

static const TinkerNewmarkWeights average_acceleration = {.beta = 0.25, .gamma = 0.5};

typedef struct Stepper {
    const TinkerSystem *system;
    TinkerNewmarkWeights own;     /* of the method */
    TinkerNewmarkWeights weights; /* of the step in progress */
    const char *refusal;
    TinkerHermite dense;
    TinkerSymmetricSolver *solver;
    TinkerLinearBand *band; /* of a linear system with a narrow band: in place of all that iterates */
    int linear;             /* one solve with one matrix is the solution */
    int carried;            /* `a` and `power_from` belong to the present state */
    double h;               /* of the last step; 0: none */
    int factored;
    int32_t *diagonal; /* entries of the pattern */
    double *stiffness, *damping, *row_masses;
    double *a, *x;              /* the acceleration before, the one looked for */
    double *correction, *along; /* of x; its part along the rows of constraints */
    double *base, *descent;     /* the best iterate so far and its correction */
    double *q, *v;              /* at the end */
    double *behind, *ahead;     /* accelerations by the forces, at the start and the end */
    double *power_from, *power_to;
    double memory[];
} Stepper;

/* Memory --------------------------------------------------------------------------------------------------------- */

static void take_arrays(Stepper *self, size_t n, size_t m, size_t entries)
{
    double *next = self->memory;
    tinker_hermite_init(&self->dense, self->system, &next);
    double **of_system[] = {&self->a,       &self->x, &self->correction, &self->along,  &self->base,
                            &self->descent, &self->q, &self->v,          &self->behind, &self->ahead};
    for (size_t i = 0; i < G_N_ELEMENTS(of_system); i++)
        *of_system[i] = tinker_take(&next, n);
    self->power_from = tinker_take(&next, m);
    self->power_to = tinker_take(&next, m);
    self->stiffness = tinker_take(&next, entries);
    self->damping = tinker_take(&next, entries);
    self->row_masses = tinker_take(&next, entries);
    self->diagonal = (int32_t *)(void *)tinker_take(&next, n);
}

static void find_diagonal(Stepper *self, const TinkerPattern *pattern)
{
    for (int32_t row = 0; row < pattern->size; row++)
        for (int32_t k = pattern->row_starts[row]; k < pattern->row_starts[row + 1]; k++)
            if (pattern->columns[k] == row) self->diagonal[row] = k;
}

/* Whether the forces are linear in places and velocities: none turns round where the ends of an edge pass each other.
 */
static int has_one_matrix(const TinkerLinearSystem *linear)
{
    if (linear == NULL) return 0;
    for (int32_t e = 0; e < linear->edge_count; e++)
        if (linear->edges[e].tension != linear->edges[e].stiffness * linear->edges[e].length) return 0;
    return 1;
}

void *tinker_newmark_create(const TinkerNewmarkWeights *weights, const char *refusal, const TinkerSystem *system)
{
    size_t n = (size_t)system->size, m = (size_t)system->books;
    const TinkerPattern *pattern = system->jacobian != NULL ? system->pattern : NULL;
    size_t entries = pattern != NULL ? (size_t)pattern->entries : 0;
    size_t doubles = tinker_hermite_doubles(system->size, system->books) + 11 * n + 2 * m + 3 * entries;
    Stepper *self = g_try_malloc0(sizeof *self + doubles * sizeof(double));
    if (self == NULL) return NULL;
    self->system = system;
    self->own = *weights;
    self->refusal = refusal;
    self->linear = !tinker_is_constrained(system) && has_one_matrix(system->linear);
    if (!tinker_is_constrained(system)) self->band = tinker_linear_band_new(system);
    take_arrays(self, n, m, entries);
    if (pattern == NULL) {
        self->refusal = no_derivatives;
        return self;
    }
    find_diagonal(self, pattern);
    if (self->band == NULL) self->solver = tinker_symmetric_solver_new(pattern, TINKER_SOLVER_FITTING);
    if (self->band != NULL || self->solver != NULL) return self;
    g_free(self);
    return NULL;
}

void tinker_newmark_destroy(void *data)
{
    Stepper *self = data;
    if (self == NULL) return;
    tinker_symmetric_solver_free(self->solver);
    tinker_linear_band_free(self->band);
    g_free(self);
}

void tinker_newmark_restart(void *data)
{
    Stepper *self = data;
    self->carried = 0;
    self->factored = 0;
    tinker_hermite_forget(&self->dense);
}

/* Newton --------------------------------------------------------------------------------------------------------- */

static double norm(const TinkerSystem *system, const double *x)
{
    double sum = 0.0;
    for (int32_t i = 0; i < system->size; i++)
        sum += system->mass[i] * x[i] * x[i];
    return sqrt(sum);
}

/* The end of the step from x. Constraints are met as RATTLE does, along the rows at the start: on a pendulum the energy
 * stays bounded, which it does not where the end is projected along its own rows. */
static TinkerStatus place(Stepper *self, const TinkerState *state, double h, double limit)
{
    const TinkerSystem *system = self->system;
    const TinkerNewmarkWeights *w = &self->weights;
    double old_q = h * h * (0.5 - w->beta), new_q = h * h * w->beta, old_v = h * (1.0 - w->gamma), new_v = h * w->gamma;
    const double *restrict a = self->a, *restrict x = self->x;
    double *restrict q = self->q, *restrict v = self->v;
    for (int32_t i = 0; i < system->size; i++) {
        q[i] = state->q[i] + (h * state->v[i] + (old_q * a[i] + new_q * x[i]));
        v[i] = state->v[i] + (old_v * a[i] + new_v * x[i]);
    }
    if (!tinker_is_constrained(system)) return TINKER_OK;
    TinkerStatus status = system->constrain_step(system->context, state->t, state->q, limit, h, self->q, self->v);
    return status == TINKER_OK ? system->project_velocity(system->context, limit, self->q, self->v, 0) : status;
}

/* The residual of x, as an acceleration, into `correction`. */
static TinkerStatus find_residual(Stepper *self, const TinkerState *state, double h, double limit)
{
    const TinkerSystem *system = self->system;
    const TinkerNewmarkWeights *w = &self->weights;
    TinkerStatus status = place(self, state, h, limit);
    if (status != TINKER_OK) return status;
    status = system->acceleration(system->context, limit, self->q, self->v, self->ahead, NULL);
    const double *restrict x = self->x, *restrict a = self->a, *restrict ahead = self->ahead;
    for (int32_t i = 0; i < system->size; i++)
        self->correction[i] =
            x[i] + w->mean_acceleration * (a[i] - x[i]) - ahead[i] - w->mean_force * (self->behind[i] - ahead[i]);
    return status;
}

/* The matrix at the end that the present x leads to. */
static TinkerStatus factor(Stepper *self, double h, double limit)
{
    const TinkerSystem *system = self->system;
    const TinkerNewmarkWeights *w = &self->weights;
    double by_v = (1.0 - w->mean_force) * h * w->gamma, by_q = (1.0 - w->mean_force) * h * h * w->beta, stiffest = 0.0;
    double *matrix = self->stiffness;
    TinkerStatus status = system->jacobian(system->context, limit, self->q, self->v, self->stiffness, self->damping);
    if (status != TINKER_OK) return status;
    for (int32_t k = 0; k < system->pattern->entries; k++)
        matrix[k] = by_q * self->stiffness[k] + by_v * self->damping[k];
    for (int32_t i = 0; i < system->size; i++) {
        double *entry = &matrix[self->diagonal[i]];
        *entry += (1.0 - w->mean_acceleration) * system->mass[i];
        stiffest = fmax(stiffest, fabs(*entry) / system->mass[i]);
    }
    if (tinker_is_constrained(system) && system->row_masses != NULL) {
        status = system->row_masses(system->context, limit, self->q, self->row_masses);
        if (status != TINKER_OK) return status;
        for (int32_t k = 0; k < system->pattern->entries; k++)
            matrix[k] += TINKER_ROW_WEIGHT * stiffest * self->row_masses[k];
    }
    self->factored = tinker_symmetric_solver_factor(self->solver, matrix);
    return self->factored ? TINKER_OK : TINKER_FAILED;
}

/* Replaces the residual by the correction of x. What the residual has along the rows of constraints does not move the
 * end, which is projected: it is met by the acceleration alone. */
static TinkerStatus solve(Stepper *self, double limit)
{
    const TinkerSystem *system = self->system;
    int32_t n = system->size;
    double *r = self->correction;
    int constrained = tinker_is_constrained(system);
    TinkerStatus status = TINKER_OK;
    if (constrained) {
        tinker_copy(n, r, self->along);
        status = system->project_velocity(system->context, limit, self->q, r, 1);
        if (status != TINKER_OK) return status;
        for (int32_t i = 0; i < n; i++)
            self->along[i] -= r[i];
    }
    for (int32_t i = 0; i < n; i++)
        r[i] *= system->mass[i];
    tinker_symmetric_solver_solve(self->solver, r);
    if (!constrained) return TINKER_OK;
    status = system->project_velocity(system->context, limit, self->q, r, 1);
    for (int32_t i = 0; i < n; i++)
        r[i] += self->along[i] / (1.0 - self->weights.mean_acceleration);
    return status;
}

/* What rounding of the terms of q1, v1 and x itself makes of x. Their norms in one loop, so that no sum waits for
 * itself alone. */
static double rounding(const Stepper *self, double h)
{
    const TinkerNewmarkWeights *w = &self->weights;
    const double *terms[] = {self->q, self->v, self->x, self->a};
    double sums[4] = {0, 0, 0, 0};
    for (int32_t i = 0; i < self->system->size; i++)
        for (int k = 0; k < 4; k++)
            sums[k] += self->system->mass[i] * terms[k][i] * terms[k][i];
    double by_place = sqrt(sums[0]) / (w->beta * h * h), by_speed = sqrt(sums[1]) / (w->gamma * fabs(h));
    return 4.0 * DBL_EPSILON * (by_place + by_speed + sqrt(sums[2]) + sqrt(sums[3]));
}

/* x = base - share * descent. */
static void descend(Stepper *self, double share)
{
    for (int32_t i = 0; i < self->system->size; i++)
        self->x[i] = self->base[i] - share * self->descent[i];
}

/* Where an iteration stands. */
typedef struct {
    double size;  /* of the correction at the best iterate; infinite: none yet */
    double share; /* of that correction which is tried */
    int sharp;    /* the matrix is that of the best iterate */
} Progress;

/* The correction at x, with a new matrix where there is none that serves. */
static TinkerStatus find_correction(Stepper *self, const TinkerState *state, double h, double limit, double *size)
{
    *size = INFINITY;
    TinkerStatus status = find_residual(self, state, h, limit);
    if (status == TINKER_OK && !self->factored) status = factor(self, h, limit);
    if (status == TINKER_OK) status = solve(self, limit);
    if (status == TINKER_OK) *size = norm(self->system, self->correction);
    return status;
}

/* Makes x the best iterate, and goes on from it. */
static void advance(Stepper *self, Progress *progress, double size, int sharp)
{
    double *correction = self->correction;
    self->correction = self->descent;
    self->descent = correction;
    tinker_copy(self->system->size, self->x, self->base);
    *progress = (Progress){size, 1.0, sharp};
    descend(self, 1.0);
}

/* Goes back to the best iterate: for a new matrix, or else for a shorter way. Returns 0 where neither is left. */
static int retreat(Stepper *self, Progress *progress)
{
    if (!isfinite(progress->size)) return 0;
    if (!progress->sharp) {
        tinker_copy(self->system->size, self->base, self->x);
        self->factored = 0;
        progress->size = INFINITY;
        return 1;
    }
    progress->share *= 0.5;
    descend(self, progress->share);
    return progress->share > 1e-3;
}

static TinkerStatus find_acceleration(Stepper *self, const TinkerState *state, double h, double limit)
{
    Progress progress = {INFINITY, 1.0, 0};
    tinker_copy(self->system->size, self->a, self->x);
    for (int iteration = 0; iteration < NEWTON_CAP; iteration++) {
        int sharp = !self->factored;
        double size;
        TinkerStatus status = find_correction(self, state, h, limit, &size);
        int first = !isfinite(progress.size);
        double gain = first ? 1.0 : size / progress.size, least = rounding(self, h);
        if (status != TINKER_OK || !(size < progress.size)) {
            /* what is left over may be rounding of large, balanced forces */
            if (progress.sharp && progress.size < 1e4 * least) return place(self, state, h, limit);
            if (!retreat(self, &progress)) return TINKER_RETRY_SMALLER;
            continue;
        }
        advance(self, &progress, size, sharp);
        if (self->linear || size <= least || gain * size <= (1.0 - gain) * least) return place(self, state, h, limit);
        if (!first && gain > TINKER_SLOW_NEWTON) self->factored = 0;
    }
    return TINKER_RETRY_SMALLER;
}

/* The acceleration of a linear system, which the band solves for in one go. */
static TinkerStatus find_linear_acceleration(Stepper *self, const TinkerState *state, double h, double limit)
{
    TinkerBandStart start = {state->q, state->v, self->a, self->behind};
    if (!self->factored) self->factored = tinker_linear_band_factor(self->band, &self->weights, h);
    if (!self->factored) return TINKER_FAILED;
    tinker_linear_band_step(self->band, &self->weights, h, limit, &start, self->x, self->q, self->v);
    return TINKER_OK;
}

/* Steps ---------------------------------------------------------------------------------------------------------- */

/* The length of the step to work with. One that differs from the last by the rounding of t alone is the last one. */
static double length_of_step(const Stepper *self, double t, double limit)
{
    double h = limit - t, rounded = 4.0 * DBL_EPSILON * fmax(fabs(t), fabs(limit));
    return fabs(h - self->h) <= rounded ? self->h : h;
}

/* How far behind the end of a step, as a part of it, the acceleration lies that the method carries over. */
static double lag(const TinkerNewmarkWeights *weights)
{
    return weights->mean_force - weights->mean_acceleration;
}

/* Chooses weights and takes the acceleration of the state where none is carried over. As that does not lag, and one of
 * steps of another length lags by another time, such a step is one of average acceleration. */
static TinkerStatus begin(Stepper *self, const TinkerState *state, double h)
{
    const TinkerSystem *system = self->system;
    int changed = h != self->h, starts = !self->carried || (changed && lag(&self->own) != 0.0);
    const TinkerNewmarkWeights *weights = starts ? &average_acceleration : &self->own;
    if (changed || memcmp(weights, &self->weights, sizeof *weights) != 0) self->factored = 0;
    self->weights = *weights;
    self->h = h;
    if (!starts) return TINKER_OK;
    TinkerStatus status = TINKER_OK;
    if (!self->carried && self->band != NULL) status = tinker_linear_band_enter(self->band, state->t, state->q);
    if (status == TINKER_OK)
        status = system->acceleration(system->context, state->t, state->q, state->v, self->a,
                                      system->books > 0 ? self->power_from : NULL);
    tinker_copy(system->size, self->a, self->behind);
    return status;
}

/* What the next step takes over: the acceleration that the forces give at the end, as x has it, and the method's own,
 * after a step of average acceleration between those of its two ends. */
static void carry_over(Stepper *self)
{
    const TinkerNewmarkWeights *w = &self->weights;
    double share = lag(&self->own) - lag(w), behind = w->mean_force, by = 1.0 / (1.0 - behind);
    double *restrict a = self->a, *restrict force = self->behind;
    const double *restrict x = self->x;
    for (int32_t i = 0; i < self->system->size; i++) {
        force[i] = by * (x[i] + w->mean_acceleration * (a[i] - x[i]) - behind * force[i]);
        a[i] = x[i] + share * (a[i] - x[i]);
    }
    self->carried = 1;
}

static TinkerStatus end(Stepper *self, TinkerState *state, double h, double limit)
{
    const TinkerSystem *system = self->system;
    TinkerStatus status = TINKER_OK;
    if (system->books > 0)
        status = system->acceleration(system->context, limit, self->q, self->v, self->ahead, self->power_to);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < system->books; i++)
        state->books[i] += 0.5 * h * (self->power_from[i] + self->power_to[i]);
    double *power = self->power_from;
    self->power_from = self->power_to;
    self->power_to = power;
    carry_over(self);
    tinker_copy(system->size, self->q, state->q);
    tinker_copy(system->size, self->v, state->v);
    state->t = limit;
    return TINKER_OK;
}

TinkerStatus tinker_newmark_step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *self = data;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;
    if (self->refusal != NULL) {
        report->failure = self->refusal;
        return TINKER_FAILED;
    }
    double h = length_of_step(self, state->t, limit);
    tinker_hermite_start(&self->dense, state);
    status = begin(self, state, h);
    if (status == TINKER_OK)
        status = self->band != NULL ? find_linear_acceleration(self, state, h, limit)
                                    : find_acceleration(self, state, h, limit);
    if (status == TINKER_OK) status = end(self, state, h, limit);
    if (status == TINKER_OK) {
        tinker_hermite_finish(&self->dense, state);
        return TINKER_OK;
    }
    tinker_newmark_restart(self);
    report->failure = tinker_failure_of(self->system, no_convergence);
    return TINKER_FAILED;
}

TinkerStatus tinker_newmark_interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *self = data;
    return tinker_hermite_interpolate(&self->dense, t, q, v, books);
}
