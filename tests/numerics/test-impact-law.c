/* Laws of impact for several contacts at once: balls in a row, and what no impact may do, at many impacts of chance. */
#include <math.h>

#include "contact-case.h"
#include "numerics/contact/impact-law.h"

/* Three balls of 1 kg in a row, the first of which comes at 1 m/s; the last two touch. W of the gaps 12 and 23, and
 * the velocities behind it. */
static void strike_row(TinkerImpactLaw law, const double *e, double *v)
{
    static const double delassus[16] = {2, 0, -1, 0, 0, 0, 0, 0, -1, 0, 2, 0, 0, 0, 0, 0};
    static const double before[4] = {-1, 0, 0, 0}, friction[2] = {0, 0};
    static const int32_t pair[2] = {0, 1};
    const TinkerImpact impact = {2, delassus, before, e, friction, NULL, NULL};
    double p[4];
    g_assert_cmpint(tinker_impact_by_law(law, &impact, pair, p), ==, TINKER_CONTACT_SOLVED);
    v[0] = 1 - p[0];
    v[1] = p[0] - p[2];
    v[2] = p[2];
}

static void test_row(void)
{
    static const struct {
        TinkerImpactLaw law;
        double e[2], v[3];
    } cases[] = {
        {TINKER_IMPACT_NEWTON, {1, 1}, {-1.0 / 3, 2.0 / 3, 2.0 / 3}},
        {TINKER_IMPACT_POISSON, {1, 1}, {-1.0 / 3, 2.0 / 3, 2.0 / 3}},
        {TINKER_IMPACT_SEQUENTIAL, {1, 1}, {0, 0, 1}},
        {TINKER_IMPACT_NEWTON, {0.5, 1}, {0, 0.5, 0.5}},
        {TINKER_IMPACT_POISSON, {0.5, 1}, {0, 1.0 / 3, 2.0 / 3}},
        {TINKER_IMPACT_SEQUENTIAL, {0.5, 1}, {0.0625, 0.1875, 0.75}},
        {TINKER_IMPACT_SEQUENTIAL, {0, 0}, {1.0 / 3, 1.0 / 3, 1.0 / 3}},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(cases); i++) {
        double v[3];
        strike_row(cases[i].law, cases[i].e, v);
        for (int k = 0; k < 3; k++)
            g_assert_cmpfloat_with_epsilon(v[k], cases[i].v[k], 1e-12);
    }
}

/* Energy that an impact adds, p . (u + u') / 2, beyond what rounding of u' makes of it. */
static double energy_gained(const ContactCase *bodies, const double *p, const double *after, const double *rounding)
{
    double gained = 0, total = 0;
    for (int32_t i = 0; i < 2 * bodies->count; i++) {
        gained += 0.5 * p[i] * (bodies->before[i] + after[i]) - 100 * fabs(p[i]) * rounding[i];
        total += fabs(p[i]) * (fabs(bodies->before[i]) + fabs(after[i]));
    }
    return total > 0 ? gained / total : 0;
}

/* Bodies part, nothing pulls, friction keeps its bound, and no energy comes from anywhere. */
static void test_random(void)
{
    g_autoptr(GRand) random = g_rand_new_with_seed(8);
    for (int32_t round = 0; round < 1000000; round++) {
        const TinkerImpactLaw law = (TinkerImpactLaw)(round % TINKER_IMPACT_LAWS);
        const int32_t count = g_rand_int_range(random, 1, 5);
        ContactCase bodies;
        contact_case_fill(&bodies, random, count, 2 * count + g_rand_int_range(random, 0, 3), FALSE, round / 3 % 3);
        double e[CASE_CONTACTS], p[CASE_WIDTH], after[CASE_WIDTH], rounding[CASE_WIDTH];
        int32_t pair[CASE_CONTACTS];
        for (int32_t k = 0; k < count; k++) {
            bodies.friction[k] = k % 3 == 2 ? 0 : g_rand_double_range(random, 0, 1);
            e[k] = round % 5 == 0 ? 1 : g_rand_double_range(random, 0, 1);
            pair[k] = round % 7 == 0 ? k / 2 : k;
        }
        const TinkerImpact impact = {count, bodies.delassus, bodies.before, e, bodies.friction, NULL, NULL};
        const TinkerContactResult result = tinker_impact_by_law(law, &impact, pair, p);
        if (law == TINKER_IMPACT_SEQUENTIAL && result != TINKER_CONTACT_SOLVED) continue; /* a single one jams */
        g_assert_cmpint(result, ==, TINKER_CONTACT_SOLVED);
        contact_case_after(&bodies, p, after, rounding);
        g_assert_cmpfloat(energy_gained(&bodies, p, after, rounding), <=, 1e-11);
        for (int32_t k = 0; k < count; k++) {
            g_assert_cmpfloat(after[2 * k], >=, -1e-9 - 100 * rounding[2 * k]);
            g_assert_cmpfloat(p[2 * k], >=, 0);
            g_assert_cmpfloat(fabs(p[2 * k + 1]), <=, bodies.friction[k] * p[2 * k] * (1 + 1e-12) + 1e-15);
        }
    }
}

/* One contact without friction: all laws are one. */
static void test_single(void)
{
    static const double delassus[4] = {1.5, 0.2, 0.2, 1}, before[2] = {-2, 1}, e[1] = {0.7}, friction[1] = {0};
    static const int32_t pair[1] = {0};
    const TinkerImpact impact = {1, delassus, before, e, friction, NULL, NULL};
    for (int law = 0; law < TINKER_IMPACT_LAWS; law++) {
        double p[2];
        g_assert_cmpint(tinker_impact_by_law((TinkerImpactLaw)law, &impact, pair, p), ==, TINKER_CONTACT_SOLVED);
        g_assert_cmpfloat_with_epsilon(p[0], 1.7 * 2 / 1.5, 1e-15);
        g_assert_cmpfloat(p[1], ==, 0);
    }
}

int main(int argc, char **argv)
{
    g_test_init(&argc, &argv, NULL);
    g_test_add_func("/numerics/impact-law/row", test_row);
    g_test_add_func("/numerics/impact-law/single", test_single);
    g_test_add_func("/numerics/impact-law/random", test_random);
    return g_test_run();
}
