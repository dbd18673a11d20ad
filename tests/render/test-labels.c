/* Names of connectors: beside their symbols, whole and upon nothing, or not at all. What is drawn is read from
 * pictures. */
#include <math.h>
#include <string.h>

#include "scene-fixture.h"
#include "stage.h"

static gboolean apart(const TinkerWrittenText *a, const TinkerWrittenText *b)
{
    return a->box[2] <= b->box[0] || b->box[2] <= a->box[0] || a->box[3] <= b->box[1] || b->box[3] <= a->box[1];
}

/* Pixels within a text's box that are no background in a picture of the same blocks without names. */
static int drawn_beneath(const TinkerWrittenText *text, TestStage *plain)
{
    const double *ground = plain->options.theme->background;
    int drawn = 0;
    for (int y = (int)ceil(text->box[1]); y < (int)text->box[3]; y++)
        for (int x = (int)ceil(text->box[0]); x < (int)text->box[2]; x++)
            drawn += !test_picture_shows(plain->picture, x, y, 0, ground);
    return drawn;
}

static double gap(double low, double high, double at)
{
    return fmax(fmax(low - at, at - high), 0);
}

/* On a spring of any direction between two bodies far apart the name stands by the middle: clear of the coils, and
 * nearer to them than a line of text is high. */
static void test_beside(void)
{
    for (int i = 0; i < 24; i++) {
        double angle = i * G_PI / 12, c = cos(angle), s = sin(angle);
        g_autofree char *blocks =
            g_strdup_printf("{\"type\": \"mass\", \"name\": \"A\", \"position\": [%g, %g]},"
                            "{\"type\": \"mass\", \"name\": \"B\", \"position\": [%g, %g]},"
                            "{\"type\": \"spring\", \"name\": \"Front spring\", \"ends\": [\"A\", \"B\"]}",
                            -3 * c, -3 * s, 3 * c, 3 * s);
        TestStage stage, plain;
        test_stage_open(&stage, blocks);
        test_stage_open(&plain, blocks);
        stage.options.show_labels = TRUE;
        test_stage_paint(&stage);
        test_stage_paint(&plain);
        const TinkerWrittenText *name = test_stage_text(&stage, "Front spring");
        g_assert_nonnull(name);
        g_assert_cmpint(drawn_beneath(name, &plain), ==, 0);
        double nearest = INFINITY; /* from the spring's axis to the name */
        for (double t = -100; t <= 100; t++)
            nearest = fmin(nearest, hypot(gap(name->box[0], name->box[2], TEST_STAGE_WIDTH / 2 + t * c),
                                          gap(name->box[1], name->box[3], TEST_STAGE_HEIGHT / 2 - t * s)));
        g_assert_cmpfloat(nearest, <, 30);
        g_assert_cmpuint(plain.written->len, ==, 0);
        test_stage_close(&plain);
        test_stage_close(&stage);
    }
}

/* Springs all over each other: a name that is written covers neither a drawing nor a text, some are written, not all.
 */
static void test_crossed(void)
{
    int named = 0, springs = 0;
    for (int round = 0; round < 20; round++) {
        g_autoptr(GString) blocks = g_string_new(NULL);
        for (int i = 0; i < 7; i++)
            g_string_append_printf(blocks, "{\"type\": \"mass\", \"name\": \"B%d\", \"position\": [%g, %g]},", i,
                                   g_test_rand_double_range(-5, 5), g_test_rand_double_range(-3, 3));
        for (int i = 0; i < 6; i++)
            g_string_append_printf(blocks,
                                   "%s{\"type\": \"spring\", \"name\": \"Spring %d\", \"ends\": [\"B%d\", \"B%d\"]}",
                                   i ? "," : "", i, i, i + 1);
        TestStage stage, plain;
        test_stage_open(&stage, blocks->str);
        test_stage_open(&plain, blocks->str);
        stage.options.show_labels = TRUE;
        test_stage_paint(&stage);
        test_stage_paint(&plain);
        springs += 6;
        for (guint i = 0; i < stage.written->len; i++) {
            const TinkerWrittenText *text = g_ptr_array_index(stage.written, i);
            if (!g_str_has_prefix(text->text, "Spring")) continue;
            named++;
            g_assert_cmpint(drawn_beneath(text, &plain), ==, 0);
            for (guint n = 0; n < stage.written->len; n++)
                g_assert_true(n == i || apart(text, g_ptr_array_index(stage.written, n)));
        }
        test_stage_close(&plain);
        test_stage_close(&stage);
    }
    g_test_message("%d of %d springs are named", named, springs);
    g_assert_cmpint(named, >, springs / 6);
    g_assert_cmpint(named, <, springs);
}

/* A body in the middle of others that leave no place beside it: its name stands farther off, on nothing, and a line
 * leads to it. */
static void test_far(void)
{
    g_autoptr(GString) blocks = g_string_new("{\"type\": \"mass\", \"name\": \"Middle\", \"width\": 0.8}");
    for (int i = 0; i < 8; i++)
        g_string_append_printf(blocks, ",{\"type\": \"mass\", \"name\": \"B%d\", \"position\": [%g, %g]}", i,
                               1.0 * ((const int[]){1, 1, 0, -1, -1, -1, 0, 1})[i],
                               1.0 * ((const int[]){0, 1, 1, 1, 0, -1, -1, -1})[i]);
    TestStage stage, plain;
    test_stage_open(&stage, blocks->str);
    test_stage_open(&plain, blocks->str);
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    test_stage_paint(&plain);
    const TinkerWrittenText *name = test_stage_text(&stage, "Middle");
    g_assert_nonnull(name);
    g_assert_cmpint(drawn_beneath(name, &plain), ==, 0);
    /* beyond its neighbours, at 50 pixels a metre */
    g_assert_cmpfloat(fmax(gap(name->box[0], name->box[2], TEST_STAGE_WIDTH / 2),
                           gap(name->box[1], name->box[3], TEST_STAGE_HEIGHT / 2)),
                      >, 50);
    test_stage_close(&plain);
    test_stage_close(&stage);
}

/* None where it would be taken for another's: on a short one, between two that run side by side, on a part of a
 * support, or on a motor, whose arrow may lie along a spring; but where it is selected. */
static void test_whose(void)
{
    TestStage stage;
    test_stage_open(&stage,
                    "{\"type\": \"mass\", \"name\": \"A\", \"position\": [-1, 2]},"
                    "{\"type\": \"mass\", \"name\": \"B\", \"position\": [0.6, 2]},"
                    "{\"type\": \"rod\", \"name\": \"A rod of no length\", \"ends\": [\"A\", \"B\"]},"
                    "{\"type\": \"support\", \"name\": \"S\", \"position\": [-4, -2], \"width\": 0.5, \"height\": 3.5},"
                    "{\"type\": \"support-motion\", \"name\": \"Shaker\", \"ends\": [\"S\"], \"amplitude\": 1},"
                    "{\"type\": \"mass\", \"name\": \"C\", \"position\": [4, -2], \"height\": 3.5},"
                    "{\"type\": \"spring\", \"name\": \"Upper\", \"ends\": [[-4, -1.4], [4, -1.4]]},"
                    "{\"type\": \"spring\", \"name\": \"Middle\", \"ends\": [[-4, -2], [4, -2]]},"
                    "{\"type\": \"spring\", \"name\": \"Lower\", \"ends\": [[-4, -2.6], [4, -2.6]]},"
                    "{\"type\": \"motor\", \"name\": \"Fan\", \"ends\": [\"B\"], \"amplitude\": 1}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    static const char *const with[] = {"A", "B", "C", "S", "Upper", "Lower"};
    static const char *const without[] = {"A rod of no length", "Shaker", "Middle", "Fan"};
    for (gsize i = 0; i < G_N_ELEMENTS(with); i++)
        g_assert_nonnull(test_stage_text(&stage, with[i]));
    for (gsize i = 0; i < G_N_ELEMENTS(without); i++)
        g_assert_null(test_stage_text(&stage, without[i]));
    /* Above the upper one, beneath the lower one: y is down, 50 pixels a metre. */
    g_assert_cmpfloat(test_stage_text(&stage, "Upper")->box[3], <, TEST_STAGE_HEIGHT / 2 + 1.4 * 50);
    g_assert_cmpfloat(test_stage_text(&stage, "Lower")->box[1], >, TEST_STAGE_HEIGHT / 2 + 2.6 * 50);
    TinkerBlockId fan = tinker_scene_find_block(stage.scene, "Fan");
    stage.options.selected = &fan;
    stage.options.selected_count = 1;
    test_stage_paint(&stage);
    g_assert_nonnull(test_stage_text(&stage, "Fan"));
    test_stage_close(&stage);
}

/* A dimension and an angle mark are read themselves; their names would stand across them. */
static void test_measures(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"mass\", \"name\": \"A\", \"position\": [-4, 2]},"
                            "{\"type\": \"mass\", \"name\": \"B\", \"position\": [4, 2]},"
                            "{\"type\": \"mass\", \"name\": \"C\", \"position\": [4, -2]},"
                            "{\"type\": \"dimension\", \"name\": \"Gauge\", \"ends\": [\"A\", \"B\"]},"
                            "{\"type\": \"angle-mark\", \"name\": \"Corner\", \"ends\": [\"B\", \"A\", \"C\"]}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    g_assert_nonnull(test_stage_text(&stage, "A"));
    g_assert_null(test_stage_text(&stage, "Gauge"));
    g_assert_null(test_stage_text(&stage, "Corner"));
    const TinkerBlockId gauge = tinker_scene_find_block(stage.scene, "Gauge");
    stage.options.selected = &gauge;
    stage.options.selected_count = 1;
    test_stage_paint(&stage);
    g_assert_nonnull(test_stage_text(&stage, "Gauge"));
    test_stage_close(&stage);
}

/* A pivot has its name beside what is drawn of it: the slab that it would be, were it solid, is 4 m wide. */
static void test_pivot(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"support\", \"name\": \"Pivot\", \"position\": [0, 0], \"solid\": false},"
                            "{\"type\": \"mass\", \"position\": [0, 1], \"width\": 1.6, \"height\": 1.6},"
                            "{\"type\": \"mass\", \"position\": [0, -1.2], \"width\": 1.6, \"height\": 1.6}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    const TinkerWrittenText *name = test_stage_text(&stage, "Pivot");
    g_assert_nonnull(name);
    g_assert_cmpfloat(gap(name->box[0], name->box[2], TEST_STAGE_WIDTH / 2), <, 2 * 50); /* 2 m, at 50 pixels a metre */
    test_stage_close(&stage);
}

/* While a body passes over it, a name neither jumps to and fro nor comes and goes at every step. */
static void test_steady(void)
{
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    TestStage stage;
    test_stage_open(&stage,
                    "{\"type\": \"spring\", \"name\": \"Spring\", \"ends\": [[-4, 0], [4, 0]]},"
                    "{\"type\": \"mass\", \"name\": \"P\", \"position\": [-4, 0.5], \"width\": 0.4, \"height\": 0.4}");
    stage.options.show_labels = TRUE;
    stage.options.memory = memory;
    TinkerBlockId passing = tinker_scene_find_block(stage.scene, "P");
    double x = NAN, y = NAN;
    int changes = 0;
    for (double place = -4; place < 4; place += 0.02) {
        tinker_frame_place(stage.frame, passing, place, 0.5, 0);
        test_stage_paint(&stage);
        const TinkerWrittenText *name = test_stage_text(&stage, "Spring");
        g_assert_nonnull(name);
        changes += name->box[0] != x || name->box[1] != y;
        x = name->box[0];
        y = name->box[1];
    }
    g_test_message("%d places", changes);
    g_assert_cmpint(changes, <=, 4);
    test_stage_close(&stage);
}

/* Beneath a plate a body has its name beyond the edge of that, with a line to it; once the plate is gone, where it
 * would be had there been none. */
static void test_far_name_comes_back(void)
{
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    TestStage stage;
    test_stage_open(&stage,
                    "{\"type\": \"mass\", \"name\": \"Plate\", \"position\": [0, 0], \"width\": 3, \"height\": 3},"
                    "{\"type\": \"mass\", \"name\": \"B\", \"position\": [0, 0], \"width\": 0.4, \"height\": 0.4}");
    stage.options.show_labels = TRUE;
    stage.options.memory = memory;
    double away[3];
    for (int i = 0; i < 3; i++) {
        if (i == 2) stage.options.memory = NULL;
        tinker_frame_place(stage.frame, tinker_scene_find_block(stage.scene, "Plate"), i == 0 ? 0 : 20, 0, 0);
        test_stage_paint(&stage);
        const TinkerWrittenText *name = test_stage_text(&stage, "B");
        g_assert_nonnull(name);
        away[i] = hypot(gap(name->box[0], name->box[2], TEST_STAGE_WIDTH / 2),
                        gap(name->box[1], name->box[3], TEST_STAGE_HEIGHT / 2));
    }
    g_assert_cmpfloat(away[0], >, 1.5 * 50); /* half the plate, at 50 pixels a metre */
    g_assert_cmpfloat(away[1], ==, away[2]);
    test_stage_close(&stage);
}

/* A disc and a plate declare neither width nor height. Their names stand above them as
 * near as that of a box of the same size, at least. */
static void test_round(void)
{
    static const char *const blocks[] = {"\"mass\", \"width\": 2, \"height\": 2", "\"disc\", \"radius\": 1",
                                         "\"plate\", \"corners\": [[-1, -1], [1, -1], [1, 1], [-1, 1]]"};
    const double top = TEST_STAGE_HEIGHT / 2 - 50; /* at 50 pixels a metre */
    double below = 0;
    for (gsize i = 0; i < G_N_ELEMENTS(blocks); i++) {
        g_autofree char *block = g_strdup_printf("{\"name\": \"Body\", \"position\": [0, 0], \"type\": %s}", blocks[i]);
        TestStage stage;
        test_stage_open(&stage, block);
        stage.options.show_labels = TRUE;
        test_stage_paint(&stage);
        const TinkerWrittenText *name = test_stage_text(&stage, "Body");
        g_assert_nonnull(name);
        if (i == 0) below = name->box[3];
        g_assert_cmpfloat(name->box[3], >=, below);
        g_assert_cmpfloat(name->box[3], <=, top);
        test_stage_close(&stage);
    }
}

/* Connectors have names where there are few blocks; among many, bodies alone have. */
static void test_nets(void)
{
    static const int rows[] = {3, 8};
    for (gsize r = 0; r < G_N_ELEMENTS(rows); r++) {
        g_autoptr(GString) blocks = g_string_new(NULL);
        for (int i = 0; i < rows[r]; i++)
            for (int side = 0; side < 2; side++)
                g_string_append_printf(blocks,
                                       "%s{\"type\": \"mass\", \"name\": \"B%d-%d\", \"position\": [%d, %g], "
                                       "\"width\": 0.2, \"height\": 0.2}",
                                       i + side ? "," : "", i, side, side ? 4 : -4, 3.5 - i);
        for (int i = 0; i < rows[r]; i++)
            for (int k = 0; k < 2; k++)
                g_string_append_printf(
                    blocks, ",{\"type\": \"rod\", \"name\": \"R%d-%d\", \"ends\": [\"B%d-0\", \"B%d-1\"]}", i, k, i, i);
        TestStage stage;
        test_stage_open(&stage, blocks->str);
        stage.options.show_labels = TRUE;
        test_stage_paint(&stage);
        int bodies = 0, rods = 0;
        for (guint i = 0; i < stage.written->len; i++) {
            const TinkerWrittenText *text = g_ptr_array_index(stage.written, i);
            bodies += text->text[0] == 'B';
            rods += text->text[0] == 'R';
        }
        g_assert_cmpint(bodies, ==, 2 * rows[r]);
        g_assert_cmpint(rods > 0, ==, r == 0);
        test_stage_close(&stage);
    }
}

/* No line from the middle of the picture to the nearest edge of a name goes through another name. */
static void assert_leaders_are_clear(const TestStage *stage)
{
    static const double from[] = {TEST_STAGE_WIDTH / 2, TEST_STAGE_HEIGHT / 2};
    for (guint i = 0; i < stage->written->len; i++) {
        const double *to = ((TinkerWrittenText *)g_ptr_array_index(stage->written, i))->box;
        const double end[] = {fmin(fmax(from[0], to[0]), to[2]), fmin(fmax(from[1], to[1]), to[3])};
        for (guint k = 0; k < stage->written->len; k++) {
            const double *other = ((TinkerWrittenText *)g_ptr_array_index(stage->written, k))->box;
            for (int step = 0; k != i && step < 100; step++) {
                const double x = from[0] + 0.01 * step * (end[0] - from[0]),
                             y = from[1] + 0.01 * step * (end[1] - from[1]);
                g_assert_false(x > other[0] && x < other[2] && y > other[1] && y < other[3]);
            }
        }
    }
}

/* A small wheel on the axle of a large one, between two others: its name, which is written first where it is selected,
 * is far off. */
static void test_leaders(void)
{
    static const char blocks[] =
        "{\"type\": \"support\", \"name\": \"Frame\", \"position\": [0, -1.2], \"width\": 0.4, \"height\": 0.2},"
        "{\"type\": \"disc\", \"name\": \"Wheel 1\", \"radius\": 0.3, \"position\": [-1.2, 0]},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Wheel 2\", \"radius\": 0.9},"
        "{\"type\": \"disc\", \"position\": [0, 0], \"name\": \"Wheel 3\", \"radius\": 0.25},"
        "{\"type\": \"disc\", \"name\": \"Wheel 4\", \"radius\": 0.75, \"position\": [1, 0]}";
    for (TinkerBlockId selected = 0; selected < 5; selected++) {
        TestStage stage;
        test_stage_open(&stage, blocks);
        stage.view.scale = 26;
        stage.options.show_labels = TRUE;
        stage.options.selected = &selected;
        stage.options.selected_count = 1;
        test_stage_paint(&stage);
        g_assert_cmpuint(stage.written->len, ==, 5);
        assert_leaders_are_clear(&stage);
        test_stage_close(&stage);
    }
}

/* A name is not written beneath a panel that lies over the picture: it goes to another side of its body, or is left out
 * where panels lie all around. */
static void test_panels(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"mass\", \"name\": \"Bob\", \"position\": [0, 0]}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    const TinkerWrittenText *free_name = test_stage_text(&stage, "Bob");
    g_assert_nonnull(free_name);
    g_autoptr(GPtrArray) texts = tinker_written_texts_new();
    TinkerWrittenText *panel = g_new0(TinkerWrittenText, 1);
    memcpy(panel->box, free_name->box, sizeof panel->box);
    g_ptr_array_add(texts, panel);
    stage.options.texts = texts;
    test_stage_paint(&stage);
    const TinkerWrittenText *moved = test_stage_text(&stage, "Bob");
    g_assert_nonnull(moved);
    g_assert_true(apart(moved, panel));
    g_ptr_array_set_size(texts, 1);
    memcpy(panel->box, (double[]){0, 0, TEST_STAGE_WIDTH, TEST_STAGE_HEIGHT}, sizeof panel->box);
    test_stage_paint(&stage);
    g_assert_null(test_stage_text(&stage, "Bob"));
    test_stage_close(&stage);
}

static void add_tests(void)
{
    g_test_add_func("/render/labels/beside", test_beside);
    g_test_add_func("/render/labels/crossed", test_crossed);
    g_test_add_func("/render/labels/far", test_far);
    g_test_add_func("/render/labels/whose", test_whose);
    g_test_add_func("/render/labels/measures", test_measures);
    g_test_add_func("/render/labels/pivot", test_pivot);
    g_test_add_func("/render/labels/steady", test_steady);
    g_test_add_func("/render/labels/round", test_round);
    g_test_add_func("/render/labels/far-name-comes-back", test_far_name_comes_back);
    g_test_add_func("/render/labels/nets", test_nets);
    g_test_add_func("/render/labels/leaders", test_leaders);
    g_test_add_func("/render/labels/panels", test_panels);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
