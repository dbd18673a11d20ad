/* What is left out where it would be too small or too much, what stays at every scale, and that pictures which are made
 * quickly, or from what earlier ones left, are the same pictures. */
#include <math.h>
#include <string.h>

#include "scene-fixture.h"
#include "stage.h"

/* A row of points with springs between them, all compressed or all stretched. */
static char *row_of_springs(double rest_length)
{
    GString *blocks = g_string_new(NULL);
    for (int i = 0; i <= 20; i++)
        g_string_append_printf(blocks,
                               "%s{\"type\": \"mass\", \"name\": \"M%d\", \"position\": [%d, 0], \"width\": 0.4, "
                               "\"height\": 0.4}",
                               i ? "," : "", i, i - 10);
    for (int i = 0; i < 20; i++)
        g_string_append_printf(blocks, ",{\"type\": \"spring\", \"ends\": [\"M%d\", \"M%d\"], \"rest_length\": %g}", i,
                               i + 1, rest_length);
    return g_string_free(blocks, FALSE);
}

/* Pixels that are clearly more of one channel than of another. */
static int tinted(const TestPicture *picture, int more, int less)
{
    int count = 0;
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++) {
            double rgba[4];
            test_picture_pixel(picture, x, y, rgba);
            count += rgba[more] > rgba[less] + 0.3;
        }
    return count;
}

/* Red or blue, and not both, from where coils are drawn down to where a spring is a few pixels long. */
static void test_state_colours(void)
{
    static const double scales[] = {50, 25, 12, 6, 3};
    for (int stretched = 0; stretched < 2; stretched++) {
        g_autofree char *blocks = row_of_springs(stretched ? 0.6 : 1.4);
        TestStage stage;
        test_stage_open(&stage, blocks);
        for (gsize i = 0; i < 2 * G_N_ELEMENTS(scales); i++) {
            stage.view.scale = scales[i / 2];
            stage.options.quick = i % 2;
            test_stage_paint(&stage);
            int red = tinted(stage.picture, 0, 2), blue = tinted(stage.picture, 2, 0);
            double length = 20 * stage.view.scale;
            g_assert_cmpint(stretched ? blue : red, >, 0.3 * length);
            /* Of a stretched spring, crosses at its ends are red. */
            gboolean crosses = stage.view.scale > 40;
            if (!stretched || !crosses) g_assert_cmpint(stretched ? red : blue, ==, 0);
        }
        test_stage_close(&stage);
    }
}

/* Ends have their crosses, until those would be no more than spots. */
static void test_crosses(void)
{
    g_autofree char *blocks = row_of_springs(0.6);
    TestStage stage;
    test_stage_open(&stage, blocks);
    stage.view.scale = 60;
    test_stage_paint(&stage);
    g_assert_cmpint(tinted(stage.picture, 0, 2), >, 50);
    static const double small[] = {36, 30, 12};
    for (gsize i = 0; i < G_N_ELEMENTS(small); i++) {
        stage.view.scale = small[i];
        test_stage_paint(&stage);
        g_assert_cmpint(tinted(stage.picture, 0, 2), ==, 0);
    }
    test_stage_close(&stage);
}

/* The picture of quick edges is the same but for shades along edges. */
static void test_quick(void)
{
    TestStage fine, quick;
    test_stage_open(&fine, "{\"type\": \"support\", \"name\": \"S\", \"position\": [-3, 0]},"
                           "{\"type\": \"mass\", \"name\": \"A\", \"position\": [1, 1]},"
                           "{\"type\": \"spring\", \"ends\": [\"S\", \"A\"], \"rest_length\": 3},"
                           "{\"type\": \"rod\", \"ends\": [\"A\", [4, -2]]}, {\"type\": \"motor\", \"ends\": [\"A\"]}");
    quick = fine;
    quick.picture = test_picture_new(TEST_STAGE_WIDTH, TEST_STAGE_HEIGHT);
    quick.options.quick = TRUE;
    test_stage_paint(&fine);
    test_stage_paint(&quick);
    int other = 0;
    for (int y = 0; y < TEST_STAGE_HEIGHT; y++)
        for (int x = 0; x < TEST_STAGE_WIDTH; x++) {
            double a[4], b[4];
            test_picture_pixel(fine.picture, x, y, a);
            test_picture_pixel(quick.picture, x, y, b);
            other += fabs(a[0] - b[0]) + fabs(a[1] - b[1]) + fabs(a[2] - b[2]) > 0.75;
        }
    g_assert_cmpint(other, <, 60);
    test_picture_free(quick.picture);
    test_stage_close(&fine);
}

static char *crowd(int bodies)
{
    GString *blocks = g_string_new("{\"type\": \"gravity\", \"name\": \"G\"}");
    for (int i = 0; i < bodies; i++)
        g_string_append_printf(blocks, ",{\"type\": \"mass\", \"name\": \"Body %d\", \"position\": [%g, %g]}", i,
                               g_test_rand_double_range(-5, 5), g_test_rand_double_range(-3, 3));
    return g_string_free(blocks, FALSE);
}

static gboolean same_pixels(const TestPicture *a, const TestPicture *b)
{
    cairo_surface_flush(a->surface);
    cairo_surface_flush(b->surface);
    gsize size = (gsize)cairo_image_surface_get_stride(a->surface) * (gsize)a->height;
    return memcmp(cairo_image_surface_get_data(a->surface), cairo_image_surface_get_data(b->surface), size) == 0;
}

/* A memory changes no picture of a scene that stands still, whether it is new or full. */
static void test_memory(void)
{
    g_autofree char *blocks = crowd(40);
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    TestStage stage, other;
    test_stage_open(&stage, blocks);
    stage.options.show_labels = stage.options.show_time = stage.options.show_grid = TRUE;
    test_stage_paint(&stage);
    g_assert_cmpuint(stage.written->len, >, 20);
    other = stage;
    other.picture = test_picture_new(TEST_STAGE_WIDTH, TEST_STAGE_HEIGHT);
    other.options.memory = memory;
    for (int i = 0; i < 3; i++) {
        test_stage_paint(&other);
        g_assert_true(same_pixels(stage.picture, other.picture));
    }
    test_picture_free(other.picture);
    test_stage_close(&stage);
}

/* A name stays on its side of its body while another one passes over it. */
static void test_names_stay(void)
{
    g_autoptr(TinkerPaintMemory) memory = tinker_paint_memory_new();
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"mass\", \"name\": \"Stays\", \"position\": [0, 0]},"
                            "{\"type\": \"mass\", \"name\": \"Passes\", \"position\": [-4, 1]}");
    stage.options.show_labels = TRUE;
    stage.options.memory = memory;
    TinkerBlockId passing = tinker_scene_find_block(stage.scene, "Passes");
    test_stage_paint(&stage);
    const TinkerWrittenText *name = test_stage_text(&stage, "Stays");
    double x = name->box[0], y = name->box[1];
    for (double place = -4; place < 4; place += 0.25) {
        tinker_frame_place(stage.frame, passing, place, 1, 0);
        test_stage_paint(&stage);
        name = test_stage_text(&stage, "Stays");
        g_assert_cmpfloat_with_epsilon(name->box[0], x, 1e-9);
        g_assert_cmpfloat_with_epsilon(name->box[1], y, 1e-9);
    }
    test_stage_close(&stage);
}

static int count_names(const TestStage *stage)
{
    int count = 0;
    for (guint i = 0; i < stage->written->len; i++)
        count += g_str_has_prefix(((const TinkerWrittenText *)g_ptr_array_index(stage->written, i))->text, "Body");
    return count;
}

/* Where names would cover everything there are none, but for those of chosen blocks. */
static void test_crowd(void)
{
    g_autofree char *blocks = crowd(400);
    TestStage stage;
    test_stage_open(&stage, blocks);
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    g_assert_cmpint(count_names(&stage), ==, 0);
    g_assert_nonnull(test_stage_text(&stage, "G"));
    TinkerBlockId chosen = tinker_scene_find_block(stage.scene, "Body 7");
    stage.options.selected = &chosen;
    stage.options.selected_count = 1;
    test_stage_paint(&stage);
    g_assert_cmpint(count_names(&stage), ==, 1);
    g_assert_nonnull(test_stage_text(&stage, "Body 7"));
    test_stage_close(&stage);
}

static void add_tests(void)
{
    g_test_add_func("/render/detail/state-colours", test_state_colours);
    g_test_add_func("/render/detail/crosses", test_crosses);
    g_test_add_func("/render/detail/quick", test_quick);
    g_test_add_func("/render/detail/memory", test_memory);
    g_test_add_func("/render/detail/names-stay", test_names_stay);
    g_test_add_func("/render/detail/crowd", test_crowd);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
