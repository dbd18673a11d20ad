/* Icons of all blocks that are installed: they have ink, keep within their rectangle, and show what the block is by its
 * colours. */
#include "render/picture/icon.h"

#include <glib/gstdio.h>

#include "picture.h"
#include "scene-fixture.h"

#define ROOM 20 /* pixels about an icon, which have to stay empty */

typedef struct {
    TestPicture *picture;
    int box[4]; /* of the ink, in the icon's pixels */
    int ink;
} Icon;

static Icon icon_draw(const TinkerBlockClass *block_class, int width, int height, double scale, const char *theme)
{
    Icon icon = {.picture = test_picture_new((int)(width * scale) + 2 * ROOM, (int)(height * scale) + 2 * ROOM),
                 .box = {G_MAXINT, G_MAXINT, G_MININT, G_MININT}};
    cairo_translate(icon.picture->cairo, ROOM, ROOM);
    cairo_scale(icon.picture->cairo, scale, scale);
    tinker_paint_block_icon(icon.picture->cairo, block_class, width, height, tinker_theme_find(theme));
    for (int y = 0; y < icon.picture->height; y++)
        for (int x = 0; x < icon.picture->width; x++) {
            double rgba[4];
            test_picture_pixel(icon.picture, x, y, rgba);
            if (rgba[3] < 0.1) continue;
            icon.ink++;
            icon.box[0] = MIN(icon.box[0], x - ROOM);
            icon.box[1] = MIN(icon.box[1], y - ROOM);
            icon.box[2] = MAX(icon.box[2], x - ROOM + 1);
            icon.box[3] = MAX(icon.box[3], y - ROOM + 1);
        }
    return icon;
}

/* In the middle, and as large as one of the sides lets it. */
static void check_fit(const Icon *icon, double width, double height)
{
    g_assert_cmpint(icon->ink, >, 20);
    g_assert_cmpint(icon->box[0], >=, 0);
    g_assert_cmpint(icon->box[1], >=, 0);
    g_assert_cmpfloat(icon->box[2], <=, width);
    g_assert_cmpfloat(icon->box[3], <=, height);
    g_assert_cmpfloat_with_epsilon((icon->box[0] + icon->box[2]) / 2.0, width / 2, 0.05 * width + 1);
    g_assert_cmpfloat_with_epsilon((icon->box[1] + icon->box[3]) / 2.0, height / 2, 0.05 * height + 1);
    double across = (icon->box[2] - icon->box[0]) / width, up = (icon->box[3] - icon->box[1]) / height;
    g_assert_cmpfloat(MAX(across, up), >, 0.5);
}

static void test_fit(void)
{
    static const double sizes[][3] = {{48, 32, 1}, {48, 32, 2}, {96, 64, 1}, {32, 32, 1}, {24, 80, 1}};
    TinkerCatalogue *catalogue = scene_fixture_catalogue();
    g_autoptr(GPtrArray) libraries = tinker_catalogue_libraries(catalogue);
    int drawn = 0;
    for (guint i = 0; i < libraries->len; i++) {
        const TinkerLibraryEntry *library = g_ptr_array_index(libraries, i);
        for (guint n = 0; n < library->types->len; n++) {
            const TinkerTypeEntry *type = g_ptr_array_index(library->types, n);
            const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, type->id, NULL);
            for (gsize size = 0; block_class != NULL && size < G_N_ELEMENTS(sizes); size++) {
                const double *s = sizes[size];
                Icon icon = icon_draw(block_class, (int)s[0], (int)s[1], s[2], "light");
                check_fit(&icon, s[0] * s[2], s[1] * s[2]);
                test_picture_free(icon.picture);
                drawn++;
            }
        }
    }
    g_assert_cmpint(drawn, >=, 9 * (int)G_N_ELEMENTS(sizes));
}

/* A connector is at rest and attached: neither red nor blue nor grey. A force is orange, though its sine starts at 0.
 */
static void test_colours(void)
{
    static const struct {
        const char *type;
        int shown;
    } wanted[] = {{"mass", TINKER_COLOUR_BODY},
                  {"support", TINKER_COLOUR_SUPPORT},
                  {"spring", TINKER_COLOUR_CONNECTOR},
                  {"damper", TINKER_COLOUR_CONNECTOR},
                  {"rod", TINKER_COLOUR_CONNECTOR},
                  {"motor", TINKER_COLOUR_FORCE},
                  {"gravity", TINKER_COLOUR_FIELD},
                  {"wind", TINKER_COLOUR_FIELD},
                  {"support-motion", TINKER_COLOUR_MOTION},
                  {"rope", TINKER_COLOUR_CONNECTOR},
                  {"marker", TINKER_COLOUR_MOTION}};
    TinkerCatalogue *catalogue = scene_fixture_catalogue();
    for (gsize i = 0; i < G_N_ELEMENTS(wanted); i++)
        for (const char *const *theme = tinker_theme_ids(); *theme; theme++) {
            const double(*colours)[4] = tinker_theme_find(*theme)->colours;
            Icon icon = icon_draw(tinker_catalogue_type(catalogue, wanted[i].type, NULL), 48, 32, 4, *theme);
            g_assert_cmpint(test_picture_count(icon.picture, colours[wanted[i].shown]), >, 100);
            g_assert_cmpint(test_picture_count(icon.picture, colours[TINKER_COLOUR_COMPRESSED]), ==, 0);
            g_assert_cmpint(test_picture_count(icon.picture, colours[TINKER_COLOUR_STRETCHED]), ==, 0);
            test_picture_free(icon.picture);
        }
}

/* Blocks without a drawing are drawn as the painter draws them: connectors as lines, others as boxes. */
static void test_plain(void)
{
    static const char *const types[] = {"spring", "mass", "gravity", "motor"};
    TinkerCatalogue *catalogue = scene_fixture_catalogue();
    for (gsize i = 0; i < G_N_ELEMENTS(types); i++) {
        TinkerBlockClass plain = *tinker_catalogue_type(catalogue, types[i], NULL);
        plain.render = NULL;
        Icon icon = icon_draw(&plain, 48, 32, 2, "dark");
        g_assert_cmpint(icon.ink, >, 20);
        g_assert_cmpint(icon.box[0], >=, 0);
        g_assert_cmpint(icon.box[2], <=, 96);
        test_picture_free(icon.picture);
    }
}

/* A rectangle without room draws nothing, and nothing else goes wrong. */
/* A picture beside the library takes the place of the drawing; one that is none does not. */
static void test_own_picture(void)
{
    g_autoptr(GError) error = NULL;
    g_autofree char *folder = g_dir_make_tmp("tinker-icon-XXXXXX", &error),
                    *file = g_build_filename(folder, "i.png", NULL);
    g_autofree char *library = g_build_filename(folder, "spring.so", NULL);
    const TinkerBlockClass *spring = tinker_catalogue_type(scene_fixture_catalogue(), "spring", NULL);
    TinkerBlockType type = *spring->type;
    TinkerBlockClass block_class = *spring;
    type.icon_path = "i.png";
    block_class.type = &type;
    block_class.path = library;
    cairo_surface_t *red = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 20, 40);
    cairo_t *cairo = cairo_create(red);
    cairo_set_source_rgb(cairo, 1, 0, 0);
    cairo_paint(cairo);
    g_assert_cmpint(cairo_surface_write_to_png(red, file), ==, CAIRO_STATUS_SUCCESS);
    cairo_destroy(cairo);
    cairo_surface_destroy(red);
    double middle[4], beside[4];
    Icon own = icon_draw(&block_class, 48, 32, 1, "light");
    test_picture_pixel(own.picture, ROOM + 24, ROOM + 16, middle);
    test_picture_pixel(own.picture, ROOM + 10, ROOM + 16, beside);
    g_assert_true(middle[0] > 0.9 && middle[1] < 0.1 && middle[3] > 0.9 && beside[3] < 0.1);
    g_assert_cmpint(own.box[3] - own.box[1], ==, 32);
    test_picture_free(own.picture);
    g_assert_true(g_file_set_contents(file, "no picture", -1, NULL));
    Icon drawn = icon_draw(&block_class, 48, 32, 1, "light");
    check_fit(&drawn, 48, 32);
    test_picture_free(drawn.picture);
    g_remove(file);
    g_rmdir(folder);
}

static void test_no_room(void)
{
    static const double odd[] = {0, -5, 1, NAN, INFINITY};
    TinkerCatalogue *catalogue = scene_fixture_catalogue();
    const TinkerBlockClass *block_class = tinker_catalogue_type(catalogue, "spring", NULL);
    g_autoptr(TestPicture) picture = test_picture_new(20, 20);
    for (gsize i = 0; i < G_N_ELEMENTS(odd); i++) {
        tinker_paint_block_icon(picture->cairo, block_class, odd[i], 20, tinker_theme_find("light"));
        tinker_paint_block_icon(picture->cairo, block_class, 20, odd[i], tinker_theme_find("light"));
    }
    g_assert_false(test_picture_has_ink(picture, 10, 10, 20));
}

static void add_tests(void)
{
    g_test_add_func("/render/icon/fit", test_fit);
    g_test_add_func("/render/icon/colours", test_colours);
    g_test_add_func("/render/icon/plain", test_plain);
    g_test_add_func("/render/icon/own-picture", test_own_picture);
    g_test_add_func("/render/icon/no-room", test_no_room);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
