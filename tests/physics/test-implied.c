/* Quantities that no plugin declares, against closed forms: lengths of paths and energies, which add up along the run,
 * angles and distances, which the state tells. Samples are few, so that nothing can come from them. */
#include <math.h>

#include "physics-fixture.h"

static const char *const methods[] = {"exact", "dop853", "dopri5"};

/* x = cos 5t: a path of 4 amplitudes a period, with a kink of the speed at every turn. */
static double path_of_oscillation(double t)
{
    double half_turns = floor(5 * t / G_PI);
    double rest = 5 * t - half_turns * G_PI;
    return 2 * half_turns + 1 - cos(rest);
}

static void test_path_of_oscillation(void)
{
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        const double times[] = {0, 0.1, 3, 9.7};
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.method = methods[m],
                                          .duration = 10,
                                          .columns = "Mass 0.path length",
                                          .at = times,
                                          .at_count = 4,
                                          .step = 0.005},
                        "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [3, 0]},"
                        "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2}");
        for (gsize i = 0; i < 4; i++)
            physics_assert_near(methods[m], physics_value(run, i, 0), path_of_oscillation(times[i]), 2e-9);
    }
}

/* The record does not change with what else is sampled but for rounding. */
static void test_path_whatever_is_sampled(void)
{
    static const char blocks[] =
        "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'mass', 'position': "
        "[1, 0]}, {'type': 'rod', 'ends': ['Support 0', 'Mass 0']}";
    g_autoptr(PhysicsRun) often =
        physics_run(&(PhysicsOptions){.duration = 7, .interval = 0.01, .columns = "Mass 0.path length"}, "%s", blocks);
    g_autoptr(PhysicsRun) once =
        physics_run(&(PhysicsOptions){.duration = 7, .interval = 7, .columns = "Mass 0.path length"}, "%s", blocks);
    physics_assert_near("path", physics_last(often, 0), physics_last(once, 0), 1e-11 * physics_last(once, 0));
}

/* Of a throw: with u = vy - g t, integral of sqrt(vx^2 + u^2) dt = (F(vy) - F(vy - g t)) / g,
 * F(u) = (u sqrt(vx^2 + u^2) + vx^2 asinh(u / vx)) / 2. */
static double throw_primitive(double u)
{
    return 0.5 * (u * sqrt(9 + u * u) + 9 * asinh(u / 3));
}

static void test_path_of_throw(void)
{
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m], .duration = 2, .interval = 2, .columns = "Mass 0.path length"},
            "{'type': 'gravity', 'acceleration': 10}, {'type': 'mass', 'velocity': [3, 8]}");
        physics_assert_near("path", physics_last(run, 0), (throw_primitive(8) - throw_primitive(-12)) / 10, 1e-10);
    }
}

/* A disc on a pin turns where it is, while what its cord carries falls: its speed is rounding, which has no path. */
static void test_path_of_what_stands(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.4, .columns = "Disc 0.path length, Mass 0.path length"},
                    "{'type': 'gravity', 'acceleration': 9}, {'type': 'support', 'position': [0, 0], 'solid': false},"
                    "{'type': 'disc', 'mass': 1, 'radius': 0.4, 'position': [0, 0], 'solid': false},"
                    "{'type': 'pin', 'ends': ['Support 0', 'Disc 0']}, {'type': 'mass', 'position': [0.4, -1]},"
                    "{'type': 'cord', 'ends': ['Disc 0', 'Mass 0'], 'side': 'left'}");
    physics_assert_near("the pulley's", physics_last(run, 0), 0, 1e-14);
    physics_assert_near("the mass's", physics_last(run, 1), 0.5 * 9 / 1.5 * 0.16, 1e-9); /* a = g / (1 + 1/2) */
}

/* Without gravity a rod turns steadily: 2 rad/s at 1.5 m. */
static double turned(double t, const void *data)
{
    return remainder(2 * t, 2 * G_PI);
}

static void test_turning_rod(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 10,
                                      .interval = 0.37,
                                      .columns = "Rod 0.angle, Rod 0.angle rate, Rod 0.length, Mass 0.path length"},
                    "{'type': 'support', 'solid': false, 'position': [20, 30]},"
                    "{'type': 'mass', 'position': [21.5, 30], 'velocity': [0, 3]}, {'type': 'rod', 'ends': ['Support "
                    "0', 'Mass 0']}");
    physics_assert_follows(run, 0, turned, NULL, 1e-8);
    for (gsize i = 0; i < physics_samples(run); i++) {
        physics_assert_near("rate", physics_value(run, i, 1), 2, 1e-9);
        physics_assert_near("length", physics_value(run, i, 2), 1.5, 1e-12);
        physics_assert_near("path", physics_value(run, i, 3), 3 * physics_time(run, i), 1e-8);
    }
}

/* Where the angle starts again it is no error of 2 pi. */
static void test_band_of_angle(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.method = "rk4",
                                      .step = 0.02,
                                      .duration = 10,
                                      .interval = 0.01,
                                      .estimate = TRUE,
                                      .bands = TRUE,
                                      .columns = "Rod 0.angle"},
                    "{'type': 'support', 'solid': false}, {'type': 'mass', 'position': [1.5, 0], 'velocity': [0, 3]},"
                    "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']}");
    const double *bands = tinker_simulation_bands(run->simulation);
    g_assert_nonnull(bands);
    g_assert_cmpfloat(bands[0], <, 1e-3);
}

/* Joints of a bar that turns at 2 rad/s about a support that is turned at 0.5 rad/s and stands askew by 0.3 rad, and of
 * a disc that a drive turns on it at 5 rad/s: the angle is that between what the ends are on, and counts turns. */
static void test_turning_joints(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 4,
                          .interval = 0.37,
                          .columns = "Pin.angle, Pin.angle rate, Hub.angle, Hub.angle rate, Drive.angle, Drive.angle "
                                     "rate, Coil.angle rate, Weld.angle, Weld.angle rate"},
        "{'type': 'support', 'name': 'S', 'solid': false, 'orientation': 0.3},"
        "{'type': 'support-turn', 'ends': ['S'], 'waveform': {'expression': '0.5*t'}},"
        "{'type': 'bar', 'name': 'Bar', 'position': [0, 0], 'length': 2, 'orientation': 0.1, 'angular_velocity': 2},"
        "{'type': 'pin', 'name': 'Pin', 'ends': ['S', 'Bar']},"
        "{'type': 'disc', 'name': 'Disc', 'position': [0, 0], 'angular_velocity': 7},"
        "{'type': 'pin', 'name': 'Hub', 'ends': ['Bar', 'Disc']},"
        "{'type': 'drive', 'name': 'Drive', 'ends': ['Disc', 'Bar'], 'speed': 5},"
        "{'type': 'torsional-spring', 'name': 'Coil', 'ends': ['S', 'Bar'], 'stiffness': 0},"
        "{'type': 'disc', 'name': 'Tip', 'radius': 0.1, 'orientation': 1, 'angular_velocity': 2, 'position': "
        "[0.9950041652780258, 0.09983341664682815], 'velocity': [-0.1996668332936563, 1.9900083305560516]},"
        "{'type': 'weld', 'name': 'Weld', 'ends': [{'block': 'Bar', 'at': [1, 0]}, 'Tip']}");
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i);
        const double expected[] = {0.1 - 0.3 + 1.5 * t, 1.5, -0.1 + 5 * t, 5, -0.1 + 5 * t, 5, 1.5, 0.9, 0};
        for (gsize c = 0; c < G_N_ELEMENTS(expected); c++)
            physics_assert_near("turned", physics_value(run, i, c), expected[c], 1e-8);
    }
}

static double distance(double t, const void *data)
{
    return hypot(3 + 0.5 * t, 4 - t);
}

static void test_distance(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 6, .columns = "Bob.1.distance to Mass 0, Wall.distance to Bob.1"},
                    "{'type': 'mass', 'position': [100, 0], 'velocity': [1, 0]},"
                    "{'type': 'mass', 'name': 'Bob.1', 'position': [103, 4], 'velocity': [1.5, -1]},"
                    "{'type': 'support', 'name': 'Wall', 'position': [103, 4], 'solid': false}");
    physics_assert_follows(run, 0, distance, NULL, 1e-10);
    for (gsize i = 0; i < physics_samples(run); i++)
        physics_assert_near("wall", physics_value(run, i, 1), sqrt(3.25) * physics_time(run, i), 1e-10);
}

/* x'' + 2 d x' + w0^2 x = 0 from rest, in a field, sampled once: what the damper took is what is missing. */
static void test_energies_of_damped(void)
{
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = methods[m],
                              .duration = 3,
                              .interval = 3,
                              .columns = "Scene.kinetic energy, Scene.stored energy, Scene.potential energy,"
                                         "Scene.damper loss, Scene.dissipated energy, Scene.energy, Scene.y momentum"},
            "{'type': 'support', 'solid': false}, {'type': 'mass', 'mass': 2, 'position': [0, -3]},"
            "{'type': 'gravity', 'acceleration': 10},"
            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'rest_length': 2, 'stiffness': 50},"
            "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 1.2}");
        /* about rest at y = -2.4: z(0) = -0.6 */
        const double d = 0.3, w = sqrt(25 - d * d), t = 3, decay = exp(-d * t);
        const double z = -0.6 * decay * (cos(w * t) + d / w * sin(w * t)), v = 0.6 * decay * 25 / w * sin(w * t);
        const double stretch = 0.4 - z, kinetic = v * v, stored = 25 * stretch * stretch, potential = 20 * (z - 2.4);
        const double total = kinetic + stored + potential, start = 25 - 60;
        const double truth[] = {kinetic, stored, potential, start - total, start - total, total, 2 * v};
        for (gsize c = 0; c < G_N_ELEMENTS(truth); c++)
            physics_assert_near("energy", physics_last(run, c), truth[c], 2e-9);
    }
}

/* A push of 3 N over 2 m of ground with friction 0.1, then an impact with e = 0.5: each loss by itself. */
static void test_losses(void)
{
    g_autoptr(PhysicsRun) slide = physics_run(
        &(PhysicsOptions){.duration = 2,
                          .interval = 2,
                          .columns =
                              "Scene.friction loss, Scene.supplied energy, Scene.x momentum, Mass 0.path length"},
        "{'type': 'gravity', 'acceleration': 10}, {'type': 'support', 'width': 100, 'position': [0, -0.6],"
        " 'static_friction': 0.1, 'dynamic_friction': 0.1}, {'type': 'mass'},"
        "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 3, 'frequency': 0}");
    const double way = 4; /* a = 3 - 1 */
    const double truth[] = {way, 3 * way, 4, way};
    for (gsize c = 0; c < G_N_ELEMENTS(truth); c++)
        physics_assert_near("slide", physics_last(slide, c), truth[c], 1e-9);
    g_autoptr(PhysicsRun) drop = physics_run(
        &(PhysicsOptions){.duration = 0.7, .interval = 0.7, .columns = "Scene.impact loss, Mass 0.path length"},
        "{'type': 'gravity', 'acceleration': 10}, {'type': 'support', 'width': 9, 'position': [0, -0.2], "
        "'restitution': "
        "0.5}, {'type': 'mass', 'mass': 2, 'position': [0, 1.25], 'width': 0, 'height': 0}");
    /* 1.25 m in 0.5 s to 5 m/s; 2.5 m/s upwards, which is 0.3 m after 0.2 s */
    physics_assert_near("impact loss", physics_last(drop, 0), 25 - 6.25, 1e-8);
    physics_assert_near("way", physics_last(drop, 1), 1.25 + 0.3, 1e-8);
}

/* Two discs of 0.5 kg m^2 on torsional springs of 2 N m/rad, turned by 3 N m and not at all: theta = 1.5 (1 - cos 2t),
 * of which the torque gives 3 theta and the spring keeps theta^2; the other swings with 1 J. What springs keep nobody
 * gives. */
static void test_given_beside_stored(void)
{
    static const char *const ways[] = {"exact", "rk4", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(ways); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.method = ways[m],
                              .duration = 1.3,
                              .interval = 0.37,
                              .step = 0.001,
                              .columns = "Scene.supplied energy, Scene.stored energy, Scene.energy"},
            "{'type': 'support', 'solid': false}, {'type': 'disc', 'position': [0, 0], 'name': 'A', 'inertia': 0.5},"
            "{'type': 'support', 'solid': false, 'position': [3, 0]}, {'type': 'disc', 'name': 'B', 'inertia': 0.5,"
            " 'position': [3, 0], 'angular_velocity': 2},"
            "{'type': 'pin', 'ends': ['Support 0', 'A']}, {'type': 'pin', 'ends': ['Support 1', 'B']},"
            "{'type': 'torsional-spring', 'ends': ['Support 0', 'A'], 'stiffness': 2},"
            "{'type': 'torsional-spring', 'ends': ['Support 1', 'B'], 'stiffness': 2},"
            "{'type': 'torque', 'ends': ['A'], 'amplitude': 3, 'frequency': 0}");
        for (gsize s = 0; s < physics_samples(run); s++) {
            const double t = physics_time(run, s), angle = 1.5 * (1 - cos(2 * t)), other = sin(2 * t);
            physics_assert_near("given", physics_value(run, s, 0), 3 * angle, 1e-9);
            physics_assert_near("stored", physics_value(run, s, 1), angle * angle + other * other, 1e-9);
            physics_assert_near("energy", physics_value(run, s, 2), 1 + 3 * angle, 1e-9);
        }
    }
}

/* Between the steps of a method that works its books out where they are asked for, they are those of the time that is
 * asked for: nobody gives anything to a mass in a potential. */
static void test_given_within_steps(void)
{
    static const char *const adaptive[] = {"cvode-bdf", "dop853", "dopri5"};
    for (gsize m = 0; m < G_N_ELEMENTS(adaptive); m++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .method = adaptive[m], .interval = 0.013, .tolerance = 1e-8, .columns = "Scene.supplied energy"},
            "{'type': 'mass', 'mass': 2, 'position': [1, 0], 'velocity': [0, 3]},"
            "{'type': 'law-force', 'ends': ['Mass 0'], 'potential': '9*x^2 + 4*y^2'}");
        for (gsize s = 0; s < physics_samples(run); s++)
            physics_assert_near("given", physics_value(run, s, 0), 0, 1e-6);
    }
}

/* A driven bar strikes a disc with the speed u where they touch, and throws it back at (1 + e) u: of what the drive
 * gives it keeps half of 3 kg times that squared, and half of 3 kg u^2 (1 - e^2) is lost. */
static void test_losses_by_drive(void)
{
    static const double restitutions[] = {1, 0.5, 0.1};
    for (gsize i = 0; i < G_N_ELEMENTS(restitutions); i++) {
        const double e = restitutions[i];
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){.duration = 0.25,
                              .columns = "Disc 0.vx, Disc 0.vy, Scene.impact loss, Scene.supplied energy"},
            "{'type': 'support', 'solid': false, 'position': [0, 0]}, {'type': 'bar', 'solid': true, 'length': 2, "
            "'width': 0.1, "
            "'position': [0, 0], 'static_friction': 0, 'dynamic_friction': 0}, {'type': 'pin', 'ends': ['Support 0', "
            "'Bar 0']}, {'type': 'drive', 'ends': ['Bar 0', 'Support 0'], 'speed': 2}, {'type': 'disc', 'mass': 3, "
            "'radius': 0.1, 'position': [0.8, 0.4], 'restitution': %g, 'static_friction': 0, 'dynamic_friction': 0}",
            e);
        const double speed = hypot(physics_last(run, 0), physics_last(run, 1)), u = speed / (1 + e);
        g_assert_cmpfloat(speed, >, 1);
        physics_assert_near("lost", physics_last(run, 2), 1.5 * u * u * (1 - e * e), 1e-8);
        physics_assert_near("given", physics_last(run, 3), 1.5 * speed * speed + 1.5 * u * u * (1 - e * e), 1e-8);
    }
}

static void assert_refused(const char *column, const char *says)
{
    g_autoptr(TinkerScene) scene = physics_scene(
        NULL, "{'type': 'mass'}, {'type': 'support'}, {'type': 'spring', 'ends': ['Mass 0', 'Support 0']}");
    g_autoptr(GArray) columns = tinker_columns_new();
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_columns_add(columns, scene, column, &error));
    g_assert_error(error, TINKER_SCENE_ERROR, TINKER_SCENE_ERROR_NAME);
    if (strstr(error->message, says) == NULL) g_error("\"%s\" does not say \"%s\"", error->message, says);
}

static void test_refused(void)
{
    assert_refused("Mass 0.distance to Mass 0", "\"Mass 0\" is not another block");
    assert_refused("Mass 0.distance to Spring 0", "\"Spring 0\" is not another block");
    assert_refused("Support 0.path length", "no quantity \"path length\"");
    assert_refused("Mass 0.angle", "no quantity \"angle\"");
    assert_refused("Spring 0.angel", "did you mean \"angle\"?");
    assert_refused("Scene.kinetic", "kinetic energy");
    assert_refused("Scene", "Scene.kinetic energy");
}

static void add_tests(void)
{
    g_test_add_func("/physics/implied/path-of-oscillation", test_path_of_oscillation);
    g_test_add_func("/physics/implied/path-whatever-is-sampled", test_path_whatever_is_sampled);
    g_test_add_func("/physics/implied/path-of-throw", test_path_of_throw);
    g_test_add_func("/physics/implied/path-of-what-stands", test_path_of_what_stands);
    g_test_add_func("/physics/implied/turning-rod", test_turning_rod);
    g_test_add_func("/physics/implied/turning-joints", test_turning_joints);
    g_test_add_func("/physics/implied/band-of-angle", test_band_of_angle);
    g_test_add_func("/physics/implied/distance", test_distance);
    g_test_add_func("/physics/implied/energies-of-damped", test_energies_of_damped);
    g_test_add_func("/physics/implied/losses", test_losses);
    g_test_add_func("/physics/implied/losses-by-drive", test_losses_by_drive);
    g_test_add_func("/physics/implied/given-beside-stored", test_given_beside_stored);
    g_test_add_func("/physics/implied/given-within-steps", test_given_within_steps);
    g_test_add_func("/physics/implied/refused", test_refused);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
