/* Bodies of very different masses that touch: what presses is the weight of all that lies above, whatever lies between;
 * and a light body between two heavy ones that close on it. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* A box on a light one, or on a light disc that is balanced under its middle, on the floor. */
static PhysicsRun *heavy_on_light(const char *light, double mass, double heavy)
{
    PhysicsOptions options = {.method = "dop853",
                              .tolerance = 1e-9,
                              .columns =
                                  "Heavy.normal force, Light.normal force, Floor.normal force, Heavy.y, Light.x"};
    return physics_run(
        &options,
        CONTACT_WEIGHT CONTACT_FLOOR
        ", 'name': 'Floor', 'width': 20},"
        "{'type': %s, 'name': 'Light', 'mass': %.17g, 'position': [0, 0.5]},"
        "{'type': 'box', 'name': 'Heavy', 'mass': %.17g, 'width': 1.5, 'height': 1, 'position': [0, 1.5]}",
        light, mass, heavy);
}

/* `Light.normal force` is what presses it from both sides. */
static void check_heavy_on_light(const char *light, double mass, double heavy)
{
    g_autoptr(PhysicsRun) run = heavy_on_light(light, mass, heavy);
    const double above = heavy * g, below = (heavy + mass) * g;
    for (gsize i = 0; i < physics_samples(run); i++) {
        physics_assert_near("what the floor bears", physics_value(run, i, 2), below, 1e-13 * below);
        physics_assert_near("what bears the heavy one", physics_value(run, i, 0), above, 1e-13 * above);
        physics_assert_near("both sides of the light one", physics_value(run, i, 1), above + below, 2e-13 * below);
        physics_assert_near("the height of the heavy one", physics_value(run, i, 3), 1.5, 1e-15);
        physics_assert_near("the place of the light one", physics_value(run, i, 4), 0, 1e-15);
    }
    g_assert_cmpuint(run->summary->events->len, ==, 0);
    g_assert_cmpint(run->summary->steps, <, 20);
}

static void test_statics(void)
{
    static const double light[] = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10};
    for (gsize i = 0; i < G_N_ELEMENTS(light); i++) {
        check_heavy_on_light("'box', 'width': 1, 'height': 1", light[i], 1);
        check_heavy_on_light("'disc', 'radius': 0.5", light[i], 1);
    }
    check_heavy_on_light("'box', 'width': 1, 'height': 1", 1e-6, 1e3);
    check_heavy_on_light("'disc', 'radius': 0.5", 1e-6, 1e3);
}

/* Boxes by turns heavy and light: each bears what is above it. */
static void test_tower(void)
{
    static const double mass[] = {20, 0.02, 30, 1e-4, 10, 1e-3, 5};
    enum { BOXES = G_N_ELEMENTS(mass) };
    PhysicsOptions options = {.method = "dop853", .tolerance = 1e-9, .columns = "Floor.normal force, Top.normal force"};
    g_autoptr(GString) blocks = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'name': 'Floor', 'width': 20}");
    double weight = 0;
    for (int i = 0; i < BOXES; i++) {
        g_autofree char *name = i == BOXES - 1 ? g_strdup("Top") : g_strdup_printf("Box %d", i);
        g_string_append_printf(blocks,
                               ", {'type': 'box', 'name': '%s', 'mass': %.17g, 'width': 1, 'height': 0.5, 'position': "
                               "[0, %.17g]}",
                               name, mass[i], 0.25 + 0.5 * i);
        weight += mass[i] * g;
    }
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    physics_assert_near("what the floor bears", physics_last(run, 0), weight, 1e-13 * weight);
    physics_assert_near("what bears the top one", physics_last(run, 1), mass[BOXES - 1] * g, 1e-12 * weight);
    g_assert_cmpint(run->summary->steps, <, 20);
    g_assert_cmpfloat(run->summary->energy_balance_error, <=, 1e-12);
}

/* Two points on one line above a floor, x < y, that fly without gravity and strike with restitution e, as long as one
 * does: answers the time at which no blow follows any more. Written down blow by blow. */
static double end_of_blows(double m, double x, double u, double mass, double y, double v, double e)
{
    double t = 0;
    for (int blows = 0; blows < 100000; blows++) {
        const double floor = u < 0 ? x / -u : INFINITY, other = u > v ? (y - x) / (u - v) : INFINITY;
        const double next = fmin(floor, other);
        if (!isfinite(next) || t + next == t) break;
        t += next;
        x += u * next;
        y += v * next;
        if (floor <= other) {
            u *= -e;
        } else {
            const double push = (1 + e) * (u - v) * m * mass / (m + mass);
            u -= push / m;
            v += push / mass;
        }
    }
    return t;
}

/* A light box between the floor and a heavy one that comes down strikes both by turns, ever sooner. When the gaps are
 * used up both are at rest: all the energy that there was is gone. */
static void test_rattles(void)
{
    static const double e = 0.3, mass[] = {10, 400};
    for (gsize i = 0; i < G_N_ELEMENTS(mass); i++) {
        PhysicsOptions options = {
            .method = "dop853", .tolerance = 1e-11, .duration = 2, .columns = "Light.y, Light.vy, Heavy.y, Heavy.vy"};
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_FLOOR
                        ", 'restitution': 0.3}, {'type': 'mass', 'name': 'Light', 'collides': true, 'width': 0.5, "
                        "'height': 0.5, 'restitution': 0.3, 'position': [0, 0.75], 'velocity': [0, -0.25]},"
                        "{'type': 'mass', 'name': 'Heavy', 'mass': %g, 'collides': true, 'width': 0.5, 'height': 0.5, "
                        "'restitution': 0.3, 'position': [0, 1.5], 'velocity': [0, -1]}",
                        mass[i]);
        const double end = end_of_blows(1, 0.5, -0.25, mass[i], 0.75, -1, e);
        const GPtrArray *events = run->summary->events;
        const TinkerEvent *last = g_ptr_array_index(events, events->len - 1);
        physics_assert_near("the end of the blows", last->time, end, 1e-9);
        physics_assert_near("the light one", physics_last(run, 0), 0.25, 1e-9);
        physics_assert_near("the heavy one", physics_last(run, 2), 0.75, 1e-9);
        physics_assert_near("the speed of the light one", physics_last(run, 1), 0, 1e-12);
        physics_assert_near("the speed of the heavy one", physics_last(run, 3), 0, 1e-12);
        contact_assert_taken(run, 0, 0.5 * (0.25 * 0.25 + mass[i]), 1e-9 * mass[i]);
    }
}

static void add_tests(void)
{
    g_test_add_func("/contact-uneven/statics", test_statics);
    g_test_add_func("/contact-uneven/tower", test_tower);
    g_test_add_func("/contact-uneven/rattles", test_rattles);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
