/* Newton's method with conjugate gradients for the implicit half kick; with conjugate residuals where forces act across
 * the velocity.
 *
 * All norms are mass-weighted, so that lengths and angles can stand side by side. Linear damping takes one Newton step,
 * as the linear solves go down to rounding. */
#include "numerics/integrate/damping.h"

#include <float.h>

#include "numerics/integrate/stepping.h"
#include "numerics/integrate/tolerances.h"

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

/* product = (1 - h P D) x. */
static TinkerStatus apply_operator(TinkerDampingSolver *solver, double t, double h, const double *q, const double *v,
                                   const double *x, double *product)
{
    const TinkerSystem *system = solver->system;
    TinkerStatus status = system->damping_product(system->context, t, q, v, x, product);
    if (status == TINKER_OK) status = project(system, t, q, product);
    for (int32_t i = 0; status == TINKER_OK && i < system->size; i++)
        product[i] = x[i] - h * product[i];
    return status;
}

/* Begins a solve: nothing found yet, and the residual over its greatest entry (see norm), which is answered, is left.
 */
static double begin_correction(TinkerDampingSolver *solver)
{
    int32_t n = solver->system->size;
    double scale = greatest(n, solver->residual);
    for (int32_t i = 0; i < n; i++) {
        solver->left[i] = solver->direction[i] = scale > 0.0 ? solver->residual[i] / scale : 0.0;
        solver->correction[i] = 0.0;
    }
    return scale;
}

static void end_correction(TinkerDampingSolver *solver, double scale)
{
    for (int32_t i = 0; i < solver->system->size; i++)
        solver->correction[i] *= scale;
}

/* p0 . A p1 = p1 . A p0 to rounding, of the first two directions. Of forces across the velocity it is not. */
static int is_symmetric(const TinkerDampingSolver *solver)
{
    const TinkerSystem *system = solver->system;
    const double *p0 = solver->directions, *a0 = solver->images, *p1 = solver->direction, *a1 = solver->product;
    double there = 0.0, back = 0.0, p0_square = 0.0, a0_square = 0.0, p1_square = 0.0, a1_square = 0.0;
    // Side by side, so that no sum waits for another.
    for (int32_t i = 0; i < system->size; i++) {
        double mass = system->mass[i];
        there += mass * p0[i] * a1[i];
        back += mass * p1[i] * a0[i];
        p0_square += mass * p0[i] * p0[i];
        a0_square += mass * a0[i] * a0[i];
        p1_square += mass * p1[i] * p1[i];
        a1_square += mass * a1[i] * a1[i];
    }
    double most = sqrt(fmax(p0_square * a1_square, p1_square * a0_square));
    return !(fabs(there - back) > TINKER_SYMMETRIC_DAMPING * most);
}

/* A direction from the residual and its product, so that its image is at a right angle to those of the `*kept` before;
 * where these span all there is, they are forgotten. Answers the image's square. */
static double find_direction(TinkerDampingSolver *solver, int *kept)
{
    const TinkerSystem *system = solver->system;
    int32_t n = system->size;
    double *p = solver->direction, *image = solver->product, whole = dot(system, image, image);
    tinker_copy(n, solver->left, p);
    for (int k = 1; k < TINKER_KEPT_DIRECTIONS && k <= *kept; k++) {
        size_t other = (size_t)((*kept - k) % TINKER_KEPT_DIRECTIONS) * (size_t)n;
        const double *before = solver->images + other, *along = solver->directions + other;
        double square = dot(system, before, before), share = square > 0.0 ? dot(system, image, before) / square : 0.0;
        for (int32_t i = 0; i < n; i++) {
            image[i] -= share * before[i];
            p[i] -= share * along[i];
        }
    }
    double across = dot(system, image, image);
    if (*kept > 0 && !(across > TINKER_SPANNED * whole)) {
        *kept = 0;
        return 0.0;
    }
    size_t slot = (size_t)(*kept % TINKER_KEPT_DIRECTIONS) * (size_t)n;
    tinker_copy(n, p, solver->directions + slot);
    tinker_copy(n, image, solver->images + slot);
    ++*kept;
    return across;
}

/* Conjugate residuals, each direction made so to those before (ORTHOMIN): for an operator that is not symmetric. The
 * residual falls at every iteration while x . A x > 0: S. C. Eisenstat, H. C. Elman, M. H. Schultz, SIAM Journal on
 * Numerical Analysis 20 (1983) 345-357. Forces across the velocity alone make it 1 + an antisymmetric part, for which
 * one direction before is as good as all: V. Faber, T. Manteuffel, likewise 21 (1984) 352-362. */
static TinkerStatus find_correction_without_symmetry(TinkerDampingSolver *solver, double t, double h, const double *q,
                                                     const double *v)
{
    const TinkerSystem *system = solver->system;
    double *x = solver->correction, *r = solver->left, scale = begin_correction(solver);
    double square = dot(system, r, r), goal = square * DBL_EPSILON * DBL_EPSILON;
    int kept = 0;
    for (int iteration = 0; iteration < GRADIENT_CAP && square > goal; iteration++) {
        TinkerStatus status = apply_operator(solver, t, h, q, v, r, solver->product);
        if (status != TINKER_OK) return status;
        if (!(dot(system, r, solver->product) > 0.0)) {
            if (iteration == 0) tinker_copy(system->size, r, x);
            break;
        }
        double across = find_direction(solver, &kept), before = square;
        if (!(across > 0.0)) continue;
        double length = dot(system, r, solver->product) / across;
        for (int32_t i = 0; i < system->size; i++) {
            x[i] += length * solver->direction[i];
            r[i] -= length * solver->product[i];
        }
        square = dot(system, r, r);
        if (!(square < before)) break; /* rounding */
    }
    end_correction(solver, scale);
    return TINKER_OK;
}

/* Solves (1 - h P D) correction = residual. Where the operator turns out not to be positive definite it stops with what
 * it has, which is at least the residual itself: Newton's check decides what that is worth. */
static TinkerStatus find_correction(TinkerDampingSolver *solver, double t, double h, const double *q, const double *v)
{
    const TinkerSystem *system = solver->system;
    int32_t n = system->size;
    double *x = solver->correction, *r = solver->left, *p = solver->direction, *product = solver->product;
    double scale = begin_correction(solver);
    double square = dot(system, r, r), goal = square * DBL_EPSILON * DBL_EPSILON;
    for (int iteration = 0; iteration < GRADIENT_CAP && square > goal; iteration++) {
        TinkerStatus status = apply_operator(solver, t, h, q, v, p, product);
        if (status != TINKER_OK) return status;
        if (iteration == 1 && !is_symmetric(solver)) return find_correction_without_symmetry(solver, t, h, q, v);
        double curvature = dot(system, p, product);
        if (!(curvature > 0.0)) {
            if (iteration == 0) tinker_copy(n, r, x);
            break;
        }
        if (iteration == 0) {
            tinker_copy(n, p, solver->directions);
            tinker_copy(n, product, solver->images);
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
    end_correction(solver, scale);
    return TINKER_OK;
}

size_t tinker_damping_doubles(int32_t n)
{
    return (8 + 2 * TINKER_KEPT_DIRECTIONS) * (size_t)n;
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
    solver->directions = tinker_take(next, TINKER_KEPT_DIRECTIONS * n);
    solver->images = tinker_take(next, TINKER_KEPT_DIRECTIONS * n);
}

/* What forces that cancel leave at rest: their rounding, beside which neither velocities nor accelerations have a size.
 */
static double rest_noise(const TinkerSystem *system, const double *q, const double *v)
{
    double extent, speed, mass = 0.0;
    system->scales(system->context, q, v, &extent, &speed);
    for (int32_t i = 0; i < system->size; i++)
        mass += system->mass[i];
    return TINKER_DAMPED_REST * speed * sqrt(mass);
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
        } else if (best <= rest_noise(system, q, v)) {
            // No share of the correction makes it better; the power is that at `v` again.
            return find_residual(solver, t, h, q, v, power, &rounding);
        } else {
            share *= 0.5;
        }
        for (int32_t i = 0; i < n; i++)
            solver->trial[i] = v[i] + share * solver->correction[i];
    }
    return TINKER_RETRY_SMALLER;
}
