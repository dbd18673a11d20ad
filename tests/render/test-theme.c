/* Themes are complete, and their colours can be told from the ground and from each other. */
#include <math.h>

#include "render/theme.h"

static const char *const ids[] = {"light", "dark", "print"};

/* Relative luminance and contrast as the Web Content Accessibility Guidelines 2.1 define them. */
static double linear(double channel)
{
    return channel <= 0.03928 ? channel / 12.92 : pow((channel + 0.055) / 1.055, 2.4);
}

static double luminance(const double c[4])
{
    return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

static double contrast(const double a[4], const double b[4])
{
    double high = fmax(luminance(a), luminance(b)), low = fmin(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

static double distance(const double a[4], const double b[4])
{
    return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2));
}

static void test_complete(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(ids); i++) {
        const TinkerTheme *theme = tinker_theme_find(ids[i]);
        g_assert_nonnull(theme);
        g_assert_cmpstr(theme->id, ==, ids[i]);
        for (int colour = 0; colour < TINKER_COLOUR_COUNT; colour++) {
            g_assert_cmpfloat(theme->colours[colour][3], ==, 1);
            g_assert_cmpfloat(contrast(theme->colours[colour], theme->background), >, 1.15);
        }
        for (int curve = 0; curve < 8; curve++) {
            g_assert_cmpfloat(theme->curves[curve][3], ==, 1);
            g_assert_cmpfloat(contrast(theme->curves[curve], theme->background), >, 2);
            for (int other = 0; other < curve; other++)
                g_assert_cmpfloat(distance(theme->curves[curve], theme->curves[other]), >, 0.2);
        }
        g_assert_cmpfloat(contrast(theme->colours[TINKER_COLOUR_TEXT], theme->background), >, 7);
        g_assert_cmpfloat(contrast(theme->axis, theme->background), >, 4.5);
    }
    g_assert_null(tinker_theme_find("sepia"));
    g_assert_null(tinker_theme_find(NULL));
}

/* Compressed is red, stretched is blue, at rest black or on a dark ground white, detached is grey, a motor orange. */
static void test_meanings(void)
{
    for (gsize i = 0; i < G_N_ELEMENTS(ids); i++) {
        const TinkerTheme *theme = tinker_theme_find(ids[i]);
        const double *red = theme->colours[TINKER_COLOUR_COMPRESSED], *blue = theme->colours[TINKER_COLOUR_STRETCHED];
        const double *rest = theme->colours[TINKER_COLOUR_CONNECTOR], *grey = theme->colours[TINKER_COLOUR_DETACHED];
        const double *orange = theme->colours[TINKER_COLOUR_FORCE];
        g_assert_true(red[0] > red[1] + 0.4 && red[0] > red[2] + 0.4);
        g_assert_true(blue[2] > blue[0] + 0.4 && blue[2] > blue[1] + 0.2);
        for (int channel = 0; channel < 3; channel++)
            g_assert_cmpfloat(rest[channel], ==, i == 1 ? 1 : 0);
        g_assert_true(grey[0] == grey[1] && grey[1] == grey[2]);
        g_assert_true(orange[0] > orange[1] + 0.2 && orange[1] > orange[2] + 0.2);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/theme/complete", test_complete);
    g_test_add_func("/render/theme/meanings", test_meanings);
    return g_test_run();
}
