/* The icons, drawn by librsvg as a desktop draws them: each gives a picture of the size asked for, fills a good part of
 * it, leaves its corners free, and has the colours that its kind must have. */
#include <cairo.h>
#include <glib.h>
#include <string.h>

#include "installed.h"

#define FOLDER "icons/hicolor/"

typedef struct {
    const char *file;
    gboolean symbolic;
} Icon;

static const Icon icons[] = {
    {FOLDER "scalable/apps/org.tinker.Tinker.svg", FALSE},
    {FOLDER "scalable/mimetypes/application-vnd.tinker.scene+json.svg", FALSE},
    {FOLDER "16x16/apps/org.tinker.Tinker.svg", FALSE},
    {FOLDER "16x16/mimetypes/application-vnd.tinker.scene+json.svg", FALSE},
    {FOLDER "symbolic/apps/org.tinker.Tinker-symbolic.svg", TRUE},
};

static cairo_surface_t *drawn(const Icon *icon, int size)
{
    g_autofree char *svg = test_installed_path(icon->file), *png = test_installed_path("icon.png");
    g_autofree char *pixels = g_strdup_printf("%d", size);
    const char *arguments[] = {"rsvg-convert", "-w", pixels, "-h", pixels, "-o", png, svg, NULL};
    g_autofree char *output = test_tool_output(arguments);
    g_assert_cmpstr(output, ==, "");
    cairo_surface_t *surface = cairo_image_surface_create_from_png(png);
    g_assert_cmpint(cairo_surface_status(surface), ==, CAIRO_STATUS_SUCCESS);
    g_assert_cmpint(cairo_image_surface_get_format(surface), ==, CAIRO_FORMAT_ARGB32);
    g_assert_cmpint(cairo_image_surface_get_width(surface), ==, size);
    g_assert_cmpint(cairo_image_surface_get_height(surface), ==, size);
    return surface;
}

static guint32 pixel(cairo_surface_t *surface, int x, int y)
{
    const unsigned char *row = cairo_image_surface_get_data(surface) + y * cairo_image_surface_get_stride(surface);
    guint32 value;
    memcpy(&value, row + 4 * x, sizeof value);
    return value;
}

/* What is to be seen of a picture: the share of its pixels that is fully opaque, how many colours these have, and the
 * largest difference between two of them in any channel. */
typedef struct {
    double coverage;
    guint colours;
    int spread;
} Look;

static Look look_of(cairo_surface_t *surface, int size)
{
    g_autoptr(GHashTable) colours = g_hash_table_new(NULL, NULL);
    int opaque = 0, least[3] = {255, 255, 255}, most[3] = {0, 0, 0};
    for (int i = 0; i < size * size; i++) {
        const guint32 colour = pixel(surface, i % size, i / size);
        if (colour >> 24 != 0xff) continue;
        opaque++;
        g_hash_table_add(colours, GUINT_TO_POINTER(colour));
        for (int k = 0; k < 3; k++) {
            const int channel = (colour >> 8 * k) & 0xff;
            least[k] = MIN(least[k], channel);
            most[k] = MAX(most[k], channel);
        }
    }
    const int spread = MAX(most[0] - least[0], MAX(most[1] - least[1], most[2] - least[2]));
    return (Look){opaque / ((double)size * size), g_hash_table_size(colours), spread};
}

static void test_pictures(gconstpointer data)
{
    const Icon *icon = data;
    static const int sizes[] = {16, 32, 64, 128, 256};
    for (gsize i = 0; i < G_N_ELEMENTS(sizes); i++) {
        const int size = sizes[i], last = size - 1;
        cairo_surface_t *surface = drawn(icon, size);
        const Look look = look_of(surface, size);
        g_assert_cmpfloat(look.coverage, >, 0.25);
        g_assert_cmpfloat(look.coverage, <, 0.85);
        if (icon->symbolic) /* one colour, but for rounding where areas overlap */
            g_assert_cmpint(look.spread, <=, 4);
        else
            g_assert_cmpuint(look.colours, >, 4);
        const guint32 corners = pixel(surface, 0, last) | pixel(surface, last, last);
        g_assert_cmphex(corners >> 24, ==, 0);
        cairo_surface_destroy(surface);
    }
}

/* A toolkit recolours fills and nothing else: a line would keep its colour, and be filled besides. */
static void test_symbols_are_areas(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(icons); i++) {
        if (!icons[i].symbolic) continue;
        g_autofree char *svg = test_installed_text(icons[i].file);
        g_assert_null(strstr(svg, "stroke"));
        g_assert_null(strstr(svg, "Gradient"));
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    for (gsize i = 0; i < G_N_ELEMENTS(icons); i++) {
        g_autofree char *path = g_strconcat("/data/", icons[i].file, NULL);
        g_test_add_data_func(path, &icons[i], test_pictures);
    }
    g_test_add_func("/data/icons/symbols-are-areas", test_symbols_are_areas);
    test_installed_set_up();
    const int status = g_test_run();
    test_installed_tear_down();
    return status;
}
