/* Restitution: elastic bounces, bounces that end in rest, oblique impacts with a Coulomb impulse. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* A hundred elastic bounces from 1 m: half a flight each way, and no energy lost. */
static void test_elastic(void)
{
    const double half = sqrt(2 / g);
    for (gsize i = 0; i < 6; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], half * 200 + 0.6 * half, NULL);
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                ", 'restitution': 1}, " CONTACT_POINT ", 'position': [0, 1]}");
        double flown = 0.6 * half, state[4];
        physics_state(run, "Mass 0", state);
        physics_assert_near("y", state[1], 1 - g / 2 * flown * flown, 1e-8);
        physics_assert_near("vy", state[3], -g * flown, 1e-8);
        physics_assert_near("energy", 0.5 * state[3] * state[3] + g * state[1], g, 1e-10 * g);
        contact_assert_count(run, "impact", 100);
        contact_assert_event(run, "impact", NULL, half * 199, 1e-8);
        contact_assert_event(run, "impact", NULL, half * 9, 1e-10);
        contact_assert_taken(run, 0, 0, 1e-9);
    }
}

/* Every rebound takes 1 - e^2 of the energy. Their times add up to (1 + e) / (1 - e) sqrt(2 h / g). */
static void test_ends_in_rest(void)
{
    const double e = 0.8, half = sqrt(2 / g), end = (1 + e) / (1 - e) * half;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 5, "Mass 0.y, Mass 0.normal force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR ", 'restitution': 0.8}, " CONTACT_POINT
                                                               ", 'mass': 2, 'position': [0, 1]}");
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
        physics_assert_near("normal force", physics_last(run, 1), 2 * g, 1e-9);
        double bound = contact_methods[i].polynomial, next = half, flight = 2 * half;
        for (int bounce = 0; bounce < 12; bounce++) {
            contact_assert_event(run, "impact", "Mass 0, Support 0", next, 20 * bound);
            flight *= e;
            next += flight;
        }
        /* what is left of the series where a rebound is below 1e-6 of the greatest speed */
        contact_assert_event(run, "rest", NULL, end, 1e-5 + 20 * bound);
        contact_assert_taken(run, 0, 2 * g, 50 * bound);
    }
}

static void test_first_rebound(void)
{
    static const double restitutions[] = {0.1, 0.5, 0.9, 0.999999};
    for (gsize i = 0; i < G_N_ELEMENTS(restitutions); i++) {
        double e = restitutions[i], half = sqrt(2 / g), v = e * g * half, flown = 0.15 * half;
        PhysicsOptions options = contact_options(&contact_methods[0], half + flown, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT CONTACT_FLOOR ", 'restitution': %.17g}, " CONTACT_POINT ", 'position': [0, 1]}",
            e);
        contact_assert_state(run, "Mass 0", (double[]){0, v * flown - g / 2 * flown * flown, 0, v - g * flown}, 1e-10);
        contact_assert_taken(run, 0, g * (1 - e * e), 1e-9);
    }
}

/* Down a frictionless slope: across it the bouncing ball, along it a free slide that impacts never touch. */
static void test_bounces_down_a_slope(void)
{
    const double e = 0.5, angle = 0.4, fall = 0.3, duration = 1.8;
    double half = sqrt(2 * fall / (g * cos(angle))), end = (1 + e) / (1 - e) * half;
    g_assert_cmpfloat(end, <, duration);
    g_autofree char *plate = contact_plate(0, 0, angle, 60, CONTACT_SMOOTH ", 'restitution': 0.5");
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'position': [%.17g, %.17g]}", plate,
                        -fall * sin(angle), fall * cos(angle));
        double way = -g / 2 * sin(angle) * duration * duration, v = -g * sin(angle) * duration;
        contact_assert_state(run, "Mass 0",
                             (double[]){way * cos(angle), way * sin(angle), v * cos(angle), v * sin(angle)},
                             contact_methods[i].polynomial);
        contact_assert_event(run, "impact", NULL, half, contact_methods[i].polynomial);
        contact_assert_event(run, "impact", NULL, 2 * half, 2 * contact_methods[i].polynomial);
        contact_assert_event(run, "rest", NULL, end, 1e-5 + 5 * contact_methods[i].polynomial);
    }
}

/* An oblique impact on a turned plate without weight. What is left along the top: 0 where friction can take all of it,
 * else less by friction times (1 + e) of the speed across. */
static void check_oblique(double angle, double across, double along, double friction, double e)
{
    double normal[2] = {-sin(angle), cos(angle)}, tangent[2] = {cos(angle), sin(angle)};
    double most = friction * (1 + e) * across, left = fabs(along) <= most ? 0 : along - copysign(most, along);
    const double touch = 0.25, duration = 0.75;
    double start[4], state[4];
    for (int k = 0; k < 2; k++) {
        start[2 + k] = along * tangent[k] - across * normal[k];
        start[k] = -touch * start[2 + k];
        state[2 + k] = left * tangent[k] + e * across * normal[k];
        state[k] = (duration - touch) * state[2 + k];
    }
    g_autofree char *more =
        g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g, 'restitution': %g", 2 * friction, friction, e);
    g_autofree char *plate = contact_plate(0, 0, angle, 4, more);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run = physics_run(&options,
                                                "%s, " CONTACT_POINT ", 'mass': 3, 'position': [%.17g, %.17g], "
                                                "'velocity': [%.17g, %.17g]}",
                                                plate, start[0], start[1], start[2], start[3]);
        contact_assert_state(run, "Mass 0", state, 1e-12);
        contact_assert_event(run, e > 0 ? "impact" : "rest", NULL, touch, 1e-12);
        contact_assert_taken(run, 0, 1.5 * (along * along - left * left + (1 - e * e) * across * across), 1e-11);
    }
}

static void test_oblique(void)
{
    check_oblique(25 * G_PI / 180, 4, 3, 0.3, 0.5);
    check_oblique(25 * G_PI / 180, 4, -3, 0.3, 0.5);
    check_oblique(-70 * G_PI / 180, 4, 1.7, 0.3, 0.5);
    check_oblique(200 * G_PI / 180, 4, -1.7, 0.3, 0.5);
    check_oblique(0, 2, 5, 0.25, 1);
    check_oblique(0, 2, 5, 0, 0.7);
    /* what stays in contact does not slide on by friction: nothing presses it */
    check_oblique(1, 2, 5, 0.25, 0);
    check_oblique(1, 2, 0.4, 0.25, 0);
}

static void test_a_support_has_its_own(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 0.6, NULL);
    g_autoptr(PhysicsRun) run =
        physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                    ", 'restitution': 0.9}, "
                    "{'type': 'support', 'position': [4, -0.2], 'restitution': 0.3}," CONTACT_POINT
                    ", 'position': [0, 1]}, " CONTACT_POINT ", 'position': [4, 1]}");
    double half = sqrt(2 / g), t = 0.6 - half, v = g * half;
    contact_assert_state(run, "Mass 0", (double[]){0, 0.9 * v * t - g / 2 * t * t, 0, 0.9 * v - g * t}, 1e-10);
    contact_assert_state(run, "Mass 1", (double[]){4, 0.3 * v * t - g / 2 * t * t, 0, 0.3 * v - g * t}, 1e-10);
    contact_assert_event(run, "impact", "Mass 0, Support 0", half, 1e-10);
    contact_assert_event(run, "impact", "Mass 1, Support 1", half, 1e-10);
    contact_assert_count(run, "impact", 2);
}

/* Between a floor and a ceiling, without weight: a triangle wave. */
static void test_between_two(void)
{
    const double v = 7, duration = 10.03;
    for (gsize i = 0; i < 6; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_FLOOR
                        ", 'restitution': 1, " CONTACT_SMOOTH
                        "}, {'type': 'support', 'position': [0, 1.2], 'orientation': '180 deg', "
                        "'restitution': 1}," CONTACT_POINT ", 'position': [0, 0.25], 'velocity': [0.1, 7]}");
        double way = 0.25 + v * duration, phase = fmod(way, 2);
        double y = phase < 1 ? phase : 2 - phase, vy = phase < 1 ? v : -v;
        double state[4];
        physics_state(run, "Mass 0", state);
        physics_assert_near("y", state[1], y, 1e-10);
        physics_assert_near("vy", state[3], vy, 1e-11);
        contact_assert_count(run, "impact", (int)floor(way));
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-bounces/elastic", test_elastic);
    g_test_add_func("/physics/contact-bounces/ends-in-rest", test_ends_in_rest);
    g_test_add_func("/physics/contact-bounces/first-rebound", test_first_rebound);
    g_test_add_func("/physics/contact-bounces/bounces-down-a-slope", test_bounces_down_a_slope);
    g_test_add_func("/physics/contact-bounces/oblique", test_oblique);
    g_test_add_func("/physics/contact-bounces/a-support-has-its-own", test_a_support_has_its_own);
    g_test_add_func("/physics/contact-bounces/between-two", test_between_two);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
