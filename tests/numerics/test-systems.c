/* Systems with closed-form motion. */
#include "test-systems.h"

#include <complex.h>
#include <math.h>
#include <string.h>
#include <tinker/unconstrained.h>

static const double oscillator_q0[TEST_SIZE] = {1.0, -0.4};
static const double oscillator_v0[TEST_SIZE] = {0.3, 0.9};
static const double unit_mass[TEST_SIZE] = {1.0, 1.0};

/* --- oscillator --- */

static TinkerStatus oscillator_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                            double *power)
{
    Oscillator *o = context;
    double square = o->omega * o->omega, push = o->unit * o->drive * cos(o->drive_rate * t);
    o->evaluations++;
    if (power) power[0] = power[1] = 0.0;
    for (int i = 0; i < TEST_SIZE; i++) {
        if (o->refuse_speed > 0.0 && fabs(v[i]) > o->refuse_speed) return TINKER_RETRY_SMALLER;
        a[i] = -square * q[i] - o->gamma * v[i] + push;
        if (t > o->break_time) a[i] = NAN;
        if (!power) continue;
        power[0] += o->gamma * v[i] * v[i];
        power[1] += push * v[i];
    }
    return TINKER_OK;
}

static TinkerStatus oscillator_damping(void *context, double t, const double *q, const double *v, const double *dv,
                                       double *out)
{
    const Oscillator *o = context;
    for (int i = 0; i < TEST_SIZE; i++)
        out[i] = -o->gamma * dv[i];
    return TINKER_OK;
}

static const int32_t oscillator_row_starts[] = {0, 1, 2}, oscillator_columns[] = {0, 1};
static const TinkerPattern oscillator_pattern = {2, 2, oscillator_row_starts, oscillator_columns};

static TinkerStatus oscillator_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                        double *damping)
{
    const Oscillator *o = context;
    for (int i = 0; i < TEST_SIZE; i++) {
        stiffness[i] = o->omega * o->omega;
        damping[i] = o->gamma;
    }
    return TINKER_OK;
}

static void largest_scales(void *context, const double *q, const double *v, double *extent, double *speed)
{
    *extent = fmax(fabs(q[0]), fabs(q[1]));
    *speed = fmax(fabs(v[0]), fabs(v[1]));
}

void oscillator_init(Oscillator *o, double omega, double gamma, double drive, double drive_rate)
{
    *o = (Oscillator){.omega = omega, .gamma = gamma, .drive = drive, .drive_rate = drive_rate, .unit = 1.0};
    o->break_time = INFINITY;
    o->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .flags = gamma != 0.0 ? TINKER_SYSTEM_VELOCITY_DEPENDENT : 0,
        .size = TEST_SIZE,
        .books = TEST_BOOKS,
        .context = o,
        .mass = unit_mass,
        .acceleration = oscillator_acceleration,
        .applied = oscillator_acceleration,
        .project = tinker_unconstrained_project,
        .constrain_step = tinker_unconstrained_constrain_step,
        .project_velocity = tinker_unconstrained_project_velocity,
        .damping_product = oscillator_damping,
        .pattern = &oscillator_pattern,
        .jacobian = oscillator_jacobian,
        .scales = largest_scales,
        .failure = tinker_unconstrained_failure,
    };
}

/* x = Re(p exp(i W t)) + A exp(r1 t) + B exp(r2 t) with complex roots; gamma < 2 omega. */
void oscillator_exact(const Oscillator *o, double t, double *q, double *v)
{
    double complex root = -0.5 * o->gamma + I * sqrt(o->omega * o->omega - 0.25 * o->gamma * o->gamma);
    double complex rate = I * o->drive_rate;
    double complex driven = o->drive / (o->omega * o->omega + o->gamma * rate + rate * rate);
    for (int i = 0; i < TEST_SIZE; i++) {
        double x0 = oscillator_q0[i] - creal(driven), v0 = oscillator_v0[i] - creal(driven * rate);
        double complex share = x0 - I * (v0 - creal(root) * x0) / cimag(root);
        q[i] = o->unit * creal(driven * cexp(rate * t) + share * cexp(root * t));
        v[i] = o->unit * creal(driven * rate * cexp(rate * t) + share * root * cexp(root * t));
    }
}

double oscillator_energy(const Oscillator *o, const double *q, const double *v)
{
    double sum = 0.0;
    for (int i = 0; i < TEST_SIZE; i++)
        sum += 0.5 * (v[i] * v[i] + o->omega * o->omega * q[i] * q[i]);
    return sum;
}

/* --- pendulum --- */

static TinkerStatus pendulum_applied(void *context, double t, const double *q, const double *v, double *a,
                                     double *power)
{
    Pendulum *p = context;
    p->evaluations++;
    a[0] = -p->drag * v[0];
    a[1] = -p->gravity - p->drag * v[1];
    if (power) power[0] = p->drag * (v[0] * v[0] + v[1] * v[1]);
    if (power) power[1] = 0.0;
    return TINKER_OK;
}

static TinkerStatus pendulum_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                          double *power)
{
    pendulum_applied(context, t, q, v, a, power);
    double r = hypot(q[0], q[1]), x = q[0] / r, y = q[1] / r;
    double along = x * v[0] + y * v[1], turn = (v[0] * v[0] + v[1] * v[1] - along * along) / r;
    double pull = x * a[0] + y * a[1] + turn;
    a[0] -= pull * x;
    a[1] -= pull * y;
    return TINKER_OK;
}

static TinkerStatus pendulum_project_velocity(void *context, double t, const double *q, double *v, int32_t homogeneous)
{
    double r = hypot(q[0], q[1]), along = (q[0] * v[0] + q[1] * v[1]) / r;
    v[0] -= along * q[0] / r;
    v[1] -= along * q[1] / r;
    return TINKER_OK;
}

static TinkerStatus pendulum_project(void *context, double t, double *q, double *v, int32_t *moved)
{
    const Pendulum *p = context;
    double r = hypot(q[0], q[1]);
    *moved = fabs(r - p->length) > 1e-15 * p->length || p->always_moved;
    q[0] *= p->length / r;
    q[1] *= p->length / r;
    return pendulum_project_velocity(context, t, q, v, 0);
}

/* |q + mu n| = length along the rod's direction n at the start of the step. */
static TinkerStatus pendulum_constrain_step(void *context, double t_from, const double *q_from, double t, double h,
                                            double *q, double *v)
{
    const Pendulum *p = context;
    double r = hypot(q_from[0], q_from[1]), x = q_from[0] / r, y = q_from[1] / r;
    double b = x * q[0] + y * q[1], c = q[0] * q[0] + q[1] * q[1] - p->length * p->length;
    if (b * b < c) return TINKER_RETRY_SMALLER;
    double mu = -c / (b + sqrt(b * b - c));
    q[0] += mu * x;
    q[1] += mu * y;
    v[0] += mu * x / h;
    v[1] += mu * y / h;
    return TINKER_OK;
}

static TinkerStatus pendulum_damping(void *context, double t, const double *q, const double *v, const double *dv,
                                     double *out)
{
    const Pendulum *p = context;
    out[0] = -p->drag * dv[0];
    out[1] = -p->drag * dv[1];
    return TINKER_OK;
}

static const int32_t pendulum_row_starts[] = {0, 2, 4}, pendulum_columns[] = {0, 1, 0, 1};
static const TinkerPattern pendulum_pattern = {2, 4, pendulum_row_starts, pendulum_columns};

static TinkerStatus pendulum_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                      double *damping)
{
    const Pendulum *p = context;
    for (int k = 0; k < 4; k++) {
        stiffness[k] = 0.0;
        damping[k] = k % 3 == 0 ? p->drag : 0.0;
    }
    return TINKER_OK;
}

static TinkerStatus pendulum_row_masses(void *context, double t, const double *q, double *values)
{
    double square = q[0] * q[0] + q[1] * q[1];
    for (int k = 0; k < 4; k++)
        values[k] = q[k / 2] * q[k % 2] / square;
    return TINKER_OK;
}

void pendulum_init(Pendulum *p, double length, double gravity, double theta0, double drag)
{
    *p = (Pendulum){.length = length, .gravity = gravity, .theta0 = theta0, .drag = drag};
    p->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .flags = TINKER_SYSTEM_CONSTRAINED | (drag != 0.0 ? TINKER_SYSTEM_VELOCITY_DEPENDENT : 0),
        .size = TEST_SIZE,
        .books = TEST_BOOKS,
        .context = p,
        .mass = unit_mass,
        .acceleration = pendulum_acceleration,
        .applied = pendulum_applied,
        .project = pendulum_project,
        .constrain_step = pendulum_constrain_step,
        .project_velocity = pendulum_project_velocity,
        .damping_product = pendulum_damping,
        .pattern = &pendulum_pattern,
        .jacobian = pendulum_jacobian,
        .row_masses = pendulum_row_masses,
        .scales = largest_scales,
        .failure = tinker_unconstrained_failure,
    };
}

void jacobi(double u, double k, double *sn, double *cn, double *dn)
{
    double a[16] = {1.0}, c[16] = {k}, b = sqrt(1.0 - k * k);
    int last = 0;
    while (last < 15 && fabs(c[last]) > 1e-17) {
        a[last + 1] = 0.5 * (a[last] + b);
        c[last + 1] = 0.5 * (a[last] - b);
        b = sqrt(a[last] * b);
        last++;
    }
    double phi = ldexp(a[last] * u, last);
    for (int i = last; i > 0; i--)
        phi = 0.5 * (phi + asin(c[i] / a[i] * sin(phi)));
    *sn = sin(phi);
    *cn = cos(phi);
    *dn = sqrt(1.0 - k * k * *sn * *sn);
}

double elliptic_period(double k)
{
    double a = 1.0, b = sqrt(1.0 - k * k);
    for (int i = 0; i < 10; i++) {
        double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return G_PI_2 / a;
}

/* sin(theta/2) = k cd(w t), theta' = -2 k w k' sd(w t), with k = sin(theta0/2), w = sqrt(g / L). */
void pendulum_exact(const Pendulum *p, double t, double *q, double *v)
{
    double k = sin(0.5 * p->theta0), w = sqrt(p->gravity / p->length), sn, cn, dn;
    jacobi(w * t, k, &sn, &cn, &dn);
    double theta = 2.0 * asin(k * cn / dn), rate = -2.0 * k * w * sqrt(1.0 - k * k) * sn / dn;
    q[0] = p->length * sin(theta);
    q[1] = -p->length * cos(theta);
    v[0] = rate * p->length * cos(theta);
    v[1] = rate * p->length * sin(theta);
}

double pendulum_period(const Pendulum *p)
{
    return 4.0 * elliptic_period(sin(0.5 * p->theta0)) / sqrt(p->gravity / p->length);
}

double pendulum_energy(const Pendulum *p, const double *q, const double *v)
{
    return 0.5 * (v[0] * v[0] + v[1] * v[1]) + p->gravity * q[1];
}

/* --- runs --- */

void test_state_init(TestState *test, double t)
{
    memset(test, 0, sizeof *test);
    test->state = (TinkerState){.t = t, .q = test->q, .v = test->v, .books = test->books};
}

TinkerIntegratorOptions equal_step_options(double h)
{
    return (TinkerIntegratorOptions){
        .struct_size = sizeof(TinkerIntegratorOptions), .tolerance = 1e30, .first_step = h, .spectral_radius = 0.8};
}

TinkerIntegratorOptions tolerance_options(double tolerance)
{
    return (TinkerIntegratorOptions){
        .struct_size = sizeof(TinkerIntegratorOptions), .tolerance = tolerance, .spectral_radius = 0.8};
}

void run_equal_steps(const TinkerIntegrator *method, const TinkerSystem *system, TestState *test, double to, int steps)
{
    double from = test->state.t, h = (to - from) / steps;
    TinkerIntegratorOptions options = equal_step_options(h);
    TinkerStepReport report = {.struct_size = sizeof report};
    void *stepper = method->create(system, &options);
    for (int i = 1; i <= steps; i++) {
        double limit = i == steps ? to : from + i * h;
        g_assert_cmpint(method->step(stepper, &test->state, limit, &report), ==, TINKER_OK);
        g_assert_cmpfloat(test->state.t, ==, limit);
    }
    method->destroy(stepper);
}

int run_to(const TinkerIntegrator *method, const TinkerSystem *system, TestState *test, double to, double tolerance)
{
    TinkerIntegratorOptions options = tolerance_options(tolerance);
    TinkerStepReport report = {.struct_size = sizeof report};
    void *stepper = method->create(system, &options);
    int steps = 0;
    for (; test->state.t < to; steps++)
        g_assert_cmpint(method->step(stepper, &test->state, to, &report), ==, TINKER_OK);
    method->destroy(stepper);
    return steps;
}

double distance(int count, const double *left, const double *right)
{
    double largest = 0.0;
    for (int i = 0; i < count; i++)
        largest = fmax(largest, fabs(left[i] - right[i]));
    return largest;
}
