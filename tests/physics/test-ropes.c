/* Constraint rows that hold in one direction only: a rope falls slack where it would have to push, and comes taut with
 * a jerk that takes what parts its ends, without a bounce. */
#include "contact-checks.h"

#include <math.h>

static const double g = CONTACT_GRAVITY;

static const char *const pivot = "{'type': 'support', 'solid': false}, ";

/* Dropped beside its rope's end: free until the rope is taut, then at rest for good. */
static void test_catches(void)
{
    const double drop = 0.75, taut = sqrt(2 * drop / g);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1.3, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'gravity'}, %s{'type': 'mass', 'mass': 2, 'position': [0, -0.25]},"
                        "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 1}",
                        pivot);
        double bound = contact_methods[i].polynomial;
        contact_assert_state(run, "Mass 0", (double[]){0, -1, 0, 0}, 1e-12);
        contact_assert_event(run, "taut", "Rope 0", taut, bound);
        contact_assert_taken(run, 0, 2 * g * drop, 50 * bound);
    }
}

/* On its way up a circle the rope goes slack where gravity alone bends the path as much: with v0^2 = 3.5 g L at the
 * bottom at cos(angle from the top) = (v0^2 / (g L) - 2) / 3; from there it is a parabola. */
static void test_leaves_the_circle(void)
{
    const double v0 = sqrt(3.5 * g), c = (3.5 - 2) / 3, s = sqrt(1 - c * c), v = sqrt(g * c), later = 0.1;
    double y[2] = {0, v0}, time = 0;
    /* the time up the circle, by an independent integration of the angle from the bottom */
    for (double step = 1e-5; G_PI - y[0] > acos(c); time += step) {
        double middle = y[1] - 0.5 * step * g * sin(y[0]), angle = y[0] + step * middle;
        y[1] = middle - 0.5 * step * g * sin(angle);
        y[0] = angle;
    }
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        double smooth = 10 * contact_methods[i].smooth + 2e-5;
        PhysicsOptions options = contact_options(&contact_methods[i], time + later, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'gravity'}, %s{'type': 'mass', 'position': [0, -1], 'velocity': [%.17g, 0]},"
                        "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': 1}",
                        pivot, v0);
        contact_assert_event(run, "slack", "Rope 0", time, smooth);
        contact_assert_state(
            run, "Mass 0",
            (double[]){s - v * c * later, c + v * s * later - 0.5 * g * later * later, -v * c, v * s - g * later},
            10 * smooth);
        contact_assert_taken(run, 0, 0, 1e-12);
    }
}

/* Two masses that part: when the rope is taut their speeds along it become one, and nobody else is there to push. */
static void test_pulls_together(void)
{
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1, NULL);
        g_autoptr(PhysicsRun) run = physics_run(
            &options, "{'type': 'mass', 'mass': 3}, {'type': 'mass', 'position': [1, 0], 'velocity': [2, 0]},"
                      "{'type': 'rope', 'ends': ['Mass 0', 'Mass 1'], 'length': 1.5}");
        contact_assert_event(run, "taut", "Rope 0", 0.25, 1e-11);
        contact_assert_state(run, "Mass 0", (double[]){0.5 * 0.75, 0, 0.5, 0}, 1e-11);
        contact_assert_state(run, "Mass 1", (double[]){0.5 * 0.75 + 1.5, 0, 0.5, 0}, 1e-11);
        contact_assert_taken(run, 0, 0.5 * 4 - 0.5 * 4 * 0.25, 1e-11);
    }
}

/* A mass on the floor that a rope holds back, and whose rope is let go by the other end landing beside it. */
static void test_with_a_plate(void)
{
    const double land = sqrt(2 * 0.5 / g);
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 1, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options, CONTACT_WEIGHT CONTACT_FLOOR
                        "}, " CONTACT_POINT "}, " CONTACT_POINT
                        ", 'position': [0, 0.5]}, {'type': 'rope', 'ends': ['Mass 0', 'Mass 1'], 'length': 0.5}");
        contact_assert_event(run, "rest", "Mass 1, Support 0", land, contact_methods[i].polynomial);
        contact_assert_state(run, "Mass 1", (double[]){0, 0, 0, 0}, 1e-12);
        contact_assert_state(run, "Mass 0", (double[]){0, 0, 0, 0}, 1e-12);
    }
}

/* Ropes over wheels: a load m1 that hangs in n strands and a weight m2 at the rope's end, pulled down. n a1 = -a2, so
 * T = (n + 1) g m1 m2 / (m1 + n^2 m2); n = 1 is Atwood's machine. */
static void check_tackle(const char *load_ends, int strands, double tolerance)
{
    const double m1 = 5, m2 = 2, n = strands;
    const double tension = (n + 1) * g * m1 * m2 / (m1 + n * n * m2), a1 = n * tension / m1 - g, a2 = tension / m2 - g;
    physics_assert_near("the rope's condition", n * a1 + a2, 0, 1e-13);
    static const char *const methods[] = {"auto", "rk4", "dop853", "verlet"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        const PhysicsOptions options = {
            .method = methods[i], .columns = "Load.y, Load.ay, Weight.y, Weight.ay, Rope 0.tension, Rope 0.slack"};
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "{'type': 'gravity'}, {'type': 'support', 'solid': false},"
                        "{'type': 'mass', 'name': 'Load', 'mass': %.17g, 'position': [0, -8]},"
                        "{'type': 'mass', 'name': 'Weight', 'mass': %.17g, 'position': [1, -10]},"
                        "{'type': 'rope', 'ends': [%s, {'block': 'Support 0', 'at': [1, 0]}, 'Weight']}",
                        m1, m2, load_ends);
        for (gsize k = 0; k < physics_samples(run); k++) {
            const double t = physics_time(run, k), s = t * t / 2;
            const double truth[] = {-8 + a1 * s, a1, -10 + a2 * s, a2, tension, 0};
            for (gsize c = 0; c < G_N_ELEMENTS(truth); c++)
                physics_assert_near(methods[i], physics_value(run, k, c), truth[c], tolerance * fmax(1, tension));
        }
        contact_assert_taken(run, 0, 0, 1e-10);
    }
}

static void test_tackles(void)
{
    check_tackle("'Load', 'Support 0'", 1, 1e-10);
    check_tackle("'Support 0', 'Load', 'Support 0'", 2, 1e-10);
    check_tackle("'Support 0', 'Load', 'Support 0', 'Load', 'Support 0'", 4, 1e-10);
}

/* A mass of 2 kg thrown off obliquely: when its rope of length l comes taut the rope takes the part of its velocity
 * along itself, m (v . n)^2 / 2, and nothing else. Without weight it then goes round with what is left. */
static void test_thrown(void)
{
    const double l = 2, vx = 3, vy = 1, m = 2;
    /* |(0.5 + vx t, vy t)| = l */
    const double a = vx * vx + vy * vy, b = 0.5 * vx, c = 0.25 - l * l, taut = (-b + sqrt(b * b - a * c)) / a;
    const double nx = (0.5 + vx * taut) / l, ny = vy * taut / l, along = vx * nx + vy * ny, across = nx * vy - ny * vx;
    for (gsize i = 0; i < CONTACT_METHODS; i++) {
        PhysicsOptions options = contact_options(&contact_methods[i], 2, NULL);
        g_autoptr(PhysicsRun) run =
            physics_run(&options,
                        "%s{'type': 'mass', 'mass': %g, 'position': [0.5, 0], 'velocity': [%g, %g]},"
                        "{'type': 'rope', 'ends': ['Support 0', 'Mass 0'], 'length': %g}",
                        pivot, m, vx, vy, l);
        const double turned = atan2(ny, nx) + across / l * (2 - taut), bound = 10 * contact_methods[i].smooth + 1e-9;
        contact_assert_event(run, "taut", "Rope 0", taut, bound);
        contact_assert_state(run, "Mass 0",
                             (double[]){l * cos(turned), l * sin(turned), -across * sin(turned), across * cos(turned)},
                             10 * bound);
        contact_assert_taken(run, 0, m * along * along / 2, 50 * bound);
    }
}

/* A rope is the limit of ever stiffer springs that are damped critically, so that they do not throw back. Of masses
 * that part they keep w t e^(-w t) of the parting speed, with w the root of stiffness by reduced mass: after 0.1 s a
 * tenth, and less than a thousandth. */
static void test_limit_of_stiff_springs(void)
{
    const char *const masses = "{'type': 'mass', 'mass': 3}, {'type': 'mass', 'position': [1, 0], 'velocity': [2, 0]}";
    const PhysicsOptions options = {.duration = 0.1, .method = "dop853"};
    double rope[4], before = INFINITY;
    g_autoptr(PhysicsRun) with = physics_run(&options, "%s, {'type': 'rope', 'ends': ['Mass 0', 'Mass 1']}", masses);
    physics_state(with, "Mass 1", rope);
    for (double stiffness = 1e3; stiffness < 2e4; stiffness *= 10) {
        double state[4];
        const double damping = 2 * sqrt(stiffness * 0.75); /* of the reduced mass 3 * 1 / (3 + 1) */
        g_autoptr(PhysicsRun) run = physics_run(&options,
                                                "%s, {'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': %g},"
                                                "{'type': 'damper', 'ends': ['Mass 0', 'Mass 1'], 'damping': %g}",
                                                masses, stiffness, damping);
        physics_state(run, "Mass 1", state);
        const double off = hypot(state[0] - rope[0], state[2] - rope[2]);
        g_assert_cmpfloat(off, <, 0.01 * before);
        before = off;
    }
    g_assert_cmpfloat(before, <, 1e-3);
}

/* One that is too short is refused, by name and with both lengths; one that is too short by less than the millionth
 * that places are given to is put right. */
static void test_too_short(void)
{
    const char *const over = "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [-1, -1]},"
                             "{'type': 'mass', 'position': [1, -1]}, {'type': 'rope', 'ends': ['Mass 0',"
                             "{'block': 'Support 0', 'at': [-1, 0]}, {'block': 'Support 0', 'at': [1, 0]}, 'Mass 1'],"
                             "'length': %.12g}";
    const PhysicsOptions options = {.method = "dop853", .columns = "Rope 0.slack"};
    g_autoptr(PhysicsRun) refused = physics_try(&options, over, 4 * (1 - 2e-6));
    physics_assert_refused(refused, TINKER_MODEL_ERROR_SCENE, "Rope 0: its length is 3.999992 m",
                           "the path through its ends is 4 m long", NULL);
    g_autoptr(PhysicsRun) run = physics_run(&options, over, 4 * (1 - 0.5e-6));
    physics_assert_near("the slack of the rope that was put right", physics_last(run, 0), 0, 1e-12);
}

/* A rope to what is welded to where the rope goes neither shortens nor pulls more than it is given: the weld holds, at
 * a start, through a blow, and where speeds that the scene gives are taken away but for their rounding. */
static void test_held(void)
{
    static const char *const methods[] = {"dop853", "rk4", "verlet"};
    for (gsize i = 0; i < G_N_ELEMENTS(methods); i++) {
        const PhysicsOptions options = {.method = methods[i], .step = 0.01, .duration = 1};
        g_autoptr(PhysicsRun) struck = physics_run(
            &options, "{'type': 'gravity', 'angle': 2.070544322161477},"
                      "{'type': 'support', 'solid': false, 'position': [0.14586114666005434, 0.0708852979743051],"
                      "'orientation': -0.18165282134103666},"
                      "{'type': 'mass', 'mass': 2.547, 'position': [0.5938256615246744, 0.2203808153771591]},"
                      "{'type': 'weld', 'ends': [{'block': 'Support 0', 'at': [0.41358672679167297, "
                      "0.2279630139368919]}, 'Mass 0']}, {'type': 'rope', 'ends': ['Mass 0', 'Support 0']},"
                      "{'type': 'impulse', 'ends': ['Mass 0'], 'impulse': 0.1, 'angle': 2.6, 'time': 0.3}");
        contact_assert_state(struck, "Mass 0", (double[]){0.5938256615246744, 0.2203808153771591, 0, 0}, 1e-12);
        g_autoptr(PhysicsRun) hurled = physics_run(
            &options,
            "{'type': 'support', 'solid': false, 'position': [-35.06129844630064, -71.43961897374747]},"
            "{'type': 'box', 'mass': 0.0018057819342980474, 'orientation': 1.6257587563780103, 'solid': false,"
            "'width': 76.50527917048868, 'height': 195.60386662995788, 'position': [109.16244782222346, "
            "-108.2726639328163], 'velocity': [-2822.6620025755296, 6408.561016258771]},"
            "{'type': 'weld', 'ends': [{'block': 'Box 0', 'at': [49.44391973373346, 99.84957049970797]},"
            "{'block': 'Support 0', 'at': [41.80876409332889, 7.0509994496508135]}]},"
            "{'type': 'rope', 'ends': [{'block': 'Box 0', 'at': [46.364776100200224, 106.11649704511387]},"
            "{'block': 'Support 0', 'at': [-45.8577268208563, -104.9380349476844]}]}");
        contact_assert_state(hurled, "Box 0", (double[]){109.16244782222346, -108.2726639328163, 0, 0}, 1e-9);
    }
}

/* Three masses fall; a spring pulls the third and the second together, and that the first by a rope: as long as it is
 * stretched, a quarter of a swing of all three. Whatever the numbers the rope lets go then, and the first goes on. */
static void test_lets_go(void)
{
    for (int i = 0; i < 60; i++) {
        const double first = 0.2 + 0.37 * (i % 7), second = 3.1 - 0.27 * (i % 11), third = 1.3, k = 7 + 1.9 * i;
        const double both = first + second, w = sqrt(k * (1 / both + 1 / third)), t = G_PI / (2 * w), end = 1.5 * t;
        const double c = cos(0.11 * i), s = sin(0.11 * i), way = 1e-4 * third / (both + third), speed = way * w;
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = "dop853", .tolerance = 1e-13, .duration = end, .columns = "Rope 0.tension"},
            "{'type': 'gravity'}, {'type': 'mass', 'mass': %.17g}, {'type': 'mass', 'mass': %.17g, 'position':"
            " [%.17g, %.17g]}, {'type': 'mass', 'mass': %.17g, 'position': [%.17g, %.17g]},"
            "{'type': 'rope', 'ends': ['Mass 0', 'Mass 1'], 'length': 1},"
            "{'type': 'spring', 'ends': ['Mass 1', 'Mass 2'], 'stiffness': %.17g, 'rest_length': 1}",
            first, second, c, s, third, (2 + 1e-4) * c, (2 + 1e-4) * s, k);
        const double along = way + speed * (end - t);
        contact_assert_event(run, "slack", "Rope 0", t, 1e-9);
        contact_assert_count(run, "slack", 1);
        contact_assert_state(
            run, "Mass 0", (double[]){along * c, along * s - g * end * end / 2, speed * c, speed * s - g * end}, 1e-8);
    }
}

/* A rope beside a rod of its length holds no more than both, also where some support moves that neither is tied to:
 * together they pull a pendulum by m (g cos(angle) + v^2 / length). */
static void test_beside_a_rod(void)
{
    for (int i = 0; i < 80; i++) {
        const double angle = 0.03 * i - 1.2, length = 500 + 7.7 * i, v = 3 + 0.7 * i, at[] = {0, 0.5};
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = "dop853",
                              .tolerance = 1e-11,
                              .duration = 0.5,
                              .columns = "Rod 0.tension, Rope 0.tension, Mass 0.y",
                              .at = at,
                              .at_count = 2},
            "{'type': 'gravity'}, %s{'type': 'support', 'name': 'Far', 'position': [5000, 0]},"
            "{'type': 'support-motion', 'ends': ['Far'], 'amplitude': 2, 'frequency': 0.1},"
            "{'type': 'mass', 'mass': 3, 'position': [%.17g, %.17g], 'velocity': [%.17g, %.17g]},"
            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}, {'type': 'rope', 'ends': ['Mass 0', 'Support 0']}",
            pivot, length * sin(angle), -length * cos(angle), v * cos(angle), v * sin(angle));
        for (gsize row = 0; row < 2; row++) {
            const double y = physics_value(run, row, 2), fell = -length * cos(angle) - y;
            const double pull = 3 * (g * -y / length + (v * v + 2 * g * fell) / length);
            physics_assert_near("pull", physics_value(run, row, 0) + physics_value(run, row, 1), pull, 1e-9);
        }
    }
}

static void add_tests(void)
{
    g_test_add_func("/physics/ropes/tackles", test_tackles);
    g_test_add_func("/physics/ropes/thrown", test_thrown);
    g_test_add_func("/physics/ropes/limit-of-stiff-springs", test_limit_of_stiff_springs);
    g_test_add_func("/physics/ropes/too-short", test_too_short);
    g_test_add_func("/physics/ropes/held", test_held);
    g_test_add_func("/physics/ropes/catches", test_catches);
    g_test_add_func("/physics/ropes/leaves-the-circle", test_leaves_the_circle);
    g_test_add_func("/physics/ropes/pulls-together", test_pulls_together);
    g_test_add_func("/physics/ropes/with-a-plate", test_with_a_plate);
    g_test_add_func("/physics/ropes/lets-go", test_lets_go);
    g_test_add_func("/physics/ropes/beside-a-rod", test_beside_a_rod);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
