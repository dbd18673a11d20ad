/* A symmetric composition of nine steps of Verlet (verlet-step.h), some of them backwards in time.
 *
 * The step of Verlet is symmetric in q, v and the books, with rods and with damping too, so the conditions of order 6
 * for symmetric compositions of symmetric steps hold: sum g = 1, sum g^3 = 0, sum g^5 = 0 and one condition more. Each
 * step lands on the rods, so the whole does.
 *
 * Between the ends q is the quintic of hermite.h. For v and the books that would lose two orders, so accelerations and
 * powers are worked out at the thirds of the step as well, at places and velocities from the quintic, when somebody
 * asks. The cubic through the four slopes, with as much of the quartic that vanishes at their four times as makes the
 * integral meet the end, is integrated: errors of h^6.
 */
#include <glib.h>

#include "numerics/integrate/hermite.h"
#include "numerics/integrate/stepping.h"
#include "numerics/integrate/verlet-step.h"

#define SUBSTEPS 9

static const double substeps[SUBSTEPS] = {
    0.39216144400731413928,  0.33259913678935943860, -0.70624617255763935981,
    0.082213596293550800231, 0.79854399093482996340, 0.082213596293550800231,
    -0.70624617255763935981, 0.33259913678935943860, 0.39216144400731413928,
};

typedef struct Stepper {
    const TinkerSystem *system;
    TinkerVerlet verlet;
    TinkerHermite dense;
    double *q_from, *v_from; /* where a substep begins */
    int inner_known;
    double *inner_a[2], *inner_power[2]; /* at a third and two thirds */
    double *inner_q, *inner_v;
    double memory[];
} Stepper;

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    size_t n = (size_t)system->size, m = (size_t)system->books;
    size_t doubles =
        tinker_hermite_doubles(system->size, system->books) + tinker_verlet_doubles(system) + 6 * n + 2 * m;
    Stepper *stepper = g_try_malloc0(sizeof *stepper + doubles * sizeof(double));
    if (!stepper) return NULL;
    double *next = stepper->memory;
    stepper->system = system;
    tinker_hermite_init(&stepper->dense, system, &next);
    tinker_verlet_init(&stepper->verlet, system, 1, &next);
    stepper->q_from = tinker_take(&next, n);
    stepper->v_from = tinker_take(&next, n);
    stepper->inner_q = tinker_take(&next, n);
    stepper->inner_v = tinker_take(&next, n);
    for (int k = 0; k < 2; k++) {
        stepper->inner_a[k] = tinker_take(&next, n);
        stepper->inner_power[k] = tinker_take(&next, m);
    }
    return stepper;
}

static void restart(void *data)
{
    Stepper *stepper = data;
    stepper->verlet.carried = 0;
    stepper->inner_known = 0;
    tinker_hermite_forget(&stepper->dense);
}

static TinkerStatus compose(Stepper *stepper, TinkerState *state, double h, double limit)
{
    double from = state->t, passed = 0.0;
    TinkerStatus status = TINKER_OK;
    for (int i = 0; i < SUBSTEPS && status == TINKER_OK; i++) {
        passed += substeps[i];
        double to = i == SUBSTEPS - 1 ? limit : from + passed * h;
        if (tinker_is_constrained(stepper->system)) tinker_copy(stepper->system->size, state->q, stepper->q_from);
        status = tinker_verlet_advance(&stepper->verlet, state, substeps[i] * h, to, stepper->q_from, stepper->v_from);
    }
    return status;
}

static TinkerStatus step(void *data, TinkerState *state, double limit, TinkerStepReport *report)
{
    Stepper *stepper = data;
    TinkerStatus status = tinker_fixed_step_begin(state->t, limit, report);
    if (status != TINKER_OK) return status;
    stepper->inner_known = 0;
    tinker_hermite_start(&stepper->dense, state);
    status = compose(stepper, state, report->step, limit);
    if (status != TINKER_OK) {
        tinker_hermite_restore(&stepper->dense, state);
        return tinker_fixed_step_fail(stepper->system, report);
    }
    tinker_hermite_finish(&stepper->dense, state);
    return TINKER_OK;
}

/* Dense output --------------------------------------------------------------------------------------------------- */

static TinkerStatus find_inner_slopes(Stepper *stepper)
{
    const TinkerSystem *system = stepper->system;
    double from = stepper->dense.from.t, h = stepper->dense.to.t - from;
    TinkerStatus status = TINKER_OK;
    for (int k = 0; k < 2 && status == TINKER_OK && !stepper->inner_known; k++) {
        double t = from + h * (k + 1) / 3.0;
        status = tinker_hermite_place_and_rate(&stepper->dense, t, stepper->inner_q, stepper->inner_v);
        if (status == TINKER_OK)
            status = system->acceleration(system->context, t, stepper->inner_q, stepper->inner_v, stepper->inner_a[k],
                                          system->books > 0 ? stepper->inner_power[k] : NULL);
    }
    stepper->inner_known = status == TINKER_OK;
    return status;
}

/* Integrals from 0 to s of the four cubics of Lagrange, and of s (s - 1/3) (s - 2/3) (s - 1), whose integral to 1 is
 * -1/270. */
static void integrals(double s, double weights[5])
{
    double square = s * s;
    weights[0] = s + square * (-2.75 + s * (3.0 - 1.125 * s));
    weights[1] = square * (4.5 + s * (-7.5 + 3.375 * s));
    weights[2] = square * (-2.25 + s * (6.0 - 3.375 * s));
    weights[3] = square * (0.5 + s * (-1.5 + 1.125 * s));
    weights[4] = square * (-1.0 / 9.0 + s * (11.0 / 27.0 + s * (-0.5 + 0.2 * s)));
}

static void integrate(int32_t count, double h, double s, const double *y0, const double *y1, const double *const f[4],
                      double *restrict y)
{
    double w[5];
    integrals(s, w);
    for (int32_t i = 0; i < count; i++) {
        double cubic = h * (f[0][i] + 3.0 * (f[1][i] + f[2][i]) + f[3][i]) / 8.0;
        double quartic = -270.0 * (y1[i] - y0[i] - cubic);
        y[i] = y0[i] + (h * (w[0] * f[0][i] + w[1] * f[1][i] + w[2] * f[2][i] + w[3] * f[3][i]) + w[4] * quartic);
    }
}

static TinkerStatus interpolate(void *data, double t, double *q, double *v, double *books)
{
    Stepper *stepper = data;
    const TinkerHermiteEnd *from = &stepper->dense.from, *to = &stepper->dense.to;
    TinkerStatus status = find_inner_slopes(stepper);
    if (status == TINKER_OK) status = tinker_hermite_interpolate(&stepper->dense, t, q, v, NULL);
    if (status != TINKER_OK) return status;
    double h = to->t - from->t, s = (t - from->t) / h;
    const double *a[] = {from->a, stepper->inner_a[0], stepper->inner_a[1], to->a};
    const double *power[] = {from->power, stepper->inner_power[0], stepper->inner_power[1], to->power};
    integrate(stepper->system->size, h, s, from->v, to->v, a, v);
    if (books) integrate(stepper->system->books, h, s, from->books, to->books, power, books);
    return TINKER_OK;
}

/* The limits are where the half trace of the nine maps of an undamped oscillator reaches -1, and where the product of
 * (1 - z) / (1 + z), z = g h c / 2m, does: a backward substep amplifies what a damper takes. */
const TinkerIntegrator tinker_integrator_verlet6 = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_EXPLICIT | TINKER_INTEGRATOR_SYMPLECTIC,
    .id = "verlet6",
    .title = "Composed Verlet, order 6; RATTLE with rods",
    .summary = "Long undamped runs at tight error, with rods too: symplectic, nine steps of Verlet in one.",
    .source =
        "W. Kahan, R.-C. Li, Mathematics of Computation 66 (1997) 1089-1099; coefficients as in E. Hairer, C. Lubich, "
        "G. Wanner, Geometric Numerical Integration, 2nd ed., V.3.2, Springer 2006",
    .order = 6,
    .dense_order = 5,
    .evaluations_per_step = SUBSTEPS,
    .imaginary_limit = 2.532627388334297,
    .real_limit = 2.7274875878803146,
    .create = create,
    .destroy = g_free,
    .restart = restart,
    .step = step,
    .interpolate = interpolate,
};
