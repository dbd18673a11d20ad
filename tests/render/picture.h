/* Pictures in memory, for tests that look at pixels. */
#ifndef TEST_PICTURE_H
#define TEST_PICTURE_H

#include <cairo.h>
#include <glib.h>

typedef struct {
    cairo_surface_t *surface;
    cairo_t *cairo;
    int width, height;
} TestPicture;

/* A transparent picture. (transfer full) */
TestPicture *test_picture_new(int width, int height);
void test_picture_free(TestPicture *picture);
G_DEFINE_AUTOPTR_CLEANUP_FUNC(TestPicture, test_picture_free)

/* Red, green, blue and alpha of a pixel, 0 to 1, not premultiplied. */
void test_picture_pixel(const TestPicture *picture, int x, int y, double rgba[4]);

/* Whether the pixel, or with `reach` one up to so many pixels from it, is near this colour (of red, green, blue). */
gboolean test_picture_shows(const TestPicture *picture, double x, double y, int reach, const double colour[4]);

/* Pixels of the whole picture that are near the colour. */
int test_picture_count(const TestPicture *picture, const double colour[4]);

/* Whether a pixel within reach has any ink. */
gboolean test_picture_has_ink(const TestPicture *picture, double x, double y, int reach);

#endif
