/* The implicit methods' own promises: closed-form recurrences, no limit of stability, the spectral radius at infinity,
 * chains by the band as by the general way, refusals that say what to do. */
#include <math.h>
#include <string.h>

#include "numerics/methods/integrators.h"
#include "test-systems.h"

#define LINKS 20 /* masses of the chain */

static const TinkerIntegrator *newmark(void)
{
    return tinker_integrator_builtin("newmark");
}

static const TinkerIntegrator *alpha(void)
{
    return tinker_integrator_builtin("generalized-alpha");
}

static void *create(const TinkerIntegrator *method, const TinkerSystem *system, double radius)
{
    TinkerIntegratorOptions options = {.struct_size = sizeof options, .spectral_radius = radius};
    return method->create(system, &options);
}

static void step_equally(const TinkerIntegrator *method, void *stepper, TinkerState *state, double h, int steps)
{
    TinkerStepReport report = {.struct_size = sizeof report};
    for (int i = 0; i < steps; i++)
        g_assert_cmpint(method->step(stepper, state, state->t + h, &report), ==, TINKER_OK);
}

/* --- one oscillator --- */

/* The trapezoidal rule for x' = v, v' = -w^2 x - g v, solved by hand. */
static void trapezoid(double w, double g, double h, double *x, double *v)
{
    double k = 0.5 * h, a = 1 + k * g + k * k * w * w;
    double x0 = *x, v0 = *v;
    *v = ((1 - k * g - k * k * w * w) * v0 - h * w * w * x0) / a;
    *x = x0 + k * (v0 + *v);
}

static void test_closed_recurrence(void)
{
    for (int damped = 0; damped < 2; damped++) {
        Oscillator o;
        TestState test;
        double gamma = damped ? 0.01 : 0.0, x[TEST_SIZE], v[TEST_SIZE];
        oscillator_init(&o, 2.0, gamma, 0.0, 0.0);
        test_state_init(&test, 0.0);
        oscillator_exact(&o, 0.0, test.q, test.v);
        memcpy(x, test.q, sizeof x);
        memcpy(v, test.v, sizeof v);
        void *stepper = create(newmark(), &o.system, 0);
        for (int i = 0; i < 1000; i++) {
            step_equally(newmark(), stepper, &test.state, 0.125, 1);
            for (int k = 0; k < TEST_SIZE; k++)
                trapezoid(2.0, gamma, 0.125, &x[k], &v[k]);
            g_assert_cmpfloat(distance(TEST_SIZE, x, test.q) + distance(TEST_SIZE, v, test.v), <, 1e-12);
        }
        newmark()->destroy(stepper);
    }
}

/* h omega = 1000, ten thousand steps: average acceleration keeps the energy, the other loses it. */
static void test_no_limit_of_stability(void)
{
    const struct {
        const TinkerIntegrator *method;
        double radius;
    } cases[] = {{newmark(), 0}, {alpha(), 1}, {alpha(), 0.8}, {alpha(), 0.3}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        Oscillator o;
        TestState test;
        oscillator_init(&o, 1000.0, 0.0, 0.0, 0.0);
        o.system.books = 0;
        test_state_init(&test, 0.0);
        test.q[0] = 1.0;
        test.v[1] = 1000.0;
        double start = oscillator_energy(&o, test.q, test.v), greatest = 0.0;
        void *stepper = create(cases[i].method, &o.system, cases[i].radius);
        for (int k = 0; k < 10000; k++) {
            step_equally(cases[i].method, stepper, &test.state, 1.0, 1);
            greatest = fmax(greatest, oscillator_energy(&o, test.q, test.v));
        }
        g_test_message("%s, %g: energy up to %.12g, at last %g", cases[i].method->id, cases[i].radius, greatest / start,
                       oscillator_energy(&o, test.q, test.v) / start);
        if (cases[i].method == newmark()) {
            g_assert_cmpfloat(fabs(oscillator_energy(&o, test.q, test.v) / start - 1.0), <, 1e-9);
            g_assert_cmpfloat(greatest / start, <, 1.0 + 1e-9);
        } else if (cases[i].radius < 1) {
            g_assert_cmpfloat(oscillator_energy(&o, test.q, test.v), <, 1e-20 * start);
        }
        cases[i].method->destroy(stepper);
    }
}

/* At infinite frequency all three eigenvalues of a step are -r: (E + r)^3 x = 0, with E one step on. */
static void test_radius_at_infinity(void)
{
    static const double radii[] = {0.3, 0.5, 0.8, 0.95};
    for (gsize i = 0; i < G_N_ELEMENTS(radii); i++) {
        Oscillator o;
        TestState test;
        double r = radii[i], x[8];
        oscillator_init(&o, 1e4, 0.0, 0.0, 0.0);
        o.system.books = 0;
        test_state_init(&test, 0.0);
        test.q[0] = test.q[1] = 1.0;
        void *stepper = create(alpha(), &o.system, r);
        for (int k = 0; k < 8; k++) {
            step_equally(alpha(), stepper, &test.state, 1.0, 1);
            x[k] = test.q[0];
        }
        for (int k = 0; k + 3 < 8; k++) {
            double rest = x[k + 3] + 3 * r * x[k + 2] + 3 * r * r * x[k + 1] + r * r * r * x[k];
            g_assert_cmpfloat(fabs(rest), <, 1e-6 * fabs(x[k]));
        }
        step_equally(alpha(), stepper, &test.state, 1.0, 1000);
        g_assert_cmpfloat(fabs(test.q[0]), <, 1e-15);
        alpha()->destroy(stepper);
    }
    /* none given: 0.8 */
    Oscillator o;
    TestState given, left;
    oscillator_init(&o, 30.0, 0.0, 0.0, 0.0);
    test_state_init(&given, 0.0);
    given.q[0] = 1.0;
    test_state_init(&left, 0.0);
    left.q[0] = 1.0;
    void *first = create(alpha(), &o.system, 0.8), *second = create(alpha(), &o.system, 0.0);
    step_equally(alpha(), first, &given.state, 0.1, 20);
    step_equally(alpha(), second, &left.state, 0.1, 20);
    g_assert_cmpmem(given.q, sizeof given.q, left.q, sizeof left.q);
    alpha()->destroy(first);
    alpha()->destroy(second);
}

/* --- a chain --- */

/* Masses in a row, spring to the wall on the left, all numbered by `number`; each spring of the given rest length, with
 * a damper. The wall moves as `signal` says, which also pushes the last mass. */
typedef struct {
    TinkerSystem system;
    TinkerLinearSystem linear;
    int32_t number[LINKS]; /* coordinate of the mass at each place of the row */
    double mass[LINKS], stiffness, damping, length, drag;
    double drag_of[LINKS];
    TinkerLinearEdge edges[LINKS];
    double anchor;
    TinkerSignal signal;
    TinkerSignalUse motion, force;
    int32_t row_starts[LINKS + 1], columns[3 * LINKS];
    TinkerPattern pattern;
    int evaluations;
} Chain;

static void signal_value(const TinkerSignal *signal, double t, double *value, double *rate)
{
    const double *c = signal->coefficient;
    *value = c[0] * sin(c[1] * (t - signal->origin) + c[2]);
    *rate = c[0] * c[1] * cos(c[1] * (t - signal->origin) + c[2]);
}

static TinkerStatus chain_acceleration(void *context, double t, const double *q, const double *v, double *a,
                                       double *power)
{
    Chain *c = context;
    double wall, speed, force[LINKS] = {0};
    c->evaluations++;
    signal_value(&c->signal, t, &wall, &speed);
    for (int i = 0; i < LINKS; i++) {
        double from = i > 0 ? q[c->number[i - 1]] : c->anchor + c->motion.factor * wall;
        double rate = i > 0 ? v[c->number[i - 1]] : c->motion.factor * speed;
        double d = q[c->number[i]] - from, sign = d > 0 ? 1 : d < 0 ? -1 : 0;
        double pull = c->stiffness * (d - sign * c->length) + c->damping * (v[c->number[i]] - rate);
        force[c->number[i]] -= pull;
        if (i > 0) force[c->number[i - 1]] += pull;
    }
    force[c->number[LINKS - 1]] += c->force.factor * wall;
    for (int i = 0; i < LINKS; i++)
        a[i] = (force[i] - c->drag * v[i]) / c->mass[i];
    return TINKER_OK;
}

static TinkerStatus chain_jacobian(void *context, double t, const double *q, const double *v, double *stiffness,
                                   double *damping)
{
    const Chain *c = context;
    int32_t place[LINKS];
    for (int i = 0; i < LINKS; i++)
        place[c->number[i]] = i;
    for (int32_t row = 0; row < LINKS; row++)
        for (int32_t k = c->row_starts[row]; k < c->row_starts[row + 1]; k++) {
            double links = c->columns[k] != row ? -1 : place[row] == LINKS - 1 ? 1 : 2;
            stiffness[k] = links * c->stiffness;
            damping[k] = links * c->damping + (c->columns[k] == row ? c->drag : 0);
        }
    return TINKER_OK;
}

static TinkerStatus chain_signals(void *context, TinkerSignal *signals)
{
    const Chain *c = context;
    signals[0] = c->signal;
    return TINKER_OK;
}

static void chain_pattern(Chain *c)
{
    int32_t entries = 0;
    for (int32_t row = 0; row < LINKS; row++) {
        c->row_starts[row] = entries;
        for (int32_t column = 0; column < LINKS; column++)
            for (int i = 0; i < LINKS; i++) {
                gboolean beside = i + 1 < LINKS && ((c->number[i] == row && c->number[i + 1] == column) ||
                                                    (c->number[i + 1] == row && c->number[i] == column));
                if (beside || (row == column && c->number[i] == row)) c->columns[entries++] = column;
            }
    }
    c->row_starts[LINKS] = entries;
    c->pattern = (TinkerPattern){LINKS, entries, c->row_starts, c->columns};
}

/* Shuffled by a step of 7, which has no factor in common with the number of masses. */
static void chain_init(Chain *c, double stiffness, double damping, double length, double drag, gboolean shuffled)
{
    *c = (Chain){.stiffness = stiffness, .damping = damping, .length = length, .drag = drag, .anchor = 0.5};
    for (int i = 0; i < LINKS; i++) {
        c->number[i] = shuffled ? 7 * i % LINKS : i;
        c->mass[i] = 1;
        c->drag_of[i] = drag;
    }
    for (int i = 0; i < LINKS; i++)
        c->edges[i] =
            (TinkerLinearEdge){i > 0 ? c->number[i - 1] : -1, c->number[i], stiffness, length, damping, .tension = 0};
    chain_pattern(c);
    c->motion = (TinkerSignalUse){.target = 0, .signal = 0, .book = -1};
    c->force = (TinkerSignalUse){.target = c->number[LINKS - 1], .signal = 0, .book = -1};
    c->linear = (TinkerLinearSystem){
        .struct_size = sizeof(TinkerLinearSystem),
        .size = LINKS,
        .edge_count = LINKS,
        .anchor_count = 1,
        .signal_count = 1,
        .force_count = 1,
        .motion_count = 1,
        .mass = c->mass,
        .drag = c->drag_of,
        .edges = c->edges,
        .anchors = &c->anchor,
        .forces = &c->force,
        .motions = &c->motion,
        .damper_book = -1,
        .drag_book = -1,
        .support_book = -1,
    };
    c->system = (TinkerSystem){
        .struct_size = sizeof(TinkerSystem),
        .size = LINKS,
        .context = c,
        .mass = c->mass,
        .acceleration = chain_acceleration,
        .applied = chain_acceleration,
        .pattern = &c->pattern,
        .jacobian = chain_jacobian,
        .linear = &c->linear,
        .signals = chain_signals,
    };
}

/* A mode of the chain with one end free: shape sin((j + 1) a), a = pi / (2 n + 1) (2 m - 1), w = 2 sqrt(k / M) sin(a /
 * 2). Average acceleration turns it by the angle whose cosine is (1 - z) / (1 + z), z = (w h / 2)^2, a step. */
static void test_modes_of_a_chain(void)
{
    for (int way = 0; way < 4; way++) {
        Chain c;
        chain_init(&c, 1e4, 0, 0, 0, way % 2 == 1);
        if (way / 2 == 1) c.system.linear = NULL;
        for (int mode = 1; mode <= LINKS; mode += 6) {
            double q[LINKS], v[LINKS] = {0}, angle = G_PI * (2 * mode - 1) / (2 * LINKS + 1), h = 0.1, largest = 0;
            double half = h * 100 * sin(0.5 * angle), turn = acos((1 - half * half) / (1 + half * half));
            TinkerState state = {.q = q, .v = v};
            for (int i = 0; i < LINKS; i++)
                q[c.number[i]] = c.anchor + sin((i + 1) * angle);
            void *stepper = create(newmark(), &c.system, 0);
            for (int k = 1; k <= 200; k++) {
                step_equally(newmark(), stepper, &state, h, 1);
                for (int i = 0; i < LINKS; i++)
                    largest = fmax(largest, fabs(q[c.number[i]] - c.anchor - sin((i + 1) * angle) * cos(k * turn)));
            }
            newmark()->destroy(stepper);
            g_test_message("way %d, mode %d: %g", way, mode, largest);
            g_assert_cmpfloat(largest, <, 1e-10);
        }
    }
}

/* With everything that a linear system has, and masses that pass through one another: the band does as Newton's method.
 */
static void test_band_as_newton(void)
{
    const TinkerIntegrator *methods[] = {newmark(), alpha()};
    for (int way = 0; way < 8; way++) {
        Chain c;
        gboolean shuffled = way % 2 == 1, passing = way / 4 == 1;
        const TinkerIntegrator *method = methods[way / 2 % 2];
        chain_init(&c, 50, 0.7, passing ? 0.1 : 1, 0.2, shuffled);
        c.signal = (TinkerSignal){TINKER_SIGNAL_HARMONIC, 0, 0.1, {0.4, 3, 0.2, 0}};
        c.motion.factor = 1.5;
        c.force.factor = passing ? 40 : 5;
        double q[2][LINKS], v[2][LINKS], largest = 0;
        gboolean passed = FALSE;
        TinkerState states[2];
        void *steppers[2];
        for (int k = 0; k < 2; k++) {
            states[k] = (TinkerState){.q = q[k], .v = v[k]};
            for (int i = 0; i < LINKS; i++) {
                q[k][c.number[i]] = c.anchor + c.length * (i + 1);
                v[k][c.number[i]] = sin(i);
            }
            c.system.linear = k == 0 ? &c.linear : NULL;
            steppers[k] = create(method, &c.system, 0.7);
        }
        for (int step = 0; step < 200; step++) {
            for (int k = 0; k < 2; k++)
                step_equally(method, steppers[k], &states[k], 0.02, 1);
            largest = fmax(largest, fmax(distance(LINKS, q[0], q[1]), distance(LINKS, v[0], v[1])));
            for (int i = 1; i < LINKS; i++)
                passed |= q[0][c.number[i]] < q[0][c.number[i - 1]];
        }
        g_assert_true(passed == passing);
        g_test_message("way %d: %g", way, largest);
        g_assert_cmpfloat(largest, <, 1e-10);
        for (int k = 0; k < 2; k++)
            method->destroy(steppers[k]);
    }
}

/* The system is asked at the start alone. */
static void test_band_asks_for_nothing(void)
{
    Chain c;
    double q[LINKS] = {0}, v[LINKS] = {0};
    TinkerState state = {.q = q, .v = v};
    chain_init(&c, 50, 0.7, 1, 0.2, TRUE);
    void *stepper = create(newmark(), &c.system, 0);
    step_equally(newmark(), stepper, &state, 0.01, 100);
    g_assert_cmpint(c.evaluations, ==, 1);
    newmark()->destroy(stepper);
}

/* --- refusals --- */

static void assert_refused(const TinkerIntegrator *method, const TinkerSystem *system, double radius, const char *why)
{
    TestState test;
    TinkerStepReport report = {.struct_size = sizeof report};
    test_state_init(&test, 0.0);
    test.q[0] = 1.0;
    test.q[1] = -0.5;
    void *stepper = create(method, system, radius);
    g_assert_cmpint(method->step(stepper, &test.state, 0.1, &report), ==, TINKER_FAILED);
    g_assert_nonnull(strstr(report.failure, why));
    g_assert_true(test.q[0] == 1.0 && test.q[1] == -0.5 && test.v[0] == 0.0 && test.state.t == 0.0);
    method->destroy(stepper);
}

/* A force that no end of the step meets: it points away from wherever the mass is. */
static TinkerStatus no_balance(void *context, double t, const double *q, const double *v, double *a, double *power)
{
    for (int i = 0; i < TEST_SIZE; i++)
        a[i] = q[i] > 0 ? -1e9 : 1e9;
    return TINKER_OK;
}

static void test_refusals(void)
{
    Oscillator o;
    Pendulum p;
    oscillator_init(&o, 2.0, 0.0, 0.0, 0.0);
    pendulum_init(&p, 1.3, 9.81, 2.0, 0.0);
    assert_refused(alpha(), &p.system, 1.0, "0.95");
    assert_refused(alpha(), &o.system, 1.1, "from 0 to 1");
    assert_refused(alpha(), &o.system, -0.1, "from 0 to 1");
    assert_refused(alpha(), &o.system, (double)NAN, "from 0 to 1");
    o.system.acceleration = no_balance;
    o.system.books = 0;
    assert_refused(newmark(), &o.system, 0, "smaller step");
    o.system.jacobian = NULL;
    assert_refused(newmark(), &o.system, 0, "explicit");
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/implicit/closed-recurrence", test_closed_recurrence);
    g_test_add_func("/numerics/implicit/no-limit-of-stability", test_no_limit_of_stability);
    g_test_add_func("/numerics/implicit/radius-at-infinity", test_radius_at_infinity);
    g_test_add_func("/numerics/implicit/modes-of-a-chain", test_modes_of_a_chain);
    g_test_add_func("/numerics/implicit/band-as-newton", test_band_as_newton);
    g_test_add_func("/numerics/implicit/band-asks-for-nothing", test_band_asks_for_nothing);
    g_test_add_func("/numerics/implicit/refusals", test_refusals);
    return g_test_run();
}
