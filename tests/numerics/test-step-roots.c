/* Falls of polynomials whose roots are known, against values that are worked out from them. */
#include <float.h>
#include <math.h>

#include <glib.h>

#include "numerics/roots/step-roots.h"

/* scale * (t - roots[0]) (t - roots[1]) ... at the nodes. */
static void from_roots(int32_t degree, int32_t count, const double *roots, double scale, double *values)
{
    double nodes[TINKER_MOST_DEGREE + 1];
    tinker_step_nodes(degree, nodes);
    for (int32_t j = 0; j <= degree; j++) {
        long double product = scale;
        for (int32_t i = 0; i < count; i++)
            product *= (long double)nodes[j] - roots[i];
        values[j] = (double)product;
    }
}

static void assert_falls(int32_t degree, const double *values, double level, int32_t count, const double *expected,
                         double tolerance)
{
    double places[TINKER_MOST_DEGREE];
    g_assert_cmpint(tinker_step_falls(degree, values, level, places, TINKER_MOST_DEGREE), ==, count);
    for (int32_t i = 0; i < count; i++)
        g_assert_cmpfloat_with_epsilon(places[i], expected[i], tolerance);
}

static void test_nodes(void)
{
    double nodes[TINKER_MOST_DEGREE + 1];
    for (int32_t n = 1; n <= TINKER_MOST_DEGREE; n++) {
        tinker_step_nodes(n, nodes);
        g_assert_cmpfloat(nodes[0], ==, 0);
        g_assert_cmpfloat(nodes[n], ==, 1);
        for (int32_t k = 0; k <= n; k++) {
            g_assert_cmpfloat_with_epsilon(nodes[k], 0.5 - 0.5 * cos(G_PI * k / n), 2e-16);
            g_assert_cmpfloat(nodes[k] + nodes[n - k], ==, 1);
        }
    }
}

/* T_n(2t - 1) falls through 0 at every other one of its roots. */
static void test_chebyshev(void)
{
    for (int32_t n = 1; n <= TINKER_MOST_DEGREE; n++)
        for (int32_t sign = -1; sign <= 1; sign += 2) {
            double values[TINKER_MOST_DEGREE + 1], expected[TINKER_MOST_DEGREE];
            int32_t count = 0;
            for (int32_t j = 0; j <= n; j++)
                values[j] = (n - j) % 2 ? -sign : sign;
            gboolean above = values[0] > 0;
            for (int32_t k = 0; k < n; k++, above = !above)
                if (above) expected[count++] = 0.5 - 0.5 * cos(G_PI * (k + 0.5) / n);
            assert_falls(n, values, 0, count, expected, 4e-16);
        }
}

/* Simple roots of chance, at least 1e-3 apart: every fall, to the accuracy that the rounding of the values leaves. */
static void test_simple_roots(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(1);
    for (int32_t round = 0; round < 5000; round++) {
        int32_t degree = g_rand_int_range(random, 1, TINKER_MOST_DEGREE + 1);
        int32_t count = g_rand_int_range(random, 1, degree + 1);
        double roots[TINKER_MOST_DEGREE], values[TINKER_MOST_DEGREE + 1], places[TINKER_MOST_DEGREE];
        for (int32_t i = 0; i < count; i++)
            roots[i] = (i + g_rand_double_range(random, 0.2, 0.8)) / count;
        double scale = exp(g_rand_double_range(random, -40, 40)) * (g_rand_boolean(random) ? 1 : -1);
        from_roots(degree, count, roots, scale, values);
        double largest = 0;
        for (int32_t j = 0; j <= degree; j++)
            largest = MAX(largest, fabs(values[j]));
        int32_t found = tinker_step_falls(degree, values, 0, places, TINKER_MOST_DEGREE), k = 0;
        for (int32_t i = values[0] >= 0 ? 0 : 1; i < count; i += 2, k++) {
            double slope = scale;
            for (int32_t j = 0; j < count; j++)
                if (j != i) slope *= roots[i] - roots[j];
            g_assert_cmpint(k, <, found);
            g_assert_cmpfloat_with_epsilon(places[k], roots[i], 4e-16 + 8 * DBL_EPSILON * largest / fabs(slope));
        }
        g_assert_cmpint(k, ==, found);
    }
}

/* Double roots: touched, dipped through, and lifted clear, by more and by less than what counts. */
static void test_dips(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(2);
    for (int32_t round = 0; round < 3000; round++) {
        int32_t degree = g_rand_int_range(random, 2, TINKER_MOST_DEGREE + 1);
        double at = g_rand_double_range(random, 0.01, 0.99), values[TINKER_MOST_DEGREE + 1], roots[2] = {at, at};
        from_roots(degree, 2, roots, 1, values);
        double largest = MAX(values[0], values[degree]);
        assert_falls(degree, values, -3e-14 * largest, 0, NULL, 0);
        /* (t - at)^2 = depth */
        for (double depth = 1e-12; depth < 1e-5; depth *= 100) {
            double place = at - sqrt(depth);
            assert_falls(degree, values, depth, 1, &place, 1e-16 * largest / sqrt(depth) + 1e-15);
        }
    }
    double touching[] = {0.25, 0, 0.25}; /* (t - 1/2)^2 */
    assert_falls(2, touching, 0, 0, NULL, 0);
    double from_below[] = {-0.25, 0, -0.25};
    assert_falls(2, from_below, 0, 0, NULL, 0);
}

/* Roots so close that values do not tell them apart: what counts is the way from above to below. */
static void test_clusters(void)
{
    double values[TINKER_MOST_DEGREE + 1];
    for (int32_t degree = 3; degree <= TINKER_MOST_DEGREE; degree++) {
        double triple[] = {0.3, 0.3 + 1e-9, 0.3 + 2e-9}, expected[] = {0.3};
        from_roots(degree, 3, triple, -1, values);
        assert_falls(degree, values, 0, 1, expected, 1e-4);
        from_roots(degree, 3, triple, 1, values);
        assert_falls(degree, values, 0, 0, NULL, 0);
        double pair[] = {0.7, 0.7 + 1e-9, 0.2}, first[] = {0.2};
        from_roots(degree, 3, pair, -1, values);
        assert_falls(degree, values, 0, 1, first, 1e-13);
        double apart[] = {0.7, 0.7 + 1e-6}, dip[] = {0.7};
        from_roots(degree, 2, apart, 1, values);
        assert_falls(degree, values, 0, 1, dip, 1e-8);
    }
    double all_one[10];
    for (int32_t i = 0; i < 10; i++)
        all_one[i] = 0.5;
    from_roots(9, 9, all_one, -1, values);
    double half = 0.5;
    assert_falls(9, values, 0, 1, &half, 0.03);
    from_roots(10, 10, all_one, 1, values);
    assert_falls(10, values, 0, 0, NULL, 0);
}

/* What falls at 0 exactly passes there, what is below there does not; at 1 it has to be below. */
static void test_ends(void)
{
    double falling[] = {0, -0.5, -1}, rising[] = {0, 0.5, 1}, below[] = {-1e-17, -0.5, -1};
    double reaching[] = {1, 0.5, 0}, through[] = {1, 0.5, -1e-17}, zero = 0, one = 1;
    assert_falls(2, falling, 0, 1, &zero, 1e-300);
    assert_falls(2, rising, 0, 0, NULL, 0);
    assert_falls(2, below, 0, 0, NULL, 0);
    assert_falls(2, reaching, 0, 0, NULL, 0);
    assert_falls(2, through, 0, 1, &one, 1e-15);
    double flat[] = {0, 0, 0, 0}, none[] = {-1, -2, -1, -3}, odd[] = {1, NAN, -1};
    assert_falls(3, flat, 0, 0, NULL, 0);
    assert_falls(3, none, 0, 0, NULL, 0);
    assert_falls(2, odd, 0, 0, NULL, 0);
    double constant[] = {2};
    assert_falls(0, constant, 1, 0, NULL, 0);
}

static void test_room(void)
{
    double values[TINKER_MOST_DEGREE + 1], places[3] = {-1, -1, -1};
    for (int32_t j = 0; j <= 10; j++)
        values[j] = j % 2 ? -1 : 1;
    g_assert_cmpint(tinker_step_falls(10, values, 0, places, 2), ==, 2);
    g_assert_cmpfloat(places[2], ==, -1);
}

/* A fall between two steps belongs to exactly one: a curve cut at any place has its falls in one part or the other. */
static void test_cut(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(3);
    for (int32_t round = 0; round < 5000; round++) {
        double cut = g_rand_boolean(random) ? 0.5 : 0.5 + g_rand_double_range(random, -1e-15, 1e-15);
        double nodes[4], left[4], right[4], places[3];
        tinker_step_nodes(3, nodes);
        for (int32_t j = 0; j < 4; j++) {
            double first = cut * nodes[j], second = cut + (1 - cut) * nodes[j];
            left[j] = (0.5 - first) * (first + 1) * (first + 1);
            right[j] = (0.5 - second) * (second + 1) * (second + 1);
        }
        left[3] = right[0]; /* the same state */
        int32_t count = tinker_step_falls(3, left, 0, places, 3) + tinker_step_falls(3, right, 0, places, 3);
        g_assert_cmpint(count, ==, 1);
    }
}

/* At a fine grid no value lies below the bound; of smooth values the bound is near. */
static void test_least(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(4);
    for (int32_t round = 0; round < 4000; round++) {
        int32_t degree = g_rand_int_range(random, 0, TINKER_MOST_DEGREE + 1);
        double nodes[TINKER_MOST_DEGREE + 1], values[TINKER_MOST_DEGREE + 1];
        double middle = g_rand_double_range(random, -1, 4), largest = 0;
        tinker_step_nodes(degree, nodes);
        for (int32_t j = 0; j <= degree; j++) {
            values[j] = middle + (round % 4 == 0 ? (j % 2 ? 1 : -1) : g_rand_double_range(random, -1, 1));
            largest = MAX(largest, fabs(values[j]));
        }
        double least = tinker_step_least(degree, values), seen = HUGE_VAL;
        g_assert_true(isfinite(least));
        for (int32_t i = 0; i <= 200; i++) {
            long double t = i / 200.0L, sum = 0; /* Lagrange */
            for (int32_t j = 0; j <= degree; j++) {
                long double product = values[j];
                for (int32_t k = 0; k <= degree; k++)
                    if (k != j) product *= (t - nodes[k]) / ((long double)nodes[j] - nodes[k]);
                sum += product;
            }
            seen = MIN(seen, (double)sum);
            g_assert_cmpfloat(tinker_step_least_before(degree, values, i / 200.0), <=, seen + 1e-15 * largest);
        }
        g_assert_cmpfloat(least, <=, seen + 1e-15 * largest);
    }
    /* a parabola's coefficients are tight at its ends: 1 + 9 t (2 - t) is least at 0 */
    for (int32_t degree = 2; degree <= TINKER_MOST_DEGREE; degree++) {
        double nodes[TINKER_MOST_DEGREE + 1], values[TINKER_MOST_DEGREE + 1];
        tinker_step_nodes(degree, nodes);
        for (int32_t j = 0; j <= degree; j++)
            values[j] = 1 + 9 * nodes[j] * (2 - nodes[j]);
        g_assert_cmpfloat_with_epsilon(tinker_step_least(degree, values), 1, 1e-10);
        /* falling instead, it is least where the look at it ends */
        for (int32_t j = 0; j <= degree; j++)
            values[j] = 1 - values[j];
        for (int32_t i = 0; i <= 10; i++)
            g_assert_cmpfloat_with_epsilon(tinker_step_least_before(degree, values, i / 10.0),
                                           -9 * i / 10.0 * (2 - i / 10.0), 1e-9);
    }
    double odd[] = {1, NAN, 1};
    g_assert_cmpfloat(tinker_step_least(2, odd), <, 0);
}

typedef struct {
    int32_t kind, asked;
    double root;
} Function;

static double ask(void *data, double x)
{
    Function *f = data;
    double d = f->root - x;
    f->asked++;
    switch (f->kind) {
    case 0:
        return d;
    case 1:
        return d * d * d * d * d * d * d;
    case 2:
        return expm1(50 * d);
    case 3:
        return d > 0 ? 1 : -1;
    case 4:
        return copysign(pow(fabs(d), 0.01), d);
    case 5:
        return d > 0 ? 1e-300 : -1e300;
    default:
        return atan(1e9 * d);
    }
}

static void test_refine(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(5);
    for (int32_t round = 0; round < 7000; round++) {
        double root = round < 700 ? 1e-9 * (round + 1) : g_rand_double_range(random, 0, 1);
        Function f = {round % 7, 0, root};
        double place = tinker_step_refine(0, 1, ask, &f);
        g_assert_cmpfloat_with_epsilon(place, f.root, 1.5 * DBL_EPSILON);
        g_assert_cmpint(f.asked, <=, 100);
        if (f.kind == 2) g_assert_cmpint(f.asked, <=, 20); /* smooth: not by halves */
    }
    Function outside = {0, 0, -1}, beyond = {0, 0, 2};
    g_assert_cmpfloat(tinker_step_refine(0, 1, ask, &outside), ==, 0);
    g_assert_cmpfloat(tinker_step_refine(0, 1, ask, &beyond), ==, 1);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/step-roots/nodes", test_nodes);
    g_test_add_func("/step-roots/chebyshev", test_chebyshev);
    g_test_add_func("/step-roots/simple", test_simple_roots);
    g_test_add_func("/step-roots/dips", test_dips);
    g_test_add_func("/step-roots/clusters", test_clusters);
    g_test_add_func("/step-roots/ends", test_ends);
    g_test_add_func("/step-roots/room", test_room);
    g_test_add_func("/step-roots/cut", test_cut);
    g_test_add_func("/step-roots/least", test_least);
    g_test_add_func("/step-roots/refine", test_refine);
    return g_test_run();
}
