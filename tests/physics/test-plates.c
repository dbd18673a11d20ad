/* Plates: moments of inertia and centres of mass by closed forms, swinging, what is no outline, and corners in scenes.
 */
#include "contact-checks.h"
#include "physics-fixture.h"

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "scene/read/scene-json.h"

#include <math.h>
#include <string.h>

/* Rotational energy of a plate of 3 kg that turns with 2 rad/s: twice its inertia. */
static double inertia_of(const char *properties)
{
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.columns = "Plate 0.rotational energy"},
        "{'type': 'plate', 'position': [0, 0], 'mass': 3, 'angular_velocity': 2, 'solid': false, %s}", properties);
    return physics_last(run, 0) / 2;
}

/* Rectangles m (w^2 + h^2) / 12, in either direction round and wherever their axes begin; right triangles
 * m (b^2 + h^2) / 18; a bracket of two rectangles by the parallel axis theorem; about another centre, Steiner. */
static void test_inertias(void)
{
    const double rectangle = 3 * (0.64 + 0.25) / 12;
    physics_assert_near("rectangle", inertia_of("'corners': [[0, 0], [0.8, 0], [0.8, 0.5], [0, 0.5]]"), rectangle,
                        1e-15);
    physics_assert_near("clockwise", inertia_of("'corners': [[0, 0.5], [0.8, 0.5], [0.8, 0], [0, 0]]"), rectangle,
                        1e-15);
    physics_assert_near("far", inertia_of("'corners': [[1e4, 7], [10000.8, 7], [10000.8, 7.5], [1e4, 7.5]]"), rectangle,
                        1e-11);
    physics_assert_near("triangle", inertia_of("'corners': [[0, 0], [1.2, 0], [0, 0.7]]"), 3 * (1.44 + 0.49) / 18,
                        1e-15);
    /* 1 x 0.5 below, 0.5 x 0.5 above its left half: masses 2 and 1, centroids 0.25 apart either way */
    const double bracket = 2 * (1 + 0.25) / 12 + 1 * 0.5 / 12 + (2.0 / 3) * (0.0625 + 0.25);
    const char *corners = "'corners': [[0, 0], [1, 0], [1, 0.5], [0.5, 0.5], [0.5, 1], [0, 1]]";
    physics_assert_near("bracket", inertia_of(corners), bracket, 1e-14);
    g_autofree char *elsewhere = g_strdup_printf("%s, 'centre_of_mass': [0, 0]", corners);
    const double x = (2 * 0.5 + 0.25) / 3, y = (2 * 0.25 + 0.75) / 3;
    physics_assert_near("elsewhere", inertia_of(elsewhere), bracket + 3 * (x * x + y * y), 1e-14);
    physics_assert_near("given", inertia_of("'inertia': 0.7"), 0.7, 0);
    physics_assert_near("in feet", inertia_of("'corners': [['1 ft', 0], ['1 ft', '1 ft'], [0, '1 ft'], [0, 0]]"),
                        3 * 0.3048 * 0.3048 / 6, 1e-15);
}

/* A square of side 1 that hangs from the middle of its upper edge swings with w^2 = m g d / (I + m d^2). */
static void test_swings(void)
{
    const double d = 0.5, amplitude = 1e-5, omega = sqrt(9.81 * d / (1.0 / 6 + d * d));
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 3, .columns = "Plate 0.angle"},
                    "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [0, 0]},"
                    "{'type': 'plate', 'mass': 3, 'position': [%.17g, %.17g], 'orientation': %.17g, 'solid': false,"
                    " 'corners': [[3, 1], [4, 1], [4, 2], [3, 2]]},"
                    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Plate 0', 'at': [0, 0.5]}]}",
                    d * sin(amplitude), -d * cos(amplitude), amplitude);
    for (gsize i = 0; i < physics_samples(run); i++)
        physics_assert_near("angle", physics_value(run, i, 0), amplitude * cos(omega * physics_time(run, i)), 5e-12);
}

static void test_refusals(void)
{
    static const struct {
        const char *corners, *why;
    } cases[] = {{"[[0, 0], [1, 0]]", "fewer than 3"},
                 {"[[0, 0], [1, 1], [2, 2]]", "no area"},
                 {"[[0, 0], [1, 1], [1, 0], [0, 2]]", "crosses or touches itself"},
                 {"[[0, 0], [1, 1], [1, 0], [0, 1]]", "crosses or touches itself"},
                 {"[[0, 0], [2, 0], [2, 1], [1, 0], [0, 1]]", "crosses or touches itself"}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autoptr(PhysicsRun) run =
            physics_try(&(PhysicsOptions){0}, "{'type': 'plate', 'position': [0, 0], 'corners': %s}", cases[i].corners);
        physics_assert_refused(run, TINKER_MODEL_ERROR_SCENE, "Plate 0", cases[i].why, NULL);
    }
}

/* Corners that are read are written as they were; what is typed in the window is a text, and written as points. */
static void test_scene(void)
{
    g_autoptr(TinkerScene) scene =
        physics_scene(NULL, "{'type': 'plate', 'position': [0, 0], 'corners': [[0, 0], [0.1, 0], ['1 ft', 2e-5]]}");
    const TinkerBlockId plate = tinker_scene_block_at(scene, 0);
    const int32_t corners = tinker_block_class_property(tinker_scene_block_class(scene, plate), "corners");
    g_assert_cmpstr(tinker_scene_get_text(scene, plate, corners), ==, "0 0; 0.1 0; 0.3048 2e-05");
    g_autofree char *text = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(text, "\"corners\": [[0, 0], [0.1, 0], [0.3048, 2e-05]]"));
    tinker_scene_set_text(scene, plate, corners, "1 ft, 0; 2 ft, 0;0 1 ; ");
    g_autofree char *typed = tinker_scene_to_text(scene, TINKER_WRITE_SI);
    g_assert_nonnull(strstr(typed, "\"corners\": [[0.3048, 0], [0.6096, 0], [0, 1]]"));
    tinker_scene_set_text(scene, plate, corners, "0 0; 1; 1 1");
    g_autoptr(GError) error = NULL;
    TinkerModel *model = tinker_model_new(scene, &error);
    g_assert_null(model);
    g_assert_error(error, TINKER_MODEL_ERROR, TINKER_MODEL_ERROR_SCENE);
    g_assert_nonnull(strstr(error->message, "Plate 0: corners: point 2"));
}

/* Contact ---------------------------------------------------------------------------------------------------------- */

#define FLOOR "{'type': 'gravity'}, {'type': 'support', 'name': 'floor', 'position': [0, -0.2], 'width': 20},"

static PhysicsRun *throw_it(const char *shape)
{
    return physics_run(
        &(PhysicsOptions){.duration = 1.2, .columns = "it.x,it.y,it.angle,it.vx,it.vy,it.angular velocity"},
        FLOOR "{'name': 'it', 'mass': 2, %s, 'position': [0, 1], 'orientation': 0.4, 'velocity': [1, 0],"
              " 'angular_velocity': 2, 'restitution': 0.4},"
              "{'type': 'disc', 'name': 'other', 'position': [1.2, 0.4]}",
        shape);
}

/* A box, and a plate with its corners, are thrown and meet a floor and a disc: they move as one, to rounding, from
 * whichever corner the outline begins and either way round, and with corners that are none. */
static void test_as_a_box(void)
{
    static const char *const outlines[] = {
        "[[0, 0], [0.8, 0], [0.8, 0.5], [0, 0.5]]",
        "[[0.8, 0.5], [0.8, 0], [0, 0], [0, 0.5]]",
        "[[0, 0], [0.3, 0], [0.8, 0], [0.8, 0.5], [0.5, 0.5], [0, 0.5]]",
    };
    g_autoptr(PhysicsRun) box = throw_it("'type': 'box', 'width': 0.8, 'height': 0.5");
    g_assert_cmpuint(box->summary->events->len, >, 6);
    for (gsize k = 0; k < G_N_ELEMENTS(outlines); k++) {
        g_autofree char *shape = g_strdup_printf("'type': 'plate', 'corners': %s", outlines[k]);
        g_autoptr(PhysicsRun) plate = throw_it(shape);
        g_assert_cmpuint(plate->summary->events->len, ==, box->summary->events->len);
        for (gsize i = 0; i < physics_samples(box); i++)
            for (gsize column = 0; column < 6; column++)
                physics_assert_near("pose", physics_value(plate, i, column), physics_value(box, i, column), 1e-10);
    }
}

/* An L of two rectangles 1 x 0.2 and 0.2 x 0.8 stands on its longer leg, which presses with its weight and stays; on
 * its shorter end, whose centre of mass is beside it, it falls over. */
static void test_angle(void)
{
    const double area = 0.2 + 0.16, x = (0.2 * 0.5 + 0.16 * 0.1) / area, y = (0.2 * 0.1 + 0.16 * 0.6) / area;
    const char *corners = "'corners': [[0, 0], [1, 0], [1, 0.2], [0.2, 0.2], [0.2, 1], [0, 1]]";
    g_autoptr(PhysicsRun) stands =
        physics_run(&(PhysicsOptions){.duration = 2, .columns = "it.x,it.y,it.angle,floor.normal force"},
                    FLOOR "{'type': 'plate', 'name': 'it', 'mass': 3, %s, 'position': [%.17g, %.17g]}", corners, x, y);
    for (gsize i = 0; i < physics_samples(stands); i++) {
        physics_assert_near("x", physics_value(stands, i, 0), x, 1e-14);
        physics_assert_near("y", physics_value(stands, i, 1), y, 1e-14);
        physics_assert_near("angle", physics_value(stands, i, 2), 0, 1e-14);
        physics_assert_near("weight", fabs(physics_value(stands, i, 3)), 3 * 9.81, 1e-11);
    }
    /* upside down: (x, y) -> (-x, 1 - y), on the end of 0.2 m */
    g_autoptr(PhysicsRun) falls = physics_run(
        &(PhysicsOptions){.duration = 2, .columns = "it.y,it.angle"},
        FLOOR "{'type': 'plate', 'name': 'it', 'mass': 3, %s, 'position': [%.17g, %.17g], 'orientation': %.17g}",
        corners, -x, 1 - y, G_PI);
    g_assert_cmpfloat(x, >, 0.2);
    g_assert_cmpfloat(fabs(physics_last(falls, 1) - G_PI), >, 0.3);
    g_assert_cmpfloat(falls->summary->energy_balance_error, <, 1e-9);
}

/* An arch falls over a disc that stands in its opening with room on all sides: to where its hull is full, and it is
 * not. It lands on both feet at sqrt(2 h / g), and the disc never moves. */
static void test_arch(void)
{
    const char *arch =
        "'corners': [[-0.7, 0], [-0.5, 0], [-0.5, 0.9], [0.5, 0.9], [0.5, 0], [0.7, 0], [0.7, 1.1], [-0.7,"
        " 1.1]], 'centre_of_mass': [0, 0]";
    const double h = 1.5, fall = sqrt(2 * h / 9.81);
    g_autoptr(PhysicsRun) run =
        physics_run(&(PhysicsOptions){.duration = 1, .columns = "it.x,it.y,it.angle,in.x,in.y,in.angle"},
                    FLOOR "{'type': 'plate', 'name': 'it', %s, 'position': [0, %.17g]},"
                          "{'type': 'disc', 'name': 'in', 'radius': 0.4, 'position': [0, 0.4]}",
                    arch, h);
    contact_assert_event(run, "rest", "it, floor", fall, 1e-12);
    g_assert_cmpuint(run->summary->events->len, ==, 1);
    const double rest[] = {0, 0, 0, 0, 0.4, 0};
    for (gsize column = 0; column < 6; column++)
        physics_assert_near("rest", physics_last(run, column), rest[column], 1e-14);
    for (gsize i = 0; physics_time(run, i) < fall; i++)
        physics_assert_near("falling", physics_value(run, i, 1),
                            h - 0.5 * 9.81 * physics_time(run, i) * physics_time(run, i), 1e-13);
}

/* A disc comes to rest in the notch of a V of 90 degrees that stands on the floor, where it touches both sides: each
 * presses with m g cos 45 without friction. */
static void test_notch(void)
{
    const double reach = 0.3 * sqrt(2);
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = 1, .columns = "in.x,in.y,V.y,floor.normal force,in.contact force"},
        FLOOR "{'type': 'plate', 'name': 'V', 'mass': 5, 'corners': [[-1, 0], [1, 0], [1, 1.2], [0, 0.2], [-1, 1.2]],"
              " 'centre_of_mass': [0, 0], 'position': [0, 0], 'static_friction': 0, 'dynamic_friction': 0},"
              "{'type': 'disc', 'name': 'in', 'mass': 2, 'radius': 0.3, 'position': [0, %.17g], 'static_friction': 0,"
              " 'dynamic_friction': 0}",
        0.2 + reach);
    physics_assert_near("x", physics_last(run, 0), 0, 1e-13);
    physics_assert_near("y", physics_last(run, 1), 0.2 + reach, 1e-13);
    physics_assert_near("V", physics_last(run, 2), 0, 1e-13);
    physics_assert_near("all", fabs(physics_last(run, 3)), 7 * 9.81, 1e-11);
    physics_assert_near("disc", physics_last(run, 4), 2 * 9.81, 1e-11);
}

/* An L that stands still, its inner corner at (0, 0), without friction. */
#define INNER                                                                                                          \
    "{'type': 'support', 'name': 'anchor', 'position': [-0.5, -0.5], 'solid': false},"                                 \
    "{'type': 'plate', 'name': 'L', 'corners': [[-1, -1], [2, -1], [2, 0], [0, 0], [0, 2], [-1, 2]],"                  \
    " 'centre_of_mass': [-0.5, -0.5], 'position': [-0.5, -0.5], 'static_friction': 0, 'dynamic_friction': 0},"         \
    "{'type': 'weld', 'ends': ['anchor', 'L']},"

/* An arrow flies with its tip ahead into the inner corner of an L, along the line that halves it, and comes back as it
 * came with e = 1. A box that slides along the foot of the L meets its wall, and slides back half as fast. */
static void test_inner_corner(void)
{
    const double far = 0.5, centre = (far + 1.0 / 3) / sqrt(2), speed = 1 / sqrt(2);
    g_autoptr(PhysicsRun) arrow =
        physics_run(&(PhysicsOptions){.duration = 2 * far, .columns = "it.x,it.y,it.vx,it.vy,it.angle"},
                    INNER "{'type': 'plate', 'name': 'it', 'corners': [[0, 0], [0.5, -0.15], [0.5, 0.15]],"
                          " 'restitution': 1, 'position': [%.17g, %.17g], 'orientation': %.17g,"
                          " 'velocity': [%.17g, %.17g]}",
                    centre, centre, G_PI / 4, -speed, -speed);
    contact_assert_event(arrow, "impact", "L, it", far, 1e-12);
    const double back[] = {centre, centre, speed, speed, G_PI / 4};
    for (gsize column = 0; column < G_N_ELEMENTS(back); column++)
        physics_assert_near("arrow", physics_last(arrow, column), back[column], 1e-12);
    g_autoptr(PhysicsRun) box = physics_run(
        &(PhysicsOptions){.duration = 2, .columns = "it.x,it.y,it.vx,it.angle"},
        "{'type': 'gravity'}," INNER "{'type': 'box', 'name': 'it', 'width': 0.4, 'height': 0.4, 'restitution': 0.5,"
        " 'position': [1, 0.2], 'velocity': [-1, 0]}");
    contact_assert_event(box, "impact", "L, it", 0.8, 1e-12);
    const double slid[] = {0.2 + 1.2 * 0.5, 0.2, 0.5, 0};
    for (gsize column = 0; column < G_N_ELEMENTS(slid); column++)
        physics_assert_near("box", physics_last(box, column), slid[column], 1e-12);
}

/* A notch is refused where contacts are impulses; a plate without one is not. */
static void test_impulses(void)
{
    static const char *const corners[] = {"[[0, 0], [1, 0], [1, 1], [0.5, 0.2]]", "[[0, 0], [1, 0], [0, 1]]"};
    for (gsize i = 0; i < G_N_ELEMENTS(corners); i++) {
        g_autoptr(PhysicsRun) run =
            physics_try(&(PhysicsOptions){.duration = 0.1, .step = 0.01, .impulses = TRUE},
                        FLOOR "{'type': 'plate', 'position': [0, 2], 'corners': %s}", corners[i]);
        if (i == 0) physics_assert_refused(run, TINKER_MODEL_ERROR_METHOD, "Plate 0", "turn inwards", NULL);
        g_assert_cmpint(run->error == NULL, ==, i == 1);
    }
}

/* A disc of 1 kg and radius R in a notch of two edges at 45 degrees, of a plate that is held, with a torque M = t: both
 * edges hold it until M = mu m g R / ((1 + mu^2) cos 45), then both rub, M less that on it from there on. */
static void test_turned_in_notch(void)
{
    const double radius = 0.5, friction = 0.5, end = 4, inertia = 0.5 * radius * radius;
    const double most = friction * 9.81 * radius / ((1 + friction * friction) * sqrt(0.5));
    g_autoptr(PhysicsRun) run = physics_run(
        &(PhysicsOptions){.duration = end, .columns = "Disc 0.angular velocity"},
        "{'type': 'gravity'}, {'type': 'support', 'solid': false, 'position': [0, -1]},"
        "{'type': 'plate', 'corners': [[0, 0], [-2, 2], [-2, -1], [2, -1], [2, 2]], 'centre_of_mass': [0, 0],"
        " 'inertia': 1, 'position': [0, 0], 'static_friction': %g, 'dynamic_friction': %g},"
        "{'type': 'weld', 'ends': ['Support 0', {'block': 'Plate 0', 'at': [0, -1]}]},"
        "{'type': 'disc', 'radius': %g, 'position': [0, %.17g]},"
        "{'type': 'torque', 'ends': ['Disc 0'], 'waveform': {'expression': 't'}}",
        friction, friction, radius, radius / sqrt(0.5));
    contact_assert_event(run, "slip", NULL, most, 1e-9);
    const double turned = 0.5 * (end * end - most * most) - most * (end - most);
    physics_assert_near("rate", physics_last(run, 0), turned / inertia, 1e-8);
}

static void add_tests(void)
{
    g_test_add_func("/plates/inertias", test_inertias);
    g_test_add_func("/plates/swings", test_swings);
    g_test_add_func("/plates/refusals", test_refusals);
    g_test_add_func("/plates/scene", test_scene);
    g_test_add_func("/plates/as-a-box", test_as_a_box);
    g_test_add_func("/plates/angle", test_angle);
    g_test_add_func("/plates/arch", test_arch);
    g_test_add_func("/plates/notch", test_notch);
    g_test_add_func("/plates/turned-in-notch", test_turned_in_notch);
    g_test_add_func("/plates/inner-corner", test_inner_corner);
    g_test_add_func("/plates/impulses", test_impulses);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
