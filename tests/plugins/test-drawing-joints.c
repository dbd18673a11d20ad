/* Drawings of joints: where their symbols are. */
#include <math.h>

#include "drawing-stage.h"

/* The symbol of what ties turning is about this place, and nothing is drawn to where its ends are. */
static void assert_symbol_at(const Stage *stage, double x, double y)
{
    g_assert_cmpint(stage_notes(stage, "end_mark"), ==, 0);
    for (int i = 0; i < stage->recorder.count; i++) {
        const Note *drawn = &stage->recorder.notes[i];
        g_assert_cmpfloat(hypot(drawn->x1 - x, drawn->y1 - y), <=, 2 * SYMBOL);
        g_assert_cmpfloat(hypot(drawn->x2 - x, drawn->y2 - y), <=, 2 * SYMBOL);
    }
}

/* At the first end, or at the end on what stands; the line between ends that lie 5 m apart is there only while it is
 * selected, or one is loose. */
static void test_turns(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    stage.ends[1].attached = 1;
    stage.instance.x = 2.5;
    stage.instance.y = 4;
    stage_draw(&stage);
    assert_symbol_at(&stage, 1, 2);
    stage.ends[1].attached = TINKER_ATTACHED_TO_SUPPORT;
    stage_draw(&stage);
    assert_symbol_at(&stage, 4, 6);
    stage.state = TINKER_STATE_SELECTED;
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "line", 0), 1, 2, 4, 6);
    stage.state = 0;
    stage.ends[0].attached = 0;
    stage_draw(&stage);
    stage_assert_line(stage_note(&stage, "line", 0), 1, 2, 4, 6);
    g_assert_cmpint(stage_note(&stage, "end_mark", 0)->edge, ==, 0);
}

/* Whether the arrow of a drive goes counter-clockwise about its place. */
static int goes_left(const Stage *stage, double x, double y)
{
    const Note *head = stage_note(stage, "arrow", 0);
    return (head->x1 - x) * (head->y2 - y) - (head->y1 - y) * (head->x2 - x) > 0;
}

/* The arrow is that of what moves, whichever end that is. */
static void test_drive_arrow(void)
{
    Stage stage;
    stage_init(&stage, "drive");
    stage.ends[1].attached = 1;
    stage_set(&stage, "speed", 3);
    stage.ends[1].attached = TINKER_ATTACHED_TO_SUPPORT;
    stage_draw(&stage);
    g_assert_true(goes_left(&stage, 4, 6));
    stage.ends[0].attached = TINKER_ATTACHED_TO_SUPPORT;
    stage.ends[1].attached = 1;
    stage_draw(&stage);
    g_assert_false(goes_left(&stage, 1, 2));
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_data_func("/plugins/drawing/drive", "drive", test_turns);
    g_test_add_data_func("/plugins/drawing/torsional-spring", "torsional-spring", test_turns);
    g_test_add_data_func("/plugins/drawing/torsional-damper", "torsional-damper", test_turns);
    g_test_add_func("/plugins/drawing/drive/arrow", test_drive_arrow);
    return g_test_run();
}
