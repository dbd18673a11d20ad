/* Drags with the real blocks: one undo step each, connected where they end, taken back whole. */
#include <math.h>
#include <string.h>
#include <tinker/shapes.h>

#include "edit/drag.h"
#include "edit/outline.h"
#include "scene-fixture.h"

#define REACH 0.1

static const char blocks[] =
    "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0]},"
    "{\"type\": \"mass\", \"name\": \"B\", \"position\": [3, 0]},"
    "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -3], \"orientation\": \"90 deg\"},"
    "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"A\", [2, 2]]}";

typedef struct {
    TinkerScene *scene;
    TinkerHistory *history;
    char *before; /* the scene as text */
} Stage;

static void set_up(Stage *stage, gconstpointer data)
{
    stage->scene = scene_fixture_read_blocks(blocks);
    stage->history = tinker_history_new(stage->scene);
    stage->before = tinker_scene_to_text(stage->scene, TINKER_WRITE_SI);
}

static void tear_down(Stage *stage, gconstpointer data)
{
    g_free(stage->before);
    tinker_history_free(stage->history);
    tinker_scene_free(stage->scene);
}

static TinkerBlockId named(const Stage *stage, const char *name)
{
    return tinker_scene_find_block(stage->scene, name);
}

static TinkerDrag *grab(Stage *stage, const char *name, int32_t part, double x, double y)
{
    TinkerDrag *drag = tinker_drag_begin(stage->history, stage->scene, (TinkerHit){named(stage, name), part}, x, y);
    g_assert_nonnull(drag);
    return drag;
}

static double value(const Stage *stage, const char *name, int32_t meaning, int component)
{
    TinkerBlockId block = named(stage, name);
    const TinkerBlockClass *block_class = tinker_scene_block_class(stage->scene, block);
    return tinker_scene_get(stage->scene, block, tinker_block_class_meaning_column(block_class, meaning) + component);
}

static void expect_place(const Stage *stage, const char *name, double x, double y)
{
    g_assert_cmpfloat_with_epsilon(value(stage, name, TINKER_MEANING_POSITION, 0), x, 1e-12);
    g_assert_cmpfloat_with_epsilon(value(stage, name, TINKER_MEANING_POSITION, 1), y, 1e-12);
}

static void expect_untouched(const Stage *stage)
{
    g_autofree char *now = tinker_scene_to_text(stage->scene, TINKER_WRITE_SI);
    g_assert_cmpstr(now, ==, stage->before);
    g_assert_null(tinker_history_can_undo(stage->history));
}

/* Many movements are one step, and undoing it restores the scene to the letter. */
static void test_move(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = grab(stage, "A", TINKER_PART_WHOLE, 0.2, -0.1);
    for (int i = 1; i <= 20; i++)
        tinker_drag_to(drag, 0.2 + 0.1 * i, -0.1 + 0.05 * i, 0, REACH);
    expect_place(stage, "A", 2, 1);
    tinker_drag_end(drag, FALSE, 0);
    g_assert_cmpstr(tinker_history_can_undo(stage->history), ==, "Move A");
    tinker_history_undo(stage->history);
    expect_untouched(stage);
    tinker_history_redo(stage->history);
    expect_place(stage, "A", 2, 1);
}

/* The block's own point goes to the grid, not the pointer's. */
static void test_snap(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = grab(stage, "A", TINKER_PART_WHOLE, 0.3, 0.3);
    tinker_drag_to(drag, 1.6, -0.4, 0.5, REACH);
    expect_place(stage, "A", 1.5, -0.5);
    tinker_drag_to(drag, 1.61, -0.41, 0, REACH);
    expect_place(stage, "A", 1.31, -0.71);
    tinker_drag_end(drag, FALSE, 0);
}

static void test_cancel(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = grab(stage, "A", TINKER_PART_WHOLE, 0, 0);
    tinker_drag_to(drag, 5, 5, 0.2, REACH);
    tinker_drag_cancel(drag);
    expect_untouched(stage);
    drag = grab(stage, "S", 0, 0, 0);
    tinker_drag_to(drag, 3, 0, 0, REACH);
    tinker_drag_cancel(drag);
    expect_untouched(stage);
}

static void test_click(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = grab(stage, "S", 0, 0.01, 0);
    tinker_drag_to(drag, 0.01, 0, 0.2, REACH);
    tinker_drag_end(drag, FALSE, 0);
    expect_untouched(stage);
    tinker_drag_cancel(grab(stage, "A", TINKER_PART_WHOLE, 0, 0));
    expect_untouched(stage);
}

/* Over a body the end tells which one; away from it, nothing; released over it, it is connected to its centre. */
static void test_connect(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = grab(stage, "S", 1, 2, 2);
    g_assert_cmpint(tinker_drag_to(drag, 2.9, 0.2, 0, REACH), ==, named(stage, "B"));
    g_assert_cmpint(tinker_drag_to(drag, 3, 2, 0, REACH), ==, TINKER_NO_BLOCK);
    g_assert_cmpint(tinker_drag_to(drag, 3.1, -0.1, 0, REACH), ==, named(stage, "B"));
    tinker_drag_end(drag, TRUE, 0);
    TinkerSceneEnd end = tinker_scene_end(stage->scene, named(stage, "S"), 1);
    g_assert_cmpint(end.block, ==, named(stage, "B"));
    g_assert_cmpfloat(end.x, ==, 0);
    g_assert_cmpfloat(end.y, ==, 0);
    tinker_history_undo(stage->history);
    expect_untouched(stage);
}

/* To a point of a support that is turned by a right angle: its own x axis is the world's y axis. */
static void test_connect_at_point(Stage *stage, gconstpointer data)
{
    for (int at_point = 0; at_point < 2; at_point++) {
        TinkerDrag *drag = grab(stage, "S", 1, 2, 2);
        g_assert_cmpint(tinker_drag_to(drag, 0.1, -2, 0, REACH), ==, named(stage, "Floor"));
        tinker_drag_end(drag, at_point, 0);
        TinkerSceneEnd end = tinker_scene_end(stage->scene, named(stage, "S"), 1);
        g_assert_cmpint(end.block, ==, named(stage, "Floor"));
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
    TinkerDrag *drag = grab(stage, "S", 0, 0, 0);
    tinker_drag_to(drag, -2, 1, 0, REACH);
    tinker_drag_end(drag, FALSE, 0);
    TinkerSceneEnd end = tinker_scene_end(stage->scene, named(stage, "S"), 0);
    g_assert_cmpint(end.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpfloat_with_epsilon(end.x, -2, 1e-12);
    g_assert_cmpfloat_with_epsilon(end.y, 1, 1e-12);
}

/* Handles change what they stand for, within the declared range. */
static void test_handles(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = grab(stage, "A", TINKER_HANDLE_SIZE, 0.4, 0.4);
    tinker_drag_to(drag, 1, 0.5, 0, REACH);
    g_assert_cmpfloat_with_epsilon(value(stage, "A", TINKER_MEANING_WIDTH, 0), 2, 1e-12);
    g_assert_cmpfloat_with_epsilon(value(stage, "A", TINKER_MEANING_HEIGHT, 0), 1, 1e-12);
    tinker_drag_end(drag, FALSE, 0);
    drag = grab(stage, "A", TINKER_HANDLE_LOCAL_ORIGIN, 0, 0);
    tinker_drag_to(drag, 1.2, 0.9, 0.5, REACH);
    g_assert_cmpfloat(fmod(value(stage, "A", TINKER_MEANING_LOCAL_ORIGIN, 0), 0.5), ==, 0);
    expect_place(stage, "A", 0, 0);
    tinker_drag_end(drag, FALSE, 0);
    tinker_history_undo(stage->history);
    tinker_history_undo(stage->history);
    expect_untouched(stage);
}

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
        TinkerDrag *drag = grab(stage, "A", TINKER_PART_WHOLE, 0, 0);
        tinker_drag_to(drag, rows[i].x, rows[i].y, 0, REACH);
        tinker_drag_end(drag, FALSE, rows[i].reach);
        expect_place(stage, "A", rows[i].snaps ? -0.6 : rows[i].x, rows[i].y);
        g_assert_cmpfloat(value(stage, "A", TINKER_MEANING_ORIENTATION, 0), ==, rows[i].snaps ? 0.5 * G_PI : 0);
        tinker_history_undo(stage->history);
        expect_untouched(stage);
    }
}

static double own_value(const TinkerScene *scene, const char *name, int32_t meaning, int32_t component)
{
    const TinkerBlockId block = tinker_scene_find_block(scene, name);
    const int32_t column = tinker_block_class_meaning_column(tinker_scene_block_class(scene, block), meaning);
    return tinker_scene_get(scene, block, column + component);
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
        const double x = own_value(scene, rows[i].name, TINKER_MEANING_POSITION, 0);
        const TinkerBlockId block = tinker_scene_find_block(scene, rows[i].name);
        tinker_history_begin(history, "Drop", NULL);
        g_assert_cmpint(tinker_snap_onto_top(history, scene, block, 0.1), ==, rows[i].snaps);
        tinker_history_end(history);
        g_assert_cmpfloat_with_epsilon(own_value(scene, rows[i].name, TINKER_MEANING_POSITION, 0), x, 1e-12);
        g_assert_cmpfloat_with_epsilon(own_value(scene, rows[i].name, TINKER_MEANING_POSITION, 1), rows[i].y, 1e-12);
        g_assert_cmpfloat_with_epsilon(own_value(scene, rows[i].name, TINKER_MEANING_ORIENTATION, 0),
                                       rows[i].orientation, 1e-12);
    }
    tinker_history_free(history);
}

/* The lowest of a rectangle's corners over a line through `through` with this normal (m), by the corners themselves. */
static double lowest_corner(const TinkerScene *scene, const char *name, double through, const double normal[2])
{
    const double x = own_value(scene, name, TINKER_MEANING_POSITION, 0);
    const double y = own_value(scene, name, TINKER_MEANING_POSITION, 1);
    const double angle = own_value(scene, name, TINKER_MEANING_ORIENTATION, 0);
    const double a = own_value(scene, name, TINKER_MEANING_WIDTH, 0) / 2;
    const double b = own_value(scene, name, TINKER_MEANING_HEIGHT, 0) / 2;
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
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Ladder", TINKER_MEANING_WIDTH, 0), hypot(1, 1.92), 1e-12);
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Ladder", TINKER_MEANING_POSITION, 0), 2.5, 1e-12);
    tinker_history_undo(history);
    drag_handle(history, scene, "Ladder", (const double[]){4, 2}, (const double[]){3, 0.08}, REACH);
    g_assert_cmpfloat_with_epsilon(lowest_corner(scene, "Ladder", 0, up), 0, 1e-12);
    drag_handle(history, scene, "Ladder", (const double[]){2, 2}, (const double[]){-0.05, 4}, REACH);
    g_assert_cmpfloat_with_epsilon(lowest_corner(scene, "Ladder", 0, up), 0, 1e-12);
    g_assert_cmpfloat_with_epsilon(lowest_corner(scene, "Ladder", 0, right), 0, 1e-12);
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Ladder", TINKER_MEANING_WIDTH, 0), 5, 0.1);
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
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Beam", TINKER_MEANING_WIDTH, 0), 3, 1e-12);
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Beam", TINKER_MEANING_HEIGHT, 0), 0.4, 1e-12);
    const double angle = own_value(scene, "Plank", TINKER_MEANING_ORIENTATION, 0);
    const double corner[2] = {cos(angle) - 0.1 * sin(angle), 1 + sin(angle) + 0.1 * cos(angle)};
    const double low[2] = {1.2, 0.08}; /* in its own axes so far to the right, and so far above */
    const double along = low[0] * cos(angle) + (low[1] - 1) * sin(angle);
    const double across = (low[1] - 1) * cos(angle) - low[0] * sin(angle);
    drag_handle(history, scene, "Plank", corner, low, REACH);
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Plank", TINKER_MEANING_ORIENTATION, 0), angle, 1e-12);
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Plank", TINKER_MEANING_WIDTH, 0), 2 * along, 1e-12);
    g_assert_cmpfloat_with_epsilon(own_value(scene, "Plank", TINKER_MEANING_HEIGHT, 0), 2 * fabs(across), 1e-12);
    tinker_history_free(history);
}

static void test_nothing(Stage *stage, gconstpointer data)
{
    TinkerHit nothing = {TINKER_NO_BLOCK, TINKER_PART_NONE}, gone = {4711, TINKER_PART_WHOLE};
    g_assert_null(tinker_drag_begin(stage->history, stage->scene, nothing, 0, 0));
    g_assert_null(tinker_drag_begin(stage->history, stage->scene, gone, 0, 0));
    TinkerDrag *drag = grab(stage, "A", TINKER_PART_WHOLE, 0, 0);
    tinker_drag_to(drag, NAN, 0, 0, REACH);
    tinker_drag_to(drag, INFINITY, 0, 0.2, REACH);
    tinker_drag_end(drag, FALSE, 0);
    expect_untouched(stage);
}

/* A plate that is turned by 90 degrees, as a drawing has its corners: a handle is where a corner is. The block is asked
 * at the place of the corner, which no handle beside it is on. */
static void expect_corners(const Stage *stage, TinkerBlockId plate, const double (*places)[2], int32_t count)
{
    g_autoptr(TinkerFrame) frame = tinker_frame_new(stage->scene, NULL);
    g_assert_cmpint(tinker_outline_corners(stage->scene, plate), ==, count);
    for (int32_t i = 0; i < count; i++) {
        const TinkerHit hit = tinker_hit_handle(frame, plate, places[i][0], places[i][1], 1e-9);
        g_assert_cmpint(hit.block, ==, plate);
        g_assert_cmpint(hit.part, ==, TINKER_PART_POINT + i);
    }
}

/* A corner that is dragged, added or taken out leaves the others where they are, wherever the centre of mass goes: of a
 * triangle it is the mean of its corners. */
static void test_outline(Stage *stage, gconstpointer data)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"plate\", \"name\": \"P\", \"position\": [5, 1], \"orientation\": \"90 deg\", "
        "\"corners\": [[0, 0], [3, 0], [0, 3]]}");
    g_autoptr(TinkerHistory) history = tinker_history_new(scene);
    const Stage of_plate = {scene, history, NULL};
    const TinkerBlockId plate = named(&of_plate, "P");
    const double start[3][2] = {{6, 0}, {6, 3}, {3, 0}}, moved[3][2] = {{6, 0}, {6, 3}, {0, 3}};
    const double four[4][2] = {{6, 0}, {7.5, 1.5}, {6, 3}, {0, 3}};
    expect_corners(&of_plate, plate, start, 3);
    TinkerDrag *drag = tinker_drag_begin(history, scene, (TinkerHit){plate, TINKER_PART_POINT + 2}, 3, 0);
    tinker_drag_to(drag, 1, 1, 0, REACH);
    tinker_drag_to(drag, 0.1, 2.9, 1, REACH); /* onto the grid */
    tinker_drag_end(drag, FALSE, 0);
    expect_corners(&of_plate, plate, moved, 3);
    expect_place(&of_plate, "P", 4, 2);
    tinker_history_begin(history, "add", NULL);
    tinker_outline_add(history, scene, plate, four[1]);
    tinker_history_end(history);
    expect_corners(&of_plate, plate, four, 4);
    tinker_history_begin(history, "remove", NULL);
    tinker_outline_remove(history, scene, plate, 1);
    tinker_outline_remove(history, scene, plate, 0); /* three are kept */
    tinker_history_end(history);
    expect_corners(&of_plate, plate, moved, 3);
    expect_place(&of_plate, "P", 4, 2);
    for (int i = 0; i < 3; i++)
        tinker_history_undo(history);
    expect_corners(&of_plate, plate, start, 3);
    expect_place(&of_plate, "P", 5, 1);
}

#define add(path, function) g_test_add(path, Stage, NULL, set_up, function, tear_down)

static void add_tests(void)
{
    add("/edit/drag/move", test_move);
    add("/edit/drag/snap", test_snap);
    add("/edit/drag/cancel", test_cancel);
    add("/edit/drag/click", test_click);
    add("/edit/drag/connect", test_connect);
    add("/edit/drag/connect-at-point", test_connect_at_point);
    add("/edit/drag/connect-along-top", test_connect_along_top);
    add("/edit/drag/connect-to-what-turns", test_connect_to_what_turns);
    add("/edit/drag/joint-drop", test_joint_drop);
    add("/edit/drag/joint-on-point-mass", test_joint_on_point_mass);
    add("/edit/drag/joint-on-one", test_joint_on_one);
    add("/edit/drag/bodies-meet", test_bodies_meet);
    add("/edit/drag/detach", test_detach);
    add("/edit/drag/handles", test_handles);
    add("/edit/drag/onto-top", test_onto_top);
    add("/edit/drag/stand-on-top", test_stand_on_top);
    add("/edit/drag/ladder", test_ladder);
    add("/edit/drag/jointed-bar-is-not-sized", test_jointed_bar_is_not_sized);
    add("/edit/drag/corner-of-long-box", test_corner_of_long_box);
    add("/edit/drag/nothing", test_nothing);
    add("/edit/drag/outline", test_outline);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
