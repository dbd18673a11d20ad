/* Forces told apart have the values that statics asks for. */
#include "acting-watch.h"

#include <math.h>

#include "physics/model/model.h"

#define G 9.81

/* The force of a block on another at the start; `kind` -1: any. */
static const TinkerActingForce *find(TinkerScene *scene, const GArray *out, const char *by, const char *on, int kind)
{
    for (guint i = 0; i < out->len; i++) {
        const TinkerActingForce *force = &g_array_index(out, TinkerActingForce, i);
        if (g_str_equal(tinker_scene_block_name(scene, force->by), by) &&
            g_str_equal(tinker_scene_block_name(scene, force->on), on) && (kind < 0 || kind == (int)force->kind))
            return force;
    }
    g_error("%s does not act on %s", by, on);
}

static void assert_force(const TinkerActingForce *force, double fx, double fy, double x, double y)
{
    physics_assert_near("fx", force->fx, fx, 1e-12 * (1 + hypot(fx, fy)));
    physics_assert_near("fy", force->fy, fy, 1e-12 * (1 + hypot(fx, fy)));
    physics_assert_near("x", force->x, x, 1e-12);
    physics_assert_near("y", force->y, y, 1e-12);
}

/* A mass hangs at rest from two springs side by side, which the model merges, and a third that hangs below holds
 * nothing. */
static void test_hanging(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [5, 3]},"
                            "{'type': 'mass', 'mass': 2, 'position': [5, 1]}, {'type': 'mass', 'position': [5, 0]},"
                            "{'type': 'spring', 'ends': ['Support 0', 'Mass 0'], 'stiffness': 9.81, 'rest_length': 1},"
                            "{'type': 'spring', 'ends': ['Mass 0', 'Support 0'], 'stiffness': 4.905, 'rest_length': 0},"
                            "{'type': 'spring', 'ends': ['Mass 0', 'Mass 1'], 'stiffness': 7, 'rest_length': 1},"
                            "{'type': 'damper', 'ends': ['Support 0', 'Mass 0'], 'damping': 3}");
    g_autoptr(GArray) out = acting_watch_at_start(scene);
    assert_force(find(scene, out, "Gravity 0", "Mass 0", TINKER_ACTING_FIELD), 0, -2 * G, 5, 1);
    assert_force(find(scene, out, "Spring 0", "Mass 0", TINKER_ACTING_LINE), 0, G, 5, 1);
    assert_force(find(scene, out, "Spring 1", "Mass 0", TINKER_ACTING_LINE), 0, G, 5, 1);
    assert_force(find(scene, out, "Spring 0", "Support 0", TINKER_ACTING_LINE), 0, -G, 5, 3);
    assert_force(find(scene, out, "Spring 2", "Mass 1", TINKER_ACTING_LINE), 0, 0, 5, 0);
    assert_force(find(scene, out, "Damper 0", "Mass 0", TINKER_ACTING_LINE), 0, 0, 5, 1);
    g_assert_cmpuint(out->len, ==, 2 + 4 * 2);
}

/* A pendulum that turns: tension m (g cos + v^2 / L); a motor at its bob, and air. */
static void test_turning(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'wind', 'drag': 0.5},"
                            "{'type': 'mass', 'mass': 3, 'position': [0, -2], 'velocity': [4, 0]},"
                            "{'type': 'rod', 'ends': ['Support 0', 'Mass 0']},"
                            "{'type': 'motor', 'ends': ['Mass 0'], 'amplitude': 7, 'frequency': 0, 'angle': 1.2}");
    g_autoptr(GArray) out = acting_watch_at_start(scene);
    const TinkerActingForce *motor = find(scene, out, "Motor 0", "Mass 0", TINKER_ACTING_ELEMENT);
    g_assert_cmpfloat(fabs(hypot(motor->fx, motor->fy) - 7), <, 1e-12);
    assert_force(find(scene, out, "Wind 0", "Mass 0", TINKER_ACTING_FIELD), -2, 0, 0, -2);
    double tension = 3 * (G + 16 / 2.0) - motor->fy;
    assert_force(find(scene, out, "Rod 0", "Mass 0", TINKER_ACTING_CONSTRAINT), 0, tension, 0, -2);
    assert_force(find(scene, out, "Rod 0", "Support 0", TINKER_ACTING_CONSTRAINT), 0, -tension, 0, 0);
}

/* Cords pull at the rim where they leave a pulley of 4 kg, not at its centre: a = (3 - 2) g / (3 + 2 + 4/2), with
 * 3 (g - a) and 2 (g + a) at either side of it. One that leaves obliquely, from a disc about (1, 2) to (4, 6) that is 5
 * m away, does so where radius and cord are at right angles. */
static void test_cords(void)
{
    const double a = G / 7;
    g_autoptr(TinkerScene) scene = physics_scene(
        NULL, "{'type': 'gravity'}, {'type': 'support', 'name': 'Axle', 'position': [1, 2], 'solid': false},"
              "{'type': 'disc', 'name': 'Pulley', 'mass': 4, 'radius': 0.5, 'position': [1, 2], 'solid': false},"
              "{'type': 'pin', 'ends': ['Axle', 'Pulley']}, {'type': 'mass', 'name': 'Heavy', 'mass': 3, "
              "'position': [0.5, 0]}, {'type': 'mass', 'name': 'Light', 'mass': 2, 'position': [1.5, -1]},"
              "{'type': 'cord', 'name': 'Left', 'ends': ['Pulley', 'Heavy'], 'side': 'right'},"
              "{'type': 'cord', 'name': 'Right', 'ends': ['Pulley', 'Light'], 'side': 'left'}");
    g_autoptr(GArray) out = acting_watch_at_start(scene);
    const TinkerActingForce *left = find(scene, out, "Left", "Pulley", TINKER_ACTING_CONSTRAINT);
    assert_force(left, 0, -3 * (G - a), 0.5, 2);
    g_assert_cmpfloat(left->torque, ==, 0);
    assert_force(find(scene, out, "Right", "Pulley", TINKER_ACTING_CONSTRAINT), 0, -2 * (G + a), 1.5, 2);
    assert_force(find(scene, out, "Right", "Light", TINKER_ACTING_CONSTRAINT), 0, 2 * (G + a), 1.5, -1);
    g_autoptr(TinkerScene) oblique = physics_scene(
        NULL, "{'type': 'disc', 'name': 'Wheel', 'radius': 3, 'position': [1, 2], 'angular_velocity': 0},"
              "{'type': 'mass', 'name': 'M', 'position': [4, 6]}, {'type': 'motor', 'ends': ['M'], 'amplitude': 7, "
              "'frequency': 0, 'angle': 0}, {'type': 'cord', 'name': 'Cord', 'ends': ['Wheel', 'M']}");
    g_autoptr(GArray) pulls = acting_watch_at_start(oblique);
    const TinkerActingForce *cord = find(oblique, pulls, "Cord", "Wheel", TINKER_ACTING_CONSTRAINT);
    physics_assert_near("x", cord->x, 1 + 3 * -0.28, 1e-12);
    physics_assert_near("y", cord->y, 2 + 3 * 0.96, 1e-12);
    g_assert_cmpfloat(hypot(cord->fx, cord->fy), >, 1);
}

/* A disc of 2 kg hangs by a pin 0.2 m off its centre in a level slot of a mass, which is held: from rest the pin does
 * not fall, N (1/m + 0.2^2/I) = g. The slot's push on the mass is 3 m off that, yet nothing can turn a mass. */
static void test_torque_on_mass(void)
{
    const double inertia = 0.5 * 2 * 0.25, normal = G / (0.5 + 0.04 / inertia);
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'gravity'}, {'type': 'support', 'solid': false}, {'type': 'mass', 'name': 'M'},"
                            "{'type': 'disc', 'mass': 2, 'radius': 0.5, 'position': [2.8, 0], 'solid': false},"
                            "{'type': 'weld', 'ends': ['Support 0', 'M']},"
                            "{'type': 'slot', 'ends': ['M', {'block': 'Disc 0', 'at': [0.2, 0]}], 'angle': 0}");
    g_autoptr(GArray) out = acting_watch_at_start(scene);
    assert_force(find(scene, out, "Slot 0", "Disc 0", TINKER_ACTING_CONSTRAINT), 0, normal, 3, 0);
    const TinkerActingForce *on = find(scene, out, "Slot 0", "M", TINKER_ACTING_CONSTRAINT);
    assert_force(on, 0, -normal, 0, 0);
    g_assert_cmpfloat(on->torque, ==, 0);
}

/* A block sticks on an incline: m g cos across it and m g sin along it, where they touch. */
static void test_incline(void)
{
    double angle = 0.3, c = cos(angle), s = sin(angle), off = 0.05 + 0.2;
    g_autofree char *blocks = g_strdup_printf(
        "{'type': 'gravity'}, {'type': 'support', 'orientation': %.17g, 'width': 6, 'height': 0.1, 'static_friction': "
        "0.5, 'dynamic_friction': 0.4}, {'type': 'mass', 'mass': 2, 'position': [%.17g, %.17g], 'height': 0.4}",
        angle, -off * s + 0.5 * c, off * c + 0.5 * s);
    g_autoptr(TinkerScene) scene = physics_scene(NULL, blocks);
    g_autoptr(GArray) out = acting_watch_at_start(scene);
    double normal = 2 * G * c, friction = 2 * G * s, x = -0.05 * s + 0.5 * c, y = 0.05 * c + 0.5 * s;
    assert_force(find(scene, out, "Support 0", "Mass 0", TINKER_ACTING_NORMAL), -normal * s, normal * c, x, y);
    assert_force(find(scene, out, "Support 0", "Mass 0", TINKER_ACTING_FRICTION), friction * c, friction * s, x, y);
    assert_force(find(scene, out, "Mass 0", "Support 0", TINKER_ACTING_NORMAL), normal * s, -normal * c, x, y);
    g_assert_cmpuint(out->len, ==, 1 + 4);
}

/* Scenes without bodies, and scenes that cannot run. */
static void test_odd_scenes(void)
{
    static const char *const empty[] = {"", "{'type': 'gravity'}", "{'type': 'support'}, {'type': 'gravity'}"};
    for (gsize i = 0; i < G_N_ELEMENTS(empty); i++) {
        g_autoptr(TinkerScene) scene = physics_scene(NULL, empty[i]);
        g_autoptr(GArray) out = tinker_acting_forces_array();
        g_autoptr(GError) error = NULL;
        gboolean done = tinker_acting_forces_at_start(scene, out, &error);
        g_assert_true(done == (error == NULL));
        g_assert_cmpuint(out->len, ==, 0);
    }
    g_autoptr(TinkerScene) scene = physics_scene(NULL, "{'type': 'mass'}, {'type': 'spring', 'ends': ['Mass 0', [1, "
                                                       "1]]}");
    g_autoptr(GArray) out = tinker_acting_forces_array();
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_acting_forces_at_start(scene, out, &error));
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE);
}

static void add_tests(void)
{
    g_test_add_func("/physics/acting-forces/hanging", test_hanging);
    g_test_add_func("/physics/acting-forces/turning", test_turning);
    g_test_add_func("/physics/acting-forces/cords", test_cords);
    g_test_add_func("/physics/acting-forces/torque-on-mass", test_torque_on_mass);
    g_test_add_func("/physics/acting-forces/incline", test_incline);
    g_test_add_func("/physics/acting-forces/odd-scenes", test_odd_scenes);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
