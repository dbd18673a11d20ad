/* The rod's rows against differences, closed forms, and lengths at the edge of what a double holds. */
#include <float.h>
#include <math.h>
#include <string.h>

#include "plugin-fixture.h"

#define COUNT 37

typedef struct {
    double g[COUNT], jacobian[4 * COUNT], drift[COUNT];
} Rows;

static const TinkerConstraint *rod(void)
{
    const TinkerConstraint *constraint = block_physics(block_open("rod"))->constraint;
    g_assert_nonnull(constraint);
    return constraint;
}

static BlockBatch *random_rods(TinkerPoint *ends)
{
    BlockBatch *batch = block_batch_new(block_open("rod"), COUNT);
    for (int i = 0; i < COUNT; i++) {
        block_batch_set(batch, i, "length", 0, fabs(random_value()));
        for (int k = 0; k < 2; k++) {
            ends[2 * i + k] = (TinkerPoint){random_value(), random_value(), random_value(), random_value()};
        }
    }
    return batch;
}

static void evaluate(BlockBatch *batch, const TinkerPoint *ends, Rows *rows)
{
    TinkerBatch view = block_batch_view(batch, 0, batch->count);
    g_assert_cmpint(rod()->rows_at(&view, ends, rows->g, rows->jacobian, rows->drift), ==, TINKER_OK);
}

/* A 3-4-5 triangle turning: n = (0.6, 0.8); ends at relative velocity (-4, 3), all of it across: drift = 25 / 5. */
static void test_closed_form(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("rod"), 1);
    block_batch_set(batch, 0, "length", 0, 4.5);
    const TinkerPoint ends[2] = {{1, 1, 2, -1}, {4, 5, -2, 2}};
    Rows rows;
    evaluate(batch, ends, &rows);
    g_assert_cmpfloat(rows.g[0], ==, 0.5);
    assert_close(rows.jacobian[0], -0.6, 4 * DBL_EPSILON);
    assert_close(rows.jacobian[1], -0.8, 4 * DBL_EPSILON);
    assert_close(rows.jacobian[2], 0.6, 4 * DBL_EPSILON);
    assert_close(rows.jacobian[3], 0.8, 4 * DBL_EPSILON);
    assert_close(rows.drift[0], 5, 8 * DBL_EPSILON);
    g_assert_cmpint(rod()->rows, ==, 1);
    g_assert_cmpint(rod()->unilateral, ==, 0);
}

/* Ends that move along the rod have no drift, however fast they are: |w|^2 - (n . w)^2 would leave 1e-16 |w|^2. */
static void test_drift_without_cancellation(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("rod"), 1);
    block_batch_set(batch, 0, "length", 0, 1);
    const double fast = 1e9, across = 1e-3;
    const TinkerPoint ends[2] = {{0, 0, 0, 0}, {1, 0, fast, across}};
    Rows rows;
    evaluate(batch, ends, &rows);
    assert_close(rows.drift[0], across * across, 8 * DBL_EPSILON);
}

static double component(const TinkerPoint *point, int axis)
{
    return axis == 0 ? point->x : point->y;
}

/* J against central differences of g: error of the differences is (h^2 / 6) / L^2, plus rounding of g over h. */
static void test_jacobian(void)
{
    TinkerPoint ends[2 * COUNT];
    g_autoptr(BlockBatch) batch = random_rods(ends);
    Rows rows, up, down;
    evaluate(batch, ends, &rows);
    for (int end = 0; end < 2; end++) {
        for (int axis = 0; axis < 2; axis++) {
            TinkerPoint higher[2 * COUNT], lower[2 * COUNT];
            double step[COUNT];
            memcpy(higher, ends, sizeof ends);
            memcpy(lower, ends, sizeof ends);
            for (int i = 0; i < COUNT; i++) {
                const int k = 2 * i + end;
                step[i] = 1e-5 * hypot(ends[2 * i + 1].x - ends[2 * i].x, ends[2 * i + 1].y - ends[2 * i].y);
                *(axis == 0 ? &higher[k].x : &higher[k].y) += step[i];
                *(axis == 0 ? &lower[k].x : &lower[k].y) -= step[i];
                step[i] = component(&higher[k], axis) - component(&lower[k], axis);
            }
            evaluate(batch, higher, &up);
            evaluate(batch, lower, &down);
            for (int i = 0; i < COUNT; i++) {
                const double scale = fabs(up.g[i]) + block_batch_view(batch, 0, COUNT).columns[0][i];
                g_assert_cmpfloat_with_epsilon((up.g[i] - down.g[i]) / step[i], rows.jacobian[4 * i + 2 * end + axis],
                                               1e-9 + 8 * DBL_EPSILON * scale / step[i]);
            }
        }
    }
}

/* Ends in straight uniform motion have no acceleration, so d2g/dt2 is the drift. L(t) = sqrt(q + 2 b t + w^2 t^2),
 * whose second derivative at 0 is (w^2 q - b^2) / q^(3/2): worked out in long double. */
static void test_drift(void)
{
    TinkerPoint ends[2 * COUNT];
    g_autoptr(BlockBatch) batch = random_rods(ends);
    Rows rows;
    evaluate(batch, ends, &rows);
    for (int i = 0; i < COUNT; i++) {
        const TinkerPoint *a = &ends[2 * i], *b = a + 1;
        const long double dx = (long double)b->x - a->x, dy = (long double)b->y - a->y;
        const long double wx = (long double)b->vx - a->vx, wy = (long double)b->vy - a->vy;
        const long double q = dx * dx + dy * dy, along = dx * wx + dy * wy, w2 = wx * wx + wy * wy;
        const long double exact = (w2 * q - along * along) / (q * sqrtl(q));
        g_assert_cmpfloat_with_epsilon(rows.drift[i], (double)exact, 1e-13 * (double)(w2 / sqrtl(q)));
    }
}

/* The same by differences of g itself along that motion: (g(h) - 2 g(0) + g(-h)) / h^2. */
static void test_drift_by_differences(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("rod"), 1);
    block_batch_set(batch, 0, "length", 0, 2);
    const TinkerPoint start[2] = {{0.3, -0.2, 0.5, 1.1}, {1.7, 0.9, -0.4, 0.8}};
    const double h = 1e-3;
    Rows rows;
    double g[3], drift = 0;
    for (int step = -1; step <= 1; step++) {
        TinkerPoint ends[2];
        for (int k = 0; k < 2; k++) {
            ends[k] = start[k];
            ends[k].x += step * h * start[k].vx;
            ends[k].y += step * h * start[k].vy;
        }
        evaluate(batch, ends, &rows);
        g[step + 1] = rows.g[0];
        if (step == 0) drift = rows.drift[0];
    }
    g_assert_cmpfloat_with_epsilon((g[2] - 2 * g[1] + g[0]) / (h * h), drift, 1e-6);
}

static void test_slices(void)
{
    TinkerPoint ends[2 * COUNT];
    g_autoptr(BlockBatch) batch = random_rods(ends);
    ends[10] = ends[11]; /* one of zero length among them, which takes the slow way */
    Rows all, single;
    evaluate(batch, ends, &all);
    for (int i = 0; i < COUNT; i++) {
        TinkerBatch one = block_batch_view(batch, i, 1);
        g_assert_cmpint(rod()->rows_at(&one, &ends[2 * i], &single.g[i], &single.jacobian[4 * i], &single.drift[i]), ==,
                        TINKER_OK);
    }
    g_assert_cmpmem(&single, sizeof single, &all, sizeof all);
}

static void test_dimensions(void)
{
    TinkerPoint ends[2 * COUNT];
    g_autoptr(BlockBatch) batch = random_rods(ends);
    Rows rows, rescaled;
    evaluate(batch, ends, &rows);
    block_batch_rescale(batch);
    points_rescale(ends, 2 * COUNT);
    evaluate(batch, ends, &rescaled);
    for (int i = 0; i < COUNT; i++) {
        g_assert_cmpfloat(rescaled.g[i], ==, rows.g[i] * rescale_factor((TinkerDimension)TINKER_DIMENSION_LENGTH));
        g_assert_cmpfloat(rescaled.drift[i], ==,
                          rows.drift[i] * rescale_factor((TinkerDimension)TINKER_DIMENSION_ACCELERATION));
        g_assert_cmpmem(&rescaled.jacobian[4 * i], 4 * sizeof(double), &rows.jacobian[4 * i], 4 * sizeof(double));
    }
}

/* A 3-4-5 triangle of any size, where the squares leave the range of a double and where they do not. */
static void test_extreme_lengths(void)
{
    static const double sizes[] = {1e-300, 1e-200, 1e-150, 1e-140, 1e-139, 1, 1e139, 1e140, 1e150, 1e200, 1e300};
    for (size_t s = 0; s < G_N_ELEMENTS(sizes); s++) {
        const double size = sizes[s];
        g_autoptr(BlockBatch) batch = block_batch_new(block_open("rod"), 1);
        block_batch_set(batch, 0, "length", 0, 4 * size);
        const TinkerPoint ends[2] = {{0, 0, 0, 0}, {3 * size, 4 * size, 0, 0}};
        Rows rows;
        evaluate(batch, ends, &rows);
        assert_close(rows.g[0], size, 32 * DBL_EPSILON);
        assert_close(rows.jacobian[2], 0.6, 8 * DBL_EPSILON);
        assert_close(rows.jacobian[3], 0.8, 8 * DBL_EPSILON);
        g_assert_cmpfloat(rows.drift[0], ==, 0);
    }
}

/* Where the ends coincide the rod has no direction: everything is finite and g tells how wrong it is. */
static void test_zero_length(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("rod"), 1);
    block_batch_set(batch, 0, "length", 0, 2);
    const TinkerPoint ends[2] = {{1, 1, 0, 0}, {1, 1, 3, 0}};
    Rows rows;
    evaluate(batch, ends, &rows);
    g_assert_cmpfloat(rows.g[0], ==, -2);
    g_assert_cmpfloat(rows.drift[0], ==, 0);
    for (int k = 0; k < 4; k++) {
        g_assert_cmpfloat(rows.jacobian[k], ==, 0);
    }
}

static void test_check(void)
{
    g_autoptr(BlockBatch) batch = block_batch_new(block_open("rod"), 3);
    for (int i = 0; i < 3; i++) {
        block_batch_set(batch, i, "length", 0, 1.0 + i);
    }
    double scale[3];
    TinkerBatch view = block_batch_view(batch, 0, 3);
    g_assert_cmpint(rod()->check(&view), ==, TINKER_OK);
    g_assert_cmpint(rod()->scale(&view, scale), ==, TINKER_OK);
    g_assert_cmpfloat(scale[2], ==, 3);
    block_batch_set(batch, 1, "length", 0, 0);
    g_assert_cmpint(rod()->check(&view), ==, TINKER_FAILED);
    g_assert_cmpint(view.failed_instance, ==, 1);
    g_assert_nonnull(view.failure);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/plugins/rod/closed-form", test_closed_form);
    g_test_add_func("/plugins/rod/drift-without-cancellation", test_drift_without_cancellation);
    g_test_add_func("/plugins/rod/jacobian", test_jacobian);
    g_test_add_func("/plugins/rod/drift", test_drift);
    g_test_add_func("/plugins/rod/drift-by-differences", test_drift_by_differences);
    g_test_add_func("/plugins/rod/slices", test_slices);
    g_test_add_func("/plugins/rod/dimensions", test_dimensions);
    g_test_add_func("/plugins/rod/extreme-lengths", test_extreme_lengths);
    g_test_add_func("/plugins/rod/zero-length", test_zero_length);
    g_test_add_func("/plugins/rod/check", test_check);
    return g_test_run();
}
