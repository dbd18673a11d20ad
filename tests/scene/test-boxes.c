/* Boxes that meet: by hand; against clipping of their corners, and a search in steps of time; the first of all pairs.
 */
#include "scene/frame/boxes.h"

#include <math.h>
#include <string.h>

#include "scene-fixture.h"

/* Two carts of width 0.8 at -3 and 1, with 3 m/s and -1 m/s: their sides are 3.2 m apart, and come nearer by 4 m/s. */
static void test_by_hand(void)
{
    const TinkerBox a = {.block = 0, .x = -3, .width = 0.8, .height = 0.4, .vx = 3};
    const TinkerBox still = {.block = 1, .x = 1, .width = 0.8, .height = 0.4};
    TinkerBox b = still;
    double time;
    b.vx = -1;
    g_assert_true(tinker_boxes_meet(&a, &b, 4, &time));
    g_assert_cmpfloat_with_epsilon(time, 0.8, 1e-9);
    g_assert_false(tinker_boxes_meet(&a, &b, 0.79, &time));
    b.vx = 3; /* as fast as the other */
    g_assert_false(tinker_boxes_meet(&a, &b, 1e6, &time));
    b.vx = -1;
    b.y = 0.4; /* passes over it, touching */
    g_assert_false(tinker_boxes_meet(&a, &b, 4, &time));
    b.y = 0.399;
    g_assert_true(tinker_boxes_meet(&a, &b, 4, &time));
    b = still;
    b.x = -2.2; /* touching, and run into from the start on */
    g_assert_true(tinker_boxes_meet(&a, &b, 1, &time));
    g_assert_cmpfloat_with_epsilon(time, 0, 1e-9);
    b.vx = 3.5; /* touching, and moving off */
    g_assert_false(tinker_boxes_meet(&a, &b, 100, &time));
    /* one on its corner: the other's side is sqrt(2) / 2 from its centre, less 1 */
    const TinkerBox corner = {.width = 1, .height = 1, .angle = G_PI / 4},
                    wall = {.x = 2, .width = 1, .height = 4, .vx = -1};
    g_assert_true(tinker_boxes_meet(&corner, &wall, 2, &time));
    g_assert_cmpfloat_with_epsilon(time, 1.5 - sqrt(0.5), 1e-8);
}

/* The corners of a box at time t, counter-clockwise. */
static void corners_of(const TinkerBox *box, double t, double corners[4][2])
{
    static const int signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double c = cos(box->angle), s = sin(box->angle);
    for (int i = 0; i < 4; i++) {
        const double u = 0.5 * signs[i][0] * box->width, v = 0.5 * signs[i][1] * box->height;
        corners[i][0] = box->x + box->vx * t + c * u - s * v;
        corners[i][1] = box->y + box->vy * t + s * u + c * v;
    }
}

/* The area that two boxes share, by clipping one of them at the sides of the other (Sutherland and Hodgman, 1974). */
static double shared_area(const TinkerBox *a, const TinkerBox *b, double t)
{
    double polygon[16][2], clipped[16][2], edges[4][2];
    int count = 4;
    corners_of(a, t, polygon);
    corners_of(b, t, edges);
    for (int side = 0; side < 4; side++) {
        const double *from = edges[side], *to = edges[(side + 1) % 4];
        int kept = 0;
        for (int i = 0; i < count; i++) {
            const double *p = polygon[i], *q = polygon[(i + 1) % count];
            const double left_p = (to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0]);
            const double left_q = (to[0] - from[0]) * (q[1] - from[1]) - (to[1] - from[1]) * (q[0] - from[0]);
            if (left_p >= 0) memcpy(clipped[kept++], p, sizeof clipped[0]);
            if ((left_p > 0 && left_q < 0) || (left_p < 0 && left_q > 0)) {
                const double share = left_p / (left_p - left_q);
                clipped[kept][0] = p[0] + share * (q[0] - p[0]);
                clipped[kept++][1] = p[1] + share * (q[1] - p[1]);
            }
        }
        count = kept;
        memcpy(polygon, clipped, sizeof polygon);
    }
    double area = 0;
    for (int i = 0; i < count; i++) {
        const double *p = polygon[i], *q = polygon[(i + 1) % count];
        area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
    return area;
}

static TinkerBox random_box(TinkerBlockId block, double extent)
{
    return (TinkerBox){.block = block,
                       .x = g_test_rand_double_range(-extent, extent),
                       .y = g_test_rand_double_range(-extent, extent),
                       .angle = g_test_rand_double_range(-G_PI, G_PI),
                       .width = g_test_rand_double_range(0.2, 2),
                       .height = g_test_rand_double_range(0.2, 2),
                       .vx = g_test_rand_double_range(-2, 2),
                       .vy = g_test_rand_double_range(-2, 2)};
}

/* Just before the time that is told nothing is shared yet, just behind it something is; where none is told, never. */
static void test_against_clipping(void)
{
    const double horizon = 3, beside = 1e-4;
    int met = 0, apart = 0;
    for (int i = 0; i < 2000; i++) {
        const TinkerBox a = random_box(0, 3), b = random_box(1, 3);
        double time;
        if (tinker_boxes_meet(&a, &b, horizon, &time)) {
            met++;
            if (time > 2 * beside) g_assert_cmpfloat(shared_area(&a, &b, time - beside), <, 1e-15);
            if (time == 0) g_assert_cmpfloat(shared_area(&a, &b, 0), >, 0);
        } else {
            apart++;
            for (int k = 0; k <= 300; k++)
                g_assert_cmpfloat(shared_area(&a, &b, k * horizon / 300), <, 1e-8);
        }
    }
    g_assert_cmpint(met, >, 300);
    g_assert_cmpint(apart, >, 300);
}

enum { BOXES = 60 };

/* The first meeting is that of the pair which meets first, among all pairs. */
static void test_first_of_all(void)
{
    int none = 0;
    for (int round = 0; round < 200; round++) {
        g_autoptr(GArray) boxes = g_array_new(FALSE, FALSE, sizeof(TinkerBox));
        const double extent = round % 2 == 0 ? 40 : 400;
        for (int i = 0; i < BOXES; i++) {
            const TinkerBox box = random_box(i, extent);
            g_array_append_val(boxes, box);
        }
        const double horizon = 5;
        double first = INFINITY;
        for (int i = 0; i < BOXES; i++)
            for (int k = i + 1; k < BOXES; k++) {
                double time;
                if (tinker_boxes_meet(&g_array_index(boxes, TinkerBox, i), &g_array_index(boxes, TinkerBox, k), horizon,
                                      &time))
                    first = fmin(first, time);
            }
        TinkerMeeting meeting;
        const gboolean found = tinker_boxes_first_meeting(boxes, horizon, &meeting);
        g_assert_cmpint(found, ==, isfinite(first));
        if (found)
            g_assert_cmpfloat_with_epsilon(meeting.time, first, 1e-12);
        else
            none++;
    }
    g_assert_cmpint(none, >, 5);
    g_assert_cmpint(none, <, 195);
}

/* Many boxes in a row, sideways or upwards, of which the last two overlap: nobody has to look at all pairs. */
static void test_many(void)
{
    enum { MANY = 30000 };
    for (int upwards = FALSE; upwards <= TRUE; upwards++) {
        g_autoptr(GArray) boxes = g_array_new(FALSE, FALSE, sizeof(TinkerBox));
        for (int i = 0; i < MANY; i++) {
            const double place = i < MANY - 1 ? i : i - 0.75;
            const TinkerBox box = {
                .block = i, .x = upwards ? 0 : place, .y = upwards ? place : 0, .width = 0.5, .height = 0.5};
            g_array_append_val(boxes, box);
        }
        TinkerMeeting meeting;
        g_assert_true(tinker_boxes_first_meeting(boxes, 10, &meeting));
        g_assert_cmpint(meeting.first, ==, MANY - 2);
        g_assert_cmpint(meeting.second, ==, MANY - 1);
    }
}

/* Which bodies count: those that can move and have an extent; and what is said of them. */
static void test_words(void)
{
    static const struct {
        const char *a, *b, *words;
    } rows[] = {
        {"\"velocity\": [3, 0]", "\"velocity\": [-1, 0]",
         "A and B meet at 0.8 s, moved on with their start velocities: they pass through each other, as not both "
         "of them have \"collides\" on"},
        {"\"width\": 8", "\"width\": 0.8",
         "A and B overlap at the start: they pass through each other, as not both of them have "
         "\"collides\" on"},
        {"\"velocity\": [3, 0], \"height\": 0", "\"velocity\": [-1, 0]", NULL},
        {"\"velocity\": [0.2, 0]", "\"velocity\": [0, 0]", NULL}, /* not within 4 s */
        {"\"velocity\": [30, 0]", "\"velocity\": [0, 30]", NULL},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(rows); i++) {
        g_autofree char *blocks = g_strdup_printf("{\"type\": \"support\", \"width\": 20}, {\"type\": \"mass\", "
                                                  "\"name\": \"A\", \"position\": [-3, 0.6], %s}, "
                                                  "{\"type\": \"mass\", \"name\": \"B\", \"position\": [1, 0.6], %s}",
                                                  rows[i].a, rows[i].b);
        g_autoptr(TinkerScene) scene = scene_fixture_read_blocks(blocks);
        g_autoptr(GPtrArray) warnings = g_ptr_array_new_with_free_func(g_free);
        tinker_boxes_tell(scene, 4, warnings);
        g_assert_cmpuint(warnings->len, ==, rows[i].words == NULL ? 0 : 1);
        if (rows[i].words != NULL) g_assert_cmpstr(g_ptr_array_index(warnings, 0), ==, rows[i].words);
    }
}

static void add_tests(void)
{
    g_test_add_func("/boxes/by-hand", test_by_hand);
    g_test_add_func("/boxes/against-clipping", test_against_clipping);
    g_test_add_func("/boxes/first-of-all", test_first_of_all);
    g_test_add_func("/boxes/many", test_many);
    g_test_add_func("/boxes/words", test_words);
}

int main(int argc, char **argv)
{
    return scene_fixture_main(argc, argv, add_tests);
}
