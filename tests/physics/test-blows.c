/* Blows at an instant, by the laws of impulse and momentum: of free bodies, and as joints and contacts answer. */
#include "contact-checks.h"
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "physics/system/summary.h"

#include <math.h>

#define GRAVITY "{'type': 'gravity'}, "
#define GROUND  "{'type': 'support', 'solid': false}, "
#define FLOOR                                                                                                          \
    "{'type': 'support', 'width': 20, 'height': 0.5, 'position': [0, -0.25], 'static_friction': 0.2,"                  \
    " 'dynamic_friction': 0.2, 'restitution': 0.7}, "
/* m = 3, L = 2: I = 1 about the centre, 4 about an end. */
#define BAR "{'type': 'bar', 'mass': 3, 'length': 2"
#define UP  1.5707963267948966

static double given(const PhysicsRun *run, TinkerBook book)
{
    return run->summary->books[book];
}

/* v = J / m and w = J r / I, by every kind of method, on its grid and off it. */
static void test_free_bar(void)
{
    static const char *const methods[] = {"dop853",  "rk4",  "verlet",   "semi-implicit-euler",
                                          "newmark", "auto", "cvode-bdf"};
    static const double times[] = {0.5, 0.51234};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        for (gsize k = 0; k < G_N_ELEMENTS(times); k++) {
            const double after = 2 - times[k];
            g_autoptr(PhysicsRun) run = physics_run(
                &(PhysicsOptions){.method = methods[m],
                                  .duration = 2,
                                  .step = 0.02,
                                  .columns = "Bar 0.vy, Bar 0.angular velocity, Bar 0.y, Bar 0.angle, Bar 0.vx"},
                BAR ", 'position': [0, 0]}, {'type': 'impulse', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}], "
                    "'impulse': 6, 'angle': %.17g,"
                    " 'time': %.17g}",
                UP, times[k]);
            physics_assert_near("at rest before", physics_value(run, 1, 0), 0, 0);
            physics_assert_near("v", physics_last(run, 0), 2, 1e-12);
            physics_assert_near("w", physics_last(run, 1), 3, 1e-12);
            physics_assert_near("y", physics_last(run, 2), 2 * after, 1e-10);
            physics_assert_near("angle", physics_last(run, 3), 3 * after, 1e-10);
            physics_assert_near("across", physics_last(run, 4), 0, 0);
            physics_assert_near("work", given(run, TINKER_BOOK_MOTORS), 0.5 * 3 * 4 + 0.5 * 9, 1e-11);
            contact_assert_event(run, "blow", "Impulse 0, Bar 0", times[k], 0);
            g_assert_cmpuint(run->summary->events->len, ==, 1);
        }
    }
}

/* At 0 the first sample has it, at the end the last; before 0 and beyond the end there is none. */
static void test_ends_of_a_run(void)
{
    static const struct {
        double time, first, last;
    } cases[] = {{0, 2, 2}, {1, 0, 2}, {-1, 0, 0}, {1.5, 0, 0}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 1, .columns = "Mass 0.vx, Impulse 0.impulse"},
                        "{'type': 'mass', 'mass': 2}, {'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 4,"
                        " 'time': %.17g}",
                        cases[i].time);
        physics_assert_near("first", physics_value(run, 0, 0), cases[i].first, 0);
        physics_assert_near("last", physics_last(run, 0), cases[i].last, 0);
        physics_assert_near("given", physics_last(run, 1), 2 * cases[i].last, 0);
        contact_assert_count(run, "blow", cases[i].last > 0);
    }
}

/* A turning blow gives H / I and moves no centre; two blows at one instant add up. */
static void test_turning_blows(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1, .columns = "Bar 0.angular velocity, Bar 0.vx, Bar 0.vy"},
        BAR ", 'position': [0, 0]}, {'type': 'impulse', 'ends': [{'block': 'Bar 0', 'at': [1, 0]}], 'angular_impulse': "
            "5, 'time': 0.5},"
            "{'type': 'impulse', 'ends': [{'block': 'Bar 0', 'at': [-1, 0]}], 'angular_impulse': -2, 'time': 0.5}");
    physics_assert_near("w", physics_last(run, 0), 3, 1e-12);
    physics_assert_near("vx", physics_last(run, 1), 0, 0);
    physics_assert_near("vy", physics_last(run, 2), 0, 0);
    contact_assert_count(run, "blow", 2);
}

/* w = J l / I of the pin, and at l = 2 L / 3, the centre of percussion, the bar goes off as if it were free: the pin
 * gives no impulse. */
static void test_pinned_bar(void)
{
    static const double arms[] = {0.4, 2.0, 4.0 / 3};
    for (gsize i = 0; i < G_N_ELEMENTS(arms); i++) {
        const double w = 6 * arms[i] / 4;
        g_autofree char *bar = g_strdup_printf(
            BAR ", 'position': [1, 0]}, {'type': 'impulse', 'ends': [{'block': 'Bar 0', 'at': [%.17g, 0]}],"
                " 'impulse': 6, 'angle': %.17g, 'time': 0.25}",
            arms[i] - 1, UP);
        const PhysicsOptions options = {.duration = 0.25, .columns = "Bar 0.vy, Bar 0.angular velocity"};
        g_autoptr(PhysicsRun) run = physics_run(
            &options, GROUND "%s, {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-1, 0]}]}", bar);
        g_autoptr(PhysicsRun) free_bar = physics_run(&options, "%s", bar);
        physics_assert_near("w", physics_last(run, 1), w, 1e-12);
        physics_assert_near("v", physics_last(run, 0), w, 1e-12);
        physics_assert_near("work", given(run, TINKER_BOOK_MOTORS), 0.5 * 4 * w * w, 1e-11);
        const double reaction = 3 * fabs(physics_last(run, 0) - physics_last(free_bar, 0));
        physics_assert_near("impulse of the pin", reaction, fabs(3 * w - 6), 1e-11);
        if (i == 2) physics_assert_near("at the centre of percussion", reaction, 0, 1e-11);
    }
}

/* Of a blow at 60 degrees on a mass at the end of a rod what is across it acts, and then T = m v^2 / l. */
static void test_mass_on_a_rod(void)
{
    const double v = 3 * sin(UP * 2 / 3) / 2;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Mass 0.speed, Rod 0.tension"},
                    GROUND "{'type': 'mass', 'mass': 2, 'position': [1.5, 0]},"
                           "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                           "{'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 3, 'angle': '60 deg'}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        physics_assert_near("v", physics_value(run, i, 0), v, 1e-11);
        physics_assert_near("T", physics_value(run, i, 1), 2 * v * v / 1.5, 1e-10);
    }
    physics_assert_near("work", given(run, TINKER_BOOK_MOTORS), v * v, 1e-12);
}

/* Gears share it: w = H / (I_1 + r^2 I_2). A drive takes it whole, and its work is that of motors as the blow's. */
static void test_gears_and_drives(void)
{
    g_autoptr(PhysicsRun) gears =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Disc 0.angular velocity, Disc 1.angular velocity"},
                    GROUND "{'type': 'disc', 'position': [0, 0], 'mass': 2, 'radius': 0.5, 'solid': false},"
                           "{'type': 'disc', 'mass': 3, 'radius': 1, 'position': [3, 0], 'solid': false},"
                           "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                           "{'type': 'pin', 'ends': [{'block': 'Support 0', 'at': [3, 0]}, 'Disc 1']},"
                           "{'type': 'gear', 'ends': ['Disc 0', 'Disc 1'], 'ratio': 0.5},"
                           "{'type': 'impulse', 'ends': ['Disc 0'], 'angular_impulse': 2, 'time': 0.3}");
    physics_assert_near("first", physics_last(gears, 0), 2 / (0.25 + 0.25 * 1.5), 1e-11);
    physics_assert_near("second", physics_last(gears, 1), -1 / (0.25 + 0.25 * 1.5), 1e-11);
    g_autoptr(PhysicsRun) driven =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "Disc 0.angular velocity"},
                    GROUND "{'type': 'disc', 'position': [0, 0], 'angular_velocity': 2, 'solid': false},"
                           "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']},"
                           "{'type': 'drive', 'ends': ['Disc 0', 'Support 0'], 'speed': 2},"
                           "{'type': 'impulse', 'ends': ['Disc 0'], 'angular_impulse': 5, 'time': 0.3}");
    physics_assert_near("held", physics_last(driven, 0), 2, 1e-12);
    physics_assert_near("work", given(driven, TINKER_BOOK_MOTORS), 0, 1e-11);
    g_assert_cmpfloat(driven->summary->energy_balance_error, <, 1e-10);
}

/* What lies on a floor is not moved by a blow downwards, whatever its restitution; up it is thrown with J / m, and
 * along at an angle it goes with (J cos - mu J sin) / m, or not at all within the cone of friction. */
static void test_on_a_floor(void)
{
    static const struct {
        double angle, vx, vy;
    } cases[] = {{-UP, 0, 0}, {UP, 0, 2}, {-0.5, 0, 0}, {-1.4, 0, 0}};
    static const char *const bodies[] = {
        "{'type': 'disc', 'mass': 3, 'position': [0, 0.4]}",
        "{'type': 'mass', 'mass': 3, 'height': 0.8, 'width': 0.8, 'position': [0, 0.4]}"};
    static const char *const names[] = {"Disc 0", "Mass 0"};
    for (gsize b = 0; b < G_N_ELEMENTS(bodies); b++) {
        for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
            const double along = 6 * cos(cases[i].angle), into = -6 * sin(cases[i].angle);
            /* what sticks of a disc rolls: v = 2/3 of what it would have, by friction of a third; else it slips */
            const double held = b == 0 ? along / 3 : along, friction = fmin(held, fmax(0.2 * into, 0));
            g_autofree char *columns = g_strdup_printf("%s.vx, %s.vy", names[b], names[b]);
            g_autoptr(PhysicsRun) run = physics_run(
                &(PhysicsOptions){.duration = 0.25, .columns = columns},
                GRAVITY FLOOR "%s, {'type': 'impulse', 'ends': ['%s'], 'impulse': 6, 'angle': %.17g, 'time': 0.25}",
                bodies[b], names[b], cases[i].angle);
            physics_assert_near("vx", physics_last(run, 0), (along - friction) / 3, 1e-11);
            physics_assert_near("vy", physics_last(run, 1), cases[i].vy, 1e-11);
            g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-9);
            contact_assert_count(run, "blow", 1);
            contact_assert_count(run, "take-off", cases[i].vy > 0);
            contact_assert_count(run, "impact", 0);
        }
    }
}

/* As impulses, in fixed steps, the floor answers to a blow in the step behind it. */
static void test_by_impulses(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 0.5, .step = 0.001, .impulses = TRUE, .columns = "Mass 0.vx, Mass 0.vy"},
        GRAVITY FLOOR "{'type': 'mass', 'mass': 3, 'height': 0.8, 'position': [0, 0.4]},"
                      "{'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 6, 'time': 0.25}");
    physics_assert_near("vx", physics_last(run, 0), 2 - 0.2 * 9.81 * 0.25, 0.01);
    physics_assert_near("vy", physics_last(run, 1), 0, 1e-9);
}

/* A taut rope holds against a blow outwards and lets go at one inwards. */
static void test_rope(void)
{
    static const double angles[] = {-UP, UP};
    for (gsize i = 0; i < G_N_ELEMENTS(angles); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 0.5, .columns = "Mass 0.vy, Rope 0.tension"},
            GRAVITY GROUND
            "{'type': 'mass', 'mass': 2, 'position': [0, -1]}, {'type': 'rope', 'ends': ['Support 0', 'Mass 0']},"
            "{'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 2, 'angle': %.17g, 'time': 0.5}",
            angles[i]);
        physics_assert_near("v", physics_last(run, 0), i == 0 ? 0 : 1, 1e-11);
        physics_assert_near("tension", physics_last(run, 1), i == 0 ? 2 * 9.81 : 0, 1e-9);
        contact_assert_count(run, "slack", i == 1);
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-10);
    }
}

/* x = J / (m w) sin w (t - T), solved exactly. */
static void test_exact_motion(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "auto", .duration = 5, .columns = "Mass 0.x, Mass 0.vx"},
                    GROUND "{'type': 'mass', 'mass': 2, 'position': [0, 0]},"
                           "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 18, 'rest_length': 0},"
                           "{'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 4, 'time': 0.7}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i), since = t >= 0.7 ? t - 0.7 : 0;
        physics_assert_near("x", physics_value(run, i, 0), 2.0 / 3 * sin(3 * since), 1e-9);
        physics_assert_near("v", physics_value(run, i, 1), t >= 0.7 ? 2 * cos(3 * since) : 0, 1e-9);
    }
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-9);
}

/* Billiards: a ball struck so that it rolls at once is struck at 3/2 r, of a disc, above the table. */
static void test_rolls_at_once(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 2, .columns = "Disc 0.vx, Disc 0.angular velocity"}, GRAVITY FLOOR
                    "{'type': 'disc', 'mass': 3, 'radius': 0.4, 'position': [0, 0.4]},"
                    "{'type': 'impulse', 'ends': [{'block': 'Disc 0', 'at': [0, 0.2]}], 'impulse': 6, 'time': 0.5}");
    physics_assert_near("v", physics_last(run, 0), 2, 1e-9);
    physics_assert_near("w", physics_last(run, 1), -5, 1e-9);
    contact_assert_count(run, "slip", 0);
}

/* A ball comes to a wall at the very instant at which another one is struck, and rebounds as at any other. */
static void test_at_an_impact(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 3, .columns = "Disc 0.vx, Disc 0.x, Disc 1.vx"},
                    "{'type': 'support', 'position': [3, 0], 'orientation': '90 deg', 'restitution': 1},"
                    "{'type': 'disc', 'mass': 1, 'radius': 0.25, 'position': [0.55, 0], 'velocity': [1, 0]},"
                    "{'type': 'disc', 'mass': 1, 'radius': 0.25, 'position': [0, 3]},"
                    "{'type': 'impulse', 'ends': ['Disc 1'], 'impulse': 1, 'time': 2}");
    physics_assert_near("speed", physics_last(run, 0), -1, 1e-12);
    physics_assert_near("place", physics_last(run, 1), 1.55, 1e-12);
    physics_assert_near("other", physics_last(run, 2), 1, 1e-12);
}

/* Three balls that touch, e = 1, the first struck by 1 N s: by Newton's law they go on together; by Poisson's the same
 * impulses that bring them to one speed, 2/3 and 1/3, act once more; in sequence the blow runs through to the last. */
static void test_by_laws(void)
{
    static const struct {
        const char *law;
        double v[3];
    } cases[] = {
        {"newton", {1.0 / 3, 1.0 / 3, 1.0 / 3}}, {"poisson", {-1.0 / 3, 2.0 / 3, 2.0 / 3}}, {"sequential", {0, 0, 1}}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        PhysicsOptions options = {.columns = "Disc 0.vx, Disc 1.vx, Disc 2.vx", .impact_law = cases[i].law};
        g_autoptr(PhysicsRun) run =
            physics_run(&options, "%s",
                        "{'type': 'disc', 'mass': 1, 'radius': 0.25, 'restitution': 1, 'position': [0, 0]},"
                        "{'type': 'disc', 'mass': 1, 'radius': 0.25, 'restitution': 1, 'position': [0.5, 0]},"
                        "{'type': 'disc', 'mass': 1, 'radius': 0.25, 'restitution': 1, 'position': [1, 0]},"
                        "{'type': 'impulse', 'ends': ['Disc 0'], 'impulse': 1, 'time': 0.5}");
        for (gsize k = 0; k < 3; k++)
            physics_assert_near(cases[i].law, physics_last(run, k), cases[i].v[k], 1e-9);
    }
}

static void add_tests(void)
{
    g_test_add_func("/blows/at-an-impact", test_at_an_impact);
    g_test_add_func("/blows/by-laws", test_by_laws);
    g_test_add_func("/blows/free-bar", test_free_bar);
    g_test_add_func("/blows/ends-of-a-run", test_ends_of_a_run);
    g_test_add_func("/blows/turning", test_turning_blows);
    g_test_add_func("/blows/pinned-bar", test_pinned_bar);
    g_test_add_func("/blows/mass-on-a-rod", test_mass_on_a_rod);
    g_test_add_func("/blows/gears-and-drives", test_gears_and_drives);
    g_test_add_func("/blows/on-a-floor", test_on_a_floor);
    g_test_add_func("/blows/by-impulses", test_by_impulses);
    g_test_add_func("/blows/rope", test_rope);
    g_test_add_func("/blows/exact-motion", test_exact_motion);
    g_test_add_func("/blows/rolls-at-once", test_rolls_at_once);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
