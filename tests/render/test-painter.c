/* The painter with the real blocks: colours of states, order, fields, names, placeholders, bounds. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "scene-fixture.h"
#include "stage.h"

/* A spring between two points that are masses without size, which leave its colour alone in the middle. */
static void check_spring(double rest_length, const char *theme, int colour)
{
    g_autofree char *blocks =
        g_strdup_printf("{\"type\": \"mass\", \"name\": \"A\", \"position\": [-2, 0], \"width\": 0, \"height\": 0},"
                        "{\"type\": \"mass\", \"name\": \"B\", \"position\": [2, 0], \"width\": 0, \"height\": 0},"
                        "{\"type\": \"spring\", \"ends\": [\"A\", \"B\"], \"rest_length\": %g}",
                        rest_length);
    TestStage stage;
    test_stage_open(&stage, blocks);
    stage.options.theme = tinker_theme_find(theme);
    test_stage_paint(&stage);
    const double *wanted = stage.options.theme->colours[colour];
    int middle = 0;
    for (int x = TEST_STAGE_WIDTH / 2 - 50; x < TEST_STAGE_WIDTH / 2 + 50; x++)
        middle += test_picture_shows(stage.picture, x, TEST_STAGE_HEIGHT / 2, 0, wanted);
    g_assert_cmpint(middle, >, 5);
    for (int other = TINKER_COLOUR_CONNECTOR; other <= TINKER_COLOUR_DETACHED; other++)
        for (int x = TEST_STAGE_WIDTH / 2 - 50; x < TEST_STAGE_WIDTH / 2 + 50 && other != colour; x++)
            g_assert_false(
                test_picture_shows(stage.picture, x, TEST_STAGE_HEIGHT / 2, 0, stage.options.theme->colours[other]) &&
                other != TINKER_COLOUR_DETACHED);
    test_stage_close(&stage);
}

static void test_spring_states(void)
{
    static const char *const themes[] = {"light", "dark", "print"};
    for (gsize i = 0; i < G_N_ELEMENTS(themes); i++) {
        check_spring(5, themes[i], TINKER_COLOUR_COMPRESSED);
        check_spring(4, themes[i], TINKER_COLOUR_CONNECTOR);
        check_spring(3, themes[i], TINKER_COLOUR_STRETCHED);
    }
}

/* Every connector with an end in the air is grey; its colour of force or tension is gone. */
static void test_detached(void)
{
    static const char *const types[] = {"spring", "damper", "rod"};
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        g_autofree char *blocks = g_strdup_printf("{\"type\": \"%s\", \"ends\": [[-2, 0], [2, 0]]}", types[i]);
        TestStage stage;
        test_stage_open(&stage, blocks);
        test_stage_paint(&stage);
        g_assert_cmpint(test_stage_shown(&stage, TINKER_COLOUR_DETACHED), >, 30);
        g_assert_cmpint(test_stage_shown(&stage, TINKER_COLOUR_CONNECTOR), ==, 0);
        g_assert_cmpint(test_stage_shown(&stage, TINKER_COLOUR_COMPRESSED), ==, 0);
        test_stage_close(&stage);
    }
}

static void test_motor(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0]},"
                            "{\"type\": \"motor\", \"ends\": [\"A\"], \"amplitude\": 1}");
    test_stage_paint(&stage);
    g_assert_cmpint(test_stage_shown(&stage, TINKER_COLOUR_FORCE), >, 30);
    test_stage_close(&stage);
}

/* What is later in the scene covers what is earlier, within a layer; connectors lie over bodies. */
static void test_order(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"spring\", \"ends\": [[-3, 0], [3, 0]]},"
                            "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0], \"width\": 2, \"height\": 2}");
    test_stage_paint(&stage);
    const double *grey = stage.options.theme->colours[TINKER_COLOUR_DETACHED];
    int over = 0;
    for (int x = TEST_STAGE_WIDTH / 2 - 40; x < TEST_STAGE_WIDTH / 2 + 40; x++)
        over += test_picture_shows(stage.picture, x, TEST_STAGE_HEIGHT / 2, 0, grey);
    g_assert_cmpint(over, >, 3);
    test_stage_close(&stage);
}

/* A pivot lies over the body that hangs on it; what is solid lies beneath. */
static void test_pivot_over_body(void)
{
    static const char *const solid[] = {"false", "true"};
    for (int i = 0; i < 2; i++) {
        TestStage stage;
        g_autofree char *blocks =
            g_strdup_printf("{\"type\": \"support\", \"position\": [0, 0], \"solid\": %s},"
                            "{\"type\": \"disc\", \"position\": [0, 0], \"radius\": 3, \"orientation\": 90}",
                            solid[i]);
        test_stage_open(&stage, blocks);
        test_stage_paint(&stage);
        const double *edge = stage.options.theme->colours[TINKER_COLOUR_BODY_EDGE];
        /* the ground of the pin, 0.2 m below its top, at 50 pixels a metre */
        const gboolean shown =
            test_picture_shows(stage.picture, TEST_STAGE_WIDTH / 2.0 - 5, TEST_STAGE_HEIGHT / 2.0 + 10, 2, edge);
        g_assert_cmpint(shown, ==, i == 0);
        test_stage_close(&stage);
    }
}

/* Fields stand side by side in the upper left corner and are found there. */
static void test_fields(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"gravity\", \"name\": \"Down\"}, {\"type\": \"mass\", \"position\": [0, 0]},"
                            "{\"type\": \"wind\", \"name\": \"Breeze\", \"velocity\": [1, 0]}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    g_assert_cmpint(test_stage_shown(&stage, TINKER_COLOUR_FIELD), >, 60);
    const TinkerWrittenText *down = test_stage_text(&stage, "Down"), *breeze = test_stage_text(&stage, "Breeze");
    g_assert_nonnull(down);
    g_assert_nonnull(breeze);
    g_assert_cmpfloat(down->box[2], <, breeze->box[0]);
    g_assert_cmpfloat(breeze->box[2], <, TEST_STAGE_WIDTH / 2);
    g_assert_cmpfloat(down->box[3], <, TEST_STAGE_HEIGHT / 3);
    double above = down->box[1] - 20;
    TinkerBlockId gravity = tinker_scene_find_block(stage.scene, "Down");
    TinkerBlockId wind = tinker_scene_find_block(stage.scene, "Breeze");
    g_assert_cmpint(tinker_painter_field_at(stage.frame, &stage.view, (down->box[0] + down->box[2]) / 2, above), ==,
                    gravity);
    g_assert_cmpint(tinker_painter_field_at(stage.frame, &stage.view, (breeze->box[0] + breeze->box[2]) / 2, above), ==,
                    wind);
    g_assert_cmpint(tinker_painter_field_at(stage.frame, &stage.view, TEST_STAGE_WIDTH - 5, TEST_STAGE_HEIGHT - 5), ==,
                    TINKER_NO_BLOCK);
    /* Something over the top of the view: they go down by as much. */
    const double middle = (down->box[0] + down->box[2]) / 2, name = down->box[1];
    stage.view.covered = 40;
    test_stage_paint(&stage);
    g_assert_cmpfloat_with_epsilon(test_stage_text(&stage, "Down")->box[1], name + 40, 1e-9);
    g_assert_cmpint(tinker_painter_field_at(stage.frame, &stage.view, middle, 30), ==, TINKER_NO_BLOCK);
    g_assert_cmpint(tinker_painter_field_at(stage.frame, &stage.view, middle, above + 40), ==, gravity);
    test_stage_close(&stage);
}

/* Names of a crowd: none over another, all on the canvas; and none at all where the crowd is drawn too small. */
static void test_names(void)
{
    g_autoptr(GString) blocks = g_string_new(NULL);
    for (int i = 0; i < 60; i++)
        g_string_append_printf(blocks, "%s{\"type\": \"mass\", \"name\": \"Body %d\", \"position\": [%g, %g]}",
                               i ? "," : "", i, g_test_rand_double_range(-5, 5), g_test_rand_double_range(-3, 3));
    TestStage stage;
    test_stage_open(&stage, blocks->str);
    stage.options.show_labels = stage.options.show_time = TRUE;
    test_stage_paint(&stage);
    g_assert_cmpuint(stage.written->len, >, 20);
    for (guint i = 0; i < stage.written->len; i++) {
        const TinkerWrittenText *a = g_ptr_array_index(stage.written, i);
        for (guint n = 0; n < i; n++) {
            const TinkerWrittenText *b = g_ptr_array_index(stage.written, n);
            g_assert_true(a->box[2] <= b->box[0] || b->box[2] <= a->box[0] || a->box[3] <= b->box[1] ||
                          b->box[3] <= a->box[1]);
        }
    }
    g_assert_nonnull(test_stage_text(&stage, "t = 0.00 s"));
    stage.view.scale = 2;
    test_stage_paint(&stage);
    g_assert_cmpuint(stage.written->len, ==, 1);
    test_stage_close(&stage);
}

static void test_lone_name(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"mass\", \"name\": \"Lone\", \"position\": [0, 0]}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    const TinkerWrittenText *name = test_stage_text(&stage, "Lone");
    g_assert_nonnull(name);
    /* Beside its body, whose half side is 20 pixels, and near it. */
    double x = fmax(fmax(name->box[0] - TEST_STAGE_WIDTH / 2, TEST_STAGE_WIDTH / 2 - name->box[2]), 0);
    double y = fmax(fmax(name->box[1] - TEST_STAGE_HEIGHT / 2, TEST_STAGE_HEIGHT / 2 - name->box[3]), 0);
    g_assert_cmpfloat(fmax(x, y), >, 20);
    g_assert_cmpfloat(fmax(x, y), <, 50);
    test_stage_close(&stage);
}

static void test_selection(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0]}");
    TinkerBlockId block = tinker_scene_find_block(stage.scene, "A");
    test_stage_paint(&stage);
    double plain[4], selected[4], highlighted[4];
    int x = TEST_STAGE_WIDTH / 2 + 21, y = TEST_STAGE_HEIGHT / 2; /* just outside the box's edge */
    test_picture_pixel(stage.picture, x, y, plain);
    stage.options.selected = &block;
    stage.options.selected_count = 1;
    test_stage_paint(&stage);
    test_picture_pixel(stage.picture, x, y, selected);
    stage.options.selected_count = 0;
    stage.options.highlighted = block;
    test_stage_paint(&stage);
    test_picture_pixel(stage.picture, x, y, highlighted);
    g_assert_cmpfloat(plain[0], >, selected[0] + 0.2);
    g_assert_cmpfloat(plain[0], >, highlighted[0] + 0.2);
    g_assert_cmpfloat(fabs(selected[2] - highlighted[2]), >, 0.1);
    /* What is selected has an outline of its very colour, two units wide. */
    const double *colour = stage.options.theme->colours[TINKER_COLOUR_SELECTED];
    for (int i = 0; i < 3; i++)
        g_assert_cmpfloat_with_epsilon(selected[i], colour[i], 0.01);
    stage.options.highlighted = TINKER_NO_BLOCK;
    stage.options.selected_count = 1;
    test_stage_paint(&stage);
    test_picture_pixel(stage.picture, x + 2, y, selected);
    for (int i = 0; i < 3; i++)
        g_assert_cmpfloat_with_epsilon(selected[i], plain[i], 0.01);
    test_stage_close(&stage);
}

/* However far the view is away, a body is seen, and has its name, alone; in a crowd it is as small as it is. */
static void test_small_bodies(void)
{
    for (double scale = 50; scale > 1e-3; scale /= 3) {
        TestStage stage;
        test_stage_open(&stage,
                        "{\"type\": \"mass\", \"name\": \"A\", \"position\": [0, 0], \"width\": 0.2, \"height\": 0.2}");
        stage.view.scale = scale;
        stage.options.show_labels = TRUE;
        test_stage_paint(&stage);
        const double *ground = stage.options.theme->background;
        int ink = 0;
        for (int x = TEST_STAGE_WIDTH / 2 - 5; x < TEST_STAGE_WIDTH / 2 + 5; x++)
            for (int y = TEST_STAGE_HEIGHT / 2 - 5; y < TEST_STAGE_HEIGHT / 2 + 5; y++) {
                double pixel[4];
                test_picture_pixel(stage.picture, x, y, pixel);
                ink += fabs(pixel[0] - ground[0]) + fabs(pixel[1] - ground[1]) > 0.3;
            }
        g_test_message("%g units a metre: %d", scale, ink);
        g_assert_cmpint(ink, >=, 20); /* of pi 3^2 */
        g_assert_cmpint(ink, <=, 100);
        g_assert_cmpuint(stage.written->len, ==, 1);
        test_stage_close(&stage);
    }
}

/* A view that has gone astray is painted too. */
static void test_wild_views(void)
{
    static const double odd[] = {1e-9, 1e9, 1e300, -1e300, 0, 300};
    TestStage stage;
    test_stage_open(
        &stage, "{\"type\": \"support\", \"name\": \"S\", \"position\": [1, 2]},"
                "{\"type\": \"mass\", \"name\": \"A\", \"position\": [1e6, -1e6]},"
                "{\"type\": \"spring\", \"ends\": [\"S\", \"A\"]}, {\"type\": \"rod\", \"ends\": [\"A\", [4, -2]]}");
    stage.options.show_grid = stage.options.show_labels = TRUE;
    for (gsize i = 0; i < G_N_ELEMENTS(odd); i++)
        for (gsize n = 0; n < 2; n++) {
            stage.view.scale = n ? 1e9 : 1e-9;
            stage.view.origin_x = odd[i];
            stage.view.origin_y = -odd[i];
            test_stage_paint(&stage);
        }
    test_stage_close(&stage);
}

/* A block of an unknown type is shown with its name. */
static void test_placeholder(void)
{
    TestStage stage;
    test_stage_open(&stage, "{\"type\": \"pulley\", \"name\": \"Pulley 0\"}");
    stage.options.show_labels = TRUE;
    test_stage_paint(&stage);
    g_assert_nonnull(test_stage_text(&stage, "Pulley 0"));
    g_assert_cmpint(test_stage_shown(&stage, TINKER_COLOUR_WARNING), >, 20);
    test_stage_close(&stage);
}

/* The bounds hold everything that is drawn. */
static void test_bounds(void)
{
    TestStage stage;
    test_stage_open(&stage,
                    "{\"type\": \"support\", \"name\": \"S\", \"position\": [1, 2], \"orientation\": \"30 deg\"},"
                    "{\"type\": \"mass\", \"name\": \"A\", \"position\": [-3, -1]},"
                    "{\"type\": \"spring\", \"ends\": [\"S\", \"A\"]}, {\"type\": \"rod\", \"ends\": [\"A\", [4, -2]]},"
                    "{\"type\": \"motor\", \"ends\": [\"A\"]}");
    double box[4];
    tinker_painter_bounds(stage.frame, box);
    stage.view = tinker_view_fit(box, TEST_STAGE_WIDTH, TEST_STAGE_HEIGHT, 10);
    test_stage_paint(&stage);
    for (int x = 0; x < TEST_STAGE_WIDTH; x++)
        for (int y = 0; y < 8; y++) {
            double top[4], bottom[4];
            test_picture_pixel(stage.picture, x, y, top);
            test_picture_pixel(stage.picture, x, TEST_STAGE_HEIGHT - 1 - y, bottom);
            g_assert_cmpfloat(top[0] + top[1] + top[2] + bottom[0] + bottom[1] + bottom[2], ==, 6);
        }
    test_stage_close(&stage);
    test_stage_open(&stage, "");
    tinker_painter_bounds(stage.frame, box);
    g_assert_true(box[0] < box[2] && box[1] < box[3]);
    test_stage_close(&stage);
}

/* The bounds of a scene of 10 m with these blocks. */
static void bounds_of(const char *blocks, double box[4])
{
    TestStage stage;
    test_stage_open(&stage, blocks);
    tinker_painter_bounds(stage.frame, box);
    test_stage_close(&stage);
}

/* Of a floor of a kilometre as much is seen as lies about the body on it, wherever on it that is; one of 9 m is seen
 * wholly, and so is a long one with nothing else there. */
static void test_bounds_with_a_long_floor(void)
{
    static const double at[] = {0, 300, -499};
    double box[4];
    for (gsize i = 0; i < G_N_ELEMENTS(at); i++) {
        g_autofree char *blocks = g_strdup_printf("{'type': 'support', 'width': 1000, 'position': [0, -0.2]},"
                                                  "{'type': 'mass', 'position': [%g, 0.4]}",
                                                  at[i]);
        g_strdelimit(blocks, "'", '"');
        bounds_of(blocks, box);
        g_assert_cmpfloat(box[0], <=, at[i] - 0.4);
        g_assert_cmpfloat(box[2], >=, at[i] + 0.4);
        g_assert_cmpfloat(box[2] - box[0], >=, 10);
        g_assert_cmpfloat(fmax(box[2] - box[0], box[3] - box[1]), <, 13);
        g_assert_cmpfloat(box[1], <=, -0.4);
    }
    bounds_of("{\"type\": \"support\", \"width\": 9}, {\"type\": \"mass\", \"position\": [4, 0.6]}", box);
    g_assert_cmpfloat(box[0], <=, -4.5);
    g_assert_cmpfloat(box[2], >=, 4.5);
    bounds_of("{\"type\": \"support\", \"width\": 1000}", box);
    g_assert_cmpfloat(box[2] - box[0], >=, 1000);
    /* A steep one, too; and a body far beside the end of one: both are in it. */
    bounds_of("{\"type\": \"support\", \"width\": 1000, \"orientation\": \"30 deg\"}, {\"type\": \"mass\"}", box);
    g_assert_cmpfloat(fmax(box[2] - box[0], box[3] - box[1]), <, 13);
    bounds_of("{\"type\": \"support\", \"width\": 1000}, {\"type\": \"mass\", \"position\": [600, 0]}", box);
    g_assert_cmpfloat(box[0], <=, 500);
    g_assert_cmpfloat(box[2], >=, 600);
}

static void test_file_is_deterministic(void)
{
    g_autofree char *folder = g_dir_make_tmp("tinker-painter-XXXXXX", NULL);
    g_autofree char *path = g_build_filename(folder, "a.png", NULL);
    char *bytes[2];
    gsize length[2];
    g_autoptr(TinkerScene) scene = scene_fixture_read(scene_fixture_example);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    TinkerPaintOptions options = tinker_paint_options_default();
    options.show_title = options.show_time = options.show_local_origins = TRUE;
    for (int i = 0; i < 2; i++) {
        g_assert_true(tinker_paint_to_file(frame, NULL, 300, 200, &options, path, NULL));
        g_assert_true(g_file_get_contents(path, &bytes[i], &length[i], NULL));
    }
    g_assert_cmpmem(bytes[0], length[0], bytes[1], length[1]);
    g_unlink(path);
    g_rmdir(folder);
    g_free(bytes[0]);
    g_free(bytes[1]);
}

/* What is painted into a recording without bounds, upright or turned, shows as what is painted at once. */
static void test_recording(void)
{
    for (int turned = 0; turned < 2; turned++) {
        TestStage stage;
        test_stage_open(&stage, "{\"type\": \"mass\"}");
        cairo_surface_t *recording = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, NULL);
        cairo_t *cairo = cairo_create(recording);
        if (turned) {
            cairo_rotate(cairo, 0.5);
            cairo_rotate(stage.picture->cairo, 0.5);
        }
        test_stage_paint(&stage);
        tinker_paint_scene(cairo, stage.frame, &stage.view, &stage.options);
        g_assert_cmpint(cairo_status(cairo), ==, CAIRO_STATUS_SUCCESS);
        g_autoptr(TestPicture) shown = test_picture_new(TEST_STAGE_WIDTH, TEST_STAGE_HEIGHT);
        cairo_set_source_surface(shown->cairo, recording, 0, 0);
        cairo_paint(shown->cairo);
        const double *body = stage.options.theme->colours[TINKER_COLOUR_BODY];
        g_assert_cmpint(test_picture_count(shown, body), >, 100);
        g_assert_cmpint(test_picture_count(shown, body), ==, test_picture_count(stage.picture, body));
        cairo_destroy(cairo);
        cairo_surface_destroy(recording);
        test_stage_close(&stage);
    }
}

static void add_tests(void)
{
    g_test_add_func("/render/painter/spring-states", test_spring_states);
    g_test_add_func("/render/painter/detached", test_detached);
    g_test_add_func("/render/painter/motor", test_motor);
    g_test_add_func("/render/painter/order", test_order);
    g_test_add_func("/render/painter/pivot-over-body", test_pivot_over_body);
    g_test_add_func("/render/painter/fields", test_fields);
    g_test_add_func("/render/painter/names", test_names);
    g_test_add_func("/render/painter/lone-name", test_lone_name);
    g_test_add_func("/render/painter/selection", test_selection);
    g_test_add_func("/render/painter/small-bodies", test_small_bodies);
    g_test_add_func("/render/painter/placeholder", test_placeholder);
    g_test_add_func("/render/painter/wild-views", test_wild_views);
    g_test_add_func("/render/painter/bounds", test_bounds);
    g_test_add_func("/render/painter/bounds-with-a-long-floor", test_bounds_with_a_long_floor);
    g_test_add_func("/render/painter/file-is-deterministic", test_file_is_deterministic);
    g_test_add_func("/render/painter/recording", test_recording);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
