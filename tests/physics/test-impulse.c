/* Contact as impulses: bodies that move alone, against closed forms, to first order in the step. */
#include "contact-checks.h"
#include "physics/model/model.h"

#include <math.h>
#include <string.h>

static const double g = CONTACT_GRAVITY;

static PhysicsOptions options_of(double step, double duration, const char *columns)
{
    return (PhysicsOptions){.impulses = TRUE, .step = step, .duration = duration, .columns = columns};
}

/* What a scene is off at the end, by step; the slope of the logarithms by least squares. */
static double observed_order(double (*miss)(double step), double coarsest, int halvings)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < halvings; i++) {
        double step = ldexp(coarsest, -i), u = log(step), v = log(miss(step));
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (halvings * xy - x * y) / (halvings * xx - x * x);
}

static double off_by(const PhysicsRun *run, const double truth[4])
{
    double state[4], most = 0;
    physics_state(run, "Mass 0", state);
    for (int i = 0; i < 4; i++)
        most = fmax(most, fabs(state[i] - truth[i]));
    return most;
}

/* --- falls and slides --- */

static double miss_of_fall(double step)
{
    PhysicsOptions options = options_of(step, 0.5, NULL);
    g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                            "}, " CONTACT_POINT ", 'position': [0, 3], 'velocity': [1, 2]}");
    return off_by(run, (double[]){0.5, 3 + 2 * 0.5 - g / 8, 1, 2 - g / 2});
}

static void test_fall(void)
{
    physics_assert_near("the order of a fall", observed_order(miss_of_fall, 0.02, 6), 1, 0.05);
}

/* Falls, and rests to the last bit where the top is, at any step. */
static void test_rests(void)
{
    for (double step = 0.05; step > 1e-4; step /= 3) {
        PhysicsOptions options =
            options_of(step, 2, "Mass 0.y, Mass 0.vy, Mass 0.normal force, Support 0.normal force, Mass 0.ay");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR "}, {'type': 'mass', 'mass': 3, 'position': [0.5, 2]}");
        for (gsize k = 0; k < physics_samples(run); k++)
            g_assert_cmpfloat(physics_value(run, k, 0), >=, 0.4 - 1e-15);
        physics_assert_near("y", physics_last(run, 0), 0.4, 1e-15);
        physics_assert_near("vy", physics_last(run, 1), 0, 0);
        physics_assert_near("normal force", physics_last(run, 2), 3 * g, 1e-12);
        physics_assert_near("normal force on the floor", physics_last(run, 3), 3 * g, 1e-12);
        physics_assert_near("ay", physics_last(run, 4), 0, 1e-12);
        physics_assert_near("what impacts took", run->summary->books[TINKER_BOOK_CONTACTS], -3 * g * 1.6,
                            30 * 6 * step);
        g_assert_cmpstr(run->summary->method, ==, "impulse");
    }
}

/* Upwards at first, so that it turns on its way: friction turns with it. */
static void test_slides(void)
{
    const double angle = G_PI / 6, friction = 0.3, t = 1.2;
    g_autofree char *plate = contact_plate(0, 0, angle, 40, "'static_friction': 0.4, 'dynamic_friction': 0.3");
    double up = g * (sin(angle) + friction * cos(angle)), down = g * (sin(angle) - friction * cos(angle)), v = 3;
    double turn = v / up, s = v * v / 2 / up - down / 2 * (t - turn) * (t - turn), u = -down * (t - turn),
           last = INFINITY;
    for (double step = 0.01; step > 1e-4; step /= 4) {
        PhysicsOptions options = options_of(step, t, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'velocity': [%.17g, %.17g]}", plate,
                        v * cos(angle), v * sin(angle));
        double miss = off_by(run, (double[]){s * cos(angle), s * sin(angle), u * cos(angle), u * sin(angle)});
        g_assert_cmpfloat(miss, <, 15 * step);
        last = miss;
    }
    g_assert_cmpfloat(last, <, 3e-3);
}

static double miss_of_slide_down(double step)
{
    const double angle = G_PI / 6, friction = 0.3, down = g * (sin(angle) - friction * cos(angle)), t = 1.5;
    const double s = -down / 2 * t * t, u = -down * t;
    g_autofree char *plate = contact_plate(0, 0, angle, 40, "'static_friction': 0.3, 'dynamic_friction': 0.3");
    PhysicsOptions options = options_of(step, t, NULL);
    g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT "}", plate);
    physics_assert_near("what friction took", run->summary->books[TINKER_BOOK_FRICTION], friction * g * cos(angle) * s,
                        100 * step);
    return off_by(run, (double[]){s * cos(angle), s * sin(angle), u * cos(angle), u * sin(angle)});
}

static void test_slides_down(void)
{
    physics_assert_near("the order of a slide", observed_order(miss_of_slide_down, 0.02, 6), 1, 0.05);
}

/* --- sticking --- */

/* Falls onto a slope, and from then on does not move by a bit in 600 s. */
static void test_sticks(void)
{
    static const double shares[] = {0.5, 0.999};
    for (gsize i = 0; i < G_N_ELEMENTS(shares); i++) {
        double angle = atan(0.5) * shares[i];
        g_autofree char *plate = contact_plate(0.3, 0.7, angle, 20, "'static_friction': 0.5, 'dynamic_friction': 0.5");
        PhysicsOptions options =
            options_of(0.01, 600, "Mass 0.x, Mass 0.y, Mass 0.vx, Mass 0.vy, Mass 0.friction force");
        options.interval = 0.5;
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, {'type': 'mass', 'mass': 2, 'position': [0.2, 1.1]}", plate);
        gsize first = 0;
        while (first < physics_samples(run) &&
               !(first > 0 && physics_value(run, first, 2) == 0 && physics_value(run, first, 3) == 0))
            first++;
        g_assert_cmpfloat(physics_time(run, first), <, 10);
        for (gsize k = first; k < physics_samples(run); k++) {
            physics_assert_near("x", physics_value(run, k, 0), physics_value(run, first, 0), 0);
            physics_assert_near("y", physics_value(run, k, 1), physics_value(run, first, 1), 0);
        }
        physics_assert_near("friction", physics_last(run, 4), 2 * g * sin(angle), 1e-9);
    }
}

/* Just beyond the angle it slides. */
static void test_slips(void)
{
    const double angle = 26.57 * G_PI / 180;
    g_autofree char *plate = contact_plate(0, 0, angle, 20, "'static_friction': 0.5, 'dynamic_friction': 0.5");
    PhysicsOptions options = options_of(0.001, 10, NULL);
    g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT "}", plate);
    double s = -g / 2 * (sin(angle) - 0.5 * cos(angle)) * 100;
    contact_assert_state(run, "Mass 0",
                         (double[]){s * cos(angle), s * sin(angle), s / 5 * cos(angle), s / 5 * sin(angle)}, 2e-5);
}

/* A static coefficient that holds what a dynamic one would not. */
static void test_static_coefficient(void)
{
    const double angle = 0.35;
    g_autofree char *plate = contact_plate(0, 0, angle, 20, "'static_friction': 0.4, 'dynamic_friction': 0.1");
    PhysicsOptions options = options_of(0.003, 60, NULL);
    g_autoptr(PhysicsRun) rests = physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT "}", plate);
    contact_assert_state(rests, "Mass 0", (double[]){0, 0, 0, 0}, 0);
    options.duration = 2;
    g_autoptr(PhysicsRun) slides = physics_run(
        &options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'velocity': [%.17g, %.17g]}", plate, -cos(angle), -sin(angle));
    double v = -1 - 2 * g * (sin(angle) - 0.1 * cos(angle));
    contact_assert_state(slides, "Mass 0",
                         (double[]){(v - 1) * cos(angle), (v - 1) * sin(angle), v * cos(angle), v * sin(angle)}, 0.02);
}

/* --- bounces --- */

static double miss_of_bounces(double step)
{
    const double e = 0.8, fall = sqrt(2 / g), times[] = {fall + e * fall, fall + 2 * e * fall + 0.5 * e * e * fall};
    PhysicsOptions options = options_of(step, 2, "Mass 0.y");
    options.at = times;
    options.at_count = 2;
    g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                            ", 'restitution': 0.8}, " CONTACT_POINT ", 'position': [0, 1]}");
    return fmax(fabs(physics_value(run, 0, 0) - e * e), fabs(physics_value(run, 1, 0) - 0.75 * e * e * e * e));
}

static void test_bounces(void)
{
    for (double step = 0.01; step > 1e-5; step /= 3)
        physics_assert_near("heights of bounces", miss_of_bounces(step), 0, 10 * step);
    physics_assert_near("the order of bounces", observed_order(miss_of_bounces, 0.01, 11), 1, 0.2);
}

/* Restitution 1 loses nothing and gains nothing, for hundreds of bounces; below 1 all bounces end in rest. */
static void test_bounces_go_on_or_end(void)
{
    PhysicsOptions options = options_of(1e-3, 500, "Mass 0.y");
    options.interval = 0.01;
    g_autoptr(PhysicsRun) on = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR ", 'restitution': 1}, " CONTACT_POINT
                                                                                  ", 'position': [0, 1]}");
    double highest = 0;
    for (gsize k = physics_samples(on) - 200; k < physics_samples(on); k++)
        highest = fmax(highest, physics_value(on, k, 0));
    physics_assert_near("the height after 550 bounces", highest, 1, 0.02);
    options.duration = 20;
    g_autoptr(PhysicsRun) ends = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                             ", 'restitution': 0.7}, " CONTACT_POINT ", 'position': [0, 1]}");
    contact_assert_state(ends, "Mass 0", (double[]){0, 0, 0, 0}, 0);
    double fall = sqrt(2 / g), rest = fall * (1 + 2 * 0.7 / 0.3);
    gsize last = physics_samples(ends) - 1;
    while (physics_value(ends, last, 0) == 0)
        last--;
    physics_assert_near("the time of rest", physics_time(ends, last), rest, 0.1);
}

/* --- plates that move --- */

static void test_lift(void)
{
    PhysicsOptions options = options_of(1e-3, 1.5, "Mass 0.y, Mass 0.vy, Mass 0.normal force");
    options.interval = 0.01234;
    g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                            "}, " CONTACT_POINT ", 'mass': 3},"
                                            "{'type': 'support-motion', 'ends': ['Support 0'], 'angle': '90 deg', "
                                            "'waveform': {'expression': 't^2 - t^3/2'}}");
    for (gsize k = 1; k < physics_samples(run); k++) {
        double t = physics_time(run, k);
        physics_assert_near("y", physics_value(run, k, 0), t * t - t * t * t / 2, 1e-6);
        g_assert_cmpfloat(physics_value(run, k, 0), >=, t * t - t * t * t / 2 - 1e-15);
        physics_assert_near("vy", physics_value(run, k, 1), 2 * t - 1.5 * t * t, 1e-5);
        physics_assert_near("normal force", physics_value(run, k, 2), 3 * (g + 2 - 3 * t), 0.01);
    }
    physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, 1e-3);
}

/* A belt at 2 m/s takes the mass along. */
static void check_belt(double v)
{
    const double friction = 0.25, speed = 2, duration = 3;
    double sliding = fabs(speed - v) / (friction * g), a = copysign(friction * g, speed - v);
    double x = v * sliding + a / 2 * sliding * sliding + speed * (duration - sliding);
    PhysicsOptions options = options_of(1e-3, duration, "Mass 0.friction force");
    g_autoptr(PhysicsRun) run = physics_run(
        &options,
        CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 40, 'static_friction': 0.3, 'dynamic_friction': 0.25}, " CONTACT_POINT
                                     ", 'mass': 4, 'velocity': [%g, 0]}, {'type': 'support-motion', 'ends': "
                                     "['Support 0'], 'waveform': {'expression': '2*t'}}",
        v);
    contact_assert_state(run, "Mass 0", (double[]){x, 0, speed, 0}, 5e-3);
    physics_assert_near("friction", physics_value(run, 1, 0), 4 * a, 1e-9);
    physics_assert_near("friction of what is carried", physics_last(run, 0), 0, 1e-9);
    physics_assert_near("what friction took", run->summary->books[TINKER_BOOK_FRICTION], -2 * (speed - v) * (speed - v),
                        0.1);
    physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, 1e-3);
}

static void test_belt(void)
{
    check_belt(0);
    check_belt(-1);
    check_belt(5);
}

/* --- springs --- */

/* A mass that a spring presses onto a rough floor: it slides, swings and stops, as events tell. */
static void test_spring(void)
{
    static const char blocks[] = CONTACT_WEIGHT CONTACT_FLOOR
        ", 'width': 20, 'static_friction': 0.3, 'dynamic_friction': 0.2}, {'type': 'support', 'solid': false, "
        "'position': "
        "[0, 2]}, " CONTACT_POINT ", 'position': [1.7, 0]}, {'type': 'spring', 'ends': ['Support 1', 'Mass 0'], "
        "'stiffness': 30, 'rest_length': 2.2}";
    PhysicsOptions exactly = {.method = "dop853", .tolerance = 1e-11, .duration = 4, .columns = "Mass 0.x, Mass 0.y"};
    g_autoptr(PhysicsRun) events = physics_run(&exactly, "%s", blocks);
    for (double step = 4e-3; step > 1e-5; step /= 8) {
        PhysicsOptions options = options_of(step, 4, "Mass 0.x, Mass 0.y");
        g_autoptr(PhysicsRun) run = physics_run(&options, "%s", blocks);
        for (gsize k = 0; k < physics_samples(run); k++)
            for (gsize c = 0; c < 2; c++)
                physics_assert_near("place", physics_value(run, k, c), physics_value(events, k, c), 8 * step);
    }
}

/* A step beyond what is stable is told before the run, and stops it. */
static void test_unstable_step(void)
{
    PhysicsOptions options = options_of(0.01, 5, NULL);
    g_autoptr(PhysicsRun) run =
        physics_try(&options, CONTACT_FLOOR "}, " CONTACT_POINT ", 'position': [0, 1]}, " CONTACT_POINT
                                            ", 'position': [0.5, 1.6]}, {'type': 'spring', 'ends': ['Mass 0', "
                                            "'Mass 1'], 'stiffness': 1e6, 'rest_length': 0.7}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_RUN, "diverged", "impulse is stable up to a step of about 0.0014",
                           "or contact by events", NULL);
    g_assert_cmpuint(run->summary->warnings->len, >, 0);
    g_assert_nonnull(strstr(tinker_warnings_text(run->summary->warnings, 0), "contacts as events"));
    g_assert_nonnull(
        strstr(tinker_warnings_text(run->summary->warnings, 0), "impulse is stable up to a step of 0.00141 s"));
}

/* --- several plates --- */

/* In a V between two tops, smooth and rough: there it stays, to the last bit. */
static void test_corner(void)
{
    static const char *const friction[] = {CONTACT_SMOOTH, "'static_friction': 0.5, 'dynamic_friction': 0.5"};
    for (gsize i = 0; i < 2; i++) {
        g_autofree char *left = contact_plate(-1, 1, -G_PI / 4, 4, friction[i]);
        g_autofree char *right = contact_plate(1, 1, G_PI / 4, 4, friction[i]);
        PhysicsOptions options =
            options_of(2e-3, 20, "Mass 0.x, Mass 0.y, Mass 0.normal force, Support 0.normal force");
        options.interval = 0.1;
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT "%s, %s, " CONTACT_POINT ", 'mass': 2, 'position': [0.3, 2]}", left, right);
        gsize last = physics_samples(run) - 1;
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, i == 0 ? 1e-13 : 1);
        for (gsize k = last - 50; k < last; k++) {
            physics_assert_near("x", physics_value(run, k, 0), physics_last(run, 0), 0);
            physics_assert_near("y", physics_value(run, k, 1), physics_last(run, 1), 0);
            g_assert_cmpfloat(physics_value(run, k, 1), >=, fabs(physics_value(run, k, 0)) - 1e-14);
        }
        if (i == 0) physics_assert_near("what presses", physics_last(run, 2), 2 * 2 * g / sqrt(2), 1e-9);
        if (i == 0) physics_assert_near("what presses the left", physics_last(run, 3), 2 * g / sqrt(2), 1e-9);
    }
}

/* Slides along the floor and meets a wall, with a bounce: the floor goes on rubbing. */
static void test_wall(void)
{
    g_autofree char *wall = contact_plate(2, 1, G_PI / 2, 2, CONTACT_SMOOTH ", 'restitution': 0.5");
    double last = INFINITY;
    for (double step = 0.01; step > 1e-4; step /= 4) {
        PhysicsOptions options = options_of(step, 1.5, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        CONTACT_WEIGHT CONTACT_FLOOR
                        ", 'width': 20, 'static_friction': 0.1, 'dynamic_friction': 0.1}, %s, " CONTACT_POINT
                        ", 'velocity': [3, 0]}",
                        wall);
        double a = 0.1 * g, hit = (3 - sqrt(9 - 4 * a)) / a, v = -0.5 * (3 - a * hit), left = 1.5 - hit;
        double state[4];
        physics_state(run, "Mass 0", state);
        last = fmax(fabs(state[0] - (2 + v * left + a / 2 * left * left)), fabs(state[2] - (v + a * left)));
        g_assert_cmpfloat(last, <, 10 * step);
        physics_assert_near("y", state[1], 0, 1e-15);
    }
    g_assert_cmpfloat(last, <, 2e-3);
}

/* Whatever the masses: v1 = (m1 - m2) / (m1 + m2) v, v2 = 2 m1 / (m1 + m2) v, whose work on the contact is 0, which
 * rounding must not take for a gain. */
static void test_elastic(void)
{
    for (int i = 1; i <= 20; i++) {
        const double m = 0.3 * i, v = 1.9;
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 3, .step = 0.001, .impulses = TRUE, .columns = "Mass 0.vx, Mass 1.vx"},
            "{'type': 'mass', 'mass': 3.2, 'width': 0.2, 'height': 0.2, 'position': [-1, 0], 'velocity': [%g, 0],"
            " 'collides': true, 'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0},"
            "{'type': 'mass', 'mass': %.17g, 'width': 0.2, 'height': 0.2, 'position': [0.5, 0],"
            " 'collides': true, 'restitution': 1, 'static_friction': 0, 'dynamic_friction': 0}",
            v, m);
        physics_assert_near("one", physics_last(run, 0), (3.2 - m) / (3.2 + m) * v, 1e-9);
        physics_assert_near("other", physics_last(run, 1), 6.4 / (3.2 + m) * v, 1e-9);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/impulse/elastic", test_elastic);
    g_test_add_func("/physics/impulse/fall", test_fall);
    g_test_add_func("/physics/impulse/rests", test_rests);
    g_test_add_func("/physics/impulse/slides", test_slides);
    g_test_add_func("/physics/impulse/slides-down", test_slides_down);
    g_test_add_func("/physics/impulse/sticks", test_sticks);
    g_test_add_func("/physics/impulse/slips", test_slips);
    g_test_add_func("/physics/impulse/static-coefficient", test_static_coefficient);
    g_test_add_func("/physics/impulse/bounces", test_bounces);
    g_test_add_func("/physics/impulse/bounces-go-on-or-end", test_bounces_go_on_or_end);
    g_test_add_func("/physics/impulse/lift", test_lift);
    g_test_add_func("/physics/impulse/belt", test_belt);
    g_test_add_func("/physics/impulse/spring", test_spring);
    g_test_add_func("/physics/impulse/unstable-step", test_unstable_step);
    g_test_add_func("/physics/impulse/corner", test_corner);
    g_test_add_func("/physics/impulse/wall", test_wall);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
