/* Arrows of forces: where they lie, how long they are, where their labels stand. */
#include <math.h>
#include <string.h>

#include "arrow-stage.h"

/* From where it acts, force times scale long, in the colour of its kind in every theme; the label by its head. */
static void test_place(gconstpointer theme)
{
    for (int i = 0; i < 24; i++) {
        double angle = i * G_PI / 12 + 0.02, ux = cos(angle), uy = sin(angle);
        ArrowStage stage;
        arrow_stage_open(&stage, theme, 0.02);
        TinkerArrowKind kind = i % TINKER_ARROW_KINDS;
        TinkerForceArrow arrow = {0.5, -0.25, 100 * ux, 100 * uy, "Spring 0  100 N", kind};
        arrow_stage_draw(&stage, &arrow, 1);
        const double *wanted = tinker_arrow_colour(stage.options.theme, kind), x = ARROW_WIDTH / 2 + 25,
                     y = ARROW_HEIGHT / 2 + 12.5;
        for (double s = 2; s < 98; s += 3)
            g_assert_true(test_picture_shows(stage.picture, x + s * ux, y - s * uy, 1, wanted));
        /* nothing before it and nothing but text behind its head */
        g_assert_false(test_picture_shows(stage.picture, x - 5 * ux, y + 5 * uy, 1, wanted));
        g_assert_false(test_picture_shows(stage.picture, x + 103 * ux, y - 103 * uy, 1, wanted));
        g_assert_cmpuint(stage.written->len, ==, 1);
        g_assert_cmpstr(arrow_stage_written(&stage, 0)->text, ==, arrow.label);
        g_assert_cmpfloat(arrow_distance_to(arrow_stage_written(&stage, 0)->box, x + 100 * ux, y - 100 * uy), >, 1);
        g_assert_cmpfloat(arrow_distance_to(arrow_stage_written(&stage, 0)->box, x + 100 * ux, y - 100 * uy), <, 12);
        arrow_stage_close(&stage);
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
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 0.02);
    arrow_stage_draw(&stage, arrows, COUNT);
    g_assert_cmpuint(stage.written->len, >, COUNT / 3);
    g_assert_cmpstr(arrow_stage_written(&stage, 0)->text, ==, labels[7]);
    arrow_stage_assert_inside_and_apart(&stage);
    arrow_stage_close(&stage);
}

/* A few forces on one body are all labelled. */
static void test_one_body(void)
{
    ArrowStage stage;
    arrow_stage_open(&stage, "dark", 0.05);
    const TinkerForceArrow arrows[] = {{0, 0, 0, -19.6, "Gravity 0  19.6 N", 0}, {0, 0, 9, 3, "Spring 0  9.5 N", 1},
                                       {0, 0, 8.8, 3, "Spring 1  9.3 N", 2},     {0, 0, 8.6, 3, "Spring 2  9.1 N", 3},
                                       {0, 0, -4, 17, "Normal  17.5 N", 4},      {0, 0, -8, -2, "Friction  8.2 N", 5}};
    arrow_stage_draw(&stage, arrows, G_N_ELEMENTS(arrows));
    g_assert_cmpuint(stage.written->len, ==, G_N_ELEMENTS(arrows));
    arrow_stage_assert_inside_and_apart(&stage);
    /* those that would lie on each other are seen apart */
    for (gsize i = 0; i < G_N_ELEMENTS(arrows); i++)
        g_assert_cmpint(test_picture_count(stage.picture, tinker_arrow_colour(stage.options.theme, arrows[i].kind)), >,
                        40);
    arrow_stage_close(&stage);
}

/* An arrow that leaves the picture is labelled inside it; one that is out of it is not. Labels keep clear of what is
 * taken. */
static void test_edges(void)
{
    const TinkerForceArrow out[] = {{5, 3, 1e4, 3e3, "A", 0}, {-5, 0, -1e150, 0, "B", 1}, {0, -3.9, 0, -3, "C", 2}};
    const TinkerForceArrow away[] = {{20, 0, 1, 0, "D", 0}, {1e300, 0, 1, 0, "E", 0}, {0, -5, 0, -30, "F", 0}};
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 0.02);
    arrow_stage_draw(&stage, out, G_N_ELEMENTS(out));
    g_assert_cmpuint(stage.written->len, ==, 3);
    arrow_stage_assert_inside_and_apart(&stage);
    g_assert_true(
        test_picture_shows(stage.picture, 10, ARROW_HEIGHT / 2, 1, tinker_arrow_colour(stage.options.theme, 1)));
    arrow_stage_draw(&stage, away, G_N_ELEMENTS(away));
    g_assert_cmpuint(stage.written->len, ==, 3);
    arrow_stage_close(&stage);
    static const double taken[][4] = {{310, 0, ARROW_WIDTH, ARROW_HEIGHT}};
    const TinkerForceArrow right = {-0.5, 0, 30, 0, "Right", 0};
    arrow_stage_open(&stage, "light", 0.02);
    stage.options.taken = taken;
    stage.options.taken_count = 1;
    arrow_stage_draw(&stage, &right, 1);
    g_assert_cmpuint(stage.written->len, ==, 1);
    g_assert_cmpfloat(arrow_stage_written(&stage, 0)->box[2], <=, 312);
    arrow_stage_close(&stage);
}

/* What is no force leaves no trace. */
static void test_odd_forces(void)
{
    const TinkerForceArrow odd[] = {{0, 0, 0, 0, "zero", 0},           {0, 0, NAN, 1, "no number", 0},
                                    {0, 0, 1, INFINITY, "endless", 0}, {NAN, 0, 1, 0, "where", 0},
                                    {0, 0, 1e-9, 0, "tiny", 0},        {INFINITY, 0, 5, 0, "far", 0},
                                    {0, 0, 1e308, 1e308, "", 0}};
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 0.02);
    arrow_stage_draw(&stage, odd, G_N_ELEMENTS(odd) - 1);
    arrow_stage_draw(&stage, NULL, 0);
    const double *ground = stage.options.theme->background;
    g_assert_cmpint(test_picture_count(stage.picture, ground), ==, ARROW_WIDTH * ARROW_HEIGHT);
    arrow_stage_draw(&stage, odd, G_N_ELEMENTS(odd));
    g_assert_cmpuint(stage.written->len, ==, 0);
    stage.options.scale = NAN;
    arrow_stage_draw(&stage, &(TinkerForceArrow){0, 0, 1, 0, "a", 0}, 1);
    stage.options.scale = 1;
    arrow_stage_draw(&stage, &(TinkerForceArrow){0, 0, 1, 0, "long", 0}, 1);
    arrow_stage_draw(&stage, &(TinkerForceArrow){0, 1, 1, 0, "\xff not text", 0}, 1);
    arrow_stage_close(&stage);
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
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 1);
    stage.options.roomy = TRUE;
    tinker_arrows_draw_noting(stage.picture->cairo, &small, arrows, G_N_ELEMENTS(arrows), &stage.options,
                              stage.written);
    g_assert_cmpuint(stage.written->len, ==, G_N_ELEMENTS(arrows));
    arrow_stage_assert_inside_and_apart(&stage);
    for (guint i = 0; i < stage.written->len; i++)
        g_assert_cmpfloat(arrow_stage_written(&stage, i)->box[2], <=, small.width);
    for (guint i = 0; i < stage.written->len; i++)
        for (gsize k = 0; k < G_N_ELEMENTS(arrows); k++)
            for (double part = 0; part <= 1; part += 0.05) {
                const double x = small.origin_x + arrows[k].x + part * arrows[k].fx,
                             y = small.origin_y - arrows[k].y - part * arrows[k].fy;
                g_assert_cmpfloat(arrow_distance_to(arrow_stage_written(&stage, i)->box, x, y), >, 0);
            }
    arrow_stage_close(&stage);
}

/* Where they were drawn is told: the first at (0, 0), 50 canvas units a metre, the labels where they were written. */
static void test_places(void)
{
    static const TinkerForceArrow arrows[] = {{0, 0, 0, 1, "weaker", TINKER_ARROW_FIELD, 0},
                                              {1, 0, 2, 0, "stronger", TINKER_ARROW_NORMAL, 0},
                                              {-1, 0, 0, 0, "none", TINKER_ARROW_NORMAL, 0}};
    static const double shafts[][4] = {
        {ARROW_WIDTH / 2, ARROW_HEIGHT / 2, ARROW_WIDTH / 2, ARROW_HEIGHT / 2 - 50},
        {ARROW_WIDTH / 2 + 50, ARROW_HEIGHT / 2, ARROW_WIDTH / 2 + 150, ARROW_HEIGHT / 2}};
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 1);
    stage.options.places = places;
    arrow_stage_draw(&stage, arrows, G_N_ELEMENTS(arrows));
    g_assert_cmpuint(places->len, ==, 2);
    for (guint i = 0; i < places->len; i++) {
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, i);
        const double *box = arrow_stage_written(&stage, i)->box;
        g_assert_cmpuint(place->number, ==, 1 - i);
        for (int k = 0; k < 4; k++)
            g_assert_cmpfloat_with_epsilon(place->shaft[k], shafts[place->number][k], 1e-9);
        g_assert_cmpstr(arrow_stage_written(&stage, i)->text, ==, arrows[place->number].label);
        g_assert_true(place->label[0] <= box[0] && place->label[1] <= box[1] && place->label[2] >= box[2] - 1 &&
                      place->label[3] >= box[3] - 1);
    }
    arrow_stage_close(&stage);
}

/* Whether a point half the way from a head to the box of its label has ink, other than the ground. */
static gboolean is_tied(const ArrowStage *stage, const TinkerArrowPlace *place)
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
    static const double around[][4] = {
        {ARROW_WIDTH / 2 - 60, ARROW_HEIGHT / 2 - 60, ARROW_WIDTH / 2 + 140, ARROW_HEIGHT / 2 + 60}};
    for (int far = 0; far < 2; far++) {
        g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
        ArrowStage stage;
        arrow_stage_open(&stage, "light", 1);
        stage.options.places = places;
        stage.options.roomy = TRUE;
        stage.options.drawn = around;
        stage.options.drawn_count = far;
        arrow_stage_draw(&stage, &arrow, 1);
        g_assert_cmpuint(places->len, ==, 1);
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, 0);
        g_assert_cmpfloat(place->shaft[2], ==, ARROW_WIDTH / 2 + 50);
        g_assert_true((arrow_distance_to(place->label, place->shaft[2], place->shaft[3]) > 40) == far);
        g_assert_true(is_tied(&stage, place) == far);
        arrow_stage_close(&stage);
    }
}

/* What pushes ends where it acts, however long it is; its label stands at its start, and another one's does not. */
static void test_pushing(void)
{
    static const TinkerForceArrow arrow = {1, 0.5, 4, 3, "normal force", TINKER_ARROW_NORMAL, TINKER_ARROW_PUSHES};
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 0.5);
    stage.options.places = places;
    arrow_stage_draw(&stage, &arrow, 1);
    g_assert_cmpuint(places->len, ==, 1);
    const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, 0);
    const double truth[] = {ARROW_WIDTH / 2 - 50, ARROW_HEIGHT / 2 + 50, ARROW_WIDTH / 2 + 50, ARROW_HEIGHT / 2 - 25};
    for (int k = 0; k < 4; k++)
        g_assert_cmpfloat_with_epsilon(place->shaft[k], truth[k], 1e-9);
    g_assert_cmpfloat(arrow_distance_to(place->label, truth[0], truth[1]), <, 12);
    arrow_stage_close(&stage);
}

/* Where a drawing is all over the picture labels go over it, each with its own place, before one is left out; they stay
 * within reach of their heads. */
static void test_none_is_left_out(void)
{
    enum { COUNT = 20 };
    static const double all[][4] = {{0, 0, ARROW_WIDTH, ARROW_HEIGHT}};
    TinkerForceArrow arrows[COUNT];
    for (int i = 0; i < COUNT; i++)
        arrows[i] = (TinkerForceArrow){0,
                                       0,
                                       0.2 * cos(i * 2 * G_PI / COUNT),
                                       0.2 * sin(i * 2 * G_PI / COUNT),
                                       "A support with a name (Normal force)",
                                       i % TINKER_ARROW_KINDS};
    g_autoptr(GArray) places = g_array_new(FALSE, FALSE, sizeof(TinkerArrowPlace));
    ArrowStage stage;
    arrow_stage_open(&stage, "light", 1);
    stage.options.roomy = TRUE;
    stage.options.reach = 180;
    stage.options.drawn = all;
    stage.options.drawn_count = 1;
    stage.options.places = places;
    arrow_stage_draw(&stage, arrows, COUNT);
    g_assert_cmpuint(stage.written->len, ==, COUNT);
    arrow_stage_assert_inside_and_apart(&stage);
    for (guint i = 0; i < places->len; i++) {
        const TinkerArrowPlace *place = &g_array_index(places, TinkerArrowPlace, i);
        g_assert_cmpfloat(arrow_distance_to(place->label, place->shaft[2], place->shaft[3]), <=, 180);
    }
    arrow_stage_close(&stage);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/render/arrows/little-room", test_little_room);
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
    return g_test_run();
}
