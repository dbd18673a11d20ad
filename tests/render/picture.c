#include "picture.h"

#include <math.h>

#define NEAR 0.12

TestPicture *test_picture_new(int width, int height)
{
    TestPicture *picture = g_new0(TestPicture, 1);
    picture->surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    picture->cairo = cairo_create(picture->surface);
    picture->width = width;
    picture->height = height;
    return picture;
}

void test_picture_free(TestPicture *picture)
{
    g_assert_cmpint(cairo_status(picture->cairo), ==, CAIRO_STATUS_SUCCESS);
    cairo_destroy(picture->cairo);
    cairo_surface_destroy(picture->surface);
    g_free(picture);
}

void test_picture_pixel(const TestPicture *picture, int x, int y, double rgba[4])
{
    cairo_surface_flush(picture->surface);
    const unsigned char *data = cairo_image_surface_get_data(picture->surface);
    const unsigned char *row = data + (gsize)y * (gsize)cairo_image_surface_get_stride(picture->surface);
    guint32 pixel = ((const guint32 *)(const void *)row)[x];
    rgba[3] = (pixel >> 24 & 0xff) / 255.0;
    for (int i = 0; i < 3; i++)
        rgba[i] = rgba[3] > 0 ? (pixel >> (16 - 8 * i) & 0xff) / 255.0 / rgba[3] : 0;
}

static gboolean is_near(const TestPicture *picture, int x, int y, const double colour[4])
{
    double rgba[4];
    test_picture_pixel(picture, x, y, rgba);
    if (rgba[3] < 0.5) return FALSE;
    for (int i = 0; i < 3; i++)
        if (fabs(rgba[i] - colour[i]) > NEAR) return FALSE;
    return TRUE;
}

gboolean test_picture_shows(const TestPicture *picture, double x, double y, int reach, const double colour[4])
{
    for (int j = MAX((int)floor(y) - reach, 0); j <= MIN((int)floor(y) + reach, picture->height - 1); j++)
        for (int i = MAX((int)floor(x) - reach, 0); i <= MIN((int)floor(x) + reach, picture->width - 1); i++)
            if (is_near(picture, i, j, colour)) return TRUE;
    return FALSE;
}

int test_picture_count(const TestPicture *picture, const double colour[4])
{
    int count = 0;
    for (int j = 0; j < picture->height; j++)
        for (int i = 0; i < picture->width; i++)
            count += is_near(picture, i, j, colour);
    return count;
}

gboolean test_picture_has_ink(const TestPicture *picture, double x, double y, int reach)
{
    for (int j = MAX((int)floor(y) - reach, 0); j <= MIN((int)floor(y) + reach, picture->height - 1); j++)
        for (int i = MAX((int)floor(x) - reach, 0); i <= MIN((int)floor(x) + reach, picture->width - 1); i++) {
            double rgba[4];
            test_picture_pixel(picture, i, j, rgba);
            if (rgba[3] > 0.3) return TRUE;
        }
    return FALSE;
}
