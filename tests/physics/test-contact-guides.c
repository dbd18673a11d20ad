/* Guides without play: bodies between two tops that face each other just as far apart as they are high. They move along
 * them, with friction on the side that presses, and pass from one side to the other without an event. */
#include "contact-checks.h"

#include <math.h>
#include <string.h>

/* A guide for masses 0.2 m high along the line through (x, y) at an angle, of this width, with these coefficients of
 * friction on its lower and its upper top. (transfer full) */
static char *guide(double x, double y, double angle, double width, double below, double above)
{
    g_autofree char *lower_friction = g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g", below, below);
    g_autofree char *upper_friction = g_strdup_printf("'static_friction': %g, 'dynamic_friction': %g", above, above);
    double nx = -0.1 * sin(angle), ny = 0.1 * cos(angle);
    g_autofree char *lower = contact_plate(x - nx, y - ny, angle, width, lower_friction),
                    *upper = contact_plate(x + nx, y + ny, angle + G_PI, width, upper_friction);
    return g_strdup_printf("%s, %s,", lower, upper);
}

/* The slider-crank: a crank of 0.5 m with 1 kg at its pin, turning freely, a rod of 1.5 m, a piston of 1 kg with
 * friction mu. y = angle and rate of the crank. The rod pulls with T at the pin and at the piston; N is T's part across
 * the guide. */
static void crank_rate(double t, const double *y, double *rate, const void *data)
{
    const double mu = *(const double *)data, r = 0.5, l = 1.5, s = sin(y[0]), c = cos(y[0]);
    double k = sqrt(l * l - r * r * s * s);
    double dx = -r * s - r * r * s * c / k; /* x = r c + k, and its second derivative by the angle */
    double ddx = -r * c - (r * r * (c * c - s * s) * k * k + r * r * r * r * s * s * c * c) / (k * k * k);
    double ex = k / l, ey = -r * s / l, along = -s * ex + c * ey; /* from the pin to the piston; along the pin's path */
    double speed = dx * y[1], way = speed > 0 ? 1 : -1;
    for (int side = 0; side < 2; side++) {
        double pull = ex + mu * way * (side == 0 ? 1 : -1) * fabs(ey); /* of T > 0, of T < 0 */
        /* r rate = T along, dx rate + ddx y1^2 = -T pull */
        double tension = -ddx * y[1] * y[1] / (pull + dx * along / r);
        rate[0] = y[1];
        rate[1] = tension * along / r;
        if ((tension > 0) == (side == 0)) return;
    }
}

static void check_piston(const ContactMethod *method, double mu, double angle, double bound)
{
    const double turn = 2, y0 = G_PI / 2, c = cos(angle), s = sin(angle), x = sqrt(2.0);
    g_autofree char *walls = guide(1.5 * c, 1.5 * s, angle, 1.6, mu, mu);
    PhysicsOptions options = contact_options(method, turn, "Crank.x, Crank.y, Piston.x, Piston.y");
    options.interval = 0.25;
    g_autoptr(PhysicsRun) run = physics_run(
        &options,
        "%s {'type': 'support', 'name': 'O', 'solid': false},"
        "{'type': 'mass', 'name': 'Crank', 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g], 'height': 0.1},"
        "{'type': 'mass', 'name': 'Piston', 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g], 'height': 0.2},"
        "{'type': 'rod', 'ends': ['O', 'Crank'], 'length': 0.5}, {'type': 'rod', 'ends': ['Crank', 'Piston'], "
        "'length': "
        "1.5}",
        walls, -0.5 * s, 0.5 * c, -2 * c, -2 * s, x * c, x * s, -2 * c, -2 * s);
    double y[2] = {y0, 4};
    for (gsize i = 0; i < physics_samples(run); i++) {
        if (i > 0) physics_rk4(2, y, physics_time(run, i - 1), physics_time(run, i), 4000, crank_rate, &mu);
        double pin[2] = {0.5 * cos(y[0]), 0.5 * sin(y[0])}, at = pin[0] + sqrt(1.5 * 1.5 - pin[1] * pin[1]);
        physics_assert_near("crank x", physics_value(run, i, 0), c * pin[0] - s * pin[1], bound);
        physics_assert_near("crank y", physics_value(run, i, 1), s * pin[0] + c * pin[1], bound);
        physics_assert_near("piston x", physics_value(run, i, 2), c * at, bound);
        physics_assert_near("piston y", physics_value(run, i, 3), s * at, bound);
    }
    contact_assert_count(run, "take-off", 0);
    contact_assert_count(run, "rest", 0);
    contact_assert_count(run, "impact", 0);
}

static void test_piston(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        double bound = 100 * contact_methods[i].smooth; /* the rod swings at some 10 rad/s for 2 s */
        check_piston(&contact_methods[i], 0, 0, bound);
        check_piston(&contact_methods[i], 0.1, 0.7, bound);
    }
}

/* 2 kg slide at 3 m/s along a guide whose lower top has mu = 0.1, the upper one 0.3; a motor pushes across with 20 N
 * sin(5 t), up first. The lost speed is mu / m times the integral of what presses, 4 N s a half wave. */
static void test_sides_by_turns(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        g_autofree char *walls = guide(0, 0, 0, 20, 0.1, 0.3);
        double half = G_PI / 5, bound = 10 * contact_methods[i].smooth;
        double at[5] = {0, half, 2 * half, 3 * half, 3.5 * half};
        PhysicsOptions options = contact_options(&contact_methods[i], 3.5 * half, "M.vx, M.y");
        options.at = at;
        options.at_count = G_N_ELEMENTS(at);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "%s {'type': 'mass', 'name': 'M', 'mass': 2, 'height': 0.2, 'velocity': [3, 0]},"
                        "{'type': 'motor', 'ends': ['M'], 'angle': '90 deg', 'amplitude': 20, 'frequency': 5, "
                        "'waveform': 'sine'}",
                        walls);
        double wave = 2 * 20.0 / 5 / 2; /* of a half wave, by the mass */
        const double lost[5] = {0, 0.3 * wave, 0.4 * wave, 0.7 * wave, (0.7 + 0.05) * wave};
        for (gsize k = 0; k < G_N_ELEMENTS(at); k++) {
            physics_assert_near("speed", physics_value(run, k, 0), 3 - lost[k], bound);
            physics_assert_near("y", physics_value(run, k, 1), 0, 1e-12);
        }
        contact_assert_count(run, "take-off", 0);
        contact_assert_taken(run, 0.5 * 2 * (9 - pow(3 - lost[4], 2)), 0, 10 * bound);
    }
}

/* Nothing presses: it glides as if the guide were not there. Out at its end it goes straight on, and falls. */
static void test_glides_out(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        double bound = contact_methods[i].polynomial;
        g_autofree char *walls = guide(0, 0, 0, 2, 0.5, 0.5);
        PhysicsOptions options = contact_options(&contact_methods[i], 0.9, NULL);
        g_autoptr(PhysicsRun) free = physics_run(
            &options, "%s {'type': 'mass', 'name': 'M', 'height': 0.2, 'position': [-0.5, 0], 'velocity': [1, 0]}",
            walls);
        contact_assert_state(free, "M", (double[]){0.4, 0, 1, 0}, bound);
        g_autofree char *smooth = guide(0, 0, 0, 2, 0, 0);
        g_autoptr(PhysicsRun) falls = physics_run(
            &options,
            CONTACT_WEIGHT "%s {'type': 'mass', 'name': 'M', 'height': 0.2, 'position': [0.5, 0], 'velocity': [1, 0]}",
            smooth);
        contact_assert_event(falls, "end", "M, Support 0", 0.5, bound);
        contact_assert_state(falls, "M", (double[]){1.4, -0.5 * CONTACT_GRAVITY * 0.16, 1, -CONTACT_GRAVITY * 0.4},
                             10 * bound);
    }
}

/* It slides under the upper top on the way; from t = 1 s on 30 N press it up against that, where mu = 0.5. */
static void test_slides_in(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.25, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, CONTACT_WEIGHT
            "{'type': 'support', 'position': [0, -0.3], 'width': 20, 'height': 0.4, " CONTACT_SMOOTH "},"
            "{'type': 'support', 'position': [5, 0.3], 'width': 8, 'height': 0.4, 'orientation': '180 deg', "
            "'static_friction': 0.5, 'dynamic_friction': 0.5},"
            "{'type': 'mass', 'name': 'M', 'height': 0.2, 'velocity': [4, 0]},"
            "{'type': 'motor', 'ends': ['M'], 'angle': '90 deg', 'waveform': {'expression': '30*step(t-1)'}}");
        double slower = 0.5 * (30 - CONTACT_GRAVITY) * 0.25;
        contact_assert_state(run, "M", (double[]){5 - 0.5 * slower * 0.25, 0, 4 - slower, 0},
                             100 * contact_methods[i].polynomial);
        contact_assert_count(run, "take-off", 0);
    }
}

/* With a tenth of a millimetre of play it takes off and lands; and moves nearly alike. */
static void test_with_play(void)
{
    PhysicsOptions options = contact_options(&contact_methods[0], 2 * G_PI / 5, "M.vx");
    g_autoptr(PhysicsRun) run = physics_run(
        &options,
        "{'type': 'support', 'position': [0, -0.3], 'width': 20, 'height': 0.4, " CONTACT_SMOOTH "},"
        "{'type': 'support', 'position': [0, 0.3001], 'width': 20, 'height': 0.4, 'orientation': '180 "
        "deg', " CONTACT_SMOOTH "}, {'type': 'mass', 'name': 'M', 'mass': 2, 'height': 0.2, 'velocity': [3, 0]},"
        "{'type': 'motor', 'ends': ['M'], 'angle': '90 deg', 'amplitude': 20, 'frequency': 5, 'waveform': 'sine'}");
    contact_assert_event(run, "rest", "M, Support 1", cbrt(6e-4 * 2 / (20 * 5)), 1e-4);
    physics_assert_near("speed", physics_last(run, 0), 3, 1e-12);
}

/* Two masses of 1 kg on a rod along the guide, on a spring of 1000 N/m along it: what presses is rounding of what
 * pulls. They swing as one, x = x0 + 0.5 cos(sqrt(k / 2 m) t), and no side is changed without end. */
static void test_pulled_along(void)
{
    static const char *const methods[] = {"auto", "rk4", "verlet6", "newmark"};
    static const double bounds[] = {1e-8, 1e-4, 1e-6, 2e-2}; /* at h w = 0.02 */
    const double angle = 1.1, c = cos(angle), s = sin(angle);
    g_autofree char *walls = guide(0, 0, angle, 10, 0, 0);
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[i], .duration = 2, .step = 1e-3, .columns = "A.x, A.y, B.x"},
            "%s {'type': 'support', 'name': 'Wall', 'solid': false, 'position': [%.17g, %.17g]},"
            "{'type': 'mass', 'name': 'A', 'height': 0.2, 'position': [%.17g, %.17g]},"
            "{'type': 'mass', 'name': 'B', 'height': 0.2, 'position': [%.17g, %.17g]},"
            "{'type': 'spring', 'ends': ['Wall', 'A'], 'stiffness': 1000, 'rest_length': 2.5}, {'type': 'rod', 'ends': "
            "['A', "
            "'B']}",
            walls, -4 * c, -4 * s, -c, -s, c, s);
        for (gsize k = 0; k < physics_samples(run); k++) {
            double x = -1.5 + 0.5 * cos(sqrt(500) * physics_time(run, k));
            physics_assert_near("x", physics_value(run, k, 0), c * x, bounds[i]);
            physics_assert_near("y", physics_value(run, k, 1), s * x, bounds[i]);
            physics_assert_near("B", physics_value(run, k, 2), c * (x + 2), bounds[i]);
        }
        g_assert_cmpuint(run->summary->events->len, ==, 0);
        g_assert_cmpint(run->summary->evaluations, <, 40 * 2000); /* 36 a step of verlet6 */
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/contact-guides/piston", test_piston);
    g_test_add_func("/physics/contact-guides/sides-by-turns", test_sides_by_turns);
    g_test_add_func("/physics/contact-guides/glides-out", test_glides_out);
    g_test_add_func("/physics/contact-guides/slides-in", test_slides_in);
    g_test_add_func("/physics/contact-guides/pulled-along", test_pulled_along);
    g_test_add_func("/physics/contact-guides/with-play", test_with_play);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
