/* What lies under a point, with the real blocks. */
#include <math.h>

#include "edit/drag.h"
#include "scene-fixture.h"

#define REACH 0.1

static const char blocks[] = "{\"type\": \"gravity\", \"name\": \"G\"},"
                             "{\"type\": \"mass\", \"name\": \"Below\", \"position\": [0, 0]},"
                             "{\"type\": \"mass\", \"name\": \"Above\", \"position\": [0.3, 0]},"
                             "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [0, -3]},"
                             "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"Below\", [4, 0]]},"
                             "{\"type\": \"motor\", \"name\": \"M\", \"ends\": [[3, 3]]},"
                             "{\"type\": \"support-motion\", \"name\": \"Shake\", \"ends\": [[-3, 3]]},"
                             "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [8, 0], \"solid\": false},"
                             "{\"type\": \"disc\", \"name\": \"Wheel\", \"position\": [8, 0]},"
                             "{\"type\": \"pulley\", \"name\": \"P\", \"position\": [5, 5]}";

typedef struct {
    TinkerScene *scene;
    TinkerFrame *frame;
} Stage;

static void set_up(Stage *stage, gconstpointer data)
{
    stage->scene = scene_fixture_read_blocks(blocks);
    stage->frame = tinker_frame_new(stage->scene, NULL);
    g_assert_nonnull(stage->frame);
}

static void tear_down(Stage *stage, gconstpointer data)
{
    tinker_frame_free(stage->frame);
    tinker_scene_free(stage->scene);
}

static TinkerBlockId named(const Stage *stage, const char *name)
{
    TinkerBlockId block = tinker_scene_find_block(stage->scene, name);
    g_assert_cmpint(block, !=, TINKER_NO_BLOCK);
    return block;
}

static void expect(const Stage *stage, double x, double y, const char *name, int32_t part)
{
    TinkerHit hit = tinker_hit(stage->frame, x, y, REACH);
    g_assert_cmpint(hit.block, ==, named(stage, name));
    g_assert_cmpint(hit.part, ==, part);
}

static void test_order(Stage *stage, gconstpointer data)
{
    /* The later mass covers the earlier one; an end comes before both; the line of a spring before the mass under it.
     */
    expect(stage, 0.3, 0.3, "Above", TINKER_PART_WHOLE);
    expect(stage, -0.35, 0.3, "Below", TINKER_PART_WHOLE);
    expect(stage, 0.02, 0.02, "S", 0);
    expect(stage, 4, 0.05, "S", 1);
    expect(stage, 2, 0.05, "S", TINKER_PART_WHOLE);
    expect(stage, 1.9, -3.1, "Floor", TINKER_PART_WHOLE);
    /* a pivot lies over what hangs on it, and is no larger than it is drawn */
    expect(stage, 8, -0.1, "Pivot", TINKER_PART_WHOLE);
    expect(stage, 8, 0.3, "Wheel", TINKER_PART_WHOLE);
    TinkerHit nothing = tinker_hit(stage->frame, -4, -1, REACH);
    g_assert_cmpint(nothing.block, ==, TINKER_NO_BLOCK);
    g_assert_cmpint(nothing.part, ==, TINKER_PART_NONE);
}

/* What cannot be dragged itself lets a drag take the body that it is on; with its ends at one place wherever it is hit.
 */
static void test_to_drag(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks("{\"type\": \"support\", \"name\": \"Bearing\", \"solid\": false},"
                                  "{\"type\": \"bar\", \"name\": \"Crank\", \"position\": [0.5, 0]},"
                                  "{\"type\": \"mass\", \"name\": \"M\", \"position\": [4, 0]},"
                                  "{\"type\": \"drive\", \"name\": \"Middle\", \"ends\": [\"Crank\", \"Bearing\"]},"
                                  "{\"type\": \"drive\", \"name\": \"End\", \"ends\": [{\"block\": \"Crank\", "
                                  "\"at\": [-0.5, 0]}, \"Bearing\"]},"
                                  "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"Crank\", \"M\"]},"
                                  "{\"type\": \"spring\", \"name\": \"Loose\", \"ends\": [\"Crank\", [0.5, 3]]}");
    static const struct {
        const char *hit, *dragged;
        double x, y;
    } cases[] = {{"Middle", "Crank", 0.65, 0.02},
                 {"Middle", "Middle", 0.5, 0.3},
                 {"End", "Crank", -0.2, 0.2},
                 {"End", "Crank", 0.15, 0.0},
                 {"S", "S", 2.5, 0.0},
                 {"S", "Crank", 0.8, 0.0},
                 {"Loose", "Loose", 0.5, 0.05},
                 {"M", "M", 4.1, 0.1}};
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        const TinkerHit hit = {tinker_scene_find_block(scene, cases[i].hit), TINKER_PART_WHOLE};
        const TinkerHit to = tinker_hit_to_drag(frame, hit, cases[i].x, cases[i].y, 0.02);
        g_assert_cmpstr(tinker_scene_block_name(scene, to.block), ==, cases[i].dragged);
        g_assert_cmpint(to.part, ==, TINKER_PART_WHOLE);
    }
    g_assert_true(tinker_is_at_one_place(frame, tinker_scene_find_block(scene, "End")));
    g_assert_false(tinker_is_at_one_place(frame, tinker_scene_find_block(scene, "Middle")));
    const TinkerHit end = {tinker_scene_find_block(scene, "Middle"), 0};
    g_assert_cmpint(tinker_hit_to_drag(frame, end, 0.5, 0, 0.02).block, ==, end.block);
}

static void test_connectable(Stage *stage, gconstpointer data)
{
    TinkerBlockId spring = named(stage, "S"), motor = named(stage, "M"), shake = named(stage, "Shake");
    g_assert_cmpint(tinker_hit_connectable(stage->frame, spring, 0.3, 0.3, REACH), ==, named(stage, "Above"));
    g_assert_cmpint(tinker_hit_connectable(stage->frame, spring, 0, -3, REACH), ==, named(stage, "Floor"));
    g_assert_cmpint(tinker_hit_connectable(stage->frame, spring, 3, 3, REACH), ==, TINKER_NO_BLOCK);
    /* A motor drives what can move, a motion what cannot. */
    g_assert_cmpint(tinker_hit_connectable(stage->frame, motor, 0.3, 0.3, REACH), ==, named(stage, "Above"));
    g_assert_cmpint(tinker_hit_connectable(stage->frame, motor, 0, -3, REACH), ==, TINKER_NO_BLOCK);
    g_assert_cmpint(tinker_hit_connectable(stage->frame, shake, 0, -3, REACH), ==, named(stage, "Floor"));
    g_assert_cmpint(tinker_hit_connectable(stage->frame, shake, 0.3, 0.3, REACH), ==, TINKER_NO_BLOCK);
}

/* Every handle that a block declares can be hit. */
static void test_handles(Stage *stage, gconstpointer data)
{
    TinkerBlockId mass = named(stage, "Above");
    TinkerInstance instance;
    TinkerHandle handles[8];
    tinker_frame_set_symbol_size(stage->frame, 0.25);
    g_assert_true(tinker_frame_instance(stage->frame, mass, &instance));
    g_assert_cmpfloat(instance.symbol_size, ==, 0.25);
    const TinkerEdit *edit = tinker_scene_block_class(stage->scene, mass)->edit;
    int32_t count = edit->handles(&instance, handles, 8);
    g_assert_cmpint(count, >, 0);
    for (int32_t i = 0; i < count; i++) {
        TinkerHit hit = tinker_hit_handle(stage->frame, mass, handles[i].x + 0.01, handles[i].y, REACH);
        g_assert_cmpint(hit.block, ==, mass);
        g_assert_cmpint(hit.part, ==, handles[i].part);
    }
    g_assert_cmpint(tinker_hit_handle(stage->frame, mass, 9, 9, REACH).block, ==, TINKER_NO_BLOCK);
}

static void test_nowhere(Stage *stage, gconstpointer data)
{
    /* Neither a field, which has no place, nor numbers that are none are hit. */
    static const double odd[] = {NAN, INFINITY, -INFINITY, 1e300};
    for (gsize i = 0; i < G_N_ELEMENTS(odd); i++) {
        g_assert_cmpint(tinker_hit(stage->frame, odd[i], 0, REACH).block, ==, TINKER_NO_BLOCK);
        g_assert_cmpint(tinker_hit_connectable(stage->frame, named(stage, "S"), odd[i], 0, REACH), ==, TINKER_NO_BLOCK);
    }
}

static void test_snap(void)
{
    double x = 1.26, y = -0.74;
    tinker_snap(0.5, &x, &y);
    g_assert_cmpfloat(x, ==, 1.5);
    g_assert_cmpfloat(y, ==, -0.5);
    x = 0.123;
    tinker_snap(0, &x, &y);
    tinker_snap(-1, &x, &y);
    tinker_snap(NAN, &x, &y);
    g_assert_cmpfloat(x, ==, 0.123);
    for (int i = 0; i < 1000; i++) {
        double grid = pow(10, g_test_rand_double_range(-6, 6));
        double was = x = grid * g_test_rand_double_range(-1000, 1000);
        y = 0;
        tinker_snap(grid, &x, &y);
        g_assert_cmpfloat(fabs(x - was), <=, grid / 2 * (1 + 1e-9));
        g_assert_cmpfloat_with_epsilon(x / grid, round(x / grid), 1e-9);
    }
}

#define add(path, function) g_test_add(path, Stage, NULL, set_up, function, tear_down)

static void add_tests(void)
{
    add("/edit/hit/order", test_order);
    add("/edit/hit/connectable", test_connectable);
    add("/edit/hit/handles", test_handles);
    add("/edit/hit/nowhere", test_nowhere);
    g_test_add_func("/edit/snap", test_snap);
    g_test_add_func("/edit/hit/to-drag", test_to_drag);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
