/* Ends that are dragged onto blocks, and joints that are put on bodies. */
#include "drag-stage.h"

/* Over a body the end tells which one; away from it, nothing; released over it, it is connected to its centre. */
static void test_connect(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "S", 1, 2, 2);
    g_assert_cmpint(tinker_drag_to(drag, 2.9, 0.2, 0, REACH), ==, stage_block(stage, "B"));
    g_assert_cmpint(tinker_drag_to(drag, 3, 2, 0, REACH), ==, TINKER_NO_BLOCK);
    g_assert_cmpint(tinker_drag_to(drag, 3.1, -0.1, 0, REACH), ==, stage_block(stage, "B"));
    tinker_drag_end(drag, TRUE, 0);
    TinkerSceneEnd end = tinker_scene_end(stage->scene, stage_block(stage, "S"), 1);
    g_assert_cmpint(end.block, ==, stage_block(stage, "B"));
    g_assert_cmpfloat(end.x, ==, 0);
    g_assert_cmpfloat(end.y, ==, 0);
    tinker_history_undo(stage->history);
    stage_expect_untouched(stage);
}

/* To a point of a support that is turned by a right angle: its own x axis is the world's y axis. */
static void test_connect_at_point(Stage *stage, gconstpointer data)
{
    for (int at_point = 0; at_point < 2; at_point++) {
        TinkerDrag *drag = stage_grab(stage, "S", 1, 2, 2);
        g_assert_cmpint(tinker_drag_to(drag, 0.1, -2, 0, REACH), ==, stage_block(stage, "Floor"));
        tinker_drag_end(drag, at_point, 0);
        TinkerSceneEnd end = tinker_scene_end(stage->scene, stage_block(stage, "S"), 1);
        g_assert_cmpint(end.block, ==, stage_block(stage, "Floor"));
        g_assert_cmpfloat_with_epsilon(end.x, at_point ? 1 : 0, 1e-12);
        g_assert_cmpfloat_with_epsilon(end.y, at_point ? -0.1 : 0, 1e-12);
        tinker_history_undo(stage->history);
    }
}

/* A bar from (5, 0) to (6, 0), and one over its right end, turned by a right angle: (6, 0) to (6, 1). */
static TinkerScene *bars(void)
{
    return scene_fixture_read_blocks(
        "{\"type\": \"bar\", \"name\": \"Lower\", \"position\": [5.5, 0]},"
        "{\"type\": \"bar\", \"name\": \"Upper\", \"position\": [6, 0.5], \"orientation\": \"90 deg\"},"
        "{\"type\": \"mass\", \"name\": \"Point\", \"position\": [5.2, 0.02], \"width\": 0, \"height\": 0},"
        "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"Point\", [2, 2]]},"
        "{\"type\": \"pin\", \"name\": \"Pin\", \"ends\": [[9, 9], [9, 9]]}");
}

static void expect_end(TinkerScene *scene, const char *name, int32_t number, const char *block, double x, double y)
{
    const TinkerSceneEnd end = tinker_scene_end(scene, tinker_scene_find_block(scene, name), number);
    g_assert_cmpstr(tinker_scene_block_name(scene, end.block), ==, block);
    g_assert_cmpfloat_with_epsilon(end.x, x, 1e-12);
    g_assert_cmpfloat_with_epsilon(end.y, y, 1e-12);
}

/* On a body that turns an end stays where it is dropped, or goes to the centre or the end that is near. */
static void test_connect_to_what_turns(Stage *stage, gconstpointer data)
{
    static const double rows[][3] = {{0.8, 0.02, 0.3}, {0.55, 0.02, 0}, {0.96, 0.01, -0.5}}; /* from (5, 0); own x */
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(TinkerScene) scene = bars();
        TinkerHistory *history = tinker_history_new(scene);
        TinkerDrag *drag = tinker_drag_begin(history, scene, (TinkerHit){tinker_scene_find_block(scene, "S"), 1}, 2, 2);
        tinker_drag_to(drag, 5 + rows[i][0], rows[i][1], 0, REACH);
        tinker_drag_end(drag, FALSE, 0);
        expect_end(scene, "S", 1, i == 2 ? "Upper" : "Lower", rows[i][2], i == 0 ? rows[i][1] : 0);
        tinker_history_free(history);
    }
}

/* A mass of height 0.8 lies 2 m up the top, 0.1 above the middle, of an incline of 3 : 4. The end of its spring that is
 * dropped lower down is as far off the top as the mass's centre, so that the spring is parallel to it; with Shift held
 * it is where it was dropped. */
static void test_connect_along_top(Stage *stage, gconstpointer data)
{
    for (int at_point = 0; at_point < 2; at_point++) {
        g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
            "{\"type\": \"support\", \"name\": \"Incline\", \"orientation\": 0.6435011087932844, \"width\": 8, "
            "\"height\": 0.2},"
            "{\"type\": \"mass\", \"name\": \"Block\", \"on\": \"Incline\", \"along\": 2, \"height\": 0.8},"
            "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"Block\", [3, -3]]}");
        TinkerHistory *history = tinker_history_new(scene);
        TinkerDrag *drag =
            tinker_drag_begin(history, scene, (TinkerHit){tinker_scene_find_block(scene, "S"), 1}, 3, -3);
        tinker_drag_to(drag, -1.6, -1.2, 0, REACH);
        tinker_drag_end(drag, at_point, 0);
        expect_end(scene, "S", 1, "Incline", -2, at_point ? 0 : 0.5);
        tinker_history_free(history);
    }
}

/* A pin goes onto the two topmost bodies, at one place: that of a marked point, and of a point mass its centre. */
static void test_joint_drop(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = bars();
    TinkerHistory *history = tinker_history_new(scene);
    const TinkerBlockId pin = tinker_scene_find_block(scene, "Pin");
    tinker_history_begin(history, "Drop", NULL);
    g_assert_cmpint(tinker_joint_drop(history, scene, pin, 5.97, 0.02, REACH), ==, 2);
    expect_end(scene, "Pin", 0, "Lower", 0.5, 0);
    expect_end(scene, "Pin", 1, "Upper", -0.5, 0);
    g_assert_cmpint(tinker_joint_drop(history, scene, pin, 5.22, 0.0, REACH), ==, 2);
    expect_end(scene, "Pin", 0, "Lower", -0.3, 0.02);
    expect_end(scene, "Pin", 1, "Point", 0, 0);
    g_assert_cmpint(tinker_joint_drop(history, scene, pin, 5.7, 0.0, 0.01), ==, 1);
    expect_end(scene, "Pin", 0, "Lower", 0.2, 0);
    g_assert_cmpint(tinker_scene_end(scene, pin, 1).block, ==, TINKER_NO_BLOCK);
    g_assert_cmpint(tinker_joint_drop(history, scene, pin, 3, 3, REACH), ==, 0);
    tinker_history_end(history);
    tinker_history_free(history);
}

/* A pin for one bar goes to an end of it: the free one, joined to what lies there. */
static void test_joint_on_one(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = bars();
    TinkerHistory *history = tinker_history_new(scene);
    const TinkerBlockId pin = tinker_scene_find_block(scene, "Pin"), lower = tinker_scene_find_block(scene, "Lower"),
                        upper = tinker_scene_find_block(scene, "Upper");
    tinker_history_begin(history, "Add", NULL);
    tinker_joint_put_on(history, scene, pin, lower); /* where the other bar is, though both ends are at one height */
    expect_end(scene, "Pin", 0, "Lower", 0.5, 0);
    expect_end(scene, "Pin", 1, "Upper", -0.5, 0);
    tinker_history_end(history);
    tinker_history_begin(history, "Away", NULL);
    const double away[2] = {20, 5};
    tinker_history_set(history, upper, tinker_scene_block_class(scene, upper)->meanings[TINKER_MEANING_POSITION], away,
                       NULL);
    tinker_joint_put_on(history, scene, pin, upper); /* upright: the upper end */
    expect_end(scene, "Pin", 0, "Upper", 0.5, 0);
    g_assert_cmpint(tinker_scene_end(scene, pin, 1).block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(tinker_scene_end(scene, pin, 1).x, 20, 1e-12);
    g_assert_cmpfloat_with_epsilon(tinker_scene_end(scene, pin, 1).y, 5.5, 1e-12);
    tinker_history_end(history);
    tinker_history_free(history);
}

static void expect_loose(TinkerScene *scene, TinkerBlockId joint, int32_t number, double x, double y)
{
    const TinkerSceneEnd end = tinker_scene_end(scene, joint, number);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(end.x, x, 1e-12);
    g_assert_cmpfloat_with_epsilon(end.y, y, 1e-12);
}

/* A point mass over the end of a bar is joined at its centre; the next pin goes to the other end, and where both have
 * one the next to the middle. What no end can be on takes none. */
static void test_joint_on_point_mass(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"bar\", \"name\": \"Bar\", \"position\": [0, 0], \"orientation\": \"90 deg\"},"
        "{\"type\": \"mass\", \"name\": \"Point\", \"position\": [0.02, -0.45], \"width\": 0.4, \"height\": 0.4},"
        "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [[-1, 0.2], [1, 0.2]]},"
        "{\"type\": \"pin\", \"name\": \"First\", \"ends\": [[9, 9], [9, 9]]},"
        "{\"type\": \"pin\", \"name\": \"Second\", \"ends\": [[9, 9], [9, 9]]},"
        "{\"type\": \"pin\", \"name\": \"Third\", \"ends\": [[9, 9], [9, 9]]}");
    TinkerHistory *history = tinker_history_new(scene);
    const TinkerBlockId bar = tinker_scene_find_block(scene, "Bar"), spring = tinker_scene_find_block(scene, "S"),
                        first = tinker_scene_find_block(scene, "First"),
                        second = tinker_scene_find_block(scene, "Second"),
                        third = tinker_scene_find_block(scene, "Third");
    tinker_history_begin(history, "Join", NULL);
    g_assert_cmpint(tinker_joint_put_on(history, scene, first, spring), ==, 0);
    expect_loose(scene, first, 0, 9, 9);
    expect_loose(scene, first, 1, 9, 9);
    g_assert_cmpint(tinker_joint_put_between(history, scene, first, (TinkerBlockId[]){spring, bar}), ==, 0);
    expect_loose(scene, first, 1, 9, 9);
    g_assert_cmpint(tinker_joint_put_on(history, scene, first, bar), ==, 2);
    expect_end(scene, "First", 0, "Bar", -0.45, -0.02);
    expect_end(scene, "First", 1, "Point", 0, 0);
    g_assert_cmpint(tinker_joint_put_on(history, scene, second, bar), ==, 1);
    expect_end(scene, "Second", 0, "Bar", 0.5, 0);
    expect_loose(scene, second, 1, 0, 0.5);
    g_assert_cmpint(tinker_joint_put_on(history, scene, third, bar), ==, 1);
    expect_end(scene, "Third", 0, "Bar", 0, 0);
    expect_loose(scene, third, 1, 0, 0);
    tinker_history_end(history);
    tinker_history_free(history);
}

/* Ends that meet are found, until they are joined; what does not turn has none. */
static void test_bodies_meet(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = bars();
    TinkerHistory *history = tinker_history_new(scene);
    const TinkerBlockId lower = tinker_scene_find_block(scene, "Lower"),
                        upper = tinker_scene_find_block(scene, "Upper");
    g_assert_cmpint(tinker_body_met(scene, lower, REACH), ==, upper);
    g_assert_cmpint(tinker_body_met(scene, tinker_scene_find_block(scene, "Point"), REACH), ==, TINKER_NO_BLOCK);
    tinker_history_begin(history, "Join", NULL);
    tinker_joint_put_between(history, scene, tinker_scene_find_block(scene, "Pin"), (TinkerBlockId[]){upper, lower});
    tinker_history_end(history);
    expect_end(scene, "Pin", 0, "Upper", -0.5, 0);
    expect_end(scene, "Pin", 1, "Lower", 0.5, 0);
    g_assert_cmpint(tinker_body_met(scene, lower, REACH), ==, TINKER_NO_BLOCK);
    tinker_history_free(history);
}

/* An attached end that is dragged into the open comes off and lies there. */
static void test_detach(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "S", 0, 0, 0);
    tinker_drag_to(drag, -2, 1, 0, REACH);
    tinker_drag_end(drag, FALSE, 0);
    TinkerSceneEnd end = tinker_scene_end(stage->scene, stage_block(stage, "S"), 0);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(end.x, -2, 1e-12);
    g_assert_cmpfloat_with_epsilon(end.y, 1, 1e-12);
}

static void add_tests(void)
{
    stage_add("/edit/drag-joints/connect", test_connect);
    stage_add("/edit/drag-joints/connect-at-point", test_connect_at_point);
    stage_add("/edit/drag-joints/connect-along-top", test_connect_along_top);
    stage_add("/edit/drag-joints/connect-to-what-turns", test_connect_to_what_turns);
    stage_add("/edit/drag-joints/joint-drop", test_joint_drop);
    stage_add("/edit/drag-joints/joint-on-point-mass", test_joint_on_point_mass);
    stage_add("/edit/drag-joints/joint-on-one", test_joint_on_one);
    stage_add("/edit/drag-joints/bodies-meet", test_bodies_meet);
    stage_add("/edit/drag-joints/detach", test_detach);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
