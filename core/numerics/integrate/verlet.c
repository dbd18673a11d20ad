/* Velocity Verlet (kick, drift, kick), with rods RATTLE, and a symmetric form of it for velocity-dependent forces:
 * verlet-step.h, a step a step. */
#include <glib.h>

#include "numerics/integrate/hermite.h"
#include "numerics/integrate/stepping.h"
#include "numerics/integrate/verlet-step.h"

typedef struct Stepper {
    TinkerVerlet verlet;
    TinkerHermite dense;
    double memory[];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    size_t doubles = tinker_hermite_doubles(system->size, system->books) + tinker_verlet_doubles(system);
    Stepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    double *next = stepper->memory;
    tinker_hermite_init(&stepper->dense, system, &next);
    tinker_verlet_init(&stepper->verlet, system, 0, &next);
    return stepper;
}

static void restart(void *data)
{
    Stepper *stepper = data;
    stepper->verlet.carried = 0;
    tinker_hermite_forget(&stepper->dense);
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;
    TinkerHermite *dense = &stepper->dense;
    tinker_hermite_start(dense, state);
    status = tinker_verlet_advance(&stepper->verlet, state, report->step, limit, dense->from.q, dense->from.v);
    if (status != TINKER_OK) {
        tinker_hermite_restore(dense, state);
        return tinker_fixed_step_fail(stepper->verlet.system, report);
    }
    tinker_hermite_finish(dense, state);
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
