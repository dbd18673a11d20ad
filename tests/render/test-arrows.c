/* Arrows of forces: where they lie, how long they are, where their labels stand. */
#include <math.h>
#include <string.h>

#include "picture.h"
#include "render/draw/text.h"
#include "render/picture/arrows-private.h"

#define WIDTH  600
#define HEIGHT 400

static const TinkerView view = {
    .scale = 50, .origin_x = WIDTH / 2, .origin_y = HEIGHT / 2, .width = WIDTH, .height = HEIGHT};

typedef struct {
    TestPicture *picture;
    GPtrArray *written; /* of TinkerWrittenText */
    TinkerArrowOptions options;
} Stage;

static void stage_open(Stage *stage, const char *theme, double scale)
{
    stage->picture = test_picture_new(WIDTH, HEIGHT);
    stage->written = tinker_written_texts_new();
    stage->options = (TinkerArrowOptions){.theme = tinker_theme_find(theme), .scale = scale};
    const double *ground = stage->options.theme->background;
    cairo_set_source_rgb(stage->picture->cairo, ground[0], ground[1], ground[2]);
    cairo_paint(stage->picture->cairo);
}

static void stage_draw(Stage *stage, const TinkerForceArrow *arrows, gsize count)
{
    cairo_matrix_t before, after;
    cairo_get_matrix(stage->picture->cairo, &before);
    tinker_arrows_draw_noting(stage->picture->cairo, &view, arrows, count, &stage->options, stage->written);
    cairo_get_matrix(stage->picture->cairo, &after);
    g_assert_cmpmem(&before, sizeof before, &after, sizeof after);
}

static void stage_close(Stage *stage)
{
    g_ptr_array_unref(stage->written);
    test_picture_free(stage->picture);
}

static const TinkerWrittenText *written(const Stage *stage, guint i)
{
    return g_ptr_array_index(stage->written, i);
}

static double distance_to(const double box[4], double x, double y)
{
    return hypot(fmax(fmax(box[0] - x, x - box[2]), 0), fmax(fmax(box[1] - y, y - box[3]), 0));
}

static void assert_inside_and_apart(const Stage *stage)
{
    for (guint i = 0; i < stage->written->len; i++) {
        const double *a = written(stage, i)->box;
        g_assert_true(a[0] >= 0 && a[1] >= 0 && a[2] <= WIDTH && a[3] <= HEIGHT);
        for (guint n = 0; n < i; n++) {
            const double *b = written(stage, n)->box;
            g_assert_true(a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1]);
        }
    }
}

/* From where it acts, force times scale long, in the colour of its kind in every theme; the label by its head. */
static void test_place(gconstpointer theme)
{
    for (int i = 0; i < 24; i++) {
        double angle = i * G_PI / 12 + 0.02, ux = cos(angle), uy = sin(angle);
        Stage stage;
        stage_open(&stage, theme, 0.02);
        TinkerArrowKind kind = i % TINKER_ARROW_KINDS;
        TinkerForceArrow arrow = {0.5, -0.25, 100 * ux, 100 * uy, "Spring 0  100 N", kind};
        stage_draw(&stage, &arrow, 1);
        const double *wanted = tinker_arrow_colour(stage.options.theme, kind), x = WIDTH / 2 + 25,
                     y = HEIGHT / 2 + 12.5;
        for (double s = 2; s < 98; s += 3)
            g_assert_true(test_picture_shows(stage.picture, x + s * ux, y - s * uy, 1, wanted));
        /* nothing before it and nothing but text behind its head */
        g_assert_false(test_picture_shows(stage.picture, x - 5 * ux, y + 5 * uy, 1, wanted));
        g_assert_false(test_picture_shows(stage.picture, x + 103 * ux, y - 103 * uy, 1, wanted));
        g_assert_cmpuint(stage.written->len, ==, 1);
        g_assert_cmpstr(written(&stage, 0)->text, ==, arrow.label);
        g_assert_cmpfloat(distance_to(written(&stage, 0)->box, x + 100 * ux, y - 100 * uy), >, 1);
        g_assert_cmpfloat(distance_to(written(&stage, 0)->box, x + 100 * ux, y - 100 * uy), <, 12);
        stage_close(&stage);
    }
}

/* The greatest are labelled first, and their labels are apart; near the edges too. */
static void test_crowd(void)
{
    enum { COUNT = 80 };
    TinkerForceArrow arrows[COUNT];
    char labels[COUNT][32];
    for (int i = 0; i < COUNT; i++) {
        g_snprintf(labels[i], sizeof(labels[i]), "Spring %d  %.1f N", i, 1.5 * i);
        arrows[i] = (TinkerForceArrow){g_test_rand_double_range(-6, 6),
                                       g_test_rand_double_range(-4, 4),
                                       g_test_rand_double_range(-50, 50),
                                       g_test_rand_double_range(-50, 50),
                                       labels[i],
                                       i % TINKER_ARROW_KINDS};
    }
    arrows[7] = (TinkerForceArrow){0, 0, 90, 0, labels[7], 0};
    Stage stage;
    stage_open(&stage, "light", 0.02);
    stage_draw(&stage, arrows, COUNT);
    g_assert_cmpuint(stage.written->len, >, COUNT / 3);
    g_assert_cmpstr(written(&stage, 0)->text, ==, labels[7]);
    assert_inside_and_apart(&stage);
    stage_close(&stage);
}

/* A few forces on one body are all labelled. */
static void test_one_body(void)
{
    Stage stage;
    stage_open(&stage, "dark", 0.05);
    const TinkerForceArrow arrows[] = {{0, 0, 0, -19.6, "Gravity 0  19.6 N", 0}, {0, 0, 9, 3, "Spring 0  9.5 N", 1},
                                       {0, 0, 8.8, 3, "Spring 1  9.3 N", 2},     {0, 0, 8.6, 3, "Spring 2  9.1 N", 3},
                                       {0, 0, -4, 17, "Normal  17.5 N", 4},      {0, 0, -8, -2, "Friction  8.2 N", 5}};
    stage_draw(&stage, arrows, G_N_ELEMENTS(arrows));
    g_assert_cmpuint(stage.written->len, ==, G_N_ELEMENTS(arrows));
    assert_inside_and_apart(&stage);
    /* those that would lie on each other are seen apart */
    for (gsize i = 0; i < G_N_ELEMENTS(arrows); i++)
        g_assert_cmpint(test_picture_count(stage.picture, tinker_arrow_colour(stage.options.theme, arrows[i].kind)), >,
                        40);
    stage_close(&stage);
}

/* An arrow that leaves the picture is labelled inside it; one that is out of it is not. Labels keep clear of what is
 * taken. */
static void test_edges(void)
{
    const TinkerForceArrow out[] = {{5, 3, 1e4, 3e3, "A", 0}, {-5, 0, -1e150, 0, "B", 1}, {0, -3.9, 0, -3, "C", 2}};
    const TinkerForceArrow away[] = {{20, 0, 1, 0, "D", 0}, {1e300, 0, 1, 0, "E", 0}, {0, -5, 0, -30, "F", 0}};
    Stage stage;
    stage_open(&stage, "light", 0.02);
    stage_draw(&stage, out, G_N_ELEMENTS(out));
    g_assert_cmpuint(stage.written->len, ==, 3);
    assert_inside_and_apart(&stage);
    g_assert_true(test_picture_shows(stage.picture, 10, HEIGHT / 2, 1, tinker_arrow_colour(stage.options.theme, 1)));
    stage_draw(&stage, away, G_N_ELEMENTS(away));
    g_assert_cmpuint(stage.written->len, ==, 3);
    stage_close(&stage);
    static const double taken[][4] = {{310, 0, WIDTH, HEIGHT}};
    const TinkerForceArrow right = {-0.5, 0, 30, 0, "Right", 0};
    stage_open(&stage, "light", 0.02);
    stage.options.taken = taken;
    stage.options.taken_count = 1;
    stage_draw(&stage, &right, 1);
    g_assert_cmpuint(stage.written->len, ==, 1);
    g_assert_cmpfloat(written(&stage, 0)->box[2], <=, 312);
    stage_close(&stage);
}

/* What is no force leaves no trace. */
static void test_odd_forces(void)
{
    const TinkerForceArrow odd[] = {{0, 0, 0, 0, "zero", 0},           {0, 0, NAN, 1, "no number", 0},
                                    {0, 0, 1, INFINITY, "endless", 0}, {NAN, 0, 1, 0, "where", 0},
                                    {0, 0, 1e-9, 0, "tiny", 0},        {INFINITY, 0, 5, 0, "far", 0},
                                    {0, 0, 1e308, 1e308, "", 0}};
    Stage stage;
    stage_open(&stage, "light", 0.02);
    stage_draw(&stage, odd, G_N_ELEMENTS(odd) - 1);
    stage_draw(&stage, NULL, 0);
    const double *ground = stage.options.theme->background;
    g_assert_cmpint(test_picture_count(stage.picture, ground), ==, WIDTH * HEIGHT);
    stage_draw(&stage, odd, G_N_ELEMENTS(odd));
    g_assert_cmpuint(stage.written->len, ==, 0);
    stage.options.scale = NAN;
    stage_draw(&stage, &(TinkerForceArrow){0, 0, 1, 0, "a", 0}, 1);
    stage.options.scale = 1;
    stage_draw(&stage, &(TinkerForceArrow){0, 0, 1, 0, "long", 0}, 1);
    stage_draw(&stage, &(TinkerForceArrow){0, 1, 1, 0, "\xff not text", 0}, 1);
    stage_close(&stage);
}

static double scale_for(double force, double previous)
{
    const TinkerForceArrow arrows[] = {{0, 0, 0.1 * force, 0, NULL, 0}, {3, 1, -0.6 * force, 0.8 * force, NULL, 0}};
    return tinker_arrows_scale(arrows, 2, &view, previous);
}

/* Round, a tenth of the view, and slow to change. */
static void test_scale(void)
{
    for (double force = 1e-6; force < 1e9; force *= 1.37) {
        double scale = scale_for(force, 0), share = scale * force * view.scale / WIDTH;
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
    g_assert_true(tinker_arrows_scale(NULL, 0, &view, 0) > 0);
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
        const double unit = 4.4482216152605, force = tinker_arrows_key_value(&view, scale, unit); /* N: a pound */
        double length = force * scale * view.scale, number = force / unit,
               mantissa = number / pow(10, floor(log10(number) + 1e-9));
        g_assert_cmpfloat(length, >, 24 * 0.999);
        g_assert_cmpfloat(length, <, 60 * 1.001);
        g_assert_true(fabs(mantissa - 1) < 1e-9 || fabs(mantissa - 2) < 1e-9 || fabs(mantissa - 5) < 1e-9);
        Stage stage;
        stage_open(&stage, "light", scale);
        const TinkerArrowLength lengths[] = {{.length = length, .label = "5 lbf"}};
        TinkerArrowKey key = {.lengths = lengths, .length_count = 1, .words = words, .word_count = G_N_ELEMENTS(words)};
        tinker_arrows_draw_key(stage.picture->cairo, &view, stage.options.theme, &key, stage.written);
        double all[4];
        g_assert_true(tinker_arrows_key_box(&view, stage.options.theme, &key, all));
        for (guint i = 0; i < stage.written->len; i++) {
            const double *box = written(&stage, i)->box;
            g_assert_true(box[0] > all[0] && box[1] > all[1] && box[2] < all[2] && box[3] < all[3]);
        }
        g_assert_cmpuint(stage.written->len, ==, 3);
        g_assert_cmpstr(written(&stage, 0)->text, ==, "5 lbf");
        assert_inside_and_apart(&stage);
        const double *box = written(&stage, 0)->box, *ink = stage.options.theme->colours[TINKER_COLOUR_TEXT];
        double y = (box[1] + box[3]) / 2, end = box[0] - 6;
        g_assert_true(test_picture_shows(stage.picture, end - length + 1, y, 1, ink));
        g_assert_true(test_picture_shows(stage.picture, end - length / 2, y, 1, ink));
        g_assert_true(test_picture_shows(stage.picture, end - 1, y, 1, ink));
        g_assert_false(test_picture_shows(stage.picture, end - length - 4, y, 1, ink));
        g_assert_cmpint(test_picture_count(stage.picture, tinker_arrow_colour(stage.options.theme, TINKER_ARROW_FIELD)),
                        >, 20);
        stage_close(&stage);
    }
    g_assert_cmpfloat(tinker_arrows_key_value(&view, 0, 1), ==, 0);
    g_assert_cmpfloat(tinker_arrows_key_value(&view, NAN, 1), ==, 0);
}

/* In a picture that is not three times as high as the key, the words are left out and the scale stays. */
static void test_key_of_small_picture(void)
{
    static const TinkerArrowWord words[] = {{TINKER_ARROW_FIELD, "field"}, {TINKER_ARROW_FRICTION, "friction"}};
    TinkerView small = view;
    small.height = 150;
    Stage stage;
    stage_open(&stage, "light", 1);
    const TinkerArrowLength lengths[] = {
        {.length = small.scale * tinker_arrows_key_value(&small, 1, 1), .label = "5 N"}};
    TinkerArrowKey key = {.lengths = lengths, .length_count = 1, .words = words, .word_count = 2};
    tinker_arrows_draw_key(stage.picture->cairo, &small, stage.options.theme, &key, stage.written);
    g_assert_cmpuint(stage.written->len, ==, 1);
    g_assert_cmpstr(written(&stage, 0)->text, ==, "5 N");
    stage_close(&stage);
}

/* A line of its own colour for each scale, and a row for the marks of paths; of nothing at all there is no key. */
static void test_key_of_several_scales(void)
{
    const TinkerTheme *theme = tinker_theme_find("light");
    const double *velocity = tinker_arrow_colour(theme, TINKER_ARROW_MOTION);
    const double *acceleration = tinker_arrow_colour(theme, TINKER_ARROW_ACCELERATION);
    const TinkerArrowLength lengths[] = {{50, "5 N", NULL}, {30, "2 m/s", velocity}, {40, "10 m/s²", acceleration}};
    TinkerArrowKey key = {.lengths = lengths, .length_count = G_N_ELEMENTS(lengths), .marks = "0.2 s"};
    Stage stage;
    stage_open(&stage, "light", 1);
    tinker_arrows_draw_key(stage.picture->cairo, &view, stage.options.theme, &key, stage.written);
    g_assert_cmpuint(stage.written->len, ==, 4);
    assert_inside_and_apart(&stage);
    for (guint i = 0; i < 3; i++) {
        const double *box = written(&stage, i)->box, y = (box[1] + box[3]) / 2;
        const double *colour = lengths[i].colour != NULL ? lengths[i].colour : theme->colours[TINKER_COLOUR_TEXT];
        g_assert_cmpstr(written(&stage, i)->text, ==, lengths[i].label);
        g_assert_true(test_picture_shows(stage.picture, box[0] - 6 - lengths[i].length / 2, y, 1, colour));
    }
    g_assert_cmpstr(written(&stage, 3)->text, ==, "0.2 s");
    stage_close(&stage);
    key = (TinkerArrowKey){.lengths = NULL};
    stage_open(&stage, "light", 1);
    tinker_arrows_draw_key(stage.picture->cairo, &view, stage.options.theme, &key, stage.written);
    g_assert_cmpuint(stage.written->len, ==, 0);
    stage_close(&stage);
}

/* A small diagram of a block that slides: each of its labels is there, and none lies on another's text or on an arrow's
 * shaft, which runs from where it acts to its head. */
static void test_little_room(void)
{
    static const TinkerView small = {.scale = 1, .origin_x = 80, .origin_y = 65, .width = 165, .height = 180};
    static const TinkerForceArrow arrows[] = {
        {0, 0, 0, -46, "Gravity  9.81 N", TINKER_ARROW_FIELD, 0},
        {24, -46, -21, 32, "Inclined plane (Normal force)  8.036 N", TINKER_ARROW_NORMAL, 0},
        {4, -14, 14, 10, "Inclined plane (Friction)  4.018 N", TINKER_ARROW_FRICTION, 0}};
    Stage stage;
    stage_open(&stage, "light", 1);
    stage.options.roomy = TRUE;
    tinker_arrows_draw_noting(stage.picture->cairo, &small, arrows, G_N_ELEMENTS(arrows), &stage.options,
                              stage.written);
    g_assert_cmpuint(stage.written->len, ==, G_N_ELEMENTS(arrows));
    assert_inside_and_apart(&stage);
    for (guint i = 0; i < stage.written->len; i++)
        g_assert_cmpfloat(written(&stage, i)->box[2], <=, small.width);
    for (guint i = 0; i < stage.written->len; i++)
        for (gsize k = 0; k < G_N_ELEMENTS(arrows); k++)
            for (double part = 0; part <= 1; part += 0.05) {
                const double x = small.origin_x + arrows[k].x + part * arrows[k].fx,
                             y = small.origin_y - arrows[k].y - part * arrows[k].fy;
                g_assert_cmpfloat(distance_to(written(&stage, i)->box, x, y), >, 0);
            }
    stage_close(&stage);
}

/* Where they were drawn is told: the first at (0, 0), 50 canvas units a metre, the labels where they were written. */
static void test_places(void)
{
    static const TinkerForceArrow arrows[] = {{0, 0, 0, 1, "weaker", TINKER_ARROW_FIELD, 0},
                                              {1, 0, 2, 0, "stronger", TINKER_ARROW_NORMAL, 0},
                                              {-1, 0, 0, 0, "none", TINKER_ARROW_NORMAL, 0}};
    static const double shafts[][4] = {{WIDTH / 2, HEIGHT / 2, WIDTH / 2, HEIGHT / 2 - 50},
                                       {WIDTH / 2 + 50, HEIGHT / 2, WIDTH / 2 + 150, HEIGHT / 2}};
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    Stage stage;
    stage_open(&stage, "light", 1);
    stage.options.places = places;
    stage_draw(&stage, arrows, G_N_ELEMENTS(arrows));
    g_assert_cmpuint(places->len, ==, 2);
    for (guint i = 0; i < places->len; i++) {
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, i);
        const double *box = written(&stage, i)->box;
        g_assert_cmpuint(place->number, ==, 1 - i);
        for (int k = 0; k < 4; k++)
            g_assert_cmpfloat_with_epsilon(place->shaft[k], shafts[place->number][k], 1e-9);
        g_assert_cmpstr(written(&stage, i)->text, ==, arrows[place->number].label);
        g_assert_true(place->label[0] <= box[0] && place->label[1] <= box[1] && place->label[2] >= box[2] - 1 &&
                      place->label[3] >= box[3] - 1);
    }
    stage_close(&stage);
}

/* Whether a point half the way from a head to the box of its label has ink, other than the ground. */
static gboolean is_tied(const Stage *stage, const TinkerArrowPlace *place)
{
    const double *ground = stage->options.theme->background, *at = place->shaft + 2, *box = place->label;
    const double x = CLAMP(at[0], box[0], box[2]), y = CLAMP(at[1], box[1], box[3]);
    double found[4];
    double most = 0;
    for (int dx = -1; dx <= 1; dx++)
        for (int dy = -1; dy <= 1; dy++) {
            test_picture_pixel(stage->picture, (int)((at[0] + x) / 2) + dx, (int)((at[1] + y) / 2) + dy, found);
            for (int k = 0; k < 3; k++)
                most = fmax(most, fabs(found[k] - ground[k]));
        }
    return most > 0.1;
}

/* A label that has no room near its head is tied to it by a line, and one that stands there is not. */
static void test_tied_labels(void)
{
    static const TinkerForceArrow arrow = {0, 0, 1, 0, "spring", TINKER_ARROW_CONNECTOR, 0};
    static const double around[][4] = {{WIDTH / 2 - 60, HEIGHT / 2 - 60, WIDTH / 2 + 140, HEIGHT / 2 + 60}};
    for (int far = 0; far < 2; far++) {
        g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
        Stage stage;
        stage_open(&stage, "light", 1);
        stage.options.places = places;
        stage.options.roomy = TRUE;
        stage.options.drawn = around;
        stage.options.drawn_count = far;
        stage_draw(&stage, &arrow, 1);
        g_assert_cmpuint(places->len, ==, 1);
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, 0);
        g_assert_cmpfloat(place->shaft[2], ==, WIDTH / 2 + 50);
        g_assert_true((distance_to(place->label, place->shaft[2], place->shaft[3]) > 40) == far);
        g_assert_true(is_tied(&stage, place) == far);
        stage_close(&stage);
    }
}

/* What pushes ends where it acts, however long it is; its label stands at its start, and another one's does not. */
static void test_pushing(void)
{
    static const TinkerForceArrow arrow = {1, 0.5, 4, 3, "normal force", TINKER_ARROW_NORMAL, TINKER_ARROW_PUSHES};
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    Stage stage;
    stage_open(&stage, "light", 0.5);
    stage.options.places = places;
    stage_draw(&stage, &arrow, 1);
    g_assert_cmpuint(places->len, ==, 1);
    const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, 0);
    const double truth[] = {WIDTH / 2 - 50, HEIGHT / 2 + 50, WIDTH / 2 + 50, HEIGHT / 2 - 25};
    for (int k = 0; k < 4; k++)
        g_assert_cmpfloat_with_epsilon(place->shaft[k], truth[k], 1e-9);
    g_assert_cmpfloat(distance_to(place->label, truth[0], truth[1]), <, 12);
    stage_close(&stage);
}

/* Where a drawing is all over the picture labels go over it, each with its own place, before one is left out; they stay
 * within reach of their heads. */
static void test_none_is_left_out(void)
{
    enum { COUNT = 20 };
    static const double all[][4] = {{0, 0, WIDTH, HEIGHT}};
    TinkerForceArrow arrows[COUNT];
    for (int i = 0; i < COUNT; i++)
        arrows[i] = (TinkerForceArrow){0,
                                       0,
                                       0.2 * cos(i * 2 * G_PI / COUNT),
                                       0.2 * sin(i * 2 * G_PI / COUNT),
                                       "A support with a name (Normal force)",
                                       i % TINKER_ARROW_KINDS};
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    Stage stage;
    stage_open(&stage, "light", 1);
    stage.options.roomy = TRUE;
    stage.options.reach = 180;
    stage.options.drawn = all;
    stage.options.drawn_count = 1;
    stage.options.places = places;
    stage_draw(&stage, arrows, COUNT);
    g_assert_cmpuint(stage.written->len, ==, COUNT);
    assert_inside_and_apart(&stage);
    for (guint i = 0; i < places->len; i++) {
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, i);
        g_assert_cmpfloat(distance_to(place->label, place->shaft[2], place->shaft[3]), <=, 180);
    }
    stage_close(&stage);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/arrows/little-room", test_little_room);
    g_test_add_func("/render/arrows/key-of-small-picture", test_key_of_small_picture);
    g_test_add_data_func("/render/arrows/place/light", "light", test_place);
    g_test_add_data_func("/render/arrows/place/dark", "dark", test_place);
    g_test_add_func("/render/arrows/places", test_places);
    g_test_add_func("/render/arrows/pushing", test_pushing);
    g_test_add_func("/render/arrows/none-is-left-out", test_none_is_left_out);
    g_test_add_func("/render/arrows/tied-labels", test_tied_labels);
    g_test_add_func("/render/arrows/crowd", test_crowd);
    g_test_add_func("/render/arrows/one-body", test_one_body);
    g_test_add_func("/render/arrows/edges", test_edges);
    g_test_add_func("/render/arrows/odd-forces", test_odd_forces);
    g_test_add_func("/render/arrows/scale", test_scale);
    g_test_add_func("/render/arrows/kinds", test_kinds);
    g_test_add_func("/render/arrows/key", test_key);
    g_test_add_func("/render/arrows/key-of-several-scales", test_key_of_several_scales);
    return g_test_run();
}
