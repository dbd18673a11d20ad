/* Newton's method with conjugate gradients for the implicit half kick.
 *
 * All norms are mass-weighted, so that lengths and angles can stand side by side. Linear damping takes one Newton step,
 * as the linear solves go down to rounding. */
#include "numerics/damping.h"

#include <float.h>

#include "numerics/integrator-private.h"

#define NEWTON_CAP   30  /* a smooth law takes 2 to 5 */
#define GRADIENT_CAP 500 /* converges in sqrt(condition) iterations, at most n without rounding */

static double dot(const TinkerSystem *system, const double *x, const double *y)
{
    double sum = 0.0;
    for (int32_t i = 0; i < system->size; i++)
        sum += system->mass[i] * x[i] * y[i];
    return sum;
}

static double greatest(int32_t n, const double *x)
{
    double most = 0.0;
    for (int32_t i = 0; i < n; i++)
        most = fmax(most, fabs(x[i]));
    return most;
}

/* Of x over its greatest entry, so that the squares of a motion that has died away do not vanish. */
static double norm(const TinkerSystem *system, const double *x)
{
    double scale = greatest(system->size, x), sum = 0.0;
    if (!(scale > 0.0) || !isfinite(scale)) return scale;
    for (int32_t i = 0; i < system->size; i++)
        sum += system->mass[i] * (x[i] / scale) * (x[i] / scale);
    return scale * sqrt(sum);
}

static TinkerStatus project(const TinkerSystem *system, double t, const double *q, double *v)
{
    if (!tinker_is_constrained(system)) return TINKER_OK;
    return system->project_velocity(system->context, t, q, v, 1);
}

/* residual = start - v + h P a(v). *rounding, what it cannot be expected to fall below, only grows: a stiff
 * damper's v1 is the small difference of v0 and a correction that was rounded beside v0. */
static TinkerStatus find_residual(TinkerDampingSolver *solver, double t, double h, const double *q, const double *v,
                                  double *power, double *rounding)
{
    const TinkerSystem *system = solver->system;
    double *r = solver->residual;
    TinkerStatus status = system->applied(system->context, t, q, v, solver->acceleration, power);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < system->size; i++)
        r[i] = h * solver->acceleration[i];
    status = project(system, t, q, r);
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < system->size; i++)
        r[i] += solver->start[i] - v[i];
    double sum = norm(system, v) + norm(system, solver->start) + fabs(h) * norm(system, solver->acceleration);
    *rounding = fmax(*rounding, 64.0 * DBL_EPSILON * sum);
    return TINKER_OK;
}

/* Solves (1 - h P D) correction = residual, both over the residual's greatest entry (see norm). Where the operator turns out not to be positive definite it stops with what
 * it has, which is at least the residual itself: Newton's check decides what that is worth. */
static TinkerStatus find_correction(TinkerDampingSolver *solver, double t, double h, const double *q, const double *v)
{
    const TinkerSystem *system = solver->system;
    int32_t n = system->size;
    double *x = solver->correction, *r = solver->left, *p = solver->direction, *product = solver->product;
    double scale = greatest(n, solver->residual);
    for (int32_t i = 0; i < n; i++) {
        r[i] = p[i] = scale > 0.0 ? solver->residual[i] / scale : 0.0;
        x[i] = 0.0;
    }
    double square = dot(system, r, r), goal = square * DBL_EPSILON * DBL_EPSILON;
    for (int iteration = 0; iteration < GRADIENT_CAP && square > goal; iteration++) {
        TinkerStatus status = system->damping_product(system->context, t, q, v, p, product);
        if (status == TINKER_OK) status = project(system, t, q, product);
        if (status != TINKER_OK) return status;
        for (int32_t i = 0; i < n; i++)
            product[i] = p[i] - h * product[i];
        double curvature = dot(system, p, product);
        if (!(curvature > 0.0)) {
            if (iteration == 0) tinker_copy(n, r, x);
            break;
        }
        double length = square / curvature, before = square;
        for (int32_t i = 0; i < n; i++) {
            x[i] += length * p[i];
            r[i] -= length * product[i];
        }
        square = dot(system, r, r);
        for (int32_t i = 0; i < n; i++)
            p[i] = r[i] + square / before * p[i];
    }
    for (int32_t i = 0; i < n; i++)
        x[i] *= scale;
    return TINKER_OK;
}

size_t tinker_damping_doubles(int32_t n)
{
    return 8 * (size_t)n;
}

void tinker_damping_init(TinkerDampingSolver *solver, const TinkerSystem *system, double **next)
{
    size_t n = (size_t)system->size;
    solver->system = system;
    solver->start = tinker_take(next, n);
    solver->trial = tinker_take(next, n);
    solver->acceleration = tinker_take(next, n);
    solver->residual = tinker_take(next, n);
    solver->correction = tinker_take(next, n);
    solver->left = tinker_take(next, n);
    solver->direction = tinker_take(next, n);
    solver->product = tinker_take(next, n);
}

TinkerStatus tinker_damping_half_step(TinkerDampingSolver *solver, double t, double h, const double *q, double *v,
                                      double *power)
{
    const TinkerSystem *system = solver->system;
    int32_t n = system->size;
    double best = INFINITY, share = 1.0, rounding = 0.0;
    tinker_copy(n, v, solver->start);
    tinker_copy(n, v, solver->trial);
    for (int iteration = 0; iteration < NEWTON_CAP; iteration++) {
        TinkerStatus status = find_residual(solver, t, h, q, solver->trial, power, &rounding);
        if (status != TINKER_OK) return status;
        double size = norm(system, solver->residual);
        if (size <= rounding) {
            tinker_copy(n, solver->trial, v);
            return TINKER_OK;
        }
        /* a step that made things worse is cut in half; `v` is where it began */
        if (size < best) {
            best = size;
            share = 1.0;
            tinker_copy(n, solver->trial, v);
            status = find_correction(solver, t, h, q, v);
            if (status != TINKER_OK) return status;
        } else {
            share *= 0.5;
        }
        for (int32_t i = 0; i < n; i++)
            solver->trial[i] = v[i] + share * solver->correction[i];
    }
    return TINKER_RETRY_SMALLER;
}
