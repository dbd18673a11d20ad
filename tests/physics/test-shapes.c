/* Gap functions of pairs of shapes, against distances of all their sides from one another at many random poses, and
 * their derivatives against differences. */
#include <glib.h>
#include <math.h>
#include <string.h>

#include "physics/shapes/gaps.h"
#include "physics/shapes/manifold.h"
#include "physics/shapes/outline-parts.h"
#include "physics/shapes/unturned.h"

#define POSES 1000000
#define MOST  96

static const double box_corners[] = {-0.5, -0.2, 0.5, -0.2, 0.5, 0.2, -0.5, 0.2};
static const double triangle_corners[] = {-0.4, -0.3, 0.6, -0.1, -0.1, 0.5};
static const double hexagon_corners[] = {0.4, 0, 0.2, 0.35, -0.2, 0.35, -0.4, 0, -0.2, -0.35, 0.2, -0.35};
static const double line_corners[] = {-0.6, 0, 0.6, 0};
static const double top_corners[] = {-0.7, 0.1, 0.7, 0.1};

/* An L, an arrow whose notch is deep, and how they are cut into triangles (test_parts holds any that are right). */
static const double angle_corners[] = {-0.2, -0.2, 0.6, -0.2, 0.6, 0, 0, 0, 0, 0.5, -0.2, 0.5};
static const double angle_parts[] = {-0.2, -0.2, 0.6, -0.2, 0.6, 0,   -0.2, -0.2, 0.6, 0,   0,    0,
                                     -0.2, -0.2, 0,   0,    0,   0.5, -0.2, -0.2, 0,   0.5, -0.2, 0.5};
static const double arrow_corners[] = {0.5, 0, -0.4, 0.4, -0.1, 0, -0.4, -0.4};
static const double arrow_parts[] = {0.5, 0, -0.4, 0.4, -0.1, 0, 0.5, 0, -0.1, 0, -0.4, -0.4};

static const TinkerOutline shapes[] = {
    {TINKER_OUTLINE_POLYGON, 0.6, 4, box_corners},
    {TINKER_OUTLINE_POLYGON, 0.7, 3, triangle_corners},
    {TINKER_OUTLINE_POLYGON, 0.5, 6, hexagon_corners},
    {TINKER_OUTLINE_DISC, 0.3, 0, NULL},
    {TINKER_OUTLINE_DISC, 0.5, 0, NULL},
    {TINKER_OUTLINE_POLYGON, 0.6, 2, line_corners},
    {TINKER_OUTLINE_POLYGON, 0.7, 6, angle_corners, 4, angle_parts},
    {TINKER_OUTLINE_POLYGON, 0.6, 4, arrow_corners, 2, arrow_parts},
};
static const TinkerOutline top = {TINKER_OUTLINE_TOP, 0.75, 2, top_corners};

static double between(GRand *random, double from, double to)
{
    return g_rand_double_range(random, from, to);
}

static TinkerBodyPose turned_by(TinkerBodyPose pose, double angle)
{
    pose.angle = angle;
    pose.cosine = cos(angle);
    pose.sine = sin(angle);
    return pose;
}

static TinkerBodyPose random_pose(GRand *random)
{
    const TinkerBodyPose pose = {between(random, -1.2, 1.2), between(random, -1.2, 1.2), between(random, -7, 7),
                                 between(random, -2, 2),     between(random, -2, 2),     between(random, -3, 3)};
    return turned_by(pose, pose.angle);
}

static void corner_at(const TinkerOutline *outline, const TinkerBodyPose *pose, int32_t number, double at[2])
{
    const double *local = outline->corners + 2 * (number % outline->count), c = cos(pose->angle), s = sin(pose->angle);
    at[0] = pose->x + c * local[0] - s * local[1];
    at[1] = pose->y + s * local[0] + c * local[1];
}

/* Brute force ------------------------------------------------------------------------------------------------------ */

static double from_segment(const double p[2], const double a[2], const double b[2])
{
    const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
    const double share = fmax(0, fmin(1, ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square));
    return hypot(p[0] - a[0] - share * x, p[1] - a[1] - share * y);
}

/* Of a point from a polygon; negative within it. */
static double from_polygon(const double p[2], const TinkerOutline *outline, const TinkerBodyPose *pose)
{
    double least = INFINITY;
    gboolean inside = FALSE; /* where a ray upwards crosses an odd number of edges */
    for (int32_t i = 0; i < outline->count; i++) {
        double a[2], b[2];
        corner_at(outline, pose, i, a);
        corner_at(outline, pose, i + 1, b);
        least = fmin(least, from_segment(p, a, b));
        const gboolean spans = outline->count > 2 && (a[0] > p[0]) != (b[0] > p[0]);
        if (spans && p[1] < a[1] + (p[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1])) inside = !inside;
    }
    return inside ? -least : least;
}

static double side_of(const double a[2], const double b[2], const double p[2])
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

static gboolean sides_cross(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                            const TinkerBodyPose *q)
{
    for (int32_t i = 0; i < first->count; i++)
        for (int32_t k = 0; k < second->count; k++) {
            double a[2], b[2], c[2], d[2];
            corner_at(first, p, i, a);
            corner_at(first, p, i + 1, b);
            corner_at(second, q, k, c);
            corner_at(second, q, k + 1, d);
            if (side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0) return TRUE;
        }
    return FALSE;
}

/* Negative where they overlap. */
static double distance_of(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                          const TinkerBodyPose *q)
{
    const double at_p[2] = {p->x, p->y}, at_q[2] = {q->x, q->y};
    const gboolean disc = first->kind == TINKER_OUTLINE_DISC, other_disc = second->kind == TINKER_OUTLINE_DISC;
    if (disc && other_disc) return hypot(p->x - q->x, p->y - q->y) - first->radius - second->radius;
    if (disc) return from_polygon(at_p, second, q) - first->radius;
    if (other_disc) return from_polygon(at_q, first, p) - second->radius;
    double least = sides_cross(first, p, second, q) ? -1 : INFINITY;
    for (int32_t i = 0; i < first->count; i++) {
        double at[2];
        corner_at(first, p, i, at);
        least = fmin(least, from_polygon(at, second, q));
    }
    for (int32_t i = 0; i < second->count; i++) {
        double at[2];
        corner_at(second, q, i, at);
        least = fmin(least, from_polygon(at, first, p));
    }
    return least;
}

/* Two corners that are nearest to each other have no function: they meet in no more than single motions. */
static double nearest_corners(const TinkerOutline *first, const TinkerBodyPose *p, const TinkerOutline *second,
                              const TinkerBodyPose *q)
{
    double least = INFINITY;
    for (int32_t i = 0; i < first->count; i++)
        for (int32_t k = 0; k < second->count; k++) {
            double a[2], b[2];
            corner_at(first, p, i, a);
            corner_at(second, q, k, b);
            least = fmin(least, hypot(a[0] - b[0], a[1] - b[1]));
        }
    return least;
}

/* Tests ------------------------------------------------------------------------------------------------------------ */

static void test_distance(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(11);
    double worst = 0;
    guint apart = 0;
    for (int32_t i = 0; i < POSES; i++) {
        const TinkerOutline *first = &shapes[g_rand_int_range(random, 0, G_N_ELEMENTS(shapes))];
        const TinkerOutline *second = &shapes[g_rand_int_range(random, 0, G_N_ELEMENTS(shapes))];
        const TinkerBodyPose p = random_pose(random), q = random_pose(random);
        const double distance = distance_of(first, &p, second, &q);
        const double overlap = tinker_outlines_overlap(first, &p, second, &q);
        if (fabs(distance) < 1e-9) continue;
        g_assert_true((overlap > 0) == (distance < 0));
        if (distance < 0) continue;
        g_assert_cmpfloat(-overlap, <=, distance + 1e-12);
        TinkerGapFunction functions[MOST];
        const int32_t count = tinker_gap_functions(first, second, functions, MOST);
        double least = nearest_corners(first, &p, second, &q);
        g_assert_cmpint(count, <, MOST);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &p, &q, &gap);
            g_assert_true(tinker_gap_alone(&functions[k], &p, &q) == gap.gap);
            if (gap.gap > 0 && fabs(gap.along) <= functions[k].half_width) least = fmin(least, gap.gap);
        }
        worst = fmax(worst, fabs(least - distance));
        apart++;
    }
    g_test_message("%u poses apart: the least gap is off by %.1e m", apart, worst);
    g_assert_cmpuint(apart, >, POSES / 4);
    g_assert_cmpfloat(worst, <, 1e-13);
}

/* Shapes that keep their angles, as a point and a grown shape: the distance of both is that of the shapes, and so is
 * whether they overlap. */
static void test_unturned(void)
{
    static const int32_t numbers[] = {0, 1, 5}; /* box, triangle, line */
    static const double way[2] = {1, 0};
    g_autoptr(GRand) random = g_rand_new_with_seed(12);
    double worst = 0;
    for (int32_t i = 0; i < POSES / 10; i++) {
        const TinkerOutline *first = &shapes[numbers[g_rand_int_range(random, 0, G_N_ELEMENTS(numbers))]];
        const TinkerOutline *second = &shapes[numbers[g_rand_int_range(random, 0, G_N_ELEMENTS(numbers))]];
        TinkerBodyPose p = random_pose(random), q = random_pose(random);
        const double distance = distance_of(first, &p, second, &q);
        TinkerUnturned both;
        TinkerGapFunction functions[MOST];
        tinker_unturned_init(&both, first, p.angle, second, q.angle);
        const int32_t count = tinker_unturned_functions(&both, first, p.angle, way, functions, MOST);
        p = turned_by(p, 0);
        q = turned_by(q, 0);
        if (fabs(distance) < 1e-9) continue;
        g_assert_true((tinker_outlines_overlap(&both.point, &p, &both.around, &q) > 0) == (distance < 0));
        if (distance < 0) continue;
        double least = nearest_corners(&both.point, &p, &both.around, &q);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &p, &q, &gap);
            g_assert_true(tinker_gap_alone(&functions[k], &p, &q) == gap.gap);
            if (gap.gap > 0 && fabs(gap.along) <= functions[k].half_width) least = fmin(least, gap.gap);
        }
        worst = fmax(worst, fabs(least - distance));
    }
    g_assert_cmpfloat(worst, <, 1e-13);
}

/* The part of a top that is within a polygon, by cutting it at all sides. */
static double length_within(const TinkerBodyPose *at_top, const TinkerOutline *other, const TinkerBodyPose *pose)
{
    double a[2], b[2], from = 0, to = 1;
    corner_at(&top, at_top, 0, a);
    corner_at(&top, at_top, 1, b);
    for (int32_t i = 0; i < other->count; i++) {
        double c[2], d[2];
        corner_at(other, pose, i, c);
        corner_at(other, pose, i + 1, d);
        const double first = side_of(c, d, a), last = side_of(c, d, b);
        if (first < 0 && last < 0) return -1;
        if (first < 0) from = fmax(from, first / (first - last));
        if (last < 0) to = fmin(to, first / (first - last));
    }
    return to - from;
}

static void test_tops(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(12);
    guint within = 0;
    for (int32_t i = 0; i < POSES / 4; i++) {
        const TinkerBodyPose p = random_pose(random), q = random_pose(random);
        const TinkerOutline *other = &shapes[g_rand_int_range(random, 0, 5)];
        const double overlap = tinker_outlines_overlap(&top, &p, other, &q);
        gboolean is_within;
        if (other->kind == TINKER_OUTLINE_DISC) {
            double a[2], b[2];
            const double at[2] = {q.x, q.y};
            corner_at(&top, &p, 0, a);
            corner_at(&top, &p, 1, b);
            is_within = from_segment(at, a, b) < other->radius;
        } else {
            is_within = length_within(&p, other, &q) > 0;
        }
        if (fabs(overlap) > 1e-9) g_assert_true((overlap > 0) == is_within);
        within += is_within;
    }
    g_assert_cmpuint(within, >, POSES / 40);
}

static TinkerBodyPose moved(const TinkerBodyPose *pose, const double a[3], double time)
{
    const TinkerBodyPose there = {.x = pose->x + time * (pose->vx + 0.5 * time * a[0]),
                                  .y = pose->y + time * (pose->vy + 0.5 * time * a[1]),
                                  .vx = pose->vx + time * a[0],
                                  .vy = pose->vy + time * a[1],
                                  .rate = pose->rate + time * a[2]};
    return turned_by(there, pose->angle + time * (pose->rate + 0.5 * time * a[2]));
}

static double second_by_rows(const TinkerGap *gap, int which, double a[2][3], int32_t tip_of)
{
    double sum = gap->drift[which];
    for (int k = 0; k < 3; k++)
        sum += gap->row[which][k] * a[tip_of][k] + gap->row[which][3 + k] * a[1 - tip_of][k];
    return sum;
}

static void assert_near(double found, double expected, double size)
{
    if (!(fabs(found - expected) <= size)) g_error("%.15g in place of %.15g", found, expected);
}

static void check_derivatives(const TinkerGapFunction *function, const TinkerBodyPose pose[2], double a[2][3])
{
    const double h = 1e-5;
    TinkerGap gap[3];
    for (int k = 0; k < 3; k++) {
        const TinkerBodyPose p = moved(&pose[0], a[0], h * (k - 1)), q = moved(&pose[1], a[1], h * (k - 1));
        tinker_gap_measure(function, &p, &q, &gap[k]);
    }
    const TinkerGap *at = &gap[1];
    if (function->round && at->gap < -0.7 * (function->tip_radius + function->seat_radius)) return;
    const double far = function->round ? at->gap + function->tip_radius + function->seat_radius : 1;
    const double size = 1e-6 * (1 + 1 / (far * far));
    assert_near((gap[2].gap - gap[0].gap) / (2 * h), at->normal_speed, size);
    assert_near((gap[2].normal_speed - gap[0].normal_speed) / (2 * h), second_by_rows(at, 0, a, function->tip_of),
                100 * size);
    assert_near((gap[2].tangential_speed - gap[0].tangential_speed) / (2 * h),
                second_by_rows(at, 1, a, function->tip_of), 100 * size);
    if (fabs(gap[2].along - gap[0].along) < 1e-2)
        assert_near((gap[2].along - gap[0].along) / (2 * h), at->along_speed, 100 * size);
}

/* With the gap 0 `rolled` is what the speed along it adds up to: the tip's frame is put there along the normal. */
static void check_rolled(const TinkerGapFunction *function, const TinkerBodyPose pose[2])
{
    const double h = 1e-5, none[3] = {0, 0, 0};
    TinkerBodyPose at[2] = {pose[0], pose[1]}, *tip = &at[function->tip_of];
    TinkerGap gap, ends[2];
    tinker_gap_measure(function, &at[0], &at[1], &gap);
    tip->x -= gap.gap * gap.normal[0];
    tip->y -= gap.gap * gap.normal[1];
    tinker_gap_measure(function, &at[0], &at[1], &gap);
    g_assert_cmpfloat(fabs(gap.gap), <, 1e-12);
    for (int k = 0; k < 2; k++) {
        const TinkerBodyPose p = moved(&at[0], none, h * (2 * k - 1)), q = moved(&at[1], none, h * (2 * k - 1));
        tinker_gap_measure(function, &p, &q, &ends[k]);
    }
    double change = ends[1].rolled - ends[0].rolled;
    if (gap.period > 0) change = remainder(change, gap.period);
    assert_near(change / (2 * h), gap.tangential_speed, 1e-6);
}

static void test_derivatives(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(13);
    for (int32_t i = 0; i < 20000; i++) {
        const TinkerOutline *first = &shapes[g_rand_int_range(random, 0, G_N_ELEMENTS(shapes))];
        const int32_t other = g_rand_int_range(random, 0, G_N_ELEMENTS(shapes) + 1);
        const TinkerOutline *second = other < (int32_t)G_N_ELEMENTS(shapes) ? &shapes[other] : &top;
        const TinkerBodyPose pose[2] = {random_pose(random), random_pose(random)};
        double a[2][3];
        for (int k = 0; k < 6; k++)
            a[k / 3][k % 3] = between(random, -3, 3);
        TinkerGapFunction functions[MOST];
        const int32_t count = tinker_gap_functions(first, second, functions, MOST);
        g_assert_cmpint(count, >, 0);
        const TinkerGapFunction *function = &functions[g_rand_int_range(random, 0, count)];
        check_derivatives(function, pose, a);
        check_rolled(function, pose);
    }
}

/* A disc that goes round a box, over edges and corners, in small steps: the gap to it changes by no more than the way.
 */
static void test_round_a_box(void)
{
    const TinkerBodyPose box = turned_by((TinkerBodyPose){0}, 0.3);
    TinkerGapFunction functions[MOST];
    const int32_t count = tinker_gap_functions(&shapes[3], &shapes[0], functions, MOST);
    double before = NAN;
    for (int32_t i = 0; i <= 100000; i++) {
        const double angle = 2 * G_PI * i / 100000;
        const TinkerBodyPose disc = {.x = 0.9 * cos(angle), .y = 0.9 * sin(angle), .cosine = 1};
        double least = INFINITY;
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &disc, &box, &gap);
            if (tinker_gap_is_over(&functions[k], &disc, &box, &gap, 1e-12) && gap.gap > -0.01)
                least = fmin(least, gap.gap);
        }
        g_assert_true(isfinite(least));
        if (i > 0) g_assert_cmpfloat(fabs(least - before), <=, 1.001 * 0.9 * 2 * G_PI / 100000);
        before = least;
    }
}

/* A box that slides along a top, at the instant when a corner of it comes over an end: the end is in line with that
 * side of the box, too, but nothing of the box is beside the end. They touch across the top alone, whatever rounding
 * does. */
static void test_over_an_end(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(19);
    for (int32_t i = 0; i < 20000; i++) {
        const double angle = between(random, -4, 4), c = cos(angle), s = sin(angle), speed = between(random, -3, 3);
        const double place = (i % 2 == 0 ? 0.2 : -0.2) + between(random, -1e-15, 1e-15), x = between(random, -9, 9);
        const TinkerBodyPose seat = turned_by((TinkerBodyPose){.x = x}, angle);
        const TinkerBodyPose box = turned_by(
            (TinkerBodyPose){.x = x + c * place - s * 0.3, .y = s * place + c * 0.3, .vx = c * speed, .vy = s * speed},
            angle + between(random, -1e-15, 1e-15));
        TinkerGapFunction functions[MOST];
        const int32_t count = tinker_gap_functions(&shapes[0], &top, functions, MOST);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &box, &seat, &gap);
            if (fabs(gap.gap) > 1e-12 || !tinker_gap_is_over(&functions[k], &box, &seat, &gap, 1e-12)) continue;
            g_assert_cmpfloat(fabs(c * gap.normal[1] - s * gap.normal[0]), >, 1 - 1e-12);
        }
    }
}

/* Outlines --------------------------------------------------------------------------------------------------------- */

static double area_of(const double *corners, int32_t count)
{
    double twice = 0;
    for (int32_t i = 0; i < count; i++) {
        const double *a = corners + 2 * i, *b = corners + 2 * ((i + 1) % count);
        twice += a[0] * b[1] - b[0] * a[1];
    }
    return 0.5 * twice;
}

/* A star of corners at random distances: any place is in as many of its triangles as it is in the star, one or none. */
static void check_star(GRand *random)
{
    enum { MOST_CORNERS = 24 };
    static const double origin[2] = {0, 0};
    const int32_t count = g_rand_int_range(random, 4, MOST_CORNERS + 1);
    double points[2 * MOST_CORNERS], corners[2 * MOST_CORNERS], triangles[6 * MOST_CORNERS], area = 0;
    for (int32_t i = 0; i < count; i++) {
        const double angle = -2 * G_PI * i / count, far = between(random, 0.1, 1); /* clockwise: it is turned round */
        points[2 * i] = far * cos(angle);
        points[2 * i + 1] = far * sin(angle);
    }
    g_assert_cmpint(tinker_outline_normalise(points, count, origin, corners), ==, count);
    tinker_outline_cut(corners, count, triangles);
    for (int32_t i = 0; i < count - 2; i++) {
        g_assert_cmpfloat(area_of(triangles + 6 * i, 3), >, 0);
        area += area_of(triangles + 6 * i, 3);
    }
    assert_near(area, area_of(corners, count), 1e-14);
    const TinkerOutline star = {TINKER_OUTLINE_POLYGON, 1, count, corners, 0, NULL};
    const TinkerBodyPose still = {.cosine = 1};
    for (int32_t k = 0; k < 50; k++) {
        const double p[2] = {between(random, -1, 1), between(random, -1, 1)};
        int32_t in = 0;
        for (int32_t i = 0; i < count - 2; i++) {
            const TinkerOutline part = {TINKER_OUTLINE_POLYGON, 1, 3, triangles + 6 * i, 0, NULL};
            in += from_polygon(p, &part, &still) < 0;
        }
        g_assert_cmpint(in, ==, from_polygon(p, &star, &still) < 0);
    }
}

static void test_parts(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(17);
    for (int32_t i = 0; i < 2000; i++)
        check_star(random);
}

/* Corners on the line of their neighbours are none, however the outline is given. */
static void test_normalised(void)
{
    static const double points[] = {1, 1, 1, 2, 1, 3, 2, 3, 3, 3, 3, 1, 2, 1}; /* clockwise */
    static const double origin[2] = {2, 2}, expected[] = {1, -1, 1, 1, -1, 1, -1, -1};
    double corners[14];
    g_assert_cmpint(tinker_outline_normalise(points, 7, origin, corners), ==, 4);
    g_assert_true(tinker_outline_is_convex(corners, 4));
    for (int k = 0; k < 8; k++)
        g_assert_cmpfloat(corners[k], ==, expected[k]);
    g_assert_false(tinker_outline_is_convex(angle_corners, 6));
}

static void place(const TinkerOutline *outline, const TinkerBodyPose *pose, double *room, TinkerPlacedShape *shape)
{
    *shape = (TinkerPlacedShape){.kind = outline->kind,
                                 .count = outline->count,
                                 .radius = outline->radius,
                                 .corners = room,
                                 .normals = room + 2 * outline->count};
    double local[4 * TINKER_MOST_CORNERS];
    tinker_shape_corners(outline, local);
    tinker_place_shape(shape, pose->x, pose->y, cos(pose->angle), sin(pose->angle), local);
}

/* The nearest point of a manifold has the least gap of all gap functions over their seats, and their normal. Corners
 * over corners of polygons have no gap function: then it has no points, or those of an edge that the other is past. */
static void test_manifolds(void)
{
    GRand *random = g_rand_new_with_seed(7);
    int compared = 0;
    for (int i = 0; i < POSES / 4; i++) {
        const int a = g_rand_int_range(random, 0, G_N_ELEMENTS(shapes)),
                  b = g_rand_int_range(random, 0, G_N_ELEMENTS(shapes) + 1);
        const TinkerOutline *first = &shapes[a], *second = b < (int)G_N_ELEMENTS(shapes) ? &shapes[b] : &top;
        if (first->triangles != NULL || second->triangles != NULL) continue;
        const TinkerBodyPose at_first = random_pose(random), at_second = random_pose(random);
        double rooms[2][4 * TINKER_MOST_CORNERS];
        TinkerPlacedShape placed[2];
        TinkerManifold manifold;
        place(first, &at_first, rooms[0], &placed[0]);
        place(second, &at_second, rooms[1], &placed[1]);
        tinker_manifold_find(&placed[0], &placed[1], 1, &manifold);
        if (!(manifold.separation > 1e-6) || manifold.count == 0) continue;
        double nearest = manifold.points[0].gap, least = INFINITY, normal[2] = {0, 0};
        if (manifold.count > 1) nearest = fmin(nearest, manifold.points[1].gap);
        g_assert_cmpfloat(nearest, >=, manifold.separation - 1e-12);
        if (nearest > manifold.separation + 1e-9) continue; /* of a corner that is past the seat */
        TinkerGapFunction functions[MOST];
        const int32_t count = tinker_gap_functions(first, second, functions, MOST);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &at_first, &at_second, &gap);
            if (gap.gap < 0 || !tinker_gap_is_over(&functions[k], &at_first, &at_second, &gap, 0)) continue;
            if (gap.gap >= least) continue;
            least = gap.gap;
            for (int axis = 0; axis < 2; axis++)
                normal[axis] = functions[k].tip_of == 0 ? gap.normal[axis] : -gap.normal[axis];
        }
        if (!isfinite(least)) continue;
        g_assert_cmpfloat(fabs(nearest - least), <, 1e-12);
        g_assert_cmpfloat(fabs(manifold.normal[0] - normal[0]) + fabs(manifold.normal[1] - normal[1]), <, 1e-6);
        compared++;
    }
    g_assert_cmpint(compared, >, POSES / 40);
    g_rand_free(random);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/shapes/distance", test_distance);
    g_test_add_func("/physics/shapes/unturned", test_unturned);
    g_test_add_func("/physics/shapes/tops", test_tops);
    g_test_add_func("/physics/shapes/derivatives", test_derivatives);
    g_test_add_func("/physics/shapes/round-a-box", test_round_a_box);
    g_test_add_func("/physics/shapes/over-an-end", test_over_an_end);
    g_test_add_func("/physics/shapes/parts", test_parts);
    g_test_add_func("/physics/shapes/normalised", test_normalised);
    g_test_add_func("/physics/shapes/manifolds", test_manifolds);
    return g_test_run();
}
