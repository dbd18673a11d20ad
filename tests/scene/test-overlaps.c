/* Bodies that start in a plate: by hand, and against clipping polygons. */
#include "scene-fixture.h"

#include <math.h>

#include "scene/frame/overlaps.h"

#define FLOOR "{\"type\": \"support\", \"name\": \"Floor\", \"position\": [1, 2], \"width\": 4, \"height\": 0.4"

/* The overlaps of a floor whose top lies at y = 2.2 with a mass of height 0.8 at (x, y). */
static GArray *overlaps_at(double x, double y, const char *more)
{
    g_autofree char *blocks =
        g_strdup_printf(FLOOR "%s}, {\"type\": \"mass\", \"name\": \"Box\", \"position\": [%.17g, %.17g]}", more, x, y);
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    return tinker_overlaps_new(frame);
}

/* Its box reaches 0.4 to both sides: it stands on the top at 2.6, and hangs under the slab, from 1.8 down, at 1.4. */
static void test_places(void)
{
    static const struct {
        double x, y;
        const char *more;
        double depth; /* 0: no overlap */
    } rows[] = {
        {0, 3.5, "", 0},
        {0, 2.6, "", 0},           /* touching */
        {0, 2.6 - 5e-10, "", 0},   /* as good as */
        {0, 2.6 - 5e-9, "", 5e-9}, /* no more */
        {0, 2.3, "", 0.3},
        {0, 2.0, "", 0.6},
        {0, 1.5, "", 1.1},
        {0, 1.4 + 5e-9, "", 1.2 - 5e-9},
        {0, 1.4, "", 0}, /* behind, its upper side at the underside */
        {0, 0, "", 0},
        {2.999, 2.3, "", 0.3}, /* the foot counts, not the box */
        {3.001, 2.3, "", 0},
        {-0.999, 2.3, "", 0.3},
        {-1.001, 2.3, "", 0},
        {0, 2.3, ", \"solid\": false", 0},
        {0, 1.5, ", \"orientation\": \"180 deg\"", 0.1}, /* the top faces down, at 1.8 */
        {0, 1.3, ", \"orientation\": \"180 deg\"", 0},
        {0, 3, ", \"orientation\": \"180 deg\"", 0},
        {0.5, 3, ", \"orientation\": \"90 deg\"", 0.1}, /* faces left, its top at x = 0.8: in by 0.5 + 0.4 - 0.8 */
        {0.3, 3, ", \"orientation\": \"90 deg\"", 0},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autoptr(GArray) overlaps = overlaps_at(rows[i].x, rows[i].y, rows[i].more);
        if (overlaps->len != (rows[i].depth > 0)) g_error("row %" G_GSIZE_FORMAT, i);
        if (rows[i].depth > 0)
            g_assert_cmpfloat_with_epsilon(g_array_index(overlaps, TinkerOverlap, 0).depth, rows[i].depth, 1e-14);
    }
}

/* A support is where its motion has it at t = 0, not where it is placed. */
static void test_moved_support(void)
{
    static const char *const motion =
        ", {\"type\": \"support-motion\", \"ends\": [\"Floor\"], \"waveform\": \"cosine\", "
        "\"amplitude\": %s, \"angle\": \"90 deg\"}";
    static const char *const amplitudes[] = {"0.5", "-0.5"};
    static const guint expected[] = {1, 0};
    for (gsize i = 0; i < G_N_ELEMENTS(amplitudes); i++) {
        g_autoptr(GString) blocks = g_string_new(FLOOR "}, {\"type\": \"mass\", \"position\": [0, 3]}");
        g_string_append_printf(blocks, motion, amplitudes[i]);
        g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks->str);
        g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
        g_autoptr(GArray) overlaps = tinker_overlaps_new(frame);
        g_assert_cmpuint(overlaps->len, ==, expected[i]);
    }
}

static void test_words(void)
{
    g_autoptr(TinkerScene) scene =
        scene_fixture_read_blocks(FLOOR ", \"orientation\": \"90 deg\"}, {\"type\": \"mass\", \"name\": \"Box\", "
                                        "\"position\": [0.5, 3]}, {\"type\": \"mass\", \"position\": [0.3, 3]}");
    g_autoptr(GPtrArray) warnings = g_ptr_array_new_with_free_func(g_free);
    tinker_overlaps_tell(scene, warnings);
    g_assert_cmpuint(warnings->len, ==, 1);
    g_assert_cmpstr(g_ptr_array_index(warnings, 0), ==,
                    "Box starts 0.1 m below the top of Floor and overlaps it, so it passes as from behind (to start on "
                    "the top, move it by [-0.1, 0] m; to let it pass, set \"solid\" of Floor to false)");
}

/* However many there are, a handful is told of, and how many more there are. */
static void test_many(void)
{
    static const char *const last[] = {NULL, NULL, "and 1 more starts below the top of a support ",
                                       "and 2 more start below the top of a support ",
                                       "and 195 more start below the top of a support "};
    static const guint counts[] = {1, 5, 6, 7, 200}, told[] = {1, 5, 6, 6, 6};
    for (gsize i = 0; i < G_N_ELEMENTS(counts); i++) {
        g_autoptr(GString) blocks = g_string_new(FLOOR "}");
        for (guint k = 0; k < counts[i]; k++)
            g_string_append(blocks, ", {\"type\": \"mass\", \"position\": [0.1, 2.4]}");
        g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks->str);
        g_autoptr(GPtrArray) warnings = g_ptr_array_new_with_free_func(g_free);
        tinker_overlaps_tell(scene, warnings);
        g_assert_cmpuint(warnings->len, ==, told[i]);
        const char *text = g_ptr_array_index(warnings, warnings->len - 1);
        if (last[i] != NULL)
            g_assert_true(g_str_has_prefix(text, last[i]));
        else
            g_assert_null(strstr(text, " more "));
    }
}

/* The line across the plate through a point, as the two places along the normal where the body's and the plate's
 * corners lie: worked out from corners in world coordinates. */
static gboolean overlap_by_corners(double px, double py, double angle, double width, double height, double x, double y,
                                   double body_height)
{
    const double tx = cos(angle), ty = sin(angle), nx = -ty, ny = tx;
    const double corners[4][2] = {{px - tx * width / 2 - nx * height / 2, py - ty * width / 2 - ny * height / 2},
                                  {px + tx * width / 2 - nx * height / 2, py + ty * width / 2 - ny * height / 2},
                                  {px + tx * width / 2 + nx * height / 2, py + ty * width / 2 + ny * height / 2},
                                  {px - tx * width / 2 + nx * height / 2, py - ty * width / 2 + ny * height / 2}};
    /* The plate grown by half a body to both faces contains the body's centre: left of all four sides. */
    for (int side = 0; side < 4; side++) {
        const double *a = corners[side], *b = corners[(side + 1) % 4];
        const double grown = side % 2 == 0 ? body_height / 2 : 0.0, length = hypot(b[0] - a[0], b[1] - a[1]);
        const double left = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length;
        if (left < -grown) return FALSE;
    }
    return TRUE;
}

enum { PLATES = 25, BODIES = 200 };

/* Nothing is missed by sorting, and nothing found twice. */
static void test_against_all_pairs(void)
{
    double plate[PLATES][5], body[BODIES][3];
    g_autoptr(GString) blocks = g_string_new(NULL);
    for (int k = 0; k < PLATES; k++) {
        const double values[5] = {g_test_rand_double_range(-5, 5), g_test_rand_double_range(-5, 5),
                                  g_test_rand_double_range(-G_PI, G_PI), g_test_rand_double_range(0.1, 5),
                                  g_test_rand_double_range(0, 1)};
        memcpy(plate[k], values, sizeof values);
        g_string_append_printf(
            blocks,
            "{\"type\": \"support\", \"name\": \"P%d\", \"position\": [%.17g, %.17g], \"orientation\": "
            "%.17g, \"width\": %.17g, \"height\": %.17g},",
            k, values[0], values[1], values[2], values[3], values[4]);
    }
    for (int i = 0; i < BODIES; i++) {
        const double values[3] = {g_test_rand_double_range(-6, 6), g_test_rand_double_range(-6, 6),
                                  g_test_rand_double_range(0, 2)};
        memcpy(body[i], values, sizeof values);
        g_string_append_printf(
            blocks, "%s{\"type\": \"mass\", \"name\": \"B%d\", \"position\": [%.17g, %.17g], \"height\": %.17g}",
            i > 0 ? "," : "", i, values[0], values[1], values[2]);
    }
    g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks->str);
    g_autoptr(TinkerFrame) frame = tinker_frame_new(scene, NULL);
    g_autoptr(GArray) overlaps = tinker_overlaps_new(frame);
    guint found = 0;
    for (int k = 0; k < PLATES; k++)
        for (int i = 0; i < BODIES; i++) {
            if (!overlap_by_corners(plate[k][0], plate[k][1], plate[k][2], plate[k][3], plate[k][4], body[i][0],
                                    body[i][1], body[i][2]))
                continue;
            g_assert_cmpuint(found, <, overlaps->len);
            const TinkerOverlap *overlap = &g_array_index(overlaps, TinkerOverlap, found++);
            g_assert_cmpint(overlap->plate, ==, k);
            g_assert_cmpint(overlap->body, ==, PLATES + i);
        }
    g_assert_cmpuint(found, ==, overlaps->len);
    g_assert_cmpuint(found, >, 20);
}

static void add_tests(void)
{
    g_test_add_func("/overlaps/places", test_places);
    g_test_add_func("/overlaps/moved-support", test_moved_support);
    g_test_add_func("/overlaps/words", test_words);
    g_test_add_func("/overlaps/many", test_many);
    g_test_add_func("/overlaps/against-all-pairs", test_against_all_pairs);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
