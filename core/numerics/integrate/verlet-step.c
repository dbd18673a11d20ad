/* Kick, drift, kick. */
#include "numerics/integrate/verlet-step.h"

#include "numerics/integrate/stepping.h"

static int is_damped(const TinkerSystem *system)
{
    return (system->flags & TINKER_SYSTEM_VELOCITY_DEPENDENT) != 0;
}

static TinkerStatus find_force(TinkerVerlet *verlet, const TinkerState *state, const double *v, double *power)
{
    const TinkerSystem *system = verlet->system;
    return system->applied(system->context, state->t, state->q, v, verlet->a, system->books > 0 ? power : NULL);
}

static void kick(int32_t n, double half, const double *restrict a, double *restrict v)
{
    for (int32_t i = 0; i < n; i++)
        v[i] += half * a[i];
}

static TinkerStatus first_kick(TinkerVerlet *verlet, TinkerState *state, double half)
{
    const TinkerSystem *system = verlet->system;
    double *power = system->books > 0 ? verlet->power_from : NULL;
    if (verlet->damped) return tinker_damping_half_step(&verlet->damping, state->t, half, state->q, state->v, power);
    TinkerStatus status = TINKER_OK;
    if (!verlet->carried) status = find_force(verlet, state, state->v, power);
    if (status == TINKER_OK) kick(system->size, half, verlet->a, state->v);
    return status;
}

static TinkerStatus drift(const TinkerVerlet *verlet, TinkerState *state, double h, double limit, const double *q_from)
{
    const TinkerSystem *system = verlet->system;
    const double *restrict v = state->v;
    double *restrict q = state->q, from = state->t;
    for (int32_t i = 0; i < system->size; i++)
        q[i] += h * v[i];
    state->t = limit;
    if (!tinker_is_constrained(system)) return TINKER_OK;
    return system->constrain_step(system->context, from, q_from, limit, h, state->q, state->v);
}

/* The explicit half kick of a system with damping: force and power at the velocity on the tangent space. */
static TinkerStatus last_kick_damped(TinkerVerlet *verlet, TinkerState *state, double half)
{
    const TinkerSystem *system = verlet->system;
    int constrained = tinker_is_constrained(system);
    TinkerStatus status = TINKER_OK;
    if (constrained) status = system->project_velocity(system->context, state->t, state->q, state->v, 0);
    if (status == TINKER_OK) status = find_force(verlet, state, state->v, verlet->power_to);
    if (status == TINKER_OK && constrained)
        status = system->project_velocity(system->context, state->t, state->q, verlet->a, 1);
    if (status == TINKER_OK) kick(system->size, half, verlet->a, state->v);
    return status;
}

/* That of one without: nothing but the power depends on the velocity, and one projection is enough. */
static TinkerStatus last_kick(TinkerVerlet *verlet, TinkerState *state, double half, const double *v_from)
{
    const TinkerSystem *system = verlet->system;
    const double *v = state->v;
    int extrapolated = system->books > 0 && !verlet->symmetric_books;
    if (extrapolated) {
        for (int32_t i = 0; i < system->size; i++)
            verlet->ahead[i] = 2.0 * state->v[i] - v_from[i];
        v = verlet->ahead;
    }
    TinkerStatus status = find_force(verlet, state, v, extrapolated ? verlet->power_to : NULL);
    if (status == TINKER_OK) kick(system->size, half, verlet->a, state->v);
    if (status == TINKER_OK && tinker_is_constrained(system))
        status = system->project_velocity(system->context, state->t, state->q, state->v, 0);
    if (status == TINKER_OK && system->books > 0 && verlet->symmetric_books)
        status = find_force(verlet, state, state->v, verlet->power_to);
    return status;
}

static TinkerStatus kick_drift_kick(TinkerVerlet *verlet, TinkerState *state, double h, double limit,
                                    const double *q_from, const double *v_from)
{
    TinkerStatus status = first_kick(verlet, state, 0.5 * h);
    if (status == TINKER_OK) status = drift(verlet, state, h, limit, q_from);
    if (status != TINKER_OK) return status;
    return verlet->damped ? last_kick_damped(verlet, state, 0.5 * h) : last_kick(verlet, state, 0.5 * h, v_from);
}

size_t tinker_verlet_doubles(const TinkerSystem *system)
{
    size_t own = 2 * (size_t)system->size + 2 * (size_t)system->books;
    return own + (is_damped(system) ? tinker_damping_doubles(system->size) : 0);
}

void tinker_verlet_init(TinkerVerlet *verlet, const TinkerSystem *system, int symmetric_books, double **next)
{
    *verlet = (TinkerVerlet){.system = system, .damped = is_damped(system), .symmetric_books = symmetric_books};
    if (verlet->damped) tinker_damping_init(&verlet->damping, system, next);
    verlet->a = tinker_take(next, (size_t)system->size);
    verlet->ahead = tinker_take(next, (size_t)system->size);
    verlet->power_from = tinker_take(next, (size_t)system->books);
    verlet->power_to = tinker_take(next, (size_t)system->books);
}

TinkerStatus tinker_verlet_advance(TinkerVerlet *verlet, TinkerState *state, double h, double limit,
                                   const double *q_from, const double *v_from)
{
    TinkerStatus status = kick_drift_kick(verlet, state, h, limit, q_from, v_from);
    verlet->carried = status == TINKER_OK;
    if (status != TINKER_OK) return status;
    for (int32_t i = 0; i < verlet->system->books; i++)
        state->books[i] += 0.5 * h * (verlet->power_from[i] + verlet->power_to[i]);
    double *power = verlet->power_from;
    verlet->power_from = verlet->power_to;
    verlet->power_to = power;
    return TINKER_OK;
}
