/* A step: start, acceleration, end; and the memory of it all. */
#include "numerics/integrate/newmark-private.h"

#include <float.h>
#include <glib.h>

#include "numerics/integrate/stepping.h"

static const char *const no_derivatives =
    "the method needs the derivatives of the forces, which this system does not give; choose an explicit method";
static const char *const no_convergence =
    "the iteration for the step's implicit equations does not converge: choose a smaller step, or an adaptive method";

static const TinkerNewmarkWeights average_acceleration = {.beta = 0.25, .gamma = 0.5};

/* Memory --------------------------------------------------------------------------------------------------------- */

static void take_arrays(NewmarkStepper *self, size_t n, size_t m, size_t entries)
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

static void find_diagonal(NewmarkStepper *self, const TinkerPattern *pattern)
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
    NewmarkStepper *self = g_try_malloc0(sizeof *self + doubles * sizeof(double));
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
    NewmarkStepper *self = data;
    if (self == NULL) return;
    tinker_symmetric_solver_free(self->solver);
    tinker_linear_band_free(self->band);
    g_free(self);
}

void tinker_newmark_restart(void *data)
{
    NewmarkStepper *self = data;
    self->carried = 0;
    self->factored = 0;
    tinker_hermite_forget(&self->dense);
}

/* The acceleration of a linear system, which the band solves for in one go. */
static TinkerStatus find_linear_acceleration(NewmarkStepper *self, const TinkerState *state, double h, double limit)
{
    TinkerBandStart start = {state->q, state->v, self->a, self->behind};
    if (!self->factored) self->factored = tinker_linear_band_factor(self->band, &self->weights, h);
    if (!self->factored) return TINKER_FAILED;
    tinker_linear_band_step(self->band, &self->weights, h, limit, &start, self->x, self->q, self->v);
    return TINKER_OK;
}

/* Steps ---------------------------------------------------------------------------------------------------------- */

/* The length of the step to work with. One that differs from the last by the rounding of t alone is the last one. */
static double length_of_step(const NewmarkStepper *self, double t, double limit)
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
static TinkerStatus begin(NewmarkStepper *self, const TinkerState *state, double h)
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
static void carry_over(NewmarkStepper *self)
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

static TinkerStatus end(NewmarkStepper *self, TinkerState *state, double h, double limit)
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
    NewmarkStepper *self = data;
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
                                    : newmark_find_acceleration(self, state, h, limit);
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
    NewmarkStepper *self = data;
    return tinker_hermite_interpolate(&self->dense, t, q, v, books);
}
