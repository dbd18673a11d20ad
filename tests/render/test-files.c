/* Pictures in files: the right kind, complete, the same bytes twice, all or nothing. */
#include <glib/gstdio.h>
#include <math.h>
#include <string.h>

#include "render/plot/plot.h"

typedef struct {
    char *folder;
} Place;

static void set_up(Place *place, gconstpointer data)
{
    place->folder = g_dir_make_tmp("tinker-files-XXXXXX", NULL);
    g_assert_nonnull(place->folder);
}

static void tear_down(Place *place, gconstpointer data)
{
    g_autoptr(GDir) folder = g_dir_open(place->folder, 0, NULL);
    for (const char *name; (name = g_dir_read_name(folder));) {
        g_autofree char *path = g_build_filename(place->folder, name, NULL);
        g_remove(path);
    }
    g_rmdir(place->folder);
    g_free(place->folder);
}

static char *written(const Place *place, const char *name, gsize *length)
{
    double x[100], y[100];
    for (int i = 0; i < 100; i++) {
        x[i] = i * 0.1;
        y[i] = sin(x[i]);
    }
    const TinkerCurve curve = {.label = "Mass 0 y", .x = x, .y = y, .count = 100};
    const TinkerPlot plot = {
        .title = "Title", .x_label = "Time [s]", .y_label = "Y [m]", .curves = &curve, .curve_count = 1};
    g_autofree char *path = g_build_filename(place->folder, name, NULL);
    g_autoptr(GError) error = NULL;
    char *bytes;
    g_assert_true(tinker_plot_to_file(&plot, 320, 240, path, &error));
    g_assert_no_error(error);
    g_assert_true(g_file_get_contents(path, &bytes, length, &error));
    return bytes;
}

static void test_png(Place *place, gconstpointer data)
{
    gsize length, again;
    g_autofree char *first = written(place, "a.png", &length), *second = written(place, "b.PNG", &again);
    g_assert_cmpmem(first, length, second, again);
    g_assert_cmpmem(first, 8, "\x89PNG\r\n\x1a\n", 8);
    /* The size stands in the header, big-endian; the last chunk is IEND. */
    g_assert_cmpmem(first + 16, 8, "\0\0\1\x40\0\0\0\xf0", 8);
    g_assert_cmpmem(first + length - 8, 4, "IEND", 4);
}

static void test_svg(Place *place, gconstpointer data)
{
    gsize length;
    g_autofree char *text = written(place, "a.svg", &length);
    g_assert_true(g_str_has_prefix(text, "<?xml"));
    g_assert_nonnull(strstr(text, "<svg"));
    g_assert_nonnull(strstr(text, "width=\"320px\""));
    g_assert_true(g_str_has_suffix(g_strchomp(text), "</svg>"));
}

static void test_pdf(Place *place, gconstpointer data)
{
    gsize length;
    g_autofree char *bytes = written(place, "a.pdf", &length);
    g_assert_cmpmem(bytes, 5, "%PDF-", 5);
    g_assert_cmpmem(bytes + length - 6, 5, "%%EOF", 5);
}

static void refuse(const char *path, int width, int code)
{
    const TinkerPlot plot = {.curves = NULL};
    g_autoptr(GError) error = NULL;
    g_assert_false(tinker_plot_to_file(&plot, width, 100, path, &error));
    g_assert_error(error, G_FILE_ERROR, code);
    g_assert_nonnull(strstr(error->message, path));
}

static void test_refusals(Place *place, gconstpointer data)
{
    refuse("-", 100, G_FILE_ERROR_INVAL);
    refuse("", 100, G_FILE_ERROR_INVAL);
    refuse("picture.jpg", 100, G_FILE_ERROR_INVAL);
    refuse("picture.png", 0, G_FILE_ERROR_INVAL);
    refuse("picture.png", -3, G_FILE_ERROR_INVAL);
    refuse("picture.png", 1 << 30, G_FILE_ERROR_INVAL);
    refuse("/nonexistent/folder/picture.png", 100, G_FILE_ERROR_NOENT);
    g_assert_false(g_file_test("picture.png", G_FILE_TEST_EXISTS));
}

/* A picture that cannot replace the old one leaves it, and nothing beside it. */
static void test_replaces(Place *place, gconstpointer data)
{
    gsize length, again;
    g_autofree char *path = g_build_filename(place->folder, "a.png", NULL);
    g_assert_true(g_file_set_contents(path, "old", 3, NULL));
    g_autofree char *bytes = written(place, "a.png", &length);
    g_autofree char *other = written(place, "b.png", &again);
    g_assert_cmpmem(bytes, length, other, again);
    g_autoptr(GDir) folder = g_dir_open(place->folder, 0, NULL);
    int files = 0;
    while (g_dir_read_name(folder))
        files++;
    g_assert_cmpint(files, ==, 2);
}

#define add(path, function) g_test_add(path, Place, NULL, set_up, function, tear_down)

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    add("/render/files/png", test_png);
    add("/render/files/svg", test_svg);
    add("/render/files/pdf", test_pdf);
    add("/render/files/refusals", test_refusals);
    add("/render/files/replaces", test_replaces);
    return g_test_run();
}
