/* Masses that collide meet each other, and bodies that turn: against conservation laws, and against the counts and
 * times that follow from reflections. */
#include "contact-checks.h"

#include <math.h>

#define CART "{'type': 'mass', 'width': 0.2, 'height': 0.2, 'collides': true"

/* Two on a smooth floor: both velocities follow from momentum and e. */
static void test_carts(void)
{
    static const double restitutions[] = {0, 0.4, 1};
    for (gsize i = 0; i < G_N_ELEMENTS(restitutions); i++)
        for (gsize k = 0; k < CONTACT_METHODS; k++) {
            const double e = restitutions[i], u = (0.5 * 2 - 1.5 * 1) / 2;
            PhysicsOptions options =
                contact_options(&contact_methods[k], 1, "Mass 0.x, Mass 0.vx, Mass 1.vx, Mass 1.y");
            g_autoptr(PhysicsRun) run = physics_run(
                &options,
                CONTACT_WEIGHT CONTACT_FLOOR
                ", 'width': 40, " CONTACT_SMOOTH "}," CART ", 'mass': 0.5, 'position': [0, 0.1], 'velocity': [2, 0],"
                " 'restitution': %g}," CART ", 'mass': 1.5, 'position': [1.7, 0.1], 'velocity': [-1, 0]}",
                e);
            contact_assert_event(run, e > 0 ? "impact" : "rest", "Mass 0, Mass 1", 0.5, 1e-9);
            physics_assert_near("vx", physics_last(run, 1), u - e * 1.5 * 3 / 2, 1e-9);
            physics_assert_near("the other's", physics_last(run, 2), u + e * 0.5 * 3 / 2, 1e-9);
            physics_assert_near("x", physics_last(run, 0), 1 + 0.5 * (u - e * 1.5 * 3 / 2), 1e-9);
            physics_assert_near("y", physics_last(run, 3), 0.1, 1e-12);
        }
}

/* A wall, a small mass and a large one that comes: as many blows as pi has digits for, and the last of them when the
 * path, unfolded at the walls of a wedge of angle atan(1/10^n), leaves it. Source: G. Galperin, "Playing pool with pi
 * (the number pi from a billiard point of view)", Regular and Chaotic Dynamics 8 (2003) 375-394. */
static void test_pi(void)
{
    static const struct {
        double mass;
        int blows;
    } cases[] = {{1, 3}, {100, 31}, {1e4, 314}, {1e6, 3141}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const double root = sqrt(cases[i].mass), wedge = atan(1 / root);
        /* straight on at speed root from (2 root, 1): blow k is at the angle k wedge */
        const double y = 1, last = (2 * root - y / tan(cases[i].blows * wedge)) / root;
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 10, .columns = "Mass 0.vx, Mass 1.vx, Mass 0.y"},
            "{'type': 'support', 'orientation': '-90 deg', 'position': [-0.2, 0], " CONTACT_SMOOTH
            ", 'restitution': 1}," CART ", 'position': [1.1, 0], 'restitution': 1, " CONTACT_SMOOTH "}," CART
            ", 'mass': %.17g, 'position': [2.3, 0], 'velocity': [-1, 0], 'restitution': 1, " CONTACT_SMOOTH "}",
            cases[i].mass);
        const GPtrArray *events = run->summary->events;
        contact_assert_count(run, "impact", cases[i].blows);
        const TinkerEvent *final = g_ptr_array_index(events, events->len - 1);
        physics_assert_near("last blow", final->time, last, 1e-9);
        const double vx = physics_last(run, 0), large = physics_last(run, 1);
        physics_assert_near("energy", vx * vx + cases[i].mass * large * large, cases[i].mass, 1e-9 * cases[i].mass);
        g_assert_cmpfloat(vx, <=, large);
        physics_assert_near("y", physics_last(run, 2), 0,
                            2e-15 * (cases[i].mass + 10)); /* the wall is 6e-17 rad askew */
    }
}

/* Bare points on one line, which need not lie along an axis, exchange their velocities; beside it they pass. */
static void test_points(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 2, .columns = "Mass 0.vx, Mass 1.vx, Mass 1.vy, Mass 2.vx, Mass 2.vy"},
        CONTACT_POINT ", 'velocity': [0.6, 0.8], 'collides': true, 'restitution': 1}," CONTACT_POINT
                      ", 'position': [0.6, 0.8], 'collides': true}," CONTACT_POINT
                      ", 'position': [3, 0.8], 'velocity': [-1, -1e-3], 'collides': true}");
    contact_assert_event(run, "impact", "Mass 0, Mass 1", 1, 1e-12);
    contact_assert_count(run, "impact", 1);
    physics_assert_near("stands", physics_last(run, 0), 0, 1e-12);
    physics_assert_near("vx", physics_last(run, 1), 0.6, 1e-12);
    physics_assert_near("vy", physics_last(run, 2), 0.8, 1e-12);
    physics_assert_near("passes", physics_last(run, 3), -1, 0);
}

/* A point, or a line, that strikes a line from either side rebounds once and stays on that side. */
static void test_lines(void)
{
    static const char *struck[] = {"{'type': 'mass', 'width': 0, 'height': 0.4, 'collides': true",
                                   "{'type': 'bar', 'length': 0.4, 'width': 0, 'solid': true, 'orientation': '90 deg'"};
    static const double restitutions[] = {0, 0.5, 1}, speeds[] = {1.3, -0.7};
    for (int i = 0; i < 2 * 2 * 3 * 2; i++) {
        const double e = restitutions[i / 2 % 3], u = speeds[i % 2], high = 0.1 * (i / 6 % 2);
        const gboolean bar = i / 12 == 1;
        /* the bar is struck in its middle, so that it does not turn */
        const double at = bar ? 0 : 0.05, hits = 0.3;
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 0.5, .columns = bar ? "Bar 0.vx, Mass 0.vx" : "Mass 0.vx, Mass 1.vx"},
            CONTACT_WEIGHT
            "%s, 'mass': 3, 'position': [0.1, 0.2], 'velocity': [0.4, 0.6], 'restitution': %g," CONTACT_SMOOTH
            "}, {'type': 'mass', 'width': 0, 'height': %g, 'collides': true,"
            "'position': [%.17g, %.17g], 'velocity': [%.17g, 0.6]," CONTACT_SMOOTH "}",
            struck[bar], e, high, 0.1 - u * hits, 0.2 + at, 0.4 + u);
        contact_assert_event(run, e > 0 ? "impact" : "rest", bar ? "Bar 0, Mass 0" : "Mass 0, Mass 1", hits, 1e-12);
        physics_assert_near("the line's", physics_last(run, 0), 0.4 + (1 + e) * u / 4, 1e-9);
        physics_assert_near("the point's", physics_last(run, 1), 0.4 + u - (1 + e) * u * 3 / 4, 1e-9);
    }
}

/* A bullet that strikes a block of no friction from above, and stays in its path: along the face nothing is taken. */
static void test_glancing(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Mass 0.vx, Mass 0.vy, Mass 1.vx, Mass 1.vy"},
                    "{'type': 'mass', 'collides': true, 'mass': 3, 'width': 2, 'height': 0.4, 'orientation': '30 "
                    "deg'," CONTACT_SMOOTH "}," CONTACT_POINT
                    ", 'collides': true, 'position': [0.1, 1], 'velocity': [0, -2], 'restitution': 0.5}");
    const double n[2] = {-0.5, sqrt(0.75)}, push = 1.5 * 2 * n[1] / (1 + 1.0 / 3);
    contact_assert_event(run, "impact", "Mass 0, Mass 1", (n[0] * 0.1 + n[1] - 0.2) / (2 * n[1]), 1e-9);
    physics_assert_near("vx", physics_last(run, 2), push * n[0], 1e-12);
    physics_assert_near("vy", physics_last(run, 3), push * n[1] - 2, 1e-12);
    physics_assert_near("block's vx", physics_last(run, 0), -push * n[0] / 3, 1e-12);
    physics_assert_near("block's vy", physics_last(run, 1), -push * n[1] / 3, 1e-12);
}

/* Five blocks in a row with room between them: the last goes on with the velocity of the first. */
static void test_cradle(void)
{
    g_autoptr(GString) blocks = g_string_new("{'type': 'support', 'solid': false}");
    for (int i = 0; i < 5; i++)
        g_string_append_printf(blocks, "," CART ", 'restitution': 1, 'position': [%g, 1], 'velocity': [%d, 0]}",
                               0.5 * i, i == 0);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 3, .columns = "Mass 0.vx, Mass 3.vx, Mass 4.vx, Mass 3.x"}, "%s", blocks->str);
    contact_assert_count(run, "impact", 4);
    contact_assert_event(run, "impact", "Mass 3, Mass 4", 1.2, 1e-9);
    physics_assert_near("first", physics_last(run, 0), 0, 1e-12);
    physics_assert_near("fourth", physics_last(run, 1), 0, 1e-12);
    physics_assert_near("last", physics_last(run, 2), 1, 1e-12);
    physics_assert_near("its place", physics_last(run, 3), 1.8, 1e-9);
}

/* One mass upon another that a rough floor holds: it slides to rest, presses with its weight, and falls off the end of
 * a shorter one. Neither is turned by landing. */
static void test_upon(void)
{
    const double g = CONTACT_GRAVITY;
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1, .columns = "Mass 1.x, Mass 1.y, Support 0.normal force, Mass 1.vx"},
        CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 40},"
        "{'type': 'mass', 'collides': true, 'mass': 9, 'width': 6, 'height': 0.4, 'position': [0, 0.2]},"
        "{'type': 'mass', 'collides': true, 'width': 0.4, 'height': 0.2, 'position': [-1, 0.5],"
        " 'velocity': [1.5, 0]}");
    contact_assert_event(run, "stick", "Mass 0, Mass 1", 1.5 / (0.5 * g), 1e-9);
    physics_assert_near("x", physics_last(run, 0), -1 + 1.5 * 1.5 / g, 1e-9);
    physics_assert_near("y", physics_last(run, 1), 0.5, 1e-12);
    physics_assert_near("weight", physics_last(run, 2), 10 * g, 1e-9);
    g_autoptr(PhysicsRun) off = physics_run(
        &(PhysicsOptions){.duration = 1.5, .columns = "Mass 1.y, Mass 1.vx"}, CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 40, " CONTACT_SMOOTH "},"
        "{'type': 'mass', 'collides': true, 'mass': 9, 'width': 2, 'height': 0.4, 'position': [0, 0.2]," CONTACT_SMOOTH
        "}, {'type': 'mass', 'collides': true, 'width': 0.4, 'height': 0.2, 'position': [0, 0.5],"
        " 'velocity': [2, 0]}");
    contact_assert_event(off, "end", "Mass 0, Mass 1", 0.6, 1e-9);
    g_assert_false(contact_event_at(off, "end", 0.6)->stays);
    contact_assert_event(off, "rest", "Mass 1, Support 0", 0.6 + sqrt(2 * 0.4 / g), 1e-9);
}

/* What overlaps at the start passes, is told of with its depth, and meets later on. */
static void test_overlap(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 4, .columns = "Mass 0.vx, Mass 1.vx"},
        "{'type': 'support', 'orientation': '90 deg', 'position': [2.2, 0], " CONTACT_SMOOTH ", 'restitution': 1}," CART
        ", 'position': [0, 0]}," CART ", 'position': [0.15, 0.05], 'velocity': [1, 0], 'restitution': 1}");
    g_assert_cmpuint(run->summary->warnings->len, ==, 1);
    const char *warning = tinker_warnings_text(run->summary->warnings, 0);
    g_assert_cmpstr(warning, ==,
                    "Mass 0 and Mass 1 overlap at the start, by 0.05 m: they pass through each other until they have "
                    "parted (place them apart, and they meet)");
    contact_assert_event(run, "impact", "Mass 1, Support 0", 1.75, 1e-9);
    contact_assert_event(run, "impact", "Mass 0, Mass 1", 1.75 + 1.7, 1e-9);
    physics_assert_near("struck", physics_last(run, 0), -1, 1e-12);
    physics_assert_near("stands", physics_last(run, 1), 0, 1e-12);
}

/* A disc strikes a mass that collides, and one that does not. */
static void test_disc(void)
{
    for (int collides = FALSE; collides <= TRUE; collides++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 2, .columns = "Disc 0.vx, Mass 0.vx"},
            "{'type': 'disc', 'position': [0, 0], 'radius': 0.3, 'velocity': [1, 0], 'restitution': 1},"
            "{'type': 'mass', 'mass': 3, 'width': 0.4, 'height': 0.4, 'position': [1.5, 0], 'collides': %s}",
            collides ? "true" : "false");
        contact_assert_count(run, "impact", collides);
        physics_assert_near("disc", physics_last(run, 0), collides ? -0.5 : 1, 1e-12);
        physics_assert_near("mass", physics_last(run, 1), collides ? 0.5 : 0, 1e-12);
    }
}

/* What a blow brings about at its own instant comes behind it, whatever the blocks are called: A lies on a rough floor
 * in front of the smooth S that strikes it, and slips from then on. */
static void test_order_of_cause(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.7}, CONTACT_WEIGHT CONTACT_FLOOR
                    ", 'width': 40}," CART ", 'name': 'S', 'position': [0, 0.1], " CONTACT_SMOOTH
                    ", 'velocity': [2, 0]}," CART ", 'name': 'A', 'static_friction': 1, 'dynamic_friction': 0.5, "
                    "'position': [1.2, 0.1]}");
    const GPtrArray *events = run->summary->events;
    gint blow = -1, slip = -1;
    for (guint i = 0; i < events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(events, i);
        if (event->time < 0.4) continue;
        if (blow < 0 && g_str_equal(event->blocks, "S, A")) blow = (gint)i;
        if (slip < 0 && g_str_equal(event->kind, "slip")) slip = (gint)i;
    }
    g_assert_cmpint(blow, >=, 0);
    g_assert_cmpint(slip, >, blow);
    physics_assert_near("at one instant", ((TinkerEvent *)g_ptr_array_index(events, slip))->time,
                        ((TinkerEvent *)g_ptr_array_index(events, blow))->time, 0);
}

/* What happens at one instant in parts of the scene that do not touch is told part by part, whatever the samples are:
 * some lie before the blows, one on them, or none. */
static void test_order_of_parts(void)
{
    static const double intervals[] = {0.01, 0.1, 0.25, 1};
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 1, .interval = intervals[i]},
                        CONTACT_FLOOR ", 'width': 40, 'restitution': 0.5}," CONTACT_POINT
                                      ", 'name': 'Z', 'position': [0, 1], 'velocity': [0, -2]}," CONTACT_POINT
                                      ", 'name': 'A', 'position': [3, 1], 'velocity': [0, -2]}");
        const GPtrArray *events = run->summary->events;
        g_assert_cmpuint(events->len, ==, 2);
        g_assert_cmpstr(((TinkerEvent *)g_ptr_array_index(events, 0))->blocks, ==, "Z, Support 0");
        g_assert_cmpstr(((TinkerEvent *)g_ptr_array_index(events, 1))->blocks, ==, "A, Support 0");
    }
}

/* A floor that takes nothing throws up what it carries, which presses it back ever sooner: where the two on top of each
 * other take energy, all of it is gone in the end, and both lie. The end follows from that alone: m g h of both. */
static void test_under_weight(void)
{
    static const struct {
        double mass, restitution;
    } cases[] = {{0.1, 0}, {0.5, 0.3}, {0.5, 0.8}, {3, 0.8}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .duration = 6, .impact_law = "sequential", .columns = "Mass 0.y, Mass 0.vy, Mass 1.y, Mass 1.vy"},
            CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 10, 'restitution': 1}," CART ", 'position': [0, 0.2]}," CART
                                         ", 'mass': %g, 'restitution': %g, 'position': [0, 0.45]}",
            cases[i].mass, cases[i].restitution);
        physics_assert_near("lower", physics_last(run, 0), 0.1, 1e-12);
        physics_assert_near("its speed", physics_last(run, 1), 0, 1e-12);
        physics_assert_near("upper", physics_last(run, 2), 0.3, 1e-12);
        physics_assert_near("its speed", physics_last(run, 3), 0, 1e-12);
        contact_assert_taken(run, 0, CONTACT_GRAVITY * (0.1 + 0.15 * cases[i].mass), 1e-9);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-masses/under-weight", test_under_weight);
    g_test_add_func("/physics/contact-masses/order-of-cause", test_order_of_cause);
    g_test_add_func("/physics/contact-masses/order-of-parts", test_order_of_parts);
    g_test_add_func("/physics/contact-masses/carts", test_carts);
    g_test_add_func("/physics/contact-masses/pi", test_pi);
    g_test_add_func("/physics/contact-masses/points", test_points);
    g_test_add_func("/physics/contact-masses/lines", test_lines);
    g_test_add_func("/physics/contact-masses/glancing", test_glancing);
    g_test_add_func("/physics/contact-masses/cradle", test_cradle);
    g_test_add_func("/physics/contact-masses/upon", test_upon);
    g_test_add_func("/physics/contact-masses/overlap", test_overlap);
    g_test_add_func("/physics/contact-masses/disc", test_disc);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
