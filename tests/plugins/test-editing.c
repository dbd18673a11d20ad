/* Hit, move and handles of bodies and of what hangs. */
#include <float.h>
#include <math.h>

#include "editing-stage.h"

/* A box of 4 m x 0.4 m about (1, 2), upright and turned. */
static void test_box_hit(gconstpointer data)
{
    EditingStage stage;
    editing_init(&stage, data);
    stage.instance.x = 1;
    stage.instance.y = 2;
    *editing_column(&stage, "width") = 4;
    *editing_column(&stage, "height") = 0.4;
    g_assert_cmpint(editing_hit(&stage, 1, 2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 2.99, 2.19), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 3.04, 2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 3.06, 2), ==, TINKER_PART_NONE);
    g_assert_cmpint(editing_hit(&stage, 3.04, 2.24), ==, TINKER_PART_NONE); /* 0.057 off the corner */
    g_assert_cmpint(editing_hit(&stage, 1, 3.9), ==, TINKER_PART_NONE);
    stage.instance.orientation = PI / 2;
    g_assert_cmpint(editing_hit(&stage, 1, 3.9), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 2.9, 2), ==, TINKER_PART_NONE);
    stage.instance.orientation = PI / 4;
    g_assert_cmpint(editing_hit(&stage, 1 + 1.4, 2 + 1.4), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 1 + 1.4, 2 - 1.4), ==, TINKER_PART_NONE);
    g_assert_cmpint(editing_hit(&stage, NAN, 2), ==, TINKER_PART_NONE);
}

static void test_dot_hit(void)
{
    EditingStage stage;
    editing_init(&stage, "mass");
    *editing_column(&stage, "width") = *editing_column(&stage, "height") = 0;
    g_assert_cmpint(editing_hit(&stage, 0.03, 0.03), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 0.04, 0.04), ==, TINKER_PART_NONE);
}

/* Moving sets the place and leaves the local origin alone. */
static void test_box_move(gconstpointer data)
{
    EditingStage stage;
    editing_init(&stage, data);
    double *position = editing_column(&stage, "position"), *origin = editing_column(&stage, "local_origin");
    editing_move(&stage, TINKER_PART_WHOLE, 0.5, -0.25);
    g_assert_cmpfloat(position[0], ==, 0.5);
    g_assert_cmpfloat(position[1], ==, -0.25);
    g_assert_cmpfloat(origin[0], ==, 0);
    stage.instance.x = 0.5;
    stage.instance.y = -0.25;
    editing_move_absolute(&stage, TINKER_PART_WHOLE, 3.2, 2.4);
    g_assert_cmpfloat(position[0], ==, 3.2);
    g_assert_cmpfloat(position[1], ==, 2.4);
    /* Displaced by a motion: it is the drawn centre that comes to lie there. */
    stage.instance.x = 3.2 + 0.25;
    stage.instance.y = 2.4;
    editing_move_absolute(&stage, TINKER_PART_WHOLE, 1, 1);
    assert_close(position[0], 0.75, 1e-15);
    g_assert_cmpfloat(position[1], ==, 1);
    g_assert_cmpfloat(origin[0], ==, 0);
    g_assert_cmpfloat(origin[1], ==, 0);
}

static void test_box_handles(gconstpointer data)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, data);
    stage.instance.x = 1;
    stage.instance.y = 2;
    stage.instance.orientation = PI / 2;
    editing_drag_handle(&stage, TINKER_PART_HANDLE + 0, 0.5, 5); /* own axes: 3 along x, 0.5 along y */
    assert_close(*editing_column(&stage, "width"), 6, 1e-15);
    assert_close(*editing_column(&stage, "height"), 1, 1e-15);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE + 0, &handle));
    assert_close(handle.x, 0.5, 1e-15);
    assert_close(handle.y, 5, 1e-15);
    editing_drag_handle(&stage, TINKER_PART_HANDLE + 1, 1 + 3, 2 + 3); /* the top faces up and right */
    assert_close(*editing_column(&stage, "orientation"), -PI / 4, 1e-14);
    editing_drag_handle(&stage, TINKER_PART_HANDLE + 1, 1, 7);
    g_assert_cmpfloat_with_epsilon(*editing_column(&stage, "orientation"), 0, 1e-14);
    editing_move_absolute(&stage, TINKER_PART_HANDLE + 1, 1, 2); /* the centre itself has no direction */
    g_assert_cmpfloat_with_epsilon(*editing_column(&stage, "orientation"), 0, 1e-14);
    editing_move_absolute(&stage, TINKER_PART_HANDLE + 2, -3, 4);
    g_assert_cmpfloat(editing_column(&stage, "local_origin")[0], ==, -3);
    g_assert_cmpfloat(editing_column(&stage, "local_origin")[1], ==, 4);
    g_assert_cmpfloat(editing_column(&stage, "position")[0], ==, 0);
    g_assert_cmpint(stage.edit->handles(&stage.instance, &handle, 1), ==, 1);
    g_assert_cmpint(stage.edit->handles(&stage.instance, &handle, 0), ==, 0);
}

/* y = cosh(x), of which 2 sinh(1) hang between places at x = -1 and 1: hit at its lowest point, and taut at its way. */
static void assert_hit_where_it_hangs(EditingStage *stage)
{
    *editing_column(stage, "length") = 2 * sinh(1);
    g_assert_cmpint(editing_hit(stage, 0, 1), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(stage, 0, cosh(1)), ==, TINKER_PART_NONE);
    *editing_column(stage, "length") = 2;
    g_assert_cmpint(editing_hit(stage, 0, 1), ==, TINKER_PART_NONE);
    g_assert_cmpint(editing_hit(stage, 0, cosh(1)), ==, TINKER_PART_WHOLE);
}

static void test_hanging(void)
{
    EditingStage stage;
    editing_init(&stage, "rope");
    stage.instance.ends = 2;
    stage.ends[0] = (TinkerEnd){.x = -1, .y = cosh(1)};
    stage.ends[1] = (TinkerEnd){.x = 1, .y = cosh(1)};
    assert_hit_where_it_hangs(&stage);
    editing_init(&stage, "cord"); /* it leaves the top of its disc */
    *editing_column(&stage, "radius") = 0.5;
    stage.ends[0] = (TinkerEnd){.x = -1, .y = cosh(1) - 0.5};
    stage.ends[1] = (TinkerEnd){.x = 1, .y = cosh(1)};
    assert_hit_where_it_hangs(&stage);
}

/* A cord that leaves a disc of 0.5 m about the origin for a load below it on the left, seen from the disc: at (0.3,
 * -0.4), 0.625 m away, as 0.4 = 0.5 * 0.5 / 0.625. Its second handle lies where it would leave on the other side;
 * dragged anywhere on that side it takes the cord there, and back. */
static void test_cord_sides(void)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, "cord");
    *editing_column(&stage, "radius") = 0.5;
    stage.ends[0] = (TinkerEnd){0, 0, 1, 0, 0};
    stage.ends[1] = (TinkerEnd){0, -0.625, 1, 0, 0};
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE, &handle));
    assert_close(handle.x, 0.3, 1e-15);
    assert_close(handle.y, -0.4, 1e-15);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE + 1, &handle));
    assert_close(handle.x, -0.3, 1e-15);
    assert_close(handle.y, -0.4, 1e-15);
    editing_move(&stage, TINKER_PART_HANDLE + 1, -0.1, 0.05);
    g_assert_cmpfloat(*editing_column(&stage, "side"), ==, 1);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE, &handle));
    assert_close(handle.x, -0.3, 1e-15);
    const int calls = stage.calls;
    editing_move_absolute(&stage, TINKER_PART_HANDLE + 1, -0.7, 2); /* still there */
    g_assert_cmpint(stage.calls, ==, calls);
    editing_move_absolute(&stage, TINKER_PART_HANDLE + 1, 0.2, 2);
    g_assert_cmpfloat(*editing_column(&stage, "side"), ==, 0);
    assert_close(*editing_column(&stage, "radius"), 0.5, 0);
}

/* Of a slab of 4 m x 0.4 m that is not solid a pin is drawn: 0.4 m wide, its top at (1, 2). */
static void test_pivot(void)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, "support");
    stage.instance.x = 1;
    stage.instance.y = 2;
    *editing_column(&stage, "solid") = 0;
    g_assert_cmpint(editing_hit(&stage, 1, 2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 1.19, 1.81), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 1.3, 1.9), ==, TINKER_PART_NONE);
    g_assert_cmpint(editing_hit(&stage, 1, 2.1), ==, TINKER_PART_NONE); /* what hangs there can be taken */
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE + 0, &handle));
    assert_close(handle.x, 1.2, 1e-15);
    assert_close(handle.y, 2.2, 1e-15);
    stage.instance.orientation = PI; /* hung from above */
    g_assert_cmpint(editing_hit(&stage, 0.81, 2.19), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(editing_hit(&stage, 1, 1.9), ==, TINKER_PART_NONE);
}

/* A local origin on the centre must not keep the mass from being taken by its middle. */
static void test_local_origin_leaves_the_centre_free(void)
{
    EditingStage stage;
    TinkerHandle handle = {0};
    editing_init(&stage, "mass");
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE + 2, &handle));
    g_assert_cmpfloat(fmax(fabs(handle.x), fabs(handle.y)), >, 0.4);
    editing_move(&stage, TINKER_PART_HANDLE + 2, 1, 2);
    g_assert_true(editing_find_handle(&stage, TINKER_PART_HANDLE + 2, &handle));
    g_assert_cmpfloat(handle.x, ==, 1);
    g_assert_cmpfloat(handle.y, ==, 2);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    static const struct {
        const char *name, *data;
        GTestDataFunc function;
    } tests[] = {{"box-hit", "mass", test_box_hit},         {"box-hit", "support", test_box_hit},
                 {"box-move", "mass", test_box_move},       {"box-move", "support", test_box_move},
                 {"box-handles", "mass", test_box_handles}, {"box-handles", "support", test_box_handles}};
    for (size_t i = 0; i < G_N_ELEMENTS(tests); i++) {
        g_autofree char *path = g_strdup_printf("/plugins/editing/%s/%s", tests[i].data, tests[i].name);
        g_test_add_data_func(path, tests[i].data, tests[i].function);
    }
    g_test_add_func("/plugins/editing/hanging", test_hanging);
    g_test_add_func("/plugins/editing/support/pivot", test_pivot);
    g_test_add_func("/plugins/editing/mass/dot", test_dot_hit);
    g_test_add_func("/plugins/editing/mass/local-origin", test_local_origin_leaves_the_centre_free);
    g_test_add_func("/plugins/editing/cord-sides", test_cord_sides);
    return g_test_run();
}
