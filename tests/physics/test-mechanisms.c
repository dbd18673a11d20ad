/* Mechanisms of many pinned bars. */
#include "physics-fixture.h"

#include <math.h>

#define FOOT   ", {'type': 'pin', 'ends': ['A%d', {'block': 'up%d', 'at': [-0.5, 0]}]}"
#define CORNER ", {'type': 'pin', 'ends': [{'block': 'up%d', 'at': [0.5, 0]}, {'block': 'across%d', 'at': [%g, 0]}]}"
#define UPRIGHT                                                                                                        \
    ", {'type': 'bar', 'name': 'up%d', 'position': [%d, 0.5], 'orientation': 1.5707963267948966,"                      \
    " 'velocity': [0.5, 0], 'angular_velocity': -1}"
#define ACROSS  ", {'type': 'bar', 'name': 'across%d', 'position': [%g, 1], 'velocity': [1, 0]}"
#define SUPPORT ", {'type': 'support', 'name': 'A%d', 'position': [%d, 0], 'solid': false}"

#define PIN  ", {'type': 'pin', 'ends': [{'block': 'Bar %d', 'at': [%g, 0]}, {'block': 'Bar %d', 'at': [%g, 0]}]}"
#define WELD ", {'type': 'weld', 'ends': [{'block': 'Bar %d', 'at': [0.5, 0]}, {'block': 'Bar %d', 'at': [-0.5, 0]}]}"

/* Square windows side by side, of bars of 1 m and 1 kg: benchmark A02 of the IFToMM library of computational benchmark
 * problems. It has one freedom and lies flat twice a turn, where each window could fold as well. (transfer full) */
static char *windows(int count)
{
    GString *blocks = g_string_new("{'type': 'gravity'}");
    for (int i = 0; i <= count; i++)
        g_string_append_printf(blocks, SUPPORT UPRIGHT FOOT, i, i, i, i, i, i);
    for (int i = 0; i < count; i++)
        g_string_append_printf(blocks, ACROSS CORNER CORNER, i, i + 0.5, i, i, -0.5, i + 1, i, 0.5);
    return g_string_free(blocks, FALSE);
}

/* Twice the place and velocity of the first upright, whose top is B0, where all windows move together: in closed form,
 * by elliptic functions of Jacobi. */
static const double times[] = {0.5, 1, 2, 5, 10};
static const double truth[][4] = {
    {0.68792597079077263444, 0.72578086135663086675, 1.9291623112747427180, -1.8285420937057935621},
    {-0.11535688063210989806, -0.99332411130045018569, -6.6699875239417715908, 0.77460009866234331520},
    {0.034466307300407161856, 0.99940586032956295647, 1.0059511728141093840, -0.034692034165161764618},
    {-0.54019005067552627413, -0.84154305246444305486, -5.4363691125785487470, 3.4896283651973379845},
    {0.18051222668672839010, 0.98357274058231157488, 1.1484412774694141333, -0.21077006677942393178},
};

static void test_windows(void)
{
    g_autofree char *blocks = windows(40);
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = "auto",
                                                              .tolerance = 1e-11,
                                                              .duration = 10,
                                                              .columns = "up0.x, up0.y, up0.vx, up0.vy",
                                                              .at = times,
                                                              .at_count = G_N_ELEMENTS(times)},
                                            "%s", blocks);
    g_test_message("%g evaluations", (double)run->summary->evaluations);
    for (gsize i = 0; i < G_N_ELEMENTS(times); i++)
        for (gsize k = 0; k < 4; k++)
            physics_assert_near("top of the first upright", 2 * physics_value(run, i, k), truth[i][k], 2e-8);
    /* a step that stops at each flat place would take ten times as many */
    g_assert_cmpint(run->summary->evaluations, <, 8000);
}

/* Methods of a fixed step begin some of their steps before a flat place and end them behind it. Errors of order 2 are
 * of the size 10 (h w)^2, with w of 5 rad/s at the fastest. */
static void test_windows_by_steps(void)
{
    static const struct {
        const char *method;
        double step, bound;
    } cases[] = {{"verlet", 1e-2, 2.5e-2},
                 {"verlet", 1e-3, 2.5e-4},
                 {"verlet6", 5e-3, 1e-5},
                 {"newmark", 1e-3, 2.5e-4},
                 {"generalized-alpha", 1e-3, 2.5e-4}};
    g_autofree char *blocks = windows(40);
    for (gsize m = 0; m < G_N_ELEMENTS(cases); m++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = cases[m].method,
                                                                  .step = cases[m].step,
                                                                  .duration = 10,
                                                                  .columns = "up0.x, up0.y",
                                                                  .at = times,
                                                                  .at_count = G_N_ELEMENTS(times)},
                                                "%s", blocks);
        for (gsize i = 0; i < G_N_ELEMENTS(times); i++)
            for (gsize k = 0; k < 2; k++)
                physics_assert_near(cases[m].method, 2 * physics_value(run, i, k), truth[i][k], cases[m].bound);
    }
}

/* Bars pinned end to end, of different masses, and a point mass at the end. Beside a rope
 * that stays slack their rows are solved in general, not along the chain. */
static void test_chain(void)
{
    enum { BARS = 12 };
    static const char rope[] = ", {'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 100}";
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    for (int i = 0; i < BARS; i++)
        g_string_append_printf(blocks, ", {'type': 'bar', 'position': [%g, 0], 'mass': %g, 'inertia': %g}", i + 0.5,
                               1 + 0.3 * (i % 3), 0.1 + 0.05 * (i % 4));
    g_string_append_printf(blocks, ", {'type': 'mass', 'position': [%d, 0], 'mass': 2}", BARS);
    g_string_append(blocks, ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    for (int i = 1; i < BARS; i++)
        g_string_append_printf(blocks, PIN, i - 1, 0.5, i, -0.5);
    g_string_append(blocks, ", {'type': 'pin', 'ends': ['Mass 0', {'block': 'Bar 11', 'at': [0.5, 0]}]}");
    static const char *const methods[] = {"dop853", "rk4", "verlet"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        const PhysicsOptions options = {.method = methods[m],
                                        .step = 1e-3,
                                        .duration = 0.5,
                                        .columns =
                                            "Bar 5.x, Bar 5.angle, Bar 11.vy, Mass 0.y, Pin 3.force, Pin 12.force"};
        g_autoptr(PhysicsRun) along = physics_run(&options, "%s", blocks->str);
        g_autoptr(PhysicsRun) general = physics_run(&options, "%s%s", blocks->str, rope);
        for (gsize i = 0; i < physics_samples(along); i++)
            for (gsize k = 0; k < 6; k++)
                physics_assert_near("of both", physics_value(along, i, k), physics_value(general, i, k),
                                    1e-8 * (1 + fabs(physics_value(general, i, k))));
    }
}

/* Bars of 1 m in one line, from a pin on: a slender bar of their length, which falls from level with 1.5 g / length. */
static void test_welded_bars(void)
{
    enum { BARS = 1000 };
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    for (int i = 0; i < BARS; i++)
        g_string_append_printf(blocks, ", {'type': 'bar', 'position': [%g, 0]}", i + 0.5);
    g_string_append(blocks, ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    for (int i = 1; i < BARS; i++)
        g_string_append_printf(blocks, WELD, i - 1, i);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "auto", .duration = 0.1, .columns = "Bar 0.angular acceleration, Bar 999.ay"}, "%s",
        blocks->str);
    const double falls = -1.5 * 9.81 / BARS;
    physics_assert_near("angular acceleration", physics_value(run, 0, 0), falls, 1e-7 * fabs(falls));
    physics_assert_near("of the last", physics_value(run, 0, 1), falls * (BARS - 0.5), 1e-7 * fabs(falls) * BARS);
}

/* Bars of 0.1 m and 0.1 kg in one line, let go: m g times how far the middle has fallen is the energy, w^2 = 3 g sin(a)
 * / l, in some steps, as the motion is that of one bar. */
static void test_welded_fall(void)
{
    enum { BARS = 1000 };
    g_autoptr(GString) blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}");
    for (int i = 0; i < BARS; i++)
        g_string_append_printf(blocks, ", {'type': 'bar', 'length': 0.1, 'mass': 0.1, 'position': [%.17g, 0]}",
                               0.1 * (i + 0.5));
    g_string_append(blocks, ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.05, 0]}]}");
    for (int i = 1; i < BARS; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'weld', 'ends': [{'block': 'Bar %d', 'at': [0.05, 0]},"
                               " {'block': 'Bar %d', 'at': [-0.05, 0]}]}",
                               i - 1, i);
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = "auto",
                                                              .tolerance = 1e-9,
                                                              .duration = 1,
                                                              .columns = "Bar 0.angle, Bar 999.angle, Bar 999.angular "
                                                                         "velocity"},
                                            "%s", blocks->str);
    const double angle = physics_last(run, 0), rate = -sqrt(3 * 9.81 * sin(-angle) / (0.1 * BARS));
    physics_assert_near("angle of the last", physics_last(run, 1), angle, 1e-8);
    physics_assert_near("rate", physics_last(run, 2), rate, 1e-8);
    g_assert_cmpint(run->summary->steps, <, 100);
}

/* A bar between two nodes of a truss, i + j / 2 for its node (i, j), with a pin to what stands at each of them first.
 */
static void add_bar(GString *blocks, GPtrArray *nodes, int number, int from, int to)
{
    const double dx = to / 2 - from / 2, dy = to % 2 - from % 2, length = hypot(dx, dy);
    g_string_append_printf(
        blocks, ", {'type': 'bar', 'name': 'B%d', 'position': [%g, %g], 'orientation': %.17g, 'length': %.17g}", number,
        from / 2 + 0.5 * dx, from % 2 + 0.5 * dy, atan2(dy, dx), length);
    for (int end = 0; end < 2; end++) {
        const int node = end == 0 ? from : to;
        char *own = g_strdup_printf("{'block': 'B%d', 'at': [%.17g, 0]}", number, (end - 0.5) * length);
        const char *first = nodes->pdata[node];
        if (first != NULL) g_string_append_printf(blocks, ", {'type': 'pin', 'ends': [%s, %s]}", first, own);
        if (first == NULL)
            nodes->pdata[node] = own;
        else
            g_free(own);
    }
}

enum { SQUARES = 60 };

/* At the wall, in the order of the bars: below, above, below, and above once more. */
#define AT_WALL                                                                                                        \
    "Pin 0.force x, Pin 2.force x, Pin 1.force x, Pin 4.force x, Pin 0.force y, Pin 2.force y, Pin 1.force y, "        \
    "Pin 4.force y"

/* A cantilever of so many squares with both diagonals, of which one is redundant in each. (transfer full) */
static char *long_truss(void)
{
    GString *blocks = g_string_new("{'type': 'gravity'}, {'type': 'support', 'solid': false}, "
                                   "{'type': 'support', 'position': [0, 1], 'solid': false}");
    g_autoptr(GPtrArray) nodes = g_ptr_array_new_with_free_func(g_free);
    g_ptr_array_set_size(nodes, 2 * SQUARES + 2);
    nodes->pdata[0] = g_strdup("'Support 0'");
    nodes->pdata[1] = g_strdup("'Support 1'");
    for (int i = 0; i < SQUARES; i++) {
        static const int bars[5][2] = {{0, 2}, {1, 3}, {0, 3}, {1, 2}, {2, 3}};
        for (int k = 0; k < 5; k++)
            add_bar(blocks, nodes, 5 * i + k, 2 * i + bars[k][0], 2 * i + bars[k][1]);
    }
    return g_string_free(blocks, FALSE);
}

/* By statics its weight, as heavy as it is made, hangs on the wall, and the couple of the two places there holds its
 * moment. */
static void assert_holds(const PhysicsRun *run, gsize sample, double heavier)
{
    const double weight = 5 * SQUARES * 9.81 * heavier, moment = weight * (0.5 * SQUARES + 0.1);
    double sums[3] = {0};
    for (gsize k = 0; k < 8; k++)
        sums[k / 4 == 1 ? 2 : k / 2] += physics_value(run, sample, k);
    physics_assert_near("couple below", fabs(sums[0]), moment, 1e-7 * moment);
    physics_assert_near("couple above", sums[1], -sums[0], 1e-7 * moment);
    physics_assert_near("weight", fabs(sums[2]), weight, 1e-7 * weight);
}

static void test_long_truss(void)
{
    g_autofree char *blocks = long_truss();
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = 0.1, .columns = AT_WALL}, "%s", blocks);
    for (gsize i = 0; i < physics_samples(run); i++)
        assert_holds(run, i, 1);
}

/* The wall moves up by sin(2 t) / 2, and takes the truss along from the start on, as one body. */
static void test_lifted_truss(void)
{
    static const char lifts[] = "{'type': 'support-motion', 'ends': ['Support %d'], 'angle': '90 deg', 'waveform': "
                                "{'expression': '0.5*sin(2*t)'}}";
    g_autofree char *blocks = long_truss(), *below = g_strdup_printf(lifts, 0), *above = g_strdup_printf(lifts, 1);
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = "auto",
                                                              .duration = 0.1,
                                                              .columns = AT_WALL ", B0.vy, B299.vy, B299.angular "
                                                                                 "velocity"},
                                            "%s, %s, %s", blocks, below, above);
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i);
        assert_holds(run, i, 1 - 2 * sin(2 * t) / 9.81);
        physics_assert_near("speed of the first", physics_value(run, i, 8), cos(2 * t), 1e-7);
        physics_assert_near("of the last", physics_value(run, i, 9), cos(2 * t), 1e-7);
        physics_assert_near("its turning", physics_value(run, i, 10), 0, 1e-7);
    }
}

static void add_tests(void)
{
    g_test_add_func("/mechanisms/windows", test_windows);
    g_test_add_func("/mechanisms/windows-by-steps", test_windows_by_steps);
    g_test_add_func("/mechanisms/chain", test_chain);
    g_test_add_func("/mechanisms/welded-bars", test_welded_bars);
    g_test_add_func("/mechanisms/welded-fall", test_welded_fall);
    g_test_add_func("/mechanisms/long-truss", test_long_truss);
    g_test_add_func("/mechanisms/lifted-truss", test_lifted_truss);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
