/* Bodies that turn, and masses that collide, with contact as impulses: against closed forms, the laws of conservation,
 * and contact by events. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

static const double g = CONTACT_GRAVITY;

#define FLOOR                                                                                                          \
    CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 100, 'static_friction': 0.5, 'dynamic_friction': 0.5, 'restitution': 0}"

static PhysicsOptions impulses(double duration, double step, const char *columns)
{
    return (PhysicsOptions){.duration = duration, .step = step, .impulses = TRUE, .columns = columns};
}

static void test_rests(void)
{
    const PhysicsOptions options = impulses(10, 1.0 / 60, "Box 0.x, Box 0.y, Box 0.angle, Support 0.normal force");
    g_autoptr(PhysicsRun) run =
        physics_run(&options, FLOOR ", {'type': 'box', 'width': 1, 'height': 0.5, 'position': [0, 0.25]}");
    physics_assert_near("x", physics_last(run, 0), 0, 1e-13);
    physics_assert_near("y", physics_last(run, 1), 0.25, 1e-13);
    physics_assert_near("angle", physics_last(run, 2), 0, 1e-13);
    physics_assert_near("force", physics_last(run, 3), g, 1e-9);
}

/* Until it stops after v / (mu g). */
static double slid_off(double step)
{
    const PhysicsOptions options = impulses(1, step, "Box 0.x, Box 0.vx, Box 0.y");
    g_autoptr(PhysicsRun) run = physics_run(&options, FLOOR ", {'type': 'box', 'width': 1, 'height': 0.5, 'position': "
                                                            "[0, 0.25], 'velocity': [3, 0]}");
    physics_assert_near("vx", physics_last(run, 1), 0, 1e-12);
    physics_assert_near("y", physics_last(run, 2), 0.25, 1e-9);
    return physics_last(run, 0) - 4.5 / (0.5 * g);
}

static void test_slides(void)
{
    const double coarse = slid_off(0.01), fine = slid_off(0.001);
    physics_assert_near("x", coarse, 0, 0.02);
    physics_assert_near("a tenth", fine, 0.1 * coarse, 0.03 * fabs(coarse));
}

/* Down a slope of `angle`, without slipping where friction holds it: 2/3 g sin a; else g (sin a - mu cos a). */
static void roll(double friction, double step, double off[2])
{
    const double angle = 0.4, needed = tan(angle) / 3;
    const double along = friction >= needed ? 2.0 / 3 * g * sin(angle) : g * (sin(angle) - friction * cos(angle));
    const double spin = friction >= needed ? along : 2 * friction * g * cos(angle);
    g_autofree char *friction_text =
        g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g, 'restitution': 0", friction, friction);
    g_autofree char *slope = contact_plate(0, 0, -angle, 200, friction_text);
    const PhysicsOptions options = impulses(2, step, "Disc 0.x, Disc 0.y, Disc 0.angle");
    g_autoptr(PhysicsRun) run =
        physics_run(&options, CONTACT_WEIGHT "%s, {'type': 'disc', 'radius': 0.5, 'position': [%.17g, %.17g]}", slope,
                    0.5 * sin(angle), 0.5 * cos(angle));
    const double x = physics_last(run, 0) - 0.5 * sin(angle), y = physics_last(run, 1) - 0.5 * cos(angle);
    physics_assert_near("off the slope", x * sin(angle) + y * cos(angle), 0, 1e-9);
    off[0] = x * cos(angle) - y * sin(angle) - 2 * along;
    off[1] = -physics_last(run, 2) * 0.5 - 2 * spin;
}

static void test_rolls(void)
{
    for (int rough = 0; rough < 2; rough++) {
        double coarse[2], fine[2];
        roll(rough ? 0.5 : 0.1, 0.02, coarse);
        roll(rough ? 0.5 : 0.1, 0.01, fine);
        for (int k = 0; k < 2; k++) {
            g_assert_cmpfloat(fabs(coarse[k]), <, 0.1);
            physics_assert_near("half the step, half the error", fine[k], 0.5 * coarse[k], 0.02 * fabs(coarse[k]));
        }
    }
}

/* S7 of the benchmarks: ten stacks of ten boxes, a hundredth of a metre above one another, after 10 s. */
static void test_stacks(void)
{
    g_autoptr(GString) blocks = g_string_new(FLOOR);
    for (int i = 0; i < 100; i++)
        g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [%d, %.17g]}",
                               2 * (i / 10), 0.25 + 0.51 * (i % 10));
    const PhysicsOptions options =
        impulses(10, 1.0 / 60,
                 "Box 0.y, Box 9.y, Box 99.y, Box 99.x, Box 99.angle, Support 0.normal force, Box 94.normal force");
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    physics_assert_near("lowest", physics_last(run, 0), 0.25, 1e-8);
    physics_assert_near("highest", physics_last(run, 1), 4.75, 1e-8);
    physics_assert_near("of the last stack", physics_last(run, 2), 4.75, 1e-8);
    physics_assert_near("x", physics_last(run, 3), 18, 1e-8);
    physics_assert_near("angle", physics_last(run, 4), 0, 1e-8);
    physics_assert_near("floor", physics_last(run, 5), 100 * g, 1e-5);
    physics_assert_near("middle", physics_last(run, 6), 11 * g, 1e-5);
}

/* What a pile at rest is off by is what its sweeps leave: no scale for an error, and not a tenth of any motion. */
static void test_rests_surely(void)
{
    for (int count = 10; count <= 20; count += 10) {
        g_autoptr(GString) blocks = g_string_new(FLOOR);
        for (int i = 0; i < count; i++)
            g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.4, 'height': 0.4, 'position': [0, %.17g]}",
                                   0.2 + 0.4 * i);
        PhysicsOptions options = impulses(5, 0.01, "Box 9.x, Box 9.y");
        options.estimate = TRUE;
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
        physics_assert_near("x", physics_last(run, 0), 0, 1e-9);
        physics_assert_near("y", physics_last(run, 1), 3.8, 1e-9);
        physics_assert_near("estimate", run->summary->error_estimate, 0, 1e-8);
        g_assert_cmpuint(run->summary->warnings->len, ==, 0);
    }
}

/* Newton's law for all at once: what event mode has, too. */
static void test_three_balls(void)
{
    const PhysicsOptions options = impulses(1, 0.01, "Disc 0.vx, Disc 1.vx, Disc 2.vx");
    g_autoptr(PhysicsRun) run = physics_run(
        &options, "{'type': 'disc', 'position': [0, 0], 'radius': 0.1, 'restitution': 1, 'velocity': [1, 0]},"
                  "{'type': 'disc', 'radius': 0.1, 'restitution': 1, 'position': [0.7, 0]},"
                  "{'type': 'disc', 'radius': 0.1, 'restitution': 1, 'position': [0.9, 0]}");
    physics_assert_near("first", physics_last(run, 0), -1.0 / 3, 1e-9);
    physics_assert_near("second", physics_last(run, 1), 2.0 / 3, 1e-9);
    physics_assert_near("third", physics_last(run, 2), 2.0 / 3, 1e-9);
}

/* Masses that collide: elastic ones of 1 and 3 kg. */
static void test_masses(void)
{
    const PhysicsOptions options = impulses(1, 0.01, "Mass 0.vx, Mass 1.vx, Mass 0.vy");
    g_autoptr(PhysicsRun) run =
        physics_run(&options, "{'type': 'mass', 'collides': true, 'restitution': 1, 'velocity': [2, 0]},"
                              "{'type': 'mass', 'collides': true, 'mass': 3, 'position': [1, 0]}");
    physics_assert_near("first", physics_last(run, 0), -1, 1e-9);
    physics_assert_near("second", physics_last(run, 1), 1, 1e-9);
    physics_assert_near("across", physics_last(run, 2), 0, 1e-12);
}

/* Points that fall onto a bar without width, and rise against it, stay on their side: what is struck without any
 * rebound from above lies there, what is from below falls from there at once. */
static void test_thin(void)
{
    const double rises = 6, arrives = (rises - sqrt(rises * rises - 2 * 9.81 * 0.5)) / 9.81, left = 1 - arrives;
    for (int k = 0; k < 3; k++) {
        const double h = 1e-3 / (1 << k);
        const PhysicsOptions options = impulses(1, h, "Mass 0.y, Mass 1.y, Mass 0.vy");
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT "{'type': 'support', 'position': [0, 1], 'solid': false},"
                                     "{'type': 'bar', 'length': 4, 'width': 0, 'solid': true, 'position': [0, 1]},"
                                     "{'type': 'weld', 'ends': ['Support 0', 'Bar 0']}," CONTACT_POINT
                                     ", 'collides': true, 'position': [-0.5, 1.5], 'velocity': [0.4, 0]}," CONTACT_POINT
                                     ", 'collides': true, 'position': [0.5, 0.5], 'velocity': [0, 6]}");
        physics_assert_near("lies", physics_last(run, 0), 1, 1e-9);
        physics_assert_near("has fallen", physics_last(run, 1), 1 - 9.81 * left * left / 2, 20 * h);
        physics_assert_near("rests", physics_last(run, 2), 0, 1e-9);
    }
}

/* Bars without width that cross at the start go through one another until they have parted, and come free on whichever
 * side that is: nothing acts on the one that goes down across the other, ever. */
static void test_thin_passes(void)
{
    for (int k = 0; k < 2; k++) {
        const PhysicsOptions options = impulses(3, 0.01, "Bar 1.vy, Bar 1.y, Bar 1.angular velocity");
        g_autoptr(PhysicsRun) run = physics_run(
            &options,
            "{'type': 'support', 'position': [0, 0], 'solid': false},"
            "{'type': 'bar', 'length': 4, 'width': 0, 'solid': true, 'position': [0, 0]},"
            "{'type': 'weld', 'ends': ['Support 0', 'Bar 0']},"
            "{'type': 'bar', 'length': 1, 'width': 0, 'solid': true, 'position': [0.3, %g], 'orientation': 1.5,"
            " 'velocity': [0, %g]}",
            k == 0 ? 0.2 : -0.2, k == 0 ? -0.5 : 0.5);
        const double way = k == 0 ? -1 : 1;
        for (gsize i = 0; i < physics_samples(run); i++)
            physics_assert_near("vy", physics_value(run, i, 0), way * 0.5, 1e-12);
        physics_assert_near("y", physics_last(run, 1), way * (3 * 0.5 - 0.2), 1e-12);
        physics_assert_near("turns", physics_last(run, 2), 0, 1e-12);
    }
}

/* A box that comes down on a corner and rocks over a rough floor, through some ten impacts: to first order what events,
 * which know the instants of impacts, make of it. */
static void test_bounces(void)
{
    static const double steps[] = {1e-4, 1e-5};
    static const char *const columns = "Box 0.x, Box 0.y, Box 0.vx, Box 0.vy";
    static const char *const blocks = CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 100, 'static_friction': 0.3, 'dynamic_friction': 0.3, 'restitution': 0.5},"
        "{'type': 'box', 'width': 0.6, 'height': 0.4, 'mass': 2, 'position': [0, 2], 'orientation': 0.4}";
    PhysicsOptions events = {.duration = 1.4, .columns = columns};
    g_autoptr(PhysicsRun) exact = physics_run(&events, "%s", blocks);
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        const PhysicsOptions options = impulses(1.4, steps[i], columns);
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
        for (gsize column = 0; column < 4; column++)
            physics_assert_near("motion", physics_last(run, column), physics_last(exact, column), 200 * steps[i]);
    }
}

#define SWARM        16
#define SWARM_COLUMN "Box %d.x, Box %d.y, Box %d.vx, Box %d.vy, Box %d.angular velocity"

/* Boxes without weight or walls that fly at one another. */
static PhysicsRun *swarm_new(double step)
{
    g_autoptr(GString) blocks = g_string_new(""), columns = g_string_new("");
    for (int i = 0; i < SWARM; i++) {
        const double x = i % 4 - 1.5, y = i / 4 - 1.5;
        g_string_append_printf(blocks,
                               "%s{'type': '%s', 'mass': %d, 'position': [%g, %g], 'velocity': [%g, %g], 'width': 0.6,"
                               "'height': 0.4, 'restitution': %g, 'angular_velocity': %g}",
                               i > 0 ? ", " : "", "box", 1 + i % 3, x, y, -x + 0.3 * y, -1.2 * y - 0.2 * x,
                               0.25 * (i % 4), 0.7 * (i % 5) - 1.3);
        g_string_append_printf(columns, "%s" SWARM_COLUMN, i > 0 ? ", " : "", i, i, i, i, i);
    }
    PhysicsOptions options = impulses(3, step, columns->str);
    options.interval = 0.01;
    return physics_run(&options, "%s", blocks->str);
}

/* Momentum along x and y, angular momentum about the origin, and energy of a swarm. */
static void add_up_swarm(const PhysicsRun *run, gsize sample, double sums[4])
{
    memset(sums, 0, 4 * sizeof(double));
    for (gsize i = 0; i < SWARM; i++) {
        double at[5], mass = 1 + (double)(i % 3), inertia = mass * (0.36 + 0.16) / 12;
        for (gsize k = 0; k < 5; k++)
            at[k] = physics_value(run, sample, 5 * i + k);
        sums[0] += mass * at[2];
        sums[1] += mass * at[3];
        sums[2] += mass * (at[0] * at[3] - at[1] * at[2]) + inertia * at[4];
        sums[3] += 0.5 * mass * (at[2] * at[2] + at[3] * at[3]) + 0.5 * inertia * at[4] * at[4];
    }
}

/* Impulses are opposite and act along one line, whatever the laws make of them: that keeps momentum exactly, and
 * angular momentum to first order, as bodies move up to where they touch before they go on: a step times their energy.
 */
static void test_momentum(void)
{
    static const double steps[] = {1e-2, 1e-3};
    for (gsize i = 0; i < G_N_ELEMENTS(steps); i++) {
        g_autoptr(PhysicsRun) run = swarm_new(steps[i]);
        double first[4], sums[4];
        add_up_swarm(run, 0, first);
        for (gsize sample = 0; sample < physics_samples(run); sample++) {
            add_up_swarm(run, sample, sums);
            physics_assert_near("x momentum", sums[0], first[0], 1e-11);
            physics_assert_near("y momentum", sums[1], first[1], 1e-11);
            physics_assert_near("angular momentum", sums[2], first[2], steps[i] * first[3]);
            g_assert_cmpfloat(sums[3], <=, first[3] * (1 + 1e-9));
        }
        g_assert_cmpfloat(sums[3], <, 0.9 * first[3]);
    }
}

/* A box that turns as it falls onto an edge, rebounds and slides, by events: half the step, about half the error. */
static void test_as_by_events(void)
{
    static const char blocks[] = CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 100, 'static_friction': 0.4, 'dynamic_friction': 0.3},"
        "{'type': 'box', 'width': 0.8, 'height': 0.4, 'position': [0, 0.7], 'orientation': 0.3, 'velocity': [2, 0],"
        "'restitution': 0.3}";
    const char *columns = "Box 0.x, Box 0.y, Box 0.angle";
    g_autoptr(PhysicsRun) truth =
        physics_run(&(PhysicsOptions){.duration = 0.35, .tolerance = 1e-11, .columns = columns}, "%s", blocks);
    g_assert_cmpuint(truth->summary->events->len, >, 0);
    double sums[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++) /* over steps that meet the floor at different shares of them */
        for (int i = 0; i < 8; i++) {
            const PhysicsOptions options = impulses(0.35, 0.35 / ((90 + 7 * i) * (4 << (2 * k))), columns);
            g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
            for (gsize column = 0; column < 3; column++)
                sums[k] += fabs(physics_last(run, column) - physics_last(truth, column)) / 24;
        }
    g_assert_cmpfloat(sums[0], <, 0.005);
    for (int k = 0; k < 2; k++)
        physics_assert_near("a quarter of the step", sums[k + 1] / sums[k], 0.25, 0.05);
}

/* A pyramid of 55 boxes on a floor, and one of two rows beside it, stand where they were put. */
static void test_pyramid(void)
{
    g_autoptr(GString) blocks = g_string_new(FLOOR);
    for (int row = 0; row < 10; row++)
        for (int i = 0; i < 10 - row; i++)
            g_string_append_printf(blocks, ", {'type': 'box', 'width': 1, 'height': 0.5, 'position': [%.17g, %.17g]}",
                                   1.05 * (i + 0.5 * row), 0.25 + 0.5 * row);
    const PhysicsOptions options = impulses(5, 1.0 / 60, "Box 54.x, Box 54.y, Box 54.angle, Support 0.normal force");
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    physics_assert_near("x", physics_last(run, 0), 4.725, 1e-5);
    physics_assert_near("y", physics_last(run, 1), 4.75, 1e-6);
    physics_assert_near("angle", physics_last(run, 2), 0, 1e-6);
    physics_assert_near("floor", physics_last(run, 3), 55 * g, 1e-4);
}

/* Tops have one side: what comes from below or past an end goes through until it is clear, and lands then. */
static void test_one_side(void)
{
    const PhysicsOptions options = impulses(3, 0.005, "Box 0.y, Box 0.angle, Disc 0.y, Box 1.y");
    g_autoptr(PhysicsRun) run = physics_run(
        &options, FLOOR ", {'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [0, -2], 'velocity': [0, 9]},"
                        "{'type': 'disc', 'radius': 0.3, 'position': [5, -1], 'velocity': [0, 7]},"
                        "{'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [10, -8]}");
    physics_assert_near("box", physics_last(run, 0), 0.25, 1e-8);
    physics_assert_near("angle", physics_last(run, 1), 0, 1e-8);
    physics_assert_near("disc", physics_last(run, 2), 0.3, 1e-8);
    physics_assert_near("below", physics_last(run, 3), -8 - 4.5 * g, 0.1);
}

/* A belt of 2 m/s takes a box along by mu g until both are as fast. */
static void test_belt(void)
{
    const PhysicsOptions options = impulses(2, 0.001, "Box 0.vx, Box 0.x");
    g_autoptr(PhysicsRun) run = physics_run(
        &options, FLOOR ", {'type': 'support-motion', 'ends': ['Support 0'], 'waveform': {'expression': '2*t'}},"
                        "{'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [0, 0.25]}");
    physics_assert_near("vx", physics_last(run, 0), 2, 1e-9);
    physics_assert_near("x", physics_last(run, 1), 4 - 0.5 * 4 / (0.5 * g), 0.005);
}

/* Warnings of steps that were not solved for. */
static guint count_unsolved(const PhysicsRun *run)
{
    guint count = 0;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        count += strstr(tinker_warnings_text(run->summary->warnings, i), "before the impulses") != NULL;
    return count;
}

/* A heavy disc runs into a wall of boxes, which a step cannot solve for within its sweeps: the run says so, once. Of
 * a stack that it solves for it does not. */
static void test_warns(void)
{
    g_autoptr(GString) blocks = g_string_new(FLOOR);
    for (int i = 0; i < 100; i++)
        g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [%g, %g]}",
                               0.5 * (i / 10) + 0.25 * (i % 2), 0.25 + 0.5 * (i % 10));
    const PhysicsOptions options = impulses(0.5, 1.0 / 60, NULL);
    g_string_append(blocks, ", {'type': 'disc', 'radius': 1, 'mass': 100, 'position': [-3, 2], 'velocity': [20, 0]}");
    g_autoptr(PhysicsRun) struck = physics_run(&options, "%s", blocks->str);
    g_assert_cmpuint(count_unsolved(struck), ==, 1);
    g_autoptr(PhysicsRun) rests =
        physics_run(&options, FLOOR ", {'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [0, 0.25]},"
                                    "{'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [0, 0.76]},"
                                    "{'type': 'box', 'width': 0.5, 'height': 0.5, 'position': [0, 1.27]}");
    g_assert_cmpuint(count_unsolved(rests), ==, 0);
}

static void test_refused(void)
{
    PhysicsOptions options = impulses(1, 0.01, NULL);
    g_autoptr(PhysicsRun) tied =
        physics_try(&options, FLOOR ", {'type': 'box', 'position': [0, 2]}, {'type': 'mass', 'position': [3, 2]}, "
                                    "{'type': 'rod', 'ends': ['Mass 0', 'Box 0']}");
    physics_assert_refused(tied, TINKER_MODEL_ERROR_METHOD, "Mass 0", "Box 0", "collides", "events", NULL);
    options.impact_law = "poisson";
    g_autoptr(PhysicsRun) law = physics_try(&options, FLOOR ", {'type': 'box', 'position': [0, 2]}");
    physics_assert_refused(law, TINKER_MODEL_ERROR_METHOD, "poisson", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/physics/pile/rests", test_rests);
    g_test_add_func("/physics/pile/slides", test_slides);
    g_test_add_func("/physics/pile/rolls", test_rolls);
    g_test_add_func("/physics/pile/stacks", test_stacks);
    g_test_add_func("/physics/pile/rests-surely", test_rests_surely);
    g_test_add_func("/physics/pile/three-balls", test_three_balls);
    g_test_add_func("/physics/pile/masses", test_masses);
    g_test_add_func("/physics/pile/thin", test_thin);
    g_test_add_func("/physics/pile/thin-passes", test_thin_passes);
    g_test_add_func("/physics/pile/bounces", test_bounces);
    g_test_add_func("/physics/pile/momentum", test_momentum);
    g_test_add_func("/physics/pile/as-by-events", test_as_by_events);
    g_test_add_func("/physics/pile/pyramid", test_pyramid);
    g_test_add_func("/physics/pile/one-side", test_one_side);
    g_test_add_func("/physics/pile/belt", test_belt);
    g_test_add_func("/physics/pile/warns", test_warns);
    g_test_add_func("/physics/pile/refused", test_refused);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
