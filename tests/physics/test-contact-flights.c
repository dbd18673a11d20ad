/* Long flights between blows: what is linear there is solved exactly, and rounding does not grow from blow to blow. The
 * truth is each flight in closed form, repeated; its phase is the remainder of a division of doubles, which is exact.
 */
#include "contact-checks.h"
#include "physics/system/summary.h"

#include <math.h>
#include <string.h>

static PhysicsOptions auto_options(double duration, double interval, const char *columns)
{
    return (PhysicsOptions){
        .method = "auto", .duration = duration, .interval = interval, .tolerance = 1e-9, .columns = columns};
}

static void assert_stepped_by(const PhysicsRun *run, const char *method)
{
    const TinkerIslandSummary *island = g_ptr_array_index(run->summary->islands, 0);
    g_assert_cmpstr(island->method, ==, method);
}

/* A ball that takes `half` seconds to the floor and back up: at rest on top at t = 0. */
static double ball_y(double t, const void *half)
{
    double T = *(const double *)half, phase = remainder(t, 2 * T);
    return 0.5 * CONTACT_GRAVITY * (T - phase) * (T + phase);
}

static double ball_vy(double t, const void *half)
{
    return -CONTACT_GRAVITY * remainder(t, 2 * *(const double *)half);
}

/* Nearly 1e5 bounces in 1e5 s. The start's height is rounded, which moves the instants by 1e-11 s and the ball by 1e-10
 * m. A mass that is no power of two rounds differently. */
static void test_elastic_ball(void)
{
    static const double masses[] = {1, 0.3}, durations[] = {1e5, 1e4};
    const double half = 0.57;
    for (gsize i = 0; i < G_N_ELEMENTS(masses); i++) {
        PhysicsOptions options = auto_options(durations[i], 1234.5, "Mass 0.y, Mass 0.vy");
        g_autoptr(PhysicsRun) run = physics_run(&options,
                                                CONTACT_WEIGHT CONTACT_FLOOR ", 'restitution': 1}, " CONTACT_POINT
                                                                             ", 'mass': %.17g, 'position': [0, %.17g]}",
                                                masses[i], ball_y(0, &half));
        physics_assert_follows(run, 0, ball_y, &half, 1e-9);
        physics_assert_follows(run, 1, ball_vy, &half, 1e-9);
        assert_stepped_by(run, "exact");
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* Between walls without friction the ball moves to and fro at one speed, whatever it does up and down. */
static double between_walls(double t, const void *speed)
{
    double way = remainder(*(const double *)speed * t, 4.0);
    return fabs(way) <= 1 ? way : copysign(2, way) - way;
}

static void test_ball_between_walls(void)
{
    const double half = 0.57, speed = 0.75;
    PhysicsOptions options = auto_options(2e4, 777.7, "Mass 0.x, Mass 0.y, Mass 0.vy");
    g_autofree char *left = contact_plate(-1, 0, -G_PI / 2, 20, "'restitution': 1, " CONTACT_SMOOTH);
    g_autofree char *right = contact_plate(1, 0, G_PI / 2, 20, "'restitution': 1, " CONTACT_SMOOTH);
    g_autoptr(PhysicsRun) run =
        physics_run(&options,
                    CONTACT_WEIGHT "%s, %s, " CONTACT_FLOOR ", 'width': 5, 'restitution': 1, " CONTACT_SMOOTH
                                   "}, " CONTACT_POINT ", 'mass': 0.3, 'position': [0, %.17g], 'velocity': [%.17g, 0]}",
                    left, right, ball_y(0, &half), speed);
    physics_assert_follows(run, 0, between_walls, &speed, 1e-9);
    physics_assert_follows(run, 1, ball_y, &half, 1e-9);
    physics_assert_follows(run, 2, ball_vy, &half, 1e-9);
}

/* A mass on a spring, whose swing a floor cuts off: it swings by A about a place that lies `above` the floor. */
typedef struct {
    double omega, above, swing;
} CutSwing;

static double cut_swing_y(double t, const void *data)
{
    const CutSwing *is = data;
    double period = 2 * acos(-is->above / is->swing) / is->omega;
    return is->above + is->swing * cos(is->omega * remainder(t, period));
}

static void test_swing_onto_floor(void)
{
    const double k = 2, m = 0.3, length = 0.5;
    const CutSwing swing = {sqrt(k / m), 2 - length - m * CONTACT_GRAVITY / k, 1.5};
    PhysicsOptions options = auto_options(2e4, 333.3, "Mass 0.y");
    g_autoptr(PhysicsRun) run =
        physics_run(&options,
                    CONTACT_WEIGHT CONTACT_FLOOR
                    ", 'restitution': 1}, {'type': 'support', 'solid': false, 'position': [0, 2]}, " CONTACT_POINT
                    ", 'mass': %.17g, 'position': [0, %.17g]}, {'type': 'spring', 'ends': ['Support 1', 'Mass 0'], "
                    "'stiffness': %.17g, 'rest_length': %.17g}",
                    m, swing.above + swing.swing, k, length);
    physics_assert_follows(run, 0, cut_swing_y, &swing, 1e-9);
    assert_stepped_by(run, "exact");
}

/* What lies on a plate is stepped by the method of contacts, and flies on exactly behind its end: 0.6 m are slid down a
 * smooth slope of 30 degrees, from whose end the mass goes down to an elastic floor, where it bounces on. */
static void test_flight_behind_a_slope(void)
{
    const double slope = -G_PI / 6, slid = 0.6, high = 1.3, fall = 0.05, g = CONTACT_GRAVITY;
    double landed = sqrt(2 * fall / g),
           u = g * landed * sin(-slope); /* of the speed of the fall what goes along the slope */
    double end = sqrt(u * u + 2 * g * sin(-slope) * slid), sliding = (end - u) / (g * sin(-slope));
    double down = end * sin(-slope), left = landed + sliding, below = sqrt(down * down + 2 * g * high);
    double first = left + (below - down) / g, period = 2 * below / g;
    g_autofree char *plate = contact_plate(0, high + slid * sin(-slope), slope, 2 * slid, CONTACT_SMOOTH);
    PhysicsOptions options = auto_options(first + 1000.25 * period, 0, "Mass 0.y, Mass 0.vx");
    g_autoptr(PhysicsRun) run = physics_run(
        &options,
        CONTACT_WEIGHT "%s, {'type': 'support', 'position': [0, -0.2], 'width': 1e6, 'restitution': 1, " CONTACT_SMOOTH
                       "}, " CONTACT_POINT ", 'position': [0, %.17g]}",
        plate, high + slid * sin(-slope) + fall);
    double rising = 0.25 * period;
    physics_assert_near("y", physics_last(run, 0), below * rising - g / 2 * rising * rising, 1e-7);
    physics_assert_near("vx", physics_last(run, 1), end * cos(slope), 1e-9);
    contact_assert_count(run, "end", 1);
    contact_assert_count(run, "impact", 1001);
    assert_stepped_by(run, "dop853");
    contact_assert_taken(run, 0, 0.5 * pow(g * landed * cos(slope), 2), 1e-9);
}

/* Between two slanted supports no digit lasts for long, so that a sample which changed a bit of the motion would show.
 */
static void test_samples_change_nothing(void)
{
    static const double intervals[] = {60, 0.1, 0.037};
    g_autoptr(PhysicsRun) first = NULL;
    for (gsize i = 0; i < G_N_ELEMENTS(intervals); i++) {
        g_autofree char *left = contact_plate(-2, 2, -0.7854, 8, "'restitution': 1, " CONTACT_SMOOTH);
        g_autofree char *right = contact_plate(2, 2, 0.9, 8, "'restitution': 1, " CONTACT_SMOOTH);
        PhysicsOptions options = auto_options(60, intervals[i], "Mass 0.y");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, %s, " CONTACT_POINT ", 'position': [0.3, 4]}", left, right);
        if (first == NULL)
            first = g_steal_pointer(&run);
        else
            physics_assert_same_bits(first, run);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-flights/elastic-ball", test_elastic_ball);
    g_test_add_func("/physics/contact-flights/ball-between-walls", test_ball_between_walls);
    g_test_add_func("/physics/contact-flights/swing-onto-floor", test_swing_onto_floor);
    g_test_add_func("/physics/contact-flights/flight-behind-a-slope", test_flight_behind_a_slope);
    g_test_add_func("/physics/contact-flights/samples-change-nothing", test_samples_change_nothing);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
