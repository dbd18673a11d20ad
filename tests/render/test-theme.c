/* Themes are complete, and their colours can be told from the ground and from each other. */
#include <math.h>

#include "render/draw/theme.h"

typedef struct {
    const char *id;
    gboolean dark;
    double text,
        mark; /* contrast that texts and marks have at least: WCAG 2.1, success criteria 1.4.3 or 1.4.6, and 1.4.11 */
} Wanted;
static const Wanted themes[] = {{"light", FALSE, 4.5, 3},
                                {"dark", TRUE, 4.5, 3},
                                {"print", FALSE, 4.5, 3},
                                {"contrast-light", FALSE, 7, 4.5},
                                {"contrast-dark", TRUE, 7, 4.5}};

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
    const char *const *listed = tinker_theme_ids();
    g_assert_cmpuint(g_strv_length((char **)listed), ==, G_N_ELEMENTS(themes));
    for (gsize i = 0; i < G_N_ELEMENTS(themes); i++) {
        const TinkerTheme *theme = tinker_theme_find(themes[i].id);
        g_assert_nonnull(theme);
        g_assert_cmpstr(theme->id, ==, themes[i].id);
        g_assert_true(g_strv_contains(listed, theme->id));
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
    for (gsize i = 0; i < G_N_ELEMENTS(themes); i++) {
        const TinkerTheme *theme = tinker_theme_find(themes[i].id);
        const double *red = theme->colours[TINKER_COLOUR_COMPRESSED], *blue = theme->colours[TINKER_COLOUR_STRETCHED];
        const double *rest = theme->colours[TINKER_COLOUR_CONNECTOR], *grey = theme->colours[TINKER_COLOUR_DETACHED];
        const double *orange = theme->colours[TINKER_COLOUR_FORCE];
        g_assert_true(red[0] > red[1] + 0.4 && red[0] > red[2] + 0.4);
        g_assert_true(blue[2] > blue[0] + 0.4 && blue[2] > blue[1] + 0.2);
        for (int channel = 0; channel < 3; channel++)
            g_assert_cmpfloat(rest[channel], ==, themes[i].dark ? 1 : 0);
        g_assert_true(grey[0] == grey[1] && grey[1] == grey[2]);
        g_assert_true(orange[0] > orange[1] + 0.2 && orange[1] > orange[2] + 0.2);
    }
}

/* Texts, in any of the colours that something is written in; and what has to be seen to understand the picture. The
 * grid stays behind all of it. */
static void test_contrast(void)
{
    static const int texts[] = {TINKER_COLOUR_TEXT, TINKER_COLOUR_FIELD, TINKER_COLOUR_WARNING, TINKER_COLOUR_DETACHED};
    static const int marks[] = {TINKER_COLOUR_BODY_EDGE, TINKER_COLOUR_CONNECTOR, TINKER_COLOUR_COMPRESSED,
                                TINKER_COLOUR_STRETCHED, TINKER_COLOUR_SELECTED,  TINKER_COLOUR_HIGHLIGHTED,
                                TINKER_COLOUR_FORCE,     TINKER_COLOUR_MOTION};
    for (gsize i = 0; i < G_N_ELEMENTS(themes); i++) {
        const TinkerTheme *theme = tinker_theme_find(themes[i].id);
        for (gsize k = 0; k < G_N_ELEMENTS(texts); k++)
            g_assert_cmpfloat(contrast(theme->colours[texts[k]], theme->background), >=, themes[i].text);
        for (gsize k = 0; k < G_N_ELEMENTS(marks); k++)
            g_assert_cmpfloat(contrast(theme->colours[marks[k]], theme->background), >=, themes[i].mark);
        g_assert_cmpfloat(contrast(theme->colours[TINKER_COLOUR_TEXT], theme->colours[TINKER_COLOUR_BODY]), >=,
                          themes[i].text);
        g_assert_cmpfloat(contrast(theme->grid, theme->background), <, 2.5);
        if (themes[i].mark < 4.5) continue;
        for (int curve = 0; curve < 8; curve++)
            g_assert_cmpfloat(contrast(theme->curves[curve], theme->background), >=, themes[i].mark);
    }
}

/* Colour blindness ------------------------------------------------------------------------------------------------- */

/* What linear red, green and blue become: nothing lost; without long and without medium waves after Viénot, Brettel and
 * Mollon, "Digital video colourmaps for checking the legibility of displays by dichromats" (1999); without short ones
 * after Machado, Oliveira and Fernandes, "A physiologically-based model for simulation of color vision deficiency"
 * (2009). */
static const double sights[4][3][3] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0.11238, 0.88762, 0}, {0.11238, 0.88762, 0}, {0.00401, -0.00401, 1}},
    {{0.29275, 0.70725, 0}, {0.29275, 0.70725, 0}, {-0.02234, 0.02234, 1}},
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}},
};

static double lab_function(double share)
{
    return share > 0.008856 ? cbrt(share) : 7.787 * share + 16.0 / 116;
}

/* CIE 1976 L*a*b* of a colour of sRGB, white of daylight D65, as such eyes see it. */
static void lab_of(const double c[4], const double sight[3][3], double lab[3])
{
    static const double xyz[3][3] = {{0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505},
                                     {0.2126, 0.7152, 0.0722},
                                     {0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089}};
    double seen[3], f[3];
    for (int i = 0; i < 3; i++) {
        seen[i] = 0;
        for (int k = 0; k < 3; k++)
            seen[i] += sight[i][k] * linear(c[k]);
        seen[i] = CLAMP(seen[i], 0, 1);
    }
    for (int i = 0; i < 3; i++)
        f[i] = lab_function(xyz[i][0] * seen[0] + xyz[i][1] * seen[1] + xyz[i][2] * seen[2]);
    lab[0] = 116 * f[1] - 16;
    lab[1] = 500 * (f[0] - f[1]);
    lab[2] = 200 * (f[1] - f[2]);
}

/* The least distance that any eyes see between two colours; 2.3 is just noticed side by side. */
static double seen_distance(const double a[4], const double b[4])
{
    double least = INFINITY;
    for (gsize i = 0; i < G_N_ELEMENTS(sights); i++) {
        double first[3], second[3];
        lab_of(a, sights[i], first);
        lab_of(b, sights[i], second);
        least = fmin(least,
                     sqrt(pow(first[0] - second[0], 2) + pow(first[1] - second[1], 2) + pow(first[2] - second[2], 2)));
    }
    return least;
}

static void test_colour_blindness(void)
{
    static const int groups[][4] = {
        {TINKER_COLOUR_CONNECTOR, TINKER_COLOUR_COMPRESSED, TINKER_COLOUR_STRETCHED, TINKER_COLOUR_DETACHED},
        {TINKER_COLOUR_FORCE, TINKER_COLOUR_MOTION, TINKER_COLOUR_FIELD, -1},
        {TINKER_COLOUR_SELECTED, TINKER_COLOUR_HIGHLIGHTED, -1, -1},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(themes); i++) {
        const TinkerTheme *theme = tinker_theme_find(themes[i].id);
        for (gsize n = 0; n < G_N_ELEMENTS(groups); n++)
            for (int a = 0; a < 4 && groups[n][a] >= 0; a++)
                for (int b = 0; b < a; b++)
                    g_assert_cmpfloat(seen_distance(theme->colours[groups[n][a]], theme->colours[groups[n][b]]), >, 15);
        for (int a = 0; a < 8; a++)
            for (int b = 0; b < a; b++)
                g_assert_cmpfloat(seen_distance(theme->curves[a], theme->curves[b]), >, 15);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/theme/complete", test_complete);
    g_test_add_func("/render/theme/meanings", test_meanings);
    g_test_add_func("/render/theme/contrast", test_contrast);
    g_test_add_func("/render/theme/colour-blindness", test_colour_blindness);
    return g_test_run();
}
