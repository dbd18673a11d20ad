/* Starts of bodies that turn: level, spinning, rolling, put on a top. */
#include <math.h>

#include "physics/compile/compile.h"
#include "physics/model/model.h"
#include "start-offers.h"

/* A bar of 1 m that hangs on a pin at its end, 30 degrees off the vertical. */
#define HANGING_BAR                                                                                                    \
    "{'type': 'support'}, {'type': 'bar', 'position': [0.25, -0.4330127018922193], 'orientation': "                    \
    "-1.0471975511965976},"                                                                                            \
    "{'type': 'pin', 'ends': ['Support 0', {'block': 'Bar 0', 'at': [-0.5, 0]}]}"

static void assert_bar(const StartFixture *f, const char *name, double x, double y, double angle)
{
    physics_assert_near("x", start_fixture_get(f, name, TINKER_MEANING_POSITION, 0), x, 1e-9);
    physics_assert_near("y", start_fixture_get(f, name, TINKER_MEANING_POSITION, 1), y, 1e-9);
    physics_assert_near("angle", start_fixture_get(f, name, TINKER_MEANING_ORIENTATION, 0), angle, 1e-9);
}

/* It turns about its pin, the shorter way. */
static void test_turned(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(HANGING_BAR);
    start_apply(f, "Bar 0", TINKER_START_LEVEL, NULL, 0);
    assert_bar(f, "Bar 0", 0.5, 0, 0);
    g_autoptr(StartFixture) again = start_fixture_new(HANGING_BAR);
    start_apply(again, "Bar 0", TINKER_START_UPRIGHT, NULL, 0);
    assert_bar(again, "Bar 0", 0, -0.5, -G_PI / 2);
    g_autoptr(StartFixture) inclined = start_fixture_new(HANGING_BAR);
    start_apply(inclined, "Bar 0", TINKER_START_INCLINED, NULL, G_PI / 6);
    assert_bar(inclined, "Bar 0", 0.5 * cos(G_PI / 6), 0.25, G_PI / 6);
}

/* Spinning about the pin: the centre moves across the bar at half a metre; what hangs on its end goes along. */
static void test_spinning(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new(HANGING_BAR ", {'type': 'mass', 'position': [0.5, -0.8660254037844386]},"
                                      "{'type': 'pin', 'ends': [{'block': 'Bar 0', 'at': [0.5, 0]}, 'Mass 0']}");
    start_apply(f, "Bar 0", TINKER_START_SPINNING, NULL, 3);
    physics_assert_near("vx", start_fixture_get(f, "Bar 0", TINKER_MEANING_VELOCITY, 0), 1.5 * sqrt(0.75), 1e-9);
    physics_assert_near("vy", start_fixture_get(f, "Bar 0", TINKER_MEANING_VELOCITY, 1), 1.5 * 0.5, 1e-9);
    physics_assert_near("mass vx", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 0), 3 * sqrt(0.75), 1e-9);
    physics_assert_near("mass vy", start_fixture_get(f, "Mass 0", TINKER_MEANING_VELOCITY, 1), 3 * 0.5, 1e-9);
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, NULL);
    g_assert_nonnull(model);
    g_assert_cmpuint(tinker_model_warnings(model)->len, ==, 0); /* nothing had to be changed */
    g_assert_true(start_try_apply(f, "Bar 0", TINKER_START_AT_REST, NULL, 0, NULL));
    g_assert_cmpfloat(start_fixture_get(f, "Bar 0", TINKER_MEANING_ANGULAR_VELOCITY, 0), ==, 0);
}

/* Free, it spins about its centre, which keeps its velocity. */
static void test_spinning_freely(void)
{
    g_autoptr(StartFixture) f = start_fixture_new("{'type': 'disc', 'position': [0, 0], 'velocity': [2, 1]}");
    start_apply(f, "Disc 0", TINKER_START_SPINNING, NULL, 4 * G_PI);
    g_assert_cmpfloat(start_fixture_get(f, "Disc 0", TINKER_MEANING_VELOCITY, 0), ==, 2);
    g_assert_false(start_is_offered(f, "Disc 0", TINKER_START_LEVEL, NULL)); /* round */
    g_autoptr(StartFixture) mass = start_fixture_new("{'type': 'mass'}");
    g_assert_false(start_is_offered(mass, "Mass 0", TINKER_START_SPINNING, NULL));
}

#define ROUGH_INCLINE                                                                                                  \
    "{'type': 'support', 'name': 'Incline', 'position': [0, 0], 'orientation': 0.5, 'width': 6, 'height': 0.4, "       \
    "'static_friction': 0.9, 'dynamic_friction': 0.9}"

/* A disc is put onto the incline and rolls up it: the point where it touches is at rest, so it never slips. */
static void test_rolling(void)
{
    g_autoptr(StartFixture) f =
        start_fixture_new(GRAVITY ROUGH_INCLINE ", {'type': 'disc', 'radius': 0.3, 'position': [0.5, 3]}");
    start_apply(f, "Disc 0", TINKER_START_ON_TOP, NULL, 0);
    const double x = start_fixture_get(f, "Disc 0", TINKER_MEANING_POSITION, 0);
    const double y = start_fixture_get(f, "Disc 0", TINKER_MEANING_POSITION, 1);
    physics_assert_near("off the top", -x * sin(0.5) + y * cos(0.5), 0.2 + 0.3, 1e-12);
    physics_assert_near("along it", x * cos(0.5) + y * sin(0.5), 0.5 * cos(0.5) + 3 * sin(0.5), 1e-9);
    g_assert_true(start_try_apply(f, "Disc 0", TINKER_START_ROLLING, NULL, 2, NULL));
    physics_assert_near("vx", start_fixture_get(f, "Disc 0", TINKER_MEANING_VELOCITY, 0), 2 * cos(0.5), 1e-12);
    physics_assert_near("vy", start_fixture_get(f, "Disc 0", TINKER_MEANING_VELOCITY, 1), 2 * sin(0.5), 1e-12);
    physics_assert_near("rate", start_fixture_get(f, "Disc 0", TINKER_MEANING_ANGULAR_VELOCITY, 0), -2 / 0.3, 1e-12);
}

/* A box is put down with the side that it has least far to turn to; what meets no top is offered none. */
static void test_box_on_top(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(
        ROUGH_INCLINE ", {'type': 'box', 'width': 0.2, 'height': 1, 'position': [0, 2], 'orientation': 1.9},"
                      "{'type': 'bar', 'position': [1, 2]}");
    start_apply(f, "Box 0", TINKER_START_ON_TOP, NULL, 0);
    const double x = start_fixture_get(f, "Box 0", TINKER_MEANING_POSITION, 0);
    const double y = start_fixture_get(f, "Box 0", TINKER_MEANING_POSITION, 1);
    physics_assert_near("orientation", start_fixture_get(f, "Box 0", TINKER_MEANING_ORIENTATION, 0), 0.5 + G_PI / 2,
                        1e-12);
    physics_assert_near("off the top", -x * sin(0.5) + y * cos(0.5), 0.2 + 0.1, 1e-12);
    g_assert_false(start_is_offered(f, "Box 0", TINKER_START_ROLLING, NULL));
    g_assert_false(start_is_offered(f, "Bar 0", TINKER_START_ON_TOP, NULL));
}

/* At rest a bar hangs straight down from its pin, and is turned so. */
static void test_bar_at_equilibrium(void)
{
    g_autoptr(StartFixture) f = start_fixture_new(GRAVITY HANGING_BAR);
    start_apply(f, "Bar 0", TINKER_START_AT_EQUILIBRIUM, NULL, 0);
    assert_bar(f, "Bar 0", 0, -0.5, -G_PI / 2);
    g_autoptr(GError) error = NULL;
    g_autoptr(TinkerModel) model = tinker_model_new(f->scene, &error);
    g_assert_no_error(error);
}

static void add_tests(void)
{
    g_test_add_func("/start/turned", test_turned);
    g_test_add_func("/start/spinning", test_spinning);
    g_test_add_func("/start/spinning-freely", test_spinning_freely);
    g_test_add_func("/start/rolling", test_rolling);
    g_test_add_func("/start/box-on-top", test_box_on_top);
    g_test_add_func("/start/bar-at-equilibrium", test_bar_at_equilibrium);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
