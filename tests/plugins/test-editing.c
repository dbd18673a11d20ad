/* Hit, move and handles, through an editor that carries out what it is told on the instance itself. */
#include <float.h>
#include <math.h>

#include "plugin-fixture.h"

#define PI    3.14159265358979323846
#define REACH 0.05

/* One block on a canvas, and the editor that changes it. */
typedef struct {
    const TinkerBlockType *block;
    const TinkerEdit *edit;
    double columns[32];
    TinkerEnd ends[2];
    TinkerInstance instance;
    TinkerEditor editor;
    int calls;
} Stage;

static void stage_set(const TinkerEditor *editor, int32_t column, double value)
{
    Stage *stage = editor->context;
    g_assert_cmpint(column, >=, 0);
    g_assert_cmpint(column, <, block_columns(stage->block));
    stage->columns[column] = value;
    stage->calls++;
}

static void stage_set_end(const TinkerEditor *editor, int32_t end, double x, double y)
{
    Stage *stage = editor->context;
    g_assert_cmpint(end, >=, 0);
    g_assert_cmpint(end, <, stage->instance.ends);
    stage->ends[end] = (TinkerEnd){x, y, 0, 0, 0};
    stage->calls++;
}

static void stage_init(Stage *stage, const char *name)
{
    g_autoptr(BlockBatch) defaults = block_batch_new(block_open(name), 1);
    *stage = (Stage){.block = defaults->block, .edit = block_interface(defaults->block, TINKER_EDIT_INTERFACE)};
    for (int32_t column = 0; column < block_columns(stage->block); column++) {
        stage->columns[column] = defaults->columns[column][0];
    }
    stage->instance = (TinkerInstance){.struct_size = sizeof(TinkerInstance),
                                       .ends = stage->block->most_ends,
                                       .name = name,
                                       .columns = stage->columns,
                                       .end = stage->ends,
                                       .symbol_size = 0.2};
    stage->editor = (TinkerEditor){
        .struct_size = sizeof(TinkerEditor), .context = stage, .set = stage_set, .set_end = stage_set_end};
}

static double *stage_column(Stage *stage, const char *property)
{
    return &stage->columns[block_column(stage->block, property)];
}

static int32_t hit(Stage *stage, double x, double y)
{
    return stage->edit->hit(&stage->instance, x, y, REACH);
}

static void move(Stage *stage, int32_t part, double dx, double dy)
{
    stage->edit->move(&stage->instance, part, dx, dy, &stage->editor);
}

static void move_absolute(Stage *stage, int32_t part, double x, double y)
{
    stage->edit->move_absolute(&stage->instance, part, x, y, &stage->editor);
}

/* A box of 4 m x 0.4 m about (1, 2), upright and turned. */
static void test_box_hit(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    stage.instance.x = 1;
    stage.instance.y = 2;
    *stage_column(&stage, "width") = 4;
    *stage_column(&stage, "height") = 0.4;
    g_assert_cmpint(hit(&stage, 1, 2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 2.99, 2.19), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 3.04, 2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 3.06, 2), ==, TINKER_PART_NONE);
    g_assert_cmpint(hit(&stage, 3.04, 2.24), ==, TINKER_PART_NONE); /* 0.057 off the corner */
    g_assert_cmpint(hit(&stage, 1, 3.9), ==, TINKER_PART_NONE);
    stage.instance.orientation = PI / 2;
    g_assert_cmpint(hit(&stage, 1, 3.9), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 2.9, 2), ==, TINKER_PART_NONE);
    stage.instance.orientation = PI / 4;
    g_assert_cmpint(hit(&stage, 1 + 1.4, 2 + 1.4), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 1 + 1.4, 2 - 1.4), ==, TINKER_PART_NONE);
    g_assert_cmpint(hit(&stage, NAN, 2), ==, TINKER_PART_NONE);
}

static void test_dot_hit(void)
{
    Stage stage;
    stage_init(&stage, "mass");
    *stage_column(&stage, "width") = *stage_column(&stage, "height") = 0;
    g_assert_cmpint(hit(&stage, 0.03, 0.03), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 0.04, 0.04), ==, TINKER_PART_NONE);
}

/* Moving sets the place and leaves the local origin alone. */
static void test_box_move(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    double *position = stage_column(&stage, "position"), *origin = stage_column(&stage, "local_origin");
    move(&stage, TINKER_PART_WHOLE, 0.5, -0.25);
    g_assert_cmpfloat(position[0], ==, 0.5);
    g_assert_cmpfloat(position[1], ==, -0.25);
    g_assert_cmpfloat(origin[0], ==, 0);
    stage.instance.x = 0.5;
    stage.instance.y = -0.25;
    move_absolute(&stage, TINKER_PART_WHOLE, 3.2, 2.4);
    g_assert_cmpfloat(position[0], ==, 3.2);
    g_assert_cmpfloat(position[1], ==, 2.4);
    /* Displaced by a motion: it is the drawn centre that comes to lie there. */
    stage.instance.x = 3.2 + 0.25;
    stage.instance.y = 2.4;
    move_absolute(&stage, TINKER_PART_WHOLE, 1, 1);
    assert_close(position[0], 0.75, 1e-15);
    g_assert_cmpfloat(position[1], ==, 1);
    g_assert_cmpfloat(origin[0], ==, 0);
    g_assert_cmpfloat(origin[1], ==, 0);
}

static gboolean find_handle(Stage *stage, int32_t part, TinkerHandle *found)
{
    TinkerHandle handles[8];
    const int32_t count = stage->edit->handles(&stage->instance, handles, 8);
    for (int32_t k = 0; k < count; k++) {
        if (handles[k].part == part) {
            *found = handles[k];
            return TRUE;
        }
    }
    return FALSE;
}

/* A handle that is dragged somewhere lies there afterwards. */
static void drag_handle(Stage *stage, int32_t part, double x, double y)
{
    TinkerHandle handle = {0};
    g_assert_true(find_handle(stage, part, &handle));
    move(stage, part, x - handle.x, y - handle.y);
}

static void test_box_handles(gconstpointer data)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, data);
    stage.instance.x = 1;
    stage.instance.y = 2;
    stage.instance.orientation = PI / 2;
    drag_handle(&stage, TINKER_PART_HANDLE + 0, 0.5, 5); /* own axes: 3 along x, 0.5 along y */
    assert_close(*stage_column(&stage, "width"), 6, 1e-15);
    assert_close(*stage_column(&stage, "height"), 1, 1e-15);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE + 0, &handle));
    assert_close(handle.x, 0.5, 1e-15);
    assert_close(handle.y, 5, 1e-15);
    drag_handle(&stage, TINKER_PART_HANDLE + 1, 1 + 3, 2 + 3); /* the top faces up and right */
    assert_close(*stage_column(&stage, "orientation"), -PI / 4, 1e-14);
    drag_handle(&stage, TINKER_PART_HANDLE + 1, 1, 7);
    g_assert_cmpfloat_with_epsilon(*stage_column(&stage, "orientation"), 0, 1e-14);
    move_absolute(&stage, TINKER_PART_HANDLE + 1, 1, 2); /* the centre itself has no direction */
    g_assert_cmpfloat_with_epsilon(*stage_column(&stage, "orientation"), 0, 1e-14);
    move_absolute(&stage, TINKER_PART_HANDLE + 2, -3, 4);
    g_assert_cmpfloat(stage_column(&stage, "local_origin")[0], ==, -3);
    g_assert_cmpfloat(stage_column(&stage, "local_origin")[1], ==, 4);
    g_assert_cmpfloat(stage_column(&stage, "position")[0], ==, 0);
    g_assert_cmpint(stage.edit->handles(&stage.instance, &handle, 1), ==, 1);
    g_assert_cmpint(stage.edit->handles(&stage.instance, &handle, 0), ==, 0);
}

/* y = cosh(x), of which 2 sinh(1) hang between places at x = -1 and 1: hit at its lowest point, and taut at its way. */
static void assert_hit_where_it_hangs(Stage *stage)
{
    *stage_column(stage, "length") = 2 * sinh(1);
    g_assert_cmpint(hit(stage, 0, 1), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(stage, 0, cosh(1)), ==, TINKER_PART_NONE);
    *stage_column(stage, "length") = 2;
    g_assert_cmpint(hit(stage, 0, 1), ==, TINKER_PART_NONE);
    g_assert_cmpint(hit(stage, 0, cosh(1)), ==, TINKER_PART_WHOLE);
}

static void test_hanging(void)
{
    Stage stage;
    stage_init(&stage, "rope");
    stage.instance.ends = 2;
    stage.ends[0] = (TinkerEnd){.x = -1, .y = cosh(1)};
    stage.ends[1] = (TinkerEnd){.x = 1, .y = cosh(1)};
    assert_hit_where_it_hangs(&stage);
    stage_init(&stage, "cord"); /* it leaves the top of its disc */
    *stage_column(&stage, "radius") = 0.5;
    stage.ends[0] = (TinkerEnd){.x = -1, .y = cosh(1) - 0.5};
    stage.ends[1] = (TinkerEnd){.x = 1, .y = cosh(1)};
    assert_hit_where_it_hangs(&stage);
}

/* A cord that leaves a disc of 0.5 m about the origin for a load below it on the left, seen from the disc: at (0.3,
 * -0.4), 0.625 m away, as 0.4 = 0.5 * 0.5 / 0.625. Its second handle lies where it would leave on the other side;
 * dragged anywhere on that side it takes the cord there, and back. */
static void test_cord_sides(void)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, "cord");
    *stage_column(&stage, "radius") = 0.5;
    stage.ends[0] = (TinkerEnd){0, 0, 1, 0, 0};
    stage.ends[1] = (TinkerEnd){0, -0.625, 1, 0, 0};
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE, &handle));
    assert_close(handle.x, 0.3, 1e-15);
    assert_close(handle.y, -0.4, 1e-15);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE + 1, &handle));
    assert_close(handle.x, -0.3, 1e-15);
    assert_close(handle.y, -0.4, 1e-15);
    move(&stage, TINKER_PART_HANDLE + 1, -0.1, 0.05);
    g_assert_cmpfloat(*stage_column(&stage, "side"), ==, 1);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE, &handle));
    assert_close(handle.x, -0.3, 1e-15);
    const int calls = stage.calls;
    move_absolute(&stage, TINKER_PART_HANDLE + 1, -0.7, 2); /* still there */
    g_assert_cmpint(stage.calls, ==, calls);
    move_absolute(&stage, TINKER_PART_HANDLE + 1, 0.2, 2);
    g_assert_cmpfloat(*stage_column(&stage, "side"), ==, 0);
    assert_close(*stage_column(&stage, "radius"), 0.5, 0);
}

/* Of a slab of 4 m x 0.4 m that is not solid a pin is drawn: 0.4 m wide, its top at (1, 2). */
static void test_pivot(void)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, "support");
    stage.instance.x = 1;
    stage.instance.y = 2;
    *stage_column(&stage, "solid") = 0;
    g_assert_cmpint(hit(&stage, 1, 2), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 1.19, 1.81), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 1.3, 1.9), ==, TINKER_PART_NONE);
    g_assert_cmpint(hit(&stage, 1, 2.1), ==, TINKER_PART_NONE); /* what hangs there can be taken */
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE + 0, &handle));
    assert_close(handle.x, 1.2, 1e-15);
    assert_close(handle.y, 2.2, 1e-15);
    stage.instance.orientation = PI; /* hung from above */
    g_assert_cmpint(hit(&stage, 0.81, 2.19), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 1, 1.9), ==, TINKER_PART_NONE);
}

/* A local origin on the centre must not keep the mass from being taken by its middle. */
static void test_local_origin_leaves_the_centre_free(void)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, "mass");
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE + 2, &handle));
    g_assert_cmpfloat(fmax(fabs(handle.x), fabs(handle.y)), >, 0.4);
    move(&stage, TINKER_PART_HANDLE + 2, 1, 2);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE + 2, &handle));
    g_assert_cmpfloat(handle.x, ==, 1);
    g_assert_cmpfloat(handle.y, ==, 2);
}

static void test_connector(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    stage.ends[0] = (TinkerEnd){0, 0, 1, 0, 0};
    stage.ends[1] = (TinkerEnd){3, 4, 0, 0, 0};
    stage.instance.x = 1.5;
    stage.instance.y = 2;
    g_assert_cmpint(hit(&stage, 0.02, 0.01), ==, 0);
    g_assert_cmpint(hit(&stage, 3.03, 4.03), ==, 1);
    g_assert_cmpint(hit(&stage, 1.5, 2.04), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 1.5, 2.2), ==, TINKER_PART_NONE);
    g_assert_cmpint(hit(&stage, 6, 8), ==, TINKER_PART_NONE);
    move(&stage, TINKER_PART_WHOLE, 1, 1); /* the attached end stays */
    g_assert_cmpfloat(stage.ends[0].x, ==, 0);
    g_assert_cmpint(stage.ends[0].attached, ==, 1);
    g_assert_cmpfloat(stage.ends[1].x, ==, 4);
    move(&stage, 0, 0.5, 0.25); /* and comes off when it is itself taken */
    g_assert_cmpint(stage.ends[0].attached, ==, 0);
    g_assert_cmpfloat(stage.ends[0].x, ==, 0.5);
    g_assert_cmpfloat(stage.ends[0].y, ==, 0.25);
    move_absolute(&stage, 1, 7, 8);
    g_assert_cmpfloat(stage.ends[1].x, ==, 7);
    g_assert_cmpfloat(stage.ends[1].y, ==, 8);
    stage.instance.x = 3.75;
    stage.instance.y = 4.125;
    move_absolute(&stage, TINKER_PART_WHOLE, 4.75, 4.125); /* both are free: the middle goes there */
    g_assert_cmpfloat(stage.ends[0].x, ==, 1.5);
    g_assert_cmpfloat(stage.ends[1].x, ==, 8);
    g_assert_cmpfloat(stage.ends[1].y, ==, 8);
    move(&stage, 17, 1, 1); /* parts that it does not have */
    move_absolute(&stage, TINKER_PART_NONE, 1, 1);
    g_assert_cmpfloat(stage.ends[0].x, ==, 1.5);
}

/* Ends that lie on one another: the point is within reach of both, and one of them is taken. */
static void test_connector_of_no_length(gconstpointer data)
{
    Stage stage;
    stage_init(&stage, data);
    g_assert_cmpint(hit(&stage, 0, 0), !=, TINKER_PART_NONE);
    g_assert_cmpint(hit(&stage, 1, 0), ==, TINKER_PART_NONE);
}

static void test_arrow_of_one_end(gconstpointer data)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, data);
    stage.ends[0] = (TinkerEnd){1, 1, 1, 0, 0};
    stage.instance.x = stage.instance.y = 1;
    *stage_column(&stage, "waveform") = 1;
    g_assert_cmpint(hit(&stage, 1, 1), ==, 0);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.y, ==, 1);
    g_assert_cmpint(hit(&stage, (1 + handle.x) / 2, 1), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, (1 + handle.x) / 2, 1.2), ==, TINKER_PART_NONE);
    drag_handle(&stage, TINKER_PART_HANDLE, 1, 5);
    assert_close(*stage_column(&stage, "angle"), PI / 2, 1e-15);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.x, ==, 1);
    move(&stage, TINKER_PART_WHOLE, 1, 1); /* attached: stays */
    g_assert_cmpint(stage.ends[0].attached, ==, 1);
    move_absolute(&stage, 0, 4, 5);
    g_assert_cmpint(stage.ends[0].attached, ==, 0);
    g_assert_cmpfloat(stage.ends[0].x, ==, 4);
    move(&stage, TINKER_PART_WHOLE, 1, 1);
    g_assert_cmpfloat(stage.ends[0].x, ==, 5);
}

/* A negative force points the other way, and dragging its tip there leaves the angle as it is. */
static void test_motor_tip_of_negative_force(void)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, "motor");
    *stage_column(&stage, "waveform") = -1;
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.x, <, 0);
    move_absolute(&stage, TINKER_PART_HANDLE, -2, 0);
    g_assert_cmpfloat(cos(*stage_column(&stage, "angle")), ==, 1);
}

/* A field stands where the host shows it; its tip turns it. */
static void test_gravity(void)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, "gravity");
    stage.instance.x = stage.instance.y = 3;
    g_assert_cmpint(hit(&stage, 3, 3), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(hit(&stage, 4, 3), ==, TINKER_PART_NONE);
    g_assert_true(find_handle(&stage, TINKER_PART_HANDLE, &handle));
    g_assert_cmpfloat(handle.x, ==, 3);
    g_assert_cmpfloat(handle.y, <, 3);
    move(&stage, TINKER_PART_WHOLE, 1, 1);
    move_absolute(&stage, TINKER_PART_WHOLE, 1, 1);
    g_assert_cmpint(stage.calls, ==, 0);
    drag_handle(&stage, TINKER_PART_HANDLE, 5, 3);
    g_assert_cmpfloat(*stage_column(&stage, "angle"), ==, 0);
}

static void test_wind(void)
{
    Stage stage;
    TinkerHandle handle = {0};
    stage_init(&stage, "wind");
    double *velocity = stage_column(&stage, "velocity");
    g_assert_cmpint(hit(&stage, 0, 0), ==, TINKER_PART_WHOLE);
    g_assert_cmpint(stage.edit->handles(&stage.instance, &handle, 1), ==, 0); /* still air points nowhere */
    velocity[0] = 3;
    velocity[1] = 4;
    drag_handle(&stage, TINKER_PART_HANDLE, 0, -2);
    g_assert_cmpfloat(velocity[0], ==, 0);
    assert_close(velocity[1], -5, 1e-15);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    static const struct {
        const char *name, *data;
        GTestDataFunc function;
    } tests[] = {{"box-hit", "mass", test_box_hit},
                 {"box-hit", "support", test_box_hit},
                 {"box-move", "mass", test_box_move},
                 {"box-move", "support", test_box_move},
                 {"box-handles", "mass", test_box_handles},
                 {"box-handles", "support", test_box_handles},
                 {"connector", "spring", test_connector},
                 {"connector", "damper", test_connector},
                 {"connector", "rod", test_connector},
                 {"no-length", "spring", test_connector_of_no_length},
                 {"no-length", "damper", test_connector_of_no_length},
                 {"no-length", "rod", test_connector_of_no_length},
                 {"arrow", "motor", test_arrow_of_one_end},
                 {"arrow", "support-motion", test_arrow_of_one_end}};
    for (size_t i = 0; i < G_N_ELEMENTS(tests); i++) {
        g_autofree char *path = g_strdup_printf("/plugins/editing/%s/%s", tests[i].data, tests[i].name);
        g_test_add_data_func(path, tests[i].data, tests[i].function);
    }
    g_test_add_func("/plugins/editing/hanging", test_hanging);
    g_test_add_func("/plugins/editing/support/pivot", test_pivot);
    g_test_add_func("/plugins/editing/mass/dot", test_dot_hit);
    g_test_add_func("/plugins/editing/mass/local-origin", test_local_origin_leaves_the_centre_free);
    g_test_add_func("/plugins/editing/motor/negative-force", test_motor_tip_of_negative_force);
    g_test_add_func("/plugins/editing/gravity/tip", test_gravity);
    g_test_add_func("/plugins/editing/wind/tip", test_wind);
    g_test_add_func("/plugins/editing/cord-sides", test_cord_sides);
    return g_test_run();
}
