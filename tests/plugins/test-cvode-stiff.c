/* The integrator on CVODE in stiff motion: a chain of 50 unit masses in a line, every other spring a million times as
 * stiff, against the eigenvectors of LAPACK. */
#include <complex.h>
#include <lapacke.h>
#include <math.h>
#include <string.h>

#include "plugin-fixture.h"
#include "test-systems.h"

static const TinkerIntegrator *cvode(void)
{
    static const TinkerIntegrator *method = NULL;
    if (method == NULL) method = integrator_open("cvode-bdf");
    return method;
}

#define CHAIN 50

typedef struct {
    TinkerSystem system;
    TinkerPattern pattern;
    double k[CHAIN + 1], c[CHAIN + 1], mass[CHAIN]; /* spring i is to the left of mass i */
    int32_t row_starts[CHAIN + 1], columns[3 * CHAIN];
} Chain;

static TinkerStatus chain_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                       double *power)
{
    const Chain *chain = context;
    double left = chain->k[0] * q[0] + chain->c[0] * v[0];
    for (int i = 0; i < CHAIN; i++) {
        double right = i + 1 == CHAIN ? 0.0 : chain->k[i + 1] * (q[i + 1] - q[i]) + chain->c[i + 1] * (v[i + 1] - v[i]);
        a[i] = right - left;
        left = right;
    }
    return TINKER_OK;
}

/* The entry of K or C that is made of these springs or dampers. */
static double chain_entry(const double *edges, int row, int column)
{
    return row == column ? edges[row] + edges[row + 1] : -edges[MAX(row, column)];
}

static TinkerStatus chain_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                   double *damping)
{
    const Chain *chain = context;
    for (int row = 0; row < CHAIN; row++)
        for (int32_t i = chain->row_starts[row]; i < chain->row_starts[row + 1]; i++) {
            stiffness[i] = chain_entry(chain->k, row, chain->columns[i]);
            damping[i] = chain_entry(chain->c, row, chain->columns[i]);
        }
    return TINKER_OK;
}

static void chain_scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = *speed = 0.0;
    for (int i = 0; i < CHAIN; i++) {
        *extent = fmax(*extent, fabs(q[i]));
        *speed = fmax(*speed, fabs(v[i]));
    }
}

static void chain_init(Chain *chain, double damping_ratio)
{
    *chain = (Chain){.pattern = {CHAIN, 0, chain->row_starts, chain->columns}};
    for (int i = 0; i < CHAIN; i++) {
        chain->k[i] = i % 2 == 0 ? 1e2 : 1e8;
        chain->c[i] = 2.0 * damping_ratio * sqrt(chain->k[i]);
        chain->mass[i] = 1.0;
        for (int column = MAX(i - 1, 0); column <= MIN(i + 1, CHAIN - 1); column++)
            chain->columns[chain->pattern.entries++] = column;
        chain->row_starts[i + 1] = chain->pattern.entries;
    }
    chain->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .size = CHAIN,
        .context = chain,
        .mass = chain->mass,
        .acceleration = chain_acceleration,
        .applied = chain_acceleration,
        .scales = chain_scales,
        .pattern = &chain->pattern,
        .jacobian = chain_jacobian,
    };
}

/* Pairs joined by a stiff spring are displaced together, on a ramp, and let go. */
static double chain_start(int i)
{
    return (i / 2 + 1) / 25.0;
}

/* The positions at `t` from the eigenvectors of z' = A z, z = (q, v). */
static void chain_exact(const Chain *chain, double t, double exact[CHAIN])
{
    enum { N = 2 * CHAIN };
    static double a[N * N], real[N], imaginary[N], vectors[N * N];
    static lapack_complex_double basis[N * N], share[N];
    lapack_int pivots[N];
    memset(a, 0, sizeof a);
    for (int row = 0; row < CHAIN; row++) {
        a[row * N + CHAIN + row] = 1.0;
        for (int column = MAX(row - 1, 0); column <= MIN(row + 1, CHAIN - 1); column++) {
            a[(CHAIN + row) * N + column] = -chain_entry(chain->k, row, column);
            a[(CHAIN + row) * N + CHAIN + column] = -chain_entry(chain->c, row, column);
        }
    }
    g_assert_cmpint(LAPACKE_dgeev(LAPACK_ROW_MAJOR, 'N', 'V', N, a, N, real, imaginary, NULL, 1, vectors, N), ==, 0);
    for (int column = 0; column < N; column++) {
        /* of a pair the real and the imaginary part stand side by side */
        double sign = imaginary[column] < 0.0 ? -1.0 : 1.0;
        int first = sign < 0.0 ? column - 1 : column;
        for (int row = 0; row < N; row++)
            basis[row * N + column] =
                vectors[row * N + first] + (imaginary[column] == 0.0 ? 0.0 : sign * vectors[row * N + first + 1]) * I;
    }
    static lapack_complex_double factors[N * N];
    memcpy(factors, basis, sizeof basis);
    for (int i = 0; i < N; i++)
        share[i] = i < CHAIN ? chain_start(i) : 0.0;
    g_assert_cmpint(LAPACKE_zgesv(LAPACK_ROW_MAJOR, N, 1, factors, N, pivots, share, 1), ==, 0);
    for (int row = 0; row < CHAIN; row++) {
        lapack_complex_double sum = 0.0;
        for (int i = 0; i < N; i++)
            sum += basis[row * N + i] * share[i] * cexp((real[i] + imaginary[i] * I) * t);
        exact[row] = creal(sum);
    }
}

/* Runs the chain to t = 10; answers its error against the extent, and the number of steps. */
static double run_chain(Chain *chain, double tolerance, int *steps)
{
    double q[CHAIN], v[CHAIN] = {0.0}, exact[CHAIN], none = 0.0;
    TinkerState state = {0.0, q, v, &none};
    TinkerIntegratorOptions options = tolerance_options(tolerance);
    TinkerStepReport report = {.struct_size = sizeof report};
    for (int i = 0; i < CHAIN; i++)
        q[i] = chain_start(i);
    void *stepper = cvode()->create(&chain->system, &options);
    for (*steps = 0; state.t < 10.0; ++*steps) {
        TinkerStatus status = cvode()->step(stepper, &state, 10.0, &report);
        if (status != TINKER_OK) g_error("t = %g: %s", state.t, report.failure);
        g_assert_cmpint(*steps, <, 200000);
    }
    cvode()->destroy(stepper);
    chain_exact(chain, 10.0, exact);
    return distance(CHAIN, q, exact) / chain_start(CHAIN - 1);
}

/* The stiff springs vibrate at up to sqrt(2e8) rad/s and hardly decay. They are not seen, and must not be what the
 * steps follow: there are fewer steps than half the periods. */
static void test_stiff_chain(void)
{
    const double periods = 10.0 * sqrt(2e8) / (2.0 * G_PI);
    double last = INFINITY;
    for (double tolerance = 1e-3; tolerance > 2e-6; tolerance *= 0.1) {
        Chain chain;
        int steps;
        chain_init(&chain, 0.01);
        double error = run_chain(&chain, tolerance, &steps);
        g_test_message("tolerance %.0e: %d steps, error %.2e", tolerance, steps, error);
        g_assert_cmpfloat(error, <, 100.0 * tolerance);
        g_assert_cmpfloat(error, <, last);
        g_assert_cmpfloat(steps, <, 0.5 * periods);
        last = error;
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/cvode/stiff-chain", test_stiff_chain);
    return g_test_run();
}
