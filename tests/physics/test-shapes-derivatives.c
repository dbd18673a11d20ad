/* Gap functions of pairs of shapes: their derivatives against differences along motions, and what they are over. */
#include <glib.h>
#include <math.h>

#include "physics/shapes/gaps.h"
#include "shape-distances.h"

static TinkerBodyPose moved(const TinkerBodyPose *pose, const double a[3], double time)
{
    const TinkerBodyPose there = {.x = pose->x + time * (pose->vx + 0.5 * time * a[0]),
                                  .y = pose->y + time * (pose->vy + 0.5 * time * a[1]),
                                  .vx = pose->vx + time * a[0],
                                  .vy = pose->vy + time * a[1],
                                  .rate = pose->rate + time * a[2]};
    return shape_turned_by(there, pose->angle + time * (pose->rate + 0.5 * time * a[2]));
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
        const TinkerOutline *second = other < (int32_t)G_N_ELEMENTS(shapes) ? &shapes[other] : &shape_top;
        const TinkerBodyPose pose[2] = {shape_random_pose(random), shape_random_pose(random)};
        double a[2][3];
        for (int k = 0; k < 6; k++)
            a[k / 3][k % 3] = shape_between(random, -3, 3);
        TinkerGapFunction functions[SHAPE_MOST];
        const int32_t count = tinker_gap_functions(first, second, functions, SHAPE_MOST);
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
    const TinkerBodyPose box = shape_turned_by((TinkerBodyPose){0}, 0.3);
    TinkerGapFunction functions[SHAPE_MOST];
    const int32_t count = tinker_gap_functions(&shapes[3], &shapes[0], functions, SHAPE_MOST);
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
        const double angle = shape_between(random, -4, 4), c = cos(angle), s = sin(angle),
                     speed = shape_between(random, -3, 3);
        const double place = (i % 2 == 0 ? 0.2 : -0.2) + shape_between(random, -1e-15, 1e-15),
                     x = shape_between(random, -9, 9);
        const TinkerBodyPose seat = shape_turned_by((TinkerBodyPose){.x = x}, angle);
        const TinkerBodyPose box = shape_turned_by(
            (TinkerBodyPose){.x = x + c * place - s * 0.3, .y = s * place + c * 0.3, .vx = c * speed, .vy = s * speed},
            angle + shape_between(random, -1e-15, 1e-15));
        TinkerGapFunction functions[SHAPE_MOST];
        const int32_t count = tinker_gap_functions(&shapes[0], &shape_top, functions, SHAPE_MOST);
        for (int32_t k = 0; k < count; k++) {
            TinkerGap gap;
            tinker_gap_measure(&functions[k], &box, &seat, &gap);
            if (fabs(gap.gap) > 1e-12 || !tinker_gap_is_over(&functions[k], &box, &seat, &gap, 1e-12)) continue;
            g_assert_cmpfloat(fabs(c * gap.normal[1] - s * gap.normal[0]), >, 1 - 1e-12);
        }
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/physics/shapes-derivatives/differences", test_derivatives);
    g_test_add_func("/physics/shapes-derivatives/round-a-box", test_round_a_box);
    g_test_add_func("/physics/shapes/over-an-end", test_over_an_end);
    return g_test_run();
}
