/* What each block lets one graph, against closed forms. */
#include <math.h>

#include "plugin-fixture.h"

static void test_mass(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("mass"), 1);
    block_batch_set(batch, 0, "mass", 0, 2);
    const TinkerPoint centre = {1, -2, 3, -4};
    const double acceleration[2] = {5, -12};
    const TinkerGraphInput input = {
        .struct_size = sizeof(TinkerGraphInput), .ends = &centre, .accelerations = acceleration};
    const struct {
        const char *quantity;
        double value;
    } rows[] = {{"x", 1},          {"y", -2},          {"vx", 3},           {"vy", -4},
                {"ax", 5},         {"ay", -12},        {"speed", 5},        {"kinetic energy", 25},
                {"x momentum", 6}, {"y momentum", -8}, {"acceleration", 13}};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_assert_cmpfloat(block_quantity_value(batch, &input, rows[i].quantity), ==, rows[i].value);
    }
}

static void test_support(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("support"), 1);
    const TinkerPoint centre = {1, -2, 3, -4};
    const double acceleration[2] = {5, -6};
    const TinkerGraphInput input = {
        .struct_size = sizeof(TinkerGraphInput), .ends = &centre, .accelerations = acceleration};
    static const char *const ids[] = {"x", "y", "vx", "vy", "ax", "ay"};
    static const double values[] = {1, -2, 3, -4, 5, -6};
    for (size_t i = 0; i < G_N_ELEMENTS(ids); i++) {
        g_assert_cmpfloat(block_quantity_value(batch, &input, ids[i]), ==, values[i]);
    }
}

/* Of both blocks alike: pressed with 12 N, pushed by 5 N along a top that is turned by 90 degrees. */
static void check_contact(const char *block)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open(block), 1);
    const TinkerPoint centre = {0, 0, 0, 0};
    const double contacts[4] = {12, -5, -12, -5};
    TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = &centre, .contacts = contacts};
    g_assert_cmpfloat(block_quantity_value(batch, &input, "normal force"), ==, 12);
    g_assert_cmpfloat(block_quantity_value(batch, &input, "friction force"), ==, -5);
    g_assert_cmpfloat(block_quantity_value(batch, &input, "contact force"), ==, 13);

    static const char *const ids[] = {"normal force", "friction force", "contact force"};
    for (size_t i = 0; i < G_N_ELEMENTS(ids); i++) {
        /* A host that was built before there were contacts, and one that has none to tell of. */
        input.contacts = contacts;
        input.struct_size = offsetof(TinkerGraphInput, contacts);
        g_assert_cmpfloat(block_quantity_value(batch, &input, ids[i]), ==, 0);
        input.contacts = NULL;
        input.struct_size = sizeof(TinkerGraphInput);
        g_assert_cmpfloat(block_quantity_value(batch, &input, ids[i]), ==, 0);
        g_assert_cmpstr(block_quantity(batch->block, block_quantity_number(batch->block, ids[i]))->id, ==, ids[i]);
    }
}

/* Each instance has numbers of its own. */
static void test_contact(void)
{
    check_contact("mass");
    check_contact("support");
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("mass"), 2);
    const TinkerPoint centres[2] = {{0, 0, 0, 0}, {1, 0, 0, 0}};
    const double contacts[8] = {1, 2, 3, 4, 5, 6, 8, 15};
    const TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = centres, .contacts = contacts};
    const TinkerGraph *graph = block_interface(batch->block, TINKER_GRAPH_INTERFACE);
    const double expected[3][2] = {{1, 5}, {2, 6}, {5, 17}};
    const int32_t first = block_quantity_number(batch->block, "normal force");
    for (int k = 0; k < 3; k++) {
        TinkerBatch view = block_batch_view(batch, 0, 2);
        double value[2];
        g_assert_cmpint(graph->values(&view, &input, first + k, value), ==, TINKER_OK);
        g_assert_cmpfloat(value[0], ==, expected[k][0]);
        g_assert_cmpfloat(value[1], ==, expected[k][1]);
    }
}

/* What the host does not know yet is refused, not made up. */
static void test_unknown(void)
{
    static const struct {
        const char *block, *quantity;
    } rows[] = {{"mass", "ax"}, {"support", "ay"}, {"rod", "tension"}};
    for (size_t i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(BlockBatch) batch = block_batch_new(block_open(rows[i].block), 1);
        const TinkerPoint ends[2] = {{0, 0, 0, 0}, {1, 0, 0, 0}};
        const TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = ends};
        const TinkerGraph *graph = block_interface(batch->block, TINKER_GRAPH_INTERFACE);
        TinkerBatch view = block_batch_view(batch, 0, 1);
        double value;
        g_assert_cmpint(graph->values(&view, &input, block_quantity_number(batch->block, rows[i].quantity), &value), ==,
                        TINKER_FAILED);
        g_assert_nonnull(view.failure);
    }
}

/* Ends 5 m apart along (0.6, 0.8), moving apart at 2 m/s along it and at 1 m/s across. */
static const TinkerPoint slanted[2] = {{1, 1, 0, 0}, {4, 5, 0.6 * 2 - 0.8, 0.8 * 2 + 0.6}};

static void test_connectors(void)
{
    const double multiplier = -7;
    const TinkerGraphInput input = {
        .struct_size = sizeof(TinkerGraphInput), .ends = slanted, .multipliers = &multiplier};
    g_autoptr(BlockBatch) spring = block_batch_new(block_open("spring"), 1);
    block_batch_set(spring, 0, "stiffness", 0, 10);
    block_batch_set(spring, 0, "rest_length", 0, 7);
    assert_close(block_quantity_value(spring, &input, "length"), 5, 1e-15);
    assert_close(block_quantity_value(spring, &input, "extension"), -2, 1e-15);
    assert_close(block_quantity_value(spring, &input, "tension"), -20, 1e-15);
    assert_close(block_quantity_value(spring, &input, "energy"), 20, 1e-15);
    g_autoptr(BlockBatch) damper = block_batch_new(block_open("damper"), 1);
    block_batch_set(damper, 0, "damping", 0, 3);
    assert_close(block_quantity_value(damper, &input, "rate"), 2, 1e-15);
    assert_close(block_quantity_value(damper, &input, "tension"), 6, 1e-15);
    assert_close(block_quantity_value(damper, &input, "dissipated power"), 12, 1e-15);
    g_autoptr(BlockBatch) rod = block_batch_new(block_open("rod"), 1);
    block_batch_set(rod, 0, "length", 0, 4.75);
    g_assert_cmpfloat(block_quantity_value(rod, &input, "tension"), ==, 7);
    assert_close(block_quantity_value(rod, &input, "length error"), 0.25, 1e-14);
}

/* Where the ends coincide a damper has no rate, and nothing is infinite. */
static void test_coinciding_ends(void)
{
    const TinkerPoint ends[2] = {{1, 1, 0, 0}, {1, 1, 3, 4}};
    const TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = ends};
    g_autoptr(BlockBatch) damper = block_batch_new(block_open("damper"), 1);
    g_assert_cmpfloat(block_quantity_value(damper, &input, "rate"), ==, 0);
    g_assert_cmpfloat(block_quantity_value(damper, &input, "tension"), ==, 0);
    g_autoptr(BlockBatch) spring = block_batch_new(block_open("spring"), 1);
    g_assert_cmpfloat(block_quantity_value(spring, &input, "length"), ==, 0);
}

static void test_motor_and_motion(void)
{
    const TinkerPoint end = {0, 0, 3, 5};
    const TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = &end};
    g_autoptr(BlockBatch) motor = block_batch_new(block_open("motor"), 1);
    block_batch_set(motor, 0, "waveform", 0, -4);
    g_assert_cmpfloat(block_quantity_value(motor, &input, "force"), ==, -4);
    g_assert_cmpfloat(block_quantity_value(motor, &input, "power"), ==, -12);
    block_batch_set(motor, 0, "angle", 0, -TINKER_PI / 2);
    g_assert_cmpfloat(block_quantity_value(motor, &input, "power"), ==, 20);
    g_autoptr(BlockBatch) motion = block_batch_new(block_open("support-motion"), 1);
    static const char *const ids[] = {"displacement", "velocity", "acceleration"};
    for (int k = 0; k < 3; k++) {
        block_batch_set(motion, 0, "waveform", k, 10 + k);
    }
    for (int k = 0; k < 3; k++) {
        g_assert_cmpfloat(block_quantity_value(motion, &input, ids[k]), ==, 10 + k);
    }
}

/* Its place is that in the world, though points come relative to an origin. */
static void test_marker(void)
{
    const TinkerPoint end = {5, 2, 3, -4};
    const double acceleration[2] = {7, 8};
    const TinkerGraphInput input = {
        .struct_size = sizeof(TinkerGraphInput), .ends = &end, .accelerations = acceleration};
    g_autoptr(BlockBatch) marker = block_batch_new(block_open("marker"), 1);
    static const struct {
        const char *id;
        double value;
    } rows[] = {{"x", 1005}, {"y", -1998}, {"vx", 3}, {"vy", -4}, {"speed", 5}, {"ax", 7}, {"ay", 8}};
    const TinkerGraph *graph = block_interface(marker->block, TINKER_GRAPH_INTERFACE);
    for (size_t k = 0; k < G_N_ELEMENTS(rows); k++) {
        TinkerBatch view = block_batch_view(marker, 0, 1);
        double value;
        view.origin[0] = 1000;
        view.origin[1] = -2000;
        const int32_t number = block_quantity_number(marker->block, rows[k].id);
        g_assert_cmpint(graph->values(&view, &input, number, &value), ==, TINKER_OK);
        g_assert_cmpfloat(value, ==, rows[k].value);
    }
}

/* The second end is the corner; the ways are turned by known angles and angular velocities about it. */
static void test_angle_mark(void)
{
    static const struct {
        double first, third, angle; /* deg */
    } cases[] = {{0, 90, 90}, {90, 0, -90}, {10, 190, 180}, {-170, 170, -20}, {30, 75, 45}};
    g_autoptr(BlockBatch) mark = block_batch_new(block_open("angle-mark"), 1);
    for (size_t k = 0; k < G_N_ELEMENTS(cases); k++) {
        const double a = cases[k].first * G_PI / 180, b = cases[k].third * G_PI / 180;
        /* Of lengths 2 and 3; the first way turns with 0.5, the third with 2 rad/s, the corner moves with (7, -1). */
        const TinkerPoint ends[3] = {
            {4 + 2 * cos(a), 5 + 2 * sin(a), 7 - 0.5 * 2 * sin(a), -1 + 0.5 * 2 * cos(a)},
            {4, 5, 7, -1},
            {4 + 3 * cos(b), 5 + 3 * sin(b), 7 - 2 * 3 * sin(b), -1 + 2 * 3 * cos(b)},
        };
        const TinkerGraphInput input = {.struct_size = sizeof(TinkerGraphInput), .ends = ends};
        const double angle = block_quantity_value(mark, &input, "angle"), expected = cases[k].angle * G_PI / 180;
        g_assert_cmpfloat(fabs(remainder(angle - expected, 2 * G_PI)), <, 1e-14); /* 180 and -180 are one */
        g_assert_cmpfloat_with_epsilon(block_quantity_value(mark, &input, "angle rate"), 1.5, 1e-14);
    }
}

static void test_fields(void)
{
    const TinkerPoint bodies[2] = {{5, 2, 3, 0}, {7, -1, 0, 1}};
    const double masses[2] = {1, 10};
    const TinkerGraphInput input = {
        .struct_size = sizeof(TinkerGraphInput), .bodies = bodies, .masses = masses, .body_count = 2};
    g_autoptr(BlockBatch) gravity = block_batch_new(block_open("gravity"), 1);
    assert_close(block_quantity_value(gravity, &input, "potential energy"), 9.81 * (1 * 2 - 10 * 1), 1e-15);
    g_autoptr(BlockBatch) wind = block_batch_new(block_open("wind"), 1);
    block_batch_set(wind, 0, "velocity", 0, 1);
    block_batch_set(wind, 0, "drag", 0, 2);
    /* -2 (2, 0) . (3, 0) - 2 (-1, 1) . (0, 1) */
    g_assert_cmpfloat(block_quantity_value(wind, &input, "power"), ==, -14);
    const TinkerGraphInput nobody = {.struct_size = sizeof(TinkerGraphInput)};
    g_assert_cmpfloat(block_quantity_value(wind, &nobody, "power"), ==, 0);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/quantities/mass", test_mass);
    g_test_add_func("/plugins/quantities/support", test_support);
    g_test_add_func("/plugins/quantities/contact", test_contact);
    g_test_add_func("/plugins/quantities/unknown", test_unknown);
    g_test_add_func("/plugins/quantities/connectors", test_connectors);
    g_test_add_func("/plugins/quantities/coinciding-ends", test_coinciding_ends);
    g_test_add_func("/plugins/quantities/motor-and-motion", test_motor_and_motion);
    g_test_add_func("/plugins/quantities/marker", test_marker);
    g_test_add_func("/plugins/quantities/angle-mark", test_angle_mark);
    g_test_add_func("/plugins/quantities/fields", test_fields);
    return g_test_run();
}
