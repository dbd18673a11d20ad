/* Bodies that turn: bars on pins, forces off their centres, by closed forms and by independent integration. */
#include "physics-fixture.h"

#include "physics/model/model.h"
#include "physics/system/summary.h"
#include "test-systems.h"

#include <math.h>
#include <string.h>

#define LENGTH  1.2
#define GRAVITY 9.81

/* A bar of 1.2 m on a pin at one end, released level: it moves as a point mass 2/3 of its length away does. */
#define BAR_PENDULUM                                                                                                   \
    "{'type': 'gravity'}, {'type': 'support'},"                                                                        \
    "{'type': 'bar', 'mass': 2.5, 'length': 1.2, 'position': [0.6, 0]},"                                               \
    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.6, 0]}]}"

static double angle_of(double t, double *rate)
{
    Pendulum p;
    double q[2], v[2];
    pendulum_init(&p, 2 * LENGTH / 3, GRAVITY, G_PI / 2, 0.0);
    pendulum_exact(&p, t, q, v);
    *rate = (q[0] * v[1] - q[1] * v[0]) / (q[0] * q[0] + q[1] * q[1]);
    return atan2(q[1], q[0]);
}

/* How far the angle is off at the end; angles of a swing below the pin, so that none is a turn away. */
static double error_of(const char *method, double step)
{
    g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = method,
                                                              .step = step,
                                                              .duration = 0.8,
                                                              .tolerance = 1e-11,
                                                              .columns = "Bar 0.angle, Bar 0.angular velocity"},
                                            BAR_PENDULUM);
    double rate, angle = angle_of(0.8, &rate);
    if (step == 0) physics_assert_near("rate", physics_last(run, 1), rate, 1e-8);
    TinkerBodySample sample;
    g_assert_true(tinker_simulation_body(run->simulation, tinker_scene_find_block(run->scene, "Bar 0"), &sample));
    g_assert_cmpfloat(sample.orientation, ==, physics_last(run, 0)); /* as it is drawn */
    return fabs(physics_last(run, 0) - angle);
}

static void test_bar_pendulum(void)
{
    static const char *const adaptive[] = {"dopri5", "dop853", "cvode-bdf"};
    for (gsize m = 0; m < G_N_ELEMENTS(adaptive); m++)
        g_assert_cmpfloat(error_of(adaptive[m], 0), <, m == 2 ? 1e-8 : 1e-9);
}

static void test_orders(void)
{
    static const struct {
        const char *method;
        int order;
    } rows[] = {{"verlet", 2}, {"rk4", 4}, {"verlet6", 6}, {"newmark", 2}, {"generalized-alpha", 2}};
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        const double coarse = error_of(rows[i].method, 0.02), fine = error_of(rows[i].method, 0.01);
        g_test_message("%s: %g, then %g", rows[i].method, coarse, fine);
        g_assert_cmpfloat(log2(coarse / fine), >, rows[i].order - 0.3);
    }
}

/* After 100 s the pin is where it was, and the energy what it was. */
static void test_pin_holds(void)
{
    static const char *const methods[] = {"verlet", "rk4", "dop853"};
    for (gsize m = 0; m < G_N_ELEMENTS(methods); m++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.method = methods[m], .duration = 100, .step = 0.005, .columns = "Bar 0.x"},
                        BAR_PENDULUM);
        g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-14);
        g_assert_cmpfloat(run->summary->constraint_velocity_error, <, 1e-13);
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-3);
    }
}

/* The pin's force: m (a - g). */
static void test_pin_force(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 3,
                                      .columns = "Pin 0.force x, Pin 0.force y, Bar 0.ax, Bar 0.ay, "
                                                 "Bar 0.angular acceleration, Bar 0.angle, Pin 0.force"},
                    BAR_PENDULUM);
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double fx = -physics_value(run, i, 0), fy = -physics_value(run, i, 1); /* on the bar */
        physics_assert_near("m ax", fx, 2.5 * physics_value(run, i, 2), 1e-9);
        physics_assert_near("m ay", fy, 2.5 * (physics_value(run, i, 3) + GRAVITY), 1e-9);
        physics_assert_near("I alpha", physics_value(run, i, 4),
                            -1.5 * GRAVITY / LENGTH * cos(physics_value(run, i, 5)), 1e-8);
        physics_assert_near("force", physics_value(run, i, 6), hypot(fx, fy), 1e-9);
    }
}

/* Thrown, it turns evenly, and its angle counts turns. */
static void test_thrown(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 10,
                                      .columns = "Box 0.angle, Box 0.angular velocity, Box 0.y, "
                                                 "Box 0.rotational energy, Box 0.angular momentum, Box 0.speed, "
                                                 "Box 0.acceleration, Box 0.x momentum, Box 0.y momentum"},
                    "{'type': 'gravity'}, {'type': 'box', 'position': [0, 0], 'mass': 3, 'width': 0.6, 'height': 0.8, "
                    "'orientation': 0.25,"
                    " 'velocity': [1, 20], 'angular_velocity': 7, 'solid': false}");
    const double inertia = 3 * (0.6 * 0.6 + 0.8 * 0.8) / 12;
    for (gsize i = 0; i < physics_samples(run); i++) {
        const double t = physics_time(run, i);
        physics_assert_near("angle", physics_value(run, i, 0), 0.25 + 7 * t, 1e-12);
        physics_assert_near("rate", physics_value(run, i, 1), 7, 1e-13);
        physics_assert_near("y", physics_value(run, i, 2), 20 * t - GRAVITY / 2 * t * t, 1e-10);
        physics_assert_near("energy", physics_value(run, i, 3), inertia * 49 / 2, 1e-12);
        physics_assert_near("momentum", physics_value(run, i, 4), inertia * 7, 1e-12);
        physics_assert_near("speed", physics_value(run, i, 5), hypot(1, 20 - GRAVITY * t), 1e-10);
        physics_assert_near("acceleration", physics_value(run, i, 6), GRAVITY, 1e-12);
        physics_assert_near("m vx", physics_value(run, i, 7), 3, 1e-12);
        physics_assert_near("m vy", physics_value(run, i, 8), 3 * (20 - GRAVITY * t), 1e-10);
    }
}

static void test_inertia_as_shaped(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 0.1,
                          .columns = "Bar 0.angular momentum, Disc 0.angular momentum, Box 0.angular momentum, "
                                     "Disc 1.angular momentum"},
        "{'type': 'bar', 'position': [0, 0], 'mass': 2, 'length': 3, 'width': 1, 'angular_velocity': 1},"
        "{'type': 'disc', 'position': [0, 0], 'mass': 2, 'radius': 3, 'angular_velocity': 1, 'solid': false},"
        "{'type': 'box', 'position': [0, 0], 'mass': 2, 'width': 3, 'height': 4, 'angular_velocity': 1, 'solid': "
        "false},"
        "{'type': 'disc', 'position': [0, 0], 'mass': 2, 'radius': 3, 'inertia': 18, 'angular_velocity': 1, 'solid': "
        "false}");
    static const double inertia[] = {1.5, 9, 2 * 25.0 / 12, 18};
    for (gsize i = 0; i < G_N_ELEMENTS(inertia); i++)
        physics_assert_near("I", physics_last(run, i), inertia[i], 1e-14 * inertia[i]);
}

/* Spring, damper and a driven force act at the free end of a bar whose pivot is shaken: with theta from +x, r = L
 * (cos, sin) from the pivot to the end, m L^2 / 3 theta'' = r x F - m (g + p'') . (-sin, cos) L / 2. */
typedef struct {
    double stiffness, rest, damping, force, shake, omega;
} Arm;

static const Arm arm = {40, 0.5, 1.5, 3, 0.1, 5};

static void arm_rate(double t, const double *y, double *rate, const void *data)
{
    const Arm *of = data;
    const double c = cos(y[0]), s = sin(y[0]), mass = 2.5;
    const double px = of->shake * sin(of->omega * t), pu = of->shake * of->omega * cos(of->omega * t);
    const double pa = -of->omega * of->omega * px;
    const double dx = 1.5 - px - LENGTH * c, dy = 0.5 - LENGTH * s, length = hypot(dx, dy);
    const double u = pu - LENGTH * s * y[1], v = LENGTH * c * y[1];
    const double stretching = -(dx * u + dy * v) / length;
    const double tension = of->stiffness * (length - of->rest) + of->damping * stretching;
    const double fx = tension * dx / length, fy = tension * dy / length + of->force * cos(2 * t);
    const double torque = LENGTH * (c * fy - s * fx) - mass * LENGTH / 2 * (GRAVITY * c - pa * s);
    rate[0] = y[1];
    rate[1] = torque / (mass * LENGTH * LENGTH / 3);
}

#define SHAKEN_ARM                                                                                                     \
    "{'type': 'gravity'}, {'type': 'support', 'solid': false},"                                                        \
    "{'type': 'support', 'position': [1.5, 0.5], 'solid': false},"                                                     \
    "{'type': 'support-motion', 'ends': ['Support 0'], 'amplitude': 0.1, 'frequency': 5},"                             \
    "{'type': 'bar', 'mass': 2.5, 'length': 1.2, 'position': [0.6, 0], 'velocity': [0.5, 0]},"                         \
    "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [-0.6, 0]}, 'Support 0']},"                                     \
    "{'type': 'spring', 'ends': [{'block': 'Bar 0', 'at': [0.6, 0]}, 'Support 1'], 'stiffness': 40,"                   \
    " 'rest_length': 0.5},"                                                                                            \
    "{'type': 'damper', 'ends': [{'block': 'Bar 0', 'at': [0.6, 0]}, 'Support 1'], 'damping': 1.5},"                   \
    "{'type': 'motor', 'ends': [{'block': 'Bar 0', 'at': [0.6, 0]}], 'amplitude': 3, 'frequency': 2, 'waveform': "     \
    "'cosine',"                                                                                                        \
    " 'angle': 1.5707963267948966}"

static void test_forces_at_an_arm(void)
{
    static const struct {
        const char *method;
        double step, bound;
    } rows[] = {{"dop853", 0.01, 1e-9},
                {"rk4", 0.001, 1e-9},
                {"verlet", 0.0002, 1e-6},
                {"newmark", 0.0005, 1e-5},
                {"generalized-alpha", 0.0005, 1e-5},
                {"cvode-bdf", 0.01, 1e-6}};
    double y[2] = {0, 0};
    physics_rk4(2, y, 0, 2, 20000, arm_rate, &arm);
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(PhysicsRun) run = physics_run(&(PhysicsOptions){.method = rows[i].method,
                                                                  .step = rows[i].step,
                                                                  .duration = 2,
                                                                  .columns = "Bar 0.angle, Bar 0.angular velocity"},
                                                SHAKEN_ARM);
        g_test_message("%s", rows[i].method);
        physics_assert_near("angle", physics_last(run, 0), y[0], rows[i].bound);
        physics_assert_near("rate", physics_last(run, 1), y[1], 10 * rows[i].bound);
        g_assert_cmpfloat(run->summary->energy_balance_error, <, 100 * rows[i].bound);
    }
}

/* A second pin at the same place changes nothing, and each carries half. */
static void test_redundant_pins(void)
{
    static const char columns[] = "Bar 0.angle, Pin 0.force y";
    g_autoptr(PhysicsRun) one = physics_run(&(PhysicsOptions){.duration = 2, .columns = columns}, BAR_PENDULUM);
    g_autoptr(PhysicsRun) two =
        physics_run(&(PhysicsOptions){.duration = 2, .columns = columns},
                    BAR_PENDULUM ", {'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.6, 0]}]}");
    g_assert_cmpint(tinker_model_sizes(one->model).degrees_of_freedom, ==, 1);
    g_assert_cmpint(tinker_model_sizes(two->model).degrees_of_freedom, ==, 1);
    g_assert_cmpint(tinker_model_sizes(two->model).redundant_rows, ==, 2);
    physics_assert_near("angle", physics_last(two, 0), physics_last(one, 0), 1e-9);
    physics_assert_near("half", 2 * physics_last(two, 1), physics_last(one, 1), 1e-6);
}

/* Parts that nothing ties together are stepped apart, as if each were alone. */
static void test_islands(void)
{
    g_autoptr(PhysicsRun) alone =
        physics_run(&(PhysicsOptions){.duration = 2, .columns = "Bar 0.angle, Bar 0.x"}, BAR_PENDULUM);
    g_autoptr(PhysicsRun) beside = physics_run(
        &(PhysicsOptions){.duration = 2, .columns = "Bar 0.angle, Bar 0.x, Disc 0.angle"},
        "{'type': 'disc', 'position': [5, 5], 'angular_velocity': 3, 'solid': false}, {'type': 'mass'}," BAR_PENDULUM);
    g_assert_cmpuint(beside->summary->islands->len, ==, 3);
    g_assert_cmpfloat(physics_last(beside, 0), ==, physics_last(alone, 0));
    g_assert_cmpfloat(physics_last(beside, 1), ==, physics_last(alone, 1));
    physics_assert_near("disc", physics_last(beside, 2), 6, 1e-13);
}

/* With an estimate the angle counts too. */
static void test_estimate(void)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.method = "rk4", .duration = 0.8, .step = 0.02, .estimate = TRUE, .columns = "Bar 0.angle"},
        BAR_PENDULUM);
    double rate, off = fabs(physics_last(run, 0) - angle_of(0.8, &rate));
    g_assert_cmpfloat(run->summary->error_estimate, >, 0.1 * off);
    g_assert_cmpfloat(run->summary->error_estimate, <, 30 * off);
}

/* Contact as impulses: bars are held by their pins all the same. */
static void test_beside_impulses(void)
{
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 0.5, .step = 1e-4, .impulses = TRUE, .columns = "Bar 0.angle"},
                    "{'type': 'support', 'name': 'Floor', 'position': [0, -5], 'width': 20},"
                    "{'type': 'mass', 'position': [3, 0]}," BAR_PENDULUM);
    double rate;
    physics_assert_near("angle", physics_last(run, 0), angle_of(0.5, &rate), 1e-3);
}

/* A beam on many feet that comes down flat stays where it lands, with contacts solved exactly and as impulses. */
static void test_many_feet(void)
{
    g_autoptr(GString) blocks =
        g_string_new("{'type': 'gravity'}, {'type': 'support', 'width': 40, 'height': 2,"
                     " 'position': [0, -1]}, {'type': 'bar', 'length': 12, 'position': [0, 1]}");
    for (int i = 0; i < 12; i++) {
        const double x = i - 5.5;
        g_string_append_printf(blocks,
                               ", {'type': 'mass', 'width': 0.2, 'height': 0.2, 'position': [%g, 1]},"
                               "{'type': 'pin', 'ends': ['Mass %d', {'block': 'Bar 0', 'at': [%g, 0]}]}",
                               x, i, x);
    }
    for (int impulses = 0; impulses < 2; impulses++) {
        g_autoptr(PhysicsRun) run = physics_run(
            &(PhysicsOptions){
                .duration = 1, .step = 0.001, .impulses = impulses, .columns = "Bar 0.y, Bar 0.angle, Mass 3.y"},
            "%s", blocks->str);
        physics_assert_near("y", physics_last(run, 0), 0.1, 1e-9);
        physics_assert_near("angle", physics_last(run, 1), 0, 1e-9);
        physics_assert_near("foot", physics_last(run, 2), 0.1, 1e-9);
    }
}

/* What turns and is solid meets supports by impulses, too, unless it is not meant to. */
static void test_passes_supports(void)
{
    static const char *const solid[] = {"true", "false"};
    for (guint i = 0; i < 2; i++) {
        g_autoptr(PhysicsRun) run =
            physics_run(&(PhysicsOptions){.duration = 1, .step = 0.01, .impulses = TRUE, .columns = "Disc 0.y"},
                        "{'type': 'gravity', 'acceleration': 8}, {'type': 'support', 'position': [0, -2]},"
                        "{'type': 'disc', 'position': [0, 0], 'radius': 0.3, 'solid': %s}",
                        solid[i]);
        physics_assert_near("y", physics_last(run, 0), i == 0 ? -1.5 : -4, i == 0 ? 1e-9 : 0.05);
    }
}

static void test_refused(void)
{
    g_autoptr(PhysicsRun) apart = physics_try(
        &(PhysicsOptions){0}, "{'type': 'support'}, {'type': 'bar', 'position': [0.6, 0]},"
                              "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}");
    physics_assert_refused(apart, TINKER_MODEL_ERROR_SCENE, "Pin 0", "(0, 0)", "(0.1, 0)", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/physics/turning/bar-pendulum", test_bar_pendulum);
    g_test_add_func("/physics/turning/orders", test_orders);
    g_test_add_func("/physics/turning/pin-holds", test_pin_holds);
    g_test_add_func("/physics/turning/pin-force", test_pin_force);
    g_test_add_func("/physics/turning/thrown", test_thrown);
    g_test_add_func("/physics/turning/inertia-as-shaped", test_inertia_as_shaped);
    g_test_add_func("/physics/turning/forces-at-an-arm", test_forces_at_an_arm);
    g_test_add_func("/physics/turning/redundant-pins", test_redundant_pins);
    g_test_add_func("/physics/turning/islands", test_islands);
    g_test_add_func("/physics/turning/estimate", test_estimate);
    g_test_add_func("/physics/turning/beside-impulses", test_beside_impulses);
    g_test_add_func("/physics/turning/many-feet", test_many_feet);
    g_test_add_func("/physics/turning/passes-supports", test_passes_supports);
    g_test_add_func("/physics/turning/refused", test_refused);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
