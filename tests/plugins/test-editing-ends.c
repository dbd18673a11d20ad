/* Hit, move and handles of connectors, of what acts on one end, and of fields. */
#include <float.h>
#include <math.h>

#include "editing-stage.h"

static void test_connector(gconstpointer data)
{
    EditingStage stage;
    editing_init(&stage, data);
    stage.ends[0] = (TinkerEnd){0, 0, 1, 0, 0};
    stage.ends[1] = (TinkerEnd){3, 4, 0, 0, 0};
    stage.instance.x = 1.5;
    stage.instance.y = 2;
    g_assert_cmpint(editing_hit(&stage, 0.02, 0.01), ==, 0);
    g_assert_cmpint(editing_hit(&stage, 3.03, 4.03), ==, 1);
    g_assert_cmpint(editing_hit(&stage, 1.5, 2.04), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 1.5, 2.2), ==, TINKER_PART_NONE);
    g_assert_cmpint(editing_hit(&stage, 6, 8), ==, TINKER_PART_NONE);
    editing_move(&stage, TINKER_PART_WHOLE, 1, 1); /* the attached end stays */
    g_assert_cmpfloat(stage.ends[0].x, ==, 0);
    g_assert_cmpint(stage.ends[0].attached, ==, 1);
    g_assert_cmpfloat(stage.ends[1].x, ==, 4);
    editing_move(&stage, 0, 0.5, 0.25); /* and comes off when it is itself taken */
    g_assert_cmpint(stage.ends[0].attached, ==, 0);
    g_assert_cmpfloat(stage.ends[0].x, ==, 0.5);
    g_assert_cmpfloat(stage.ends[0].y, ==, 0.25);
    editing_move_absolute(&stage, 1, 7, 8);
    g_assert_cmpfloat(stage.ends[1].x, ==, 7);
    g_assert_cmpfloat(stage.ends[1].y, ==, 8);
    stage.instance.x = 3.75;
    stage.instance.y = 4.125;
    editing_move_absolute(&stage, TINKER_PART_WHOLE, 4.75, 4.125); /* both are free: the middle goes there */
    g_assert_cmpfloat(stage.ends[0].x, ==, 1.5);
    g_assert_cmpfloat(stage.ends[1].x, ==, 8);
    g_assert_cmpfloat(stage.ends[1].y, ==, 8);
    editing_move(&stage, 17, 1, 1); /* parts that it does not have */
    editing_move_absolute(&stage, TINKER_PART_NONE, 1, 1);
    g_assert_cmpfloat(stage.ends[0].x, ==, 1.5);
}

/* Ends that lie on one another: the point is within reach of both, and one of them is taken. */
static void test_connector_of_no_length(gconstpointer data)
{
    EditingStage stage;
    editing_init(&stage, data);
    g_assert_cmpint(editing_hit(&stage, 0, 0), !=, TINKER_PART_NONE);
    g_assert_cmpint(editing_hit(&stage, 1, 0), ==, TINKER_PART_NONE);
}

static void test_arrow_of_one_end(gconstpointer data)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, data);
    stage.ends[0] = (TinkerEnd){1, 1, 1, 0, 0};
    stage.instance.x = stage.instance.y = 1;
    *editing_column(&stage, "waveform") = 1;
    g_assert_cmpint(editing_hit(&stage, 1, 1), ==, 0);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.y, ==, 1);
    g_assert_cmpint(editing_hit(&stage, (1 + handle.x) / 2, 1), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, (1 + handle.x) / 2, 1.2), ==, TINKER_PART_NONE);
    editing_drag_handle(&stage, TINKER_PART_HANDLE, 1, 5);
    assert_close(*editing_column(&stage, "angle"), PI / 2, 1e-15);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.x, ==, 1);
    editing_move(&stage, TINKER_PART_WHOLE, 1, 1); /* attached: stays */
    g_assert_cmpint(stage.ends[0].attached, ==, 1);
    editing_move_absolute(&stage, 0, 4, 5);
    g_assert_cmpint(stage.ends[0].attached, ==, 0);
    g_assert_cmpfloat(stage.ends[0].x, ==, 4);
    editing_move(&stage, TINKER_PART_WHOLE, 1, 1);
    g_assert_cmpfloat(stage.ends[0].x, ==, 5);
}

/* A negative force points the other way, and dragging its tip there leaves the angle as it is. */
static void test_motor_tip_of_negative_force(void)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, "motor");
    *editing_column(&stage, "waveform") = -1;
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.x, <, 0);
    editing_move_absolute(&stage, TINKER_PART_HANDLE, -2, 0);
    g_assert_cmpfloat(cos(*editing_column(&stage, "angle")), ==, 1);
}

/* A field stands where the host shows it; its tip turns it. */
static void test_gravity(void)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, "gravity");
    stage.instance.x = stage.instance.y = 3;
    g_assert_cmpint(editing_hit(&stage, 3, 3), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 4, 3), ==, TINKER_PART_NONE);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.x, ==, 3);
    g_assert_cmpfloat(handle.y, <, 3);
    editing_move(&stage, TINKER_PART_WHOLE, 1, 1);
    editing_move_absolute(&stage, TINKER_PART_WHOLE, 1, 1);
    g_assert_cmpint(stage.calls, ==, 0);
    editing_drag_handle(&stage, TINKER_PART_HANDLE, 5, 3);
    g_assert_cmpfloat(*editing_column(&stage, "angle"), ==, 0);
}

static void test_wind(void)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, "wind");
    double *velocity = editing_column(&stage, "velocity");
    g_assert_cmpint(editing_hit(&stage, 0, 0), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(stage.edit->handles(&stage.instance, &handle, 1), ==, 0); /* still air points nowhere */
    velocity[0] = 3;
    velocity[1] = 4;
    editing_drag_handle(&stage, TINKER_PART_HANDLE, 0, -2);
    g_assert_cmpfloat(velocity[0], ==, 0);
    assert_close(velocity[1], -5, 1e-15);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    static const struct {
        const char *name, *data;
        GTestDataFunc function;
    } tests[] = {{"connector", "spring", test_connector},
                 {"connector", "damper", test_connector},
                 {"connector", "rod", test_connector},
                 {"no-length", "spring", test_connector_of_no_length},
                 {"no-length", "damper", test_connector_of_no_length},
                 {"no-length", "rod", test_connector_of_no_length},
                 {"arrow", "motor", test_arrow_of_one_end},
                 {"arrow", "support-motion", test_arrow_of_one_end}};
    for (size_t i = 0; i < G_N_ELEMENTS(tests); i++) {
        g_autofree char *path = g_strdup_printf("/plugins/editing-ends/%s/%s", tests[i].data, tests[i].name);
        g_test_add_data_func(path, tests[i].data, tests[i].function);
    }
    g_test_add_func("/plugins/editing-ends/motor/negative-force", test_motor_tip_of_negative_force);
    g_test_add_func("/plugins/editing-ends/gravity/tip", test_gravity);
    g_test_add_func("/plugins/editing-ends/wind/tip", test_wind);
    return g_test_run();
}
