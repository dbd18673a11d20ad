/* The method of Dormand and Prince of order 5 with an embedded one of order 4 and Hairer's dense output of order 4. Its
 * last stage is the next step's first. */
#include "numerics/integrate/explicit-rk.h"
#include "numerics/integrate/stepping.h"

static const double c[TINKER_RK_STAGES_CAP] = {0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0};

static const double a[TINKER_RK_STAGES_CAP][TINKER_RK_STAGES_CAP] = {
    [1] = {1.0 / 5.0},
    [2] = {3.0 / 40.0, 9.0 / 40.0},
    [3] = {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
    [4] = {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
    [5] = {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
    [6] = {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
};

static const double d[1][TINKER_RK_STAGES_CAP] = {{
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
}};

/* b minus the weights of order 4 */
static const double error[TINKER_RK_STAGES_CAP] = {
    71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0,
};

const TinkerTableau tinker_tableau_dopri5 = {
    .order = 5,
    .stages = 6,
    .extra_stages = 0,
    .dense_rows = 1,
    .c = c,
    .a = a,
    .d = d,
    .error = error,
    .law = {.exponent = 0.2 - 0.75 * 0.04, .memory = 0.04, .least_factor = 0.2, .greatest_factor = 10.0},
};

static void *create(const TinkerSystem *system, const TinkerIntegratorOptions *options)
{
    return tinker_explicit_rk_create(&tinker_tableau_dopri5, system, options);
}

/* R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 + z^5/120 + z^6/600; the limits are where |R(iy)| and |R(-x)| first pass 1. */
const TinkerIntegrator tinker_integrator_dopri5 = {
    .struct_size = sizeof(TinkerIntegrator),
    .flags = TINKER_INTEGRATOR_ADAPTIVE | TINKER_INTEGRATOR_EXPLICIT,
    .id = "dopri5",
    .title = "Dormand-Prince 5(4), adaptive",
    .summary = "Loose tolerances: short steps that follow what changes quickly.",
    .source = "J. R. Dormand, P. J. Prince, Journal of Computational and Applied Mathematics 6 (1980) 19-26; dense "
              "output: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.6",
    .order = 5,
    .dense_order = 4,
    .evaluations_per_step = 6,
    .imaginary_limit = 0.99718900863253,
    .real_limit = 3.306567892634946,
    .create = create,
    .destroy = tinker_explicit_rk_destroy,
    .restart = tinker_explicit_rk_restart,
    .step = tinker_explicit_rk_step,
    .interpolate = tinker_explicit_rk_interpolate,
};
