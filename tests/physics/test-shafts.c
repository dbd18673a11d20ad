/* Shafts: bodies that turn on fixed axes, tied by gears, torsional springs and dampers, stepped exactly; by closed
 * forms.
 */
#include "physics-fixture.h"

#include "physics/compile/compile.h"
#include "physics/line/linear-form.h"

#include <math.h>

/* "Axle" with bearings one metre apart, and a disc of an inertia on each. */
#define AXLE "{'type': 'support', 'name': 'Axle', 'solid': false}"
#define DISC(name, inertia, x, more)                                                                                   \
    ", {'type': 'disc', 'name': '" name "', 'radius': 0.3, 'inertia': " inertia ", 'position': [" x ", 0]" more "}"    \
    ", {'type': 'pin', 'ends': [{'block': 'Axle', 'at': [" x ", 0]}, '" name "']}"

static PhysicsRun *exactly(const char *columns, double duration, const char *blocks)
{
    PhysicsRun *run = physics_run(
        &(PhysicsOptions){.method = "exact", .duration = duration, .interval = duration / 8, .columns = columns}, "%s",
        blocks);
    g_assert_cmpfloat(run->summary->energy_balance_error, <, 1e-12);
    g_assert_cmpfloat(run->summary->constraint_position_error, <, 1e-13);
    g_assert_cmpfloat(run->summary->constraint_velocity_error, <, 1e-13);
    g_assert_cmpint(run->summary->evaluations, ==, 0);
    return run;
}

/* Two discs I1, I2 on a shaft of k: they swing against each other at w^2 = k (1/I1 + 1/I2) about what turns on evenly.
 */
static void test_two_discs(void)
{
    const double i1 = 0.5, i2 = 2, k = 8, omega = sqrt(k * (1 / i1 + 1 / i2));
    g_autoptr(PhysicsRun) run =
        exactly("A.angle, B.angle, A.angular velocity, B.angular velocity", 40,
                AXLE DISC("A", "0.5", "0", ", 'angular_velocity': 1")
                    DISC("B", "2", "1", ", 'orientation': 0.3") ", {'type': 'torsional-spring', 'ends': ['A', 'B'], "
                                                                "'stiffness': 8, 'rest_angle': 0.1}");
    for (gsize s = 0; s < physics_samples(run); s++) {
        const double t = physics_time(run, s), c = cos(omega * t), d = sin(omega * t);
        const double mean = (i1 * t + i2 * 0.3) / (i1 + i2), drift = i1 / (i1 + i2);
        const double twist = 0.1 + 0.2 * c - d / omega, rate = -0.2 * omega * d - c;
        physics_assert_near("A", physics_value(run, s, 0), mean - i2 / (i1 + i2) * twist, 1e-12);
        physics_assert_near("B", physics_value(run, s, 1), mean + i1 / (i1 + i2) * twist, 1e-12);
        physics_assert_near("A's rate", physics_value(run, s, 2), drift - i2 / (i1 + i2) * rate, 1e-12);
        physics_assert_near("B's rate", physics_value(run, s, 3), drift + i1 / (i1 + i2) * rate, 1e-12);
    }
}

/* A shaft of k from A to B, which is geared to C by i: C is felt at B as i^2 I_C. C starts as the gear has it, and
 * swings as -i times B. The gear's torque on B is what turns C: i I_C theta_C''. */
static void test_geared_torsion(void)
{
    const double ia = 0.8, ib = 0.1 + 2.5 * 2.5 * 0.3, k = 20, omega = sqrt(k * (1 / ia + 1 / ib));
    g_autoptr(PhysicsRun) run =
        exactly("A.angle, B.angle, C.angle, G.torque", 25,
                AXLE DISC("A", "0.8", "0", ", 'orientation': 0.4") DISC("B", "0.1", "1", "")
                    DISC("C", "0.3", "2",
                         ", 'orientation': -1") ", {'type': 'torsional-spring', 'ends': ['A', 'B'], 'stiffness': 20, "
                                                "'rest_angle': 0}"
                                                ", {'type': 'gear', 'name': 'G', 'ends': ['B', 'C'], 'ratio': 2.5}");
    for (gsize s = 0; s < physics_samples(run); s++) {
        const double c = cos(omega * physics_time(run, s)), b = ia * 0.4 / (ia + ib) * (1 - c);
        physics_assert_near("A", physics_value(run, s, 0), 0.4 * (ia + ib * c) / (ia + ib), 1e-12);
        physics_assert_near("B", physics_value(run, s, 1), b, 1e-12);
        physics_assert_near("C", physics_value(run, s, 2), -1 - 2.5 * b, 1e-12);
        const double of_c = -2.5 * ia * 0.4 / (ia + ib) * omega * omega * c;
        physics_assert_near("torque", physics_value(run, s, 3), 2.5 * 0.3 * of_c, 1e-10);
    }
}

/* Wheels of I1 to I4: 1 drives 2 by 1/3, 3 is welded to 2 and drives 4, inside, by 1/2. A torque M cos(w t) turns 1:
 * with I = I1 + (I2 + I3) / 9 + I4 / 36, theta_1 = M (1 - cos w t) / (I w^2). */
static void test_gear_train(void)
{
    const double inertia = 0.2 + (1 + 0.5) / 9 + 3.0 / 36, swing = 5 / (inertia * 16);
    g_autoptr(PhysicsRun) run = exactly(
        "W1.angle, W2.angle, W3.angle, W4.angle, W1.angular velocity", 12,
        AXLE DISC("W1", "0.2", "0", "") DISC("W2", "1", "1", "")
            DISC("W4", "3", "2",
                 ", 'orientation': 2") ", {'type': 'disc', 'name': 'W3', 'inertia': 0.5, 'position': [1, 0], 'solid': "
                                       "false},"
                                       "{'type': 'weld', 'ends': ['W2', 'W3']},"
                                       "{'type': 'gear', 'ends': ['W1', 'W2'], 'ratio': 0.3333333333333333},"
                                       "{'type': 'gear', 'ends': ['W3', 'W4'], 'ratio': 0.5, 'internal': true},"
                                       "{'type': 'torque', 'ends': ['W1', 'Axle'], 'amplitude': 5, 'frequency': 4}");
    for (gsize s = 0; s < physics_samples(run); s++) {
        const double t = physics_time(run, s), turned = swing * (1 - cos(4 * t));
        physics_assert_near("1", physics_value(run, s, 0), turned, 1e-12);
        physics_assert_near("2", physics_value(run, s, 1), -turned / 3, 1e-12);
        physics_assert_near("3", physics_value(run, s, 2), -turned / 3, 1e-12);
        physics_assert_near("4", physics_value(run, s, 3), 2 - turned / 6, 1e-12);
        physics_assert_near("rate", physics_value(run, s, 4), 4 * swing * sin(4 * t), 1e-12);
    }
    physics_assert_near("motors", run->summary->books[TINKER_BOOK_MOTORS],
                        run->summary->kinetic_end - run->summary->kinetic_start, 1e-11);
}

/* I theta'' + c theta' + k theta = 0 against the support: theta = e^(-d t) (cos w t + d / w sin w t) theta(0). */
static void test_damped(void)
{
    const double d = 0.6 / (2 * 0.5), omega = sqrt(7 / 0.5 - d * d);
    g_autoptr(PhysicsRun) run = exactly(
        "A.angle", 10,
        AXLE DISC("A", "0.5", "0",
                  ", 'orientation': 0.9") ", {'type': 'torsional-spring', 'ends': ['A', 'Axle'], 'stiffness': 7, "
                                          "'rest_angle': 0}"
                                          ", {'type': 'torsional-damper', 'ends': ['Axle', 'A'], 'damping': 0.6}");
    for (gsize s = 0; s < physics_samples(run); s++) {
        const double t = physics_time(run, s);
        physics_assert_near("angle", physics_value(run, s, 0),
                            0.9 * exp(-d * t) * (cos(omega * t) + d / omega * sin(omega * t)), 1e-13);
    }
    physics_assert_near("dampers", run->summary->books[TINKER_BOOK_DAMPERS],
                        run->summary->kinetic_end + run->summary->potential_end - 0.5 * 7 * 0.81, 1e-12);
}

/* --- where there is such a form --- */

static gboolean is_linear(const char *blocks)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(TinkerModel) model = tinker_model_new(scene, &error);
    g_assert_no_error(error);
    TinkerLinearForm *form = tinker_linear_form_new(model);
    const gboolean linear = form != NULL;
    if (linear) g_assert_true(tinker_linear_form_is_of_shafts(form));
    tinker_linear_form_free(form);
    return linear;
}

#define FOUR                                                                                                           \
    AXLE DISC("A", "1", "0", "") DISC("B", "1", "1", "") DISC("C", "1", "2", "") DISC(                                 \
        "D", "1", "3",                                                                                                 \
        "") ", {'type': 'gear', 'ends': ['A', 'B'], 'ratio': 2}, {'type': 'gear', 'ends': ['C', 'D'], 'ratio': 2},"    \
            "{'type': 'torsional-spring', 'ends': ['A', 'C']},"

static void test_recognised(void)
{
    /* two gears alike between two shafts: a closed ring whose ratios fit, and one whose ratios do not */
    g_assert_true(is_linear(FOUR "{'type': 'torsional-spring', 'ends': ['B', 'D']}"));
    g_assert_false(is_linear(FOUR "{'type': 'torsional-spring', 'ends': ['A', 'D']}"));
    /* driven; held off its centre, where its weight turns it; not held; held to a mass on a spring */
    g_assert_false(is_linear(FOUR "{'type': 'drive', 'ends': ['A', 'Axle']}"));
    g_assert_false(is_linear(AXLE ", {'type': 'bar', 'name': 'B', 'position': [0.5, 0]},"
                                  "{'type': 'pin', 'ends': ['Axle', {'block': 'B', 'at': [-0.5, 0]}]}"));
    g_assert_false(is_linear(AXLE DISC("A", "1", "0", "") ", {'type': 'disc', 'name': 'B', 'position': [4, 0]},"
                                                          "{'type': 'torsional-spring', 'ends': ['A', 'B']}"));
    g_assert_false(is_linear(AXLE DISC("A", "1", "0", "") ", {'type': 'mass', 'position': [4, 0]},"
                                                          "{'type': 'spring', 'ends': ['A', 'Mass 0']}"));
}

/* A method for linear parts alone says where it is not linear. */
static void test_refused(void)
{
    g_autoptr(PhysicsRun) run =
        physics_try(&(PhysicsOptions){.method = "exact"}, FOUR "{'type': 'torsional-spring', 'ends': ['A', 'D']}");
    physics_assert_refused(run, TINKER_MODEL_ERROR_METHOD, "exact", "not linear", NULL);
}

static void add_tests(void)
{
    g_test_add_func("/physics/shafts/two-discs", test_two_discs);
    g_test_add_func("/physics/shafts/geared-torsion", test_geared_torsion);
    g_test_add_func("/physics/shafts/gear-train", test_gear_train);
    g_test_add_func("/physics/shafts/damped", test_damped);
    g_test_add_func("/physics/shafts/recognised", test_recognised);
    g_test_add_func("/physics/shafts/refused", test_refused);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
