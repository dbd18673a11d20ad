/* What tells arrows of forces: their scale, the colours of their kinds, and the key. */
#include <math.h>
#include <string.h>

#include "arrow-stage.h"

static double scale_for(double force, double previous)
{
    const TinkerForceArrow arrows[] = {{0, 0, 0.1 * force, 0, NULL, 0}, {3, 1, -0.6 * force, 0.8 * force, NULL, 0}};
    return tinker_arrows_scale(arrows, 2, &arrow_view, previous);
}

/* Round, a tenth of the view, and slow to change. */
static void test_scale(void)
{
    for (double force = 1e-6; force < 1e9; force *= 1.37) {
        double scale = scale_for(force, 0), share = scale * force * arrow_view.scale / ARROW_WIDTH;
        g_assert_cmpfloat(share, >, 0.1 / sqrt(2.5) * 0.999);
        g_assert_cmpfloat(share, <, 0.1 * sqrt(2.5) * 1.001);
        double mantissa = scale / pow(10, floor(log10(scale) + 1e-9));
        g_assert_true(fabs(mantissa - 1) < 1e-9 || fabs(mantissa - 2) < 1e-9 || fabs(mantissa - 5) < 1e-9);
    }
    double wanted = 1.2; /* m: a tenth of 600 / 50 m */
    g_assert_cmpfloat(scale_for(wanted / 0.01, 0.029), ==, 0.029);
    g_assert_cmpfloat(scale_for(wanted / 0.01, 0.0034), ==, 0.0034);
    g_assert_cmpfloat(fabs(scale_for(wanted / 0.01, 0.031) - 0.01), <, 1e-12);
    g_assert_cmpfloat(fabs(scale_for(wanted / 0.01, 0.0033) - 0.01), <, 1e-12);
    g_assert_cmpfloat(scale_for(0, 0.7), ==, 0.7);
    g_assert_cmpfloat(scale_for(NAN, 0.7), ==, 0.7);
    static const double odd[] = {0, NAN, INFINITY, 5e-324, 1e308};
    for (gsize i = 0; i < G_N_ELEMENTS(odd); i++) {
        g_assert_true(scale_for(odd[i], 0) > 0 && isfinite(scale_for(odd[i], 0)));
        g_assert_true(scale_for(odd[i], NAN) > 0 && isfinite(scale_for(odd[i], NAN)));
    }
    g_assert_true(tinker_arrows_scale(NULL, 0, &arrow_view, 0) > 0);
}

/* Seen apart: no two kinds of single forces have colours that are near to each other, in any theme. */
static void test_kinds(void)
{
    for (const char *const *id = tinker_theme_ids(); *id != NULL; id++)
        for (int a = 0; a < TINKER_ARROW_MOTION; a++)
            for (int b = 0; b < a; b++) {
                const double *one = tinker_arrow_colour(tinker_theme_find(*id), (TinkerArrowKind)a);
                const double *other = tinker_arrow_colour(tinker_theme_find(*id), (TinkerArrowKind)b);
                double distance = hypot(hypot(one[0] - other[0], one[1] - other[1]), one[2] - other[2]);
                g_test_message("%s: %d and %d: %g", *id, a, b, distance);
                g_assert_cmpfloat(distance, >, 0.15);
            }
}

/* The line is as long as the arrow of the force that it is said to be, which is a round one. */
static void test_key(void)
{
    static const TinkerArrowWord words[] = {{TINKER_ARROW_FIELD, "field"}, {TINKER_ARROW_FRICTION, "friction"}};
    for (double scale = 1.3e-6; scale < 1e6; scale *= 7.7) {
        const double unit = 4.4482216152605, force = tinker_arrows_key_value(&arrow_view, scale, unit); /* N: a pound */
        double length = force * scale * arrow_view.scale, number = force / unit,
               mantissa = number / pow(10, floor(log10(number) + 1e-9));
        g_assert_cmpfloat(length, >, 24 * 0.999);
        g_assert_cmpfloat(length, <, 60 * 1.001);
        g_assert_true(fabs(mantissa - 1) < 1e-9 || fabs(mantissa - 2) < 1e-9 || fabs(mantissa - 5) < 1e-9);
        ArrowStage stage;
        arrow_stage_open(&stage, "light", scale);
        const TinkerArrowLength lengths[] = {{.length = length, .label = "5 lbf"}};
        TinkerArrowKey key = {.lengths = lengths, .length_count = 1, .words = words, .word_count = G_N_ELEMENTS(words)};
        tinker_arrows_draw_key(stage.picture->cairo, &arrow_view, stage.options.theme, &key, stage.written);
        double all[4];
        g_assert_true(tinker_arrows_key_box(&arrow_view, stage.options.theme, &key, all));
        for (guint i = 0; i < stage.written->len; i++) {
            const double *box = arrow_stage_written(&stage, i)->box;
            g_assert_true(box[0] > all[0] && box[1] > all[1] && box[2] < all[2] && box[3] < all[3]);
        }
        g_assert_cmpuint(stage.written->len, ==, 3);
        g_assert_cmpstr(arrow_stage_written(&stage, 0)->text, ==, "5 lbf");
        arrow_stage_assert_inside_and_apart(&stage);
        const double *box = arrow_stage_written(&stage, 0)->box,
                     *ink = stage.options.theme->colours[TINKER_COLOUR_TEXT];
        double y = (box[1] + box[3]) / 2, end = box[0] - 6;
        g_assert_true(test_picture_shows(stage.picture, end - length + 1, y, 1, ink));
        g_assert_true(test_picture_shows(stage.picture, end - length / 2, y, 1, ink));
        g_assert_true(test_picture_shows(stage.picture, end - 1, y, 1, ink));
        g_assert_false(test_picture_shows(stage.picture, end - length - 4, y, 1, ink));
        g_assert_cmpint(test_picture_count(stage.picture, tinker_arrow_colour(stage.options.theme, TINKER_ARROW_FIELD)),
                        >, 20);
        arrow_stage_close(&stage);
    }
    g_assert_cmpfloat(tinker_arrows_key_value(&arrow_view, 0, 1), ==, 0);
    g_assert_cmpfloat(tinker_arrows_key_value(&arrow_view, NAN, 1), ==, 0);
}

/* In a picture that is not three times as high as the key, the words are left out and the scale stays. */
static void test_key_of_small_picture(void)
{
    static const TinkerArrowWord words[] = {{TINKER_ARROW_FIELD, "field"}, {TINKER_ARROW_FRICTION, "friction"}};
    TinkerView small = arrow_view;
    small.height = 150;
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 1);
    const TinkerArrowLength lengths[] = {
        {.length = small.scale * tinker_arrows_key_value(&small, 1, 1), .label = "5 N"}};
    TinkerArrowKey key = {.lengths = lengths, .length_count = 1, .words = words, .word_count = 2};
    tinker_arrows_draw_key(stage.picture->cairo, &small, stage.options.theme, &key, stage.written);
    g_assert_cmpuint(stage.written->len, ==, 1);
    g_assert_cmpstr(arrow_stage_written(&stage, 0)->text, ==, "5 N");
    arrow_stage_close(&stage);
}

/* A line of its own colour for each scale, and a row for the marks of paths; of nothing at all there is no key. */
static void test_key_of_several_scales(void)
{
    const TinkerTheme *theme = tinker_theme_find("light");
    const double *velocity = tinker_arrow_colour(theme, TINKER_ARROW_MOTION);
    const double *acceleration = tinker_arrow_colour(theme, TINKER_ARROW_ACCELERATION);
    const TinkerArrowLength lengths[] = {{50, "5 N", NULL}, {30, "2 m/s", velocity}, {40, "10 m/s²", acceleration}};
    TinkerArrowKey key = {.lengths = lengths, .length_count = G_N_ELEMENTS(lengths), .marks = "0.2 s"};
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 1);
    tinker_arrows_draw_key(stage.picture->cairo, &arrow_view, stage.options.theme, &key, stage.written);
    g_assert_cmpuint(stage.written->len, ==, 4);
    arrow_stage_assert_inside_and_apart(&stage);
    for (guint i = 0; i < 3; i++) {
        const double *box = arrow_stage_written(&stage, i)->box, y = (box[1] + box[3]) / 2;
        const double *colour = lengths[i].colour != NULL ? lengths[i].colour : theme->colours[TINKER_COLOUR_TEXT];
        g_assert_cmpstr(arrow_stage_written(&stage, i)->text, ==, lengths[i].label);
        g_assert_true(test_picture_shows(stage.picture, box[0] - 6 - lengths[i].length / 2, y, 1, colour));
    }
    g_assert_cmpstr(arrow_stage_written(&stage, 3)->text, ==, "0.2 s");
    arrow_stage_close(&stage);
    key = (TinkerArrowKey){.lengths = NULL};
    arrow_stage_open(&stage, "light", 1);
    tinker_arrows_draw_key(stage.picture->cairo, &arrow_view, stage.options.theme, &key, stage.written);
    g_assert_cmpuint(stage.written->len, ==, 0);
    arrow_stage_close(&stage);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/arrows-key/small-picture", test_key_of_small_picture);
    g_test_add_func("/render/arrows-key/scale", test_scale);
    g_test_add_func("/render/arrows-key/kinds", test_kinds);
    g_test_add_func("/render/arrows-key/key", test_key);
    g_test_add_func("/render/arrows-key/several-scales", test_key_of_several_scales);
    return g_test_run();
}
