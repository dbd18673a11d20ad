/* Kutta's method of order 4 with an embedded one of order 3, for steps that are far shorter than a method of higher
 * order makes by itself: to an event that is to come soon, or to a break. There its few stages are as accurate.
 *
 * The embedded weights are (1/6, 1/3, 1/3, 0, 1/6): the last stage gives way to the acceleration at the new point,
 * which meets all conditions of order 3 (sum b = 1, sum b c = 1/2, sum b c^2 = 1/3, sum b A c = 1/6). That is the next
 * step's first stage, too, and dense output is the cubic through both ends. Source: E. Hairer, S. P. Norsett,
 * G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.1, II.4. */
#include "numerics/integrate/explicit-rk.h"

static const double c[TINKER_RK_STAGES_CAP] = {0.0, 0.5, 0.5, 1.0, 1.0};

static const double a[TINKER_RK_STAGES_CAP][TINKER_RK_STAGES_CAP] = {
    [1] = {0.5},
    [2] = {0.0, 0.5},
    [3] = {0.0, 0.0, 1.0},
    [4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0},
};

/* b minus the weights of order 3 */
static const double error[TINKER_RK_STAGES_CAP] = {[3] = 1.0 / 6.0, [4] = -1.0 / 6.0};

/* Under a force of time alone both methods are Simpson's rule, and differ by nothing. The cubic is off by up to h^4 /
 * 384 times the third derivative of a, of velocities; h (a0 - 2 a(h/2) + a1) / 96, which is h^3 / 384 times the second
 * one, is no less as long as that changes by no more than itself within the step. Of places it is h^3 a' / 384
 * likewise. */
static const double dense_error[TINKER_RK_STAGES_CAP] = {1.0 / 96.0, -1.0 / 96.0, -1.0 / 96.0, 1.0 / 96.0};

const TinkerTableau tinker_tableau_kutta = {
    .order = 4,
    .stages = 4,
    .extra_stages = 0,
    .dense_rows = 0,
    .c = c,
    .a = a,
    .error = error,
    .dense_error = dense_error,
    .law = {.exponent = 1.0 / 3.0, .memory = 0.0, .least_factor = 0.2, .greatest_factor = 5.0},
};
