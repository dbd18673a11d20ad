/* Every built-in method keeps its order on whole scenes, against closed forms. */
#include "physics-fixture.h"

#include "numerics/methods/integrators.h"
#include "test-systems.h"

#include <complex.h>
#include <math.h>

#define ORDER_MARGIN 0.15
#define DURATION     2.0

/* An adaptive method is made to take steps of a length by breaks at its multiples: an idle motor that switches there.
 */
static char *idle_breaks(int steps)
{
    return g_strdup_printf(", {'type': 'motor', 'ends': ['Mass 0'], 'waveform': {'expression': '0*floor(t*%d/2)'}}",
                           steps);
}

typedef struct {
    const char *name, *blocks;
    void (*exact)(double t, double state[4]);
} OrderCase;

/* Unit mass, stiffness 4, at 2 m from its support along x: x'' + c x' + 4 x = f cos(1.3 t), x(0) = 0.5, v(0) = 0.2. */
static void oscillator_state(double c, double f, double t, double state[4])
{
    double complex s = 1.3 * I, steady = f / (4 + c * s + s * s), root = -c / 2 + I * sqrt(4 - c * c / 4);
    double x0 = 0.5 - creal(steady), v0 = 0.2 - creal(s * steady);
    double complex free = x0 - I * (v0 + c / 2 * x0) / cimag(root);
    state[0] = creal(steady * cexp(s * t) + free * cexp(root * t));
    state[2] = creal(s * steady * cexp(s * t) + root * free * cexp(root * t));
    state[1] = state[3] = 0;
}

static void undamped(double t, double state[4])
{
    oscillator_state(0, 0, t, state);
}

static void damped(double t, double state[4])
{
    oscillator_state(0.7, 0, t, state);
}

static void driven(double t, double state[4])
{
    oscillator_state(0.7, 1.5, t, state);
}

static void pendulum(double t, double state[4])
{
    Pendulum p;
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    pendulum_exact(&p, t, state, state + 2);
}

#define OSCILLATOR                                                                                                     \
    "{'type': 'support', 'position': [-2, 0]}, {'type': 'mass', 'position': [0.5, 0], 'velocity': [0.2, 0]},"          \
    "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2, 'stiffness': 4}"
#define DAMPER ",{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 0.7}"
#define MOTOR  ",{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 1.5, 'frequency': 1.3}"

static const OrderCase order_cases[] = {
    {"undamped", OSCILLATOR, undamped},
    {"damped", OSCILLATOR DAMPER, damped},
    {"driven", OSCILLATOR DAMPER MOTOR, driven},
    {"pendulum",
     "{'type': 'support'}, {'type': 'gravity'},"
     "{'type': 'mass', 'position': [1.1820866548733862, 0.5409908875112851]},"
     "{'type': 'rod', 'ends': ['Support 0', 'Mass 0'], 'length': 1.3}",
     pendulum},
};

/* The largest error over eight samples that lie on steps. */
static double error_of(const TinkerIntegrator *method, const OrderCase *test, int steps)
{
    g_autofree char *breaks = idle_breaks(steps);
    gboolean adaptive = (method->flags & TINKER_INTEGRATOR_ADAPTIVE) != 0;
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = method->id,
                                                              .duration = DURATION,
                                                              .interval = DURATION / 8,
                                                              .step = DURATION / steps,
                                                              .tolerance = 0.999,
                                                              .columns = "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy"},
                                            "%s%s", test->blocks, adaptive ? breaks : "");
    double largest = 0;
    g_assert_cmpint(run->summary->steps, ==, steps);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double truth[4];
        test->exact(physics_time(run, i), truth);
        for (gsize k = 0; k < 4; k++)
            largest = fmax(largest, fabs(physics_value(run, i, k) - truth[k]));
    }
    return largest;
}

static int coarse_steps(const TinkerIntegrator *method, gboolean constrained)
{
    if (method->order >= 8) return constrained ? 32 : 8;
    if (method->order == 6) return constrained ? 64 : 32;
    if (method->order >= 6) return constrained ? 128 : 32;
    if (method->order >= 4) return constrained ? 512 : 128;
    return method->order == 2 ? 512 : 4096;
}

static void test_order(gconstpointer data)
{
    const TinkerIntegrator *method = data;
    for (gsize i = 0; i < G_N_ELEMENTS(order_cases); i++) {
        gboolean constrained = order_cases[i].exact == pendulum;
        int steps = coarse_steps(method, constrained);
        double coarse = error_of(method, &order_cases[i], steps), fine = error_of(method, &order_cases[i], 2 * steps);
        g_test_message("%s: errors %.3e, %.3e, order %.3f", order_cases[i].name, coarse, fine, log2(coarse / fine));
        /* Order 8 on the pendulum reaches rounding before its leading term is all there is. */
        if (constrained && method->order >= 8)
            g_assert_cmpfloat(log2(coarse / fine), >, method->order - ORDER_MARGIN);
        else
            physics_assert_near(order_cases[i].name, log2(coarse / fine), method->order, ORDER_MARGIN);
    }
}

/* The thesis's method at its step: x of the spring-mass scene of its chapter on results, against cos. The error of one
 * period of order 4 is (h w)^5 / 120 a step: 500 steps of h w = 0.05. */
static void test_rk4_at_a_hundredth(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "rk4", .duration = 5, .interval = 0.01, .columns = "Mass 0.y"},
        "{'type': 'gravity'}, {'type': 'support', 'position': [0, 4]}, {'type': 'mass', 'position': [0, 2]},"
        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 25, 'rest_length': 2}");
    double bound = 9.81 / 25 * 500 * pow(0.05, 5) / 120 * 1.05;
    g_assert_cmpuint(physics_samples(run), ==, 501);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double truth = 2 - 9.81 / 25 * (1 - cos(5 * physics_time(run, i)));
        physics_assert_near("y", physics_value(run, i, 0), truth, bound);
    }
}

static void add_tests(void)
{
    for (const TinkerIntegrator *const *method = tinker_integrator_builtins(); *method != NULL; method++) {
        if ((*method)->flags & TINKER_INTEGRATOR_LINEAR) continue; /* exact: of no order */
        g_autofree char *name = g_strdup_printf("/physics/orders/%s", (*method)->id);
        g_test_add_data_func(name, *method, test_order);
    }
    g_test_add_func("/physics/orders/rk4-at-a-hundredth", test_rk4_at_a_hundredth);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
