/* What resists rolling: discs on tops and on each other, against closed forms. A disc rolls with N up to rho from the
 * place below its centre: it slows down with rho g R / (R^2 + I / m), and stays where tan a is at most rho / R. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

/* A level top brings a disc of radius 0.5 m to rest; it has turned by what it rolled, and stays. */
static void test_stops(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        const double r = 0.5, rho = 0.05, v = 2, a = rho * g * r / (1.5 * r * r), bound = contact_methods[i].polynomial;
        PhysicsOptions options =
            contact_options(&contact_methods[i], 8,
                            "Disc 0.x, Disc 0.angle, Disc 0.vx, Disc 0.angular velocity, Disc 0.normal force,"
                            "Disc 0.friction force");
        const double at[] = {0, 1, 5, 8};
        options.at = at;
        options.at_count = 4;
        g_autoptr(PhysicsRun) run = physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                                                ", 'width': 60}, {'type': 'disc', 'radius': 0.5, 'mass': 3,"
                                                " 'rolling_resistance': 0.05, 'position': [0, 0.5],"
                                                " 'velocity': [2, 0], 'angular_velocity': -4}");
        contact_assert_event(run, "stick", "Disc 0, Support 0", v / a, fmax(bound, 1e-9));
        g_assert_cmpuint(run->summary->events->len, ==, 1);
        physics_assert_near("speed", physics_value(run, 1, 2), v - a, bound);
        physics_assert_near("friction", physics_value(run, 1, 5), -3 * a, 1e-9);
        physics_assert_near("normal force", physics_value(run, 1, 4), 3 * g, 1e-9);
        physics_assert_near("way", physics_last(run, 0), v * v / (2 * a), bound);
        physics_assert_near("turned", physics_last(run, 1), -v * v / (2 * a) / r, 2 * bound);
        for (gsize column = 0; column < 4; column++)
            g_assert_cmpfloat(physics_value(run, 2, column), ==, physics_last(run, column));
        g_assert_cmpfloat(physics_last(run, 3), ==, 0);
        contact_assert_taken(run, 1.5 * 0.5 * 3 * v * v, 0, fmax(bound, 1e-8));
    }
}

/* On a slope it stays to the last digit below atan(rho / R), and rolls down above it. */
static void test_slope(void)
{
    const double r = 0.25, rho = 0.03, t = 2;
    for (int k = 0; k < 2; k++) {
        const double angle = atan(rho / r) + (k == 0 ? -1e-6 : 1e-3);
        const double start[] = {-r * sin(angle), r * cos(angle)};
        g_autofree char *slope = contact_plate(0, 0, angle, 40, "");
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = t, .columns = "Disc 0.x, Disc 0.y, Disc 0.angle"},
                        CONTACT_WEIGHT "%s, {'type': 'disc', 'radius': 0.25, 'rolling_resistance': 0.03,"
                                       " 'position': [%.17g, %.17g]}",
                        slope, start[0], start[1]);
        const double a = k == 0 ? 0 : g * (sin(angle) - rho / r * cos(angle)) / 1.5, way = a * t * t / 2;
        physics_assert_near("x", physics_last(run, 0), start[0] - way * cos(angle), k == 0 ? 0 : 1e-11);
        physics_assert_near("y", physics_last(run, 1), start[1] - way * sin(angle), k == 0 ? 0 : 1e-11);
        physics_assert_near("angle", physics_last(run, 2), way / r, k == 0 ? 0 : 1e-10);
    }
}

/* A disc at rest with a force F = t on its middle, or a torque M = t, begins to roll at F R = rho N, or M = rho N, and
 * speeds up with what is beyond that. */
static void test_begins(void)
{
    static const struct {
        const char *pushes;
        double arm;
    } cases[] = {{"motor", 0.4}, {"torque", 1}};
    const double r = 0.4, rho = 0.1, end = 3;
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = end, .columns = "Disc 0.angular velocity"},
            CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 60}, {'type': 'disc', 'radius': 0.4, 'rolling_resistance': 0.1,"
                                         " 'position': [0, 0.4]},"
                                         "{'type': '%s', 'ends': ['Disc 0'], 'waveform': {'expression': 't'}}",
            cases[i].pushes);
        const double begins = rho * g / cases[i].arm, beyond = cases[i].arm * (end - begins) * (end - begins) / 2;
        contact_assert_event(run, "slip", "Disc 0, Support 0", begins, 1e-9);
        g_assert_cmpuint(run->summary->events->len, ==, 1);
        physics_assert_near("rate", physics_last(run, 0), (i == 0 ? -1 : 1) * beyond / (1.5 * r * r), 1e-9);
    }
}

/* A disc that spins between two rough walls rocks from one to the other, with blows that follow ever faster, infinitely
 * many of them in finite time: it lies still between them then, with a resistance to rolling and without. */
static void test_rocks_down(void)
{
    const double r = 0.328839826604669, right = 0.515340079580399, left = -0.331401046216596;
    const double x = -r * (cos(left) - cos(right)) / sin(right - left),
                 y = r * (sin(right) - sin(left)) / sin(right - left);
    for (int i = 0; i < 2; i++) {
        g_autofree char *right_wall =
            contact_plate(0, 0, right, 40, "'static_friction': 0.8775, 'dynamic_friction': 0.8775");
        g_autofree char *left_wall =
            contact_plate(0, 0, left, 40, "'static_friction': 0.5787, 'dynamic_friction': 0.5787");
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 1.5, .columns = "Disc 0.x, Disc 0.y, Disc 0.speed"},
                        CONTACT_WEIGHT "%s, %s, {'type': 'disc', 'radius': %.17g, 'position': [%.17g, %.17g],"
                                       " 'angular_velocity': 0.5159302025397174, 'static_friction': 0.6454880066547126,"
                                       " 'dynamic_friction': 0.4856351776494283%s}",
                        right_wall, left_wall, r, x, y, i == 0 ? "" : ", 'rolling_resistance': 0.02876755531910319");
        physics_assert_near("x", physics_last(run, 0), x, 1e-12);
        physics_assert_near("y", physics_last(run, 1), y, 1e-12);
        physics_assert_near("speed", physics_last(run, 2), 0, 1e-30);
    }
}

/* Up a slope it stops; steeper than the limit it turns back there, with another acceleration. */
static void test_turns_back(void)
{
    const double r = 0.25, rho = 0.03, angle = 0.3, v = 3, t = 3;
    const double up = g * (sin(angle) + rho / r * cos(angle)) / 1.5,
                 down = g * (sin(angle) - rho / r * cos(angle)) / 1.5, turns = v / up;
    g_autofree char *slope = contact_plate(0, 0, angle, 60, "");
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = t, .columns = "Disc 0.vx, Disc 0.angular velocity, Disc 0.x"},
                    CONTACT_WEIGHT "%s, {'type': 'disc', 'radius': 0.25, 'rolling_resistance': 0.03,"
                                   " 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g],"
                                   " 'angular_velocity': %.17g}",
                    slope, -r * sin(angle), r * cos(angle), v * cos(angle), v * sin(angle), -v / r);
    contact_assert_event(run, "reversal", "Disc 0, Support 0", turns, 1e-9);
    const double way = v * v / (2 * up) - down * (t - turns) * (t - turns) / 2;
    physics_assert_near("vx", physics_last(run, 0), -down * (t - turns) * cos(angle), 1e-9);
    physics_assert_near("rate", physics_last(run, 1), down * (t - turns) / r, 1e-9);
    physics_assert_near("x", physics_last(run, 2), -r * sin(angle) + way * cos(angle), 1e-9);
}

/* Set down sliding it slides with mu g, and turns with (mu m g R - rho m g) / I until it rolls; then it stops. */
static void test_slides_then_rolls_then_stops(void)
{
    const double mu = 0.2, r = 0.3, rho = 0.02, v = 5;
    const double alpha = g * (mu * r - rho) / (r * r / 2), rolls = v / (mu * g + alpha * r), after = v - mu * g * rolls;
    const double stops = rolls + after * 1.5 * r / (rho * g);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = stops + 1, .columns = "Disc 0.vx, Disc 0.angle, Disc 0.x"},
                    CONTACT_WEIGHT CONTACT_FLOOR
                    ", 'width': 90, 'static_friction': 0.2, 'dynamic_friction': 0.2}, {'type': 'disc', 'radius': 0.3,"
                    " 'rolling_resistance': 0.02, 'position': [0, 0.3], 'velocity': [5, 0]}");
    contact_assert_event(run, "stick", "Disc 0, Support 0", rolls, 1e-9);
    contact_assert_event(run, "stick", "Disc 0, Support 0", stops, 1e-9);
    const double rolled = after * (stops - rolls) / 2;
    physics_assert_near("x", physics_last(run, 2), (v + after) / 2 * rolls + rolled, 1e-9);
    physics_assert_near("angle", physics_last(run, 1), -alpha * rolls * rolls / 2 - rolled / r, 1e-8);
    physics_assert_near("at rest", physics_last(run, 0), 0, 1e-30);
    contact_assert_taken(run, v * v / 2, 0, 1e-8);
}

/* What lands turning is braked by a blow of the moment, too: J = m v normal, so rho J about the centre, and the floor's
 * friction is 0. Without friction the moment alone goes on to brake it. */
static void test_lands_spinning(void)
{
    const double r = 0.3, rho = 0.02, fall = 1, lands = sqrt(2 * fall / g), rate = 40, inertia = r * r / 2;
    const double left = rate - rho * g * lands / inertia, brakes = rho * g / inertia;
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 20, .columns = "Disc 0.angular velocity, Disc 0.angle, Disc 0.x"},
                    CONTACT_WEIGHT CONTACT_FLOOR ", 'restitution': 0, " CONTACT_SMOOTH "}, {'type': 'disc',"
                                                 " 'radius': 0.3, 'rolling_resistance': 0.02, 'position': [0, 1.3],"
                                                 " 'angular_velocity': 40}");
    contact_assert_event(run, "rest", "Disc 0, Support 0", lands, 1e-9);
    contact_assert_event(run, "stick", "Disc 0, Support 0", lands + left / brakes, 1e-8);
    physics_assert_near("angle", physics_last(run, 1), rate * lands + left * left / (2 * brakes), 1e-7);
    physics_assert_near("at rest", physics_last(run, 0), 0, 1e-30);
    physics_assert_near("x", physics_last(run, 2), 0, 1e-14);
}

/* A disc that spins upon another one, without friction: the moment rho N acts on both, against their relative turning,
 * until they turn alike; angular momentum is kept. */
static void test_on_each_other(void)
{
    const double r = 0.5, rho = 0.04, rate = 6, upper = r * r / 2, lower = 2 * r * r / 2;
    const double moment = rho * g, alike = rate / (moment / upper + moment / lower);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 8, .columns = "Disc 0.angular velocity, Disc 1.angular velocity, Disc 1.x"},
        CONTACT_WEIGHT CONTACT_FLOOR ", " CONTACT_SMOOTH "},"
                                     "{'type': 'disc', 'radius': 0.5, 'mass': 2, " CONTACT_SMOOTH
                                     ", 'position': [0, 0.5]},"
                                     "{'type': 'disc', 'radius': 0.5, " CONTACT_SMOOTH
                                     ", 'rolling_resistance': 0.04, 'position': [0, 1.5], 'angular_velocity': 6}");
    contact_assert_event(run, "stick", "Disc 0, Disc 1", alike, 1e-9);
    physics_assert_near("upper", physics_last(run, 1), rate * upper / (upper + lower), 1e-10);
    g_assert_cmpfloat(physics_last(run, 0), ==, physics_last(run, 1));
}

/* Beside masses on tops that turn, which are stepped by themselves, two discs do what they do alone: what resists them
 * turns them the less by rho g R / (R^2 + I / m) / R, and rubs with m times what they slow down by. */
static void test_beside_others(void)
{
    const double r[] = {0.5, 0.25}, rho[] = {0.05, 0.02}, v = 2, t = 0.5;
    const double at[] = {0, t};
    PhysicsOptions options = {.duration = t,
                              .columns = "Disc 0.angular acceleration, Disc 0.friction force, Disc 0.angular velocity,"
                                         "Disc 1.angular acceleration, Disc 1.friction force, Disc 1.angular velocity,"
                                         "Mass 0.normal force",
                              .at = at,
                              .at_count = 2};
    g_autoptr(PhysicsRun) run = physics_run(
        &options, CONTACT_WEIGHT "{'type': 'support', 'name': 'Plank', 'position': [50, -0.2]},"
                                 "{'type': 'support-turn', 'ends': ['Plank']},"
                                 "{'type': 'mass', 'name': 'Mass 0', 'mass': 2, 'on': 'Plank'}," CONTACT_FLOOR
                                 ", 'width': 60}, {'type': 'disc', 'name': 'Disc 0', 'radius': 0.5, 'mass': 3,"
                                 " 'rolling_resistance': 0.05, 'position': [0, 0.5], 'velocity': [2, 0],"
                                 " 'angular_velocity': -4}, {'type': 'disc', 'name': 'Disc 1', 'radius': 0.25,"
                                 " 'rolling_resistance': 0.02, 'position': [-9, 0.25], 'velocity': [-2, 0],"
                                 " 'angular_velocity': 8}");
    for (gsize row = 0; row < 2; row++) {
        for (gsize i = 0; i < 2; i++) {
            const double a = rho[i] * g / (1.5 * r[i]), sign = i == 0 ? 1 : -1, mass = i == 0 ? 3 : 1;
            const double rate = -sign * (v - a * at[row]) / r[i];
            physics_assert_near("turns the less", physics_value(run, row, 3 * i), sign * a / r[i], 1e-9);
            physics_assert_near("friction", physics_value(run, row, 3 * i + 1), -sign * mass * a, 1e-9);
            physics_assert_near("rate", physics_value(run, row, 3 * i + 2), rate, 1e-9);
        }
        physics_assert_near("lies there", physics_value(run, row, 6), 2 * g, 1e-9);
    }
}

/* As impulses it is refused by name, with what to do. */
static void test_refused_as_impulses(void)
{
    g_autoptr(PhysicsRun) run = physics_try(&(PhysicsOptions){.duration = 1, .impulses = TRUE},
                                            CONTACT_WEIGHT CONTACT_FLOOR "}, {'type': 'disc', 'radius': 0.5,"
                                                                         " 'rolling_resistance': 0.05, 'position':"
                                                                         " [0, 0.5]}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_METHOD, "Disc 0", "rolling resistance", "leave", NULL);
}

/* Many discs in a trough, so that the laws have many contacts at once: all come to rest, and no energy is gained. */
static void test_heap(void)
{
    g_autoptr(GString) blocks = g_string_new(CONTACT_WEIGHT CONTACT_FLOOR ", 'width': 20}");
    for (int i = 0; i < 6; i++)
        g_string_append_printf(blocks,
                               ", {'type': 'disc', 'radius': 0.2, 'rolling_resistance': 0.01, 'position': [%g, 0.2],"
                               " 'velocity': [%g, 0], 'angular_velocity': %g}",
                               0.41 * i, 0.5 - 0.2 * i, -5 * (0.5 - 0.2 * i));
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 6, .columns = "Disc 0.angular velocity, Disc 5.angular velocity, Disc 3.vx"},
        "%s", blocks->str);
    for (gsize column = 0; column < 3; column++)
        physics_assert_near("at rest", physics_last(run, column), 0, 1e-30);
}

static void add_tests(void)
{
    g_test_add_func("/rolling/stops", test_stops);
    g_test_add_func("/rolling/slope", test_slope);
    g_test_add_func("/rolling/begins", test_begins);
    g_test_add_func("/rolling/rocks-down", test_rocks_down);
    g_test_add_func("/rolling/turns-back", test_turns_back);
    g_test_add_func("/rolling/slides-rolls-stops", test_slides_then_rolls_then_stops);
    g_test_add_func("/rolling/lands-spinning", test_lands_spinning);
    g_test_add_func("/rolling/on-each-other", test_on_each_other);
    g_test_add_func("/rolling/heap", test_heap);
    g_test_add_func("/rolling/beside-others", test_beside_others);
    g_test_add_func("/rolling/refused-as-impulses", test_refused_as_impulses);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
