/* Solid bodies that turn meet each other: against closed forms, and against the momentum of all of them. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

static const double g = CONTACT_GRAVITY;

#define FLOOR CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 40, 'static_friction': 0.8, 'dynamic_friction': 0.8}"

/* Two discs run into each other and go on together, without rebound. */
static void test_discs(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options =
            contact_options(&contact_methods[i], 2, "Disc 0.x, Disc 1.x, Disc 0.vx, Disc 1.vx, Disc 0.angle");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, "{'type': 'disc', 'position': [0, 0], 'radius': 0.3, 'velocity': [2, 0]},"
                                  "{'type': 'disc', 'radius': 0.2, 'mass': 3, 'position': [1.5, 0]}");
        contact_assert_event(run, "rest", "Disc 0, Disc 1", 0.5, 1e-9);
        physics_assert_near("vx", physics_last(run, 2), 0.5, 1e-10);
        physics_assert_near("the other's", physics_last(run, 3), 0.5, 1e-10);
        physics_assert_near("x", physics_last(run, 0), 1.75, 1e-9);
        physics_assert_near("apart", physics_last(run, 1) - physics_last(run, 0), 0.5, 1e-12);
        physics_assert_near("angle", physics_last(run, 4), 0, 1e-12);
    }
}

/* A disc strikes the upper side of a box, 0.1 m beside its middle: the impulses that leave the point of contact without
 * any speed, along the normal and along the side, by the two equations of it. */
static void test_disc_strikes_box(void)
{
    const double r = 0.2, c = 0.1, h = 0.3, inertia = (0.8 * 0.8 + 0.6 * 0.6) / 12, disc = 0.5 * r * r;
    const double nn = 2 + c * c / inertia, nt = -c * h / inertia, tt = 2 + h * h / inertia + r * r / disc, v = 1.5;
    const double det = nn * tt - nt * nt, normal = v * tt / det, along = -v * nt / det;
    g_assert_cmpfloat(fabs(along), <, 0.5 * normal);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.7,
                                      .columns = "Box 0.vx, Box 0.vy, Box 0.angular velocity, Disc 0.vx, Disc 0.vy,"
                                                 "Disc 0.angular velocity"},
                    "{'type': 'box', 'position': [0, 0], 'width': 0.8, 'height': 0.6},"
                    "{'type': 'disc', 'radius': 0.2, 'position': [0.1, 1.4], 'velocity': [0, -1.5]}");
    contact_assert_event(run, "rest", "Box 0, Disc 0", 0.6, 1e-12);
    g_autoptr(PhysicsRun) just =
        physics_run(&(PhysicsOptions){.duration = 0.6 + 1e-9,
                                      .columns = "Box 0.vx, Box 0.vy, Box 0.angular velocity, Disc 0.vx, Disc 0.vy,"
                                                 "Disc 0.angular velocity"},
                    "{'type': 'box', 'position': [0, 0], 'width': 0.8, 'height': 0.6},"
                    "{'type': 'disc', 'radius': 0.2, 'position': [0.1, 1.4], 'velocity': [0, -1.5]}");
    physics_assert_near("vx", physics_last(just, 0), -along, 1e-7);
    physics_assert_near("vy", physics_last(just, 1), -normal, 1e-7);
    physics_assert_near("rate", physics_last(just, 2), (-c * normal + h * along) / inertia, 1e-7);
    physics_assert_near("disc vx", physics_last(just, 3), along, 1e-7);
    physics_assert_near("disc vy", physics_last(just, 4), normal - v, 1e-7);
    physics_assert_near("disc rate", physics_last(just, 5), r * along / disc, 1e-7);
}

/* Ten boxes upon one another stand still, and press with the weight of what is above. */
static void test_stack(void)
{
    g_autoptr(GString) blocks = g_string_new(FLOOR);
    for (int i = 0; i < 10; i++)
        g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.8, 'height': 0.4, 'position': [0, %.17g]}",
                               0.2 + 0.4 * i);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 10,
                                      .columns = "Box 0.y, Box 9.y, Box 9.x, Box 9.angle, Support 0.normal force,"
                                                 "Box 9.normal force, Box 4.normal force"},
                    "%s", blocks->str);
    physics_assert_near("lowest", physics_last(run, 0), 0.2, 1e-13);
    physics_assert_near("highest", physics_last(run, 1), 3.8, 1e-12);
    physics_assert_near("x", physics_last(run, 2), 0, 1e-12);
    physics_assert_near("angle", physics_last(run, 3), 0, 1e-12);
    physics_assert_near("floor", physics_last(run, 4), 10 * g, 1e-9);
    physics_assert_near("top", physics_last(run, 5), g, 1e-9);
    physics_assert_near("middle", physics_last(run, 6), 6 * g + 5 * g, 1e-9);
    g_assert_cmpuint(run->summary->events->len, ==, 0);
    g_assert_cmpint(run->summary->steps, <=, 10); /* of what stands still there is nothing to be resolved */
}

/* On a box that the floor holds another slides until v / (mu g); and a disc until v / (3 mu g), which rolls then. */
static void test_slides_on_a_box(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.6, .columns = "Box 0.x, Box 1.x, Box 1.vx, Disc 0.vx"},
                    FLOOR ", {'type': 'box', 'width': 8, 'height': 0.5, 'position': [0, 0.25], 'mass': 20},"
                          "{'type': 'box', 'width': 0.5, 'height': 0.2, 'position': [-2, 0.6], 'velocity': [2, 0]},"
                          "{'type': 'disc', 'radius': 0.25, 'position': [1, 0.75], 'velocity': [3, 0]}");
    contact_assert_event(run, "stick", "Box 0, Box 1", 2 / (0.5 * g), 1e-9);
    contact_assert_event(run, "stick", "Box 0, Disc 0", 1 / (0.5 * g), 1e-9);
    physics_assert_near("held", physics_last(run, 0), 0, 1e-12);
    physics_assert_near("x", physics_last(run, 1), -2 + 4 / g, 1e-9);
    physics_assert_near("vx", physics_last(run, 2), 0, 1e-12);
    physics_assert_near("rolls", physics_last(run, 3), 2, 1e-9);
}

/* Two boxes that lie on one floor, side by side: the lower corners meet at the floor, and neither is under the other.
 */
static void test_side_by_side(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Box 0.vx, Box 1.vx, Box 0.y, Box 0.angle"},
                    CONTACT_WEIGHT CONTACT_FLOOR
                    ", 'width': 40, " CONTACT_SMOOTH "},"
                    "{'type': 'box', 'width': 1, 'height': 0.4, 'position': [0, 0.2], 'velocity': [2, 0]},"
                    "{'type': 'box', 'width': 1, 'height': 0.4, 'position': [2, 0.2]}");
    contact_assert_event(run, "rest", "Box 0, Box 1", 0.5, 1e-9);
    contact_assert_count(run, "jam", 0);
    physics_assert_near("vx", physics_last(run, 0), 1, 1e-9);
    physics_assert_near("the other's", physics_last(run, 1), 1, 1e-9);
    physics_assert_near("y", physics_last(run, 2), 0.2, 1e-9);
}

/* What a joint ties together does not meet; what overlaps at the start passes until it has parted. */
static void test_passes(void)
{
    g_autoptr(PhysicsRun) joined =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Box 1.angle"},
                    "{'type': 'box', 'position': [0, 0]}, {'type': 'box', 'position': [0.4, 0], 'angular_velocity': 1},"
                    "{'type': 'pin', 'ends': [{'block': 'Box 0', 'at': [0.4, 0]}, 'Box 1']}");
    physics_assert_near("turns", physics_last(joined, 0), 1, 1e-12);
    g_autoptr(PhysicsRun) over =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Box 1.x"},
                    "{'type': 'box', 'position': [0, 0]}, {'type': 'box', 'position': [0.4, 0], 'velocity': [1, 0]}");
    physics_assert_near("x", physics_last(over, 0), 1.4, 1e-12);
    g_assert_cmpuint(over->summary->events->len, ==, 0);
}

/* Two discs whose surfaces are given for the first, the second, both, or none of them: the larger rebound counts. */
static void test_rebounds(void)
{
    static const struct {
        const char *first, *second;
        double e;
    } cases[] = {{"", "", 0},
                 {", 'restitution': 0.5", "", 0.5},
                 {"", ", 'restitution': 0.25", 0.25},
                 {", 'restitution': 0.5", ", 'restitution': 0.75", 0.75},
                 {", 'restitution': 1", ", 'restitution': 0", 1}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 1, .columns = "Disc 0.vx, Disc 1.vx"},
                        "{'type': 'disc', 'position': [0, 0], 'radius': 0.3, 'velocity': [2, 0]%s},"
                        "{'type': 'disc', 'radius': 0.2, 'mass': 3, 'position': [1.5, 0]%s}",
                        cases[i].first, cases[i].second);
        physics_assert_near("vx", physics_last(run, 0), 0.5 * (1 - 3 * cases[i].e), 1e-12);
        physics_assert_near("the other's", physics_last(run, 1), 0.5 * (1 + cases[i].e), 1e-12);
    }
}

/* How far a box slides on another that the floor holds, and how far on the floor: v^2 / (2 mu g), with the geometric
 * mean of two coefficients, or the one that there is. */
static void test_roughness(void)
{
    static const struct {
        const char *below, *above;
        double among, floor;
    } cases[] = {{"", "", 0.5, 0.8},
                 {"", ", 'static_friction': 0.2, 'dynamic_friction': 0.2", 0.2, 0.4},
                 {", 'static_friction': 0.9, 'dynamic_friction': 0.45", "", 0.45, 0.8},
                 {", 'static_friction': 0.9, 'dynamic_friction': 0.45",
                  ", 'static_friction': 0.3, 'dynamic_friction': 0.2", 0.3, 0.4},
                 {"", ", 'dynamic_friction': 0.2", 0.2, 0.4}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 2, .columns = "Box 1.x, Box 2.x, Mass 0.x, Box 0.x"},
            FLOOR ", {'type': 'box', 'width': 8, 'height': 0.5, 'position': [0, 0.25], 'mass': 20 %s},"
                  "{'type': 'box', 'width': 0.5, 'height': 0.2, 'position': [-2, 0.6], 'velocity': [2, 0]%s},"
                  "{'type': 'box', 'width': 0.5, 'height': 0.2, 'position': [6, 0.1], 'velocity': [2, 0]%s},"
                  "{'type': 'mass', 'width': 0.5, 'height': 0.2, 'position': [10, 0.1],"
                  " 'velocity': [2, 0]%s}",
            cases[i].below, cases[i].above, cases[i].above, cases[i].above);
        physics_assert_near("on the box", physics_last(run, 0), -2 + 2 / (cases[i].among * g), 1e-9);
        physics_assert_near("on the floor", physics_last(run, 1), 6 + 2 / (cases[i].floor * g), 1e-9);
        physics_assert_near("a mass", physics_last(run, 2), 10 + 2 / (cases[i].floor * g), 1e-9);
        physics_assert_near("held", physics_last(run, 3), 0, 1e-12);
    }
}

/* A mass that rebounds by its own restitution, by events and by impulses. */
static void test_mass_rebounds(void)
{
    for (int impulses = FALSE; impulses <= TRUE; impulses++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 1, .step = 1e-3, .impulses = impulses, .columns = "Mass 0.vy"},
            CONTACT_FLOOR "}, {'type': 'mass', 'position': [0, 0.9], 'velocity': [0, -1], 'restitution': 0.5}");
        physics_assert_near("vy", physics_last(run, 0), 0.5, 1e-12);
    }
}

/* A box that is pulled high up by a force that grows, F = t: its corners press ever less evenly, and both hold until F
 * is mu g, wherever it pulls. */
static void test_pulled_high(void)
{
    const double mu = 0.4, slides = 0.3, from = mu * g, end = 4.2, over = end - from;
    const double x = (end * end * end - from * from * from) / 6 - from * from * over / 2 - slides * g * over * over / 2;
    static const double heights[] = {-0.5, 0, 0.4};
    for (gsize i = 0; i < G_N_ELEMENTS(heights); i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = end, .columns = "Box 0.x, Box 0.angle"},
                        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 40, 'static_friction': 0.4, 'dynamic_friction': 0.3},"
                                                     "{'type': 'box', 'width': 1, 'height': 1, 'position': [0, 0.5]},"
                                                     "{'type': 'motor', 'ends': [{'block': 'Box 0', 'at': [0, %g]}],"
                                                     " 'waveform': {'expression': 't'}}",
                        heights[i]);
        g_assert_cmpuint(run->summary->events->len, ==, 1);
        contact_assert_event(run, "slip", "Box 0, Support 0", from, 1e-9);
        physics_assert_near("x", physics_last(run, 0), x, 1e-9);
        physics_assert_near("angle", physics_last(run, 1), 0, 1e-12);
    }
}

typedef struct {
    double momentum[2], angular, energy;
} Total;

/* Of so many boxes and discs, by turns, of mass 1. */
static Total total_of(const PhysicsRun *run, gsize sample, int count, const double *inertia)
{
    Total total = {{0, 0}, 0, 0};
    for (int i = 0; i < count; i++) {
        double at[5];
        for (gsize k = 0; k < 5; k++)
            at[k] = physics_value(run, sample, 5 * (gsize)i + k);
        total.momentum[0] += at[2];
        total.momentum[1] += at[3];
        total.angular += at[0] * at[3] - at[1] * at[2] + inertia[i % 2] * at[4];
        total.energy += 0.5 * (at[2] * at[2] + at[3] * at[3] + inertia[i % 2] * at[4] * at[4]);
    }
    return total;
}

/* Boxes and discs that fly together from all sides: momentum and angular momentum stay, and energy never grows. */
static void test_momentum(void)
{
    enum { COUNT = 6 };
    const double inertia[] = {(0.36 + 0.16) / 12, 0.5 * 0.0625};
    for (guint32 seed = 0; seed < 10; seed++) {
        g_autoptr(GRand) random = g_rand_new_with_seed(seed);
        g_autoptr(GString) blocks = g_string_new("{'type': 'support', 'solid': false}"), columns = g_string_new(NULL);
        for (int i = 0; i < COUNT; i++) {
            const double a = 2 * G_PI * i / COUNT, v = g_rand_double_range(random, 0.5, 1.5);
            g_string_append_printf(blocks,
                                   ", {'type': '%s', %s, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g],"
                                   " 'orientation': %.17g, 'angular_velocity': %.17g}",
                                   i % 2 == 0 ? "box" : "disc",
                                   i % 2 == 0 ? "'width': 0.6, 'height': 0.4" : "'radius': 0.25", 1.5 * cos(a),
                                   1.5 * sin(a), -v * cos(a) + g_rand_double_range(random, -0.1, 0.1),
                                   -v * sin(a) + g_rand_double_range(random, -0.1, 0.1), g_rand_double(random),
                                   g_rand_double_range(random, -3, 3));
            const char *name = i % 2 == 0 ? "Box" : "Disc";
            for (int k = 0; k < 5; k++)
                g_string_append_printf(columns, "%s%s %d.%s", columns->len > 0 ? ", " : "", name, i / 2,
                                       ((const char *const[]){"x", "y", "vx", "vy", "angular velocity"})[k]);
        }
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 3, .interval = 0.05, .columns = columns->str}, "%s", blocks->str);
        g_assert_cmpuint(run->summary->events->len, >, 0);
        const Total first = total_of(run, 0, COUNT, inertia);
        double before = first.energy;
        for (gsize i = 0; i < physics_samples(run); i++) {
            const Total now = total_of(run, i, COUNT, inertia);
            physics_assert_near("momentum along x", now.momentum[0], first.momentum[0], 1e-10);
            physics_assert_near("momentum along y", now.momentum[1], first.momentum[1], 1e-10);
            physics_assert_near("angular momentum", now.angular, first.angular, 1e-9);
            g_assert_cmpfloat(now.energy, <=, before + 1e-10);
            before = now.energy;
        }
        physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, 1e-8);
    }
}

/* Wheels that mesh touch where their rims meet, and do not meet there: the small one turns by M t^2 / 2 over the
 * inertia of both, 0.125 + 0.25 * 2. */
static void test_gears_do_not_meet(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .tolerance = 1e-10, .columns = "Disc 0.angle"},
                    "{'type': 'support', 'position': [0, 4], 'solid': false},"
                    "{'type': 'disc', 'radius': 0.5, 'position': [0, 4]},"
                    "{'type': 'disc', 'radius': 1, 'mass': 4, 'position': [1.5, 4]}, {'type': 'pin', 'ends': ['Support "
                    "0', 'Disc 0']},"
                    "{'type': 'pin', 'ends': [{'block': 'Support 0', 'at': [1.5, 0]}, 'Disc 1']},"
                    "{'type': 'gear', 'ends': ['Disc 0', 'Disc 1'], 'ratio': 0.5},"
                    "{'type': 'torque', 'ends': ['Disc 0'], 'waveform': 'cosine', 'amplitude': 2}");
    physics_assert_near("angle", physics_last(run, 0), 2 * 0.5 / (0.125 + 0.25 * 2), 1e-8);
}

/* So many discs in a row, a metre apart, of which the first comes to the second at 2 m/s; `more` behind them. */
static PhysicsRun *row_of(int discs, gboolean impulses, const char *more)
{
    g_autoptr(GString) blocks =
        g_string_new("{'type': 'disc', 'position': [0, 0], 'radius': 0.2, 'velocity': [2, 0], 'restitution': 0}");
    for (int i = 1; i < discs; i++)
        g_string_append_printf(blocks, ", {'type': 'disc', 'radius': 0.2, 'position': [%d, 0], 'restitution': 0}", i);
    return physics_run(&(PhysicsOptions){.duration = 0.5, .columns = "Disc 0.vx", .impulses = impulses}, "%s%s",
                       blocks->str, more);
}

static gboolean warns_of_passing(const PhysicsRun *run)
{
    gboolean warns = FALSE;
    for (guint i = 0; i < run->summary->warnings->len; i++)
        warns |= strstr(tinker_warnings_text(run->summary->warnings, i), "pass through each other") != NULL;
    return warns;
}

/* The first two go on together; by events not in a scene of too many, which says so. What cannot meet does not count.
 */
static void test_too_many(void)
{
    g_autoptr(GString) bars = g_string_new(NULL);
    for (int i = 0; i < 10; i++)
        g_string_append_printf(bars, ", {'type': 'bar', 'position': [0, %d]}", i + 5);
    g_autoptr(PhysicsRun) few = row_of(256, FALSE, bars->str), many = row_of(257, FALSE, ""),
                          piled = row_of(257, TRUE, "");
    physics_assert_near("vx", physics_last(few, 0), 1, 1e-10);
    physics_assert_near("vx of a pile", physics_last(piled, 0), 1, 1e-10);
    physics_assert_near("vx through the other", physics_last(many, 0), 2, 1e-12);
    g_assert_false(warns_of_passing(few));
    g_assert_false(warns_of_passing(piled));
    g_assert_true(warns_of_passing(many));
}

/* A plate, which may have many corners, counts as four. */
static void test_too_many_plates(void)
{
    for (int plates = 64; plates <= 65; plates++) {
        g_autoptr(GString) blocks = g_string_new("{'type': 'plate', 'position': [0, 0]}");
        for (int i = 1; i < plates; i++)
            g_string_append_printf(blocks, ", {'type': 'plate', 'position': [%d, 0]}", 3 * i);
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.duration = 0.01}, "%s", blocks->str);
        g_assert_cmpint(warns_of_passing(run), ==, plates > 64);
    }
}

/* Six dominoes fall over one another and come to rest on each other, where contacts stop and slide the other way within
 * microseconds. No step is looked at so closely for it that forces are worked out many times as often as its stages and
 * the places of a search ask for (13 and 10 of each step that is made). */
static void test_dominoes_cost(void)
{
    g_autoptr(GString) blocks = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 8}");
    for (int i = 0; i < 6; i++)
        g_string_append_printf(blocks, ", {'type': 'box', 'width': 0.1, 'height': 0.8, 'position': [%.17g, 0.4]%s}",
                               0.3 * i, i > 0 ? "" : ", 'velocity': [0.32, 0.04], 'angular_velocity': -0.8");
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 5, .columns = "Box 5.angle"}, "%s", blocks->str);
    const TinkerSummary *summary = run->summary;
    g_assert_cmpfloat(summary->energy_balance_error, <, 1e-9);
    g_assert_cmpfloat(fabs(summary->kinetic_end), <, 1e-12);
    g_assert_cmpint(summary->evaluations, <, 2 * 23 * (summary->steps + summary->rejected_steps));
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-bodies/discs", test_discs);
    g_test_add_func("/physics/contact-bodies/gears-do-not-meet", test_gears_do_not_meet);
    g_test_add_func("/physics/contact-bodies/disc-strikes-box", test_disc_strikes_box);
    g_test_add_func("/physics/contact-bodies/stack", test_stack);
    g_test_add_func("/physics/contact-bodies/slides-on-a-box", test_slides_on_a_box);
    g_test_add_func("/physics/contact-bodies/side-by-side", test_side_by_side);
    g_test_add_func("/physics/contact-bodies/too-many", test_too_many);
    g_test_add_func("/physics/contact-bodies/too-many-plates", test_too_many_plates);
    g_test_add_func("/physics/contact-bodies/passes", test_passes);
    g_test_add_func("/physics/contact-bodies/momentum", test_momentum);
    g_test_add_func("/physics/contact-bodies/rebounds", test_rebounds);
    g_test_add_func("/physics/contact-bodies/pulled-high", test_pulled_high);
    g_test_add_func("/physics/contact-bodies/roughness", test_roughness);
    g_test_add_func("/physics/contact-bodies/mass-rebounds", test_mass_rebounds);
    g_test_add_func("/physics/contact-bodies/dominoes-cost", test_dominoes_cost);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
