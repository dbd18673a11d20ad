/* Rods and friction that leave no acceleration (Painleve's paradox): a dumbbell whose lower end slides on a rough
 * floor.
 *
 * The rod leans back by 45 degrees against the sliding. With the upper mass's share b of the whole, pressing with N at
 * the lower end accelerates it upwards by N / m1 (1 - b cos (cos + mu sin)), which is not upwards any more from mu
 * = 1.105 on. Source: Genot, Brogliato, "New results on Painleve paradoxes", Eur. J. Mech. A 18 (1999) 653-677, for a
 * rigid bar. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY, lower_mass = 0.05, upper_mass = 0.95, lean = G_PI / 4;

static PhysicsRun *dumbbell(const ContactMethod *method, double duration, double friction, double v)
{
    PhysicsOptions options = contact_options(method, duration, "Mass 0.normal force, Mass 0.friction force, Mass 0.ax");
    return physics_run(&options,
                       CONTACT_WEIGHT CONTACT_FLOOR
                       ", 'width': 20, 'static_friction': %g, 'dynamic_friction': %g}, " CONTACT_POINT
                       ", 'mass': 0.05, 'velocity': [%.17g, 0]}, " CONTACT_POINT
                       ", 'mass': 0.95, 'position': [%.17g, %.17g], 'velocity': [%.17g, 0]},"
                       "{'type': 'rod', 'ends': ['Mass 0', 'Mass 1']}",
                       friction, friction, v, -copysign(sin(lean), v), cos(lean), v);
}

/* Below the threshold it slides on, and the floor presses with that N. */
static void test_slides(void)
{
    const double friction = 0.5, c = cos(lean), s = sin(lean);
    double press = lower_mass * g / (1 - upper_mass * c * (c + friction * s));
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run = dumbbell(&contact_methods[i], 0.05, friction, 1);
        physics_assert_near("normal force", physics_value(run, 0, 0), press, 1e-9);
        physics_assert_near("friction", physics_value(run, 0, 1), -friction * press, 1e-9);
        contact_assert_count(run, "jam", 0);
        physics_assert_near("the error of the books", run->summary->energy_balance_error, 0, contact_methods[i].smooth);
    }
}

static void upright(double t, const double *y, double *rate, const void *data)
{
    rate[0] = y[1];
    rate[1] = g * sin(y[0]);
}

/* Beyond it, an impulse ends the sliding at once. Nothing but rest of the lower end satisfies the laws behind it: the
 * upper one keeps what is across the rod, and swings about the lower one, which sticks. */
static void check_jam(double v)
{
    const double friction = 2, end = 0.3;
    double side = copysign(1, v), y[2] = {-side * lean, v * cos(lean)};
    double along = lower_mass + upper_mass * sin(lean) * sin(lean), across = upper_mass * sin(lean) * cos(lean);
    g_assert_cmpfloat(along, <, friction * across);
    double lost = 0.5 * v * v * (1 - upper_mass * cos(lean) * cos(lean));
    physics_rk4(2, y, 0, end, 4000, upright, NULL);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autoptr(PhysicsRun) run = dumbbell(&contact_methods[i], end, friction, v);
        double bound = contact_methods[i].smooth;
        contact_assert_event(run, "jam", "Mass 0, Support 0", 0, 0);
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
        contact_assert_state(run, "Mass 1", (double[]){sin(y[0]), cos(y[0]), cos(y[0]) * y[1], -sin(y[0]) * y[1]},
                             bound);
        contact_assert_taken(run, 0, lost, 1e-9);
    }
}

static void test_jams(void)
{
    check_jam(1);
    check_jam(-1);
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-jam/slides", test_slides);
    g_test_add_func("/physics/contact-jam/jams", test_jams);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
