/* Frames: where blocks stand at a time, and connectors side by side. */
#include "scene-fixture.h"

#include <math.h>

#include "scene/frame/frame-quantity.h"
#include "scene/frame/tops.h"

#define TWO_MASSES                                                                                                     \
    "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0]}, {\"type\": \"mass\", \"name\": \"B\", "              \
    "\"position\": [3, 4]}"

static void ends_of(TinkerFrame *frame, const char *name, TinkerEnd ends[2])
{
    TinkerInstance instance;
    TinkerBlockId block = tinker_scene_find_block(tinker_frame_scene(frame), name);
    g_assert_true(tinker_frame_instance(frame, block, &instance));
    g_assert_cmpint(instance.ends, ==, 2);
    ends[0] = instance.end[0];
    ends[1] = instance.end[1];
}

/* How far a point lies to the left of the line from A to B, along (3, 4) / 5. */
static double left_of_line(const TinkerEnd *end)
{
    return (3 * end->y - 4 * end->x) / 5;
}

static void test_side_by_side(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks(TWO_MASSES ", {\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"A\", \"B\"]},"
                                             "{\"type\": \"damper\", \"name\": \"D\", \"ends\": [\"B\", \"A\"]}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerEnd spring[2], damper[2];
    ends_of(frame, "S", spring);
    ends_of(frame, "D", damper);
    /* Symmetric about the line whatever the order of their ends, as long as they are, and apart. */
    g_assert_cmpfloat(fabs(left_of_line(&spring[0])), >, 0.05);
    for (int k = 0; k < 2; k++) {
        g_assert_cmpfloat_with_epsilon(left_of_line(&spring[k]), left_of_line(&spring[0]), 1e-12);
        g_assert_cmpfloat_with_epsilon(left_of_line(&damper[k]), -left_of_line(&spring[0]), 1e-12);
    }
    g_assert_cmpfloat_with_epsilon(hypot(spring[1].x - spring[0].x, spring[1].y - spring[0].y), 5, 1e-12);
    g_assert_cmpfloat_with_epsilon(hypot(damper[1].x - damper[0].x, damper[1].y - damper[0].y), 5, 1e-12);
    g_assert_cmpfloat_with_epsilon(damper[1].x + spring[0].x, 0, 1e-12);
}

static void test_alone(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        TWO_MASSES ", {\"type\": \"support\", \"name\": \"C\", \"position\": [3, 0]},"
                   "{\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"A\", \"B\"]},"
                   "{\"type\": \"rod\", \"name\": \"R\", \"ends\": [\"A\", \"C\"]},"
                   "{\"type\": \"damper\", \"name\": \"D\", \"ends\": [\"A\", {\"block\": \"C\", \"at\": [1, 0]}]}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    static const char *const names[] = {"S", "R", "D"};
    static const double places[][2] = {{3, 4}, {3, 0}, {4, 0}};
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        TinkerEnd ends[2];
        ends_of(frame, names[i], ends);
        g_assert_cmpfloat(ends[0].x, ==, 0);
        g_assert_cmpfloat(ends[0].y, ==, 0);
        g_assert_cmpfloat_with_epsilon(ends[1].x, places[i][0], 1e-15);
        g_assert_cmpfloat_with_epsilon(ends[1].y, places[i][1], 1e-15);
    }
}

/* A support stands where its motion has it, at t = 0 too, and a length as placed is taken there. */
static void test_moving_support(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"support\", \"name\": \"C\", \"position\": [1, 2]}, {\"type\": \"mass\", \"name\": \"A\"},"
        "{\"type\": \"support-motion\", \"name\": \"M\", \"ends\": [\"C\"], \"waveform\": \"cosine\","
        "\"amplitude\": 2, \"frequency\": 3}, {\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"A\", \"C\"]}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerBlockId support = tinker_scene_find_block(scene, "C"), spring = tinker_scene_find_block(scene, "S");
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, spring);
    int32_t rest = block_class->first_columns[tinker_block_class_property(block_class, "rest_length")];
    double x, y, orientation;
    tinker_frame_centre(frame, support, &x, &y, &orientation);
    g_assert_cmpfloat_with_epsilon(x, 3, 1e-15);
    g_assert_cmpfloat_with_epsilon(tinker_frame_column(frame, spring, rest), hypot(3, 2), 1e-15);
    g_assert_true(tinker_frame_set_time(frame, 0.7, NULL));
    tinker_frame_centre(frame, support, &x, &y, &orientation);
    g_assert_cmpfloat_with_epsilon(x, 1 + 2 * cos(2.1), 1e-15);
    g_assert_cmpfloat_with_epsilon(y, 2, 1e-15);
    g_assert_cmpfloat_with_epsilon(tinker_frame_column(frame, spring, rest), hypot(3, 2), 1e-15);
}

/* What the places alone tell, by hand; what needs more than them is not told. */
static void test_quantity(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        TWO_MASSES ", {\"type\": \"spring\", \"name\": \"S\", \"ends\": [\"A\", \"B\"], \"stiffness\": 20, "
                   "\"rest_length\": 4}, {\"type\": \"damper\", \"ends\": [\"A\", \"B\"]},"
                   "{\"type\": \"rod\", \"name\": \"R\", \"ends\": [\"A\", \"B\"]},"
                   "{\"type\": \"spring\", \"name\": \"Loose\", \"ends\": [\"A\", [1, 1]]},"
                   "{\"type\": \"motor\", \"name\": \"M\", \"ends\": [\"A\"], \"amplitude\": 3},"
                   "{\"type\": \"nobody\", \"name\": \"P\"}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    static const struct {
        const char *block, *quantity;
        double value; /* NAN: not told */
    } cases[] = {{"S", "length", 5}, {"S", "tension", 20},  {"S", "energy", 10},
                 {"B", "x", 3},      {"M", "force", 3},     {"B", "speed", 0},
                 {"B", "ax", NAN},   {"R", "tension", NAN}, {"Loose", "length", NAN}};
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        TinkerBlockId block = tinker_scene_find_block(scene, cases[i].block);
        int32_t quantity = tinker_block_class_quantity(tinker_scene_block_class(scene, block), cases[i].quantity);
        double value = NAN;
        g_assert_cmpint(quantity, >=, 0);
        g_assert_true(tinker_frame_quantity(frame, block, quantity, &value) == !isnan(cases[i].value));
        if (!isnan(cases[i].value)) g_assert_cmpfloat_with_epsilon(value, cases[i].value, 1e-12);
    }
    double value;
    g_assert_false(tinker_frame_quantity(frame, tinker_scene_find_block(scene, "P"), 0, &value));

    /* It follows the frame. */
    TinkerBlockId spring = tinker_scene_find_block(scene, "S");
    tinker_frame_place(frame, tinker_scene_find_block(scene, "B"), 0, 7, 0);
    g_assert_true(tinker_frame_quantity(frame, spring, 0, &value));
    g_assert_cmpfloat_with_epsilon(value, 7, 1e-12);
}

/* On a slope of 0.4 rad: what touches it lies along it, what is above it or beside it does not. */
static void test_lying_bodies(void)
{
    const double slope = 0.4, high = 0.1 + 0.25; /* m: half of both heights */
    g_autofree char *blocks = g_strdup_printf(
        "{\"type\": \"support\", \"width\": 4, \"height\": 0.2, \"orientation\": %.17g},"
        "{\"type\": \"mass\", \"name\": \"Lies\", \"width\": 0.5, \"height\": 0.5, \"position\": [%.17g, %.17g]},"
        "{\"type\": \"mass\", \"name\": \"Above\", \"width\": 0.5, \"height\": 0.5, \"position\": [%.17g, %.17g]},"
        "{\"type\": \"mass\", \"name\": \"Beside\", \"width\": 0.5, \"height\": 0.5, \"position\": [%.17g, %.17g]}",
        slope, -high * sin(slope), high * cos(slope), -2 * high * sin(slope), 2 * high * cos(slope),
        3 * cos(slope) - high * sin(slope), 3 * sin(slope) + high * cos(slope));
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    static const char *const names[] = {"Lies", "Above", "Beside"};
    tinker_tops_turn_bodies(frame);
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        double x, y, orientation;
        tinker_frame_centre(frame, tinker_scene_find_block(scene, names[i]), &x, &y, &orientation);
        g_assert_cmpfloat_with_epsilon(orientation, i == 0 ? slope : 0, 1e-15);
    }
}

/* The length of a slack cord is known as placed, also where something else is drawn as it lies; not any more once a
 * body has been placed, until it is told. */
static void test_wound(void)
{
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(
        "{\"type\": \"disc\", \"name\": \"D\", \"position\": [0, 3], \"radius\": 0.1},"
        "{\"type\": \"mass\", \"name\": \"M\", \"position\": [0, 1]},"
        "{\"type\": \"cord\", \"name\": \"C\", \"ends\": [\"D\", \"M\"], \"length\": 3},"
        "{\"type\": \"rope\", \"name\": \"R\", \"ends\": [\"D\", \"M\"], \"length\": 3},"
        "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [5, 0], \"width\": 4, \"height\": 0.2},"
        "{\"type\": \"mass\", \"name\": \"Lies\", \"position\": [5, 0.35], \"width\": 0.5, \"height\": 0.5}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    const TinkerBlockId cord = tinker_scene_find_block(scene, "C"), rope = tinker_scene_find_block(scene, "R"),
                        mass = tinker_scene_find_block(scene, "M");
    const TinkerBlockClass *block_class = tinker_scene_block_class(scene, cord);
    const int32_t column = tinker_block_class_meaning_column(block_class, TINKER_MEANING_LENGTH);
    TinkerInstance instance;
    g_assert_cmpfloat(tinker_frame_length(frame, cord), ==, 3);
    tinker_tops_turn_bodies(frame);
    g_assert_cmpfloat(tinker_frame_length(frame, cord), ==, 3);
    tinker_frame_place(frame, mass, 0, 2, 0);
    g_assert_true(isnan(tinker_frame_length(frame, cord)));
    g_assert_true(tinker_frame_instance(frame, cord, &instance));
    g_assert_true(isnan(instance.columns[column]));
    tinker_frame_set_length(frame, cord, 2.5);
    g_assert_true(tinker_frame_instance(frame, cord, &instance));
    g_assert_cmpfloat(instance.columns[column], ==, 2.5);
    tinker_frame_set_length(frame, rope, 2.5);
    tinker_frame_set_length(frame, tinker_scene_id_limit(scene), 2.5);
    g_assert_true(isnan(tinker_frame_length(frame, rope)));
}

/* Wound is what has one row of two ends that speaks of angles, with a radius and a length. */
static void test_what_is_wound(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks("{\"type\": \"disc\", \"name\": \"D\", \"position\": [0, 3], \"radius\": 0.1},"
                                  "{\"type\": \"cord\", \"name\": \"C\", \"ends\": [\"D\", [0, 0]]},"
                                  "{\"type\": \"rope\", \"name\": \"R\", \"ends\": [\"D\", [0, 0]]}");
    const TinkerBlockClass *cord = tinker_scene_block_class(scene, tinker_scene_find_block(scene, "C"));
    g_assert_true(tinker_block_class_is_wound(cord));
    g_assert_false(tinker_block_class_is_wound(tinker_scene_block_class(scene, tinker_scene_find_block(scene, "R"))));
    static const int32_t meanings[] = {TINKER_MEANING_RADIUS, TINKER_MEANING_LENGTH};
    for (gsize i = 0; i < G_N_ELEMENTS(meanings); i++) {
        TinkerBlockClass other = *cord;
        other.meanings[meanings[i]] = -1;
        g_assert_false(tinker_block_class_is_wound(&other));
    }
    for (int change = 0; change < 3; change++) {
        TinkerBlockType type = *cord->type;
        TinkerConstraint constraint = *cord->physics->constraint;
        TinkerPhysics physics = *cord->physics;
        TinkerBlockClass other = *cord;
        if (change == 0) type.most_ends = 3;
        if (change == 1) constraint.rows = 2;
        if (change == 2) constraint.angles = 0;
        physics.constraint = &constraint;
        other.type = &type;
        other.physics = &physics;
        g_assert_false(tinker_block_class_is_wound(&other));
    }
}

/* What was noted up to the frame's time, and no time twice; a block that leaves none has none. */
static void test_paths(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks(TWO_MASSES ", {\"type\": \"marker\", \"name\": \"M\", \"ends\": [\"B\"]}");
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerBlockId mass = tinker_scene_find_block(scene, "B"), marker = tinker_scene_find_block(scene, "M");
    TinkerInstance instance;
    g_assert_true(tinker_frame_leaves_paths(frame));
    for (int k = 0; k < 5; k++) {
        g_assert_true(tinker_frame_set_time(frame, k, NULL));
        tinker_frame_place(frame, mass, k, k * k, 0);
        tinker_frame_note_paths(frame);
        tinker_frame_note_paths(frame);
    }
    for (int k = 4; k >= 0; k--) {
        g_assert_true(tinker_frame_set_time(frame, k + 0.5, NULL));
        g_assert_true(tinker_frame_instance(frame, marker, &instance));
        g_assert_cmpint(instance.path_count, ==, k + 1);
        g_assert_cmpfloat(instance.path[2 * k], ==, k);
        g_assert_cmpfloat(instance.path[2 * k + 1], ==, k * k);
        g_assert_true(tinker_frame_instance(frame, mass, &instance));
        g_assert_true(instance.path == NULL && instance.path_count == 0);
    }
}

static void add_tests(void)
{
    g_test_add_func("/scene/frame/paths", test_paths);
    g_test_add_func("/scene/frame/lying-bodies", test_lying_bodies);
    g_test_add_func("/scene/frame/wound", test_wound);
    g_test_add_func("/scene/frame/what-is-wound", test_what_is_wound);
    g_test_add_func("/scene/frame/quantity", test_quantity);
    g_test_add_func("/scene/frame/side-by-side", test_side_by_side);
    g_test_add_func("/scene/frame/alone", test_alone);
    g_test_add_func("/scene/frame/moving-support", test_moving_support);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
