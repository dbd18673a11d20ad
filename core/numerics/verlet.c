/* Velocity Verlet (kick, drift, kick), with rods RATTLE, and a symmetric form of it for velocity-dependent forces.
 *
 * With a(t, q, v) the applied acceleration and P the projection onto the tangent space J v = 0 a step is
 *
 *     v <- v + h/2 P a(t0, q0, v)       implicit in v: damping.h; explicit where a does not depend on v
 *     q <- q + h v                      with rods both corrected along J(q0)^T so that g(q, t1) = 0
 *     v projected onto J v + dg/dt = 0 at the new place
 *     v <- v + h/2 P a(t1, q1, v)       explicit
 *
 * The explicit half is the adjoint of the implicit one, so the whole is symmetric and of order 2. Which comes first
 * matters for stiff dampers: this way round the drift sees the damped velocity. Between two steps the explicit and the
 * implicit half join to the trapezoidal rule, whose factor (1 - z) / (1 + z), z = hc/2m, never exceeds 1 in size; for
 * x'' = -omega^2 x - c/m x' the step has determinant (1 - z) / (1 + z) and is stable for h omega <= 2 whatever c is. A
 * velocity that forces and dampers hold in balance is met exactly. What is not so held, a first velocity against a
 * damper with z >> 1, dies in slow alternation, as with the trapezoidal rule.
 *
 * Books follow by the trapezoidal rule. Damped, the powers are those after the implicit and before the explicit half:
 * either is off by order h, and the two cancel. Undamped, the velocity at the end is extrapolated from the start over
 * the middle, so that one evaluation gives force and power.
 */
#include <glib.h>

#include "numerics/damping.h"
#include "numerics/hermite.h"
#include "numerics/integrator-private.h"

typedef struct Stepper {
    const TinkerSystem *system;
    TinkerHermite dense;
    TinkerDampingSolver damping;
    int damped;
    int carried; /* `a` and `power_from` of an undamped system belong to the present state */
    double *a;
    double *ahead; /* the extrapolated velocity */
    double *power_from, *power_to;
    double memory[];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    size_t n = (size_t)system->size, m = (size_t)system->books;
    int damped = (system->flags & TINKER_SYSTEM_VELOCITY_DEPENDENT) != 0;
    size_t doubles = tinker_hermite_doubles(system->size, system->books) + 2 * n + 2 * m;
    if (damped) doubles += tinker_damping_doubles(system->size);
    Stepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    double *next = stepper->memory;
    stepper->system = system;
    stepper->damped = damped;
    tinker_hermite_init(&stepper->dense, system, &next);
    if (damped) tinker_damping_init(&stepper->damping, system, &next);
    stepper->a = tinker_take(&next, n);
    stepper->ahead = tinker_take(&next, n);
    stepper->power_from = tinker_take(&next, m);
    stepper->power_to = tinker_take(&next, m);
    return stepper;
}

static void restart(void *data)
{
    Stepper *stepper = data;
    stepper->carried = 0;
    tinker_hermite_forget(&stepper->dense);
}

static TinkerStatus find_force(Stepper *stepper, const TinkerState *state, const double *v, double *power)
{
    const TinkerSystem *system = stepper->system;
    return system->applied(system->context, state->t, state->q, v, stepper->a, system->books > 0 ? power : NULL);
}

static void kick(int32_t n, double half, const double *restrict a, double *restrict v)
{
    for (int32_t i = 0; i < n; i++)
        v[i] += half * a[i];
}

static TinkerStatus first_kick(Stepper *stepper, TinkerState *state, double half)
{
    const TinkerSystem *system = stepper->system;
    double *power = system->books > 0 ? stepper->power_from : NULL;
    if (stepper->damped) return tinker_damping_half_step(&stepper->damping, state->t, half, state->q, state->v, power);
    TinkerStatus status = TINKER_OK;
    if (!stepper->carried) status = find_force(stepper, state, state->v, power);
    if (status == TINKER_OK) kick(system->size, half, stepper->a, state->v);
    return status;
}

static TinkerStatus drift(Stepper *stepper, TinkerState *state, double h, double limit)
{
    const TinkerSystem *system = stepper->system;
    const double *restrict v = state->v;
    double *restrict q = state->q, from = state->t;
    for (int32_t i = 0; i < system->size; i++)
        q[i] += h * v[i];
    state->t = limit;
    if (!tinker_is_constrained(system)) return TINKER_OK;
    return system->constrain_step(system->context, from, stepper->dense.from.q, limit, h, state->q, state->v);
}

/* The explicit half kick of a system with damping: force and power at the velocity on the tangent space. */
static TinkerStatus last_kick_damped(Stepper *stepper, TinkerState *state, double half)
{
    const TinkerSystem *system = stepper->system;
    int constrained = tinker_is_constrained(system);
    TinkerStatus status = TINKER_OK;
    if (constrained) status = system->project_velocity(system->context, state->t, state->q, state->v, 0);
    if (status == TINKER_OK) status = find_force(stepper, state, state->v, stepper->power_to);
    if (status == TINKER_OK && constrained)
        status = system->project_velocity(system->context, state->t, state->q, stepper->a, 1);
    if (status == TINKER_OK) kick(system->size, half, stepper->a, state->v);
    return status;
}

/* That of one without: nothing but the power depends on the velocity, and one projection is enough. */
static TinkerStatus last_kick(Stepper *stepper, TinkerState *state, double half)
{
    const TinkerSystem *system = stepper->system;
    const double *v = state->v;
    if (system->books > 0) {
        for (int32_t i = 0; i < system->size; i++)
            stepper->ahead[i] = 2.0 * state->v[i] - stepper->dense.from.v[i];
        v = stepper->ahead;
    }
    TinkerStatus status = find_force(stepper, state, v, stepper->power_to);
    if (status == TINKER_OK) kick(system->size, half, stepper->a, state->v);
    if (status == TINKER_OK && tinker_is_constrained(system))
        status = system->project_velocity(system->context, state->t, state->q, state->v, 0);
    return status;
}

static TinkerStatus advance(Stepper *stepper, TinkerState *state, double h, double limit)
{
    TinkerStatus status = first_kick(stepper, state, 0.5 * h);
    if (status == TINKER_OK) status = drift(stepper, state, h, limit);
    if (status != TINKER_OK) return status;
    return stepper->damped ? last_kick_damped(stepper, state, 0.5 * h) : last_kick(stepper, state, 0.5 * h);
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;
    double h = report->step;
    tinker_hermite_start(&stepper->dense, state);
    status = advance(stepper, state, h, limit);
    if (status != TINKER_OK) {
        tinker_hermite_restore(&stepper->dense, state);
        stepper->carried = 0;
        return tinker_fixed_step_fail(stepper->system, report);
    }
    for (int32_t i = 0; i < stepper->system->books; i++)
        state->books[i] += 0.5 * h * (stepper->power_from[i] + stepper->power_to[i]);
    double *power = stepper->power_from;
    stepper->power_from = stepper->power_to;
    stepper->power_to = power;
    stepper->carried = 1;
    tinker_hermite_finish(&stepper->dense, state);
    return TINKER_OK;
}

static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *stepper = data;
    return tinker_hermite_interpolate(&stepper->dense, t, q, v, books);
}

const TinkerIntegrator tinker_integrator_verlet = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT | TINKER_INTEGRATOR_SYMPLECTIC,
    .id = "verlet",
    .title = "Velocity Verlet, order 2; RATTLE with rods",
    .summary = "Long undamped runs: symplectic, so the energy error stays bounded; damping is treated implicitly.",
    .source = "H. C. Andersen, Journal of Computational Physics 52 (1983) 24-34; damping by symmetric composition: "
              "E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., II.4, II.5, Springer 2006",
    .order = 2,
    .dense_order = 2,
    .evaluations_per_step = 1,
    .imaginary_limit = 2.0,
    .real_limit = -1.0,
    .create = create,
    .destroy = g_free,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
