/* Newton's iteration for the acceleration of an implicit step. Norms are mass-weighted. */
#include "numerics/integrate/newmark-private.h"

#include <float.h>
#include <glib.h>

#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"

#define NEWTON_CAP 50

static double norm(const TinkerSystem *system, const double *x)
{
    double sum = 0.0;
    for (int32_t i = 0; i < system->size; i++)
        sum += system->mass[i] * x[i] * x[i];
    return sqrt(sum);
}

/* The end of the step from x. Constraints are met as RATTLE does, along the rows at the start: on a pendulum the energy
 * stays bounded, which it does not where the end is projected along its own rows. */
static TinkerStatus place(NewmarkStepper *self, const TinkerState *state, double h, double limit)
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
static TinkerStatus find_residual(NewmarkStepper *self, const TinkerState *state, double h, double limit)
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
static TinkerStatus factor(NewmarkStepper *self, double h, double limit)
{
    const TinkerSystem *system = self->system;
    const TinkerNewmarkWeights *w = &self->weights;
    double by_v = (1.0 - w->mean_force) * h * w->gamma, by_q = (1.0 - w->mean_force) * h * h * w->beta, stiffest = 0.0;
    double *matrix = self->stiffness, held = 0.0;
    TinkerStatus status = system->jacobian(system->context, limit, self->q, self->v, self->stiffness, self->damping);
    if (status != TINKER_OK) return status;
    for (int32_t k = 0; k < system->pattern->entries; k++)
        matrix[k] = by_q * self->stiffness[k] + by_v * self->damping[k];
    for (int32_t i = 0; i < system->size; i++) {
        double *entry = &matrix[self->diagonal[i]];
        held = fmax(held, fabs(*entry) / system->mass[i]);
        *entry += (1.0 - w->mean_acceleration) * system->mass[i];
        stiffest = fmax(stiffest, fabs(*entry) / system->mass[i]);
    }
    self->held = held / (1.0 + held);
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
static TinkerStatus solve(NewmarkStepper *self, double limit)
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
    self->moving = norm(system, r);
    for (int32_t i = 0; i < n; i++)
        r[i] += self->along[i] / (1.0 - self->weights.mean_acceleration);
    return status;
}

/* What rounding of the terms of q1, v1 and x itself makes of x: `least` where places act by the forces that they make,
 * `most` where they are what is asked for, as on rows of constraints near a singular place. */
typedef struct {
    double least, most;
    int adds_up; /* most, beside the accelerations: an iteration that ends there may leave the same in each step */
} Rounding;

/* All norms in one loop, so that no sum waits for itself alone. */
static Rounding rounding(const NewmarkStepper *self, double h)
{
    const TinkerNewmarkWeights *w = &self->weights;
    const double *terms[] = {self->q, self->v, self->x, self->a};
    double sums[4] = {0, 0, 0, 0};
    for (int32_t i = 0; i < self->system->size; i++)
        for (int k = 0; k < 4; k++)
            sums[k] += self->system->mass[i] * terms[k][i] * terms[k][i];
    double by_place = sqrt(sums[0]) / (w->beta * h * h), by_speed = sqrt(sums[1]) / (w->gamma * fabs(h));
    double accelerations = sqrt(sums[2]) + sqrt(sums[3]), itself = by_speed + accelerations;
    double least = 4.0 * DBL_EPSILON * (self->held * by_place + itself), most = 4.0 * DBL_EPSILON * (by_place + itself);
    return (Rounding){least, most, most > TINKER_LOOSE_NEWTON * accelerations};
}

/* Whether a correction, or what is to be expected behind it where each is `gain` of the one before. */
static int is_nothing(double size, double gain, double rounding)
{
    return size <= rounding || gain * size <= (1.0 - gain) * rounding;
}

/* x = base - share * descent. */
static void descend(NewmarkStepper *self, double share)
{
    for (int32_t i = 0; i < self->system->size; i++)
        self->x[i] = self->base[i] - share * self->descent[i];
}

/* Where an iteration stands. */
typedef struct {
    double size;   /* of the correction at the best iterate; infinite: none yet */
    double moving; /* of what of it moves the end */
    double share;  /* of that correction which is tried */
    int sharp;     /* the matrix is that of the best iterate */
} Progress;

/* The correction at x, with a new matrix where there is none that serves. */
static TinkerStatus find_correction(NewmarkStepper *self, const TinkerState *state, double h, double limit,
                                    double *size)
{
    *size = INFINITY;
    TinkerStatus status = find_residual(self, state, h, limit);
    if (status == TINKER_OK && !self->factored) status = factor(self, h, limit);
    if (status == TINKER_OK) status = solve(self, limit);
    if (status == TINKER_OK) *size = norm(self->system, self->correction);
    if (!tinker_is_constrained(self->system)) self->moving = *size;
    return status;
}

/* Makes x the best iterate, and goes on from it. */
static void advance(NewmarkStepper *self, Progress *progress, double size, int sharp)
{
    double *correction = self->correction;
    self->correction = self->descent;
    self->descent = correction;
    tinker_copy(self->system->size, self->x, self->base);
    *progress = (Progress){size, self->moving, 1.0, sharp};
    descend(self, 1.0);
}

/* Goes back to the best iterate: for a new matrix, or else for a shorter way. Returns 0 where neither is left. */
static int retreat(NewmarkStepper *self, Progress *progress)
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

/* Whether what moves the end got smaller though the whole did not: near a singular place rounding of places alone makes
 * much of what the rows say of accelerations, which the end does not depend on. */
static int only_forces_differ(const NewmarkStepper *self, const Progress *progress)
{
    return tinker_is_constrained(self->system) && isfinite(progress->size) &&
           self->moving < TINKER_SLOW_NEWTON * progress->moving;
}

TinkerStatus newmark_find_acceleration(NewmarkStepper *self, const TinkerState *state, double h, double limit)
{
    Progress progress = {INFINITY, INFINITY, 1.0, 0};
    int by_motion = 0;
    tinker_copy(self->system->size, self->a, self->x);
    for (int iteration = 0; iteration < NEWTON_CAP; iteration++) {
        int sharp = !self->factored;
        double size;
        TinkerStatus status = find_correction(self, state, h, limit, &size);
        int first = !isfinite(progress.size);
        if (by_motion && status == TINKER_OK) size = self->moving;
        if (status == TINKER_OK && !(size < progress.size) && only_forces_differ(self, &progress)) {
            by_motion = 1;
            progress.size = progress.moving;
            size = self->moving;
        }
        double gain = first ? 1.0 : size / progress.size;
        Rounding noise = rounding(self, h);
        if (status != TINKER_OK || !(size < progress.size)) {
            /* what is left over may be rounding of large, balanced forces */
            if (progress.sharp && progress.size < 1e4 * noise.most) return place(self, state, h, limit);
            if (!retreat(self, &progress)) return TINKER_RETRY_SMALLER;
            continue;
        }
        advance(self, &progress, size, sharp);
        if (self->linear || is_nothing(size, gain, noise.most)) {
            if (!self->linear && noise.adds_up && !is_nothing(self->moving, gain, noise.least)) self->factored = 0;
            return place(self, state, h, limit);
        }
        if (!first && gain > TINKER_SLOW_NEWTON) self->factored = 0;
    }
    return TINKER_RETRY_SMALLER;
}
