/* Bars held by more joints than they need: two pins in one hole, a slot beside a pin, a plank on many links. */
#include "physics-fixture.h"

#include "test-systems.h"

#include <math.h>

#define BAR ", {'type': 'bar', 'length': %.17g, 'mass': %.17g, 'position': [%.17g, 0]}"
#define PIN ", {'type': 'pin', 'ends': [{'block': 'Bar %d', 'at': [%.17g, 0]}, {'block': 'Bar %d', 'at': [%.17g, 0]}]}"
#define SLOT                                                                                                           \
    ", {'type': 'slot', 'angle': %.17g, 'ends': [{'block': 'Bar %d', 'at': [%.17g, 0]},"                               \
    " {'block': 'Bar %d', 'at': [%.17g, 0]}]}"

enum { BARS = 1000 };

/* Joints beside the pins of the first so many: behind all pins, whose names are then the same. */
typedef enum { ALONE, TWICE, WITH_A_SLOT } Beside;

/* A level line of bars of 10 m and 10 kg in all, pinned to a support at its left end. (transfer full) */
static char *line(Beside beside)
{
    const double length = 10.0 / BARS, half = 0.5 * length;
    GString *blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    for (int i = 0; i < BARS; i++)
        g_string_append_printf(blocks, BAR, length, length, (i + 0.5) * length);
    g_string_append_printf(blocks, ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [%.17g, 0]}]}",
                           -half);
    for (int i = 1; i < BARS; i++)
        g_string_append_printf(blocks, PIN, i - 1, half, i, -half);
    for (int i = 1; i < BARS; i++) {
        if (beside == TWICE && i % 2 == 0) g_string_append_printf(blocks, PIN, i - 1, half, i, -half);
        if (beside == TWICE && i % 2 == 1) g_string_append_printf(blocks, PIN, i, -half, i - 1, half);
        if (beside == WITH_A_SLOT) g_string_append_printf(blocks, SLOT, G_PI / 2, i - 1, half, i, -half);
    }
    return g_string_free(blocks, FALSE);
}

static PhysicsRun *run_line(Beside beside, const char *method, double duration)
{
    g_autofree char *blocks = line(beside);
    return physics_run(&(PhysicsOptions){.method = method,
                                         .step = 1e-4,
                                         .tolerance = 1e-9,
                                         .duration = duration,
                                         .columns = "Bar 0.angle, Bar 499.y, Bar 999.x, Bar 999.y, Bar 999.vy,"
                                                    "Pin 0.force y, Pin 500.force x, Pin 500.force y"},
                       "%s", blocks);
}

/* Of every joint the forces are shared, but for that at the support. */
static void compare(const PhysicsRun *held, const PhysicsRun *alone, double share)
{
    g_assert_cmpuint(held->summary->events->len, ==, 0);
    g_assert_cmpfloat(held->summary->energy_balance_error, <=, 1.01 * alone->summary->energy_balance_error + 1e-12);
    g_assert_cmpfloat(held->summary->constraint_velocity_error, <, 1e-10);
    for (gsize i = 0; i < physics_samples(alone); i++)
        for (gsize k = 0; k < 8; k++) {
            const double truth = physics_value(alone, i, k);
            physics_assert_near("of both", physics_value(held, i, k), k < 6 ? truth : share * truth,
                                1e-8 * (1 + fabs(truth)));
        }
}

/* Half the pins have the ends of their twins the other way round. */
static void test_pinned_twice(void)
{
    static const char *const methods[] = {"dop853", "rk4", "verlet"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        const double duration = m == 0 ? 0.05 : 0.01;
        g_autoptr(PhysicsRun) alone = run_line(ALONE, methods[m], duration);
        g_autoptr(PhysicsRun) twice = run_line(TWICE, methods[m], duration);
        g_assert_cmpint(tinker_model_sizes(twice->model).redundant_rows, ==, 2 * (BARS - 1));
        g_assert_cmpint(tinker_model_sizes(twice->model).degrees_of_freedom, ==, BARS);
        g_assert_cmpint(twice->summary->steps, ==, alone->summary->steps);
        compare(twice, alone, 0.5);
    }
}

/* The slot holds along the line, which nothing pulls at when the line is let go. Forces along it are shared. */
static void test_pin_and_slot(void)
{
    g_autoptr(PhysicsRun) alone = run_line(ALONE, "dop853", 0.005), held = run_line(WITH_A_SLOT, "dop853", 0.005);
    g_assert_cmpint(tinker_model_sizes(held->model).redundant_rows, ==, BARS - 1);
    g_assert_cmpuint(held->summary->events->len, ==, 0);
    g_assert_cmpfloat(held->summary->energy_balance_error, <, 1e-9);
    for (gsize i = 0; i < physics_samples(alone); i++)
        for (gsize k = 0; k < 6; k++)
            physics_assert_near("of both", physics_value(held, i, k), physics_value(alone, i, k),
                                1e-8 * (1 + fabs(physics_value(alone, i, k))));
}

/* Links of 1 m hang side by side, each pinned to a support and to a plank that moves along without turning: a pendulum
 * of the length (n m / 3 + M) / (n m / 2 + M). Two rows fewer depend on others than there are links. */
static void hang_a_plank(int links, const char *method, double bound)
{
    const double start = 1, mass = 0.1, plank = 5, apart = 0.1, across = apart * (links - 1);
    Pendulum p;
    pendulum_init(&p, (links * mass / 3 + plank) / (links * mass / 2 + plank), 9.81, start, 0);
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    g_string_append_printf(blocks,
                           ", {'type': 'bar', 'name': 'Plank', 'mass': %g, 'length': %.17g,"
                           " 'position': [%.17g, %.17g]}",
                           plank, across, 0.5 * across + sin(start), -cos(start));
    for (int i = 0; i < links; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'bar', 'mass': %g, 'position': [%.17g, %.17g], 'orientation': %.17g}", mass,
                               apart * i + 0.5 * sin(start), -0.5 * cos(start), start - G_PI / 2);
    for (int i = 0; i < links; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'pin', 'ends': [{'block': 'Support 0', 'at': [%.17g, 0]},"
                               " {'block': 'Bar %d', 'at': [-0.5, 0]}]}"
                               ", {'type': 'pin', 'ends': [{'block': 'Bar %d', 'at': [0.5, 0]},"
                               " {'block': 'Plank', 'at': [%.17g, 0]}]}",
                               apart * i, i, i, apart * i - 0.5 * across);
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = method,
                                                              .step = 1e-3,
                                                              .tolerance = 1e-11,
                                                              .duration = 1,
                                                              .columns = "Bar 0.angle, Plank.angle, Plank.x, Plank.y"},
                                            "%s", blocks->str);
    g_assert_cmpint(tinker_model_sizes(run->model).degrees_of_freedom, ==, 1);
    g_assert_cmpint(tinker_model_sizes(run->model).redundant_rows, ==, links - 2);
    for (gsize i = 0; i < physics_samples(run); i++) {
        double q[2], v[2];
        pendulum_exact(&p, physics_time(run, i), q, v);
        physics_assert_near("turn of a link", physics_value(run, i, 0), atan2(q[0], -q[1]) - G_PI / 2, bound);
        physics_assert_near("turn of the plank", physics_value(run, i, 1), 0, bound);
        physics_assert_near("x", physics_value(run, i, 2), 0.5 * across + q[0] / p.length, bound);
        physics_assert_near("y", physics_value(run, i, 3), q[1] / p.length, bound);
    }
}

/* Few links are solved by the products of their rows, many with the plank's velocity as an unknown of its own. */
static void test_plank(void)
{
    static const int links[] = {3, 12, 63, 64, 65, 250, 999};
    for (gsize i = 0; i < G_N_ELEMENTS(links); i++)
        hang_a_plank(links[i], "dop853", 1e-9);
    hang_a_plank(100, "rk4", 1e-9);
    hang_a_plank(100, "verlet", 1e-5);
}

static void add_tests(void)
{
    g_test_add_func("/redundant-pins/pinned-twice", test_pinned_twice);
    g_test_add_func("/redundant-pins/pin-and-slot", test_pin_and_slot);
    g_test_add_func("/redundant-pins/plank", test_plank);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
