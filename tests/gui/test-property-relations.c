/* Rows of the property list that reach beyond the block's own values: its local coordinates, its connections, a length
 * that is left to the drawing, and the motion of a support. */
#include "panel-fixture.h"

static void test_offset(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS);
    panel_select(fixture, "Mass 0");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Offset (Local Coordinates)", "Y", "-1 m");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 1), 1.4, 1e-15);
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "position", 0), ==, 3.2);
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "local_origin", 0), ==, 3.2);
    g_assert_cmpfloat(panel_stored(fixture, "Mass 0", "local_origin", 1), ==, 2.4);
    panel_assert_shown(fixture, "Offset (Local Coordinates)", "Y", "-1.00000 m");
    panel_assert_shown(fixture, "Global Position", "Y", "1.40000 m");
    panel_assert_undoes(fixture, before);

    /* From then on the origin stays, and the place alone makes the offset. */
    panel_type(fixture, "Global Position", "Y", "2.9 m");
    panel_assert_shown(fixture, "Offset (Local Coordinates)", "Y", "0.50000 m");
}

/* A spring whose rest length was left to the drawing is stretched by an offset, as far as that leads: by 1 m straight
 * away from the support above. */
static void test_offset_stretches(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new("{'type': 'mass', 'name': 'Mass 0', 'position': [0, 2]}," ONE_SUPPORT "," ONE_SPRING);
    panel_select(fixture, "Mass 0");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Offset (Local Coordinates)", "Y", "-1 m");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Mass 0", "position", 1), 1, 1e-15);
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "Spring 0", "rest_length", 0), 2, 1e-15);
    panel_assert_undoes(fixture, before);
}

static void test_ends(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_MASS "," ONE_SUPPORT "," ONE_SPRING);
    TinkerScene *scene = tinker_document_scene(fixture->document);
    TinkerBlockId spring = gui_fixture_block(fixture, "Spring 0");
    panel_select(fixture, "Spring 0");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Connections", "End 2", "");
    TinkerSceneEnd end = tinker_scene_end(scene, spring, 1);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(end.x, 3.2, 1e-15);
    g_assert_cmpfloat_with_epsilon(end.y, 2.4, 1e-15);
    panel_assert_undoes(fixture, before);
    panel_assert_shown(fixture, "Connections", "End 2", "");
    panel_assert_refused(fixture, "Connections", "End 2", "Mass 1", PARTS("Mass 1", "did you mean “Mass 0”"));
    panel_assert_refused(fixture, "Connections", "End 2", "Spring 0", PARTS("itself"));
    panel_type(fixture, "Connections", "End 2", "Mass 0");
    g_assert_cmpint(tinker_scene_end(scene, spring, 1).block, ==, gui_fixture_block(fixture, "Mass 0"));
}

/* Where on a body that turns, or on a support, an end is can be typed; a point mass has no places. A pin takes its body
 * along: 0.25 m from the centre of a bar that lies along x, the bar's centre is 0.25 m from the support. */
static void test_places_of_ends(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(
        "{'type': 'support', 'name': 'S'}, {'type': 'bar', 'name': 'B', 'position': [0.5, 0]},"
        "{'type': 'mass', 'name': 'M', 'position': [3, 3]}, {'type': 'marker', 'name': 'P', 'ends': ['B']},"
        "{'type': 'pin', 'name': 'Pin', 'ends': ['S', {'block': 'B', 'at': [-0.5, 0]}]},"
        "{'type': 'spring', 'name': 'K', 'ends': ['B', 'M']}");
    TinkerScene *scene = tinker_document_scene(fixture->document);
    panel_select(fixture, "P");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_assert_shown(fixture, "Connections", "End X", "0.00000 m");
    panel_type(fixture, "Connections", "End X", "30 cm");
    const TinkerSceneEnd on_bar = tinker_scene_end(scene, gui_fixture_block(fixture, "P"), 0);
    g_assert_cmpint(on_bar.block, ==, gui_fixture_block(fixture, "B"));
    g_assert_cmpfloat_with_epsilon(on_bar.x, 0.3, 1e-15);
    g_assert_cmpfloat(on_bar.y, ==, 0);
    g_assert_cmpfloat(panel_stored(fixture, "B", "position", 0), ==, 0.5);
    panel_assert_undoes(fixture, before);
    panel_assert_refused(fixture, "Connections", "End Y", "1 kg", PARTS("length"));

    panel_select(fixture, "Pin");
    g_autofree char *marked = gui_fixture_text(fixture);
    panel_assert_shown(fixture, "Connections", "End 2 X", "-0.50000 m");
    panel_type(fixture, "Connections", "End 2 X", "-0.25");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "B", "position", 0), 0.25, 1e-9);
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "B", "position", 1), 0, 1e-9);
    tinker_document_undo(fixture->document); /* one step */
    g_autofree char *undone = gui_fixture_text(fixture);
    g_assert_cmpstr(undone, ==, marked);
    panel_type(fixture, "Connections", "End 1 Y", "0.1");
    const double turn = panel_stored(fixture, "B", "orientation", 0);
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "B", "position", 0) - 0.5 * cos(turn), 0, 1e-9);
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, "B", "position", 1) - 0.5 * sin(turn), 0.1, 1e-9);
    panel_select(fixture, "K");
    g_autoptr(TinkerPropertyRow) none = panel_find_row(fixture, "Connections", "End 2 X");
    g_assert_null(none);
}

static void test_as_placed(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new("{'type': 'mass', 'name': 'Mass 0', 'position': [3, 0]}," ONE_SUPPORT "," ONE_SPRING);
    panel_select(fixture, "Spring 0");
    panel_assert_shown(fixture, "Spring Properties", "Undeformed Length", "5.00000 m");
    g_autofree char *before = gui_fixture_text(fixture);
    panel_type(fixture, "Spring Properties", "Undeformed Length", "4");
    g_assert_cmpfloat(panel_stored(fixture, "Spring 0", "rest_length", 0), ==, 4);
    panel_type(fixture, "Spring Properties", "Undeformed Length", "");
    g_autofree char *after = gui_fixture_text(fixture);
    g_assert_cmpstr(after, ==, before);
}

static void test_motion(void)
{
    g_autoptr(GuiFixture) fixture = gui_fixture_new(ONE_SUPPORT "," ONE_MASS);
    TinkerScene *scene = tinker_document_scene(fixture->document);
    panel_select(fixture, "Mass 0");
    g_autoptr(TinkerPropertyRow) none = panel_find_row(fixture, "Motion", "Type");
    g_assert_null(none); /* what can move has no motion of its own */

    panel_select(fixture, "Support 0");
    g_autofree char *before = gui_fixture_text(fixture);
    g_autoptr(TinkerPropertyRow) type = panel_find_row(fixture, "Motion", "Type"),
                                 amplitude = panel_find_row(fixture, "Motion", "Amplitude");
    g_assert_nonnull(type);
    g_assert_null(amplitude);
    g_assert_cmpstr(type->choices[type->chosen], ==, "None");

    panel_choose(fixture, "Motion", "Type", "Cosine");
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 3);
    TinkerBlockId motion = tinker_scene_block_at(scene, 2);
    g_assert_cmpint(tinker_scene_end(scene, motion, 0).block, ==, gui_fixture_block(fixture, "Support 0"));
    panel_assert_undoes(fixture, before);
    panel_assert_shown(fixture, "Motion", "Amplitude", "0.00000 m");
    panel_assert_shown(fixture, "Motion", "Frequency", "0.00000 rad/s");
    panel_type(fixture, "Motion", "Amplitude", "10 cm");
    g_assert_cmpfloat_with_epsilon(panel_stored(fixture, tinker_scene_block_name(scene, motion), "amplitude", 0), 0.1,
                                   1e-15);
    panel_assert_sensitive(fixture, "Motion", "Frequency", TRUE);

    panel_choose(fixture, "Motion", "Type", "Expression");
    panel_assert_shown(fixture, "Motion", "Expression", "0.1*cos(0*t)");
    panel_assert_sensitive(fixture, "Motion", "Amplitude", FALSE);
    panel_assert_sensitive(fixture, "Motion", "Angle", TRUE);
    panel_type(fixture, "Motion", "Expression", "0.2*sin(t)^2");
    panel_assert_refused(fixture, "Motion", "Expression", "0.2*sine(t)", PARTS("sin"));
    panel_choose(fixture, "Motion", "Type", "None");
    panel_assert_sensitive(fixture, "Motion", "Frequency", FALSE);
    g_assert_cmpint(tinker_scene_block_count(scene), ==, 3);
}

/* A second motion of the same support has a group of its own, and each row sets its own block. */
static void test_two_motions(void)
{
    g_autoptr(GuiFixture) fixture =
        gui_fixture_new(ONE_SUPPORT ", {'type': 'support-motion', 'name': 'A', 'ends': ['Support 0']},"
                                    "{'type': 'support-motion', 'name': 'B', 'ends': ['Support 0']}");
    panel_select(fixture, "Support 0");
    panel_type(fixture, "Motion", "Amplitude", "1");
    panel_type(fixture, "Motion (B)", "Amplitude", "2");
    g_assert_cmpfloat(panel_stored(fixture, "A", "amplitude", 0), ==, 1);
    g_assert_cmpfloat(panel_stored(fixture, "B", "amplitude", 0), ==, 2);
}

static void add_tests(void)
{
    g_test_add_func("/gui/property-list/offset", test_offset);
    g_test_add_func("/gui/property-list/offset-stretches", test_offset_stretches);
    g_test_add_func("/gui/property-list/ends", test_ends);
    g_test_add_func("/gui/property-list/places-of-ends", test_places_of_ends);
    g_test_add_func("/gui/property-list/as-placed", test_as_placed);
    g_test_add_func("/gui/property-list/motion", test_motion);
    g_test_add_func("/gui/property-list/two-motions", test_two_motions);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
