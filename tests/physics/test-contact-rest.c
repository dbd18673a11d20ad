/* Contact as the thesis has it: a mass that meets a top from above stops, lies, slides with Coulomb friction, leaves
 * over the end and passes from behind. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* --- landing --- */

static void test_drop(void)
{
    const double fall = 2.6, landing = sqrt(2 * fall / g);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options =
            contact_options(&contact_methods[i], 2, "Mass 0.y, Mass 0.vy, Mass 0.normal force, Support 0.normal force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR "}, {'type': 'mass', 'mass': 3, 'position': [0.5, 3]}");
        double bound = contact_methods[i].polynomial;
        for (gsize k = 0; k < physics_samples(run); k++) {
            double t = physics_time(run, k);
            gboolean lies = t > landing;
            physics_assert_near("y", physics_value(run, k, 0), lies ? 0.4 : 3 - g / 2 * t * t, lies ? 1e-12 : bound);
            physics_assert_near("vy", physics_value(run, k, 1), lies ? 0 : -g * t, lies ? 1e-12 : bound);
            physics_assert_near("normal force", physics_value(run, k, 2), lies ? 3 * g : 0, 1e-9);
            physics_assert_near("normal force on the floor", physics_value(run, k, 3), lies ? 3 * g : 0, 1e-9);
        }
        contact_assert_event(run, "rest", "Mass 0, Support 0", landing, bound);
        contact_assert_count(run, "impact", 0);
        contact_assert_taken(run, 0, 3 * g * fall, 60 * bound);
    }
}

/* A box falls on a plate turned by 30 degrees: what is across goes, a Coulomb impulse slows it along; it slides to the
 * lower end and flies on. */
typedef struct {
    double landing, end, from, speed, left, acceleration; /* along the plate, positive upwards */
} Slide;

static Slide slide_of(double angle, double friction, double height, double x, double fall, double half)
{
    Slide slide = {.landing = sqrt(2 * fall / g)};
    double y = (x * sin(angle) + height / 2) / cos(angle), fast = sqrt(2 * g * fall);
    slide.from = x * cos(angle) + y * sin(angle);
    slide.speed = -fast * (sin(angle) - friction * cos(angle));
    slide.acceleration = -g * (sin(angle) - friction * cos(angle));
    slide.left = -sqrt(slide.speed * slide.speed - 2 * slide.acceleration * (slide.from + half));
    slide.end = slide.landing + (slide.left - slide.speed) / slide.acceleration;
    return slide;
}

static void test_slides_off_a_turned_plate(void)
{
    const double angle = G_PI / 6, friction = 0.2, height = 0.5, x = 0.5, half = 2, duration = 2;
    Slide slide = slide_of(angle, friction, height, x, 1, half);
    double tangent[2] = {cos(angle), sin(angle)}, normal[2] = {-sin(angle), cos(angle)};
    double flight = duration - slide.end, state[4];
    g_assert_cmpfloat(flight, >, 0.1);
    for (int k = 0; k < 2; k++) {
        double weight = k == 1 ? -g : 0;
        state[2 + k] = slide.left * tangent[k] + weight * flight;
        state[k] = -half * tangent[k] + height / 2 * normal[k] + slide.left * tangent[k] * flight +
                   weight / 2 * flight * flight;
    }
    g_autofree char *plate = contact_plate(0, 0, angle, 2 * half, "'static_friction': 0.2, 'dynamic_friction': 0.2");
    double top = (x * sin(angle) + height / 2) / cos(angle);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], duration, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT "%s, {'type': 'mass', 'mass': 2, 'height': 0.5, 'position': [%.17g, %.17g]}",
            plate, x, top + 1);
        double bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", state, 10 * bound);
        contact_assert_event(run, "rest", NULL, slide.landing, bound);
        contact_assert_event(run, "end", "Mass 0, Support 0", slide.end, 2 * bound);
        contact_assert_taken(run, friction * 2 * g * cos(angle) * (slide.from + half),
                             2 * g - slide.speed * slide.speed, 100 * bound);
    }
}

/* --- what passes --- */

static void test_passes_from_behind(void)
{
    /* Beneath, from below, through either end below the top, from inside, and from just below the top. */
    static const double starts[][4] = {{0, -3, 0, 0},     {0, -3, 0, 4},   {-3, -0.1, 50, 0},
                                       {3, -0.1, -50, 0}, {0, -0.2, 0, 0}, {0, -0.000001, 0, 0}};
    const double t = 1.5;
    for (gsize i = 0; i < G_N_ELEMENTS(starts); i++) {
        const double *s = starts[i];
        for (gsize m = 0; m < CONTACT_METHODS; m++) {
            PhysicsOptions options = contact_options(&contact_methods[m], t, NULL);
            g_autoptr(PhysicsRun) run = physics_run(&options,
                                                    CONTACT_WEIGHT CONTACT_FLOOR
                                                    "}, " CONTACT_POINT ", 'position': [%g, %g], 'velocity': [%g, %g]}",
                                                    s[0], s[1], s[2], s[3]);
            contact_assert_state(run, "Mass 0",
                                 (double[]){s[0] + s[2] * t, s[1] + s[3] * t - g / 2 * t * t, s[2], s[3] - g * t},
                                 contact_methods[m].polynomial);
            contact_assert_taken(run, 0, 0, 0);
        }
    }
}

static void test_passes_a_plate_turned_over(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 1.5, NULL);
    g_autoptr(PhysicsRun) run = physics_run(
        &options, CONTACT_WEIGHT "{'type': 'support', 'orientation': '180 deg'}, {'type': 'mass', 'position': [0, 3]}");
    contact_assert_state(run, "Mass 0", (double[]){0, 3 - g / 2 * 2.25, 0, -g * 1.5}, 1e-10);
    contact_assert_count(run, "rest", 0);
}

/* Up through the plate, and down onto its top. */
static void test_lands_where_it_crossed(void)
{
    double landing = (10 + sqrt(100 - 2 * g * 3)) / g;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 2.5, NULL);
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                "}," CONTACT_POINT ", 'position': [0, -3], 'velocity': [0, 10]}");
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
        contact_assert_event(run, "rest", NULL, landing, contact_methods[i].polynomial);
        contact_assert_taken(run, 0, 50 - 3 * g, 20 * contact_methods[i].polynomial);
    }
}

/* --- friction --- */

/* Downwards at 3 m/s where friction is stronger than the slope: it stops and stays. */
static void test_friction_stops_it(void)
{
    const double angle = 20 * G_PI / 180, friction = 0.5, v = 3;
    double brake = g * (friction * cos(angle) - sin(angle)), way = v * v / 2 / brake;
    g_autofree char *plate = contact_plate(0, 0, angle, 20, "");
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 5,
                                                 "Mass 0.friction force, Mass 0.normal force, Support "
                                                 "0.friction force, Mass 0.contact force");
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'mass': 2, 'velocity': [%.17g, %.17g]}", plate,
                        -v * cos(angle), -v * sin(angle));
        double bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){-way * cos(angle), -way * sin(angle), 0, 0}, bound);
        contact_assert_event(run, "stick", "Mass 0, Support 0", v / brake, bound);
        contact_assert_taken(run, friction * 2 * g * cos(angle) * way, 0, 50 * bound);
        physics_assert_near("sliding friction", physics_value(run, 1, 0), friction * 2 * g * cos(angle), 1e-9);
        physics_assert_near("holding friction", physics_last(run, 0), 2 * g * sin(angle), 1e-9);
        physics_assert_near("normal force", physics_last(run, 1), 2 * g * cos(angle), 1e-9);
        physics_assert_near("friction on the plate", physics_last(run, 2), -2 * g * sin(angle), 1e-9);
        physics_assert_near("contact force", physics_last(run, 3), 2 * g, 1e-9);
    }
}

/* Dropped on a slope below the friction angle: the impulse along the top stops it at once. */
static void test_lands_and_sticks(void)
{
    const double angle = 20 * G_PI / 180;
    g_autofree char *plate = contact_plate(0, 0, angle, 20, "");
    PhysicsOptions options = contact_options(&contact_methods[0], 3, NULL);
    g_autoptr(PhysicsRun) run =
        physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'position': [0, 2]}", plate);
    contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
    contact_assert_event(run, "rest", NULL, sqrt(4 / g), 1e-10);
    contact_assert_taken(run, 0, 2 * g, 1e-9);
}

/* From rest for this long: how far it comes down a slope of the default friction. */
static double slid(const ContactMethod *method, double angle, double duration, const char *more)
{
    g_autofree char *plate = contact_plate(0, 0, angle, 50, more);
    PhysicsOptions options = contact_options(method, duration, NULL);
    if (options.step > 0 && duration > 100) options.step = 0.1;
    g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT "}", plate);
    double state[4];
    physics_state(run, "Mass 0", state);
    return -(state[0] * cos(angle) + state[1] * sin(angle));
}

static void test_threshold(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        const ContactMethod *method = &contact_methods[i];
        double angle = 26.57 * G_PI / 180, way = 50 * g * (sin(angle) - 0.5 * cos(angle));
        physics_assert_near("that way", way, 0.0473667, 5e-8);
        physics_assert_near("way at 26.57 degrees", slid(method, angle, 10, ""), way, method->polynomial);
        physics_assert_near("way at 26.56 degrees", slid(method, 26.56 * G_PI / 180, 10, ""), 0, 1e-15);
        physics_assert_near("way at 0.999 of the angle", slid(method, 0.999 * atan(0.5), 600, ""), 0, 1e-9);
        physics_assert_near("way at -0.999 of the angle", slid(method, -0.999 * atan(0.5), 600, ""), 0, 1e-9);
    }
}

/* Between the two coefficients what lies stays, what slides goes on. */
static void test_static_coefficient(void)
{
    static const char both[] = "'static_friction': 0.6, 'dynamic_friction': 0.3";
    const double angle = 25 * G_PI / 180;
    physics_assert_near("from rest", slid(&contact_methods[0], angle, 10, both), 0, 1e-15);
    g_autofree char *plate = contact_plate(0, 0, angle, 50, both);
    PhysicsOptions options = contact_options(&contact_methods[0], 2, NULL);
    g_autoptr(PhysicsRun) down =
        physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'velocity': [%.17g, %.17g]}", plate,
                    -0.1 * cos(angle), -0.1 * sin(angle));
    double a = g * (sin(angle) - 0.3 * cos(angle)), way = 0.2 + 2 * a, v = 0.1 + 2 * a;
    contact_assert_state(down, "Mass 0",
                         (double[]){-way * cos(angle), -way * sin(angle), -v * cos(angle), -v * sin(angle)}, 1e-10);
    g_autoptr(PhysicsRun) up =
        physics_run(&options, CONTACT_WEIGHT "%s, " CONTACT_POINT ", 'velocity': [%.17g, %.17g]}", plate,
                    2 * cos(angle), 2 * sin(angle));
    double brake = g * (sin(angle) + 0.3 * cos(angle));
    contact_assert_state(up, "Mass 0", (double[]){2 / brake * cos(angle), 2 / brake * sin(angle), 0, 0}, 1e-10);
    contact_assert_event(up, "stick", NULL, 2 / brake, 1e-10);
}

/* What blows leave of bodies that came to rest, far below rounding, is no lift-off: from a start with it the floor
 * bears the weight at once, under a mass and under both corners of a box. */
static void test_bears_at_once(void)
{
    static const char *const bodies[] = {
        "{'type': 'mass', 'name': 'B', 'mass': 3, 'height': 0.8, 'position': [0.5, 0.4], 'velocity': [1e-46, 7e-46]}",
        "{'type': 'box', 'name': 'B', 'mass': 3, 'position': [0.5, 0.4], 'velocity': [-7e-46, 1e-46],"
        " 'angular_velocity': -3e-46}"};
    for (gsize i = 0; i < G_N_ELEMENTS(bodies); i++) {
        PhysicsOptions options = contact_options(&contact_methods[0], 0.1, "Support 0.normal force, B.y");
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR "}, %s", bodies[i]);
        for (gsize k = 0; k < physics_samples(run); k++) {
            physics_assert_near("normal force", physics_value(run, k, 0), 3 * g, 1e-9);
            physics_assert_near("y", physics_value(run, k, 1), 0.4, 1e-15);
        }
    }
}

/* A box that slides to a stop: what friction leaves of its speeds is 0 or a number that every program reads, and the
 * kinetic energy, which is the square of that, as well. */
static void test_no_remainders(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options =
            contact_options(&contact_methods[i], 1, "Box 0.vx, Box 0.vy, Box 0.angular velocity, Box 0.kinetic energy");
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                ", 'static_friction': 0.3, 'dynamic_friction': 0.3},"
                                                "{'type': 'box', 'mass': 1e-3, 'width': 1e-3, 'height': 1e-3,"
                                                " 'position': [0, 5e-4], 'velocity': [0.2, 0]}");
        for (gsize s = 0; s < physics_samples(run); s++)
            for (gsize column = 0; column < 4; column++)
                g_assert_cmpint(fpclassify(physics_value(run, s, column)), !=, FP_SUBNORMAL);
        physics_assert_near("vx", physics_last(run, 0), 0, 1e-15);
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-rest/drop", test_drop);
    g_test_add_func("/physics/contact-rest/slides-off-a-turned-plate", test_slides_off_a_turned_plate);
    g_test_add_func("/physics/contact-rest/passes-from-behind", test_passes_from_behind);
    g_test_add_func("/physics/contact-rest/passes-a-plate-turned-over", test_passes_a_plate_turned_over);
    g_test_add_func("/physics/contact-rest/lands-where-it-crossed", test_lands_where_it_crossed);
    g_test_add_func("/physics/contact-rest/friction-stops-it", test_friction_stops_it);
    g_test_add_func("/physics/contact-rest/lands-and-sticks", test_lands_and_sticks);
    g_test_add_func("/physics/contact-rest/threshold", test_threshold);
    g_test_add_func("/physics/contact-rest/static-coefficient", test_static_coefficient);
    g_test_add_func("/physics/contact-rest/bears-at-once", test_bears_at_once);
    g_test_add_func("/physics/contact-rest/no-remainders", test_no_remainders);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
