/* Impacts together with rods: they act through them. */
#include "contact-checks.h"
#include "physics/model/model.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* --- a pendulum against a wall --- */

/* A quarter of the period of a pendulum of 1 m, by the arithmetic-geometric mean. */
static double quarter_period(double amplitude)
{
    double a = 1, b = cos(amplitude / 2);
    for (int i = 0; i < 8; i++) {
        double mean = 0.5 * (a + b);
        b = sqrt(a * b);
        a = mean;
    }
    return G_PI / 2 / a / sqrt(g);
}

/* Let go at `amplitude` to the left of the lowest place; the wall's top faces left and stands at x. */
static PhysicsRun *swing(const PhysicsOptions *options, double amplitude, double x, const char *wall_is)
{
    g_autofree char *wall = contact_plate(x, -1, G_PI / 2, 1.5, wall_is);
    return physics_run(options,
                       CONTACT_WEIGHT "%s, {'type': 'support', 'solid': false}, " CONTACT_POINT
                                      ", 'position': [%.17g, %.17g]}, {'type': 'rod', 'ends': ['Support 1', 'Mass 0']}",
                       wall, -sin(amplitude), -cos(amplitude));
}

/* Thrown back with e of its speed it swings to 1 - cos = e^2 (1 - cos amplitude). */
static void check_lowest(double e)
{
    const double amplitude = G_PI / 3;
    double back = acos(1 - e * e * (1 - cos(amplitude))), touch = quarter_period(amplitude);
    g_autofree char *more = g_strdup_printf(CONTACT_SMOOTH ", 'restitution': %g", e);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], touch + quarter_period(back), NULL);
        g_autoptr(PhysicsRun) run = swing(&options, amplitude, 0, more);
        double bound = contact_methods[i].smooth;
        contact_assert_state(run, "Mass 0", (double[]){-sin(back), -cos(back), 0, 0}, 10 * bound);
        contact_assert_event(run, "impact", "Mass 0, Support 0", touch, i < 2 ? 1e-10 : bound);
        contact_assert_taken(run, 0, (1 - e * e) * g * (1 - cos(amplitude)), 30 * bound);
    }
}

static void test_pendulum_at_its_lowest(void)
{
    check_lowest(1);
    check_lowest(0.6);
}

/* Where the way stands oblique to the wall, the rod takes part: with one freedom left the speed along the way becomes
 * -e times itself, with and without friction. */
static void test_pendulum_oblique(void)
{
    static const char *const walls[] = {CONTACT_SMOOTH ", 'restitution': 0.5",
                                        "'static_friction': 0.3, 'dynamic_friction': 0.3, 'restitution': 0.5"};
    double speed = 2 * g * (cos(G_PI / 6) - cos(G_PI / 3)), back = acos(cos(G_PI / 6) - 0.25 * speed / 2 / g);
    for (gsize w = 0; w < G_N_ELEMENTS(walls); w++) {
        PhysicsOptions options = contact_options(&contact_methods[0], 0.5, NULL);
        g_autoptr(PhysicsRun) run = swing(&options, G_PI / 3, -0.5, walls[w]);
        double state[4];
        physics_state(run, "Mass 0", state);
        physics_assert_near("energy", 0.5 * (state[2] * state[2] + state[3] * state[3]) + g * state[1], -g * cos(back),
                            1e-9);
        g_assert_cmpfloat(state[0], <, -0.5);
        contact_assert_count(run, "impact", 1);
        contact_assert_taken(run, 0, 0.75 * speed / 2, 1e-9);
    }
}

/* It stays at such a wall, which then bears m g tan 30 degrees. */
static void test_pendulum_leans(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.5, "Mass 0.normal force, Rod 0.tension");
        g_autoptr(PhysicsRun) run = swing(&options, G_PI / 3, -0.5, CONTACT_SMOOTH);
        contact_assert_state(run, "Mass 0", (double[]){-0.5, -cos(G_PI / 6), 0, 0}, 1e-10);
        physics_assert_near("normal force", physics_last(run, 0), g * tan(G_PI / 6), 1e-8);
        physics_assert_near("tension", physics_last(run, 1), g / cos(G_PI / 6), 1e-8);
        contact_assert_taken(run, 0, g * (cos(G_PI / 6) - cos(G_PI / 3)), 20 * contact_methods[i].smooth);
    }
}

/* --- dumbbells --- */

/* Flat: both ends at once. */
static void test_dumbbell_flat(void)
{
    const double landing = sqrt(2 / g), after = 0.1, v = 0.6 * g * landing;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        for (int bounces = 0; bounces < 2; bounces++) {
            PhysicsOptions options = contact_options(&contact_methods[i], landing + after,
                                                     "Mass 0.normal force, Mass 1.normal force, Rod 0.tension");
            g_autoptr(PhysicsRun) run =
                physics_run(&options,
                            CONTACT_WEIGHT CONTACT_FLOOR ", 'restitution': %g}, " CONTACT_POINT
                                                         ", 'position': [0, 1]}, " CONTACT_POINT
                                                         ", 'mass': 3, 'position': [1, 1]}, {'type': "
                                                         "'rod', 'ends': ['Mass 0', 'Mass 1']}",
                            bounces ? 0.6 : 0.0);
            double y = bounces ? v * after - g / 2 * after * after : 0, rate = bounces ? v - g * after : 0;
            contact_assert_state(run, "Mass 0", (double[]){0, y, 0, rate}, contact_methods[i].polynomial);
            contact_assert_state(run, "Mass 1", (double[]){1, y, 0, rate}, contact_methods[i].polynomial);
            physics_assert_near("on the first", physics_last(run, 0), bounces ? 0 : g, 1e-8);
            physics_assert_near("on the second", physics_last(run, 1), bounces ? 0 : 3 * g, 1e-8);
            physics_assert_near("tension", physics_last(run, 2), 0, 1e-8);
            contact_assert_count(run, bounces ? "impact" : "rest", 2);
            contact_assert_taken(run, 0, 4 * g * (bounces ? 0.64 : 1), 100 * contact_methods[i].polynomial);
        }
    }
}

/* Tilted, without weight, its lower end first: the impulse (1 + e) v 2 m / (1 + cos^2 tilt) there moves the middle and
 * turns the rod; then it flies on turning evenly. */
static void test_dumbbell_tilted(void)
{
    static const double restitutions[] = {0, 0.5, 1};
    const double tilt = G_PI / 6, v = 2, touch = 0.25, after = 0.1;
    for (gsize r = 0; r < G_N_ELEMENTS(restitutions); r++) {
        double e = restitutions[r], impulse = (1 + e) * v * 2 / (1 + cos(tilt) * cos(tilt));
        double rise = impulse / 2 - v, turn = -impulse * cos(tilt), angle = tilt + turn * after;
        double middle[2] = {cos(tilt) / 2, sin(tilt) / 2 + rise * after};
        double lower[4], upper[4], arm[2] = {cos(angle) / 2, sin(angle) / 2};
        for (int k = 0; k < 2; k++) {
            double speed = k == 0 ? -arm[1] * turn : arm[0] * turn;
            lower[k] = middle[k] - arm[k];
            upper[k] = middle[k] + arm[k];
            lower[2 + k] = (k == 1 ? rise : 0) - speed;
            upper[2 + k] = (k == 1 ? rise : 0) + speed;
        }
        for (gsize i = 0; i < CONTACT_METHODS; i++) {
            PhysicsOptions options = contact_options(&contact_methods[i], touch + after, NULL);
            g_autoptr(PhysicsRun) run =
                physics_run(&options,
                            CONTACT_FLOOR ", 'restitution': %g, " CONTACT_SMOOTH "}, " CONTACT_POINT
                                          ", 'position': [0, 0.5], 'velocity': [0, -2]}, " CONTACT_POINT
                                          ", 'position': [%.17g, %.17g], 'velocity': [0, -2]}, {'type': 'rod', 'ends': "
                                          "['Mass 0', 'Mass 1']}",
                            e, cos(tilt), 0.5 + sin(tilt));
            double bound = contact_methods[i].smooth;
            contact_assert_state(run, "Mass 0", lower, bound);
            contact_assert_state(run, "Mass 1", upper, bound);
            contact_assert_taken(run, 0, impulse * v * (1 - e) / 2, 1e-9);
        }
    }
}

/* Nobody strikes twice at one instant: blows that throw others back are taken together with theirs. */
static void check_instants(const PhysicsRun *run)
{
    for (guint i = 0; i < run->summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(run->summary->events, i);
        for (guint k = i; k-- > 0;) {
            const TinkerEvent *before = g_ptr_array_index(run->summary->events, k);
            if (event->time - before->time > 1e-14) break;
            g_assert_false(g_str_equal(event->kind, "impact") && g_str_equal(before->kind, "impact") &&
                           g_str_equal(event->blocks, before->blocks));
        }
    }
}

/* A chain of masses, nearly level, comes down on a floor that throws nothing back, so that dozens of them strike by
 * turns and at once: none stops the run or goes through the floor, and what impacts and friction took is what is
 * missing. */
static void check_chain_onto_floor(int count, double duration)
{
    const PhysicsOptions options = {.method = "dop853", .tolerance = 1e-9, .duration = duration};
    g_autoptr(GString) blocks =
        g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 340, 'static_friction': 0.3, 'dynamic_friction': 0.3}");
    double potential = 0;
    for (int i = 0; i < count; i++) {
        double y = 0.3 + 0.05 * sin(i);
        potential += CONTACT_GRAVITY * y;
        g_string_append_printf(blocks, ", " CONTACT_POINT ", 'position': [%d, %.17g]}", i - count / 2, y);
        if (i > 0) g_string_append_printf(blocks, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i - 1, i);
    }
    g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks->str);
    double energy = 0;
    for (int i = 0; i < count; i++) {
        double state[4];
        g_autofree char *name = g_strdup_printf("Mass %d", i);
        physics_state(run, name, state);
        g_assert_cmpfloat(state[1], >=, -1e-9);
        energy += CONTACT_GRAVITY * state[1] + 0.5 * (state[2] * state[2] + state[3] * state[3]);
    }
    const double *books = run->summary->books;
    g_assert_cmpfloat(books[TINKER_BOOK_CONTACTS], <, -1);
    g_assert_cmpfloat(books[TINKER_BOOK_FRICTION], <=, 0);
    /* one that follows upon another takes little more than a step of four stages and a few looks */
    g_assert_cmpint(run->summary->contact_changes, >, 50);
    g_assert_cmpint(run->summary->evaluations, <, 25 * run->summary->contact_changes);
    physics_assert_near("energy", energy, potential + books[TINKER_BOOK_CONTACTS] + books[TINKER_BOOK_FRICTION],
                        1e-7 * potential);
    check_instants(run);
}

static void test_chain_onto_floor(void)
{
    check_chain_onto_floor(70, 0.26);
    check_chain_onto_floor(160, 0.25);
    check_chain_onto_floor(150, 0.45); /* here some stick, and come to their limit */
}

/* --- what slides and is halted by the landing of another --- */

/* From then on nothing pushes along the floor: friction and the forces of rods are 0. */
static void check_halted(const char *masses, const char *columns, gsize count)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 0.8, columns);
        g_autoptr(PhysicsRun) run = physics_run(
            &options,
            CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 20, 'static_friction': 0.6, 'dynamic_friction': 0.5}, %s", masses);
        for (gsize k = 0; k < count; k++)
            physics_assert_near(contact_methods[i].method, physics_last(run, k), 0, 1e-8);
    }
}

/* The second comes down on the floor, and what stops it there stops the first, which slid, through the rod. */
static void test_halted_by_a_rod(void)
{
    check_halted(CONTACT_POINT ", 'mass': 1, 'velocity': [0.7, 0]}, " CONTACT_POINT
                               ", 'mass': 2, 'position': [1, 0.3], 'velocity': [0.7, 0]},"
                               "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                 "Mass 0.vx, Mass 0.friction force, Mass 1.friction force, Rod 0.tension", 4);
}

/* The middle one comes down between two that slide apart: they stand still in the moment in which all lie in line. */
static void test_halted_in_line(void)
{
    check_halted(CONTACT_POINT
                 ", 'mass': 1}, " CONTACT_POINT ", 'mass': 1.4, 'position': [1, 0.3]}, " CONTACT_POINT
                 ", 'mass': 2, 'position': [2, 0]},"
                 "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}, {'type': 'rod', 'ends': ['Mass 1', 'Mass 2']}",
                 "Mass 0.vx, Mass 2.vx, Mass 0.friction force, Mass 2.friction force, Rod 0.tension, Rod 1.tension", 6);
}

/* A row that lies on the floor is pulled at one end by 10 N more every second: all hold until that is what they can
 * hold together, and then all slip at one instant, most of them by one decision. Nothing but the force that is more
 * than friction accelerates the row then. */
static void test_row_slips_at_once(void)
{
    enum { COUNT = 40 };
    const double friction = 0.02 * COUNT * g, slips = friction / 10, duration = slips + 1;
    g_autoptr(GString) row = g_string_new(NULL);
    for (int i = 0; i < COUNT; i++) {
        g_string_append_printf(row, "%s" CONTACT_POINT ", 'mass': 1, 'position': [%d, 0]}", i > 0 ? "," : "", i);
        if (i > 0) g_string_append_printf(row, ", {'type': 'rod', 'ends': ['Mass %d', 'Mass %d']}", i - 1, i);
    }
    PhysicsOptions options = {.method = "dop853", .duration = duration, .columns = "Mass 0.x"};
    g_autoptr(PhysicsRun) run = physics_run(
        &options,
        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 200, 'static_friction': 0.02, 'dynamic_friction': 0.02}, %s,"
                                     "{'type': 'motor', 'ends': ['Mass %d'], 'waveform': {'expression': '10*t'}}",
        row->str, COUNT - 1);
    contact_assert_count(run, "slip", COUNT);
    for (guint i = 0; i < run->summary->events->len; i++) {
        const TinkerEvent *event = g_ptr_array_index(run->summary->events, i);
        if (g_str_equal(event->kind, "slip")) physics_assert_near("all at once", event->time, slips, 1e-9);
    }
    physics_assert_near("the row moves", physics_last(run, 0), 10.0 * pow(duration - slips, 3) / 6 / COUNT, 1e-9);
    g_assert_cmpint(run->summary->contact_changes, <, COUNT / 2);
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-rods/halted-by-a-rod", test_halted_by_a_rod);
    g_test_add_func("/physics/contact-rods/halted-in-line", test_halted_in_line);
    g_test_add_func("/physics/contact-rods/row-slips-at-once", test_row_slips_at_once);
    g_test_add_func("/physics/contact-rods/pendulum-at-its-lowest", test_pendulum_at_its_lowest);
    g_test_add_func("/physics/contact-rods/pendulum-oblique", test_pendulum_oblique);
    g_test_add_func("/physics/contact-rods/pendulum-leans", test_pendulum_leans);
    g_test_add_func("/physics/contact-rods/dumbbell-flat", test_dumbbell_flat);
    g_test_add_func("/physics/contact-rods/dumbbell-tilted", test_dumbbell_tilted);
    g_test_add_func("/physics/contact-rods/chain-onto-floor", test_chain_onto_floor);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
