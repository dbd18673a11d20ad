/* The implicit methods on chains: modes in closed form, the band as the general way, and nothing asked within a step.
 */
#include <math.h>
#include <string.h>

#include "implicit-case.h"
#include "test-systems.h"

#define LINKS 20 /* masses of the chain */

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
            void *stepper = implicit_create(implicit_newmark(), &c.system, 0);
            for (int k = 1; k <= 200; k++) {
                implicit_step_equally(implicit_newmark(), stepper, &state, h, 1);
                for (int i = 0; i < LINKS; i++)
                    largest = fmax(largest, fabs(q[c.number[i]] - c.anchor - sin((i + 1) * angle) * cos(k * turn)));
            }
            implicit_newmark()->destroy(stepper);
            g_test_message("way %d, mode %d: %g", way, mode, largest);
            g_assert_cmpfloat(largest, <, 1e-10);
        }
    }
}

/* With everything that a linear system has, and masses that pass through one another: the band does as Newton's method.
 */
static void test_band_as_newton(void)
{
    const TinkerIntegrator *methods[] = {implicit_newmark(), implicit_alpha()};
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
            steppers[k] = implicit_create(method, &c.system, 0.7);
        }
        for (int step = 0; step < 200; step++) {
            for (int k = 0; k < 2; k++)
                implicit_step_equally(method, steppers[k], &states[k], 0.02, 1);
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
    void *stepper = implicit_create(implicit_newmark(), &c.system, 0);
    implicit_step_equally(implicit_newmark(), stepper, &state, 0.01, 100);
    g_assert_cmpint(c.evaluations, ==, 1);
    implicit_newmark()->destroy(stepper);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/implicit-chain/modes", test_modes_of_a_chain);
    g_test_add_func("/numerics/implicit-chain/band-as-newton", test_band_as_newton);
    g_test_add_func("/numerics/implicit-chain/band-asks-for-nothing", test_band_asks_for_nothing);
    return g_test_run();
}
