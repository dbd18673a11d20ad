/* What is attached at an edge of a body stays there where the body gets another size, and what is joined follows: the
 * lengths of a mechanism can be typed in. */
#include "start-fixture.h"

#include <math.h>
#include <string.h>

#include "analysis/start/joined.h"

#define CLOSE(actual, expected) g_assert_cmpfloat_with_epsilon(actual, expected, 1e-9)

/* A bar of 2 m about a place, with a pin at each end: to what is left of it and to what is right of it. */
#define PINNED_BAR(left, place, right)                                                                                 \
    "{'type': 'bar', 'name': 'Bar', 'length': 2, 'position': [" place "]},"                                            \
    "{'type': 'pin', 'name': 'Pin', 'ends': ['" left "', {'block': 'Bar', 'at': [-1, 0]}]},"                           \
    "{'type': 'pin', 'name': 'End', 'ends': [{'block': 'Bar', 'at': [1, 0]}, '" right "']}"

/* Gives the block another width, as a field of the panel does. */
static gboolean resize(StartFixture *fixture, const char *name, double width, GError **error)
{
    const TinkerBlockId block = start_fixture_block(fixture, name);
    const TinkerPlacement before = tinker_placement_of(fixture->scene, block);
    const int32_t property = tinker_scene_block_class(fixture->scene, block)->meanings[TINKER_MEANING_WIDTH];
    tinker_history_begin(fixture->history, "Width", NULL);
    g_assert_true(tinker_history_set(fixture->history, block, property, &width, NULL));
    const gboolean followed = tinker_joined_follow(fixture->history, fixture->scene, &before, error);
    tinker_history_end(fixture->history);
    return followed;
}

static double place(const StartFixture *fixture, const char *name, int32_t component)
{
    return start_fixture_get(fixture, name, TINKER_MEANING_POSITION, component);
}

/* A bar that hangs level from its left end: longer, its centre is further out, and the mass welded to its other end
 * with it. What is attached elsewhere stays. */
static void test_edges_stay_edges(void)
{
    g_autoptr(StartFixture) fixture = start_fixture_new(
        "{'type': 'support', 'name': 'Hook', 'position': [1, 2]},"
        "{'type': 'mass', 'name': 'Bob', 'position': [3, 2]}," PINNED_BAR(
            "Hook", "2, 2",
            "Bob") ", {'type': 'marker', 'name': 'Marker', 'ends': [{'block': 'Bar', 'at': [0.25, 0]}]}");
    g_autoptr(GError) error = NULL;
    g_assert_true(resize(fixture, "Bar", 3, &error));
    g_assert_no_error(error);
    CLOSE(place(fixture, "Bar", 0), 2.5);
    CLOSE(place(fixture, "Bob", 0), 4);
    CLOSE(place(fixture, "Bob", 1), 2);
    CLOSE(tinker_scene_end(fixture->scene, start_fixture_block(fixture, "Pin"), 1).x, -1.5);
    CLOSE(tinker_scene_end(fixture->scene, start_fixture_block(fixture, "Marker"), 0).x, 0.25);
    start_fixture_assert_one_step(fixture);
}

/* A slider-crank at 90 degrees: with a longer rod the joints fit still, each link as long as it says. */
static void test_slider_crank(void)
{
    const double r = 0.5, l = 1.5, x = sqrt(l * l - r * r);
    g_autofree char *blocks = g_strdup_printf(
        "{'type': 'support', 'name': 'Bearing', 'position': [0, 0]},"
        "{'type': 'bar', 'name': 'Crank', 'length': 0.5, 'position': [0, 0.25], 'orientation': %.17g},"
        "{'type': 'bar', 'name': 'Rod', 'length': 1.5, 'position': [%.17g, 0.25], 'orientation': %.17g},"
        "{'type': 'box', 'name': 'Piston', 'position': [%.17g, 0]},"
        "{'type': 'pin', 'ends': ['Bearing', {'block': 'Crank', 'at': [-0.25, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Crank', 'at': [0.25, 0]}, {'block': 'Rod', 'at': [-0.75, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Rod', 'at': [0.75, 0]}, 'Piston']},"
        "{'type': 'slider', 'ends': ['Bearing', 'Piston']}",
        0.5 * G_PI, 0.5 * x, -asin(r / l), x);
    g_autoptr(StartFixture) fixture = start_fixture_new(blocks);
    g_autoptr(GError) error = NULL;
    g_assert_true(resize(fixture, "Rod", 1.8, &error));
    g_assert_no_error(error);
    const double pin[2] = {2 * place(fixture, "Crank", 0), 2 * place(fixture, "Crank", 1)};
    CLOSE(hypot(pin[0], pin[1]), r);
    CLOSE(hypot(place(fixture, "Piston", 0) - pin[0], pin[1]), 1.8);
    CLOSE(place(fixture, "Piston", 1), 0);
    start_fixture_assert_one_step(fixture);
}

/* Between two supports a bar has one length. */
static void test_no_room(void)
{
    g_autoptr(StartFixture) fixture = start_fixture_new(
        "{'type': 'support', 'name': 'Left', 'position': [-1, 0]},"
        "{'type': 'support', 'name': 'Right', 'position': [1, 0]}," PINNED_BAR("Left", "0, 0", "Right"));
    g_autoptr(GError) error = NULL;
    g_assert_false(resize(fixture, "Bar", 2.5, &error));
    g_assert_nonnull(error);
    g_assert_true(strstr(error->message, "Pin") != NULL || strstr(error->message, "End") != NULL);
    CLOSE(start_fixture_get(fixture, "Bar", TINKER_MEANING_WIDTH, 0), 2);
    CLOSE(tinker_scene_end(fixture->scene, start_fixture_block(fixture, "Pin"), 1).x, -1);
}

/* A four-bar linkage: its crank and its frame, its coupler and its rocker (m), the crank at an angle and the rocker's
 * pin above the line between the supports. */
#define CRANK   1.0
#define COUPLER 2.8
#define ROCKER  2.5
#define FRAME   3.0

/* Where both pins are: the second one where the circles of coupler and rocker meet. */
static void pins_at(double angle, double crank[2], double rocker[2])
{
    crank[0] = CRANK * cos(angle);
    crank[1] = CRANK * sin(angle);
    const double dx = FRAME - crank[0], dy = -crank[1], way = hypot(dx, dy);
    const double along = (COUPLER * COUPLER - ROCKER * ROCKER + way * way) / (2 * way);
    const double across = sqrt(COUPLER * COUPLER - along * along);
    rocker[0] = crank[0] + (along * dx - across * dy) / way;
    rocker[1] = crank[1] + (along * dy + across * dx) / way;
}

#define LINK "{'type': 'bar', 'name': '%s', 'length': %.17g, 'position': [%.17g, %.17g], 'orientation': %.17g},"

static char *link_between(const char *name, double x1, double y1, double x2, double y2)
{
    return g_strdup_printf(LINK, name, hypot(x2 - x1, y2 - y1), 0.5 * (x1 + x2), 0.5 * (y1 + y2),
                           atan2(y2 - y1, x2 - x1));
}

static StartFixture *driven_four_bar(double angle)
{
    double b[2], c[2];
    pins_at(angle, b, c);
    g_autofree char *crank = link_between("Crank", 0, 0, b[0], b[1]);
    g_autofree char *coupler = link_between("Coupler", b[0], b[1], c[0], c[1]);
    g_autofree char *rocker = link_between("Rocker", FRAME, 0, c[0], c[1]);
    g_autofree char *blocks = g_strconcat(
        "{'type': 'support', 'name': 'A', 'position': [0, 0]}, {'type': 'support', 'name': 'D', 'position': [3, 0]},",
        crank, coupler, rocker,
        "{'type': 'pin', 'ends': ['A', {'block': 'Crank', 'at': [-0.5, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Crank', 'at': [0.5, 0]}, {'block': 'Coupler', 'at': [-1.4, 0]}]},"
        "{'type': 'pin', 'ends': [{'block': 'Coupler', 'at': [1.4, 0]}, {'block': 'Rocker', 'at': [1.25, 0]}]},"
        "{'type': 'pin', 'ends': ['D', {'block': 'Rocker', 'at': [-1.25, 0]}]},"
        "{'type': 'drive', 'ends': ['Crank', 'A'], 'speed': 2}",
        NULL);
    return start_fixture_new(blocks);
}

/* Moves a body as a hand does that holds it by a place of its axes. */
static void drag_to(StartFixture *fixture, const char *name, const double grip[2], const double hand[2])
{
    const TinkerBlockId block = start_fixture_block(fixture, name);
    const TinkerPlacement before = tinker_placement_of(fixture->scene, block);
    const double c = cos(before.orientation), s = sin(before.orientation);
    const double to[2] = {hand[0] - (c * grip[0] - s * grip[1]), hand[1] - (s * grip[0] + c * grip[1])};
    const int32_t property = tinker_scene_block_class(fixture->scene, block)->meanings[TINKER_MEANING_POSITION];
    g_autoptr(GError) error = NULL;
    g_assert_true(tinker_history_set(fixture->history, block, property, to, NULL));
    g_assert_true(tinker_joined_follow_hand(fixture->history, fixture->scene, &before, grip, hand, &error));
    g_assert_no_error(error);
}

static double turn(const StartFixture *fixture, const char *name)
{
    return start_fixture_get(fixture, name, TINKER_MEANING_ORIENTATION, 0);
}

/* A crank that a drive turns is played by hand: held at its free end, a quarter of its length from the bearing, or
 * beside it, it points to the hand, and coupler and rocker are where circles meet. */
static void test_driven_crank_by_hand(void)
{
    static const double grips[] = {0.5, -0.25, 0.1};
    double b[2], c[2];
    for (gsize k = 0; k < G_N_ELEMENTS(grips); k++) {
        g_autoptr(StartFixture) fixture = driven_four_bar(G_PI / 3);
        tinker_history_begin(fixture->history, "Drag", NULL);
        for (int i = 1; i <= 12; i++) {
            const double angle = G_PI / 3 + 0.2 * i, out = (0.5 + grips[k]) * (i % 2 ? 1.3 : 0.8);
            drag_to(fixture, "Crank", (double[]){grips[k], 0}, (double[]){out * cos(angle), out * sin(angle)});
            pins_at(angle, b, c);
            g_assert_cmpfloat_with_epsilon(turn(fixture, "Crank"), angle, 1e-6);
            g_assert_cmpfloat_with_epsilon(2 * place(fixture, "Crank", 0), b[0], 1e-6);
            g_assert_cmpfloat_with_epsilon(place(fixture, "Coupler", 0), 0.5 * (b[0] + c[0]), 1e-6);
            g_assert_cmpfloat_with_epsilon(place(fixture, "Coupler", 1), 0.5 * (b[1] + c[1]), 1e-6);
            g_assert_cmpfloat_with_epsilon(turn(fixture, "Rocker"), atan2(c[1], c[0] - FRAME), 1e-6);
        }
        tinker_history_end(fixture->history);
        start_fixture_assert_one_step(fixture);
    }
}

static void add_tests(void)
{
    g_test_add_func("/joined/driven-crank-by-hand", test_driven_crank_by_hand);
    g_test_add_func("/joined/edges-stay-edges", test_edges_stay_edges);
    g_test_add_func("/joined/slider-crank", test_slider_crank);
    g_test_add_func("/joined/no-room", test_no_room);
}

int main(int argc, char **argv)
{
    return physics_main(argc, argv, add_tests);
}
