/* Bodies with shapes on joints, with contact as impulses: against closed forms, statics and the laws of conservation.
 */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

static const double g = CONTACT_GRAVITY;

static PhysicsOptions impulses(double duration, double step, const char *columns)
{
    return (PhysicsOptions){.duration = duration, .step = step, .impulses = TRUE, .columns = columns};
}

/* Joints hold to rounding, at every step, and nothing gave the scene energy. */
static void check_held(const PhysicsRun *run, double given)
{
    const TinkerSummary *summary = run->summary;
    const double before = summary->kinetic_start + summary->potential_start;
    g_assert_cmpfloat(summary->constraint_position_error, <, 1e-13);
    g_assert_cmpfloat(summary->kinetic_end + summary->potential_end, <=, before + given);
}

/* A box on an arm, turning at 3 rad/s about a nail, strikes a wall: no impulse of the nail turns it, so that it goes
 * back at e times its rate, to first order in the step; and the wall took (1 - e^2) of its energy. */
static void test_pendulum_strikes(void)
{
    static const double restitutions[] = {0, 0.4, 1}, steps[] = {1e-3, 1e-4};
    for (gsize i = 0; i < G_N_ELEMENTS(restitutions) * G_N_ELEMENTS(steps); i++) {
        const double e = restitutions[i / 2], h = steps[i % 2], inertia = 2 * (0.16 + 0.16) / 12 + 2;
        const double energy = 0.5 * inertia * 9;
        g_autofree char *surface = g_strdup_printf(CONTACT_SMOOTH ", 'restitution': %g", e);
        g_autofree char *wall = contact_plate(0.5, -1, G_PI / 2, 5, surface);
        const PhysicsOptions options = impulses(0.5, h, "Box 0.angular velocity, Box 0.kinetic energy, Box 0.angle");
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'support', 'name': 'Nail', 'solid': false}, %s, {'type': 'box', 'mass': 2, 'width': "
                        "0.4, 'height': 0.4, 'position': [0, -1], 'velocity': [3, 0], 'angular_velocity': 3}, "
                        "{'type': 'pin', 'ends': ['Nail', {'block': 'Box 0', 'at': [0, 1]}]}",
                        wall);
        physics_assert_near("rate", physics_last(run, 0), -3 * e, h);
        physics_assert_near("energy", physics_last(run, 1), e * e * energy, h * energy);
        physics_assert_near("taken", run->summary->books[TINKER_BOOK_CONTACTS], (e * e - 1) * energy, h * energy);
        check_held(run, 1e-12);
    }
}

/* Two bars in one line, pinned end to end, are as heavy as 2/7 of one at their end: a disc strikes them there. */
static void test_strikes_chain(void)
{
    const double m = 1, mass = 3, v = 2, e = 0.5;
    const double impulse = (1 + e) * v / (1 / mass + 3.5 / m);
    const PhysicsOptions options =
        impulses(0.0505, 1e-3, "Disc 0.vy, Bar 0.vy, Bar 1.vy, Bar 0.angular velocity, Bar 1.angular velocity");
    g_autoptr(PhysicsRun) run = physics_run(
        &options, "{'type': 'bar', 'solid': true, 'width': 0.02, 'position': [0, 0], 'restitution': 0.5, "
                  "'static_friction': 0, 'dynamic_friction': 0},"
                  "{'type': 'bar', 'solid': true, 'width': 0.02, 'position': [1, 0], 'restitution': 0.5, "
                  "'static_friction': 0, 'dynamic_friction': 0, 'inertia': 0.083333333333333333},"
                  "{'type': 'disc', 'mass': 3, 'radius': 0.1, 'position': [1.5, -0.2105], 'velocity': [0, 2]},"
                  "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, {'block': 'Bar 1', 'at': [-0.5, 0]}]}");
    physics_assert_near("disc", physics_last(run, 0), v - impulse / mass, 1e-9);
    physics_assert_near("first", physics_last(run, 1), -impulse / 4 / m, 1e-2);
    physics_assert_near("second", physics_last(run, 2), 1.25 * impulse / m, 1e-2);
    physics_assert_near("first turns", physics_last(run, 3), -1.5 * impulse / m, 3e-2);
    physics_assert_near("second turns", physics_last(run, 4), 4.5 * impulse / m, 3e-2);
    check_held(run, 1e-12);
}

#define FLOOR                                                                                                          \
    CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 100, 'static_friction': 0.5, 'dynamic_friction': 0.5, 'restitution': 0}"
#define CART                                                                                                           \
    "{'type': 'box', 'mass': 6, 'width': 2, 'height': 0.4, 'position': [%.17g, %.17g], 'orientation': %.17g,"          \
    " 'velocity': [%.17g, 0]},"                                                                                        \
    "{'type': 'disc', 'radius': 0.3, 'position': [%.17g, %.17g], 'velocity': [%.17g, 0],"                              \
    " 'angular_velocity': %.17g},"                                                                                     \
    "{'type': 'disc', 'radius': 0.3, 'position': [%.17g, %.17g], 'velocity': [%.17g, 0],"                              \
    " 'angular_velocity': %.17g},"                                                                                     \
    "{'type': 'pin', 'ends': [{'block': 'Box 0', 'at': [-0.5, -0.2]}, 'Disc 0']},"                                     \
    "{'type': 'pin', 'ends': [{'block': 'Box 0', 'at': [1, -0.2]}, 'Disc 1']}"

/* A cart whose wheels touch the line through the origin at this angle, with a speed along x where that is level.
 * (transfer full) */
static char *cart(double angle, double speed)
{
    const double c = cos(angle), s = sin(angle);
    return g_strdup_printf(CART, -0.5 * s, 0.5 * c, angle, speed, -0.5 * c - 0.3 * s, -0.5 * s + 0.3 * c, speed,
                           -speed / 0.3, c - 0.3 * s, s + 0.3 * c, speed, -speed / 0.3);
}

/* The load of the box on the wheels is as its arms. */
static void test_cart_rests(void)
{
    g_autofree char *blocks = cart(0, 0);
    PhysicsOptions options = impulses(10, 1.0 / 240,
                                      "Box 0.y, Disc 0.y, Disc 1.y, Disc 0.normal force, Disc 1.normal "
                                      "force, Pin 0.force, Pin 1.force, Box 0.x");
    g_autoptr(PhysicsRun) run = physics_run(&options, FLOOR ", %s", blocks);
    physics_assert_near("box", physics_last(run, 0), 0.5, 1e-10);
    physics_assert_near("first wheel", physics_last(run, 1), 0.3, 1e-10);
    physics_assert_near("second wheel", physics_last(run, 2), 0.3, 1e-10);
    physics_assert_near("under the first", physics_last(run, 3), (1 + 4) * g, 1e-6);
    physics_assert_near("under the second", physics_last(run, 4), (1 + 2) * g, 1e-6);
    physics_assert_near("first pin", physics_last(run, 5), 4 * g, 1e-6);
    physics_assert_near("second pin", physics_last(run, 6), 2 * g, 1e-6);
    physics_assert_near("along", physics_last(run, 7), 0, 1e-10);
    check_held(run, 1e-12);
}

/* Over the floor it goes on as it was: nothing resists. */
static void test_cart_rolls(void)
{
    g_autofree char *blocks = cart(0, 2);
    const PhysicsOptions options = impulses(5, 1.0 / 240, "Box 0.y, Box 0.x, Box 0.vx, Disc 1.angle");
    g_autoptr(PhysicsRun) run = physics_run(&options, FLOOR ", %s", blocks);
    physics_assert_near("height", physics_last(run, 0), 0.5, 1e-10);
    physics_assert_near("way", physics_last(run, 1), 10, 1e-8);
    physics_assert_near("speed", physics_last(run, 2), 2, 1e-8);
    physics_assert_near("turned", physics_last(run, 3), -10 / 0.3, 1e-7);
    check_held(run, 1e-9);
}

/* Down a slope, its wheels heavier by half for what turns. */
static void test_cart_down_a_slope(void)
{
    const double angle = -0.2, a = 8 * g * sin(-angle) / 9;
    g_autofree char *blocks = cart(angle, 0);
    g_autofree char *slope =
        contact_plate(0, 0, angle, 100, "'static_friction': 0.8, 'dynamic_friction': 0.8, 'restitution': 0");
    double off[2];
    for (int i = 0; i < 2; i++) {
        const PhysicsOptions options = impulses(2, 0.01 / (1 + i), "Box 0.x, Box 0.y");
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT "%s, %s", slope, blocks);
        const double x = physics_last(run, 0), y = physics_last(run, 1);
        physics_assert_near("height", y * cos(angle) - x * sin(angle), 0.5, 1e-9);
        off[i] = x * cos(angle) + y * sin(angle) - 2 * a;
        check_held(run, 1e-9);
    }
    g_assert_cmpfloat(fabs(off[0]), <, 0.03);
    physics_assert_near("half the step, half the error", off[1], 0.5 * off[0], 0.02 * fabs(off[0]));
}

#define PILE  9
#define CHAIN 8
/* A pile of boxes and a chain of bars, the last with a heavy disc, that swings into it; all rest at first. (transfer
 * full) */
static char *wrecking_ball(void)
{
    GString *blocks =
        g_string_new(FLOOR ", {'type': 'support', 'solid': false, 'name': 'Nail 0', 'position': [-1.2, 4.5]}");
    for (int i = 0; i < PILE; i++)
        g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [%.17g, %.17g]}",
                               -0.51 + 0.51 * (i % 3), 0.25 + 0.5 * (i / 3));
    for (int i = 0; i < CHAIN; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'bar', 'solid': true, 'length': 0.5, 'mass': 0.2, 'position': [%.17g, 4.5], "
                               "'orientation': %.17g}, {'type': 'pin', 'ends': [{'block': '%s %d', 'at': [%g, 0]}, "
                               "{'block': 'Bar %d', 'at': [-0.25, 0]}]}",
                               -1.45 - 0.5 * i, G_PI, i > 0 ? "Bar" : "Nail", MAX(i - 1, 0), i > 0 ? 0.25 : 0.0, i);
    g_string_append_printf(blocks,
                           ", {'type': 'disc', 'mass': 5, 'radius': 0.3, 'position': [%.17g, 4.5]}, {'type': 'weld', "
                           "'ends': [{'block': 'Bar %d', 'at': [0.25, 0]}, 'Disc 0']}",
                           -1.2 - 0.5 * CHAIN, CHAIN - 1);
    return g_string_free(blocks, FALSE);
}

/* Of all boxes, bars and the disc: velocities are those of the steps' middles, as in all methods that leap. */
static double energy_of(const PhysicsRun *run, gsize sample, double h)
{
    double sum = 0;
    for (gsize i = 0; i < PILE + CHAIN + 1; i++) {
        const double mass = i < PILE ? 1 : i < PILE + CHAIN ? 0.2 : 5;
        const double y = physics_value(run, sample, 3 * i + 1) - 0.5 * h * physics_value(run, sample, 3 * i + 2);
        sum += physics_value(run, sample, 3 * i) + mass * g * y;
    }
    return sum;
}

/* The most that it ever has above the least before (J). */
static double gain_of(double h)
{
    g_autofree char *blocks = wrecking_ball();
    g_autoptr(GString) columns = g_string_new("");
    for (int i = 0; i < PILE + CHAIN + 1; i++) {
        const char *type = i < PILE ? "Box" : i < PILE + CHAIN ? "Bar" : "Disc";
        const int number = i < PILE ? i : i < PILE + CHAIN ? i - PILE : 0;
        g_string_append_printf(columns, "%s%s %d.kinetic energy, %s %d.y, %s %d.vy", i > 0 ? ", " : "", type, number,
                               type, number, type, number);
    }
    PhysicsOptions options = impulses(5, h, columns->str);
    options.interval = 0.01;
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
    double first = energy_of(run, 0, h), least = first, gain = 0;
    for (gsize i = 1; i < physics_samples(run); i++) {
        const double now = energy_of(run, i, h);
        gain = fmax(gain, now - least);
        least = fmin(least, now);
    }
    g_assert_cmpfloat(least, <, first - 100); /* it struck */
    check_held(run, 0);
    return gain;
}

/* Of some 200 J that go to and fro nothing comes from nowhere, but for what steps leave out to second order. */
static void test_wrecking_ball(void)
{
    static const double steps[] = {4e-3, 1e-3};
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++)
        physics_assert_near("gained", gain_of(steps[i]), 0, 2e4 * steps[i] * steps[i]);
}

/* Pairs of boxes, pinned at a corner or tied by rods and springs, that fly at one another without weight or walls. */
static void test_momentum(void)
{
    const double h = 1e-3;
    g_autoptr(GString) blocks = g_string_new(""), columns = g_string_new("");
    for (int i = 0; i < 16; i++) {
        const double x = i % 4 - 1.5, y = i / 4 - 1.5;
        g_string_append_printf(blocks,
                               "%s{'type': 'box', 'mass': %d, 'position': [%g, %g], 'velocity': [%g, %g], 'width': 0.6,"
                               "'height': 0.4, 'restitution': %g, 'angular_velocity': %g}",
                               i > 0 ? ", " : "", 1 + i % 3, x, y, -x + 0.3 * y, -1.2 * y - 0.2 * x, 0.25 * (i % 4),
                               0.7 * (i % 5) - 1.3);
        if (i % 4 == 1)
            g_string_append_printf(blocks,
                                   ", {'type': 'pin', 'ends': [{'block': 'Box %d', 'at': [0.5, 0]}, {'block': 'Box "
                                   "%d', 'at': [-0.5, 0]}]}",
                                   i - 1, i);
        if (i % 4 == 3)
            g_string_append_printf(blocks,
                                   ", {'type': '%s', 'ends': [{'block': 'Box %d', 'at': [0.3, 0.2]}, 'Box %d']}",
                                   i < 8 ? "rod" : "spring", i - 1, i);
        g_string_append_printf(columns, "%sBox %d.x, Box %d.y, Box %d.vx, Box %d.vy, Box %d.angular velocity",
                               i > 0 ? ", " : "", i, i, i, i, i);
    }
    PhysicsOptions options = impulses(3, h, columns->str);
    options.interval = 0.01;
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    double first[3], sums[3];
    for (gsize sample = 0; sample < physics_samples(run); sample++) {
        memset(sums, 0, sizeof(sums));
        for (gsize i = 0; i < 16; i++) {
            double at[5], mass = 1 + (double)(i % 3), inertia = mass * (0.36 + 0.16) / 12;
            for (gsize k = 0; k < 5; k++)
                at[k] = physics_value(run, sample, 5 * i + k);
            sums[0] += mass * at[2];
            sums[1] += mass * at[3];
            sums[2] += mass * (at[0] * at[3] - at[1] * at[2]) + inertia * at[4];
        }
        if (sample == 0) memcpy(first, sums, sizeof(sums));
        physics_assert_near("x momentum", sums[0], first[0], 1e-11);
        physics_assert_near("y momentum", sums[1], first[1], 1e-11);
        physics_assert_near("angular momentum", sums[2], first[2], 50 * h);
    }
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-13);
    g_assert_cmpfloat(run->summary->books[TINKER_BOOK_CONTACTS], <, -1);
}

static void add_tests(void)
{
    g_test_add_func("/physics/pile-joints/pendulum-strikes", test_pendulum_strikes);
    g_test_add_func("/physics/pile-joints/strikes-chain", test_strikes_chain);
    g_test_add_func("/physics/pile-joints/cart-rests", test_cart_rests);
    g_test_add_func("/physics/pile-joints/cart-rolls", test_cart_rolls);
    g_test_add_func("/physics/pile-joints/cart-down-a-slope", test_cart_down_a_slope);
    g_test_add_func("/physics/pile-joints/wrecking-ball", test_wrecking_ball);
    g_test_add_func("/physics/pile-joints/momentum", test_momentum);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
