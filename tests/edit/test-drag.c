/* Drags of whole blocks, handles and corners, with the real blocks: one undo step each, taken back whole. */
#include <math.h>

#include "drag-stage.h"
#include "edit/outline.h"

/* Many movements are one step, and undoing it restores the scene to the letter. */
static void test_move(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "A", TINKER_PART_WHOLE, 0.2, -0.1);
    for (int i = 1; i <= 20; i++)
        tinker_drag_to(drag, 0.2 + 0.1 * i, -0.1 + 0.05 * i, 0, REACH);
    stage_expect_place(stage, "A", 2, 1);
    tinker_drag_end(drag, FALSE, 0);
    g_assert_cmpstr(tinker_history_can_undo(stage->history), ==, "Move A");
    tinker_history_undo(stage->history);
    stage_expect_untouched(stage);
    tinker_history_redo(stage->history);
    stage_expect_place(stage, "A", 2, 1);
}

/* The block's own point goes to the grid, not the pointer's. */
static void test_snap(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "A", TINKER_PART_WHOLE, 0.3, 0.3);
    tinker_drag_to(drag, 1.6, -0.4, 0.5, REACH);
    stage_expect_place(stage, "A", 1.5, -0.5);
    tinker_drag_to(drag, 1.61, -0.41, 0, REACH);
    stage_expect_place(stage, "A", 1.31, -0.71);
    tinker_drag_end(drag, FALSE, 0);
}

static void test_cancel(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "A", TINKER_PART_WHOLE, 0, 0);
    tinker_drag_to(drag, 5, 5, 0.2, REACH);
    tinker_drag_cancel(drag);
    stage_expect_untouched(stage);
    drag = stage_grab(stage, "S", 0, 0, 0);
    tinker_drag_to(drag, 3, 0, 0, REACH);
    tinker_drag_cancel(drag);
    stage_expect_untouched(stage);
}

static void test_click(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "S", 0, 0.01, 0);
    tinker_drag_to(drag, 0.01, 0, 0.2, REACH);
    tinker_drag_end(drag, FALSE, 0);
    stage_expect_untouched(stage);
    tinker_drag_cancel(stage_grab(stage, "A", TINKER_PART_WHOLE, 0, 0));
    stage_expect_untouched(stage);
}

/* Handles change what they stand for, within the declared range. */
static void test_handles(Stage *stage, gconstpointer data)
{
    TinkerDrag *drag = stage_grab(stage, "A", TINKER_HANDLE_SIZE, 0.4, 0.4);
    tinker_drag_to(drag, 1, 0.5, 0, REACH);
    g_assert_cmpfloat_with_epsilon(stage_value(stage->scene, "A", TINKER_MEANING_WIDTH, 0), 2, 1e-12);
    g_assert_cmpfloat_with_epsilon(stage_value(stage->scene, "A", TINKER_MEANING_HEIGHT, 0), 1, 1e-12);
    tinker_drag_end(drag, FALSE, 0);
    drag = stage_grab(stage, "A", TINKER_HANDLE_LOCAL_ORIGIN, 0, 0);
    tinker_drag_to(drag, 1.2, 0.9, 0.5, REACH);
    g_assert_cmpfloat(fmod(stage_value(stage->scene, "A", TINKER_MEANING_LOCAL_ORIGIN, 0), 0.5), ==, 0);
    stage_expect_place(stage, "A", 0, 0);
    tinker_drag_end(drag, FALSE, 0);
    tinker_history_undo(stage->history);
    tinker_history_undo(stage->history);
    stage_expect_untouched(stage);
}

static void test_nothing(Stage *stage, gconstpointer data)
{
    TinkerHit nothing = {TINKER_NO_BLOCK, TINKER_PART_NONE}, gone = {4711, TINKER_PART_WHOLE};
    g_assert_null(tinker_drag_begin(stage->history, stage->scene, nothing, 0, 0));
    g_assert_null(tinker_drag_begin(stage->history, stage->scene, gone, 0, 0));
    TinkerDrag *drag = stage_grab(stage, "A", TINKER_PART_WHOLE, 0, 0);
    tinker_drag_to(drag, NAN, 0, 0, REACH);
    tinker_drag_to(drag, INFINITY, 0, 0.2, REACH);
    tinker_drag_end(drag, FALSE, 0);
    stage_expect_untouched(stage);
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
    const TinkerBlockId plate = stage_block(&of_plate, "P");
    const double start[3][2] = {{6, 0}, {6, 3}, {3, 0}}, moved[3][2] = {{6, 0}, {6, 3}, {0, 3}};
    const double four[4][2] = {{6, 0}, {7.5, 1.5}, {6, 3}, {0, 3}};
    expect_corners(&of_plate, plate, start, 3);
    TinkerDrag *drag = tinker_drag_begin(history, scene, (TinkerHit){plate, TINKER_PART_POINT + 2}, 3, 0);
    tinker_drag_to(drag, 1, 1, 0, REACH);
    tinker_drag_to(drag, 0.1, 2.9, 1, REACH); /* onto the grid */
    tinker_drag_end(drag, FALSE, 0);
    expect_corners(&of_plate, plate, moved, 3);
    stage_expect_place(&of_plate, "P", 4, 2);
    tinker_history_begin(history, "add", NULL);
    tinker_outline_add(history, scene, plate, four[1]);
    tinker_history_end(history);
    expect_corners(&of_plate, plate, four, 4);
    tinker_history_begin(history, "remove", NULL);
    tinker_outline_remove(history, scene, plate, 1);
    tinker_outline_remove(history, scene, plate, 0); /* three are kept */
    tinker_history_end(history);
    expect_corners(&of_plate, plate, moved, 3);
    stage_expect_place(&of_plate, "P", 4, 2);
    for (int i = 0; i < 3; i++)
        tinker_history_undo(history);
    expect_corners(&of_plate, plate, start, 3);
    stage_expect_place(&of_plate, "P", 5, 1);
}

static void add_tests(void)
{
    stage_add("/edit/drag/move", test_move);
    stage_add("/edit/drag/snap", test_snap);
    stage_add("/edit/drag/cancel", test_cancel);
    stage_add("/edit/drag/click", test_click);
    stage_add("/edit/drag/handles", test_handles);
    stage_add("/edit/drag/nothing", test_nothing);
    stage_add("/edit/drag/outline", test_outline);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
