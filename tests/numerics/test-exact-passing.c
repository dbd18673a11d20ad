/* The exact method on edges that pass through d = 0, against closed forms put together from passing to passing. */
#include <float.h>
#include <math.h>

#include "linear-case.h"
#include "numerics/exact/exact.h"

/* A spring of length L about an anchor, stretched enough to pass through it: x = L + A cos t from x = L + A until
 * x = 0 at t1, mirrored after that; the period is 4 t1. */
static double passing_truth(double L, double A, double t)
{
    long double t1 = acosl(-(long double)L / A), phase = fmodl(t, 4.0L * t1);
    if (phase > 2.0L * t1) phase = 4.0L * t1 - phase;
    return (double)(phase < t1 ? L + A * cosl(phase) : -(L + A * cosl(2.0L * t1 - phase)));
}

static void test_passing(void)
{
    for (int reach = 0; reach < 3; reach++) {
        double L = 0.5, A = reach == 0 ? 1.5 : reach == 1 ? 5.0 : 0.51;
        for (int steps = 1; steps <= 1000; steps *= 100) {
            LinearCase test;
            case_init(&test, 1);
            case_edge(&test, -1, 0, 1.0, 0.0)->length = L;
            test.q[0] = L + A;
            double T = 300.0;
            int taken = case_run(&test, T, steps), passings = (int)(T / acos(-L / A) + 1.0) / 2;
            g_assert_cmpint(taken, ==, steps + passings);
            /* a passing at the speed v shifts what follows by rounding / v */
            double v = sqrt(A * A - L * L);
            assert_near(test.q[0], passing_truth(L, A, T), 100.0 * DBL_EPSILON * passings * passings * A / v);
        }
    }
}

/* It dips below the anchor for a moment within one long step: both passings are found. */
static void test_grazing(void)
{
    for (double dip = 1e-2; dip > 1e-12; dip *= 0.1) {
        LinearCase test;
        case_init(&test, 1);
        case_edge(&test, -1, 0, 1.0, 0.0)->length = 1.0;
        test.q[0] = 2.0 + dip;
        g_assert_cmpint(case_run(&test, 4.0, 1), ==, 2);
    }
    LinearCase test;
    case_init(&test, 1);
    case_edge(&test, -1, 0, 1.0, 0.0)->length = 1.0;
    test.q[0] = 2.0 - 1e-9;
    g_assert_cmpint(case_run(&test, 1000.0, 1), ==, 1);
}

/* A constant pull towards the anchor from either side: x = x0 - p t^2 / 2 until 0. */
static void test_constant_tension(void)
{
    LinearCase test;
    case_init(&test, 1);
    case_edge(&test, 0, -1, 0.0, 0.0)->tension = 2.0;
    test.q[0] = 1.0;
    double quarter = 1.0, T = 41.25;
    int taken = case_run(&test, T, 1);
    g_assert_cmpint(taken, ==, 22);
    /* 10 periods of 4 quarters, then 1.25 quarters */
    double s = T - 40.0 * quarter - quarter;
    /* each passing is off by some roundings, which shifts all that follows */
    assert_near(test.q[0], -(2.0 * s - s * s), 100.0 * DBL_EPSILON * 21 * 21);
}

/* Separate parts step as if each were alone, and a passing in one ends the step of all. */
static void test_parts(void)
{
    LinearCase both, alone;
    case_init(&both, 2);
    case_edge(&both, -1, 0, 4.0, 0.1);
    case_edge(&both, -1, 1, 1.0, 0.0)->length = 0.5;
    both.q[0] = 1.0;
    both.q[1] = 2.0;
    case_init(&alone, 1);
    case_edge(&alone, -1, 0, 4.0, 0.1);
    alone.q[0] = 1.0;
    case_run(&alone, 10.0, 1);
    int steps = case_run(&both, 10.0, 1);
    g_assert_cmpint(steps, ==, 4); /* passings at acos(-1/3) times 1, 3 and 5 */
    assert_near(both.q[0], alone.q[0], 100.0 * DBL_EPSILON);
}

/* Stiff, damped and driven: after a moment nothing moves faster than the drive. The ends of the springs stay metres
 * apart, and one long step finds that out. The anchor's spring hardly gives: x = -6 + 0.8 sin 10 t to (10 / 3e4)^2. */
static void test_out_of_reach(void)
{
    LinearCase test;
    case_init(&test, 2);
    test.mass[0] = 0.02;
    test.mass[1] = 0.05;
    test.q[0] = -10.0;
    test.q[1] = -6.0;
    int32_t wall = case_anchor(&test, 40.0);
    case_edge(&test, 0, 1, 600.0, 160.0)->length = 4.0;
    case_edge(&test, 1, wall, 5e7, 0.0)->length = 46.0;
    case_motion(&test, wall, case_harmonic(&test, 0.8, 10.0, 0.0), 1.0);
    g_assert_cmpint(case_run(&test, 1.0, 1), ==, 1);
    assert_near(test.q[1], -6.0 + 0.8 * sin(10.0), 1e-6);
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/exact-passing/spring", test_passing);
    g_test_add_func("/numerics/exact-passing/grazing", test_grazing);
    g_test_add_func("/numerics/exact-passing/constant-tension", test_constant_tension);
    g_test_add_func("/numerics/exact-passing/parts", test_parts);
    g_test_add_func("/numerics/exact-passing/out-of-reach", test_out_of_reach);
    return g_test_run();
}
