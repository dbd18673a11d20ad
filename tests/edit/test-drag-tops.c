/* Bodies that are dragged to the tops of supports, whole or by an end. */
#include <math.h>

#include "drag-stage.h"

/* The floor is turned by 90 degrees: its top faces left, at x = -0.2, from y = -5 to y = -1, so that a mass of height
 * 0.8 touches it with its centre at x = -0.6. */
static void test_onto_top(Stage *stage, gconstpointer data)
{
    static const struct {
        double x, y, reach;
        gboolean snaps;
    } rows[] = {
        {-0.65, -2, REACH, TRUE},  {-0.69, -4.9, REACH, TRUE},  {-0.6, -2, REACH, TRUE},  {-0.3, -1.1, REACH, TRUE},
        {-0.71, -2, REACH, FALSE}, {-0.65, -0.9, REACH, FALSE}, {-0.1, -2, REACH, FALSE}, {-0.65, -2, 0, FALSE},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        TinkerDrag *drag = stage_grab(stage, "A", TINKER_PART_WHOLE, 0, 0);
        tinker_drag_to(drag, rows[i].x, rows[i].y, 0, REACH);
        tinker_drag_end(drag, FALSE, rows[i].reach);
        stage_expect_place(stage, "A", rows[i].snaps ? -0.6 : rows[i].x, rows[i].y);
        g_assert_cmpfloat(stage_value(stage->scene, "A", TINKER_MEANING_ORIENTATION, 0), ==,
                          rows[i].snaps ? 0.5 * G_PI : 0);
        tinker_history_undo(stage->history);
        stage_expect_untouched(stage);
    }
}

/* Bodies that turn are put onto the top, at y = 0.2, as they are near it: a disc by its radius, a box with a side. What
 * something holds keeps its place. */
static void test_stand_on_top(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, 0], \"width\": 8, \"height\": 0.4},"
        "{\"type\": \"disc\", \"name\": \"Disc\", \"radius\": 0.5, \"position\": [1, 0.75], \"orientation\": 1},"
        "{\"type\": \"box\", \"name\": \"Box\", \"width\": 0.2, \"height\": 1, \"position\": [-1, 0.35], "
        "\"orientation\": \"84 deg\"},"
        "{\"type\": \"disc\", \"name\": \"Held\", \"radius\": 0.5, \"position\": [3, 0.75]},"
        "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"Held\", [3, 3]]}");
    static const struct {
        const char *name;
        double y, orientation;
        gboolean snaps;
    } rows[] = {{"Disc", 0.7, 1, TRUE}, {"Box", 0.3, 0.5 * G_PI, TRUE}, {"Held", 0.75, 0, FALSE}};
    TinkerHistory *history = tinker_history_new(scene);
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        const double x = stage_value(scene, rows[i].name, TINKER_MEANING_POSITION, 0);
        const TinkerBlockId block = tinker_scene_find_block(scene, rows[i].name);
        tinker_history_begin(history, "Drop", NULL);
        g_assert_cmpint(tinker_snap_onto_top(history, scene, block, 0.1), ==, rows[i].snaps);
        tinker_history_end(history);
        g_assert_cmpfloat_with_epsilon(stage_value(scene, rows[i].name, TINKER_MEANING_POSITION, 0), x, 1e-12);
        g_assert_cmpfloat_with_epsilon(stage_value(scene, rows[i].name, TINKER_MEANING_POSITION, 1), rows[i].y, 1e-12);
        g_assert_cmpfloat_with_epsilon(stage_value(scene, rows[i].name, TINKER_MEANING_ORIENTATION, 0),
                                       rows[i].orientation, 1e-12);
    }
    tinker_history_free(history);
}

/* The lowest of a rectangle's corners over a line through `through` with this normal (m), by the corners themselves. */
static double lowest_corner(const TinkerScene *scene, const char *name, double through, const double normal[2])
{
    const double x = stage_value(scene, name, TINKER_MEANING_POSITION, 0);
    const double y = stage_value(scene, name, TINKER_MEANING_POSITION, 1);
    const double angle = stage_value(scene, name, TINKER_MEANING_ORIENTATION, 0);
    const double a = stage_value(scene, name, TINKER_MEANING_WIDTH, 0) / 2;
    const double b = stage_value(scene, name, TINKER_MEANING_HEIGHT, 0) / 2;
    double lowest = INFINITY;
    for (int corner = 0; corner < 4; corner++) {
        const double along = corner & 1 ? a : -a, across = corner & 2 ? b : -b;
        const double at[2] = {x + along * cos(angle) - across * sin(angle),
                              y + along * sin(angle) + across * cos(angle)};
        lowest = fmin(lowest, at[0] * normal[0] + at[1] * normal[1] - through);
    }
    return lowest;
}

static void drag_handle(TinkerHistory *history, TinkerScene *scene, const char *name, const double from[2],
                        const double to[2], double reach)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    const TinkerHit handle = tinker_hit_handle(frame, tinker_scene_find_block(scene, name), from[0], from[1], REACH);
    const TinkerHit hit = tinker_hit_to_drag(frame, handle, from[0], from[1], REACH);
    TinkerDrag *drag = tinker_drag_begin(history, scene, hit, from[0], from[1]);
    g_assert_nonnull(drag);
    tinker_drag_to(drag, to[0], to[1], 0, REACH);
    tinker_drag_end(drag, FALSE, reach);
}

/* Floor and wall have their tops at y = 0 and x = 0. A ladder's end that is dropped near the one, and then its other
 * end near the other, lies there with a corner; the end that is not dragged stays where it was, on its top. */
static void test_ladder(Stage *stage, gconstpointer data)
{
    static const double up[2] = {0, 1}, right[2] = {1, 0};
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [2, -0.2], \"width\": 8, \"height\": 0.4},"
        "{\"type\": \"support\", \"name\": \"Wall\", \"position\": [-0.2, 3], \"width\": 8, \"height\": 0.4, "
        "\"orientation\": \"-90 deg\"},"
        "{\"type\": \"bar\", \"name\": \"Ladder\", \"position\": [3, 2], \"length\": 2, \"width\": 0.1}");
    TinkerHistory *history = tinker_history_new(scene);
    drag_handle(history, scene, "Ladder", (const double[]){4, 2}, (const double[]){3, 0.08}, 0);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Ladder", TINKER_MEANING_WIDTH, 0), hypot(1, 1.92), 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Ladder", TINKER_MEANING_POSITION, 0), 2.5, 1e-12);
    tinker_history_undo(history);
    drag_handle(history, scene, "Ladder", (const double[]){4, 2}, (const double[]){3, 0.08}, REACH);
    g_assert_cmpfloat_with_epsilon(lowest_corner(scene, "Ladder", 0, up), 0, 1e-12);
    drag_handle(history, scene, "Ladder", (const double[]){2, 2}, (const double[]){-0.05, 4}, REACH);
    g_assert_cmpfloat_with_epsilon(lowest_corner(scene, "Ladder", 0, up), 0, 1e-12);
    g_assert_cmpfloat_with_epsilon(lowest_corner(scene, "Ladder", 0, right), 0, 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Ladder", TINKER_MEANING_WIDTH, 0), 5, 0.1);
    tinker_history_free(history);
}

/* An end of a bar that a joint is on is no handle of its length: the bar is moved by it. One that is free has it. */
static void test_jointed_bar_is_not_sized(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"support\", \"name\": \"Wall\", \"position\": [0, 0]},"
        "{\"type\": \"bar\", \"name\": \"Crank\", \"position\": [0.5, 0]},"
        "{\"type\": \"bar\", \"name\": \"Free\", \"position\": [0.5, 3]},"
        "{\"type\": \"pin\", \"name\": \"A\", \"ends\": [\"Wall\", {\"block\": \"Crank\", \"at\": [-0.5, 0]}]}");
    static const struct {
        const char *name;
        double y;
        gboolean sizes;
    } rows[] = {{"Crank", 0, FALSE}, {"Free", 3, TRUE}};
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        const TinkerHit hit =
            tinker_hit_handle(frame, tinker_scene_find_block(scene, rows[i].name), 1, rows[i].y, REACH);
        g_assert_cmpint(hit.part, >=, TINKER_PART_HANDLE);
        const TinkerHit held = tinker_hit_to_drag(frame, hit, 1, rows[i].y, REACH);
        g_assert_cmpint(held.part, ==, rows[i].sizes ? hit.part : TINKER_PART_WHOLE);
    }
}

/* A corner of a long box is no end: a pin in its middle does not keep it from being sized by it, and near a top it
 * stays where it is dropped, whatever the angle. */
static void test_corner_of_long_box(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -0.2], \"width\": 8, \"height\": 0.4},"
        "{\"type\": \"support\", \"name\": \"Wall\", \"position\": [0, 5]},"
        "{\"type\": \"box\", \"name\": \"Beam\", \"position\": [0, 5], \"width\": 2, \"height\": 0.2},"
        "{\"type\": \"box\", \"name\": \"Plank\", \"position\": [0, 1], \"width\": 2, \"height\": 0.2, "
        "\"orientation\": \"-40 deg\"},"
        "{\"type\": \"pin\", \"name\": \"A\", \"ends\": [\"Wall\", {\"block\": \"Beam\", \"at\": [0, 0]}]}");
    TinkerHistory *history = tinker_history_new(scene);
    drag_handle(history, scene, "Beam", (const double[]){1, 5.1}, (const double[]){1.5, 5.2}, REACH);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Beam", TINKER_MEANING_WIDTH, 0), 3, 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Beam", TINKER_MEANING_HEIGHT, 0), 0.4, 1e-12);
    const double angle = stage_value(scene, "Plank", TINKER_MEANING_ORIENTATION, 0);
    const double corner[2] = {cos(angle) - 0.1 * sin(angle), 1 + sin(angle) + 0.1 * cos(angle)};
    const double low[2] = {1.2, 0.08}; /* in its own axes so far to the right, and so far above */
    const double along = low[0] * cos(angle) + (low[1] - 1) * sin(angle);
    const double across = (low[1] - 1) * cos(angle) - low[0] * sin(angle);
    drag_handle(history, scene, "Plank", corner, low, REACH);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Plank", TINKER_MEANING_ORIENTATION, 0), angle, 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Plank", TINKER_MEANING_WIDTH, 0), 2 * along, 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(scene, "Plank", TINKER_MEANING_HEIGHT, 0), 2 * fabs(across), 1e-12);
    tinker_history_free(history);
}

static void add_tests(void)
{
    stage_add("/edit/drag-tops/onto-top", test_onto_top);
    stage_add("/edit/drag-tops/stand-on-top", test_stand_on_top);
    stage_add("/edit/drag-tops/ladder", test_ladder);
    stage_add("/edit/drag-tops/jointed-bar-is-not-sized", test_jointed_bar_is_not_sized);
    stage_add("/edit/drag-tops/corner-of-long-box", test_corner_of_long_box);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
