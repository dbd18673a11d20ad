/* What leans on other contacts (rolling resistance) and what is bounded by a number (friction of pins): answers for
 * bodies of chance keep the laws, whichever way they are found. */
#include <math.h>
#include <string.h>

#include "contact-case.h"
#include "numerics/contact/contact-laws.h"

/* The first `ordinary` contacts touch; each other one leans on one of these, or on nothing. */
static void fill(ContactCase *bodies, GRand *random, int32_t ordinary, int32_t count, int32_t *bearer)
{
    const int32_t width = 2 * count;
    contact_case_fill(bodies, random, count, width + 2, FALSE, 1);
    for (int32_t k = 0; k < count; k++) {
        bodies->friction[k] = g_rand_double_range(random, 0.05, 1);
        bearer[k] = k < ordinary ? k : g_rand_int_range(random, -1, ordinary);
        if (k < ordinary) continue;
        bodies->before[2 * k] = 0;
        for (int32_t i = 0; i < width; i++)
            bodies->delassus[2 * k * width + i] = bodies->delassus[i * width + 2 * k] = 0;
    }
}

static void assert_law(const ContactCase *bodies, const int32_t *bearer, int32_t k, const double *f, const double *a,
                       const double *rounding)
{
    const double normal = bearer[k] < 0 ? 1 : f[2 * bearer[k]], most = bodies->friction[k] * normal, t = f[2 * k + 1];
    const double slack = 1e3 * rounding[2 * k + 1], speed = a[2 * k + 1], near = 1e-11 * (1 + fabs(most));
    if (bearer[k] == k) {
        g_assert_cmpfloat(f[2 * k], >=, 0);
        g_assert_cmpfloat(a[2 * k], >=, -1e3 * rounding[2 * k]);
        g_assert_true(f[2 * k] == 0 || fabs(a[2 * k]) <= 1e3 * rounding[2 * k]);
    } else {
        g_assert_cmpfloat(f[2 * k], ==, 0);
    }
    g_assert_cmpfloat(fabs(t), <=, most + near);
    if (normal == 0) return;
    if (bodies->sliding[k] != 0)
        g_assert_cmpfloat_with_epsilon(t, -most * bodies->sliding[k], near);
    else if (fabs(speed) > slack)
        g_assert_cmpfloat_with_epsilon(t, speed > 0 ? -most : most, near);
}

static void test_modes(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(20);
    int solved = 0, slipping = 0, holding = 0;
    for (int round = 0; round < 2000; round++) {
        ContactCase bodies;
        int32_t bearer[CASE_CONTACTS];
        double f[CASE_WIDTH], a[CASE_WIDTH], rounding[CASE_WIDTH];
        TinkerContactMode modes[CASE_CONTACTS];
        const int32_t ordinary = g_rand_int_range(random, 1, 4), count = ordinary + g_rand_int_range(random, 1, 5);
        fill(&bodies, random, ordinary, count, bearer);
        for (int32_t k = 0; k < MIN(count, CASE_CONTACTS) && round % 2 == 1; k++)
            bodies.sliding[k] = (int8_t)g_rand_int_range(random, -1, 2);
        const TinkerClosedContacts closed = {
            count, bodies.delassus, bodies.before, bodies.sliding, bodies.friction, bodies.friction, 0, NULL, bearer};
        const TinkerContactResult result = tinker_contact_modes(&closed, modes, f);
        if (round % 2 == 0) g_assert_cmpint(result, ==, TINKER_CONTACT_SOLVED);
        if (result != TINKER_CONTACT_SOLVED) continue;
        solved++;
        contact_case_after(&bodies, f, a, rounding);
        for (int32_t k = 0; k < count; k++)
            assert_law(&bodies, bearer, k, f, a, rounding);
        for (int32_t k = ordinary; k < count; k++) {
            slipping += modes[k] == TINKER_CONTACT_SLIP_FORWARD || modes[k] == TINKER_CONTACT_SLIP_BACKWARD;
            holding += modes[k] == TINKER_CONTACT_STICK;
            if (bearer[k] >= 0)
                g_assert_true((modes[k] == TINKER_CONTACT_OPEN) == (modes[bearer[k]] == TINKER_CONTACT_OPEN));
        }
    }
    g_assert_cmpint(solved, >, 1500);
    g_assert_cmpint(slipping, >, 500);
    g_assert_cmpint(holding, >, 200);
}

/* An impact without restitution keeps the same laws, with velocities in place of accelerations. */
static void test_impacts(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(21);
    for (int round = 0; round < 1000; round++) {
        ContactCase bodies;
        int32_t bearer[CASE_CONTACTS];
        double p[CASE_WIDTH], after[CASE_WIDTH], rounding[CASE_WIDTH], restitution[CASE_CONTACTS] = {0};
        const int32_t ordinary = g_rand_int_range(random, 1, 4), count = ordinary + g_rand_int_range(random, 1, 5);
        fill(&bodies, random, ordinary, count, bearer);
        const TinkerImpact impact = {count, bodies.delassus, bodies.before, restitution, bodies.friction, NULL,
                                     NULL,  bearer};
        g_assert_cmpint(tinker_impact_solve(&impact, p), ==, TINKER_CONTACT_SOLVED);
        contact_case_after(&bodies, p, after, rounding);
        for (int32_t k = 0; k < count; k++)
            assert_law(&bodies, bearer, k, p, after, rounding);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/contact-leaning/modes", test_modes);
    g_test_add_func("/contact-leaning/impacts", test_impacts);
    return g_test_run();
}
