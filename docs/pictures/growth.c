/* Growth by the program's own steps wherever a method can be stepped at a given length; of the adaptive Runge-Kutta
 * pairs, whose steps choose their length themselves, by their tableaus; of the backward differentiation formulas by
 * their characteristic polynomials. */
#include "growth.h"

#include <complex.h>
#include <math.h>
#include <string.h>

#include "numerics/integrate/explicit-rk.h"
#include "numerics/methods/integrators.h"
#include "numerics/stability/amplification.h"

#define MOST_ORDER 5
#define TEN_TURNS  (20 * G_PI)

const TinkerIntegrator *docs_integrator(const Method *method)
{
    return tinker_integrator_builtin(method->id);
}

/* The oscillator with step 1 at a place of a plane. */
static TinkerOscillator oscillator_at(const Method *method, double x, double y)
{
    if (method->plane == PLANE_OF_DAMPING) return (TinkerOscillator){x * x, y};
    return (TinkerOscillator){x * x + y * y, -2 * x};
}

static double map_growth(const Method *method, double x, double y)
{
    double map[4];
    if (!tinker_amplification(docs_integrator(method), 0, oscillator_at(method, x, y), 1.0, map)) return INFINITY;
    return tinker_map_growth(map);
}

static double map_error(const Method *method, double x, double y)
{
    double rate = method->plane == PLANE_OF_ROOTS ? hypot(x, y) : fmax(x, y);
    return tinker_step_error(docs_integrator(method), 0, oscillator_at(method, x, y), 1.0, TEN_TURNS / rate);
}

static double long_run_growth(const Method *method, double x, double y)
{
    return tinker_long_run_growth(docs_integrator(method), 0, oscillator_at(method, x, y), 1.0);
}

/* Runge-Kutta pairs ------------------------------------------------------------------------------------------------ */

/* What y' = lambda y is multiplied by at a step. */
static double complex tableau_factor(const Method *method, double complex z)
{
    const TinkerTableau *tableau = strcmp(method->id, "dopri5") == 0 ? &tinker_tableau_dopri5 : &tinker_tableau_dop853;
    double complex slope[TINKER_RK_STAGES_CAP], value = 1;
    for (int stage = 0; stage <= tableau->stages; stage++) {
        value = 1;
        for (int i = 0; i < stage; i++)
            value += tableau->a[stage][i] * slope[i];
        slope[stage] = z * value;
    }
    return value;
}

static double tableau_growth(const Method *method, double x, double y)
{
    return cabs(tableau_factor(method, x + I * y));
}

static double tableau_error(const Method *method, double x, double y)
{
    double complex factor = tableau_factor(method, x + I * y), made = 1;
    double worst = 0;
    for (int step = 1; step <= TEN_TURNS / hypot(x, y); step++) {
        made *= factor;
        worst = fmax(worst, cabs(made - cexp(step * (x + I * y))));
    }
    return worst;
}

/* Backward differentiation formulas -------------------------------------------------------------------------------- */

/* The formula applied to y' = z y: sum_k coefficient[k] y_(n - k) = 0, from sum_j (1 - shift)^j / j = z. */
static void bdf_coefficients(int order, double complex z, double complex *coefficient)
{
    double power[MOST_ORDER + 1] = {1};
    for (int k = 0; k <= order; k++)
        coefficient[k] = 0;
    for (int j = 1; j <= order; j++) {
        for (int k = j; k > 0; k--)
            power[k] -= power[k - 1];
        for (int k = 0; k <= j; k++)
            coefficient[k] += power[k] / j;
    }
    coefficient[0] -= z;
}

/* Whether all roots are within this radius: the test of Schur and Cohn, which lowers the degree by one at a time. */
static gboolean roots_are_within(const double complex *coefficient, int degree, double radius)
{
    double complex p[MOST_ORDER + 1], lower[MOST_ORDER + 1];
    for (int k = 0; k <= degree; k++)
        p[k] = coefficient[k] * pow(radius, degree - k);
    for (; degree > 0; degree--) {
        if (!(cabs(p[0]) > cabs(p[degree]))) return FALSE;
        for (int k = 0; k < degree; k++)
            lower[k] = conj(p[0]) * p[k] - p[degree] * conj(p[degree - k]);
        double size = cabs(lower[0]);
        for (int k = 0; k < degree; k++)
            p[k] = lower[k] / size;
    }
    return TRUE;
}

static double bdf_growth(const Method *method, double x, double y)
{
    double complex coefficient[MOST_ORDER + 1];
    double low = 0, high = 2;
    bdf_coefficients(method->order, x + I * y, coefficient);
    if (!roots_are_within(coefficient, method->order, high)) return high;
    for (int i = 0; i < 20; i++) {
        double middle = 0.5 * (low + high);
        if (roots_are_within(coefficient, method->order, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}

void docs_bdf_edge(int order, double angle, double *real, double *imaginary)
{
    double complex edge = 0, backward = 1 - cexp(-I * angle), power = 1;
    for (int j = 1; j <= order; j++) {
        power *= backward;
        edge += power / j;
    }
    *real = creal(edge);
    *imaginary = cimag(edge);
}

/* Everything else -------------------------------------------------------------------------------------------------- */

static double exact_growth(const Method *method, double x, double y)
{
    return exp(x);
}

double docs_error_of_ten_periods(const char *id, double steps_a_period)
{
    double step = 2 * G_PI / steps_a_period;
    return tinker_step_error(tinker_integrator_builtin(id), 0, (TinkerOscillator){1, 0}, step, TEN_TURNS);
}

double docs_undamped_growth(const char *id, double spectral_radius, double turn)
{
    return tinker_long_run_growth(tinker_integrator_builtin(id), spectral_radius, (TinkerOscillator){turn * turn, 0},
                                  1);
}

const Method docs_methods[] = {
    {"semi-implicit-euler", PLANE_OF_DAMPING, map_growth, NULL, 0},
    {"verlet", PLANE_OF_DAMPING, map_growth, map_error, 0},
    {"verlet6", PLANE_OF_DAMPING, map_growth, map_error, 0},
    {"rk4", PLANE_OF_ROOTS, map_growth, map_error, 0},
    {"dopri5", PLANE_OF_ROOTS, tableau_growth, tableau_error, 0},
    {"dop853", PLANE_OF_ROOTS, tableau_growth, tableau_error, 0},
    {"newmark", PLANE_OF_DAMPING, map_growth, map_error, 0},
    {"generalized-alpha", PLANE_OF_DAMPING, long_run_growth, NULL, 0},
    {"exact", PLANE_OF_ROOTS, exact_growth, NULL, 0},
    {"cvode-bdf", PLANE_OF_ROOTS, bdf_growth, NULL, 1},
    {"cvode-bdf", PLANE_OF_ROOTS, bdf_growth, NULL, 2},
    {"cvode-bdf", PLANE_OF_ROOTS, bdf_growth, NULL, 3},
    {"cvode-bdf", PLANE_OF_ROOTS, bdf_growth, NULL, 4},
    {"cvode-bdf", PLANE_OF_ROOTS, bdf_growth, NULL, 5},
    {0},
};
